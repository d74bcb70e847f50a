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

/// The limb that a joint belongs to.
enum class LimbKind {
  trunk,  ///< pelvis, spine, neck and head
  arm,    ///< from the clavicle to the hand
  leg,    ///< from the hip to the toes
};

/// The anatomical kind of a joint or of an effector.
enum class JointKind {
  other,        ///< no anatomical counterpart, as in robots
  hips,         ///< the pelvis
  spine,        ///< the lowest joint of the back
  chest,        ///< the joint above it
  upper_chest,  ///< the joint above that
  neck,         ///< above the shoulders
  head,         ///< joint between neck and skull
  clavicle,     ///< joint of the clavicle with the breastbone
  shoulder,     ///< root of the arm
  elbow,        ///< bends the arm
  wrist,        ///< root of the hand
  hand,         ///< the grip, an effector
  hip,          ///< root of the leg
  knee,         ///< bends the leg
  ankle,        ///< root of the foot
  toes,         ///< joint that bends where a heel lifts
  foot,         ///< the sole, an effector
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
/// The joints of the back, from the lowest up.
inline constexpr std::array kBackJoints{JointKind::spine, JointKind::chest, JointKind::upper_chest};

/// The anatomical movement of a joint's degree of freedom.
enum class FreedomKind {
  other,        ///< no anatomical name; also the value for an effector
  flexion,      ///< bends
  abduction,    ///< moves a limb away from the midline
  lateral,      ///< bends the trunk to the side
  rotation,     ///< turns about the segment's long axis
  inversion,    ///< turns the sole inwards
  elevation,    ///< lifts the shoulder
  protraction,  ///< moves the shoulder forwards
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

/// The anatomical place of a degree of freedom or an effector: "left_hip.flexion" is the dof
/// "flexion" of the joint "hip" of the left leg.
struct JointPlace {
  std::optional<Side> side{};                     ///< empty for the trunk and for midline parts
  LimbKind limb = LimbKind::trunk;                ///< the limb it belongs to
  JointKind joint_kind = JointKind::other;        ///< kind of `joint`
  FreedomKind freedom_kind = FreedomKind::other;  ///< kind of `freedom`
  std::string joint{};                            ///< "hip", "upper_chest", "hand"
  std::string freedom{};                          ///< "flexion"; empty for an effector

