// SPDX-License-Identifier: MIT
// Motions on the character's own skeleton, judged by the files' own forward kinematics.
#include <gmock/gmock.h>

#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "document/schema_check.hpp"
#include "measure/measure_person.hpp"
#include "support/exported.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;
// numbers of a GLB are floats, of a chain of joints some decimetres each
constexpr double kFloats = 2e-6;  // m
const std::string kAnimation = "shigusa candidate 1";

nlohmann::json identity_rotation() { return {0.0, 0.0, 0.0, 1.0}; }

// person_gltf with a node above its root.
nlohmann::json below(nlohmann::json above) {
  nlohmann::json file = person_gltf();
  above["name"] = "above";
  above["children"] = {0};
  file["nodes"].push_back(above);
  return file;
}

// The person in a T-pose, facing -Z as in VRM 0.x, with VRM's names for a few bones.
nlohmann::json vrm_person() {
  const double half = sqrt(0.5);
  nlohmann::json file = below({{"rotation", {0.0, 1.0, 0.0, 0.0}}});
  nlohmann::json bones = nlohmann::json::array();
  const auto name_bone = [&](const char* bone, const char* node) {
    for (std::size_t i = 0; i < file["nodes"].size(); ++i) {
      if (file["nodes"][i].value("name", "") == node) {
        bones.push_back({{"bone", bone}, {"node", i}});
      }
    }
  };
  for (const auto& [bone, node] : {std::pair{"hips", "hips"},
                                   {"spine", "chest"},
                                   {"neck", "neck"},
                                   {"head", "head"},
                                   {"leftUpperLeg", "left_upper_leg"},
                                   {"leftLowerLeg", "left_lower_leg"},
                                   {"leftFoot", "left_foot"},
                                   {"rightUpperLeg", "right_upper_leg"},
                                   {"rightLowerLeg", "right_lower_leg"},
                                   {"rightFoot", "right_foot"},
                                   {"leftUpperArm", "left_upper_arm"},
                                   {"leftLowerArm", "left_lower_arm"},
                                   {"leftHand", "left_hand"},
                                   {"rightUpperArm", "right_upper_arm"},
                                   {"rightLowerArm", "right_lower_arm"},
                                   {"rightHand", "right_hand"}}) {
    name_bone(bone, node);
  }
  for (nlohmann::json& node : file["nodes"]) {
    if (node.value("name", "") == "left_upper_arm") node["rotation"] = {0.0, 0.0, half, half};
    if (node.value("name", "") == "right_upper_arm") node["rotation"] = {0.0, 0.0, -half, half};
  }
  file["extensions"]["VRM"]["humanoid"]["humanBones"] = bones;
  return file;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

class CharacterExport : public testing::Test {
 protected:
  // Bends the person of a file to a low goal and writes the result; candidates with all weights 1.
  void reach(const std::string& name, const std::string& formats, bool one_file = false) {
    file_.character = {
        .source = name, .extent = file_.character.extent, .heels = file_.character.heels};
    const auto measured = measure_character(file_.character, work_.path());
    ASSERT_TRUE(measured) << measured.error().to_string();
    const double s = *file_.character.stature;
    file_.goals = {{"right_hand", goal_ * s}};
    const Task task = make_task(file_, work_.path()).value();
    GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
    ASSERT_TRUE(generation.meets_goals()) << generation.remaining_distance;
    if (one_file) generation.candidates.push_back(generation.candidates[0]);
    const auto written =
        write_result(work_.path(), {file_, task, generation},
                     {.formats = parse_formats(formats).value(), .one_file = one_file});
    ASSERT_TRUE(written) << written.error().to_string();
    summary_ = Json::parse(written->summary);
    EXPECT_EQ(
        SchemaCheck::in_docs("result.schema.json").judge(nlohmann::json::parse(written->summary)),
        "");
  }
  void reach_with(const std::string& name, const nlohmann::json& gltf, const std::string& formats) {
    work_.put(name, glb(gltf.dump(), "data"));
    reach(name, formats);
  }

  [[nodiscard]] const Json& candidate() const { return summary_.at("candidates").at(0); }

  // Goal and feet by the GLB's own numbers; `unit`: m per unit of the file.
  void expect_kept(double unit = 1.0) const {
    const ExportedGlb out(work_.get(candidate().at("files").at("glb")));
    const int frames = out.frames(kAnimation);
    ASSERT_EQ(frames, candidate().at("file_frames"));
    ASSERT_LT(candidate().at("read_back").at("glb").at("effector_mm").get<double>(), 1e3 * kFloats);
    ASSERT_LT(candidate().at("read_back").at("glb").at("feet_mm").get<double>(), 1e3 * kFloats);
    const Json& goal = candidate().at("reached").at(0);
    const Vec3d hand = out.at(goal.at("gltf_node"), kAnimation, frames - 1) * unit;
    const Vec3d wanted{goal.at("goal_m").at(0), goal.at("goal_m").at(1), goal.at("goal_m").at(2)};
    EXPECT_LE(norm(hand - wanted), kMillimetre);
    for (const Json& contact : candidate().at("contacts")) {
      const int foot = contact.at("gltf_node");
      const Transformd first = out.place(foot, kAnimation, 0);
      for (int f = 0; f < frames; ++f) {
        const Transformd now = out.place(foot, kAnimation, f);
        EXPECT_LE(norm(now.translation - first.translation) * unit, kMillimetre);
        EXPECT_LE(norm(now.rotation.cx - first.rotation.cx) / norm(first.rotation.cx),
                  radians(0.1));
      }
    }
  }

  // Goal and feet by a BVH's own kinematics.
  void expect_bvh_kept(const std::string& bvh) const {
    const ExportedMotion motion(bvh, candidate().at("bvh_unit_m"));
    const Json& goal = candidate().at("reached").at(0);
    const Vec3d wanted{goal.at("goal_m").at(0), goal.at("goal_m").at(1), goal.at("goal_m").at(2)};
    EXPECT_LE(norm(motion.at_end(goal.at("joint")) - wanted), kMillimetre);
    for (const Json& contact : candidate().at("contacts")) {
      EXPECT_LE(motion.slide(contact.at("joint")), kMillimetre);
      EXPECT_LE(motion.tilt(contact.at("joint")), radians(0.1));
    }
  }

  WorkFolder work_;
  Vec3d goal_{-0.1, 0.4, 0.3};  // in statures
  TaskFile file_;
  Json summary_;
};

TEST_F(CharacterExport, GlbMeetsTheGoalOnTheFilesOwnNodes) {
  reach_with("person.glb", person_gltf(), "glb");
  expect_kept();
  EXPECT_EQ(candidate().at("reached").at(0).at("joint"), "right_hand_grip");
  EXPECT_EQ(candidate().at("glb_animation"), kAnimation);
}

// On tiptoe the file's toes stay in their start positions, and its feet rise.
TEST_F(CharacterExport, ToesStayWhereHeelsLift) {
  file_.character.heels = true;
  goal_ = {-0.14, 0.0, 0.09};
  nlohmann::json vrm = vrm_person();
  for (std::size_t i = 0; i < vrm["nodes"].size(); ++i) {
    const std::string name = vrm["nodes"][i].value("name", "");
    if (!name.ends_with("_toes")) continue;
    const char* bone = name == "left_toes" ? "leftToes" : "rightToes";
    vrm["extensions"]["VRM"]["humanoid"]["humanBones"].push_back({{"bone", bone}, {"node", i}});
  }
  // of the VRM the spine is one joint: less of it stretches
  for (const auto& [person, height] : {std::pair{person_gltf(), 1.275}, std::pair{vrm, 1.235}}) {
    goal_.y = height;
    reach_with("person.glb", person, "glb");
    expect_kept();
    const ExportedGlb out(work_.get(candidate().at("files").at("glb")));
    const int last = out.frames(kAnimation) - 1;
    for (const Json& contact : candidate().at("contacts")) {
      EXPECT_THAT(std::string(contact.at("joint")), testing::EndsWith("toes"));
      const int foot = out.parent(contact.at("gltf_node"));
      const double rises = out.at(foot, kAnimation, last).y - out.at(foot, kAnimation, 0).y;
      EXPECT_GT(rises, 0.01);
      EXPECT_GT(contact.at("heel_lift_mm"), 1e3 * rises);
    }
  }
}

TEST_F(CharacterExport, HeelsNeedToes) {
  const auto refusal = [&](const nlohmann::json& person) {
    work_.put("person.glb", glb(person.dump(), "data"));
    CharacterSpec spec{.source = "person.glb", .heels = true};
    const auto measured = measure_character(spec, work_.path());
    return measured ? std::string() : measured.error().message.text;
  };
  nlohmann::json person = person_gltf();
  EXPECT_EQ(refusal(person), "");
  for (nlohmann::json& node : person["nodes"]) {
    if (node.value("name", "") == "left_foot") node["children"] = nlohmann::json::array();
  }
  EXPECT_THAT(refusal(person), HasSubstr("left_toes"));
}

TEST_F(CharacterExport, AllJointsStandWhereTheBodysDo) {
  reach_with("person.glb", vrm_person(), "glb");
  TaskFile same = file_;
  const Task task = make_task(same, work_.path()).value();
  const GenerateResult again = regenerate(task, uniform_parameters(task.body)).value();
  const Clip written = motion_at(task.body, again.candidates[0], kUsualRate);
  const ExportedMotion body(format_bvh(skeleton_motion(task.body, written)), 0.01);
  const ExportedGlb out(work_.get("candidate-1.glb"));
  for (const auto& [bone, node] : file_.character.humanoid) {
    const int i = rig_node(file_.character, bone);
    // of the trunk the body has other joints, and neck, head and toes by proportions
    if (bone.ends_with("chest") || bone == "spine" || bone.ends_with("_shoulder")) continue;
    if (bone == "neck" || bone == "head" || bone.ends_with("toes") || bone == "hips") continue;
    for (const int f : {0, written.frames / 2, written.frames - 1}) {
      EXPECT_LE(
          norm(out.at(file_.character.rig->file_node[static_cast<std::size_t>(i)], kAnimation, f) -
               body.at(bone, f)),
          kFloats)
          << bone << " " << f;
    }
  }
}

TEST_F(CharacterExport, NodesAboveTheHipsMayTurnAndScale) {
  const double half = sqrt(0.5);
  // Z up and in centimetres: by a matrix, and by parts
  reach_with(
      "matrix.glb",
      below({{"matrix", {100.0, 0, 0, 0, 0, 0, 100.0, 0, 0, -100.0, 0, 0, 5.0, 7.0, 9.0, 1}}}),
      "glb");
  expect_kept(0.01);
  reach_with("parts.glb", below({{"rotation", {half, 0, 0, half}}, {"scale", {1.2, 1.2, 1.2}}}),
             "glb");
  expect_kept();
}

TEST_F(CharacterExport, JointsStandExactlyBelowAnUnevenScaleToo) {
  reach_with("uneven.glb", below({{"scale", {1.0, 1.2, 0.9}}}), "glb");
  expect_kept();
}

TEST_F(CharacterExport, AMirroredFileKeepsItsOwnAxes) {
  reach_with("mirrored.glb",
             below({{"scale", {-1.0, 1.0, 1.0}}, {"translation", {3.0, 0.5, -2.0}}}), "glb");
  const Placement& file = file_.character.rig->rig.placement;
  ASSERT_TRUE(file.mirrored());
  const ExportedGlb out(work_.get("candidate-1.glb"));
  const int last = out.frames(kAnimation) - 1;
  const Json& goal = candidate().at("reached").at(0);
  const Vec3d wanted{goal.at("goal_m").at(0), goal.at("goal_m").at(1), goal.at("goal_m").at(2)};
  EXPECT_LE(norm(file.to_world(out.at(goal.at("gltf_node"), kAnimation, last)) - wanted),
            kMillimetre);
  for (const Json& contact : candidate().at("contacts")) {
    const int foot = contact.at("gltf_node");
    EXPECT_LE(norm(out.at(foot, kAnimation, last) - out.place(foot).translation), kMillimetre);
  }
}

TEST_F(CharacterExport, NodesBetweenAndBelowBonesGoAlong) {
  // a twist bone between upper and lower arm, and a sword in the hand, both without a name
  nlohmann::json file = person_gltf();
  auto& nodes = file["nodes"];
  const auto index_of = [&](const std::string& name) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].value("name", "") == name) return i;
    }
    return nodes.size();
  };
  const std::size_t upper = index_of("right_upper_arm");
  const auto children = nodes[upper]["children"];
  nodes[upper]["children"] = {nodes.size()};
  nodes.push_back({{"rotation", identity_rotation()}, {"children", children}});
  nodes[index_of("right_hand")]["children"].push_back(nodes.size());
  nodes.push_back({{"translation", {0.1, -0.5, 0.2}}});
  reach_with("person.glb", file, "glb");
  expect_kept();
  const ExportedGlb out(work_.get("candidate-1.glb"));
  const auto& animation = out.json().at("animations").at(0);
  for (const auto& channel : animation.at("channels")) {
    EXPECT_LT(channel.at("target").at("node").get<std::size_t>(), nodes.size() - 2);
    if (channel.at("target").at("path") != "translation") continue;
    EXPECT_EQ(channel.at("target").at("node"), index_of("hips"));
  }
}

