// SPDX-License-Identifier: MIT
// The start posture of a character: an unchanged frame, or the rest pose standing at ease.
#include <gmock/gmock.h>

#include <bit>
#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "document/character_export.hpp"
#include "formats/gltf_write.hpp"
#include "human/stance.hpp"
#include "rig/stick_figure.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Quatd about(Axis axis, double angle_deg) { return to_quat(rotation(axis, radians(angle_deg))); }

// Turns a node relative to its parent, in each frame or at rest.
void turn(const Skeleton& skeleton, std::vector<LocalTransform>& frame, const char* name,
          const Quatd& by) {
  LocalTransform& local = frame.at(static_cast<std::size_t>(skeleton.find(name)));
  local.rotation = by * local.rotation;
}

// A BVH of the standing figure, whose OFFSETs form a T-pose, in two frames: the arms are lowered
// from the T by the angle `down`, and hang in the second.
std::string spread_bvh(double down_deg) {
  SkeletonMotion motion{standing_figure().skeleton(), {}};
  motion.clip.frames = 2;
  for (const double angle : {down_deg, 90.0}) {
    std::vector<LocalTransform> frame;
    for (const SkeletonNode& node : motion.skeleton.nodes) frame.push_back({node.offset, {}});
    turn(motion.skeleton, frame, "LeftArm", about(Axis::z, -angle));
    turn(motion.skeleton, frame, "RightArm", about(Axis::z, angle));
    motion.clip.local.insert(motion.clip.local.end(), frame.begin(), frame.end());
  }
  return format_bvh(motion);
}

Result<CharacterSpec> loaded(std::string bytes, CharacterSpec spec) {
  const Result<void> done = load_character(std::move(bytes), spec);
  if (!done) return tl::unexpected(done.error());
  return spec;
}

// Depth of an arm's end below its shoulder, as a share of its length.
double hangs(const CharacterSpec& spec) {
  const Landmarks::Arm& arm = spec.landmarks->right_arm;
  return (arm.shoulder.y - arm.wrist.y) /
         (norm(arm.elbow - arm.shoulder) + norm(arm.wrist - arm.elbow));
}

TEST(StartPose, ArmsOfABvhInTOrAHangAtTheStart) {
  for (const double down_deg : {0.0, 45.0}) {
    const auto spec = loaded(spread_bvh(down_deg), {.source = "t.bvh"});
    ASSERT_TRUE(spec) << spec.error().to_string();
    EXPECT_GT(hangs(*spec), 0.9) << down_deg;
    EXPECT_THAT(spec->doubts, Contains(HasSubstr("with --frame 0")));
  }
}

TEST(StartPose, FrameOfABvhIsTakenAsItIs) {
  const auto spread = loaded(spread_bvh(0.0), {.source = "t.bvh", .frame = 0});
  ASSERT_TRUE(spread);
  EXPECT_NEAR(hangs(*spread), 0.0, 1e-6);
  const auto hanging = loaded(spread_bvh(0.0), {.source = "t.bvh", .frame = 1});
  EXPECT_NEAR(hangs(hanging.value()), 1.0, 1e-6);
  for (const auto& spec : {spread, hanging}) {
    EXPECT_THAT(spec->doubts, Not(Contains(HasSubstr("--frame"))));
  }
}

TEST(StartPose, RestOfABvhIsThatOfItsOffsetsAtEase) {
  const auto spec = loaded(spread_bvh(30.0), {.source = "t.bvh", .frame = kRestPose});
  ASSERT_TRUE(spec) << spec.error().to_string();
  EXPECT_GT(hangs(*spec), 0.9);
  EXPECT_NEAR(degrees(atan2(
                  spec->rig->rig.rest.right_arm.wrist.y - spec->rig->rig.rest.right_arm.shoulder.y,
                  -spec->rig->rig.rest.right_arm.wrist.x)),
              0.0, 1e-4);
}

TEST(StartPose, RecordedPostureIsNoRestPose) {
  const auto spec = loaded(person_bvh(), {.source = "person.bvh"});
  const auto first = loaded(person_bvh(), {.source = "person.bvh", .frame = 0});
  EXPECT_EQ(hangs(spec.value()), hangs(first.value()));
  EXPECT_THAT(spec->doubts, first->doubts);
}

