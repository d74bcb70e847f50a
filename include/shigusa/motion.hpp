// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <shigusa/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace shigusa {

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
