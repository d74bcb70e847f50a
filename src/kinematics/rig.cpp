// SPDX-License-Identifier: MIT
#include "kinematics/rig.hpp"

#include <optional>

#include "core/check.hpp"
#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "math/linear_map.hpp"
#include "rig_drivers.hpp"
#include "rig_fingers.hpp"
#include "rig_twist.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// An affine map p -> linear p + at; rotations from the file include its scales.
using Affine = Transformd;

// Equality of rotations to within rounding; q and -q are the same.
bool same_rotation(const Quatd& a, const Quatd& b) {
  constexpr double kSame = 1e-9;  // half the angle between them (rad)
  const double sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0.0 ? -1.0 : 1.0;
  return max(max(abs(a.x - sign * b.x), abs(a.y - sign * b.y)),
             max(abs(a.z - sign * b.z), abs(a.w - sign * b.w))) < kSame;
}

// The driver of a node's bone, with the node's share of its limb's twist.
struct NodeDriver {
  BoneDriver bone;
  int limb = -1;  // index in LimbTwists; -1: full twist
  double share = 0.0;
};

class RigMover {
 public:
  RigMover(const PosedBody& posed, const Rig& rig, const HandPlay& hands, bool in_file)
      : RigMover(posed, rig, hands, in_file, human_frames(rig.rest), human_frames(rig.start)) {}

  RigMover(const PosedBody& posed, const Rig& rig, const HandPlay& hands, bool in_file,
           const HumanFrames& rest, const HumanFrames& start)
      : body_(posed.body),
        rig_(rig),
        in_file_(in_file || rig.placement.mirrored()),
        start_(home_kinematics(posed)),
        now_(body_),
        twists_(body_, rig, rest, start, start_),
        fingers_(rig, hands),
        driver_(rig.nodes.size(), -1) {
    for (int b = 0; b < kHumanoidBoneCount; ++b) {
      const int node = rig.bones.node[index(b)];
      if (node < 0) continue;
      const auto driver = bone_driver(static_cast<Bone>(b), body_, rig, rest, start);
      if (!driver) continue;
      const bool apart = untwisted(rig.twists, static_cast<Bone>(b));
      drive(node, {*driver, apart ? twists_.find(static_cast<Bone>(b)) : -1});
    }
    for (const TwistBone& twist : rig.twists) {
      const int limb = twists_.find(twist.bone);
      auto driver = bone_driver(twist.bone, body_, rig, rest, start);
      if (limb < 0 || !driver) continue;
      // a twist bone below the limb is carried by it
      driver->carries = !hangs_on(twist.node, rig.bones[twist.bone]);
      drive(twist.node, {*driver, limb, twist.share});
    }
    for (const Side side : {Side::left, Side::right}) {
      // a grip that is another bone's node moves with that bone; otherwise with the hand
      const int grip = rig.grips[static_cast<std::size_t>(side)];
      const auto hand = side == Side::left ? Bone::left_hand : Bone::right_hand;
      if (grip < 0 || driver_[index(grip)] >= 0) continue;
      if (const auto driver = bone_driver(hand, body_, rig, rest, start)) drive(grip, {*driver});
    }
    find_places();
  }

  RigMotion play(const Clip& clip) {
    const std::size_t nodes = rig_.nodes.size();
    RigMotion motion{clip.frame_time, clip.frames, {}, {}, {}};
    motion.turns.resize(nodes);
    motion.moves.resize(nodes);
    motion.local.reserve(index(clip.frames) * nodes);
    for (int f = 0; f < clip.frames; ++f) {
      forward_kinematics<double>(body_, clip.frame(f), now_);
      twists_.show(now_);
      share_ = clip.frames > 1 ? static_cast<double>(f) / (clip.frames - 1) : 0.0;
      for (std::size_t i = 0; i < nodes; ++i) motion.local.push_back(place(i, motion));
    }
    return motion;
  }

 private:
  [[nodiscard]] bool hangs_on(int node, int ancestor) const {
    while (node > ancestor) node = rig_.nodes[index(node)].parent;
    return node == ancestor;
  }

  void drive(int node, const NodeDriver& driver) {
    driver_[index(node)] = static_cast<int>(drivers_.size());
    drivers_.push_back(driver);
  }

