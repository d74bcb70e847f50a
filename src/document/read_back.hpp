// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/files.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// How far off a format's digits may put each node.
struct ReadBackDigits {
  double turn = 0.0;      // rad, of its rotation
  double length = 0.0;    // m, of its place in its parent …
  double relative = 0.0;  // … and that as a share of the length
};

// Reads exported files back, as anybody else does, and compares the places of their nodes with
// those of the motion, in every frame: of the nodes that goals are for, and of the planted feet.
//
// A file may be off by its digits, which adds up from a node to all that it carries; beyond twice
// that the file is wrong, and the error says by how much. Borrows all.
class ReadBackCheck {
 public:
  // `clip`: the candidate's motion at the file's rate. Without a rig the character leaves on the
  // body's own skeleton. `in_place`: the file keeps its hips where they are along the floor.
  ReadBackCheck(const CharacterSpec& character, const Task& task, const Candidate& candidate,
                const Clip& clip, bool in_place = false);

  [[nodiscard]] Result<ReadBack> bvh(std::string_view bytes) const;
  // `animation`: its name in the file.
  [[nodiscard]] Result<ReadBack> glb(std::string_view bytes, const std::string& animation) const;
  // Played on the character.
  [[nodiscard]] Result<ReadBack> vrma(std::string_view bytes) const;

 private:
  // A point of the body that a node of the file is to be at.
  struct Mark {
    std::string name;  // of the effector or contact
    bool foot = false;
    bool turns = false;  // its rotation is compared too
    int node = -1;       // of the character's rig, or of the body's nodes
    int turned = -1;     // the one whose rotation is compared: of a finger the hand
    int link = 0;
    Vec3d point{};  // m, link frame
  };
  // (nodes of the file) their placements in shigusa's world.
  using Places = std::vector<Transformd>;
  struct FileMotion {
    const char* format = "";
    int frames = 0;
    double frame_time = 0.0;  // s
    std::vector<int> parents;
    std::vector<int> node_of;  // (nodes of the rig or the body) index in the file
    ReadBackDigits digits;
    std::function<Places(int)> places;  // of a frame
  };

  // Of a file whose nodes are these, in their order.
  [[nodiscard]] static FileMotion file_motion(const char* format, const SkeletonClip& clip,
                                              const Skeleton& nodes, const ReadBackDigits& digits);
  void add_mark(const std::string& name, const std::string& body_node, bool foot, bool turns);
  // How far a node may be off.
  struct Allowance {
    double length = 0.0;  // m
    double turn = 0.0;    // rad
  };

  // A point of a link from its place in the start posture.
  [[nodiscard]] Vec3d in_link(int link, const Vec3d& at_start) const;
  [[nodiscard]] Result<ReadBack> compare(const FileMotion& file,
                                         const std::vector<Mark>& marks) const;
  [[nodiscard]] static Allowance allowance(const FileMotion& file, const Places& places, int node);
  [[nodiscard]] static tl::unexpected<Error> wrong_by(const FileMotion& file, const Mark& mark,
                                                      int frame, const Message& how);
  [[nodiscard]] Places in_world(Places places, double unit) const;
  // The point whose travel along the floor the file leaves out: the hips, or a body's first node.
  [[nodiscard]] Mark hips() const;

  const CharacterSpec& character_;
  const BodyModel& body_;
  const Clip& clip_;
  std::vector<Vec3d> start_;  // (nodes of the rig) m, world
  std::vector<Mark> marks_;
  bool in_place_;
};

}  // namespace shigusa
