// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "body/anthropometry.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "human/segment_mass.hpp"
#include "math/axes.hpp"
#include "robot_builder.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

constexpr double kGravity = 9.80665;  // m/s²

// Strength of a joint without effort, as a share of the weight times the stature: an adult's.
double usual_strength(const std::string& part) {
  const auto is_one_of = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return part.find(name) != part.npos; });
  };
  if (is_one_of({"hip", "knee", "ankle", "spine", "chest"})) return 0.18;
  return is_one_of({"wrist", "neck", "head"}) ? 0.02 : 0.06;
}

// Nearest coordinate axis to a direction and its sign; for other directions a frame with the
// direction as that axis.
struct TurnAxis {
  Axis axis = Axis::x;
  double sign = 1.0;
  std::optional<Mat3d> turn{};
};

TurnAxis turn_axis(const Vec3d& v) {
  constexpr double kRounding = 1e-9;
  const int k = main_axis(v);
  const double sign = v[k] < 0.0 ? -1.0 : 1.0;
  TurnAxis result{static_cast<Axis>(k), sign};
  const Vec3d along = v * sign;
  if (abs(along[(k + 1) % 3]) <= kRounding && abs(along[(k + 2) % 3]) <= kRounding) return result;
  Vec3d e{};
  e[(k + 1) % 3] = 1.0;
  Vec3d columns[3];
  columns[k] = normalized(along);
  columns[(k + 1) % 3] = normalized(e - columns[k] * dot(e, columns[k]));
  columns[(k + 2) % 3] = cross(columns[k], columns[(k + 1) % 3]);
  result.turn = Mat3d{columns[0], columns[1], columns[2]};
  return result;
}

// Rotation about a unit vector.
Mat3d rotation_about(const Vec3d& axis, double angle) {
  const TurnAxis t = turn_axis(axis);
  const Mat3d turn = t.turn.value_or(Mat3d{});
  return rotated(turn, t.axis, sin_cos(t.sign * angle)) * transpose(turn);
}

}  // namespace

Result<PosedBody> RobotBuilder::build() {
  SHG_TRY(understand());
  body_.name = robot_.name;
  body_.robot = true;
  doubts_ = map_.doubts;
  doubts_.insert(doubts_.end(), robot_.doubts.begin(), robot_.doubts.end());
  find_groups();
  measure();
  add_links();
  SHG_TRY(add_masses());
  for (const std::size_t side : {kRight, 1 - kRight}) {
    add_foot(side);
    add_hand(side);
  }
  add_capsules();
  add_nodes();
  add_robot_frame();
  tell();
  return PosedBody{BodyModel(std::move(body_)),
                   {.angles = std::move(home_)},
                   std::move(doubts_),
                   std::move(frame_)};
}

Result<void> RobotBuilder::understand() {
  for (int round = 0; round < 2; ++round) {
    SHG_TRY_ASSIGN(placed_, place_robot(robot_, map_));
    SHG_TRY_ASSIGN(person_, person_joints(robot_, map_, placed_));
    list_moving();
    if (!bend_still_joints()) break;
  }
  return {};
}

void RobotBuilder::list_moving() {
  moving_.clear();
  of_joint_.assign(robot_.joints.size(), -1);
  const auto add = [&](const std::vector<PersonJoint>& joints) {
    for (const PersonJoint& j : joints) {
      of_joint_[index(j.joint)] = static_cast<int>(moving_.size());
      moving_.push_back({.person = &j});
    }
  };
  for (const PersonLimb& leg : person_.legs) add(leg.joints);
  add(person_.spine);
  add(person_.neck);
  for (const PersonLimb& arm : person_.arms) add(arm.joints);
}

bool RobotBuilder::bend_still_joints() {
  bool any = false;
  still_.resize(robot_.joints.size(), 0.0);
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    Robot::Joint& joint = robot_.joints[j];
    if (!joint.moves || of_joint_[j] >= 0 || still_[j] != 0.0) continue;
    still_[j] = clamp(joint.rest, joint.lower, joint.upper);
    if (still_[j] == 0.0) continue;
    if (joint.slides) {
      joint.origin.translation += joint.origin.rotation * (joint.axis * still_[j]);
    } else {
      joint.origin.rotation = joint.origin.rotation * rotation_about(joint.axis, still_[j]);
    }
    any = true;
  }
  return any;
}

