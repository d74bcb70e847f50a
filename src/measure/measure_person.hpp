// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string>
#include <vector>

#include "body/skin.hpp"

namespace shigusa {

// Placement of a file's person in shigusa's world: p_world = unit · (left, up, ahead)ᵀ (p_file -
// origin).
struct Placement {
  Vec3d left{1, 0, 0};  // unit vectors in the file's axes
  Vec3d up{0, 1, 0};
  Vec3d ahead{0, 0, 1};  // -(left × up) for a mirrored file
  Vec3d origin{};        // on the floor between the feet, in the file's units and axes
  double unit = 1.0;     // m per unit of the file

  [[nodiscard]] Vec3d to_world(const Vec3d& p) const;
  [[nodiscard]] bool mirrored() const { return dot(cross(left, up), ahead) < 0.0; }
};

// A person measured from a skeleton.
struct MeasuredPerson {
  Landmarks landmarks;
  double stature = 0.0;             // m, standing height, measured along the bones in any posture
  bool stature_guessed = false;     // no unit gives a human stature
  Placement placement;              // of the file in shigusa's world
  std::array<int, 2> grip_nodes{};  // left, right: the nodes at the hands' grips
  std::vector<Message> doubts;      // guesses: the unit, a missing toe, a lifted foot
};

struct MeasureSettings {
  // m; if given, the skeleton is scaled to this standing height and no unit is guessed
  std::optional<double> stature;
  // mesh in the same posture, units and axes; empty: only joints are measured
  std::span<const SkinVertex> skin{};
  // whether the posture is one for modelling: the trunk counts as upright, wherever its joints lie
  bool at_rest = false;
};

// Measures a person in the posture `world` (nodes; the file's own units and axes): finds the up
// axis and the facing direction from the body itself, guesses the unit among metres, centimetres,
// millimetres, decimetres, inches and the CMU database's 1/0.45 inch by the resulting stature, and
// moves the person onto the floor, between the feet, facing +Z. The last three units require a
// usual stature, or a child's with a child's proportions. A figure that no unit gives 0.5 to 2.5 m
// is taken to be 1.70 m tall, with a doubt. Fails if a limb segment has zero length.
//
// - Up is the axis of the file, ±x ±y ±z, nearest to the line from the ankles to the head. If legs
//   and trunk do not both point along it (a stoop, a sitting person), the axis along which both
//   point at rest, in the OFFSETs, has priority. A body that is straight along no axis, such as one
//   below a tilted armature, has its own direction, with a doubt.
// - Left is the mean of the hip line and the shoulder line, made horizontal. If the feet then point
//   backwards, the file is mirrored, and so is the measured person.
// - Stature is ankle height (0.039 of it) + shank + thigh + the chain of joints from mid-hip to the
//   vertex, averaged over left and right. If a trunk that stands at rest is longer along its bones
//   than straight by more than 3 %, the straight length is used.
// - Fingertips and toe tips are the farthest nodes below hand and foot, without the thumb; the
//   vertex is the head's tip. Missing ones are placed by the proportions of anthropometry.hpp.
// - A hand's grip is the node nearest to kGripFraction of the line from wrist to fingertip, among
//   the hand and its named descendants, thumbs excepted.
// - The floor is at the lower foot's sole: 0.039 of the stature below its ankle, or at the tip of
//   the toes.
//
// A mesh, if there is one, determines more:
// - A sole is at the lowest vertex bound to a foot or its descendants, or to the shank of a missing
//   foot; it is at the file's own 0 if the lower sole is within kFileFloor of that. Its outline is
//   that of the vertices slightly above, along the direction from ankle to toes. A foot without
//   toes points towards its vertices.
// - The vertex of a head without a tip is the highest vertex bound to the head itself over its
//   middle, so that neither ears nor parts on separate bones count; its height above the head's
//   joint is at most kTallestSkull times the breadth of the head. The stature follows from it and
//   the bones; for a person standing straight it is the height from the soles to the vertex if they
//   differ by more than 1.4 %.
// - Each part's shape is fitted to the vertices bound to it (fitted_parts).
inline constexpr double kFileFloor = 0.003;              // m
inline constexpr double kTrunkLeanMost = radians(20.0);  // more is a stoop
inline constexpr double kTallestSkull = 1.5;
[[nodiscard]] Result<MeasuredPerson> measure_person(const Skeleton& skeleton,
                                                    const std::vector<Transformd>& world,
                                                    const HumanoidMap& map,
                                                    const MeasureSettings& settings = {});

// Shapes of a measured person's hands alone, from a mesh with the fingers in another posture than
// `world` (nodes).
[[nodiscard]] PartShapes fitted_hands(const Skeleton& skeleton,
                                      const std::vector<Transformd>& world,
                                      std::span<const SkinVertex> hands, const HumanoidMap& map,
                                      const MeasuredPerson& person);

}  // namespace shigusa
