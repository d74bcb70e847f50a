// SPDX-License-Identifier: MIT
#include "jolts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <shigusa/generate.hpp>
#include <shigusa/parallel.hpp>

#include "../experiments/report.hpp"
#include "jolt_meter.hpp"
#include "random_tasks.hpp"

namespace shigusa::bench {
namespace {

constexpr int kTasks = 500;
constexpr std::size_t kNamesShown = 6;

// What one task's candidates do; none where the goals are not met.
struct Measured {
  std::vector<Jolts> candidates;
  std::vector<std::string> names;  // (freedoms) of the body
};

Measured measured(int index) {
  const Task task = hand_task(index);
  const auto generation = generate(task);
  if (!generation || !generation->meets_goals()) return {};
  const BodyModel body = prepared(task).value().body;
  Measured result;
  for (const Dof& dof : body.dofs()) result.names.push_back(dof.name);
  for (const Candidate& candidate : generation->candidates) {
    result.candidates.push_back(jolts_of(body, candidate.motion));
  }
  return result;
}

// Counts of motions.
struct Count {
  int all = 0, pressure = 0, torque = 0, both = 0;

  void add(const Jolts& jolts) {
    ++all;
    if (jolts.pressure_jolts()) ++pressure;
    if (jolts.torque_jolts()) ++torque;
    if (jolts.pressure_jolts() && jolts.torque_jolts()) ++both;
  }
  [[nodiscard]] std::vector<std::string> cells() const {
    if (all == 0) return {"0", "–", "–", "–"};
    return {std::to_string(all), percent(pressure + torque - both, all), percent(pressure, all),
            percent(torque, all)};
  }
};

// The motions of one kind of task.
struct KindCount {
  Count first, every;

  void add(const Measured& task) {
    for (std::size_t c = 0; c < task.candidates.size(); ++c) {
      if (c == 0) first.add(task.candidates[c]);
      every.add(task.candidates[c]);
    }
  }
};

std::string shares(const std::vector<Measured>& tasks) {
  Table table({"asked for", "first choices", "jolt", "by pressure", "by a torque", "candidates",
               "jolt", "by pressure", "by a torque"});
  const auto kinds = hand_task_kinds();
  std::vector<KindCount> counts(kinds.size());
  KindCount all;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    counts[i % kinds.size()].add(tasks[i]);
    all.add(tasks[i]);
  }
  const auto row = [&](const std::string& name, const KindCount& count) {
    std::vector<std::string> cells{name};
    for (const Count* each : {&count.first, &count.every}) {
      const auto more = each->cells();
      cells.insert(cells.end(), more.begin(), more.end());
    }
    table.add(cells);
  };
  for (std::size_t k = 0; k < kinds.size(); ++k) row(kinds[k], counts[k]);
  row("**all**", all);
  return table.text();
}

// Words for the place of a frame among a motion's 60.
const char* part_of(int frame) {
  if (frame <= 2) return "1–2";
  if (frame <= 20) return "3–20";
  if (frame <= 40) return "21–40";
  if (frame <= 56) return "41–56";
  return frame <= 58 ? "57–58" : "59–60";
}

// "21–40 (12), 41–56 (3)": the most frequent first.
std::string most_frequent(const std::map<std::string, int>& counts) {
  std::vector<std::pair<std::string, int>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(sorted.size(), kNamesShown); ++i) {
    text += fmt::format("{}{} ({})", i == 0 ? "" : ", ", sorted[i].first, sorted[i].second);
  }
  return text.empty() ? "–" : text;
}

// What jolts, what moves it, and when; of all candidates.
std::string causes(const std::vector<Measured>& tasks) {
  std::map<std::string, int> joints, frames[2], drivers[2], rooms[2];
  const auto take = [&](const Measured& task, const Jolt& jolt, std::size_t kind) {
    ++frames[kind][part_of(jolt.frame)];
    if (jolt.joint >= 0) ++joints[task.names[static_cast<std::size_t>(jolt.joint)]];
    if (jolt.driver < 0) return;
    ++drivers[kind][task.names[static_cast<std::size_t>(jolt.driver)]];
    ++rooms[kind][jolt.room < radians(0.2) ? "at it" : jolt.room < radians(8.0) ? "< 8°" : "> 8°"];
  };
  for (const Measured& task : tasks) {
    for (const Jolts& jolts : task.candidates) {
      if (jolts.pressure_jolts()) take(task, jolts.pressure, 0);
      if (jolts.torque_jolts()) take(task, jolts.torque, 1);
    }
  }
  Table table({"", "the pressure", "a torque"});
  table.add({"frames", most_frequent(frames[0]), most_frequent(frames[1])});
  table.add({"joint whose torque it is", "–", most_frequent(joints)});
  table.add({"joint that makes it", most_frequent(drivers[0]), most_frequent(drivers[1])});
  table.add({"from its limit", most_frequent(rooms[0]), most_frequent(rooms[1])});
  return table.text();
}

}  // namespace

std::string jolts_section() {
  std::vector<Measured> tasks(kTasks);
  parallel_for(kTasks, 0, [&](int i, int) { tasks[static_cast<std::size_t>(i)] = measured(i); });
  const auto met = std::count_if(tasks.begin(), tasks.end(),
                                 [](const Measured& task) { return !task.candidates.empty(); });
  std::string text = fmt::format(
      "## Jolts\n\nThe motions of {} random tasks of hands for the body `human` (statures of 1.45 "
      "to 2.00 m, both sexes), {} of which meet their goals. A motion jolts where from one of its "
      "60 frames to the next the floor's centre of pressure moves by more than {:.0f} cm, or a "
      "torque by more than {:.0f} % of its joint's strength both ways together.\n\n",
      kTasks, met, 100.0 * kPressureMoves, 100.0 * kTorqueMoves);
  text += shares(tasks);
  text +=
      "\nThe greatest change of each motion that jolts, with the number of motions. *Joint that "
      "makes it*: the freedom whose change of acceleration makes the largest part of it; *from its "
      "limit*: how far that one is from its nearest limit then.\n\n";
  return text + causes(tasks);
}

}  // namespace shigusa::bench
