// SPDX-License-Identifier: MIT
#pragma once

// The system calls by which files change, in the hands of the tests: this program's own functions
// of these names stand before the C library's.
namespace shigusa::testing_support {

enum class Fault {
  none,
  killed_before,  // the call: SIGKILL
  killed_after,
  disk_full,  // ENOSPC; of a write, half of it is done
};

// From now on, the call of that number (from 1) meets the fault; of the full disk, all after it
// too.
void arm(Fault fault, int call);

// Calls since.
int calls_made();

}  // namespace shigusa::testing_support
