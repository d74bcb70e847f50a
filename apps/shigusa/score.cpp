// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/score_clip.hpp>
#include <shigusa/words.hpp>

#include "commands.hpp"
#include "table.hpp"

namespace shigusa::app {
namespace {

void print_score(const RecordedMotion& recorded, const ScoreSettings& settings,
                 const ClipScore& score) {
  const Clip& clip = score.motion.clip;
  const ClipFit& fit = score.fit;
  print_out("{}: {:.3f} m, {:.1f} kg, {} dof; frames {} to {}, {:.2f} s",
            printable(recorded.body.name()), recorded.body.stature(), recorded.body.mass(),
            recorded.body.dof_count(), settings.first, settings.first + clip.frames - 1,
            clip.duration());
  print_out("{}\n", settings.cutoff > 0.0 ? fmt::format("; smoothed at {:g} Hz", settings.cutoff)
                                          : std::string());
  print_out(
      "the body's joints are {:.2f} cm from the recorded ones on average, {:.2f} cm at most "
      "({} in frame {})\n",
      100.0 * fit.mean_distance, 100.0 * fit.worst_distance, fit.worst_joint, fit.worst_frame);
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

}  // namespace

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
  CharacterOptions person = options.person;
  person.animation.reset();  // the clip's
  SHG_TRY(apply_character_options(person, character));
  SHG_TRY_ASSIGN(const RecordedMotion recorded,
                 read_recorded(options.clip, character, settings.first,
                               options.person.animation.value_or("")));
  const Result<ClipScore> score = score_clip(recorded, settings);
  if (!score) return fail(score.error().code, score.error().to_string(), options.clip);
  for (const Message& doubt : recorded.body.doubts()) note(recorded.body.name(), doubt.text);
  for (const Message& doubt : score->doubts) note(options.clip, doubt.text);
  if (options.json) {
    print_out("{}", format_clip_score(options.clip, recorded, settings, *score));
  } else {
    print_score(recorded, settings, *score);
  }
  return kDone;
}

}  // namespace shigusa::app
