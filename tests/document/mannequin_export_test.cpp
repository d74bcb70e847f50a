// SPDX-License-Identifier: MIT
// Built-in bodies as GLB, measured in the written files.
#include <gmock/gmock.h>

#include <algorithm>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "support/exported_glb.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Json = nlohmann::ordered_json;

constexpr const char* kAnimation = "shigusa";

// A reach of one body, written and read back.
class Written {
 public:
  explicit Written(CharacterSpec who, const FileSettings& settings = {}) {
    asked_.character = std::move(who);
    asked_.goals = {{"right_hand", {-0.2, 1.0, 0.35}}};
    const Task task = make_task(asked_, {}).value();
    stature = task.body.stature();
    const Candidate best = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
    const auto made = export_candidate(asked_.character, task, best, FileFormat::glb, settings);
    EXPECT_TRUE(made) << made.error().to_string();
    bytes = made.value_or("");
    glb.emplace(bytes);
  }

  [[nodiscard]] int node(const std::string& name) const {
    const Json& nodes = glb->json().at("nodes");
    const auto found = std::find_if(nodes.begin(), nodes.end(),
                                    [&](const Json& one) { return one.at("name") == name; });
    return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
  }
  [[nodiscard]] Vec3d hand(int frame) const {
    return glb->at(node("right_hand_grip"), kAnimation, frame);
  }
  [[nodiscard]] int last() const { return glb->frames(kAnimation) - 1; }

  // How far a node is turned from rest (rad).
  [[nodiscard]] double turned(const std::string& name, int frame) const {
    const int parent = glb->parent(node(name));
    const auto local = [&](const std::string& animation) {
      return transpose(glb->place(parent, animation, frame).rotation) *
             glb->place(node(name), animation, frame).rotation;
    };
    return norm(rotation_vector(transpose(local({})) * local(kAnimation)));
  }

  std::string bytes;
  double stature = 0.0;
  std::optional<ExportedGlb> glb;

 private:
  TaskFile asked_;
};

// The vertices of the skin, blended by an independent reader.
std::vector<Vec3d> skin(const ExportedGlb& glb, const std::string& animation, int frame) {
  const Json& json = glb.json();
  const Json& skin = json.at("skins").at(0);
  const Json& attributes = json.at("meshes").at(0).at("primitives").at(0).at("attributes");
  const auto accessor = [&](const char* name) { return attributes.at(name).get<std::size_t>(); };
  const auto fours = [&](const char* name) {
    const Json& view =
        json.at("bufferViews")
            .at(json.at("accessors").at(accessor(name)).at("bufferView").get<std::size_t>());
    return glb.binary().data() + view.at("byteOffset").get<std::size_t>();
  };
  std::vector<Transformd> bones;
  for (const int joint : skin.at("joints")) {
    const auto m = glb.element(skin.at("inverseBindMatrices"), static_cast<int>(bones.size()));
    bones.push_back(glb.place(joint, animation, frame) *
                    Transformd{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}},
                               {m[12], m[13], m[14]}});
  }
  std::vector<Vec3d> out;
  const int count = json.at("accessors").at(accessor("POSITION")).at("count");
  for (int v = 0; v < count; ++v) {
    const auto p = glb.element(accessor("POSITION"), v);
    Vec3d at{};
    int sum = 0;
    for (int k = 0; k < 4; ++k) {
      const auto bone = static_cast<unsigned char>(fours("JOINTS_0")[4 * v + k]);
      const auto weight = static_cast<unsigned char>(fours("WEIGHTS_0")[4 * v + k]);
      at = at + bones.at(bone) * Vec3d{p[0], p[1], p[2]} * (weight / 255.0);
      sum += weight;
    }
    EXPECT_EQ(sum, 255) << v;
    out.push_back(at);
  }
  return out;
}

std::pair<double, double> heights(const std::vector<Vec3d>& skin) {
  const auto [low, high] = std::minmax_element(
      skin.begin(), skin.end(), [](const Vec3d& a, const Vec3d& b) { return a.y < b.y; });
  return {low->y, high->y};
}

class Mannequins : public testing::TestWithParam<CharacterSpec> {};

