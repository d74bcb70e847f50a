// SPDX-License-Identifier: MIT
// Twist bones in exported motion: shares of the twist by their positions, and no effect on other
// nodes. Read back by the files' own forward kinematics.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "character/character_rig.hpp"
#include "document/character_export.hpp"
#include "formats/gltf_animation.hpp"
#include "formats/gltf_write.hpp"
#include "kinematics/fit_clip.hpp"
#include "support/exported_glb.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;

const std::string kName = "motion";
constexpr double kFloats = 2e-6;  // numbers of a GLB are floats

// person_gltf in a T-pose, to which bones are added.
class Figure {
 public:
  Figure() : file_(person_gltf()) {
    const double half = sqrt(0.5);
    node("left_upper_arm")["rotation"] = {0.0, 0.0, half, half};
    node("right_upper_arm")["rotation"] = {0.0, 0.0, -half, half};
  }

  [[nodiscard]] std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < file_["nodes"].size(); ++i) {
      if (file_["nodes"][i].value("name", "") == name) return i;
    }
    throw std::runtime_error("no node " + name);
  }
  json& node(const std::string& name) { return file_["nodes"][index(name)]; }
  json& parent_of(std::size_t child) {
    for (json& node : file_["nodes"]) {
      const json children = node.value("children", json::array());
      if (std::find(children.begin(), children.end(), child) != children.end()) return node;
    }
    throw std::runtime_error("a root");
  }

  // A child of the bone, at that share of the way to the next one.
  Figure& leaf(const std::string& name, const std::string& bone, const std::string& next,
               double share) {
    const json at = scaled(node(next)["translation"], share);
    const std::size_t parent = index(bone);
    file_["nodes"][parent]["children"].push_back(file_["nodes"].size());
    file_["nodes"].push_back({{"name", name}, {"translation", at}});
    return *this;
  }

  // Between the two.
  Figure& chain(const std::string& name, const std::string& bone, const std::string& next,
                double share) {
    const json way = node(next)["translation"];
    const std::size_t below = index(next);
    leaf(name, bone, next, share);
    json& children = node(bone)["children"];
    children.erase(std::find(children.begin(), children.end(), below));
    node(name)["children"] = {below};
    node(next)["translation"] = scaled(way, 1.0 - share);
    return *this;
  }

  [[nodiscard]] std::string bytes() const { return glb(file_.dump(), "data"); }

 private:
  static json scaled(const json& v, double by) {
    return {by * v[0].get<double>(), by * v[1].get<double>(), by * v[2].get<double>()};
  }

  json file_;
};

// A motion of a figure's body, with its twist bones and with them treated as ordinary nodes.
struct Played {
  CharacterSpec spec;
  PosedBody posed;
  Clip clip;
  ExportedGlb with;
  ExportedGlb without;

  [[nodiscard]] int node(const std::string& name) const {
    const int i = spec.rig->skeleton.find(name);
    return spec.rig->file_node[static_cast<std::size_t>(i)];
  }
  // How far (rad) a node is turned about the limb's line from where it would be without twist
  // bones; the rest of its turn must be none.
  [[nodiscard]] double twist(const std::string& name, const std::string& bone,
                             const std::string& next, int frame) const {
    const Transformd is = with.place(node(name), kName, frame);
    const Transformd was = without.place(node(name), kName, frame);
    const Vec3d line =
        normalized(without.at(node(bone), kName, frame) - without.at(node(next), kName, frame));
    EXPECT_LE(norm(is.translation - was.translation), kFloats);
    const Quatd q = to_quat(is.rotation * transpose(was.rotation));
    const Vec3d v{q.x, q.y, q.z};
    EXPECT_LE(norm(v - line * dot(v, line)), 1e-5) << name;
    return 2.0 * atan2(dot(v, line), q.w);
  }
};

using Pose = std::function<void(int frame, const std::function<double&(const char*)>& angle)>;