  // Finds the rest placements of the nodes, and the drivers of those that are not bones.
  void find_places() {
    for (std::size_t i = 0; i < rig_.nodes.size(); ++i) {
      const RigNode& node = rig_.nodes[i];
      SHG_CHECK(node.parent < static_cast<int>(i), "parents come before their children");
      const Mat3d turn = to_matrix(node.rotation);
      const Affine local{{turn.cx * node.scale.x, turn.cy * node.scale.y, turn.cz * node.scale.z},
                         node.translation};
      if (node.parent < 0) {
        rest_.push_back(local);
        continue;
      }
      const std::size_t parent = index(node.parent);
      rest_.push_back(rest_[parent] * local);
      if (driver_[i] < 0) driver_[i] = driver_[parent];
    }
    placed_ = rest_;
  }

  // Placement of a node by its driver from its rest placement, in the file's units: only the
  // rotation has a linear part, as the units cancel.
  [[nodiscard]] Affine moved(const NodeDriver& driver, const Affine& rest) const {
    const int link = driver.bone.link;
    const Transformd from{start_.link_rotation(link), start_.link_origin(link)};
    const Transformd to{now_.link_rotation(link), now_.link_origin(link)};
    Transformd move = to * inverse(from) * driver.bone.to_start;
    if (driver.limb >= 0) move = twists_.turn(driver.limb, driver.share) * move;
    const Placement& file = rig_.placement;
    const Mat3d axes = transpose(Mat3d{file.left, file.up, file.ahead});
    const Vec3d at = move * file.to_world(rest.translation);
    if (!in_file_) return {move.rotation * (axes * rest.rotation), at * (1.0 / file.unit)};
    return {transpose(axes) * (move.rotation * (axes * rest.rotation)),
            transpose_times(axes, at) * (1.0 / file.unit) + file.origin};
  }

  // A node's transform in its parent, whose placement in this frame is known.
  LocalTransform place(std::size_t i, RigMotion& motion) {
    const RigNode& node = rig_.nodes[i];
    LocalTransform local{node.translation, node.rotation};
    const std::size_t parent = index(node.parent);
    const Affine above = node.parent < 0 ? Affine{} : placed_[parent];
    const bool changes = driver_[i] >= 0 && (node.parent < 0 || driver_[i] != driver_[parent]);
    const std::optional<Mat3d> to_parent = changes ? inverse_of(above.rotation) : std::nullopt;
    if (to_parent) turn(i, above, *to_parent, local, motion);
    if (fingers_.turns(i)) {
      local.rotation = fingers_.turned(i, share_, local.rotation);
      if (!same_rotation(local.rotation, node.rotation)) motion.turns[i] = true;
    }
    const Mat3d r = to_matrix(local.rotation);
    placed_[i] = above * Affine{{r.cx * node.scale.x, r.cy * node.scale.y, r.cz * node.scale.z},
                                local.translation};
    return local;
  }

  void turn(std::size_t i, const Affine& above, const Mat3d& to_parent, LocalTransform& local,
            RigMotion& motion) const {
    const RigNode& node = rig_.nodes[i];
    const NodeDriver& driver = drivers_[index(driver_[i])];
    const Affine goal = moved(driver, rest_[i]);
    Mat3d m = to_parent * goal.rotation;
    const Vec3d& s = node.scale;
    if (s.x != 0.0 && s.y != 0.0 && s.z != 0.0) {
      m = orthonormal({m.cx * (1.0 / s.x), m.cy * (1.0 / s.y), m.cz * (1.0 / s.z)});
      const Quatd turned = to_quat(m);
      if (!same_rotation(turned, node.rotation)) {
        local.rotation = turned;
        motion.turns[i] = true;
      }
    }
    if (!driver.bone.carries) return;
    const Vec3d at = to_parent * (goal.translation - above.translation);
    // displacements by rounding alone are dropped
    constexpr double kStill = 1e-6;  // m
    const double off = norm(above.rotation * (at - node.translation)) * rig_.placement.unit;
    if (node.parent >= 0 && driver_[index(node.parent)] >= 0 && off < kStill) {
      return;
    }
    local.translation = at;
    motion.moves[i] = true;
  }

  const BodyModel& body_;
  const Rig& rig_;
  bool in_file_;  // placements are in the file's axes, and not in the world's
  Kinematics<double> start_;
  Kinematics<double> now_;
  LimbTwists twists_;
  FingerMover fingers_;
  double share_ = 0.0;  // of the motion's time
  std::vector<NodeDriver> drivers_;
  std::vector<int> driver_;     // (nodes) index in drivers_, or -1
  std::vector<Affine> rest_;    // (nodes) in the file's world
  std::vector<Affine> placed_;  // (nodes) the same in this frame
};

}  // namespace

RigMotion rig_motion(const PosedBody& body, const Clip& clip, const Rig& rig, const HandPlay& hands,
                     bool in_file) {
  return RigMover(body, rig, hands, in_file).play(clip);
}

}  // namespace shigusa
