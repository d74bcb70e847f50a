// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/check.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "human_builder.hpp"

namespace shigusa {
namespace {

Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

// Women's share of a man's lumbar bend. In reaches to low targets the ratio of back to hip flexion
// is 0.2 : 1 for women and 1.2 : 1 for men (Thomas, Corcos and Hasan, J. Motor Behavior 30 (1998)
// 98); in a full bend they are much closer.
constexpr double kWomensBack = 0.85;

bool joint_is_leg(const std::string& joint) {
  return !joint.ends_with("shoulder") && !joint.ends_with("elbow");
}

}  // namespace

HumanBuilder::HumanBuilder(const Landmarks& person, const HumanSettings& settings,
                           std::vector<Message> doubts)
    : person_(person),
      settings_(settings),
      frames_(human_frames(person)),
      table_(segment_table(settings.sex)),
      masses_(person, frames_, table_, settings.mass, settings.stature),
      doubts_(std::move(doubts)) {
  SHG_CHECK(!settings.heels || (whole() && !settings.sits), "heels lift of who stands, all joints");
  const double right_above = person.right_leg.ankle.y - person.left_leg.ankle.y;
  const bool both = settings.extent != BodyExtent::half;
  other_stands_ = both && (settings.on_both || abs(right_above) <= kLiftedFoot);
  base_side_ = both && right_above > kLiftedFoot ? Side::left : Side::right;
  if (other_stands_) base_side_ = settings.base;
  const double usual = default_mass(stature_of_limbs(person, settings.stature), settings.sex);
  const double of_mass = 1.0 + kStrengthOfMass * (settings.mass / usual - 1.0);
  strength_ =
      usual / table_.mean_mass * of_mass * (settings_.sex == Sex::female ? kFemaleStrength : 1.0);
  if (!both) leg_strength_ = 2.0;
}

PosedBody HumanBuilder::build() {
  body_.name = settings_.name;
  body_.stature = settings_.stature;
  body_.lumbar_part = settings_.sex == Sex::female ? kWomensBack : 1.0;
  add_leg(base_side_);
  add_trunk();
  add_arm(Side::right);
  if (settings_.extent != BodyExtent::half) {
    add_arm(Side::left);
    add_leg(other(base_side_));
    if (!other_stands_ && !settings_.sits) {
      doubts_.push_back(say("foot_lifted", base_side_ == Side::left ? "right " : "left "));
    }
  }
  add_nodes();
  hold_start_posture();
  body_.mass = body_.base_mass.mass;
  for (const MassProperties& link : body_.masses) body_.mass += link.mass;
  return {BodyModel(std::move(body_)), {.angles = std::move(home_)}, std::move(doubts_)};
}

HumanBuilder::Part HumanBuilder::add_joint(const std::string& joint, const Part& on,
                                           const Vec3d& at, const Mat3d& frame,
                                           const std::vector<Freedom>& freedoms) {
  const double strength = strength_ * (joint_is_leg(joint) ? leg_strength_ : 1.0);
  Part part{on.link, frame, at};
  Vec3d offset = in_link(at, on);
  for (const Freedom& f : freedoms) {
    body_.dofs.push_back({.joint = joint,
                          .name = joint + "." + f.name,
                          .parent = part.link,
                          .offset = offset,
                          .axis = f.axis,
                          .sign = f.sign,
                          .lower = f.limits.lower,
                          .upper = f.limits.upper,
                          .torque_positive = f.limits.torque_positive * strength,
                          .torque_negative = f.limits.torque_negative * strength,
                          .give = f.give});
    body_.masses.emplace_back();
    home_.push_back(f.start);
    part.link = static_cast<int>(body_.dofs.size()) - 1;
    offset = {};
  }
  return part;
}

// Joints of a leg from the pelvis down; one for a seated person. For a leg that is the base of the
// chain, the degrees of freedom are in reverse order with opposite signs.
std::vector<HumanBuilder::LegJoint> HumanBuilder::leg_joints(Side side) const {
  const double s = side_sign(side);
  const Landmarks::Leg& leg = person_.leg(side);
  const auto& [thigh, shank, foot] = frames_.leg(side);
  const auto hinge = [&](const Mat3d& above, const Mat3d& below) {
    return climbs(side) ? -hinge_angle(below, above) : hinge_angle(above, below);
  };
  JointLimits hip_bends = whole() ? kFreeHipFlexion : kHipFlexion;
  // a seated person's hip has the range that it has with a bent knee
  if (settings_.sits) hip_bends.upper += whole() ? kFreeHipFlexionGain : kHipFlexionGain;
  const BallAngles hip = ball_angles(transpose(frames_.trunk) * thigh, side);
  std::vector<LegJoint> joints{{"hip",
                                leg.hip,
                                frames_.trunk,
                                thigh,
                                {{"flexion", Axis::x, -1.0, hip_bends, hip.flexion},
                                 {"abduction", Axis::z, s, kHipAbduction, hip.abduction},
                                 {"rotation", Axis::y, s, kHipRotation, hip.rotation}}}};
  if (!settings_.sits) {
    const Freedom knee{"flexion", Axis::x, 1.0, kKneeFlexion, hinge(thigh, shank)};
    const Freedom ankle{"flexion", Axis::x, -1.0, kAnkleFlexion, -hinge(shank, foot)};
    joints.push_back({"knee", leg.knee, thigh, shank, {knee}});
    joints.push_back({"ankle", leg.ankle, shank, foot, {ankle}});
    if (whole()) joints.back().freedoms.push_back({"inversion", Axis::z, -s, kAnkleInversion});
  }
  if (settings_.heels) {
    const Freedom bends{"flexion", Axis::x, -1.0, kToesFlexion, 0.0, kToesGive};
    joints.push_back({"toes", toes_joint(leg), foot, foot, {bends}});
  }
  if (!climbs(side)) return joints;
  for (LegJoint& joint : joints) {
    std::reverse(joint.freedoms.begin(), joint.freedoms.end());
    for (Freedom& f : joint.freedoms) f.sign = -f.sign;
  }
  return joints;
}

// Adds a leg, hanging from the pelvis or, as the base of the chain, rising from the floor or the
// seat to the trunk. A seated person's leg is rigid.
void HumanBuilder::add_leg(Side side) {
  const bool up = climbs(side);
  LegParts& parts = legs_[index_of(side)];
  Part pelvis = up ? Part{} : trunk_.front();
  const std::array links{&pelvis, &parts.thigh, &parts.shank, &parts.foot, &parts.toes};
  const std::vector<LegJoint> joints = leg_joints(side);
  const std::size_t count = joints.size();
  if (up) {
    body_.base = {joints.back().below, joints.back().at};
    *links[count] = {kBaseLink, joints.back().below, joints.back().at};
  }
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t k = up ? count - 1 - j : j;
    const LegJoint& joint = joints[k];
    *links[up ? k : k + 1] = add_joint(side_prefix(side) + joint.name, *links[up ? k + 1 : k],
                                       joint.at, up ? joint.above : joint.below, joint.freedoms);
  }
  if (up) trunk_ = {pelvis};
  for (std::size_t k = count + 1; k < links.size(); ++k) *links[k] = *links[count];
  add_leg_capsules(side);
  set_leg_masses(side);
  if (settings_.sits) {
    add_seat(side, parts.thigh);
  } else {
    body_.couplings.push_back(
        {freedom(side_prefix(side) + "hip.flexion"), freedom(side_prefix(side) + "knee.flexion"),
         whole() ? kFreeHipFlexionGain : kHipFlexionGain, kHipFlexionKneeFull});
    if (up || other_stands_) add_foot(side, parts.toes);
  }
}

