// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/cost.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "body/load.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

// A posture held still, with a mass (kg) in each hand.
MotionCost cost_of(const PosedBody& person, const Clip& clip, double each,
                   const Ergonomics& ergonomics = {}, std::vector<LiftSpan> lifts = {}) {
  BodyModel loaded = person.body;
  HeldSpan span{0, clip.frames - 1, {}};
  for (const Side side : {Side::left, Side::right}) {
    if (!(each > 0.0)) continue;
    span.loads.push_back(
        {.effector = person.body.find_effector(JointKind::hand, side).value(), .mass = each});
    loaded = with_load(loaded, span.loads.back());
  }
  const Motion motion = ClipDynamics(loaded).completed(clip);
  const auto cost = motion_cost({person, motion, std::span(&span, 1), lifts}, ergonomics);
  EXPECT_TRUE(cost);
  return *cost;
}

Clip still(const std::vector<double>& angles) {
  return {.dofs = static_cast<int>(angles.size()), .frames = 1, .angles = angles};
}

// The person with the hips bent by an angle (rad) over straight legs and hanging arms.
std::vector<double> bent(const PosedBody& person, double hips) {
  std::vector<double> angles = person.home.angles;
  for (const int hip : person.body.dofs_of(JointKind::hip, FreedomKind::flexion)) {
    angles[static_cast<std::size_t>(hip)] += hips;
  }
  for (const int shoulder : person.body.dofs_of(JointKind::shoulder, FreedomKind::flexion)) {
    angles[static_cast<std::size_t>(shoulder)] += hips;
  }
  return angles;
}

// Bands of low_back.md for a man of 70 to 80 kg.
TEST(MotionCost, BackIsWithinPublishedBands) {
  const PosedBody man = human_body();
  const MotionCost upright = cost_of(man, still(man.home.angles), 0.0);
  EXPECT_LT(upright.back->moment.value, 25.0);
  EXPECT_GT(upright.back->forces->compression.value, 300.0);
  EXPECT_LT(upright.back->forces->compression.value, 1000.0);
  const MotionCost leaning = cost_of(man, still(bent(man, radians(45.0))), 0.0);
  EXPECT_GT(leaning.back->moment.value, 60.0);
  EXPECT_LT(leaning.back->moment.value, 120.0);
  EXPECT_GT(leaning.back->forces->compression.value, 1200.0);
  EXPECT_LT(leaning.back->forces->compression.value, 2800.0);
  EXPECT_GT(leaning.back->forces->compression.value, 2.0 * upright.back->forces->compression.value);
}

// The moment of the weights above the joint about it, added up here.
TEST(MotionCost, BackMomentIsThatOfTheWeightsAbove) {
  const PosedBody man = human_body();
  const int spine = man.body.find_dof(JointKind::spine, FreedomKind::rotation).value();
  for (const double lean : {0.2, 0.7, 1.2}) {
    for (const double each : {0.0, 8.0}) {
      const std::vector<double> angles = bent(man, lean);
      const Kinematics<double> at = testing_support::placed(man.body, angles);
      Vec3d moment{};
      double weight = 0.0;
      const auto add = [&](const Vec3d& place, double mass) {
        moment += cross(place - at.link_origin(spine), Vec3d{0.0, -kGravity * mass, 0.0});
        weight += kGravity * mass;
      };
      for (int link = 0; link < man.body.dof_count(); ++link) {
        const MassProperties& own = man.body.link_mass(link);
        if (man.body.moves(spine, link) && own.mass > 0.0) add(at.point(link, own.com), own.mass);
      }
      for (const Effector& hand : man.body.effectors()) {
        if (each > 0.0) add(at.point(hand.link, hand.point), each);
      }
      const MotionCost cost = cost_of(man, still(angles), each);
      EXPECT_NEAR(cost.back->moment.value, norm(moment), 0.03 * norm(moment) + 0.5);
      const BackForces& forces = cost.frames[0].back.value();
      EXPECT_NEAR(forces.muscle, cost.back->moment.value / kBackLever, 1e-6);
      const double along = forces.compression - forces.muscle;
      EXPECT_NEAR(sqrt(along * along + forces.shear * forces.shear), weight, 1e-6);
    }
  }
}

