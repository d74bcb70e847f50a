// SPDX-License-Identifier: MIT
#include "rig/finger_bones.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <functional>
#include <shigusa/math.hpp>

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// Two hands whose arms point along `arm` (the left one's; the right one's is its mirror image),
// palms down, with the names of their nodes.
class Hands {
 public:
  explicit Hands(std::function<std::string(int, int, bool)> name, const Vec3d& arm = {1, 0, 0},
                 int joints = 3)
      : name_(std::move(name)), joints_(joints) {
    add("hips", -1, {0, 1, 0});
    for (const bool left : {true, false}) hand(left, arm);
  }

  [[nodiscard]] std::vector<FingerBone> found(bool mirrored = false) const {
    std::vector<Transformd> world;
    for (const Vec3d& p : at_) world.push_back({{}, p});
    return find_finger_bones(skeleton_, world, map_, {}, mirrored);
  }
  [[nodiscard]] const std::vector<Vec3d>& at() const { return at_; }
  [[nodiscard]] const std::string& name(int node) const {
    return skeleton_.nodes[static_cast<std::size_t>(node)].name;
  }
  [[nodiscard]] Vec3d out_of_palm(bool left) const { return palm_[left ? 0 : 1]; }
  Skeleton& skeleton() { return skeleton_; }

 private:
  int add(const std::string& name, int parent, const Vec3d& at) {
    const Vec3d from = parent < 0 ? Vec3d{} : at_[static_cast<std::size_t>(parent)];
    skeleton_.nodes.push_back({name, parent, at - from});
    at_.push_back(at);
    return static_cast<int>(at_.size()) - 1;
  }

  void hand(bool left, Vec3d along) {
    if (!left) along.x = -along.x;
    along = normalized(along);
    const Vec3d ahead{0, 0, 1};  // the thumb's side
    palm_[left ? 0 : 1] = left ? cross(along, ahead) : cross(ahead, along);
    const Vec3d wrist = Vec3d{left ? 0.2 : -0.2, 1.4, 0} + along * 0.5;
    const int hand = add(left ? "LeftHand" : "RightHand", 0, wrist);
    map_[left ? Bone::left_hand : Bone::right_hand] = hand;
    for (int f = 0; f < 5; ++f) {
      const bool thumb = f == 0;
      const Vec3d root =
          thumb ? along * 0.02 + ahead * 0.03 : along * 0.09 + ahead * (0.06 - 0.02 * f);
      const Vec3d way = normalized(thumb ? along + ahead : along + ahead * (0.25 - 0.1 * f));
      int on = hand;
      for (int k = 0; k < joints_; ++k) {
        on = add(name_(f, k + 1, left), on, wrist + root + way * (0.03 * k));
      }
    }
  }

  std::function<std::string(int, int, bool)> name_;
  int joints_;
  Skeleton skeleton_;
  std::vector<Vec3d> at_;
  HumanoidMap map_;
  std::array<Vec3d, 2> palm_{};
};