void HumanBuilder::set_leg_masses(Side side) {
  const LegParts& parts = legs_[index_of(side)];
  LinkMass thigh = masses_.thigh(side);
  LinkMass shank = masses_.shank(side);
  LinkMass foot = masses_.foot(side);
  if (settings_.sits) {
    thigh.add(shank);
    thigh.add(foot);
    return set_mass(parts.thigh, thigh);
  }
  if (settings_.extent == BodyExtent::half) {
    // the left leg moves as the right one does, shifted along the hinge axis (rule R1)
    const Vec3d axis = parts.foot.frame.cx;
    shift_ = axis * dot(person_.left_leg.ankle - person_.leg(side).ankle, axis);
    for (LinkMass* part : {&foot, &shank, &thigh}) part->add(part->shifted(shift_));
  }
  if (settings_.heels) {
    const LinkMass toes = masses_.forefoot(side);
    foot.take_off(toes);
    set_mass(parts.toes, toes);
  }
  set_mass(parts.foot, foot);
  set_mass(parts.shank, shank);
  set_mass(parts.thigh, thigh);
}

void HumanBuilder::add_arm(Side side) {
  const double s = side_sign(side);
  const std::string prefix = side_prefix(side);
  const Landmarks::Arm& arm = person_.arm(side);
  const ArmFrames& frame = frames_.arm(side);
  ArmParts& parts = arms_[index_of(side)];
  parts.clavicle = add_clavicle(side);
  const bool free = parts.clavicle.link != trunk_.back().link;
  const BallAngles shoulder = ball_angles(transpose(frames_.trunk) * frame.upper_arm, side);
  const int root = static_cast<int>(body_.dofs.size());
  parts.upper = add_joint(
      prefix + "shoulder", parts.clavicle, arm.shoulder, frame.upper_arm,
      {{"flexion", Axis::x, -1.0, free ? kFreeShoulderFlexion : kShoulderFlexion, shoulder.flexion},
       {"abduction", Axis::z, s, free ? kFreeShoulderAbduction : kShoulderAbduction,
        shoulder.abduction},
       {"rotation", Axis::y, s, whole() ? kFreeShoulderRotation : kShoulderRotation,
        shoulder.rotation}});
  if (whole()) {
    body_.couplings.push_back(
        {root + 2, root + 1, kFreeShoulderRotationGain, kFreeShoulderRotationFull});
  }
  const Freedom bends{"flexion", Axis::x, -1.0, kElbowFlexion,
                      -hinge_angle(frame.upper_arm, frame.forearm)};
  set_mass(parts.upper, masses_.upper_arm(side));
  if (whole()) {
    parts.fore = add_joint(prefix + "elbow", parts.upper, arm.elbow, frame.forearm,
                           {bends, {"rotation", Axis::y, s, kForearmRotation}});
    parts.hand = add_joint(
        prefix + "wrist", parts.fore, arm.wrist, frame.forearm,
        {{"flexion", Axis::z, -s, kWristFlexion}, {"deviation", Axis::x, -1.0, kWristDeviation}});
    set_mass(parts.fore, masses_.forearm(side));
    set_mass(parts.hand, masses_.hand(side));
  } else {
    parts.fore = parts.hand =
        add_joint(prefix + "elbow", parts.upper, arm.elbow, frame.forearm, {bends});
    set_mass(parts.fore, masses_.forearm_and_hand(side));
  }
  add_arm_capsules(side);
  body_.effectors.push_back({prefix + "hand", prefix + "hand_grip", parts.hand.link,
                             in_link(grip_of(arm), parts.hand), root});
}

