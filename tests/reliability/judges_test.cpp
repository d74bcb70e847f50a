// SPDX-License-Identifier: MIT
// Each judge of random tasks detects a motion that was spoilt on purpose.
#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>

#include "reliability/auditor.hpp"

namespace shigusa::bench {
namespace {

struct FlawCase {
  const char* name;
  Flaw flaw;
  const char* kind;
  const char* found;  // words of the finding
};
void PrintTo(const FlawCase& spoilt, std::ostream* out) { *out << spoilt.name; }

const Cast& our_cast() {
  static const Cast cast = load_cast({});
  return cast;
}

const Kind& kind_named(const std::string& name) {
  const auto kinds = all_kinds();
  return *std::find_if(kinds.begin(), kinds.end(),
                       [&](const Kind& kind) { return name == kind.name; });
}

// The findings of the first tasks of a kind, up to the first fault.
Audit audit_of(const FlawCase& spoilt, Flaw flaw) {
  constexpr std::uint64_t kTasks = 12;
  Auditor auditor(100, flaw);
  const Kind& kind = kind_named(spoilt.kind);
  for (std::uint64_t number = 0; number < kTasks; ++number) {
    auditor.take(kind, kind.draw(our_cast(), number));
    if (!auditor.audit().failures.empty()) break;
  }
  return auditor.audit();
}

class Judges : public testing::TestWithParam<FlawCase> {};

TEST_P(Judges, FindWhatIsSpoilt) {
  EXPECT_THAT(audit_of(GetParam(), Flaw::none).failures, testing::IsEmpty());
  EXPECT_THAT(audit_of(GetParam(), GetParam().flaw).failures,
              testing::Contains(testing::StartsWith(GetParam().found)));
}

INSTANTIATE_TEST_SUITE_P(
    Flaws, Judges,
    testing::Values(
        FlawCase{"goal", Flaw::goal_off, "a place", "a goal is missed"},
        FlawCase{"goal_of_a_robot", Flaw::goal_off, "a robot's hand", "a goal is missed"},
        FlawCase{"goal_of_a_file", Flaw::goal_off, "a file's hand", "a goal is missed"},
        FlawCase{"second_file", Flaw::other_file_off, "a file's hand", "a goal is missed"},
#ifdef SHIGUSA_HAS_MUJOCO
        FlawCase{"mujoco", Flaw::other_file_off, "a robot's hand", "a goal is missed"},
#endif
        FlawCase{"rotation", Flaw::goal_turned, "a rotation", "a rotation is missed"},
        FlawCase{"palm", Flaw::goal_turned, "the way a palm faces", "a rotation is missed"},
        FlawCase{"slide", Flaw::foot_slid, "a place", "a foot slides"},
        FlawCase{"slide_of_a_robot", Flaw::foot_slid, "a robot's hand", "a foot slides"},
        FlawCase{"tilt", Flaw::foot_tilted, "a place", "a foot tilts"},
        FlawCase{"limit", Flaw::limit_passed, "a place", "a limit is passed"},
        FlawCase{"limit_of_a_robot", Flaw::limit_passed, "a robot's hand", "a limit is passed"},
        FlawCase{"box", Flaw::box_in_limb, "a place", "a bone is in an obstacle"},
        FlawCase{"box_in_a_robot", Flaw::box_in_limb, "a robot's hand", "a bone is in an obstacle"},
        FlawCase{"seat", Flaw::seat_low, "a seat", "hips are off the seat"},
        FlawCase{"heel", Flaw::heel_told_high, "heels that may lift", "a heel is not as high"},
        FlawCase{"rest", Flaw::rest_slid, "a hand on the thigh", "a resting hand slides"},
        FlawCase{"rest_on_a_box", Flaw::rest_off, "a hand on a box", "a resting hand is off"},
        FlawCase{"torque", Flaw::torque_told_low, "a place", "a torque is not as told"},
        FlawCase{"torque_of_a_robot", Flaw::torque_told_low, "a robot's hand",
                 "a torque is not as told"},
        FlawCase{"strength", Flaw::weakness_hidden, "a load of 1 to 40 kg", "1.5 times a joint's"},
        FlawCase{"pressure", Flaw::tipping_hidden, "both hands", "the floor presses"},
        FlawCase{"order", Flaw::order_wrong, "a place", "a worse kind of candidate ranks above"}),
    [](const testing::TestParamInfo<FlawCase>& test) { return test.param.name; });

TEST(Judges, CountArmsThatGoThroughTheHead) {
  const FlawCase spoilt{"", Flaw::none, "a place", ""};
  EXPECT_EQ(audit_of(spoilt, Flaw::none).through, 0);
  EXPECT_GT(audit_of(spoilt, Flaw::arm_in_head).through, 0);
}

}  // namespace
}  // namespace shigusa::bench
