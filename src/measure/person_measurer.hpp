// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <utility>

#include "body/anthropometry.hpp"
#include "core/say.hpp"
#include "human/landmark_points.hpp"
#include "measure/measure_person.hpp"
#include "rig/humanoid_names.hpp"
#include "rig/skeleton_tree.hpp"

namespace shigusa {

[[nodiscard]] inline std::string_view side_word(Side side) {
  return side == Side::left ? "left" : "right";
}

struct FileUnit;

// Measures in the file's units and axes, then moves the result into shigusa's world.
class PersonMeasurer {
 public:
  PersonMeasurer(const Skeleton& skeleton, const std::vector<Transformd>& world,
                 const HumanoidMap& map, std::span<const SkinVertex> skin);

  // See measure_person. Call once.
  Result<MeasuredPerson> measure(const MeasureSettings& settings);

 private:
  using Bone = HumanoidBone;

  template <class... Args>
  void doubt(Sentence<std::type_identity_t<Args>...> sentence, const Args&... args) {
    result_.doubts.push_back(say(sentence, args...));
  }

  [[nodiscard]] const Vec3d& at(Bone bone) const { return tree_.at(map_[bone]); }
  [[nodiscard]] BonePart part(int i) const { return read_bone_name(tree_.node(i).name).part; }
  Landmarks& body() { return result_.landmarks; }
  Landmarks::Leg& leg(Side side) { return body().leg(side); }
  Landmarks::Arm& arm(Side side) { return body().arm(side); }

  // limbs and directions
  [[nodiscard]] Result<void> check_length(Side side, std::string_view segment, Bone a,
                                          Bone b) const;
  Result<void> read_limbs();
  Vec3d find_up();
  Result<void> find_left();

  // tips, stature and grips
  [[nodiscard]] int toe_node(Side side) const;
  void read_tips();
  void read_further_joints();
  [[nodiscard]] double length_along_bones(int a, int b, const std::vector<Vec3d>& at) const;
  [[nodiscard]] double trunk_length(double leg_length, const std::vector<Vec3d>& at) const;
  [[nodiscard]] double winding(double leg_length) const;
  [[nodiscard]] bool stands_straight() const;
  double stature_along_bones();
  double measure_stature();
  void place_missing_tips();
  void find_grips();

  // measures from the mesh, if there is one
  [[nodiscard]] std::vector<Vec3d> flesh_of_foot(Side side) const;
  void read_soles();
  [[nodiscard]] SoleOutline outline_of(const std::vector<Vec3d>& flesh, const Vec3d& ankle,
                                       const Vec3d& ahead) const;
  [[nodiscard]] Vec3d left_of(const Vec3d& ahead) const;
  [[nodiscard]] SoleOutline broadened(const SoleOutline& sole, double breadth) const;
  void widen_peg(Side side);
  [[nodiscard]] std::optional<Vec3d> skull_by_mesh() const;
  void fit_parts();

  // placement in the world
  Result<void> find_unit(const MeasureSettings& settings);
  void doubt_unit(const FileUnit& best);
  [[nodiscard]] double sole(Side side) const;
  void move_to_world();
  void find_trunk_lean();
  void check_plausibility();

  const Skeleton& skeleton_;
  SkeletonTree tree_;
  const HumanoidMap& map_;
  MeasuredPerson result_;
  Vec3d up_{};  // directions in the file's axes
  Vec3d left_{};
  Vec3d ahead_{};
  Vec3d mid_hip_{};
  Vec3d mid_shoulder_{};
  int neck_ = -1;
  int head_ = -1;
  int head_tip_ = -1;
  bool wound_ = false;          // the bones of the trunk zigzag
  std::optional<Vec3d> skull_;  // from the head's joint to the vertex, from the mesh
  double head_length_ = 0.0;    // neck to vertex, file units
  double legs_ = 0.0;           // hip to ankle along the bones, file units
  double stature_ = 0.0;        // file units
};

// Fewest vertices that determine the shape of a part.
inline constexpr std::size_t kFewestVertices = 12;

// Vertices for which `of_part` holds. Vertices of meshes rigidly attached to a node count only if
// there are fewer than kFewestVertices others.
template <class OfPart>
[[nodiscard]] std::vector<Vec3d> flesh_of(std::span<const SkinVertex> skin, const OfPart& of_part) {
  std::vector<Vec3d> points;
  for (const bool rigid : {false, true}) {
    for (const SkinVertex& vertex : skin) {
      if (vertex.rigid == rigid && of_part(vertex)) points.push_back(vertex.position);
    }
    if (points.size() >= kFewestVertices) break;
  }
  return points;
}

}  // namespace shigusa
