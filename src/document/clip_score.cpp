// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/formats.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/score.hpp>

#include "body/anthropometry.hpp"
#include "character/character_file.hpp"
#include "character/character_heels.hpp"
#include "character/humanoid_request.hpp"
#include "clip_frames.hpp"
#include "core/say.hpp"
#include "criteria/built_in_criteria.hpp"
#include "criteria/motion_frame.hpp"
#include "criteria/support_margin.hpp"
#include "criteria/user_criteria.hpp"
#include "dynamics/contact_forces.hpp"
#include "formats/file_kind.hpp"
#include "formats/gltf_animation.hpp"
#include "generate/candidate.hpp"
#include "generate/posture_meter.hpp"
#include "kinematics/fit_clip.hpp"
#include "motion/low_pass.hpp"
#include "rig/find_humanoid.hpp"

namespace shigusa {
namespace {

// Margin (s) on either side of the scored frames that the smoothing needs.
constexpr double kAround = 0.35;
// A hand counts as reaching too if its travel exceeds this share of the longest.
constexpr double kGoesAsFar = 0.9;

// Contents of a motion file.
struct MotionFile {
  SkeletonMotion motion;
  HumanoidMap given;  // bone map given by the file itself
  std::vector<Message> doubts;
  std::vector<ActionTime> actions{};
};

Result<MotionFile> parse_motion(std::string_view bytes, const std::string& name,
                                const std::string& animation) {
  if (format_of_file(name) == FileFormat::bvh) {
    if (!animation.empty()) return holds_one_motion(name);
    SHG_TRY_ASSIGN(SkeletonMotion motion, parse_bvh(bytes, name));
    return MotionFile{std::move(motion), {}, {}};
  }
  SHG_TRY_ASSIGN(GltfMotion file, parse_gltf_animation(bytes, name, {.animation = animation}));
  MotionFile read{std::move(file.motion), file.character.humanoid, std::move(file.doubts)};
  for (const GltfActionTime& time : file.actions) read.actions.push_back({time.start, time.end});
  return read;
}

Result<void> check_clip_name(const std::string& name) {
  const std::optional<FileFormat> format = format_of_file(name);
  if (format && info_of(*format).clip) return {};
  return fail(
      ErrorCode::invalid_argument,
      say("no_clip", format_endings([](const FormatInfo& info) { return info.clip; }, "and")),
      name);
}

struct MeasuredFile {
  HumanoidMap map;
  MeasuredPerson person;
};

Result<MeasuredFile> measure(const MotionFile& file, int frame, const BoneRequest& bones,
                             const MeasureSettings& settings, const std::string& name) {
  const auto& [skeleton, clip] = file.motion;
  if (frame < 0 || frame >= clip.frames) {
    return fail(ErrorCode::invalid_argument, say("no_frame_of", frame, clip.frames - 1), name);
  }
  const std::vector<Transformd> world = world_transforms(skeleton, clip, frame);
  std::vector<std::string> nodes;
  for (const SkeletonNode& node : skeleton.nodes) nodes.push_back(node.name);
  SHG_TRY_ASSIGN(const HumanoidMap asked, requested_bones(bones, nodes, name));
  const Result<HumanoidMap> map = find_humanoid(skeleton, world, file.given, asked);
  if (!map) return fail(map.error().code, map.error().to_message(), name);
  Result<MeasuredPerson> person = measure_person(skeleton, world, *map, settings);
  if (!person) return fail(person.error().code, person.error().to_message(), name);
  return MeasuredFile{*map, std::move(*person)};
}

// Start landmarks of a body that is not taken from the clip.
Landmarks start_of(const CharacterSpec& character, const BodyModel& body) {
  if (character.landmarks) return *character.landmarks;
  return standing_landmarks(body.stature(),
                            character.source == "half_body" ? 0.0 : kStandingToeOut);
}

// Plays the frames first..last of a clip, with their neighbours, and shows them to the criteria as
// a rollout shows its own.
class ClipPlayer {
 public:
  ClipPlayer(const BodyModel& body, const CriteriaContext& context,
             const CriteriaSettings& criteria)
      : body_(body),
        placed_(body),
        work_(body),
        criteria_(body, context, criteria),
        support_(body, context.start) {}

  Motion play(const Clip& clip, int first, int last) {
    const auto dofs = static_cast<std::size_t>(clip.dofs);
    Motion motion;
    motion.clip = {clip.dofs, last - first + 1, clip.frame_time, {}};
    std::vector<double> speeds(dofs);
    std::vector<double> accelerations(dofs);
    std::vector<double> torques(dofs);
    const double rate = 1.0 / clip.frame_time;
    for (int f = first; f <= last; ++f) {
      const std::span<const double> now = clip.frame(f);
      for (std::size_t d = 0; d < dofs; ++d) {
        const double gone = f > 0 ? now[d] - clip.frame(f - 1)[d] : 0.0;
        const double to_come = f + 1 < clip.frames ? clip.frame(f + 1)[d] - now[d] : gone;
        const double came = f > 0 ? gone : to_come;
        speeds[d] = (to_come + came) * (0.5 * rate);
        accelerations[d] = (to_come - came) * (rate * rate);
      }
      forward_kinematics<double>(body_, now, placed_);
      const Wrench<double> ground =
          inverse_dynamics<double>(body_, placed_, {speeds, accelerations}, work_, torques);
      bear_on_feet<double>(body_, placed_, now, ground, torques);
      const Vec3d com = centre_of_mass(body_, work_);
      const PlacedFrame<double> frame{{now, torques, com, speeds, accelerations, clip.frame_time},
                                      placed_,
                                      pressure(ground, floor_height(body_))};
      criteria_.add(frame);
      support_.add(frame);
      motion.clip.angles.insert(motion.clip.angles.end(), now.begin(), now.end());
      motion.torques.insert(motion.torques.end(), torques.begin(), torques.end());
      motion.centre_of_mass.push_back(com);
    }
    return motion;
  }

