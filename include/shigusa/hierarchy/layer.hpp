// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria/criteria_settings.hpp>
#include <shigusa/hierarchy/body_limbs.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

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
};

// A limb of a reduced body: one rigid rod of variable length.
struct ReducedLimb {
  BodyLimb joints;        // what it stands for
  int slide = 0;          // dof that is its length
  double longest = 0.0;   // m, hand to shoulder or ankle to hip in the leg's plane: contraction 0
  double shortest = 0.0;  // m: contraction 1
};

// A body with fewer freedoms, on which a layer moves.
struct ReducedBody {
  Transformd base{};
  std::vector<ReducedDof> dofs;
  int trunk = -1;                  // link
  std::vector<ReducedLimb> limbs;  // legs, then arms
};

// What the number of a gene means.
enum class LayerGeneKind {
  weight,       // of one freedom in weighted IK: 1..15, and 0 locks it
  contraction,  // how much shorter limbs end: 0..15 of 15 parts of their range
};

inline constexpr int kLayerGeneMax = 15;

// One number that a layer searches.
struct LayerGene {
  std::string name;  // "right_hip.flexion", "legs.contraction"
  LayerGeneKind kind = LayerGeneKind::weight;
  std::vector<int> applies_to;  // of the layer's body: the dof with that weight; limbs by number
};

// How what a layer decides about a limb becomes the limb's joints below.
enum class Handover {
  closed_form,   // they follow from the ends of the limb
  limb_library,  // another layer moves the limb along the same path
};

struct HandedLimb {
  int limb = 0;  // of the layer's body
  Handover by = Handover::closed_form;
  std::string layer;  // name of the layer that it is handed to, of limb_library
};

// One layer of a hierarchy (paper, section 3.4), as data: a body with fewer freedoms than the one
// below, the numbers that are searched for it, what its motions are scored by, and what it decides
// for the layers below.
struct Layer {
  std::string name;
  ReducedBody body;
  std::vector<LayerGene> genes;
  CriteriaSettings criteria;
  std::vector<HandedLimb> hands_down;
};

// What the paper's count of 14 parameters for the whole body means (rule R2).
enum class LayerReading {
  shared_contractions,  // 6 weights a half, and 2 contractions: of the arms, of the legs
  contraction_a_limb,   // hips do not rotate: 5 weights a half, and 4 contractions
};

// "shared_contractions", "contraction_a_limb".
[[nodiscard]] std::string_view layer_reading_name(LayerReading reading);
[[nodiscard]] std::span<const LayerReading> layer_readings();

// The paper's two layers for a body: first the trunk with arms and legs of variable length, scored
// by `criteria` when its limbs have been expanded; then one layer for each arm, scored by joint
// range and torque. Fails on a body that is not a person's (find_limbs).
[[nodiscard]] Result<std::vector<Layer>> paper_layers(
    const BodyModel& body, const CriteriaSettings& criteria = {},
    LayerReading reading = LayerReading::shared_contractions);

// A straight limb cannot be made longer by any joint speed, so the longest that a layer asks for is
// bent by this (rule R3).
inline constexpr double kLeastBend = radians(5.0);

}  // namespace shigusa
