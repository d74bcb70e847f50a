// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/score.hpp>

#include "commands.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "table.hpp"
#include "text_table.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct ScoreOptions {
  std::string clip;
  std::optional<std::string> task;
  std::optional<std::string> character;  // the clip's own person when not given
  CharacterOptions person;
  std::string frames;  // FIRST:LAST, or empty for all
  std::optional<std::string> criteria;
  std::optional<double> smooth;  // Hz
  bool cost = false;
  std::string ergonomics;  // NAME=VALUE,…, or empty
  bool json = false;
};

void print_score(const RecordedMotion& recorded, const ScoreSettings& settings,
                 const ClipScore& score) {
  const Clip& clip = score.motion.clip;
  const ClipFit& fit = score.fit;
  const std::string smoothed =
      settings.cutoff > 0.0 ? fmt::format("; smoothed at {:g} Hz", settings.cutoff) : "";
  print_out("{}",
            hanging(fmt::format("{}: {:.3f} m, {:.1f} kg, {} dof; frames {} to {}, {:.2f} s{}",
                                printable(recorded.body.name()), recorded.body.stature(),
                                recorded.body.mass(), recorded.body.dof_count(), settings.first,
                                settings.first + clip.frames - 1, clip.duration(), smoothed)));
  print_out("{}", hanging(fmt::format("the body's joints are {:.2f} cm from the recorded ones on "
                                      "average, {:.2f} cm at most ({} in frame {})",
                                      100.0 * fit.mean_distance, 100.0 * fit.worst_distance,
                                      fit.worst_joint, fit.worst_frame)));
  for (const FootTravel& foot : fit.feet) {
    print_out("{} moves by up to {:.2f} cm and {:.1f}°{}\n", foot.foot, 100.0 * foot.travel,
              degrees(foot.turn), foot.base ? "; the body stands on it" : "");
  }
  print_out("{}", score_table(recorded.body, score));
  if (score.measures.collides.depth > kCollisionDepth) {
    print_out("{} is {:.1f} cm in {} at {:.2f} s\n", score.measures.collides.limb,
              100.0 * score.measures.collides.depth, score.measures.collides.other,
              score.measures.collides.time);
  }
}

std::string action_words(const ActionScore& action) {
  const ActionResult& own = action.result;
  std::string words =
      fmt::format("{:.2f} to {:.2f} s  {}: {}, score {:.4f}", own.start, own.end, word_of(own.kind),
                  word_of(own.judgement.verdict), own.score.total);
  for (const HandAtThing& hand : action.hands) {
    words += fmt::format("; {} {:.0f} mm from the thing", hand.effector, 1e3 * hand.distance);
  }
  if (action.taken) words += fmt::format("; taken at {:.2f} s", *action.taken);
  for (const GoalResult& goal : own.goals) {
    words += fmt::format("; {} {:.0f} mm from its goal", goal.asked.effector, 1e3 * goal.error);
  }
  if (own.placed) {
    words += fmt::format("; {} {:.0f} mm and {:.0f}° from its place", printable(own.placed->name),
                         1e3 * own.placed->error, degrees(own.placed->turn_error));
  }
  for (const Reason& reason : own.judgement.reasons) words += "; " + reason_words(reason);
  return words;
}

// The ergonomics of a task or of none, after the options.
Result<Ergonomics> ergonomics_after(const ScoreOptions& options, const Ergonomics& ergonomics) {
  if (options.ergonomics.empty()) return ergonomics;
  return placed("--ergonomics", with_assignments(ergonomics, options.ergonomics));
}

// Scores the clip as the actions of a task.
Result<int> score_actions(const ScoreOptions& options, const ScoreSettings& settings) {
  const std::filesystem::path path = to_path(*options.task);
  SHG_TRY_ASSIGN(TaskFile file, read_task(path));
  SHG_TRY_ASSIGN(const Task task, make_task(file, path.parent_path()));
  CharacterSpec character;
  if (options.character) {
    character.source = *options.character;
  } else {
    character = file.character;
  }
  if (character.source == options.clip) character.frame = settings.first;
  SHG_TRY_ASSIGN(const RecordedMotion recorded,
                 read_clip(options.clip, options.person, std::move(character), settings.first));
  ScoreSettings asked = settings;
  if (options.cost || task.cost) {
    SHG_TRY_ASSIGN(asked.ergonomics,
                   ergonomics_after(options, ergonomics_of(task, file.character.sex)));
  }
  const Result<WorkScore> score = score_work(recorded, task, asked);
  if (!score) return fail(score.error().code, score.error().to_string(), options.clip);
  for (const Message& doubt : recorded.doubts) note(recorded.body.name(), doubt.text);
  for (const Message& doubt : score->doubts) note(options.clip, doubt.text);
  if (options.json) {
    print_out("{}", format_work_score(options.clip, recorded, asked, *score));
    return kDone;
  }
  for (const ActionScore& action : score->actions) {
    print_out("{}", hanging(action_words(action)));
  }
  print_out("{}, score {:.4f}\n", word_of(score->judgement.verdict), score->score.total);
  if (score->cost) print_out("\n{}", cost_lines(*score->cost));
  return kDone;
}