Played play(const Figure& figure, int frames, const Pose& pose) {
  CharacterSpec spec{.source = "figure.glb"};
  const auto loaded = load_character(figure.bytes(), spec);
  if (!loaded) throw std::runtime_error(loaded.error().to_string());
  PosedBody posed = build_character(spec).value();
  Clip clip{.dofs = posed.body.dof_count(), .frames = frames, .angles = {}};
  for (int f = 0; f < frames; ++f) {
    std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
    pose(f, [&](const char* name) -> double& {
      return angles[static_cast<std::size_t>(posed.body.find_dof(name).value())];
    });
    clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
  }
  const auto file = [&](const CharacterSpec& of) {
    const CharacterExporter exporter(*of.rig);
    const GltfAnimation animation = exporter.animation(posed, clip, kName, {});
    return ExportedGlb(exporter.glb(std::span(&animation, 1)).value());
  };
  CharacterSpec plain = spec;
  CharacterRig untwisted = *spec.rig;
  untwisted.rig.twists.clear();
  plain.rig = std::make_shared<const CharacterRig>(std::move(untwisted));
  ExportedGlb with = file(spec);
  ExportedGlb without = file(plain);
  return {std::move(spec), std::move(posed), std::move(clip), std::move(with), std::move(without)};
}

void reach_about(int frame, const std::function<double&(const char*)>& angle) {
  for (const double side : {-1.0, 1.0}) {
    const std::string of = side < 0.0 ? "left_" : "right_";
    angle((of + "shoulder.flexion").c_str()) += 0.1 * frame;
    angle((of + "shoulder.rotation").c_str()) += side * 0.04 * frame;
    angle((of + "elbow.flexion").c_str()) += 0.08 * frame;
    angle((of + "elbow.rotation").c_str()) += 0.07 * frame;
    angle((of + "wrist.flexion").c_str()) += 0.03 * frame;
  }
  angle("left_hip.rotation") += 0.05 * frame;
  angle("left_knee.flexion") += 0.05 * frame;
}

constexpr int kFrames = 12;

void expect_limbs_kept(const Played& played) {
  for (int f = 0; f < kFrames; ++f) {
    for (const auto& [bone, name] : played.spec.humanoid) {
      const Transformd is = played.with.place(played.node(name), kName, f);
      const Transformd was = played.without.place(played.node(name), kName, f);
      EXPECT_LE(norm(is.translation - was.translation), kFloats) << bone << ' ' << f;
      if (!bone.ends_with("hand") && !bone.ends_with("foot")) continue;
      EXPECT_LE(norm(is.rotation.cx - was.rotation.cx) + norm(is.rotation.cy - was.rotation.cy),
                1e-5)
          << bone << ' ' << f;
    }
  }
}

// A reader of the file uses the rest pose for joints without a channel.
TEST(RigMotion, OnlyNodesThatLeaveTheirRestTurn) {
  const Figure figure;
  const Played played = play(
      figure, 2, [](int frame, const auto& angle) { angle("right_elbow.flexion") += 0.3 * frame; });
  const Rig& rig = played.spec.rig->rig;
  const RigMotion motion = rig_motion(played.posed, played.clip, rig);
  int turning = 0;
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
    double largest = 0.0;
    for (std::size_t f = 0; f < 2; ++f) {
      const Quatd& q = motion.local[f * rig.nodes.size() + i].rotation;
      const Quatd& rest = rig.nodes[i].rotation;
      const double w = q.x * rest.x + q.y * rest.y + q.z * rest.z + q.w * rest.w;
      largest = std::fmax(largest, acos(min(abs(w), 1.0)));
    }
    // acos keeps half of a number's digits beside 1
    EXPECT_EQ(motion.turns[i], largest > 1e-7) << i;
    turning += motion.turns[i] ? 1 : 0;
  }
  // both upper arms, let down from the T, the forearm, and the legs, which lean ahead
  EXPECT_EQ(turning, 9);
}

TEST(TwistExport, ALeafOfTheForearmTakesItsShareAndTheElbowNone) {
  Figure figure;
  figure.leaf("lowerarm_twist_01_r", "right_lower_arm", "right_hand", 0.5);
  figure.leaf("lowerarm_twist_02_r", "right_lower_arm", "right_hand", 0.25);
  const Played played = play(figure, kFrames, reach_about);
  ASSERT_EQ(played.spec.rig->rig.twists.size(), 2u);
  expect_limbs_kept(played);
  for (int f = 0; f < kFrames; ++f) {
    // rotation of the forearm about itself: to the outside, which is -y on the right
    const double psi = -0.07 * f;
    const auto twist = [&](const char* name) {
      return played.twist(name, "right_lower_arm", "right_hand", f);
    };
    // the wrist's flexion adds no twist
    EXPECT_NEAR(twist("right_lower_arm"), -psi, 1e-5) << f;
    EXPECT_NEAR(twist("lowerarm_twist_02_r"), -0.75 * psi, 1e-3) << f;
    EXPECT_NEAR(twist("lowerarm_twist_01_r"), -0.5 * psi, 1e-3) << f;
  }
}

