// SPDX-License-Identifier: MIT
#include "work/check_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "body/seat.hpp"
#include "core/say.hpp"
#include "kinematics/penetration.hpp"
#include "problem/request_fields.hpp"
#include "work/hold.hpp"
#include "work/moment.hpp"

namespace shigusa {
namespace {

// Depth (m) of a thing in another one or in an obstacle that counts as contact.
constexpr double kContactDepth = 0.01;
// Distance (m) by which a part may reach out of its thing's sides.
constexpr double kPartSlack = 1e-3;
// Distance (m) and turn (deg) from where the feet are within which to stand there needs no step.
constexpr double kNoStep = 0.05;
constexpr double kNoTurn = 10.0;

tl::unexpected<Error> wrong(std::size_t action, Message message) {
  return fail(ErrorCode::invalid_argument, std::move(message), fmt::format("actions[{}]", action));
}

tl::unexpected<Error> wrong_thing(const Thing& thing, Message message) {
  return fail(ErrorCode::invalid_argument, std::move(message), "thing " + thing.name.substr(0, 80));
}

bool is_finite_place(const Vec3d& place) {
  return is_finite(place.x) && is_finite(place.y) && is_finite(place.z) &&
         norm(place) <= 2.0 * kGoalRange;
}

// Parts lie within their thing's sides.
Result<void> check_parts(const Thing& thing) {
  if (thing.parts.size() > kPartsMax) {
    return wrong_thing(thing, say("at_most", thing.parts.size(), kPartsMax));
  }
  if (thing.shape != ThingShape::box) return wrong_thing(thing, say("parts_of_box"));
  for (const ThingPart& part : thing.parts) {
    for (int k = 0; k < 3; ++k) {
      const double end = abs(part.position[k]) + 0.5 * part.size[k];
      if (part.size[k] > 0.0 && end <= 0.5 * thing.size[k] + kPartSlack) continue;
      return wrong_thing(thing, say(
                                    "part_outside", "xyz" [k], Metres { thing.size[k] }));
    }
  }
  return {};
}

Result<void> check_numbers(const Thing& thing) {
  if (!(thing.mass >= 0.0 && thing.mass <= kLoadMax)) {
    return wrong_thing(thing, say("too_heavy_thing", thing.name, thing.mass, kLoadMax));
  }
  for (int k = 0; k < 3; ++k) {
    if (thing.size[k] >= kThingLeast && thing.size[k] <= kThingMost) continue;
    return wrong_thing(thing, say(
                                  "thing_size", "xyz" [k], Metres { thing.size[k] },
                                  Metres{kThingLeast}, Metres{kThingMost}));
  }
  if (!thing.parts.empty()) SHG_TRY(check_parts(thing));
  if (is_finite_place(thing.position) && is_finite_place(thing.centre) &&
      is_finite(thing.turn_deg)) {
    return {};
  }
  return wrong_thing(thing, say("finite_numbers", Metres{kGoalRange}, Metres{kGoalRange}));
}

// Depth (m) of one rounded box in another, measured at the points of a grid on its faces.
double depth_in(const Obstacle& one, const PlacedBox& other) {
  constexpr int kParts = 4;
  const Mat3d axes = to_matrix(one.rotation);
  double deepest = -1e9;
  for (int x = 0; x <= kParts; ++x) {
    for (int y = 0; y <= kParts; ++y) {
      for (int z = 0; z <= kParts; ++z) {
        const auto at = [](int k, double side) { return side * (1.0 * k / kParts - 0.5); };
        const Vec3d own{at(x, one.size.x), at(y, one.size.y), at(z, one.size.z)};
        deepest = max(deepest, one.radius - box_distance(other, one.position + axes * own));
      }
    }
  }
  return deepest;
}

Result<void> check_things(const Task& task) {
  if (task.things.size() > kThingsMax) {
    return fail(ErrorCode::invalid_argument, say("at_most", task.things.size(), kThingsMax),
                "things");
  }
  std::set<std::string> names;
  std::vector<Obstacle> all = task.obstacles;
  for (const Thing& thing : task.things) {
    if (!names.insert(thing.name).second) return wrong_thing(thing, say("thing_twice", thing.name));
    SHG_TRY(check_numbers(thing));
    const std::vector<Obstacle> own = obstacles_of(thing, start_pose(thing));
    const std::vector<PlacedBox> placed = placed_boxes(own);
    const std::vector<PlacedBox> boxes = placed_boxes(all);
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (std::size_t p = 0; p < own.size(); ++p) {
        const double depth = max(depth_in(own[p], boxes[k]), depth_in(all[k], placed[p]));
        if (depth <= kContactDepth) continue;
        return wrong_thing(thing,
                           say("thing_in", thing.name, Millimetres{1e3 * depth}, all[k].name));
      }
    }
    all.insert(all.end(), own.begin(), own.end());
  }
  if (all.size() > kObstaclesMax) {
    return fail(ErrorCode::invalid_argument, say("things_and_obstacles", all.size(), kObstaclesMax),
                "things");
  }
  return {};
}

// The things in hands from action to action, as far as names tell.
class Hands {
 public:
  explicit Hands(const Task& task) : task_(task) {}