Result<int> score(const ScoreOptions& options) {
  ScoreSettings settings;
  if (options.criteria) {
    const Result<CriteriaSettings> mixture = mixture_named(*options.criteria);
    if (!mixture) return fail(mixture.error().code, mixture.error().message, "--criteria");
    settings.criteria = *mixture;
  }
  if (options.smooth) settings.cutoff = *options.smooth;
  SHG_TRY_ASSIGN(const FrameRange frames, parse_frames(options.frames));
  settings.first = frames.first;
  settings.last = frames.last;
  if (options.task) return score_actions(options, settings);
  CharacterSpec character;
  character.source = options.character.value_or(options.clip);
  if (character.source == options.clip) character.frame = settings.first;
  SHG_TRY_ASSIGN(const RecordedMotion recorded,
                 read_clip(options.clip, options.person, std::move(character), settings.first));
  if (options.cost) {
    SHG_TRY_ASSIGN(settings.ergonomics, ergonomics_after(options, {}));
  }
  const Result<ClipScore> score = score_clip(recorded, settings);
  if (!score) return fail(score.error().code, score.error().to_string(), options.clip);
  for (const Message& doubt : recorded.doubts) note(recorded.body.name(), doubt.text);
  for (const Message& doubt : score->doubts) note(options.clip, doubt.text);
  if (options.json) {
    print_out("{}", format_clip_score(options.clip, recorded, settings, *score));
  } else {
    print_score(recorded, settings, *score);
    if (score->cost) print_out("{}\n", cost_lines(*score->cost));
  }
  return kDone;
}

}  // namespace

void add_score(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ScoreOptions>();
  ScoreOptions& o = *options;
  CLI::App* c = app.add_subcommand("score", "Score a motion, recorded or made, by the criteria");
  c->group(kLook)->footer(
      "shigusa score out/candidate-1.bvh\n"
      "shigusa score out/candidate-1.glb work.json\n"
      "shigusa score lift.bvh --frames 100:300 --criteria default");
  const std::string scoring = "The score";
  describe(
      c->add_option("clip", o.clip)->required(),
      {.brief = "Motion file: " + format_endings([](const FormatInfo& info) { return info.clip; }),
       .form = "FILE"});
  describe(c->add_option("task", o.task),
           {.brief = "Task of actions that the motion does, of which each is scored",
            .full = "A task of actions: each of them is scored in its time, with what it reached. "
                    "Times come from a GLB or VRMA file of this program, or else from the motion: "
                    "hands are slow at a thing or its place. Things follow the hands that take "
                    "them. The character is the task's.",
            .form = "TASK.json"});
  describe(c->add_option("--character", o.character),
           {.group = heading(OptionGroup::body),
            .brief = "Who moves so (default: the clip's own person)",
            .full = fmt::format("Whose body moves so: {} or a person's file; when not given, the "
                                "clip's own person, extent human, as the first frame shows them.",
                                fmt::join(kBuiltInCharacters, ", ")),
            .form = character_form()});
  add_character_options(*c, o.person);
  describe(c->add_option("--frames", o.frames),
           {.group = scoring,
            .brief = kFramesHelp,
            .full = std::string(kFramesHelp) + ", in which the feet stand.",
            .form = "FIRST:LAST"});
  describe(c->add_option("--criteria", o.criteria),
           {.group = scoring,
            .brief = "Mixture that the motion is scored by (default: the one named default)",
            .form = mixture_choices()});
  describe(c->add_option("--smooth", o.smooth),
           {.group = scoring,
            .brief = "Smooths the record below this (default 6; 0: not at all)",
            .full = "What is faster than this, in Hz, is taken for noise of the record: 6 when not "
                    "given; with 0 nothing is.",
            .form = "HZ"});
  describe(c->add_flag("--cost", o.cost),
           {.group = scoring,
            .brief = "Tell the cost to the body: REBA, RULA, NIOSH, L5/S1, strengths",
            .full = "What the motion costs the body by REBA, RULA, EN 1005-4 and, with a task, the "
                    "revised NIOSH lifting equation, the loads at L5/S1, and joint torques beside "
                    "people's strengths; with the ergonomics of the task."});
  describe(c->add_option("--ergonomics", o.ergonomics),
           {.group = scoring,
            .brief = "For --cost: coupling=poor,lifts_per_min=4,lifting_time=long",
            .full = "What the motion does not tell, for --cost: the keys of \"ergonomics\" in a "
                    "task, with commas between. Example: `--ergonomics "
                    "coupling=poor,lifts_per_min=4`.",
            .form = "NAME=VALUE,…",
            .rare = true});
  describe(c->add_flag("--json", o.json),
           {.group = heading(OptionGroup::output), .brief = "Print JSON"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(score(*options)); });
}

}  // namespace shigusa::app
