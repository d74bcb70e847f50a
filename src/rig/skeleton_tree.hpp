// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/motion.hpp>
#include <span>
#include <vector>

#include "body/skin.hpp"
#include "core/index.hpp"

namespace shigusa {

// Geometric queries on the nodes of a skeleton in one posture. Borrows both.
class SkeletonTree {
 public:
  // `world`: (nodes). Parents must come before children. `skin`: mesh in the same posture.
  SkeletonTree(const Skeleton& skeleton, const std::vector<Transformd>& world,
               std::span<const SkinVertex> skin = {});

  [[nodiscard]] int size() const { return static_cast<int>(world_.size()); }
  [[nodiscard]] const SkeletonNode& node(int i) const { return skeleton_.nodes[index(i)]; }
  // Name of a node for messages: "joint 'Hips'", "the End Site of 'Head'".
  [[nodiscard]] std::string described(int i) const;
  [[nodiscard]] const Vec3d& at(int i) const { return world_[index(i)].translation; }
  [[nodiscard]] const std::vector<int>& children(int i) const { return children_[index(i)]; }

  // Length of the longest chain from a node down to a tip; the longest one of all roots.
  [[nodiscard]] double reach(int i) const { return reach_[index(i)]; }
  [[nodiscard]] double extent() const { return extent_; }

  // Whether i is `ancestor` or a descendant of it.
  [[nodiscard]] bool below(int i, int ancestor) const {
    return first_[index(ancestor)] <= first_[index(i)] && first_[index(i)] < last_[index(ancestor)];
  }
  // Deepest common ancestor of both, or -1.
  [[nodiscard]] int common_ancestor(int a, int b) const;

  // Whether two nodes are at different points, to a millionth of the extent (and 1e-9).
  [[nodiscard]] bool apart(int a, int b) const;

  // Longest chain from `first`, a child of `origin`, down to a tip; nodes that coincide with their
  // predecessor, which for the first is `origin`, are left out.
  [[nodiscard]] std::vector<int> chain(int origin, int first) const;

  // Tip of the longest chain below i; i itself if no descendant is apart from it. Nodes for which
  // `skip` holds are left out with their descendants.
  [[nodiscard]] int farthest(int i, const std::function<bool(int)>& skip = {}) const;

  [[nodiscard]] std::span<const SkinVertex> skin() const { return skin_; }

 private:
  const Skeleton& skeleton_;
  const std::vector<Transformd>& world_;
  std::span<const SkinVertex> skin_;
  std::vector<std::vector<int>> children_;
  std::vector<double> reach_;
  std::vector<int> first_;  // preorder index
  std::vector<int> last_;   // preorder index after the last descendant
  double extent_ = 0.0;
};

}  // namespace shigusa
