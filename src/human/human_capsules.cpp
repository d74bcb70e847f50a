// SPDX-License-Identifier: MIT
// Collision shapes of the body's parts.
#include "human_builder.hpp"

namespace shigusa {

void HumanBuilder::add_capsule(BodyPart part, const Part& on) {
  for (Capsule& capsule : part_capsules(part, person_, frames_, settings_.stature)) {
    capsule.link = on.link;
    capsule.from = in_link(capsule.from, on);
    capsule.to = in_link(capsule.to, on);
    body_.capsules.push_back(std::move(capsule));
  }
}

void HumanBuilder::add_trunk_capsules() {
  if (trunk_.size() == 1) {
    add_capsule(BodyPart::trunk, trunk_.front());
  } else {
    for (std::size_t j = 0; j < trunk_.size(); ++j) {
      add_capsule(static_cast<BodyPart>(static_cast<std::size_t>(BodyPart::pelvis) + j), trunk_[j]);
    }
  }
  add_capsule(BodyPart::neck, neck_);
  add_capsule(BodyPart::head, head_);
  add_capsule(BodyPart::jaw, head_);
}

void HumanBuilder::add_leg_capsules(Side side) {
  const LegParts& parts = legs_[index_of(side)];
  const std::size_t first = body_.capsules.size();
  add_capsule(of_side(BodyPart::left_thigh, side), parts.thigh);
  add_capsule(of_side(BodyPart::left_shank, side), parts.shank);
  add_capsule(of_side(BodyPart::left_foot, side), parts.foot);
  if (settings_.heels) {
    // the foot bends at the toes' joint: the part ahead of it belongs to the toes
    const Vec3d bend = toes_joint(person_.leg(side));
    Capsule& foot = body_.capsules.back();
    const Vec3d line = foot.to - foot.from;
    const double share =
        dot(in_link(bend, parts.foot) - foot.from, line) / max(dot(line, line), 1e-12);
    Capsule toes = foot;
    foot.to = foot.from + line * clamp(share, 0.0, 1.0);
    const auto in_toes = [&](const Vec3d& p) {
      return in_link(parts.foot.frame * p + parts.foot.origin, parts.toes);
    };
    toes.name = side_prefix(side) + "toes";
    toes.link = parts.toes.link;
    toes.from = in_toes(foot.to);
    toes.to = in_toes(toes.to);
    body_.capsules.push_back(std::move(toes));
  }
  for (std::size_t c = first; c < body_.capsules.size(); ++c) body_.capsules[c].leg = side;
}

void HumanBuilder::add_arm_capsules(Side side) {
  const ArmParts& parts = arms_[index_of(side)];
  const BodyPart upper = of_side(BodyPart::left_upper_arm, side);
  add_capsule(upper, parts.upper);
  body_.capsules.back().grown_on = true;
  if (person_.parts[upper]) {
    body_.capsules.push_back(beyond_trunk(body_.capsules.back()));
  }
  add_capsule(of_side(BodyPart::left_forearm, side), parts.fore);
  if (whole()) {
    add_capsule(of_side(BodyPart::left_hand, side), parts.hand);
  } else {
    // a hand without a wrist belongs to its forearm
    body_.capsules.back().to = in_link(person_.arm(side).fingertip, parts.fore);
  }
}

}  // namespace shigusa
