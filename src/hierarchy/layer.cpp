// SPDX-License-Identifier: MIT
#include <array>
#include <shigusa/hierarchy/layer.hpp>
#include <shigusa/kinematics/forward_kinematics.hpp>
#include <utility>

namespace shigusa {
namespace {

// Builds the reduced body from the start posture of the whole one.
class Reducer {
 public:
  Reducer(const BodyModel& body, const BodyLimbs& limbs)
      : body_(body), limbs_(limbs), placed_(body) {
    forward_kinematics<double>(body, body.start(), placed_);
    reduced_.base = body.base();
  }

  ReducedBody reduce() {
    add_carrying_leg(limbs_.legs[0]);
    for (std::size_t i = 1; i < limbs_.legs.size(); ++i) add_planted_leg(limbs_.legs[i]);
    for (const BodyLimb& arm : limbs_.arms) add_arm(arm);
    return std::move(reduced_);
  }

 private:
  int add(ReducedDof dof) {
    reduced_.dofs.push_back(std::move(dof));
    return static_cast<int>(reduced_.dofs.size()) - 1;
  }

  // the body's dof with another parent and place
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

  // Of an arm from shoulder to hand; of a leg in its plane, where its length is what changes.
  static double length_at(const BodyLimb& limb, double bend) {
    const double plane = limb.segments.length(bend);
    if (limb.kind == LimbKind::leg) return plane;
    return sqrt(plane * plane + limb.segments.across() * limb.segments.across());
  }

  // lean and length of a leg in its foot's frame
  struct LegLine {
    double lean;
    double length;
  };
  [[nodiscard]] LegLine leg_line(const BodyLimb& leg) const {
    const double knee = body_.start()[static_cast<std::size_t>(leg.hinge)];
    const double ankle = body_.start()[static_cast<std::size_t>(leg.ankle)];
    return {ankle + leg.segments.direction(knee), leg.segments.length(knee)};
  }

  // the ball joint's angles where the limb is its line: as the body's, from another rotation
  [[nodiscard]] std::vector<double> ball_starts(const BodyLimb& leg, const Mat3d& line) const {
    const Mat3d& trunk = placed_.link_rotation(limbs_.trunk);
    std::vector<double> angles(body_.start().begin(), body_.start().end());
    const BallTurns near = leg.turns_of(body_, angles);
    leg.put_turns(body_, ball_turns(transpose(trunk) * line, near), angles);
    return angles;
  }

  void add_carrying_leg(const BodyLimb& leg) {
    const LegLine line = leg_line(leg);
    const Mat3d frame = placed_.base_rotation * rotation(Axis::x, line.lean);
    const std::vector<double> start = ball_starts(leg, frame);
    const auto at = [&start](int dof) { return start[static_cast<std::size_t>(dof)]; };
    const int lean = add_like(leg.ankle, -1, body_.dof(leg.ankle).offset, line.lean);
    const int slide = add_slide(leg, lean, {leg.segments.across(), 0, 0}, 1.0, line.length);
    const int rotation = add_like(leg.rotation, slide, {}, at(leg.rotation));
    const int abduction = add_like(leg.abduction, rotation, {}, at(leg.abduction));
    reduced_.trunk = add_like(leg.flexion, abduction, {}, at(leg.flexion));
  }

  void add_planted_leg(const BodyLimb& leg) {
    const LegLine line = leg_line(leg);
    const Mat3d& foot = placed_.link_rotation(leg.ankle);
    const std::vector<double> start = ball_starts(leg, foot * rotation(Axis::x, line.lean));
    const auto at = [&start](int dof) { return start[static_cast<std::size_t>(dof)]; };
    const int flexion = add_like(leg.flexion, reduced_.trunk, leg.root, at(leg.flexion));
    const int abduction = add_like(leg.abduction, flexion, {}, at(leg.abduction));
    const int rotation = add_like(leg.rotation, abduction, {}, at(leg.rotation));
    const int slide = add_slide(leg, rotation, {-leg.segments.across(), 0, 0}, -1.0, line.length);
    add_like(leg.ankle, slide, {}, line.lean);
  }

  void add_arm(const BodyLimb& arm) {
    const Effector& effector = body_.effectors()[static_cast<std::size_t>(arm.effector)];
    const Vec3d shoulder = placed_.origin[static_cast<std::size_t>(arm.flexion)];
    const Vec3d hand = placed_.point(effector.link, effector.point);
    // Rx(x) · Rz(z) brings -y to the hand's direction
    const Vec3d way = transpose_times(placed_.link_rotation(limbs_.trunk), hand - shoulder);
    const Vec3d up = -way;
    const double z = atan2(-up.x, sqrt(up.y * up.y + up.z * up.z));
    const double x = atan2(up.z, up.y);
    const int flexion =
        add_like(arm.flexion, reduced_.trunk, arm.root, x * body_.dof(arm.flexion).sign);
    const int abduction = add_like(arm.abduction, flexion, {}, z * body_.dof(arm.abduction).sign);
    add_slide(arm, abduction, {}, -1.0, norm(way));
  }

