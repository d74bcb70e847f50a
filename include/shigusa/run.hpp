// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace shigusa {

/// The progress of long work.
struct ProgressReport {
  std::string_view stage;   ///< "search", "export"; valid during the call only
  double fraction = 0.0;    ///< 0..1 of this stage, at most; the work may converge earlier
  int evaluations = 0;      ///< motions scored so far
  double best_score = 0.0;  ///< lowest score so far; undefined while evaluations is 0
};

/// Callbacks and stop conditions of long work; all members may be empty. `report` is called on the
/// calling thread, and its exceptions are passed on to the caller. Setting `cancel` to true, from
/// any thread or a signal handler, ends the work at its next step with the best result so far; so
/// does passing the `deadline`. A result at a deadline depends on the machine's speed.
struct Progress {
  std::function<void(const ProgressReport&)> report{};  ///< called at each step
  /// Ends the work once it is true.
  const std::atomic<bool>* cancel = nullptr;
  /// Ends the work once it has passed.
  std::optional<std::chrono::steady_clock::time_point> deadline{};

  /// Whether the work must end now.
  [[nodiscard]] bool cancelled() const {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) return true;
    return deadline && std::chrono::steady_clock::now() >= *deadline;
  }
};

/// Counter-based random numbers: the k-th number is a pure function of (seed, stream, k), so work
/// split over threads or machines draws the same numbers. The mixing function is the finaliser of
/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014).
class Random {
 public:
  /// `stream` separates independent users of one seed (searches, restarts, tests).
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : key_(mix(seed + kGolden) ^ mix(stream * kGolden + 0x6A09E667F3BCC909ULL)) {}

  /// Next 64 uniform bits.
  std::uint64_t next() { return mix(key_ + kGolden * ++counter_); }

  /// Uniform in [0, 1): 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

  /// Uniform in [low, high], high itself only by rounding.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform integer in [0, count), count ≥ 1; each has a probability within 2^-32 of 1 / count.
  std::uint32_t below(std::uint32_t count) {
    const std::uint64_t high = next() >> 32;
    return static_cast<std::uint32_t>((high * count) >> 32);
  }

  /// True with the given probability in [0, 1].
  bool chance(double probability) { return uniform() < probability; }

  /// Number of numbers drawn so far.
  [[nodiscard]] std::uint64_t counter() const { return counter_; }

 private:
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

/// Largest number of threads.
inline constexpr int kMaxThreads = 1024;

/// The number of threads for a setting: 0 is one per core of the machine. At least 1, and 1 if the
/// library was built without threads.
[[nodiscard]] int thread_count(int threads);

/// Calls work(index, worker) for each index in 0..count-1, on up to `threads` threads (0: one per
/// core), in no defined order. `worker`, in 0..thread_count(threads)-1, differs between concurrent
/// calls and can select scratch memory. An exception of a call is passed on.
void parallel_for(int count, int threads, const std::function<void(int index, int worker)>& work);

/// The SIMD instruction set, and with it the number of motions that a core scores at once. It does
/// not change results.
enum class SimdSet {
  scalar,   ///< one motion
  lanes_4,  ///< four motions: the baseline of the architecture (SSE2, NEON, WASM SIMD)
  avx2,     ///< eight motions
  avx512,   ///< sixteen motions (AVX-512 F, VL, DQ)
};

/// The name of a set: "scalar", "avx2", "avx512"; lanes_4 is "sse2" on x86 and "simd128" elsewhere.
[[nodiscard]] std::string_view simd_name(SimdSet set);
/// The set with this name, or nothing.
[[nodiscard]] std::optional<SimdSet> find_simd(std::string_view name);
/// Number of motions that a core scores at once with a set.
[[nodiscard]] int simd_lanes(SimdSet set);

/// The sets that are compiled in and that this machine supports, narrowest first; detected once.
[[nodiscard]] std::span<const SimdSet> usable_simd_sets();
/// The widest usable set.
[[nodiscard]] SimdSet widest_simd_set();

/// Settings of the parallel scoring of motions; they do not change scores.
struct BatchSettings {
  SimdSet simd = widest_simd_set();  ///< instruction set; PreconditionError if the machine lacks it
  int threads = 0;                   ///< number of threads; 0: one per core
};

}  // namespace shigusa
