// SPDX-License-Identifier: MIT
#include "core/parse_number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <shigusa/error.hpp>
#include <string>

#include "core/c_locale.hpp"
#include "support/host_locale.hpp"

namespace shigusa {
namespace {

using testing_support::HostLocale;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParseNumber, TakesCsNotationOfDecimals) {
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+1e3"), 1000.0);
  EXPECT_EQ(parse_number(".25E+1"), 2.5);
  EXPECT_EQ(parse_number("2."), 2.0);
  EXPECT_EQ(parse_number("5e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(ParseNumber, IsNoneForAnythingElse) {
  for (const std::string text : {"", " 1", "1 ", "\t1", "1,5", "0x10", "0x1p-4", "+-1", "-+1",
                                 "++1", "--1", "1e", ".", "e5", "1.5.2", "1'000", "one"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
  EXPECT_EQ(parse_number(std::string_view("1\0", 2)), std::nullopt);
}

TEST(ParseNumber, LeavesInfinityAndNanToItsCaller) {
  EXPECT_EQ(parse_number("inf"), kInfinity);
  EXPECT_EQ(parse_number("-inf"), -kInfinity);
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(ParseNumber, TooLargeIsInfiniteAndTooSmallIsNought) {
  const std::string noughts(400, '0');
  EXPECT_EQ(parse_number("1e400"), kInfinity);
  EXPECT_EQ(parse_number("-1e400"), -kInfinity);
  EXPECT_EQ(parse_number("1" + noughts), kInfinity);
  EXPECT_EQ(parse_number("1" + noughts + "e-50"), kInfinity);
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  EXPECT_EQ(parse_number("0." + noughts + "1"), 0.0);
}

// The C library parses numbers too, with its own rounding.
TEST(ParseNumber, AgreesWithTheCLibraryOnAllDoubles) {
  EXPECT_TRUE(rc::check("as strtod", [](std::uint64_t bits) {
    const auto value = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(value));
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", value);
    RC_ASSERT(parse_number(text) == std::strtod(text, nullptr));
    std::snprintf(text, sizeof text, "%.*e", static_cast<int>(bits % 20), value);
    RC_ASSERT(parse_number(text) == std::strtod(text, nullptr));
  }));
}

TEST(ParseNumber, HasAPointInEveryLocale) {
  for (const char* language : {"de_DE", "ps_AF"}) {
    const HostLocale host(language);
    if (!host.chosen()) GTEST_SKIP() << "no locale " << language << " and no localedef";
    EXPECT_EQ(parse_number("0.5"), 0.5) << language;
    EXPECT_EQ(parse_number("0,5"), std::nullopt) << language;
    EXPECT_EQ(parse_number("0.5e-400"), 0.0) << language;
  }
}

TEST(WithinCLocale, IsOfItsThreadAndOver) {
  const HostLocale host("de_DE");
  if (!host.chosen()) GTEST_SKIP() << "no locale de_DE and no localedef";
  {
    const WithinCLocale point;
    EXPECT_EQ(std::strtod("0.5", nullptr), 0.5);
  }
  EXPECT_EQ(std::strtod("0.5", nullptr), 0.0);
  EXPECT_EQ(std::strtod("0,5", nullptr), 0.5);
}

}  // namespace
}  // namespace shigusa
