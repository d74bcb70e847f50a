// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// One named node of a hierarchy; its frame at rest has the parent's orientation.
struct SkeletonNode {
  std::string name;       ///< unique; empty for an end site
  int parent = -1;        ///< index of an earlier node; -1 for a root
  Vec3d offset{};         ///< m, origin in the parent's frame at rest
  bool end_site = false;  ///< marks the tip of its parent; carries no motion
};

/// A hierarchy of named nodes, parents before children: the form that files hold. The kernel
/// computes on BodyModel instead.
struct Skeleton {
  std::vector<SkeletonNode> nodes;  ///< parents before children

  /// Index of the node of that name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
};

/// A node's place in its parent's frame.
struct LocalTransform {
  Vec3d translation{};  ///< m
  Quatd rotation{};     ///< from the node's axes to its parent's
};

/// Motion of a skeleton at a constant frame time.
struct SkeletonClip {
  double frame_time = 1.0 / 60.0;     ///< s
  int frames = 0;                     ///< postures, at equal times
  std::vector<LocalTransform> local;  ///< (frames × nodes) each node in its parent's frame

  /// The transforms of all nodes at one frame, 0..frames-1.
  [[nodiscard]] const LocalTransform* frame(const Skeleton& skeleton, int index) const {
    return local.data() + static_cast<std::size_t>(index) * skeleton.nodes.size();
  }
};

/// A skeleton with its motion: what a motion file holds. Metres, seconds, radians.
struct SkeletonMotion {
  Skeleton skeleton;  ///< the nodes at rest
  SkeletonClip clip;  ///< how they move
};

/// Origins of all nodes at rest: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Vec3d> rest_origins(const Skeleton& skeleton);

/// World transforms of all nodes at one frame: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Transformd> world_transforms(const Skeleton& skeleton,
                                                       const SkeletonClip& clip, int frame);

/// The bones that a motion needs, named as in the VRM 1.0 humanoid vocabulary.
enum class HumanoidBone {
  hips,             ///< the root of what moves
  neck,             ///< above the shoulders
  head,             ///< turns with the gaze
  left_upper_leg,   ///< thigh: turns about the hip
  left_lower_leg,   ///< shank: turns about the knee
  left_foot,        ///< turns about the ankle
  left_toes,        ///< turn about the ball of the foot
  right_upper_leg,  ///< thigh: turns about the hip
  right_lower_leg,  ///< shank: turns about the knee
  right_foot,       ///< turns about the ankle
  right_toes,       ///< turn about the ball of the foot
  left_upper_arm,   ///< turns about the shoulder
  left_lower_arm,   ///< turns about the elbow
  left_hand,        ///< turns about the wrist
  right_upper_arm,  ///< turns about the shoulder
  right_lower_arm,  ///< turns about the elbow
  right_hand,       ///< turns about the wrist
  spine,            ///< the lowest joint of the trunk; from here on a skeleton may lack bones
  chest,            ///< the joint above it
  upper_chest,      ///< the joint above that
  left_shoulder,    ///< clavicle
  right_shoulder,   ///< clavicle
};
/// Number of the bones.
inline constexpr int kHumanoidBoneCount = 22;

/// "right_upper_leg".
[[nodiscard]] std::string_view humanoid_bone_name(HumanoidBone bone);

/// Which node of a skeleton is which bone; the node's origin is the bone's proximal joint.
struct HumanoidMap {
  std::array<int, kHumanoidBoneCount> node;  ///< node index, or -1 where the skeleton has none
  std::vector<Message> doubts;               ///< sentences for a person: guesses that may be wrong
  bool mirrored = false;  ///< what is called left is on the body's right: a mirrored file

  /// No bone is known.
  HumanoidMap() { node.fill(-1); }
  /// The node that a bone is, or -1.
  [[nodiscard]] int operator[](HumanoidBone bone) const {
    return node[static_cast<std::size_t>(bone)];
  }
  /// The same, to be changed.
  [[nodiscard]] int& operator[](HumanoidBone bone) { return node[static_cast<std::size_t>(bone)]; }
};

