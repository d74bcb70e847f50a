// SPDX-License-Identifier: MIT
#include "rise.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "criteria/posture_points.hpp"
#include "kinematics/weighted_ik.hpp"
#include "math/turn_about.hpp"
#include "rollout/posture_law.hpp"

namespace shigusa {
namespace {

// Length of a standing leg, relative to a straight one: knees bent by some 11 degrees.
constexpr double kAlmostStraight = 0.995;
// Length of a leg from which an upright person stands, as characters from files whose rest pose has
// the knees bent by up to 42 degrees.
constexpr double kStandsOn = 0.93;
// Steps on the way up, and iterations of each.
constexpr int kSteps = 40;
constexpr int kIterations = 4;
constexpr int kLast = 60;  // iterations of the last step
// Distance (m) and turn (rad) left at the end: it is where motions are drawn to.
constexpr double kThere = 0.02;
constexpr double kLevel = 0.15;

// Horizontal direction in which the standing feet face together; unit vector.
Vec3d heading(const BodyModel& body, const Kinematics<double>& start) {
  Vec3d sum{};
  for (const Foot& foot : body.feet()) {
    const Vec3d& ahead = start.link_rotation(foot.link).cz;
    sum += normalized(Vec3d{ahead.x, 0.0, ahead.z}, {0, 0, 1});
  }
  return normalized(Vec3d{sum.x, 0.0, sum.z}, {0, 0, 1});
}

class Riser {
 public:
  Riser(const BodyModel& body, const State& start, int pelvis)
      : body_(body),
        pelvis_(pelvis),
        angles_(start.angles),
        placed_(placed(body, start)),
        workspace_(body),
        weights_(body.dofs().size()) {
    for (const Foot& foot : body.feet()) {
      if (foot.link == kBaseLink) continue;
      held_.push_back({.link = foot.link,
                       .point = foot.centre,
                       .place = placed_.point(foot.link, foot.centre),
                       .exact = true,
                       .turning = Turning::whole,
                       .orientation = placed_.link_rotation(foot.link)});
    }
    for (std::size_t d = 0; d < weights_.size(); ++d) {
      const Dof& dof = body.dofs()[d];
      weights_[d] = dof.part.limb == LimbKind::leg ? 1.0 : 0.0;
    }
  }

  // Moves the pelvis there, in steps; false if it does not arrive.
  bool go(const Vec3d& point, const Vec3d& place, const Mat3d& orientation) {
    Constraint<double> pelvis{
        .link = pelvis_, .point = point, .exact = true, .turning = Turning::whole};
    const Vec3d from = placed_.point(pelvis_, point);
    const Mat3d turned = placed_.link_rotation(pelvis_);
    const Quatd turn = to_quat(orientation * transpose(turned));
    const double sine = sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    const double angle = 2.0 * atan2(sine, turn.w);
    const Vec3d axis = normalized(Vec3d{turn.x, turn.y, turn.z}, {0, 1, 0});
    held_.insert(held_.begin(), pelvis);
    for (int k = 1; k <= kSteps; ++k) {
      const double share = static_cast<double>(k) / kSteps;
      held_[0].place = from + (place - from) * share;
      held_[0].orientation = turn_about(axis, angle * share) * turned;
      for (int i = 0; i < (k == kSteps ? kLast : kIterations); ++i) step();
    }
    return std::all_of(held_.begin(), held_.end(), [this](const Constraint<double>& held) {
      return norm(position_error(placed_, held)) < kThere && tilt(placed_, held) < kLevel;
    });
  }

  [[nodiscard]] const std::vector<double>& angles() const { return angles_; }

 private:
  void step() {
    const auto change =
        weighted_ik_step<double>(body_, placed_, {held_, weights_}, IkSettings{}, workspace_);
    for (std::size_t d = 0; d < angles_.size(); ++d) {
      const Dof& dof = body_.dofs()[d];
      const double lower = min(dof.lower, angles_[d]);
      const double upper = max(upper_limit(body_, static_cast<int>(d), angles_), angles_[d]);
      angles_[d] = clamp(angles_[d] + change[d], lower, upper);
    }
    forward_kinematics<double>(body_, angles_, placed_);
  }

