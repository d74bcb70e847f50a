// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <limits>
#include <shigusa/human.hpp>
#include <string>

namespace shigusa {
namespace {

using Body = PosedBody (*)(const BodyBuild&);

std::string refusal(Body body, const BodyBuild& build) {
  try {
    (void)body(build);
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return "none";
}

TEST(BuildRange, StaturesAndMassesOutOfRangeAreRefusedInWords) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const Body body : {half_body, full_body, human_body}) {
    EXPECT_THAT(refusal(body, {.stature = 170.0}),
                testing::HasSubstr("stature is 170 m; allowed are 0.5 to 2.5 m"));
    EXPECT_THAT(refusal(body, {.mass = 1e9}),
                testing::HasSubstr("mass is 1e+09 kg; allowed are 2 to 300 kg"));
    EXPECT_THAT(refusal(body, {.stature = kNone}), testing::HasSubstr("stature is nan"));
    EXPECT_EQ(refusal(body, {.stature = kStatureMin, .mass = kMassMin}), "none");
    EXPECT_EQ(refusal(body, {.stature = kStatureMax, .mass = kMassMax}), "none");
  }
}

}  // namespace
}  // namespace shigusa