  /// Whether the place is this dof of this joint, on either side.
  [[nodiscard]] bool is(JointKind a_joint, FreedomKind a_freedom) const {
    return joint_kind == a_joint && freedom_kind == a_freedom;
  }
};

/// Parses the name of a joint, dof, node or effector, such as "left_hip.flexion", into its place.
[[nodiscard]] JointPlace parse_joint_name(std::string_view name);

/// The constants of a body as arrays of T for the motion kernel; opaque.
template <class T>
struct BodyConstants;

/// Index of the fixed base link: the foot that carries the body, its forefoot where heels lift, or
/// the right thigh of a seated person. Every other link has the index of the dof that moves it.
inline constexpr int kBaseLink = -1;

/// One rotational degree of freedom and the link that it moves. At zero angles every link frame has
/// the base link's orientation, so that each joint axis is a coordinate axis or, in robots, an axis
/// of a frame turned against the link's (`turn`).
struct Dof {
  std::string joint;  ///< "right_hip"
  std::string name;   ///< "right_hip.flexion"
  /// Index of the link that carries the joint: an earlier dof, or kBaseLink.
  int parent = kBaseLink;
  Vec3d offset{};       ///< m, the joint's centre in the parent's link frame
  Axis axis = Axis::x;  ///< rotation axis in the parent's link frame
  double sign = 1.0;    ///< +1 or -1, so that a positive angle is the anatomical direction
  /// R_LA of a slanting axis, which is `axis` of the frame A; empty: A is L.
  std::optional<Mat3d> turn{};
  double lower = -kPi;           ///< rad, hard limit
  double upper = kPi;            ///< rad, hard limit
  double torque_positive = 1.0;  ///< N·m, strength towards larger angles, > 0
  double torque_negative = 1.0;  ///< N·m, strength towards smaller angles, > 0
  /// Compliance relative to other dofs of the same weight, in (0, 1]: below 1 for a dof that moves
  /// last (the toes).
  double give = 1.0;
  JointPlace part{};  ///< parsed from `name` by BodyModel
};

/// A coupling of an upper limit to another angle: hamstrings let the hip flex further when the knee
/// bends. upper(q) = Dof::upper + gain · clamp(q[driver] / driver_full, 0, 1).
struct LimitCoupling {
  int dof = 0;               ///< index of the dof whose upper limit grows
  int driver = 0;            ///< index of the dof that drives the limit
  double gain = 0.0;         ///< rad, the largest growth
  double driver_full = 1.0;  ///< rad, > 0: driver angle of the full growth
};

/// Mass, centre of mass and inertia of one link.
struct MassProperties {
  double mass = 0.0;                               ///< kg
  Vec3d com{};                                     ///< m, in the link frame
  Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  ///< kg·m², about the com, link axes
};

/// A point on a link that goals can be given for (end effector).
struct Effector {
  std::string name;   ///< "right_hand"
  std::string node;   ///< exported skeleton's node with its origin at the point: "right_hand_grip"
  int link = 0;       ///< index of the link that carries the point
  Vec3d point{};      ///< m, in the link frame
  int limb_root = 0;  ///< first dof of the effector's limb: the shoulder's for a hand
  JointPlace part{};  ///< parsed from `name` by BodyModel
};

/// A collision shape: a segment with a radius at each end, fixed to `link`.
struct Capsule {
  std::string name;           ///< "trunk"
  int link = kBaseLink;       ///< index of the link that carries the segment
  Vec3d from{};               ///< m, link frame
  Vec3d to{};                 ///< m, link frame
  double radius = 0.0;        ///< m, > 0, at `from`
  std::optional<Side> leg{};  ///< side of the leg that it belongs to; empty elsewhere
  double to_radius = radius;  ///< m, > 0, at `to`; linear in between
  double give = 0.0;          ///< m, depth to which soft tissue yields without a collision
  bool grown_on = false;  ///< an arm's capsule that begins inside the trunk; the two are not tested
                          ///< for collision
  /// Part of a thing in a hand, whose depth in the body is that of its HeldShape.
  bool of_thing = false;
};

/// A thing in a hand or a part of one, for collisions with the body: a box with round edges that
/// moves with a link.
struct HeldShape {
  std::string name;      ///< name of the thing
  int link = kBaseLink;  ///< index of the link that carries it
  Vec3d middle{};        ///< m, link frame
  Quatd turn{};          ///< R_LT, its own axes in the link frame
  Vec3d size{};          ///< m, its sides without the radius
  double radius = 0.0;   ///< m, added to the size on all sides
};

/// Bend of the toes (rad) at which the heel bears no more load; below it the load share falls with
/// the bend.
inline constexpr double kHeelLifts = radians(3.0);
/// A heel that can lift. The planted link is then the forefoot, and the rest of the foot turns
/// about the toes' joint. Points are in the frame of the foot's link.
struct Heel {
  int toes = 0;                 ///< dof of the toes: 0 with the heel down, growing as it lifts
  int ankle = 0;                ///< dof of the ankle's dorsiflexion; the toes bend beyond its limit
  Vec3d back{};                 ///< m, rearmost point of the sole, with the heel down
  Vec3d forefoot_centre{};      ///< m, middle of the forefoot's sole
  std::vector<Vec3d> forefoot;  ///< m, corners of the forefoot's sole
};

/// A planted foot, or the thigh of a seated person: it bears weight for the whole motion and must
/// not move.
struct Foot {
  std::string name;            ///< "left_foot"
  std::string node;            ///< exported skeleton's node that moves with it
  int link = kBaseLink;        ///< index of the link that carries the sole
  Vec3d centre{};              ///< m, middle of the sole, link frame
  std::vector<Vec3d> outline;  ///< m, corners of the sole, counter-clockwise from above, link frame
  std::optional<Heel> heel{};  ///< empty: the foot stays flat
};

/// A node of the skeleton that files of the body hold; it moves with `link`.
struct BodyNode {
  std::string name;       ///< VRM 1.0 humanoid vocabulary in snake_case; empty for an end site
  int parent = -1;        ///< index of an earlier node; -1 for a root
  int link = kBaseLink;   ///< index of the link that carries the node
  Vec3d point{};          ///< m, the node's origin in the link frame
  bool end_site = false;  ///< marks the tip of its parent; without motion of its own
};

/// A joint of a robot's file and its mapping to the body, for writing motions in the file's terms.
struct RobotJoint {
  std::string name;     ///< the file's name of the joint
  int dof = -1;         ///< index of the corresponding dof; -1 for a joint kept at a constant value
  double angle = 0.0;   ///< rad, or m if it slides: the constant value where dof is -1
  double sign = 1.0;    ///< factor from the dof's angle q to the file's angle, +1 or -1
  bool slides = false;  ///< prismatic: the value is a length
};

/// A joint of a robot's file between the world and the root link.
struct RootJoint {
  std::size_t joint = 0;  ///< index into RobotFrame::joints
  Transformd origin;      ///< the joint frame at value 0, in the previous joint's frame
  Vec3d axis{1, 0, 0};  ///< unit vector of the joint frame: rotation axis, or direction of sliding
  bool slides = false;  ///< prismatic: slides along its axis
};

/// The pose of a robot's root link, for a body made from a robot's file. The robot's world has z up
/// and x ahead; its origin is shigusa's.
struct RobotFrame {
  std::string root;      ///< name of the file's root link, or of the first link below a world link
  int link = kBaseLink;  ///< index of the body's link that carries the root link
  Transformd root_in_link;         ///< pose of the root link's frame in that link's frame
  std::vector<RobotJoint> joints;  ///< all movable joints, in the file's order
  /// The six joints from `world` to the root link, outermost first; empty: the root floats
  /// freely.
  std::vector<RootJoint> carriers{};
  Transformd world{};  ///< pose of the file's world link in the robot's world; used with carriers
};

/// A node whose position in the character's file differs from the body's; goals for the node refer
/// to this point.
struct NodePlace {
  std::string node;  ///< name of a node of the body
  Vec3d point{};     ///< m, the file's position in the frame of the node's link
};

/// The complete description of a body. BodyModel checks it once and keeps it.
struct BodyDefinition {
  std::string name;          ///< "full_body", or the name of the character's file
  double stature = 0.0;      ///< m, standing height
  double mass = 0.0;         ///< kg, of all links together
  double lumbar_part = 1.0;  ///< the back's share of a bend, relative to a man's
  Transformd base;  ///< X_WB, the base link's frame in the world: +Y up, facing +Z, floor at y = 0
  std::vector<Dof> dofs;                 ///< parents before children
  std::vector<LimitCoupling> couplings;  ///< upper limits that grow with other angles
  MassProperties base_mass;              ///< mass of the base link
  std::vector<MassProperties> masses;    ///< (dofs), mass of the link that each dof moves
  std::vector<Effector> effectors;       ///< the hands, or the ends of a robot's arms
  std::vector<Foot> feet;                ///< planted feet, the base among them if it is a foot
  std::vector<Capsule> capsules;         ///< collision shapes
  std::vector<HeldShape> held;           ///< things in the hands
  std::vector<BodyNode> nodes;           ///< the exported skeleton, parents before children
  std::vector<NodePlace> places;         ///< positions of nodes that differ from the file's
  bool robot = false;  ///< a robot, whose strengths are effort limits, exactly known
};

/// An articulated body on a fixed base: immutable after construction, shared by all threads.
class BodyModel {
 public:
  /// Checks the definition (parents before children, equal counts, limits in order, feet and
  /// effectors on existing links; PreconditionError otherwise) and takes it over.
  explicit BodyModel(BodyDefinition definition);

