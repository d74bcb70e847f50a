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

// Where a file's person stands in shigusa's world:
// p_world = unit · (left, up, ahead)ᵀ (p_file - origin).
struct Placement {
  Vec3d left{1, 0, 0};  // unit vectors in the file's axes
  Vec3d up{0, 1, 0};
  Vec3d ahead{0, 0, 1};  // -(left × up) where the file is mirrored
  Vec3d origin{};        // on the floor between the feet, in the file's units and axes
  double unit = 1.0;     // m per unit of the file

  [[nodiscard]] Vec3d to_world(const Vec3d& p) const;
  [[nodiscard]] bool mirrored() const { return dot(cross(left, up), ahead) < 0.0; }
};

// A person as measured from a skeleton.
struct MeasuredPerson {
  Landmarks landmarks;
  double stature = 0.0;             // m, standing height: measured along the bones, not the posture
  bool stature_guessed = false;     // no unit makes a person of the file
  Placement placement;              // of the file in shigusa's world
  std::array<int, 2> grip_nodes{};  // left, right: the nodes at the hands' grips
  std::vector<Message> doubts;      // guesses: the unit, a missing toe, a lifted foot
};

struct MeasureSettings {
  // m; when given, the skeleton is scaled to this standing height and the unit is not guessed
  std::optional<double> stature;
  // the mesh in the same posture, in the same units and axes; none: joints alone are measured
  std::span<const SkinVertex> skin{};
  // the posture is one in which people are modelled: the trunk is upright, wherever joints lie in
  // it
  bool at_rest = false;
};

// Measures a person in the posture `world` (nodes; the file's own units and axes): finds the up
// axis and the facing from the body itself, guesses the unit among metres, centimetres,
// millimetres, decimetres, inches and the CMU database's 1/0.45 inch by the stature it would give,
// and moves the person onto the floor, between the feet, facing +Z. Of the last three only a usual
// stature tells, or a child's of a figure that is built as one. A figure that no unit makes a
// person of 0.5 to 2.5 m is taken to be 1.70 m tall, with a doubt. Fails when a limb segment has
// zero length.
//
// - Up is the axis of the file, ±x ±y ±z, nearest to the way from the ankles to the head. Where
//   legs and trunk do not both point along it (a stoop, a person who sits), the axis along which
//   both point at rest, in the OFFSETs, comes first. A body that is straight along no axis, as one
//   below a tilted armature, has its own direction, with a doubt.
// - Left is the mean of the hip line and the shoulder line, made horizontal. If the feet then point
//   backwards, the file is mirrored, and so is the person measured.
// - Stature is ankle height (0.039 of it) + shank + thigh + the chain of joints from between the
//   hips to the vertex; left and right averaged. Where a trunk that stands at rest is longer along
//   its bones than straight, by more than 3 %, it is as long as straight.
// - Fingertips and toe tips are the farthest nodes below hand and foot, without the thumb; the
//   vertex is the head's tip. Missing ones are placed by the proportions of anthropometry.hpp.
// - A hand's grip is the node nearest to kGripFraction of the way from wrist to fingertip, of the
//   hand and what has a name below it, thumbs excepted.
// - The floor is where the sole of the lower foot is: 0.039 of the stature below its ankle, or at
//   the tip of the toes.
//
// Where there is a mesh, it tells what joints leave open:
// - A sole is the lowest vertex bound to a foot or what hangs on it, or where a foot has none, to
//   its shank; the file's own 0 where the lower sole is within kFileFloor of it. Its outline is
//   that of the vertices a little above that, along the way from ankle to toes. A foot without toes
//   points where its vertices are.
// - The vertex of a head without a tip is the highest vertex bound to the head itself over its
//   middle, so that neither ears nor parts on bones of their own count; it is no higher above the
//   head's joint than kTallestSkull times the head is broad. The stature is what the bones and it
//   tell; of who stands straight it is the way from the soles up to it where that is another, by
//   more than 1.4 %.
// - Each part's shape is fitted to the vertices bound to it (fitted_parts).
inline constexpr double kFileFloor = 0.003;              // m
inline constexpr double kTrunkLeanMost = radians(20.0);  // more is a stoop
inline constexpr double kTallestSkull = 1.5;
[[nodiscard]] Result<MeasuredPerson> measure_person(const Skeleton& skeleton,
                                                    const std::vector<Transformd>& world,
                                                    const HumanoidMap& map,
                                                    const MeasureSettings& settings = {});

// The shapes of a measured person's hands alone, by a mesh that has their fingers in another
// posture than `world` (nodes).
[[nodiscard]] PartShapes fitted_hands(const Skeleton& skeleton,
                                      const std::vector<Transformd>& world,
                                      std::span<const SkinVertex> hands, const HumanoidMap& map,
                                      const MeasuredPerson& person);

}  // namespace shigusa
