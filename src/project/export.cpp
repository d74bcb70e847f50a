// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <shigusa/core/names.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/io/csv.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/io/strip_figure.hpp>
#include <shigusa/kinematics/skeleton_motion.hpp>
#include <shigusa/project/export.hpp>
#include <utility>

#include "character_export.hpp"
#include "robot_columns.hpp"

namespace shigusa {
namespace {

constexpr std::array<std::pair<const char*, ExportFormat>, 7> kFormats{
    {{"bvh", ExportFormat::bvh},
     {"csv", ExportFormat::csv},
     {"svg", ExportFormat::svg},
     {"png", ExportFormat::png},
     {"pdf", ExportFormat::pdf},
     {"glb", ExportFormat::glb},
     {"vrma", ExportFormat::vrma}}};
constexpr const char* kOneFile = "candidates.glb";

const char* format_name(ExportFormat format) {
  for (const auto& [name, known] : kFormats) {
    if (known == format) return name;
  }
  return "";
}

void add_point_columns(const std::string& name, const std::vector<Vec3d>& points,
                       std::vector<CsvColumn>& columns) {
  for (int k = 0; k < 3; ++k) {
    CsvColumn column{fmt::format("{}.{} [m]", name, "xyz"[k]), {}};
    for (const Vec3d& point : points) column.values.push_back(point[k]);
    columns.push_back(std::move(column));
  }
}

Result<std::string> motion_csv(const Task& task, const Candidate& candidate) {
  const Motion& motion = candidate.motion;
  std::vector<CsvColumn> columns{{"time [s]", {}}};
  for (int f = 0; f < motion.clip.frames; ++f) {
    columns[0].values.push_back(f * motion.clip.frame_time);
  }
  if (task.body.robot()) {
    add_robot_columns(task.body, motion, columns);
    const auto turned = [](std::vector<Vec3d> points) {
      for (Vec3d& point : points) point = in_robot_world(point);
      return points;
    };
    add_point_columns("centre_of_mass", turned(motion.centre_of_mass), columns);
    for (std::size_t g = 0; g < candidate.goals.size(); ++g) {
      add_point_columns(candidate.goals[g].effector, turned(motion.effectors[g]), columns);
    }
    return format_csv(columns);
  }
  const auto dofs = static_cast<std::size_t>(motion.clip.dofs);
  const auto add = [&](std::size_t d, const char* unit, const std::vector<double>& values) {
    CsvColumn column{fmt::format("{} {}", task.body.dofs()[d].name, unit), {}};
    for (std::size_t i = d; i < values.size(); i += dofs) column.values.push_back(values[i]);
    columns.push_back(std::move(column));
  };
  for (std::size_t d = 0; d < dofs; ++d) add(d, "[rad]", motion.clip.angles);
  for (std::size_t d = 0; d < dofs; ++d) add(d, "torque [N m]", motion.torques);
  add_point_columns("centre_of_mass", motion.centre_of_mass, columns);
  for (std::size_t g = 0; g < candidate.goals.size(); ++g) {
    add_point_columns(candidate.goals[g].effector, motion.effectors[g], columns);
  }
  return format_csv(columns);
}

// The limb that a goal moves, by the effector's name; none of the trunk and the head.
std::optional<Limb> limb_of(std::string_view effector) {
  const bool left = effector.starts_with("left_");
  if (!left && !effector.starts_with("right_")) return std::nullopt;
  const auto has = [effector](std::string_view word) {
    return effector.find(word) != effector.npos;
  };
  for (const char* word : {"foot", "toes", "ankle", "knee", "hip", "leg"}) {
    if (has(word)) return left ? Limb::left_leg : Limb::right_leg;
  }
  for (const char* word : {"hand", "wrist", "elbow", "shoulder", "arm"}) {
    if (has(word)) return left ? Limb::left_arm : Limb::right_arm;
  }
  return std::nullopt;
}

StripSettings strip_settings(const Task& task) {
  StripSettings settings;
  settings.floor = 0.0;
  settings.facing = Vec3d{0, 0, 1};
  settings.accented.clear();
  for (const Goal& goal : task.goals) {
    if (const auto limb = limb_of(goal.effector)) settings.accented.push_back(*limb);
  }
  return settings;
}

Result<std::string> motion_strip(const Task& task, const Candidate& candidate,
                                 FigureFormat format) {
  StripOverlay overlay;
  for (const GoalResult& goal : candidate.goals) overlay.goals.push_back(goal.goal);
  overlay.centre_of_mass = candidate.motion.centre_of_mass;
  overlay.hand_path = candidate.motion.effectors.front();
  return draw_strip(skeleton_motion(task.body, candidate.motion.clip), overlay,
                    strip_settings(task), format);
}

std::string file_name(std::size_t index, const char* format) {
  return fmt::format("candidate-{}.{}", index + 1, format);
}

// Removes what an earlier result left in the folder and this one does not have: more candidates, or
// other formats. Nothing of an older motion may stand beside a new one.
void remove_surplus(const std::filesystem::path& folder, const std::vector<CandidateFiles>& files) {
  constexpr std::size_t kMany = 1000;
  std::error_code ignored;
  const bool one = !files.empty() && files[0].contains("glb") && files[0].at("glb") == kOneFile;
  if (!one) std::filesystem::remove(folder / kOneFile, ignored);
  for (std::size_t i = 0; i < kMany; ++i) {
    bool any = i < files.size();
    for (const auto& [name, format] : kFormats) {
      if (i < files.size() && files[i].contains(name) && files[i].at(name) != kOneFile) continue;
      any = std::filesystem::remove(folder / file_name(i, name), ignored) || any;
    }
    if (!any) return;
  }
}

}  // namespace

Result<std::vector<ExportFormat>> parse_formats(std::string_view list) {
  std::vector<ExportFormat> formats;
  std::vector<std::string> names;
  for (const auto& [name, format] : kFormats) names.emplace_back(name);
  bool more = !list.empty();
  while (more) {
    const std::size_t comma = list.find(',');
    const std::string_view word = list.substr(0, comma);
    more = comma != list.npos;
    list = more ? list.substr(comma + 1) : std::string_view{};
    bool found = false;
    for (const auto& [name, format] : kFormats) {
      if (word == name) formats.push_back(format);
      found = found || word == name;
    }
    if (!found) return fail(ErrorCode::invalid_argument, unknown_name("format", word, names));
  }
  return formats;
}

Result<void> prepare_folder(const std::filesystem::path& folder) {
  if (folder.empty()) {
    return fail(ErrorCode::invalid_argument, "the folder for the result has an empty name");
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    return fail(ErrorCode::io,
                "cannot make this folder: " + (error ? error.message() : "it is a file"),
                folder.string());
  }
  const std::filesystem::path probe = folder / ".shigusa-probe";
  if (const auto written = write_file(probe, ""); !written) {
    return fail(ErrorCode::io, "cannot write to this folder: " + written.error().message,
                folder.string());
  }
  std::filesystem::remove(probe, error);
  return {};
}

Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                     ExportFormat format) {
  switch (format) {
    case ExportFormat::bvh:
      return format_bvh(skeleton_motion(task.body, candidate.motion.clip));
    case ExportFormat::csv:
      return motion_csv(task, candidate);
    case ExportFormat::svg:
      return motion_strip(task, candidate, FigureFormat::svg);
    case ExportFormat::png:
      return motion_strip(task, candidate, FigureFormat::png);
    case ExportFormat::pdf:
      return motion_strip(task, candidate, FigureFormat::pdf);
    case ExportFormat::glb:
    case ExportFormat::vrma:
      break;
  }
  return fail(ErrorCode::unsupported, "a body of one's own has no glTF file to leave in");
}

