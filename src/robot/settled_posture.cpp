// SPDX-License-Identifier: MIT
#include "robot/settled_posture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "body/posture_modes.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "kinematics/weighted_ik.hpp"
#include "math/turn_about.hpp"

namespace shigusa {
namespace {

constexpr int kSteps = 200;
constexpr double kRate = 0.15;   // of the way left, in a step
constexpr double kFlat = 1e-7;   // m: tolerance of a foot's position
constexpr double kAside = 0.15;  // of an arm that hangs, how far its hand is aside
// Lateral distance of a hand, as a share of its drop, beyond which the arm sticks out.
constexpr double kHanging = 0.35;
// Threshold for a raised arm, with an upper arm more than 45° from hanging.
constexpr double kRaised = 0.7;
constexpr double kAlmostStraight = 0.97;
// Threshold for an elbow that bends forwards: its axis is within 45° of the lateral one.
constexpr double kAhead = 0.7;

class Settler {
 public:
  explicit Settler(const BodyModel& body)
      : body_(body), kinematics_(body), workspace_(body), weights_(body.dofs().size(), 1.0) {
    const std::vector<double> zero(body.dofs().size(), 0.0);
    forward_kinematics<double>(body, zero, kinematics_);
    for (const Foot& foot : body.feet()) {
      if (foot.link == kBaseLink) continue;
      feet_.push_back({.link = foot.link,
                       .point = foot.centre,
                       .place = kinematics_.point(foot.link, foot.centre),
                       .exact = true,
                       .turning = Turning::whole,
                       .orientation = kinematics_.link_rotation(foot.link)});
    }
  }

  // Plants the feet at their positions for these angles, level and at their former height; false if
  // one is too far off.
  bool plant(const std::vector<double>& angles) {
    constexpr double kStep = 0.05;             // m, up or down
    constexpr double kTilted = radians(15.0);  // from level
    forward_kinematics<double>(body_, angles, kinematics_);
    for (Constraint<double>& foot : feet_) {
      const Vec3d at = kinematics_.point(foot.link, foot.point);
      const Mat3d& level = foot.orientation;
      const Mat3d& now = kinematics_.link_rotation(foot.link);
      // upward direction in the frame of a standing foot
      const Vec3d up = now * transpose_times(level, Vec3d{0, 1, 0});
      if (abs(at.y - foot.place.y) > kStep || up.y < sin_cos(kTilted).cos) return false;
      foot.place = {at.x, foot.place.y, at.z};
      const Vec3d turned = now * transpose_times(level, Vec3d{0, 0, 1});
      const double yaw = atan2(turned.x, turned.z);
      foot.orientation = turn_about({0, 1, 0}, yaw) * level;
    }
    return true;
  }

  // Moves from the angles towards the aim with the feet in place; false if the feet or the limits
  // prevent it.
  bool walk(std::vector<double>& angles, const std::vector<double>& aim,
            const std::vector<Constraint<double>>& arms = {}) {
    std::vector<double> now = angles;
    std::vector<Constraint<double>> targets = arms;
    if (arms.empty()) targets = feet_;
    for (std::size_t d = 0; d < weights_.size(); ++d) {
      weights_[d] = arms.empty() || moves_arm(static_cast<int>(d)) ? 1.0 : 0.0;
    }
    std::vector<double> pull(now.size());
    for (int k = 0; k < kSteps; ++k) {
      for (std::size_t d = 0; d < now.size(); ++d) pull[d] = kRate * (aim[d] - now[d]);
      forward_kinematics<double>(body_, now, kinematics_);
      advance(targets, pull, now);
    }
    for (int k = 0; k < kSteps && !stands(now); ++k) advance(feet_, {}, now);
    if (!stands(now)) return false;
    angles = now;
    return true;
  }

