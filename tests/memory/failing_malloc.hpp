// SPDX-License-Identifier: MIT
#pragma once

// The C library's memory, in the hands of the tests: this program's own functions of these names
// stand before it, for the libraries too.
namespace shigusa::testing_support {

enum class Lack {
  none,
  once,      // that allocation gets none
  from_then  // nor does any after it
};

// From now on, on this thread, the allocation of that number (from 1) gets no memory.
void run_out(Lack lack, long allocation);

// Allocations of this thread since.
[[nodiscard]] long allocations();
// Blocks of all threads that are not given back.
[[nodiscard]] long blocks();

}  // namespace shigusa::testing_support
