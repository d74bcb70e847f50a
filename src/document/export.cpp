// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/body/joint_name.hpp>
#include <shigusa/character/character_rig.hpp>
#include <shigusa/core/enum_words.hpp>
#include <shigusa/document/export.hpp>
#include <shigusa/figure/strip_figure.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/io/csv.hpp>
#include <shigusa/kinematics/held_resample.hpp>
#include <shigusa/kinematics/skeleton_motion.hpp>
#include <utility>

#include "character_export.hpp"
#include "export_file.hpp"
#include "io/json_reader.hpp"
#include "read_back.hpp"
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
  const JointName joint = parse_joint_name(effector);
  if (!joint.side) return std::nullopt;
  const bool left = joint.side == Side::left;
  if (joint.limb() == LimbKind::leg) return left ? Limb::left_leg : Limb::right_leg;
  return left ? Limb::left_arm : Limb::right_arm;
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

Result<MadeFile> drawn(Result<std::string> bytes) {
  if (!bytes) return tl::unexpected(bytes.error());
  return MadeFile{std::move(*bytes), {}};
}

// The motion as files of it have it. Fails on more of it than a file may hold.
Result<Clip> clip_at_rate(const CharacterSpec& character, const Task& task,
                          const Candidate& candidate, double rate) {
  const Clip& clip = candidate.motion.clip;
  const std::size_t nodes =
      character.rig ? character.rig->rig.nodes.size() : task.body.nodes().size();
  const auto frames = static_cast<std::size_t>(frames_at(clip.duration(), rate));
  if (frames * nodes <= kBvhMaxTransforms) return motion_at(task.body, candidate, rate);
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} frames of {} nodes are more than a file may hold, {}: ask for fewer "
                          "frames a second by --fps",
                          frames, nodes, kBvhMaxTransforms));
}

// Formats with the motion of nodes: BVH of any body, GLB and VRMA of characters that can.
Result<std::string> moving_file(const CharacterSpec& character, const BodyModel& body,
                                const Clip& clip, ExportFormat format, const std::string& name) {
  if (!character.rig) return format_bvh(skeleton_motion(body, clip));
  const CharacterExporter exporter(*character.rig);
  if (format == ExportFormat::bvh) return exporter.bvh(body, clip);
  if (format == ExportFormat::vrma) return exporter.vrma(body, clip, name);
  return exporter.glb(std::vector{exporter.animation(body, clip, name)});
}

}  // namespace

const char* format_name(ExportFormat format) {
  for (const auto& [name, known] : kFormats) {
    if (known == format) return name;
  }
  return "";
}

std::string candidate_file(std::size_t rank, ExportFormat format) {
  return fmt::format("candidate-{}.{}", rank, format_name(format));
}

bool is_result_file(std::string_view name) {
  constexpr std::string_view kCandidate = "candidate-";
  if (name == kOneFile) return true;
  const std::size_t dot = name.find('.');
  if (!name.starts_with(kCandidate) || dot == name.npos) return false;
  const std::string_view rank = name.substr(kCandidate.size(), dot - kCandidate.size());
  const bool number = !rank.empty() && rank.find_first_not_of("0123456789") == rank.npos;
  return number && std::any_of(kFormats.begin(), kFormats.end(), [&](const auto& format) {
           return name.substr(dot + 1) == format.first;
         });
}

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
      if (word != name) continue;
      found = true;
      const bool again = std::find(formats.begin(), formats.end(), format) != formats.end();
      if (!again) formats.push_back(format);
    }
    if (!found) return fail(ErrorCode::invalid_argument, unknown_name("format", word, names));
  }
  return formats;
}

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

Result<void> check_rate(double rate, std::string_view place) {
  if (rate >= kRateMin && rate <= kRateMax) return {};
  return fail(
      ErrorCode::invalid_argument,
      fmt::format("is {:g} frames a second; allowed are {:g} to {:g}", rate, kRateMin, kRateMax),
      std::string(place));
}

Clip motion_at(const BodyModel& body, const Candidate& candidate, double rate) {
  Held held;
  for (const Foot& foot : body.feet()) {
    const auto stands = [&foot](const ContactResult& contact) {
      return contact.effector == foot.name;
    };
    const auto& contacts = candidate.contacts;
    // the base cannot move
    if (foot.link == kBaseLink || std::none_of(contacts.begin(), contacts.end(), stands)) continue;
    held.feet.push_back(foot);
  }
  for (const GoalResult& goal : candidate.goals) {
    if (const auto effector = body.find_effector(goal.effector)) {
      held.effectors.push_back(body.effector(*effector));
    }
  }
  return resampled(body, candidate.motion.clip, rate, held);
}

