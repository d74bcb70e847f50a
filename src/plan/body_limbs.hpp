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

// The last frame of a motion takes further steps, at most this number, until the effector is this
// near its goal (m).
inline constexpr int kLastSteps = 12;
inline constexpr double kLastTolerance = 1e-10;
// … or where single precision computes.
template <class S>
inline constexpr double kLastMiss = sizeof(Element<S>) == sizeof(double) ? kLastTolerance : 1e-6;

// A limb of the body as layers see it: a ball joint at the trunk, a hinge in the middle and, of a
// leg, an ankle at the foot, which is planted. An arm holds its joints beyond the elbow as they
// are at the start, but for a goal that turns the hand. Numbers are those of the body's dofs.
struct BodyLimb {
  std::string name;               // "right_arm"
  LimbKind kind = LimbKind::arm;  // or leg
  int flexion = 0;                // of shoulder or hip
  int abduction = 0;
  int rotation = 0;
  int hinge = 0;       // elbow or knee
  int ankle = -1;      // of a leg: its flexion …
  int inversion = -1;  // … and its inversion, where it has one
  // of an arm with a wrist: the forearm's rotation and the wrist's freedoms, else -1
  int forearm = -1;
  int wrist_flexion = -1;
  int wrist_deviation = -1;
  bool carries = false;  // the leg that stands on the base: its chain leads up to the trunk
  int effector = -1;     // of an arm, in the body's effectors
  int foot = -1;         // of a leg, in the body's feet
  int carrier = 0;  // link that the ball joint hangs on: the trunk's or, of an arm, a clavicle's
  Vec3d root{};     // m, centre of the ball joint in the carrier's frame
  // from the shoulder to the hand's point, or from the ankle up to the hip
  HingedLimb segments{{0, 1, 0}, {0, 1, 0}, 1.0};

  [[nodiscard]] bool has_wrist() const { return forearm >= 0; }

  // The rotation from the trunk to upper arm or thigh by the turns of the ball joint's dofs, and
  // the reverse: signs of the dofs, and of the chain's direction.
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

// The limbs that move: legs whose foot is planted, the base's first; arms with an effector. A leg
// that is lifted moves with the trunk.
struct BodyLimbs {
  int trunk = 0;            // link: the pelvis
  std::vector<int> joints;  // dofs between the trunk and what its arms hang on, in the body's order
  std::vector<BodyLimb> legs;
  std::vector<BodyLimb> arms;  // in the order of the body's effectors
};

// Finds them by the shape of the body's tree: legs of 1 + 1 + 3 freedoms, or 2 + 1 + 3 with an
// ankle that inverts; a trunk that is rigid or has joints; arms of 3 + 1 freedoms, or 3 + 2 + 2
// with a forearm that turns and a wrist. Fails on a body that has another.
[[nodiscard]] Result<BodyLimbs> find_limbs(const BodyModel& body);

// Where a link is in the frame of another that carries it, in the start posture.
[[nodiscard]] Transformd held_place(const BodyModel& body, int carrier, int link);

}  // namespace shigusa
