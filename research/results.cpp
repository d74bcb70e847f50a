// SPDX-License-Identifier: MIT
// Measures the figures of docs/results.md and writes that page with its pictures.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <shigusa/run.hpp>
#include <shigusa/shigusa.hpp>
#include <string>
#include <vector>

#include "problem/make_problem.hpp"
#include "rollout/detour.hpp"
#include "rollout/rollout.hpp"

namespace {

using namespace shigusa;

struct Experiment {
  const char* title;
  const char* file;  // stem of its pictures
  Vec3d goal;
};

// Goals of the paper, which gives them in words only (sections 4.1 and 4.2).
const Experiment kExperiments[] = {
    {"Low front-left (section 4.1, figures 4 and 5)", "low_front_left", {0.25, 0.55, 0.50}},
    {"At the feet (section 4.2, figure 6)", "at_the_feet", {-0.05, 0.10, 0.30}},
};
constexpr int kSeeds = 32;
constexpr int kLongBudget = 5000;
constexpr std::uint64_t kShownSeed = 1;

Task make(const PosedBody& posed, const Vec3d& goal, std::uint64_t seed) {
  Task task = with_preset(Task(posed), Preset::paper);
  task.goals = {{"right_hand", goal}};
  task.seed = seed;
  task.batch.threads = 1;
  return task;
}

double seconds_of(const Task& task, GenerateResult& generation) {
  const auto begin = std::chrono::steady_clock::now();
  generation = generate(task).value();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

// Best score among random genomes of the paper's code.
double best_of_random(const Task& task, int count, std::uint64_t seed) {
  ReachProblem problem = make_problem(task).value();
  add_detours(problem);
  Random random(seed, 99);
  double best = worst_score(task.criteria);
  for (int i = 0; i < count; ++i) {
    std::vector<std::uint16_t> genes;
    for (int d = 0; d < task.body.dof_count(); ++d) {
      genes.push_back(static_cast<std::uint16_t>(random.below(16)));
    }
    const RolledOut rolled = roll_out(problem, decode_paper_genes(task.body, genes));
    if (!rolled.outcome.met()) continue;
    best = std::min(best, score_motion(task.body, rolled.motion, task.criteria).total);
  }
  return best;
}

void single_runs(const PosedBody& posed, const Experiment& experiment, std::string& page) {
  std::vector<double> best, random, evaluations, milliseconds, candidates;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Task task = make(posed, experiment.goal, seed);
    GenerateResult g;
    milliseconds.push_back(1e3 * seconds_of(task, g));
    best.push_back(g.best_seen_score);
    random.push_back(best_of_random(task, g.log.evaluations, seed));
    evaluations.push_back(g.log.evaluations);
    candidates.push_back(static_cast<double>(g.candidates.size()));
  }
  page += fmt::format(
      "| {} | {} | {:.0f} | {:.3f} ({:.3f}–{:.3f}) | {:.3f} ({:.3f}–{:.3f}) | {:.0f} | {:.1f} |\n",
      experiment.title, posed.body.name(), quantile(evaluations, 0.5), quantile(best, 0.5),
      quantile(best, 0.25), quantile(best, 0.75), quantile(random, 0.5), quantile(random, 0.25),
      quantile(random, 0.75), quantile(candidates, 0.5), quantile(milliseconds, 0.5));
}

void candidate_table(const GenerateResult& generation, std::string& page) {
  page +=
      "| rank | score | joint range | balance | torque | hand's error, mm | foot's slide, mm | "
      "most over its limit |\n|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < generation.candidates.size(); ++i) {
    const Candidate& c = generation.candidates[i];
    double slide = 0.0;
    for (const ContactResult& foot : c.contacts) slide = std::max(slide, foot.max_slide);
    const std::string over = c.measures.over_limit.empty()
                                 ? "–"
                                 : fmt::format("{} by {:.0f}°", c.measures.over_limit[0].dof,
                                               degrees(c.measures.over_limit[0].excess));
    page += fmt::format("| {} | {:.4f} | {:.3f} | {:.3f} | {:.3f} | {:.4f} | {:.4f} | {} |\n",
                        i + 1, c.score.total, c.score.terms[0].penalty, c.score.terms[1].penalty,
                        c.score.terms[2].penalty, 1e3 * c.goals[0].error, 1e3 * slide, over);
  }
}

