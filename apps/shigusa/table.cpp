// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/draw.hpp>
#include <type_traits>

#include "commands.hpp"
#include "text_table.hpp"

namespace shigusa::app {
namespace {

using Align = TextTable::Align;
using Candidates = std::vector<Candidate>;

constexpr double kMillimetres = 1e3;

// A value of each candidate.
template <class Value>
auto of_each(const Candidates& candidates, const Value& value) {
  std::vector<std::invoke_result_t<Value, const Candidate&>> values;
  for (const Candidate& candidate : candidates) values.push_back(value(candidate));
  return values;
}

std::string most_loaded_words(const BodyModel& body, const MotionMeasures& measures) {
  const JointLoad* load = most_loaded(measures);
  if (load == nullptr) return "-";
  return fmt::format("{:.0f} % {}", 100.0 * load->share, printable(body.dof(load->dof).name));
}

std::string most_over_words(const MotionMeasures& measures) {
  if (measures.over_limit.empty()) return "-";
  const LimitExcess& most = measures.over_limit.front();
  return fmt::format("{} by {:.0f}°", printable(most.dof), degrees(most.excess));
}

std::string balance_words(const MotionMeasures& measures) {
  if (!measures.support) return "-";
  return fmt::format("{:.0f}", kMillimetres * measures.support->centre_of_mass.distance);
}

double worst_error(const Candidate& candidate) {
  double error = 0.0;
  for (const GoalResult& goal : candidate.goals) error = std::max(error, goal.error);
  return kMillimetres * error;
}

double worst_slide(const Candidate& candidate) {
  double slide = 0.0;
  for (const ContactResult& foot : candidate.contacts) slide = std::max(slide, foot.max_slide);
  for (const RestResult& hand : candidate.resting) slide = std::max(slide, hand.max_slide);
  return kMillimetres * slide;
}

double most_lift(const Candidate& candidate) {
  double lift = 0.0;
  for (const ContactResult& foot : candidate.contacts) {
    if (foot.heel) lift = std::max(lift, foot.heel->height);
  }
  return kMillimetres * lift;
}

double arm_depth(const Candidate& candidate) {
  return kMillimetres * std::max(candidate.arm_collision->depth, 0.0);
}

// A row per candidate: verdict, score, final posture and effort.
TextTable candidate_rows(const BodyModel& body, const Candidates& candidates) {
  TextTable table;
  std::vector<std::string> ranks;
  for (std::size_t i = 0; i < candidates.size(); ++i) ranks.push_back(fmt::format("{}", i + 1));
  table.add("rank", Align::right, std::move(ranks));
  table.add("verdict", Align::left, of_each(candidates, [](const Candidate& candidate) {
              return std::string(word_of(candidate.judgement.verdict));
            }));
  table.add("score", Align::right, of_each(candidates, [](const Candidate& candidate) {
              return fmt::format("{:.4f}", candidate.score.total);
            }));
  table.add("ends as", Align::left, of_each(candidates, [](const Candidate& candidate) {
              return posture_words(candidate.final_posture);
            }));
  table.add_known("most loaded", Align::left, of_each(candidates, [&](const Candidate& candidate) {
                    return most_loaded_words(body, candidate.measures);
                  }));
  table.add_known("balance mm", Align::right, of_each(candidates, [](const Candidate& candidate) {
                    return balance_words(candidate.measures);
                  }));
  table.add_known("over its limit", Align::left,
                  of_each(candidates, [](const Candidate& candidate) {
                    return most_over_words(candidate.measures);
                  }));
  table.add_numbers("error mm", of_each(candidates, worst_error), 2);
  table.add_numbers("slide mm", of_each(candidates, worst_slide), 2);
  const Candidate& first = candidates.front();
  if (std::any_of(first.contacts.begin(), first.contacts.end(),
                  [](const ContactResult& foot) { return foot.heel.has_value(); })) {
    table.add_numbers("heels mm", of_each(candidates, most_lift), 1);
  }
  if (first.arm_collision) table.add_numbers("arm in body mm", of_each(candidates, arm_depth), 1);
  return table;
}

// Terms of scores with the same criteria: a row per criterion, a column per motion. The heads are
// those of the motions.
class PenaltyTable {
 public:
  explicit PenaltyTable(const std::vector<ScoreTerm>& terms) {
    for (const ScoreTerm& term : terms) rows_.push_back({printable(term.name), term.weight, {}});
  }

