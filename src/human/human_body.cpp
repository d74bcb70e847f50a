// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/check.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "human_builder.hpp"

namespace shigusa {
namespace {

Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

// Women's part of a man's lumbar bend: in reaches to low targets their backs and hips share it as
// 0.2 : 1, men's as 1.2 : 1 (Thomas, Corcos and Hasan, J. Motor Behavior 30 (1998) 98); in a full
// bend they are much nearer.
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
      masses_(person, frames_, table_, settings.mass, settings.stature) {
  SHG_CHECK(!settings.heels || (whole() && !settings.sits), "heels lift of who stands, all joints");
  body_.doubts = std::move(doubts);
  const double right_above = person.right_leg.ankle.y - person.left_leg.ankle.y;
  const bool both = settings.extent != BodyExtent::half;
  other_stands_ = both && (settings.on_both || abs(right_above) <= kLiftedFoot);
  base_side_ = both && right_above > kLiftedFoot ? Side::left : Side::right;
  if (other_stands_) base_side_ = settings.base;
  strength_ =
      settings_.mass / table_.mean_mass * (settings_.sex == Sex::female ? kFemaleStrength : 1.0);
  if (!both) leg_strength_ = 2.0;
}

BodyModel HumanBuilder::build() {
  body_.name = settings_.name;
  body_.stature = settings_.stature;
  body_.lumbar_part = settings_.sex == Sex::female ? kWomensBack : 1.0;
  settings_.sits ? add_seated_leg(base_side_) : add_standing_leg();
  add_trunk();
  add_arm(Side::right);
  if (settings_.extent != BodyExtent::half) {
    add_arm(Side::left);
    settings_.sits ? add_seated_leg(other(base_side_)) : add_hanging_leg(other(base_side_));
    if (!other_stands_ && !settings_.sits) {
      body_.doubts.push_back(say("foot_lifted", base_side_ == Side::left ? "right " : "left "));
    }
  }
  add_nodes();
  hold_start_posture();
  body_.mass = body_.base_mass.mass;
  for (const MassProperties& link : body_.masses) body_.mass += link.mass;
  return BodyModel(std::move(body_));
}

HumanBuilder::Part HumanBuilder::add_joint(const std::string& joint, const Part& on,
                                           const Vec3d& at, const Mat3d& frame,
                                           std::initializer_list<Freedom> freedoms) {
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
                          .torque_negative = f.limits.torque_negative * strength});
    body_.masses.emplace_back();
    body_.start.push_back(f.start);
    part.link = static_cast<int>(body_.dofs.size()) - 1;
    offset = {};
  }
  return part;
}

HumanBuilder::Part HumanBuilder::add_hip_above(Side side, const Part& thigh,
                                               const JointLimits& bends) {
  const double s = side_sign(side);
  const BallAngles hip = ball_angles(transpose(frames_.trunk) * frames_.leg(side).thigh, side);
  return add_joint(prefix_of(side) + "hip", thigh, person_.leg(side).hip, frames_.trunk,
                   {{"rotation", Axis::y, -s, kHipRotation, hip.rotation},
                    {"abduction", Axis::z, -s, kHipAbduction, hip.abduction},
                    {"flexion", Axis::x, 1.0, bends, hip.flexion}});
}

HumanBuilder::Part HumanBuilder::add_hip_below(Side side, const JointLimits& bends) {
  const double s = side_sign(side);
  const Mat3d& thigh = frames_.leg(side).thigh;
  const BallAngles hip = ball_angles(transpose(frames_.trunk) * thigh, side);
  return add_joint(prefix_of(side) + "hip", trunk_.front(), person_.leg(side).hip, thigh,
                   {{"flexion", Axis::x, -1.0, bends, hip.flexion},
                    {"abduction", Axis::z, s, kHipAbduction, hip.abduction},
                    {"rotation", Axis::y, s, kHipRotation, hip.rotation}});
}

// The joints of the standing leg are climbed from the floor, so their freedoms come in reverse
// order and turn the other way.
void HumanBuilder::add_standing_leg() {
  const Side side = base_side_;
  const double s = side_sign(side);
  const std::string prefix = prefix_of(side);
  const Landmarks::Leg& leg = person_.leg(side);
  const LegFrames& frame = frames_.leg(side);
  LegParts& parts = legs_[index_of(side)];
  const Vec3d stands = settings_.heels ? toes_joint(leg) : leg.ankle;
  body_.base = {frame.foot, stands};
  parts.foot = parts.toes = {kBaseLink, frame.foot, stands};
  if (settings_.heels) parts.foot = add_toes(side, parts.toes, 1.0);
  const Freedom bends{"flexion", Axis::x, 1.0, kAnkleFlexion, hinge_angle(frame.foot, frame.shank)};
  parts.shank = whole() ? add_joint(prefix + "ankle", parts.foot, leg.ankle, frame.shank,
                                    {{"inversion", Axis::z, s, kAnkleInversion}, bends})
                        : add_joint(prefix + "ankle", parts.foot, leg.ankle, frame.shank, {bends});
  parts.thigh =
      add_joint(prefix + "knee", parts.shank, leg.knee, frame.thigh,
                {{"flexion", Axis::x, -1.0, kKneeFlexion, -hinge_angle(frame.shank, frame.thigh)}});
  trunk_ = {add_hip_above(side, parts.thigh, whole() ? kFreeHipFlexion : kHipFlexion)};
  couple_hip(trunk_.front().link, parts.thigh.link);
  add_leg_capsules(side);
  add_standing_masses(side);
  add_foot(side, parts.toes);
}

