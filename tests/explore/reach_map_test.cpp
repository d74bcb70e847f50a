// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <shigusa/character.hpp>
#include <shigusa/explore.hpp>
#include <shigusa/files.hpp>

#include "formats/glb.hpp"
#include "formats/json_text.hpp"

namespace shigusa {
namespace {

Task task_of_hand() {
  Task task(*build_character({}));
  task.goals = {{.effector = "right_hand"}};
  return task;
}

// A few places, from near the body to out of reach.
constexpr MapSettings kFew{
    .spacing = 0.4, .low = Vec3d{-0.6, 0.8, 0.3}, .high = Vec3d{0.2, 1.2, 1.9}};

TEST(ReachMap, PlacesHaveTheVerdictsOfReach) {
  const Task task = task_of_hand();
  const auto map = reach_map(task, kFew);
  ASSERT_TRUE(map) << map.error().to_string();
  ASSERT_EQ(map->places.size(), 3U * 2U * 5U);
  EXPECT_EQ(map->places[map->at(0, 0, 0)].verdict, Verdict::possible);
  EXPECT_EQ(map->places[map->at(2, 1, 4)].verdict, std::nullopt);
  int agree = 0;
  for (std::size_t k = 0; k < map->places.size(); ++k) {
    Task there = task;
    there.goals.front().position = map->position(k);
    const auto made = generate(there);
    const auto verdict = made->meets_goals()
                             ? std::optional(made->candidates.front().judgement.verdict)
                             : std::nullopt;
    agree += map->places[k].verdict == verdict;
  }
  EXPECT_GE(agree, 28);
}

TEST(ReachMap, TellsRebaByTheErgonomicsOfTheTask) {
  Task task = task_of_hand();
  const Vec3d place{-0.2, 1.0, 0.4};
  const auto at_place = reach_map(task, {.low = place, .high = place});
  task.ergonomics.held = task.ergonomics.repeated = task.ergonomics.rapid = true;
  const auto active = reach_map(task, {.low = place, .high = place});
  ASSERT_TRUE(at_place && active);
  EXPECT_GE(at_place->places[0].reba.value(), 1);
  EXPECT_EQ(active->places[0].reba.value(), at_place->places[0].reba.value() + 3);
}

TEST(ReachMap, IsTheSameForAnyNumberOfThreads) {
  Task task = task_of_hand();
  task.batch.threads = 1;
  const auto one = reach_map(task, kFew);
  task.batch.threads = 3;
  const auto three = reach_map(task, kFew);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(map_csv(task.body, *one), map_csv(task.body, *three));
}

TEST(ReachMap, PlacesKnowWhereTheyAre) {
  ReachMap map;
  map.low = {-0.2, 0.0, 0.1};
  map.spacing = 0.1;
  map.count = {2, 3, 4};
  EXPECT_EQ(map.position(map.at(1, 2, 3)), (Vec3d{-0.1, 0.2, 0.4}));
  EXPECT_EQ(map.plane(Axis::y, 0.24), 2);
  EXPECT_EQ(map.plane(Axis::y, 0.26), std::nullopt);
}

TEST(ReachMap, RefusesWhatItCannotMap) {
  Task task = task_of_hand();
  const auto key = [&task](const MapSettings& settings) {
    return reach_map(task, settings).error().message.key;
  };
  EXPECT_EQ(key({.spacing = -0.1}), "spacing_range");
  EXPECT_EQ(key({.spacing = 0.01}), "places_most");
  EXPECT_EQ(key({.low = Vec3d{9.0, 0.0, 0.0}}), "box_range");
  task.goals.clear();
  EXPECT_EQ(key({}), "no_goal");
  task = with_preset(task_of_hand(), Preset::paper);
  EXPECT_EQ(key({}), "map_by_flat");
}

TEST(MapFiles, HoldTheReachablePlaces) {
  const Task task = task_of_hand();
  ReachMap map{.effector = "right_hand", .spacing = 0.5, .count = {2, 1, 1}};
  map.places = {{.verdict = Verdict::possible, .score = 0.25, .strength = 0.5, .dof = 0, .reba = 3},
                {}};
  EXPECT_EQ(
      map_csv(task.body, map),
      "x [m],y [m],z [m],verdict,score,strength,joint,duration [s],reba\n0,0,0,possible,0.25,0.5," +
          task.body.dof(0).name + ",0,3\n0.5,0,0,unreachable,,,,,\n");
  const std::string glb = map_glb(map);
  const auto parts = glb_parts(glb, "map.glb");
  ASSERT_TRUE(parts);
  const auto json = parse_json(parts->json, "map.glb");
  ASSERT_TRUE(json);
  ASSERT_EQ((*json)["meshes"].size(), 1U);
  EXPECT_EQ((*json)["meshes"][0]["primitives"][0]["attributes"]["_REBA"], 2);
  EXPECT_EQ((*json)["accessors"][2]["count"], 6);
  EXPECT_TRUE(map_section(task, map, Axis::x, 0.1));
  EXPECT_EQ(map_section(task, map, Axis::x, 0.9).error().message.key, "no_section");
}

}  // namespace
}  // namespace shigusa
