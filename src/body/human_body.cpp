// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/body/human_body.hpp>
#include <tuple>

#include "human_frames.hpp"
#include "segment_mass.hpp"

namespace shigusa {
namespace {

std::string side_name(Side side) { return side == Side::left ? "left" : "right"; }
Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

// Builds the definition link by link; each step adds what hangs on the links before it.
class HumanBuilder {
 public:
  HumanBuilder(const Landmarks& person, const HumanSettings& settings,
               std::vector<std::string> doubts)
      : person_(person),
        settings_(settings),
        frames_(human_frames(person)),
        table_(segment_table(settings.sex)),
        masses_(person, frames_, table_, settings.mass, settings.stature) {
    body_.doubts = std::move(doubts);
    const double right_above = person.right_leg.ankle.y - person.left_leg.ankle.y;
    const bool full = settings.extent == BodyExtent::full;
    base_side_ = full && right_above > kLiftedFoot ? Side::left : Side::right;
    other_stands_ = full && (right_above < 0 ? -right_above : right_above) <= kLiftedFoot;
  }

  BodyModel build() {
    body_.name = settings_.name;
    body_.stature = settings_.stature;
    add_standing_leg();
    add_arm(Side::right);
    if (settings_.extent == BodyExtent::full) {
      add_arm(Side::left);
      add_hanging_leg(other(base_side_));
      if (!other_stands_) {
        body_.doubts.push_back(fmt::format(
            "the {} foot is lifted at the start: it carries nothing and keeps its angles",
            side_name(other(base_side_))));
      }
    }
    add_nodes();
    hold_start_posture();
    body_.mass = body_.base_mass.mass;
    for (const MassProperties& link : body_.masses) body_.mass += link.mass;
    return BodyModel(std::move(body_));
  }

 private:
  int add_dof(const std::string& joint, const char* freedom, int parent, const Vec3d& offset,
              Axis axis, double sign, const JointLimits& limits, double start) {
    const double strength = strength_ * (joint_is_leg(joint) ? leg_strength_ : 1.0);
    body_.dofs.push_back({.joint = joint,
                          .name = joint + "." + freedom,
                          .parent = parent,
                          .offset = offset,
                          .axis = axis,
                          .sign = sign,
                          .lower = limits.lower,
                          .upper = limits.upper,
                          .torque_positive = limits.torque_positive * strength,
                          .torque_negative = limits.torque_negative * strength});
    body_.masses.emplace_back();
    body_.start.push_back(start);
    return static_cast<int>(body_.dofs.size()) - 1;
  }

  static bool joint_is_leg(const std::string& joint) {
    return !joint.ends_with("shoulder") && !joint.ends_with("elbow");
  }

  // a point of the start posture in the frame of a link whose origin is at `origin`
  static Vec3d local(const Mat3d& frame, const Vec3d& origin, const Vec3d& point) {
    return transpose_times(frame, point - origin);
  }

  void add_standing_leg() {
    const Side side = base_side_;
    const double s = side_sign(side);
    const std::string prefix = side_name(side) + "_";
    const Landmarks::Leg& leg = person_.leg(side);
    const LegFrames& frame = frames_.leg(side);
    if (settings_.extent == BodyExtent::half) leg_strength_ = 2.0;
    strength_ =
        settings_.mass / table_.mean_mass * (settings_.sex == Sex::female ? kFemaleStrength : 1.0);
    body_.base = {frame.foot, leg.ankle};
    const int ankle = add_dof(prefix + "ankle", "flexion", kBaseLink, {}, Axis::x, 1.0,
                              kAnkleFlexion, hinge_angle(frame.foot, frame.shank));
    const int knee =
        add_dof(prefix + "knee", "flexion", ankle, local(frame.shank, leg.ankle, leg.knee), Axis::x,
                -1.0, kKneeFlexion, -hinge_angle(frame.shank, frame.thigh));
    const BallAngles hip = ball_angles(transpose(frames_.trunk) * frame.thigh, side);
    const std::string joint = prefix + "hip";
    // the joint is climbed from the thigh, so its rotations come in reverse order
    const int rotation = add_dof(joint, "rotation", knee, local(frame.thigh, leg.knee, leg.hip),
                                 Axis::y, -s, kHipRotation, hip.rotation);
    const int abduction =
        add_dof(joint, "abduction", rotation, {}, Axis::z, -s, kHipAbduction, hip.abduction);
    trunk_ = add_dof(joint, "flexion", abduction, {}, Axis::x, 1.0, kHipFlexion, hip.flexion);
    couple_hip(trunk_, knee);
    add_capsule(prefix + "thigh", knee, frame.thigh, leg.knee, leg.knee, leg.hip, kThighRadius);
    add_trunk_capsule();
    trunk_origin_ = leg.hip;
    add_standing_masses(side, ankle, knee);
    add_foot(side, kBaseLink, frame.foot, leg.ankle);
  }

