// SPDX-License-Identifier: MIT
#include "core/text.hpp"

#include <gtest/gtest.h>

namespace shigusa {
namespace {

TEST(Text, BlanksAreThoseOfJsonAndXml) {
  for (const char c : {' ', '\t', '\n', '\r'}) EXPECT_TRUE(is_blank(c)) << static_cast<int>(c);
  for (const char c : {'a', '_', '0', '\v', '\f', '\0'}) {
    EXPECT_FALSE(is_blank(c)) << static_cast<int>(c);
  }
}

TEST(Text, LettersOfAsciiAloneHaveCases) {
  EXPECT_EQ(lower(std::string("AZ@[az\xC3\x84")), "az@[az\xC3\x84");
  EXPECT_TRUE(is_upper('A') && is_upper('Z'));
  EXPECT_FALSE(is_upper('@') || is_upper('[') || is_upper('a'));
  EXPECT_EQ(capitalised("a word"), "A word");
  EXPECT_EQ(capitalised("zone"), "Zone");
  EXPECT_EQ(capitalised("`code`"), "`code`");
  EXPECT_EQ(capitalised("{z"), "{z");
  EXPECT_EQ(capitalised(""), "");
}

TEST(Text, LengthsAreThoseOfUtf8) {
  EXPECT_EQ(utf8_length(""), 0u);
  EXPECT_EQ(utf8_length("\x7F"), 1u);
  EXPECT_EQ(utf8_length("\xC2\x80"), 2u);
  EXPECT_EQ(utf8_length("\xE0\xA0\x80"), 3u);
  EXPECT_EQ(utf8_length("\xF0\x90\x80\x80"), 4u);
  EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF"), 4u);
}

TEST(Text, WhatIsNoUtf8HasNoLength) {
  for (const char* bytes : {"\x80", "\xC1\xBF", "\xC2", "\xC2z", "\xE0\x9F\xBF", "\xED\xA0\x80",
                            "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    EXPECT_EQ(utf8_length(bytes), 0u) << std::string(bytes).size();
  }
}

TEST(Text, MarkupIsEscaped) {
  EXPECT_EQ(markup_text("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  // characters that markup does not allow are dropped, and bytes that are no UTF-8 are replaced
  EXPECT_EQ(markup_text("a\x01\tb"), "ab");
  EXPECT_EQ(markup_text("a\xFF"
                        "b"),
            "a\xEF\xBF\xBD"
            "b");
}

}  // namespace
}  // namespace shigusa
