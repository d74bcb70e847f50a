// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

namespace shigusa {

// A bone that moves the mannequin's skin.
struct SkinBone {
  enum class Kind {
    node,    // of the body
    half,    // follows a joint's turn by half, without its twist
    swing,   // … by all of it but its twist
    roll,    // … with half its twist
    finger,  // a finger's bone
  };
  std::string name;
  Kind kind = Kind::node;
  std::string of;      // the joint that is followed; what a finger's bone hangs on
  Vec3d place{};       // m, where the mesh is made
  double angle = 0.0;  // rad, how far it is turned about the axis ahead from a hanging limb there
  Vec3d axis{};        // of a finger's bend, in the axes of a hanging arm
  std::array<double, 3> bends{};  // rad: open, relaxed, in a grip
};

// The page's mannequin as studio/figure/make.mjs made it: a skin about a man of average mass, and
// what makes others of him.
struct MannequinMesh {
  double stature = 0.0;                    // m
  std::map<std::string, double> measures;  // m, of bones
  std::map<std::string, double> volumes;   // m³, of the man and of what the shifts make of him
  std::vector<SkinBone> bones;
  std::vector<Vec3d> positions;                      // m
  std::map<std::string, std::vector<Vec3d>> shifts;  // m, of each position
  std::vector<std::array<std::uint8_t, 4>> joints;   // of each position: indices of bones
  std::vector<std::array<std::uint8_t, 4>> weights;  // theirs, of 255
  std::vector<std::uint16_t> corners;                // three of each triangle

  // The positions of a person's skin; `mass`: of that of an average person of the stature.
  [[nodiscard]] std::vector<Vec3d> skin(bool female, double mass) const;
};

// The one in the program, unpacked once.
[[nodiscard]] const MannequinMesh& mannequin_mesh();

// Unit vectors: of each position, by the triangles about it.
[[nodiscard]] std::vector<Vec3d> vertex_normals(const std::vector<Vec3d>& positions,
                                                const std::vector<std::uint16_t>& corners);

}  // namespace shigusa