  // Targets of the hands at the sides, for arms that do not hang yet: those that stick out keep
  // their elbow angles, raised ones stretch them.
  [[nodiscard]] std::vector<Constraint<double>> hanging(const std::vector<double>& angles) {
    forward_kinematics<double>(body_, angles, kinematics_);
    std::vector<Constraint<double>> targets;
    for (const Effector& effector : body_.effectors()) {
      const Vec3d shoulder = kinematics_.origin[index(effector.limb_root)];
      const Vec3d hand = kinematics_.point(effector.link, effector.point);
      const Vec3d reach = hand - shoulder;
      const int elbow = elbow_of(effector);
      const Vec3d upper = kinematics_.origin[index(elbow)] - shoulder;
      const bool raised = -upper.y < kRaised * norm(upper);
      const double aside = abs(reach.x);
      const bool sticks_out = aside > kHanging * abs(reach.y) && aside > abs(reach.z);
      if (!raised && !sticks_out) continue;
      const double out = shoulder.x < 0.0 ? -kAside : kAside;
      Constraint<double> target;
      target.link = effector.link;
      target.point = effector.point;
      target.place = shoulder + normalized(Vec3d{out, -1.0, 0.1}) * norm(reach);
      if (raised && !sticks_out) {
        const double stretched = norm(upper) + norm(hand - kinematics_.origin[index(elbow)]);
        target.place = shoulder + normalized(Vec3d{out, -1.0, 0.1}) * (kAlmostStraight * stretched);
        elbows_.push_back(body_.dof(elbow).joint);
      }
      targets.push_back(target);
    }
    return targets;
  }

  // Turns straight hanging arms so that their elbows bend forwards, and bends them slightly: an
  // elbow that bends sideways lifts no hand past its shoulder. Other arms are kept.
  void bend_ahead(std::vector<double>& angles) {
    forward_kinematics<double>(body_, angles, kinematics_);
    for (const Effector& effector : body_.effectors()) {
      const int elbow = flexion_of(effector);
      if (elbow == kBaseLink || angles[index(elbow)] >= kStandingElbow) continue;
      const Vec3d way =
          kinematics_.origin[index(elbow)] - kinematics_.origin[index(effector.limb_root)];
      const Vec3d along = normalized(way);
      const Vec3d& axis = kinematics_.axis[index(elbow)];
      if (along.y > -kRaised || -axis.x > kAhead) continue;
      const int turn = turn_of(elbow, along);
      if (turn == kBaseLink) continue;
      const Vec3d across = level(Vec3d{-1.0, 0.0, 0.0}, along);
      const Vec3d now = level(axis, along);
      const double angle = atan2(dot(along, cross(now, across)), dot(now, across));
      const bool with = dot(kinematics_.axis[index(turn)], along) > 0.0;
      turn_to(turn, angles[index(turn)] + (with ? angle : -angle), angles);
      turn_to(elbow, kStandingElbow, angles);
    }
  }

  // Whether the feet are where they were planted.
  [[nodiscard]] bool stands(const std::vector<double>& angles) {
    forward_kinematics<double>(body_, angles, kinematics_);
    return std::all_of(feet_.begin(), feet_.end(), [&](const Constraint<double>& foot) {
      return norm(position_error(kinematics_, foot)) < kFlat && tilt(kinematics_, foot) < kFlat;
    });
  }

 private:
  // Component of v perpendicular to a direction.
  static Vec3d level(const Vec3d& v, const Vec3d& along) { return v - along * dot(v, along); }

  void turn_to(int dof, double angle, std::vector<double>& angles) const {
    angles[index(dof)] = clamp(angle, body_.dof(dof).lower, body_.dof(dof).upper);
  }

  // Degree of freedom by which an arm's elbow bends, or kBaseLink.
  [[nodiscard]] int flexion_of(const Effector& effector) const {
    for (int d = effector.link; d != effector.limb_root && d != kBaseLink;
         d = body_.dof(d).parent) {
      if (body_.dof(d).name.ends_with("elbow.flexion")) return d;
    }
    return kBaseLink;
  }

  // Degree of freedom before the elbow that rotates the upper arm about its axis, or kBaseLink.
  [[nodiscard]] int turn_of(int elbow, const Vec3d& along) const {
    constexpr double kAlong = 0.9;
    for (int d = body_.dof(elbow).parent; d != kBaseLink; d = body_.dof(d).parent) {
      const bool arm =
          body_.dof(d).joint.ends_with("shoulder") || body_.dof(d).joint.ends_with("elbow");
      if (!arm) return kBaseLink;
      if (abs(dot(kinematics_.axis[index(d)], along)) > kAlong) return d;
    }
    return kBaseLink;
  }

