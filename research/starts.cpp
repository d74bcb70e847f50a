// SPDX-License-Identifier: MIT
// shigusa_starts searches the start tables (src/generate/start_table.hpp) and prints them. Tasks of
// each kind are drawn as for a data set, and searched in passes: each pass begins at the table of
// the one before, so that a good posture found for one task spreads to those around it.
// shigusa_starts --check TASKS measures how far the default query ends above the best known score,
// for so many other tasks of each kind, and fails where that is too far.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <shigusa/dataset.hpp>
#include <shigusa/files.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "core/check.hpp"
#include "core/index.hpp"
#include "generate/parameter_space.hpp"
#include "generate/posture_meter.hpp"
#include "generate/start_table.hpp"
#include "problem/make_problem.hpp"

namespace {

using namespace shigusa;

// Motions searched for each task, in the first pass and in each later one.
constexpr int kFirstEvaluations = 1728;
constexpr int kLaterEvaluations = 864;
constexpr int kPasses = 7;
constexpr int kMotions = 7;  // of a row that other searches begin at
constexpr int kWritten = 4;  // of a row in the file, which is less than 1 MB so
constexpr int kAsked = 8;    // candidates of a search

// Tasks of a kind: their number and their form, see docs/data.md.
struct Drawn {
  const char* name = nullptr;
  int tasks = 0;
  const char* form = nullptr;
  bool bent = false;  // begin where a motion to a low place has ended
  int effort = 1;     // times the motions
};
#define SHG_REACH(low) R"({"reach": [[-1.0, )" low R"(, -0.5], [1.0, 2.2, 1.1]]})"
#define SHG_LOAD R"("load_kg": {"choice": [0, {"uniform": [0, 12]}], "shares": [3, 1]})"
#define SHG_OTHER                                                                 \
  R"({"effector": "left_hand", "position_m": {"beside": {"goal": 0, "offset_m":)" \
  R"( {"box_m": [[0.1, -0.1, -0.15], [0.7, 0.1, 0.15]]}}}, )"
#define SHG_ONE(low) R"({"effector": "right_hand", "position_m": )" SHG_REACH(low)
// Half of the places are below the hips, where postures differ most.
#define SHG_LOW                                                         \
  R"({"effector": "right_hand", "position_m": {"choice": [)" SHG_REACH( \
      "0.03") R"(, )"                                                   \
              R"({"reach": [[-0.8, 0.03, -0.3], [0.8, 0.6, 0.9]]}]})"
// Places further off as well, where a body of other proportions may get.
#define SHG_WIDE                                                        \
  R"({"effector": "right_hand", "position_m": {"choice": [)" SHG_REACH( \
      "0.03") R"(, )"                                                   \
              R"({"reach": [[-0.8, 0.03, -0.3], [0.8, 0.6, 0.9]]}, )"   \
              R"({"box_m": [[-1.0, 0.03, -0.6], [1.0, 0.9, 1.0]]}]})"
#define SHG_AXIS                                                                                       \
  R"("axis": {"choice": [{"axis": "palm", "direction": "down"}, {"axis": "palm", "direction": "up"},)" \
  R"( {"axis": "palm", "direction": "in"}, {"axis": "palm", "direction": "ahead"},)"                   \
  R"( {"axis": "fingers", "direction": "ahead"}, {"axis": "thumb", "direction": "up"}]})"
constexpr Drawn kDrawn[] = {
    {"half body", 700, R"({"character": "half_body", "goals": [)" SHG_LOW "}]}"},
    {"full body", 900, R"({"character": "full_body", "goals": [)" SHG_LOW "}]}"},
    {"one hand", 2300, R"({"character": "human", "goals": [)" SHG_WIDE ", " SHG_LOAD "}]}", false,
     2},
    {"both hands", 1300,
     R"({"character": "human", "goals": [)" SHG_LOW ", " SHG_LOAD "}, " SHG_OTHER SHG_LOAD "}]}"},
    {"sitting, one hand", 400,
     R"({"character": {"source": "human", "seat_m": 0.45}, "goals": [)" SHG_ONE("0.03") "}]}"},
    {"sitting, both hands", 200,
     R"({"character": {"source": "human", "seat_m": 0.45}, "goals": [)" SHG_ONE(
         "0.03") "}, " SHG_OTHER R"("load_kg": 0}]})"},
    {"turned, one hand", 1000,
     R"({"character": "human", "goals": [)" SHG_ONE("0.03") ", " SHG_AXIS "}]}"},
    {"turned, both hands", 400,
     R"({"character": "human", "goals": [)" SHG_ONE(
         "0.03") R"(, "axis": {"axis": "palm", "direction": "in"}}, )" SHG_OTHER
                 R"("axis": {"axis": "palm", "direction": "in"}}]})"},
    {"rising, one hand", 500, R"({"character": "human", "goals": [)" SHG_ONE("0.5") "}]}", true},
    {"rising, both hands", 300,
     R"({"character": "human", "goals": [)" SHG_ONE("0.5") "}, " SHG_OTHER R"("load_kg": 0}]})",
     true},
};

constexpr std::size_t kLowKind = 2;  // whose low tasks end where rises begin

// A motion to a task.
struct Known {
  bool possible = false;
  double score = 0.0;
  Look look{};
  std::string digits{};
};

// A task with its known motions, the best one first.
struct Place {
  Task task;
  StartKey key{};
  std::vector<std::string> names{};
  std::vector<Known> known{};
  State end{};  // of the best one
};

std::string digits_of(const std::vector<double>& point) {
  std::string digits;
  const double last = static_cast<double>(kStartDigits.size() - 1);
  for (const double x : point) digits += kStartDigits[static_cast<std::size_t>(x * last + 0.5)];
  return digits;
}

// Keeps the best motions that look different.
void keep_best(std::vector<Known>& known) {
  std::stable_sort(known.begin(), known.end(), [](const Known& a, const Known& b) {
    return std::pair(!a.possible, a.score) < std::pair(!b.possible, b.score);
  });
  std::vector<Known> kept;
  for (Known& motion : known) {
    const auto alike = [&](const Known& other) { return look_alike(other.look, motion.look); };
    if (std::any_of(kept.begin(), kept.end(), alike)) continue;
    if (kept.size() < index(kMotions)) kept.push_back(std::move(motion));
  }
  known = std::move(kept);
}

// Searches a task, and adds the motions found.
void search(int evaluations, std::uint64_t seed, Place& place) {
  Task task = place.task;
  task.batch.threads = 1;
  task.candidates = kAsked;
  task.evaluations = evaluations;
  task.seed = seed;
  const auto found = generate(task);
  if (!found) return;
  const ReachProblem problem = make_problem(task).value();
  const ParameterList list = parameter_list(task.body, task.start, task).value();
  const ParameterSpace space(problem, list, GeneCode::natural);
  PostureMeter meter(task.body, task.home, 0);
  const std::string before = place.known.empty() ? "" : place.known.front().digits;
  for (const Candidate& candidate : found->candidates) {
    place.known.push_back({.possible = candidate.judgement.verdict != Verdict::impossible,
                           .score = candidate.score.total,
                           .look = meter.look(candidate.motion.clip),
                           .digits = digits_of(space.encode(Parameters(candidate.parameters)))});
  }
  keep_best(place.known);
  const std::string& best = place.known.front().digits;
  if (best == before) return;
  const Candidate& first = found->candidates.front();
  place.names = space.names();
  place.key = start_key(problem);
  place.end = {.angles = {}, .velocities = {}, .held = {}};
  const auto last = first.motion.clip.frame(first.motion.clip.frames - 1);
  place.end.angles.assign(last.begin(), last.end());
  std::size_t hand = 0;
  for (const ReachGoal* goal : goals_of_hands(problem)) {
    const auto of = std::find_if(problem.goals.begin(), problem.goals.end(),
                                 [goal](const ReachGoal& other) { return &other == goal; });
    const auto g = static_cast<std::size_t>(of - problem.goals.begin());
    place.key.turns[hand++] = first.goals[g].turn.reached;
  }
}

std::vector<Place> places_of(const Drawn& drawn, std::uint64_t seed) {
  const std::string plan = fmt::format(
      R"({{"version": 1, "name": "starts", "licence": "CC0-1.0", "seed": {}, "tasks": {}, "task": {}}})",
      seed, drawn.tasks, drawn.form);
  const auto read = DatasetPlan::parse(plan, "starts", ".");
  SHG_CHECK(read.has_value(), read ? "" : read.error().to_string());
  std::vector<Place> places;
  for (int k = 0; k < drawn.tasks; ++k) {
    auto file = read->task(static_cast<std::uint64_t>(k));
    if (!file) continue;
    auto task = make_task(file->file, ".");
    SHG_CHECK(task.has_value(), "a drawn task");
    places.push_back({.task = std::move(*task)});
  }
  return places;
}

// Begins tasks where motions to low places have ended.
void bend(std::span<const Place> low, std::vector<Place>& places) {
  std::vector<const Place*> ends;
  for (const Place& place : low) {
    if (place.task.goals.front().position.y < 0.5) ends.push_back(&place);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k].task.start.angles = ends[k * 7 % ends.size()]->end.angles;
  }
}