  Result<void> follow(std::size_t at, const Action& action) {
    switch (*kind_of(action)) {
      case ActionKind::grasp:
        return grasp(at, action);
      case ActionKind::place:
        if (!action.position) return wrong(at, say("place_where"));
        return let_go(at, action.place);
      case ActionKind::release:
        return let_go(at, action.release);
      case ActionKind::goals:
        return move(at, action);
      default:
        return {};
    }
  }

 private:
  Result<void> grasp(std::size_t at, const Action& action) {
    SHG_TRY(known(at, action.grasp));
    std::vector<std::string> hands;
    for (const Side side : {Side::right, Side::left}) {
      if (const std::string hand = hand_name(task_.body, side); !hand.empty())
        hands.push_back(hand);
    }
    for (const std::string& hand : action.with) {
      if (std::find(hands.begin(), hands.end(), hand) == hands.end()) {
        return wrong(at, say("not_a_hand", hand.substr(0, 80),
                             fmt::format("{}", fmt::join(hands, " and "))));
      }
    }
    if (held_.contains(action.grasp)) return hand_over(at, action);
    const Thing& thing = task_.things[thing_named(task_, action.grasp)];
    std::vector<std::string> with = action.with;
    if (with.empty() && takes_two(thing)) with = hands;
    for (const std::string& hand : with) {
      const auto full = in_.find(hand);
      if (full != in_.end()) return wrong(at, say("hand_full", hand, full->second));
    }
    if (with.empty() && in_.size() >= hands.size()) {
      return wrong(at, say("hand_full", hands.front(), in_.begin()->second));
    }
    held_.insert(action.grasp);
    for (const std::string& hand : with) in_[hand] = action.grasp;
    return {};
  }

  // One empty hand takes a thing that another hand holds alone.
  Result<void> hand_over(std::size_t at, const Action& action) {
    const auto holds = [&](const auto& hand) { return hand.second == action.grasp; };
    const bool one = std::count_if(in_.begin(), in_.end(), holds) == 1 && action.with.size() == 1;
    if (!one) return wrong(at, say("held_already", action.grasp));
    const std::string& taker = action.with.front();
    const auto full = in_.find(taker);
    if (full != in_.end()) return wrong(at, say("hand_full", taker, full->second));
    std::erase_if(in_, holds);
    in_[taker] = action.grasp;
    return {};
  }

  // Hands with a thing in both of them go nowhere alone.
  Result<void> move(std::size_t at, const Action& action) const {
    for (const Goal& goal : action.goals) {
      const auto own = in_.find(goal.effector);
      if (own == in_.end()) continue;
      const auto holds = std::count_if(
          in_.begin(), in_.end(), [&](const auto& hand) { return hand.second == own->second; });
      if (holds > 1) return wrong(at, say("hand_holds", goal.effector, own->second));
    }
    return {};
  }

  Result<void> let_go(std::size_t at, const std::string& name) {
    SHG_TRY(known(at, name));
    if (held_.erase(name) == 0) return wrong(at, say("not_held", name));
    std::erase_if(in_, [&](const auto& hand) { return hand.second == name; });
    return {};
  }