  /// The definition that the body was made from.
  [[nodiscard]] const BodyDefinition& definition() const { return definition_; }
  /// Name of the body.
  [[nodiscard]] const std::string& name() const { return definition_.name; }
  /// Standing height (m).
  [[nodiscard]] double stature() const { return definition_.stature; }
  /// The back's share of a bend, relative to a man's.
  [[nodiscard]] double lumbar_part() const { return definition_.lumbar_part; }
  /// Mass of all links together (kg).
  [[nodiscard]] double mass() const { return definition_.mass; }
  /// Whether it is a robot, whose strengths are effort limits, exactly known.
  [[nodiscard]] bool is_robot() const { return definition_.robot; }
  /// Number of degrees of freedom.
  [[nodiscard]] int dof_count() const { return static_cast<int>(definition_.dofs.size()); }
  /// X_WB, the pose of the base link's frame in the world.
  [[nodiscard]] const Transformd& base() const { return definition_.base; }
  /// All degrees of freedom, parents before children.
  [[nodiscard]] std::span<const Dof> dofs() const { return definition_.dofs; }
  /// The dof at an index, 0..dof_count()-1.
  [[nodiscard]] const Dof& dof(int i) const {
    return definition_.dofs[static_cast<std::size_t>(i)];
  }
  /// The couplings of upper limits to other angles.
  [[nodiscard]] std::span<const LimitCoupling> couplings() const { return definition_.couplings; }
  /// The coupling of a dof's upper limit; null for a constant limit.
  [[nodiscard]] const LimitCoupling* coupling_of(int dof) const;
  /// Mass of a link; kBaseLink is allowed.
  [[nodiscard]] const MassProperties& link_mass(int link) const {
    return link == kBaseLink ? definition_.base_mass
                             : definition_.masses[static_cast<std::size_t>(link)];
  }
  /// The hands, or the ends of a robot's arms. Further points for goals: see effector().
  [[nodiscard]] std::span<const Effector> effectors() const { return definition_.effectors; }
  /// The planted feet.
  [[nodiscard]] std::span<const Foot> feet() const { return definition_.feet; }
  /// The collision shapes.
  [[nodiscard]] std::span<const Capsule> capsules() const { return definition_.capsules; }
  /// The nodes of the exported skeleton, parents before children.
  [[nodiscard]] std::span<const BodyNode> nodes() const { return definition_.nodes; }

