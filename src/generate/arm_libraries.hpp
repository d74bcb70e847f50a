// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/task.hpp>
#include <span>
#include <string>
#include <vector>

#include "layers/layered_player.hpp"
#include "layers/limb_library.hpp"

namespace shigusa {

// The libraries of the arms that have a goal and go by weights.
class ArmLibraries {
 public:
  ArmLibraries(const Task& task, const LayeredProblem& problem);

  // (goals) By where the hands end: the lower layer's weights stay the same during a motion.
  [[nodiscard]] std::vector<ArmWeights> choose(std::span<const HandPath> paths);

  // Cells that were in no store; counted before keep().
  [[nodiscard]] int cells_searched() const;

  // Stores what is new, beside what others have stored meanwhile.
  void keep();

 private:
  void take_stored(std::size_t goal);

  LimbStore store_;
  std::vector<LimbLibrary> libraries_;  // (goals)
  std::vector<std::string> names_;
  int found_ = 0;  // cells that were stored
};

}  // namespace shigusa
