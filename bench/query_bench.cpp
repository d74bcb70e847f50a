// SPDX-License-Identifier: MIT
// Times of interactive use: a whole query, and reading a character's file.
#include <benchmark/benchmark.h>

#include <shigusa/character.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>

#include "support/gltf_file.hpp"

namespace shigusa::bench {
namespace {

constexpr std::size_t kVrmBytes = 5'000'000;

// generate() with default settings and a goal low front-left.
void query(benchmark::State& state, const PosedBody& posed, SimdSet simd, int threads) {
  Task task(posed, {.goals = {{"right_hand", {0.25, 0.55, 0.50}}}});
  task.batch = {simd, threads};
  for (auto _ : state) {
    const GenerateResult generation = generate(task).value();
    if (generation.status != ReachStatus::reached) state.SkipWithError("not reached");
    benchmark::DoNotOptimize(generation.candidates.data());
  }
}

// A VRM of a person with a million numbers of mesh data, and unused textures.
std::string large_vrm() {
  nlohmann::json file = testing_support::person_gltf();
  nlohmann::json& bones = file["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"];
  const auto& nodes = file["nodes"];
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const std::string_view bone = humanoid_bone_name(static_cast<HumanoidBone>(b));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].value("name", "") != bone) continue;
      bones[testing_support::camel_case(bone)] = {{"node", n}};
    }
  }
  // facial morph targets make the JSON of a VRM long
  nlohmann::json& accessors = file["accessors"] = nlohmann::json::array();
  for (int k = 0; k < 4000; ++k) {
    accessors.push_back({{"bufferView", k},
                         {"componentType", 5126},
                         {"count", 250},
                         {"type", "VEC3"},
                         {"min", {-0.1, -0.1, -0.1}},
                         {"max", {0.1, 0.1, 0.1}}});
  }
  std::string json = file.dump();
  return testing_support::glb(json, std::string((kVrmBytes - json.size()) / 4 * 4, '\1'));
}

void load_vrm(benchmark::State& state) {
  const std::string bytes = large_vrm();
  for (auto _ : state) {
    CharacterSpec spec;
    spec.source = "person.vrm";
    if (!load_character(bytes, spec)) state.SkipWithError("the file is refused");
    const auto posed = build_character(spec);
    if (!posed) state.SkipWithError("it gives no body");
    benchmark::DoNotOptimize(posed);
  }
  state.counters["bytes"] = static_cast<double>(bytes.size());
}

const bool kRegistered = [] {
  using benchmark::RegisterBenchmark;
  for (const SimdSet simd : usable_simd_sets()) {
    if (simd == SimdSet::scalar) continue;
    const std::string set(simd_name(simd));
    RegisterBenchmark(("query/full_body/" + set).c_str(), query, full_body(), simd, 1)
        ->Unit(benchmark::kMillisecond);
    RegisterBenchmark(("query/human/" + set).c_str(), query, human_body(), simd, 1)
        ->Unit(benchmark::kMillisecond);
    RegisterBenchmark(("query/human/two_threads/" + set).c_str(), query, human_body(), simd, 2)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
  RegisterBenchmark("load/vrm", load_vrm)->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
