// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "body/anthropometry.hpp"
#include "body/load.hpp"
#include "body/posture_modes.hpp"
#include "body/seat.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "motion/minimum_jerk.hpp"
#include "rollout/arm_clearance.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Share of the duration by which the head has turned to the goal: gaze arrives before the hand
// (Prablanc et al., Biological Cybernetics 35 (1979) 113-124).
inline constexpr double kGazeArrives = 0.45;
// The head's share of a gaze turn to the side (B. Biguer, M. Jeannerod and C. Prablanc, Exp. Brain
// Res. 46 (1982) 301: at most two thirds), and the range of the eyes, which do the rest (rad; of
// the 35 degrees of MIL-STD-1472).
inline constexpr double kHeadOfGaze = 0.65;
inline constexpr double kEyesEase = radians(30);
// The trunk's turn (rad) for a goal to the side: the share kTrunkOfGaze of the azimuth beyond
// kTrunkTurns, at most kTrunkMost, for a person whose feet stay planted. Chosen so that goals
// behind are in sight (docs/people.md, Gaze); no published figure was found. It ends with the hand.
inline constexpr double kTrunkTurns = radians(50);
inline constexpr double kTrunkOfGaze = 0.6;
inline constexpr double kTrunkMost = radians(65);
// Azimuths beyond which the legs follow the pelvis, partly from kLegsFollow, wholly from kLegsAll
// on: nearer goals are in sight without.
inline constexpr double kLegsFollow = radians(130);
inline constexpr double kLegsAll = radians(150);
inline constexpr double kTrunkBegins = 0.05;
inline constexpr double kTrunkArrives = 0.8;
// Fraction of the remaining turn made per frame.
inline constexpr double kTrunkShare = 0.3;
// Azimuth beyond which the trunk turns to the side of the reaching hand even for a goal on the
// other side.
inline constexpr double kBehind = radians(150);
// Share of its shoulder's turn that a free arm compensates in order to keep hanging.
inline constexpr double kArmHangs = 0.8;
// Least flexion of a hanging elbow (rad).
inline constexpr double kElbowHangs = radians(10);
// The clavicle's elevation, which stands for the shoulder blade's upward rotation, with the arm
// raised by an angle e from hanging: c (kScapulaFirst + c kScapulaMore), c = (1 - cos e) / 2. Of
// each part of e it is 5 % at 0 to 30 degrees, 19 and 38 % at 30 to 60 and to 90 and 53 % at 90 to
// 120, where people's is 2.5, 21 to 38 and 53 % (J. Scibek and C. Carcia, World J. Orthopedics 3
// (2012) 87), and on the whole 1 to 2.3 of the shoulder's own joint.
inline constexpr double kScapulaFirst = radians(20);
inline constexpr double kScapulaMore = radians(35);
// Factor on the elevation of an arm that is lowered, for a ratio of 1 to 2.7 (J. Braman et al., J.
// Shoulder and Elbow Surgery 18 (2009) 960).
inline constexpr double kScapulaLowers = (1.0 + 2.3) / (1.0 + 2.7);
// The clavicle's protraction with the arm straight ahead: a part of the shoulder blade's rotation
// (V. Inman, J. Saunders and L. Abbott, J. Bone and Joint Surgery 26 (1944) 1-30).
inline constexpr double kClavicleAhead = radians(14);

// Fraction of the remaining error of clavicles and free arms corrected per frame, and its cap
// (rad); the cap guards the singularity of the azimuth.
inline constexpr double kLawShare = 0.4;
inline constexpr double kLawStep = radians(4);
// Parameters of the back's bend (rad) for a pelvis tipped forwards by an angle t, kBackBend · t /
// (t + kBackHalf): 1.9, 0.9 and 0.4 times the hips' share in the first, second and third part of a
// bend of 111 degrees (Esola et al., Spine 21 (1996) 71).
inline constexpr double kBackBend = radians(75);
inline constexpr double kBackHalf = radians(18);
// Relative increase of the back's bend per kilogram of load in the hand, up to kBackLoadMost
// (Vazirian, Van Dillen and Bazrgari, 2016: larger with load).
inline constexpr double kBackOfLoad = 0.01;
inline constexpr double kBackLoadMost = 20.0;  // kg