TEST(MotionCost, ScoresOfKnownPosturesAreTheirTables) {
  const PosedBody man = human_body();
  const MotionCost upright = cost_of(man, still(man.home.angles), 0.0);
  EXPECT_EQ(upright.reba->score.worst, 1);
  EXPECT_EQ(upright.rula->score.worst, upright.frames[0].rula[0]->score);
  EXPECT_DOUBLE_EQ(upright.reba->above[0], 1.0);
  EXPECT_DOUBLE_EQ(upright.reba->above[1], 0.0);
  // trunk 3, hanging arms, whose flexion of 45° gravity helps; 12 kg
  const MotionCost lift = cost_of(man, still(bent(man, radians(44.0))), 6.0);
  const RebaParts& parts = lift.frames[0].reba[0]->parts;
  EXPECT_EQ(parts.trunk, 3);
  EXPECT_EQ(parts.load, 2);
  EXPECT_EQ(parts.upper_arm, 1);
  EXPECT_EQ(lift.frames[0].rula[0]->parts.force, 3);
  Ergonomics asked;
  asked.coupling = Coupling::poor;
  asked.repeated = true;
  const MotionCost worse = cost_of(man, still(bent(man, radians(44.0))), 6.0, asked);
  EXPECT_EQ(worse.frames[0].reba[0]->parts.coupling, 2);
  EXPECT_EQ(worse.frames[0].reba[0]->parts.activity, 1);
  EXPECT_EQ(worse.frames[0].rula[0]->parts.muscle, 1);
}

// A slow motion along the minimum-jerk curve between two postures: of quick ones the load's inertia
// may relieve the back.
Clip between(const std::vector<double>& from, const std::vector<double>& to, int frames) {
  Clip clip{
      .dofs = static_cast<int>(from.size()), .frames = frames, .frame_time = 0.1, .angles = {}};
  for (int f = 0; f < frames; ++f) {
    const double t = static_cast<double>(f) / (frames - 1);
    const double s = t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
    for (std::size_t d = 0; d < from.size(); ++d) {
      clip.angles.push_back(from[d] + (to[d] - from[d]) * s);
    }
  }
  return clip;
}

bool all_finite(const MotionCost& cost) {
  for (const FrameCost& frame : cost.frames) {
    if (!is_finite(frame.back_moment.value()) || !is_finite(frame.back->compression) ||
        !is_finite(frame.back->shear) || !is_finite(frame.angles.trunk->flexion) ||
        !is_finite(frame.angles.neck->twist) || !is_finite(frame.angles.arms[0]->flexion)) {
      return false;
    }
  }
  return true;
}

// Motions that each property is tried on.
constexpr int kMotions = 200;

// A bent posture with arms and head anywhere near, the hands ahead of the back: a load behind it
// would balance the trunk.
std::vector<double> drawn_posture(const PosedBody& man, Random& random) {
  std::vector<double> end = bent(man, random.uniform(0.3, 1.4));
  for (int d = 0; d < man.body.dof_count(); ++d) {
    const Dof& dof = man.body.dof(d);
    if (dof.part.limb == LimbKind::leg) continue;
    const auto k = static_cast<std::size_t>(d);
    const bool raises = dof.part.is(JointKind::shoulder, FreedomKind::flexion);
    end[k] = clamp(end[k] + random.uniform(raises ? 0.2 : -0.3, raises ? 0.8 : 0.3), dof.lower,
                   dof.upper);
  }
  return end;
}

