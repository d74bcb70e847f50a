// SPDX-License-Identifier: MIT
// Goals of any joint, rotations, axes, boxes, steps and gaze on the command line, measured by the
// written files' own kinematics.
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/human.hpp>

#include "app/result_checks.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;

constexpr double kTurn = 0.5;  // degrees, kTurnTolerance

std::string text(const Vec3d& p) { return fmt::format("{},{},{}", p.x, p.y, p.z); }

double angle_deg(const Vec3d& a, const Vec3d& b) {
  return degrees(std::atan2(norm(cross(a, b)), dot(a, b)));
}

// Angle (degrees) between a node's final rotation and the wanted one.
double off_deg(const ExportedMotion& motion, const std::string& node, const Quatd& wanted) {
  return degrees(
      norm(rotation_vector(to_matrix(wanted) * transpose(motion.rotation_at_end(node)))));
}

class Goals : public testing::Test {
 protected:
  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }

  ProgramRun reach(const Words& more) {
    Words call{"reach", "--character", "human", "--formats",    "bvh", "--out",
               "out",   "--seed",      "3",     "--candidates", "2"};
    if (std::find(more.begin(), more.end(), "--evaluations") == more.end()) {
      call.insert(call.end(), {"--evaluations", "200"});
    }
    call.insert(call.end(), more.begin(), more.end());
    return run(call);
  }

  // where the human's effector is at the start
  static Vec3d start(const std::string& effector) {
    static const PosedBody posed = human_body();
    return effector_position(posed, posed.home.angles, effector.c_str());
  }

  [[nodiscard]] StoredRun stored(const std::string& folder = "out") const {
    return {work_, folder};
  }
  [[nodiscard]] Json summary(const std::string& folder = "out") const {
    return stored(folder).summary();
  }
  [[nodiscard]] ExportedMotion best(const std::string& folder = "out") const {
    const StoredRun run = stored(folder);
    return run.motion(run.candidate(1));
  }

  WorkFolder work_;
};

TEST_F(Goals, EveryJointGoesWhereItIsTold) {
  const std::pair<const char*, Vec3d> ways[] = {
      {"head", {0.05, -0.12, 0.15}},       {"neck", {0.0, -0.1, 0.15}},
      {"hips", {0.02, -0.25, -0.08}},      {"chest", {0.1, -0.05, 0.05}},
      {"left_shoulder", {0.0, -0.1, 0.1}}, {"right_elbow", {-0.1, 0.15, 0.2}},
      {"left_elbow", {0.15, 0.2, 0.1}},    {"right_wrist", {-0.1, 0.3, 0.3}},
      {"left_foot", {0.05, 0.0, 0.3}},     {"right_foot", {-0.05, 0.0, 0.3}},
      {"right_toes", {0.0, 0.0, -0.2}}};
  for (const auto& [effector, way] : ways) {
    // the nodes of the foot that bears the human at first are no effectors of that body
    const bool base =
        std::string(effector) == "right_foot" || std::string(effector) == "right_toes";
    const std::string mirrored = "left_" + std::string(effector).substr(base ? 6 : 0);
    const Vec3d left = base ? start(mirrored) : Vec3d{};
    const Vec3d from = base ? Vec3d{-left.x, left.y, left.z} : start(effector);
    const ProgramRun done = reach({"--goal", std::string(effector) + "=" + text(from + way)});
    EXPECT_THAT(done.exit_code, delivered()) << effector << done.err;
    expect_promises_kept(stored());
  }
}

TEST_F(Goals, KneesGoAheadAsFarAsTheirFeetLetThem) {
  for (const std::string knee : {"left_knee", "right_knee"}) {
    // a shank turns about its ankle: the height is left to it
    const Vec3d goal = start(knee) + Vec3d{0, -0.02, 0.1};
    const ProgramRun done =
        reach({"--goal", knee + "=" + text(goal), "--tolerance", knee + "=0.01,0.03,0"});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    const ExportedMotion motion = best();
    const std::string node = knee.substr(0, knee.find('_')) + "_lower_leg";
    EXPECT_NEAR(motion.at_end(node).z, goal.z, kMillimetre);
    expect_feet_stand(motion, stored().candidate(1));
  }
}

