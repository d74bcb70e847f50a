// SPDX-License-Identifier: MIT
#include "task_supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <utility>

#include "body/capsules.hpp"
#include "core/say.hpp"
#include "math/axes.hpp"
#include "problem/reachability.hpp"
#include "rollout/rollout.hpp"

namespace shigusa {
namespace {

// Share of the way from hip to knee at which the middle of the hand rests, so that the fingers end
// just above the knee (Kingma et al., J. Biomechanics 49 (2016) 881-889).
constexpr double kAlongThigh = 0.65;
// m; distance of a hand from the edges of a box, if it is wide enough.
constexpr double kFromEdge = 0.04;
// Distance, as a share of the arm's length, below the shoulder of the point to which the hand rests
// nearest.
constexpr double kBelowShoulder = 0.4;
// Possible arrivals of hands as shares of the duration, the earliest first. A hand that arrives at
// 0.7 has covered 0.99 of its way at 0.6.
constexpr double kArrivals[] = {0.7, 0.8, 0.9};

tl::unexpected<Error> wrong_support(const Support& support, Message message) {
  return fail(ErrorCode::invalid_argument, std::move(message),
              "support of " + support.effector.substr(0, 80));
}

Result<int> hand_index(const BodyModel& body, const Support& support) {
  const auto index = body.find_effector(support.effector);
  if (index && *index < static_cast<int>(body.effectors().size())) return *index;
  std::vector<std::string> names;
  for (const Effector& hand : body.effectors()) names.push_back(hand.name);
  return fail(ErrorCode::not_found, unknown_name("hand", support.effector, names), "support");
}

Result<void> check_free(const Task& task, const Support& support, int hand) {
  for (const Goal& goal : task.goals) {
    const auto effector = task.body.find_effector(goal.effector);
    if (!effector) continue;
    if (!task.body.moves(task.body.effector(hand).limb_root, task.body.effector(*effector).link)) {
      continue;
    }
    return wrong_support(support, say("arm_has_goal", goal.effector));
  }
  return {};
}

const Capsule* thigh_of(const BodyModel& body, const Effector& hand) {
  if (body.is_robot() || !hand.part.side) return nullptr;
  const std::string_view name =
      body_part_name(*hand.part.side == Side::left ? BodyPart::left_thigh : BodyPart::right_thigh);
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.name == name && capsule.link != kBaseLink) return &capsule;
  }
  return nullptr;
}

// Puts a hand on the front of the thigh, slightly above the knee.
void put_on_thigh(const Capsule& thigh, double thickness, HandSupport& support) {
  const Vec3d line = thigh.to - thigh.from;
  const Vec3d along = normalized(line);
  const Vec3d ahead{0, 0, 1};
  support.carrier = thigh.link;
  support.normal = normalized(ahead - along * dot(along, ahead));
  const double radius = thigh.radius + kAlongThigh * taper_of(thigh);
  support.place = thigh.from + line * kAlongThigh + support.normal * (radius + thickness);
}

const Obstacle* obstacle_named(const Task& task, const std::string& name) {
  for (const Obstacle& obstacle : task.obstacles) {
    if (obstacle.name == name) return &obstacle;
  }
  return nullptr;
}

// A point on a surface.
struct SurfacePlace {
  Vec3d at{};  // m, world: of a hand of some thickness that lies on it
  Vec3d normal{};
};

// The points of an obstacle's surface nearest to a given point (m, world), one on each of its sides
// that faces it, level ones first; for a round obstacle only the nearest.
std::vector<SurfacePlace> places_near(const Obstacle& obstacle, const Vec3d& point,
                                      double thickness) {
  const Mat3d axes = to_matrix(obstacle.rotation);
  const Vec3d half = obstacle.size * 0.5;
  const Vec3d p = transpose_times(axes, point - obstacle.position);
  const double off = obstacle.radius + thickness;
  std::vector<SurfacePlace> places;
  const auto add = [&](const Vec3d& local, const Vec3d& normal) {
    places.push_back({obstacle.position + axes * (local + normal * off), axes * normal});
  };
  if (half.x <= 0.0 || half.y <= 0.0 || half.z <= 0.0) {
    Vec3d core{};
    for (int k = 0; k < 3; ++k) core[k] = clamp(p[k], -half[k], half[k]);
    add(core, normalized(p - core));
    return places;
  }
  for (int k = 0; k < 3; ++k) {
    Vec3d local{};
    for (int j = 0; j < 3; ++j) {
      const double most = max(half[j] - kFromEdge, 0.0);
      local[j] = clamp(p[j], -most, most);
    }
    Vec3d normal{};
    normal[k] = p[k] < 0.0 ? -1.0 : 1.0;
    local[k] = normal[k] * half[k];
    const bool faces = abs(p[k]) > half[k];
    if (faces) add(local, normal);
  }
  if (places.empty()) {  // inside the obstacle: the upper side
    const Vec3d normal = nearest_axis(transpose_times(axes, Vec3d{0, 1, 0}));
    const int k = main_axis(normal);
    Vec3d local = p;
    local[k] = normal[k] * half[k];
    add(local, normal);
  }
  std::stable_sort(places.begin(), places.end(), [&](const SurfacePlace& a, const SurfacePlace& b) {
    const bool a_level = a.normal.y > 0.7;
    const bool b_level = b.normal.y > 0.7;
    if (a_level != b_level) return a_level;
    return norm(a.at - point) < norm(b.at - point);
  });
  return places;
}

