// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

#include "body/joint_name.hpp"
#include "core/index.hpp"
#include "kinematics/limb.hpp"

namespace shigusa {

// Further steps of a motion's last frame, and the distance (m) of the effector from its goal at
// which they end.
inline constexpr int kLastSteps = 12;
inline constexpr double kLastTolerance = 1e-10;
// The same distance by precision.
template <class S>
inline constexpr double kLastMiss = sizeof(Element<S>) == sizeof(double) ? kLastTolerance : 1e-6;

// A limb of the body for layers: a ball joint at the trunk, a hinge in the middle and, for a leg,
// an ankle at the planted foot. An arm keeps the start angles of its joints beyond the elbow,
// unless a goal turns the hand. Numbers are indices of the body's dofs.
struct BodyLimb {
  std::string name;               // "right_arm"
  LimbKind kind = LimbKind::arm;  // or leg
  int flexion = 0;                // of shoulder or hip
  int abduction = 0;
  int rotation = 0;
  int hinge = 0;       // elbow or knee
  int ankle = -1;      // of a leg: its flexion
  int inversion = -1;  // of a leg: its inversion, if it has one
  // for an arm with a wrist: the forearm's rotation and the wrist's dofs, else -1
  int forearm = -1;
  int wrist_flexion = -1;
  int wrist_deviation = -1;
  bool carries = false;  // the leg on the base: its chain leads up to the trunk
  int effector = -1;     // of an arm, in the body's effectors
  int foot = -1;         // of a leg, in the body's feet
  int carrier = 0;  // link of the ball joint's parent: the trunk's or, for an arm, a clavicle's
  Vec3d root{};     // m, centre of the ball joint in the carrier's frame
  // from the shoulder to the hand's point, or from the ankle up to the hip
  HingedLimb segments{{0, 1, 0}, {0, 1, 0}, 1.0};

  [[nodiscard]] bool has_wrist() const { return forearm >= 0; }

  // The rotation from the trunk to upper arm or thigh as turns of the ball joint's dofs, and the
  // reverse: accounts for the signs of the dofs and the direction of the chain.
  template <class S>
  [[nodiscard]] BasicBallTurns<S> turns_of(const BodyModel& body, std::span<const S> angles) const {
    const auto turn = [&](int dof) { return S(sense(body, dof)) * angles[index(dof)]; };
    return {turn(flexion), turn(abduction), turn(rotation)};
  }
  template <class S>
  void put_turns(const BodyModel& body, const BasicBallTurns<S>& turns, std::span<S> angles) const {
    const auto put = [&](int dof, const S& turn) {
      angles[index(dof)] = S(sense(body, dof)) * turn;
    };
    put(flexion, turns.x);
    put(abduction, turns.z);
    put(rotation, turns.y);
  }

 private:
  [[nodiscard]] double sense(const BodyModel& body, int dof) const {
    return carries ? -body.dof(dof).sign : body.dof(dof).sign;
  }
};

// The moving limbs: legs with a planted foot, the base's first; arms with an effector. A lifted leg
// moves with the trunk.
struct BodyLimbs {
  int trunk = 0;            // link: the pelvis
  std::vector<int> joints;  // dofs between the trunk and its arms' parents, in the body's order
  std::vector<BodyLimb> legs;
  std::vector<BodyLimb> arms;  // in the order of the body's effectors
};

// Finds the limbs by the shape of the body's tree: legs of 1 + 1 + 3 dofs, or 2 + 1 + 3 with an
// ankle that inverts; a trunk that is rigid or has joints; arms of 3 + 1 dofs, or 3 + 2 + 2 with a
// forearm that turns and a wrist. Fails for bodies with another tree.
[[nodiscard]] Result<BodyLimbs> find_limbs(const BodyModel& body, const State& start);

// Placement of a link in the frame of another that carries it, in the start posture.
[[nodiscard]] Transformd held_place(const BodyModel& body, const State& start, int carrier,
                                    int link);

}  // namespace shigusa
