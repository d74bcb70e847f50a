// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <shigusa/error.hpp>
#include <shigusa/score.hpp>

#include "commands.hpp"
#include "table.hpp"
#include "text_table.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct ScoreOptions {
  std::string clip;
  std::optional<std::string> character;  // the clip's own person when not given
  CharacterOptions person;
  std::string frames;  // FIRST:LAST, or empty for all
  std::optional<std::string> criteria;
  std::optional<double> smooth;  // Hz
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
  CharacterSpec character;
  character.source = options.character.value_or(options.clip);
  if (character.source == options.clip) character.frame = settings.first;
  SHG_TRY_ASSIGN(const RecordedMotion recorded,
                 read_clip(options.clip, options.person, std::move(character), settings.first));
  const Result<ClipScore> score = score_clip(recorded, settings);
  if (!score) return fail(score.error().code, score.error().to_string(), options.clip);
  for (const Message& doubt : recorded.doubts) note(recorded.body.name(), doubt.text);
  for (const Message& doubt : score->doubts) note(options.clip, doubt.text);
  if (options.json) {
    print_out("{}", format_clip_score(options.clip, recorded, settings, *score));
  } else {
    print_score(recorded, settings, *score);
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
      "shigusa score lift.bvh --frames 100:300 --criteria default");
  const std::string scoring = "The score";
  describe(
      c->add_option("clip", o.clip)->required(),
      {.brief = "Motion file: " + format_endings([](const FormatInfo& info) { return info.clip; }),
       .form = "FILE"});
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
  describe(c->add_flag("--json", o.json),
           {.group = heading(OptionGroup::output), .brief = "Print JSON"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(score(*options)); });
}

}  // namespace shigusa::app
