// SPDX-License-Identifier: MIT
#include "work/hold.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/index.hpp"
#include "kinematics/penetration.hpp"

namespace shigusa {
namespace {

// Directions (deg) from ahead out to a hand's own side from which one hand takes an upright thing.
constexpr double kSideWays[] = {60.0, 90.0, 30.0};
// Distance (m) of a hand's point from the edge of a thing: half a palm's length, chosen.
constexpr double kNearEdge = 0.05;
// Depth (m) of a hand's point in an obstacle by which a way is left out.
constexpr double kHandClear = 0.005;
// Height (m) by which a thing is put higher from which two hands hold it so that wrists can do
// both: with the fingers by these angles (deg) below level. Palms that face each other are turned
// in a vertical plane by the wrists' deviation alone, which has some 50 deg.
constexpr double kPutHigh = 0.4;
constexpr double kFingersBelow[] = {25.0, 10.0, 40.0};
// Share of the way to a thing's near edge at which it is held then: there is room to lift it.
constexpr double kMiddle = 0.3;
// Directions (deg) from ahead out to a hand's own side from which a hand closes around an upright
// bar, and from above ahead and out around another one: an arm that hangs to a low bar has the
// fingers down.
constexpr double kUprightBarWays[] = {60.0, 90.0, 30.0, 0.0, 120.0, -45.0, 165.0};
constexpr double kLevelBarWays[] = {0.0, 30.0, 60.0, -35.0, 90.0};
constexpr double kLowBarWays[] = {90.0, 60.0, 30.0, 0.0, -35.0};
// Height (m) above the hand up to which a bar is low.
constexpr double kLowBar = 0.05;
// Upright part of a bar's direction from which it counts as upright.
constexpr double kUprightBar = 0.7;
// Cosine from a hand's other side within which a handle is left for what one hand takes otherwise.
constexpr double kFarHandle = 0.5;
// Half the width (m) of the palm that lies on a thing of parts, and height by which what is below
// its corners may stick out beside what is below its middle.
constexpr double kPalmHalf = 0.025;
constexpr double kSameFace = 0.01;
// Largest number of places of a thing of parts at which hands are tried.
constexpr std::size_t kPlacesMost = 6;
// Axes in a hand's frame, for the right hand; the palm of the left one is opposite.
constexpr Vec3d kPalm{1, 0, 0};
constexpr Vec3d kThumb{0, 0, 1};

// The goals of hands that take a thing; none where one has no place there.
using HandGoals = std::vector<std::optional<Goal>>;

// A body's directions on the floor.
struct Facing {
  Vec3d ahead{0, 0, 1};
  Vec3d left{1, 0, 0};
};

Facing facing_of(const BodyModel& body, const Kinematics<double>& placed) {
  Vec3d sum{};
  for (const Foot& foot : body.feet()) sum += placed.link_rotation(foot.link).cz;
  Facing facing;
  facing.ahead = normalized(Vec3d{sum.x, 0.0, sum.z}, {0, 0, 1});
  facing.left = cross(Vec3d{0, 1, 0}, facing.ahead);
  return facing;
}

// Distance (m) of a hand's point from what its palm lies on, along the palm's direction (unit
// vector in the hand's frame).
double palm_of(const BodyModel& body, int hand, const Vec3d& palm) {
  constexpr double kUsual = 0.02;
  const Effector& effector = body.effector(hand);
  double deep = 0.0;
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.link != effector.link) continue;
    deep = max(deep, dot(capsule.from - effector.point, palm) + capsule.radius);
    deep = max(deep, dot(capsule.to - effector.point, palm) + capsule.to_radius);
  }
  return deep > 0.0 ? deep : kUsual;
}

// Distance (m) from the middle of a thing to its surface along a direction (unit vector, world).
double extent(const Thing& thing, const Transformd& pose, const Vec3d& direction) {
  const Vec3d own = transpose_times(pose.rotation, direction);
  if (thing.shape == ThingShape::sphere) return 0.5 * thing.size.x;
  if (thing.shape == ThingShape::cylinder) {
    return abs(own.y) > 0.7 ? 0.5 * thing.size.y : 0.5 * thing.size.x;
  }
  // through the face that the direction meets first
  double least = 1e9;
  for (int k = 0; k < 3; ++k) {
    if (abs(own[k]) > 1e-9) least = min(least, 0.5 * thing.size[k] / abs(own[k]));
  }
  return least;
}

