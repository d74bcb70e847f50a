// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace shigusa {

/// A side of the body, as the person has it.
enum class Side {
  left,   ///< the person's left, +X
  right,  ///< the person's right, -X
};

/// The limb that a joint is of.
enum class LimbKind {
  trunk,  ///< pelvis, spine, neck and head
  arm,    ///< from the clavicle to the hand
  leg,    ///< from the hip to the toes
};

/// A joint of a person, or a place that goals are given for.
enum class JointKind {
  other,        ///< that people have no word for, as robots have some
  hips,         ///< the pelvis
  spine,        ///< the lowest joint of the back
  chest,        ///< the joint above it
  upper_chest,  ///< the joint above that
  neck,         ///< above the shoulders
  head,         ///< of neck and skull
  clavicle,     ///< at the breastbone
  shoulder,     ///< carries the arm
  elbow,        ///< bends the arm
  wrist,        ///< carries the hand
  hand,         ///< its grip, an effector
  hip,          ///< carries the leg
  knee,         ///< bends the leg
  ankle,        ///< carries the foot
  toes,         ///< bend where a heel lifts
  foot,         ///< its sole, an effector
};
/// The words of JointKind.
template <>
inline constexpr std::array kEnumWords<JointKind>{
    EnumWord{JointKind::hips, "hips"},         EnumWord{JointKind::spine, "spine"},
    EnumWord{JointKind::chest, "chest"},       EnumWord{JointKind::upper_chest, "upper_chest"},
    EnumWord{JointKind::neck, "neck"},         EnumWord{JointKind::head, "head"},
    EnumWord{JointKind::clavicle, "clavicle"}, EnumWord{JointKind::shoulder, "shoulder"},
    EnumWord{JointKind::elbow, "elbow"},       EnumWord{JointKind::wrist, "wrist"},
    EnumWord{JointKind::hand, "hand"},         EnumWord{JointKind::hip, "hip"},
    EnumWord{JointKind::knee, "knee"},         EnumWord{JointKind::ankle, "ankle"},
    EnumWord{JointKind::toes, "toes"},         EnumWord{JointKind::foot, "foot"}};
/// The joints of the back, from below.
inline constexpr std::array kBackJoints{JointKind::spine, JointKind::chest, JointKind::upper_chest};

/// The movement that a freedom of a joint is.
enum class FreedomKind {
  other,        ///< that people have no word for; also of an effector, which has none
  flexion,      ///< bends
  abduction,    ///< takes a limb off the body
  lateral,      ///< bends the trunk to the side
  rotation,     ///< turns about the segment's own axis
  inversion,    ///< turns the sole inwards
  elevation,    ///< lifts the shoulder
  protraction,  ///< takes the shoulder forwards
  deviation,    ///< bends the hand sideways
};
/// The words of FreedomKind.
template <>
inline constexpr std::array kEnumWords<FreedomKind>{
    EnumWord{FreedomKind::flexion, "flexion"},
    EnumWord{FreedomKind::abduction, "abduction"},
    EnumWord{FreedomKind::lateral, "lateral"},
    EnumWord{FreedomKind::rotation, "rotation"},
    EnumWord{FreedomKind::inversion, "inversion"},
    EnumWord{FreedomKind::elevation, "elevation"},
    EnumWord{FreedomKind::protraction, "protraction"},
    EnumWord{FreedomKind::deviation, "deviation"}};

/// Where a freedom or an effector is on a person: "left_hip.flexion" is the freedom "flexion" of
/// the joint "hip" of the left leg.
struct JointPlace {
  std::optional<Side> side{};               ///< none of the trunk, and of what both sides share
  LimbKind limb = LimbKind::trunk;          ///< that it is of
  JointKind joint_kind = JointKind::other;  ///< of `joint`
  FreedomKind freedom_kind = FreedomKind::other;  ///< of `freedom`
  std::string joint{};                            ///< "hip", "upper_chest", "hand"
  std::string freedom{};                          ///< "flexion"; empty of an effector

