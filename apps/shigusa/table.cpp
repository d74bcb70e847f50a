// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"

namespace shigusa::app {
namespace {

std::size_t column_width(const ScoreTerm& term) {
  return std::max<std::size_t>(11, term.name.size());
}

std::string most_over(const std::vector<LimitExcess>& over_limit) {
  if (over_limit.empty()) return "-";
  return fmt::format("{} by {:.0f}°", over_limit.front().dof, degrees(over_limit.front().excess));
}

std::string least_margin(const std::optional<SupportMargins>& support) {
  return support ? fmt::format("{:.0f}", 1e3 * support->centre_of_mass.distance) : "-";
}

std::string measures_head() {
  return fmt::format("{:>10}  {:<20}  {:<28}  {}", "balance mm", "ends as", "most loaded",
                     "most over its limit");
}

// The measures of a motion in the columns of measures_head().
std::string measures_row(const BodyModel& body, const MotionMeasures& measures,
                         const FinalPosture& ends) {
  const JointLoad* load = most_loaded(measures);
  const std::string loaded =
      load == nullptr ? "-"
                      : fmt::format("{:.0f} % {}", 100.0 * load->share, body.dof(load->dof).name);
  return fmt::format("{:>10}  {:<20}  {:<28}  {}", least_margin(measures.support),
                     posture_words(ends), loaded, most_over(measures.over_limit));
}

// Why a motion is not possible; empty where it is.
std::string verdict_line(const Judgement& judgement, const std::string& of) {
  if (judgement.verdict == Verdict::possible) return {};
  constexpr std::size_t kShown = 3;
  std::string text = fmt::format(
      "{} {}: ", of, judgement.verdict == Verdict::impossible ? "is impossible" : "strains");
  for (std::size_t i = 0; i < std::min(kShown, judgement.reasons.size()); ++i) {
    text += (i > 0 ? "; " : "") + reason_words(judgement.reasons[i]);
  }
  if (judgement.reasons.size() > kShown) {
    text += fmt::format("; and {} more", judgement.reasons.size() - kShown);
  }
  if (judgement.possible_in) text += fmt::format("; not in {:.1f} s", *judgement.possible_in);
  return text + "\n";
}

// The columns that only some results have.
struct Columns {
  bool arms = false;   // of layered presets
  bool heels = false;  // that may lift
};

std::string table_head(const Candidate& first, const Columns& columns) {
  std::string text = fmt::format("{:>4}  {:<10}  {:>7}", "rank", "verdict", "score");
  for (const ScoreTerm& term : first.score.terms) {
    text += fmt::format("  {:>{}}", term.name, column_width(term));
  }
  if (columns.arms) text += fmt::format("  {:>14}", "arm in body mm");
  text += fmt::format("  {:>9}  {:>9}  ", "error mm", "slide mm");
  if (columns.heels) text += fmt::format("{:>8}  ", "heels mm");
  return text + measures_head() + "\n";
}

std::string table_row(const BodyModel& body, std::size_t rank, const Candidate& candidate,
                      const Columns& columns) {
  std::string text = fmt::format("{:>4}  {:<10}  {:>7.4f}", rank,
                                 word_of(candidate.judgement.verdict), candidate.score.total);
  for (const ScoreTerm& term : candidate.score.terms) {
    text += fmt::format("  {:>{}.4f}", term.penalty, column_width(term));
  }
  if (candidate.arm_collision) {
    text += fmt::format("  {:>14.1f}", 1e3 * std::max(candidate.arm_collision->depth, 0.0));
  }
  double error = 0.0;
  double slide = 0.0;
  double lift = 0.0;
  for (const GoalResult& goal : candidate.goals) error = std::max(error, goal.error);
  for (const ContactResult& foot : candidate.contacts) {
    slide = std::max(slide, foot.max_slide);
    if (foot.heel) lift = std::max(lift, foot.heel->height);
  }
  for (const RestResult& hand : candidate.resting) slide = std::max(slide, hand.max_slide);
  text += fmt::format("  {:>9.3f}  {:>9.3f}  ", 1e3 * error, 1e3 * slide);
  if (columns.heels) text += fmt::format("{:>8.1f}  ", 1e3 * lift);
  return text + measures_row(body, candidate.measures, candidate.final_posture) + "\n";
}

// The candidates as a table for a person: verdicts, scores, criteria, errors, joints over their
// limits; below it why what is not possible is not.
std::string candidate_table(const BodyModel& body, const std::vector<Candidate>& candidates) {
  const Candidate& first = candidates.front();
  const Columns columns{
      first.arm_collision.has_value(),
      std::any_of(first.contacts.begin(), first.contacts.end(),
                  [](const ContactResult& foot) { return foot.heel.has_value(); })};
  std::string text = table_head(first, columns);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    text += table_row(body, i + 1, candidates[i], columns);
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    text += verdict_line(candidates[i].judgement, fmt::format("candidate {}", i + 1));
  }
  return text;
}

// A run in one line: status, body, goals, counts and time.
std::string headline(const FinishedRun& run) {
  const auto& [file, task, generation, info] = run;
  std::string text = fmt::format("{}: {}", word_of(generation.status), printable(task.body.name()));
  for (const Goal& goal : task.goals) {
    text += fmt::format(", {} at ({:g}, {:g}, {:g}) m", goal.effector, goal.position.x,
                        goal.position.y, goal.position.z);
  }
  text += fmt::format("; {:.2f} s of motion", generation.duration);
  if (generation.evaluations > 0) {
    text += fmt::format("; {} motions in {} generations{}, {:.0f} ms", generation.evaluations,
                        generation.generations,
                        generation.runs > 1 ? fmt::format(" of {} runs", generation.runs) : "",
                        info.elapsed_ms);
  }
  if (generation.cells_searched > 0) {
    text += fmt::format("; {} cells of the limb library searched", generation.cells_searched);
  }
  if (generation.end == SearchEnd::cancelled) text += "; stopped early";
  return text + "\n";
}

// Tells the user on stderr how the result differs from what is asked for.
void note_run(const FinishedRun& run) {
  const auto& [file, task, generation, info] = run;
  for (const Message& doubt : task.body.doubts()) note(task.body.name(), doubt.text);
  if (generation.replay_differs > 0) {
    note("search", fmt::format("{} of {} candidates scored up to {:.4f} otherwise in the search's "
                               "single precision than in double, whose scores are given",
                               generation.replay_differs, generation.candidates.size(),
                               generation.replay_difference));
  }
  if (generation.meets_goals() && !generation.fewer.empty())
    note("candidates", generation.fewer.text);
  if (generation.slowed) {
    note("duration", fmt::format("{:.2f} s, as nothing that was found is possible in less",
                                 generation.duration));
  }
  if (generation.gentled) {
    note("duration",
         fmt::format("{:.2f} s, as the first candidate would jolt in less", generation.duration));
  }
  if (generation.status == ReachStatus::unsteady) {
    print_err("shigusa: unsteady: the goal{} met, but by no motion that this body could make\n",
              task.goals.size() > 1 ? "s are" : " is");
  }
  if (!generation.meets_goals()) {
    const std::string turn =
        generation.remaining_turn > 0.0
            ? fmt::format(", turned {:.1f}° from what is asked", degrees(generation.remaining_turn))
            : "";
    print_err("shigusa: out of reach: the closest motion ends {:.1f} mm from the goal{}{}\n",
              1e3 * generation.remaining_distance, task.goals.size() > 1 ? "s" : "", turn);
  }
}

}  // namespace

