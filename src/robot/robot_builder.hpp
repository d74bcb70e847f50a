// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "body/skin.hpp"
#include "core/index.hpp"
#include "robot/robot.hpp"
#include "robot_joints.hpp"

namespace shigusa {

// Least distance from wrist to fingertip, as a share of the stature.
inline constexpr double kLeastHand = 0.01;

// Head of a robot in the posture of PlacedRobot (m, world).
struct RobotHead {
  Vec3d joint{};  // pivot of the head
  Vec3d top{};
  int group = -1;          // group of links that it moves with
  bool own_joint = false;  // whether the file has a joint for it
};

// Sole of a robot's foot in the posture of PlacedRobot: corners in its world (m), at one height,
// counter-clockwise from above.
struct RobotSole {
  std::array<Vec3d, 4> corners;
  bool guessed = false;  // by a person's proportions
};

// `links`: links rigidly connected to the foot; `ankle`: centre of the ankle joint.
[[nodiscard]] RobotSole robot_sole(const Robot& robot, const PlacedRobot& placed,
                                   const std::vector<int>& links, const Vec3d& ankle,
                                   double stature);

// Builds a body from a robot, link by link. Positions are in shigusa's world at zero angles, where
// the frames of all links are parallel.
class RobotBuilder {
 public:
  RobotBuilder(const Robot& robot, const HumanoidMap& map, std::optional<double> mass)
      : robot_(robot), map_(map), spread_(mass) {}

  [[nodiscard]] Result<PosedBody> build();

 private:
  static constexpr std::size_t kRight = 1;  // index among left and right of the standing side

  // A moving joint of the body.
  struct Moving {
    const PersonJoint* person = nullptr;
    int dof = -1;
    int outer = -1;  // group away from the pelvis
    int inner = -1;
  };
  // interprets the robot as a person: bones, joints, groups of links
  Result<void> understand();
  void list_moving();

  // Bends fixed joints whose limits exclude 0 as little as possible; returns whether there was one.
  bool bend_still_joints();

  // Collects links without relative motion into groups.
  void find_groups();

  [[nodiscard]] const Vec3d& centre(const PersonJoint& joint) const;

  // The flexing joint of a part, else its first one.
  static const PersonJoint& hinge(const PersonLimb& limb, std::size_t part);
  [[nodiscard]] Vec3d hip(std::size_t side) const { return centre(hinge(person_.legs[side], 0)); }
  [[nodiscard]] Vec3d knee(std::size_t side) const { return centre(hinge(person_.legs[side], 1)); }
  [[nodiscard]] Vec3d ankle(std::size_t side) const { return centre(hinge(person_.legs[side], 2)); }
  [[nodiscard]] Vec3d shoulder(std::size_t side) const;
  [[nodiscard]] Vec3d elbow(std::size_t side) const { return centre(hinge(person_.arms[side], 2)); }
  [[nodiscard]] Vec3d wrist(std::size_t side) const;

  // Determines stature, floor and the base's placement.
  void measure();

  [[nodiscard]] const Vec3d& origin(int link) const;

  // Adds the tree from the standing foot, depth first, the pelvis before other children of a link.
  void add_links();
  void add_dof(Moving& moving, int group, int parent);
  std::string unique(const std::string& name);
  Result<void> add_masses();
  // Distributes a person's mass (kg) over the links of a robot without masses.
  void spread_mass(double mass);
  [[nodiscard]] bool is_within_joint(std::size_t group) const;

  [[nodiscard]] int dof_of(const PersonJoint& joint) const;
  [[nodiscard]] int link_of(int robot_link) const {
    return link_of_[static_cast<std::size_t>(group_[index(robot_link)])];
  }
  [[nodiscard]] Vec3d local(int link, const Vec3d& world) const { return world - origin(link); }

  void add_foot(std::size_t side);

  // The frame in the hand that is the effector.
  [[nodiscard]] int hand_link(std::size_t side) const;
  void add_hand(std::size_t side);
  [[nodiscard]] RobotHead head() const;

  // Adds collision capsules: from the links' collision shapes, else their visual ones, else, if
  // there are only meshes, from a person of that stature.
  void add_capsules();
  void add_part(BodyPart part, int group, const Landmarks& person);
  void add_trunk_parts(const Landmarks& person, const std::vector<int>& groups);
  void add_limb_parts(std::size_t side, const Landmarks& person);
  // Landmarks of the robot as a person at zero angles; without the waist.
  [[nodiscard]] Landmarks landmarks(const std::vector<SkinVertex>& skin) const;
  // Adds the joints of the waist, coinciding ones as one; returns the groups of links above them,
  // the pelvis's first.
  [[nodiscard]] std::vector<int> add_waist(Landmarks& person) const;
  [[nodiscard]] Vec3d fingertip(std::size_t side, const std::vector<SkinVertex>& skin) const;
  // Points of all links' shapes; the node of each is its link.
  [[nodiscard]] std::vector<SkinVertex> skin() const;
  // Points without those of limbs less than half covered by shapes: a motor or a sensor does not
  // determine the limb's shape.
  [[nodiscard]] std::vector<SkinVertex> without_stubs(const Landmarks& person,
                                                      std::vector<SkinVertex> skin) const;
  [[nodiscard]] PartShapes fitted(const Landmarks& person,
                                  const std::vector<SkinVertex>& skin) const;
  // The links that a part's last joint moves; `part` as in PersonLimb::begins.
  [[nodiscard]] int group_before(const PersonLimb& limb, std::size_t part) const;

  // Adds nodes at the joints, from the pelvis on, so that a skeleton of them moves as the robot
  // does.
  void add_nodes();

  // Gives bending joints a person's names; links of effectors and feet keep theirs.
  void name_nodes();
  int add_node(const std::string& name, int parent, int group, const Vec3d& world,
               bool end_site = false);
  std::string free_name(std::string name);
  void add_chain(const std::vector<PersonJoint>& joints);
  void add_head();
  void add_hand_nodes(std::size_t side);
  void add_foot_nodes(std::size_t side);
  void add_robot_frame();
  // Finds a world link above the root: an ancestor in a chain of links without mass or shape.
  void find_world();
  void tell_of_world(const std::string& world, const std::string& bolt,
                     const std::vector<std::string>& floating);
  void tell();

  Robot robot_;
  const HumanoidMap& map_;
  std::optional<double> spread_;  // kg
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
  std::vector<std::string> weak_;      // dofs without effort
  std::vector<std::string> massless_;  // links
  std::vector<std::string> carrying_;  // joints between the world and the root
  BodyDefinition body_;
  std::vector<double> home_;  // (dofs) rad
  std::vector<Message> doubts_;
  RobotFrame frame_;
};

}  // namespace shigusa
