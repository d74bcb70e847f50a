// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "human/human_frames.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// The dof that turns a forearm about its own axis, at the body's elbow.
struct ForearmTurn {
  int dof = -1;
  // Turn of the forearm's link about its y axis, from the dof's zero (rad).
  [[nodiscard]] double angle(const Kinematics<double>& placed) const;
};
[[nodiscard]] std::optional<ForearmTurn> forearm_turn(const BodyModel& body, HumanoidBone bone);

// Twists of the limbs of a rig with twist bones, frame by frame: the angles (rad) about the line
// from a limb's joint to the next one, relative to the rest posture,
//
//   upper limb:  θ of the limb against its carrier (clavicle or trunk, pelvis)
//   lower limb:  ψ of the forearm at its elbow, φ of hand or foot against the limb.
//
// At a share s of the limb's length a bone is turned against the body's limb by -(1 - s) θ, or by
// -ψ + s (ψ + φ). θ and φ are the twists of a swing-twist decomposition R = S T: of an arm from
// stretched out sideways, of a leg from hanging, so that the swing stays away from half a turn.
// Source: P. Dobrowolski, "Swing-twist decomposition in Clifford algebra", 2015.
class LimbTwists {
 public:
  // `rest` and `start`: the frames of the rig's two postures; `standing`: the body in its start
  // posture.
  LimbTwists(const BodyModel& body, const Rig& rig, const HumanFrames& rest,
             const HumanFrames& start, const Kinematics<double>& standing);

  // Updates the limbs for this frame; angles continue from the frame before without a jump.
  void show(const Kinematics<double>& now);

  // The index for turn() of the limb whose twist bones belong to this bone, or -1.
  [[nodiscard]] int find(HumanoidBone bone) const;

  // The displacement (world) of a bone at that share of the limb relative to the body's limb.
  [[nodiscard]] Transformd turn(int limb, double share) const;

 private:
  struct Limb {
    TwistSegment segment;
    int link = kBaseLink;
    int above = kBaseLink;   // link that carries an upper limb
    int beyond = kBaseLink;  // link of the next bone
    Vec3d joint{};           // m, link frame
    Vec3d axis{};            // unit, link frame, towards the joint
    Mat3d reference{};       // of an upper limb against its carrier
    double rest = 0.0;       // θ in the rest posture
    Mat3d start{};           // of the next bone against a lower limb
    std::optional<ForearmTurn> forearm{};
    double at_joint = 0.0;  // θ or ψ
    double at_end = 0.0;    // φ
    Transformd placed{};    // of the link
  };

  std::vector<Limb> limbs_;
};

}  // namespace shigusa
