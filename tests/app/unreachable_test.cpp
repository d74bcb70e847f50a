// SPDX-License-Identifier: MIT
#include <cmath>
#include <regex>

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

struct FarGoal {
  const char* name;
  const char* body;
  const char* goal;
  const char* preset = "paper";
};

class Unreachable : public testing::TestWithParam<FarGoal> {
 protected:
  Unreachable()
      : run_(run_shigusa(
            {"reach", "--preset", GetParam().preset, "--character", GetParam().body, "--goal",
             std::string("right_hand=") + GetParam().goal, "--formats", "bvh,csv", "--out", "out"},
            {.folder = work_.path()})),
        stored_(work_, "out") {}

  // Calls visit(name, angles) for each freedom's angles (frames, rad) of each candidate.
  template <class Visit>
  void for_each_freedom(const Visit& visit) const {
    for (const Json& candidate : stored_.summary().at("candidates")) {
      const std::string csv = stored_.get(candidate.at("files").at("csv"));
      for (const auto& parameter : candidate.at("parameters").items()) {
        // of trunk and legs; an arm that moves by its own layer may end a little faster
        static const std::regex kWeight(R"((\w+\.\w+)\.weight)");
        std::smatch name;
        if (!std::regex_match(parameter.key(), name, kWeight)) continue;
        const std::string freedom = name[1];
        visit(freedom, csv_column(csv, freedom + " [rad]"));
      }
    }
  }

  [[nodiscard]] double frame_time() const {
    const Json& candidate = stored_.candidate(1);
    return candidate.at("duration_s").get<double>() / (candidate.at("frames").get<double>() - 1.0);
  }

  WorkFolder work_;
  ProgramRun run_;
  StoredRun stored_;
};

TEST_P(Unreachable, NoJointIsFasterThanAQuickReachAsksFor) {
  // a joint that turns by all of its range (some 4 rad) with minimum jerk in the shortest reach
  // peaks at 1.875 · 4 rad / 0.6 s = 12.5 rad/s
  constexpr double kFast = 15.0;  // rad/s
  for_each_freedom([&](const std::string& name, const std::vector<double>& angles) {
    for (std::size_t f = 1; f < angles.size(); ++f) {
      EXPECT_LE(std::fabs(angles[f] - angles[f - 1]) / frame_time(), kFast) << name << ' ' << f;
    }
  });
}

TEST_P(Unreachable, NoJointShakes) {
  // Shaking and jolts are changes of a joint's step from one frame to the next. Minimum jerk over
  // all of a range of 4 rad in 60 frames has 5.77 · 4 rad / 60² = 0.37° of them; five times that
  // leaves room for motions that are not so even.
  constexpr double kJolt = radians(2.0);
  for_each_freedom([&](const std::string& name, const std::vector<double>& angles) {
    for (std::size_t f = 2; f < angles.size(); ++f) {
      const double change = angles[f] - 2.0 * angles[f - 1] + angles[f - 2];
      EXPECT_LE(std::fabs(change), kJolt) << name << ' ' << f;
    }
  });
}

TEST_P(Unreachable, MotionEndsAtRest) {
  EXPECT_EQ(run_.exit_code, 3) << run_.err;
  // Of a minimum-jerk way, 10 (1/60)³ is left to the last of 60 frames: 0.1 mm of 2 m. A limb that
  // straightens turns its joints with the root of what is left, so they still creep.
  for (const Json& candidate : stored_.summary().at("candidates")) {
    const ExportedMotion motion = stored_.motion(candidate);
    const std::string joint = candidate.at("reached").at(0).at("joint");
    EXPECT_LE(norm(motion.at_end(joint) - motion.at(joint, motion.frames() - 2)), kMillimetre);
  }
  for_each_freedom([&](const std::string& name, const std::vector<double>& angles) {
    EXPECT_LE(std::fabs(angles.back() - angles[angles.size() - 2]), radians(1.5)) << name;
  });
}

INSTANTIATE_TEST_SUITE_P(
    Goal, Unreachable,
    testing::Values(FarGoal{"OverheadHalf", "half_body", "0,3,0"},
                    FarGoal{"AheadHalf", "half_body", "-0.2,1.2,2"},
                    FarGoal{"LeftHalf", "half_body", "1.5,1,0.5"},
                    FarGoal{"OverheadFull", "full_body", "0,3,0"},
                    FarGoal{"RightFull", "full_body", "-1.5,1.2,0.5"},
                    FarGoal{"FarAwayFull", "full_body", "60,40,-90"},
                    FarGoal{"LayersOverheadHalf", "half_body", "0,3,0", "layers"},
                    FarGoal{"LayersAheadHalf", "half_body", "-0.2,1.2,2", "layers"},
                    FarGoal{"LayersLeftHalf", "half_body", "1.5,1,0.5", "layers"},
                    FarGoal{"LayersOverheadFull", "full_body", "0,3,0", "layers"},
                    FarGoal{"LayersRightFull", "full_body", "-1.5,1.2,0.5", "layers"},
                    FarGoal{"LayersFarAwayFull", "full_body", "60,40,-90", "layers"}),
    [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace shigusa
