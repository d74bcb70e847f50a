// SPDX-License-Identifier: MIT
#include "formats/gltf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/human.hpp>

#include "formats/glb.hpp"
#include "formats/gltf_json.hpp"
#include "formats/gltf_nodes.hpp"
#include "measure/measure_person.hpp"
#include "rig/find_humanoid.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kRounding = 1e-12;  // of some products of numbers near 1

// A file of these nodes; `more` are further members.
std::string file_of(const std::string& nodes, const std::string& more = "") {
  return R"({"asset": {"version": "2.0"}, "nodes": [)" + nodes + "]" + more + "}";
}

GltfCharacter read(const std::string& bytes) {
  auto file = parse_gltf(bytes, "hero.vrm");
  EXPECT_TRUE(file) << file.error().to_string();
  return file ? std::move(*file) : GltfCharacter{};
}

Vec3d place(const GltfCharacter& character, std::string_view name) {
  const SkeletonMotion& rest = character.rest;
  const auto world = world_transforms(rest.skeleton, rest.clip, 0);
  return world.at(static_cast<std::size_t>(rest.skeleton.find(name))).translation;
}

void expect_place(const GltfCharacter& character, std::string_view name, const Vec3d& at) {
  EXPECT_LE(norm(place(character, name) - at), kRounding) << name;
}

std::vector<std::string> names(const GltfCharacter& character) {
  std::vector<std::string> all;
  for (const SkeletonNode& node : character.rest.skeleton.nodes) all.push_back(node.name);
  return all;
}

TEST(Gltf, ChildrenTurnWithTheirParent) {
  // a quarter turn about z takes +y to -x
  const GltfCharacter c = read(file_of(
      R"({"name": "a", "translation": [1, 2, 3], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476],
          "children": [1]},
         {"name": "b", "translation": [0, 1, 0]})"));
  expect_place(c, "a", {1, 2, 3});
  expect_place(c, "b", {0, 2, 3});
  EXPECT_EQ(c.rest.clip.frames, 1);
  EXPECT_THAT(c.file_node, ElementsAre(0, 1));
  EXPECT_EQ(c.vrm, VrmVersion::none);
  EXPECT_THAT(c.doubts, IsEmpty());
}

TEST(Gltf, RestPoseTurnsNoNode) {
  const GltfCharacter c = read(file_of(
      R"({"name": "a", "rotation": [0, 0, 1, 0], "children": [1]}, {"translation": [0, 1, 0]})"));
  EXPECT_EQ(c.rest.clip.local[1].rotation, Quatd{});
  EXPECT_LE(norm(c.rest.skeleton.nodes[1].offset - Vec3d{0, -1, 0}), kRounding);
}

