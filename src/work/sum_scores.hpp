// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

namespace shigusa {

// Adds the penalties of a motion, weighted by its duration (s).
void add_score(const Score& score, double seconds, Score& sum);
// Ends a sum of motions of that many seconds in all: their mean over time.
void end_score(double seconds, Score& sum);

// Adds the reasons of a motion that begins at `start` (s).
void add_judgement(const Judgement& judgement, double start, Judgement& all);

}  // namespace shigusa