TEST_F(Goals, BothHandsAndTheHeadAtOnce) {
  const ProgramRun done =
      reach({"--goal", "right_hand=-0.2,0.9,0.4", "--goal", "left_hand=0.2,1.1,0.4", "--goal",
             "head=" + text(start("head") + Vec3d{0, -0.1, 0.12})});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(stored().candidate(1).at("reached").size(), 3u);
  expect_promises_kept(stored());
}

TEST_F(Goals, BothHandsAreTurnedAsTold) {
  // forearms level ahead, the right palm down and the left one up
  const Quatd right{-0.5, 0.5, -0.5, 0.5};
  const Quatd left{-0.5, 0.5, -0.5, 0.5};
  const ProgramRun done =
      reach({"--goal", "right_hand=-0.2,1.0,0.4", "--goal", "left_hand=0.2,1.0,0.4", "--rotation",
             "right_hand=-0.5,0.5,-0.5,0.5", "--rotation", "left_hand=-0.5,0.5,-0.5,0.5"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  expect_promises_kept(stored());
  for (const Json& candidate : Json(summary().at("candidates"))) {
    const ExportedMotion motion = stored().motion(candidate);
    for (std::size_t g = 0; g < 2; ++g) {
      const Json& goal = candidate.at("reached").at(g);
      const double off = off_deg(motion, goal.at("joint"), g == 0 ? right : left);
      EXPECT_LE(off, kTurn);
      EXPECT_NEAR(off, goal.at("rotation_error_deg").get<double>(), 1e-3);
    }
  }
  // the right palm is +x of its hand, the left one -x
  EXPECT_LT(angle_deg(best().rotation_at_end("right_hand").cx, {0, -1, 0}), kTurn);
  EXPECT_LT(angle_deg(-best().rotation_at_end("left_hand").cx, {0, 1, 0}), kTurn);
}

TEST_F(Goals, PalmFacesDownAndTheHandIsFreeToTurnAboutIt) {
  ASSERT_EQ(reach({"--goal", "right_hand=-0.25,0.95,0.4", "--palm", "right_hand=down"}).exit_code,
            0);
  expect_promises_kept(stored());
  for (const Json& candidate : Json(summary().at("candidates"))) {
    const ExportedMotion motion = stored().motion(candidate);
    EXPECT_LE(angle_deg(motion.rotation_at_end("right_hand").cx, {0, -1, 0}), kTurn);
  }
  // fingers ahead as well is a rotation
  const ProgramRun whole = reach({"--goal", "right_hand=-0.25,0.95,0.4", "--palm",
                                  "right_hand=down", "--fingers", "right_hand=0.3,0,1"});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  const Mat3d turned = best().rotation_at_end("right_hand");
  EXPECT_LE(angle_deg(turned.cx, {0, -1, 0}), kTurn);
  EXPECT_LE(angle_deg(-turned.cy, {0.3, 0, 1}), kTurn);
}

TEST_F(Goals, WhatCannotTurnSoFarEndsAsNearAsItGets) {
  // a pelvis upside down above two planted feet
  const ProgramRun done =
      reach({"--goal", "hips=0,0.8,0", "--rotation", "hips=1,0,0,0", "--evaluations", "100"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_THAT(done.err, HasSubstr("° from what is asked"));
  const Json told = summary();
  EXPECT_EQ(told.at("status"), "unreachable");
  EXPECT_GT(told.at("remaining_deg").get<double>(), kTurn);
  const Json goal = stored().candidate(1).at("reached").at(0);
  EXPECT_NEAR(off_deg(best(), "hips", {1, 0, 0, 0}), goal.at("rotation_error_deg").get<double>(),
              1e-3);
  expect_feet_stand(best(), stored().candidate(1));
}

TEST_F(Goals, EndsWithinTheBoxAndUsesIt) {
  const Vec3d middle{-0.25, 0.9, 0.5};
  const Vec3d half{0.05, 0.0, 0.1};
  ASSERT_EQ(
      reach({"--goal", "right_hand=" + text(middle), "--tolerance", "right_hand=" + text(half)})
          .exit_code,
      0);
  for (const Json& candidate : Json(summary().at("candidates"))) {
    const Vec3d end = stored().motion(candidate).at_end("right_hand_grip");
    EXPECT_NEAR(end.y, middle.y, kMillimetre);
    for (const int k : {0, 2}) EXPECT_LE(std::fabs(end[k] - middle[k]), half[k]);
    // the hand comes from the near side and goes no farther than it must
    EXPECT_LT(end.z, middle.z - 0.5 * half.z);
    EXPECT_LT(candidate.at("reached").at(0).at("error_mm").get<double>(), 1.0);
  }
}

TEST_F(Goals, BoxBringsAPointOutOfReachWithinIt) {
  const std::string far = "right_hand=-0.25,1.2,2.0";
  EXPECT_EQ(reach({"--goal", far}).exit_code, 3);
  const ProgramRun done = reach({"--goal", far, "--tolerance", "right_hand=0.1,0.1,1.4"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_GE(best().at_end("right_hand_grip").z, 0.6);
}

TEST_F(Goals, FootStepsAndTheOtherStays) {
  for (const std::string foot : {"left", "right"}) {
    const std::string other = foot == "left" ? "right" : "left";
    const Vec3d left = start("left_foot");
    const Vec3d from{foot == "left" ? left.x : -left.x, left.y, left.z};
    const ProgramRun done = reach({"--goal", foot + "_foot=" + text(from + Vec3d{0, 0, 0.35})});
    EXPECT_THAT(done.exit_code, delivered()) << done.err;
    expect_promises_kept(stored());
    const Json contacts = stored().candidate(1).at("contacts");
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts.at(0).at("effector"), other + "_foot");
    const ExportedMotion motion = best();
    EXPECT_LE(motion.slide(other + "_foot"), kMillimetre);
    EXPECT_LE(motion.tilt(foot + "_foot"), radians(5.0));
    const Mat3d turned =
        motion.rotation_at_end(foot + "_foot") * transpose(motion.rotation(foot + "_foot", 0));
    EXPECT_LE(degrees(norm(rotation_vector(turned))), kTurn);
    // it neither scrapes nor flies
    const Vec3d midway = motion.at(foot + "_foot", motion.frames() / 2);
    EXPECT_GT(midway.y - from.y, 0.05);
    EXPECT_LT(midway.y - from.y, 0.2);
    for (int f = 0; f < motion.frames(); ++f) {
      EXPECT_GE(motion.at(foot + "_foot", f).y, from.y - kMillimetre);
    }
  }
}

TEST_F(Goals, StandsOnOneFoot) {
  const ProgramRun done = reach({"--goal", "right_hand=-0.25,1.2,0.4", "--contacts", "left_foot"});
  EXPECT_THAT(done.exit_code, delivered()) << done.err;
  const ExportedMotion motion = best();
  EXPECT_LE(motion.slide("left_foot"), kMillimetre);
  EXPECT_NEAR(motion.at_end("right_foot").y - motion.at("right_foot", 0).y, 0.1, kMillimetre);
  EXPECT_EQ(stored().candidate(1).at("contacts").size(), 1u);
  // that may be all that is asked
  EXPECT_THAT(reach({"--contacts", "right_foot"}).exit_code, delivered());
  EXPECT_LE(best().slide("right_foot"), kMillimetre);
  EXPECT_NEAR(best().at_end("left_foot").y - best().at("left_foot", 0).y, 0.1, kMillimetre);
}

TEST_F(Goals, HeadTurnsToWhatItLooksAt) {
  const Vec3d points[] = {{1.0, 1.6, 1.0}, {-1.0, 1.6, 1.0}};
  for (const Vec3d& point : points) {
    ASSERT_EQ(reach({"--goal", "right_hand=-0.3,1.1,0.3", "--look-at", text(point)}).exit_code, 0);
    const Vec3d ahead = best().rotation_at_end("head").cz;
    const Vec3d way = point - best().at_end("head");
    // eyes do a part of it
    EXPECT_LT(angle_deg({ahead.x, 0, ahead.z}, {way.x, 0, way.z}), 30.0);
  }
}

TEST_F(Goals, MirrorImageTurnsAndStepsOnTheOtherSide) {
  ASSERT_THAT(reach({"--goal", "right_hand=-0.3,1.1,0.35", "--palm", "right_hand=left", "--goal",
                     "left_foot=" + text(start("left_foot") + Vec3d{0.05, 0, 0.2}), "--look-at",
                     "-0.5,1.2,1"})
                  .exit_code,
              delivered());
  ASSERT_THAT(run({"mirror", "out", "--formats", "bvh", "--out", "image"}).exit_code, delivered());
  const StoredRun image = stored("image");
  expect_promises_kept(image);
  const ExportedMotion motion = best();
  const ExportedMotion other = best("image");
  const auto across = [](const Vec3d& p) { return Vec3d{-p.x, p.y, p.z}; };
  for (const char* node : {"hand_grip", "foot", "lower_arm", "lower_leg"}) {
    const std::string right = std::string("right_") + node;
    const std::string left = std::string("left_") + node;
    for (const int f : {motion.frames() / 2, motion.frames() - 1}) {
      EXPECT_LT(norm(across(motion.at(right, f)) - other.at(left, f)), 2e-3) << right << f;
      EXPECT_LT(norm(across(motion.at(left, f)) - other.at(right, f)), 2e-3) << left << f;
    }
  }
  EXPECT_LE(angle_deg(-other.rotation_at_end("left_hand").cx, {-1, 0, 0}), kTurn);
  EXPECT_EQ(image.summary().at("task").at("look_at_m").at(0), 0.5);
}

TEST_F(Goals, TaskFileSaysTheSameAndAnEditKeepsIt) {
  work_.put("task.json", R"({"character": "human", "evaluations": 200, "seed": 3, "candidates": 2,
    "look_at_m": [0.2, 1.3, 1.0], "contacts": ["right_foot", "left_foot"],
    "goals": [{"effector": "right_hand", "position_m": [-0.25, 1.0, 0.4],
               "axis": {"axis": "palm", "direction": "down"}, "tolerance_m": [0.02, 0, 0.03]}]})");
  ASSERT_EQ(run({"reach", "task.json", "--formats", "bvh", "--out", "file"}).exit_code, 0);
  ASSERT_EQ(reach({"--goal", "right_hand=-0.25,1.0,0.4", "--palm", "right_hand=down", "--tolerance",
                   "right_hand=0.02,0,0.03", "--look-at", "0.2,1.3,1", "--contacts",
                   "right_foot,left_foot"})
                .exit_code,
            0);
  EXPECT_EQ(stored("file").get("candidate-1.bvh"), stored().get("candidate-1.bvh"));
  ASSERT_EQ(run({"edit", "out", "--formats", "bvh", "--out", "same"}).exit_code, 0);
  EXPECT_EQ(stored("same").get("candidate-1.bvh"), stored().get("candidate-1.bvh"));
}

TEST_F(Goals, NlpIkTurnsHandsToo) {
  const ProgramRun done = reach({"--generator", "nlp_ik", "--evaluations", "40", "--goal",
                                 "right_hand=-0.25,1.0,0.4", "--palm", "right_hand=down"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_LE(angle_deg(best().rotation_at_end("right_hand").cx, {0, -1, 0}), kTurn);
}

// parts of the figure in the accent colour
int accented(const std::string& svg) {
  int count = 0;
  const std::string accent = "#a32b19";
  for (std::size_t at = svg.find(accent); at != svg.npos; at = svg.find(accent, at + 1)) ++count;
  return count;
}

TEST_F(Goals, TheLimbThatAGoalMovesIsAccentedInTheFigure) {
  const auto drawn = [this](const std::string& goal) {
    const ProgramRun made =
        run({"reach", "--character", "human", "--goal", goal, "--formats", "svg", "--evaluations",
             "200", "--candidates", "1", "--out", "out"});
    EXPECT_THAT(made.exit_code, delivered()) << made.err;
    return accented(work_.get("out/candidate-1.svg"));
  };
  EXPECT_EQ(drawn("head=0,1.5,0.2"), 0);
  const int poses = 7;
  EXPECT_EQ(drawn("left_foot=0.15,0.3,0.3"), 3 * poses);  // thigh, shank, foot
  EXPECT_EQ(drawn("right_elbow=-0.4,1.3,0.2"), 3 * poses);
}

}  // namespace
}  // namespace shigusa
