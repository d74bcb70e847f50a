// SPDX-License-Identifier: MIT
// Learns from a data set where to begin: for a goal and a body nobody has searched for yet, the
// parameters of the best motions of tasks like it. The last tasks of the data set's plan are kept
// from the table, searched with and without such starts, and compared.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <shigusa/dataset.hpp>
#include <shigusa/dataset_read.hpp>
#include <shigusa/shigusa.hpp>
#include <string>
#include <vector>

namespace {

using shigusa::DatasetMotion;
using shigusa::DatasetPlan;
using shigusa::Goal;
using shigusa::Parameters;
using shigusa::Task;

constexpr std::size_t kNearest = 8;  // starts of a search; its own table gives as many
constexpr std::uint64_t kUnseen = 300;
constexpr std::array kBudgets{16, 64, 128, 432, 864, 1728};  // motions
constexpr double kNever = 1e9;                               // the score of no motion

// The tasks that may learn from one another: the same effectors, alike turned and loaded, of
// somebody who stands or sits.
std::string kind_of(const std::vector<Goal>& goals, bool sits) {
  std::string kind = sits ? "sits" : "stands";
  for (const Goal& goal : goals) {
    kind += ", " + goal.effector + (goal.axis || goal.rotation ? " turned" : "") +
            (goal.load > 0.0 ? " loaded" : "");
  }
  return kind;
}

// A task as numbers that are alike where its motions are: places in statures, loads in the body's
// mass.
std::vector<double> features_of(const std::vector<Goal>& goals, double stature, double mass,
                                double seat) {
  std::vector<double> features{seat / stature};
  for (const Goal& goal : goals) {
    for (int k = 0; k < 3; ++k) features.push_back(goal.position[k] / stature);
    features.push_back(goal.load / mass);
  }
  return features;
}

double square_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

// A row of the table: a task that was searched, and the parameters of its best motion.
struct Row {
  std::vector<double> features;
  std::vector<double> parameters;
};
// The rows of a kind of tasks.
struct Rows {
  std::vector<std::string> names;  // of the parameters
  std::vector<Row> rows;
};
using Learned = std::map<std::string, Rows>;  // by the kind

// The best possible motion of each task before number `end`.
shigusa::Result<Learned> learn(const char* folder, std::uint64_t end) {
  Learned learned;
  const auto read = shigusa::read_motions(folder, [&](const DatasetMotion& motion) {
    const bool possible = motion.verdict != shigusa::Verdict::impossible;
    if (motion.rank != 1 || !possible || motion.task >= end) return;
    Rows& rows = learned[kind_of(motion.goals, motion.seat.has_value())];
    if (rows.names.empty()) rows.names.assign(motion.names.begin(), motion.names.end());
    if (!std::ranges::equal(rows.names, motion.names)) return;  // a body of other freedoms
    rows.rows.push_back(
        {features_of(motion.goals, motion.stature, motion.mass, motion.seat.value_or(0.0)),
         motion.parameters});
  });
  if (!read) return tl::unexpected(read.error());
  return learned;
}

// The parameters of the tasks that are nearest, nearest first.
std::vector<Parameters> starts_for(const Task& task, const Rows& known,
                                   const std::vector<double>& features) {
  std::vector<std::pair<double, const Row*>> nearest;
  for (const Row& row : known.rows) {
    nearest.emplace_back(square_distance(features, row.features), &row);
  }
  const std::size_t count = std::min(kNearest, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count),
                    nearest.end());
  std::vector<Parameters> starts;
  for (std::size_t k = 0; k < count; ++k) {
    const auto values = shigusa::named_parameters(task, known.names, nearest[k].second->parameters);
    if (values) starts.push_back(*values);
  }
  return starts;
}

// The score of the first motion that a search delivers.
double score_of(const Task& task) {
  const auto found = shigusa::generate(task);
  const bool reached = found && found->status == shigusa::ReachStatus::reached;
  return reached ? found->candidates[0].score.total : kNever;
}

// A task that was kept from the table, searched by each budget.
struct Compared {
  std::string kind;
  double scores[2][kBudgets.size()] = {};  // without learned starts, and with them
  double best = kNever;                    // of all of these
};

