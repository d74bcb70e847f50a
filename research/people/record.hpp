// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <shigusa/character.hpp>
#include <shigusa/request.hpp>
#include <string>
#include <vector>

#include "kinematics/fit_clip.hpp"

// A recorded man's reaches to the floor and back up, with the corresponding requests to shigusa.
namespace shigusa::bench {

// One line of the manifest: a reach with the right hand, its frames in the 60 Hz file.
struct Segment {
  std::string name;  // "02_06_00_start-low"
  int first = 0;
  int last = 0;
};
// Lists all reaches, down and up. Fails on a file that cannot be read or has none.
[[nodiscard]] Result<std::vector<Segment>> all_segments(const std::filesystem::path& manifest);
// Selects the downward reaches ("…-low"). Fails on a file that cannot be read or has none.
[[nodiscard]] Result<std::vector<Segment>> downward_segments(const std::filesystem::path& manifest);

// Joints by which postures are compared (m, world of the reach).
enum Joint {
  right_shoulder,
  right_elbow,
  right_hip,
  right_knee,
  right_ankle,
  left_shoulder,
  left_hip,
  left_knee,
  left_ankle,
  right_wrist,
  right_grip,
  kJoints
};
using Joints = std::vector<Vec3d>;  // (kJoints)

// A motion as joint positions, and as angles of two bodies.
struct Track {
  double frame_time = 0.0;     // s
  std::vector<Joints> joints;  // (frames)
  Clip angles;                 // of the body of the extent human
  Clip paper_angles;           // of the 18 dofs with the nearest joints
  [[nodiscard]] double duration() const {
    return static_cast<double>(joints.size() - 1) * frame_time;
  }
};

// A recorded reach.
struct Recorded {
  Segment segment;
  SkeletonMotion motion;  // the whole file
  CharacterSpec person;   // measured in the first frame, extent human
  PosedBody posed;        // and the same with 18 dofs
  PosedBody paper;
  Track track{};
  double fit_mean = 0.0;        // m, between the body's joints and his
  double paper_fit_mean = 0.0;  // m, with 18 dofs

  // Input of shigusa: his body, the end position of his hand, and his duration.
  [[nodiscard]] Task task() const;
};
// `heels`: on a body with lifting heels.
[[nodiscard]] Result<Recorded> read_reach(const std::filesystem::path& clip, const Segment& segment,
                                          bool heels = false);

// A motion of a body with these joints; without the angles of another body.
[[nodiscard]] Track joints_track(const BodyModel& body, const Clip& clip);

// A generated motion of the reach's body.
[[nodiscard]] Track track_of(const Recorded& reach, const Clip& clip);

}  // namespace shigusa::bench
