// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <shigusa/motion.hpp>
#include <string>
#include <vector>

#include "mannequin_mesh.hpp"

namespace shigusa {

// The joints of a built-in body where none is turned, by the names of its bones.
class RestBones {
 public:
  explicit RestBones(const Skeleton& body);

  [[nodiscard]] bool has(const std::string& bone) const { return node(bone) >= 0; }
  [[nodiscard]] int node(const std::string& bone) const;
  [[nodiscard]] std::optional<Vec3d> at(const std::string& bone) const;
  [[nodiscard]] std::optional<Vec3d> way(const std::string& from, const std::string& to) const;
  // The way to the node below a bone that is farthest from it: a fingertip, the top of the head.
  [[nodiscard]] Vec3d way_to_tip(const std::string& bone) const;
  // The body's axes: left, up, ahead.
  [[nodiscard]] const Mat3d& axes() const { return axes_; }

 private:
  const Skeleton& body_;
  std::vector<Vec3d> places_;  // (nodes) m, world
  Mat3d axes_;
};

// How a bone's skin lies about a body at rest.
struct SkinFit {
  std::string bone;  // the body's that carries it
  Quatd turn{};      // of the body's bone, unturned, from a hanging limb
  Transformd place;  // from where the mesh is made to the world, with scales in its matrix
};

// Lays the mannequin's skin about a body: each part lies along the body's own bone and is as long
// as that, so that a body of any proportions is covered. Borrows both.
class SkinFitter {
 public:
  SkinFitter(const RestBones& body, const MannequinMesh& mesh, double stature);

  // The bone, or the next one above it that the body has; the hips where it has none.
  [[nodiscard]] std::string carrier(const std::string& bone) const;
  // How a node's bone lies.
  [[nodiscard]] SkinFit of(const std::string& bone) const;
  // How a follower's skin lies where its joint hangs straight; `turn`: of the bone above.
  [[nodiscard]] Transformd hanging(const SkinBone& follower, const Quatd& turn) const;

 private:
  // How a bone's skin is scaled along the axes of a hanging limb, and turned from there.
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