  /// Whether it is that freedom of that joint, of any side.
  [[nodiscard]] bool is(JointKind a_joint, FreedomKind a_freedom) const {
    return joint_kind == a_joint && freedom_kind == a_freedom;
  }
};

/// The place that the name of a joint, freedom, node or effector tells: "left_hip.flexion".
[[nodiscard]] JointPlace parse_joint_name(std::string_view name);

/// A body as the kernel computes with it.
template <class T>
struct BodyConstants;

/// The link that stands still: the foot that carries the body, or its forefoot where heels lift.
/// All other links are numbered as the freedom that moves them.
inline constexpr int kBaseLink = -1;

/// One rotational freedom and the link that it moves. Where all angles are 0 every link frame has
/// the orientation of the base's, so a joint's axis is one of the coordinate axes, or, in robots,
/// one of a frame that is turned against the link's.
struct Dof {
  std::string joint;             ///< "right_hip"
  std::string name;              ///< "right_hip.flexion"
  int parent = kBaseLink;        ///< link that carries the joint: an earlier dof, or kBaseLink
  Vec3d offset{};                ///< m, the joint's centre in the parent's link frame
  Axis axis = Axis::x;           ///< rotation axis in the parent's link frame
  double sign = 1.0;             ///< direction of the axis: a positive angle is the anatomical one
  std::optional<Mat3d> turn{};   ///< R_LA of a slanting axis: it is `axis` of the frame A
  double lower = -kPi;           ///< rad, hard limit
  double upper = kPi;            ///< rad, hard limit
  double torque_positive = 1.0;  ///< N·m, strength towards larger angles, > 0
  double torque_negative = 1.0;  ///< N·m, strength towards smaller angles, > 0
  /// How much the freedom gives beside the other freedoms at the same weight, in (0, 1]: less than
  /// 1 of one that gives way last (the toes).
  double give = 1.0;
  JointPlace part{};  ///< by the name; BodyModel sets it
};

/// An upper limit that grows with another angle: hamstrings let the hip flex further when the knee
/// bends. upper(q) = Dof::upper + gain · clamp(q[driver] / driver_full, 0, 1).
struct LimitCoupling {
  int dof = 0;               ///< freedom whose upper limit grows
  int driver = 0;            ///< freedom that the limit grows with
  double gain = 0.0;         ///< rad, by how much it grows at most
  double driver_full = 1.0;  ///< rad, > 0: angle of the driver at which it has grown by all of that
};

/// Mass of one link, with its distribution.
struct MassProperties {
  double mass = 0.0;                               ///< kg
  Vec3d com{};                                     ///< m, in the link frame
  Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  ///< kg·m², about the com, link axes
};

/// A point that goals are given for.
struct Effector {
  std::string name;   ///< "right_hand"
  std::string node;   ///< node of the exported skeleton whose origin it is: "right_hand_grip"
  int link = 0;       ///< that carries the point
  Vec3d point{};      ///< m, in the link frame
  int limb_root = 0;  ///< first dof of the limb that it ends: the shoulder's
  JointPlace part{};  ///< by the name; BodyModel sets it
};

/// A part of the body as a line with a thickness; moves with `link`.
struct Capsule {
  std::string name;           ///< "trunk"
  int link = kBaseLink;       ///< that carries the line
  Vec3d from{};               ///< m, link frame
  Vec3d to{};                 ///< m, link frame
  double radius = 0.0;        ///< m, > 0, at `from`
  std::optional<Side> leg{};  ///< of whose leg it is a part, where it is
  double to_radius = radius;  ///< m, > 0, at `to`; between them it changes evenly
  double give = 0.0;          ///< m, by which its flesh yields to what presses on it
  bool grown_on = false;  ///< of an arm: it begins within the trunk, which it cannot collide with
};