  void add(std::string head, const std::vector<ScoreTerm>& terms) {
    heads_.push_back(std::move(head));
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k].penalties.push_back(terms[k].penalty);
  }

  [[nodiscard]] std::vector<std::string> zeros() const {
    std::vector<std::string> names;
    for (const Row& row : rows_) {
      if (is_zero(row)) names.push_back(row.name);
    }
    return names;
  }

  [[nodiscard]] std::string text() const {
    std::vector<std::string> names;
    std::vector<std::string> weights;
    std::vector<std::vector<std::string>> columns(heads_.size());
    for (const Row& row : rows_) {
      if (is_zero(row)) continue;
      names.push_back(row.name);
      weights.push_back(fmt::format("{:.3g}", row.weight));
      for (std::size_t k = 0; k < columns.size(); ++k) {
        columns[k].push_back(fmt::format("{:.4f}", row.penalties[k]));
      }
    }
    if (names.empty()) return {};
    TextTable table;
    table.add("penalty, 0 to 1", Align::left, std::move(names));
    table.add("weight", Align::right, std::move(weights));
    for (std::size_t k = 0; k < columns.size(); ++k) {
      table.add(heads_[k], Align::right, std::move(columns[k]));
    }
    return "\n" + table.text();
  }

 private:
  struct Row {
    std::string name;
    double weight = 0.0;
    std::vector<double> penalties;
  };
  // Value as printed.
  [[nodiscard]] static bool is_zero(const Row& row) {
    constexpr double kPrinted = 5e-5;
    return std::all_of(row.penalties.begin(), row.penalties.end(),
                       [](double penalty) { return penalty < kPrinted; });
  }

  std::vector<std::string> heads_;
  std::vector<Row> rows_;
};

// Names of the columns that are 0 in all rows, in one sentence; empty if there are none.
std::string zero_line(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  if (names.empty()) return {};
  for (std::size_t k = 0; k + 1 < names.size(); ++k) names[k] += ",";
  names.insert(names.begin(), "0 for all:");
  return "\n" + hanging(names);
}

// Reason why a motion is not possible; empty if it is.
std::string verdict_lines(const Judgement& judgement, const std::string& of) {
  if (judgement.verdict == Verdict::possible) return {};
  constexpr std::size_t kShown = 3;
  std::string text = fmt::format(
      "{} {}: ", of, judgement.verdict == Verdict::impossible ? "is impossible" : "strains");
  for (std::size_t i = 0; i < std::min(kShown, judgement.reasons.size()); ++i) {
    text += (i > 0 ? "; " : "") + printable(reason_words(judgement.reasons[i]));
  }
  if (judgement.reasons.size() > kShown) {
    text += fmt::format("; and {} more", judgement.reasons.size() - kShown);
  }
  if (judgement.possible_in)
    text += fmt::format("; {} would do", enough_words(*judgement.possible_in));
  return hanging(text);
}

// Verdict on the start posture of a run without possible motions, if the start is the cause.
Judgement fault_of_start(const FinishedRun& run) {
  const Judgement start = run.generation.status == ReachStatus::unsteady
                              ? judge_start(run.task.body, run.task.start)
                              : Judgement{};
  return start.verdict == Verdict::impossible ? start : Judgement{};
}

// The candidates as text tables: verdicts, scores, final postures and efforts; then each
// criterion's penalty; then reasons for impossible ones, once if the start posture is the cause.
std::string candidate_table(const BodyModel& body, const Candidates& candidates,
                            const Judgement& start) {
  const TextTable rows = candidate_rows(body, candidates);
  PenaltyTable penalties(candidates.front().score.terms);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    penalties.add(fmt::format("{}", i + 1), candidates[i].score.terms);
  }
  std::string text =
      "\n" + rows.text() + penalties.text() + zero_line(penalties.zeros(), rows.zeros());
  std::string verdicts = verdict_lines(start, "the start itself");
  const bool each = verdicts.empty();
  for (std::size_t i = 0; each && i < candidates.size(); ++i) {
    verdicts += verdict_lines(candidates[i].judgement, fmt::format("candidate {}", i + 1));
  }
  return text + (verdicts.empty() ? "" : "\n") + verdicts + "\n";
}