TEST_P(Mannequins, ReachTheGoalInTheirOwnSize) {
  const Written out(GetParam());
  EXPECT_LE(norm(out.hand(out.last()) - Vec3d{-0.2, 1.0, 0.35}), 1e-3);
  const auto [low, high] = heights(skin(*out.glb, {}, 0));
  EXPECT_NEAR(low, 0.0, 0.02);
  EXPECT_NEAR(high - low, out.stature, 0.03 * out.stature);
  EXPECT_NEAR(heights(skin(*out.glb, kAnimation, out.last())).first, 0.0, 0.02);
}

TEST_P(Mannequins, MoveWhatFollowsAJointAndTheFingersOfAReachingHand) {
  const Written out(GetParam());
  for (const char* follower : {"right_upper_arm_half", "right_upper_arm_swing",
                               "right_upper_arm_roll", "right_lower_arm_half"}) {
    EXPECT_GT(out.turned(follower, out.last()), 0.02) << follower;
  }
  const int widest = out.last() / 2;
  const double open = out.turned("right_index_intermediate", widest);
  EXPECT_GT(open, 0.2);  // from a relaxed hand
  EXPECT_GT(out.turned("right_index_intermediate", out.last()), 0.2);
  EXPECT_LE(out.turned("right_index_intermediate", 0), 1e-6);
  EXPECT_LE(out.turned("left_index_intermediate", out.last()), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Of, Mannequins,
                         testing::Values(CharacterSpec{},
                                         CharacterSpec{.stature = 1.5, .sex = Sex::female},
                                         CharacterSpec{.stature = 1.95, .mass = 120.0}));

TEST(Mannequin, HasNormalsOfLengthOneAndTheBoundsOfItsPositions) {
  const Written out({});
  const Json& attributes =
      out.glb->json().at("meshes").at(0).at("primitives").at(0).at("attributes");
  const Json& positions =
      out.glb->json().at("accessors").at(attributes.at("POSITION").get<std::size_t>());
  std::vector<double> low(3, 9.0);
  std::vector<double> high(3, -9.0);
  for (int v = 0; v < positions.at("count"); ++v) {
    const auto at = out.glb->element(attributes.at("POSITION"), v);
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = min(low[i], at[i]);
      high[i] = max(high[i], at[i]);
    }
    const auto n = out.glb->element(attributes.at("NORMAL"), v);
    EXPECT_NEAR(norm(Vec3d{n[0], n[1], n[2]}), 1.0, 1e-6);
  }
  EXPECT_EQ(positions.at("min"), Json(low));
  EXPECT_EQ(positions.at("max"), Json(high));
}

TEST(Mannequin, LeavesWithTheNamesOfOthersAndInPlace) {
  const Written out({}, {.names = JointNames::mixamo, .in_place = true});
  EXPECT_GE(out.node("mixamorig:RightForeArm"), 0);
  EXPECT_GE(out.node("mixamorig:Head_end"), 0);
  EXPECT_EQ(out.node("right_lower_arm"), -1);
  const Vec3d way = out.glb->at(0, kAnimation, out.last()) - out.glb->at(0, kAnimation, 0);
  EXPECT_LE(norm(Vec3d{way.x, 0.0, way.z}), 1e-6);
}

TEST(Mannequin, BodiesWithFewerLimbsLeaveTooAndTheSameBytesComeAgain) {
  for (const std::string source : {"full_body", "half_body"}) {
    const Written out({.source = source});
    EXPECT_LE(norm(out.hand(out.last()) - Vec3d{-0.2, 1.0, 0.35}), 1e-3) << source;
    EXPECT_EQ(out.bytes, Written({.source = source}).bytes) << source;
  }
}

TEST(Mannequin, AllMotionsLeaveInOneFile) {
  TaskFile file;
  file.goals = {{"left_hand", {0.2, 1.0, 0.35}}};
  const Task task = make_task(file, {}).value();
  const Candidate one = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  const ExportedGlb glb(export_all(file.character, task, {one, one}).value());
  EXPECT_EQ(glb.json().at("animations").at(1).at("name"), "shigusa candidate 2");
}

// GLB is not a default format of built-in bodies: the page makes the file itself.
TEST(Mannequin, LeavesWhereItIsAskedForAlone) {
  const std::vector<FileFormat> usual = usual_formats({});
  EXPECT_EQ(std::count(usual.begin(), usual.end(), FileFormat::glb), 0);
  EXPECT_TRUE(check_formats({}, {FileFormat::glb}));
  EXPECT_FALSE(check_formats({.source = "hero.bvh"}, {FileFormat::glb}));
}

}  // namespace
}  // namespace shigusa