TEST_F(CharacterExport, HalfABodyLeavesToo) {
  file_.character.extent = BodyExtent::half;
  reach_with("person.glb", person_gltf(), "glb");
  expect_kept();
}

TEST_F(CharacterExport, TheWholeHumanLeavesToo) {
  file_.character.extent = BodyExtent::human;
  reach_with("person.glb", vrm_person(), "glb");
  expect_kept();
}

TEST_F(CharacterExport, VrmAnimationFacesAheadWithBonesUnturnedAtRest) {
  reach_with("person.vrm", vrm_person(), "vrma");
  const ExportedGlb out(work_.get("candidate-1.vrma"));
  const auto& bones =
      out.json().at("extensions").at("VRMC_vrm_animation").at("humanoid").at("humanBones");
  EXPECT_EQ(bones.size(), 16u);
  const auto at = [&](const char* bone) {
    return out.place(bones.at(bone).at("node")).translation;
  };
  // the rest pose: a T, left is +X, the hips as high as the file has them
  EXPECT_GT(at("leftHand").x, at("leftUpperArm").x + 0.4);
  EXPECT_NEAR(at("leftHand").y, at("leftUpperArm").y, 0.1);
  EXPECT_LT(at("rightHand").x, -0.4);
  EXPECT_NEAR(at("hips").y, file_.character.rig->rig.rest.left_leg.hip.y, 0.02);
  const Json& goal = candidate().at("reached").at(0);
  // the grip hangs on the hand, which is 8 cm from it
  const Vec3d hand =
      out.at(bones.at("rightHand").at("node"), kAnimation, out.frames(kAnimation) - 1);
  const Vec3d wanted{goal.at("goal_m").at(0), goal.at("goal_m").at(1), goal.at("goal_m").at(2)};
  const Landmarks& start = *file_.character.landmarks;
  EXPECT_NEAR(norm(hand - wanted), norm(*start.right_arm.grip - start.right_arm.wrist), 1e-5);
  for (const auto& channel : out.json().at("animations").at(0).at("channels")) {
    if (channel.at("target").at("path") == "rotation") continue;
    EXPECT_EQ(channel.at("target").at("node"), bones.at("hips").at("node"));
  }
}