// Summary of a run in a few lines: status, body and goals, then counts and time.
std::string headline(const FinishedRun& run) {
  const auto& [file, task, generation, info, costs] = run;
  std::string text = hanging(printable(
      fmt::format("{}: {}, {}", word_of(generation.status), task.body.name(), asked_words(task))));
  std::string found = fmt::format("{:.2f} s of motion", generation.duration);
  if (generation.log.evaluations > 0) {
    found += fmt::format("; {} motions", generation.log.evaluations);
    if (generation.log.generations > 0) {
      found += fmt::format(" in {} generations", generation.log.generations);
    }
    if (generation.log.runs > 1) found += fmt::format(" of {} runs", generation.log.runs);
    found += fmt::format(", {:.0f} ms", info.elapsed_ms);
  }
  if (generation.log.cells_searched > 0) {
    found += fmt::format("; {} cells of the limb library searched", generation.log.cells_searched);
  }
  if (generation.end == SearchEnd::cancelled) found += "; stopped early";
  return text + hanging(found);
}

// Remark on a goal that no possible motion meets; the rate was measured for the preset flat.
std::string_view unsteady_words(const FinishedRun& run) {
  if (run.generation.log.evaluations == 0) return "not by a motion that this body could make";
  if (run.task.preset != Preset::flat) return "no motion was found that this body could make";
  return "no motion was found that this body could make (another --seed finds one for one such "
         "task "
         "in twenty)";
}

// Remark on hands that were allowed to rest and do not in any candidate.
void note_supports(const FinishedRun& run) {
  for (const Support& support : run.task.supports) {
    const auto rests = [&support](const Candidate& candidate) {
      return std::any_of(
          candidate.resting.begin(), candidate.resting.end(),
          [&support](const RestResult& r) { return r.effector == support.effector; });
    };
    const auto& all = run.generation.candidates;
    if (std::any_of(all.begin(), all.end(), rests)) continue;
    note(support.effector,
         fmt::format("it rests on the {} in none of these motions; --fix {}.support=0.1 makes it "
                     "bear a tenth of the weight",
                     support.on, support.effector));
  }
}

// Reports on stderr where the result differs from the request.
void note_run(const FinishedRun& run, const Judgement& start) {
  const auto& [file, task, generation, info, costs] = run;
  for (const Message& doubt : task.doubts) note(task.body.name(), doubt.text);
  if (generation.log.replay_differs > 0) {
    note("search", fmt::format("{} of {} candidates scored up to {:.4f} otherwise in the search's "
                               "single precision than in double, whose scores are given",
                               generation.log.replay_differs, generation.candidates.size(),
                               generation.log.replay_difference));
  }
  if (generation.meets_goals() && !generation.fewer.empty())
    note("candidates", generation.fewer.text);
  note_supports(run);
  if (generation.slowed) {
    note("duration", fmt::format("{:.2f} s, as what was found strains or is impossible in less",
                                 generation.duration));
  }
  if (generation.gentled) {
    note("duration", fmt::format("{:.2f} s, as the first candidate would jolt or strain in less",
                                 generation.duration));
  }
  if (start.verdict == Verdict::impossible) {
    print_err("shigusa: unsteady: whatever the goal, this body could not hold the start\n");
  } else if (generation.status == ReachStatus::unsteady) {
    print_err("shigusa: unsteady: the goal{} met, but {}\n",
              task.goals.size() > 1 ? "s are" : " is", unsteady_words(run));
  }
  if (!generation.meets_goals()) {
    const std::string turn =
        generation.remaining_turn > 0.0
            ? fmt::format(", turned {:.1f}° from what is asked", degrees(generation.remaining_turn))
            : "";
    print_err("shigusa: out of reach: the closest motion ends {:.1f} mm from the goal{}{}\n",
              1e3 * generation.remaining_distance, task.goals.size() > 1 ? "s" : "", turn);
    if (!generation.conflict.empty()) note("goals", generation.conflict.text);
  }
}

// Ending of the candidates' pictures, the most widely readable one; empty if none are written.
std::string_view picture_ending(const std::vector<FileFormat>& formats) {
  for (const FileFormat picture : {FileFormat::png, FileFormat::svg, FileFormat::pdf}) {
    if (std::find(formats.begin(), formats.end(), picture) != formats.end()) {
      return info_of(picture).endings.front();
    }
  }
  return {};
}

}  // namespace