/// A heel bears nothing once its toes are bent by this (rad); before, the less the more they are.
inline constexpr double kHeelLifts = radians(3.0);
/// A heel that lifts. The link that stands is then the forefoot, and the rest of the foot turns
/// about the toes' joint; points in the frame of the foot's link.
struct Heel {
  int toes = 0;             ///< freedom of the toes: 0 with the heel down, larger the more it lifts
  int ankle = 0;            ///< the ankle's dorsiflexion, which the toes take over where it ends
  Vec3d back{};             ///< m, hindmost place of the sole, with the heel down
  Vec3d forefoot_centre{};  ///< m, middle of the sole that the forefoot stands on
  std::vector<Vec3d> forefoot;  ///< m, corners of that
};

/// A foot on the floor. It bears weight for the whole motion and must not move.
struct Foot {
  std::string name;            ///< "left_foot"
  std::string node;            ///< node of the exported skeleton that moves with it
  int link = kBaseLink;        ///< that the sole belongs to
  Vec3d centre{};              ///< m, middle of the sole, link frame
  std::vector<Vec3d> outline;  ///< m, corners of the sole, counter-clockwise from above, link frame
  std::optional<Heel> heel{};  ///< none: the foot stays flat
};

/// A node of the skeleton that the body is written to files as; moves with `link`.
struct BodyNode {
  std::string name;       ///< VRM 1.0 humanoid vocabulary in snake_case; empty for an end site
  int parent = -1;        ///< index of an earlier node
  int link = kBaseLink;   ///< that carries the node
  Vec3d point{};          ///< m, the node's origin in the link frame
  bool end_site = false;  ///< the tip of its parent; it carries no motion
};

/// A joint of the robot's file, for motions in the file's own terms.
struct RobotJoint {
  std::string name;     ///< in the file
  int dof = -1;         ///< freedom that is this joint; -1 where the joint keeps one place
  double angle = 0.0;   ///< rad, or m where it slides: the place that such a joint keeps
  double sign = 1.0;    ///< the file's angle is sign · q
  bool slides = false;  ///< the joint moves by a length, not by an angle
};

/// A joint of a robot's file between the world and the root, which hangs on the world by it.
struct RootJoint {
  std::size_t joint = 0;  ///< of RobotFrame::joints
  Transformd origin;      ///< its frame where it keeps its place, in that of the one before
  Vec3d axis{1, 0, 0};    ///< unit vector in that frame: it turns about it, or slides along it
  bool slides = false;    ///< along its axis
};

/// Tells where a robot is whose body was made from its file. The robot's world has z up and
/// x ahead; its origin is shigusa's.
struct RobotFrame {
  std::string root;                ///< the file's root link, or the first below a world
  int link = kBaseLink;            ///< the link that carries it
  Transformd root_in_link;         ///< its frame, in that link's
  std::vector<RobotJoint> joints;  ///< all that move, in the file's order
  /// Six that carry the root from `world` on, in their order; none: it is free.
  std::vector<RootJoint> carriers{};
  Transformd world{};  ///< of such a root: where the world's link is, in the robot's world
};

/// Where a character's file has a node that the body has elsewhere: goals for it are for this
/// point.
struct NodePlace {
  std::string node;  ///< one of the body's
  Vec3d point{};     ///< m, in the frame of that node's link
};

/// Everything that makes a body; BodyModel checks it once and keeps it.
struct BodyDefinition {
  std::string name;          ///< "full_body", or of a character the file's
  double stature = 0.0;      ///< m
  double mass = 0.0;         ///< kg, of the links together
  double load = 0.0;         ///< kg, of them the heaviest that a hand holds
  double lumbar_part = 1.0;  ///< how much the back takes of a bend, beside a man's
  Transformd base;        ///< the base link's frame in the world: +Y up, facing +Z, floor at y = 0
  std::vector<Dof> dofs;  ///< parents before children
  std::vector<LimitCoupling> couplings;  ///< upper limits that grow with other angles
  MassProperties base_mass;              ///< of the base link
  std::vector<MassProperties> masses;    ///< (dofs), of the link that each dof moves
  std::vector<Effector> effectors;       ///< hands, mostly
  std::vector<Foot> feet;                ///< that stand, the base among them where it is one
  std::vector<Capsule> capsules;         ///< what collides
  std::vector<BodyNode> nodes;           ///< of the skeleton that it is written as
  std::vector<double> start;             ///< (dofs) rad, the posture that motions start from
  std::optional<RobotFrame> robot;       ///< of a body from a robot's file
  std::vector<Message> doubts;           ///< what was guessed when the body was made, for a person
  std::vector<NodePlace> places;         ///< of nodes that are no effectors' own
};

