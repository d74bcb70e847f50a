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

// Pieces of work of four reaches, drawn within easy reach, or the first reach of each as a query of
// its own. The ratio of both times is that of four actions to one query.
void reaches(benchmark::State& state, SimdSet simd, bool all) {
  constexpr int kPieces = 12;
  Random random(3);
  std::vector<Task> tasks;
  for (int p = 0; p < kPieces; ++p) {
    Task& task = tasks.emplace_back(human_body());
    task.batch = {simd, 1};
    for (int a = 0; a < 4; ++a) {
      const bool left = random.uniform(0.0, 1.0) < 0.5;
      const double side = (left ? 1.0 : -1.0) * random.uniform(0.0, 0.5);
      const Vec3d place{side, random.uniform(0.45, 1.6), random.uniform(0.25, 0.5)};
      task.actions.push_back({.goals = {{left ? "left_hand" : "right_hand", place}}});
    }
    if (all) continue;
    task.goals = task.actions.front().goals;
    task.actions.clear();
  }
  for (auto _ : state) {
    for (const Task& task : tasks) {
      const auto made = all ? perform(task) : generate(task);
      if (!made || !made->meets_goals()) state.SkipWithError("not reached");
      benchmark::DoNotOptimize(made);
    }
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
    RegisterBenchmark(("work/four_reaches/" + set).c_str(), reaches, simd, true)
        ->Unit(benchmark::kMillisecond);
    RegisterBenchmark(("work/first_reach/" + set).c_str(), reaches, simd, false)
        ->Unit(benchmark::kMillisecond);
  }
  RegisterBenchmark("load/vrm", load_vrm)->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace shigusa::bench
