// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "human/human_frames.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/rig.hpp"

namespace shigusa {

// The freedom that turns a forearm about itself, which the body has at its elbow.
struct ForearmTurn {
  int dof = -1;
  // of the forearm's link, about its y axis, from where the freedom is 0 (rad)
  [[nodiscard]] double angle(const Kinematics<double>& placed) const;
};
[[nodiscard]] std::optional<ForearmTurn> forearm_turn(const BodyModel& body, HumanoidBone bone);

// How the limbs of a rig with twist bones are twisted, frame by frame: the angles (rad) about the
// line from a limb's joint to the next one, since the posture at rest,
//
//   upper limb:  θ of the limb against what it hangs on (clavicle or trunk, pelvis)
//   lower limb:  ψ of the forearm at its elbow, φ of hand or foot against the limb.
//
// At a share s of the limb's length a bone is turned against the body's limb by -(1 - s) θ, or by
// -ψ + s (ψ + φ). θ and φ are the twist of swing and twist, R = S T: of an arm from stretched out
// sideways, of a leg from hanging, so that the swing stays away from half a turn.
// Source: P. Dobrowolski, "Swing-twist decomposition in Clifford algebra", 2015.
class LimbTwists {
 public:
  // `rest` and `start`: the frames of the rig's two postures; `standing`: the body at its start.
  LimbTwists(const BodyModel& body, const Rig& rig, const HumanFrames& rest,
             const HumanFrames& start, const Kinematics<double>& standing);

  // The limbs as they are in this frame; angles go on from the frame before without a jump.
  void show(const Kinematics<double>& now);

  // The index for turn() of the limb whose bones share this one's twist, or -1.
  [[nodiscard]] int find(HumanoidBone bone) const;

  // Moves (world) a bone at that share of the limb from where the body's limb has it.
  [[nodiscard]] Transformd turn(int limb, double share) const;

 private:
  struct Limb {
    TwistSegment segment;
    int link = kBaseLink;
    int above = kBaseLink;   // link that an upper limb hangs on
    int beyond = kBaseLink;  // link of the next bone
    Vec3d joint{};           // m, link frame
    Vec3d axis{};            // unit, link frame, towards the joint
    Mat3d reference{};       // of an upper limb against what it hangs on
    double rest = 0.0;       // θ in the posture at rest
    Mat3d start{};           // of the next bone against a lower limb
    std::optional<ForearmTurn> forearm{};
    double at_joint = 0.0;  // θ or ψ
    double at_end = 0.0;    // φ
    Transformd placed{};    // of the link
  };

  std::vector<Limb> limbs_;
};

}  // namespace shigusa
