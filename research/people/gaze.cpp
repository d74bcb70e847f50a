// SPDX-License-Identifier: MIT
#include "gaze.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "../experiments/report.hpp"
#include "criteria/head.hpp"
#include "random_tasks.hpp"

namespace shigusa::bench {
namespace {

constexpr int kTasks = 500;  // those of both hands are left out
constexpr double kNear = radians(15.0);

// End of a first choice.
struct Gaze {
  bool met = false;
  bool ahead = false;  // the goal is in front of the ankles
  double away = 0.0;   // rad, between where the head faces and the goal
  double chest = 0.0;  // rad, by which the chest is turned, and
  double hips = 0.0;   // of it the pelvis
};

// Yaw of a link's axis z from straight ahead (rad), positive to the left.
double turned(const Kinematics<double>& placed, int link) {
  const Vec3d faces = placed.link_rotation(link).cz;
  return std::atan2(faces.x, faces.z);
}

Gaze gaze_of(const Task& task) {
  const auto generation = generate(task);
  if (!generation || !generation->meets_goals()) return {};
  const BodyModel& body = task.body;
  const Clip& clip = generation->candidates.front().motion.clip;
  const HeadPoints points = head_points(body, task.home);
  Kinematics<double> placed(body);
  forward_kinematics<double>(body, clip.frame(clip.frames - 1), placed);
  const Vec3d& goal = task.goals.front().position;
  const Vec3d way = goal - placed.point(points.head_link, points.head);
  const Vec3d faces = placed.link_rotation(points.head_link).cz;
  return {true, goal.z > 0.0, std::atan2(norm(cross(faces, way)), dot(faces, way)),
          turned(placed, body.dof(*body.find_dof("neck.flexion")).parent),
          turned(placed, points.pelvis_link)};
}

// Goals of the right hand all around, at the distance of an arm with bent elbow from the body's
// axis.
constexpr double kAround = 0.5;                     // m
constexpr std::array kHeights{0.6, 1.0, 1.4, 1.7};  // m
struct Direction {
  const char* name;
  double azimuth;  // degrees to the right of ahead
};
constexpr std::array<Direction, 8> kDirections{{{"in front", 0.0},
                                                {"half right", 45.0},
                                                {"right", 90.0},
                                                {"right and behind", 135.0},
                                                {"behind", 170.0},
                                                {"half left", -45.0},
                                                {"left", -90.0},
                                                {"left and behind", -120.0}}};

Task task_around(const Direction& direction, double height) {
  TaskFile file;
  file.character.source = "human";
  const double azimuth = radians(direction.azimuth);
  file.goals = {
      {"right_hand", {-kAround * std::sin(azimuth), height, kAround * std::cos(azimuth)}}};
  Task task = make_task(file, {}).value();
  task.batch.threads = 1;
  return task;
}

std::string around_table() {
  constexpr int kGoals = static_cast<int>(kDirections.size() * kHeights.size());
  std::vector<Gaze> gazes(kGoals);
  parallel_for(kGoals, 0, [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    gazes[k] =
        gaze_of(task_around(kDirections[k / kHeights.size()], kHeights[k % kHeights.size()]));
  });
  Table table({"goals", "reached", "off, °", "most off, °", "chest turned, °", "pelvis, °"});
  for (std::size_t d = 0; d < kDirections.size(); ++d) {
    int met = 0;
    Gaze sum;
    double most = 0.0;
    for (std::size_t h = 0; h < kHeights.size(); ++h) {
      const Gaze& gaze = gazes[d * kHeights.size() + h];
      if (!gaze.met) continue;
      ++met;
      const double off = std::fmax(0.0, gaze.away - kEyesFree);
      sum.away += off;
      most = std::fmax(most, off);
      sum.chest += std::fabs(gaze.chest);
      sum.hips += std::fabs(gaze.hips);
    }
    const auto mean = [&](double of) {
      return met > 0 ? fmt::format("{:.0f}", degrees(of / met)) : std::string("–");
    };
    table.add({kDirections[d].name, fmt::format("{} of {}", met, kHeights.size()), mean(sum.away),
               fmt::format("{:.0f}", degrees(most)), mean(sum.chest), mean(sum.hips)});
  }
  return fmt::format(
             "\nThe same of goals for the right hand {:.0f} cm from the body's axis, each at "
             "{} heights from {:.1f} to {:.1f} m.\n\n",
             100.0 * kAround, kHeights.size(), kHeights.front(), kHeights.back()) +
         table.text();
}

}  // namespace

std::string gaze_section() {
  std::vector<Gaze> gazes(kTasks);
  parallel_for(kTasks, 0, [&](int i, int) {
    const Task task = hand_task(i);
    if (task.goals.size() == 1) gazes[static_cast<std::size_t>(i)] = gaze_of(task);
  });
  Table table({"goals", "motions", "eyes on the goal", "within 15° of it", "median off, °"});
  for (const bool all : {false, true}) {
    std::vector<double> off;
    int on = 0;
    int near = 0;
    for (const Gaze& gaze : gazes) {
      if (!gaze.met || !(all || gaze.ahead)) continue;
      off.push_back(std::fmax(0.0, gaze.away - kEyesFree));
      if (off.back() == 0.0) ++on;
      if (off.back() <= kNear) ++near;
    }
    const auto count = static_cast<double>(off.size());
    table.add({all ? "all" : "in front", std::to_string(off.size()), percent(on, count),
               percent(near, count), fmt::format("{:.0f}", degrees(median(off)))});
  }
  return "## Gaze\n\nFirst choices of the random tasks above that are of one hand: whether the "
         "head ends so that eyes, which turn by up to 35°, are on the goal.\n\n" +
         table.text() + around_table();
}

}  // namespace shigusa::bench
