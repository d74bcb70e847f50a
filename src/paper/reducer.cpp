// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "body/joint_name.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "plan/layer.hpp"

namespace shigusa {
namespace {

// Builds the reduced body from the start posture of the whole one.
class Reducer {
 public:
  Reducer(const BodyModel& body, const State& start, const BodyLimbs& limbs)
      : body_(body), start_(start.angles), limbs_(limbs), placed_(placed(body, start)) {
    reduced_.base = body.base();
  }

  ReducedBody reduce() {
    add_carrying_leg(limbs_.legs[0]);
    for (std::size_t i = 1; i < limbs_.legs.size(); ++i) add_planted_leg(limbs_.legs[i]);
    for (const int joint : limbs_.joints) add_joint(joint);
    for (const BodyLimb& arm : limbs_.arms) add_arm(arm);
    return std::move(reduced_);
  }

 private:
  int add(ReducedDof dof) {
    reduced_.dofs.push_back(std::move(dof));
    return static_cast<int>(reduced_.dofs.size()) - 1;
  }

  // Adds the body's dof with another parent and offset.
  int add_like(int dof, int parent, const Vec3d& offset, double start) {
    const Dof& from = body_.dof(dof);
    return add({.name = from.name,
                .parent = parent,
                .offset = offset,
                .axis = from.axis,
                .sign = from.sign,
                .start = start});
  }

  int add_slide(const BodyLimb& limb, int parent, const Vec3d& offset, double sign, double length) {
    const int slide = add({.name = limb.name + ".length",
                           .kind = ReducedDof::Kind::slide,
                           .parent = parent,
                           .offset = offset,
                           .axis = Axis::y,
                           .sign = sign,
                           .start = length});
    reduced_.limbs.push_back({.joints = limb,
                              .slide = slide,
                              .longest = length_at(limb, kLeastBend),
                              .shortest = length_at(limb, body_.dof(limb.hinge).upper)});
    return slide;
  }

  // The length of an arm from shoulder to hand; for a leg in its plane, as its rod lies there.
  static double length_at(const BodyLimb& limb, double bend) {
    const double plane = limb.segments.length(bend);
    if (limb.kind == LimbKind::leg) return plane;
    return sqrt(plane * plane + limb.segments.across() * limb.segments.across());
  }

  // Gives a reduced dof the limits of the body's, widened to its start.
  void hold_to_limits(int dof, int reduced) {
    const Dof& from = body_.dof(dof);
    const double start = start_[static_cast<std::size_t>(dof)];
    ReducedDof& to = reduced_.dofs[static_cast<std::size_t>(reduced)];
    to.lower = std::min(from.lower, start);
    to.upper = std::max(from.upper, start);
  }

  // Limits the lean of the leg added last.
  void limit_lean(const BodyLimb& leg, int lean) {
    hold_to_limits(leg.ankle, lean);
    reduced_.limbs.back().lean = lean;
  }

  // The reduced body's link for the trunk or one of its joints.
  [[nodiscard]] int reduced_link(int link) const {
    if (link == limbs_.trunk) return reduced_.trunk;
    const auto at = std::find_if(reduced_.joints.begin(), reduced_.joints.end(),
                                 [link](const TrunkJoint& joint) { return joint.of_body == link; });
    return at->dof;
  }

  // Adds a dof of the spine or of a clavicle.
  void add_joint(int dof) {
    const Dof& from = body_.dof(dof);
    const double start = start_[static_cast<std::size_t>(dof)];
    const int joint = add_like(dof, reduced_link(from.parent), from.offset, start);
    hold_to_limits(dof, joint);
    ReducedDof& added = reduced_.dofs.back();
    // the joints of the spine share one weight for each of their dofs
    const std::string& freedom = from.part.freedom;
    for (const TrunkJoint& earlier : reduced_.joints) {
      const ReducedDof& other = reduced_.dofs[static_cast<std::size_t>(earlier.dof)];
      if (!is_of_arm(dof) && other.weight_of < 0 &&
          parse_joint_name(other.name).freedom == freedom) {
        added.weight_of = earlier.dof;
      }
    }
    reduced_.joints.push_back({joint, dof});
  }

  // Whether a dof belongs to a clavicle: it moves only one arm.
  [[nodiscard]] bool is_of_arm(int dof) const {
    int arms = 0;
    for (const BodyLimb& arm : limbs_.arms) arms += body_.moves(dof, arm.carrier) ? 1 : 0;
    return arms < static_cast<int>(limbs_.arms.size());
  }

  // Lean and length of a leg in its foot's frame.
  struct LegLine {
    double lean;
    double length;
  };
  [[nodiscard]] LegLine leg_line(const BodyLimb& leg) const {
    const double knee = start_[static_cast<std::size_t>(leg.hinge)];
    const double ankle = start_[static_cast<std::size_t>(leg.ankle)];
    return {ankle + leg.segments.direction(knee), leg.segments.length(knee)};
  }

  // The ball joint's start angles with the limb as a straight rod: like the body's, from another
  // rotation.
  [[nodiscard]] std::vector<double> ball_starts(const BodyLimb& leg, const Mat3d& line) const {
    const Mat3d& trunk = placed_.link_rotation(limbs_.trunk);
    std::vector<double> angles = start_;
    const BallTurns near = leg.turns_of<double>(body_, angles);
    leg.put_turns<double>(body_, ball_turns(transpose(trunk) * line, near), angles);
    return angles;
  }