// The relative bend of the back for a pelvis tipped forwards by an angle, and for its rotation.
template <class S>
[[nodiscard]] S bend_of_back(const S& tip) {
  return tip / (tip + S(kBackHalf));
}
template <class S>
[[nodiscard]] S bend_of_back(const Mat3<S>& pelvis) {
  return bend_of_back<S>(max(atan2(-pelvis.cz.y, pelvis.cy.y), S(0)));
}
// The bend (rad) of a body's back to which that is relative, with the start's loads and the
// person's habit.
[[nodiscard]] double back_bend(const BodyModel& body, const CriteriaContext& context);
// Share of that in one of the back's joints.
[[nodiscard]] double back_share(std::size_t joint, std::size_t joints);

// Clavicle angles (rad) of an arm that points along a unit vector in the frame of the chest,
// relative to a hanging arm's.
template <class S>
struct Shrug {
  S elevation;
  S protraction;
};
template <class S>
[[nodiscard]] Shrug<S> shrugged(const Vec3<S>& along) {
  const S raised = (S(1) + along.y) * S(0.5);
  return {raised * (S(kScapulaFirst) + raised * S(kScapulaMore)), along.z * S(kClavicleAhead)};
}

// Flexion and abduction (rad) of a shoulder whose arm hangs, from the rotation of its parent link;
// side: +1 left, -1 right.
template <class S>
struct Hanging {
  S flexion;
  S abduction;
};
template <class S>
[[nodiscard]] Hanging<S> hanging(const Mat3<S>& parent, const S& side) {
  const Vec3<S> down{-parent.cx.y, -parent.cy.y, -parent.cz.y};
  const S level = sqrt(down.y * down.y + down.z * down.z);
  return {atan2(down.z, -down.y) * S(kArmHangs), atan2(down.x, level) * side * S(kArmHangs)};
}

// Angles (rad) that the law would set for an arm in the start posture, from the links that carry
// its shoulder and its clavicle, and the upper arm's.
struct ArmAtStart {
  double flexion = 0.0;
  double abduction = 0.0;
  double elevation = 0.0;
  double protraction = 0.0;
};
struct ArmLinks {
  int parent = 0;
  int chest = 0;
  int upper = 0;
};
[[nodiscard]] ArmAtStart arm_at_start(const ReachProblem& problem, const ArmLinks& links,
                                      double side);
// Rotation R_WL of a link at the start.
[[nodiscard]] Mat3d rotation_at_start(const ReachProblem& problem, int link);

// Whether the law applies to a body: to one with a neck.
[[nodiscard]] inline bool nods(const BodyModel& body) {
  return body.find_dof(JointKind::neck, FreedomKind::flexion).has_value();
}

// Share of a gaze turn made by the head: a head broader than the shoulders would come down on the
// reaching arms.
[[nodiscard]] double head_share(const ReachProblem& problem);

// Share of Shrug::elevation applied to an arm's clavicle: kScapulaLowers if the hand ends lower
// than it starts, seen from the shoulder in the frame of the chest; else 1.
[[nodiscard]] double scapula_share(const ReachProblem& problem, const ArmLinks& links);

// The trunk's turn at the end of a motion, relative to the start posture.
struct TrunkTurn {
  double side = 0.0;           // +1 to the left, -1 to the right
  std::vector<double> change;  // (dofs) rad; empty: the gaze target is in front, above or below
};
[[nodiscard]] TrunkTurn trunk_turn(const ReachProblem& problem);

