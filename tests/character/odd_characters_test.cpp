// SPDX-License-Identifier: MIT
// Unusual characters of users, each made here from one person by one change: measured, moved, and
// judged by the exported file's own forward kinematics.
#include <gmock/gmock.h>

#include <functional>
#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "core/index.hpp"
#include "document/character_export.hpp"
#include "formats/gltf_write.hpp"
#include "kinematics/rig.hpp"
#include "support/convention.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

constexpr double kMillimetre = 1e-3;
const std::string kMotion = "motion";

json& node(json& file, const std::string& name) {
  for (json& each : file["nodes"]) {
    if (each.value("name", "") == name) return each;
  }
  throw std::runtime_error("no node " + name);
}

std::size_t index_of(const json& file, const std::string& name) {
  for (std::size_t i = 0; i < file["nodes"].size(); ++i) {
    if (file["nodes"][i].value("name", "") == name) return i;
  }
  throw std::runtime_error("no node " + name);
}

// Moves the person below such a node.
std::function<void(json&)> below(json above) {
  above["name"] = "Armature";
  above["children"] = {0};
  return [above](json& file) { file["nodes"].push_back(above); };
}

void add_child(json& file, const std::string& parent, json child, bool first = false) {
  json& children = node(file, parent)["children"];
  children.insert(first ? children.begin() : children.end(), file["nodes"].size());
  file["nodes"].push_back(std::move(child));
}

// Turns a node relative to its parent about x (0), y or z.
void turn(json& file, const std::string& name, int axis, double angle_deg) {
  json& turned = node(file, name);
  const std::vector<double> was = turned.value("rotation", std::vector<double>{0, 0, 0, 1});
  const SinCos<double> half = sin_cos(radians(0.5 * angle_deg));
  double by[3] = {0, 0, 0};
  by[axis] = half.sin;
  const Quatd q = Quatd{by[0], by[1], by[2], half.cos} * Quatd{was[0], was[1], was[2], was[3]};
  turned["rotation"] = {q.x, q.y, q.z, q.w};
}

// A node of no length between a bone and its child.
void add_helper(json& file, const std::string& name) {
  const std::size_t child = index_of(file, name);
  json& below = file["nodes"][child];
  json helper{{"name", name + "_helper"}, {"children", {child}}};
  helper["translation"] = below["translation"];
  below["translation"] = {0.0, 0.0, 0.0};
  for (json& each : file["nodes"]) {
    if (!each.contains("children")) continue;
    for (json& index : each["children"]) {
      if (index == child) index = file["nodes"].size();
    }
  }
  file["nodes"].push_back(helper);
}

// The motion of a character whose right hand reaches ahead, as played by its exported file.
struct Played {
  int frames = 0;
  double mass = 0.0;                                               // kg, of the body
  std::function<Vec3d(const std::string& of, int frame)> at = {};  // where a body node's node is, m

  // How far the hand ends from its goal, m.
  double miss(const TaskFile& file) const {
    return norm(at("right_hand_grip", frames - 1) - file.goals.at(0).position);
  }
};

Result<Played> reach_with_right_hand(TaskFile& file) {
  file.goals = {{"right_hand", Vec3d{-0.1, 0.4, 0.3} * *file.character.stature}};
  const Task task = make_task(file, {}).value();
  const GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
  if (!generation.meets_goals()) {
    return fail(ErrorCode::unsupported, "the goal is not reached");
  }
  const Clip& clip = generation.candidates[0].motion.clip;
  const CharacterRig& rig = *file.character.rig;
  const CharacterExporter exporter(rig);
  const GltfAnimation animation = exporter.animation(task, clip, kMotion, {});
  const ExportedGlb out(exporter.glb(std::span(&animation, 1)).value());
  const auto at = [out, rig, &character = file.character](const std::string& of, int frame) {
    const int i = rig.file_node[static_cast<std::size_t>(rig_node(character, of))];
    return out.at(i, kMotion, frame) * rig.rig.placement.unit;
  };
  return Played{clip.frames, task.body.mass(), at};
}