  const BodyModel& body_;
  const BodyLimbs& limbs_;
  Kinematics<double> placed_;
  ReducedBody reduced_;
};

void add_weight(Layer& layer, int dof) {
  layer.genes.push_back(
      {layer.body.dofs[static_cast<std::size_t>(dof)].name, LayerGeneKind::weight, {dof}});
}

// one gene for each freedom that is no length, in the body's order
void add_weights(Layer& layer, LayerReading reading) {
  for (std::size_t d = 0; d < layer.body.dofs.size(); ++d) {
    const ReducedDof& dof = layer.body.dofs[d];
    if (dof.kind == ReducedDof::Kind::slide) continue;
    if (reading == LayerReading::contraction_a_limb && dof.axis == Axis::y) continue;
    add_weight(layer, static_cast<int>(d));
  }
}

void add_contractions(Layer& layer, LayerReading reading) {
  const auto limbs_of = [&layer](LimbKind kind) {
    std::vector<int> limbs;
    for (std::size_t i = 0; i < layer.body.limbs.size(); ++i) {
      if (layer.body.limbs[i].joints.kind == kind) limbs.push_back(static_cast<int>(i));
    }
    return limbs;
  };
  for (const auto& [kind, name] : {std::pair{LimbKind::leg, "legs"}, {LimbKind::arm, "arms"}}) {
    const std::vector<int> limbs = limbs_of(kind);
    if (reading == LayerReading::shared_contractions) {
      layer.genes.push_back(
          {std::string(name) + ".contraction", LayerGeneKind::contraction, limbs});
      continue;
    }
    for (const int limb : limbs) {
      const std::string& of = layer.body.limbs[static_cast<std::size_t>(limb)].joints.name;
      layer.genes.push_back({of + ".contraction", LayerGeneKind::contraction, {limb}});
    }
  }
}

// The arm alone, hung from the trunk (paper, section 3.4): four hinges.
Layer arm_layer(const BodyModel& body, const BodyLimb& arm) {
  Layer layer{.name = arm.name, .body = {}, .genes = {}, .criteria = {}, .hands_down = {}};
  layer.criteria.balance_weight = 0.0;  // with the trunk held there is nothing to balance
  int parent = -1;
  for (const int dof : {arm.flexion, arm.abduction, arm.rotation, arm.hinge}) {
    const Dof& from = body.dof(dof);
    layer.body.dofs.push_back({.name = from.name,
                               .parent = parent,
                               .offset = from.offset,
                               .axis = from.axis,
                               .sign = from.sign,
                               .start = body.start()[static_cast<std::size_t>(dof)]});
    parent = static_cast<int>(layer.body.dofs.size()) - 1;
    add_weight(layer, parent);
  }
  return layer;
}

}  // namespace

std::string_view layer_reading_name(LayerReading reading) {
  switch (reading) {
    case LayerReading::shared_contractions:
      return "shared_contractions";
    case LayerReading::contraction_a_limb:
      return "contraction_a_limb";
  }
  return "";
}

std::span<const LayerReading> layer_readings() {
  static constexpr std::array kReadings{LayerReading::shared_contractions,
                                        LayerReading::contraction_a_limb};
  return kReadings;
}

Result<std::vector<Layer>> paper_layers(const BodyModel& body, const CriteriaSettings& criteria,
                                        LayerReading reading) {
  const Result<BodyLimbs> limbs = find_limbs(body);
  if (!limbs) return tl::unexpected(limbs.error());
  Layer upper{.name = "trunk_and_limb_lengths",
              .body = Reducer(body, *limbs).reduce(),
              .genes = {},
              .criteria = criteria,
              .hands_down = {}};
  add_weights(upper, reading);
  add_contractions(upper, reading);
  for (std::size_t i = 0; i < upper.body.limbs.size(); ++i) {
    const BodyLimb& limb = upper.body.limbs[i].joints;
    const bool leg = limb.kind == LimbKind::leg;
    upper.hands_down.push_back({static_cast<int>(i),
                                leg ? Handover::closed_form : Handover::limb_library,
                                leg ? "" : limb.name});
  }
  std::vector<Layer> layers{std::move(upper)};
  for (const BodyLimb& arm : limbs->arms) layers.push_back(arm_layer(body, arm));
  return layers;
}

}  // namespace shigusa
