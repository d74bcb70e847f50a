// SPDX-License-Identifier: MIT
#include "cost/angles.hpp"

#include "body/joint_name.hpp"
#include "body/seat.hpp"
#include "core/check.hpp"
#include "core/index.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "dynamics/contact_forces.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// Distance from the side, as the part of an upper arm in the sagittal plane, below which flexion
// fades.
constexpr double kBeside = 0.2588;  // sin 15°

// Flexion of an elbow below which it is bent the other way, beyond hyperextension.
constexpr double kBendsBack = radians(-10.0);

std::optional<LinkPoint> point_of(const BodyModel& body, Bone bone) {
  const BodyNode* node = body.find_node(humanoid_bone_name(bone));
  if (node == nullptr) return std::nullopt;
  return LinkPoint{node->link, node->point};
}

double angle_between(const Vec3d& a, const Vec3d& b) { return atan2(norm(cross(a, b)), dot(a, b)); }

// Axes with y along `up` and x as near to `left` as that permits.
Mat3d axes_of(const Vec3d& left, const Vec3d& up) {
  const Vec3d y = normalized(up);
  const Vec3d x = normalized(left - y * dot(left, y), {1, 0, 0});
  return {x, y, cross(x, y)};
}

double arc_sine(double x) { return asin(clamp(x, -1.0, 1.0)); }

// An angle between -2π and 2π, brought to -π to π.
double wrapped(double angle) {
  return angle > kPi ? angle - kTwoPi : angle < -kPi ? angle + kTwoPi : angle;
}

// An angle of several turns, brought to -π to π.
double wrapped_far(double angle) { return angle - kTwoPi * nearest_integer(angle / kTwoPi); }

}  // namespace

AngleMeter::AngleMeter(const BodyModel& body, const State& home)
    : body_(body), neutral_(home.angles), c7_(point_of(body, Bone::neck)) {
  const std::array sides{
      std::array{Bone::left_upper_arm, Bone::left_lower_arm, Bone::left_hand, Bone::left_upper_leg,
                 Bone::left_lower_leg, Bone::left_foot},
      std::array{Bone::right_upper_arm, Bone::right_lower_arm, Bone::right_hand,
                 Bone::right_upper_leg, Bone::right_lower_leg, Bone::right_foot}};
  for (std::size_t k = 0; k < 2; ++k) {
    std::array<std::optional<LinkPoint>, 6> at;
    for (std::size_t b = 0; b < at.size(); ++b) at[b] = point_of(body, sides[k][b]);
    const Side side = k == 0 ? Side::left : Side::right;
    if (at[0] && at[1] && at[2]) {
      arms_[k] = Arm{*at[0],
                     *at[1],
                     *at[2],
                     0.0,
                     body.find_dof(JointKind::wrist, FreedomKind::flexion, side),
                     body.find_dof(JointKind::wrist, FreedomKind::deviation, side),
                     body.find_dof(JointKind::elbow, FreedomKind::rotation, side),
                     body.find_dof(JointKind::elbow, FreedomKind::flexion, side)};
    }
    if (at[3] && at[4] && at[5]) legs_[k] = Leg{*at[3], *at[4], *at[5]};
  }
  if (const auto pelvis = point_of(body, Bone::hips)) pelvis_ = pelvis->link;
  const auto head = point_of(body, Bone::head);
  if (head && c7_ && head->link != c7_->link) head_ = head->link;
  if (!c7_ || !pelvis_) return;

  const auto lean_at = [&](std::span<const double> angles) {
    Kinematics<double> placed(body);
    forward_kinematics<double>(body, angles, placed);
    const Vec3d left =
        legs_[0] && legs_[1] ? legs_[0]->hip.in(placed)-legs_[1]->hip.in(placed) : Vec3d{1, 0, 0};
    const Mat3d person = axes_of({left.x, 0.0, left.z}, {0, 1, 0});
    pelvis_axes_ = transpose(placed.link_rotation(*pelvis_)) * person;
    chest_axes_ = transpose(placed.link_rotation(c7_->link)) * person;
    if (head_) head_axes_ = transpose(placed.link_rotation(*head_)) * person;
    for (auto& arm : arms_) {
      if (!arm) continue;
      const Vec3d up = arm->shoulder.in(placed)-c7_->in(placed);
      arm->height = up.y;
    }
    const Vec3d line = c7_->in(placed)-hips(placed);
    lean_ = atan2(dot(line, person.cz), line.y);
    return angle_between(line, {0, 1, 0});
  };
  if (lean_at(neutral_) > kHomeLeans && !sits(body)) {
    home_leans_ = true;
    neutral_.assign(body.dofs().size(), 0.0);
    lean_at(neutral_);
  }
}

