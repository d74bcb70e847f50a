// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace shigusa {

/// Most threads that may be asked for.
inline constexpr int kMaxThreads = 1024;

/// How many threads `threads` stands for: 0 is one for each core of the machine. At least 1, and 1
/// where the library was built without threads.
[[nodiscard]] int thread_count(int threads);

/// Calls work(index, worker) for each index in 0..count-1, on up to `threads` threads (0: one for
/// each core) at once and in no order. `worker`, in 0..thread_count(threads)-1, is never the same
/// in two calls at one time: for scratch memory. An exception of a call is passed on.
void parallel_for(int count, int threads, const std::function<void(int index, int worker)>& work);

/// How many motions a core scores at once, and by which instructions. The choice changes no result.
enum class SimdSet {
  scalar,   ///< one
  lanes_4,  ///< four: what every machine of the kind has (SSE2, NEON, WASM SIMD)
  avx2,     ///< eight
  avx512,   ///< sixteen (AVX-512 F, VL, DQ)
};

/// "scalar", "avx2", "avx512"; lanes_4 is "sse2" on x86 and "simd128" elsewhere.
[[nodiscard]] std::string_view simd_name(SimdSet set);
/// The set of that name, or nothing.
[[nodiscard]] std::optional<SimdSet> find_simd(std::string_view name);
/// How many motions a core scores at once by that set.
[[nodiscard]] int simd_lanes(SimdSet set);

/// The sets that this program has and this machine can run, narrowest first; asked once.
[[nodiscard]] std::span<const SimdSet> usable_simd_sets();
/// The widest of them.
[[nodiscard]] SimdSet widest_simd_set();

/// How many motions are scored at once; none of it changes a score.
struct BatchSettings {
  SimdSet simd = widest_simd_set();  ///< PreconditionError where the machine lacks it
  int threads = 0;                   ///< 0: one for each core
};

}  // namespace shigusa
