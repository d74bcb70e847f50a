// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/error.hpp>
#include <vector>

namespace shigusa {
namespace {

const std::vector<std::string> kHands{"left_hand", "right_hand"};

TEST(NearestName, MendsATransposition) {
  EXPECT_EQ(nearest_name("right_hnad", kHands), "right_hand");
}

TEST(NearestName, SuggestsNothingForAnotherWord) { EXPECT_EQ(nearest_name("zzzzz", kHands), ""); }

TEST(NearestName, OfNoNamesIsEmpty) { EXPECT_EQ(nearest_name("hand", {}), ""); }

TEST(NearestName, KnowsWordsInAnotherOrderAndCase) {
  EXPECT_EQ(nearest_name("hand_right", kHands), "right_hand");
  EXPECT_EQ(nearest_name("Left Hand", kHands), "left_hand");
  EXPECT_EQ(nearest_name("GLB", std::vector<std::string>{"bvh", "glb"}), "glb");
}

TEST(NearestName, CompletesWords) {
  EXPECT_EQ(nearest_name("hand", std::vector<std::string>{"head", "right_hand", "left_hand"}),
            "right_hand");
  const std::vector<std::string> known{"sway", "squat_deg", "squat_rad", "right_elbow.weight"};
  EXPECT_EQ(nearest_name("squat", known), "squat_deg");
  EXPECT_EQ(nearest_name("right_elbow", known), "right_elbow.weight");
}

TEST(NearestName, MendsWordByWord) {
  const std::vector<std::string> known{"neck", "left_knee", "right_knee", "right_hand"};
  EXPECT_EQ(nearest_name("kneee", known), "left_knee");
  EXPECT_EQ(nearest_name("rigth", known), "right_knee");
  EXPECT_EQ(nearest_name("knee_rigth", known), "right_knee");
  EXPECT_EQ(nearest_name("han", known), "right_hand");
  EXPECT_EQ(nearest_name("shoulder", known), "");
}

TEST(NearestName, CountsWhatStandsInFront) {
  EXPECT_EQ(nearest_name("xxxxab", std::vector<std::string>{"ab", "xxxxzz"}), "xxxxzz");
  EXPECT_EQ(nearest_name("abcd", std::vector<std::string>{"xabzz", "axcy"}), "axcy");
}

TEST(NearestName, IsNearWhereAThirdOfTheLongerOneIsTheSame) {
  EXPECT_EQ(nearest_name("abc", std::vector<std::string>{"axy"}), "axy");
  EXPECT_EQ(nearest_name("abc", std::vector<std::string>{"axyz"}), "");
  EXPECT_EQ(nearest_name("ab", std::vector<std::string>{"abcdef"}), "abcdef");
  EXPECT_EQ(nearest_name("ab", std::vector<std::string>{"abcdefg"}), "");
}

TEST(NearestName, CountsWhatIsMissingAndWhatIsTooMuchOnce) {
  EXPECT_EQ(nearest_name("abcd", std::vector<std::string>{"abxy", "abcdz"}), "abcdz");
  EXPECT_EQ(nearest_name("abcdz", std::vector<std::string>{"abcxy", "abcd"}), "abcd");
}

TEST(NearestName, TakesTheFirstAmongEquals) {
  EXPECT_EQ(nearest_name("_hand", kHands), "left_hand");
  EXPECT_EQ(nearest_name("abcd", std::vector<std::string>{"axcy", "xbyd"}), "axcy");
}

TEST(UnknownName, SuggestsAndListsWhatIsKnown) {
  EXPECT_EQ(unknown_name("effector", "right_hnad", kHands),
            "unknown effector 'right_hnad'; did you mean 'right_hand'? Known: left_hand, "
            "right_hand");
}

TEST(UnknownName, AsksForTheSideWhereNoneWasSaid) {
  EXPECT_EQ(unknown_name("effector", "hand", kHands),
            "unknown effector 'hand'; did you mean 'left_hand' or 'right_hand'? Known: left_hand, "
            "right_hand");
}

TEST(UnknownName, TakesNamesWithoutWords) {
  EXPECT_EQ(unknown_name("node", "------", std::vector<std::string>{"right------"}),
            "unknown node '------'; did you mean 'right------'? Known: right------");
}

TEST(NearestName, ComparesTheBeginningsOfEndlessNames) {
  const std::vector<std::string> known{std::string(4'000'000, 'b'), "right_hand"};
  EXPECT_EQ(nearest_name(std::string(4'000'000, 'a'), known), "");
}

TEST(UnknownName, CutsEndlessNames) {
  EXPECT_LT(unknown_name("key", std::string(1'000'000, 'a'), kHands).text.size(), 200U);
}

}  // namespace
}  // namespace shigusa