TEST(TwistExport, SegmentsOfAChainShareLikewiseAndTheHandStays) {
  Figure figure;
  figure.chain("DEF-upper_arm.R.001", "right_upper_arm", "right_lower_arm", 0.5);
  figure.chain("DEF-forearm.R.001", "right_lower_arm", "right_hand", 0.5);
  const Played played = play(figure, kFrames, reach_about);
  ASSERT_EQ(played.spec.rig->rig.twists.size(), 2u);
  expect_limbs_kept(played);
  for (int f = 1; f < kFrames; ++f) {
    const double base = played.twist("right_upper_arm", "right_upper_arm", "right_lower_arm", f);
    const double half =
        played.twist("DEF-upper_arm.R.001", "right_upper_arm", "right_lower_arm", f);
    EXPECT_GT(std::abs(base), 0.01) << f;
    EXPECT_NEAR(half, 0.5 * base, 1e-5) << f;
    EXPECT_NEAR(played.twist("DEF-forearm.R.001", "right_lower_arm", "right_hand", f),
                0.5 * 0.07 * f, 1e-3)
        << f;
  }
}

TEST(TwistExport, AShouldersTwistIsCounteredNextToIt) {
  Figure figure;
  figure.leaf("upperarm_twist_01_l", "left_upper_arm", "left_lower_arm", 0.0);
  figure.leaf("upperarm_twist_02_l", "left_upper_arm", "left_lower_arm", 0.75);
  figure.leaf("thigh_twist_01_l", "left_upper_leg", "left_lower_leg", 0.25);
  // turned about itself alone
  const Played played = play(figure, kFrames, [](int f, const auto& angle) {
    angle("left_shoulder.rotation") += 0.06 * f;
    angle("left_hip.rotation") += 0.03 * f;
  });
  ASSERT_EQ(played.spec.rig->rig.twists.size(), 3u);
  expect_limbs_kept(played);
  const auto arm = [&](const char* name, int f) {
    return played.twist(name, "left_upper_arm", "left_lower_arm", f);
  };
  for (int f = 0; f < kFrames; ++f) {
    EXPECT_NEAR(arm("left_upper_arm", f), 0.0, 1e-5);
    // an arm that hangs beside the body was let down from the T without a twist, but for what its
    // slope ahead makes
    EXPECT_NEAR(arm("upperarm_twist_01_l", f) - arm("upperarm_twist_01_l", 0), -0.06 * f, 0.02);
    EXPECT_NEAR(arm("upperarm_twist_02_l", f), 0.25 * arm("upperarm_twist_01_l", f), 1e-5);
    EXPECT_NEAR(played.twist("thigh_twist_01_l", "left_upper_leg", "left_lower_leg", f),
                -0.75 * 0.03 * f, 0.01);
  }
}

TEST(TwistExport, ABoneBesideTheLimbGoesWithIt) {
  // as in some rigs: on the arm's own parent
  Figure figure;
  figure.leaf("LUpArmTwist", "left_upper_arm", "left_lower_arm", 0.5);
  json& arm = figure.node("left_upper_arm");
  const std::size_t twist = figure.index("LUpArmTwist");
  const json offset = figure.node("LUpArmTwist")["translation"];
  arm["children"].erase(std::find(arm["children"].begin(), arm["children"].end(), twist));
  const std::size_t upper = figure.index("left_upper_arm");
  figure.parent_of(upper)["children"].push_back(twist);
  // where it was, on an arm stretched out
  const double x = arm["translation"][0].get<double>() - offset[1].get<double>();
  const double y = arm["translation"][1].get<double>() + offset[0].get<double>();
  const double z = arm["translation"][2].get<double>() + offset[2].get<double>();
  figure.node("LUpArmTwist")["translation"] = {x, y, z};
  const Played played = play(figure, kFrames, reach_about);
  ASSERT_EQ(played.spec.rig->rig.twists.size(), 1u);
  for (int f = 0; f < kFrames; ++f) {
    const Vec3d middle = (played.with.at(played.node("left_upper_arm"), kName, f) +
                          played.with.at(played.node("left_lower_arm"), kName, f)) *
                         0.5;
    EXPECT_LE(norm(played.with.at(played.node("LUpArmTwist"), kName, f) - middle), 1e-5) << f;
  }
}

