// SPDX-License-Identifier: MIT
#include "reflection.hpp"

#include <utility>
#include <vector>

#include "core/index.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "problem/mirror_request.hpp"

namespace shigusa {
namespace {

// The dof on the other side, and the sign of its angle there.
struct Fellow {
  int dof = 0;
  double sign = 1.0;
};

// The counterpart of each dof; none if some dof has no counterpart.
std::optional<std::vector<Fellow>> fellows_of(const BodyModel& body) {
  std::vector<Fellow> fellows;
  for (const Dof& dof : body.dofs()) {
    const auto other = body.find_dof(with_other_side(dof.name));
    if (!other) return std::nullopt;
    const bool of_middle = body.dof(*other).name == dof.name;
    fellows.push_back({*other, of_middle && dof.axis != Axis::x ? -1.0 : 1.0});
  }
  return fellows;
}

// Negligible differences of lengths (m) and start angles (rad) between the sides; the foot that is
// not the base slides by less.
constexpr double kAlike = 1e-4;

Clip reflected(const std::vector<Fellow>& fellows, const Clip& clip) {
  Clip image = clip;
  for (int f = 0; f < clip.frames; ++f) {
    const std::size_t begin = index(f) * index(clip.dofs);
    for (std::size_t d = 0; d < fellows.size(); ++d) {
      image.angles[begin + index(fellows[d].dof)] = fellows[d].sign * clip.angles[begin + d];
    }
  }
  return image;
}

// Whether a posture is the mirror image of another: each effector is at its counterpart's mirrored
// position.
bool is_image(const BodyModel& body, std::span<const double> angles,
              std::span<const double> of_angles) {
  Kinematics<double> image(body);
  Kinematics<double> of(body);
  forward_kinematics<double>(body, angles, image);
  forward_kinematics<double>(body, of_angles, of);
  for (int e = 0; e < body.effector_count(); ++e) {
    const Effector& effector = body.effector(e);
    const auto other = body.find_effector(with_other_side(effector.name));
    if (!other) continue;  // a foot that is the base is no effector
    const Effector& fellow = body.effector(*other);
    const Vec3d across_it = across(of.point(fellow.link, fellow.point));
    if (!(norm(image.point(effector.link, effector.point) - across_it) < kReachTolerance)) {
      return false;
    }
  }
  return true;
}

bool stands_alike(const BodyModel& body, std::span<const double> start,
                  const std::vector<Fellow>& fellows) {
  for (std::size_t d = 0; d < fellows.size(); ++d) {
    const double own = start[index(fellows[d].dof)];
    if (!(abs(own - fellows[d].sign * start[d]) < kAlike)) return false;
  }
  return is_image(body, start, start);
}

std::vector<std::vector<Vec3d>> paths_of_goals(const ReachProblem& problem, const Clip& clip) {
  const BodyModel& body = *problem.body;
  std::vector<std::vector<Vec3d>> paths(problem.asked());
  Kinematics<double> placed(body);
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), placed);
    for (std::size_t g = 0; g < paths.size(); ++g) {
      const Effector& effector = body.effector(problem.goals[g].effector);
      paths[g].push_back(placed.point(effector.link, effector.point));
    }
  }
  return paths;
}

// The link on the other side: link and dof numbers are the same.
int other_link(const std::vector<Fellow>& fellows, int link) {
  return link == kBaseLink ? kBaseLink : fellows[index(link)].dof;
}

RestingHand reflected(const BodyModel& body, const std::vector<Fellow>& fellows, RestingHand hand) {
  hand.effector = *body.find_effector(with_other_side(body.effector(hand.effector).name));
  if (hand.thigh) hand.thigh = other_link(fellows, *hand.thigh);
  for (Vec3d& place : hand.places) place = across(place);
  for (Vec3d& force : hand.forces) force = across(force);
  return hand;
}

}  // namespace

Task mirrored_task(Task task) {
  mirror_request(task);
  task.criteria.user.clear();
  task.fixed.reset();
  return task;
}

std::optional<Motion> reflection(const ReachProblem& problem, const Motion& of) {
  const BodyModel& body = *problem.body;
  const auto fellows = fellows_of(body);
  if (!fellows || !problem.start().velocities.empty() ||
      !stands_alike(body, problem.start().angles, *fellows))
    return std::nullopt;
  Clip image = reflected(*fellows, of.clip);
  const int last = image.frames - 1;
  if (!is_image(body, image.frame(last), of.clip.frame(last))) return std::nullopt;
  std::vector<RestingHand> resting;
  for (const RestingHand& hand : of.resting) resting.push_back(reflected(body, *fellows, hand));
  Motion motion = ClipDynamics(body).completed(std::move(image), std::move(resting));
  motion.effectors = paths_of_goals(problem, motion.clip);
  return motion;
}

}  // namespace shigusa