  Result<void> known(std::size_t at, const std::string& name) const {
    if (thing_named(task_, name) < task_.things.size()) return {};
    std::vector<std::string> names;
    for (const Thing& thing : task_.things) names.push_back(thing.name);
    return fail(ErrorCode::not_found, unknown_name("thing", name, names),
                fmt::format("actions[{}]", at));
  }

  const Task& task_;
  std::set<std::string> held_{};
  std::map<std::string, std::string> in_{};  // thing of each hand that is told
};

Result<void> check_stance(std::size_t at, const Task& task, const Stance& stance) {
  const auto steps =
      fail(ErrorCode::unsupported, say("needs_steps"), fmt::format("actions[{}].stand", at));
  if (sits(task.body)) return steps;
  const Kinematics<double> placed_home = placed(task.body, task.home);
  Vec3d middle{};
  for (const Foot& foot : task.body.feet()) {
    middle += placed_home.point(foot.link, foot.centre) *
              (1.0 / static_cast<double>(task.body.feet().size()));
  }
  const bool near = abs(stance.x - middle.x) <= kNoStep + abs(middle.x) &&
                    abs(stance.z) <= kNoStep + abs(middle.z) && abs(stance.facing_deg) <= kNoTurn;
  if (near) return {};
  return steps;
}

// Whether the next action goes on with the effectors that pass.
bool can_pass(const Task& task, std::size_t action) {
  const Action& via = task.actions[action];
  if (action + 1 == task.actions.size() || via.goals.empty() || via.hold > 0.0) return false;
  const Action& next = task.actions[action + 1];
  return !next.via && std::all_of(via.goals.begin(), via.goals.end(), [&](const Goal& goal) {
    return std::any_of(next.goals.begin(), next.goals.end(),
                       [&](const Goal& after) { return after.effector == goal.effector; });
  });
}

}  // namespace

std::optional<ActionKind> kind_of(const Action& action) {
  std::optional<ActionKind> kind;
  int kinds = 0;
  const auto is = [&](bool given, ActionKind of) {
    if (!given) return;
    kind = of;
    ++kinds;
  };
  is(action.stand.has_value(), ActionKind::stand);
  is(action.sit.has_value(), ActionKind::sit);
  is(action.wait.has_value(), ActionKind::wait);
  is(!action.grasp.empty(), ActionKind::grasp);
  is(!action.place.empty(), ActionKind::place);
  is(!action.release.empty(), ActionKind::release);
  is(!action.goals.empty(), ActionKind::goals);
  if (kinds == 0 && action.look_at) return ActionKind::goals;
  return kinds == 1 ? kind : std::nullopt;
}

const Action* via_before(const Task& task, std::size_t action) {
  return action > 0 && task.actions[action - 1].via ? &task.actions[action - 1] : nullptr;
}

std::size_t thing_named(const Task& task, std::string_view name) {
  const auto named = [name](const Thing& thing) { return thing.name == name; };
  return static_cast<std::size_t>(std::find_if(task.things.begin(), task.things.end(), named) -
                                  task.things.begin());
}

Result<void> check_work(const Task& task) {
  if (task.actions.empty()) return fail(ErrorCode::invalid_argument, say("no_actions"), "actions");
  if (task.actions.size() > kActionsMax) {
    return fail(ErrorCode::invalid_argument, say("actions_most", task.actions.size(), kActionsMax),
                "actions");
  }
  if (!task.goals.empty()) {
    return fail(ErrorCode::invalid_argument, say("goals_in_actions"), "goals");
  }
  if (task.preset != Preset::flat) {
    return fail(ErrorCode::invalid_argument, say("actions_by_flat"), "actions");
  }
  SHG_TRY(check_things(task));
  Hands hands(task);
  for (std::size_t k = 0; k < task.actions.size(); ++k) {
    const Action& action = task.actions[k];
    const auto kind = kind_of(action);
    if (!kind) return wrong(k, say("action_kind"));
    if (*kind == ActionKind::sit) {
      return fail(ErrorCode::unsupported, say("needs_steps"), fmt::format("actions[{}].sit", k));
    }
    if (action.stand) SHG_TRY(check_stance(k, task, *action.stand));
    if (action.via && !can_pass(task, k)) return wrong(k, say("via_where"));
    SHG_TRY(hands.follow(k, action));
  }
  return {};
}

}  // namespace shigusa
