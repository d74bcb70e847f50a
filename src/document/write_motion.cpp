// SPDX-License-Identifier: MIT
// Writers of the formats that hold the motion of nodes.
#include <fmt/format.h>

#include <shigusa/formats.hpp>

#include "character/character_rig.hpp"
#include "character_export.hpp"
#include "core/say.hpp"
#include "export_file.hpp"
#include "glb_things.hpp"
#include "hand_play.hpp"
#include "in_place.hpp"
#include "joint_names.hpp"
#include "kinematics/skeleton_motion.hpp"
#ifdef SHIGUSA_HAS_MANNEQUIN
#include "mannequin_export.hpp"
#endif
#include "read_back.hpp"

namespace shigusa {
namespace {

// Frames a second of a file.
double rate_of(const FileSettings& settings) { return settings.rate.value_or(kUsualRate); }

// A file made by `make` from the motion at the requested rate, and read back by `check`.
template <class Make, class Check>
Result<MadeFile> checked_file(const WriteRequest& request, Make&& make, Check&& check) {
  const auto& [character, task, candidate, settings, cost] = request;
  SHG_TRY_ASSIGN(const Clip clip, clip_at_rate(character, task, candidate, rate_of(settings)));
  SHG_TRY_ASSIGN(std::string bytes, make(clip));
  SHG_TRY_ASSIGN(const ReadBack back,
                 check(ReadBackCheck(character, task, candidate, clip, settings.in_place), bytes));
  return MadeFile{std::move(bytes), back};
}

CharacterExporter exporter_of(const WriteRequest& request) {
  return CharacterExporter(*request.character.rig, request.settings);
}

// GLB writer of a character. That of built-in bodies needs the mannequin, which a build may lack
// (check_formats).
std::unique_ptr<GlbExporter> glb_exporter(const CharacterSpec& character,
                                          [[maybe_unused]] const Task& task,
                                          const FileSettings& settings) {
#ifdef SHIGUSA_HAS_MANNEQUIN
  if (!character.rig) {
    return std::make_unique<MannequinExporter>(character, task.body, settings);
  }
#endif
  return std::make_unique<CharacterExporter>(*character.rig, settings);
}

GltfAnimation animation_of(const GlbExporter& exporter, const Task& task,
                           const Candidate& candidate, const Clip& clip, double rate,
                           const std::string& name) {
  const std::vector<ThingMotion> things = things_at(candidate, rate);
  return exporter.animation(
      task, clip, name,
      {.things = things, .hands = hand_play(task, candidate), .markers = markers_of(candidate)});
}

}  // namespace

Result<Clip> clip_at_rate(const CharacterSpec& character, const Task& task,
                          const Candidate& candidate, double rate) {
  const Clip& clip = candidate.motion.clip;
  const std::size_t nodes =
      character.rig ? character.rig->rig.nodes.size() : task.body.nodes().size();
  const auto frames = static_cast<std::size_t>(frames_at(clip.duration(), rate));
  if (frames * nodes <= kBvhMaxTransforms) return motion_at(task.body, candidate, rate);
  return fail(ErrorCode::invalid_argument, say("file_frames", frames, nodes, kBvhMaxTransforms));
}

// BVH of any body; a character from a file keeps its own nodes.
template <>
Result<MadeFile> write_as<FileFormat::bvh>(const WriteRequest& request) {
  const std::shared_ptr<const CharacterRig>& rig = request.character.rig;
  const PosedBody& body = request.task;
  const FileSettings& settings = request.settings;
  const auto make = [&](const Clip& clip) -> Result<std::string> {
    if (rig)
      return exporter_of(request).bvh(body, clip, hand_play(request.task, request.candidate));
    SkeletonMotion motion = skeleton_motion(body, clip);
    if (settings.in_place) {
      stay_in_place(0, {}, {0, 1, 0}, motion.skeleton.nodes.size(), motion.clip.local);
    }
    motion.skeleton = named(std::move(motion.skeleton), settings.names);
    return format_bvh(motion);
  };
  return checked_file(request, make, [](const ReadBackCheck& check, const std::string& bytes) {
    return check.bvh(bytes);
  });
}

template <>
Result<MadeFile> write_as<FileFormat::glb>(const WriteRequest& request) {
  const auto exporter = glb_exporter(request.character, request.task, request.settings);
  const std::string& name = request.settings.animation;
  const auto make = [&](const Clip& clip) {
    const auto& [character, task, candidate, settings, cost] = request;
    return exporter->glb(
        std::vector{animation_of(*exporter, task, candidate, clip, rate_of(settings), name)});
  };
  return checked_file(request, make, [&](const ReadBackCheck& check, const std::string& bytes) {
    return check.glb(bytes, name);
  });
}

template <>
Result<MadeFile> write_as<FileFormat::vrma>(const WriteRequest& request) {
  const CharacterExporter exporter = exporter_of(request);
  const auto make = [&](const Clip& clip) {
    const auto& [character, task, candidate, settings, cost] = request;
    return exporter.vrma(task, clip, settings.animation,
                         {.hands = hand_play(task, candidate), .markers = markers_of(candidate)});
  };
  return checked_file(request, make, [](const ReadBackCheck& check, const std::string& bytes) {
    return check.vrma(bytes);
  });
}

Result<MadeGlb> make_one_glb(const CharacterSpec& character, const Task& task,
                             const std::vector<Candidate>& candidates,
                             const FileSettings& settings) {
  SHG_TRY(check_formats(character, {FileFormat::glb}));
  SHG_TRY(check_file_settings(character, FileFormat::glb, settings));
  const auto exporter = glb_exporter(character, task, settings);
  std::vector<GltfAnimation> animations;
  std::vector<Clip> clips;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    SHG_TRY_ASSIGN(Clip clip, clip_at_rate(character, task, candidates[i], rate_of(settings)));
    clips.push_back(std::move(clip));
    const std::string name =
        settings.animation.empty()
            ? candidate_animation(character, i + 1)
            : free_animation(character, fmt::format("{} {}", settings.animation, i + 1));
    animations.push_back(
        animation_of(*exporter, task, candidates[i], clips.back(), rate_of(settings), name));
  }
  SHG_TRY_ASSIGN(std::string bytes, exporter->glb(animations));
  MadeGlb made{std::move(bytes), {}};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const ReadBackCheck check(character, task, candidates[i], clips[i], settings.in_place);
    SHG_TRY_ASSIGN(const ReadBack back, check.glb(made.bytes, animations[i].name));
    made.back.push_back(back);
  }
  return made;
}

}  // namespace shigusa