std::string score_table(const BodyModel& body, const ClipScore& scored) {
  const Score& score = scored.score;
  std::string head = fmt::format("{:>7}", "score");
  std::string row = fmt::format("{:>7.4f}", score.total);
  for (const ScoreTerm& term : score.terms) {
    head += fmt::format("  {:>{}}", term.name, column_width(term));
    row += fmt::format("  {:>{}.4f}", term.penalty, column_width(term));
  }
  return head + fmt::format("  {}\n", measures_head()) + row +
         fmt::format("  {}\n", measures_row(body, scored.measures, scored.final_posture));
}

Result<int> deliver(const FinishedRun& run, const Delivery& delivery) {
  const auto& [folder, settings, json] = delivery;
  SHG_TRY_ASSIGN(const std::string summary, write_result(folder, run, settings));
  note_run(run);
  const GenerateResult& generation = run.generation;
  if (json) {
    print_out("{}", summary);
  } else {
    print_out("{}{}", headline(run), candidate_table(run.task.body, generation.candidates));
    const auto& formats = settings.formats;
    const bool pictures =
        std::find(formats.begin(), formats.end(), FileFormat::png) != formats.end();
    for (std::size_t i = 0; pictures && i < generation.candidates.size(); ++i) {
      print_out("{}\n", (folder / fmt::format("candidate-{}.png", i + 1)).string());
    }
    print_out("{}\n", (folder / kSummaryName).string());
  }
  return generation.status == ReachStatus::reached ? kDone : kUnreachable;
}

}  // namespace shigusa::app
