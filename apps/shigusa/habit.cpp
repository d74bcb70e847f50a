// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <shigusa/files.hpp>
#include <shigusa/score.hpp>

#include "commands.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct HabitOptions {
  std::string clip;
  CharacterOptions person;
  std::vector<std::string> frames;  // FIRST:LAST, or none for all
};

Result<int> habit(const HabitOptions& options) {
  std::vector<FrameRange> ranges;
  for (const std::string& text : options.frames) {
    SHG_TRY_ASSIGN(ranges.emplace_back(), parse_frames(text));
  }
  const int first = ranges.empty() ? 0 : ranges.front().first;
  CharacterSpec character{.source = options.clip};
  character.frame = first;
  SHG_TRY_ASSIGN(const RecordedMotion recorded,
                 read_clip(options.clip, options.person, std::move(character), first));
  const Result<LearnedHabit> learned = learn_habit(recorded, ranges);
  if (!learned) return fail(learned.error().code, learned.error().message, options.clip);
  for (const Message& doubt : recorded.doubts) note(recorded.body.name(), doubt.text);
  print_out("{}", format_habit(learned->habit));
  print_err("shigusa: measured in {} down\n",
            number_of(static_cast<std::uint64_t>(learned->reaches), "reach"));
  return kDone;
}

}  // namespace

void add_habit(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<HabitOptions>();
  HabitOptions& o = *options;
  CLI::App* c = app.add_subcommand("habit", "Learn a person's way of moving from a recorded clip");
  c->group(kLook)->footer(
      "shigusa habit lift.bvh > habit.json\n"
      "shigusa reach --goal right_hand=-0.2,0.2,0.4 --habit habit.json");
  describe(
      c->add_option("clip", o.clip)->required(),
      {.brief = "Motion file: " + format_endings([](const FormatInfo& info) { return info.clip; }),
       .form = "FILE"});
  add_character_options(*c, o.person);
  describe(c->add_option("--frames", o.frames)->allow_extra_args(false),
           {.group = "The habit",
            .brief = kFramesHelp,
            .full = std::string(kFramesHelp) +
                    ", each from standing to a reach down; all when not given. Repeatable.",
            .form = "FIRST:LAST"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(habit(*options)); });
}

}  // namespace shigusa::app