  void add_standing_masses(Side side, int ankle, int knee) {
    const Landmarks::Leg& leg = person_.leg(side);
    const LegFrames& frame = frames_.leg(side);
    LinkMass foot = masses_.foot(side);
    LinkMass shank = masses_.shank(side);
    LinkMass thigh = masses_.thigh(side);
    LinkMass trunk = masses_.trunk_and_head();
    if (settings_.extent == BodyExtent::half) {
      // the left leg moves as the right one does, shifted along the hinge axis (rule R1)
      const Vec3d axis = frame.foot.cx;
      shift_ = axis * dot(person_.left_leg.ankle - leg.ankle, axis);
      for (LinkMass* part : {&foot, &shank, &thigh}) part->add(part->shifted(shift_));
      trunk.add(masses_.arm(Side::left));
    }
    body_.base_mass = foot.in_frame(frame.foot, leg.ankle);
    set_mass(ankle, shank.in_frame(frame.shank, leg.ankle));
    set_mass(knee, thigh.in_frame(frame.thigh, leg.knee));
    set_mass(trunk_, trunk.in_frame(frames_.trunk, trunk_origin_));
  }

  void add_arm(Side side) {
    const double s = side_sign(side);
    const std::string prefix = side_name(side) + "_";
    const Landmarks::Arm& arm = person_.arm(side);
    const ArmFrames& frame = frames_.arm(side);
    const BallAngles shoulder = ball_angles(transpose(frames_.trunk) * frame.upper_arm, side);
    const std::string joint = prefix + "shoulder";
    const int flexion =
        add_dof(joint, "flexion", trunk_, local(frames_.trunk, trunk_origin_, arm.shoulder),
                Axis::x, -1.0, kShoulderFlexion, shoulder.flexion);
    const int abduction = add_dof(joint, "abduction", flexion, {}, Axis::z, s, kShoulderAbduction,
                                  shoulder.abduction);
    const int upper =
        add_dof(joint, "rotation", abduction, {}, Axis::y, s, kShoulderRotation, shoulder.rotation);
    const int fore =
        add_dof(prefix + "elbow", "flexion", upper, local(frame.upper_arm, arm.shoulder, arm.elbow),
                Axis::x, -1.0, kElbowFlexion, -hinge_angle(frame.upper_arm, frame.forearm));
    add_capsule(prefix + "forearm", fore, frame.forearm, arm.elbow, arm.elbow, arm.fingertip,
                kForearmRadius);
    set_mass(upper, masses_.upper_arm(side).in_frame(frame.upper_arm, arm.shoulder));
    set_mass(fore, masses_.forearm_and_hand(side).in_frame(frame.forearm, arm.elbow));
    const Vec3d grip = arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction;
    body_.effectors.push_back({prefix + "hand", prefix + "hand_grip", fore,
                               local(frame.forearm, arm.elbow, grip), flexion});
  }

  void add_hanging_leg(Side side) {
    const double s = side_sign(side);
    const std::string prefix = side_name(side) + "_";
    const Landmarks::Leg& leg = person_.leg(side);
    const LegFrames& frame = frames_.leg(side);
    const BallAngles hip = ball_angles(transpose(frames_.trunk) * frame.thigh, side);
    const std::string joint = prefix + "hip";
    const int flexion =
        add_dof(joint, "flexion", trunk_, local(frames_.trunk, trunk_origin_, leg.hip), Axis::x,
                -1.0, kHipFlexion, hip.flexion);
    const int abduction =
        add_dof(joint, "abduction", flexion, {}, Axis::z, s, kHipAbduction, hip.abduction);
    const int thigh =
        add_dof(joint, "rotation", abduction, {}, Axis::y, s, kHipRotation, hip.rotation);
    const int shank =
        add_dof(prefix + "knee", "flexion", thigh, local(frame.thigh, leg.hip, leg.knee), Axis::x,
                1.0, kKneeFlexion, hinge_angle(frame.thigh, frame.shank));
    const int foot =
        add_dof(prefix + "ankle", "flexion", shank, local(frame.shank, leg.knee, leg.ankle),
                Axis::x, -1.0, kAnkleFlexion, -hinge_angle(frame.shank, frame.foot));
    couple_hip(flexion, shank);
    add_capsule(prefix + "thigh", thigh, frame.thigh, leg.hip, leg.hip, leg.knee, kThighRadius);
    set_mass(thigh, masses_.thigh(side).in_frame(frame.thigh, leg.hip));
    set_mass(shank, masses_.shank(side).in_frame(frame.shank, leg.knee));
    set_mass(foot, masses_.foot(side).in_frame(frame.foot, leg.ankle));
    if (other_stands_) add_foot(side, foot, frame.foot, leg.ankle);
  }

