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

// One freedom of a reduced body, and the link that it moves: a hinge turns about `axis`, a slide
// moves along it.
struct ReducedDof {
  enum class Kind { hinge, slide };
  std::string name;  // "right_hip.flexion", "right_leg.length"
  Kind kind = Kind::hinge;
  int parent = -1;      // link that carries it: an earlier dof, or -1 for the base
  Vec3d offset{};       // m, in the parent's frame: a hinge's centre, or where a slide of 0 m is
  Axis axis = Axis::x;  // in the parent's frame …
  double sign = 1.0;    // … and its direction
  double start = 0.0;   // rad or m
  int weight_of = -1;   // an earlier dof whose weight it goes by; -1: its own
  double lower = -kUnlimited;  // rad, where limits are held
  double upper = kUnlimited;   // rad
};

// How the length of a limb goes from the start to the final one.
enum class LengthLaw {
  schedule,  // with minimum jerk (rule R3)
  path,  // less, where the shoulder can stay, by half of what the hand on its path is nearer to it:
         // an arm that goes up in front bends meanwhile
};

// A limb of a reduced body: a telescopic limb (paper, section 3.4), one rigid rod of variable
// length.
struct ReducedLimb {
  BodyLimb joints;  // what it stands for
  int slide = 0;    // dof that is its length
  // of a leg whose ankle inverts: dof of its line's lean, whose limits are the ankle's; else -1
  int lean = -1;
  int carrier = -1;  // of an arm: link that its shoulder is in
  // of an arm on a clavicle, which goes with it by PostureLaw: dofs, else -1
  int elevation = -1;
  int protraction = -1;
  double longest = 0.0;   // m, hand to shoulder or ankle to hip in the leg's plane: contraction 0
  double shortest = 0.0;  // m: contraction 1
  LengthLaw law = LengthLaw::schedule;  // of an arm that has a goal
};

// A freedom that a reduced body has as the whole one has it: of the spine or a clavicle.
struct TrunkJoint {
  int dof = 0;      // of the reduced body
  int of_body = 0;  // of the whole one
};

// A body with fewer freedoms, on which a layer moves.
struct ReducedBody {
  Transformd base{};
  std::vector<ReducedDof> dofs;
  int trunk = -1;                  // link
  std::vector<TrunkJoint> joints;  // what arms hang on, from the trunk on
  std::vector<ReducedLimb> limbs;  // legs, then arms
};

// The body on which the upper layer moves: the trunk with its joints, as the body starts, and its
// limbs as telescopic rods (paper, section 3.4).
[[nodiscard]] ReducedBody reduced_body(const BodyModel& body, const BodyLimbs& limbs);

// How what a layer decides about a limb becomes the limb's joints below.
enum class DelegateMethod {
  closed_form,   // they follow from the ends of the limb
  limb_library,  // another layer moves the limb along the same path by weights
  swivel,        // they follow from the ends and from the swivel that another layer chooses
};

struct Delegate {
  int limb = 0;  // of the layer's body
  DelegateMethod by = DelegateMethod::closed_form;
  std::string layer;   // name of the layer that it is handed to; none of closed_form
  std::string idle{};  // the layer that has it where no goal moves it; none: it stays as it is
};

// One layer of a hierarchy (paper, section 3.4), as data: a body with fewer freedoms than the one
// below, the numbers that are searched for it, what its motions are scored by, and what it decides
// for the layers below.
struct Layer {
  std::string name;
  ReducedBody body;
  std::vector<ParameterInfo> parameters;
  CriteriaSettings criteria;
  std::vector<Delegate> delegates;
};

// The paper's two layers for a body: first the trunk with arms and legs of variable length, scored
// by `criteria` when its limbs have been expanded; then one layer for each arm, scored by joint
// range and torque. Fails on a body that is not a person's (find_limbs).
[[nodiscard]] Result<std::vector<Layer>> paper_layers(
    const BodyModel& body, const CriteriaSettings& criteria = {},
    LayerReading reading = LayerReading::shared_contractions);

// How far an elbow may be swivelled from where the hand's path alone takes it (rad, outwards).
inline constexpr double kSwivelMin = radians(-60.0);
inline constexpr double kSwivelMax = radians(90.0);

// Three layers: the paper's upper one; then for each arm the swivel of its elbow, all that a hand's
// path leaves open of an arm of four freedoms; then "rest", the final angles of what no goal moves,
// scored by `criteria` on the whole body, so that a free arm balances what the others do, and by
// the torque that it takes itself, so that it hangs where it need not. Of a body with a neck
// PostureLaw moves head, clavicles and the free shoulder, and "rest" has the free elbow alone; its
// arms have wrists, which turn hands. Fails as paper_layers does.
[[nodiscard]] Result<std::vector<Layer>> human_layers(
    const BodyModel& body, const CriteriaSettings& criteria = {},
    LayerReading reading = LayerReading::shared_contractions);

// Which layers a body gets, and the reading of the first.
struct LayerChoice {
  LayerStack stack = LayerStack::paper;
  LayerReading reading = LayerReading::shared_contractions;
};
[[nodiscard]] Result<std::vector<Layer>> make_layers(const BodyModel& body,
                                                     const LayerChoice& choice,
                                                     const CriteriaSettings& criteria = {});

// Whether a layer searches numbers of that kind.
[[nodiscard]] bool searches(const Layer& layer, ParameterKind kind);

// A straight limb cannot be made longer by any joint speed, so the longest that a layer asks for is
// bent by this (rule R3).
inline constexpr double kLeastBend = radians(5.0);

}  // namespace shigusa