std::string mixamo(int f, int k, bool left) {
  constexpr std::array kNames{"Thumb", "Index", "Middle", "Ring", "Pinky"};
  return std::string("mixamorig:") + (left ? "Left" : "Right") + "Hand" +
         kNames[static_cast<std::size_t>(f)] + std::to_string(k);
}
std::string rigify(int f, int k, bool left) {
  constexpr std::array kNames{"thumb", "f_index", "f_middle", "f_ring", "f_pinky"};
  return std::string("DEF-") + kNames[static_cast<std::size_t>(f)] + ".0" + std::to_string(k) +
         (left ? ".L" : ".R");
}
std::string unreal(int f, int k, bool left) {
  constexpr std::array kNames{"thumb", "index", "middle", "ring", "pinky"};
  return std::string(kNames[static_cast<std::size_t>(f)]) + "_0" + std::to_string(k) +
         (left ? "_l" : "_r");
}
std::string biped(int f, int k, bool left) {
  return std::string("Bip01 ") + (left ? "L" : "R") + " Finger" + std::to_string(f) +
         (k > 1 ? std::to_string(k - 1) : "");
}
std::string makehuman(int f, int k, bool left) {
  return "finger" + std::to_string(f + 1) + "-" + std::to_string(k) + (left ? ".L" : ".R");
}
std::string daz(int f, int k, bool left) {
  constexpr std::array kNames{"Thumb", "Index", "Mid", "Ring", "Pinky"};
  return (left ? "l" : "r") + std::string(kNames[static_cast<std::size_t>(f)]) + std::to_string(k);
}
std::string vroid(int f, int k, bool left) {
  constexpr std::array kNames{"Thumb", "Index", "Middle", "Ring", "Little"};
  return std::string("J_Bip_") + (left ? "L_" : "R_") + kNames[static_cast<std::size_t>(f)] +
         std::to_string(k);
}
std::string mmd(int f, int k, bool left) {
  constexpr std::array kNames{"親指", "人指", "中指", "薬指", "小指"};
  constexpr std::array kDigits{"０", "１", "２", "３"};
  return (left ? "左" : "右") + std::string(kNames[static_cast<std::size_t>(f)]) +
         kDigits[static_cast<std::size_t>(k)];
}

TEST(FingerNames, OfAllConventionsAreRead) {
  for (const auto& name : {mixamo, rigify, unreal, biped, makehuman, daz, vroid, mmd}) {
    const Hands hands(name);
    const std::vector<FingerBone> bones = hands.found();
    ASSERT_EQ(bones.size(), 30u) << name(1, 1, true);
    for (const FingerBone& bone : bones) {
      EXPECT_EQ(hands.name(bone.node),
                name(static_cast<int>(bone.finger), bone.joint, bone.side == Side::left));
    }
  }
}

TEST(FingerBones, TipsAndMetacarpalsAreNone) {
  const Hands with_tips(mixamo, {1, 0, 0}, 4);
  EXPECT_EQ(with_tips.found().size(), 30u);
  // the first of four is a metacarpal's by its name
  const Hands with_metacarpals(
      [](int f, int k, bool left) {
        if (f == 0) return unreal(f, k, left);
        return k == 1 ? unreal(f, 1, left) + "_metacarpal" : unreal(f, k - 1, left);
      },
      {1, 0, 0}, 4);
  for (const FingerBone& bone : with_metacarpals.found()) {
    EXPECT_EQ(with_metacarpals.name(bone.node).find("metacarpal"), std::string::npos);
  }
  EXPECT_EQ(with_metacarpals.found().size(), 30u);
}

TEST(FingerBones, AHandWithOneFingerHasNone) {
  const Hands hands([](int f, int k, bool left) {
    return f < 2 ? mixamo(f, k, left) : "Prop" + std::to_string(f) + std::to_string(k);
  });
  EXPECT_TRUE(hands.found().empty());
}

TEST(FingerBones, ControlsOfFingersAreNone) {
  const Hands hands([](int f, int k, bool left) { return "MCH-" + rigify(f, k, left).substr(4); });
  EXPECT_TRUE(hands.found().empty());
}

// Displacement of a bone's tip when the bone turns by a small positive angle.
Vec3d goes(const FingerBone& bone, const Vec3d& way) { return cross(bone.axis, way); }

class FingerAxes : public testing::TestWithParam<Vec3d> {};

