// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <shigusa/run.hpp>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/check.hpp"
#include "core/index.hpp"

#ifdef SHIGUSA_HAS_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif
#ifdef SHIGUSA_THREAD_SANITIZER
extern "C" {
void __tsan_acquire(void* address);
void __tsan_release(void* address);
}
#endif

namespace shigusa {
#ifdef SHIGUSA_HAS_TBB
namespace {

#ifdef SHIGUSA_THREAD_SANITIZER
// Ordering for the thread sanitizer, which cannot see into oneTBB, where atomics order the calls.
// It declares that calls come after everything before parallel_for and before everything after it,
// and that a worker's calls are sequential. Two workers' calls stay unordered, so their races are
// found.
class Order {
 public:
  explicit Order(int workers) : workers_(index(workers)) { __tsan_release(&begin_); }
  ~Order() { __tsan_acquire(&end_); }
  Order(const Order&) = delete;
  Order& operator=(const Order&) = delete;

  class Call {
   public:
    Call(Order& order, int worker) : order_(order), worker_(&order.workers_[index(worker)]) {
      __tsan_acquire(&order_.begin_);
      __tsan_acquire(worker_);
    }
    ~Call() {
      __tsan_release(worker_);
      __tsan_release(&order_.end_);
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    Order& order_;
    char* worker_;
  };

 private:
  char begin_ = 0;
  char end_ = 0;
  std::vector<char> workers_;
};
#else
struct Order {
  explicit Order(int) {}
  struct Call {
    Call(Order&, int) {}
  };
};
#endif

// Pool of task arenas. A worker takes some tens of microseconds to join an arena, and looks for
// more work for a while before it leaves, so arenas are kept; each call has its own, as threads
// that share one would wait for each other's work.
class Arenas {
 public:
  std::unique_ptr<tbb::task_arena> take(int workers) {
    const std::lock_guard lock(mutex_);
    if (workers > allowed_) {  // more threads than cores, if requested
      allowed_ = workers;
      control_.reset();  // of two controls the smaller one would apply
      control_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                       index(workers));
    }
    for (auto kept = idle_.rbegin(); kept != idle_.rend(); ++kept) {
      if ((*kept)->max_concurrency() != workers) continue;
      std::unique_ptr<tbb::task_arena> arena = std::move(*kept);
      idle_.erase(kept.base() - 1);
      return arena;
    }
    return std::make_unique<tbb::task_arena>(workers);
  }

  void give_back(std::unique_ptr<tbb::task_arena> arena) {
    const std::lock_guard lock(mutex_);
    if (idle_.size() == kMostIdle) idle_.erase(idle_.begin());
    idle_.push_back(std::move(arena));
  }

 private:
  static constexpr std::size_t kMostIdle = 16;
  std::mutex mutex_;
  std::unique_ptr<tbb::global_control> control_;
  int allowed_ = tbb::this_task_arena::max_concurrency();
  std::vector<std::unique_ptr<tbb::task_arena>> idle_;
};

class Arena {
 public:
  explicit Arena(int workers) : arena_(all().take(workers)) {}
  ~Arena() { all().give_back(std::move(arena_)); }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  tbb::task_arena* operator->() { return arena_.get(); }

 private:
  static Arenas& all() {
    static Arenas arenas;
    return arenas;
  }
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace
#elif !defined(__EMSCRIPTEN__)
namespace {

// Whether this thread is a worker, whose own loops run on it alone.
thread_local bool is_worker = false;

// Calls work(index, worker) of a loop in one of its workers, until none is left or one has thrown.
class Loop {
 public:
  Loop(int count, const std::function<void(int, int)>& work) : count_(count), work_(work) {}

  void run(int worker) {
    const bool before = std::exchange(is_worker, true);
    for (int index = next_++; index < count_; index = next_++) {
      try {
        work_(index, worker);
      } catch (...) {
        next_ = count_;
        const std::lock_guard lock(mutex_);
        if (!thrown_) thrown_ = std::current_exception();
      }
    }
    is_worker = before;
  }

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  int count_;
  const std::function<void(int, int)>& work_;
  std::atomic<int> next_{0};
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

}  // namespace
#endif

int thread_count(int threads) {
  SHG_CHECK(threads >= 0 && threads <= kMaxThreads, "threads are 0 (all cores) to 1024");
#ifdef SHIGUSA_HAS_TBB
  return threads == 0 ? tbb::this_task_arena::max_concurrency() : threads;
#elif !defined(__EMSCRIPTEN__)
  return threads == 0 ? std::max(static_cast<int>(std::thread::hardware_concurrency()), 1)
                      : threads;
#else
  return 1;
#endif
}

void parallel_for(int count, int threads, const std::function<void(int, int)>& work) {
#ifdef SHIGUSA_HAS_TBB
  const int workers = std::min(thread_count(threads), count);
  if (workers > 1) {
    Arena arena(workers);
    Order order(workers);
    arena->execute([&] {
      tbb::parallel_for(
          0, count,
          [&](int index) {
            const int worker = tbb::this_task_arena::current_thread_index();
            const Order::Call call(order, worker);
            work(index, worker);
          },
          tbb::simple_partitioner());
    });
    return;
  }
#elif !defined(__EMSCRIPTEN__)
  const int workers = is_worker ? 1 : std::min(thread_count(threads), count);
  if (workers > 1) {
    Loop loop(count, work);
    std::vector<std::thread> others;
    for (int worker = 1; worker < workers; ++worker) {
      try {
        others.emplace_back([&loop, worker] { loop.run(worker); });
      } catch (const std::system_error&) {
        break;  // the system has no more threads
      }
    }
    loop.run(0);
    for (std::thread& other : others) other.join();
    return loop.rethrow();
  }
#else
  (void)thread_count(threads);
#endif
  for (int index = 0; index < count; ++index) work(index, 0);
}

}  // namespace shigusa
