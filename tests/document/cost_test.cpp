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
#include "result_sample.hpp"
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

TEST(CandidateCost, IsToldIfAskedForAndFollowsTheSchema) {
  const auto told = [](const Work& work) {
    return nlohmann::json::parse(format_result({work.file, work.task, work.generation, {}}));
  };
  const nlohmann::json json = told(costed_work());
  EXPECT_EQ(SchemaCheck::in_docs("result.schema.json").judge(json), "");
  for (const auto& candidate : json["candidates"]) {
    EXPECT_EQ(candidate["cost"]["niosh"].size(), 1U);
    EXPECT_EQ(candidate["cost"]["ergonomics"]["coupling"], "good");
    EXPECT_EQ(candidate["cost"]["reba"]["parts"].size(), 9U);
  }
  const auto again = parse_result(json.dump(), "again");
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_TRUE(again->task.cost);
  EXPECT_EQ(again->task.ergonomics, costed_work().file.ergonomics);
}

// By the contract of pieces of work; of tasks with goals alone nothing is computed.
TEST(CandidateCost, OfAPieceOfWorkIsToldUnasked) {
  const Work& work = box_work();
  const nlohmann::json json =
      nlohmann::json::parse(format_result({work.file, work.task, work.generation, {}}));
  for (const auto& candidate : json["candidates"]) {
    const auto& cost = candidate["cost"];
    EXPECT_GT(cost["reba"]["worst"], 0);
    EXPECT_GT(cost["rula"]["mean"], 0.0);
    EXPECT_EQ(cost["niosh"][0]["thing"], "box");
    EXPECT_GT(cost["niosh"][0]["lifting_index"], 0.0);
    EXPECT_GT(cost["low_back"]["compression_n"], 1000.0);
  }
  EXPECT_EQ(candidate_costs({work.file, work.task, work.generation})->size(),
            work.generation.candidates.size());
  TaskFile asked;
  asked.goals = {{.effector = "right_hand", .position = {-0.2, 1.1, 0.4}}};
  const ResultSample goals(asked);
  EXPECT_TRUE(candidate_costs({goals.file, goals.task, goals.generation})->empty());
}

TEST(Ergonomics, AreAssignedByTheKeysOfFiles) {
  Ergonomics before;
  before.rapid = true;
  const auto after = with_assignments(
      before, "coupling=poor,lifts_per_min=4,held=true,thresholds.upright_rad=0.1");
  ASSERT_TRUE(after) << after.error().to_string();
  EXPECT_EQ(after->coupling, Coupling::poor);
  EXPECT_EQ(after->lifts_per_min, 4.0);
  EXPECT_TRUE(after->held && after->rapid);
  EXPECT_EQ(after->thresholds.upright, 0.1);
  for (const char* wrong : {"", "coupling", "=poor", "coupling=loose", "lifts_per_min=-1",
                            "rapid=1", "grip=poor", "coupling=poor,", "thresholds=1",
                            "coupling.poor=1", "age_years=1e400", "coupling=poor,coupling.a=1"}) {
    EXPECT_FALSE(with_assignments({}, wrong)) << wrong;
  }
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

// Frames from one drawn posture to the next: a motion does not leap, and the fit of a file to a
// body follows it from frame to frame.
constexpr int kBetween = 8;

// A motion from the home through drawn postures: the hips and the back bent, arms and head
// anywhere.
Clip drawn_postures(const PosedBody& person, int count) {
  Random random(17);
  Clip clip{.dofs = person.body.dof_count(),
            .frames = 1,
            .frame_time = 1.0 / 60.0,
            .angles = person.home.angles};
  std::vector<double> from = person.home.angles;
  for (int n = 0; n < count; ++n) {
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
    for (int k = 1; k <= kBetween; ++k, ++clip.frames) {
      const double share = static_cast<double>(k) / kBetween;
      for (std::size_t d = 0; d < angles.size(); ++d) {
        clip.angles.push_back(from[d] + share * (angles[d] - from[d]));
      }
    }
    from = angles;
  }
  return clip;
}

// Share of the drawn postures, with either arm, that have the same scores by REBA and RULA in a BVH
// file as on the body that it was written from; none differs by more than 2.
double same_scores(const PosedBody& person, const Clip& clip, const std::string& bvh) {
  const MotionCost own = motion_cost({person, ClipDynamics(person.body).completed(clip)}).value();
  CharacterSpec character;
  character.source = "postures.bvh";
  character.frame = 0;
  character.stature = person.body.stature();
  const auto recorded = parse_recorded(bvh, "postures.bvh", character, 0);
  EXPECT_TRUE(recorded) << recorded.error().to_string();
  ScoreSettings settings;
  settings.cutoff = 0.0;
  settings.ergonomics.emplace();
  const auto score = score_clip(*recorded, settings);
  EXPECT_TRUE(score) << score.error().to_string();
  EXPECT_EQ(score->cost->frames.size(), own.frames.size());
  int same = 0;
  int all = 0;
  for (std::size_t f = kBetween; f < own.frames.size(); f += kBetween) {
    const FrameCost& read = score->cost->frames.at(f);
    for (std::size_t k = 0; k < 2; ++k, ++all) {
      const int reba = std::abs(own.frames[f].reba[k]->score - read.reba[k]->score);
      const int rula = std::abs(own.frames[f].rula[k]->score - read.rula[k]->score);
      EXPECT_LE(std::max(reba, rula), 2) << f;
      same += reba == 0 && rula == 0 ? 1 : 0;
    }
  }
  return static_cast<double>(same) / all;
}

TEST(ClipCost, OfTheSamePosturesAsBvhOfOtherNamesIsTheSame) {
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
    SkeletonMotion file = skeleton_motion(person.body, clip);
    file.skeleton = named(std::move(file.skeleton), names);
    EXPECT_GE(same_scores(person, clip, format_bvh(file)), 0.95) << person.body.stature();
  }
}

// Skeletons with other spines, clavicles and names than the built-in bodies' own.
TEST(ClipCost, OfTheSamePosturesOnOtherHierarchiesIsTheSame) {
  for (const char* name :
       {"assimp__Boxing_Toes.bvh", "fairmotion__pfnn_hierarchy.bvh", "bvhtoolbox_walk01.bvh"}) {
    TaskFile file;
    file.character.source =
        (std::filesystem::path(SHIGUSA_SHARED_DIR) / "characters" / name).string();
    if (!std::filesystem::exists(file.character.source)) GTEST_SKIP() << "no shared/characters";
    file.goals = {{.effector = "right_hand", .position = {-0.2, 1.0, 0.4}}};
    const auto task = make_task(file, {});
    ASSERT_TRUE(task) << task.error().to_string();
    Candidate candidate;
    const Clip clip = drawn_postures(*task, 200);
    candidate.motion = ClipDynamics(task->body).completed(clip);
    const auto bvh = export_candidate(file.character, *task, candidate, FileFormat::bvh);
    ASSERT_TRUE(bvh) << bvh.error().to_string();
    EXPECT_GE(same_scores(*task, clip, *bvh), 0.95) << name;
  }
}

}  // namespace
}  // namespace shigusa
