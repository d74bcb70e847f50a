// SPDX-License-Identifier: MIT
// Layers on a whole human: ankles that invert, a spine, clavicles, forearms and wrists.
#include <gmock/gmock.h>

#include <shigusa/generate.hpp>

#include "body/link_mass.hpp"
#include "generate/layered_approaches.hpp"
#include "human/at_ease.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "support/layered.hpp"
#include "support/problems.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

PosedBody crooked_human() {
  return build_human(asymmetric_person(), {"crooked", BodyExtent::human, 1.6, 60.0});
}

std::string link_name(const PosedBody& posed, int link) { return posed.body.dof(link).name; }

Task human_task(const PosedBody& posed, const Vec3d& goal) {
  return with_preset(Task(posed, {.goals = {{"right_hand", goal}}}), Preset::human);
}

// A motion of the upper layer with random weights and lengths, and the motion of all layers.
struct Played {
  LayeredValues parameters;
  ReducedClip<double> clip;
  RolledOut whole;
};

Played play_random(const LayeredProblem& problem, LayeredPlayer& player, Random& random) {
  Played played;
  std::vector<double> point;
  for (std::size_t g = 0; g < problem.layers[0].parameters.size(); ++g) {
    point.push_back(random.uniform(0.2, 0.8));
  }
  const LayeredValues upper = decode_layer_point(problem.layers[0], point);
  played.parameters = start_values(problem.layers);
  played.parameters.joints = upper.joints;
  played.parameters.contractions = upper.contractions;
  player.run_upper(upper, played.clip);
  played.whole = player.expand(played.clip, played.parameters);
  return played;
}

bool arrives(LayeredPlayer& player, const ReducedClip<double>& clip) {
  return clip.path_error < 1e-4 && clip.foot_error < 1e-4 && player.check_pelvis(clip).in_reach;
}

TEST(FindLimbs, OfAWholeHumanHangOnPelvisAndClavicles) {
  const PosedBody posed = human_body();
  const BodyLimbs limbs = find_limbs(posed.body, posed.home).value();
  EXPECT_EQ(link_name(posed, limbs.trunk), "right_hip.flexion");
  ASSERT_EQ(limbs.legs.size(), 2u);
  EXPECT_EQ(link_name(posed, limbs.legs[0].inversion), "right_ankle.inversion");
  EXPECT_EQ(link_name(posed, limbs.legs[1].inversion), "left_ankle.inversion");
  EXPECT_EQ(link_name(posed, limbs.legs[1].ankle), "left_ankle.flexion");
  ASSERT_EQ(limbs.arms.size(), 2u);
  EXPECT_EQ(link_name(posed, limbs.arms[0].carrier), "right_clavicle.protraction");
  EXPECT_EQ(limbs.joints.size(), 3u * 3u + 2u * 2u);
  EXPECT_EQ(find_limbs(full_body().body, full_body().home).value().legs[0].inversion, -1);
  EXPECT_TRUE(find_limbs(full_body().body, full_body().home).value().joints.empty());
}

TEST(FindLimbs, RefuseHeelsThatLiftAndPeopleWhoSit) {
  const PosedBody lifts = human_body({.heels = true});
  EXPECT_FALSE(find_limbs(lifts.body, lifts.home));
  const Landmarks person = seated(standing_landmarks(1.75, 0.1), 1.75, 0.45);
  const PosedBody sits =
      build_human(person, {.name = "seated", .extent = BodyExtent::human, .sits = true});
  EXPECT_FALSE(find_limbs(sits.body, sits.home));
}

TEST(LayeredHuman, LegsShareWeightsSpineGoesByOneAWayAndClaviclesByNone) {
  const Layer upper = human_layers(human_body().body, human_body().home).value()[0];
  std::vector<std::string> genes;
  for (const ParameterInfo& gene : upper.parameters) genes.push_back(gene.name);
  for (const char* name : {"spine.flexion", "spine.lateral", "spine.rotation", "ankle.inversion",
                           "ankle.flexion", "hip.rotation", "legs"}) {
    EXPECT_THAT(genes, Contains(name));
  }
  EXPECT_THAT(genes, Not(Contains("chest.flexion")));
  EXPECT_THAT(genes, Not(Contains("right_clavicle.elevation")));
  EXPECT_EQ(genes.size(), 5u + 3u + 2u * 2u + 2u);
}