/// Steps of a motion that is generated (rule R6); it has a frame more.
inline constexpr int kMotionSteps = 60;

/// A body's motion: joint angles at equally spaced times.
struct Clip {
  int dofs = 0;                    ///< freedoms of the body
  int frames = 0;                  ///< postures
  double frame_time = 1.0 / 60.0;  ///< s
  std::vector<double> angles;      ///< (frames × dofs) rad, dof order of BodyModel

  /// (dofs) rad, the angles of one frame, 0..frames-1.
  [[nodiscard]] std::span<const double> frame(int index) const {
    return std::span<const double>(angles).subspan(
        static_cast<std::size_t>(index) * static_cast<std::size_t>(dofs),
        static_cast<std::size_t>(dofs));
  }
  /// From the first frame to the last (s).
  [[nodiscard]] double duration() const { return frames > 1 ? (frames - 1) * frame_time : 0.0; }
};

/// Frames a second of the files that motions leave in, where nobody asks for others (Hz).
inline constexpr double kUsualRate = 60.0;
/// The fewest frames a second that can be asked for (Hz).
inline constexpr double kRateMin = 1.0;
/// The most frames a second that can be asked for (Hz).
inline constexpr double kRateMax = 240.0;

/// Frames that a motion of this duration (s) has at a rate (frames/s), the first at time 0: the
/// last one is the first that is not before the motion's end.
[[nodiscard]] int frames_at(double duration, double rate);

/// The clip at `rate` frames a second: frame k is the posture at k / rate, and the last one exactly
/// the clip's last. Between the clip's frames angles follow cubic Hermite splines, whose slope in a
/// frame is that between its neighbours, and 0 in the first and the last: a motion begins and ends
/// at rest. Where the clip's frames are h seconds apart, an angle q is off by h³ |d³q/dt³| / 40 at
/// most. Needs a frame, and a rate from kRateMin to kRateMax.
[[nodiscard]] Clip resampled(const Clip& clip, double rate);

/// A hand that rests on something, and what it bears, frame after frame.
struct RestingHand {
  int effector = 0;            ///< see BodyModel::effector
  std::optional<int> thigh{};  ///< link that bears the opposite force; none of a thing of the world
  std::vector<Vec3d> places{};  ///< (frames) m, world: where the hand's point is
  std::vector<Vec3d> forces{};  ///< (frames) N, world: on the hand
};

/// A motion with the quantities that can be read off it. Criteria of the user's own are given this.
struct Motion {
  Clip clip;                                  ///< joint angles
  std::vector<double> torques;                ///< (frames × dofs) N·m, dof order of BodyModel
  std::vector<Vec3d> centre_of_mass;          ///< (frames) m, world
  std::vector<std::vector<Vec3d>> effectors;  ///< [goal][frame] m, world: where the goal's point is
  std::vector<RestingHand> resting{};         ///< hands that rest on something
};

/// How far a recorded foot goes from where it is in the first frame.
struct FootTravel {
  std::string foot;     ///< "right_foot"
  int node = -1;        ///< of the recorded skeleton
  bool base = false;    ///< the body stands on it, so that it cannot follow
  double travel = 0.0;  ///< m, of its joint, the most at any frame
  double turn = 0.0;    ///< rad, the same
};

/// A recorded motion as a body's angles.
struct ClipFit {
  Clip clip;       ///< with the frames around
  int before = 0;  ///< how many of these come before the first that is looked at
  /// m, between recorded joints and the body's, over joints and frames; those of the standing foot
  /// apart
  double mean_distance = 0.0;
  double worst_distance = 0.0;   ///< m, the largest of the same
  std::string worst_joint;       ///< humanoid bone that it is of
  int worst_frame = 0;           ///< of the record, when it is
  std::vector<FootTravel> feet;  ///< how far the recorded feet go
};

}  // namespace shigusa