  [[nodiscard]] const BuiltInCriteria<double>& criteria() const { return criteria_; }
  [[nodiscard]] const SupportMeter& support() const { return support_; }

 private:
  const BodyModel& body_;
  Kinematics<double> placed_;
  DynamicsWorkspace<double> work_;
  BuiltInCriteria<double> criteria_;
  SupportMeter support_;
};

Score summed(const BuiltInCriteria<double>& criteria, const BodyModel& body, const Motion& motion,
             const CriteriaSettings& settings) {
  Score score;
  criteria.visit_penalties([&score](std::string_view name, double weight, double penalty) {
    score.terms.push_back({std::string(name), weight, penalty});
  });
  for (const UserCriterion& user : settings.user) {
    score.terms.push_back({user.name, user.weight, penalties_of(user, body, {&motion, 1})[0]});
  }
  for (const ScoreTerm& term : score.terms) score.total += term.weight * term.penalty;
  return score;
}

// Rig of a file's nodes, posed as in a frame.
Rig rig_of(const SkeletonMotion& motion, int frame, const MeasuredFile& measured) {
  const MeasuredPerson& person = measured.person;
  Rig rig{
      {}, measured.map, person.grip_nodes, person.placement, person.landmarks, person.landmarks};
  const auto& [skeleton, clip] = motion;
  rig.twists = find_twist_bones(skeleton, world_transforms(skeleton, clip, frame), measured.map);
  for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
    const LocalTransform& local = clip.frame(skeleton, frame)[i];
    rig.nodes.push_back({skeleton.nodes[i].parent, local.translation, local.rotation});
  }
  return rig;
}

// The motion on the body measured from the file.
Result<RecordedMotion> on_its_person(MotionFile file, const std::string& name,
                                     CharacterSpec character, int first) {
  const int frame = character.frame.value_or(first);
  SHG_TRY_ASSIGN(MeasuredFile measured,
                 measure(file, frame, character.map, {character.stature}, name));
  MeasuredPerson& person = measured.person;
  if (character.heels) {
    const auto world = world_transforms(file.motion.skeleton, file.motion.clip, frame);
    const MeasuredPerson at_rest = person;
    SHG_TRY(find_toes(world, measured.map, at_rest, name, person));
  }
  character.stature = person.stature;
  character.landmarks = person.landmarks;
  character.doubts = std::move(file.doubts);
  for (const auto* found : {&measured.map.doubts, &person.doubts}) {
    character.doubts.insert(character.doubts.end(), found->begin(), found->end());
  }
  auto rig = std::make_shared<const Rig>(rig_of(file.motion, frame, measured));
  SHG_TRY_ASSIGN(PosedBody body, build_character(character));
  return RecordedMotion{std::move(body), std::move(file.motion), std::move(rig),
                        std::move(file.actions)};
}

// The motion on another body. The file is scaled to its stature, by the person measured in the
// first frame.
Result<RecordedMotion> on_another_body(MotionFile file, const std::string& name,
                                       CharacterSpec character, int first) {
  SHG_TRY(measure_character(character, {}));
  SHG_TRY_ASSIGN(PosedBody posed, build_character(character));
  SHG_TRY_ASSIGN(const MeasuredFile measured,
                 measure(file, first, {}, {posed.body.stature()}, name));
  Rig rig = rig_of(file.motion, first, measured);
  rig.start = start_of(character, posed);
  return RecordedMotion{std::move(posed), std::move(file.motion),
                        std::make_shared<const Rig>(std::move(rig)), std::move(file.actions)};
}

void doubt(const ScoreSettings& settings, SmoothClip& result) {
  const ClipFit& fit = result.fit;
  for (const FootTravel& foot : fit.feet) {
    if (foot.travel <= kFootSteps) continue;
    const double travel_cm = 100.0 * foot.travel;
    result.doubts.push_back(foot.base ? say("base_travels", foot.foot, travel_cm)
                                      : say("foot_travels", foot.foot, travel_cm));
  }
  if (fit.mean_distance > kFollowsBadly) {
    result.doubts.push_back(say("joints_far", 100.0 * fit.mean_distance));
  }
  const Clip& clip = fit.clip;
  if (settings.cutoff > 0.0 && settings.cutoff * clip.frame_time >= kLowPassShare) {
    result.doubts.push_back(say("frames_too_few", 1.0 / clip.frame_time, settings.cutoff));
  }
}

// Hands that travel nearly as far as the one that travels farthest. A recording does not state its
// goals, and a free hand moves along with the trunk.
std::vector<int> reaching_hands(const BodyModel& body, const Clip& clip, int first, int last) {
  Kinematics<double> begin(body);
  Kinematics<double> end(body);
  forward_kinematics<double>(body, clip.frame(first), begin);
  forward_kinematics<double>(body, clip.frame(last), end);
  std::vector<std::pair<double, int>> ways;
  double farthest = 0.0;
  for (int e = 0; e < static_cast<int>(body.effectors().size()); ++e) {
    const Effector& hand = body.effector(e);
    if (hand.part.joint_kind != JointKind::hand || hand.limb_root < 0) continue;
    const double way = norm(end.point(hand.link, hand.point) - begin.point(hand.link, hand.point));
    ways.emplace_back(way, e);
    farthest = max(farthest, way);
  }
  std::vector<int> hands;
  for (const auto& [way, e] : ways) {
    if (way > kGoesAsFar * farthest) hands.push_back(e);
  }
  return hands;
}

}  // namespace