TEST(LayeredHuman, WholeBodyIsWhereTheReducedOneIsAndFeetStay) {
  for (const PosedBody& posed : {human_body(), human_body({.base = Side::left}), crooked_human()}) {
    const double size = posed.body.stature();
    const Task task = human_task(posed, {-0.1 * size, 0.5 * size, 0.28 * size});
    const LayeredProblem problem = testing_support::make_layered_problem(task);
    const BodyLimbs& limbs = problem.limbs;
    LayeredPlayer player(problem);
    Random random(5);
    int arrived = 0;
    for (int i = 0; i < 30; ++i) {
      const Played played = play_random(problem, player, random);
      if (!arrives(player, played.clip)) continue;
      ++arrived;
      const Clip& clip = played.whole.motion.clip;
      for (int f = 0; f < clip.frames; ++f) {
        const auto k = static_cast<std::size_t>(f);
        const Kinematics<double> at = placed(posed, clip.frame(f));
        EXPECT_LT(norm(at.link_origin(limbs.trunk) - played.clip.trunk[k].translation), 1e-6);
        EXPECT_LT(rotation_chord(at.link_rotation(limbs.trunk), played.clip.trunk[k].rotation),
                  1e-6);
        const Transformd& carrier = played.clip.carriers[0][k];
        const int link = limbs.arms[static_cast<std::size_t>(problem.arms[0])].carrier;
        EXPECT_LT(norm(at.link_origin(link) - carrier.translation), 1e-6);
        const Effector& hand = posed.body.effectors()[0];
        EXPECT_LT(norm(at.point(hand.link, hand.point) - played.clip.hands[0][k]), 1e-6);
      }
      const MeasuredMotion measured(problem.reach, clip);
      EXPECT_LT(measured.contact_slide, 1e-6);
      EXPECT_LT(measured.contact_tilt, 1e-6);
      EXPECT_LT(measured.goal_error, 1e-4);
      EXPECT_LT(measured.start_error, 1e-12);
    }
    EXPECT_GE(arrived, 10) << posed.body.name();
  }
}

TEST(LayeredHuman, AnklesAndSpineKeepTheirLimitsInASquat) {
  const PosedBody posed = human_body();
  const Task task = human_task(posed, {-0.2, 0.25, 0.4});
  const LayeredProblem problem = testing_support::make_layered_problem(task);
  LayeredPlayer player(problem);
  Random random(2);
  double largest = 0.0;
  int arrived = 0;
  for (int i = 0; i < 40; ++i) {
    const Played played = play_random(problem, player, random);
    if (!arrives(player, played.clip)) continue;
    ++arrived;
    std::vector<int> held = problem.limbs.joints;
    for (const BodyLimb& leg : problem.limbs.legs) held.push_back(leg.ankle);
    const Clip& clip = played.whole.motion.clip;
    for (int f = 0; f < clip.frames; ++f) {
      for (const int d : held) {
        const double angle = clip.frame(f)[static_cast<std::size_t>(d)];
        // a step that two chains share is closed to within the tolerance of planted feet
        EXPECT_LT(angle - posed.body.dof(d).upper, radians(0.5)) << posed.body.dof(d).name;
        EXPECT_LT(posed.body.dof(d).lower - angle, radians(0.5)) << posed.body.dof(d).name;
        if (d == problem.limbs.legs[0].ankle) largest = max(largest, angle);
      }
    }
  }
  EXPECT_GE(arrived, 5);
  EXPECT_GT(largest, posed.body.dof(problem.limbs.legs[0].ankle).upper - radians(3.0));
}

TEST(LayeredHuman, HeadTurnsToTheGoalBeforeTheHandArrivesAndTheFreeArmHangs) {
  const PosedBody posed = human_body();
  const Vec3d goal{-0.5, 0.9, 0.35};
  const Task task = human_task(posed, goal);
  const LayeredProblem problem = testing_support::make_layered_problem(task);
  LayeredPlayer player(problem);
  Random random(9);
  const Played played = play_random(problem, player, random);
  ASSERT_TRUE(arrives(player, played.clip));
  const Clip& clip = played.whole.motion.clip;
  const int head = posed.body.find_dof("head.rotation").value();
  const auto off = [&](int frame) {
    const Kinematics<double> at = placed(posed, clip.frame(frame));
    const Vec3d way = normalized(goal - at.link_origin(head));
    return acos(dot(way, at.link_rotation(head).cz));
  };
  EXPECT_LT(off(45), 0.5 * off(0));
  // the hand has a tenth of its way to go when the head has next to nothing left
  EXPECT_LT(abs(off(45) - off(60)), 0.25 * off(0));
  // upper arm within a share of the trunk's lean
  const int arm = posed.body.find_dof("left_shoulder.rotation").value();
  const Kinematics<double> end = placed(posed, clip.frame(60));
  EXPECT_GT(end.link_rotation(arm).cy.y, 0.95);
  // the clavicle of the arm with the goal goes with the line from shoulder to hand
  const auto elevation =
      static_cast<std::size_t>(posed.body.find_dof("right_clavicle.elevation").value());
  const auto wanted = [&](int frame) {
    const Kinematics<double> at = placed(posed, clip.frame(frame));
    const Effector& hand = posed.body.effectors()[0];
    const Vec3d shoulder = at.link_origin(problem.limbs.arms[0].flexion);
    const Vec3d way = normalized(at.point(hand.link, hand.point) - shoulder);
    const Mat3d& chest = at.link_rotation(posed.body.dof(static_cast<int>(elevation)).parent);
    return shrugged(transpose_times(chest, way));
  };
  const auto moved = [&](std::size_t d) { return clip.frame(60)[d] - clip.frame(0)[d]; };
  EXPECT_GT(moved(elevation), radians(2.0));
  EXPECT_NEAR(moved(elevation), wanted(60).elevation - wanted(0).elevation, 1e-3);
  EXPECT_NEAR(moved(elevation + 1), wanted(60).protraction - wanted(0).protraction, 1e-3);
}