Compared compare(const DatasetPlan& plan, std::uint64_t number, const Learned& learned) {
  Compared compared;
  auto drawn = plan.task(number);
  if (!drawn) return compared;
  shigusa::TaskFile& file = drawn->file;
  auto task = shigusa::make_task(file, {});
  if (!task) return compared;
  task->batch.threads = 1;  // tasks run side by side
  // scores of motions that take longer are no comparison: one duration for all searches
  const auto usual = shigusa::generate(*task);
  if (!usual || usual->status != shigusa::ReachStatus::reached) return compared;
  task->duration = usual->duration;
  const auto& seat = file.character.seat;
  const auto known = learned.find(kind_of(file.goals, seat.has_value()));
  if (known == learned.end()) return compared;
  compared.kind = known->first;
  Task taught = *task;
  taught.starts = starts_for(
      taught, known->second,
      features_of(file.goals, task->body.stature(), task->body.mass(), seat.value_or(0.0)));
  for (std::size_t b = 0; b < kBudgets.size(); ++b) {
    task->evaluations = taught.evaluations = kBudgets[b];
    for (const bool with : {false, true}) {
      const double score = score_of(with ? taught : *task);
      compared.scores[with][b] = score;
      compared.best = std::min(compared.best, score);
    }
  }
  return compared;
}

// How far above the best known score the tasks are (per cent): that share of them is no farther.
double above_best(const std::vector<const Compared*>& tasks, std::size_t b, bool with,
                  double share) {
  std::vector<double> above;
  for (const Compared* task : tasks) {
    const double score = task->scores[with][b];
    above.push_back(score < kNever ? 100.0 * (score / task->best - 1.0) : kNever);
  }
  std::sort(above.begin(), above.end());
  return above[static_cast<std::size_t>(share * static_cast<double>(above.size() - 1))];
}

// The motions that a search without learned starts scores for the same median, between budgets by
// their logarithms.
double motions_without(const std::vector<const Compared*>& tasks, double median) {
  double before = kNever;
  for (std::size_t b = 0; b < kBudgets.size(); ++b) {
    const double here = above_best(tasks, b, false, 0.5);
    if (here <= median) {
      if (b == 0 || before == kNever) return kBudgets[b];
      const double ratio = static_cast<double>(kBudgets[b]) / kBudgets[b - 1];
      return kBudgets[b - 1] * std::pow(ratio, (before - median) / (before - here));
    }
    before = here;
  }
  return kNever;
}

std::string shown(double number, const char* form) {
  char text[32];
  std::snprintf(text, sizeof text, form, number);
  return number < kNever ? text : "-";
}

void print(const std::string& kind, const std::vector<const Compared*>& tasks, std::size_t rows) {
  std::printf("\n%s (%zu tasks; %zu in the table)\n", kind.c_str(), tasks.size(), rows);
  std::printf("  motions   without: median, 9/10   with: median, 9/10   same median without\n");
  for (std::size_t b = 0; b < kBudgets.size(); ++b) {
    std::printf("  %7d  ", kBudgets[b]);
    for (const bool with : {false, true}) {
      for (const double share : {0.5, 0.9}) {
        std::printf("%11s", shown(above_best(tasks, b, with, share), "%.1f %%").c_str());
      }
    }
    const double motions = motions_without(tasks, above_best(tasks, b, true, 0.5));
    std::printf("%22s\n", shown(motions, "%.0f").c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: %s FOLDER [TASKS]\n", argv[0]), 1;
  const auto plan = DatasetPlan::read(std::filesystem::path(argv[1]) / shigusa::kPlanName);
  if (!plan) return std::fprintf(stderr, "%s\n", plan.error().to_string().c_str()), 1;
  const std::uint64_t asked = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : kUnseen;
  const std::uint64_t unseen = std::min(asked, plan->tasks() / 2);
  const std::uint64_t first = plan->tasks() - unseen;
  const auto learned = learn(argv[1], first);
  if (!learned) return std::fprintf(stderr, "%s\n", learned.error().to_string().c_str()), 1;
  std::vector<Compared> all(unseen);
  shigusa::parallel_for(static_cast<int>(unseen), 0, [&](int k, int) {
    const auto i = static_cast<std::size_t>(k);
    all[i] = compare(*plan, first + i, *learned);
  });
  std::map<std::string, std::vector<const Compared*>> kinds;
  for (const Compared& one : all) {
    if (one.best < kNever) kinds[one.kind].push_back(&one);
  }
  for (const auto& [kind, tasks] : kinds) print(kind, tasks, learned->at(kind).rows.size());
  return kinds.empty() ? 1 : 0;
}
