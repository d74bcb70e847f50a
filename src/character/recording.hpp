// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <shigusa/motion.hpp>
#include <vector>

#include "character_file.hpp"
#include "measure/measure_person.hpp"

namespace shigusa {

// Frames that the up axis of a recording is told by, and starts that are looked at closely, at
// most.
inline constexpr int kFramesForUp = 64;
inline constexpr int kStartsTried = 24;

// A file's motion as a person's: joints go with their nodes, and soles and tips as they were
// measured with the last joint of their limb. Meant for a look at every frame.
class Recording {
 public:
  // Borrows all of it. `world`: (nodes) the pose in which the person was measured.
  Recording(const CharacterFile& file, const HumanoidMap& map, const MeasuredPerson& person,
            const std::vector<Transformd>& world);

  // The person in a frame, in shigusa's world, upright where the recording is: of glTF that rests
  // along y in y; else along the axis of the file that most frames stand along, and one along which
  // the person is on the file's own 0 before others.
  [[nodiscard]] Landmarks at(int frame) const;

  // The first frame in which the person stands on both feet, in no T or A, and for whom `holds` is
  // true; `still`: and does not move.
  [[nodiscard]] std::optional<int> first_stand(
      bool still, const std::function<bool(const Landmarks&)>& holds) const;

 private:
  struct Attached {
    int node = 0;
    Vec3d point{};  // in the node
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
  bool y_is_up_;                     // of the format
  std::vector<bool> unread_;         // (frames)
  std::vector<int> needed_;          // nodes that carry points, parents first
  std::vector<Attached> landmarks_;  // as for_each_landmark has them
  std::vector<Attached> corners_;    // of the soles, left and right
  Vec3d up_{};                       // in the file's axes
};

}  // namespace shigusa
