// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/formats.hpp>

namespace shigusa {

// Some writers (MakeHuman) give joints position channels that count from the OFFSET, where most
// write the whole place. The values of the first frame tell which: where nearly all joints below
// the roots that have them, and at least kFewestPlaced of them, are at 0 although their OFFSET is
// not, OFFSETs are added in all frames, and the channels are taken away: they tell nothing.
inline constexpr int kFewestPlaced = 4;
void add_offsets(BvhFile& file);

}  // namespace shigusa
