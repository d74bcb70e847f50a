// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <string>
#include <vector>

#include "body/joint_name.hpp"
#include "human_frames.hpp"
#include "landmark_points.hpp"
#include "part_shapes.hpp"
#include "segment_mass.hpp"

namespace shigusa {

[[nodiscard]] inline std::size_t index_of(Side side) { return side == Side::left ? 0 : 1; }

// Builds a person's body definition link by link, each attached to those before it.
class HumanBuilder {
 public:
  HumanBuilder(const Landmarks& person, const HumanSettings& settings, std::vector<Message> doubts);
  PosedBody build();

 private:
  // A link in the start posture.
  struct Part {
    int link = kBaseLink;
    Mat3d frame;        // R_WL
    Vec3d origin{};     // m, world
    double from = 0.0;  // for a piece of the trunk: where it begins, as a share of hips – C7
  };
  // A degree of freedom of a joint.
  struct Freedom {
    const char* name;
    Axis axis;
    double sign;
    JointLimits limits;
    double start = 0.0;
    double give = 1.0;
  };
  // A joint of a leg, with the frames of the segments above and below it.
  struct LegJoint {
    const char* name;
    Vec3d at;
    Mat3d above;
    Mat3d below;
    std::vector<Freedom> freedoms;
  };

  [[nodiscard]] bool whole() const { return settings_.extent == BodyExtent::human; }
  // whether the chain begins at the distal end of that leg
  [[nodiscard]] bool climbs(Side side) const { return side == base_side_; }

  // a joint at a point of the part; its link's frame in the start posture is `frame`
  Part add_joint(const std::string& joint, const Part& on, const Vec3d& at, const Mat3d& frame,
                 const std::vector<Freedom>& freedoms);

  // legs and arms
  [[nodiscard]] std::vector<LegJoint> leg_joints(Side side) const;
  void add_leg(Side side);
  void set_leg_masses(Side side);
  void add_seat(Side side, const Part& thigh);
  void add_arm(Side side);
  void add_foot(Side side, const Part& part);
  [[nodiscard]] Vec3d to_below_ankle(const SoleOutline& sole, Side side, const Part& part) const;
  [[nodiscard]] Heel heel_of(Side side, const Part& part) const;
  [[nodiscard]] int freedom(const std::string& name) const;
  // transforms a point of the start posture to the part's frame
  [[nodiscard]] static Vec3d in_link(const Vec3d& point, const Part& part);

  // trunk and head
  void add_trunk();
  void add_spine();
  void add_neck();
  [[nodiscard]] Part add_clavicle(Side side);

  // skeleton nodes, for drawing and export
  void add_nodes();
  [[nodiscard]] int add_trunk_nodes(int hips);
  void add_stubs(int hips, int chest);
  void add_arm_nodes(Side side, int chest);
  void add_leg_nodes(Side side, int hips);
  int add_node(const std::string& name, int parent, const Part& part, const Vec3d& point,
               bool end_site = false);

  // adds the collision shape of a part of the person, fixed to `on`
  void add_capsule(BodyPart part, const Part& on);
  void add_trunk_capsules();
  void add_leg_capsules(Side side);
  void add_arm_capsules(Side side);
  void set_mass(const Part& part, const LinkMass& mass);
  void hold_start_posture();

  const Landmarks& person_;
  const HumanSettings& settings_;
  HumanFrames frames_;
  const SegmentTable& table_;
  SegmentMasses masses_;
  BodyDefinition body_;
  std::vector<double> home_;  // (dofs) rad
  std::vector<Message> doubts_;
  Side base_side_ = Side::right;
  bool other_stands_ = false;
  double strength_ = 1.0;
  double leg_strength_ = 1.0;
  std::vector<Part> trunk_;  // from the pelvis to the part with arms and neck: one if rigid
  Part neck_;
  Part head_;
  struct ArmParts {
    Part clavicle, upper, fore, hand;
  };
  struct LegParts {
    Part thigh, shank, foot;
    Part toes;  // the foot, or its forefoot if heels lift
  };
  ArmParts arms_[2];
  LegParts legs_[2];
  Vec3d shift_{};  // from the right leg's mass to the left leg's (half extent)
};

}  // namespace shigusa
