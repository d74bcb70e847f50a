// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// A named node of a hierarchy; its frame at rest has the parent's orientation.
struct SkeletonNode {
  std::string name;       ///< unique; empty for an end site
  int parent = -1;        ///< index of an earlier node; -1 for a root
  Vec3d offset{};         ///< m, origin in the parent's frame at rest
  bool end_site = false;  ///< marks the tip of its parent; carries no motion
};

/// A hierarchy of named nodes, parents before children, as stored in motion files. For computation
/// see BodyModel.
struct Skeleton {
  std::vector<SkeletonNode> nodes;  ///< parents before children

  /// Index of the node with this name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
};

/// The pose of a node in its parent's frame.
struct LocalTransform {
  Vec3d translation{};  ///< m
  Quatd rotation{};     ///< from the node's axes to its parent's
};

/// A motion of a skeleton at a constant frame time.
struct SkeletonClip {
  double frame_time = 1.0 / 60.0;     ///< s
  int frames = 0;                     ///< number of frames
  std::vector<LocalTransform> local;  ///< (frames × nodes) each node in its parent's frame

  /// The transforms of all nodes at one frame, 0..frames-1.
  [[nodiscard]] const LocalTransform* frame(const Skeleton& skeleton, int index) const {
    return local.data() + static_cast<std::size_t>(index) * skeleton.nodes.size();
  }
};

/// A skeleton with its motion, the content of a motion file. Metres, seconds, radians.
struct SkeletonMotion {
  Skeleton skeleton;  ///< the nodes at rest
  SkeletonClip clip;  ///< their motion
};

/// Origins of all nodes at rest: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Vec3d> rest_origins(const Skeleton& skeleton);

/// World transforms of all nodes at one frame: (nodes), in the file's world, metres.
[[nodiscard]] std::vector<Transformd> world_transforms(const Skeleton& skeleton,
                                                       const SkeletonClip& clip, int frame);

/// The bones used here of the VRM 1.0 humanoid vocabulary.
enum class HumanoidBone {
  hips,             ///< pelvis, root of the motion
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
/// Number of humanoid bones.
inline constexpr int kHumanoidBoneCount = 22;

/// The name of a bone in snake_case: "right_upper_leg".
[[nodiscard]] std::string_view humanoid_bone_name(HumanoidBone bone);

/// The nodes of a skeleton that correspond to humanoid bones; a node's origin is the bone's
/// proximal joint.
struct HumanoidMap {
  std::array<int, kHumanoidBoneCount> node;  ///< node index of each bone; -1 for a missing bone
  std::vector<Message> doubts;               ///< warnings for the user: guesses that may be wrong
  bool mirrored = false;  ///< left and right names are exchanged: a mirrored file

  /// A map without bones.
  HumanoidMap() { node.fill(-1); }
  /// The node index of a bone, or -1.
  [[nodiscard]] int operator[](HumanoidBone bone) const {
    return node[static_cast<std::size_t>(bone)];
  }
  /// Mutable access.
  [[nodiscard]] int& operator[](HumanoidBone bone) { return node[static_cast<std::size_t>(bone)]; }
};

/// Number of steps of a generated motion (rule R6), which has one frame more.
inline constexpr int kMotionSteps = 60;

/// A motion of a body: joint angles at equally spaced times.
struct Clip {
  int dofs = 0;                    ///< degrees of freedom of the body
  int frames = 0;                  ///< number of frames
  double frame_time = 1.0 / 60.0;  ///< s
  std::vector<double> angles;      ///< (frames × dofs) rad, dof order of BodyModel
  /// (dofs) rad, the angles one frame before the first; empty: the motion begins at rest.
  std::vector<double> before{};

  /// Angles of one frame, 0..frames-1: (dofs) rad.
  [[nodiscard]] std::span<const double> frame(int index) const {
    return std::span<const double>(angles).subspan(
        static_cast<std::size_t>(index) * static_cast<std::size_t>(dofs),
        static_cast<std::size_t>(dofs));
  }
  /// Angles of the frame before one: (dofs) rad; before the first, its own if the motion begins at
  /// rest.
  [[nodiscard]] std::span<const double> frame_before(int index) const {
    if (index > 0) return frame(index - 1);
    return before.empty() ? frame(0) : std::span<const double>(before);
  }
  /// The state in one frame, 0..frames-1, with velocities by central differences; at rest in the
  /// last frame, and in the first without `before`.
  [[nodiscard]] State state(int index) const;
  /// Duration from the first frame to the last (s).
  [[nodiscard]] double duration() const { return frames > 1 ? (frames - 1) * frame_time : 0.0; }
};

/// Default frame rate of motion files (Hz).
inline constexpr double kUsualRate = 60.0;
/// Smallest frame rate of motion files (Hz).
inline constexpr double kRateMin = 1.0;
/// Largest frame rate of motion files (Hz).
inline constexpr double kRateMax = 240.0;

/// Number of frames of a motion of a duration (s) at a rate (frames/s): the first at time 0, the
/// last the first one at or after the motion's end.
[[nodiscard]] int frames_at(double duration, double rate);

/// Resamples a clip at `rate` frames per second: frame k is the posture at k / rate, and the last
/// frame is the clip's last posture. Angles are interpolated by cubic Hermite splines, whose slope
/// at a frame is that between its neighbours, 0 at the last frame, and at the first 0 or by
/// `before` if there is one. For frames h seconds apart the error of an angle q is at most h³
/// |d³q/dt³| / 40. Needs at least one frame, and a rate in kRateMin..kRateMax.
[[nodiscard]] Clip resampled(const Clip& clip, double rate);

/// The contact of a resting hand with its force in each frame.
struct RestingHand {
  int effector = 0;  ///< index of the effector, see BodyModel::effector
  /// Link of the thigh that bears the opposite force; empty for an obstacle.
  std::optional<int> thigh{};
  std::vector<Vec3d> places{};  ///< (frames) m, world: position of the hand's point
  std::vector<Vec3d> forces{};  ///< (frames) N, world: force on the hand
};

/// A motion with its derived quantities; the input of user-defined criteria.
struct Motion {
  Clip clip;                          ///< joint angles
  std::vector<double> torques;        ///< (frames × dofs) N·m, dof order of BodyModel
  std::vector<Vec3d> centre_of_mass;  ///< (frames) m, world
  /// [goal][frame] m, world: position of the goal's effector.
  std::vector<std::vector<Vec3d>> effectors;
  std::vector<RestingHand> resting{};  ///< resting hands
};

/// The largest deviation of a recorded foot from its pose in the first frame.
struct FootTravel {
  std::string foot;     ///< "right_foot"
  int node = -1;        ///< node index in the recorded skeleton
  bool base = false;    ///< the foot is the body's fixed base, which cannot follow
  double travel = 0.0;  ///< m, largest displacement of its joint
  double turn = 0.0;    ///< rad, largest rotation
};

/// A recorded motion fitted to a body.
struct ClipFit {
  Clip clip;       ///< joint angles, including frames before and after the scored ones
  int before = 0;  ///< number of frames before the first scored one
  /// Mean distance (m) of recorded joints from the body's, over joints and frames, without those of
  /// the standing foot.
  double mean_distance = 0.0;
  double worst_distance = 0.0;   ///< m, largest distance
  std::string worst_joint;       ///< humanoid bone of the largest distance
  int worst_frame = 0;           ///< recorded frame of the largest distance
  std::vector<FootTravel> feet;  ///< movement of the recorded feet
};

}  // namespace shigusa