TEST_F(CharacterExport, VrmAnimationIsPlayedBackOnTheCharacter) {
  reach_with("person.vrm", vrm_person(), "bvh,glb,vrma");
  for (const char* format : {"bvh", "glb", "vrma"}) {
    const Json& back = candidate().at("read_back").at(format);
    EXPECT_LT(back.at("effector_mm").get<double>(), 1e3 * kFloats) << format;
    EXPECT_LT(back.at("feet_mm").get<double>(), 1e3 * kFloats) << format;
    EXPECT_LT(back.at("turn_deg").get<double>(), 1e-4) << format;
  }
}

TEST_F(CharacterExport, AllCandidatesFitInOneFile) {
  work_.put("person.glb", glb(person_gltf().dump(), "data"));
  work_.put("candidate-2.glb", "of an earlier result");
  reach("person.glb", "glb,csv", true);
  const ExportedGlb out(work_.get("candidates.glb"));
  ASSERT_EQ(out.json().at("animations").size(), 2u);
  EXPECT_EQ(out.json().at("animations").at(1).at("name"), "shigusa candidate 2");
  EXPECT_EQ(summary_.at("candidates").at(1).at("files").at("glb"), "candidates.glb");
  EXPECT_EQ(summary_.at("candidates").at(1).at("glb_animation"), "shigusa candidate 2");
  EXPECT_FALSE(std::filesystem::exists(work_ / "candidate-2.glb"));
  reach("person.glb", "csv");
  EXPECT_FALSE(std::filesystem::exists(work_ / "candidates.glb"));
}

