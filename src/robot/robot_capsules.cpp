// SPDX-License-Identifier: MIT
// Collision capsules of a robot.
#include <algorithm>

#include "body/anthropometry.hpp"
#include "human/human_frames.hpp"
#include "human/landmark_points.hpp"
#include "human/part_shapes.hpp"
#include "measure/fitted_parts.hpp"
#include "robot_builder.hpp"
#include "shape_points.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

// Distances from the shoulders up to the head's joint and the vertex, for robots without a neck.
constexpr double kHeadJoint = 0.09;
constexpr double kVertex = 1.0 - F::kShoulderHeight;
// Distance of waist joints, as a share of the stature, below which they are one.
constexpr double kOneWaist = 0.05;
// Spacing of points on shapes.
constexpr double kPointsApart = 0.01;
// Limits on the numbers of points: along an edge, and of all shapes together.
constexpr double kMostOnEdge = 24.0;
constexpr double kMostPoints = 200'000.0;

// Shapes that determine a link's thickness.
const std::vector<Robot::Shape>& telling(const Robot::Link& link) {
  return link.collides.empty() ? link.shown : link.collides;
}

// Whether points lie beside at least half of the line between two joints.
bool cover(const std::vector<Vec3d>& points, const Vec3d& from, const Vec3d& to) {
  constexpr std::size_t kPieces = 8;
  std::array<bool, kPieces> covered{};
  const Vec3d line = to - from;
  const double square = max(dot(line, line), 1e-12);
  for (const Vec3d& p : points) {
    const double share = dot(p - from, line) / square;
    if (share >= 0.0 && share < 1.0) {
      covered[static_cast<std::size_t>(share * static_cast<double>(kPieces))] = true;
    }
  }
  return 2 * std::count(covered.begin(), covered.end(), true) >= std::ssize(covered);
}

// Drops shapes that are too thick to be the body part's.
void drop_giants(const Landmarks& person, double stature, PartShapes& parts) {
  constexpr double kThickest = 3.0;  // of a person's
  const HumanFrames frames = human_frames(person);
  for (int k = 0; k < kBodyPartCount; ++k) {
    const auto part = static_cast<BodyPart>(k);
    const std::optional<PartShape>& shape = parts[part];
    if (!shape) continue;
    const PartShape usual = part_shape(part, person, frames, stature);
    const double thick = max(shape->radius, shape->to_radius) + norm(shape->aside);
    if (thick > kThickest * max(usual.radius, usual.to_radius)) parts[part].reset();
  }
}

bool none_of(const PartShapes& parts) {
  return std::none_of(parts.shape.begin(), parts.shape.end(),
                      [](const auto& shape) { return shape.has_value(); });
}

}  // namespace

RobotHead RobotBuilder::head() const {
  const Vec3d shoulders = (shoulder(0) + shoulder(1)) * 0.5;
  const Vec3d top = shoulders + Vec3d{0.0, kVertex * body_.stature, 0.0};
  const Vec3d joint = shoulders + Vec3d{0.0, kHeadJoint * body_.stature, 0.0};
  if (person_.neck.empty()) return {joint, top, group_[index(person_.chest)], false};
  const PersonJoint& last = person_.neck.back();
  const bool own_joint = person_.neck.size() > 1;
  const Vec3d above = centre(last) + Vec3d{0.0, 0.5 * kVertex * body_.stature, 0.0};
  return {own_joint ? centre(last) : joint, top.y > above.y ? top : above,
          moving_[index(of_joint_[index(last.joint)])].outer, own_joint};
}

void RobotBuilder::add_capsules() {
  const std::vector<SkinVertex> points = skin();
  Landmarks person = landmarks(points);
  const std::vector<int> trunk = add_waist(person);
  person.parts = fitted(person, points);
  add_trunk_parts(person, trunk);
  for (const std::size_t side : {kRight, 1 - kRight}) add_limb_parts(side, person);
}

