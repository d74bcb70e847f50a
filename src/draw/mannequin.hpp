// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/motion.hpp>
#include <vector>

#include "kinematics/rig.hpp"
#include "mannequin_fit.hpp"
#include "mannequin_follower.hpp"

namespace shigusa {

// The mannequin fitted to a built-in body: the body's nodes, in their order, followed by the
// additional nodes that move its skin.
class Mannequin {
 public:
  Mannequin(const Skeleton& body, const MannequinMesh& mesh, double stature);

  // Names and parents; names of the body's nodes are its own.
  [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }
  // (nodes) rest transforms relative to parents, with relaxed hands.
  [[nodiscard]] const std::vector<LocalTransform>& rest() const { return rest_; }
  // (bones of the mesh, then the body's other nodes) the node that moves the skin, and its inverse
  // bind matrix from mesh space to the node, with scales.
  [[nodiscard]] const std::vector<int>& joints() const { return joints_; }
  [[nodiscard]] const std::vector<Transformd>& inverses() const { return inverses_; }

  // (frames × nodes) transforms relative to parents, from the body's motion and the fingers' play.
  [[nodiscard]] std::vector<LocalTransform> play(const SkeletonClip& body,
                                                 const HandPlay& hands) const;

 private:
  struct Follower {
    int node;
    MannequinFollower turn;
  };
  struct Finger {
    int node;
    const SkinBone* bone;
    Vec3d axis;  // bending axis
  };
  class Builder;

  void bend(std::array<double, 2> closed, LocalTransform* local) const;
  // How far a hand is closed, see finger_bend: by its keys, or else by the motion's time.
  [[nodiscard]] double closed_at(const HandPlay& hands, std::size_t side, double share) const;

  Skeleton skeleton_;
  std::size_t body_nodes_;
  std::vector<LocalTransform> rest_;
  std::vector<int> joints_;
  std::vector<Transformd> inverses_;
  std::vector<Follower> followers_;
  std::vector<Finger> fingers_;
};

}  // namespace shigusa
