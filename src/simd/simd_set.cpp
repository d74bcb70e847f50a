// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <shigusa/run.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/check.hpp"
#include "simd/usable_set.hpp"

namespace shigusa {
namespace {

#if defined(__x86_64__) || defined(__i386__)
constexpr const char* kFourLanes = "sse2";
#else
constexpr const char* kFourLanes = "simd128";
#endif

constexpr std::array<std::pair<SimdSet, const char*>, 4> kNames{{{SimdSet::scalar, "scalar"},
                                                                 {SimdSet::lanes_4, kFourLanes},
                                                                 {SimdSet::avx2, "avx2"},
                                                                 {SimdSet::avx512, "avx512"}}};

std::vector<SimdSet> find_usable() {
#ifdef __wasm_simd128__
  std::vector<SimdSet> sets{SimdSet::lanes_4};  // each set adds a tenth to a browser's module
#else
  std::vector<SimdSet> sets{SimdSet::scalar, SimdSet::lanes_4};
#endif
#ifdef SHIGUSA_HAS_AVX
  if (__builtin_cpu_supports("avx2")) sets.push_back(SimdSet::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq")) {
    sets.push_back(SimdSet::avx512);
  }
#endif
  return sets;
}

}  // namespace

std::string_view simd_name(SimdSet set) {
  for (const auto& [known, name] : kNames) {
    if (known == set) return name;
  }
  return "";
}

std::optional<SimdSet> find_simd(std::string_view name) {
  for (const auto& [set, known] : kNames) {
    if (known == name) return set;
  }
  return std::nullopt;
}

int simd_lanes(SimdSet set) {
  switch (set) {
    case SimdSet::scalar:
      return 1;
    case SimdSet::lanes_4:
      return 4;
    case SimdSet::avx2:
      return 8;
    case SimdSet::avx512:
      return 16;
  }
  return 1;
}

std::span<const SimdSet> usable_simd_sets() {
  static const std::vector<SimdSet> sets = find_usable();
  return sets;
}

void require_usable(SimdSet set) {
  const auto usable = usable_simd_sets();
  SHG_CHECK(std::find(usable.begin(), usable.end(), set) != usable.end(),
            "this machine cannot run the SIMD set " + std::string(simd_name(set)));
}

SimdSet widest_simd_set() { return usable_simd_sets().back(); }

}  // namespace shigusa
