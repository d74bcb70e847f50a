// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/words.hpp>

#include "commands.hpp"

namespace shigusa::app {
namespace {

Result<double> parse_stature(const std::string& text, Sex sex) {
  if (const auto percentile = stature_percentile(text, sex)) return *percentile;
  if (const auto stature = parse_number(text)) return *stature;
  return fail(ErrorCode::invalid_argument,
              fmt::format("is '{}'; allowed are metres, p5, p50 and p95", text.substr(0, 80)),
              "--stature");
}

// BONE=NODE, or a JSON file
Result<void> add_bones(const std::string& text, CharacterSpec& spec) {
  const std::size_t sign = text.find('=');
  if (sign != std::string::npos) {
    spec.map.emplace_back(text.substr(0, sign), text.substr(sign + 1));
    return {};
  }
  SHG_TRY_ASSIGN(const BoneRequest bones, read_bone_request(text));
  spec.map.insert(spec.map.end(), bones.begin(), bones.end());
  return {};
}

// Fails on options of people from files that are given of others.
Result<void> check_given(const CharacterOptions& options, const CharacterSpec& spec) {
  const bool of_file = !is_built_in(spec);
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
      return fail(ErrorCode::invalid_argument,
                  fmt::format("is of a person from a file, and {} is built in", spec.source),
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

}  // namespace

Result<void> apply_character_options(const CharacterOptions& options, CharacterSpec& spec) {
  SHG_TRY(check_given(options, spec));
  if (options.extent) spec.extent = *value_of<BodyExtent>(*options.extent, "extent");
  if (options.frame) spec.frame = options.frame;
  if (options.animation) spec.animation = options.animation;
  if (options.mass) spec.mass = options.mass;
  if (options.seat) spec.seat = options.seat;
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
  usual.one_file = options.one_file;
  usual.rate = options.fps.value_or(usual.rate);
  usual.clip = options.clip;
  usual.in_place = options.in_place;
  if (options.joint_names) {
    SHG_TRY_ASSIGN(usual.names, value_of<JointNames>(*options.joint_names, "joint names"));
  }
  if (!options.formats) return usual;
  SHG_TRY_ASSIGN(usual.formats, parse_formats(*options.formats));
  SHG_TRY(check_formats(spec, usual.formats));
  return usual;
}

}  // namespace shigusa::app
