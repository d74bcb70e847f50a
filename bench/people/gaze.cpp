// SPDX-License-Identifier: MIT
#include "gaze.hpp"

#include <fmt/format.h>

#include <cmath>
#include <shigusa/generate.hpp>
#include <shigusa/parallel.hpp>

#include "../experiments/report.hpp"
#include "criteria/head.hpp"
#include "random_tasks.hpp"

namespace shigusa::bench {
namespace {

constexpr int kTasks = 500;  // those of both hands are left out
constexpr double kNear = radians(15.0);

// How a first choice ends.
struct Gaze {
  bool met = false;
  bool ahead = false;  // the goal is in front of the ankles
  double away = 0.0;   // rad, between where the head faces and the goal
};

Gaze gaze_of(int index) {
  const Task task = hand_task(index);
  if (task.goals.size() > 1) return {};
  const auto generation = generate(task);
  if (!generation || !generation->meets_goals()) return {};
  const BodyModel& body = task.body;
  const Clip& clip = generation->candidates.front().motion.clip;
  const HeadPoints points = head_points(body);
  Kinematics<double> placed(body);
  forward_kinematics<double>(body, clip.frame(clip.frames - 1), placed);
  const Vec3d& goal = task.goals.front().position;
  const Vec3d way = goal - placed.point(points.head_link, points.head);
  const Vec3d faces = placed.link_rotation(points.head_link).cz;
  return {true, goal.z > 0.0, std::atan2(norm(cross(faces, way)), dot(faces, way))};
}

}  // namespace

std::string gaze_section() {
  std::vector<Gaze> gazes(kTasks);
  parallel_for(kTasks, 0, [&](int i, int) { gazes[static_cast<std::size_t>(i)] = gaze_of(i); });
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
         table.text();
}

}  // namespace shigusa::bench
