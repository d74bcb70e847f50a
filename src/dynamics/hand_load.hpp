// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/motion.hpp>
#include <span>

#include "dynamics/inverse_dynamics.hpp"
#include "kinematics/weighted_ik.hpp"

namespace shigusa {

// A hand that presses on a thigh or on an obstacle, at one moment.
template <class S>
struct HandLoad {
  int link = 0;                 // of the hand
  int carrier = kWorldCarrier;  // link with the opposite force, or kWorldCarrier
  Vec3<S> at{};                 // m, world
  Vec3<S> force{};              // N, world: on the hand
};

// Largest tangential force of a hand relative to the normal force: dry skin on cloth holds about
// that (Derler and Gerhardt, Tribology Letters 45 (2012) 1-27: 0.3 to 0.7, quoted from memory).
inline constexpr double kHandFriction = 0.5;
// Least share of the force along the normal, for a shoulder beside or behind the surface.
inline constexpr double kLeastNormal = 0.2;

// The direction (unit vector) of the force on a hand that leans on a surface with this normal:
// along the arm, towards the shoulder, within the limits of friction. `arm`: from the hand to the
// shoulder.
template <class S>
[[nodiscard]] Vec3<S> leaning_direction(const Vec3<S>& normal, const Vec3<S>& arm) {
  const Vec3<S> along = arm * (S(1) / max(norm(arm), S(1e-6)));
  const S out = dot(along, normal);
  const Vec3<S> beside = along - normal * out;
  const S pressed = max(out, S(kLeastNormal));
  const S slip = max(norm(beside), S(1e-6));
  const Vec3<S> direction =
      normal * pressed + beside * min(S(1), pressed * S(kHandFriction) / slip);
  return direction * (S(1) / norm(direction));
}

// Subtracts the effect of the force on a hand, and of its reaction on the carrier, from the joint
// torques tau (dofs, N·m); joints that move both are unaffected. If the carrier is the world, the
// force is subtracted from the floor's wrench.
template <class S>
void bear_on_hand(const BodyModel& body, const Kinematics<S>& kinematics, const HandLoad<S>& load,
                  Wrench<S>& ground, std::span<S> tau) {
  const auto& dofs = body.constants<Element<S>>().dofs;
  const bool on_body = load.carrier != kWorldCarrier;
  const auto take = [&](int link, int other, const Vec3<S>& force) {
    Vec3<S> moment{};  // about the joint
    for (const int d : body.chain(link)) {
      const std::size_t k = index(d);
      if (dofs[k].starts_joint) moment = cross(load.at - kinematics.origin[k], force);
      if (on_body && body.moves(d, other)) continue;
      tau[k] = tau[k] - dot(kinematics.axis[k], moment);
    }
  };
  take(load.link, load.carrier, load.force);
  if (on_body) {
    take(load.carrier, load.link, -load.force);
    return;
  }
  ground.force = ground.force - load.force;
  ground.moment = ground.moment - cross(load.at, load.force);
}

// Applies bear_on_hand to one frame of a stored motion's hands.
inline void bear_on_hands(const BodyModel& body, const Kinematics<double>& kinematics,
                          std::span<const RestingHand> hands, std::size_t frame,
                          Wrench<double>& ground, std::span<double> tau) {
  for (const RestingHand& hand : hands) {
    const HandLoad<double> load{body.effector(hand.effector).link,
                                hand.thigh.value_or(kWorldCarrier), hand.places[frame],
                                hand.forces[frame]};
    bear_on_hand<double>(body, kinematics, load, ground, tau);
  }
}

}  // namespace shigusa
