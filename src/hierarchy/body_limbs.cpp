// SPDX-License-Identifier: MIT
#include <shigusa/hierarchy/body_limbs.hpp>

namespace shigusa {
namespace {

Error unlike_a_person(const BodyModel& body, const std::string& what) {
  return {
      ErrorCode::unsupported,
      "layers are for bodies of a trunk with arms of 3 + 1 and legs of 1 + 1 + 3 freedoms; " + what,
      body.name()};
}

// "right" of "right_ankle"
std::string side_of(const Dof& dof) { return dof.joint.substr(0, dof.joint.find('_')); }

bool is_ball(const BodyModel& body, int x, int z, int y) {
  return body.dof(x).axis == Axis::x && body.dof(z).axis == Axis::z && body.dof(y).axis == Axis::y;
}

// ankle, knee and hip from the base up to the trunk
std::optional<BodyLimb> carrying_leg(const BodyModel& body, std::span<const int> chain) {
  if (chain.size() != 5) return std::nullopt;
  BodyLimb leg{.name = side_of(body.dof(chain[0])) + "_leg",
               .kind = LimbKind::leg,
               .flexion = chain[4],
               .abduction = chain[3],
               .rotation = chain[2],
               .hinge = chain[1],
               .ankle = chain[0],
               .carries = true};
  if (!is_ball(body, leg.flexion, leg.abduction, leg.rotation)) return std::nullopt;
  const Dof& ankle = body.dof(leg.ankle);
  const Dof& knee = body.dof(leg.hinge);
  if (ankle.axis != Axis::x || knee.axis != Axis::x || ankle.sign != 1.0) return std::nullopt;
  leg.segments = HingedLimb(knee.offset, body.dof(leg.rotation).offset, knee.sign);
  return leg;
}

// hip, knee and ankle from the trunk down to a planted foot
std::optional<BodyLimb> planted_leg(const BodyModel& body, std::span<const int> chain) {
  if (chain.size() != 5) return std::nullopt;
  BodyLimb leg{.name = side_of(body.dof(chain[4])) + "_leg",
               .kind = LimbKind::leg,
               .flexion = chain[0],
               .abduction = chain[1],
               .rotation = chain[2],
               .hinge = chain[3],
               .ankle = chain[4]};
  if (!is_ball(body, leg.flexion, leg.abduction, leg.rotation)) return std::nullopt;
  const Dof& ankle = body.dof(leg.ankle);
  const Dof& knee = body.dof(leg.hinge);
  if (ankle.axis != Axis::x || knee.axis != Axis::x || ankle.sign != -1.0) return std::nullopt;
  leg.root = body.dof(leg.flexion).offset;
  // climbed from the foot, all turns are the other way round
  leg.segments = HingedLimb(-ankle.offset, -knee.offset, -knee.sign);
  return leg;
}

std::optional<BodyLimb> arm_of(const BodyModel& body, std::span<const int> chain,
                               const Effector& effector) {
  if (chain.size() != 4 || chain[0] != effector.limb_root) return std::nullopt;
  BodyLimb arm{.name = side_of(body.dof(chain[0])) + "_arm",
               .kind = LimbKind::arm,
               .flexion = chain[0],
               .abduction = chain[1],
               .rotation = chain[2],
               .hinge = chain[3]};
  if (!is_ball(body, arm.flexion, arm.abduction, arm.rotation)) return std::nullopt;
  const Dof& elbow = body.dof(arm.hinge);
  if (elbow.axis != Axis::x) return std::nullopt;
  arm.root = body.dof(arm.flexion).offset;
  arm.segments = HingedLimb(elbow.offset, effector.point, elbow.sign);
  return arm;
}

}  // namespace

BallTurns BodyLimb::turns_of(const BodyModel& body, std::span<const double> angles) const {
  const double way = carries ? -1.0 : 1.0;
  const auto turn = [&](int dof) {
    return way * body.dof(dof).sign * angles[static_cast<std::size_t>(dof)];
  };
  return {turn(flexion), turn(abduction), turn(rotation)};
}

void BodyLimb::put_turns(const BodyModel& body, const BallTurns& turns,
                         std::span<double> angles) const {
  const double way = carries ? -1.0 : 1.0;
  const auto put = [&](int dof, double turn) {
    angles[static_cast<std::size_t>(dof)] = way * body.dof(dof).sign * turn;
  };
  put(flexion, turns.x);
  put(abduction, turns.z);
  put(rotation, turns.y);
}

Result<BodyLimbs> find_limbs(const BodyModel& body) {
  const auto refuse = [&body](const std::string& what) {
    return tl::unexpected(unlike_a_person(body, what));
  };
  BodyLimbs limbs;
  if (body.robot()) return refuse("a robot has others");
  if (body.effectors().empty()) return refuse("it has no hand");
  limbs.trunk = body.dof(body.effectors()[0].limb_root).parent;
  const auto trunk_chain = body.chain(limbs.trunk);
  std::optional<BodyLimb> base = carrying_leg(body, trunk_chain);
  if (!base) return refuse("the standing leg is different");
  for (std::size_t f = 0; f < body.feet().size(); ++f) {
    const Foot& foot = body.feet()[f];
    std::optional<BodyLimb> leg = base;
    if (foot.link != kBaseLink) {
      const auto chain = body.chain(foot.link);
      if (chain.size() < trunk_chain.size()) return refuse(foot.name + " is different");
      leg = planted_leg(body, chain.subspan(trunk_chain.size()));
    }
    if (!leg) return refuse(foot.name + " is different");
    leg->foot = static_cast<int>(f);
    limbs.legs.insert(foot.link == kBaseLink ? limbs.legs.begin() : limbs.legs.end(), *leg);
  }
  if (limbs.legs.empty() || !limbs.legs[0].carries) return refuse("it does not stand on its base");
  for (std::size_t e = 0; e < body.effectors().size(); ++e) {
    const Effector& effector = body.effectors()[e];
    const auto chain = body.chain(effector.link);
    if (chain.size() < trunk_chain.size()) return refuse(effector.name + " is different");
    std::optional<BodyLimb> arm = arm_of(body, chain.subspan(trunk_chain.size()), effector);
    if (!arm || body.dof(arm->flexion).parent != limbs.trunk) {
      return refuse(effector.name + " is different");
    }
    arm->effector = static_cast<int>(e);
    limbs.arms.push_back(*arm);
  }
  return limbs;
}

}  // namespace shigusa
