// SPDX-License-Identifier: MIT
#include "persons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "../experiments/report.hpp"
#include "measures.hpp"
#include "recorded_reaches.hpp"

namespace shigusa::bench {
namespace {

constexpr int kCandidates = 8;
constexpr double kAside = 0.15;     // m, of one hand
constexpr double kHalfBox = 0.165;  // m, of each of two
constexpr double kTrunkNear = radians(15.0);
constexpr double kKneeNear = radians(20.0);
constexpr double kMoves = 0.05;  // of its greatest speed: a wrist that is slower rests

// A recorded reach and its generated motions.
struct Beside {
  bool met = false;
  std::vector<ReachFigures> candidates;  // the best-scored first
  std::size_t nearest = 0;
};

double off(const ReachFigures& a, const ReachFigures& b) {
  const double trunk = (a.trunk - b.trunk) / kTrunkNear;
  const double knee = (a.knee - b.knee) / kKneeNear;
  return trunk * trunk + knee * knee;
}

bool same_style(const ReachFigures& a, const ReachFigures& b) {
  return std::fabs(a.trunk - b.trunk) <= kTrunkNear && std::fabs(a.knee - b.knee) <= kKneeNear;
}

// Time of the wrist's greatest speed, as a share of its movement time.
double peak_of(const Track& track) {
  std::vector<double> speeds;
  for (std::size_t f = 1; f < track.joints.size(); ++f) {
    speeds.push_back(norm(track.joints[f][right_wrist] - track.joints[f - 1][right_wrist]));
  }
  const auto top = std::max_element(speeds.begin(), speeds.end());
  const auto moves = [&](double speed) { return speed >= kMoves * *top; };
  const auto first = std::find_if(speeds.begin(), speeds.end(), moves);
  const auto last = std::find_if(speeds.rbegin(), speeds.rend(), moves).base() - 1;
  return last == first ? 0.5 : static_cast<double>(top - first) / static_cast<double>(last - first);
}

ReachFigures figures_of(const Track& track) {
  const Joints& first = track.joints.front();
  const Joints& last = track.joints.back();
  const Looks looks = looks_of(track);
  return {.trunk = trunk_lean(last) - trunk_lean(first),
          .knee = mean_knee(last) - mean_knee(first),
          .drop = looks.drop,
          .back = looks.back,
          .bow = forward_bow(track, right_wrist) / norm(last[right_wrist] - first[right_wrist]),
          .peak = peak_of(track)};
}

Beside beside(const PosedBody& posed, const RecordedReach& reach) {
  Task task(posed);
  const double aside = reach.both ? kHalfBox : kAside;
  task.goals = {{"right_wrist", {-aside, reach.height, reach.ahead}}};
  if (reach.both) task.goals.push_back({"left_wrist", {aside, reach.height, reach.ahead}});
  task.duration = reach.duration;
  task.candidates = kCandidates;
  task.batch.threads = 1;
  const GenerateResult generation = generate(task).value();
  Beside result{.met = generation.meets_goals(), .candidates = {}};
  for (const Candidate& candidate : generation.candidates) {
    result.candidates.push_back(figures_of(joints_track(posed, candidate.motion.clip)));
  }
  const auto nearer = [&](const ReachFigures& a, const ReachFigures& b) {
    return off(a, reach.figures) < off(b, reach.figures);
  };
  const auto nearest = std::min_element(result.candidates.begin(), result.candidates.end(), nearer);
  result.nearest = static_cast<std::size_t>(nearest - result.candidates.begin());
  return result;
}

struct Column {
  const char* name;
  double ReachFigures::*member;
  double scale;
  int digits;
};
constexpr std::array kColumns{Column{"trunk, °", &ReachFigures::trunk, 180.0 / kPi, 0},
                              Column{"knee, °", &ReachFigures::knee, 180.0 / kPi, 0},
                              Column{"pelvis drop, cm", &ReachFigures::drop, 100.0, 0},
                              Column{"pelvis back, cm", &ReachFigures::back, 100.0, 0},
                              Column{"bow / distance", &ReachFigures::bow, 1.0, 2},
                              Column{"peak", &ReachFigures::peak, 1.0, 2}};

std::string table_of(const std::vector<RecordedReach>& reaches, const std::vector<Beside>& made) {
  std::vector<std::string> head{"person", "hands", "s", "wrist, m"};
  for (const Column& column : kColumns) head.emplace_back(column.name);
  head.emplace_back("style");
  Table table(head);
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const RecordedReach& reach = reaches[i];
    const ReachFigures& best = made[i].candidates.front();
    const ReachFigures& nearest = made[i].candidates[made[i].nearest];
    std::vector<std::string> cells{
        reach.person, reach.both ? "two" : "one", fmt::format("{:.2f}", reach.duration),
        fmt::format("{:.2f} > {:.2f}{}", reach.from, reach.height, made[i].met ? "" : ", missed")};
    for (const Column& c : kColumns) {
      const auto cell = [&](const ReachFigures& of) {
        return fmt::format("{:.{}f}", of.*c.member * c.scale, c.digits);
      };
      cells.push_back("**" + cell(reach.figures) + "** " + cell(best) + " " + cell(nearest));
    }
    const bool first = same_style(best, reach.figures);
    const bool some = same_style(nearest, reach.figures);
    cells.emplace_back(first ? "first" : some ? "among 8" : "no");
    table.add(cells);
  }
  return table.text();
}

// Share of persons whose style the chosen candidates have; a person with several styles counts by
// their shares.
double share_of_persons(const std::vector<RecordedReach>& reaches, const std::vector<bool>& same) {
  std::map<std::string, std::pair<int, int>> counts;  // of the same style, and all
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    auto& [found, all] = counts[reaches[i].person];
    found += same[i] ? 1 : 0;
    ++all;
  }
  double sum = 0.0;
  for (const auto& [person, count] : counts) {
    sum += static_cast<double>(count.first) / count.second;
  }
  return sum / static_cast<double>(counts.size());
}

