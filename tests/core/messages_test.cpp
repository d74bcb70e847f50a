// SPDX-License-Identifier: MIT
#include "core/messages.hpp"

#include <gtest/gtest.h>

#include <set>
#include <shigusa/error.hpp>

#include "core/say.hpp"

namespace shigusa {
namespace {

TEST(Messages, EachHasItsOwnKeyAndText) {
  std::set<std::string_view> keys;
  std::set<std::string_view> texts;
  for (const auto& table : messages::kAll) {
    for (const MessageText& message : table) {
      EXPECT_TRUE(keys.insert(message.key).second) << message.key;
      EXPECT_TRUE(texts.insert(message.text).second) << message.text;
      EXPECT_EQ(message.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"),
                std::string_view::npos)
          << message.key;
    }
  }
}

TEST(Say, TextIsWhatFmtMakesOfIt) {
  const double stature = 0.125;
  const Message message = say("stature_range", Metres{stature}, Metres{0.5}, Metres{2.5});
  constexpr MessageText kText = messages::sentence("stature_range");
  EXPECT_EQ(message.text, fmt::format(kText.text, stature, 0.5, 2.5));
  EXPECT_EQ(message.key, "stature_range");
}

TEST(Say, ValuesKeepTheirNumbersAndTheDigitsOfTheSentence) {
  const Message message = say("unequal_segments", "thigh", 0.31749, 0.3);
  ASSERT_EQ(message.values.size(), 3U);
  EXPECT_EQ(message.values[0], "thigh");
  EXPECT_FALSE(message.values[0].number.has_value());
  EXPECT_EQ(message.values[1].text, "0.317");
  EXPECT_EQ(message.values[1].number, 0.31749);
}

TEST(Say, WholeNumbersStandAsTheyAre) {
  EXPECT_EQ(say("no_frame", -1, say("frames", 123'456'789)).text,
            "frame -1 does not exist; the file has the frames 0 to 123456789");
}

TEST(Say, ValuesMayBeMessages) {
  const Message message = say("no_skeleton", say("nodes_at_one_point", 3));
  EXPECT_EQ(message.text, "no skeleton in this file: its 3 nodes stand at one point");
  ASSERT_EQ(message.values.size(), 1U);
  EXPECT_EQ(message.values[0].key, "nodes_at_one_point");
  EXPECT_EQ(message.values[0].values.at(0).number, 3.0);
}

TEST(Say, LengthsHaveTheirUnit) {
  const Message message = say("stature_range", Metres{0.25}, Metres{0.5}, Metres{2.5});
  EXPECT_EQ(message.text, "a stature of 0.25 m; 0.5 to 2.5 m are allowed");
  EXPECT_EQ(message.values.at(0).unit, "m");
}

TEST(Say, DoubledBracesAreBraces) {
  EXPECT_EQ(say("must_be_object").text, "must be an object { … }");
  EXPECT_EQ(say("points_object", 3).text, "must be an object { … } of at most 3 points");
}

TEST(Say, ErrorWithinAnotherKeepsItsSentence) {
  const Error error{ErrorCode::parse, say("empty_file"), "hero.glb"};
  const Message message = error.to_message();
  EXPECT_EQ(message.text, error.to_string());
  EXPECT_EQ(message.key, "at_place");
  EXPECT_EQ(message.values.at(1).key, "empty_file");
}

}  // namespace
}  // namespace shigusa
