// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "rollout/rollout.hpp"
#include "support/bodies.hpp"

// Reaching problems for tests, and the requirements on their motions, measured from the joint
// angles alone.
namespace shigusa::testing_support {

inline const PosedBody& half() {
  static const PosedBody body = half_body();
  return body;
}
inline const PosedBody& full() {
  static const PosedBody body = full_body();
  return body;
}

// A reach of one effector from the start posture in 1 s.
inline ReachProblem reach_with(const PosedBody& body, const char* effector, const Vec3d& goal) {
  ReachProblem problem;
  problem.body = &body.body;
  problem.context.start = body.home;
  problem.goals.push_back({body.body.find_effector(effector).value(),
                           {effector_position(body, body.home.angles, effector), goal}});
  return problem;
}

// A goal for the right hand within reach of its arm alone, neither stretched nor folded up: 0.2 to
// 0.5 m from the shoulder, like the whole path to it.
inline Vec3d near_goal(const PosedBody& body, Random& random) {
  const auto shoulder =
      static_cast<std::size_t>(body.body.find_dof("right_shoulder.flexion").value());
  const Vec3d centre = placed(body, body.home.angles).origin[shoulder];
  const Vec3d from = effector_position(body, body.home.angles, "right_hand");
  for (;;) {
    const Vec3d goal = centre + random_direction(random) * random.uniform(0.2, 0.5);
    const Vec3d way = goal - from;
    const double nearest = clamp(dot(centre - from, way) / dot(way, way), 0.0, 1.0);
    if (norm(from + way * nearest - centre) > 0.2) return goal;
  }
}

// (dofs) weights of the paper's code 1..15
inline Parameters random_parameters(const BodyModel& body, Random& random) {
  Parameters parameters = uniform_parameters(body);
  for (std::size_t d = 0; d < body.dofs().size(); ++d) {
    parameters.values[d] = 1.0 + random.below(15);
  }
  return parameters;
}

// A body with weights and a goal near its shoulder.
struct RandomReach {
  const PosedBody& posed;
  ReachProblem problem;
  Parameters parameters;

  RandomReach(const PosedBody& b, std::uint64_t seed) : posed(b) {
    Random random(seed);
    problem = reach_with(b, "right_hand", near_goal(b, random));
    parameters = random_parameters(b, random);
  }

  // Every locked joint has its start angle in every frame.
  [[nodiscard]] bool keeps_locked(const Clip& clip) const {
    for (std::size_t i = 0; i < clip.angles.size(); ++i) {
      const std::size_t d = i % posed.body.dofs().size();
      if (parameters.locked[d] && clip.angles[i] != posed.home.angles[d]) return false;
    }
    return true;
  }
};

// The full body with a goal within or beyond reach, weights up to a million times apart, and locks
// until nothing can move.
struct WildReach {
  ReachProblem problem;
  Parameters parameters = uniform_parameters(full());

  explicit WildReach(std::uint64_t seed) {
    Random random(seed);
    const double x = random.uniform(-1.5, 1.5);
    const double y = random.uniform(0.0, 2.5);
    problem = reach_with(full(), "right_hand", {x, y, random.uniform(-1.5, 1.5)});
    const double locked = random.uniform(0.0, 0.9);
    const double spread = random.uniform(0.0, 3.0);
    for (std::size_t d = 0; d < full().body.dofs().size(); ++d) {
      parameters.values[d] = std::pow(10.0, random.uniform(-spread, spread));
      parameters.locked[d] = random.chance(locked);
    }
  }
};

// A clip's actual motion, by forward kinematics of each frame.
struct MeasuredMotion {
  double start_error = 0.0;    // rad, largest difference of the first frame from the start posture
  double path_error = 0.0;     // m, of any goal's effector at any frame
  double goal_error = 0.0;     // m, of any goal's effector at the last frame
  double contact_slide = 0.0;  // m, of any foot
  double contact_tilt = 0.0;   // rad, of any foot
  double largest_step = 0.0;   // rad, of any angle from one frame to the next
  bool finite = true;

  MeasuredMotion(const ReachProblem& problem, const Clip& clip) {
    const BodyModel& body = *problem.body;
    const std::vector<double>& first = problem.start().angles;
    const Kinematics<double> start = placed(body, first);
    for (std::size_t d = 0; d < body.dofs().size(); ++d) {
      start_error = std::fmax(start_error, std::fabs(clip.frame(0)[d] - first[d]));
    }
    for (const double angle : clip.angles) finite = finite && std::isfinite(angle);
    for (int f = 0; f < clip.frames; ++f) {
      const Kinematics<double> now = placed(body, clip.frame(f));
      measure_hands(problem, now, f, clip.frames - 1);
      measure_feet(body, start, now);
      for (std::size_t d = 0; f > 0 && d < body.dofs().size(); ++d) {
        const double step = clip.frame(f)[d] - clip.frame(f - 1)[d];
        largest_step = std::fmax(largest_step, std::fabs(step));
      }
    }
  }

 private:
  void measure_hands(const ReachProblem& problem, const Kinematics<double>& now, int frame,
                     int last) {
    for (const ReachGoal& goal : problem.goals) {
      const Effector& effector = problem.body->effectors()[static_cast<std::size_t>(goal.effector)];
      const Vec3d at = now.point(effector.link, effector.point);
      const Vec3d wanted = goal.path.at(static_cast<double>(frame) / last);
      path_error = std::fmax(path_error, norm(at - wanted));
      if (frame == last) goal_error = std::fmax(goal_error, norm(at - goal.path.goal));
    }
  }

  void measure_feet(const BodyModel& body, const Kinematics<double>& start,
                    const Kinematics<double>& now) {
    for (const Foot& foot : body.feet()) {
      for (const Vec3d& corner : foot.outline) {
        const Vec3d moved = now.point(foot.link, corner) - start.point(foot.link, corner);
        contact_slide = std::fmax(contact_slide, norm(moved));
      }
      const Mat3d turned = now.link_rotation(foot.link) * transpose(start.link_rotation(foot.link));
      contact_tilt = std::fmax(contact_tilt, norm(rotation_vector(turned)));
    }
  }
};

}  // namespace shigusa::testing_support