// Distance (m) from a place to where a line from it along a direction (unit vector) leaves the last
// of the boxes; below 0 where it meets none.
double leaves(std::span<const PlacedBox> boxes, const Vec3d& place, const Vec3d& direction) {
  double last = -1.0;
  for (const PlacedBox& box : boxes) {
    const Vec3d from = to_frame_of(box, place);
    const Vec3d along = transpose_times(box.axes, direction);
    double enter = 0.0;
    double leave = 1e9;
    for (int k = 0; k < 3; ++k) {
      if (abs(along[k]) < 1e-9) {
        if (abs(from[k]) > box.half[k]) leave = -1.0;
        continue;
      }
      const double middle = -from[k] / along[k];
      const double half = box.half[k] / abs(along[k]);
      enter = max(enter, middle - half);
      leave = min(leave, middle + half);
    }
    if (leave >= enter) last = max(last, leave);
  }
  return last;
}

class HoldFinder {
 public:
  HoldFinder(const BodyModel& body, const Kinematics<double>& placed, const Thing& thing,
             const Transformd& pose, std::span<const Obstacle> obstacles, double higher)
      : body_(body),
        placed_(placed),
        thing_(thing),
        pose_(pose),
        boxes_(placed_boxes({obstacles.begin(), obstacles.end()})),
        parts_(thing.parts.empty() ? std::vector<PlacedBox>()
                                   : placed_boxes(obstacles_of(thing, pose))),
        facing_(facing_of(body, placed)),
        higher_(higher) {
    find_places();
  }

  void add_two(const std::string& right, const std::string& left) {
    // the sides of a box face most nearly left and right
    const Mat3d& own = pose_.rotation;
    std::vector<Vec3d> lines{own.cx, own.cz};
    if (thing_.shape != ThingShape::box) lines = {facing_.left, facing_.ahead};
    std::stable_sort(lines.begin(), lines.end(), [this](const Vec3d& a, const Vec3d& b) {
      return abs(dot(a, facing_.left)) > abs(dot(b, facing_.left));
    });
    for (const Vec3d& line : lines) {
      const Vec3d to_left = dot(line, facing_.left) < 0.0 ? -line : line;
      for (const Vec3d& place : places_) {
        if (higher_ > kPutHigh) {
          add_pitched(
              {on_palm(right, place, -to_left, kMiddle), on_palm(left, place, to_left, kMiddle)});
        }
        add({on_palm(right, place, -to_left), on_palm(left, place, to_left)});
      }
    }
  }

  void add_one(const std::string& hand) {
    const bool flat = thing_.shape == ThingShape::box && thing_.size.y < thing_.size.x &&
                      thing_.size.y < thing_.size.z;
    for (const Vec3d& place : places_) {
      if (!flat) add_sides(hand, place);
      add({on_palm(hand, place, {0, 1, 0})});
      if (flat) add_sides(hand, place);
    }
  }

  // One hand around the bar of the thing's handle, with the thumb along it.
  void add_bar(const std::string& hand) {
    const Vec3d out = is_left(hand) ? facing_.left : -facing_.left;
    Vec3d bar = normalized(pose_.rotation * thing_.handle->along);
    const bool upright = abs(bar.y) > kUprightBar;
    // thumbs point up, ahead or to the other side
    if ((upright ? bar.y : dot(bar, facing_.ahead - out)) < 0.0) bar = -bar;
    const Vec3d first = upright ? -facing_.ahead : Vec3d{0, 1, 0};
    const Vec3d second = upright ? out : out * 0.5 + facing_.ahead;
    const Vec3d from = normalized(first - bar * dot(first, bar));
    Vec3d to = cross(bar, from);
    if (dot(to, second) < 0.0) to = -to;
    const Effector& effector = body_.effector(body_.find_effector(hand).value());
    const bool low = (pose_ * thing_.handle->position).y <
                     placed_.point(effector.link, effector.point).y + kLowBar;
    const std::span<const double> ways = upright ? std::span<const double>(kUprightBarWays)
                                         : low   ? std::span<const double>(kLowBarWays)
                                                 : std::span<const double>(kLevelBarWays);
    for (const double sign : {1.0, -1.0}) {
      for (const double degrees : ways) {
        const SinCos<double> turn = sin_cos(radians(degrees));
        add_around(hand, bar * sign, from * turn.cos + to * turn.sin);
      }
    }
  }