TEST(Gltf, MatrixStandsForAPlace) {
  // an armature with z up, as CesiumMan's
  const GltfCharacter c = read(file_of(
      R"({"matrix": [1,0,0,0, 0,0,-1,0, 0,1,0,0, 0,0,0,1], "children": [1]},
         {"name": "hips", "translation": [0.1, 0.2, 0.9]})"));
  expect_place(c, "hips", {0.1, 0.9, -0.2});
}

TEST(Gltf, RotationsOfAnyLengthAreTurns) {
  const GltfCharacter c = read(file_of(
      R"({"rotation": [0, 0, 3, 3], "children": [1]}, {"name": "b", "translation": [0, 1, 0]})"));
  expect_place(c, "b", {-1, 0, 0});
}

TEST(Gltf, ScalesGoIntoTheOffsets) {
  const GltfCharacter c = read(file_of(
      R"({"scale": [0.01, 0.01, 0.01], "children": [1]},
         {"name": "b", "translation": [0, 90, 0], "scale": [-1, 1, 1], "children": [2]},
         {"name": "c", "translation": [10, 0, 0]})"));
  expect_place(c, "b", {0, 0.9, 0});
  expect_place(c, "c", {-0.1, 0.9, 0});
  EXPECT_THAT(c.doubts, IsEmpty());
}

TEST(Gltf, UnevenScaleOfABoneIsADoubt) {
  const std::string scaled = R"({"name": "chest", "scale": [1, 2, 1], "children": [1, 2]})";
  const GltfCharacter c =
      read(file_of(scaled + R"(, {"name": "b", "translation": [1, 1, 0]}, {"scale": [1, 3, 1]})"));
  expect_place(c, "b", {1, 2, 0});
  ASSERT_EQ(c.doubts.size(), 1u);
  EXPECT_THAT(c.doubts[0], HasSubstr("node 0 'chest' has different scales along its axes"));
}

TEST(Gltf, NamesAreUniqueAndNodesWithoutNameAreCalledByTheirIndex) {
  EXPECT_THAT(names(read(file_of(R"({"name": "a"}, {"name": "a"}, {}, {"name": "a_2"})"))),
              ElementsAre("a", "a_2", "node 2", "a_2_2"));
}

TEST(Gltf, ParentsComeBeforeTheirChildren) {
  const GltfCharacter c = read(file_of(
      R"({"name": "tip"}, {"name": "low", "children": [0]}, {"name": "root", "children": [3, 1]},
         {"name": "high"})"));
  EXPECT_THAT(names(c), ElementsAre("root", "high", "low", "tip"));
  EXPECT_THAT(c.file_node, ElementsAre(2, 3, 1, 0));
  EXPECT_EQ(c.rest.skeleton.nodes[3].parent, 2);
}

TEST(Gltf, OnlyJointsAndWhatTheyHangOnAreTaken) {
  const GltfCharacter c = read(file_of(
      R"({"name": "rig", "children": [1, 4]}, {"name": "hand", "children": [2, 3]},
         {"name": "sword", "mesh": 0}, {"name": "fingertip"}, {"name": "body", "mesh": 1},
         {"name": "lamp"})",
      R"(, "skins": [{"joints": [1]}])"));
  EXPECT_THAT(names(c), ElementsAre("rig", "hand", "fingertip"));
}

// The person with a skin over the trunk, as in mannequins: each limb has a part of it, whose own
// origin is elsewhere.
nlohmann::json person_with_rigid_limbs() {
  nlohmann::json file = person_gltf();
  nlohmann::json& nodes = file["nodes"];
  nlohmann::json joints = nlohmann::json::array();
  const std::size_t count = nodes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = nodes[i].value("name", "");
    if (name == "hips" || name == "spine" || name == "chest" || name == "neck") joints.push_back(i);
    if (!name.starts_with("left_") && !name.starts_with("right_") && name != "head") continue;
    nodes[i]["children"].push_back(nodes.size());
    nodes.push_back({{"mesh", 0}, {"translation", {-0.3, -1.4, 0.2}}});
  }
  file["skins"] = {{{"joints", joints}}};
  return file;
}

TEST(Gltf, LimbsOfRigidPartsAreBones) {
  const GltfCharacter whole = read(person_gltf().dump());
  const GltfCharacter c = read(person_with_rigid_limbs().dump());
  EXPECT_EQ(names(c), names(whole));
  for (const std::string& name : names(whole)) EXPECT_EQ(place(c, name), place(whole, name));
  ASSERT_EQ(c.doubts.size(), 1u);
  EXPECT_THAT(c.doubts[0], HasSubstr("make no whole person"));
  EXPECT_EQ(c.meshes.size(), person_with_rigid_limbs()["nodes"].size() - names(whole).size());
  for (const GltfMeshNode& mesh : c.meshes) EXPECT_GE(mesh.node, 0);
}

TEST(Gltf, JointsOfAPersonAreTakenAlone) {
  nlohmann::json file = person_with_rigid_limbs();
  nlohmann::json joints = nlohmann::json::array();
  for (std::size_t i = 0; i < person_gltf()["nodes"].size(); ++i) joints.push_back(i);
  file["skins"] = {{{"joints", joints}}};
  file["nodes"].push_back({{"name", "lamp"}});
  EXPECT_EQ(names(read(file.dump())), names(read(person_gltf().dump())));
}

TEST(Gltf, GlbIsReadAsItsJson) {
  const std::string json = person_gltf().dump();
  const GltfCharacter text = read(json);
  const GltfCharacter binary = read(glb(json));
  EXPECT_EQ(names(text), names(binary));
  for (const std::string& name : names(text)) EXPECT_EQ(place(text, name), place(binary, name));
}

// Zeros at the end of a GLB's text, as some writers leave them, are not part of the text.
TEST(Gltf, ZerosAfterTheTextOfAGlbAreLeftOut) {
  const std::string json = person_gltf().dump();
  for (const std::size_t zeros : {1U, 2U, 3U, 6U}) {
    std::string padded = json + std::string((4 - (json.size() + zeros) % 4) % 4, ' ');
    padded += std::string(zeros, '\0');
    padded.resize((padded.size() + 3) / 4 * 4, '\0');
    const std::string file = glb(padded);
    EXPECT_EQ(names(read(file)), names(read(json)));
    GltfNewNode added;
    added.name = "more";
    added.parent = 0;
    added.translation = {0, 1, 0};
    const std::string changed = add_nodes(file, "hero.glb", {&added, 1}).value();
    const GlbParts parts = glb_parts(changed, "hero.glb").value();
    EXPECT_EQ(parts.json.find('\0'), parts.json.npos) << zeros;
    EXPECT_EQ(parts.binary, "mesh");
  }
}

// The person's file with one more node, and that node's members.
nlohmann::json with_rock(const char* members) {
  nlohmann::json file = person_gltf();
  file["nodes"].push_back(nlohmann::json::parse(members));
  file["nodes"].back()["name"] = "rock";
  return file;
}

TEST(Gltf, DamagedSceneryIsLeftOutWithADoubt) {
  const std::vector<std::string> whole = names(read(person_gltf().dump()));
  for (const char* members :
       {R"({"rotation": [0, 0, 0, 0]})", R"({"translation": [1e30, 0, 0]})",
        R"({"matrix": [1, 2, 3]})", R"({"children": [9999]})", R"({"scale": "big"})"}) {
    const GltfCharacter character = read(with_rock(members).dump());
    EXPECT_EQ(names(character), whole) << members;
    EXPECT_THAT(character.doubts,
                testing::Contains(HasSubstr("1 nodes or skins of the file are damaged")))
        << members;
  }
  nlohmann::json circle = with_rock("{}");
  const auto rock = circle["nodes"].size() - 1;
  circle["nodes"].back()["children"] = {rock + 1};
  circle["nodes"].push_back({{"name", "moss"}, {"children", {rock}}});
  EXPECT_EQ(names(read(circle.dump())), whole);
  nlohmann::json skins = person_gltf();
  skins["skins"] = {{{"joints", {9999}}}};
  EXPECT_EQ(names(read(skins.dump())), whole);
}

TEST(Gltf, DamagedBonesAreRefused) {
  // hips, of which a person has no lack, and a neck that a skin binds
  for (const std::size_t at : {std::size_t{0}, std::size_t{1}}) {
    nlohmann::json file = person_gltf();
    const std::string bone = file["nodes"][at]["name"].get<std::string>();
    file["nodes"][at]["rotation"] = {0, 0, 0, 0};
    if (at > 0) file["skins"] = {{{"joints", {0, at}}}};
    const auto read = parse_gltf(file.dump(), "hero.vrm");
    ASSERT_FALSE(read) << bone;
    EXPECT_THAT(read.error().to_string(), HasSubstr("quaternion of length 0"));
    EXPECT_THAT(read.error().to_string(), HasSubstr(bone));
  }
}

TEST(Gltf, PersonStandsWhereTheirBvhPutsThem) {
  const SkeletonMotion bvh = parse_bvh(person_bvh(), "person.bvh").value();
  const auto world = world_transforms(bvh.skeleton, bvh.clip, 0);
  const GltfCharacter c = read(person_gltf().dump());
  for (std::size_t i = 0; i < world.size(); ++i) {
    const std::string& name = bvh.skeleton.nodes[i].name;
    if (!name.empty()) expect_place(c, name, world[i].translation * 0.01);
  }
}

// The person with the bones of `map` instead of names: VRM node index = index in person_gltf.
nlohmann::json nameless_person() {
  nlohmann::json file = person_gltf();
  for (nlohmann::json& node : file["nodes"]) node.erase("name");
  return file;
}

HumanoidMap person_map() {
  const GltfCharacter c = read(person_gltf().dump());
  return find_humanoid(c.rest.skeleton, world_transforms(c.rest.skeleton, c.rest.clip, 0)).value();
}

nlohmann::json vrm0_person() {
  nlohmann::json file = nameless_person();
  const HumanoidMap map = person_map();
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<HumanoidBone>(b);
    file["extensions"]["VRM"]["humanoid"]["humanBones"].push_back(
        {{"bone", camel_case(humanoid_bone_name(bone))}, {"node", map[bone]}});
  }
  return file;
}