void RobotBuilder::find_groups() {
  group_.assign(robot_.links.size(), -1);
  for (std::size_t i = 0; i < group_.size(); ++i) {
    const int carrier = placed_.carrier[i];
    if (carrier >= 0 && of_joint_[index(carrier)] < 0) {
      group_[i] = group_[index(robot_.joints[index(carrier)].parent)];
    } else {
      group_[i] = static_cast<int>(members_.size());
      members_.emplace_back();
    }
    members_[index(group_[i])].push_back(static_cast<int>(i));
  }
  link_of_.assign(members_.size(), kBaseLink);
  for (Moving& m : moving_) {
    const Robot::Joint& joint = robot_.joints[index(m.person->joint)];
    m.outer = group_[index(m.person->outward ? joint.child : joint.parent)];
    m.inner = group_[index(m.person->outward ? joint.parent : joint.child)];
  }
}

const Vec3d& RobotBuilder::centre(const PersonJoint& joint) const {
  return placed_.centre(robot_, joint.joint);
}

const PersonJoint& RobotBuilder::hinge(const PersonLimb& limb, std::size_t part) {
  const std::size_t end =
      part + 1 < limb.begins.size() ? limb.begins[part + 1] : limb.joints.size();
  for (std::size_t i = limb.begins[part]; i < end; ++i) {
    if (limb.joints[i].freedom == "flexion") return limb.joints[i];
  }
  return limb.joints[limb.begins[part]];
}

Vec3d RobotBuilder::shoulder(std::size_t side) const {
  return centre(hinge(person_.arms[side], 1));
}

Vec3d RobotBuilder::wrist(std::size_t side) const {
  const PersonLimb& arm = person_.arms[side];
  return arm.begins[3] < arm.joints.size() ? centre(arm.joints[arm.begins[3]])
                                           : placed_.links[index(arm.end)].translation;
}

void RobotBuilder::measure() {
  double legs = 0.0;
  for (const std::size_t s : {0u, 1u}) {
    legs += 0.5 * (norm(hip(s) - knee(s)) + norm(knee(s) - ankle(s)));
  }
  const Vec3d trunk = (shoulder(0) + shoulder(1) - hip(0) - hip(1)) * 0.5;
  body_.stature = (legs + norm(trunk)) / (F::kShoulderHeight - F::kAnkleHeight);
  for (const std::size_t s : {0u, 1u}) {
    soles_[s] = robot_sole(robot_, placed_, members_[index(group_[index(person_.legs[s].end)])],
                           ankle(s), body_.stature);
  }
  const double floor = min(soles_[0].corners[0].y, soles_[1].corners[0].y);
  for (Transformd& link : placed_.links) link.translation.y -= floor;
  for (RobotSole& sole : soles_) {
    for (Vec3d& corner : sole.corners) corner.y -= floor;
  }
  base_ = ankle(kRight);
  body_.base = {Mat3d{}, base_};
}

const Vec3d& RobotBuilder::origin(int link) const {
  return link == kBaseLink ? base_ : origins_[index(link)];
}

void RobotBuilder::add_links() {
  body_.base_mass = {};
  std::vector<int> waiting{group_[index(person_.legs[kRight].end)]};
  std::vector<bool> seen(members_.size(), false);
  seen[index(waiting[0])] = true;
  while (!waiting.empty()) {
    const int group = waiting.back();
    const int parent = waiting.size() == 1 ? kBaseLink : link_of_[index(group)];
    int next = -1;
    for (std::size_t m = 0; m < moving_.size() && next < 0; ++m) {
      const Moving& j = moving_[m];
      const int other = j.inner == group ? j.outer : j.outer == group ? j.inner : -1;
      if (other < 0 || seen[index(other)]) continue;
      next = other;
      seen[index(other)] = true;
      add_dof(moving_[m], other, parent);
    }
    if (next < 0) {
      waiting.pop_back();
    } else {
      waiting.push_back(next);
    }
  }
}