  // Whether the handle is on the far side of the thing from the hand's own side.
  [[nodiscard]] bool is_behind(const std::string& hand) const {
    const Vec3d off = pose_.rotation * thing_.handle->position;
    const double out = dot(off, is_left(hand) ? facing_.left : -facing_.left);
    return -out > kFarHandle * norm(Vec3d{off.x, 0.0, off.z});
  }

  [[nodiscard]] Holds take() { return std::move(holds_); }

 private:
  // The places (m, world) within the thing from whose sides hands may take it: its middle, or the
  // one with the mass and those of its parts, the nearest to the mass first.
  void find_places() {
    if (thing_.parts.empty()) return places_.push_back(pose_.translation);
    const Vec3d mass = pose_ * thing_.centre;
    for (const ThingPart& part : thing_.parts) places_.push_back(pose_ * part.position);
    std::stable_sort(places_.begin(), places_.end(), [&mass](const Vec3d& a, const Vec3d& b) {
      return norm(a - mass) < norm(b - mass);
    });
    places_.insert(places_.begin(), mass);
    places_.resize(std::min(places_.size(), kPlacesMost));
  }

  // Distance (m) from a place in the thing to its surface under a palm on a side (unit vector);
  // nothing where a palm does not lie there.
  [[nodiscard]] std::optional<double> surface(const Vec3d& place, const Vec3d& side) const {
    if (thing_.parts.empty()) return extent(thing_, pose_, side);
    const Vec3d across =
        normalized(cross(side, abs(side.y) < 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    const Vec3d along = cross(side, across);
    const double middle = leaves(parts_, place, side);
    double most = middle;
    for (const double a : {-kPalmHalf, kPalmHalf}) {
      for (const double b : {-kPalmHalf, kPalmHalf}) {
        most = max(most, leaves(parts_, place + across * a + along * b, side));
      }
    }
    if (middle < 0.0 || most - middle > kSameFace) return std::nullopt;
    return most;
  }

  // The goal of a hand whose palm lies on the thing from a side (unit vector out of the thing), at
  // a place within: on the near part of a deep one, so that the forearm does not pass along it.
  [[nodiscard]] std::optional<Goal> on_palm(const std::string& name, Vec3d place, const Vec3d& side,
                                            double share = 1.0) const {
    const Vec3d back = -facing_.ahead;
    Vec3d nearer{};
    if (thing_.shape == ThingShape::box && abs(dot(side, back)) < 0.5) {
      const Vec3d along = normalized(back - side * dot(side, back));
      const double deep = surface(place, along).value_or(0.0);
      nearer = along * max(deep - kNearEdge, 0.0) * share;
    }
    if (!thing_.parts.empty()) place += std::exchange(nearer, {});
    std::optional<Goal> goal = at(name, place, side);
    if (!goal) return goal;
    goal->position += nearer;
    goal->axis = GoalAxis{palm_axis(name), -side};
    return goal;
  }

  // The same hold with the fingers at given angles.
  void add_pitched(const HandGoals& palms) {
    for (const double degrees : kFingersBelow) {
      const SinCos<double> pitch = sin_cos(radians(degrees));
      const Vec3d thumb = Vec3d{0, pitch.cos, 0} + facing_.ahead * pitch.sin;
      HandGoals goals = palms;
      for (std::optional<Goal>& goal : goals) {
        if (!goal) return;
        const auto turn = rotation_pointing(kThumb, thumb, goal->axis->axis, goal->axis->direction);
        if (!turn) return;
        goal->rotation = *turn;
        goal->axis.reset();
      }
      add(goals);
    }
  }

  // A hand on a side (unit vector) of the bar, clear of the thing's shape.
  void add_around(const std::string& name, const Vec3d& thumb, const Vec3d& side) {
    const double depth = palm_of(body_, body_.find_effector(name).value(), palm_axis(name));
    const auto rotation = rotation_pointing(kThumb, thumb, palm_axis(name), -side);
    if (!rotation) return;
    const Vec3d at = pose_ * thing_.handle->position + side * (depth + kTouch);
    const std::vector<PlacedBox> own = placed_boxes(obstacles_of(thing_, pose_));
    if (depth - least_distance(own, at) > kHandClear) return;
    add({Goal{.effector = name, .position = at, .rotation = *rotation}});
  }

  void add_sides(const std::string& hand, const Vec3d& place) {
    const Vec3d out = is_left(hand) ? facing_.left : -facing_.left;
    for (const double degrees : kSideWays) {
      const SinCos<double> turn = sin_cos(radians(degrees));
      // the hand comes from the body's side of the thing
      const Vec3d side = out * turn.sin - facing_.ahead * turn.cos;
      std::optional<Goal> goal = at(hand, place, side);
      const auto rotation = rotation_pointing(kThumb, {0, 1, 0}, palm_axis(hand), -side);
      if (!rotation || !goal) continue;
      goal->rotation = *rotation;
      add({goal});
    }
  }

  // A hand on a side (unit vector), off a place within the thing.
  [[nodiscard]] std::optional<Goal> at(const std::string& name, const Vec3d& place,
                                       const Vec3d& side) const {
    const int hand = body_.find_effector(name).value();
    const auto out = surface(place, side);
    if (!out) return std::nullopt;
    const double off = *out + palm_of(body_, hand, palm_axis(name)) + kTouch;
    return Goal{.effector = name, .position = place + side * off};
  }

  [[nodiscard]] bool is_left(const std::string& name) const {
    return body_.effector(body_.find_effector(name).value()).part.side == Side::left;
  }
  [[nodiscard]] Vec3d palm_axis(const std::string& name) const {
    return is_left(name) ? -kPalm : kPalm;
  }

  // Adds a way, unless a hand has no place or is in an obstacle.
  void add(const HandGoals& hands) {
    std::vector<Goal> goals;
    for (const std::optional<Goal>& goal : hands) {
      if (!goal) return;
      goals.push_back(*goal);
    }
    for (const Goal& goal : goals) {
      const int hand = body_.find_effector(goal.effector).value();
      const double palm = palm_of(body_, hand, palm_axis(goal.effector));
      for (const PlacedBox& box : boxes_) {
        if (palm - box_distance(box, goal.position) > kHandClear) return;
      }
    }
    holds_.push_back(std::move(goals));
  }

  const BodyModel& body_;
  const Kinematics<double>& placed_;
  const Thing& thing_;
  Transformd pose_;
  std::vector<PlacedBox> boxes_;
  std::vector<PlacedBox> parts_;  // of the thing, if it has some
  std::vector<Vec3d> places_{};
  Facing facing_;
  double higher_;
  Holds holds_;
};

}  // namespace

bool takes_two(const Thing& thing) {
  if (thing.handle) return thing.mass > kHandleMass;
  return min(thing.size.x, thing.size.z) > kOneHandWidth || thing.mass > kOneHandMass;
}

std::string hand_name(const BodyModel& body, Side side) {
  const auto hand = body.find_effector(JointKind::hand, side);
  return hand ? body.effector(*hand).name : std::string();
}

Holds holds_of(const BodyModel& body, const Kinematics<double>& placed, const Thing& thing,
               const Transformd& pose, std::span<const std::string> hands,
               std::span<const Obstacle> obstacles, double higher) {
  HoldFinder finder(body, placed, thing, pose, obstacles, higher);
  const std::string right = hand_name(body, Side::right);
  const std::string left = hand_name(body, Side::left);
  const bool both = !right.empty() && !left.empty();
  if (both && (hands.empty() ? takes_two(thing) : hands.size() > 1)) {
    finder.add_two(right, left);
    return finder.take();
  }
  std::vector<std::string> ones(hands.begin(), hands.end());
  if (ones.empty()) {
    const Vec3d at = thing.handle ? pose * thing.handle->position : pose.translation;
    Vec3d middle{};
    for (const Foot& foot : body.feet()) {
      middle +=
          placed.point(foot.link, foot.centre) * (1.0 / static_cast<double>(body.feet().size()));
    }
    const bool by_left = dot(at - middle, facing_of(body, placed).left) > 0.0;
    ones = {by_left ? left : right, by_left ? right : left};
    std::erase(ones, std::string());
  } else {
    ones.resize(1);
  }
  Thing bare = thing;
  bare.handle.reset();
  const bool wide = both && hands.empty() && takes_two(bare);
  for (const std::string& hand : ones) {
    const bool far = thing.handle && finder.is_behind(hand);
    if (thing.handle && !far) finder.add_bar(hand);
    if (!wide) finder.add_one(hand);
    if (far) finder.add_bar(hand);
  }
  if (wide) finder.add_two(right, left);
  return finder.take();
}

}  // namespace shigusa
