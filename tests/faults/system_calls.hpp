// SPDX-License-Identifier: MIT
#pragma once

// The system calls that change files, under the tests' control: this program's functions of these
// names replace the C library's.
namespace shigusa::testing_support {

enum class Fault {
  none,
  killed_before,  // the call: SIGKILL
  killed_after,
  disk_full,  // ENOSPC; of a write, half of it is done
};

// From now on, the call with that number (from 1) meets the fault; with a full disk, all later ones
// do too.
void arm(Fault fault, int call);

// Number of calls since.
int calls_made();

}  // namespace shigusa::testing_support
