// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace shigusa {

// The style sheet of a page of motions.
extern const std::string_view kPageStyle;

// The script of a page of motions, which draws the output of page_figures.
extern const std::string_view kPageScript;

// The part of the script that pages of pieces of work have besides.
extern const std::string_view kPageWork;

}  // namespace shigusa