std::vector<SkinVertex> RobotBuilder::skin() const {
  double shapes = 1.0;
  for (const Robot::Link& link : robot_.links) {
    shapes += static_cast<double>(telling(link).size());
  }
  const double most = clamp(sqrt(kMostPoints / (6.0 * shapes)), 2.0, kMostOnEdge);
  std::vector<SkinVertex> skin;
  for (std::size_t i = 0; i < robot_.links.size(); ++i) {
    for (const Robot::Shape& shape : telling(robot_.links[i])) {
      for (const Vec3d& p :
           surface_points(shape, kPointsApart * body_.stature, static_cast<int>(most))) {
        skin.push_back({placed_.links[i] * p, static_cast<int>(i)});
      }
    }
  }
  return skin;
}

Landmarks RobotBuilder::landmarks(const std::vector<SkinVertex>& skin) const {
  Landmarks person;
  for (const Side side : kBothSides) {
    const auto s = static_cast<std::size_t>(side);
    const SoleOutline& sole = soles_[s].corners;
    person.leg(side) = {hip(s), knee(s), ankle(s), (sole[0] + sole[3]) * 0.5, {}, sole};
    person.arm(side) = {shoulder(s), elbow(s), wrist(s), fingertip(s, skin), {}, {}};
  }
  const RobotHead top = head();
  const Vec3d shoulders = (shoulder(0) + shoulder(1)) * 0.5;
  person.neck = person_.neck.empty() ? shoulders : centre(person_.neck.front());
  person.head = top.joint.y > person.neck.y ? top.joint : person.neck;
  person.head_top = top.top;
  const int skull = map_[HumanoidBone::head];
  double highest = -1e9;
  for (const SkinVertex& p : skin) {
    if (p.node == skull) highest = max(highest, p.position.y);
  }
  if (highest > person.head->y) person.head_top.y = highest;
  return person;
}

// Fingertip: the end of shapes beyond the hand's frame, or that frame if there are none.
Vec3d RobotBuilder::fingertip(std::size_t side, const std::vector<SkinVertex>& skin) const {
  const PersonLimb& arm = person_.arms[side];
  const Vec3d from = wrist(side);
  const Vec3d to_grip = placed_.links[index(hands_[side])].translation - from;
  double length = norm(to_grip);
  const bool apart = length > kLeastHand * body_.stature;
  const Vec3d along = normalized(apart ? to_grip : from - elbow(side));
  for (const SkinVertex& p : skin) {
    if (group_[index(p.node)] != group_[index(arm.end)]) continue;
    length = max(length, dot(p.position - from, along));
  }
  return from + along * length;
}

std::vector<int> RobotBuilder::add_waist(Landmarks& person) const {
  std::vector<int> groups{group_[index(person_.pelvis)]};
  for (const PersonJoint& joint : person_.spine) {
    const Vec3d& at = centre(joint);
    const bool one =
        !person.spine.empty() && (norm(at - person.spine.back()) < kOneWaist * body_.stature ||
                                  person.spine.size() == kSpineJoints);
    if (!one) {
      person.spine.push_back(at);
      groups.emplace_back();
    }
    groups.back() = moving_[index(of_joint_[index(joint.joint)])].outer;
  }
  return groups;
}

std::vector<SkinVertex> RobotBuilder::without_stubs(const Landmarks& person,
                                                    std::vector<SkinVertex> skin) const {
  std::vector<int> bone(robot_.links.size(), -1);  // (links) the nearest one at or above
  for (std::size_t i = 0; i < bone.size(); ++i) {
    const int carrier = placed_.carrier[i];
    if (carrier >= 0) bone[i] = bone[index(robot_.joints[index(carrier)].parent)];
    for (const HumanoidBone each : kHumanoidBones) {
      if (map_[each] == static_cast<int>(i)) bone[i] = static_cast<int>(i);
    }
  }
  const auto drop_stub = [&](int limb, const Vec3d& from, const Vec3d& to) {
    std::vector<Vec3d> points;
    for (const SkinVertex& p : skin) {
      if (bone[index(p.node)] == limb) points.push_back(p.position);
    }
    if (cover(points, from, to)) return;
    std::erase_if(skin, [&](const SkinVertex& p) { return bone[index(p.node)] == limb; });
  };
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    const Landmarks::Arm& arm = person.arm(side);
    drop_stub(map_[leg_bones(side)[0]], leg.hip, leg.knee);
    drop_stub(map_[leg_bones(side)[1]], leg.knee, leg.ankle);
    drop_stub(map_[arm_bones(side)[0]], arm.shoulder, arm.elbow);
    drop_stub(map_[arm_bones(side)[1]], arm.elbow, arm.wrist);
    drop_stub(map_[arm_bones(side)[2]], arm.wrist, arm.fingertip);
  }
  return skin;
}