  const BodyModel& body_;
  int pelvis_;
  std::vector<double> angles_;
  Kinematics<double> placed_;
  IkWorkspace<double> workspace_;
  std::vector<double> weights_;  // (dofs) inverse ones: legs alone move
  std::vector<Constraint<double>> held_;
};

// Whether the body stands in the posture already.
bool stands(const BodyModel& body, const State& start, const PosturePoints& points,
            std::span<const int> knees) {
  double bent = 0.0;
  for (const int knee : knees) bent += start.angles[index(knee)];
  const Kinematics<double> now = placed(body, start);
  const Vec3d line = points.trunk(now);
  const double lean = atan2(sqrt(line.x * line.x + line.z * line.z), line.y);
  if (lean > kStandsLean) return false;
  const Vec3d leg = PosturePoints::middle(points.hips, now) - points.ankles;
  return bent <= kStandsKnees * static_cast<double>(knees.size()) ||
         norm(leg) >= kStandsOn * points.leg;
}

}  // namespace

std::vector<double> rise_of(const BodyModel& body, const CriteriaContext& context) {
  const State& start = context.start;
  const PosturePoints points = posture_points(body, start);
  const std::vector<int> knees = body.dofs_of(JointKind::knee, FreedomKind::flexion);
  if (!points.found || knees.empty() || body.feet().empty()) return {};
  const BodyNode* hips = body.find_node(humanoid_bone_name(HumanoidBone::hips));
  if (hips == nullptr || hips->link == kBaseLink || stands(body, start, points, knees)) return {};
  const Kinematics<double> now = placed(body, start);
  const Vec3d ahead = heading(body, now);
  const Vec3d up{0, 1, 0};
  const Vec3d over = points.ankles + ahead * (kStandsAhead * body.stature());
  const Mat3d& pelvis = now.link_rotation(hips->link);
  const Vec3d middle = transpose_times(
      pelvis, PosturePoints::middle(points.hips, now) - now.link_origin(hips->link));
  const Vec3d place = over + up * (kAlmostStraight * points.leg);
  const Mat3d facing{cross(up, ahead), up, ahead};
  // a file's pelvis may be turned with its trunk, farther than the legs follow: then the hips face
  // ahead, and the trunk keeps its turn
  const Vec3d beside = transpose_times(pelvis, points.hips[0].in(now)-points.hips[1].in(now));
  const Vec3d left = normalized(Vec3d{beside.x, 0.0, beside.z}, {1, 0, 0});
  const Mat3d by_hips = facing * transpose(Mat3d{left, up, cross(left, up)});
  std::vector<double> change;
  for (const Mat3d& orientation : {facing, by_hips}) {
    Riser riser(body, start, hips->link);
    if (change.empty() && riser.go(middle, place, orientation)) change = riser.angles();
  }
  if (change.empty()) return {};
  for (std::size_t d = 0; d < change.size(); ++d) change[d] -= start.angles[d];
  // the law of the back bends it with the pelvis; what it is bent beside that goes
  const double bent = back_bend(body, context) * bend_of_back(pelvis);
  for (std::size_t j = 0; j < kBackJoints.size(); ++j) {
    for (const FreedomKind freedom :
         {FreedomKind::flexion, FreedomKind::rotation, FreedomKind::lateral}) {
      const auto dof = body.find_dof(kBackJoints[j], freedom);
      if (!dof) continue;
      const double at = start.angles[index(*dof)];
      const double law =
          freedom == FreedomKind::flexion ? back_share(j, back_joints(body)) * bent : 0.0;
      change[index(*dof)] = -max(at - law, min(at, 0.0));
    }
  }
  // arms hang there, as in standing
  for (const Effector& hand : body.effectors()) {
    if (hand.part.limb != LimbKind::arm) continue;
    for (const int d : body.chain(hand.link)) {
      if (d < hand.limb_root) continue;
      const bool bends = body.dof(d).part.is(JointKind::elbow, FreedomKind::flexion);
      change[index(d)] = (bends ? kElbowHangs : 0.0) - start.angles[index(d)];
    }
  }
  return change;
}

}  // namespace shigusa