// Motion of the dofs of a whole human that no goal determines, frame by frame: the head turns to
// the goal, a free arm hangs and bends, clavicles go with their arms, the back bends with the
// pelvis. The law only sets the null-space reference; goals, contacts and limits take precedence.
// For bodies with a neck only.
template <class S>
class PostureLaw {
 public:
  explicit PostureLaw(const ReachProblem& problem)
      : steps_(problem.steps),
        ease_(problem.ease),
        gaze_arrives_(kGazeArrives - problem.gaze_lead),
        eyes_(static_cast<T>(problem.context.habit.eyes)),
        elbow_bends_(static_cast<T>(problem.context.habit.free_arm)) {
    const BodyModel& body = *problem.body;
    if (!problem.posture_law || !nods(body)) return;
    find_head(problem);
    find_back(problem);
    find_trunk(problem);
    for (const Side side : {Side::left, Side::right}) find_arm(problem, side);
  }

  [[nodiscard]] bool empty() const { return !looks_ && arms_.empty() && back_.empty(); }

  // Sets the reference (dofs, rad) of the step to `frame`, from the placement and the angles (dofs,
  // rad) before it. `guided`: the rest of the body is drawn to a posture; the back and arms with
  // goals are left to it. Otherwise the reference holds the back's bend in addition to the law (see
  // bends_back()).
  void draw(int frame, const Kinematics<S>& now, std::span<const S> angles, bool guided,
            std::span<S> reference) {
    if (!guided) bend_back(now, angles, reference);
    if (!guided) turn_trunk(frame, angles, reference);
    if (looks_) look(gaze_share(frame), now, angles, reference);
    for (Arm& arm : arms_) {
      if (arm.free) hang(arm, now, angles, reference);
      if (arm.has_clavicle && (arm.free || !guided)) shrug(arm, now, angles, reference);
    }
  }

  // Whether the law bends the back by this dof.
  [[nodiscard]] bool bends_back(std::size_t dof) const {
    return std::any_of(back_.begin(), back_.end(),
                       [dof](const Freedom& f) { return f.dof == dof; });
  }

 private:
  using T = Element<S>;
  struct Freedom {
    std::size_t dof = 0;
    T lower{};  // rad
    T upper{};
    T start{};  // rad, offset at which the law leaves the start posture unchanged
    T share{};  // of the angle wanted of all joints together
  };
  struct Arm {
    bool free = false;
    bool has_clavicle = false;
    T side{};        // +1 left, -1 right
    int parent = 0;  // link that carries the shoulder
    int chest = 0;   // link that carries the clavicle
    int upper = 0;   // the upper arm's link
    bool has_elbow = false;
    T lean{};    // rad: flexion of the law in the start posture
    T rhythm{};  // factor on the clavicle's elevation, see scapula_share
    Freedom flexion, abduction, elevation, protraction, elbow;
    std::optional<ArmClearance<S>> clearance;
    std::optional<ArmClearance<S>> lift;  // by the elbow, off the thighs of a person who sits
  };

  static Freedom freedom(const ReachProblem& problem, int d, double share = 1.0) {
    const Dof& dof = problem.body->dof(d);
    const double start = problem.start().angles[index(d)];
    return {index(d), static_cast<T>(dof.lower), static_cast<T>(dof.upper), static_cast<T>(start),
            static_cast<T>(share)};
  }

  void find_head(const ReachProblem& problem) {
    const BodyModel& body = *problem.body;
    const auto neck = body.find_dof(JointKind::neck, FreedomKind::flexion);
    if (!problem.context.gaze || !neck) return;
    looks_ = true;
    target_ = to_scalar<S>(*problem.context.gaze);
    chest_ = body.dof(*neck).parent;
    const double each =
        (body.find_dof(JointKind::head, FreedomKind::flexion) ? 0.5 : 1.0) * head_share(problem);
    for (const JointKind joint : {JointKind::neck, JointKind::head}) {
      const auto nod = body.find_dof(joint, FreedomKind::flexion);
      const auto turn = body.find_dof(joint, FreedomKind::rotation);
      if (!nod || !turn) continue;
      head_ = *nod;
      nods_.push_back(freedom(problem, *nod, each));
      turns_.push_back(freedom(problem, *turn, each));
    }
  }

