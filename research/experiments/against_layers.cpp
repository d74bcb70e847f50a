// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "goal_search.hpp"
#include "problem/make_problem.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

// Searches and criteria: layers, and all parameters at once.
struct Pairing {
  const char* name;
  SearchMethod method;
  Preset layered;
  Preset flat;  // preset with all parameters at once
  const char* criteria_name;
  CriteriaSettings (*criteria)();
};
constexpr Pairing kPairings[] = {
    {"paper_ga over codes 0..15", SearchMethod::paper_ga, Preset::layers, Preset::paper, "paper",
     paper_criteria},
    {"cma_es over wide codes", SearchMethod::cma_es, Preset::layers, Preset::flat, "default",
     default_criteria},
    {"cma_es over wide codes, human", SearchMethod::cma_es, Preset::human, Preset::flat, "default",
     default_criteria},
};
constexpr int kShort = 300;
constexpr int kLong = 3000;

// A store for the lifetime of the program.
class MemoryStore {
 public:
  [[nodiscard]] LimbStore store() {
    return {
        .load = [this](const std::string& name) -> std::optional<std::string> {
          const auto found = kept_.find(name);
          return found == kept_.end() ? std::nullopt : std::optional(found->second);
        },
        .save = [this](const std::string& name, std::string_view bytes) { kept_[name] = bytes; }};
  }

 private:
  std::map<std::string, std::string> kept_;
};

struct Run {
  double score = 0.0;
  double milliseconds = 0.0;
};

Task pairing_task(const Subject& subject, const Place& place, const Pairing& pairing,
                  Preset preset) {
  Task task = goal_task(subject.posed, place.position, preset, pairing.criteria());
  task.search = pairing.method;
  // only the searches are compared: replay of candidates has a cost of its own
  task.candidates = 1;
  // otherwise an impossible candidate would be scored with a longer duration
  task.duration = make_problem(task).value().duration;
  return task;
}

// The best score, as generate() reports it, without the candidates' feedback. For human, values
// that lower layers find after the search exist only in the candidate.
Run run_layers(Task task, int evaluations, const LimbStore& store, int* cells) {
  task.evaluations = evaluations;
  const Stopwatch watch;
  task.layers.store = store;
  task.layers.feedback_rounds = 0;
  const GenerateResult found = generate(task).value();
  if (cells != nullptr) *cells = found.log.cells_searched;
  const double milliseconds = watch.milliseconds();
  // a miss scores more than the worst, by its error
  double score = std::min(found.best_seen_score, worst_score(task.criteria));
  if (found.meets_goals()) {
    score = std::min(score, found.candidates.front().score.total);
  }
  return {score, milliseconds};
}

Run run_flat(Task task, int evaluations) {
  task.evaluations = evaluations;
  const Stopwatch watch;
  const GenerateResult found = generate(task).value();
  return {found.best_seen_score, watch.milliseconds()};
}

// Medians over the seeds, for one place.
struct Compared {
  double layers = 0.0;
  double flat = 0.0;
  double flat_in_time = 0.0;
  double flat_motions = 0.0;  // that the layers' warm time is enough for
  double cold = 0.0;          // ms
  double warm = 0.0;          // ms
  double flat_time = 0.0;     // ms
  double cells = 0.0;         // searched when cold
};

// Number of motions in that time, at the speed of the measured run; it includes the fixed cost of a
// query, and so is slightly too low.
int motions_in(double milliseconds, int evaluations, const Run& measured) {
  return std::max(evaluations,
                  static_cast<int>(milliseconds / measured.milliseconds * evaluations));
}

int seeds_of(const Plan& plan, int evaluations) {
  return evaluations == kShort ? plan.seeds : plan.slow_seeds;
}

