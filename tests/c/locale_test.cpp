// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "c/everything.hpp"
#include "support/host_locale.hpp"

namespace shigusa_c_test {
namespace {

using shigusa::testing_support::HostLocale;

class InALocale : public testing::TestWithParam<const char*> {};

TEST_P(InALocale, TheInterfaceGivesTheSameBytes) {
  const Texts usual = everything();
  Texts there;
  {
    const HostLocale host(GetParam());
    if (!host.chosen()) GTEST_SKIP() << "no locale " << GetParam() << " and no localedef";
    there = everything();
  }
  EXPECT_THAT(usual.at("message"), testing::HasSubstr("'0,05'"));
  for (const auto& [name, text] : usual)
    EXPECT_TRUE(timeless(there[name]) == timeless(text)) << name;
}

INSTANTIATE_TEST_SUITE_P(CInterface, InALocale, testing::Values("de_DE", "ps_AF"),
                         [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace shigusa_c_test