// Medians of the differences from the recorded figures, and shares of styles.
std::string sums(const std::vector<RecordedReach>& reaches, const std::vector<Beside>& made) {
  Table table({"median difference from the record", "trunk, °", "knee, °", "pelvis drop, cm",
               "pelvis back, cm", "bow / distance", "peak", "same style", "of persons"});
  const auto row = [&](const char* name, const std::function<std::size_t(const Beside&)>& chosen) {
    std::vector<std::string> cells{name};
    for (const Column& c : kColumns) {
      std::vector<double> differences;
      for (std::size_t i = 0; i < reaches.size(); ++i) {
        const ReachFigures& of = made[i].candidates[chosen(made[i])];
        differences.push_back(std::fabs(of.*c.member - reaches[i].figures.*c.member) * c.scale);
      }
      cells.push_back(fmt::format("{:.{}f}", median(differences), c.digits));
    }
    std::vector<bool> same;
    for (std::size_t i = 0; i < reaches.size(); ++i) {
      same.push_back(same_style(made[i].candidates[chosen(made[i])], reaches[i].figures));
    }
    cells.push_back(
        fmt::format("{} of {}", std::count(same.begin(), same.end(), true), reaches.size()));
    cells.push_back(fmt::format("{:.0f} %", 100.0 * share_of_persons(reaches, same)));
    table.add(cells);
  };
  row("best-scored", [](const Beside&) { return std::size_t{0}; });
  row("nearest of 8", [](const Beside& b) { return b.nearest; });
  return table.text();
}

}  // namespace

Result<std::string> persons_section(const std::filesystem::path& path) {
  SHG_TRY_ASSIGN(const std::vector<RecordedReach> reaches, read_recorded_reaches(path));
  const PosedBody posed = human_body();
  std::vector<Beside> made(reaches.size());
  parallel_for(static_cast<int>(reaches.size()), 0, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    made[i] = beside(posed, reaches[i]);
  });
  std::string text = fmt::format(
      "## Recorded persons\n\nThe reaches of `../shared/people/reaches.tsv` that begin upright "
      "with arms hanging, on the built-in body `human` (their statures are not known): the wrist "
      "goes to the recorded height and distance ahead in the recorded time; {} candidates of the "
      "default preset. The box lifters were asked to squat. Changes from start to end, "
      "**recorded**, "
      "best-scored, nearest of {} by trunk and knee. *Bow*: how far in front of its straight way "
      "the wrist is where it is farthest from that; *peak*: the share of the time at which it is "
      "fastest. The same *style*: a trunk within {:.0f}° and knees within {:.0f}° of the recorded "
      "change; *of persons*: each person counts once, by the share of their reaches.\n\n",
      kCandidates, kCandidates, degrees(kTrunkNear), degrees(kKneeNear));
  return text + sums(reaches, made) + "\n" + table_of(reaches, made);
}

}  // namespace shigusa::bench
