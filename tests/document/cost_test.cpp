// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/human.hpp>
#include <shigusa/score.hpp>

#include "document/joint_names.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "schema_check.hpp"
#include "support/bodies.hpp"
#include "support/work.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// The box of that work with what it costs.
const Work& costed_work() {
  static const Work made([] {
    TaskFile file = box_task();
    file.cost = true;
    file.ergonomics.age = 40.0;
    return file;
  }());
  return made;
}

TEST(CandidateCost, TellsTheLiftOfAPieceOfWork) {
  const Work& work = costed_work();
  ASSERT_FALSE(work.generation.candidates.empty());
  const Candidate& candidate = work.generation.candidates.front();
  const auto cost =
      candidate_cost(work.task, candidate, ergonomics_of(work.task, work.file.character.sex));
  ASSERT_TRUE(cost);
  ASSERT_EQ(cost->frames.size(), static_cast<std::size_t>(candidate.motion.clip.frames));
  ASSERT_EQ(cost->lifts.size(), 1U);
  const LiftCost& lift = cost->lifts.front();
  EXPECT_EQ(lift.span.thing, "box");
  EXPECT_EQ(lift.span.hands.size(), 2U);
  EXPECT_EQ(lift.origin.load, 4.0);
  EXPECT_LT(lift.origin.vertical, 0.45);
  EXPECT_NEAR(lift.destination.vertical, 0.9, 0.2);
  EXPECT_NEAR(lift.destination.travel, lift.destination.vertical - lift.origin.vertical, 1e-9);
  EXPECT_GT(lift.index.value(), 0.1);
  EXPECT_LT(lift.index.value(), 1.5);
  // the load counts while it is in the hands, and not before
  const auto load_in = [&](double time) {
    const auto frame = static_cast<std::size_t>(time / candidate.motion.clip.frame_time);
    return cost->frames.at(frame).rula[0]->parts.force;
  };
  EXPECT_EQ(load_in(0.0), 0);
  EXPECT_EQ(load_in(0.5 * (cost->frames[static_cast<std::size_t>(lift.span.taken)].time +
                           cost->frames[static_cast<std::size_t>(lift.span.put)].time)),
            1);
  EXPECT_TRUE(cost->back->forces->limit);
  EXPECT_GT(cost->back->forces->compression.value, 1000.0);
  EXPECT_LT(cost->back->forces->compression.value, 6000.0);
}

TEST(CandidateCost, IsToldOnlyIfAskedForAndFollowsTheSchema) {
  const auto told = [](const Work& work) {
    return nlohmann::json::parse(format_result({work.file, work.task, work.generation, {}}));
  };
  const nlohmann::json json = told(costed_work());
  EXPECT_EQ(SchemaCheck::in_docs("result.schema.json").judge(json), "");
  for (const auto& candidate : json["candidates"]) {
    EXPECT_EQ(candidate["cost"]["lifts"].size(), 1U);
    EXPECT_EQ(candidate["cost"]["ergonomics"]["coupling"], "good");
    EXPECT_EQ(candidate["cost"]["reba"]["parts"].size(), 9U);
  }
  EXPECT_FALSE(told(box_work())["candidates"][0].contains("cost"));
  const auto again = parse_result(json.dump(), "again");
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_TRUE(again->task.cost);
  EXPECT_EQ(again->task.ergonomics, costed_work().file.ergonomics);
}

TEST(CandidateCost, StandsInCsv) {
  const Work& work = costed_work();
  const auto csv = [](const Work& of) {
    return export_candidate(of.task, of.generation.candidates.front(), FileFormat::csv).value();
  };
  const std::string with = csv(work);
  for (const char* column : {"reba.left", "reba.trunk", "rula.right", "rula.wrist_twist",
                             "l5s1.moment [N m]", "l5s1.compression [N]", "l5s1.shear [N]"}) {
    EXPECT_NE(with.find(column), with.npos) << column;
    EXPECT_EQ(csv(box_work()).find(column), with.npos) << column;
  }
}

// A posture in each frame after the first one, which is the home: the hips and the back bent, arms
// and head anywhere.
Clip drawn_postures(const PosedBody& person, int count) {
  Random random(17);
  Clip clip{.dofs = person.body.dof_count(), .frames = 1, .angles = person.home.angles};
  for (int n = 0; n < count; ++n, ++clip.frames) {
    std::vector<double> angles = person.home.angles;
    const double hips = random.uniform(0.0, 1.0);
    const double back = random.uniform(-0.1, 0.25);
    for (int d = 0; d < person.body.dof_count(); ++d) {
      const Dof& dof = person.body.dof(d);
      double& angle = angles[static_cast<std::size_t>(d)];
      // the same draws for bodies of other skeletons
      const double any = random.uniform(0.15, 0.7);
      if (dof.part.is(JointKind::hip, FreedomKind::flexion)) angle += hips;
      if (dof.part.limb == LimbKind::leg) continue;
      const bool bends = dof.part.freedom_kind == FreedomKind::flexion;
      if (dof.part.limb == LimbKind::trunk) {
        if (bends) angle += back;
      } else if (dof.part.joint_kind != JointKind::clavicle &&
                 dof.part.joint_kind != JointKind::wrist) {
        angle = dof.lower + any * (dof.upper - dof.lower);
      }
    }
    clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
  }
  return clip;
}

// The cost of postures, and that of the same postures read from a BVH file of the skeleton.
TEST(ClipCost, OfTheSamePosturesAsBvhOfOtherSkeletonsIsTheSame) {
  BodyBuild small;
  small.stature = 1.58;
  small.sex = Sex::female;
  BodyBuild tall;
  tall.stature = 1.92;
  const std::pair<PosedBody, JointNames> skeletons[] = {{human_body(), JointNames::own},
                                                        {human_body(small), JointNames::mixamo},
                                                        {human_body(tall), JointNames::unreal}};
  for (const auto& [person, names] : skeletons) {
    const Clip clip = drawn_postures(person, 200);
    const Motion motion = ClipDynamics(person.body).completed(clip);
    const MotionCost own = motion_cost({person, motion}).value();
    SkeletonMotion file = skeleton_motion(person.body, clip);
    file.skeleton = named(std::move(file.skeleton), names);
    CharacterSpec character;
    character.source = "postures.bvh";
    character.frame = 0;
    character.stature = person.body.stature();
    const auto recorded = parse_recorded(format_bvh(file), "postures.bvh", character, 0);
    ASSERT_TRUE(recorded) << recorded.error().to_string();
    ScoreSettings settings;
    settings.cutoff = 0.0;
    settings.ergonomics.emplace();
    const auto score = score_clip(*recorded, settings);
    ASSERT_TRUE(score) << score.error().to_string();
    ASSERT_EQ(score->cost->frames.size(), own.frames.size());
    int same = 0;
    int all = 0;
    for (std::size_t f = 0; f < own.frames.size(); ++f) {
      for (std::size_t k = 0; k < 2; ++k) {
        const int reba =
            std::abs(own.frames[f].reba[k]->score - score->cost->frames[f].reba[k]->score);
        const int rula =
            std::abs(own.frames[f].rula[k]->score - score->cost->frames[f].rula[k]->score);
        EXPECT_LE(reba, 2) << f;
        EXPECT_LE(rula, 2) << f;
        same += reba == 0 && rula == 0 ? 1 : 0;
        ++all;
      }
    }
    // the rest are arms that the fit of a leap from posture to posture leaves a few degrees off
    EXPECT_GT(same, all * 9 / 10) << person.body.stature();
  }
}

}  // namespace
}  // namespace shigusa
