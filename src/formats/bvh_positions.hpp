// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/formats.hpp>

namespace shigusa {

// Adds OFFSETs to position channels of writers (MakeHuman) that count them from the OFFSET, where
// most write the whole translation. The first frame decides: OFFSETs are added in all frames if
// nearly all non-root joints with such channels, and at least kFewestPlaced, are at 0 although
// their OFFSET is not. The channels, which hold no information, are then removed.
inline constexpr int kFewestPlaced = 4;
void add_offsets(BvhFile& file);

}  // namespace shigusa
