// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <shigusa/motion.hpp>
#include <vector>

#include "character_file.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {

// Largest numbers of frames for detecting the up axis, and of start frames that are examined
// closely.
inline constexpr int kFramesForUp = 64;
inline constexpr int kStartsTried = 24;

// A file's motion as landmarks of a person: joints move with their nodes; soles and tips move
// rigidly with the last joint of their limb. Cheap enough for every frame.
class Recording {
 public:
  // Borrows all arguments. `world`: (nodes) pose in which the person was measured.
  Recording(const CharacterFile& file, const HumanoidMap& map, const MeasuredPerson& person,
            const std::vector<Transformd>& world);

  // Landmarks of the person in a frame, in shigusa's world, upright along the recording's up axis.
  // That is y for glTF that rests along y; else the axis of the file along which most frames stand,
  // with preference for one whose 0 is the floor under the person.
  [[nodiscard]] Landmarks at(int frame) const;

  // First frame in which the person stands on both feet, in neither T nor A pose, and `holds` is
  // true; with `still` they must not move either.
  [[nodiscard]] std::optional<int> first_stand(
      bool still, const std::function<bool(const Landmarks&)>& holds) const;

 private:
  struct Attached {
    int node = 0;
    Vec3d point{};  // in the node's frame
  };

  [[nodiscard]] Attached attach(int node, const Vec3d& point) const;
  [[nodiscard]] Landmarks in_file(int frame) const;
  [[nodiscard]] Vec3d find_up() const;
  [[nodiscard]] bool reads(int frame) const;
  [[nodiscard]] bool stands_still(int frame) const;

  const Skeleton& skeleton_;
  const SkeletonClip& clip_;
  const HumanoidMap& map_;
  const MeasuredPerson& person_;
  const std::vector<Transformd>& world_;
  bool y_is_up_;                     // fixed by the format
  std::vector<bool> unread_;         // (frames)
  std::vector<int> needed_;          // nodes that carry points, parents first
  std::vector<Attached> landmarks_;  // in the order of for_each_landmark
  std::vector<Attached> corners_;    // of the soles, left and right
  Vec3d up_{};                       // in the file's axes
};

}  // namespace shigusa
