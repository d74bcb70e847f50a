// SPDX-License-Identifier: MIT
#include <shigusa/core/check.hpp>
#include <shigusa/core/parallel.hpp>

#ifdef SHIGUSA_HAS_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace shigusa {

int thread_count(int threads) {
  SHG_CHECK(threads >= 0 && threads <= kMaxThreads, "threads are 0 (all cores) to 1024");
#ifdef SHIGUSA_HAS_TBB
  return threads == 0 ? tbb::this_task_arena::max_concurrency() : threads;
#else
  return 1;
#endif
}

void parallel_for(int count, int threads, const std::function<void(int, int)>& work) {
#ifdef SHIGUSA_HAS_TBB
  const int workers = thread_count(threads);
  if (workers > 1 && count > 1) {
    // more threads than cores, where they are asked for
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(workers));
    tbb::task_arena arena(workers);
    arena.execute([&] {
      tbb::parallel_for(
          0, count, [&](int index) { work(index, tbb::this_task_arena::current_thread_index()); },
          tbb::simple_partitioner());
    });
    return;
  }
#else
  (void)thread_count(threads);
#endif
  for (int index = 0; index < count; ++index) work(index, 0);
}

}  // namespace shigusa
