// SPDX-License-Identifier: MIT
#include "character_heels.hpp"

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/say.hpp"
#include "human/human_frames.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {
namespace {

// Least distance (m) of a toes' joint ahead of the ankle, and behind the tip.
constexpr double kShortestPart = 0.02;

}  // namespace

Result<void> check_heels(const CharacterSpec& spec, BodyExtent extent) {
  if (spec.heels && extent != BodyExtent::human) {
    return fail(ErrorCode::invalid_argument, say("heels_of_human"), "character");
  }
  if (spec.heels && spec.seat) {
    return fail(ErrorCode::invalid_argument, say("heels_who_sit"), "character");
  }
  return {};
}

Result<void> find_toes(const std::vector<Transformd>& world, const HumanoidMap& map,
                       const MeasuredPerson& person, const std::string& file,
                       MeasuredPerson& start) {
  const HumanFrames rest_frames = human_frames(person.landmarks);
  const HumanFrames start_frames = human_frames(start.landmarks);
  for (const Side side : kBothSides) {
    const HumanoidBone bone =
        side == Side::left ? HumanoidBone::left_toes : HumanoidBone::right_toes;
    if (map[bone] < 0) {
      return fail(ErrorCode::invalid_argument,
                  say("heels_no_toes", humanoid_bone_name(bone), humanoid_bone_name(bone)), file);
    }
    const Vec3d at = person.placement.to_world(world[index(map[bone])].translation);
    Landmarks::Leg& leg = start.landmarks.leg(side);
    const Vec3d in_foot =
        transpose_times(rest_frames.leg(side).foot, at - person.landmarks.leg(side).ankle);
    leg.toes = leg.ankle + start_frames.leg(side).foot * in_foot;
    const Vec3d sole = leg.toe - leg.ankle;
    const Vec3d ahead = normalized(Vec3d{sole.x, 0.0, sole.z}, {0, 0, 1});
    const double to_joint = dot(*leg.toes - leg.ankle, ahead);
    if (!(to_joint >= kShortestPart)) {
      return fail(ErrorCode::invalid_argument,
                  say("heels_short_toes", humanoid_bone_name(bone), Metres{to_joint},
                      Metres{kShortestPart}),
                  file);
    }
    if (dot(leg.toe - *leg.toes, ahead) >= kShortestPart) continue;
    leg.toe = *leg.toes + ahead * (to_joint * (1.0 / kToesShare - 1.0));
    leg.toe.y = min(leg.toes->y, max(sole.y + leg.ankle.y, 0.0));
    start.doubts.push_back(say("toes_guessed", humanoid_bone_name(bone)));
  }
  return {};
}

}  // namespace shigusa