namespace {

// One candidate's bytes; `name` of its animation.
Result<std::string> export_any(const CharacterExporter* character, const Task& task,
                               const Candidate& candidate, ExportFormat format,
                               const std::string& name) {
  if (character != nullptr && format == ExportFormat::bvh) {
    return character->bvh(task.body, candidate.motion.clip);
  }
  if (character != nullptr && format == ExportFormat::glb) {
    return character->glb(
        std::vector{character->animation(task.body, candidate.motion.clip, name)});
  }
  if (character != nullptr && format == ExportFormat::vrma) {
    return character->vrma(task.body, candidate.motion.clip, name);
  }
  return export_candidate(task, candidate, format);
}

}  // namespace

std::vector<ExportFormat> usual_formats(const CharacterSpec& character) {
  std::vector<ExportFormat> formats{ExportFormat::bvh, ExportFormat::csv, ExportFormat::svg,
                                    ExportFormat::png};
  for (const ExportFormat more : {ExportFormat::glb, ExportFormat::vrma}) {
    if (check_formats(character, {more})) formats.push_back(more);
  }
  return formats;
}

Result<void> check_formats(const CharacterSpec& character,
                           const std::vector<ExportFormat>& formats) {
  for (const ExportFormat format : formats) {
    if (format != ExportFormat::glb && format != ExportFormat::vrma) continue;
    const std::string asked = std::string("the format ") + format_name(format);
    if (!character.rig && character.landmarks) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("needs the character's file, {}: give it by --character FILE",
                              character.source),
                  asked);
    }
    const bool gltf = character.rig && character.rig->format != CharacterFormat::bvh;
    const bool vrm = gltf && character.rig->format == CharacterFormat::vrm;
    if (format == ExportFormat::glb && gltf && !character.rig->not_glb.empty()) {
      return fail(ErrorCode::unsupported, character.rig->not_glb, asked);
    }
    if (format == ExportFormat::glb ? gltf : vrm) continue;
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("is for characters from {} files, and {} is none",
                    format == ExportFormat::glb ? ".glb, .gltf and .vrm" : "VRM", character.source),
        asked);
  }
  return {};
}

