// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "commands.hpp"

namespace shigusa::app {

Result<void> apply_character_options(const CharacterOptions& options, CharacterSpec& spec) {
  const struct {
    const char* name;
    bool given;
    bool measures;  // told before the person in the file is measured
  } of_a_file[] = {{"--extent", options.extent.has_value(), false},
                   {"--frame", options.frame.has_value(), true},
                   {"--stature", options.stature.has_value() && !is_built_in(spec), true}};
  for (const auto& option : of_a_file) {
    if (option.given && is_built_in(spec)) {
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
  if (options.extent) {
    spec.extent = *options.extent == "half"   ? BodyExtent::half
                  : *options.extent == "full" ? BodyExtent::full
                                              : BodyExtent::human;
  }
  if (options.frame) spec.frame = *options.frame;
  if (options.stature) spec.stature = *options.stature;
  if (options.mass) spec.mass = *options.mass;
  if (options.sex) spec.sex = *options.sex == "female" ? Sex::female : Sex::male;
  return {};
}

Result<ExportSettings> export_settings(const std::optional<std::string>& formats, bool one_file,
                                       const CharacterSpec& spec) {
  if (!formats) return ExportSettings{usual_formats(spec), one_file};
  Result<std::vector<ExportFormat>> asked = parse_formats(*formats);
  if (!asked) return tl::unexpected(asked.error());
  if (const auto can = check_formats(spec, *asked); !can) return tl::unexpected(can.error());
  return ExportSettings{std::move(*asked), one_file};
}

}  // namespace shigusa::app