void HumanBuilder::add_standing_masses(Side side) {
  const Landmarks::Leg& leg = person_.leg(side);
  const LegParts& parts = legs_[index_of(side)];
  LinkMass foot = masses_.foot(side);
  LinkMass shank = masses_.shank(side);
  LinkMass thigh = masses_.thigh(side);
  if (settings_.extent == BodyExtent::half) {
    // the left leg moves as the right one does, shifted along the hinge axis (rule R1)
    const Vec3d axis = parts.foot.frame.cx;
    shift_ = axis * dot(person_.left_leg.ankle - leg.ankle, axis);
    for (LinkMass* part : {&foot, &shank, &thigh}) part->add(part->shifted(shift_));
  }
  if (settings_.heels) {
    set_foot_masses(side);
  } else {
    body_.base_mass = foot.in_frame(parts.foot.frame, leg.ankle);
  }
  set_mass(parts.shank, shank);
  set_mass(parts.thigh, thigh);
}

void HumanBuilder::add_hanging_leg(Side side) {
  const double s = side_sign(side);
  const std::string prefix = prefix_of(side);
  const Landmarks::Leg& leg = person_.leg(side);
  const LegFrames& frame = frames_.leg(side);
  LegParts& parts = legs_[index_of(side)];
  const int first = static_cast<int>(body_.dofs.size());
  parts.thigh = add_hip_below(side, whole() ? kFreeHipFlexion : kHipFlexion);
  parts.shank =
      add_joint(prefix + "knee", parts.thigh, leg.knee, frame.shank,
                {{"flexion", Axis::x, 1.0, kKneeFlexion, hinge_angle(frame.thigh, frame.shank)}});
  const Freedom bends{"flexion", Axis::x, -1.0, kAnkleFlexion,
                      -hinge_angle(frame.shank, frame.foot)};
  parts.foot = whole() ? add_joint(prefix + "ankle", parts.shank, leg.ankle, frame.foot,
                                   {bends, {"inversion", Axis::z, -s, kAnkleInversion}})
                       : add_joint(prefix + "ankle", parts.shank, leg.ankle, frame.foot, {bends});
  parts.toes = settings_.heels ? add_toes(side, parts.foot, -1.0) : parts.foot;
  couple_hip(first, parts.shank.link);
  add_leg_capsules(side);
  set_mass(parts.thigh, masses_.thigh(side));
  set_mass(parts.shank, masses_.shank(side));
  set_foot_masses(side);
  if (other_stands_) add_foot(side, parts.toes);
}

void HumanBuilder::add_arm(Side side) {
  const double s = side_sign(side);
  const std::string prefix = prefix_of(side);
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

void HumanBuilder::couple_hip(int hip, int knee) {
  body_.couplings.push_back(
      {hip, knee, whole() ? kFreeHipFlexionGain : kHipFlexionGain, kHipFlexionKneeFull});
}

void HumanBuilder::set_mass(const Part& part, const LinkMass& mass) {
  MassProperties& link = part.link == kBaseLink ? body_.base_mass : body_.masses[index(part.link)];
  link = mass.in_frame(part.frame, part.origin);
}

// widens limits to the start posture
void HumanBuilder::hold_start_posture() {
  for (std::size_t i = 0; i < body_.dofs.size(); ++i) {
    Dof& dof = body_.dofs[i];
    double upper = dof.upper;
    for (const LimitCoupling& c : body_.couplings) {
      if (c.dof != static_cast<int>(i)) continue;
      const double driver = body_.start[index(c.driver)];
      upper += c.gain * clamp(driver / c.driver_full, 0.0, 1.0);
    }
    const double over = max(body_.start[i] - upper, 0.0);
    const double under = max(dof.lower - body_.start[i], 0.0);
    if (max(over, under) <= 0.0) continue;
    dof.upper += over;
    dof.lower -= under;
    if (max(over, under) < radians(1.0)) continue;
    body_.doubts.push_back(say("start_outside", dof.name, degrees(body_.start[i])));
  }
}

BodyModel build_human(const Landmarks& landmarks, const HumanSettings& settings,
                      std::vector<Message> doubts) {
  return HumanBuilder(landmarks, settings, std::move(doubts)).build();
}

BodyModel half_body(const BodyBuild& s) {
  return build_human(standing_landmarks(s.stature, 0.0),
                     {"half_body", BodyExtent::half, s.stature, s.mass, s.sex});
}

BodyModel full_body(const BodyBuild& s) {
  return build_human(standing_landmarks(s.stature, kStandingToeOut),
                     {"full_body", BodyExtent::full, s.stature, s.mass, s.sex, s.base});
}

BodyModel human_body(const BodyBuild& s) {
  return build_human(standing_landmarks(s.stature, kStandingToeOut), {.name = "human",
                                                                      .extent = BodyExtent::human,
                                                                      .stature = s.stature,
                                                                      .mass = s.mass,
                                                                      .sex = s.sex,
                                                                      .base = s.base,
                                                                      .heels = s.heels});
}

}  // namespace shigusa
