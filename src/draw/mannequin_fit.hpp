// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <shigusa/motion.hpp>
#include <string>
#include <vector>

#include "mannequin_mesh.hpp"

namespace shigusa {

// Joint positions of a built-in body at rest, by the names of its bones.
class RestBones {
 public:
  explicit RestBones(const Skeleton& body);

  [[nodiscard]] bool has(const std::string& bone) const { return node(bone) >= 0; }
  [[nodiscard]] int node(const std::string& bone) const;
  [[nodiscard]] std::optional<Vec3d> at(const std::string& bone) const;
  [[nodiscard]] std::optional<Vec3d> way(const std::string& from, const std::string& to) const;
  // Vector from a bone to its farthest descendant, such as a fingertip or the top of the head.
  [[nodiscard]] Vec3d way_to_tip(const std::string& bone) const;
  // The body's axes: left, up, ahead.
  [[nodiscard]] const Mat3d& axes() const { return axes_; }

 private:
  const Skeleton& body_;
  std::vector<Vec3d> places_;  // (nodes) m, world
  Mat3d axes_;
};

// Placement of a bone's skin on a body at rest.
struct SkinFit {
  std::string bone;  // the body's bone that carries it
  Quatd turn{};      // rotation of the body's bone from a hanging limb
  Transformd place;  // transform from mesh space to the world, with scales in its matrix
};

// Fits the mannequin's skin to a body: each part is aligned with the body's own bone and scaled to
// its length, so that a body of any proportions is covered. Borrows both.
class SkinFitter {
 public:
  SkinFitter(const RestBones& body, const MannequinMesh& mesh, double stature);

  // The bone if the body has it, else its nearest ancestor in the body; the hips if there is none.
  [[nodiscard]] std::string carrier(const std::string& bone) const;
  // Placement of a node's skin.
  [[nodiscard]] SkinFit of(const std::string& bone) const;
  // Placement of a follower's skin with its joint hanging straight; `turn`: rotation of the bone
  // above.
  [[nodiscard]] Transformd hanging(const SkinBone& follower, const Quatd& turn) const;

 private:
  // Scale of a bone's skin along the axes of a hanging limb, and its rotation from there.
  struct Measure {
    Vec3d scale;
    Quatd turn{};
  };

  [[nodiscard]] const SkinBone& made(const std::string& bone) const;
  [[nodiscard]] double ratio(std::optional<double> length, double made) const;
  [[nodiscard]] Transformd lay(const Vec3d& at, const Quatd& turn, const Vec3d& scale,
                               const Vec3d& from, double angle) const;
  [[nodiscard]] std::optional<SkinFit> missing(const std::string& side,
                                               const std::string& bone) const;
  [[nodiscard]] SkinFit shoulder(const std::string& side) const;
  [[nodiscard]] Measure measure(const std::string& side, const std::string& bone) const;
  [[nodiscard]] Measure foot(const std::string& side) const;
  [[nodiscard]] Quatd turn_of(const Vec3d& made, const Vec3d& way) const;

  const RestBones& body_;
  const MannequinMesh& mesh_;
  double scale_;
  Transformd trunk_;
};

}  // namespace shigusa