struct Odd {
  const char* name;
  std::function<void(json&)> make;
  const char* doubt = "";  // a part of the doubt
  bool flat_feet = true;
};

class OddCharacters : public testing::TestWithParam<Odd> {};

TEST_P(OddCharacters, AreMappedAndKeepAllPromises) {
  json gltf = person_gltf();
  GetParam().make(gltf);
  TaskFile file;
  file.character = {.source = "odd.glb"};
  const auto loaded = load_character(glb(gltf.dump(), "data"), file.character);
  ASSERT_TRUE(loaded) << loaded.error().to_string();
  for (const auto& [bone, found] : file.character.humanoid) {
    if (!bone.starts_with("left_") && !bone.starts_with("right_")) continue;
    EXPECT_EQ(found, bone);
  }
  const double s = *file.character.stature;
  EXPECT_NEAR(s, 1.741, 0.01);
  if (*GetParam().doubt != '\0') {
    EXPECT_THAT(file.character.doubts, Contains(HasSubstr(GetParam().doubt)));
  }
  const Played played = reach_with_right_hand(file).value();
  const auto at = [&](const std::string& of, int frame) { return played.at(of, frame); };
  EXPECT_LE(played.miss(file), kMillimetre);
  for (const char* foot : {"left_foot", "right_foot"}) {
    for (int f = 0; f < played.frames; ++f) {
      EXPECT_LE(norm(at(foot, f) - at(foot, 0)), kMillimetre);
    }
  }
  // the left foot on the left, and both on the floor that goals are measured from
  EXPECT_GT(at("left_foot", 0).x, at("right_foot", 0).x);
  if (GetParam().flat_feet) {
    EXPECT_NEAR(at("left_foot", 0).y, 0.039 * s, 0.02);
  }
}

// From the page's data: nodes relative to their parents, with their scales.
TEST_P(OddCharacters, StandWhereTheirDescribedNodesPutThem) {
  json gltf = person_gltf();
  GetParam().make(gltf);
  CharacterSpec spec{.source = "odd.glb"};
  ASSERT_TRUE(load_character(glb(gltf.dump(), "data"), spec));
  const PosedBody posed = build_character(spec).value();
  Clip start;
  start.dofs = posed.body.dof_count();
  start.frames = 1;
  start.angles.assign(posed.home.angles.begin(), posed.home.angles.end());
  const std::vector<LocalTransform> locals = node_motion(spec, posed, start);
  std::vector<Transformd> placed;
  for (const CharacterNode& node : character_nodes(spec, posed)) {
    const LocalTransform& local = locals[placed.size()];
    const Mat3d turned = to_matrix(local.rotation);
    const Transformd in_parent{
        {turned.cx * node.scale.x, turned.cy * node.scale.y, turned.cz * node.scale.z},
        local.translation};
    placed.push_back(node.parent < 0 ? in_parent : placed[index(node.parent)] * in_parent);
  }
  const Vec3d hand = placed[index(spec.rig->rig.grips[1])].translation * node_unit(spec);
  EXPECT_LE(norm(hand - start_places(posed)[index(*posed.body.find_effector("right_hand"))]),
            kMillimetre);
}

void arms(json& file, double left_deg) {
  turn(file, "left_upper_arm", 2, left_deg);
  turn(file, "right_upper_arm", 2, -left_deg);
}