  /// Indices of the dofs that move a link, from the base outwards; empty for kBaseLink.
  [[nodiscard]] std::span<const int> chain(int link) const {
    if (link == kBaseLink) return {};
    const auto k = static_cast<std::size_t>(link);
    return std::span<const int>(chains_).subspan(chain_begin_[k],
                                                 chain_begin_[k + 1] - chain_begin_[k]);
  }
  /// The body's constants in the element type T: double or float.
  template <class T>
  [[nodiscard]] const BodyConstants<T>& constants() const {
    if constexpr (std::is_same_v<T, double>) {
      return *constants_;
    } else {
      static_assert(std::is_same_v<T, float>);
      return *constants_float_;
    }
  }

  /// Index of the effector with this name, or at the node with this name, or nothing. Goals can be
  /// given for the effectors and for each named node that can move.
  [[nodiscard]] std::optional<int> find_effector(std::string_view name) const;
  /// Index of a limb's effector by its kind and side, or nothing.
  [[nodiscard]] std::optional<int> find_effector(JointKind joint, Side side) const;
  /// The node with this name, or null.
  [[nodiscard]] const BodyNode* find_node(std::string_view name) const;
  /// Length of an effector's limb (m): the sum of the distances along its chain.
  [[nodiscard]] double limb_length(const Effector& effector) const;
  /// The effector at an index, 0..effector_count()-1: those of effectors() first, then the further
  /// nodes that goals can be given for.
  [[nodiscard]] const Effector& effector(int i) const {
    const auto k = static_cast<std::size_t>(i);
    const std::size_t hands = definition_.effectors.size();
    return k < hands ? definition_.effectors[k] : further_[k - hands];
  }
  /// Number of the points that goals can be given for.
  [[nodiscard]] int effector_count() const {
    return static_cast<int>(definition_.effectors.size() + further_.size());
  }
  /// Index of the dof with this name, or nothing.
  [[nodiscard]] std::optional<int> find_dof(std::string_view name) const;
  /// Index of a dof by joint, movement and, for limbs, side; nothing if the body lacks it.
  [[nodiscard]] std::optional<int> find_dof(JointKind joint, FreedomKind freedom,
                                            std::optional<Side> side = {}) const;
  /// Indices of a joint's dof on all sides, ascending.
  [[nodiscard]] std::vector<int> dofs_of(JointKind joint, FreedomKind freedom) const;
  /// Whether the dof moves the link.
  [[nodiscard]] bool moves(int dof, int link) const {
    return link != kBaseLink && ancestry_[static_cast<std::size_t>(link) * definition_.dofs.size() +
                                          static_cast<std::size_t>(dof)] != 0;
  }

