// SPDX-License-Identifier: MIT
#include "kinds.hpp"

#include <array>
#include <cmath>

#include "draw.hpp"
#include "support/random_tasks.hpp"

namespace shigusa::bench {
namespace {

using testing_support::kTaskKinds;

// Distances within and beyond reach, in shares of the stature.
constexpr Vec3d kLow{-0.35, 0.03, -0.2};
constexpr Vec3d kHigh{0.3, 1.1, 0.45};

Goal hand_goal(Draw& draw, double size, const char* hand = "right_hand") {
  return {.effector = hand, .position = draw.in_box(kLow, kHigh) * size};
}

double build(Draw& draw, const char* source, TaskFile& file) {
  file.character.source = source;
  file.character.stature = draw.within(1.45, 2.0);
  file.character.sex = draw.in(0.5) ? Sex::female : Sex::male;
  return *file.character.stature;
}

double cast_in(const CastMember& member, DrawnTask& task) {
  task.who = &member;
  task.file.character = member.character;
  return member.stature;
}

template <std::size_t Which>
DrawnTask basic(const Cast&, std::uint64_t number) {
  return {testing_support::random_task(number * kTaskKinds.size() + Which), nullptr};
}

DrawnTask robots_hand(const Cast& cast, std::uint64_t number) {
  Draw draw(2001, number);
  DrawnTask task;
  const double size = cast_in(draw.one_of(cast.robots), task);
  task.file.goals = {hand_goal(draw, size, draw.in(0.5) ? "right_hand" : "left_hand")};
  return task;
}

DrawnTask robots_hands(const Cast& cast, std::uint64_t number) {
  Draw draw(2002, number);
  DrawnTask task;
  const double size = cast_in(draw.one_of(cast.robots), task);
  task.file.goals = {hand_goal(draw, size)};
  if (draw.in(0.5)) {
    task.file.goals.push_back(hand_goal(draw, size, "left_hand"));
  } else {
    task.file.goals[0].load = draw.within(0.2, 5.0);
  }
  return task;
}

Obstacle box_ahead(Draw& draw, double size) {
  return {.name = "box",
          .position = draw.in_box({-0.3, 0.3, 0.2}, {0.2, 0.9, 0.5}) * size,
          .size = draw.in_box({0.1, 0.05, 0.05}, {0.5, 0.3, 0.3}) * size};
}

DrawnTask robot_and_box(const Cast& cast, std::uint64_t number) {
  Draw draw(2003, number);
  DrawnTask task;
  const double size = cast_in(draw.one_of(cast.robots), task);
  task.file.goals = {hand_goal(draw, size)};
  task.file.obstacles = {box_ahead(draw, size)};
  return task;
}

DrawnTask files_hand(const Cast& cast, std::uint64_t number) {
  Draw draw(2004, number);
  DrawnTask task;
  const double size = cast_in(draw.one_of(cast.people), task);
  Goal hand = hand_goal(draw, size);
  const double what = draw.within(0, 1);
  if (what < 0.15) hand.load = draw.within(1.0, 20.0);
  if (what > 0.85) hand.axis = GoalAxis{{1, 0, 0}, draw.in_box({-1, -1, -1}, {1, 1, 1})};
  if (what > 0.75 && what < 0.85) hand.rotation = draw.turn();
  task.file.goals = {hand};
  return task;
}

DrawnTask files_more(const Cast& cast, std::uint64_t number) {
  Draw draw(2005, number);
  DrawnTask task;
  const double size = cast_in(draw.one_of(cast.people), task);
  task.file.goals = {hand_goal(draw, size)};
  if (draw.in(0.5)) task.file.goals.push_back(hand_goal(draw, size, "left_hand"));
  if (draw.in(0.5)) task.file.obstacles = {box_ahead(draw, size)};
  if (draw.in(0.2)) adopt_preset(task.file, Preset::human);
  return task;
}

DrawnTask from_a_seat(const Cast& cast, std::uint64_t number) {
  Draw draw(2006, number);
  DrawnTask task;
  const bool of_file = draw.in(0.25);
  const double size = of_file ? cast_in(draw.one_of(cast.people), task)
                              : build(draw, draw.in(0.8) ? "human" : "full_body", task.file);
  const double seat = std::fmax(draw.within(0.2, 0.32) * size, kSeatMin);
  task.file.character.seat = seat;
  if (of_file) task.file.character = seated_member(*task.who, seat);
  task.file.goals = {{.effector = "right_hand",
                      .position = draw.in_box({-0.35, 0.1, -0.1}, {0.3, 0.9, 0.55}) * size}};
  if (draw.in(0.3)) {
    task.file.goals.push_back({.effector = "left_hand",
                               .position = draw.in_box({-0.2, 0.2, 0.1}, {0.35, 0.8, 0.5}) * size});
  }
  return task;
}

DrawnTask heels(const Cast& cast, std::uint64_t number) {
  Draw draw(2007, number);
  DrawnTask task;
  std::vector<const CastMember*> with_toes;
  for (const CastMember& member : cast.people) {
    if (member.toes) with_toes.push_back(&member);
  }
  const double size = !with_toes.empty() && draw.in(0.2) ? cast_in(*draw.one_of(with_toes), task)
                                                         : build(draw, "human", task.file);
  task.file.character.heels = true;
  Goal hand = hand_goal(draw, size);
  if (draw.in(0.5)) hand.position.y = draw.within(1.1, 1.35) * size;
  task.file.goals = {hand};
  return task;
}

DrawnTask hand_on_thigh(const Cast& cast, std::uint64_t number) {
  Draw draw(2008, number);
  DrawnTask task;
  const double size =
      draw.in(0.2) ? cast_in(draw.one_of(cast.people), task) : build(draw, "human", task.file);
  task.file.goals = {{.effector = "right_hand",
                      .position = draw.in_box({-0.3, 0.03, 0.0}, {0.2, 0.6, 0.4}) * size}};
  if (draw.in(0.3)) task.file.goals[0].load = draw.within(1.0, 15.0);
  task.file.supports = {{"left_hand", std::string(kThighPlace)}};
  return task;
}

DrawnTask hand_on_box(const Cast& cast, std::uint64_t number) {
  Draw draw(2009, number);
  DrawnTask task;
  const double size =
      draw.in(0.2) ? cast_in(draw.one_of(cast.people), task) : build(draw, "human", task.file);
  task.file.goals = {{.effector = "right_hand",
                      .position = draw.in_box({-0.35, 0.1, 0.1}, {0.0, 0.8, 0.45}) * size}};
  Obstacle box{.name = "stool",
               .position = draw.in_box({0.12, 0.3, 0.15}, {0.3, 0.6, 0.35}) * size,
               .size = draw.in_box({0.1, 0.02, 0.1}, {0.3, 0.4, 0.3}) * size};
  if (draw.in(0.3)) box.radius = 0.01;
  task.file.obstacles = {box};
  task.file.supports = {{"left_hand", "stool"}};
  return task;
}

// The paper's own bodies.
DrawnTask by_paper(const Cast&, std::uint64_t number) {
  Draw draw(2010, number);
  DrawnTask task;
  const bool half = draw.in(0.3);
  const double size = build(draw, half ? "half_body" : "full_body", task.file);
  adopt_preset(task.file, Preset::paper);
  task.file.goals = {hand_goal(draw, size)};
  if (!half && draw.in(0.3)) task.file.goals.push_back(hand_goal(draw, size, "left_hand"));
  return task;
}

// Bodies of a few statures, whose arm libraries are searched once.
DrawnTask by_layers(const Cast&, std::uint64_t number) {
  Draw draw(2011, number);
  DrawnTask task;
  build(draw, "full_body", task.file);
  task.file.character.stature = draw.one_of(std::vector{1.55, 1.7, 1.9});
  const double size = *task.file.character.stature;
  adopt_preset(task.file, Preset::layers);
  task.file.goals = {hand_goal(draw, size)};
  if (draw.in(0.3)) task.file.goals.push_back(hand_goal(draw, size, "left_hand"));
  return task;
}

DrawnTask by_human_layers(const Cast&, std::uint64_t number) {
  Draw draw(2012, number);
  DrawnTask task;
  const double size = build(draw, "human", task.file);
  adopt_preset(task.file, Preset::human);
  task.file.goals = {hand_goal(draw, size)};
  if (draw.in(0.5)) task.file.goals.push_back(hand_goal(draw, size, "left_hand"));
  if (draw.in(0.3)) task.file.obstacles = {box_ahead(draw, size)};
  return task;
}

Obstacle thing_of_any_shape(Draw& draw, double size) {
  Obstacle thing{.name = "thing",
                 .position = draw.in_box({-0.4, 0.2, 0.2}, {0.3, 1.0, 0.5}) * size,
                 .rotation = draw.turn()};
  const double shape = draw.within(0, 1);
  thing.radius = draw.within(0.02, 0.08) * size;
  if (shape > 0.3) thing.size.x = draw.within(0.05, 0.4) * size;
  if (shape > 0.6) {
    thing.size = draw.in_box({0.05, 0.05, 0.05}, {0.4, 0.3, 0.3}) * size;
    thing.radius = shape > 0.8 ? 0.0 : draw.within(0.01, 0.05);
  }
  return thing;
}

DrawnTask round_and_turned(const Cast&, std::uint64_t number) {
  Draw draw(2013, number);
  DrawnTask task;
  const double size = build(draw, draw.in(0.7) ? "human" : "full_body", task.file);
  task.file.goals = {hand_goal(draw, size)};
  if (draw.in(0.3)) task.file.goals.push_back(hand_goal(draw, size, "left_hand"));
  const int things = 1 + static_cast<int>(draw.within(0, 3));
  for (int k = 0; k < things; ++k) {
    task.file.obstacles.push_back(thing_of_any_shape(draw, size));
  }
  return task;
}

DrawnTask table_ahead(const Cast&, std::uint64_t number) {
  Draw draw(2014, number);
  DrawnTask task;
  const double size = build(draw, "human", task.file);
  const double top = draw.within(0.38, 0.52) * size;
  const double edge = draw.within(0.1, 0.2) * size;
  const double thick = draw.within(0.02, 0.06);
  task.file.obstacles = {{.name = "table",
                          .position = {0.0, top - 0.5 * thick, edge + 0.35},
                          .size = {1.4, thick, 0.7}}};
  const bool below = draw.in(0.2);
  const auto above = [&](double out) {
    const double over = below ? -draw.within(0.1, 0.25) : draw.within(0.03, 0.35);
    return Vec3d{out * draw.within(0.02, 0.2) * size, top + over, edge + draw.within(0.0, 0.3)};
  };
  task.file.goals = {{.effector = "right_hand", .position = above(-1.0)}};
  if (draw.in(0.4)) {
    task.file.goals.push_back({.effector = "left_hand", .position = above(1.0)});
  }
  return task;
}

// with its number as the seed
template <DrawnTask (*Make)(const Cast&, std::uint64_t)>
DrawnTask seeded(const Cast& cast, std::uint64_t number) {
  DrawnTask task = Make(cast, number);
  task.file.seed = number;
  return task;
}

constexpr std::array kKinds{Kind{"a place", basic<0>},
                            Kind{"both hands", basic<1>},
                            Kind{"a rotation", basic<2>},
                            Kind{"the way a palm faces", basic<3>},
                            Kind{"a load of 1 to 40 kg", basic<4>},
                            Kind{"an obstacle in between", basic<5>},
                            Kind{"a foot", basic<6>},
                            Kind{"round and turned things", seeded<round_and_turned>},
                            Kind{"a table ahead", seeded<table_ahead>},
                            Kind{"a seat", seeded<from_a_seat>},
                            Kind{"heels that may lift", seeded<heels>},
                            Kind{"a hand on the thigh", seeded<hand_on_thigh>, true},
                            Kind{"a hand on a box", seeded<hand_on_box>, true},
                            Kind{"a file's hand", seeded<files_hand>},
                            Kind{"a file's hands, boxes", seeded<files_more>},
                            Kind{"a robot's hand", seeded<robots_hand>},
                            Kind{"a robot's hands, a load", seeded<robots_hands>},
                            Kind{"a robot and a box", seeded<robot_and_box>},
                            Kind{"the preset paper", seeded<by_paper>},
                            Kind{"the preset layers", seeded<by_layers>},
                            Kind{"the preset human", seeded<by_human_layers>}};

}  // namespace

std::span<const Kind> all_kinds() { return kKinds; }

}  // namespace shigusa::bench