PartShapes RobotBuilder::fitted(const Landmarks& person,
                                const std::vector<SkinVertex>& skin) const {
  Skeleton skeleton;
  for (std::size_t i = 0; i < robot_.links.size(); ++i) {
    const int carrier = placed_.carrier[i];
    skeleton.nodes.push_back(
        {robot_.links[i].name, carrier < 0 ? -1 : robot_.joints[index(carrier)].parent});
  }
  const std::vector<SkinVertex> telling = without_stubs(person, skin);
  const SkeletonTree tree(skeleton, placed_.links, telling);
  MeasuredPerson measured;
  measured.landmarks = person;
  HumanoidMap map = map_;
  // the pelvis may be a child of the chest, which then has no bone above it
  int& chest = map[HumanoidBone::chest];
  if (chest < 0 && person_.chest != person_.pelvis) chest = person_.chest;
  PartShapes parts = fitted_parts(tree, map, measured);
  // a head with only a camera's shape does not determine its size
  if (none_of(parts)) {
    map[HumanoidBone::head] = -1;
    parts = fitted_parts(tree, map, measured);
  }
  drop_giants(person, body_.stature, parts);
  return parts;
}

void RobotBuilder::add_part(BodyPart part, int group, const Landmarks& person) {
  for (Capsule& capsule : part_capsules(part, person, human_frames(person), body_.stature)) {
    capsule.link = link_of_[index(group)];
    capsule.from = local(capsule.link, capsule.from);
    capsule.to = local(capsule.link, capsule.to);
    capsule.give = 0.0;  // no flesh
    body_.capsules.push_back(std::move(capsule));
  }
}

void RobotBuilder::add_trunk_parts(const Landmarks& person, const std::vector<int>& groups) {
  const std::vector<BodyPart> parts = trunk_parts(person);
  for (std::size_t k = 0; k < parts.size(); ++k) add_part(parts[k], groups[k], person);
  const auto outer = [&](const PersonJoint& joint) {
    return moving_[index(of_joint_[index(joint.joint)])].outer;
  };
  const bool turns = !person_.neck.empty();
  add_part(BodyPart::neck, turns ? outer(person_.neck.front()) : group_[index(person_.chest)],
           person);
  add_part(BodyPart::head, head().group, person);
  add_part(BodyPart::jaw, head().group, person);
}

int RobotBuilder::group_before(const PersonLimb& limb, std::size_t part) const {
  const PersonJoint& last = limb.joints[limb.begins[part] - 1];
  return moving_[index(of_joint_[index(last.joint)])].outer;
}

void RobotBuilder::add_limb_parts(std::size_t s, const Landmarks& person) {
  const auto side = static_cast<Side>(s);
  const PersonLimb& leg = person_.legs[s];
  const std::size_t first = body_.capsules.size();
  add_part(of_side(BodyPart::left_thigh, side), group_before(leg, 1), person);
  add_part(of_side(BodyPart::left_shank, side), group_before(leg, 2), person);
  add_part(of_side(BodyPart::left_foot, side), group_[index(leg.end)], person);
  for (std::size_t c = first; c < body_.capsules.size(); ++c) body_.capsules[c].leg = side;
  const PersonLimb& arm = person_.arms[s];
  const BodyPart upper = of_side(BodyPart::left_upper_arm, side);
  add_part(upper, group_before(arm, 2), person);
  body_.capsules.back().grown_on = true;
  if (person.parts[upper]) body_.capsules.push_back(beyond_trunk(body_.capsules.back()));
  add_part(of_side(BodyPart::left_forearm, side), group_before(arm, 3), person);
  const double hand = norm(person.arm(side).fingertip - person.arm(side).wrist);
  if (hand > kLeastHand * body_.stature) {
    add_part(of_side(BodyPart::left_hand, side), group_[index(arm.end)], person);
  }
}

}  // namespace shigusa