Mat3d AngleMeter::turned(int link, const Mat3d& neutral, const Kinematics<double>& placed) const {
  return placed.link_rotation(link) * neutral;
}

Mat3d AngleMeter::person_axes(const Kinematics<double>& placed) const {
  const Vec3d left = turned(*pelvis_, pelvis_axes_, placed).cx;
  return axes_of({left.x, 0.0, left.z}, {0, 1, 0});
}

Vec3d AngleMeter::hips(const Kinematics<double>& placed) const {
  if (legs_[0] && legs_[1]) return 0.5 * (legs_[0]->hip.in(placed) + legs_[1]->hip.in(placed));
  const BodyNode* node = body_.find_node(humanoid_bone_name(Bone::hips));
  return placed.point(node->link, node->point);
}

std::optional<Vec3d> AngleMeter::ankles(const Kinematics<double>& placed) const {
  if (!legs_[0] || !legs_[1]) return std::nullopt;
  return 0.5 * (legs_[0]->ankle.in(placed) + legs_[1]->ankle.in(placed));
}

std::optional<Vec3d> AngleMeter::trunk_line(const Kinematics<double>& placed) const {
  if (!c7_ || !pelvis_) return std::nullopt;
  return normalized(c7_->in(placed)-hips(placed));
}

std::optional<Mat3d> AngleMeter::trunk_axes(const Kinematics<double>& placed) const {
  if (!c7_ || !pelvis_) return std::nullopt;
  const Mat3d line =
      axes_of(turned(c7_->link, chest_axes_, placed).cx, c7_->in(placed)-hips(placed));
  const SinCos<double> back = sin_cos(-lean_);
  return Mat3d{line.cx, line.cy * back.cos + line.cz * back.sin,
               line.cz * back.cos - line.cy * back.sin};
}

TrunkAngles AngleMeter::trunk(const Kinematics<double>& placed) const {
  const Mat3d person = person_axes(placed);
  const Vec3d line = normalized(c7_->in(placed)-hips(placed));
  const auto level = [&line](const Vec3d& v) { return v - line * dot(v, line); };
  const Vec3d below = level(turned(*pelvis_, pelvis_axes_, placed).cx);
  const Vec3d above = level(turned(c7_->link, chest_axes_, placed).cx);
  return {wrapped(atan2(dot(line, person.cz), dot(line, person.cy)) - lean_),
          arc_sine(dot(line, person.cx)), atan2(dot(cross(below, above), line), dot(below, above))};
}

void AngleMeter::set_hand(const Arm& arm, std::span<const double> angles, ArmAngles& out) const {
  const auto at = [&](const std::optional<int>& dof) {
    return dof ? wrapped_far(angles[index(*dof)]) : 0.0;
  };
  double flexion = at(arm.flexion);
  double deviation = at(arm.deviation);
  double rotation = at(arm.rotation);
  // fitted angles may be the other ones of the same posture, with the elbow or the hand bent the
  // other way
  if (at(arm.bend) < kBendsBack) rotation = wrapped(rotation + kPi);
  if (arm.flexion && arm.deviation && arm.rotation && abs(flexion) > 0.5 * kPi) {
    flexion = wrapped(kPi - flexion);
    deviation = wrapped(deviation + kPi);
    rotation = wrapped(rotation + kPi);
  }
  if (arm.flexion) out.wrist = wrapped(flexion - neutral_[index(*arm.flexion)]);
  if (arm.deviation) out.deviation = wrapped(deviation - neutral_[index(*arm.deviation)]);
  if (!arm.rotation) return;
  const Dof& dof = body_.dof(*arm.rotation);
  const double range = dof.upper - dof.lower;
  out.forearm = range > 0.0 ? clamp((rotation - dof.lower) / range, 0.0, 1.0) : 0.5;
}