Compared compare(const Plan& plan, const Subject& subject, const Place& place,
                 const Pairing& pairing, int evaluations) {
  std::map<std::string, std::vector<double>> all;
  for (int seed = 1; seed <= seeds_of(plan, evaluations); ++seed) {
    Task layered = pairing_task(subject, place, pairing, pairing.layered);
    Task flat = pairing_task(subject, place, pairing, pairing.flat);
    layered.seed = flat.seed = static_cast<std::uint64_t>(seed);
    MemoryStore memory;
    int cells = 0;
    const Run cold = run_layers(layered, evaluations, memory.store(), &cells);
    const Run warm = run_layers(layered, evaluations, memory.store(), nullptr);
    const Run equal = run_flat(flat, evaluations);
    const int motions = motions_in(warm.milliseconds, evaluations, equal);
    all["layers"].push_back(warm.score);
    all["flat"].push_back(equal.score);
    all["in_time"].push_back(run_flat(flat, motions).score);
    all["motions"].push_back(motions);
    all["cold"].push_back(cold.milliseconds);
    all["warm"].push_back(warm.milliseconds);
    all["flat_time"].push_back(equal.milliseconds);
    all["cells"].push_back(cells);
  }
  return {median(all["layers"]),    median(all["flat"]), median(all["in_time"]),
          median(all["motions"]),   median(all["cold"]), median(all["warm"]),
          median(all["flat_time"]), median(all["cells"])};
}

// One line of the table.
void add_line(const Plan& plan, const Subject& subject, const Pairing& pairing, int evaluations,
              Table& table) {
  std::vector<Compared> compared(subject.places.size());
  parallel_for(static_cast<int>(compared.size()), 0, [&](int i, int) {
    const auto p = static_cast<std::size_t>(i);
    compared[p] = compare(plan, subject, subject.places[p], pairing, evaluations);
  });
  const auto drawn = [&](auto value) {
    std::vector<double> values;
    for (std::size_t p = 0; p < subject.drawn; ++p) values.push_back(value(compared[p]));
    return values;
  };
  const auto feet = std::find_if(subject.places.begin(), subject.places.end(),
                                 [](const Place& place) { return place.name == "at the feet"; });
  const Compared& at_feet = compared[static_cast<std::size_t>(feet - subject.places.begin())];
  const auto ms = [&](auto value) { return fmt::format("{:.1f}", median(drawn(value))); };
  table.add({pairing.criteria_name, subject.posed.body.name(), pairing.name,
             std::to_string(evaluations), spread(drawn([](auto& c) { return c.layers; })),
             spread(drawn([](auto& c) { return c.flat; })),
             spread(drawn([](auto& c) { return c.flat_in_time; })),
             spread(drawn([](auto& c) { return c.layers / c.flat; })),
             spread(drawn([](auto& c) { return c.layers / c.flat_in_time; })),
             fmt::format("{:.2f}", at_feet.layers / at_feet.flat),
             ms([](auto& c) { return c.cold; }), ms([](auto& c) { return c.warm; }),
             ms([](auto& c) { return c.flat_time; }),
             fmt::format("{:.0f}", median(drawn([](auto& c) { return c.cells; }))),
             fmt::format("{:.0f}", median(drawn([](auto& c) { return c.flat_motions; })))});
}

}  // namespace

std::string against_layers(const Plan& plan, std::span<const Subject> subjects) {
  Table table({"criteria", "body", "search", "motions", "layers", "flat", "flat in equal time",
               "layers / flat", "in equal time", "at the feet", "cold, ms", "warm, ms", "flat, ms",
               "cells", "flat motions in warm time"});
  std::vector<Subject> bodies(subjects.begin(), subjects.end());
  bodies.push_back(make_subject(plan, human_body()));
  for (const Pairing& pairing : kPairings) {
    for (const Subject& subject : bodies) {
      add_line(plan, subject, pairing, kShort, table);
      if (!plan.quick) add_line(plan, subject, pairing, kLong, table);
    }
  }
  return fmt::format(
             "`generate_layered()` (trunk and limb lengths above, arms from the limb library "
             "below; human: the swivel of arms, then free arms) "
             "against `generate()` by the same search, criteria, duration and seeds ({} at 300 "
             "motions, {} at 3000): over codes 0..15 against the preset paper, over wide codes "
             "against the preset "
             "flat. "
             "Best score that each saw, a miss being the worst. At equal time, flat scores as many "
             "motions as the layers' warm time is enough for at flat's speed (on one thread each). "
             "Cold "
             "is with no cell of the library searched before, warm the same query again; cells are "
             "what "
             "the cold one searched. Ratios above 1 are in favour of flat; that at the feet is of "
             "equal "
             "motions.\n\n",
             plan.seeds, plan.slow_seeds) +
         table.text();
}

}  // namespace shigusa::bench
