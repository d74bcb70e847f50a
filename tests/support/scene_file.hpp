// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <vector>

#include "support/mesh_file.hpp"

// GLB files of scenes, and their meshes.
namespace shigusa::testing_support {

// Triangles of a mesh.
struct SolidMesh {
  std::vector<Vec3d> points{};
  std::vector<std::uint32_t> indices{};

  // A box by its lower and upper corner.
  SolidMesh& box(const Vec3d& low, const Vec3d& high) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (int k = 0; k < 8; ++k) {
      points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    }
    for (const std::uint32_t corner :
         {0U, 2U, 1U, 1U, 2U, 3U, 4U, 5U, 6U, 5U, 7U, 6U, 0U, 1U, 4U, 1U, 5U, 4U,
          2U, 6U, 3U, 3U, 6U, 7U, 0U, 4U, 2U, 2U, 4U, 6U, 1U, 3U, 5U, 3U, 7U, 5U}) {
      indices.push_back(first + corner);
    }
    return *this;
  }

  // A closed surface of revolution about the vertical through `middle`, by pairs of radius and
  // height above it.
  SolidMesh& turned(const Vec3d& middle, const std::vector<std::pair<double, double>>& outline) {
    constexpr std::uint32_t kSides = 32;
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const auto& [radius, height] : outline) {
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const SinCos<double> turn = sin_cos(kTwoPi * k / kSides);
        points.push_back(middle + Vec3d{radius * turn.cos, height, radius * turn.sin});
      }
    }
    for (std::uint32_t row = 0; row + 1 < outline.size(); ++row) {
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t a = first + row * kSides + k;
        const std::uint32_t b = first + row * kSides + (k + 1) % kSides;
        indices.insert(indices.end(), {a, b, a + kSides, b, b + kSides, a + kSides});
      }
    }
    return *this;
  }
};

// A cup of 8 cm and 10 cm without a lid, its bottom at the origin.
inline SolidMesh cup_mesh() {
  return SolidMesh().turned(
      {}, {{0.0, 0.0}, {0.04, 0.0}, {0.04, 0.1}, {0.036, 0.1}, {0.036, 0.006}, {0.0, 0.006}});
}

// A scene's file.
class SceneFile {
 public:
  // Adds a node with a mesh; returns its JSON.
  nlohmann::json& add(const std::string& name, const SolidMesh& mesh, const Vec3d& at = {},
                      double turn_deg = 0.0) {
    nlohmann::json& node = add_empty(name, at, turn_deg);
    std::vector<float> numbers;
    for (const Vec3d& point : mesh.points) {
      for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<float>(point[k]));
    }
    const std::size_t positions = file_.add(numbers, "VEC3", 5126);
    const std::size_t indices = file_.add(mesh.indices, "SCALAR", 5125);
    node["mesh"] = file_.json["meshes"].size();
    file_.json["meshes"].push_back(
        {{"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}});
    return node;
  }

  nlohmann::json& add_empty(const std::string& name, const Vec3d& at = {}, double turn_deg = 0.0) {
    const SinCos<double> half = sin_cos(0.5 * radians(turn_deg));
    file_.json["nodes"].push_back({{"name", name},
                                   {"translation", {at.x, at.y, at.z}},
                                   {"rotation", {0.0, half.sin, 0.0, half.cos}}});
    return file_.json["nodes"].back();
  }

  // Makes the last node a child of another one.
  void put_below(const std::string& parent) {
    auto& nodes = file_.json["nodes"];
    nodes[static_cast<std::size_t>(index_of(file_.json, parent))]["children"].push_back(
        nodes.size() - 1);
  }

  [[nodiscard]] nlohmann::json& json() { return file_.json; }
  [[nodiscard]] std::string bytes() { return file_.bytes(); }

 private:
  MeshFile file_{{{"asset", {{"version", "2.0"}}}, {"nodes", nlohmann::json::array()}}};
};

// A table of 1.4 m, 0.73 m and 0.7 m with four legs, as one mesh.
inline SolidMesh table_mesh() {
  SolidMesh mesh;
  mesh.box({-0.7, 0.68, -0.35}, {0.7, 0.73, 0.35});
  for (const double x : {-0.65, 0.65}) {
    for (const double z : {-0.3, 0.3}) {
      mesh.box({x - 0.03, 0.0, z - 0.03}, {x + 0.03, 0.68, z + 0.03});
    }
  }
  return mesh;
}

// A cup with a handle on a table, and a floor.
inline SceneFile cup_scene() {
  SceneFile scene;
  scene.add("floor", SolidMesh().box({-3, -0.1, -3}, {3, 0, 3}));
  scene.add("table", table_mesh(), {0, 0, 0.65});
  scene.add("cup", cup_mesh(), {-0.3, 0.73, 0.45})["extras"] = {{"mass_kg", 0.4},
                                                                {"upright", true}};
  return scene;
}

}  // namespace shigusa::testing_support
