// SPDX-License-Identifier: MIT
#include "core/messages.hpp"

#include <gtest/gtest.h>

#include <set>

namespace shigusa {
namespace {

TEST(Messages, EachHasItsOwnKeyAndText) {
  std::set<std::string_view> keys;
  std::set<std::string_view> texts;
  for (const MessageText& message : messages::kAll) {
    EXPECT_TRUE(keys.insert(message.key).second) << message.key;
    EXPECT_TRUE(texts.insert(message.text).second) << message.text;
    EXPECT_EQ(message.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos)
        << message.key;
  }
}

// Else a page could not tell which message a sentence is.
TEST(Messages, EachHasWordsOfItsOwnBesideItsValues) {
  for (const MessageText& message : messages::kAll) {
    int letters = 0;
    int depth = 0;
    for (const char c : message.text) {
      depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      letters += depth == 0 && c >= 'a' && c <= 'z' ? 1 : 0;
    }
    EXPECT_EQ(depth, 0) << message.key;
    EXPECT_GE(letters, 2) << message.key;
  }
}

}  // namespace
}  // namespace shigusa