  void find_back(const ReachProblem& problem) {
    const BodyModel& body = *problem.body;
    // a local copy: the table itself would be shared between SIMD sets
    constexpr auto kJoints = kBackJoints;
    const std::size_t joints = back_joints(body);
    if (joints < 2) return;  // a waist goes its own way
    for (std::size_t j = 0; j < joints; ++j) {
      const auto bend = body.find_dof(kJoints[j], FreedomKind::flexion);
      back_.push_back(freedom(problem, *bend, back_share(j, joints)));
    }
    pelvis_ = body.dof(static_cast<int>(back_.front().dof)).parent;
    back_bend_ = static_cast<T>(back_bend(body, problem.context));
    // for a bent start posture, the law continues from there
    const double bent =
        bend_of_back(rotation_at_start(problem, pelvis_)) * static_cast<double>(back_bend_);
    for (Freedom& f : back_) {
      // a file's back is straight at the start, and does not bend backwards from there
      f.lower = f.start < T(0) ? f.start : T(0);
      f.start -= f.share * static_cast<T>(bent);
    }
  }

  void find_trunk(const ReachProblem& problem) {
    const TrunkTurn turn = trunk_turn(problem);
    side_ = static_cast<T>(turn.side);
    for (std::size_t d = 0; d < turn.change.size(); ++d) {
      if (turn.change[d] == 0.0) continue;
      trunk_.push_back(freedom(problem, static_cast<int>(d), turn.change[d]));
    }
  }

  void find_arm(const ReachProblem& problem, Side side) {
    const BodyModel& body = *problem.body;
    const auto dof = [&](JointKind joint, FreedomKind freedom) {
      return body.find_dof(joint, freedom, side);
    };
    const auto flexion = dof(JointKind::shoulder, FreedomKind::flexion);
    const auto abduction = dof(JointKind::shoulder, FreedomKind::abduction);
    const auto rotation = dof(JointKind::shoulder, FreedomKind::rotation);
    if (!flexion || !abduction || !rotation) return;
    Arm arm;
    arm.free = true;
    for (const ReachGoal& goal : problem.goals) {
      const int link = body.effector(goal.effector).link;
      arm.free = arm.free && !body.moves(*flexion, link);
    }
    arm.side = static_cast<T>(side == Side::left ? 1.0 : -1.0);
    arm.parent = body.dof(*flexion).parent;
    arm.upper = *rotation;
    arm.flexion = freedom(problem, *flexion);
    arm.abduction = freedom(problem, *abduction);
    if (const auto hand = body.find_effector(JointKind::hand, side); hand && arm.free) {
      arm.clearance.emplace(problem, body.effector(*hand), *abduction);
    }
    const auto elbow = dof(JointKind::elbow, FreedomKind::flexion);
    arm.has_elbow = elbow.has_value();
    if (elbow) {
      arm.elbow = freedom(problem, *elbow);
      arm.elbow.lower = static_cast<T>(min(static_cast<double>(arm.elbow.start), kElbowHangs));
      const auto hand = body.find_effector(JointKind::hand, side);
      if (hand && arm.free && sits(body)) arm.lift.emplace(problem, body.effector(*hand), *elbow);
    }
    const auto elevation = dof(JointKind::clavicle, FreedomKind::elevation);
    const auto protraction = dof(JointKind::clavicle, FreedomKind::protraction);
    arm.has_clavicle = elevation && protraction;
    if (arm.has_clavicle) {
      arm.chest = body.dof(*elevation).parent;
      arm.elevation = freedom(problem, *elevation);
      arm.protraction = freedom(problem, *protraction);
    }
    arm.rhythm = static_cast<T>(
        arm.has_clavicle ? scapula_share(problem, {arm.parent, arm.chest, arm.upper}) : 1.0);
    begin_at_start(problem, arm);
    arms_.push_back(std::move(arm));
  }

