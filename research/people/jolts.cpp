// SPDX-License-Identifier: MIT
#include "jolts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "../experiments/report.hpp"
#include "jolt_meter.hpp"
#include "random_tasks.hpp"

namespace shigusa::bench {
namespace {

constexpr int kTasks = 500;
constexpr std::size_t kNamesShown = 6;

// Jolts of one task's candidates; empty if the goals are not met.
struct Measured {
  std::vector<Jolts> candidates;
  std::vector<Verdict> verdicts;   // of them
  std::vector<std::string> names;  // (dofs) of the body
};

Measured measured(int index) {
  const Task task = hand_task(index);
  const auto generation = generate(task);
  if (!generation || !generation->meets_goals()) return {};
  const BodyModel body = PreparedTask::of(task).value().task().body;
  Measured result;
  for (const Dof& dof : body.dofs()) result.names.push_back(dof.name);
  for (const Candidate& candidate : generation->candidates) {
    result.candidates.push_back(jolts_of(body, candidate.motion));
    result.verdicts.push_back(candidate.judgement.verdict);
  }
  return result;
}

// Numbers of motions.
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

// Numbers of first choices and of all candidates.
struct BothCounts {
  Count first, every;

  void add(const Jolts& jolts, bool is_first) {
    if (is_first) first.add(jolts);
    every.add(jolts);
  }
  [[nodiscard]] std::vector<std::string> row(const std::string& name) const {
    std::vector<std::string> cells{name};
    for (const Count* each : {&first, &every}) {
      const auto more = each->cells();
      cells.insert(cells.end(), more.begin(), more.end());
    }
    return cells;
  }
};

std::string shares(const std::vector<Measured>& tasks) {
  Table table({"", "first choices", "jolt", "by pressure", "by a torque", "candidates", "jolt",
               "by pressure", "by a torque"});
  const auto kinds = hand_task_kinds();
  std::vector<BothCounts> by_kind(kinds.size());
  std::array<BothCounts, kEnumWords<Verdict>.size()> by_verdict;
  BothCounts all;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (std::size_t c = 0; c < tasks[i].candidates.size(); ++c) {
      const Jolts& jolts = tasks[i].candidates[c];
      by_kind[i % kinds.size()].add(jolts, c == 0);
      by_verdict[static_cast<std::size_t>(tasks[i].verdicts[c])].add(jolts, c == 0);
      all.add(jolts, c == 0);
    }
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) table.add(by_kind[k].row(kinds[k]));
  table.add(all.row("**all**"));
  for (const auto& word : kEnumWords<Verdict>) {
    const auto name = fmt::format("of these, *{}*", word_of(word.value));
    table.add(by_verdict[static_cast<std::size_t>(word.value)].row(name));
  }
  return table.text();
}

// Words for the position of a frame among a motion's 60.
const char* part_of(int frame) {
  if (frame <= 2) return "1–2";
  if (frame <= 20) return "3–20";
  if (frame <= 40) return "21–40";
  if (frame <= 56) return "41–56";
  return frame <= 58 ? "57–58" : "59–60";
}

// Frequencies, "21–40 (12), 41–56 (3)": the most frequent first.
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

// Table of the joints, times and events of jolts, over all candidates.
std::string causes(const std::vector<Measured>& tasks) {
  std::map<std::string, int> joints, frames[2], drivers[2], events[2];
  const auto take = [&](const Measured& task, const Jolt& jolt, std::size_t kind) {
    ++frames[kind][part_of(jolt.frame)];
    ++events[kind][kJoltEvents[static_cast<std::size_t>(jolt.event)]];
    if (jolt.joint >= 0) ++joints[task.names[static_cast<std::size_t>(jolt.joint)]];
    if (jolt.driver < 0) return;
    ++drivers[kind][task.names[static_cast<std::size_t>(jolt.driver)]];
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
  table.add({"what happens then", most_frequent(events[0]), most_frequent(events[1])});
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
      kTasks, met, 100.0 * kPressureJolt, 100.0 * kTorqueJolt);
  text += shares(tasks);
  text +=
      "\nThe greatest change of each motion that jolts, with the number of motions. *Joint that "
      "makes it*: the freedom whose change of acceleration makes the largest part of it; *what "
      "happens then*: at the motion's ends that; else a joint that is stopped by its limit, or "
      "leaves "
      "it at once, or changes its step at once, in this order; else nothing of these.\n\n";
  return text + causes(tasks);
}

}  // namespace shigusa::bench