TEST(LayeredHuman, ArmAloneHoldsForearmAndHand) {
  const PosedBody posed = human_body();
  const BodyLimb arm = find_limbs(posed.body, posed.home).value().arms[0];
  const PosedBody alone = arm_body(posed.body, posed.home, arm);
  const Kinematics<double> whole = placed(posed, posed.home.angles);
  const Kinematics<double> own = placed(alone, alone.home.angles);
  const Effector& hand = posed.body.effectors()[0];
  const Vec3d shoulder = whole.origin[static_cast<std::size_t>(arm.flexion)];
  const Vec3d way = transpose_times(whole.link_rotation(arm.carrier),
                                    whole.point(hand.link, hand.point) - shoulder);
  EXPECT_LT(norm(own.point(3, alone.body.effectors()[0].point) - way), 1e-12);
  double mass = 0.0;
  LinkMass held;  // by the elbow
  for (int link = arm.flexion; link < posed.body.dof_count(); ++link) {
    const MassProperties& part = posed.body.link_mass(link);
    if (posed.body.moves(arm.flexion, link)) mass += part.mass;
    const Mat3d& turn = whole.link_rotation(link);
    if (!posed.body.moves(arm.hinge, link)) continue;
    held.add(LinkMass::of(part.mass, whole.point(link, part.com),
                          turn * part.inertia * transpose(turn)));
  }
  EXPECT_NEAR(alone.body.mass(), mass, 1e-12);
  const MassProperties wanted = held.in_frame(whole.link_rotation(arm.carrier), shoulder);
  const MassProperties& found = alone.body.link_mass(3);
  EXPECT_NEAR(found.mass, wanted.mass, 1e-12);
  EXPECT_LT(norm(own.point(3, found.com) - wanted.com), 1e-12);
  const Mat3d& turn = own.link_rotation(3);
  const Mat3d inertia = turn * found.inertia * transpose(turn);
  EXPECT_LT(norm(inertia.cx - wanted.inertia.cx), 1e-12);
  EXPECT_LT(norm(inertia.cy - wanted.inertia.cy), 1e-12);
  EXPECT_LT(norm(inertia.cz - wanted.inertia.cz), 1e-12);
}

// A hand's path from its start to a place in front of the chest, and the arm's motion along it.
struct Turned {
  PosedBody posed = human_body();
  BodyLimb arm = find_limbs(posed.body, posed.home).value().arms[0];
  PosedBody alone = arm_body(posed.body, posed.home, arm, true);
  std::vector<double> angles{};

  [[nodiscard]] std::span<const double> frame(int f) const {
    return std::span(angles).subspan(static_cast<std::size_t>(7 * f), 7);
  }
  double run(const Vec3d& goal, double swivel, const EffectorTurn& turn) {
    const Effector& hand = alone.body.effectors()[0];
    const Vec3d start = placed(alone, alone.home.angles).point(hand.link, hand.point);
    const EffectorPath path{start, goal};
    std::vector<Vec3d> places;
    for (int f = 0; f <= 60; ++f) places.push_back(path.at(f / 60.0));
    SwivelArm<double> moved(alone, arm);
    moved.follow(places, {turn.kind, turn.goal, turn.axis, turn.direction});
    const double miss = moved.run(swivel, angles);
    for (int f = 0; f <= 60; ++f) {
      const Vec3d at = placed(alone, frame(f)).point(hand.link, hand.point);
      EXPECT_LT(norm(at - places[static_cast<std::size_t>(f)]), miss + 1e-9);
    }
    return miss;
  }
};