Result<FileSettings> parse_file_settings(std::string_view text, std::string_view name) {
  const Result<Json> json = parse_json(text, name);
  if (!json) return tl::unexpected(json.error());
  JsonReader reader(*json, std::string(name) + ": ");
  FileSettings settings;
  reader.number("fps", settings.rate, kRateMin, kRateMax);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return settings;
}

Result<MadeFile> make_file(const CharacterSpec& character, const Task& task,
                           const Candidate& candidate, ExportFormat format,
                           const FileSettings& settings) {
  if (const auto can = check_formats(character, {format}); !can) return tl::unexpected(can.error());
  if (const auto can = check_rate(settings.rate, "rate"); !can) return tl::unexpected(can.error());
  switch (format) {
    case ExportFormat::csv:
      return drawn(motion_csv(task, candidate));
    case ExportFormat::svg:
      return drawn(motion_strip(task, candidate, FigureFormat::svg));
    case ExportFormat::png:
      return drawn(motion_strip(task, candidate, FigureFormat::png));
    case ExportFormat::pdf:
      return drawn(motion_strip(task, candidate, FigureFormat::pdf));
    case ExportFormat::bvh:
    case ExportFormat::glb:
    case ExportFormat::vrma:
      break;
  }
  const Result<Clip> clip = clip_at_rate(character, task, candidate, settings.rate);
  if (!clip) return tl::unexpected(clip.error());
  const ReadBackCheck check(character, task, candidate, *clip);
  const std::string& name = settings.animation;
  Result<std::string> bytes = moving_file(character, task.body, *clip, format, name);
  if (!bytes) return tl::unexpected(bytes.error());
  const Result<ReadBack> back = format == ExportFormat::bvh   ? check.bvh(*bytes)
                                : format == ExportFormat::glb ? check.glb(*bytes, name)
                                                              : check.vrma(*bytes);
  if (!back) return tl::unexpected(back.error());
  return MadeFile{std::move(*bytes), *back};
}

Result<MadeGlb> make_one_glb(const CharacterSpec& character, const Task& task,
                             const std::vector<Candidate>& candidates, double rate) {
  if (const auto can = check_formats(character, {ExportFormat::glb}); !can) {
    return tl::unexpected(can.error());
  }
  if (const auto can = check_rate(rate, "rate"); !can) return tl::unexpected(can.error());
  const CharacterExporter exporter(*character.rig);
  std::vector<GltfAnimation> animations;
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Result<Clip> clip = clip_at_rate(character, task, candidates[i], rate);
    if (!clip) return tl::unexpected(clip.error());
    clips.push_back(std::move(*clip));
    animations.push_back(
        exporter.animation(task.body, clips.back(), candidate_animation(character, i + 1)));
  }
  Result<std::string> bytes = exporter.glb(animations);
  if (!bytes) return tl::unexpected(bytes.error());
  MadeGlb made{std::move(*bytes), {}};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const ReadBackCheck check(character, task, candidates[i], clips[i]);
    const Result<ReadBack> back = check.glb(made.bytes, animations[i].name);
    if (!back) return tl::unexpected(back.error());
    made.back.push_back(*back);
  }
  return made;
}

Result<std::string> export_candidate(const CharacterSpec& character, const Task& task,
                                     const Candidate& candidate, ExportFormat format,
                                     const FileSettings& settings) {
  Result<MadeFile> made = make_file(character, task, candidate, format, settings);
  if (!made) return tl::unexpected(made.error());
  return std::move(made->bytes);
}

Result<std::string> export_candidate(const Task& task, const Candidate& candidate,
                                     ExportFormat format, const FileSettings& settings) {
  return export_candidate(CharacterSpec{}, task, candidate, format, settings);
}

Result<std::string> export_all(const CharacterSpec& character, const Task& task,
                               const std::vector<Candidate>& candidates, double rate) {
  Result<MadeGlb> made = make_one_glb(character, task, candidates, rate);
  if (!made) return tl::unexpected(made.error());
  return std::move(made->bytes);
}

}  // namespace shigusa