  // Offsets the law to the start posture, in which a character from a file may stoop or hold up an
  // arm: the law continues from there instead of pulling the arm to its own posture at once.
  static void begin_at_start(const ReachProblem& problem, Arm& arm) {
    const ArmAtStart start = arm_at_start(
        problem, {arm.parent, arm.has_clavicle ? arm.chest : arm.parent, arm.upper}, arm.side);
    arm.flexion.start -= static_cast<T>(start.flexion);
    arm.abduction.start -= static_cast<T>(start.abduction);
    arm.lean = static_cast<T>(start.flexion);
    if (!arm.has_clavicle) return;
    arm.elevation.start -= static_cast<T>(start.elevation) * arm.rhythm;
    arm.protraction.start -= static_cast<T>(start.protraction);
  }

  // Share of the remaining gaze turn made in a frame.
  [[nodiscard]] S gaze_share(int frame) const {
    const auto done = [this](int f) {
      return minimum_snap(static_cast<double>(f) / (gaze_arrives_ * steps_));
    };
    return S(share_of_rest(done(frame - 1), done(frame)));
  }

  // Draws a dof by a share of its distance from the wanted angle.
  static void draw_to(const Freedom& f, const S& wanted, const S& share, std::span<const S> angles,
                      std::span<S> reference) {
    const S held = clamp(S(f.start) + wanted * S(f.share), S(f.lower), S(f.upper));
    reference[f.dof] = clamp((held - angles[f.dof]) * share, S(-kLawStep), S(kLawStep));
  }

  void bend_back(const Kinematics<S>& now, std::span<const S> angles,
                 std::span<S> reference) const {
    if (back_.empty()) return;
    const S bend = bend_of_back(now.link_rotation(pelvis_)) * S(back_bend_);
    for (const Freedom& f : back_) {
      const S wanted = max(S(f.start) + bend * S(f.share), S(f.lower)) + reference[f.dof];
      reference[f.dof] = min(wanted, S(f.upper)) - angles[f.dof];
    }
  }

  // Draws the trunk at least as far as the law; other causes may turn it farther.
  void turn_trunk(int frame, std::span<const S> angles, std::span<S> reference) const {
    if (trunk_.empty()) return;
    const double tau = hastened(static_cast<double>(frame) / steps_, ease_);
    const S done(minimum_snap((tau - kTrunkBegins) / (kTrunkArrives - kTrunkBegins)));
    // a remaining error at the end stays: the motion ends at rest
    const S share(kTrunkShare *
                  (1.0 - minimum_snap((tau - kTrunkArrives) / (1.0 - kTrunkArrives))));
    for (const Freedom& f : trunk_) {
      const S wanted = clamp(S(f.start) + done * S(f.share), S(f.lower), S(f.upper));
      const S missing = wanted - angles[f.dof] - reference[f.dof];
      const S drawn = clamp(missing * share, S(-kLawStep), S(kLawStep));
      const S more = f.share > T(0) ? max(drawn, S(0)) : min(drawn, S(0));
      reference[f.dof] = reference[f.dof] + more;
    }
  }

  // Turn of the head (rad) to an offset in the frame of the chest: sideways for a target behind,
  // and continuous from side to side.
  static S side_of(const Vec3<S>& offset, const S& across) {
    return atan2(offset.x, max(offset.z, across * S(0.2)));
  }
  // The same for a trunk that turns, to the trunk's side all the way; the jump is 105 degrees to
  // the other side.
  [[nodiscard]] S side_behind(const Vec3<S>& offset) const {
    constexpr double kCos75 = 0.25881904510252;
    constexpr double kSin75 = 0.96592582628907;
    const S x = offset.x * S(side_);
    const S turn =
        atan2(x * S(kCos75) - offset.z * S(kSin75), offset.z * S(kCos75) + x * S(kSin75));
    return (turn + S(radians(75.0))) * S(side_);
  }

