// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/files.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Rounding errors that a format's digits allow for each node.
struct ReadBackDigits {
  double turn = 0.0;      // rad, of the node's rotation
  double length = 0.0;    // m, of its position in its parent, absolute
  double relative = 0.0;  // the same relative to the length
};

// Reads exported files back and compares the positions of their nodes with those of the motion in
// every frame: the nodes that have goals, and the planted feet.
//
// A file may deviate by the rounding of its digits, which accumulates from a node to its
// descendants; beyond twice that the file is wrong, and the error states the deviation. Borrows all
// arguments.
class ReadBackCheck {
 public:
  // `clip`: the candidate's motion at the file's rate. A character without a rig is exported on the
  // body's own skeleton. `in_place`: whether the file holds the hips in place horizontally.
  ReadBackCheck(const CharacterSpec& character, const Task& task, const Candidate& candidate,
                const Clip& clip, bool in_place = false);

  [[nodiscard]] Result<ReadBack> bvh(std::string_view bytes) const;
  // Checks a GLB. `animation`: name of the animation in the file.
  [[nodiscard]] Result<ReadBack> glb(std::string_view bytes, const std::string& animation) const;
  // Checks a VRM animation, played on the character.
  [[nodiscard]] Result<ReadBack> vrma(std::string_view bytes) const;

 private:
  // A point of the body with the node of the file that should coincide with it.
  struct Mark {
    std::string name;  // name of the effector or contact
    bool foot = false;
    bool turns = false;  // whether its rotation is compared too
    int node = -1;       // index in the character's rig, or in the body's nodes
    int turned = -1;     // node whose rotation is compared; the hand for a finger
    int link = 0;
    Vec3d point{};  // m, link frame
  };
  // (nodes of the file) placements in shigusa's world.
  using Places = std::vector<Transformd>;
  struct FileMotion {
    const char* format = "";
    int frames = 0;
    double frame_time = 0.0;  // s
    std::vector<int> parents;
    std::vector<int> node_of;  // (nodes of the rig or the body) index in the file
    ReadBackDigits digits;
    std::function<Places(int)> places;  // placements in a frame
  };

  // The motion of a file that has these nodes in this order.
  [[nodiscard]] static FileMotion file_motion(const char* format, const SkeletonClip& clip,
                                              const Skeleton& nodes, const ReadBackDigits& digits);
  void add_mark(const std::string& name, const std::string& body_node, bool foot, bool turns);
  // Permitted deviation of a node.
  struct Allowance {
    double length = 0.0;  // m
    double turn = 0.0;    // rad
  };

  // A point in link coordinates, from its position in the start posture.
  [[nodiscard]] Vec3d in_link(int link, const Vec3d& at_start) const;
  [[nodiscard]] Result<ReadBack> compare(const FileMotion& file,
                                         const std::vector<Mark>& marks) const;
  [[nodiscard]] static Allowance allowance(const FileMotion& file, const Places& places, int node);
  [[nodiscard]] static tl::unexpected<Error> wrong_by(const FileMotion& file, const Mark& mark,
                                                      int frame, const Message& how);
  [[nodiscard]] Places in_world(Places places, double unit) const;
  // The point whose horizontal travel the file leaves out: the hips, or the body's first node.
  [[nodiscard]] Mark hips() const;

  const CharacterSpec& character_;
  const PosedBody& task_;
  const BodyModel& body_;
  const Clip& clip_;
  std::vector<Vec3d> start_;  // (nodes of the rig) m, world
  std::vector<Mark> marks_;
  bool in_place_;
};

}  // namespace shigusa