TEST_F(CharacterExport, BvhKeepsTheFilesNodesChannelsAndUnit) {
  // another order of channels and inches
  std::string text = person_bvh();
  replace_all(text, "Zrotation Xrotation Yrotation", "Yrotation Xrotation Zrotation");
  replace_all(text, "right_upper_arm", "RightArm");
  replace_all(text, "left_foot", "LeftFoot");
  work_.put("person.bvh", text);
  reach("person.bvh", "bvh");
  const std::string out = work_.get("candidate-1.bvh");
  EXPECT_THAT(out, HasSubstr("JOINT RightArm"));
  EXPECT_THAT(out, HasSubstr("CHANNELS 3 Yrotation Xrotation Zrotation"));
  const BvhFile source = parse_bvh_file(text, "person.bvh").value();
  const BvhFile written = parse_bvh_file(out, "out.bvh").value();
  ASSERT_EQ(written.motion.skeleton.nodes.size(), source.motion.skeleton.nodes.size());
  for (std::size_t i = 0; i < source.motion.skeleton.nodes.size(); ++i) {
    EXPECT_EQ(written.motion.skeleton.nodes[i].name, source.motion.skeleton.nodes[i].name);
    EXPECT_EQ(written.motion.skeleton.nodes[i].parent, source.motion.skeleton.nodes[i].parent);
    EXPECT_LE(
        norm(written.motion.skeleton.nodes[i].offset - source.motion.skeleton.nodes[i].offset),
        1e-6);
  }
  expect_bvh_kept(out);
}

