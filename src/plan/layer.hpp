// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <shigusa/parameters.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/body_limbs.hpp"
#include "plan/parameter_info.hpp"

namespace shigusa {

inline constexpr double kUnlimited = 1e9;  // rad

// One dof of a reduced body, with the link that it moves: a hinge turns about `axis`, a slide moves
// along it.
struct ReducedDof {
  enum class Kind { hinge, slide };
  std::string name;  // "right_hip.flexion", "right_leg.length"
  Kind kind = Kind::hinge;
  int parent = -1;      // link that carries it: an earlier dof, or -1 for the base
  Vec3d offset{};       // m, in the parent's frame: a hinge's centre, or a slide's position at 0 m
  Axis axis = Axis::x;  // in the parent's frame
  double sign = 1.0;    // direction along the axis
  double start = 0.0;   // rad or m
  int weight_of = -1;   // an earlier dof whose weight it shares; -1: its own
  double lower = -kUnlimited;  // rad, where limits are held
  double upper = kUnlimited;   // rad
};

// Course of a limb's length from the start to the final one.
enum class LengthLaw {
  schedule,  // with minimum jerk (rule R3)
  path,  // reduced, if the shoulder can stay, by half of the hand's approach to it on its path: an
         // arm that rises in front bends meanwhile
};

// A limb of a reduced body: a telescopic limb (paper, section 3.4), one rigid rod of variable
// length.
struct ReducedLimb {
  BodyLimb joints;  // the limb of the whole body
  int slide = 0;    // dof of its length
  // for a leg with an ankle that inverts: dof of its line's lean, with the ankle's limits; else -1
  int lean = -1;
  int carrier = -1;  // for an arm: link of its shoulder
  // for an arm on a clavicle that follows it by PostureLaw: dofs, else -1
  int elevation = -1;
  int protraction = -1;
  double longest = 0.0;   // m, hand to shoulder or ankle to hip in the leg's plane: contraction 0
  double shortest = 0.0;  // m: contraction 1
  LengthLaw law = LengthLaw::schedule;  // for an arm with a goal
};

// A dof of a reduced body that is the same as the whole body's: of the spine or a clavicle.
struct TrunkJoint {
  int dof = 0;      // of the reduced body
  int of_body = 0;  // of the whole body
};

// A body with fewer dofs, moved by a layer.
struct ReducedBody {
  Transformd base{};
  std::vector<ReducedDof> dofs;
  int trunk = -1;                  // link
  std::vector<TrunkJoint> joints;  // parents of the arms, from the trunk on
  std::vector<ReducedLimb> limbs;  // legs, then arms
};

// The body of the upper layer: the trunk with its joints, in the start posture, and its limbs as
// telescopic rods (paper, section 3.4).
[[nodiscard]] ReducedBody reduced_body(const BodyModel& body, const State& start,
                                       const BodyLimbs& limbs);

// Method by which a layer's result for a limb determines the limb's joints below.
enum class DelegateMethod {
  closed_form,   // joints follow from the ends of the limb
  limb_library,  // another layer moves the limb along the same path by weights
  swivel,        // joints follow from the ends and from the swivel chosen by another layer
};

struct Delegate {
  int limb = 0;  // of the layer's body
  DelegateMethod by = DelegateMethod::closed_form;
  std::string layer;   // name of the layer below; empty for closed_form
  std::string idle{};  // layer of the limb while it is idle; empty: it stays as it is
};

// One layer of a hierarchy (paper, section 3.4), as data: a body with fewer dofs than the one
// below, its searched parameters, the criteria of its motions, and its results for the layers
// below.
struct Layer {
  std::string name;
  ReducedBody body;
  std::vector<ParameterInfo> parameters;
  CriteriaSettings criteria;
  std::vector<Delegate> delegates;
};

// The paper's two layers for a body: first the trunk with arms and legs of variable length, scored
// by `criteria` after its limbs have been expanded; then one layer for each arm, scored by joint
// range and torque. Fails for a body that is not a person's (find_limbs).
[[nodiscard]] Result<std::vector<Layer>> paper_layers(
    const BodyModel& body, const State& start, const CriteriaSettings& criteria = {},
    LayerReading reading = LayerReading::shared_contractions);

// Range of an elbow's swivel relative to the hand's path alone (rad, outwards).
inline constexpr double kSwivelMin = radians(-60.0);
inline constexpr double kSwivelMax = radians(90.0);

// Three layers: the paper's upper one; then for each arm the swivel of its elbow, the only dof of
// an arm of four that a hand's path leaves free; then "rest", the final angles of idle limbs,
// scored by `criteria` on the whole body, so that a free arm balances the others, and by its own
// torque, so that it hangs unless needed. On a body with a neck PostureLaw moves head, clavicles
// and the free shoulder, and "rest" has only the free elbow; its arms have wrists, which turn the
// hands. Fails as paper_layers does.
[[nodiscard]] Result<std::vector<Layer>> human_layers(
    const BodyModel& body, const State& start, const CriteriaSettings& criteria = {},
    LayerReading reading = LayerReading::shared_contractions);

// The layers of a body, and the reading of the first.
struct LayerChoice {
  LayerStack stack = LayerStack::paper;
  LayerReading reading = LayerReading::shared_contractions;
};
[[nodiscard]] Result<std::vector<Layer>> make_layers(const BodyModel& body, const State& start,
                                                     const LayerChoice& choice,
                                                     const CriteriaSettings& criteria = {});

// Whether a layer searches parameters of this kind.
[[nodiscard]] bool searches(const Layer& layer, ParameterKind kind);

// Least bend of the longest limb that a layer requests: a straight limb cannot be lengthened by any
// joint velocity (rule R3).
inline constexpr double kLeastBend = radians(5.0);

}  // namespace shigusa