void RobotBuilder::add_dof(Moving& moving, int group, int parent) {
  const PersonJoint& person = *moving.person;
  const Robot::Joint& joint = robot_.joints[index(person.joint)];
  const bool child_moves = group == group_[index(joint.child)];
  const double sign = person.sign;
  const TurnAxis axis = turn_axis(placed_.axis[index(person.joint)] * (child_moves ? sign : -sign));
  Dof dof;
  dof.joint = person.part;
  dof.name = unique(person.part + "." + person.freedom);
  dof.parent = parent;
  dof.offset = centre(person) - origin(parent);
  dof.axis = axis.axis;
  dof.sign = axis.sign;
  dof.turn = axis.turn;
  dof.lower = sign > 0.0 ? joint.lower : 0.0 - joint.upper;
  dof.upper = sign > 0.0 ? joint.upper : 0.0 - joint.lower;
  if (!joint.limited && person.usual) {
    dof.lower = (*person.usual)[0];
    dof.upper = (*person.usual)[1];
    unlimited_.push_back(joint.name);
  }
  dof.torque_positive = dof.torque_negative = joint.effort;
  moving.dof = static_cast<int>(body_.dofs.size());
  link_of_[index(group)] = moving.dof;
  origins_.push_back(centre(person));
  home_.push_back(clamp(0.0, dof.lower, dof.upper));
  body_.dofs.push_back(std::move(dof));
}

std::string RobotBuilder::unique(const std::string& name) {
  std::string result = name;
  const auto taken = [&] {
    return std::any_of(body_.dofs.begin(), body_.dofs.end(),
                       [&](const Dof& dof) { return dof.name == result; });
  };
  for (int k = 2; taken(); ++k) result = fmt::format("{}_{}", name, k);
  return result;
}

Result<void> RobotBuilder::add_masses() {
  body_.masses.assign(body_.dofs.size(), {});
  if (spread_) spread_mass(*spread_);
  for (std::size_t g = 0; g < members_.size(); ++g) {
    LinkMass sum;
    for (const int link : members_[g]) {
      const Robot::Link& l = robot_.links[index(link)];
      const Transformd& place = placed_.links[index(link)];
      const Vec3d com = place * l.com;
      sum.add(LinkMass::of(l.mass, com, place.rotation * l.inertia * transpose(place.rotation)));
    }
    if (!(sum.mass > 0.0)) {
      if (!is_within_joint(g)) massless_.push_back(robot_.links[index(members_[g][0])].name);
      continue;
    }
    const int link = link_of_[g];
    MassProperties& to = link == kBaseLink ? body_.base_mass : body_.masses[index(link)];
    to = sum.in_frame(Mat3d{}, origin(link));
    body_.mass += sum.mass;
  }
  if (!(body_.mass > 0.0)) {
    return fail(ErrorCode::unsupported, say("no_mass"));
  }
  // no joint could hold the whole weight at an arm of the robot's height: such an effort means no
  // limit
  const double most = body_.mass * kGravity * body_.stature;
  for (Dof& dof : body_.dofs) {
    if (dof.torque_positive > 0.0 && dof.torque_positive <= most) continue;
    weak_.push_back(dof.name);
    dof.torque_positive = dof.torque_negative = usual_strength(dof.joint) * most;
  }
  return {};
}

// Whether a link lies between two axes of one joint, so that it needs no mass.
bool RobotBuilder::is_within_joint(std::size_t group) const {
  constexpr double kApart = 0.05;  // of the stature, between the axes
  for (const Moving& m : moving_) {
    if (m.inner != static_cast<int>(group)) continue;
    for (const Moving& other : moving_) {
      const bool carries = other.outer == m.inner;
      const double apart = norm(centre(*m.person) - centre(*other.person));
      if (carries && apart < kApart * body_.stature) return true;
    }
  }
  return false;
}

int RobotBuilder::dof_of(const PersonJoint& joint) const {
  return moving_[index(of_joint_[index(joint.joint)])].dof;
}

Result<PosedBody> build_robot(const Robot& robot, const HumanoidMap& map,
                              std::optional<double> mass) {
  return RobotBuilder(robot, map, mass).build();
}

}  // namespace shigusa
