// SPDX-License-Identifier: MIT
#pragma once

// Uses std::vector without including it: the check that headers compile alone must refuse this.
inline std::vector<int> numbers() { return {1, 2}; }
