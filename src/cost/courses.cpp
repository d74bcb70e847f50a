// SPDX-License-Identifier: MIT
#include "cost/courses.hpp"

#include <algorithm>

#include "cost/posture_parts.hpp"

namespace shigusa {
namespace {

constexpr std::array kSides{Side::left, Side::right};

void add(int value, double weight, ScoreCourse& course) {
  course.worst = std::max(course.worst, value);
  course.mean += weight * value;
}

// `least`: the lowest level.
template <class Score, class Parts>
std::optional<PostureCourse> course_of(std::span<const FrameCost> frames,
                                       std::array<std::optional<Score>, 2> FrameCost::*scores,
                                       const std::array<SubScore<Parts>, 9>& parts, int least,
                                       int levels) {
  const std::vector<double> weights = time_weights(frames.size());
  PostureCourse course;
  course.above.resize(static_cast<std::size_t>(levels));
  bool any = false;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto& own = frames[f].*scores;
    std::optional<std::size_t> worse;
    for (std::size_t k = 0; k < kSides.size(); ++k) {
      if (!own[k]) continue;
      add(own[k]->score, weights[f], course.sides[k]);
      if (!worse || own[k]->score >= own[*worse]->score) worse = k;
    }
    if (!worse) continue;
    const Score& score = *own[*worse];
    if (!any || score.score > course.score.worst) {
      course.time = frames[f].time;
      course.side = kSides[*worse];
    }
    any = true;
    add(score.score, weights[f], course.score);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      int part = 0;
      for (const auto& side : own) {
        if (side) part = std::max(part, side->parts.*parts[p].part);
      }
      add(part, weights[f], course.parts[p]);
    }
    for (int level = least; level <= score.level; ++level) {
      course.above[static_cast<std::size_t>(level - least)] += weights[f];
    }
  }
  if (!any) return std::nullopt;
  return course;
}

// The angle that a part is judged by; empty where the body lacks it.
std::optional<double> angle_of(ZonePart part, std::size_t side, const PostureAngles& angles) {
  switch (part) {
    case ZonePart::trunk:
      if (angles.trunk) return angles.trunk->flexion;
      break;
    case ZonePart::trunk_aside:
      if (angles.trunk) return max(abs(angles.trunk->lateral), abs(angles.trunk->twist));
      break;
    case ZonePart::upper_arm:
      if (angles.arms[side]) return angles.arms[side]->elevation;
      break;
    case ZonePart::head:
      if (angles.neck) return angles.neck->flexion;
      break;
    case ZonePart::head_inclination:
      return angles.head;
  }
  return std::nullopt;
}

// The worst verdict on the zones of a course.
std::optional<ZoneVerdict> verdict_on(const ZoneCourse& course, const Ergonomics& ergonomics) {
  std::optional<ZoneVerdict> worst;
  const auto judge = [&](int zone, Recurrence recurrence) {
    const ZoneVerdict own = zone_verdict(course.part, zone, recurrence);
    if (own != ZoneVerdict::unknown && (!worst || own > *worst)) worst = own;
  };
  for (int zone = -1; zone <= 2; ++zone) {
    const auto z = static_cast<std::size_t>(zone + 1);
    if (course.longest[z] >= kHeldFrom) judge(zone, Recurrence::held);
    if (!ergonomics.moves_per_min || !(course.shares[z] > 0.0)) continue;
    judge(zone,
          *ergonomics.moves_per_min < kFrequentFrom ? Recurrence::rare : Recurrence::frequent);
  }
  return worst;
}

// Raises a peak to a value, if it is the first one or greater.
void raise(Peak& peak, double value, double time, bool first) {
  if (first || value > peak.value) peak = {value, time};
}

}  // namespace

std::vector<double> time_weights(std::size_t frames) {
  if (frames < 2) return std::vector<double>(frames, 1.0);
  std::vector<double> weights(frames, 1.0 / static_cast<double>(frames - 1));
  weights.front() *= 0.5;
  weights.back() *= 0.5;
  return weights;
}

std::optional<PostureCourse> reba_course(std::span<const FrameCost> frames) {
  return course_of(frames, &FrameCost::reba, kRebaParts, 0, kRebaLevels);
}

std::optional<PostureCourse> rula_course(std::span<const FrameCost> frames) {
  return course_of(frames, &FrameCost::rula, kRulaParts, 1, kRulaLevels);
}

std::vector<ZoneCourse> zone_courses(std::span<const FrameCost> frames, double frame_time,
                                     const Ergonomics& ergonomics) {
  const std::vector<double> weights = time_weights(frames.size());
  std::vector<ZoneCourse> courses;
  for (const auto& [part, word] : kEnumWords<ZonePart>) {
    const bool arm = part == ZonePart::upper_arm;
    for (std::size_t side = 0; side < (arm ? kSides.size() : 1); ++side) {
      ZoneCourse course{part};
      if (arm) course.side = kSides[side];
      bool any = false;
      std::size_t since = 0;
      int before = 0;
      for (std::size_t f = 0; f < frames.size(); ++f) {
        const std::optional<double> angle = angle_of(part, side, frames[f].angles);
        if (!angle) continue;
        course.greatest = any ? max(course.greatest, *angle) : *angle;
        const int zone = zone_of(part, *angle);
        if (!any || zone != before) since = f;
        before = zone;
        any = true;
        const auto z = static_cast<std::size_t>(zone + 1);
        course.shares[z] += weights[f];
        course.longest[z] = max(course.longest[z], static_cast<double>(f - since) * frame_time);
      }
      if (!any) continue;
      course.verdict = verdict_on(course, ergonomics);
      courses.push_back(course);
    }
  }
  return courses;
}

std::optional<BackCourse> back_course(std::span<const FrameCost> frames,
                                      const Ergonomics& ergonomics) {
  const std::vector<double> weights = time_weights(frames.size());
  BackCourse course;
  bool any = false;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const FrameCost& frame = frames[f];
    if (!frame.back_moment) continue;
    raise(course.moment, *frame.back_moment, frame.time, !any);
    course.mean_moment += weights[f] * *frame.back_moment;
    any = true;
    if (!frame.back) continue;
    const bool first = !course.forces;
    if (first) course.forces.emplace();
    BackForcesCourse& forces = *course.forces;
    raise(forces.compression, frame.back->compression, frame.time, first);
    raise(forces.shear, frame.back->shear, frame.time, first);
    forces.mean_compression += weights[f] * frame.back->compression;
    if (frame.back->compression > kBackActionLimit) forces.above_action += weights[f];
    if (frame.back->compression > kBackPermissible) forces.above_permissible += weights[f];
  }
  if (!any) return std::nullopt;
  if (course.forces && ergonomics.age && ergonomics.sex) {
    course.forces->limit = back_limit(*ergonomics.age, *ergonomics.sex);
  }
  return course;
}

}  // namespace shigusa