TEST_P(FingerAxes, BendToThePalm) {
  for (const bool mirrored : {false, true}) {
    const Hands hands(mixamo, GetParam());
    for (const FingerBone& bone : hands.found(mirrored)) {
      if (bone.joint == 3) continue;
      // the next node is the next joint
      const auto at = static_cast<std::size_t>(bone.node);
      const Vec3d way = normalized(hands.at()[at + 1] - hands.at()[at]);
      const Vec3d palm = hands.out_of_palm(bone.side == Side::left) * (mirrored ? -1.0 : 1.0);
      EXPECT_NEAR(norm(bone.axis), 1.0, 1e-12);
      EXPECT_NEAR(dot(bone.axis, way), 0.0, 1e-12);
      EXPECT_NEAR(bone.bent, 0.0, 1e-12);
      // a finger straight out of the palm's plane, the thumb half across it
      EXPECT_GT(dot(goes(bone, way), palm), bone.finger == Finger::thumb ? 0.4 : 0.999)
          << hands.name(bone.node);
    }
  }
}

TEST_P(FingerAxes, OfThumbsCrossThePalm) {
  const Hands hands(mixamo, GetParam());
  for (const FingerBone& bone : hands.found()) {
    if (bone.finger != Finger::thumb || bone.joint == 3) continue;
    const auto at = static_cast<std::size_t>(bone.node);
    const Vec3d way = normalized(hands.at()[at + 1] - hands.at()[at]);
    EXPECT_LT(goes(bone, way).z, -0.2);  // away from the thumb's side
  }
}

std::string name_of(const testing::TestParamInfo<Vec3d>& info) {
  constexpr std::array kNames{"T", "A", "Hanging"};
  return kNames[info.index];
}

INSTANTIATE_TEST_SUITE_P(Poses, FingerAxes,
                         testing::Values(Vec3d{1, 0, 0}, Vec3d{1, -1, 0}, Vec3d{0.1, -1, 0}),
                         name_of);

TEST(FingerBones, WhatIsBentIsTold) {
  Hands hands(mixamo);
  std::vector<Transformd> world;
  // the left index finger: 30 degrees at its knuckle and 20 at the next joint
  for (const Vec3d& p : hands.at()) world.push_back({{}, p});
  const std::vector<FingerBone> straight = hands.found();
  const auto index = std::find_if(straight.begin(), straight.end(), [](const FingerBone& b) {
    return b.side == Side::left && b.finger == Finger::index && b.joint == 1;
  });
  const auto node = static_cast<std::size_t>(index->node);
  const Vec3d way = normalized(hands.at()[node + 1] - hands.at()[node]);
  const auto bent = [&](double angle) {
    const SinCos<double> turn = sin_cos(radians(angle));
    return way * turn.cos + Vec3d{0, -1, 0} * turn.sin;
  };
  Skeleton& skeleton = hands.skeleton();
  skeleton.nodes[node + 1].offset = bent(30) * 0.03;
  skeleton.nodes[node + 2].offset = bent(50) * 0.03;
  world[node + 1].translation = world[node].translation + bent(30) * 0.03;
  world[node + 2].translation = world[node + 1].translation + bent(50) * 0.03;
  HumanoidMap map;
  map[Bone::left_hand] = skeleton.find("LeftHand");
  for (const FingerBone& bone : find_finger_bones(skeleton, world, map, {}, false)) {
    if (bone.finger != Finger::index) continue;
    const double wanted = bone.joint == 1 ? 30.0 : bone.joint == 2 ? 20.0 : 0.0;
    EXPECT_NEAR(degrees(bone.bent), wanted, 1e-6) << bone.joint;
  }
}

TEST(FingerBones, HaveTheNamesOfVrm) {
  EXPECT_EQ(vrm_finger_name({0, Side::left, Finger::index, 1, {}, 0.0}), "leftIndexProximal");
  EXPECT_EQ(vrm_finger_name({0, Side::right, Finger::little, 3, {}, 0.0}), "rightLittleDistal");
  EXPECT_EQ(vrm_finger_name({0, Side::right, Finger::thumb, 1, {}, 0.0}), "rightThumbMetacarpal");
  EXPECT_EQ(vrm_finger_name({0, Side::right, Finger::thumb, 2, {}, 0.0}), "rightThumbProximal");
}

}  // namespace
}  // namespace shigusa
