// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <shigusa/body/anthropometry.hpp>
#include <shigusa/body/human_body.hpp>
#include <shigusa/core/check.hpp>

#include "robot_feet.hpp"
#include "robot_joints.hpp"
#include "segment_mass.hpp"

namespace shigusa {
namespace {

using F = StatureFractions;

constexpr std::array<const char*, 2> kSides{"left_", "right_"};
constexpr std::size_t kRight = 1;
constexpr double kGravity = 9.80665;  // m/s²
// Of a joint without effort, as a share of the weight times the stature: an adult's shoulder.
constexpr double kUsualStrength = 0.06;
// A gripper's frame is at least this far beyond the wrist, as a share of the stature.
constexpr double kLeastHand = 0.01;
// From between the shoulders up to the head's joint and the vertex, of robots without a neck.
constexpr double kHeadJoint = 0.09;
constexpr double kVertex = 1.0 - F::kShoulderHeight;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Mat3d scaled(const Mat3d& m, double s) { return {m.cx * s, m.cy * s, m.cz * s}; }
Mat3d outer(const Vec3d& a, const Vec3d& b) { return {a * b.x, a * b.y, a * b.z}; }

// Inertia about the origin of a point mass at p.
Mat3d point_inertia(double mass, const Vec3d& p) {
  const double d = dot(p, p);
  return scaled(Mat3d{{d, 0, 0}, {0, d, 0}, {0, 0, d}} + scaled(outer(p, p), -1.0), mass);
}

// Which coordinate axis a direction is nearest to, which way, and, where it is none, the frame that
// has the direction as that axis.
struct TurnAxis {
  Axis axis = Axis::x;
  double sign = 1.0;
  std::optional<Mat3d> turn{};
};

TurnAxis turn_axis(const Vec3d& v) {
  constexpr double kRounding = 1e-9;
  int k = 0;
  for (int i = 1; i < 3; ++i) k = abs(v[i]) > abs(v[k]) ? i : k;
  const double sign = v[k] < 0.0 ? -1.0 : 1.0;
  TurnAxis result{static_cast<Axis>(k), sign};
  const Vec3d along = v * sign;
  const Vec3d next = along[(k + 1) % 3] == 0.0 && along[(k + 2) % 3] == 0.0 ? Vec3d{} : along;
  if (abs(along[(k + 1) % 3]) <= kRounding && abs(along[(k + 2) % 3]) <= kRounding) return result;
  Vec3d e{};
  e[(k + 1) % 3] = 1.0;
  Vec3d columns[3];
  columns[k] = normalized(next);
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

class RobotBuilder {
 public:
  RobotBuilder(const Robot& robot, const HumanoidMap& map) : robot_(robot), map_(map) {}

  Result<BodyModel> build() {
    if (const auto done = understand(); !done) return tl::unexpected(done.error());
    body_.name = robot_.name;
    body_.doubts = map_.doubts;
    body_.doubts.insert(body_.doubts.end(), robot_.doubts.begin(), robot_.doubts.end());
    find_groups();
    measure();
    add_links();
    if (const auto done = add_masses(); !done) return tl::unexpected(done.error());
    for (const std::size_t side : {kRight, 1 - kRight}) {
      add_foot(side);
      add_hand(side);
    }
    add_capsules();
    add_nodes();
    add_robot_frame();
    tell();
    return BodyModel(std::move(body_));
  }

 private:
  // A moving joint of the body.
  struct Moving {
    const PersonJoint* person = nullptr;
    int dof = -1;
    int outer = -1;  // group away from the pelvis
    int inner = -1;
  };

  Result<void> understand() {
    for (int round = 0; round < 2; ++round) {
      Result<PlacedRobot> placed = place_robot(robot_, map_);
      if (!placed) return tl::unexpected(placed.error());
      placed_ = std::move(*placed);
      Result<PersonJoints> person = person_joints(robot_, map_, placed_);
      if (!person) return tl::unexpected(person.error());
      person_ = std::move(*person);
      list_moving();
      if (!bend_still_joints()) break;
    }
    return {};
  }

  void list_moving() {
    moving_.clear();
    of_joint_.assign(robot_.joints.size(), -1);
    const auto add = [&](const std::vector<PersonJoint>& joints) {
      for (const PersonJoint& j : joints) {
        of_joint_[at(j.joint)] = static_cast<int>(moving_.size());
        moving_.push_back({.person = &j});
      }
    };
    for (const PersonLimb& leg : person_.legs) add(leg.joints);
    add(person_.spine);
    add(person_.neck);
    for (const PersonLimb& arm : person_.arms) add(arm.joints);
  }

  // Joints that keep their angle and may not be at 0 are bent as little as their limits allow; true
  // where there was one.
  bool bend_still_joints() {
    bool any = false;
    still_.resize(robot_.joints.size(), 0.0);
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      Robot::Joint& joint = robot_.joints[j];
      if (!joint.moves || of_joint_[j] >= 0 || still_[j] != 0.0) continue;
      still_[j] = clamp(0.0, joint.lower, joint.upper);
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

  // Links that do not move against each other are one group.
  void find_groups() {
    group_.assign(robot_.links.size(), -1);
    for (std::size_t i = 0; i < group_.size(); ++i) {
      const int carrier = placed_.carrier[i];
      if (carrier >= 0 && of_joint_[at(carrier)] < 0) {
        group_[i] = group_[at(robot_.joints[at(carrier)].parent)];
      } else {
        group_[i] = static_cast<int>(members_.size());
        members_.emplace_back();
      }
      members_[at(group_[i])].push_back(static_cast<int>(i));
    }
    link_of_.assign(members_.size(), kBaseLink);
    for (Moving& m : moving_) {
      const Robot::Joint& joint = robot_.joints[at(m.person->joint)];
      m.outer = group_[at(m.person->outward ? joint.child : joint.parent)];
      m.inner = group_[at(m.person->outward ? joint.parent : joint.child)];
    }
  }

  [[nodiscard]] const Vec3d& centre(const PersonJoint& joint) const {
    return placed_.centre(robot_, joint.joint);
  }

  // The joint of a part that flexes, else its first one.
  static const PersonJoint& hinge(const PersonLimb& limb, std::size_t part) {
    const std::size_t end =
        part + 1 < limb.begins.size() ? limb.begins[part + 1] : limb.joints.size();
    for (std::size_t i = limb.begins[part]; i < end; ++i) {
      if (limb.joints[i].freedom == "flexion") return limb.joints[i];
    }
    return limb.joints[limb.begins[part]];
  }
  [[nodiscard]] Vec3d hip(std::size_t side) const { return centre(hinge(person_.legs[side], 0)); }
  [[nodiscard]] Vec3d knee(std::size_t side) const { return centre(hinge(person_.legs[side], 1)); }
  [[nodiscard]] Vec3d ankle(std::size_t side) const { return centre(hinge(person_.legs[side], 2)); }
  [[nodiscard]] Vec3d shoulder(std::size_t side) const {
    return centre(hinge(person_.arms[side], 1));
  }
  [[nodiscard]] Vec3d elbow(std::size_t side) const { return centre(hinge(person_.arms[side], 2)); }
  [[nodiscard]] Vec3d wrist(std::size_t side) const {
    const PersonLimb& arm = person_.arms[side];
    return arm.begins[3] < arm.joints.size() ? centre(arm.joints[arm.begins[3]])
                                             : placed_.links[at(arm.end)].translation;
  }

  // Stature, floor, and the base's place.
  void measure() {
    double legs = 0.0;
    for (const std::size_t s : {0u, 1u}) {
      legs += 0.5 * (norm(hip(s) - knee(s)) + norm(knee(s) - ankle(s)));
    }
    const Vec3d trunk = (shoulder(0) + shoulder(1) - hip(0) - hip(1)) * 0.5;
    body_.stature = (legs + norm(trunk)) / (F::kShoulderHeight - F::kAnkleHeight);
    for (const std::size_t s : {0u, 1u}) {
      soles_[s] = robot_sole(robot_, placed_, members_[at(group_[at(person_.legs[s].end)])],
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

  [[nodiscard]] const Vec3d& origin(int link) const {
    return link == kBaseLink ? base_ : origins_[at(link)];
  }

  // The tree from the standing foot on, depth first, the pelvis before what else hangs on a link.
  void add_links() {
    body_.base_mass = {};
    std::vector<int> waiting{group_[at(person_.legs[kRight].end)]};
    std::vector<bool> seen(members_.size(), false);
    seen[at(waiting[0])] = true;
    while (!waiting.empty()) {
      const int group = waiting.back();
      const int parent = waiting.size() == 1 ? kBaseLink : link_of_[at(group)];
      int next = -1;
      for (std::size_t m = 0; m < moving_.size() && next < 0; ++m) {
        const Moving& j = moving_[m];
        const int other = j.inner == group ? j.outer : j.outer == group ? j.inner : -1;
        if (other < 0 || seen[at(other)]) continue;
        next = other;
        seen[at(other)] = true;
        add_dof(moving_[m], other, parent);
      }
      if (next < 0) {
        waiting.pop_back();
      } else {
        waiting.push_back(next);
      }
    }
  }

  void add_dof(Moving& moving, int group, int parent) {
    const PersonJoint& person = *moving.person;
    const Robot::Joint& joint = robot_.joints[at(person.joint)];
    const bool child_moves = group == group_[at(joint.child)];
    const double sign = person.sign;
    const TurnAxis axis = turn_axis(placed_.axis[at(person.joint)] * (child_moves ? sign : -sign));
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
    link_of_[at(group)] = moving.dof;
    origins_.push_back(centre(person));
    body_.start.push_back(clamp(0.0, dof.lower, dof.upper));
    body_.dofs.push_back(std::move(dof));
  }

  std::string unique(const std::string& name) {
    std::string result = name;
    const auto taken = [&] {
      return std::any_of(body_.dofs.begin(), body_.dofs.end(),
                         [&](const Dof& dof) { return dof.name == result; });
    };
    for (int k = 2; taken(); ++k) result = fmt::format("{}_{}", name, k);
    return result;
  }

  Result<void> add_masses() {
    body_.masses.assign(body_.dofs.size(), {});
    for (std::size_t g = 0; g < members_.size(); ++g) {
      LinkMass sum;
      for (const int link : members_[g]) {
        const Robot::Link& l = robot_.links[at(link)];
        const Transformd& place = placed_.links[at(link)];
        const Vec3d com = place * l.com;
        sum.add(
            {l.mass, com * l.mass,
             place.rotation * l.inertia * transpose(place.rotation) + point_inertia(l.mass, com)});
      }
      if (!(sum.mass > 0.0)) continue;
      const int link = link_of_[g];
      MassProperties& to = link == kBaseLink ? body_.base_mass : body_.masses[at(link)];
      to = sum.in_frame(Mat3d{}, origin(link));
      body_.mass += sum.mass;
    }
    if (!(body_.mass > 0.0)) {
      return fail(ErrorCode::unsupported,
                  "no link has a mass; a motion is chosen by its torques and needs them");
    }
    // no joint holds all the weight at an arm as long as the robot: such an effort stands for none
    const double most = body_.mass * kGravity * body_.stature;
    for (Dof& dof : body_.dofs) {
      if (dof.torque_positive > 0.0 && dof.torque_positive <= most) continue;
      weak_.push_back(dof.name);
      dof.torque_positive = dof.torque_negative = kUsualStrength * most;
    }
    return {};
  }

  [[nodiscard]] int dof_of(const PersonJoint& joint) const {
    return moving_[at(of_joint_[at(joint.joint)])].dof;
  }
  [[nodiscard]] int link_of(int robot_link) const { return link_of_[at(group_[at(robot_link)])]; }
  [[nodiscard]] Vec3d local(int link, const Vec3d& world) const { return world - origin(link); }

  void add_foot(std::size_t side) {
    const RobotSole& sole = soles_[side];
    // a foot that hangs in the air bears nothing
    if (sole.corners[0].y > kLiftedFoot) return;
    const int end = person_.legs[side].end;
    Foot foot{.name = std::string(kSides[side]) + "foot",
              .node = robot_.links[at(end)].name,
              .link = link_of(end),
              .centre = {},
              .outline = {}};
    for (const Vec3d& corner : sole.corners) {
      foot.outline.push_back(local(foot.link, corner));
      foot.centre += foot.outline.back() * 0.25;
    }
    body_.feet.push_back(std::move(foot));
  }

  // The frame in the hand that is the effector.
  [[nodiscard]] int hand_link(std::size_t side) const {
    const PersonLimb& arm = person_.arms[side];
    for (const char* word : {"grip", "palm", "hand"}) {
      for (const int link : members_[at(group_[at(arm.end)])]) {
        std::string name = robot_.links[at(link)].name;
        for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const Vec3d way = placed_.links[at(link)].translation - wrist(side);
        const bool apart = norm(way) > kLeastHand * body_.stature;
        if (apart && name.find(word) != name.npos) return link;
      }
    }
    return arm.end;
  }

  void add_hand(std::size_t side) {
    const PersonLimb& arm = person_.arms[side];
    hands_[side] = hand_link(side);
    const int link = link_of(hands_[side]);
    body_.effectors.push_back({std::string(kSides[side]) + "hand",
                               robot_.links[at(hands_[side])].name, link,
                               local(link, placed_.links[at(hands_[side])].translation),
                               dof_of(arm.joints[arm.begins[1]])});
  }

  void add_capsule(const std::string& name, int link, const Vec3d& from, const Vec3d& to,
                   double radius) {
    if (norm(to - from) > 0.0) {
      body_.capsules.push_back(
          {name, link, local(link, from), local(link, to), radius * body_.stature});
    }
  }

  // As a person's of that stature, which is all that the file's meshes would tell.
  void add_capsules() {
    const Vec3d hips = (hip(0) + hip(1)) * 0.5;
    const Vec3d shoulders = (shoulder(0) + shoulder(1)) * 0.5;
    const Vec3d inset = normalized(shoulders - hips) * (kTrunkRadius * body_.stature);
    add_capsule("trunk", link_of(person_.chest), hips, shoulders - inset, kTrunkRadius);
    for (const std::size_t side : {kRight, 1 - kRight}) {
      const std::string prefix = kSides[side];
      const PersonLimb& leg = person_.legs[side];
      const int thigh = moving_[at(of_joint_[at(leg.joints[leg.begins[1] - 1].joint)])].outer;
      add_capsule(prefix + "thigh", link_of_[at(thigh)], knee(side), hip(side), kThighRadius);
      const Effector& hand = body_.effectors[side == kRight ? 0 : 1];
      add_capsule(prefix + "hand", hand.link, wrist(side), origin(hand.link) + hand.point,
                  kForearmRadius);
    }
  }

  // Nodes stand where joints turn, so that a skeleton of them moves as the robot does. They grow
  // from the pelvis.
  void add_nodes() {
    const Vec3d hips = (hip(0) + hip(1)) * 0.5;
    name_nodes();
    const int pelvis = group_[at(person_.pelvis)];
    node_of_.assign(members_.size(), -1);
    node_of_[at(pelvis)] = add_node("hips", -1, pelvis, hips);
    for (const PersonLimb& leg : person_.legs) add_chain(leg.joints);
    add_chain(person_.spine);
    for (const PersonLimb& arm : person_.arms) add_chain(arm.joints);
    add_chain(person_.neck);
    add_head();
    for (const std::size_t side : {0u, 1u}) {
      add_hand_nodes(side);
      add_foot_nodes(side);
    }
  }

  // A person's names go to the joints that bend; an effector's and a foot's link keep theirs.
  void name_nodes() {
    for (const std::size_t side : {0u, 1u}) {
      const std::string prefix = kSides[side];
      const PersonLimb& leg = person_.legs[side];
      const PersonLimb& arm = person_.arms[side];
      names_.emplace(leg.joints[0].joint, prefix + "upper_leg");
      names_.emplace(hinge(leg, 1).joint, prefix + "lower_leg");
      names_.emplace(hinge(leg, 2).joint, prefix + "foot");
      names_.emplace(arm.joints[arm.begins[1]].joint, prefix + "upper_arm");
      names_.emplace(hinge(arm, 2).joint, prefix + "lower_arm");
      if (arm.begins[3] < arm.joints.size()) {
        names_.emplace(arm.joints[arm.begins[3]].joint, prefix + "hand");
      }
      for (const int link : {hands_[side], leg.end}) {
        taken_.push_back(robot_.links[at(link)].name);
      }
    }
    if (!person_.neck.empty()) {
      names_.emplace(person_.neck.back().joint, "head");
      names_.emplace(person_.neck.front().joint, "neck");
    }
  }

  int add_node(const std::string& name, int parent, int group, const Vec3d& world,
               bool end_site = false) {
    const int link = link_of_[at(group)];
    body_.nodes.push_back({name, parent, link, local(link, world), end_site});
    return static_cast<int>(body_.nodes.size()) - 1;
  }

  std::string free_name(std::string name) {
    while (std::find(taken_.begin(), taken_.end(), name) != taken_.end()) name += "_joint";
    taken_.push_back(name);
    return name;
  }

  void add_chain(const std::vector<PersonJoint>& joints) {
    for (const PersonJoint& j : joints) {
      const Moving& m = moving_[at(of_joint_[at(j.joint)])];
      const auto name = names_.find(j.joint);
      const Robot::Joint& joint = robot_.joints[at(j.joint)];
      node_of_[at(m.outer)] =
          add_node(free_name(name != names_.end()
                                 ? name->second
                                 : robot_.links[at(j.outward ? joint.child : joint.parent)].name),
                   node_of_[at(m.inner)], m.outer, centre(j));
    }
  }

  void add_head() {
    const Vec3d shoulders = (shoulder(0) + shoulder(1)) * 0.5;
    const int chest = group_[at(person_.chest)];
    const Vec3d top = shoulders + Vec3d{0.0, kVertex * body_.stature, 0.0};
    if (person_.neck.empty()) {
      const Vec3d joint = shoulders + Vec3d{0.0, kHeadJoint * body_.stature, 0.0};
      const int head = add_node(free_name("head"), node_of_[at(chest)], chest, joint);
      add_node("", head, chest, top, true);
      return;
    }
    const int group = moving_[at(of_joint_[at(person_.neck.back().joint)])].outer;
    int head = node_of_[at(group)];
    if (person_.neck.size() == 1) {
      head = add_node(free_name("head"), head, group,
                      shoulders + Vec3d{0.0, kHeadJoint * body_.stature, 0.0});
    }
    const Vec3d above =
        origin(link_of_[at(group)]) + Vec3d{0.0, 0.5 * kVertex * body_.stature, 0.0};
    add_node("", head, group, top.y > above.y ? top : above, true);
  }

  void add_hand_nodes(std::size_t side) {
    const PersonLimb& arm = person_.arms[side];
    const int group = group_[at(arm.end)];
    const Vec3d grip = placed_.links[at(hands_[side])].translation;
    const std::string vocabulary = std::string(kSides[side]) + "hand";
    int parent = node_of_[at(group)];
    const bool has_wrist = arm.begins[3] < arm.joints.size();
    if (!has_wrist && robot_.links[at(hands_[side])].name != vocabulary) {
      parent =
          add_node(free_name(vocabulary), parent, group, placed_.links[at(arm.end)].translation);
    }
    const int node = add_node(robot_.links[at(hands_[side])].name, parent, group, grip);
    const Vec3d along = normalized(wrist(side) - elbow(side));
    add_node("", node, group, grip + along * (0.3 * F::kHand * body_.stature), true);
  }

  void add_foot_nodes(std::size_t side) {
    const int end = person_.legs[side].end;
    const int group = group_[at(end)];
    const int parent = node_of_[at(group)];
    add_node(robot_.links[at(end)].name, parent, group, placed_.links[at(end)].translation);
    const Vec3d toe = (soles_[side].corners[0] + soles_[side].corners[3]) * 0.5;
    add_node("", static_cast<int>(body_.nodes.size()) - 1, group, toe, true);
  }

  void add_robot_frame() {
    RobotFrame frame;
    frame.root = robot_.links[0].name;
    frame.link = link_of(0);
    frame.root_in_link = {placed_.links[0].rotation,
                          local(frame.link, placed_.links[0].translation)};
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const Robot::Joint& joint = robot_.joints[j];
      if (!joint.moves) continue;
      RobotJoint& to = frame.joints.emplace_back();
      to.name = joint.name;
      to.angle = still_[j];
      to.slides = joint.slides;
      if (of_joint_[j] < 0) {
        if (joint.turns) still_names_.push_back(joint.name);
        continue;
      }
      const Moving& m = moving_[at(of_joint_[j])];
      to.dof = m.dof;
      to.sign = m.person->sign;
    }
    body_.robot = std::move(frame);
  }

  void tell() {
    const auto doubt = [&](const std::vector<std::string>& names, const char* what) {
      if (names.empty()) return;
      body_.doubts.push_back(names.size() == 1 ? fmt::format("joint '{}' {}", names[0], what)
                                               : fmt::format("{} joints, '{}' the first, each {}",
                                                             names.size(), names[0], what));
    };
    doubt(still_names_, "is of no limb, or of fingers, toes or face: it keeps its angle");
    doubt(unlimited_, "has no limits in the file: it gets a person's");
    if (!weak_.empty()) {
      body_.doubts.push_back(fmt::format(
          "the file has no effort, or an impossible one, for {} of the freedoms, {} the "
          "first: each gets {:.0f} N m",
          weak_.size(), weak_[0], kUsualStrength * body_.mass * kGravity * body_.stature));
    }
    if (soles_[0].guessed || soles_[1].guessed) {
      body_.doubts.push_back(
          "the feet have no shapes to tell their soles: they are as long and "
          "broad as a person's");
    }
    if (body_.feet.size() < 2) {
      body_.doubts.push_back("one foot is in the air where all angles are 0: it carries nothing");
    }
  }

  Robot robot_;
  const HumanoidMap& map_;
  PlacedRobot placed_;
  PersonJoints person_;
  std::vector<Moving> moving_;
  std::vector<int> of_joint_;              // (joints) index in moving_, or -1
  std::vector<double> still_;              // (joints) rad, of those that keep their angle
  std::vector<int> group_;                 // (links)
  std::vector<std::vector<int>> members_;  // (groups) links
  std::vector<int> link_of_;               // (groups) the kernel's link
  std::vector<Vec3d> origins_;             // (dofs) m, world, of their links
  Vec3d base_{};
  std::array<RobotSole, 2> soles_;
  std::array<int, 2> hands_{};        // links of the file
  std::map<int, std::string> names_;  // of nodes, by joint
  std::vector<std::string> taken_;    // names of nodes
  std::vector<int> node_of_;          // (groups)
  std::vector<std::string> unlimited_;
  std::vector<std::string> still_names_;
  std::vector<std::string> weak_;  // freedoms without effort
  BodyDefinition body_;
};

}  // namespace

Result<BodyModel> build_robot(const Robot& robot, const HumanoidMap& map) {
  return RobotBuilder(robot, map).build();
}

}  // namespace shigusa
