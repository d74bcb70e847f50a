// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate/generator.hpp>

namespace shigusa {

// generate() and regenerate() of layered presets. Where no motion of the layers arrives, what is
// given ends as near to the goals as one does.
[[nodiscard]] Result<Generation> generate_layered(const Task& task, const Progress& progress);
[[nodiscard]] Result<Generation> regenerate_layered(const Task& task, const Parameters& parameters);

}  // namespace shigusa