 private:
  BodyDefinition definition_;
  std::vector<Effector> further_;
  std::vector<char> ancestry_;            // (links × dofs) 1 where the dof moves the link
  std::vector<int> chains_;               // chains of all links, concatenated
  std::vector<std::size_t> chain_begin_;  // (links + 1) start of each chain
  // immutable, hence shared by copies of a body
  std::shared_ptr<const BodyConstants<double>> constants_;
  std::shared_ptr<const BodyConstants<float>> constants_float_;
};

/// A box with round edges of a thing in a hand.
struct HeldPart {
  Vec3d offset{};       ///< m, its middle from the thing's, along the thing's axes
  Vec3d size{};         ///< m, sides along the thing's axes, without the radius
  double radius = 0.0;  ///< m, added to the size on all sides

  /// Whether both are the same.
  bool operator==(const HeldPart&) const = default;
};

/// A load that a hand holds: a mass at an effector's point, or its share of a rigid thing.
struct HeldLoad {
  int effector = 0;               ///< index of the effector, see BodyModel::effector
  double mass = 0.0;              ///< kg, 0..kLoadMax
  Vec3d centre{};                 ///< m, link frame: centre of mass from the effector's point
  Quatd turn{};                   ///< R_LT, the thing's own axes in the link frame
  Vec3d inertia{};                ///< kg·m², about the centre of mass, along the thing's axes
  std::string name{};             ///< name of the thing in collisions
  Vec3d middle{};                 ///< m, link frame: middle of the thing from the effector's point
  std::vector<HeldPart> parts{};  ///< its form in collisions; empty: none are tested

  /// Whether both are the same.
  bool operator==(const HeldLoad&) const = default;
};

/// The posture, the velocities and the loads with which a motion begins or ends.
struct State {
  std::vector<double> angles{};      ///< (dofs) rad
  std::vector<double> velocities{};  ///< (dofs) rad/s; empty: at rest
  std::vector<HeldLoad> held{};      ///< loads in the hands, to which those of goals are added

  /// Whether both are the same.
  bool operator==(const State&) const = default;
};

/// A body with the state in which it was built; it can be passed where a body is expected.
struct PosedBody {
  BodyModel body;                     ///< the body, of no posture
  State home{};                       ///< the state in which it was built, standing or sitting
  std::vector<Message> doubts{};      ///< warnings for the user: guesses made while building it
  std::optional<RobotFrame> robot{};  ///< joints of the robot's file; empty for a person

  /// The body alone, which lives as long as this.
  operator const BodyModel&() const { return body; }
};

/// The upper limit (rad) of a dof at the given angles (dofs, rad), couplings included.
[[nodiscard]] double upper_limit(const BodyModel& body, int dof, std::span<const double> angles);

/// A copy of the body with other NodePlaces in place of its own.
[[nodiscard]] BodyModel with_places(const BodyModel& body, std::vector<NodePlace> places);

/// The sex that selects the tables of masses and strengths.
enum class Sex {
  male,    ///< tables of men
  female,  ///< tables of women
};
/// The words of Sex.
template <>
inline constexpr std::array kEnumWords<Sex>{EnumWord{Sex::male, "male"},
                                            EnumWord{Sex::female, "female"}};

inline constexpr double kStatureMin = 0.5;  ///< smallest stature, m
/// The greatest stature, m.
inline constexpr double kStatureMax = 2.5;
inline constexpr double kMassMin = 2.0;  ///< smallest mass, kg
/// The greatest mass, kg.
inline constexpr double kMassMax = 300.0;

/// A standing person's build.
struct BodyBuild {
  double stature = 1.741;   ///< m, kStatureMin..kStatureMax
  double mass = 73.0;       ///< kg, kMassMin..kMassMax
  Sex sex = Sex::male;      ///< tables of masses and strengths
  Side base = Side::right;  ///< foot that is the fixed base
  bool heels = false;       ///< heels may lift; human_body only
};

/// Mean standing height (m) of the sex.
[[nodiscard]] double mean_stature(Sex sex);

/// Mass (kg) of a person of a stature (m) at the mean body-mass index of the sex.
[[nodiscard]] double default_mass(double stature, Sex sex);

/// Standing height (m) at a percentile: "p5", "p50" or "p95"; nothing for other names. Source: C.
/// Gordon et al., 1988 Anthropometric Survey of U.S. Army Personnel, Natick TR-89/044 (1989),
/// stature.
[[nodiscard]] std::optional<double> stature_percentile(std::string_view name, Sex sex);

}  // namespace shigusa
