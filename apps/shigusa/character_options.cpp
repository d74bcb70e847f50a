// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/error.hpp>

#include "commands.hpp"
#include "core/parse_number.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "picture.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

// Fails on a length out of range, with a hint if it is plausible in centimetres.
Result<void> check_length(const char* option, double metres, double low, double high) {
  if (metres >= low && metres <= high) return {};
  return fail(ErrorCode::invalid_argument,
              fmt::format("is {:g} m; allowed are {:g} to {:g} m{}", metres, low, high,
                          centimetre_hint(metres, low, high)),
              option);
}

Result<double> parse_stature(const std::string& text, Sex sex) {
  if (const auto percentile = stature_percentile(text, sex)) return *percentile;
  const std::optional<double> stature = parse_number(text);
  if (!stature) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is '{}'; allowed are metres, p5, p50 and p95{}", text.substr(0, 80),
                            comma_hint(text)),
                "--stature");
  }
  SHG_TRY(check_length("--stature", *stature, kStatureMin, kStatureMax));
  return *stature;
}

// BONE=NODE, or a JSON file
Result<void> add_bones(const std::string& text, CharacterSpec& spec) {
  const std::size_t sign = text.find('=');
  if (sign != std::string::npos) {
    spec.map.emplace_back(text.substr(0, sign), text.substr(sign + 1));
    return {};
  }
  SHG_TRY_ASSIGN(const BoneRequest bones, read_bone_request(to_path(text)));
  spec.map.insert(spec.map.end(), bones.begin(), bones.end());
  return {};
}

// Fails if options for people from files are given for other characters.
Result<void> check_given(const CharacterOptions& options, const CharacterSpec& spec) {
  const bool of_file = !is_built_in(spec);
  if (options.sex && is_robot(spec)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("robots cannot have a sex: {} is a robot, whose masses and strengths "
                            "are of its file",
                            spec.source),
                "--sex");
  }
  const struct {
    const char* name;
    bool given;
    bool measures;  // it is needed when the person in the file is measured
  } of_a_file[] = {{"--extent", options.extent.has_value(), false},
                   {"--frame", options.frame.has_value(), true},
                   {"--animation", options.animation.has_value(), true},
                   {"--map", !options.map.empty(), true},
                   {"--seat", options.seat.has_value() && of_file, true},
                   {"--heels", options.heels && of_file, true},
                   {"--stature", options.stature.has_value() && of_file, true}};
  for (const auto& option : of_a_file) {
    if (option.given && !of_file) {
      return fail(
          ErrorCode::invalid_argument,
          fmt::format("is of a person from a file, and {} is built in; give a file in its place",
                      spec.source),
          option.name);
    }
    if (option.given && option.measures && spec.landmarks) {
      return fail(ErrorCode::invalid_argument,
                  "the task file holds this person as measured; give the file by --character",
                  option.name);
    }
  }
  return {};
}

// Options that do not apply to robots.
Result<void> check_files_of_robot(const FileOptions& options, const CharacterSpec& spec) {
  const struct {
    const char* name;
    bool given;
    const char* what;
  } of_people[] = {
      {"--joint-names", options.joint_names.has_value(), "have other joint names than its file's"},
      {"--one-file", options.one_file, "leave as GLB"},
      {"--clip", !options.clip.empty(), "leave as GLB or VRMA"},
      {"--only-this-clip", options.only_this_clip, "leave as GLB"}};
  for (const auto& option : of_people) {
    if (!option.given || !is_robot(spec)) continue;
    return fail(ErrorCode::invalid_argument,
                fmt::format("robots cannot {}, and {} is a robot", option.what, spec.source),
                option.name);
  }
  return {};
}