  // The plane of a leg for the orientation of its foot.
  [[nodiscard]] Mat3d plane_of(const BodyLimb& leg, const Mat3d& foot) const {
    if (leg.inversion < 0) return foot;
    const double turn = body_.dof(leg.inversion).sign * inversion_of(leg);
    return foot * rotation(Axis::z, leg.carries ? turn : -turn);
  }
  [[nodiscard]] double inversion_of(const BodyLimb& leg) const {
    return start_[static_cast<std::size_t>(leg.inversion)];
  }

  void add_carrying_leg(const BodyLimb& leg) {
    const LegLine line = leg_line(leg);
    const Mat3d frame = plane_of(leg, placed_.base_rotation) * rotation(Axis::x, line.lean);
    const std::vector<double> start = ball_starts(leg, frame);
    const auto at = [&start](int dof) { return start[static_cast<std::size_t>(dof)]; };
    int parent = -1;
    Vec3d ankle = body_.dof(leg.ankle).offset;
    if (leg.inversion >= 0) {
      parent = add_like(leg.inversion, -1, body_.dof(leg.inversion).offset, inversion_of(leg));
      ankle = {};
    }
    const int lean = add_like(leg.ankle, parent, ankle, line.lean);
    if (parent >= 0) hold_to_limits(leg.inversion, parent);
    const int slide = add_slide(leg, lean, {leg.segments.across(), 0, 0}, 1.0, line.length);
    if (parent >= 0) limit_lean(leg, lean);
    const int rotation = add_like(leg.rotation, slide, {}, at(leg.rotation));
    const int abduction = add_like(leg.abduction, rotation, {}, at(leg.abduction));
    reduced_.trunk = add_like(leg.flexion, abduction, {}, at(leg.flexion));
  }

  void add_planted_leg(const BodyLimb& leg) {
    const LegLine line = leg_line(leg);
    const Mat3d& foot = placed_.link_rotation(leg.inversion < 0 ? leg.ankle : leg.inversion);
    const std::vector<double> start =
        ball_starts(leg, plane_of(leg, foot) * rotation(Axis::x, line.lean));
    const auto at = [&start](int dof) { return start[static_cast<std::size_t>(dof)]; };
    const int flexion = add_like(leg.flexion, reduced_.trunk, leg.root, at(leg.flexion));
    const int abduction = add_like(leg.abduction, flexion, {}, at(leg.abduction));
    const int rotation = add_like(leg.rotation, abduction, {}, at(leg.rotation));
    const int slide = add_slide(leg, rotation, {-leg.segments.across(), 0, 0}, -1.0, line.length);
    const int lean = add_like(leg.ankle, slide, {}, line.lean);
    if (leg.inversion < 0) return;
    limit_lean(leg, lean);
    hold_to_limits(leg.inversion, add_like(leg.inversion, lean, {}, inversion_of(leg)));
    share_weights_of_legs();
  }

  // Makes both legs share one weight for each dof, as in the preset flat.
  void share_weights_of_legs() {
    for (std::size_t d = 0; d < reduced_.dofs.size(); ++d) {
      ReducedDof& dof = reduced_.dofs[d];
      for (std::size_t e = 0; e < d && dof.kind == ReducedDof::Kind::hinge; ++e) {
        const std::string& other = reduced_.dofs[e].name;
        if (without_side(other) == without_side(dof.name)) dof.weight_of = static_cast<int>(e);
      }
    }
  }

  void add_arm(const BodyLimb& arm) {
    const Effector& effector = body_.effectors()[static_cast<std::size_t>(arm.effector)];
    const Vec3d shoulder = placed_.origin[static_cast<std::size_t>(arm.flexion)];
    const Vec3d hand = placed_.point(effector.link, effector.point);
    // Rx(x) · Rz(z) turns -y to the hand's direction
    const Vec3d line = transpose_times(placed_.link_rotation(arm.carrier), hand - shoulder);
    const Vec3d up = -line;
    const double z = atan2(-up.x, sqrt(up.y * up.y + up.z * up.z));
    const double x = atan2(up.z, up.y);
    const int carrier = reduced_link(arm.carrier);
    const int flexion = add_like(arm.flexion, carrier, arm.root, x * body_.dof(arm.flexion).sign);
    const int abduction = add_like(arm.abduction, flexion, {}, z * body_.dof(arm.abduction).sign);
    add_slide(arm, abduction, {}, -1.0, norm(line));
    ReducedLimb& limb = reduced_.limbs.back();
    limb.carrier = carrier;
    for (const TrunkJoint& joint : reduced_.joints) {
      if (!is_of_arm(joint.of_body) || !body_.moves(joint.of_body, arm.carrier)) continue;
      const JointPlace& part = body_.dof(joint.of_body).part;
      if (part.is(JointKind::clavicle, FreedomKind::elevation)) limb.elevation = joint.dof;
      if (part.is(JointKind::clavicle, FreedomKind::protraction)) limb.protraction = joint.dof;
    }
  }

  const BodyModel& body_;
  const std::vector<double>& start_;  // (dofs) rad
  const BodyLimbs& limbs_;
  Kinematics<double> placed_;
  ReducedBody reduced_;
};

}  // namespace

ReducedBody reduced_body(const BodyModel& body, const State& start, const BodyLimbs& limbs) {
  return Reducer(body, start, limbs).reduce();
}

}  // namespace shigusa
