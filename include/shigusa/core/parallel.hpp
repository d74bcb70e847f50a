// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace shigusa {

// Most threads that may be asked for.
inline constexpr int kMaxThreads = 1024;

// How many threads `threads` stands for: 0 is one for each core of the machine. At least 1, and 1
// where the library was built without threads.
[[nodiscard]] int thread_count(int threads);

// Calls work(index, worker) for each index in 0..count-1, on up to `threads` threads (0: one for
// each core) at once and in no order. `worker`, in 0..thread_count(threads)-1, is never the same in
// two calls at one time: for scratch memory. What a call throws is passed on.
void parallel_for(int count, int threads, const std::function<void(int index, int worker)>& work);

}  // namespace shigusa
