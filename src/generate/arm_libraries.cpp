// SPDX-License-Identifier: MIT
#include "arm_libraries.hpp"

namespace shigusa {

ArmLibraries::ArmLibraries(const Task& task, const LayeredProblem& problem)
    : store_(task.layers.store) {
  for (std::size_t g = 0; g < problem.arms.size(); ++g) {
    const Layer& layer = problem.layers[1 + g];
    if (!searches(layer, ParameterKind::weight)) continue;
    libraries_.emplace_back(problem.arm_bodies[g], LimbLibrarySettings{
                                                       .search = task.layers.limb_search,
                                                       .criteria = layer.criteria,
                                                       .batch = task.batch,
                                                   });
    names_.push_back(limb_file_name(layer.name, libraries_[g].hash()));
    take_stored(g);
    found_ += libraries_[g].cells_built();
  }
}

std::vector<ArmWeights> ArmLibraries::choose(std::span<const HandPath> paths) {
  std::vector<ArmWeights> arms;
  for (std::size_t g = 0; g < libraries_.size(); ++g) {
    const int cell = libraries_[g].cell_of(paths[g].back());
    arms.push_back(arm_weights(libraries_[g].genes(cell)));
  }
  return arms;
}

int ArmLibraries::cells_searched() const {
  int built = 0;
  for (const LimbLibrary& library : libraries_) built += library.cells_built();
  return built - found_;
}

void ArmLibraries::keep() {
  if (cells_searched() == 0 || !store_.save) return;
  for (std::size_t g = 0; g < libraries_.size(); ++g) {
    take_stored(g);
    store_.save(names_[g], libraries_[g].bytes());
  }
}

void ArmLibraries::take_stored(std::size_t goal) {
  if (!store_.load) return;
  // damaged or old ones are left alone, and replaced when something new is stored
  if (const auto bytes = store_.load(names_[goal])) libraries_[goal].take(*bytes);
}

}  // namespace shigusa