// As in Blender's export of a Rigify rig's deforming bones: trunk, clavicles, arms and legs each
// hang on the armature.
void limbs_beside_the_trunk(json& file) {
  const auto children_of = [&](const std::string& of) -> json& {
    return node(file, of)["children"];
  };
  const auto vec = [](const json& v) { return Vec3d{v[0], v[1], v[2]}; };
  const Vec3d hips = vec(node(file, "hips")["translation"]);
  const Vec3d chest = hips + vec(node(file, "chest")["translation"]);
  const std::size_t trunk = index_of(file, "hips");
  json roots = {trunk};
  for (const char* limb :
       {"left_upper_arm", "right_upper_arm", "left_upper_leg", "right_upper_leg"}) {
    const std::size_t i = index_of(file, limb);
    const bool leg = std::string(limb).ends_with("leg");
    json& above = children_of(leg ? "hips" : "chest");
    above.erase(std::find(above.begin(), above.end(), i));
    const Vec3d at = vec(file["nodes"][i]["translation"]) + (leg ? hips : chest);
    file["nodes"][i]["translation"] = {at.x, at.y, at.z};
    roots.push_back(i);
    if (leg) continue;
    // towards the middle from the shoulder
    roots.push_back(file["nodes"].size());
    file["nodes"].push_back(
        {{"name", std::string(limb).substr(0, limb[0] == 'l' ? 5 : 6) + "shoulder"},
         {"translation", {0.2 * at.x, at.y, at.z}}});
  }
  node(file, "hips")["name"] = "DEF-spine";
  file["nodes"].push_back({{"name", "Armature"}, {"children", roots}});
}

// As in Quaternius' older figures, to be moved separately.
void feet_on_the_root(json& file) {
  json roots = {0};
  const std::size_t above = file["nodes"].size();
  file["nodes"].push_back({{"name", "Root"}});
  for (const std::string side : {"left", "right"}) {
    Vec3d at{};
    for (const char* part : {"hips", "_upper_leg", "_lower_leg", "_foot"}) {
      const std::string name = part[0] == '_' ? side + part : part;
      const json& t = node(file, name)["translation"];
      at += Vec3d{t[0], t[1], t[2]};
    }
    const std::size_t foot = index_of(file, side + "_foot");
    json& shank = node(file, side + "_lower_leg")["children"];
    shank = {file["nodes"].size()};
    const json tip = file["nodes"][foot]["translation"];
    file["nodes"][foot]["translation"] = {at.x, at.y, at.z};
    file["nodes"].push_back({{"name", side + "_lower_leg_end"}, {"translation", tip}});
    roots.push_back(foot);
  }
  file["nodes"][above]["children"] = roots;
}

INSTANTIATE_TEST_SUITE_P(
    Of, OddCharacters,
    testing::Values(
        Odd{"ArmsDown", [](json&) {}}, Odd{"APose", [](json& f) { arms(f, 45.0); }},
        Odd{"TPose", [](json& f) { arms(f, 88.0); }},
        Odd{"Inches", below({{"scale", {39.37, 39.37, 39.37}}})},
        Odd{"CentimetresZUp",
            below({{"rotation", {sqrt(0.5), 0.0, 0.0, sqrt(0.5)}}, {"scale", {100, 100, 100}}})},
        Odd{"OnAPlinth", below({{"translation", {0.3, 0.8, -2.0}}})},
        Odd{"SunkenInTheFloor", below({{"translation", {0, -0.6, 0}}})},
        Odd{"FacingAway", below({{"rotation", {0.0, 1.0, 0.0, 0.0}}})},
        Odd{"UnevenScaleAbove", below({{"scale", {1.03, 1.0, 0.96}}}), "different scales"},
        Odd{"OtherRoots",
            [](json& f) {
              f["nodes"].push_back({{"name", "Camera"}, {"translation", {9, 9, 9}}});
              f["nodes"].push_back({{"name", "ik_hand_r"}, {"translation", {3, 1, 0}}});
              f["nodes"].push_back({{"name", "left_foot"}, {"translation", {-3, 1, 0}}});
            }},
        Odd{"ControlsInTheSkin",
            [](json& f) {
              add_child(f, "hips", {{"name", "ik_foot_l"}, {"translation", {0.1, -0.9, 0}}}, true);
              add_child(f, "hips", {{"name", "right_hand.IK"}, {"translation", {-0.4, 0, 0}}},
                        true);
              add_child(f, "hips", {{"name", "left_knee_pole"}, {"translation", {0.1, -0.4, 2}}},
                        true);
              add_child(f, "right_hand", {{"name", "sword"}, {"translation", {0.1, -1.2, 0.2}}});
              json joints = json::array();
              for (std::size_t i = 0; i < f["nodes"].size(); ++i) joints.push_back(i);
              f["skins"] = {{{"joints", joints}}};
            }},
        Odd{"BonesOfNoLength",
            [](json& f) {
              for (const char* bone : {"left_upper_leg", "left_lower_leg", "right_foot",
                                       "right_upper_arm", "right_lower_arm", "left_hand"}) {
                add_helper(f, bone);
              }
            }},
        Odd{"NamesTwice",
            [](json& f) {
              add_child(f, "head", {{"name", "head"}, {"translation", {0, 0.1, 0}}});
              add_child(f, "left_hand", {{"name", "left_hand"}, {"translation", {0, -0.1, 0}}});
              add_child(f, "right_foot", {{"name", "right_foot"}, {"translation", {0, 0, 0.1}}});
            }},
        Odd{"LimbsBesideTheTrunk", limbs_beside_the_trunk, "the limbs hang on joint 'Armature'"},
        Odd{"FeetOnTheRoot", feet_on_the_root, "does not hang on it"},
        Odd{"PosedInAStep",
            [](json& f) {
              turn(f, "left_upper_leg", 0, -22.0);
              turn(f, "right_upper_leg", 0, 22.0);
            },
            "", false},
        Odd{"PosedOddly",
            [](json& f) {
              turn(f, "left_upper_arm", 0, -70.0);
              turn(f, "right_upper_arm", 2, -60.0);
              turn(f, "right_lower_arm", 0, -80.0);
              turn(f, "chest", 1, 25.0);
              turn(f, "head", 1, 40.0);
            }}),
    [](const auto& of) { return std::string(of.param.name); });

