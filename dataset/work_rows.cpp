// SPDX-License-Identifier: MIT
#include "work_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/index.hpp"
#include "motion_columns.hpp"

namespace shigusa {
namespace {

// A frame among others: the one before it, and its share of the way to the next.
struct Between {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0.0;
};

// The times of `frames` frames among those of a motion of `own` frames.
std::vector<Between> times_of(std::size_t frames, std::size_t own) {
  std::vector<Between> times;
  const std::size_t last = own - 1;
  for (std::size_t f = 0; f < frames; ++f) {
    const std::size_t before = f * last / (frames - 1);
    const double share =
        static_cast<double>(f * last - before * (frames - 1)) / static_cast<double>(frames - 1);
    times.push_back({before, std::min(before + 1, last), share});
  }
  return times;
}

// Rows of `width` numbers at other times.
std::vector<double> numbers_at(const std::vector<Between>& times, const std::vector<double>& from,
                               std::size_t width) {
  std::vector<double> to;
  if (from.empty()) return to;
  for (const auto& [before, after, share] : times) {
    for (std::size_t k = 0; k < width; ++k) {
      const double first = from[before * width + k];
      to.push_back(first + (from[after * width + k] - first) * share);
    }
  }
  return to;
}

}  // namespace

std::vector<std::string> action_names(const Request& task) {
  std::vector<std::string> names;
  for (const Action& action : task.actions) {
    const auto kind = kind_of(action);
    std::string name = fmt::format("{} {}", names.size() + 1, kind ? word_of(*kind) : "");
    for (const std::string& thing : {action.grasp, action.place, action.release}) {
      if (!thing.empty()) name += " " + thing;
    }
    for (const Goal& goal : action.goals) name += " " + goal.effector;
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> thing_names(const Request& task) {
  std::vector<std::string> names;
  for (const Thing& thing : task.things) names.push_back(thing.name);
  return names;
}

std::vector<double> numbers_in_frames(const std::vector<double>& series, std::size_t width,
                                      std::size_t frames) {
  if (series.empty()) return {};
  return numbers_at(times_of(frames, series.size() / width), series, width);
}

Candidate in_frames(const Candidate& candidate, std::size_t frames) {
  Candidate made = candidate;
  Motion& motion = made.motion;
  Clip& clip = motion.clip;
  const double duration = clip.duration();
  const std::vector<Between> times = times_of(frames, index(clip.frames));
  for (std::vector<double>* numbers : {&clip.angles, &motion.torques}) {
    *numbers = numbers_at(times, *numbers, index(clip.dofs));
  }
  std::vector<Vec3d> centres;
  for (const auto& [before, after, share] : times) {
    if (motion.centre_of_mass.empty()) break;
    const Vec3d& first = motion.centre_of_mass[before];
    centres.push_back(first + (motion.centre_of_mass[after] - first) * share);
  }
  motion.centre_of_mass = std::move(centres);
  for (ThingMotion& thing : made.things) {
    const ThingMotion own = thing;
    thing.poses.clear();
    for (const auto& [before, after, share] : times) {
      thing.poses.push_back(pose_at(own, static_cast<double>(before) + share));
    }
  }
  clip.frames = static_cast<int>(frames);
  clip.frame_time = duration / static_cast<double>(frames - 1);
  return made;
}

void add_work(const Request& task, const Candidate& candidate, Table& table) {
  for (std::size_t a = 0; a < task.actions.size(); ++a) {
    const bool done = a < candidate.actions.size();
    table["action_start_s"].push(done ? candidate.actions[a].start : kNoNumber);
    table["action_end_s"].push(done ? candidate.actions[a].end : kNoNumber);
    const Verdict verdict = done ? candidate.actions[a].judgement.verdict : Verdict::impossible;
    table["action_verdict"].push(static_cast<double>(verdict));
  }
  for (const Thing& thing : task.things) {
    table["thing_mass_kg"].push(thing.mass);
    table["thing_size_m"].push(thing.size);
  }
}

void add_present_actions(const Candidate& candidate, Column& into) {
  const Clip& clip = candidate.motion.clip;
  for (int f = 0; f < clip.frames; ++f) {
    std::size_t present = 0;
    for (std::size_t a = 1; a < candidate.actions.size(); ++a) {
      if (f * clip.frame_time >= candidate.actions[a].start) present = a;
    }
    into.push(static_cast<double>(present));
  }
}

void add_poses(const Candidate& candidate, Column& into) {
  for (std::size_t f = 0; f < index(candidate.motion.clip.frames); ++f) {
    for (const ThingMotion& thing : candidate.things) {
      into.push(thing.poses[f].translation);
      into.push(to_quat(thing.poses[f].rotation));
    }
  }
}

}  // namespace shigusa