void HumanBuilder::set_mass(const Part& part, const LinkMass& mass) {
  MassProperties& link = part.link == kBaseLink ? body_.base_mass : body_.masses[index(part.link)];
  link = mass.in_frame(part.frame, part.origin);
}

// Widens limits to the start posture.
void HumanBuilder::hold_start_posture() {
  for (std::size_t i = 0; i < body_.dofs.size(); ++i) {
    Dof& dof = body_.dofs[i];
    double upper = dof.upper;
    for (const LimitCoupling& c : body_.couplings) {
      if (c.dof != static_cast<int>(i)) continue;
      const double driver = home_[index(c.driver)];
      upper += c.gain * clamp(driver / c.driver_full, 0.0, 1.0);
    }
    const double over = max(home_[i] - upper, 0.0);
    const double under = max(dof.lower - home_[i], 0.0);
    if (max(over, under) <= 0.0) continue;
    dof.upper += over;
    dof.lower -= under;
    if (max(over, under) < radians(1.0)) continue;
    doubts_.push_back(say("start_outside", dof.name, degrees(home_[i])));
  }
}

PosedBody build_human(const Landmarks& landmarks, const HumanSettings& settings,
                      std::vector<Message> doubts) {
  return HumanBuilder(landmarks, settings, std::move(doubts)).build();
}

namespace {

// A build whose stature and mass are in range.
const BodyBuild& checked(const BodyBuild& build) {
  SHG_CHECK(build.stature >= kStatureMin && build.stature <= kStatureMax,
            fmt::format("stature is {:g} m; allowed are {:g} to {:g} m", build.stature, kStatureMin,
                        kStatureMax));
  SHG_CHECK(
      build.mass >= kMassMin && build.mass <= kMassMax,
      fmt::format("mass is {:g} kg; allowed are {:g} to {:g} kg", build.mass, kMassMin, kMassMax));
  return build;
}

}  // namespace

PosedBody half_body(const BodyBuild& build) {
  const BodyBuild& s = checked(build);
  return build_human(standing_landmarks(s.stature, 0.0),
                     {"half_body", BodyExtent::half, s.stature, s.mass, s.sex});
}

PosedBody full_body(const BodyBuild& build) {
  const BodyBuild& s = checked(build);
  return build_human(standing_landmarks(s.stature, kStandingToeOut),
                     {"full_body", BodyExtent::full, s.stature, s.mass, s.sex, s.base});
}

PosedBody human_body(const BodyBuild& build) {
  const BodyBuild& s = checked(build);
  return build_human(standing_landmarks(s.stature, kStandingToeOut), {.name = "human",
                                                                      .extent = BodyExtent::human,
                                                                      .stature = s.stature,
                                                                      .mass = s.mass,
                                                                      .sex = s.sex,
                                                                      .base = s.base,
                                                                      .heels = s.heels});
}

}  // namespace shigusa
