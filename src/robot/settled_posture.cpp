// SPDX-License-Identifier: MIT
#include "robot/settled_posture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "body/posture_modes.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "kinematics/weighted_ik.hpp"

namespace shigusa {
namespace {

constexpr int kSteps = 200;
constexpr double kRate = 0.15;   // of the way left, in a step
constexpr double kFlat = 1e-7;   // m: a foot that is so near its place stands
constexpr double kAside = 0.15;  // of an arm that hangs, how far its hand is aside
// An arm sticks out where its hand is further aside, of its height …
constexpr double kHanging = 0.35;
// … and is raised where its upper arm is further than 45° from hanging.
constexpr double kRaised = 0.7;
constexpr double kAlmostStraight = 0.97;

class Settler {
 public:
  explicit Settler(const BodyModel& body)
      : body_(body), kinematics_(body), workspace_(body), weights_(body.dofs().size(), 1.0) {
    const std::vector<double> zero(body.dofs().size(), 0.0);
    forward_kinematics<double>(body, zero, kinematics_);
    for (const Foot& foot : body.feet()) {
      if (foot.link == kBaseLink) continue;
      IkTarget<double> target;
      target.link = foot.link;
      target.point = foot.centre;
      target.position = kinematics_.point(foot.link, foot.centre);
      target.contact = true;
      target.orientation = kinematics_.link_rotation(foot.link);
      feet_.push_back(target);
    }
  }

  // Walks from the angles towards the aim with the feet where they are; false where the feet or the
  // limits do not let it come there.
  bool walk(std::vector<double>& angles, const std::vector<double>& aim,
            const std::vector<IkTarget<double>>& arms = {}) {
    std::vector<double> now = angles;
    std::vector<IkTarget<double>> targets = arms;
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

  // The hands' targets to hang at the sides, of arms that do not yet: those that stick out keep
  // their elbows, those that are raised stretch them.
  [[nodiscard]] std::vector<IkTarget<double>> hanging(const std::vector<double>& angles) {
    forward_kinematics<double>(body_, angles, kinematics_);
    std::vector<IkTarget<double>> targets;
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
      IkTarget<double> target;
      target.link = effector.link;
      target.point = effector.point;
      target.position = shoulder + normalized(Vec3d{out, -1.0, 0.1}) * norm(reach);
      if (raised && !sticks_out) {
        const double stretched = norm(upper) + norm(hand - kinematics_.origin[index(elbow)]);
        target.position =
            shoulder + normalized(Vec3d{out, -1.0, 0.1}) * (kAlmostStraight * stretched);
        elbows_.push_back(body_.dof(elbow).joint);
      }
      targets.push_back(target);
    }
    return targets;
  }

 private:
  void advance(const std::vector<IkTarget<double>>& targets, std::span<const double> pull,
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

  // The first freedom of an arm's elbow; its shoulder's where it has none.
  [[nodiscard]] int elbow_of(const Effector& effector) const {
    int elbow = effector.limb_root;
    for (int d = effector.link; d != effector.limb_root && d != kBaseLink;
         d = body_.dof(d).parent) {
      if (body_.dof(d).joint.ends_with("elbow")) elbow = d;
    }
    return elbow;
  }

  // Shoulders hang an arm, and the elbows of those that were raised.
  [[nodiscard]] bool moves_arm(int dof) const {
    if (std::find(elbows_.begin(), elbows_.end(), body_.dof(dof).joint) != elbows_.end()) {
      return true;
    }
    const auto effectors = body_.effectors();
    return std::any_of(effectors.begin(), effectors.end(), [&](const Effector& effector) {
      return body_.dof(dof).joint == body_.dof(effector.limb_root).joint;
    });
  }

  [[nodiscard]] bool stands(const std::vector<double>& angles) {
    forward_kinematics<double>(body_, angles, kinematics_);
    return std::all_of(feet_.begin(), feet_.end(), [&](const IkTarget<double>& foot) {
      return norm(position_error(kinematics_, foot)) < kFlat && tilt(kinematics_, foot) < kFlat;
    });
  }

  const BodyModel& body_;
  Kinematics<double> kinematics_;
  IkWorkspace<double> workspace_;
  std::vector<double> weights_;  // (dofs) inverse ones: 0 where locked
  std::vector<IkTarget<double>> feet_;
  std::vector<std::string> elbows_;  // joints that stretch
};

// Whether every angle of the aim is within its limits.
bool allowed(const BodyModel& body, const std::vector<double>& aim) {
  for (std::size_t d = 0; d < aim.size(); ++d) {
    if (aim[d] < body.dofs()[d].lower || aim[d] > body.dofs()[d].upper) return false;
  }
  return true;
}

}  // namespace

std::vector<double> settled_posture(const BodyModel& body, std::vector<Message>& doubts) {
  Settler settler(body);
  const std::vector<double> zero(body.start().begin(), body.start().end());
  std::vector<double> angles = zero;
  if (!settler.walk(angles, zero)) {
    doubts.push_back(say("feet_not_flat"));
  }
  for (const PostureMode& mode : posture_modes(body)) {
    if (mode.name != "squat") continue;
    std::vector<double> bent = angles;
    for (std::size_t d = 0; d < bent.size(); ++d) bent[d] += kStandingKnee * mode.direction[d];
    if (!allowed(body, bent) || !settler.walk(angles, bent)) {
      doubts.push_back(say("straight_knees"));
    }
  }
  const std::vector<IkTarget<double>> arms = settler.hanging(angles);
  if (!arms.empty()) (void)settler.walk(angles, angles, arms);
  return angles;
}

}  // namespace shigusa