  void add_capsule(const std::string& name, int link, const Mat3d& frame, const Vec3d& origin,
                   const Vec3d& from, const Vec3d& to, double radius) {
    body_.capsules.push_back({name, link, local(frame, origin, from), local(frame, origin, to),
                              radius * settings_.stature});
  }

  void add_trunk_capsule() {
    const Vec3d hips = (person_.left_leg.hip + person_.right_leg.hip) * 0.5;
    const Vec3d shoulders = (person_.left_arm.shoulder + person_.right_arm.shoulder) * 0.5;
    // the ends are round: they begin a radius within
    const Vec3d inset = normalized(shoulders - hips) * (kTrunkRadius * settings_.stature);
    add_capsule("trunk", trunk_, frames_.trunk, trunk_origin_, hips, shoulders - inset,
                kTrunkRadius);
  }

  void set_mass(int link, const MassProperties& mass) {
    body_.masses[static_cast<std::size_t>(link)] = mass;
  }

  void couple_hip(int hip, int knee) {
    body_.couplings.push_back({hip, knee, kHipFlexionGain, kHipFlexionKneeFull});
  }

  void add_foot(Side side, int link, const Mat3d& frame, const Vec3d& ankle) {
    Foot foot{.name = side_name(side) + "_foot",
              .node = side_name(side) + "_foot",
              .link = link,
              .centre = {},
              .outline = {}};
    const SoleOutline sole = sole_outline(person_.leg(side), settings_.stature);
    std::vector<Vec3d> corners(sole.begin(), sole.end());
    if (settings_.extent == BodyExtent::half) {
      // the sole of the foot that is not drawn carries weight too
      for (const Vec3d& corner : sole) corners.push_back(corner + shift_);
    }
    Vec3d sum{};
    for (const Vec3d& corner : corners) {
      foot.outline.push_back(local(frame, ankle, corner));
      sum += foot.outline.back();
    }
    foot.centre = sum * (1.0 / static_cast<double>(corners.size()));
    body_.feet.push_back(std::move(foot));
  }

  int add_node(const std::string& name, int parent, int link, const Mat3d& frame,
               const Vec3d& origin, const Vec3d& point, bool end_site = false) {
    body_.nodes.push_back({name, parent, link, local(frame, origin, point), end_site});
    return static_cast<int>(body_.nodes.size()) - 1;
  }

  void add_nodes() {
    const Vec3d mid_hip = (person_.left_leg.hip + person_.right_leg.hip) * 0.5;
    const Vec3d mid_shoulder = (person_.left_arm.shoulder + person_.right_arm.shoulder) * 0.5;
    const auto trunk_node = [&](const char* name, int parent, const Vec3d& point, bool end) {
      return add_node(name, parent, trunk_, frames_.trunk, trunk_origin_, point, end);
    };
    const int hips = trunk_node("hips", -1, mid_hip, false);
    const int chest = trunk_node("chest", hips, mid_hip + (mid_shoulder - mid_hip) * 0.6, false);
    const int neck = trunk_node("neck", chest, person_.neck, false);
    const Vec3d head = person_.neck + (person_.head_top - person_.neck) * 0.35;
    trunk_node("", trunk_node("head", neck, head, false), person_.head_top, true);
    for (const Side side : {Side::left, Side::right}) {
      if (side == Side::left && settings_.extent == BodyExtent::half) {
        // the still limbs are not shown (paper, section 4), but the trunk that they hang on is
        const Vec3d stub = (mid_hip - mid_shoulder) * 0.05;
        for (const auto& [name, parent, at] :
             {std::tuple{"left_upper_arm", chest, person_.left_arm.shoulder},
              std::tuple{"left_upper_leg", hips, person_.left_leg.hip}}) {
          trunk_node("", trunk_node(name, parent, at, false), at + stub, true);
        }
        continue;
      }
      add_arm_nodes(side, chest);
      add_leg_nodes(side, hips);
    }
  }