/// An articulated body on a fixed base: immutable after construction, shared by all threads.
class BodyModel {
 public:
  /// Checks the definition (parents before children, equal counts, limits in order, feet and
  /// effectors on existing links; PreconditionError otherwise) and takes it over.
  explicit BodyModel(BodyDefinition definition);

  /// Everything that the body was made from.
  [[nodiscard]] const BodyDefinition& definition() const { return definition_; }
  /// The name that its definition has.
  [[nodiscard]] const std::string& name() const { return definition_.name; }
  /// Standing height (m).
  [[nodiscard]] double stature() const { return definition_.stature; }
  /// How much the back takes of a bend, beside a man's.
  [[nodiscard]] double lumbar_part() const { return definition_.lumbar_part; }
  /// Mass of all links together (kg).
  [[nodiscard]] double mass() const { return definition_.mass; }
  /// The heaviest load that a hand holds (kg).
  [[nodiscard]] double load() const { return definition_.load; }
  /// Number of freedoms.
  [[nodiscard]] int dof_count() const { return static_cast<int>(definition_.dofs.size()); }
  /// X_WB, the place of the base link's frame in the world.
  [[nodiscard]] const Transformd& base() const { return definition_.base; }
  /// All freedoms, parents before children.
  [[nodiscard]] std::span<const Dof> dofs() const { return definition_.dofs; }
  /// The freedom of that index, 0..dof_count()-1.
  [[nodiscard]] const Dof& dof(int i) const {
    return definition_.dofs[static_cast<std::size_t>(i)];
  }
  /// Upper limits that grow with other angles.
  [[nodiscard]] std::span<const LimitCoupling> couplings() const { return definition_.couplings; }
  /// The coupling that a freedom's upper limit grows by; null where the limit stays.
  [[nodiscard]] const LimitCoupling* coupling_of(int dof) const;
  /// Mass of a link; kBaseLink is allowed.
  [[nodiscard]] const MassProperties& link_mass(int link) const {
    return link == kBaseLink ? definition_.base_mass
                             : definition_.masses[static_cast<std::size_t>(link)];
  }
  /// The hands, or of a robot the ends of its arms.
  [[nodiscard]] std::span<const Effector> effectors() const { return definition_.effectors; }
  /// The feet that stand.
  [[nodiscard]] std::span<const Foot> feet() const { return definition_.feet; }
  /// The parts that collide.
  [[nodiscard]] std::span<const Capsule> capsules() const { return definition_.capsules; }
  /// Nodes of the skeleton that the body is written to files as.
  [[nodiscard]] std::span<const BodyNode> nodes() const { return definition_.nodes; }
  /// (dofs) rad, the posture that motions start from.
  [[nodiscard]] std::span<const double> start() const { return definition_.start; }
  /// Sentences for a person: guesses that making the body took.
  [[nodiscard]] std::span<const Message> doubts() const { return definition_.doubts; }
  /// Where the robot of a file is; empty of a person.
  [[nodiscard]] const std::optional<RobotFrame>& robot() const { return definition_.robot; }

  /// The dofs that move a link, from the base on; none move kBaseLink.
  [[nodiscard]] std::span<const int> chain(int link) const {
    if (link == kBaseLink) return {};
    const auto k = static_cast<std::size_t>(link);
    return std::span<const int>(chains_).subspan(chain_begin_[k],
                                                 chain_begin_[k + 1] - chain_begin_[k]);
  }
  /// The body as the kernel reads it for a scalar made of T: double or float.
  template <class T>
  [[nodiscard]] const BodyConstants<T>& constants() const {
    if constexpr (std::is_same_v<T, double>) {
      return *constants_;
    } else {
      static_assert(std::is_same_v<T, float>);
      return *constants_float_;
    }
  }