std::string error_of(const json& gltf) {
  CharacterSpec spec{.source = "odd.glb"};
  const auto loaded = load_character(glb(gltf.dump(), "data"), spec);
  return loaded ? "" : loaded.error().to_string();
}

TEST(OddCharacter, ATrunkBesideItsLimbsIsFoundAndGoesWithThem) {
  json gltf = person_gltf();
  limbs_beside_the_trunk(gltf);
  CharacterSpec spec{.source = "odd.glb"};
  ASSERT_TRUE(load_character(glb(gltf.dump(), "data"), spec));
  for (const auto& [bone, found] : {std::pair{"hips", "Armature"},
                                    {"neck", "neck"},
                                    {"head", "head"},
                                    {"left_shoulder", "left_shoulder"},
                                    {"right_shoulder", "right_shoulder"}}) {
    EXPECT_THAT(spec.humanoid, Contains(testing::Pair(bone, found)));
  }
  const PosedBody posed = build_character(spec).value();
  Clip clip{.dofs = posed.body.dof_count(), .frames = 2, .angles = {}};
  for (int f = 0; f < clip.frames; ++f) {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    angles[static_cast<std::size_t>(posed.body.find_dof("right_hip.flexion").value())] += 0.5 * f;
    clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
  }
  const RigMotion moved = rig_motion(posed, clip, spec.rig->rig);
  const Skeleton& skeleton = spec.rig->skeleton;
  const SkeletonClip played{clip.frame_time, moved.frames, moved.local};
  const auto between = [&](const char* a, const char* b, int frame) {
    const auto world = world_transforms(skeleton, played, frame);
    return norm(world[static_cast<std::size_t>(skeleton.find(a))].translation -
                world[static_cast<std::size_t>(skeleton.find(b))].translation);
  };
  for (const auto& [a, b] : {std::pair{"DEF-spine", "left_upper_leg"},
                             {"DEF-spine", "right_upper_leg"},
                             {"neck", "left_upper_arm"},
                             {"neck", "right_upper_arm"},
                             {"head", "left_shoulder"}}) {
    EXPECT_NEAR(between(a, b, 1), between(a, b, 0), 1e-9) << a << ' ' << b;
  }
}