nlohmann::json vrm1_person() {
  nlohmann::json file = nameless_person();
  const HumanoidMap map = person_map();
  for (int b = 0; b < kHumanoidBoneCount; ++b) {
    const auto bone = static_cast<HumanoidBone>(b);
    file["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"][camel_case(humanoid_bone_name(bone))] =
        {{"node", map[bone]}};
  }
  return file;
}

// The file's own node of each bone.
std::array<int, kHumanoidBoneCount> file_nodes(const GltfCharacter& c) {
  std::array<int, kHumanoidBoneCount> nodes = c.humanoid.node;
  for (int& node : nodes) node = node < 0 ? -1 : c.file_node[static_cast<std::size_t>(node)];
  return nodes;
}

TEST(Vrm, BonesOfBothVersionsAreRead) {
  const GltfCharacter old = read(glb(vrm0_person().dump()));
  EXPECT_EQ(old.vrm, VrmVersion::v0);
  EXPECT_EQ(file_nodes(old), person_map().node);
  EXPECT_THAT(old.doubts, IsEmpty());
  const GltfCharacter now = read(glb(vrm1_person().dump()));
  EXPECT_EQ(now.vrm, VrmVersion::v1);
  EXPECT_EQ(file_nodes(now), person_map().node);
  EXPECT_THAT(now.doubts, IsEmpty());
}

