// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate/generator.hpp>
#include <span>

#include "searched.hpp"

namespace shigusa {

// Replays what was found on the last of the ways, each on the first way that brings it to the goal,
// and keeps what arrives and differs, best first. Where one of a style passes through nothing, one
// does.
void deliver_candidates(const Task& task, std::span<const ReachProblem> ways,
                        const Searched& searched, const SearchResult& found,
                        Generation& generation);

}  // namespace shigusa
