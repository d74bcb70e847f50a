// SPDX-License-Identifier: MIT
// Whatever floating-point settings a host has: the bytes are the same, and the settings are
// restored afterwards.
#include <gtest/gtest.h>

#include <cfenv>
#include <stdexcept>

#include "c/everything.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace shigusa_c_test {
namespace {

// Sets the host's floating-point settings, and restores the former ones at the end.
class HostMode {
 public:
  // `flushed`: numbers near 0 are 0, where the machine can have that
  HostMode(int rounding, bool flushed) {
    std::fegetenv(&before_);
    std::fesetround(rounding);
#if defined(__SSE2__)
    constexpr unsigned kFlush = 0x8040;
    if (flushed) _mm_setcsr(_mm_getcsr() | kFlush);
#else
    (void)flushed;
#endif
  }
  ~HostMode() { std::fesetenv(&before_); }
  HostMode(const HostMode&) = delete;
  HostMode& operator=(const HostMode&) = delete;

 private:
  std::fenv_t before_{};
};

// The host's settings: its rounding, and the bits for denormal numbers.
std::pair<int, unsigned> chosen() {
#if defined(__SSE2__)
  return {std::fegetround(), _mm_getcsr() & 0xFFC0U};
#else
  return {std::fegetround(), 0U};
#endif
}

struct Mode {
  const char* name;
  int rounding;
  bool flushed;
};

class InAnArithmetic : public testing::TestWithParam<Mode> {};

TEST_P(InAnArithmetic, TheInterfaceGivesTheSameBytesAndLeavesItAsItWas) {
  const Texts usual = everything();
  Texts there;
  std::pair<int, unsigned> before;
  std::pair<int, unsigned> after;
  std::string facts;
  {
    const HostMode host(GetParam().rounding, GetParam().flushed);
    before = chosen();
    there = everything();
    facts = text_of(shigusa_facts);
    after = chosen();
  }
  EXPECT_EQ(before.first, GetParam().rounding);
  EXPECT_EQ(before, after);
  EXPECT_EQ(facts, text_of(shigusa_facts));
  for (const auto& [name, text] : usual)
    EXPECT_TRUE(timeless(there[name]) == timeless(text)) << name;
}

TEST_P(InAnArithmetic, ThreadsComputeAsTheCallerDoes) {
  constexpr const char* kTwo =
      R"({"goals": [{"effector": "left_hand", "position_m": [0.2, 0.7, 0.5]}], "evaluations": 200})";
  shigusa_result* made = nullptr;
  ASSERT_EQ(shigusa_generate(nullptr, kTwo, 2, nullptr, &made), SHIGUSA_OK);
  const Outcome usual(made);
  {
    const HostMode host(GetParam().rounding, GetParam().flushed);
    ASSERT_EQ(shigusa_generate(nullptr, kTwo, 2, nullptr, &made), SHIGUSA_OK);
  }
  const Outcome there(made);
  EXPECT_EQ(text_of(shigusa_result_export, there.get(), 1, "csv"),
            text_of(shigusa_result_export, usual.get(), 1, "csv"));
}

// A host's own function, and the settings seen in it.
struct Host {
  int calls = 0;
  std::pair<int, unsigned> mode{};
  bool throws = false;
};
int32_t report(void* user, double, int32_t, double) {
  auto& host = *static_cast<Host*>(user);
  ++host.calls;
  host.mode = chosen();
  if (host.throws) throw std::runtime_error("the host has had enough");
  return 0;
}

TEST_P(InAnArithmetic, TheHostsFunctionsRunInItsOwn) {
  for (const bool throws : {false, true}) {
    Host host{.throws = throws};
    const shigusa_watch watch{report, &host};
    const HostMode mode(GetParam().rounding, GetParam().flushed);
    const auto before = chosen();
    shigusa_result* made = nullptr;
    const shigusa_status status = shigusa_generate(nullptr, kLowReach, 1, &watch, &made);
    EXPECT_EQ(status, throws ? SHIGUSA_HOST : SHIGUSA_OK);
    EXPECT_GT(host.calls, 0);
    EXPECT_EQ(host.mode, before);
    EXPECT_EQ(chosen(), before);
    shigusa_result_free(made);
  }
}

INSTANTIATE_TEST_SUITE_P(
    CInterface, InAnArithmetic,
    testing::Values(Mode{"nearest", FE_TONEAREST, false}, Mode{"up", FE_UPWARD, false},
                    Mode{"down", FE_DOWNWARD, false}, Mode{"to_zero", FE_TOWARDZERO, false},
                    Mode{"flushed", FE_TONEAREST, true}, Mode{"up_flushed", FE_UPWARD, true}),
    [](const auto& mode) { return std::string(mode.param.name); });

// An exception of a host's function is its own, not an error of the library.
TEST(HostFunctions, WhatTheyThrowIsToldAsTheirs) {
  int calls = 0;
  const auto of_exception = [](void* user, double, int32_t, double) -> int32_t {
    ++*static_cast<int*>(user);
    throw std::out_of_range("no such row in the host's list");
  };
  const auto of_number = [](void*, double, int32_t, double) -> int32_t { throw 7; };
  const auto of_memory = [](void*, double, int32_t, double) -> int32_t { throw std::bad_alloc(); };
  shigusa_result* made = nullptr;
  const shigusa_watch watch{of_exception, &calls};
  EXPECT_EQ(shigusa_generate(nullptr, kLowReach, 1, &watch, &made), SHIGUSA_HOST);
  EXPECT_STREQ(shigusa_message(), "no such row in the host's list");
  EXPECT_EQ(calls, 1) << "it is not called again";
  EXPECT_EQ(made, nullptr);
  for (const auto function : {+of_number, +of_memory}) {
    const shigusa_watch other{function, nullptr};
    EXPECT_EQ(shigusa_generate(nullptr, kLowReach, 2, &other, &made), SHIGUSA_HOST);
    EXPECT_STRNE(shigusa_message(), "");
  }
  const Outcome found = outcome_of(nullptr, kLowReach);
  const std::string summary = text_of(shigusa_result_describe, found.get());
  EXPECT_EQ(shigusa_restore_watched(nullptr, summary.c_str(), &watch, &made), SHIGUSA_HOST);
  EXPECT_EQ(made, nullptr);
}

}  // namespace
}  // namespace shigusa_c_test
