// SPDX-License-Identifier: MIT
#include "cases.hpp"

#include <fmt/format.h>

#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa::bench {
namespace {

constexpr double kShift = 0.04;            // m, by which a unit's goals are moved at most
constexpr double kArm = 0.66;              // m, from the shoulder to the grip
constexpr double kAnkleToShoulder = 0.03;  // m, ahead
constexpr double kHandsApart = 0.33;       // m
constexpr std::size_t kHeldOut = 4;        // one unit of this number

// Units of one body. Goals are for the right hand of a body of kUsualStature; in every second unit
// the left hand moves.
class Maker {
 public:
  Maker(BodyBuild build, std::string name, std::uint64_t seed, std::vector<Unit>& units)
      : body_(human_body(build)), name_(std::move(name)), random_(seed), units_(units) {}

  // Begins a unit, whose goals are all displaced equally.
  void begin(const std::string& what, Series series) {
    const std::size_t k = units_.size();
    units_.push_back({fmt::format("{} {}", name_, what), series, {}, k % kHeldOut == kHeldOut - 1});
    side_ = k % 2 == 0 ? Side::right : Side::left;
    shift_ = {random_.uniform(-kShift, kShift), random_.uniform(-kShift, kShift),
              random_.uniform(-kShift, kShift)};
  }

  Case& one(Vec3d goal) {
    const bool left = side_ == Side::left;
    goal = placed(goal);
    if (left) goal.x = -goal.x;
    return add({{left ? "left_hand" : "right_hand", goal}}, side_);
  }

  Case& both(Vec3d middle) {
    const Vec3d half{0.5 * kHandsApart * scale(), 0.0, 0.0};
    middle.x = 0.0;
    Vec3d at = placed(middle);
    at.x = 0.0;
    return add({{"right_hand", at - half}, {"left_hand", at + half}}, Side::right);
  }

 private:
  [[nodiscard]] double scale() const { return body_.body.stature() / kUsualStature; }
  [[nodiscard]] Vec3d placed(const Vec3d& goal) const {
    Vec3d at = goal + shift_;
    at.y = max(at.y, 0.04);
    return at * scale();
  }
  Case& add(std::vector<Goal> goals, Side side) {
    Task task(body_);
    task.goals = std::move(goals);
    units_.back().cases.push_back(case_of(std::move(task), side));
    return units_.back().cases.back();
  }

  PosedBody body_;
  std::string name_;
  Random random_;
  std::vector<Unit>& units_;
  Side side_ = Side::right;
  Vec3d shift_{};
};

void add_low(Maker& make) {
  constexpr double kHeights[] = {0.06, 0.22, 0.40, 0.58, 0.78};
  make.begin("both hands, floor to table", Series::heights);
  for (const double y : kHeights) make.both({0.0, y, 0.42});
  make.begin("one hand, floor to table", Series::heights);
  for (const double y : kHeights) make.one({-0.16, y, 0.38});
  make.begin("both hands, near and far", Series::near_and_far);
  for (const double z : {0.22, 0.40, 0.58}) make.both({0.0, 0.20, z});
  make.begin("one hand, distances", Series::distances);
  for (const double z : {0.34, 0.49, 0.61}) make.one({-0.12, 0.28, z});
  make.begin("floor", Series::none);
  make.one({-0.18, 0.10, 0.26});
  make.one({-0.05, 0.16, 0.36});
  make.one({-0.25, 0.20, 0.44});
  make.begin("bend", Series::none);
  Case& bend = make.one({-0.14, 0.15, 0.32});
  bend.task.fixed_assignments = {"squat_deg=5"};
  bend.straight = true;
}

void add_high(Maker& make) {
  make.begin("level", Series::arms);
  for (const double share : {0.70, 0.85, 1.0, 1.15}) {
    Case& level = make.one({-0.20, 1.40, kAnkleToShoulder + kArm * share});
    level.arm = (level.ahead - kAnkleToShoulder) / kArm;
  }
  make.begin("shelf", Series::none);
  for (const Vec3d& goal : {Vec3d{-0.2, 1.28, 0.62}, {-0.15, 1.50, 0.60}, {-0.25, 1.74, 0.54}}) {
    make.one(goal);
  }
  make.begin("table", Series::none);
  make.one({-0.15, 0.95, 0.45});
  make.one({-0.25, 0.82, 0.60});
  make.both({0.0, 1.05, 0.50});
  make.begin("above", Series::none);
  make.one({-0.28, 1.93, 0.22});
  make.begin("aside", Series::none);
  make.one({-0.60, 0.40, 0.10});
  make.one({-0.65, 1.10, 0.15});
  make.one({0.25, 0.90, 0.40});
}

}  // namespace

Case case_of(Task task, Side side) {
  Case made{std::move(task), side};
  const PosedBody& posed = made.task;
  const double scale = kUsualStature / posed.body.stature();
  const Kinematics<double> start = home_kinematics(posed);
  const Vec3d goal = made.task.goals.front().position;
  const Effector& hand =
      posed.body.effector(posed.body.find_effector(made.task.goals.front().effector).value());
  const Vec3d way = goal - start.point(hand.link, hand.point);
  made.both = made.task.goals.size() > 1;
  made.height = goal.y * scale;
  made.ahead = goal.z * scale;
  made.aside = made.both ? 0.0 : (side == Side::right ? -goal.x : goal.x) * scale;
  made.rise = way.y / max(norm(way), 1e-9);
  return made;
}

std::vector<Unit> made_units(std::uint64_t seed) {
  std::vector<Unit> units;
  std::uint64_t k = seed * 100;
  for (const Sex sex : {Sex::male, Sex::female}) {
    for (const char* percentile : {"p5", "p50", "p95"}) {
      const double stature = stature_percentile(percentile, sex).value();
      const BodyBuild build{stature, default_mass(stature, sex), sex};
      Maker make(build, fmt::format("{} {}", word_of(sex), percentile), ++k, units);
      add_low(make);
      add_high(make);
    }
  }
  for (const double z : {0.42, 0.52, 0.48, 0.46}) {
    std::vector<Unit> pair;
    ++k;
    for (const Sex sex : {Sex::male, Sex::female}) {
      const double stature = kUsualStature - 0.08;
      Maker make({stature, default_mass(stature, sex), sex}, "sexes", k, pair);
      make.begin(fmt::format("at {:.2f}", z), Series::sexes);
      make.one({-0.1, 0.30, z});
    }
    pair[0].cases.push_back(std::move(pair[1].cases.front()));
    pair[0].held_out = units.size() % kHeldOut == kHeldOut - 1;
    units.push_back(std::move(pair[0]));
  }
  return units;
}

}  // namespace shigusa::bench