// A posture whose upper body is the mirror image; the legs stand alike.
std::vector<double> mirrored(const PosedBody& man, const std::vector<double>& angles) {
  std::vector<double> image = angles;
  for (int d = 0; d < man.body.dof_count(); ++d) {
    const JointPlace& part = man.body.dof(d).part;
    if (part.limb == LimbKind::leg) continue;
    const double angle = angles[static_cast<std::size_t>(d)];
    const FreedomKind kind = part.freedom_kind;
    const bool turns = kind == FreedomKind::lateral || kind == FreedomKind::rotation;
    if (!part.side) {
      image[static_cast<std::size_t>(d)] = turns ? -angle : angle;
      continue;
    }
    const Side other = *part.side == Side::left ? Side::right : Side::left;
    image[static_cast<std::size_t>(man.body.find_dof(part.joint_kind, kind, other).value())] =
        angle;
  }
  return image;
}

TEST(MotionCost, HeavierIsNeverBetterAndNothingIsNaN) {
  const PosedBody man = human_body();
  const std::vector<int> hands{man.body.find_effector(JointKind::hand, Side::left).value(),
                               man.body.find_effector(JointKind::hand, Side::right).value()};
  Random random(11);
  for (int n = 0; n < kMotions; ++n) {
    const Clip clip = between(man.home.angles, drawn_posture(man, random), 31);
    const auto lifting = [&](double each) {
      return cost_of(man, clip, each, {}, {{"box", 2.0 * each, hands, 0, 30}});
    };
    double each = 0.0;
    MotionCost before = lifting(each);
    ASSERT_TRUE(all_finite(before));
    for (int step = 0; step < 3; ++step) {
      each += random.uniform(0.5, 6.0);
      MotionCost cost = lifting(each);
      ASSERT_TRUE(all_finite(cost));
      ASSERT_EQ(cost.lifts[0].index.has_value(), before.lifts[0].index.has_value());
      if (cost.lifts[0].index) {
        ASSERT_TRUE(is_finite(*cost.lifts[0].index));
        ASSERT_GT(*cost.lifts[0].index, *before.lifts[0].index);
      }
      ASSERT_GE(cost.reba->score.worst, before.reba->score.worst);
      ASSERT_GE(cost.reba->score.mean, before.reba->score.mean);
      ASSERT_GE(cost.rula->score.worst, before.rula->score.worst);
      ASSERT_GE(cost.rula->score.mean, before.rula->score.mean);
      ASSERT_GE(cost.back->moment.value, before.back->moment.value);
      ASSERT_GE(cost.back->forces->compression.value, before.back->forces->compression.value);
      before = std::move(cost);
    }
  }
}

void expect_mirrored(const PostureCourse& own, const PostureCourse& image) {
  ASSERT_EQ(own.score.worst, image.score.worst);
  ASSERT_NEAR(own.score.mean, image.score.mean, 1e-9);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(own.sides[k].worst, image.sides[1 - k].worst);
    ASSERT_NEAR(own.sides[k].mean, image.sides[1 - k].mean, 1e-9);
  }
}

TEST(MotionCost, OfTheMirrorImageIsTheSame) {
  const PosedBody man = human_body();
  Random random(12);
  for (int n = 0; n < kMotions; ++n) {
    const std::vector<double> end = drawn_posture(man, random);
    const double each = random.uniform(0.0, 8.0);
    const MotionCost own = cost_of(man, between(man.home.angles, end, 31), each);
    const MotionCost image = cost_of(man, between(man.home.angles, mirrored(man, end), 31), each);
    ASSERT_NO_FATAL_FAILURE(expect_mirrored(*own.reba, *image.reba)) << n;
    ASSERT_NO_FATAL_FAILURE(expect_mirrored(*own.rula, *image.rula)) << n;
    ASSERT_NEAR(own.back->moment.value, image.back->moment.value, 1e-3 * own.back->moment.value);
    const double compression = own.back->forces->compression.value;
    ASSERT_NEAR(compression, image.back->forces->compression.value, 1e-3 * compression);
  }
}

