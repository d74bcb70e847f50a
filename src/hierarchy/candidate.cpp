// SPDX-License-Identifier: MIT
#include "candidate.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace shigusa {

std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip) {
  std::vector<LimitExcess> result;
  for (int d = 0; d < body.dof_count(); ++d) {
    const auto k = static_cast<std::size_t>(d);
    double excess = 0.0;
    for (int f = 0; f < clip.frames; ++f) {
      const std::span<const double> angles = clip.frame(f);
      excess = max(excess, angles[k] - upper_limit(body, d, angles));
      excess = max(excess, body.dof(d).lower - angles[k]);
    }
    // less than a tenth of a degree is nothing that anyone sees
    if (excess > radians(0.1)) result.push_back({body.dof(d).name, excess});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const LimitExcess& a, const LimitExcess& b) { return a.excess > b.excess; });
  return result;
}

namespace {

PathKind path_kind(const ReachProblem& problem, const EffectorPath& path,
                   const Parameters& parameters) {
  if (!problem.follow_path) return PathKind::free;
  if (path.detour != Vec3d{}) return PathKind::detour;
  return parameters.posture.bow == 0.0 && parameters.posture.sway == 0.0 ? PathKind::straight
                                                                         : PathKind::bowed;
}

double frame_distance(const Clip& a, const Clip& b, int frame) {
  double squares = 0.0;
  for (int d = 0; d < a.dofs; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const double difference = a.frame(frame)[k] - b.frame(frame)[k];
    squares += difference * difference;
  }
  return sqrt(squares / a.dofs);
}

}  // namespace

Candidate make_candidate(const Task& task, const ReachProblem& problem,
                         const Parameters& parameters, RolledOut rolled) {
  const BodyModel& body = task.body;
  Candidate candidate;
  candidate.parameters = parameters;
  candidate.score = score_motion(body, rolled.motion, task_criteria(task));
  for (std::size_t g = 0; g < task.goals.size(); ++g) {
    const auto index = static_cast<std::size_t>(problem.goals[g].effector);
    const Effector& effector = body.effectors()[index];
    const Vec3d reached = rolled.motion.effectors[g].back();
    const Vec3d goal = task.goals[g].position;
    candidate.goals.push_back({effector.name, effector.node, goal, reached, norm(goal - reached),
                               path_kind(problem, problem.goals[g].path, parameters)});
  }
  candidate.path_error = rolled.outcome.path_error;
  for (const Foot& foot : body.feet()) {
    // the base cannot move; what another foot does was measured in every frame
    const double slide = foot.link == kBaseLink ? 0.0 : rolled.outcome.contact_slide;
    candidate.contacts.push_back({foot.name, foot.node, slide});
  }
  candidate.over_limit = limit_excess(body, rolled.motion.clip);
  const Clip& clip = rolled.motion.clip;
  candidate.collides = deepest_collision(body, rolled.motion.clip, task_criteria(task).collision);
  candidate.final_posture =
      PostureMeter(body).measure(clip.frame(clip.frames - 1), problem.goals.front().effector);
  candidate.motion = std::move(rolled.motion);
  return candidate;
}

double miss_of(const Candidate& candidate) {
  double squares = 0.0;
  for (const GoalResult& goal : candidate.goals) squares += goal.error * goal.error;
  return sqrt(squares);
}

double ranking(const Score& score) {
  return is_finite(score.total) ? score.total : std::numeric_limits<double>::infinity();
}

double largest_distance(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (int f = 0; f < a.frames; ++f) largest = max(largest, frame_distance(a, b, f));
  return largest;
}

double final_distance(const Clip& a, const Clip& b) { return frame_distance(a, b, a.frames - 1); }

}  // namespace shigusa