Result<std::string> export_candidate(const CharacterSpec& character, const Task& task,
                                     const Candidate& candidate, ExportFormat format,
                                     const std::string& animation) {
  if (const auto can = check_formats(character, {format}); !can) return tl::unexpected(can.error());
  std::optional<CharacterExporter> exporter;
  if (character.rig) exporter.emplace(*character.rig);
  return export_any(exporter ? &*exporter : nullptr, task, candidate, format, animation);
}

Result<std::string> export_all(const CharacterSpec& character, const Task& task,
                               const std::vector<Candidate>& candidates) {
  if (const auto can = check_formats(character, {ExportFormat::glb}); !can) {
    return tl::unexpected(can.error());
  }
  const CharacterExporter exporter(*character.rig);
  std::vector<GltfAnimation> animations;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    animations.push_back(exporter.animation(task.body, candidates[i].motion.clip,
                                            candidate_animation(character, i + 1)));
  }
  return exporter.glb(animations);
}

Result<std::string> write_result(const std::filesystem::path& folder, const TaskFile& file,
                                 const Task& task, const Generation& generation,
                                 const RunInfo& info, const ExportSettings& settings) {
  if (const auto can = check_formats(file.character, settings.formats); !can) {
    return tl::unexpected(can.error());
  }
  std::optional<CharacterExporter> character;
  if (file.character.rig) character.emplace(*file.character.rig);
  std::vector<CandidateFiles> files(generation.candidates.size());
  for (const ExportFormat format : settings.formats) {
    const bool one = settings.one_file && format == ExportFormat::glb;
    if (one) {
      const auto bytes = export_all(file.character, task, generation.candidates);
      if (!bytes) return tl::unexpected(bytes.error());
      const auto written = write_file(folder / kOneFile, *bytes);
      if (!written) return tl::unexpected(written.error());
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
      const std::string name = one ? kOneFile : file_name(i, format_name(format));
      files[i][format_name(format)] = name;
      if (one) continue;
      const Result<std::string> bytes =
          export_any(character ? &*character : nullptr, task, generation.candidates[i], format,
                     candidate_animation(file.character, i + 1));
      if (!bytes) return tl::unexpected(bytes.error());
      if (const auto written = write_file(folder / name, *bytes); !written) {
        return tl::unexpected(written.error());
      }
    }
  }
  remove_surplus(folder, files);
  const std::string summary = format_result(file, task, generation, info, files);
  if (const auto written = write_file(folder / kSummaryName, summary); !written) {
    return tl::unexpected(written.error());
  }
  return summary;
}

}  // namespace shigusa