// The table of a kind, with so many motions of a row at most.
StartTable table_of(const Drawn& drawn, const std::vector<Place>& places, int most) {
  StartTable table;
  for (const Place& place : places) {
    if (table.rows.empty()) {
      table.kind = *start_kind(make_problem(place.task).value());
      table.feet = place.task.body.feet().size();
      for (const std::string& name : place.names) table.names.push_back(name);
    }
    SHG_CHECK(place.names.size() == table.names.size(), "tasks of a kind share their coordinates");
    const auto kind = start_kind(make_problem(place.task).value());
    if (!(*kind == table.kind)) continue;  // a start that is hardly bent
    StartRow& row = table.rows.emplace_back();
    row.key = place.key;
    for (const Known& known : place.known) {
      if (row.motions.size() < index(most)) row.motions.push_back(known.digits);
    }
  }
  SHG_CHECK(!table.rows.empty() && drawn.bent == table.kind.bent, "a kind's rows");
  return table;
}

// Prints the progress of a kind.
void tell(const Drawn& drawn, int pass, std::span<const Place> places) {
  double sum = 0.0;
  std::size_t motions = 0;
  for (const Place& place : places) {
    sum += place.known.front().score;
    motions += place.known.size();
  }
  std::cerr << fmt::format("pass {}, {}: {} tasks, {} motions, mean score {:.4f}\n", pass,
                           drawn.name, places.size(), motions,
                           sum / static_cast<double>(places.size()));
}

