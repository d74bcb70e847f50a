// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <exception>
#include <shigusa/dataset.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parallel.hpp>
#include <shigusa/task.hpp>
#include <sstream>

#include "commands.hpp"
#include "dataset_commands.hpp"
#include "usage.hpp"

namespace {

using namespace shigusa::app;
using shigusa::FormatInfo;

bool needs_file(const FormatInfo& info) { return info.needs != shigusa::NeededFile::none; }

std::string character_help() {
  std::string text;
  for (const std::string_view name : shigusa::kBuiltInCharacters) text += std::string(name) + ", ";
  return text + "a person's file (" +
         shigusa::format_endings([](const FormatInfo& info) { return info.person; }) +
         "), or a robot's (" +
         shigusa::format_endings([](const FormatInfo& info) { return info.robot; }) + ")";
}

void add_character_options(CLI::App& c, CharacterOptions& o) {
  c.add_option("--extent", o.extent,
               "Of a person from a file: human (spine, neck, wrists, …), full (18 dof) or half (9)")
      ->check(CLI::IsMember(shigusa::all_words<shigusa::BodyExtent>()));
  c.add_option(
       "--frame", o.frame,
       "Frame of the file that is the start posture, exactly (from 0; of glTF of an animation, "
       "at 60 a second), or rest: the file's rest pose, at ease")
      ->transform(frame_or_rest());
  c.add_option("--animation", o.animation,
               "Name or index of a glTF file's animation (default: its first)");
  c.add_option(
      "--stature", o.stature,
      "Standing height in metres, or p5, p50, p95: that of 5, 50 or 95 of 100 people of the "
      "sex at most");
  c.add_option("--mass", o.mass, "Mass in kilograms");
  c.add_option("--sex", o.sex, "male or female: mass distribution and strength")
      ->check(CLI::IsMember(shigusa::all_words<shigusa::Sex>()));
  c.add_option("--seat", o.seat,
               "Sits on a seat of this height in metres, with the feet where they stand");
  c.add_flag(
      "--heels", o.heels,
      "Heels may lift where people's do: on tiptoe for what is high, in a deep squat (human, "
      "standing)");
  c.add_option("--map", o.map,
               "BONE=NODE: which node of the file a bone is (right_hand=Bone_17, or #17 by its "
               "place), or a "
               "file of them: JSON, or what `shigusa body` printed; repeatable")
      ->allow_extra_args(false);
}

// The words of an enum as --help shows them, "paper|flat"; of other values the form of their text.
template <class Value>
std::string words_or(const char* form) {
  if constexpr (std::is_enum_v<Value>) {
    return fmt::format("{}", fmt::join(shigusa::all_words<Value>(), "|"));
  } else {
    return form == nullptr ? "" : form;
  }
}
// `usual`, `rate`: what is written, and at how many frames a second, where nothing is said.
void add_file_options(CLI::App* c, FileOptions& o, const std::string& usual,
                      const std::string& rate) {
  c->add_option("--formats", o.formats,
                "Of " + shigusa::format_words([](const FormatInfo& info) { return info.written; }) +
                    " (default: " + usual + ")");
  c->add_option("--fps", o.fps,
                "Frames a second of " +
                    shigusa::format_words([](const FormatInfo& info) { return info.rated; }) +
                    ", 1 to 240, such as 24 or 29.97 (default: " + rate +
                    "); the others have the motion's own frames")
      ->check(CLI::Range(shigusa::kRateMin, shigusa::kRateMax));
  c->add_flag("--one-file", o.one_file,
              "All candidates in one candidates.glb in place of a GLB for each");
  c->add_option("--clip", o.clip,
                "What the animation is called in GLB and VRMA; in one file with the rank after it");
  c->add_option("--joint-names", o.joint_names,
                "Whose names the joints of a built-in body have in BVH (default: own)")
      ->type_name(words_or<shigusa::JointNames>(nullptr));
  c->add_flag(
      "--in-place", o.in_place,
      "Leaves out what the hips travel along the floor in BVH, GLB and VRMA: for games that "
      "move the character themselves");
}

template <class Holder, class Value>
std::string form_of(const shigusa::Field<Holder, Value>& field) {
  return words_or<Value>(field.traits.form);
}
template <class Holder, class Value>
std::string form_of(const shigusa::Field<Holder, std::optional<Value>>& field) {
  return words_or<Value>(field.traits.form);
}

// Adds the option of each field, with the field's sentence and its bounds of whole numbers.
template <class Holder>
void add_field_options(CLI::App& c, FieldOptions<Holder>& o) {
  for_each_option<Holder>(o, [&c](const auto& field, auto& typed) {
    using Typed = std::remove_cvref_t<decltype(typed)>;
    const auto& traits = field.traits;
    const std::string form = form_of(field);
    if constexpr (std::same_as<Typed, bool>) {
      c.add_flag(traits.option, typed, field.says);
    } else if constexpr (std::same_as<Typed, std::vector<std::string>>) {
      c.add_option(traits.option, typed, std::string(field.says) + " Repeatable.")
          ->allow_extra_args(false)
          ->type_name(form);
    } else {
      CLI::Option* option = c.add_option(traits.option, typed, field.says);
      if (!form.empty()) option->type_name(form);
      if constexpr (std::integral<decltype(traits.low)>) {
        if (traits.high > 0) option->check(whole_number(traits.low, traits.high));
      }
    }
  });
}

void add_task_options(CLI::App& c, TaskOptions& o) {
  add_field_options<shigusa::Request>(c, o.request);
  add_field_options<shigusa::Goal>(c, o.goal);
  const auto add = [&](const char* name, std::vector<std::string>& into, const char* help) {
    c.add_option(name, into, std::string(help) + " Repeatable.")
        ->allow_extra_args(false)
        ->type_name("HAND=DIRECTION");
  };
  add("--palm", o.palms,
      "The direction that the palm faces at the end: up, down, left, right, ahead, back, or X,Y,Z; "
      "the hand may turn about it.");
  add("--thumb", o.thumbs,
      "The same of the thumb's side, along what the hand grips; with --palm or --fingers the whole "
      "rotation.");
  add("--fingers", o.fingers, "The same of the way that the fingers point.");
}

void add_reach(CLI::App& app, ReachOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand(
      "reach", "Find natural motions that bring hands, feet or other joints to their goals");
  c->add_option("task", o.task, "Task file (JSON); options below take precedence over it");
  c->add_option("--character", o.character, character_help());
  add_character_options(*c, o.person);
  add_task_options(*c, o.asked);
  c->add_option("--seconds", o.seconds, "Time limit of the search; what is found depends on speed")
      ->check(CLI::Range(1e-3, 1e6));
  c->add_option("--threads", o.threads, "Threads of the search (default 0: one for each core)")
      ->check(whole_number(0, shigusa::kMaxThreads));
  c->add_option("--simd", o.simd,
                "Instructions of the search (default: the widest of the machine)");
  c->add_option("--out", o.out, "Folder for the result")->capture_default_str();
  add_file_options(c, o.files,
                   shigusa::format_words([](const FormatInfo& info) {
                     return info.usual && !needs_file(info);
                   }) + "; for characters whose file can hold them also " +
                       shigusa::format_words(
                           [](const FormatInfo& info) { return info.usual && needs_file(info); }),
                   "60");
  c->add_flag("--json", o.json, "Print summary.json instead of the table");
  c->callback([&] { exit_code = exit_code_of(reach(o)); });
}

// The options that edit and mirror have in common.
void add_result_options(CLI::App* c, EditOptions& o, int& exit_code) {
  c->add_option("result", o.result, "Folder of a result, or its summary.json")->required();
  c->add_option(
      "--character", o.character,
      "The person's file, which " + shigusa::format_words(needs_file, "or") +
          " and a BVH of the file's own nodes need (default: where the result says it is)");
  c->add_option("--candidate", o.candidate, "Rank of the candidate")->capture_default_str();
  c->add_option(
      "--out", o.out,
      "Folder for the new result (default: a new one beside the old, named as the command)");
  add_file_options(c, o.files, "those of the result", "the result's");
  c->add_flag("--json", o.json, "Print summary.json instead of the table");
  c->callback([&] { exit_code = exit_code_of(edit(o)); });
}

void add_edit(CLI::App& app, EditOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand("edit", "Change a candidate's parameters; no search");
  add_result_options(c, o, exit_code);
  c->add_option(
       "--set", o.assignments,
       "NAME.weight=NUMBER or NAME.locked=true|false, NAME a joint or a freedom such as "
       "right_shoulder.flexion; or of the posture squat_deg=NUMBER and so on; later.NAME for "
       "the second phase of a motion, which begins about switch=NUMBER (0.2..0.8); of the preset "
       "layers also legs.contraction=NUMBER (0..15), and right_arm.NAME for the arm's own; "
       "of human right_arm.swivel_deg=NUMBER and left_elbow.final_deg=NUMBER; repeatable")
      ->allow_extra_args(false);
}

void add_mirror(CLI::App& app, EditOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand(
      "mirror", "A candidate for the other hand: left for right, by the same person");
  o.mirror = true;
  add_result_options(c, o, exit_code);
}

void add_render(CLI::App& app, RenderOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand("render", "Draw a motion as a strip of poses");
  c->add_option("clip", o.clip, "BVH file, recorded or made")->required();
  c->add_option("--out", o.out, "Picture: .svg, .png or .pdf (default: the clip's name with .svg)");
  c->add_option("--poses", o.poses, "Poses to draw")->capture_default_str();
  c->add_option("--frames", o.frames, "FIRST:LAST part of the clip (from 0)");
  c->add_option("--stature", o.stature,
                "Standing height in metres, where the file's unit misleads");
  c->callback([&] { exit_code = exit_code_of(render(o)); });
}

void add_score(CLI::App& app, ScoreOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand("score", "Score a motion, recorded or made, by the criteria");
  c->add_option(
       "clip", o.clip,
       "Motion file: " + shigusa::format_endings([](const FormatInfo& info) { return info.clip; }))
      ->required();
  c->add_option("--character", o.character,
                "Whose body moves so: half_body, full_body, human or a person's file (default: the "
                "clip's own person, extent human, as the first frame shows them)");
  add_character_options(*c, o.person);
  c->add_option("--frames", o.frames, "FIRST:LAST part of the clip, in which the feet stand");
  c->add_option("--criteria", o.criteria, "paper, default or pareto");
  c->add_option("--smooth", o.smooth,
                "Hz: what is faster is taken for noise of the record (default 6; 0: nothing is)");
  c->add_flag("--json", o.json, "Print JSON");
  c->callback([&] { exit_code = exit_code_of(score(o)); });
}

void add_schema(CLI::App& app, bool& of_plans) {
  CLI::App* c = app.add_subcommand("schema", "Print the JSON schema of task files");
  c->add_flag("--plan", of_plans, "That of plans for data sets");
  c->callback(
      [&of_plans] { write_out(of_plans ? shigusa::plan_schema() : shigusa::task_schema()); });
}

void add_dataset(CLI::App& app, DatasetOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand(
      "dataset", "Make a data set of motions: many tasks, drawn as a plan says (docs/data.md)");
  // with a command of its own, such as merge, there is no plan
  c->add_option("plan", o.plan, "Plan (JSON): a task in which values may be draws");
  c->add_option("--out", o.folder, "Folder for the data set; shards that are there stay");
  c->add_option("--shards", o.shards,
                "FIRST:LAST of the shards to make, the last one not among them (default: all)");
  c->add_option("--part", o.part,
                "K/N: the shards of part K (from 0) of N equal ones, for N programs at once")
      ->excludes("--shards");
  c->add_flag("--check-plan", o.check_plan,
              "Checks the plan, prints how many tasks and shards it has, and makes nothing");
  c->add_option("--task", o.task, "Makes this one task alone, as reach does, into --out");
  c->add_option("--threads", o.threads,
                "Tasks that are made at once (default 0: one for each core)")
      ->check(whole_number(0, shigusa::kMaxThreads));
  c->add_option("--simd", o.simd, "Instructions of the searches (default: the machine's widest)");
  add_file_options(c, o.files, "those of reach, of --task", "60");
  c->add_flag("--json", o.json, "Of --task: print summary.json instead of the table");
  add_dataset_merge(*c, exit_code);
  add_dataset_check(*c, exit_code);
  add_dataset_show(*c, exit_code);
  add_dataset_export(*c, exit_code);
  c->callback([&, c] {
    if (c->get_subcommands().empty()) exit_code = exit_code_of(dataset(o));
  });
}

void add_studio(CLI::App& app, StudioOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand(
      "studio", "Serve the studio, a page for the browser, to this machine alone, and open it");
  c->add_option("--port", o.port, "Port (default 0: any that is free)")
      ->check(whole_number(0, 65535));
  c->add_flag("!--no-open", o.open, "Do not open a browser; the address is printed");
  c->add_option("--folder", o.folder, "Folder of the built page (default: the installed one)");
  c->callback([&] { exit_code = exit_code_of(studio(o)); });
}

void add_body(CLI::App& app, BodyOptions& o, int& exit_code) {
  CLI::App* c = app.add_subcommand("body", "Show what was understood of a body");
  c->add_option("source", o.source, character_help())->required();
  add_character_options(*c, o.person);
  c->add_flag("--json", o.json, "Print JSON");
  c->callback([&] { exit_code = exit_code_of(body(o)); });
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  catch_interrupts();
  CLI::App app("shigusa: natural whole-body motions from the final state of the hands", "shigusa");
  app.set_version_flag("--version", SHIGUSA_VERSION);
  app.require_subcommand(1);
  int exit_code = kDone;
  ReachOptions reach_options;
  EditOptions edit_options;
  EditOptions mirror_options;
  RenderOptions render_options;
  ScoreOptions score_options;
  BodyOptions body_options;
  StudioOptions studio_options;
  DatasetOptions dataset_options;
  add_reach(app, reach_options, exit_code);
  add_edit(app, edit_options, exit_code);
  add_mirror(app, mirror_options, exit_code);
  add_render(app, render_options, exit_code);
  add_score(app, score_options, exit_code);
  add_body(app, body_options, exit_code);
  add_dataset(app, dataset_options, exit_code);
  bool schema_of_plans = false;
  add_schema(app, schema_of_plans);
  add_studio(app, studio_options, exit_code);
  try {
    app.parse(argc, argv);
    return finish_output(exit_code);
  } catch (const CLI::ParseError& error) {
    // asking for help or the version comes as an "error" too
    if (error.get_exit_code() != 0) return report_usage(app, error);
    std::ostringstream told;
    app.exit(error, told);
    write_out(told.str());
    return finish_output(kDone);
  } catch (const std::exception& error) {
    print_err("shigusa: internal fault: {}\n", error.what());
    return kFault;
  }
}
