// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/error.hpp>

namespace shigusa {
enum class Fruit { apple, pear, quince };

template <>
inline constexpr std::array kEnumWords<Fruit>{
    EnumWord{Fruit::pear, "pear"},
    EnumWord{Fruit::apple, "apple"},
};

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(EnumWords, GoFromValueToWordAndBack) {
  EXPECT_EQ(word_of(Fruit::apple), "apple");
  EXPECT_EQ(value_of<Fruit>("pear", "fruit"), Fruit::pear);
  EXPECT_THAT(all_words<Fruit>(), ElementsAre("pear", "apple"));
}

TEST(EnumWords, AValueWithoutAWordHasNone) { EXPECT_EQ(word_of(Fruit::quince), ""); }

TEST(EnumWords, AWordThatIsNoneIsToldWithTheNearest) {
  const auto value = value_of<Fruit>("aple", "fruit");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::invalid_argument);
  EXPECT_THAT(value.error().message, HasSubstr("unknown fruit 'aple'; did you mean 'apple'?"));
}

TEST(EnumWords, OfATableAreThoseOfItsRows) {
  struct Row {
    Fruit fruit;
    double price;
    std::string_view word;
  };
  constexpr std::array kRows{Row{Fruit::quince, 3.0, "quince"}, Row{Fruit::pear, 1.0, "pear"}};
  constexpr auto kWords = words_of_table(kRows, &Row::fruit);
  ASSERT_EQ(kWords.size(), 2u);
  EXPECT_EQ(kWords[0].value, Fruit::quince);
  EXPECT_EQ(kWords[1].word, "pear");
}

}  // namespace
}  // namespace shigusa