// Searches for the best known motion of a task, and their motions.
constexpr int kBestSearches = 3;
constexpr int kBestEvaluations = 30'000;
// Largest excesses over it: the median of tasks, and their ninth tenth.
constexpr double kMostMedian = 0.06;
constexpr double kMostNinth = 0.25;
constexpr std::uint64_t kOtherTasks = 1000;  // added to the seed of tasks that are not in a table

// Excess of the default query's score over the best known one, as a share of it.
double excess_of(Task task) {
  task.batch.threads = 1;
  const auto score = [](const Task& asked) {
    const auto found = generate(asked);
    return found && found->meets_goals() ? found->candidates.front().score.total : -1.0;
  };
  const double asked = score(task);
  if (asked < 0.0) return -1.0;
  task.evaluations = kBestEvaluations;
  double best = asked;
  for (int k = 0; k < kBestSearches; ++k) {
    task.seed = static_cast<std::uint64_t>(k) + 1;
    if (const double found = score(task); found > 0.0) best = min(best, found);
  }
  return (asked - best) / best;
}

// Prints how far the default query ends above the best known score, for drawn tasks of each kind.
// False where that is too far.
bool check(int tasks) {
  bool good = true;
  for (std::size_t k = 0; k < std::size(kDrawn); ++k) {
    Drawn drawn = kDrawn[k];
    drawn.tasks = tasks;
    std::vector<Place> places = places_of(drawn, kOtherTasks + k);
    if (drawn.bent) {
      std::vector<Place> low = places_of(
          {.name = nullptr, .tasks = 4 * tasks, .form = kDrawn[kLowKind].form}, kOtherTasks);
      parallel_for(static_cast<int>(low.size()), 0,
                   [&](int i, int) { search(kLaterEvaluations, 1, low[index(i)]); });
      std::erase_if(low, [](const Place& place) { return place.known.empty(); });
      bend(low, places);
    }
    std::vector<double> excesses(places.size());
    parallel_for(static_cast<int>(places.size()), 0,
                 [&](int i, int) { excesses[index(i)] = excess_of(places[index(i)].task); });
    std::erase_if(excesses, [](double excess) { return excess < 0.0; });
    std::sort(excesses.begin(), excesses.end());
    const double median = excesses[excesses.size() / 2];
    const double ninth = excesses[excesses.size() * 9 / 10];
    good = good && median <= kMostMedian && ninth <= kMostNinth;
    std::cout << fmt::format("{}: {} tasks, median {:.1f} %, ninth tenth {:.1f} %\n", drawn.name,
                             excesses.size(), 100.0 * median, 100.0 * ninth)
              << std::flush;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--check") return check(std::stoi(argv[2])) ? 0 : 1;
  SHG_CHECK(set_start_tables(""), "no table");
  std::vector<std::vector<Place>> places;
  for (const Drawn& drawn : kDrawn) places.push_back(places_of(drawn, places.size() + 1));
  std::vector<StartTable> tables(places.size());
  for (int pass = 0; pass < kPasses; ++pass) {
    const int evaluations = pass == 0 ? kFirstEvaluations : kLaterEvaluations;
    for (std::size_t k = 0; k < places.size(); ++k) {
      std::vector<Place>& all = places[k];
      if (pass == 0 && kDrawn[k].bent) bend(places[kLowKind], all);
      parallel_for(static_cast<int>(all.size()), 0, [&](int i, int) {
        search(kDrawn[k].effort * evaluations, static_cast<std::uint64_t>(pass) + 1, all[index(i)]);
      });
      // what nobody can do is kept: a body of other proportions may
      std::erase_if(all, [](const Place& place) { return place.known.empty(); });
      const bool last = pass + 1 == kPasses;
      tables[k] = table_of(kDrawn[k], all, last ? kWritten : kMotions);
      tell(kDrawn[k], pass, all);
    }
    SHG_CHECK(set_start_tables(start_text(tables)), "tables as written");
  }
  std::cout << "# Start tables, see src/generate/start_table.hpp. Written by scripts/make_starts; "
               "change research/starts.cpp, not this file.\n"
            << start_text(tables);
}