TEST(MotionCost, TheWorstScoreByRebaAloneIsThatOfAll) {
  const PosedBody man = human_body();
  Random random(13);
  for (int n = 0; n < 20; ++n) {
    const Clip clip = between(man.home.angles, drawn_posture(man, random), 31);
    const Motion motion = ClipDynamics(man.body).completed(clip);
    const HeldSpan held{0, 30, {{.effector = 0, .mass = random.uniform(0.0, 15.0)}}};
    const CostInput input{man, motion, std::span(&held, 1), {}};
    EXPECT_EQ(worst_reba(input), motion_cost(input)->reba->score.worst);
  }
  const PosedBody rods = testing_support::chain({{}, {}});
  const Motion still_rods = held_still(rods.body, rods.home);
  EXPECT_FALSE(worst_reba({rods, still_rods}));
}

TEST(MotionCost, LiftsAreMeasuredFromAnkles) {
  const PosedBody man = human_body();
  const Clip clip = between(bent(man, 1.2), man.home.angles, 61);
  const std::vector<int> hands{man.body.find_effector(JointKind::hand, Side::left).value(),
                               man.body.find_effector(JointKind::hand, Side::right).value()};
  const LiftSpan span{"box", 10.0, hands, 0, 60};
  const MotionCost cost = cost_of(man, clip, 5.0, {}, {span, span});
  ASSERT_EQ(cost.lifts.size(), 2U);
  const LiftCost& lift = cost.lifts[0];
  const auto middle = [&](const char* joint, int frame) {
    const auto at = [&](const char* side) {
      const auto angles = clip.frame(frame);
      const BodyNode* node = man.body.find_node(std::string(side) + joint);
      return node != nullptr
                 ? testing_support::placed(man.body, angles).point(node->link, node->point)
                 : testing_support::effector_position(man.body, angles,
                                                      (std::string(side) + joint).c_str());
    };
    return 0.5 * (at("left_") + at("right_"));
  };
  const Vec3d from = middle("hand_grip", 0) - middle("foot", 0);
  EXPECT_NEAR(lift.origin.horizontal, from.z, 0.01);
  EXPECT_NEAR(lift.origin.vertical, middle("hand_grip", 0).y, 1e-9);
  EXPECT_NEAR(lift.origin.travel, middle("hand_grip", 60).y - middle("hand_grip", 0).y, 1e-9);
  EXPECT_NEAR(lift.origin.asymmetry, 0.0, radians(5.0));
  EXPECT_GT(lift.index.value(), 0.0);
  EXPECT_GE(cost.repeated->index.value(), lift.index.value());
  const MotionCost one = cost_of(man, clip, 5.0, {}, {{"cup", 5.0, {hands[0]}, 0, 60}});
  EXPECT_EQ(one.lifts[0].notes.front().key, "lift_one_hand");
  EXPECT_FALSE(one.repeated);
}

TEST(MotionCost, StrengthsTellWhoIsAble) {
  const PosedBody man = human_body();
  const MotionCost cost = cost_of(man, still(bent(man, 1.0)), 10.0);
  ASSERT_EQ(cost.strengths.size(), man.body.dofs().size());
  for (const StrengthCost& own : cost.strengths) {
    ASSERT_TRUE(own.able >= 0.0 && own.able <= 1.0);
    const double share = own.torque / own.strength;
    EXPECT_EQ(share<1.0, own.able> 0.5) << own.dof;
  }
  const MotionCost free = cost_of(man, still(man.home.angles), 0.0);
  for (const StrengthCost& own : free.strengths) EXPECT_GT(own.able, 0.9) << own.dof;
}

TEST(MotionCost, BodiesWithoutPartsSaySo) {
  const PosedBody man = full_body();
  const MotionCost cost = cost_of(man, still(man.home.angles), 0.0);
  ASSERT_TRUE(cost.reba && cost.back);
  EXPECT_FALSE(cost.back->forces);
  std::vector<std::string> keys;
  for (const Message& note : cost.notes) keys.emplace_back(note.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"cost_no_neck", "cost_no_wrists", "cost_rigid_trunk"}));
  const PosedBody rods = testing_support::chain({{}, {}});
  const Motion motion = held_still(rods.body, rods.home);
  const auto none = motion_cost({rods, motion});
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->reba || none->back);
  EXPECT_EQ(none->notes.front().key, "cost_lacks_parts");
}

}  // namespace
}  // namespace shigusa
