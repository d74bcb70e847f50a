// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "core/say.hpp"
#include "export_file.hpp"
#include "files/file.hpp"
#include "formats/by_format.hpp"
#include "formats/json_reader.hpp"

namespace shigusa {
namespace {

// File name endings of the characters that a format needs.
template <NeededFile needed>
std::string endings_for() {
  return format_endings(
      [](const FormatInfo& info) { return info.person && is_file(info.format, needed); }, "and");
}

bool leaves_as_mannequin(const CharacterSpec& character, const FormatInfo& info) {
  return info.mannequin && is_built_in(character) && has_mannequin();
}

}  // namespace

std::string candidate_file(std::size_t rank, FileFormat format) {
  return fmt::format("candidate-{}.{}", rank, word_of(format));
}

bool is_result_file(std::string_view name) {
  constexpr std::string_view kCandidate = "candidate-";
  if (name == kOneFile) return true;
  const std::size_t dot = name.find('.');
  if (!name.starts_with(kCandidate) || dot == name.npos) return false;
  const std::string_view rank = name.substr(kCandidate.size(), dot - kCandidate.size());
  const bool number = !rank.empty() && rank.find_first_not_of("0123456789") == rank.npos;
  return number &&
         std::any_of(kFileFormats.begin(), kFileFormats.end(), [&](const FormatInfo& format) {
           return format.written && name.substr(dot + 1) == format.word;
         });
}

Result<std::vector<FileFormat>> parse_formats(std::string_view list) {
  std::vector<FileFormat> formats;
  std::vector<std::string> names;
  for (const FormatInfo& info : kFileFormats) {
    if (info.written) names.emplace_back(info.word);
  }
  bool more = !list.empty();
  while (more) {
    const std::size_t comma = list.find(',');
    const std::string_view word = list.substr(0, comma);
    more = comma != list.npos;
    list = more ? list.substr(comma + 1) : std::string_view{};
    const auto format = value_of<FileFormat>(word, "format");
    if (!format || !info_of(*format).written) {
      return fail(ErrorCode::invalid_argument, unknown_name("format", word, names));
    }
    const bool again = std::find(formats.begin(), formats.end(), *format) != formats.end();
    if (!again) formats.push_back(*format);
  }
  return formats;
}

std::vector<FileFormat> usual_formats(const CharacterSpec& character) {
  std::vector<FileFormat> formats;
  for (const FormatInfo& info : kFileFormats) {
    const bool asked_for = info.mannequin && !character.rig;
    if (!info.usual || asked_for) continue;
    if (check_formats(character, {info.format})) formats.push_back(info.format);
  }
  return formats;
}

Result<void> check_formats(const CharacterSpec& character, const std::vector<FileFormat>& formats) {
  for (const FileFormat format : formats) {
    const FormatInfo& info = info_of(format);
    const std::string asked = "the format " + std::string(info.word);
    if (!info.written) return fail(ErrorCode::unsupported, say("read_alone"), asked);
    if (info.needs == NeededFile::none || leaves_as_mannequin(character, info)) continue;
    if (!character.rig && character.landmarks) {
      return fail(ErrorCode::invalid_argument, say("file_needed", character.source), asked);
    }
    const bool can = character.rig && is_file(character.rig->format, info.needs);
    if (can && format == FileFormat::glb && !character.rig->not_glb.empty()) {
      return fail(ErrorCode::unsupported, character.rig->not_glb, asked);
    }
    if (can) continue;
    const std::string files = info.needs == NeededFile::vrm ? endings_for<NeededFile::vrm>()
                                                            : endings_for<NeededFile::gltf>();
    return fail(ErrorCode::invalid_argument, say("other_characters", files, character.source),
                asked);
  }
  return {};
}

Result<void> check_rate(double rate, std::string_view place) {
  if (rate >= kRateMin && rate <= kRateMax) return {};
  return fail(ErrorCode::invalid_argument, say("rate_range", rate, kRateMin, kRateMax),
              std::string(place));
}

Result<FileSettings> parse_file_settings(std::string_view text, std::string_view name,
                                         FileSettings settings) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  JsonReader reader(json, std::string(name) + ": ");
  if (reader.has("fps")) reader.number("fps", settings.rate.emplace(), kRateMin, kRateMax);
  reader.text("clip", settings.animation);
  reader.word("joint_names", settings.names);
  reader.truth("in_place", settings.in_place);
  reader.truth("only_this_clip", settings.only_this_clip);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return settings;
}

Result<void> check_file_settings(const CharacterSpec& character, FileFormat format,
                                 const FileSettings& settings) {
  if (settings.rate) SHG_TRY(check_rate(*settings.rate, "rate"));
  constexpr std::size_t kClipNameMax = 200;
  if (settings.animation.size() > kClipNameMax) {
    return fail(ErrorCode::invalid_argument,
                say("long_clip_name", settings.animation.size(), kClipNameMax), "the clip's name");
  }
  const bool has_own = character.rig || character.urdf;
  if (settings.names == JointNames::own || !has_own || !info_of(format).clip) return {};
  return fail(ErrorCode::invalid_argument, say("own_joint_names", character.source), "joint names");
}

Result<MadeFile> unread(Result<std::string> bytes) {
  if (!bytes) return tl::unexpected(bytes.error());
  return MadeFile{std::move(*bytes), {}};
}

Result<MadeFile> make_file(const WriteRequest& request, FileFormat format) {
  static constexpr auto kWriters =
      by_format<Result<MadeFile>(const WriteRequest&), &FormatInfo::written>(
          []<FileFormat written>() { return &write_as<written>; });
  SHG_TRY(check_formats(request.character, {format}));
  SHG_TRY(check_file_settings(request.character, format, request.settings));
  return kWriters[static_cast<std::size_t>(format)](request);
}

Result<std::string> export_candidate(const CharacterSpec& character, const Task& task,
                                     const Candidate& candidate, FileFormat format,
                                     const FileSettings& settings) {
  SHG_TRY_ASSIGN(MadeFile made, make_file({character, task, candidate, settings}, format));
  return std::move(made.bytes);
}

Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                     FileFormat format, const FileSettings& settings) {
  return export_candidate(CharacterSpec{}, task, candidate, format, settings);
}

Result<void> save(const std::filesystem::path& path, const CharacterSpec& character,
                  const Task& task, const Candidate& candidate, const FileSettings& settings) {
  const std::string ending = file_ending(path.string());
  SHG_TRY_ASSIGN(
      const auto format,
      value_of<FileFormat>(ending.size() > 1 ? ending.substr(1) : "no ending", "format"));
  SHG_TRY_ASSIGN(const std::string bytes,
                 export_candidate(character, task, candidate, format, settings));
  return write_file(path, bytes);
}

Result<std::string> export_all(const CharacterSpec& character, const Task& task,
                               const std::vector<Candidate>& candidates,
                               const FileSettings& settings) {
  SHG_TRY_ASSIGN(MadeGlb made, make_one_glb(character, task, candidates, settings));
  return std::move(made.bytes);
}

}  // namespace shigusa