ArmAngles AngleMeter::arm(const Arm& arm, double side, const Mat3d& trunk,
                          const Kinematics<double>& placed, std::span<const double> angles) const {
  const Vec3d shoulder = arm.shoulder.in(placed);
  const Vec3d elbow = arm.elbow.in(placed);
  const Vec3d wrist = arm.wrist.in(placed);
  const Vec3d world = normalized(elbow - shoulder, {0, -1, 0});
  const Vec3d upper = transpose_times(trunk, world);
  const double in_plane = sqrt(upper.y * upper.y + upper.z * upper.z);
  double flexion = atan2(upper.z, -upper.y);
  if (flexion < -0.5 * kPi) flexion += kTwoPi;  // past the head
  const Mat3d chest = turned(c7_->link, chest_axes_, placed);
  ArmAngles out;
  out.flexion = flexion * min(1.0, in_plane / kBeside);
  out.abduction = arc_sine(side * upper.x);
  out.elevation = angle_between(world, {0, -1, 0});
  out.raised = dot(chest.cy, shoulder - c7_->in(placed)) - arm.height;
  out.elbow = kPi - angle_between(shoulder - elbow, wrist - elbow);
  out.across = side * dot(trunk.cx, wrist - c7_->in(placed));
  out.outside = side * dot(trunk.cx, wrist - shoulder);
  set_hand(arm, angles, out);
  return out;
}

std::optional<double> AngleMeter::on_left(const Kinematics<double>& placed,
                                          std::span<const double> angles) const {
  std::array<std::optional<Vec3d>, 2> at;
  for (const Foot& foot : body_.feet()) {
    const std::optional<Side> side = parse_joint_name(foot.name).side;
    if (side) at[*side == Side::left ? 0 : 1] = bearing_centre<double>(foot, placed, angles);
  }
  if (!at[0] && !at[1]) return std::nullopt;
  if (!at[0] || !at[1]) return at[0] ? 1.0 : 0.0;
  const Vec3d line{at[0]->x - at[1]->x, 0.0, at[0]->z - at[1]->z};
  const Vec3d mass = centre_of_mass(body_, placed) - *at[1];
  const double square = dot(line, line);
  return square > 0.0 ? clamp(dot({mass.x, 0.0, mass.z}, line) / square, 0.0, 1.0) : 0.5;
}

PostureAngles AngleMeter::measure(const Kinematics<double>& placed,
                                  std::span<const double> angles) const {
  PostureAngles out;
  out.sits = sits(body_);
  out.on_left = on_left(placed, angles);
  for (std::size_t k = 0; k < 2; ++k) {
    if (!legs_[k]) continue;
    const Vec3d knee = legs_[k]->knee.in(placed);
    out.knees[k] =
        kPi - angle_between(legs_[k]->hip.in(placed)-knee, legs_[k]->ankle.in(placed)-knee);
  }
  const std::optional<Mat3d> axes = trunk_axes(placed);
  if (!axes) return out;
  out.trunk = trunk(placed);
  for (std::size_t k = 0; k < 2; ++k) {
    if (arms_[k]) out.arms[k] = arm(*arms_[k], k == 0 ? 1.0 : -1.0, *axes, placed, angles);
  }
  if (!head_) return out;
  const Mat3d head = turned(*head_, head_axes_, placed);
  const Mat3d on_trunk = transpose(*axes) * head;
  const Quatd turn = to_quat(on_trunk);
  out.neck = TrunkAngles{atan2(on_trunk.cy.z, on_trunk.cy.y), arc_sine(on_trunk.cy.x),
                         wrapped(2.0 * atan2(turn.y, turn.w))};
  const Mat3d person = person_axes(placed);
  out.head = atan2(dot(head.cy, person.cz), dot(head.cy, person.cy));
  return out;
}

PostureAngles posture_angles(const BodyModel& body, const State& home,
                             std::span<const double> angles) {
  SHG_CHECK(angles.size() == body.dofs().size(), "a posture has an angle for each freedom");
  Kinematics<double> placed(body);
  forward_kinematics<double>(body, angles, placed);
  return AngleMeter(body, home).measure(placed, angles);
}

}  // namespace shigusa