  void add_arm_nodes(Side side, int chest) {
    const std::string prefix = side_name(side) + "_";
    const Landmarks::Arm& arm = person_.arm(side);
    const ArmFrames& frame = frames_.arm(side);
    const int upper = *find(prefix + "shoulder.rotation");
    const int fore = *find(prefix + "elbow.flexion");
    const auto fore_node = [&](const std::string& name, int parent, const Vec3d& p, bool end) {
      return add_node(name, parent, fore, frame.forearm, arm.elbow, p, end);
    };
    const int a =
        add_node(prefix + "upper_arm", chest, upper, frame.upper_arm, arm.shoulder, arm.shoulder);
    const int b = fore_node(prefix + "lower_arm", a, arm.elbow, false);
    const int c = fore_node(prefix + "hand", b, arm.wrist, false);
    const Vec3d grip = arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction;
    fore_node("", fore_node(prefix + "hand_grip", c, grip, false), arm.fingertip, true);
  }

  void add_leg_nodes(Side side, int hips) {
    const std::string prefix = side_name(side) + "_";
    const Landmarks::Leg& leg = person_.leg(side);
    const LegFrames& frame = frames_.leg(side);
    const bool standing = side == base_side_;
    // a link's frame has its origin at the joint nearer to the base
    const int thigh = *find(prefix + (standing ? "knee.flexion" : "hip.rotation"));
    const int shank = *find(prefix + (standing ? "ankle.flexion" : "knee.flexion"));
    const int foot = standing ? kBaseLink : *find(prefix + "ankle.flexion");
    const int a = add_node(prefix + "upper_leg", hips, thigh, frame.thigh,
                           standing ? leg.knee : leg.hip, leg.hip);
    const int b = add_node(prefix + "lower_leg", a, shank, frame.shank,
                           standing ? leg.ankle : leg.knee, leg.knee);
    const int c = add_node(prefix + "foot", b, foot, frame.foot, leg.ankle, leg.ankle);
    const Vec3d ball = leg.ankle + (leg.toe - leg.ankle) * 0.7;
    const int d = add_node(prefix + "toes", c, foot, frame.foot, leg.ankle, ball);
    add_node("", d, foot, frame.foot, leg.ankle, leg.toe, true);
  }

  [[nodiscard]] std::optional<int> find(const std::string& name) const {
    for (std::size_t i = 0; i < body_.dofs.size(); ++i) {
      if (body_.dofs[i].name == name) return static_cast<int>(i);
    }
    return std::nullopt;
  }

  // widens limits to the start posture
  void hold_start_posture() {
    for (std::size_t i = 0; i < body_.dofs.size(); ++i) {
      Dof& dof = body_.dofs[i];
      double upper = dof.upper;
      for (const LimitCoupling& c : body_.couplings) {
        if (c.dof != static_cast<int>(i)) continue;
        const double driver = body_.start[static_cast<std::size_t>(c.driver)];
        upper += c.gain * clamp(driver / c.driver_full, 0.0, 1.0);
      }
      const double over = max(body_.start[i] - upper, 0.0);
      const double under = max(dof.lower - body_.start[i], 0.0);
      if (max(over, under) <= 0.0) continue;
      dof.upper += over;
      dof.lower -= under;
      if (max(over, under) < radians(1.0)) continue;
      body_.doubts.push_back(fmt::format(
          "the start posture has {} at {:.0f}°, outside its limits: they are widened to hold it",
          dof.name, degrees(body_.start[i])));
    }
  }

  const Landmarks& person_;
  const HumanSettings& settings_;
  HumanFrames frames_;
  const SegmentTable& table_;
  SegmentMasses masses_;
  BodyDefinition body_;
  Side base_side_ = Side::right;
  bool other_stands_ = false;
  double strength_ = 1.0;
  double leg_strength_ = 1.0;
  int trunk_ = kBaseLink;
  Vec3d trunk_origin_{};
  Vec3d shift_{};  // from the right leg to the left leg's mass (half extent)
};

}  // namespace

BodyModel build_human(const Landmarks& landmarks, const HumanSettings& settings,
                      std::vector<std::string> doubts) {
  return HumanBuilder(landmarks, settings, std::move(doubts)).build();
}

BodyModel half_body(const Stature& s) {
  return build_human(standing_landmarks(s.stature, 0.0),
                     {"half_body", BodyExtent::half, s.stature, s.mass, s.sex});
}

BodyModel full_body(const Stature& s) {
  return build_human(standing_landmarks(s.stature, kStandingToeOut),
                     {"full_body", BodyExtent::full, s.stature, s.mass, s.sex});
}

}  // namespace shigusa
