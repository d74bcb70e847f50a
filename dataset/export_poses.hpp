// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/files.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <vector>

#include "data_rows.hpp"

namespace shigusa {

// Motion of a skeleton's nodes.
struct NodeMotion {
  std::vector<std::string> names;
  std::vector<int> parents;    // -1 of the first node
  std::vector<Vec3d> offsets;  // (nodes) m, in the parent
  double frame_time = 0.0;     // s
  std::vector<Quatd> turns;    // (frames × nodes) each in its parent
  std::vector<Vec3d> root;     // (frames) m, world, of the first node

  [[nodiscard]] std::size_t frames() const { return root.size(); }
  // Index of the node of that name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
};

// The same as transforms.
struct NodePlaces {
  std::vector<std::string> names;
  std::vector<int> parents;
  double frame_time = 0.0;
  std::vector<Vec3d> places;  // (frames × nodes) m, world

  [[nodiscard]] std::size_t frames() const { return places.size() / names.size(); }
  [[nodiscard]] int find(std::string_view name) const;
  [[nodiscard]] const Vec3d& at(std::size_t frame, int node) const {
    return places[frame * names.size() + static_cast<std::size_t>(node)];
  }
};

// Node motions of a data set: from stored series, or by making the motion again from its
// parameters.
class Poses {
 public:
  // Borrows the plan.
  explicit Poses(const DatasetPlan& plan) : plan_(&plan) {}

  // Series to read for these.
  [[nodiscard]] std::vector<DatasetSeries> series_for_turns() const;
  [[nodiscard]] std::vector<DatasetSeries> series_for_places() const;

  [[nodiscard]] Result<NodeMotion> turns(const DataMotion& motion) const;
  [[nodiscard]] Result<NodePlaces> places(const DataMotion& motion) const;

 private:
  [[nodiscard]] bool keeps(DatasetSeries series) const;

  const DatasetPlan* plan_;
};

// Motion at a rate (Hz), with frames as in `resampled`; rotations stay unit quaternions.
[[nodiscard]] NodeMotion at_rate(const NodeMotion& motion, double rate);
[[nodiscard]] NodePlaces at_rate(const NodePlaces& motion, double rate);

// Source of a motion's nodes.
[[nodiscard]] NodePlaces places_of(const NodeMotion& motion);

// A task of a data set, drawn again, with the parameters of one of its motions.
struct DrawnAgain {
  TaskFile file;
  Task task;
  Parameters parameters;
  // reason why the values do not fit the task's plan, if its body differs; empty: they fit
  std::string misfit{};
};
// `person`: replaces the task's character, if given.
[[nodiscard]] Result<DrawnAgain> drawn_again(const DatasetPlan& plan, const DataMotion& motion,
                                             const CharacterSpec* person = nullptr);

}  // namespace shigusa