TEST(Vrm, WrongBonesAreLeftOutWithADoubt) {
  nlohmann::json file = vrm0_person();
  nlohmann::json& bones = file["extensions"]["VRM"]["humanoid"]["humanBones"];
  bones.push_back({{"bone", "leftHand"}, {"node", 0}});
  bones.push_back({{"bone", "jaw"}, {"node", 9999}});
  bones.push_back({{"bone", "leftEye"}, {"node", -1}});  // UniVRM's entry for a missing bone
  bones.push_back(7);
  const GltfCharacter c = read(file.dump());
  EXPECT_EQ(file_nodes(c), person_map().node);
  ASSERT_EQ(c.doubts.size(), 1u);
  EXPECT_THAT(c.doubts[0], HasSubstr("wrong in 3 places"));
  EXPECT_THAT(c.doubts[0], HasSubstr("\"leftHand\" comes twice"));
}

TEST(Vrm, PersonOf0xWhoFacesBackwardsIsMeasuredAsTheSame) {
  // half a turn about y, around all
  nlohmann::json file = vrm0_person();
  nlohmann::json& nodes = file["nodes"];
  nodes.push_back({{"rotation", {0, 1, 0, 0}}, {"children", {0}}});
  const auto measured = [](const GltfCharacter& c) {
    const auto world = world_transforms(c.rest.skeleton, c.rest.clip, 0);
    const HumanoidMap map = find_humanoid(c.rest.skeleton, world, c.humanoid).value();
    return measure_person(c.rest.skeleton, world, map).value();
  };
  const Landmarks turned = measured(read(file.dump())).landmarks;
  const Landmarks plain = measured(read(vrm1_person().dump())).landmarks;
  EXPECT_LE(norm(turned.left_arm.wrist - plain.left_arm.wrist), kRounding);
  EXPECT_LE(norm(turned.right_leg.toe - plain.right_leg.toe), kRounding);
  EXPECT_GT(turned.left_leg.hip.x, 0.0);
  EXPECT_GT(turned.left_leg.toe.z, turned.left_leg.ankle.z);
}

TEST(Gltf, ValuesInMessagesAreCutAtSixtyCharacters) {
  const std::string sixty = '"' + std::string(58, 'a') + '"';
  EXPECT_EQ(json_shown(std::string(58, 'a')), sixty);
  EXPECT_EQ(json_shown(std::string(59, 'a')), '"' + std::string(59, 'a') + "…");
  EXPECT_EQ(json_shown(std::string("é")), "\"\\u00e9\"");
}

TEST(Gltf, MeshesInTheTextCostNothing) {
  std::string list = "[0";
  for (int i = 0; i < 1'000'000; ++i) list += ",0";
  const GltfCharacter c = read(
      R"({"meshes": [)" + list + R"(]], "buffers": [{"uri": "data:)" + std::string(5'000'000, 'A') +
      R"("}], "asset": {"version": "2.0"}, "nodes": [{"extras": )" + list +
      R"(]}], "extensions": {"VRM": {"blendShapeMaster": )" + list + "]}}}");
  EXPECT_EQ(c.rest.skeleton.nodes.size(), 1u);
}

TEST(Gltf, ExtrasOfNodesCostNothing) {
  for (const char* each : {"[]", "{}", "{\"name\": []}"}) {
    std::string list = each;
    for (int i = 0; i < 6000; ++i) list += std::string(",") + each;
    for (const std::string& extras : {"[" + list + "]", R"({"children": [)" + list + "]}"}) {
      const GltfCharacter c = read(
          R"({"asset": {"version": "2.0"}, "nodes": [{"name": "a", "extras": )" + extras + "}]}");
      EXPECT_EQ(c.rest.skeleton.nodes.size(), 1u);
    }
  }
}

std::string many(int count, const std::string& text) {
  std::string all = text;
  for (int i = 1; i < count; ++i) all += "," + text;
  return all;
}