// Rarely used options for people from files.
void add_file_person_options(CLI::App& c, CharacterOptions& o) {
  const std::string group = heading(OptionGroup::body);
  describe(c.add_option("--extent", o.extent)->check(one_of("extent", all_words<BodyExtent>())),
           {.group = group,
            .brief = "Of a person from a file (default human)",
            .full = "Of a person from a file: human (spine, neck, wrists and so on), full (18 "
                    "freedoms) or half (9).",
            .form = choices<BodyExtent>(),
            .rare = true});
  describe(c.add_option("--frame", o.frame)->transform(frame_or_rest()),
           {.group = group,
            .brief = "Frame of the file that is the start posture",
            .full = "Frame of the file that is the start posture, exactly (from 0; of glTF of an "
                    "animation, at 60 a second), or rest: the file's rest pose, at ease. When not "
                    "given, a motion starts in the first frame that stands still on both feet, or "
                    "at rest where none does.",
            .form = "FRAME|rest",
            .rare = true});
  describe(
      c.add_option("--animation", o.animation),
      {.group = group,
       .brief = "A glTF file's animation (default: its first)",
       .full = "Name or index of a glTF file's animation; its first when not given. Of an MJCF "
               "file, of a keyframe, from which the robot starts.",
       .form = "NAME",
       .rare = true});
  describe(c.add_option("--map", o.map)->allow_extra_args(false),
           {.group = group,
            .brief = "The node of the file that a bone is, or a file of them",
            .full = "The node of the file that a bone is, by its name, right_hand=Bone_17, or by "
                    "its place, right_hand=#17; or a file of them: JSON, or what `shigusa body` "
                    "printed. Repeatable.",
            .form = "BONE=NODE|FILE",
            .rare = true});
}

void add_rare_file_options(CLI::App& c, FileOptions& o) {
  describe(c.add_flag("--one-file", o.one_file),
           {.group = heading(OptionGroup::output),
            .brief = "All candidates in one candidates.glb",
            .full = "All candidates in one candidates.glb in place of a GLB for each.",
            .rare = true});
  describe(c.add_option("--clip", o.clip),
           {.group = heading(OptionGroup::output),
            .brief = "Name of the animation in GLB and VRMA",
            .full = "Name of the animation in GLB and VRMA; in one file with the rank after it.",
            .form = "NAME",
            .rare = true});
  describe(c.add_option("--joint-names", o.joint_names),
           {.group = heading(OptionGroup::output),
            .brief = "Names of a built-in body's joints in BVH and GLB",
            .full = "Whose names the joints of a built-in body have in BVH and GLB: own, when not "
                    "given, or those of another program.",
            .form = choices<JointNames>(),
            .rare = true});
  describe(c.add_flag("--in-place", o.in_place),
           {.group = heading(OptionGroup::output),
            .brief = "The hips stay where they are along the floor",
            .full = "Leaves out the way of the hips along the floor in BVH, GLB and VRMA: for "
                    "games that move the character themselves.",
            .rare = true});
  describe(c.add_flag("--only-this-clip", o.only_this_clip),
           {.group = heading(OptionGroup::output),
            .brief = "GLB without the animations that the file has",
            .full = "Leaves the animations that the character's file has out of GLB; else they "
                    "come after the new one.",
            .rare = true});
}

}  // namespace

bool needs_file(const FormatInfo& info) { return info.needs != NeededFile::none; }

std::string character_form() { return fmt::format("{}|FILE", fmt::join(kBuiltInCharacters, "|")); }

std::string character_help() {
  return fmt::format("{}, a person's file ({}), or a robot's ({}).",
                     fmt::join(kBuiltInCharacters, ", "),
                     format_endings([](const FormatInfo& info) { return info.person; }),
                     format_endings([](const FormatInfo& info) { return info.robot; }));
}

std::string usual_formats_help() {
  return format_words([](const FormatInfo& info) { return info.usual && !needs_file(info); }) +
         "; for characters whose file can hold them also " +
         format_words([](const FormatInfo& info) { return info.usual && needs_file(info); }) +
         "; built-in bodies can leave in " +
         format_words([](const FormatInfo& info) { return info.mannequin; }) + " too";
}

void add_character_options(CLI::App& c, CharacterOptions& o) {
  const std::string group = heading(OptionGroup::body);
  describe(c.add_option("--stature", o.stature),
           {.group = group,
            .brief = "Standing height in metres (default: the body's own)",
            .full = "Standing height in metres, or p5, p50, p95: that of 5, 50 or 95 of 100 people "
                    "of the sex at most.",
            .form = "METRES|p5|p50|p95"});
  describe(c.add_option("--mass", o.mass),
           {.group = group,
            .brief = "Mass of the body (default: from stature and sex)",
            .full = "Mass of the body in kilograms; from stature and sex when not given. Of a "
                    "robot whose file has no masses: spread over it as a person's.",
            .form = "KILOGRAMS"});
  describe(c.add_option("--sex", o.sex)->check(one_of("sex", all_words<Sex>())),
           {.group = group,
            .brief = "Of mass distribution and strength (default male)",
            .form = choices<Sex>()});
  describe(c.add_option("--seat", o.seat),
           {.group = group,
            .brief = "Sits on a seat of this height",
            .full = "Sits on a seat of this height in metres, with the feet where they stand.",
            .form = "METRES"});
  describe(c.add_flag("--heels", o.heels),
           {.group = group,
            .brief = "Heels may lift where people's do",
            .full = "Heels may lift where people's do: on tiptoe for what is high, in a deep squat "
                    "(human, standing)."});
  add_file_person_options(c, o);
}