// Writes a candidate's figure; returns the line of the page that shows it.
std::string picture(const std::filesystem::path& docs, const Task& task, const Candidate& candidate,
                    const std::string& name, const std::string& words) {
  const std::string svg = export_candidate(task, candidate, FileFormat::svg).value();
  std::ofstream(docs / "images" / "results" / name, std::ios::binary) << svg;
  return fmt::format("\n![{}](images/results/{})\n", words, name);
}

void show(const std::filesystem::path& docs, const PosedBody& posed, const Experiment& experiment,
          bool long_search, std::string& page) {
  Task task = make(posed, experiment.goal, kShownSeed);
  if (long_search) task.evaluations = kLongBudget;
  GenerateResult generation;
  const double seconds = seconds_of(task, generation);
  page += fmt::format(
      "\n### {}: {}, {}\n\nGoal ({:g}, {:g}, {:g}) m, seed {}: {} motions of {:.2f} s scored in "
      "{:.0f} ms on one core; {} final genomes missed, {} were near copies.\n\n",
      experiment.title, posed.body.name(),
      long_search ? fmt::format("{} motions", kLongBudget) : "one run of the paper's search",
      experiment.goal.x, experiment.goal.y, experiment.goal.z, kShownSeed,
      generation.log.evaluations, generation.duration, 1e3 * seconds, generation.log.missed,
      generation.log.near_copies);
  candidate_table(generation, page);
  const std::size_t shown =
      std::min<std::size_t>(long_search ? 2 : 1, generation.candidates.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string name = fmt::format("{}-{}{}-{}.svg", experiment.file, posed.body.name(),
                                         long_search ? "" : "-one_run", i + 1);
    page += picture(docs, task, generation.candidates[i], name,
                    fmt::format("{}, candidate {}", experiment.title, i + 1));
  }
}

std::string results_page(const std::filesystem::path& docs) {
  std::string page =
      "# Results\n\nThis page and its pictures are written by `scripts/make_results`; change "
      "`research/results.cpp`, not the page.\n\nThe paper's two experiments (its section 4) under "
      "the preset `paper`: 4-bit weights of all joints at once, its three criteria and its "
      "genetic algorithm. The paper tells its goals in words; the coordinates are ours. Body: a "
      "man of 1.741 m and 73 kg. Scores lie between 0 and 1, lower is better.\n\n"
      "## One run of the paper's search\n\nMedian and quartiles over " +
      fmt::format("{} seeds", kSeeds) +
      "; the random column is the best of as many random genomes as the run scored. The time is "
      "of the whole search on one core, the test of reach included.\n\n"
      "| experiment | body | motions scored | best score | best of random | candidates | "
      "ms |\n|---|---|---|---|---|---|---|\n";
  const PosedBody bodies[] = {half_body(), full_body()};
  for (const PosedBody& posed : bodies) {
    for (const Experiment& experiment : kExperiments) single_runs(posed, experiment, page);
  }
  page += "\n## Candidates\n";
  for (const Experiment& experiment : kExperiments) {
    show(docs, bodies[0], experiment, false, page);
    for (const PosedBody& posed : bodies) show(docs, posed, experiment, true, page);
  }
  std::ifstream remarks(docs / "results_remarks.md");
  page += "\n";
  page.append(std::istreambuf_iterator<char>(remarks), {});
  return page;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: shigusa_results DOCS_FOLDER\n";
    return 2;
  }
  const std::filesystem::path docs = argv[1];
  std::filesystem::create_directories(docs / "images" / "results");
  const std::string page = results_page(docs);
  std::ofstream(docs / "results.md", std::ios::binary) << page;
  std::cout << (docs / "results.md").string() << "\n";
  return 0;
}