  /// Index of the effector of that name, or of that node, or nothing. Goals can be given for the
  /// effectors, and then for the body's named nodes that can move.
  [[nodiscard]] std::optional<int> find_effector(std::string_view name) const;
  /// Index of a limb's effector by what it is, or nothing.
  [[nodiscard]] std::optional<int> find_effector(JointKind joint, Side side) const;
  /// The node of that name; null where the body has none.
  [[nodiscard]] const BodyNode* find_node(std::string_view name) const;
  /// Length of an effector's limb (m): the distances along its chain, stretched out.
  [[nodiscard]] double limb_length(const Effector& effector) const;
  /// The effector of that index, 0..effector_count()-1; the hands come first.
  [[nodiscard]] const Effector& effector(int i) const {
    const auto k = static_cast<std::size_t>(i);
    const std::size_t hands = definition_.effectors.size();
    return k < hands ? definition_.effectors[k] : further_[k - hands];
  }
  /// Number of the points that goals can be given for.
  [[nodiscard]] int effector_count() const {
    return static_cast<int>(definition_.effectors.size() + further_.size());
  }
  /// Index of the dof of that name, or nothing.
  [[nodiscard]] std::optional<int> find_dof(std::string_view name) const;
  /// Index of that freedom of that joint; of limbs on one side. Nothing where the body lacks it.
  [[nodiscard]] std::optional<int> find_dof(JointKind joint, FreedomKind freedom,
                                            std::optional<Side> side = {}) const;
  /// Indices of that freedom of that joint on all sides, in their order.
  [[nodiscard]] std::vector<int> dofs_of(JointKind joint, FreedomKind freedom) const;
  /// True when moving the dof moves the link.
  [[nodiscard]] bool moves(int dof, int link) const {
    return link != kBaseLink && ancestry_[static_cast<std::size_t>(link) * definition_.dofs.size() +
                                          static_cast<std::size_t>(dof)] != 0;
  }

 private:
  BodyDefinition definition_;
  std::vector<Effector> further_;
  std::vector<char> ancestry_;            // (links × dofs) 1 where the dof moves the link
  std::vector<int> chains_;               // of all links, one after the other
  std::vector<std::size_t> chain_begin_;  // (links + 1) where each begins
  // shared by the copies of a body, as they never change
  std::shared_ptr<const BodyConstants<double>> constants_;
  std::shared_ptr<const BodyConstants<float>> constants_float_;
};

/// The upper limit (rad) of a dof at the given angles (dofs, rad), with what the body's couplings
/// add.
[[nodiscard]] double upper_limit(const BodyModel& body, int dof, std::span<const double> angles);

/// The body with these places in the places of its own.
[[nodiscard]] BodyModel with_places(const BodyModel& body, std::vector<NodePlace> places);

/// The sex that tables of masses and strengths are taken for.
enum class Sex {
  male,    ///< of the tables of men
  female,  ///< of the tables of women
};
/// The words of Sex.
template <>
inline constexpr std::array kEnumWords<Sex>{EnumWord{Sex::male, "male"},
                                            EnumWord{Sex::female, "female"}};

/// A standing person's build.
struct BodyBuild {
  double stature = 1.741;   ///< m, 0.5..2.5
  double mass = 73.0;       ///< kg, 2..300
  Sex sex = Sex::male;      ///< of the tables
  Side base = Side::right;  ///< the foot that bears the body
  bool heels = false;       ///< they may lift; of human_body
};

/// Standing height (m) of the group's mean.
[[nodiscard]] double mean_stature(Sex sex);

/// Mass in kg of a person of that stature with the body-mass index of the group's mean.
[[nodiscard]] double default_mass(double stature, Sex sex);

/// Standing height (m) that 5, 50 or 95 of a hundred people do not exceed, by the names "p5", "p50"
/// and "p95"; nothing for other names. Source: C. Gordon et al., 1988 Anthropometric Survey of U.S.
/// Army Personnel, Natick TR-89/044 (1989), stature.
[[nodiscard]] std::optional<double> stature_percentile(std::string_view name, Sex sex);

}  // namespace shigusa