void add_file_options(CLI::App& c, FileOptions& o, const FileHelp& help) {
  const auto is_written = [](const FormatInfo& info) { return info.written; };
  const auto is_rated = [](const FormatInfo& info) { return info.rated; };
  std::vector<std::string_view> words;
  for (const FormatInfo& info : kFileFormats) {
    if (info.written) words.push_back(info.word);
  }
  describe(c.add_option("--formats", o.formats),
           {.group = heading(OptionGroup::output),
            .brief = "Files of each candidate, with commas between",
            .full = "Files of each candidate, of " + format_words(is_written) +
                    ", with commas between; when not given: " + help.usual + ".",
            .form = fmt::format("{},…", fmt::join(words, "|")),
            .rare = help.rare});
  describe(c.add_option("--fps", o.fps)->check(number(kRateMin, kRateMax)),
           {.group = heading(OptionGroup::output),
            .brief = fmt::format("Frames a second of {} (default {})", format_words(is_rated),
                                 help.rate),
            .full = fmt::format("Frames a second of {}, 1 to 240, such as 24 or 29.97; {} when not "
                                "given, but {:g} of npz. The others have the motion's own frames, "
                                "unless it is the csv of a robot.",
                                format_words(is_rated), help.rate, info_of(FileFormat::npz).rate),
            .form = "RATE",
            .rare = help.rare});
  add_rare_file_options(c, o);
}

Result<void> apply_character_options(const CharacterOptions& options, CharacterSpec& spec) {
  SHG_TRY(check_given(options, spec));
  if (options.extent) spec.extent = *value_of<BodyExtent>(*options.extent, "extent");
  if (options.frame) spec.frame = options.frame;
  if (options.animation) spec.animation = options.animation;
  if (options.mass) spec.mass = options.mass;
  if (options.seat) {
    SHG_TRY(check_length("--seat", *options.seat, kSeatMin, kSeatMax));
    spec.seat = options.seat;
  }
  spec.heels = spec.heels || options.heels;
  if (options.sex) spec.sex = *value_of<Sex>(*options.sex, "sex");
  if (options.stature) {
    SHG_TRY_ASSIGN(spec.stature, parse_stature(*options.stature, spec.sex));
  }
  for (const std::string& text : options.map) {
    SHG_TRY(add_bones(text, spec));
  }
  return {};
}

Result<ExportSettings> export_settings(const FileOptions& options, const CharacterSpec& spec,
                                       ExportSettings usual) {
  SHG_TRY(check_files_of_robot(options, spec));
  usual.from_svg = picture_from;
  usual.one_file = options.one_file;
  if (options.fps) usual.rate = options.fps;
  usual.clip = options.clip;
  usual.in_place = options.in_place;
  usual.only_this_clip = options.only_this_clip;
  if (options.joint_names) {
    SHG_TRY_ASSIGN(usual.names, placed("--joint-names",
                                       value_of<JointNames>(*options.joint_names, "joint names")));
  }
  if (!options.formats) return usual;
  SHG_TRY_ASSIGN(usual.formats, placed("--formats", parse_formats(*options.formats)));
  SHG_TRY(with_hint(check_formats(spec, usual.formats), "; give one by --character"));
  return usual;
}

Result<RecordedMotion> read_clip(const std::string& clip, const CharacterOptions& options,
                                 CharacterSpec character, int first) {
  CharacterOptions person = options;
  person.animation.reset();
  SHG_TRY(apply_character_options(person, character));
  return read_recorded(to_path(clip), std::move(character), first, options.animation.value_or(""));
}

}  // namespace shigusa::app