TEST(TurningArm, EndsWithTheRotationWantedAndKeepsToItsPath) {
  Random random(4);
  for (int i = 0; i < 30; ++i) {
    Turned arm;
    EffectorTurn turn{.kind = Turning::whole};
    const double about = -0.5 * kPi + random.uniform(-0.4, 0.4);
    turn.goal = rotation(Axis::y, random.uniform(-0.4, 0.4)) * rotation(Axis::x, about);
    EXPECT_LT(arm.run({random.uniform(-0.1, 0.1), random.uniform(-0.3, 0.0), 0.4},
                      random.uniform(-0.2, 0.5), turn),
              1e-9);
    const Kinematics<double> end = placed(arm.alone, arm.frame(60));
    EXPECT_LT(rotation_chord(end.link_rotation(6), turn.goal), 1e-7);
    for (std::size_t d = 0; d < 7; ++d) {
      EXPECT_LT(abs(arm.frame(31)[d] - arm.frame(30)[d]), 0.2);
      EXPECT_EQ(arm.frame(0)[d], arm.alone.home.angles[d]);
    }
  }
}

TEST(TurningArm, PointsAnAxisAndTurnsNoMoreAboutIt) {
  Turned arm;
  const EffectorTurn up{.kind = Turning::axis, .axis = {1, 0, 0}, .direction = {0, 1, 0}};
  EXPECT_LT(arm.run({0.0, -0.25, 0.4}, 0.1, up), 1e-9);
  const Kinematics<double> end = placed(arm.alone, arm.frame(60));
  EXPECT_LT(up.miss(end.link_rotation(6)), 1e-9);
  // the same axis where it points already leaves the wrist alone
  const EffectorTurn same{
      .kind = Turning::axis, .axis = {1, 0, 0}, .direction = end.link_rotation(6).cx};
  Turned again;
  again.run({0.0, -0.25, 0.4}, 0.1, same);
  for (std::size_t d = 4; d < 7; ++d) EXPECT_NEAR(again.frame(60)[d], arm.frame(60)[d], 1e-9);
}

TEST(LayeredHuman, HandsAreTurnedAsTheirGoalsSay) {
  const GoalAxis palm_up{{1, 0, 0}, {0, 1, 0}};
  const Quatd palm_left_thumb_up = to_quat(rotation(Axis::x, -0.5 * kPi));
  for (const Goal& goal : {Goal{.position = {-0.2, 1.1, 0.4}, .axis = palm_up},
                           Goal{.position = {-0.25, 1.3, 0.35}, .rotation = palm_left_thumb_up}}) {
    Task task = with_preset(Task(human_body(), {.goals = {goal}}), Preset::human);
    task.evaluations = 120;
    const GenerateResult generation = generate(task).value();
    EXPECT_TRUE(generation.meets_goals());
    for (const Candidate& candidate : generation.candidates) {
      EXPECT_LE(candidate.goals[0].error, kReachTolerance);
      ASSERT_TRUE(candidate.goals[0].turn.error);
      EXPECT_LE(*candidate.goals[0].turn.error, kTurnTolerance);
      EXPECT_TRUE(candidate.measures.over_limit.empty());
    }
  }
}

TEST(LayeredHuman, RotationsAreForHandsWithAWristAndThePresetHuman) {
  Goal goal{.position = {-0.2, 1.1, 0.4}, .axis = GoalAxis{}};
  for (const auto& [posed, preset] :
       {std::pair{full_body(), Preset::human}, std::pair{human_body(), Preset::layers}}) {
    const auto refused = generate(with_preset(Task(posed, {.goals = {goal}}), preset));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  }
}

TEST(LayeredHuman, GoalsHighLowAcrossAndOfBothHandsAreMet) {
  const std::vector<std::vector<Goal>> tasks{
      {{"right_hand", {-0.2, 1.75, 0.3}}},
      {{"right_hand", {-0.25, 1.0, 0.45}}},
      {{"right_hand", {-0.25, 0.35, 0.45}}},
      {{"left_hand", {-0.25, 1.1, 0.4}}},
      {{"right_hand", {-0.2, 0.9, 0.4}}, {"left_hand", {0.2, 1.1, 0.4}}}};
  for (const std::vector<Goal>& goals : tasks) {
    Task task = with_preset(Task(human_body(), {.goals = goals}), Preset::human);
    task.evaluations = 120;
    const GenerateResult generation = generate(task).value();
    EXPECT_TRUE(generation.meets_goals());
    ASSERT_FALSE(generation.candidates.empty());
    for (const Candidate& candidate : generation.candidates) {
      for (const GoalResult& goal : candidate.goals) EXPECT_LE(goal.error, kReachTolerance);
      for (const auto& contact : candidate.contacts) EXPECT_LE(contact.max_slide, 1e-6);
      EXPECT_TRUE(candidate.measures.over_limit.empty());
    }
  }
}

}  // namespace
}  // namespace shigusa
