// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "core/check.hpp"
#include "paper/limb_library.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr double kWantedMilliseconds = 20.0;
constexpr double kWantedMegabytes = 64.0;
constexpr double kWantedLoad = 5.0;  // ms
constexpr int kRounds = 25;

struct QueryCost {
  double milliseconds = 0.0;
  double kibibytes = 0.0;
};

// A query in a separate process, as peak memory is per process.
QueryCost ask(const std::string& program, std::string_view simd, int rounds) {
  const std::string command = fmt::format("'{}' {} {}", program, simd, rounds);
  FILE* pipe = popen(command.c_str(), "r");
  SHG_CHECK(pipe != nullptr, "cannot run " + command);
  QueryCost cost;
  const int read = std::fscanf(pipe, "%lf %lf", &cost.milliseconds, &cost.kibibytes);
  SHG_CHECK(pclose(pipe) == 0 && read == 2, "failed: " + command);
  return cost;
}

// Milliseconds to build the right arm's whole library, and to read it from a file.
struct LibraryCost {
  double build = 0.0;
  double load = 0.0;
  std::size_t bytes = 0;
};

LibraryCost library_cost() {
  const PosedBody posed = full_body();
  const BodyLimbs limbs = find_limbs(posed.body, posed.home).value();
  const PosedBody arm = arm_body(posed.body, posed.home, limbs.arms.front());
  const auto folder = std::filesystem::temp_directory_path() / "shigusa_experiments";
  const LimbStore store = limb_store(folder);
  LibraryCost cost;
  LimbLibrarySettings alone;
  alone.batch.threads = 1;
  LimbLibrary built(arm, alone);
  const std::string name = limb_file_name("arm", built.hash());
  const Stopwatch building;
  built.build_all();
  cost.build = building.milliseconds();
  cost.bytes = built.bytes().size();
  store.save(name, built.bytes());
  std::vector<double> loads;
  for (int round = 0; round < kRounds; ++round) {
    const Stopwatch loading;
    LimbLibrary stored(arm);
    const auto bytes = store.load(name);
    SHG_CHECK(bytes && stored.take(*bytes), "the library that was kept is not taken");
    loads.push_back(loading.milliseconds());
    SHG_CHECK(stored.cells_built() == kLimbCells, "cells are missing");
  }
  cost.load = median(loads);
  std::filesystem::remove_all(folder);
  return cost;
}

}  // namespace

std::string one_query(const Plan& plan, const std::string& program) {
  const int rounds = plan.quick ? 3 : kRounds;
  Table table({"SIMD set", "ms a query", "wanted", "peak memory, MB", "wanted"});
  for (const SimdSet set : usable_simd_sets()) {
    const double time = ask(program, simd_name(set), rounds).milliseconds;
    const double memory = ask(program, simd_name(set), 1).kibibytes * 1024.0 / 1e6;
    const bool asked = set == SimdSet::avx2;
    table.add({std::string(simd_name(set)), fmt::format("{:.1f}", time),
               asked ? fmt::format("≤ {:g}", kWantedMilliseconds) : "",
               fmt::format("{:.1f}", memory), fmt::format("≤ {:g}", kWantedMegabytes)});
  }
  const LibraryCost library = library_cost();
  return fmt::format(
             "`generate()` on full_body with the preset flat and nothing else said ({} motions, {} "
             "candidates), for the goal low front-left, on one thread: processor time, median of "
             "{} in a process "
             "of its own; the peak memory is that of a process that does one (all that it has "
             "resident at once).\n\n",
             kFlatEvaluations, traits_of(Preset::flat).candidates, rounds) +
         table.text() +
         fmt::format(
             "\nThe whole limb library of an arm takes {:.1f} s to search on one core and {:.2f} "
             "ms (wanted: ≤ {:g}) to make and take from its file of {} bytes.\n",
             1e-3 * library.build, library.load, kWantedLoad, library.bytes);
}

}  // namespace shigusa::bench
