// SPDX-License-Identifier: MIT
#include "skeleton_tree.hpp"

#include <fmt/format.h>

#include "core/check.hpp"

namespace shigusa {

SkeletonTree::SkeletonTree(const Skeleton& skeleton, const std::vector<Transformd>& world,
                           std::span<const SkinVertex> skin)
    : skeleton_(skeleton),
      world_(world),
      skin_(skin),
      children_(world.size()),
      reach_(world.size()),
      first_(world.size()),
      last_(world.size()) {
  SHG_CHECK(world.size() == skeleton.nodes.size(), "one transform for each node");
  std::vector<int> below(world.size(), 1);  // size of each node's subtree
  for (int i = size(); i-- > 0;) {
    const int parent = node(i).parent;
    SHG_CHECK(parent < i, "parents come before their children");
    if (parent < 0) {
      extent_ = max(extent_, reach(i));
    } else {
      reach_[index(parent)] = max(reach(parent), reach(i) + norm(at(i) - at(parent)));
      below[index(parent)] += below[index(i)];
    }
  }
  int next_root = 0;
  std::vector<int> next(world.size());  // position of each node's next child
  for (int i = 0; i < size(); ++i) {
    const int parent = node(i).parent;
    int& place = parent < 0 ? next_root : next[index(parent)];
    first_[index(i)] = place;
    place += below[index(i)];
    last_[index(i)] = place;
    next[index(i)] = first_[index(i)] + 1;
    if (parent >= 0) children_[index(parent)].push_back(i);
  }
}

std::string SkeletonTree::described(int i) const {
  if (!node(i).end_site) return fmt::format("joint '{}'", node(i).name);
  const int parent = node(i).parent;
  return parent < 0 ? "an End Site" : fmt::format("the End Site of '{}'", node(parent).name);
}

int SkeletonTree::common_ancestor(int a, int b) const {
  while (a >= 0 && !below(b, a)) a = node(a).parent;
  return a;
}

bool SkeletonTree::apart(int a, int b) const {
  constexpr double kSamePlace = 1e-6;
  // no figure is smaller in any unit that files use
  constexpr double kSmallest = 1e-3;
  return norm(at(a) - at(b)) > kSamePlace * max(extent_, kSmallest);
}

std::vector<int> SkeletonTree::chain(int origin, int first) const {
  std::vector<int> nodes;
  int last = origin;
  for (int i = first; i >= 0;) {
    if (apart(i, last)) {
      nodes.push_back(i);
      last = i;
    }
    int next = -1;
    double longest = -1.0;
    for (const int child : children(i)) {
      const double length = reach(child) + norm(at(child) - at(i));
      if (length > longest) next = child;
      longest = max(longest, length);
    }
    i = next;
  }
  return nodes;
}

int SkeletonTree::farthest(int i, const std::function<bool(int)>& skip) const {
  std::vector<double> length(world_.size(), -1.0);  // of the way from i; negative: left out
  length[index(i)] = 0.0;
  int best = i;
  for (int k = i + 1; k < size(); ++k) {
    const int parent = node(k).parent;
    if (parent < 0 || length[index(parent)] < 0.0 || (skip && skip(k))) continue;
    length[index(k)] = length[index(parent)] + norm(at(k) - at(parent));
    if (length[index(k)] > length[index(best)] && apart(k, i)) best = k;
  }
  return best;
}

}  // namespace shigusa