TEST(TwistExport, AnArmRaisedOverheadTurnsItsTwistBonesWithoutAJump) {
  Figure figure;
  figure.leaf("upperarm_twist_01_r", "right_upper_arm", "right_lower_arm", 0.1);
  figure.leaf("lowerarm_twist_01_r", "right_lower_arm", "right_hand", 0.5);
  for (const char* way : {"right_shoulder.flexion", "right_shoulder.abduction"}) {
    const Played played = play(figure, 60, [&](int f, const auto& angle) {
      angle(way) += f * radians(178.0) / 59.0;
      angle("right_elbow.rotation") += 0.02 * f;
    });
    for (const char* name : {"upperarm_twist_01_r", "lowerarm_twist_01_r", "right_lower_arm"}) {
      const int node = played.node(name);
      for (int f = 1; f < 60; ++f) {
        const Mat3d before = played.with.place(node, kName, f - 1).rotation;
        const Quatd q = to_quat(played.with.place(node, kName, f).rotation * transpose(before));
        EXPECT_LE(2.0 * degrees(acos(min(abs(q.w), 1.0))), 12.0) << way << ' ' << name << ' ' << f;
      }
    }
  }
}

TEST(TwistExport, AMotionWithTwistBonesIsFittedExactly) {
  for (const bool chains : {false, true}) {
    Figure figure;
    if (chains) {
      figure.chain("DEF-upper_arm.R.001", "right_upper_arm", "right_lower_arm", 0.5);
      figure.chain("DEF-forearm.R.001", "right_lower_arm", "right_hand", 0.5);
    } else {
      figure.leaf("upperarm_twist_01_r", "right_upper_arm", "right_lower_arm", 0.1);
      figure.leaf("lowerarm_twist_01_r", "right_lower_arm", "right_hand", 0.5);
    }
    const Played played = play(figure, kFrames, reach_about);
    const Rig& rig = played.spec.rig->rig;
    // the figure stands where its motion does, so that one placement is for both
    ASSERT_LE(norm(rig.placement.origin), 1e-6);
    const CharacterExporter exporter(*played.spec.rig);
    const GltfAnimation animation = exporter.animation(played.posed, played.clip, kName, {});
    const GltfMotion read =
        parse_gltf_animation(exporter.glb(std::span(&animation, 1)).value(), "out.glb", {}).value();
    // turns of a motion that is read are those from rest
    Rig unturned = rig;
    for (std::size_t i = 0; i < unturned.nodes.size(); ++i) {
      unturned.nodes[i] = {unturned.nodes[i].parent, played.spec.rig->posed[i].translation, {}};
    }
    const ClipFit fit = fit_clip(played.posed, unturned, read.motion, {0, kFrames - 1, 0});
    EXPECT_LT(fit.worst_distance, 1e-4) << chains;
    for (std::size_t i = 0; i < fit.clip.angles.size(); ++i) {
      EXPECT_NEAR(fit.clip.angles[i], played.clip.angles[i], 1e-3)
          << chains << ' ' << played.posed.body.dof(static_cast<int>(i) % fit.clip.dofs).name;
    }
  }
}

// A seated person's thighs stay on the seat while the pelvis turns: their twist is shared, too.
TEST(TwistExport, SeatedThighsThatShareTheirTwistLeave) {
  Figure figure;
  for (const std::string side : {"left", "right"}) {
    figure.chain("DEF-thigh." + side + ".001", side + "_upper_leg", side + "_lower_leg", 0.5);
  }
  CharacterSpec spec{.source = "figure.glb", .seat = 0.45};
  ASSERT_TRUE(load_character(figure.bytes(), spec));
  Task task(build_character(spec).value());
  task.goals = {{"right_hand", {0.45, 1.0, 0.25}}};
  task.evaluations = 100;
  const GenerateResult result = generate(task).value();
  ASSERT_FALSE(result.candidates.empty());
  for (const Candidate& candidate : result.candidates) {
    for (const FileFormat format : {FileFormat::bvh, FileFormat::glb}) {
      const auto file = export_candidate(spec, task, candidate, format);
      EXPECT_TRUE(file) << file.error().to_string();
    }
  }
}

}  // namespace
}  // namespace shigusa