// A person with an animation that lifts the right arm ahead from its first frame on.
std::string animated_glb() {
  json file = person_gltf();
  std::size_t arm = 0;
  while (file["nodes"][arm].value("name", "") != "right_upper_arm") ++arm;
  std::string binary;
  const auto put = [&](float x) { binary += word_bytes(std::bit_cast<std::uint32_t>(x)); };
  for (const float time : {0.0f, 1.0f}) put(time);
  const SinCos<double> half = sin_cos(radians(-45.0));
  for (int k = 0; k < 2; ++k) {
    for (const double x : {half.sin, 0.0, 0.0, half.cos}) put(static_cast<float>(x));
  }
  file["buffers"] = {{{"byteLength", binary.size()}}};
  file["bufferViews"] = {{{"buffer", 0}, {"byteLength", 8}},
                         {{"buffer", 0}, {"byteOffset", 8}, {"byteLength", 32}}};
  file["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", 2}, {"type", "SCALAR"}},
      {{"bufferView", 1}, {"componentType", 5126}, {"count", 2}, {"type", "VEC4"}}};
  file["animations"] = {
      {{"name", "lift"},
       {"samplers", {{{"input", 0}, {"output", 1}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", arm}, {"path", "rotation"}}}}}}}};
  return glb(file.dump(), binary);
}

TEST(StartPose, FrameZeroOfGltfIsOfTheFirstAnimationAsOthersAre) {
  const auto rest = loaded(animated_glb(), {.source = "a.glb"});
  ASSERT_TRUE(rest) << rest.error().to_string();
  EXPECT_GT(hangs(*rest), 0.9);
  for (const int frame : {0, 5}) {
    const auto lifted = loaded(animated_glb(), {.source = "a.glb", .frame = frame});
    ASSERT_TRUE(lifted) << lifted.error().to_string();
    EXPECT_LT(hangs(*lifted), 0.3) << frame;
  }
  const auto named = loaded(animated_glb(), {.source = "a.glb", .animation = "lift"});
  EXPECT_LT(hangs(named.value()), 0.3);
}

TEST(StartPose, RestOfGltfIsWhatNoFrameIs) {
  const auto said = loaded(animated_glb(), {.source = "a.glb", .frame = kRestPose});
  EXPECT_EQ(hangs(said.value()), hangs(loaded(animated_glb(), {.source = "a.glb"}).value()));
  const auto both =
      loaded(animated_glb(), {.source = "a.glb", .frame = kRestPose, .animation = "lift"});
  ASSERT_FALSE(both);
  EXPECT_THAT(both.error().to_string(), HasSubstr("the rest pose is of no animation"));
}

TEST(StartPose, FrameOfGltfWithoutAnimationsIsRefused) {
  for (const int frame : {0, 5}) {
    const auto spec = loaded(glb(person_gltf().dump()), {.source = "a.glb", .frame = frame});
    ASSERT_FALSE(spec);
    EXPECT_THAT(spec.error().to_string(), HasSubstr("the file has no animation"));
  }
}

json described(const CharacterSpec& spec) {
  return json::parse(format_character(spec, build_character(spec).value()));
}

TEST(StartPose, DescriptionTellsWhichMotionsAndFramesThereAre) {
  const json bvh = described(loaded(spread_bvh(0.0), {.source = "t.bvh"}).value());
  EXPECT_EQ(bvh["frames"], 2);
  EXPECT_EQ(bvh["animations"], json::array());
  const json rest = described(loaded(animated_glb(), {.source = "a.glb"}).value());
  EXPECT_EQ(rest["frames"], 0);
  EXPECT_EQ(rest["animations"], json::array({"lift"}));
  const json lifted = described(loaded(animated_glb(), {.source = "a.glb", .frame = 5}).value());
  EXPECT_EQ(lifted["frames"], 61);
  EXPECT_FALSE(described({}).contains("frames"));
}

TEST(StartPose, DescriptionTellsAStatureThatNoUnitGives) {
  SkeletonMotion large{standing_figure().skeleton(), {}};
  for (SkeletonNode& node : large.skeleton.nodes) node.offset = node.offset * 2.0;
  large.clip.frames = 1;
  for (const SkeletonNode& node : large.skeleton.nodes) {
    large.clip.local.push_back({node.offset, {}});
  }
  const auto guessed = [&](std::optional<double> stature) {
    return described(
        loaded(format_bvh(large), {.source = "large.bvh", .stature = stature}).value());
  };
  EXPECT_TRUE(guessed({})["stature_guessed"]);
  EXPECT_EQ(guessed({})["stature_m"], 1.7);
  EXPECT_FALSE(guessed(1.5)["stature_guessed"]);
  EXPECT_FALSE(described(loaded(spread_bvh(0.0), {.source = "t.bvh"}).value())["stature_guessed"]);
}

struct Bend {
  const char* node;
  Axis axis;
  double angle_deg;
};
constexpr Bend kLeap[] = {{"right_upper_leg", Axis::x, -80.0},
                          {"right_lower_leg", Axis::x, 100.0},
                          {"left_upper_leg", Axis::x, 30.0},
                          {"left_lower_leg", Axis::x, 40.0},
                          {"hips", Axis::x, 20.0},
                          {"right_upper_arm", Axis::x, -120.0}};

// An animation whose only frame turns no node, as the person's nodes are in their standing pose.
json standing_animation(json& file, std::string& binary) {
  binary.clear();
  const auto put = [&](float x) { binary += word_bytes(std::bit_cast<std::uint32_t>(x)); };
  put(0.0f);
  for (const float x : {0.0f, 0.0f, 0.0f, 1.0f}) put(x);
  file["buffers"] = {{{"byteLength", binary.size()}}};
  file["bufferViews"] = {{{"buffer", 0}, {"byteLength", 4}},
                         {{"buffer", 0}, {"byteOffset", 4}, {"byteLength", 16}}};
  file["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}},
      {{"bufferView", 1}, {"componentType", 5126}, {"count", 1}, {"type", "VEC4"}}};
  json animation{{"name", "stand"}, {"samplers", {{{"input", 0}, {"output", 1}}}}};
  for (std::size_t i = 0; i < file["nodes"].size(); ++i) {
    for (const Bend& bend : kLeap) {
      if (file["nodes"][i].value("name", "") != bend.node) continue;
      animation["channels"].push_back(
          {{"sampler", 0}, {"target", {{"node", i}, {"path", "rotation"}}}});
    }
  }
  return animation;
}

// A person bound standing, below an armature with z up, whose nodes rest bent.
std::string bent_glb(std::span<const Bend> pose, bool skinned, bool animated = false) {
  json file = person_gltf();
  const SinCos<double> half = sin_cos(radians(-45.0));
  json& nodes = file["nodes"];
  const std::size_t people = nodes.size();
  nodes.push_back({{"name", "Armature"},
                   {"rotation", {half.sin, 0.0, 0.0, half.cos}},
                   {"scale", {0.01, 0.01, 0.01}},
                   {"children", {people + 1}}});
  nodes.push_back({{"name", "up"},
                   {"rotation", {-half.sin, 0.0, 0.0, half.cos}},
                   {"scale", {100.0, 100.0, 100.0}},
                   {"children", {0}}});
  const std::string plain = glb(file.dump());
  const ExportedGlb standing(plain);
  std::string binary;
  json joints = json::array();
  for (std::size_t i = 0; i < people; ++i) {
    joints.push_back(i);
    // in the armature's space, as exporters have it
    const Transformd armature = standing.place(static_cast<int>(people));
    const Transformd joint = standing.place(static_cast<int>(i));
    const Mat3d& r = joint.rotation;
    const Mat3d back = transpose(r);
    const double unit = 0.01;
    // inverse of armature⁻¹ · joint: joint⁻¹ · armature
    const Mat3d turned = back * armature.rotation;
    const Vec3d at = back * (armature.translation - joint.translation);
    const double m[16] = {
        turned.cx.x, turned.cx.y, turned.cx.z, 0, turned.cy.x, turned.cy.y, turned.cy.z, 0,
        turned.cz.x, turned.cz.y, turned.cz.z, 0, at.x,        at.y,        at.z,        1};
    for (const double x : m) {
      binary += word_bytes(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    }
    EXPECT_NEAR(norm(armature.rotation.cx), unit, 1e-9);
  }
  for (const auto& [name, axis, angle_deg] : pose) {
    for (json& node : nodes) {
      if (node.value("name", "") != name) continue;
      const std::vector<double> q = node["rotation"];
      const Quatd turned = about(axis, angle_deg) * Quatd{q[0], q[1], q[2], q[3]};
      node["rotation"] = {turned.x, turned.y, turned.z, turned.w};
    }
  }
  if (animated) {
    file["animations"] = {
        {{"name", "still"}, {"samplers", json::array()}, {"channels", json::array()}},
        standing_animation(file, binary)};
    return glb(file.dump(), binary);
  }
  if (!skinned) return glb(file.dump());
  file["skins"] = {{{"joints", joints}, {"inverseBindMatrices", 0}}};
  file["buffers"] = {{{"byteLength", binary.size()}}};
  file["bufferViews"] = {{{"buffer", 0}, {"byteLength", binary.size()}}};
  file["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", people}, {"type", "MAT4"}}};
  return glb(file.dump(), binary);
}

std::string leaping_glb(bool skinned, bool animated = false) {
  return bent_glb(kLeap, skinned, animated);
}

constexpr Bend kHandRaised[] = {{"right_upper_arm", Axis::x, -70.0},
                                {"right_lower_arm", Axis::x, -60.0}};

TEST(StartPose, OwnPoseOfWhoStandsIsTheStart) {
  const auto own = loaded(bent_glb(kHandRaised, true), {.source = "own.glb"});
  ASSERT_TRUE(own) << own.error().to_string();
  EXPECT_THAT(own->doubts, Contains(HasSubstr("the start is the pose that the file shows")));
  EXPECT_FALSE(own->rig->rig.at_ease);
  const auto bound = loaded(bent_glb({}, true), {.source = "bound.glb"});
  EXPECT_NEAR(*own->stature, *bound->stature, 1e-5);
  // as the nodes are, and not at ease
  const CharacterRig& rig = *own->rig;
  const ExportedGlb file(*rig.bytes);
  const auto wrist = static_cast<std::size_t>(rig_node(*own, "right_hand"));
  EXPECT_LE(norm(rig.rig.placement.to_world(file.place(rig.file_node[wrist]).translation) -
                 own->landmarks->right_arm.wrist),
            1e-4);
  EXPECT_LT(hangs(*own), 0.3);

  const auto at_rest =
      loaded(bent_glb(kHandRaised, true), {.source = "own.glb", .frame = kRestPose});
  EXPECT_GT(hangs(*at_rest), 0.9);
  EXPECT_THAT(at_rest->doubts, Not(Contains(HasSubstr("the pose that the file shows"))));
  // without a bound mesh the bind pose is unknown, and the arms are laid at ease
  EXPECT_GT(hangs(*loaded(bent_glb(kHandRaised, false), {.source = "own.glb"})), 0.9);
}

TEST(StartPose, ArmsThatAreLaidBesideTheBodyAreToldOnce) {
  constexpr Bend kSpread[] = {{"right_upper_arm", Axis::z, -70.0},
                              {"left_upper_arm", Axis::z, 70.0}};
  for (const bool skinned : {false, true}) {
    const auto spec = loaded(bent_glb(kSpread, skinned), {.source = "t.glb"});
    ASSERT_TRUE(spec) << spec.error().to_string();
    EXPECT_GT(hangs(*spec), 0.9);
    EXPECT_EQ(std::ranges::count_if(spec->doubts,
                                    [](const Message& doubt) {
                                      return doubt.text.find("they hang") != std::string::npos;
                                    }),
              1);
  }
}

TEST(StartPose, NodesInALeapGiveWayToThePoseThatTheMeshWasBoundIn) {
  const auto leaping = loaded(leaping_glb(true), {.source = "leap.glb"});
  ASSERT_TRUE(leaping) << leaping.error().to_string();
  const auto standing = loaded(glb(person_gltf().dump()), {.source = "standing.glb"});
  EXPECT_THAT(leaping->doubts, Contains(HasSubstr("the pose in which the mesh was bound")));
  // matrices are single precision
  EXPECT_NEAR(*leaping->stature, *standing->stature, 1e-5);
  EXPECT_LE(norm(leaping->landmarks->right_leg.knee - standing->landmarks->right_leg.knee), 1e-5);
  EXPECT_LE(norm(leaping->landmarks->left_arm.wrist - standing->landmarks->left_arm.wrist), 1e-5);
}

TEST(StartPose, MotionFromTheBoundPosePlaysOnTheFile) {
  TaskFile file;
  file.character = loaded(leaping_glb(true), {.source = "leap.glb"}).value();
  const double s = *file.character.stature;
  file.goals = {{"right_hand", Vec3d{-0.1, 0.4, 0.3} * s}};
  const Task task = make_task(file, {}).value();
  const GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
  ASSERT_TRUE(generation.meets_goals());
  const Clip& clip = generation.candidates[0].motion.clip;
  const CharacterExporter exporter(*file.character.rig);
  const GltfAnimation animation = exporter.animation(task, clip, "motion", {});
  const ExportedGlb out(exporter.glb(std::span(&animation, 1)).value());
  const auto at = [&](const char* of, int frame) {
    const auto i = static_cast<std::size_t>(rig_node(file.character, of));
    return file.character.rig->rig.placement.to_world(
        out.at(file.character.rig->file_node[i], "motion", frame));
  };
  EXPECT_LE(norm(at("right_hand_grip", clip.frames - 1) - file.goals[0].position), 1e-3);
  for (const char* foot : {"left_foot", "right_foot"}) {
    for (int f = 1; f < clip.frames; ++f) EXPECT_LE(norm(at(foot, f) - at(foot, 0)), 1e-3);
  }
}

TEST(StartPose, NodesInALeapWithoutABoundPoseAreADoubt) {
  const auto spec = loaded(leaping_glb(false), {.source = "leap.glb"});
  ASSERT_TRUE(spec) << spec.error().to_string();
  EXPECT_THAT(spec->doubts, Contains(HasSubstr("the rest pose of the nodes is no standing pose")));
}

TEST(StartPose, AnimationThatWouldDoIsNamed) {
  const auto spec = loaded(leaping_glb(false, true), {.source = "leap.glb"});
  ASSERT_TRUE(spec) << spec.error().to_string();
  EXPECT_THAT(spec->doubts,
              Contains(HasSubstr("frame 0 of the animation 'stand' does: --animation")));
}

TEST(StartPose, PeopleAtRestAreToldFromThoseInMotion) {
  const Landmarks standing = standing_landmarks(1.75, kStandingToeOut);
  EXPECT_TRUE(stands_at_rest(standing, 1.75));
  EXPECT_FALSE(spreads_arms(standing));
  Landmarks fighting = standing;
  for (Vec3d* p : {&fighting.left_leg.ankle, &fighting.left_leg.toe}) p->z += 0.35;
  EXPECT_FALSE(stands_at_rest(fighting, 1.75));
  Landmarks on_one_foot = standing;
  for (Vec3d* p : {&on_one_foot.left_leg.ankle, &on_one_foot.left_leg.toe}) p->y += 0.3;
  EXPECT_FALSE(stands_at_rest(on_one_foot, 1.75));
  Landmarks saluting = standing;
  saluting.right_arm.wrist = saluting.right_arm.shoulder + Vec3d{0.05, 0.2, 0.1};
  EXPECT_FALSE(stands_at_rest(saluting, 1.75));
}

TEST(StartPose, OfATaskFileIsANumberOrRest) {
  const auto frame = [](const char* value) {
    return parse_task(
        std::string(R"({"goals": [{"effector": "right_hand", "position_m": [0, 1, 0]}],
      "character": {"source": "a.bvh", "frame": )") +
            value + "}}",
        "task.json");
  };
  EXPECT_EQ(frame("7")->character.frame, 7);
  EXPECT_EQ(frame(R"("rest")")->character.frame, kRestPose);
  EXPECT_THAT(frame(R"("first")").error().to_string(), HasSubstr(R"("rest")"));
  EXPECT_FALSE(frame("-1"));
}

}  // namespace
}  // namespace shigusa
