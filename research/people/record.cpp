// SPDX-License-Identifier: MIT
#include "record.hpp"

#include <array>
#include <charconv>
#include <shigusa/formats.hpp>

#include "character/character_rig.hpp"
#include "files/file.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "tab_table.hpp"

namespace shigusa::bench {
namespace {

constexpr int kManifestRate = 2;  // its frames per frame of the file
constexpr std::size_t kManifestMaxBytes = 1 << 20;

using Bone = HumanoidBone;
constexpr std::array kBones{Bone::right_upper_arm, Bone::right_lower_arm, Bone::right_upper_leg,
                            Bone::right_lower_leg, Bone::right_foot,      Bone::left_upper_arm,
                            Bone::left_upper_leg,  Bone::left_lower_leg,  Bone::left_foot,
                            Bone::right_hand};
static_assert(kBones.size() == right_grip);

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} && value >= 0 ? std::optional(value) : std::nullopt;
}

Result<CharacterSpec> measured(const std::filesystem::path& clip, int frame, BodyExtent extent,
                               bool heels = false) {
  CharacterSpec person{.source = clip.string(), .extent = extent, .frame = frame};
  person.heels = heels;
  SHG_TRY(measure_character(person, {}));
  return person;
}

Track record_track(const Recorded& reach) {
  const Rig& rig = reach.person.rig->rig;
  Track track;
  track.frame_time = reach.motion.clip.frame_time;
  for (int f = reach.segment.first; f <= reach.segment.last; ++f) {
    const auto world = world_transforms(reach.motion.skeleton, reach.motion.clip, f);
    const auto at = [&](int node) {
      return rig.placement.to_world(world[static_cast<std::size_t>(node)].translation);
    };
    Joints joints;
    for (const Bone bone : kBones) joints.push_back(at(rig.bones[bone]));
    joints.push_back(at(rig.grips[1]));
    track.joints.push_back(std::move(joints));
  }
  return track;
}

// The body's own skeleton as a rig in the body's start posture.
Rig own_rig(const Landmarks& start, const SkeletonMotion& motion) {
  Rig rig;
  for (std::size_t i = 0; i < motion.skeleton.nodes.size(); ++i) {
    const LocalTransform& local = motion.clip.local[i];
    rig.nodes.push_back({motion.skeleton.nodes[i].parent, local.translation, local.rotation});
  }
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<Bone>(b);
    rig.bones[bone] = motion.skeleton.find(humanoid_bone_name(bone));
  }
  rig.rest = rig.start = start;
  return rig;
}

}  // namespace

Result<std::vector<Segment>> all_segments(const std::filesystem::path& manifest) {
  SHG_TRY_ASSIGN(const std::string text, read_text_file(manifest, kManifestMaxBytes));
  std::vector<Segment> segments;
  for (const std::string_view line : split(text, '\n')) {
    const auto cells = split(line, '\t');
    if (cells.size() < 4) continue;
    const auto first = number(cells[2]);
    const auto last = number(cells[3]);
    if (!first || !last) continue;
    segments.push_back({std::string(cells[0]), *first / kManifestRate, *last / kManifestRate});
  }
  if (segments.empty()) return fail(ErrorCode::parse, "has no segment", manifest.string());
  return segments;
}

Result<std::vector<Segment>> downward_segments(const std::filesystem::path& manifest) {
  SHG_TRY_ASSIGN(std::vector<Segment> segments, all_segments(manifest));
  std::erase_if(segments, [](const Segment& each) { return !each.name.ends_with("-low"); });
  if (segments.empty()) {
    return fail(ErrorCode::parse, "has no segment that ends in -low", manifest.string());
  }
  return segments;
}

Task Recorded::task() const {
  Task task(posed);
  task.goals = {{"right_hand", track.joints.back()[right_grip]}};
  task.duration = track.duration();
  return task;
}

Result<Recorded> read_reach(const std::filesystem::path& clip, const Segment& segment, bool heels) {
  SHG_TRY_ASSIGN(SkeletonMotion motion, read_bvh(clip));
  SHG_TRY_ASSIGN(const CharacterSpec person,
                 measured(clip, segment.first, BodyExtent::human, heels));
  SHG_TRY_ASSIGN(const CharacterSpec paper, measured(clip, segment.first, BodyExtent::full));
  SHG_TRY_ASSIGN(PosedBody posed, build_character(person));
  SHG_TRY_ASSIGN(PosedBody paper_posed, build_character(paper));
  Recorded reach{segment, std::move(motion), person, std::move(posed), std::move(paper_posed)};
  reach.track = record_track(reach);
  const FitFrames frames{segment.first, segment.last};
  ClipFit fit = fit_clip(reach.posed, person.rig->rig, reach.motion, frames);
  ClipFit paper_fit = fit_clip(reach.paper, paper.rig->rig, reach.motion, frames);
  reach.fit_mean = fit.mean_distance;
  reach.paper_fit_mean = paper_fit.mean_distance;
  reach.track.angles = std::move(fit.clip);
  reach.track.paper_angles = std::move(paper_fit.clip);
  return reach;
}

Track joints_track(const BodyModel& body, const Clip& clip) {
  Track track;
  track.frame_time = clip.frame_time;
  track.angles = clip;
  std::array<const BodyNode*, kJoints> nodes{};
  for (const BodyNode& node : body.nodes()) {
    for (std::size_t j = 0; j < kBones.size(); ++j) {
      if (node.name == humanoid_bone_name(kBones[j])) nodes[j] = &node;
    }
    if (node.name == "right_hand_grip") nodes[right_grip] = &node;
  }
  Kinematics<double> placed(body);
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), placed);
    Joints joints;
    for (const BodyNode* node : nodes) joints.push_back(placed.point(node->link, node->point));
    track.joints.push_back(std::move(joints));
  }
  return track;
}

Track track_of(const Recorded& reach, const Clip& clip) {
  const PosedBody& posed = reach.posed;
  Track track = joints_track(posed, clip);
  const SkeletonMotion motion = skeleton_motion(posed, clip);
  const Rig rig = own_rig(*reach.person.landmarks, motion);
  track.paper_angles =
      fit_clip(reach.paper, rig, motion, {.first = 0, .last = clip.frames - 1}).clip;
  return track;
}

}  // namespace shigusa::bench
