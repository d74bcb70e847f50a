// SPDX-License-Identifier: MIT
#include "plan/body_limbs.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "core/say.hpp"

namespace shigusa {
namespace {

// Dofs of a leg with a hinge for an ankle; one more with an ankle that inverts.
constexpr std::size_t kLegDofs = 5;
// Dofs of an arm up to the elbow's flexion, and of one with forearm and wrist.
constexpr std::size_t kArmToElbow = 4;
constexpr std::size_t kArmToHand = 7;

// The side's name, such as "right" for "right_ankle".
std::string side_of(const Dof& dof) { return dof.part.side == Side::left ? "left" : "right"; }

bool is_ball(const BodyModel& body, int x, int z, int y) {
  return body.dof(x).axis == Axis::x && body.dof(z).axis == Axis::z && body.dof(y).axis == Axis::y;
}

bool is_hinge(const BodyModel& body, int dof, Axis axis) {
  return body.dof(dof).axis == axis && !body.dof(dof).turn;
}

// Whether the first chain begins with the second.
bool begins_with(std::span<const int> chain, std::span<const int> first) {
  return chain.size() >= first.size() && std::equal(first.begin(), first.end(), chain.begin());
}

// The standing leg's part of the chain from the base to a hand.
std::span<const int> leg_of(const BodyModel& body, std::span<const int> chain) {
  const bool inverts = !chain.empty() && body.dof(chain[0]).axis == Axis::z;
  return chain.first(std::min(chain.size(), kLegDofs + (inverts ? 1 : 0)));
}

// The leg of the base: ankle, knee and hip from the base up to the trunk.
std::optional<BodyLimb> carrying_leg(const BodyModel& body, std::span<const int> chain) {
  int inversion = -1;
  if (chain.size() == kLegDofs + 1) {
    inversion = chain[0];
    if (!is_hinge(body, inversion, Axis::z)) return std::nullopt;
    chain = chain.subspan(1);
  }
  if (chain.size() != kLegDofs) return std::nullopt;
  BodyLimb leg{.name = side_of(body.dof(chain[0])) + "_leg",
               .kind = LimbKind::leg,
               .flexion = chain[4],
               .abduction = chain[3],
               .rotation = chain[2],
               .hinge = chain[1],
               .ankle = chain[0],
               .inversion = inversion,
               .carries = true,
               .carrier = chain[4]};
  if (!is_ball(body, leg.flexion, leg.abduction, leg.rotation)) return std::nullopt;
  const Dof& ankle = body.dof(leg.ankle);
  const Dof& knee = body.dof(leg.hinge);
  if (ankle.axis != Axis::x || knee.axis != Axis::x || ankle.sign != 1.0) return std::nullopt;
  leg.segments = HingedLimb(knee.offset, body.dof(leg.rotation).offset, knee.sign);
  return leg;
}

// A leg from the trunk down to a planted foot: hip, knee and ankle.
std::optional<BodyLimb> planted_leg(const BodyModel& body, std::span<const int> chain) {
  const bool inverts = chain.size() == kLegDofs + 1;
  if (chain.size() != kLegDofs && !inverts) return std::nullopt;
  BodyLimb leg{.name = side_of(body.dof(chain[4])) + "_leg",
               .kind = LimbKind::leg,
               .flexion = chain[0],
               .abduction = chain[1],
               .rotation = chain[2],
               .hinge = chain[3],
               .ankle = chain[4],
               .inversion = inverts ? chain[5] : -1,
               .carrier = body.dof(chain[0]).parent};
  if (!is_ball(body, leg.flexion, leg.abduction, leg.rotation)) return std::nullopt;
  const Dof& ankle = body.dof(leg.ankle);
  const Dof& knee = body.dof(leg.hinge);
  if (ankle.axis != Axis::x || knee.axis != Axis::x || ankle.sign != -1.0) return std::nullopt;
  if (inverts && !is_hinge(body, leg.inversion, Axis::z)) return std::nullopt;
  leg.root = body.dof(leg.flexion).offset;
  // upwards from the foot, all turns are reversed
  leg.segments = HingedLimb(-ankle.offset, -knee.offset, -knee.sign);
  return leg;
}

// The arm of a chain that begins at the shoulder.
std::optional<BodyLimb> arm_of(const BodyModel& body, const State& start,
                               std::span<const int> chain, const Effector& effector) {
  if (chain.size() != kArmToElbow && chain.size() != kArmToHand) return std::nullopt;
  BodyLimb arm{.name = side_of(body.dof(chain[0])) + "_arm",
               .kind = LimbKind::arm,
               .flexion = chain[0],
               .abduction = chain[1],
               .rotation = chain[2],
               .hinge = chain[3],
               .carrier = body.dof(chain[0]).parent};
  if (!is_ball(body, arm.flexion, arm.abduction, arm.rotation)) return std::nullopt;
  const Dof& elbow = body.dof(arm.hinge);
  if (elbow.axis != Axis::x) return std::nullopt;
  if (chain.size() == kArmToHand) {
    arm.forearm = chain[4];
    arm.wrist_flexion = chain[5];
    arm.wrist_deviation = chain[6];
    if (!is_hinge(body, arm.forearm, Axis::y) || !is_hinge(body, arm.wrist_flexion, Axis::z) ||
        !is_hinge(body, arm.wrist_deviation, Axis::x)) {
      return std::nullopt;
    }
  }
  arm.root = body.dof(arm.flexion).offset;
  const Vec3d hand = held_place(body, start, arm.hinge, effector.link) * effector.point;
  arm.segments = HingedLimb(elbow.offset, hand, elbow.sign);
  return arm;
}

}  // namespace

Transformd held_place(const BodyModel& body, const State& start, int carrier, int link) {
  if (link == carrier) return {};
  SHG_CHECK(link != kBaseLink, "a link that the other one carries");
  const Dof& dof = body.dof(link);
  const double angle = dof.sign * start.angles[static_cast<std::size_t>(link)];
  return held_place(body, start, carrier, dof.parent) *
         Transformd{rotation(dof.axis, angle), dof.offset};
}

Result<BodyLimbs> find_limbs(const BodyModel& body, const State& start) {
  const auto refuse = [&body](const Message& what) {
    return fail(ErrorCode::unsupported, say("layers_bodies", what), body.name());
  };
  BodyLimbs limbs;
  if (body.is_robot()) return refuse(say("robot_has_others"));
  if (body.effectors().empty()) return refuse(say("has_no_hand"));
  const int shoulder = body.effectors()[0].limb_root;
  const auto trunk_chain = leg_of(body, body.chain(body.dof(shoulder).parent));
  std::optional<BodyLimb> base = carrying_leg(body, trunk_chain);
  if (!base) return refuse(say("standing_leg_differs"));
  limbs.trunk = trunk_chain.back();
  for (std::size_t f = 0; f < body.feet().size(); ++f) {
    const Foot& foot = body.feet()[f];
    std::optional<BodyLimb> leg = base;
    if (foot.link != kBaseLink) {
      const auto chain = body.chain(foot.link);
      if (!begins_with(chain, trunk_chain)) return refuse(say("limb_differs", foot.name));
      leg = planted_leg(body, chain.subspan(trunk_chain.size()));
    }
    if (!leg) return refuse(say("limb_differs", foot.name));
    leg->foot = static_cast<int>(f);
    limbs.legs.insert(foot.link == kBaseLink ? limbs.legs.begin() : limbs.legs.end(), *leg);
  }
  if (limbs.legs.empty() || !limbs.legs[0].carries) return refuse(say("not_on_base"));
  for (std::size_t e = 0; e < body.effectors().size(); ++e) {
    const Effector& effector = body.effectors()[e];
    const auto carrier = body.chain(body.dof(effector.limb_root).parent);
    const auto chain = body.chain(effector.link);
    if (!begins_with(carrier, trunk_chain)) return refuse(say("limb_differs", effector.name));
    std::optional<BodyLimb> arm = arm_of(body, start, chain.subspan(carrier.size()), effector);
    if (!arm) return refuse(say("limb_differs", effector.name));
    arm->effector = static_cast<int>(e);
    limbs.arms.push_back(*arm);
    for (const int joint : carrier.subspan(trunk_chain.size())) limbs.joints.push_back(joint);
  }
  std::sort(limbs.joints.begin(), limbs.joints.end());
  limbs.joints.erase(std::unique(limbs.joints.begin(), limbs.joints.end()), limbs.joints.end());
  return limbs;
}

}  // namespace shigusa
