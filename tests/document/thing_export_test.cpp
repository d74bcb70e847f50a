// SPDX-License-Identifier: MIT
// Things in GLB files of characters, by the files' own numbers.
#include <gmock/gmock.h>

#include <algorithm>
#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "document/glb_things.hpp"
#include "formats/gltf_animation.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Json = nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;
constexpr double kTenthDegree = radians(0.1);
constexpr const char* kAnimation = "shigusa";

int node_of(const ExportedGlb& glb, const std::string& name) {
  const Json& nodes = glb.json().at("nodes");
  const auto found = std::find_if(nodes.begin(), nodes.end(),
                                  [&](const Json& node) { return node.value("name", "") == name; });
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

double turn_between(const Mat3d& a, const Mat3d& b) {
  return norm(rotation_vector(a * transpose(b)));
}

// A rotation without the scale of its node.
Mat3d unscaled(const Mat3d& m) { return {normalized(m.cx), normalized(m.cy), normalized(m.cz)}; }

// Volume by the divergence theorem: closed and seen from outside.
TEST(ThingExport, MeshesAreClosedAndHaveTheirSize) {
  const struct {
    ThingShape shape;
    double volume;
    double within;  // of the volume: by the sides of a polygon
  } cases[] = {{ThingShape::box, 0.2 * 0.3 * 0.2, 1e-9},
               {ThingShape::cylinder, kPi * 0.01 * 0.3, 0.015},
               {ThingShape::sphere, kPi * 0.008 / 6.0, 0.03}};
  for (const auto& [shape, volume, within] : cases) {
    const GltfMesh mesh = mesh_of({.shape = shape, .size = {0.2, 0.3, 0.2}}, 0.01);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < mesh.corners.size(); k += 3) {
      const auto at = [&](std::size_t c) { return mesh.positions.at(mesh.corners[k + c]); };
      const Vec3d face = cross(at(1) - at(0), at(2) - at(0));
      EXPECT_GT(norm(face), 1e-6);
      sum += dot(at(0), face) / 6.0;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_GT(dot(normalized(face), mesh.normals.at(mesh.corners[k + c])), 0.9);
      }
    }
    EXPECT_NEAR(sum * 1e-6, volume, within * volume) << word_of(shape);
    for (const Vec3d& normal : mesh.normals) EXPECT_NEAR(norm(normal), 1.0, 1e-12);
  }
}

// A thing on a hand moves as the hand does, whatever the unit and the axes of the file.
class ThingsOfCharacters : public testing::TestWithParam<std::pair<const char*, nlohmann::json>> {};

TEST_P(ThingsOfCharacters, AreInTheHandThatHoldsThem) {
  const WorkFolder folder;
  nlohmann::json person = person_gltf();
  nlohmann::json above = GetParam().second;
  above["name"] = "above";
  above["children"] = {0};
  person["nodes"].push_back(above);
  person["scenes"] = {{{"nodes", {person["nodes"].size() - 1}}}};
  folder.put("person.glb", glb(person.dump(), "data"));
  TaskFile file;
  file.character.source = "person.glb";
  ASSERT_TRUE(measure_character(file.character, folder.path()));
  file.goals = {{"right_hand", Vec3d{-0.1, 0.4, 0.3} * *file.character.stature}};
  const Task task = make_task(file, folder.path()).value();
  Candidate candidate = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  const Effector& hand = task.body.effector(task.body.find_effector("right_hand").value());
  ThingMotion& held = candidate.things.emplace_back();
  held.thing.name = "ball";
  Kinematics<double> placed(task.body);
  for (int f = 0; f < candidate.motion.clip.frames; ++f) {
    forward_kinematics<double>(task.body, candidate.motion.clip.frame(f), placed);
    held.poses.push_back({placed.link_rotation(hand.link), placed.point(hand.link, hand.point)});
  }
  const int grip = file.character.rig->file_node.at(
      static_cast<std::size_t>(rig_node(file.character, candidate.goals.front().node)));
  const double unit = node_unit(file.character);
  for (const bool in_place : {false, true}) {
    const auto bytes =
        export_candidate(file.character, task, candidate, FileFormat::glb, {.in_place = in_place});
    ASSERT_TRUE(bytes) << bytes.error().to_string();
    EXPECT_TRUE(parse_gltf_animation(*bytes, "person.glb", {.animation = kAnimation}));
    const ExportedGlb out(*bytes);
    const int ball = node_of(out, "ball");
    const Mat3d hand_first = unscaled(out.place(grip, kAnimation, 0).rotation);
    const Mat3d ball_first = out.place(ball, kAnimation, 0).rotation;
    for (int f = 0; f < out.frames(kAnimation); ++f) {
      const Transformd at = out.place(grip, kAnimation, f);
      const Transformd own = out.place(ball, kAnimation, f);
      EXPECT_LE(norm(own.translation - at.translation) * unit, kMillimetre) << f;
      EXPECT_LE(turn_between(own.rotation * transpose(ball_first),
                             unscaled(at.rotation) * transpose(hand_first)),
                kTenthDegree)
          << f;
    }
    // its size is the thing's
    const Json& mesh = out.json().at("meshes").back().at("primitives").at(0).at("attributes");
    const Json& high = out.json().at("accessors").at(mesh.at("POSITION").get<std::size_t>());
    EXPECT_NEAR(high.at("max").at(0).get<double>() * unit, 0.05, 1e-6);
    EXPECT_EQ(out.json().at("scenes").at(0).at("nodes").back(), ball);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, ThingsOfCharacters,
    testing::Values(
        std::pair<const char*, nlohmann::json>{"metres", nlohmann::json::object()},
        std::pair<const char*, nlohmann::json>{
            "centimetres",
            {{"matrix", {100.0, 0, 0, 0, 0, 0, 100.0, 0, 0, -100.0, 0, 0, 5.0, 7.0, 9.0, 1}}}},
        std::pair<const char*, nlohmann::json>{
            "mirrored", {{"scale", {-1.0, 1.0, 1.0}}, {"translation", {3.0, 0.5, -2.0}}}},
        std::pair<const char*, nlohmann::json>{
            "scaled", {{"rotation", {sqrt(0.5), 0, 0, sqrt(0.5)}}, {"scale", {1.2, 1.2, 1.2}}}}),
    [](const auto& of) { return of.param.first; });

}  // namespace
}  // namespace shigusa