std::string score_table(const BodyModel& body, const ClipScore& scored) {
  TextTable row;
  row.add("score", Align::right, {fmt::format("{:.4f}", scored.score.total)});
  row.add("ends as", Align::left, {posture_words(scored.final_posture)});
  row.add("most loaded", Align::left, {most_loaded_words(body, scored.measures)});
  row.add_known("balance mm", Align::right, {balance_words(scored.measures)});
  row.add_known("over its limit", Align::left, {most_over_words(scored.measures)});
  PenaltyTable penalties(scored.score.terms);
  penalties.add("", scored.score.terms);
  return "\n" + row.text() + penalties.text() + zero_line(penalties.zeros(), row.zeros()) + "\n";
}

std::string cost_lines(const MotionCost& cost) {
  std::string text;
  const auto add = [&text](const std::string& line) { text += hanging(line); };
  const auto posture = [&](const char* name, const std::optional<PostureCourse>& course,
                           std::size_t from, const char* level) {
    if (!course) return;
    add(fmt::format(
        "{} {} at most, at {:.2f} s ({} arm), {:.1f} on average; {:.0f} % of the time "
        "{} or more",
        name, course->score.worst, course->time, course->side == Side::left ? "left" : "right",
        course->score.mean, 100.0 * course->above[from], level));
  };
  posture("REBA", cost.reba, 3, "high (8)");
  posture("RULA", cost.rula, 2, "to be changed soon (5)");
  if (cost.back) {
    std::string line = fmt::format("L5/S1 {:.0f} N m at {:.2f} s", cost.back->moment.value,
                                   cost.back->moment.time);
    if (const auto& forces = cost.back->forces) {
      line += fmt::format(
          ", compression {:.0f} N at {:.2f} s (limits {:.0f} and {:.0f}), shear "
          "{:.0f} N",
          forces->compression.value, forces->compression.time, kBackActionLimit, kBackPermissible,
          forces->shear.value);
      if (forces->limit) line += fmt::format("; limit by age {:.0f} N", *forces->limit);
    }
    add(line);
  }
  const auto weakest = std::min_element(
      cost.strengths.begin(), cost.strengths.end(),
      [](const StrengthCost& a, const StrengthCost& b) { return a.able < b.able; });
  if (weakest != cost.strengths.end()) {
    add(fmt::format("{:.0f} % of people are strong enough: {} needs {:.0f} N m at {:.2f} s",
                    100.0 * weakest->able, printable(weakest->dof), weakest->torque,
                    weakest->time));
  }
  for (const LiftCost& lift : cost.lifts) {
    const std::string ends = fmt::format(
        "{}, {:g} kg: RWL {:.1f} kg where it is taken, {:.1f} kg "
        "where it is put",
        printable(lift.span.thing), lift.span.mass, lift.at_origin.limit,
        lift.at_destination.limit);
    add(ends + (lift.index ? fmt::format("; LI {:.2f}", *lift.index) : "; no load is allowed"));
    for (const Message& note : lift.notes) add("  " + printable(note.text));
  }
  if (cost.repeated && cost.repeated->index) {
    add(fmt::format("composite lifting index {:.2f}", *cost.repeated->index));
  }
  for (const Message& note : cost.notes) add(printable(note.text));
  return text;
}

Result<int> deliver(FinishedRun run, const Delivery& delivery) {
  const auto& [folder, settings, json] = delivery;
  SHG_TRY_ASSIGN(const std::vector<MotionCost> costs, candidate_costs(run));
  run.costs = costs;
  SHG_TRY_ASSIGN(const WrittenResult written, write_result(folder, run, settings));
  for (const Message& each : written.notes) note("files", each.text);
  const Judgement start = fault_of_start(run);
  note_run(run, start);
  const GenerateResult& generation = run.generation;
  if (json) {
    print_out("{}", written.summary);
  } else {
    print_out("{}{}", headline(run), candidate_table(run.task.body, generation.candidates, start));
    for (std::size_t i = 0; run.task.cost && i < costs.size(); ++i) {
      print_out("candidate {}\n{}\n", i + 1, cost_lines(costs[i]));
    }
    const std::string_view ending = picture_ending(settings.formats);
    for (std::size_t i = 0; !ending.empty() && i < generation.candidates.size(); ++i) {
      print_out("{}\n", (folder / fmt::format("candidate-{}{}", i + 1, ending)).string());
    }
    print_out("{}\n", (folder / kSummaryName).string());
  }
  return generation.status == ReachStatus::reached ? kDone : kUnreachable;
}

}  // namespace shigusa::app