  // Direction (any length, world) of the head for a gaze: the eyes look farther up or down, by an
  // angle that grows with the gaze's and ends at that of the habit. `ahead`: that of the chest, for
  // gazes straight down.
  [[nodiscard]] Vec3<S> without_eyes(const Vec3<S>& gaze, const Vec3<S>& ahead) const {
    constexpr double kAhead = 0.05;
    const S little = norm(gaze) * S(kAhead);
    const Vec3<S> level{gaze.x + ahead.x * little, S(0), gaze.z + ahead.z * little};
    const S across = max(norm(level), S(1e-6));
    const S nod = atan2(-gaze.y, across);
    const S eyes = nod * S(eyes_) / sqrt(max(nod * nod + S(eyes_) * S(eyes_), S(1e-9)));
    const SinCos<S> tip = sin_cos(nod - eyes);
    const Vec3<S> along = level * (tip.cos / across);
    return {along.x, -tip.sin, along.z};
  }

  void look(const S& share, const Kinematics<S>& now, std::span<const S> angles,
            std::span<S> reference) const {
    const Vec3<S> eye = now.origin[index(head_)];
    const Mat3<S>& chest = now.link_rotation(chest_);
    const Vec3<S> offset = transpose_times(chest, without_eyes(target_ - eye, chest.cz + chest.cy));
    const S across = sqrt(offset.x * offset.x + offset.z * offset.z);
    const S turn = trunk_.empty() ? side_of(offset, across) : side_behind(offset);
    const S eyes = clamp(turn * S(1.0 - kHeadOfGaze), S(-kEyesEase), S(kEyesEase));
    const S nod = atan2(-offset.y, across);
    for (const Freedom& f : turns_) draw_to(f, turn - eyes, share, angles, reference);
    for (const Freedom& f : nods_) draw_to(f, nod, share, angles, reference);
  }

  void hang(Arm& arm, const Kinematics<S>& now, std::span<const S> angles,
            std::span<S> reference) const {
    const Hanging<S> wanted = hanging(now.link_rotation(arm.parent), S(arm.side));
    draw_to(arm.flexion, wanted.flexion, S(kLawShare), angles, reference);
    draw_to(arm.abduction, wanted.abduction, S(kLawShare), angles, reference);
    keep_off(arm.clearance, arm.abduction, now, angles, reference);
    if (!arm.has_elbow) return;
    const S lean = wanted.flexion - S(arm.lean);
    draw_to(arm.elbow, lean * S(elbow_bends_), S(kLawShare), angles, reference);
    keep_off(arm.lift, arm.elbow, now, angles, reference);
  }

  // Abducts the arm, or bends its elbow, to keep it clear of trunk and legs.
  static void keep_off(std::optional<ArmClearance<S>>& clearance, const Freedom& by,
                       const Kinematics<S>& now, std::span<const S> angles,
                       std::span<S> reference) {
    if (!clearance) return;
    const S off = min(clearance->aside(now), S(by.upper) - angles[by.dof]);
    reference[by.dof] = max(reference[by.dof], min(off * S(kLawShare), S(kLawStep)));
  }

  void shrug(const Arm& arm, const Kinematics<S>& now, std::span<const S> angles,
             std::span<S> reference) const {
    const Shrug<S> wanted =
        shrugged(transpose_times(now.link_rotation(arm.chest), -now.link_rotation(arm.upper).cy));
    draw_to(arm.elevation, wanted.elevation * S(arm.rhythm), S(kLawShare), angles, reference);
    draw_to(arm.protraction, wanted.protraction, S(kLawShare), angles, reference);
  }

  int steps_;            // in a motion
  double ease_;          // see ReachProblem
  double gaze_arrives_;  // share of the duration at which the head arrives
  T eyes_;               // rad, see Habit
  T elbow_bends_;        // see Habit::free_arm
  bool looks_ = false;
  Vec3<S> target_{};  // m, world
  int chest_ = 0;     // link that carries the neck
  int head_ = 0;      // dof whose centre is taken as the eyes
  std::vector<Freedom> nods_;
  std::vector<Freedom> turns_;
  std::vector<Freedom> back_;
  std::vector<Freedom> trunk_;  // share: rad, the turn at the end
  T side_{};                    // +1 for a turn to the left, -1 to the right
  int pelvis_ = 0;              // link that carries the back
  T back_bend_{};               // rad, see kBackBend
  std::vector<Arm> arms_;
};

}  // namespace shigusa