  void advance(const std::vector<Constraint<double>>& targets, std::span<const double> pull,
               std::vector<double>& angles) {
    if (targets.empty()) {
      for (std::size_t d = 0; d < pull.size(); ++d) angles[d] += pull[d];
    } else {
      const auto step = weighted_ik_step<double>(body_, kinematics_, {targets, weights_, pull},
                                                 IkSettings{}, workspace_);
      for (std::size_t d = 0; d < step.size(); ++d) angles[d] += step[d];
    }
    for (std::size_t d = 0; d < angles.size(); ++d) {
      angles[d] = clamp(angles[d], body_.dofs()[d].lower, body_.dofs()[d].upper);
    }
    forward_kinematics<double>(body_, angles, kinematics_);
  }

  // First degree of freedom of an arm's elbow; its shoulder's if it has none.
  [[nodiscard]] int elbow_of(const Effector& effector) const {
    int elbow = effector.limb_root;
    for (int d = effector.link; d != effector.limb_root && d != kBaseLink;
         d = body_.dof(d).parent) {
      if (body_.dof(d).joint.ends_with("elbow")) elbow = d;
    }
    return elbow;
  }

  // Whether a degree of freedom takes part in lowering an arm: shoulders, and elbows of raised
  // arms.
  [[nodiscard]] bool moves_arm(int dof) const {
    if (std::find(elbows_.begin(), elbows_.end(), body_.dof(dof).joint) != elbows_.end()) {
      return true;
    }
    const auto effectors = body_.effectors();
    return std::any_of(effectors.begin(), effectors.end(), [&](const Effector& effector) {
      return body_.dof(dof).joint == body_.dof(effector.limb_root).joint;
    });
  }

  const BodyModel& body_;
  Kinematics<double> kinematics_;
  IkWorkspace<double> workspace_;
  std::vector<double> weights_;  // (dofs) inverse ones: 0 where locked
  std::vector<Constraint<double>> feet_;
  std::vector<std::string> elbows_;  // joints that stretch
};

// Largest difference (rad) of two postures.
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) most = max(most, abs(a[d] - b[d]));
  return most;
}

// Whether every angle of the aim is within its limits.
bool allowed(const BodyModel& body, const std::vector<double>& aim) {
  for (std::size_t d = 0; d < aim.size(); ++d) {
    if (aim[d] < body.dofs()[d].lower || aim[d] > body.dofs()[d].upper) return false;
  }
  return true;
}

}  // namespace

Result<void> settle_at_keyframe(PosedBody& robot, const Robot& file, const std::string& keyframe) {
  constexpr double kNoted = radians(1.0);
  const BodyModel& body = robot.body;
  std::vector<double> aim = robot.home.angles;
  for (const RobotJoint& joint : robot.robot.value().joints) {
    const auto same = [&](const Robot::Joint& each) { return each.name == joint.name; };
    const auto found = std::find_if(file.joints.begin(), file.joints.end(), same);
    if (joint.dof < 0 || found == file.joints.end()) continue;
    aim[index(joint.dof)] = joint.sign * found->rest;
  }
  std::vector<double> angles = aim;
  for (std::size_t d = 0; d < angles.size(); ++d) {
    angles[d] = clamp(angles[d], body.dofs()[d].lower, body.dofs()[d].upper);
  }
  Settler settler(body);
  if (!settler.plant(angles)) {
    return fail(ErrorCode::unsupported, say("keyframe_feet", shown(keyframe)));
  }
  if (!settler.stands(angles) && !settler.walk(angles, std::vector<double>(angles))) {
    return fail(ErrorCode::unsupported, say("keyframe_feet", shown(keyframe)));
  }
  if (apart(angles, aim) > kNoted) robot.doubts.push_back(say("keyframe_near", shown(keyframe)));
  robot.home.angles = std::move(angles);
  return {};
}

void settle(PosedBody& robot) {
  const BodyModel& body = robot.body;
  Settler settler(body);
  const std::vector<double> zero = robot.home.angles;
  std::vector<double>& angles = robot.home.angles;
  if (!settler.walk(angles, zero)) {
    robot.doubts.push_back(say("feet_not_flat"));
  }
  for (const PostureMode& mode : posture_modes(body)) {
    if (mode.name != "squat") continue;
    std::vector<double> bent = angles;
    for (std::size_t d = 0; d < bent.size(); ++d) bent[d] += kStandingKnee * mode.direction[d];
    if (!allowed(body, bent) || !settler.walk(angles, bent)) {
      robot.doubts.push_back(say("straight_knees"));
    }
  }
  const std::vector<Constraint<double>> arms = settler.hanging(angles);
  if (!arms.empty()) (void)settler.walk(angles, angles, arms);
  settler.bend_ahead(angles);
}

}  // namespace shigusa