Result<RecordedMotion> read_recorded(const std::filesystem::path& path, CharacterSpec character,
                                     int first, const std::string& animation) {
  const std::string name = path.filename().string();
  SHG_TRY(check_clip_name(name));
  SHG_TRY_ASSIGN(const std::string bytes, read_character_bytes(path));
  if (character.source == path.string()) character.source = name;
  return parse_recorded(bytes, name, std::move(character), first, animation);
}

Result<RecordedMotion> parse_recorded(std::string_view bytes, const std::string& name,
                                      CharacterSpec character, int first,
                                      const std::string& animation) {
  if (is_robot(character)) {
    return fail(ErrorCode::invalid_argument, say("robot_not_scored", character.source),
                "character");
  }
  SHG_TRY(check_clip_name(name));
  SHG_TRY(check_file_kind(bytes, name));
  SHG_TRY_ASSIGN(MotionFile file, parse_motion(bytes, name, animation));
  const bool own = character.source == name;
  return own ? on_its_person(std::move(file), name, std::move(character), first)
             : on_another_body(std::move(file), name, std::move(character), first);
}

Result<SmoothClip> smooth_clip(const RecordedMotion& recorded, const ScoreSettings& settings) {
  const SkeletonClip& clip = recorded.motion.clip;
  const int last = settings.last.value_or(clip.frames - 1);
  if (settings.first < 0 || last < settings.first || last >= clip.frames) {
    return fail(ErrorCode::invalid_argument,
                say("frames_none", settings.first, last, clip.frames - 1), "frames");
  }
  if (!(clip.frame_time > 0.0)) {
    return fail(ErrorCode::invalid_argument, say("no_speeds", clip.frame_time), "clip");
  }
  if (!(settings.cutoff >= 0.0) || !is_finite(settings.cutoff)) {
    return fail(ErrorCode::invalid_argument, say("smoothing_range", settings.cutoff), "smoothing");
  }
  const int around = static_cast<int>(min(kAround / clip.frame_time, 1000.0)) + 1;
  SmoothClip smooth;
  smooth.fit = fit_clip(recorded, *recorded.rig, recorded.motion, {settings.first, last, around});
  smooth.clip = smooth.fit.clip;
  if (settings.cutoff > 0.0) low_pass(smooth.clip, settings.cutoff);
  smooth.first = smooth.fit.before;
  smooth.last = smooth.first + last - settings.first;
  doubt(settings, smooth);
  return smooth;
}

ClipScore score_frames(const BodyModel& body, CriteriaContext context, const SmoothClip& smooth,
                       const CriteriaSettings& criteria) {
  if (context.effectors.empty()) {
    context.effectors = reaching_hands(body, smooth.clip, smooth.first, smooth.last);
  }
  ClipPlayer player(body, context, criteria);
  ClipScore result;
  result.motion = player.play(smooth.clip, smooth.first, smooth.last);
  result.score = summed(player.criteria(), body, result.motion, criteria);
  result.measures = measure_motion(body, result.motion, context);
  // the player's meter saw the surrounding frames too
  result.measures.support = player.support().margins();
  return result;
}

Result<ClipScore> score_clip(const RecordedMotion& recorded, const ScoreSettings& settings) {
  SHG_TRY_ASSIGN(SmoothClip smooth, smooth_clip(recorded, settings));
  ClipScore result =
      score_frames(recorded.body, {.start = recorded.home}, smooth, settings.criteria);
  PostureMeter meter(recorded.body, recorded.home, 0);
  result.final_posture = meter.measure(result.motion.clip.frame(result.motion.clip.frames - 1));
  if (settings.ergonomics) {
    SHG_TRY_ASSIGN(result.cost, motion_cost({recorded, result.motion}, *settings.ergonomics));
  }
  result.fit = std::move(smooth.fit);
  result.doubts = std::move(smooth.doubts);
  return result;
}

}  // namespace shigusa