// A giant of 3.2 m and a toy of 0.3 m: a person of 1.70 m moves, and the file keeps its own size.
TEST(OddCharacter, OfNoPersonsSizeMovesAsAPersonAndPlaysOnItsFile) {
  for (const double size : {0.3, 3.2}) {
    json gltf = person_gltf();
    const double scale = size / 1.741;
    below({{"scale", {scale, scale, scale}}})(gltf);
    TaskFile file;
    file.character = {.source = "odd.glb"};
    ASSERT_TRUE(load_character(glb(gltf.dump(), "data"), file.character));
    EXPECT_EQ(*file.character.stature, 1.7);
    EXPECT_THAT(file.character.doubts, Contains(HasSubstr("a stature of 1.70 m is guessed")));
    const Played played = reach_with_right_hand(file).value();
    EXPECT_NEAR(played.mass, default_mass(1.7, Sex::male), 1e-9);
    EXPECT_NEAR(file.character.rig->rig.placement.unit, 1.7 / size, 0.01 / size);
    EXPECT_LE(played.miss(file), kMillimetre);
  }
}

TEST(OddCharacter, AnimalsAreRefusedUnlessAPersonInsists) {
  const StickFigure fox =
      read_convention(std::filesystem::path(SHIGUSA_SOURCE_DIR) / "tests/animals/fox.txt").figure;
  json file{{"asset", {{"version", "2.0"}}}, {"nodes", json::array()}};
  for (const StickFigure::Point& point : fox.points) {
    const Vec3d from =
        point.parent < 0 ? Vec3d{} : fox.points[static_cast<std::size_t>(point.parent)].at;
    const Vec3d off = point.at - from;
    if (point.parent >= 0) {
      file["nodes"][static_cast<std::size_t>(point.parent)]["children"].push_back(
          file["nodes"].size());
    }
    file["nodes"].push_back({{"name", point.name}, {"translation", {off.x, off.y, off.z}}});
  }
  CharacterSpec spec{.source = "fox.glb"};
  const auto refused = load_character(glb(file.dump()), spec);
  ASSERT_FALSE(refused);
  EXPECT_THAT(
      refused.error().to_string(),
      testing::AllOf(HasSubstr("fox.glb: no person: it stands on four legs"), HasSubstr("--map")));
  CharacterSpec insisted{.source = "fox.glb", .map = {{"head", "b_Head_05"}}};
  EXPECT_TRUE(load_character(glb(file.dump()), insisted));
}

TEST(OddCharacter, SidesThatNamesExchangeAreADoubt) {
  json file = person_gltf();
  for (json& each : file["nodes"]) {
    const std::string name = each.value("name", "");
    if (name.starts_with("left_")) each["name"] = "right_" + name.substr(5);
    if (name.starts_with("right_")) each["name"] = "left_" + name.substr(6);
  }
  CharacterSpec spec{.source = "odd.glb"};
  ASSERT_TRUE(load_character(glb(file.dump(), "data"), spec));
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("its left and right are exchanged")));
}

TEST(OddCharacter, ALimbOfNoLengthIsRefusedByName) {
  json file = person_gltf();
  for (const char* name : {"right_hand", "right_hand_grip"}) {
    node(file, name)["translation"] = {0.0, 0.0, 0.0};
  }
  EXPECT_THAT(error_of(file), HasSubstr("the right forearm has no length"));
}

TEST(OddCharacter, LegsOnARootOfTheirOwnAreRefused) {
  json file = person_gltf();
  json& children = node(file, "hips")["children"];
  for (const char* leg : {"left_upper_leg", "right_upper_leg"}) {
    children.erase(std::find(children.begin(), children.end(), index_of(file, leg)));
  }
  const json legs = {index_of(file, "left_upper_leg"), index_of(file, "right_upper_leg")};
  const json place = node(file, "hips")["translation"];
  file["nodes"].push_back({{"name", "legs"}, {"children", legs}, {"translation", place}});
  EXPECT_THAT(error_of(file), HasSubstr("the limbs hang on several roots"));
}

}  // namespace
}  // namespace shigusa
