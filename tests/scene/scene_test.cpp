// SPDX-License-Identifier: MIT
// Meshes of a scene become boxes and things where they are.
#include <gmock/gmock.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/scene.hpp>

#include "kinematics/penetration.hpp"
#include "support/scene_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kSingle = 1e-6;  // m, of single precision near 1

Scene read(SceneFile& file, std::vector<std::string> things = {}) {
  const auto scene = parse_scene(file.bytes(), "room.glb", {.things = std::move(things)});
  EXPECT_TRUE(scene) << scene.error().to_string();
  return scene.value_or(Scene{});
}

std::string refusal(SceneFile& file, const SceneSettings& settings = {}) {
  const auto scene = parse_scene(file.bytes(), "room.glb", settings);
  return scene ? "nothing" : scene.error().to_string();
}

double volume_of(const Scene& scene) {
  double volume = 0.0;
  for (const Obstacle& box : scene.obstacles) volume += box.size.x * box.size.y * box.size.z;
  return volume;
}

// Least distance (m) of a place from all obstacles; below 0 within one.
double distance_of(const Scene& scene, const Vec3d& place) {
  double least = 1e9;
  for (const PlacedBox& box : placed_boxes(scene.obstacles)) {
    least = min(least, box_distance(box, place));
  }
  return least;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_LE(norm(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Scene, ATableIsItsTopAndItsLegs) {
  SceneFile file;
  file.add("table", table_mesh(), {0, 0, 0.65});
  const Scene scene = read(file);
  ASSERT_EQ(scene.obstacles.size(), 5u);
  EXPECT_EQ(scene.obstacles[0].name, "table");
  EXPECT_EQ(scene.obstacles[4].name, "table 5");
  const double cell = 1.4 / 48;
  const Obstacle& top = scene.obstacles[0];
  expect_near(top.position, {0, 0.705, 0.65}, kSingle);
  expect_near(top.size, {1.4, 0.05, 0.7}, kSingle);
  for (std::size_t k = 1; k < 5; ++k) {
    expect_near(scene.obstacles[k].size, {0.06, 0.68, 0.06}, cell);
    EXPECT_NEAR(scene.obstacles[k].position.y, 0.34, cell);
  }
  EXPECT_NEAR(volume_of(scene), 1.4 * 0.05 * 0.7 + 4 * 0.06 * 0.06 * 0.68, 0.1 * 0.06);
  // free between the legs, up to the top
  EXPECT_GT(distance_of(scene, {0, 0.4, 0.65}), 0.25);
  EXPECT_GT(distance_of(scene, {0, 0.65, 0.65}), 0.02);
  EXPECT_GT(distance_of(scene, {0.5, 0.3, 0.4}), 0.08);
}

TEST(Scene, AShelfIsFreeAboveItsBoards) {
  SceneFile file;
  file.add(
      "shelf",
      SolidMesh().box({-0.4, 0.0, 0.0}, {0.4, 1.2, 0.02}).box({-0.4, 0.5, 0.02}, {0.4, 0.53, 0.3}),
      {0, 0, 0.7}, 180.0);
  const Scene scene = read(file);
  ASSERT_EQ(scene.obstacles.size(), 2u);
  EXPECT_NEAR(volume_of(scene), 0.8 * 1.2 * 0.02 + 0.8 * 0.03 * 0.28, 0.1 * 0.026);
  EXPECT_GT(distance_of(scene, {0.1, 0.6, 0.5}), 0.06);
  EXPECT_LT(distance_of(scene, {0.1, 0.515, 0.5}), 0.0);
}

TEST(Scene, ATurnedCrateIsOneBoxAlongItsSides) {
  SceneFile file;
  file.add("crate", SolidMesh().box({-0.2, 0.0, -0.15}, {0.2, 0.3, 0.15}), {0.3, 0, 0.6}, 30.0);
  const Scene scene = read(file);
  ASSERT_EQ(scene.obstacles.size(), 1u);
  expect_near(scene.obstacles[0].size, {0.4, 0.3, 0.3}, kSingle);
  expect_near(scene.obstacles[0].position, {0.3, 0.15, 0.6}, kSingle);
  EXPECT_NEAR(abs(scene.obstacles[0].rotation.y), sin_cos(radians(15.0)).sin, kSingle);
  // and as a thing
  const Scene taken = read(file, {"crate"});
  EXPECT_THAT(taken.obstacles, IsEmpty());
  ASSERT_EQ(taken.things.size(), 1u);
  EXPECT_EQ(taken.things[0].shape, ThingShape::box);
  EXPECT_NEAR(taken.things[0].turn_deg, 30.0, 1e-4);
  expect_near(taken.things[0].size, {0.4, 0.3, 0.3}, kSingle);
  expect_near(taken.things[0].position, {0.3, 0.15, 0.6}, kSingle);
  expect_near(taken.things[0].centre, {}, 0.0);
  ASSERT_EQ(taken.notes.size(), 1u);
  EXPECT_THAT(taken.notes[0].text, HasSubstr("mass_kg"));
}

TEST(Scene, AThingThatIsNoBoxHasParts) {
  SceneFile file;
  file.add("bracket",
           SolidMesh()
               .box({-0.25, 0.0, -0.1}, {0.25, 0.1, 0.1})
               .box({-0.25, 0.1, -0.1}, {-0.15, 0.4, 0.1}),
           {0.1, 0.8, 0.5}, 20.0);
  const Scene scene = read(file, {"bracket"});
  ASSERT_EQ(scene.things.size(), 1u);
  const Thing& bracket = scene.things[0];
  expect_near(bracket.size, {0.5, 0.4, 0.2}, kSingle);
  ASSERT_EQ(bracket.parts.size(), 2u);
  double volume = 0.0;
  for (const ThingPart& part : bracket.parts) volume += part.size.x * part.size.y * part.size.z;
  EXPECT_NEAR(volume, 0.5 * 0.1 * 0.2 + 0.1 * 0.3 * 0.2, 1e-3);
  const double cell = 0.5 / 48;
  expect_near(bracket.centre, {-0.075, -0.075, 0.0}, cell);
  // it is a thing that work takes
  Task task(human_body(), {});
  task.things = scene.things;
  task.actions = {{.grasp = "bracket"}};
  EXPECT_TRUE(perform(task));
}

TEST(Scene, ACupIsACylinderWithItsHandle) {
  SceneFile file = cup_scene();
  // a handle of three bars, out to the right
  file.add("Cup_Handle", SolidMesh()
                             .box({0.038, 0.075, -0.005}, {0.075, 0.085, 0.005})
                             .box({0.065, 0.02, -0.005}, {0.075, 0.085, 0.005})
                             .box({0.038, 0.02, -0.005}, {0.075, 0.03, 0.005}));
  file.put_below("cup");
  const Scene scene = read(file, {"cup"});
  ASSERT_EQ(scene.things.size(), 1u);
  const Thing& cup = scene.things[0];
  EXPECT_EQ(cup.name, "cup");
  EXPECT_EQ(cup.shape, ThingShape::cylinder);
  expect_near(cup.size, {0.08, 0.1, 0.08}, kSingle);
  expect_near(cup.position, {-0.3, 0.78, 0.45}, kSingle);
  EXPECT_EQ(cup.mass, 0.4);
  EXPECT_TRUE(cup.upright);
  // thin walls and a bottom: 4 mm and 6 mm, nearly the same all along
  EXPECT_LT(norm(cup.centre), 0.02);
  EXPECT_LE(cup.centre.y, 0.0);
  ASSERT_TRUE(cup.handle);
  expect_near(cup.handle->position, {0.07, 0.0025, 0.0}, 1e-3);
  EXPECT_EQ(cup.handle->along, (Vec3d{0, 1, 0}));
  // the floor is none
  for (const Obstacle& box : scene.obstacles) EXPECT_EQ(box.name.substr(0, 5), "table");
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_THAT(scene.notes[0].text, HasSubstr("floor ends at the floor"));
}

TEST(Scene, ABallIsASphereAndAThingHasItsChildren) {
  SceneFile file;
  std::vector<std::pair<double, double>> arc;
  for (int k = 0; k <= 16; ++k) {
    const SinCos<double> turn = sin_cos(kPi * k / 16);
    arc.emplace_back(0.1 * turn.sin, -0.1 * turn.cos);
  }
  file.add("Ball 1", SolidMesh().turned({}, arc), {0.1, 0.5, 0.5})["extras"] = {{"mass_kg", -2}};
  file.add_empty("bin", {0.6, 0, 0.5});
  file.add("walls", SolidMesh().box({-0.1, 0, -0.1}, {0.1, 0.3, 0.1}));
  file.put_below("bin");
  const Scene scene = read(file, {"Ball_1", "bin"});
  EXPECT_THAT(scene.obstacles, IsEmpty());
  ASSERT_EQ(scene.things.size(), 2u);
  EXPECT_EQ(scene.things[0].shape, ThingShape::sphere);
  EXPECT_NEAR(scene.things[0].size.x, 0.2, 1e-3);
  EXPECT_EQ(scene.things[0].mass, 0.0);
  EXPECT_EQ(scene.things[1].name, "bin");
  expect_near(scene.things[1].position, {0.6, 0.15, 0.5}, kSingle);
}

TEST(Scene, ARoomAroundTheBodyIsHollow) {
  SceneFile file;
  file.add("room", SolidMesh().box({-2, -0.05, -2}, {2, 2.5, 2}));
  const Scene scene = read(file);
  EXPECT_GT(scene.obstacles.size(), 3u);
  EXPECT_GT(distance_of(scene, {0.5, 1.2, 0.5}), 1.0);
  EXPECT_LT(distance_of(scene, {0.0, 1.2, 2.0}), 0.05);
}

TEST(Scene, WhatIsRoundHasFewBoxes) {
  SceneFile file;
  for (int k = 0; k < 20; ++k) {
    const double x = 0.5 * k;
    file.add("pot" + std::to_string(k),
             SolidMesh().turned({}, {{0.0, 0.0}, {0.1, 0.05}, {0.2, 0.3}, {0.05, 0.5}, {0.0, 0.5}}),
             {x, 0.2, 1.0});
  }
  const Scene scene = read(file);
  EXPECT_LE(scene.obstacles.size(), kSceneBoxesMax);
  EXPECT_GE(scene.obstacles.size(), 20u);
  EXPECT_LT(distance_of(scene, {0.0, 0.5, 1.0}), 0.0);
  EXPECT_GT(distance_of(scene, {0.25, 0.5, 1.0}), 0.04);
}

TEST(Scene, WhatCannotBeOneIsTold) {
  SceneFile empty;
  empty.add_empty("nothing");
  EXPECT_THAT(refusal(empty), HasSubstr("room.glb: has no mesh"));
  SceneFile many;
  for (int k = 0; k < 65; ++k) {
    many.add("crate", SolidMesh().box({0, 0, 0}, {0.1, 0.1, 0.1}), {0.2 * k, 0, 1});
  }
  EXPECT_THAT(refusal(many), HasSubstr("65 meshes; allowed are 64"));
  many.json()["nodes"].erase(64);
  EXPECT_EQ(refusal(many), "nothing");
  EXPECT_THAT(refusal(many, {.boxes = 60}), HasSubstr("64 obstacles; allowed are 60"));
  SceneFile person;
  person.add("table", table_mesh());
  person.json()["skins"] = {{{"joints", {0}}}};
  EXPECT_THAT(refusal(person), HasSubstr("joints of a character"));
  SceneFile whole;
  whole.add("table", table_mesh());
  const std::string bytes = whole.bytes();
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{11}, std::size_t{100}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_FALSE(parse_scene(bytes.substr(0, length), "room.glb")) << length;
  }
}

}  // namespace
}  // namespace shigusa
