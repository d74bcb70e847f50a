// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/body/anthropometry.hpp>
#include <shigusa/dynamics/contact_forces.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/motion/low_pass.hpp>
#include <shigusa/project/clip_score.hpp>

#include "hierarchy/candidate.hpp"

namespace shigusa {
namespace {

// What smoothing sees on either side of the frames that are scored (s).
constexpr double kAround = 0.35;

// The landmarks of the body that is no part of the clip, in its start posture.
Landmarks start_of(const CharacterSpec& character, const BodyModel& body) {
  if (character.landmarks) return *character.landmarks;
  return standing_landmarks(body.stature(),
                            character.source == "half_body" ? 0.0 : kStandingToeOut);
}

// Goes through the frames first..last of a clip with what comes before and after them, and shows
// them to the criteria as a rollout shows its own.
class ClipPlayer {
 public:
  ClipPlayer(const BodyModel& body, const CriteriaSettings& criteria)
      : body_(body), placed_(body), work_(body), criteria_(body, criteria) {}

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
          inverse_dynamics<double>(body_, placed_, speeds, accelerations, work_, torques);
      if (body_.feet().size() == 2) {
        share_ground_wrench<double>(body_, placed_, ground, body_.feet()[0], body_.feet()[1],
                                    torques);
      }
      const Vec3d com = centre_of_mass(body_, work_);
      criteria_.add({now, torques, com, speeds, accelerations, &placed_, clip.frame_time});
      motion.clip.angles.insert(motion.clip.angles.end(), now.begin(), now.end());
      motion.torques.insert(motion.torques.end(), torques.begin(), torques.end());
      motion.centre_of_mass.push_back(com);
    }
    return motion;
  }

  [[nodiscard]] const BuiltInCriteria<double>& criteria() const { return criteria_; }

 private:
  const BodyModel& body_;
  Kinematics<double> placed_;
  DynamicsWorkspace<double> work_;
  BuiltInCriteria<double> criteria_;
};

Score summed(const BuiltInCriteria<double>& criteria, const BodyModel& body, const Motion& motion,
             const CriteriaSettings& settings) {
  Score score;
  criteria.visit_penalties([&score](const char* name, double weight, double penalty) {
    score.terms.push_back({name, weight, penalty});
  });
  for (const UserCriterion& user : settings.user) {
    score.terms.push_back(
        {user.name, user.weight, clamp(user.value(body, motion) / user.scale, 0.0, 1.0)});
  }
  for (const ScoreTerm& term : score.terms) score.total += term.weight * term.penalty;
  return score;
}

void doubt(const ScoreSettings& settings, ClipScore& result) {
  const ClipFit& fit = result.fit;
  for (const FootTravel& foot : fit.feet) {
    if (foot.travel <= kFootSteps) continue;
    result.doubts.push_back(fmt::format(
        "the {} moves by {:.1f} cm{}: score the frames in which the feet stand (--frames)",
        foot.foot, 100.0 * foot.travel,
        foot.base ? ", and the body stands on it, which cannot follow" : ""));
  }
  if (fit.mean_distance > kFollowsBadly) {
    result.doubts.push_back(
        fmt::format("the body's joints are {:.1f} cm from the recorded ones on average: another "
                    "motion is scored",
                    100.0 * fit.mean_distance));
  }
  const Clip& clip = fit.clip;
  if (settings.cutoff > 0.0 && settings.cutoff * clip.frame_time >= kLowPassShare) {
    result.doubts.push_back(fmt::format("{:.1f} frames a second are too few to smooth at {:g} Hz",
                                        1.0 / clip.frame_time, settings.cutoff));
  }
}

}  // namespace

Result<RecordedMotion> read_recorded(const std::filesystem::path& path, CharacterSpec character,
                                     int first) {
  const std::string name = path.filename().string();
  if (path.extension() != ".bvh" && path.extension() != ".BVH") {
    return fail(ErrorCode::invalid_argument, "is no clip that can be scored; allowed is .bvh",
                name);
  }
  if (is_robot(character)) {
    return fail(ErrorCode::invalid_argument,
                character.source + " is a robot; recorded motion is scored on people", "character");
  }
  const bool own = character.source == path.string();
  CharacterSpec person{.source = path.string(), .frame = first};
  if (own) {
    person = character;
  } else if (const auto measured = measure_character(character, {}); !measured) {
    return tl::unexpected(measured.error());
  } else if (const auto body = build_character(character); !body) {
    return tl::unexpected(body.error());
  } else {
    person.stature = body->stature();
  }
  if (const auto measured = measure_character(person, {}); !measured) {
    return tl::unexpected(measured.error());
  }
  Result<BodyModel> body = build_character(own ? person : character);
  if (!body) return tl::unexpected(body.error());
  Result<SkeletonMotion> motion = read_bvh(path);
  if (!motion) return tl::unexpected(motion.error());
  Rig rig = std::move(person.rig->rig);
  if (!own) rig.start = start_of(character, *body);
  return RecordedMotion{std::move(*motion), std::move(rig), std::move(*body)};
}

Result<ClipScore> score_clip(const RecordedMotion& recorded, const ScoreSettings& settings) {
  const SkeletonClip& clip = recorded.motion.clip;
  const int last = settings.last.value_or(clip.frames - 1);
  if (settings.first < 0 || last < settings.first || last >= clip.frames) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the frames {} to {} are none; the file has 0 to {}", settings.first,
                            last, clip.frames - 1),
                "frames");
  }
  if (!(clip.frame_time > 0.0)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("a frame time of {:g} s has no speeds; allowed is more than 0",
                            clip.frame_time),
                "clip");
  }
  if (!(settings.cutoff >= 0.0) || !is_finite(settings.cutoff)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {:g} Hz; allowed is 0, for none, or more", settings.cutoff),
                "smoothing");
  }
  const int around = static_cast<int>(min(kAround / clip.frame_time, 1000.0)) + 1;
  ClipScore result;
  result.fit =
      fit_clip(recorded.body, recorded.rig, recorded.motion, {settings.first, last, around});
  Clip smooth = result.fit.clip;
  if (settings.cutoff > 0.0) low_pass(smooth, settings.cutoff);
  const int first = result.fit.before;
  ClipPlayer player(recorded.body, settings.criteria);
  result.motion = player.play(smooth, first, first + last - settings.first);
  result.score = summed(player.criteria(), recorded.body, result.motion, settings.criteria);
  result.over_limit = limit_excess(recorded.body, result.motion.clip);
  result.collides =
      deepest_collision(recorded.body, result.motion.clip, settings.criteria.collision);
  PostureMeter meter(recorded.body);
  result.final_posture = meter.measure(result.motion.clip.frame(result.motion.clip.frames - 1), 0);
  doubt(settings, result);
  return result;
}

}  // namespace shigusa