void put_on(const SurfacePlace& place, HandSupport& support) {
  support.place = place.at;
  support.normal = place.normal;
}

tl::unexpected<Error> out_of_reach(const Support& support, double distance) {
  return wrong_support(
      support, say("hand_does_not_reach", support.on.substr(0, 80), Millimetres{1e3 * distance}));
}

// Puts a hand on the first side of its obstacle in reach; `free`: the posture that meets the goals
// without supports.
Result<void> settle_on(const Obstacle& obstacle, const Support& asked,
                       const Kinematics<double>& free, ReachProblem& problem,
                       HandSupport& support) {
  const Effector& hand = problem.body->effector(support.effector);
  Vec3d point = free.origin[index(hand.limb_root)];
  point.y -= kBelowShoulder * problem.body->limb_length(hand);
  const double thickness = half_thickness(*problem.body, hand);
  double left = 0.0;
  for (const SurfacePlace& place : places_near(obstacle, point, thickness)) {
    put_on(place, support);
    const ClosestReach reach = closest_reach(problem);
    if (reach.reached()) return {};
    if (left == 0.0 || reach.distance < left) left = reach.distance;
  }
  return out_of_reach(asked, left);
}

// Sets the earliest arrival of the hands that the motion of uniform weights allows.
void settle_arrival(ReachProblem& problem) {
  const std::vector<double> uniform(problem.body->dofs().size(), 1.0);
  for (const double arrives : kArrivals) {
    for (HandSupport& support : problem.supports) support.arrives = arrives;
    Rollout<double> rollout(problem);
    if (rollout.run(uniform, [](const PlacedFrame<double>&) {}).met()) return;
  }
}

}  // namespace

double half_thickness(const BodyModel& body, const Effector& hand) {
  double half = 0.0;
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.link == hand.link) half = max(half, min(capsule.radius, capsule.to_radius));
  }
  return half;
}

Result<void> check_supports(const Request& request) {
  if (request.supports.empty()) return {};
  if (request.preset != Preset::flat) {
    return fail(ErrorCode::unsupported, say("no_resting", word_of(request.preset)), "support");
  }
  if (request.generator == MotionGenerator::weighted_ik) return {};
  return fail(ErrorCode::unsupported, say("generator_no_resting", word_of(request.generator)),
              "support");
}

Result<std::vector<HandSupport>> make_supports(const Task& task, const Kinematics<double>& start) {
  SHG_TRY(check_supports(task));
  std::vector<HandSupport> supports;
  for (const Support& asked : task.supports) {
    SHG_TRY_ASSIGN(const int index, hand_index(task.body, asked));
    SHG_TRY(check_free(task, asked, index));
    for (const HandSupport& earlier : supports) {
      if (earlier.effector == index) return wrong_support(asked, say("second_support"));
    }
    const Effector& hand = task.body.effector(index);
    HandSupport support{.name = asked.effector, .effector = index};
    const double thickness = half_thickness(task.body, hand);
    const Vec3d at = start.point(hand.link, hand.point);
    if (const Obstacle* obstacle = obstacle_named(task, asked.on)) {
      put_on(places_near(*obstacle, at, thickness).front(), support);
    } else if (asked.on == kThighPlace) {
      const Capsule* thigh = thigh_of(task.body, hand);
      if (thigh == nullptr) {
        return wrong_support(asked, say("no_thigh", task.body.name()));
      }
      put_on_thigh(*thigh, thickness, support);
    } else {
      std::vector<std::string> places{std::string(kThighPlace)};
      for (const Obstacle& known : task.obstacles) places.push_back(known.name);
      return fail(ErrorCode::not_found, unknown_name("place", asked.on, places),
                  "support of " + asked.effector);
    }
    supports.push_back(std::move(support));
  }
  return supports;
}

std::vector<RestingPlace> resting_places(const Task& task) {
  std::vector<RestingPlace> places;
  for (const Support& support : task.supports) {
    const auto effector = task.body.find_effector(support.effector);
    if (!effector) continue;
    const Effector& hand = task.body.effector(*effector);
    const Capsule* thigh = thigh_of(task.body, hand);
    const bool on_obstacle = obstacle_named(task, support.on) != nullptr;
    if (!on_obstacle && thigh == nullptr) continue;
    places.push_back({hand.link, on_obstacle ? support.on : thigh->name});
  }
  return places;
}

Result<void> settle_supports(const Task& task, ReachProblem& problem) {
  if (problem.supports.empty()) return {};
  ReachProblem without = problem;
  without.supports.clear();
  const ClosestReach free = closest_reach(without);
  if (!free.reached()) {
    return fail(ErrorCode::invalid_argument, say("support_out_of_reach"), "support");
  }
  Kinematics<double> placed(task.body);
  forward_kinematics<double>(task.body, free.angles, placed);
  for (std::size_t k = 0; k < problem.supports.size(); ++k) {
    // one after the other, with those before it
    ReachProblem up_to = problem;
    up_to.supports.resize(k + 1);
    const Support& asked = task.supports[k];
    if (const Obstacle* obstacle = obstacle_named(task, asked.on)) {
      SHG_TRY(settle_on(*obstacle, asked, placed, up_to, up_to.supports[k]));
      problem.supports[k] = up_to.supports[k];
      continue;
    }
    const ClosestReach reach = closest_reach(up_to);
    if (!reach.reached()) return out_of_reach(asked, reach.distance);
  }
  settle_arrival(problem);
  return {};
}

}  // namespace shigusa
