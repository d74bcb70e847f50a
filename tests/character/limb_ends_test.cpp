// SPDX-License-Identifier: MIT
// Characters whose arms end at the forearms, or legs at the shanks.
#include "character/limb_ends.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <shigusa/character.hpp>
#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "document/character_export.hpp"
#include "formats/gltf_nodes.hpp"
#include "support/mesh_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

// The file without a node and its descendants.
json without(const json& gltf, const std::string& name) {
  std::vector<bool> gone(gltf["nodes"].size(), false);
  const std::function<void(int)> drop = [&](int i) {
    gone[static_cast<std::size_t>(i)] = true;
    for (const json& child :
         gltf["nodes"][static_cast<std::size_t>(i)].value("children", json::array())) {
      drop(child.get<int>());
    }
  };
  drop(index_of(gltf, name));
  std::vector<int> place(gone.size(), -1);
  json rest = gltf;
  rest["nodes"] = json::array();
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    place[i] = static_cast<int>(rest["nodes"].size());
    rest["nodes"].push_back(gltf["nodes"][i]);
  }
  for (json& node : rest["nodes"]) {
    json children = json::array();
    for (const json& child : node.value("children", json::array())) {
      const int to = place[child.get<std::size_t>()];
      if (to >= 0) children.push_back(to);
    }
    node.erase("children");
    if (!children.empty()) node["children"] = children;
  }
  return rest;
}

// A tube about the line from a node to a point.
void add_tube(std::vector<MeshPoint>& points, const json& gltf, const std::string& name,
              const Vec3d& end) {
  const ExportedGlb rest(glb(gltf.dump(), ""));
  const Vec3d from = rest.place(index_of(gltf, name)).translation;
  for (int i = 0; i <= 100; ++i) {
    const Vec3d out{0.03 * std::cos(2.4 * i), 0.0, 0.03 * std::sin(2.4 * i)};
    points.push_back(
        {from + (end - from) * (i / 100.0) + out * (i < 100 ? 1.0 : 0.0), index_of(gltf, name)});
  }
}

Vec3d place_of(const json& gltf, const std::string& name) {
  return ExportedGlb(glb(gltf.dump(), "")).place(index_of(gltf, name)).translation;
}

// A person without these limbs' ends, whose mesh reaches to their former places.
std::string ended(const std::string& end, const std::string& before, const Vec3d& beyond) {
  json gltf = person_gltf();
  std::vector<std::pair<std::string, Vec3d>> tips;
  for (const std::string side : {"left_", "right_"}) {
    tips.emplace_back(side + before, place_of(gltf, side + end) + beyond);
  }
  for (const std::string side : {"left_", "right_"}) gltf = without(gltf, side + end);
  std::vector<MeshPoint> points;
  for (const auto& [node, tip] : tips) add_tube(points, gltf, node, tip);
  MeshFile file(gltf);
  file.add_skinned(points);
  return file.bytes();
}

CharacterSpec loaded(const std::string& bytes) {
  CharacterSpec spec{.source = "ended.glb"};
  const auto done = load_character(bytes, spec);
  EXPECT_TRUE(done) << done.error().to_string();
  return spec;
}

std::string bone(const CharacterSpec& spec, const std::string& name) {
  for (const auto& [known, node] : spec.humanoid) {
    if (known == name) return node;
  }
  return "";
}

TEST(LimbEnds, AnArmThatEndsAtItsForearmGetsAHandWithinItsMesh) {
  const CharacterSpec plain = loaded(glb(person_gltf().dump(), ""));
  const CharacterSpec spec = loaded(ended("hand", "lower_arm", {0, -0.18, 0}));
  EXPECT_EQ(bone(spec, "left_hand"), "left_hand");
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("nothing follows joint 'left_lower_arm'")));
  const Landmarks::Arm& arm = spec.landmarks->left_arm;
  const Landmarks::Arm& whole = plain.landmarks->left_arm;
  EXPECT_NEAR(norm(arm.wrist - arm.elbow), norm(whole.wrist - whole.elbow), 0.02);
  EXPECT_NEAR(norm(arm.fingertip - arm.elbow), norm(whole.wrist - whole.elbow) + 0.18, 0.03);
}

TEST(LimbEnds, ALegThatEndsAtItsShankGetsAFoot) {
  const CharacterSpec plain = loaded(glb(person_gltf().dump(), ""));
  const CharacterSpec spec = loaded(ended("foot", "lower_leg", {0, -0.065, 0}));
  EXPECT_EQ(bone(spec, "right_foot"), "right_foot");
  const Landmarks::Leg& leg = spec.landmarks->right_leg;
  const Landmarks::Leg& whole = plain.landmarks->right_leg;
  EXPECT_NEAR(norm(leg.knee - leg.ankle), norm(whole.knee - whole.ankle), 0.02);
}

// The written file has the hands, so that a reader finds them again.
TEST(LimbEnds, MotionsLeaveOnTheFileWithItsHands) {
  TaskFile file;
  file.character = loaded(ended("hand", "lower_arm", {0, -0.18, 0}));
  file.goals = {{"right_hand", Vec3d{-0.2, 1.0, 0.4}}};
  const Task task = make_task(file, {}).value();
  const GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
  const Clip& clip = generation.candidates[0].motion.clip;
  const CharacterRig& rig = *file.character.rig;
  const CharacterExporter exporter(rig);
  const GltfAnimation animation = exporter.animation(task, clip, "motion", {});
  const std::string bytes = exporter.glb(std::span(&animation, 1)).value();
  const CharacterSpec again = loaded(bytes);
  EXPECT_EQ(again.humanoid, file.character.humanoid);
  const ExportedGlb shown(bytes);
  const int hand =
      rig.file_node[static_cast<std::size_t>(rig_node(file.character, "right_hand_grip"))];
  const Vec3d at =
      rig.rig.placement.to_world(shown.place(hand, "motion", clip.frames - 1).translation);
  EXPECT_LT(norm(at - file.goals[0].position), 0.01);
}

TEST(LimbEnds, WhoHasHandsAndFeetStaysByteForByte) {
  const json gltf = person_gltf();
  const std::string bytes = glb(gltf.dump(), "");
  const GltfCharacter file = parse_gltf(bytes, "whole.glb").value();
  EXPECT_FALSE(with_limb_ends(bytes, "whole.glb", file, {}));
}

TEST(LimbEnds, NodesAreAddedBehindTheFilesOwn) {
  const std::string text =
      R"({"asset":{"version":"2.0"},"nodes":[{"name":"a","children":[1]},{"name":"b"},{}]})";
  const std::vector<GltfNewNode> added{
      {1, "c", {0, 1, 0}, Vec3d{0, 0, 1}}, {0, "d", {}, {}}, {2, "e", {}, {}}};
  const json file = json::parse(add_nodes(text, "text.gltf", added).value());
  ASSERT_EQ(file["nodes"].size(), 7u);
  EXPECT_EQ(file["nodes"][0]["children"], json({1, 5}));
  EXPECT_EQ(file["nodes"][1]["children"], json({3}));
  EXPECT_EQ(file["nodes"][2]["children"], json({6}));
  EXPECT_EQ(file["nodes"][3]["children"], json({4}));
  EXPECT_EQ(file["nodes"][4]["name"], "c end");
  EXPECT_EQ(file["nodes"][4]["translation"], json({0.0, 0.0, 1.0}));
}

}  // namespace
}  // namespace shigusa
