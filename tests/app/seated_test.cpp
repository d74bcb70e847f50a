// SPDX-License-Identifier: MIT
// Reaches of people who sit, by the written file's own kinematics.
#include "app/result_checks.hpp"
#include "support/person_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class Seated : public testing::Test {
 protected:
  ProgramRun reach(const Words& more) {
    Words call{"reach", "--formats", "bvh", "--out", "out", "--evaluations", "600"};
    call.insert(call.end(), more.begin(), more.end());
    return run_shigusa(call, {.folder = work_.path()});
  }

  // what lies on the seat and below it stays where it is while the trunk goes to the goal
  void expect_legs_still() {
    const StoredRun stored(work_, "out");
    const ExportedMotion motion = stored.motion(stored.candidate(1));
    for (const char* node : {"left_upper_leg", "right_upper_leg", "left_lower_leg",
                             "right_lower_leg", "left_foot", "right_foot"}) {
      EXPECT_LT(motion.slide(node), 1e-3) << node;
    }
    EXPECT_GT(motion.slide("head"), 0.05);
  }

  WorkFolder work_;
};

TEST_F(Seated, HandReachesAndThighsAndFeetStay) {
  for (const Words& goal :
       {Words{"--goal", "right_hand=-0.3,0.9,0.6"}, Words{"--goal", "left_hand=0.1,0.45,0.4"}}) {
    const ProgramRun run = reach({"--character", "human", "--seat", "0.45", goal[0], goal[1]});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    expect_legs_still();
  }
}

TEST_F(Seated, APersonOfAFileSitsToo) {
  work_.put("person.bvh", person_bvh());
  const ProgramRun run = reach({"--character", "person.bvh", "--seat", "0.4", "--goal",
                                "right_hand=-0.3,0.9,0.5", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expect_legs_still();
  EXPECT_THAT(run.out, HasSubstr("right_upper_leg"));
}

TEST_F(Seated, EditKeepsTheSeat) {
  ASSERT_EQ(reach({"--character", "human", "--seat", "0.45", "--goal", "right_hand=-0.3,0.9,0.6"})
                .exit_code,
            0);
  const ProgramRun edit =
      run_shigusa({"edit", "out", "--set", "lean_deg=5", "--formats", "bvh", "--out", "edited"},
                  {.folder = work_.path()});
  ASSERT_EQ(edit.exit_code, 0) << edit.err;
}

TEST_F(Seated, SeatsThatNobodySitsOnAreRefused) {
  EXPECT_EQ(
      reach({"--character", "human", "--seat", "3", "--goal", "right_hand=0,1,0.4"}).exit_code, 2);
  const ProgramRun half =
      reach({"--character", "half_body", "--seat", "0.4", "--goal", "right_hand=0,1,0.4"});
  EXPECT_EQ(half.exit_code, 2);
  EXPECT_THAT(half.err, HasSubstr("seat"));
}

}  // namespace
}  // namespace shigusa