TEST(Gltf, JsonLargerThanItMayBeIsRefused) {
  const auto file = parse_gltf(
      file_of(R"({"name": ")" + std::string(kGltfMaxJsonBytes, 'a') + "\"}"), "hero.vrm");
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().to_string(), HasSubstr("JSON part has 41943"));
  EXPECT_THAT(file.error().to_string(), HasSubstr("41943040"));
}

const std::string kGlb = glb(file_of("{}"));

TEST(Gltf, MalformedFilesAreRefusedWithTheirPlace) {
  const std::pair<std::string, std::vector<std::string>> table[] = {
      {"", {"empty"}},
      {"HIERARCHY", {"not glTF", "line 1"}},
      {R"({"asset": {"version": "2.0"}, "nodes": [{)", {"not glTF", "line 1"}},
      {"[]", {"no object"}},
      {"{}", {"asset.version"}},
      {R"({"asset": {"version": "1.0"}})", {"version \"1.0\"", "2.0"}},
      {R"({"asset": {"version": "2.0"}})", {"no nodes"}},
      {R"({"asset": {"version": "2.0"}, "nodes": 5})", {"no nodes"}},
      {file_of("{}, 5"), {"node 1", "5"}},
      {std::string(100'000, '['), {"nested deeper than 64"}},
      {file_of(R"({"extras": )" + std::string(100'000, '[')), {"nested"}},
      {file_of(many(4097, "{}")), {"more than 4096 entries in nodes"}},
      {file_of(R"({"children": [)" + many(600'000, "0") + "]}"), {"more than 500000 values"}},
      {file_of(R"({"name": ")" + std::string(300, 'a') + "\"}"), {"node 0", "300 bytes", "256"}},
      {file_of(R"({"translation": [0, 1e999, 0]})"), {"not glTF", "1e999"}},
      {file_of(R"({}, {"name": "a", "children": [2]}, {"children": [1]})"),
       {"node 1 'a' of hero.vrm", "its own descendant"}},
      {file_of(R"({"children": [0]})"), {"node 0", "its own descendant"}},
      {file_of(R"({"children": [2]}, {"children": [2]}, {"name": "c"})"),
       {"node 2 'c'", "a child of node 0 and of node 1"}},
      {file_of(R"({"children": [7]})"), {"node 0", "7", "0 to 0"}},
      {file_of(R"({"children": [-1]})"), {"node 0", "-1"}},
      {file_of(R"({"children": [18446744073709551615]})"), {"18446744073709551615"}},
      {file_of(R"({"children": {}})"), {"node 0", "no list"}},
      {file_of("{}", R"(, "skins": [{}, {"joints": [1]}])"),
       {"skin 1 of hero.vrm", "joints holds 1", "0 to 0"}},
      {file_of("{}", R"(, "skins": 3)"), {"skins is 3"}},
      {file_of(R"({"translation": [1, 2]})"), {"node 0", "3 numbers"}},
      {file_of(R"({"scale": [1, "x", 1]})"), {"scale is [1,\"x\",1]"}},
      {file_of(R"({"rotation": null})"), {"rotation is null", "4 numbers"}},
      {file_of(R"({"translation": [0, 2e9, 0]})"), {"from -1e+09 to 1e+09"}},
      {file_of(R"({"scale": [1e9, 1e9, 1e9], "children": [1]}, {"translation": [9, 9, 9]})"),
       {"node 1", "from the origin"}},
      {file_of(R"({"rotation": [0, 0, 0, 0]})"), {"quaternion of length 0"}},
      {file_of(R"({"matrix": [1]})"), {"matrix", "16 numbers"}},
      {kGlb.substr(0, 13), {"ends after 13 bytes", "20"}},
      {kGlb.substr(0, kGlb.size() - 1), {"its header tells", "ends after"}},
      {std::string(kGlb).replace(4, 4, word_bytes(1)), {"version 1", "2"}},
      {std::string(kGlb).replace(8, 4, word_bytes(3'000'000'000)), {"3000000000 bytes"}},
      {std::string(kGlb).replace(12, 4, word_bytes(3'000'000'000)),
       {"first chunk", "3000000000 bytes"}},
      {std::string(kGlb).replace(16, 4, "BIN_"), {"first chunk"}},
      {std::string(kGlb).replace(20, 4, std::string("\0\xff\x1b[", 4)), {"not glTF"}},
  };
  for (const auto& [bytes, told] : table) {
    const auto file = parse_gltf(bytes, "hero.vrm");
    ASSERT_FALSE(file) << testing::PrintToString(told);
    EXPECT_THAT(file.error().to_string(), HasSubstr("hero.vrm: "));
    for (const std::string& words : told) EXPECT_THAT(file.error().to_string(), HasSubstr(words));
  }
}

}  // namespace
}  // namespace shigusa
