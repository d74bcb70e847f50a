// SPDX-License-Identifier: MIT
#pragma once

// The C library's allocation functions, under the tests' control: this program's functions of these
// names replace them, for the libraries too.
namespace shigusa::testing_support {

enum class Lack {
  none,
  once,      // that allocation gets none
  from_then  // nor does any after it
};

// From now on, on this thread, the allocation with that number (from 1) fails.
void run_out(Lack lack, long allocation);

// Number of allocations of this thread since.
[[nodiscard]] long allocations();
// Number of blocks of all threads that are not freed.
[[nodiscard]] long blocks();

}  // namespace shigusa::testing_support