// The hips move although they hang on another node, and have no channels for that in the file.
TEST_F(CharacterExport, BvhWhoseHipsAreNoRootMeetsTheGoal) {
  std::string text = person_bvh();
  replace_all(text, "Zrotation Xrotation Yrotation", "Xrotation Yrotation Zrotation");
  replace_all(text, "ROOT hips", "ROOT Reference frame\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT hips");
  replace_all(text, "MOTION", "}\nMOTION");
  replace_all(text, "right_hand\n", "Bip01 R Hand\n");
  work_.put("person.bvh", text);
  reach("person.bvh", "bvh");
  const std::string out = work_.get("candidate-1.bvh");
  EXPECT_THAT(out, HasSubstr("JOINT Bip01_R_Hand\n"));
  expect_bvh_kept(out);
}

TEST_F(CharacterExport, BvhOfAGltfCharacterHasItsNodesInCentimetres) {
  reach_with("person.glb", vrm_person(), "bvh");
  const ExportedMotion motion(work_.get("candidate-1.bvh"), 0.01);
  EXPECT_EQ(candidate().at("bvh_unit_m"), 0.01);
  EXPECT_GE(motion.motion().skeleton.find("above"), 0);
  const Json& goal = candidate().at("reached").at(0);
  const Vec3d wanted{goal.at("goal_m").at(0), goal.at("goal_m").at(1), goal.at("goal_m").at(2)};
  EXPECT_LE(norm(motion.at_end(goal.at("joint")) - wanted), kMillimetre);
}

TEST_F(CharacterExport, AResultFindsItsFileAgain) {
  reach_with("person.glb", person_gltf(), "glb");
  TaskFile stored = parse_task(format_task(file_), "task.json").value();
  ASSERT_FALSE(stored.character.rig);
  const auto refused = check_formats(stored.character, {FileFormat::glb});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("needs the character's file, person.glb"));
  ASSERT_TRUE(attach_file(stored.character, work_ / "person.glb"));
  EXPECT_TRUE(check_formats(stored.character, {FileFormat::glb}));
  // another person, or none
  work_.put("other.glb", glb(below({{"scale", {1.1, 1.0, 1.0}}}).dump(), "data"));
  TaskFile other = parse_task(format_task(file_), "task.json").value();
  const auto not_them = attach_file(other.character, work_ / "other.glb");
  ASSERT_FALSE(not_them);
  EXPECT_THAT(not_them.error().to_string(),
              HasSubstr("other.glb: is not the person of the result"));
  EXPECT_FALSE(attach_file(other.character, work_ / "none.glb"));
}

TEST(CheckFormats, TellsWhoCannotLeaveInThem) {
  const auto refused = check_formats(CharacterSpec{}, {FileFormat::bvh, FileFormat::vrma});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("human is none"));
  EXPECT_TRUE(check_formats(CharacterSpec{}, {FileFormat::bvh, FileFormat::pdf}));
  EXPECT_EQ(usual_formats(CharacterSpec{}).size(), 3u);
}

}  // namespace
}  // namespace shigusa
