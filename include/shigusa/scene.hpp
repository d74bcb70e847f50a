// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <shigusa/action.hpp>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

inline constexpr std::size_t kSceneMeshesMax = 64;  ///< largest number of a scene's meshes
inline constexpr std::size_t kSceneBoxesMax = 64;   ///< largest number of a scene's boxes
inline constexpr std::size_t kMeshBoxesMax = 12;    ///< largest number of a mesh's boxes

/// Settings of the reading of a scene.
struct SceneSettings {
  std::vector<std::string> things{};    ///< names of nodes that are things
  std::vector<std::string> left_out{};  ///< names of nodes that are not read
  std::size_t boxes = kSceneBoxesMax;   ///< largest number of obstacles, at least one for each mesh
};

/// The obstacles and things of a scene.
struct Scene {
  std::vector<Obstacle> obstacles{};  ///< named after their nodes: "table", "table 2"
  std::vector<Thing> things{};        ///< in the order of SceneSettings::things
  std::vector<std::string> names{};   ///< of all nodes that can be things
  std::vector<Message> notes{};       ///< what was left out, and masses that are not known
};

/// Parses a GLB or glTF file as a scene, in metres, +Y up, with the body's start at its origin.
/// `name` stands for the file in errors.
///
/// - Each mesh is an obstacle of up to kMeshBoxesMax boxes along the axes of its node. The boxes
///   are found by cells of 1/48 of the mesh's longest side, or larger ones where that takes too
///   many boxes; what its surface encloses is solid, but for the place where the body stands.
///   Boxes end at the surface. Boxes that end within 1 cm of the floor are left out.
/// - A node of SceneSettings::things is a thing with the meshes of the nodes below it: a cylinder
///   or a sphere where it is as round as one, else a box. Letters of its name that a thing's name
///   may not have count as "_". Its mass (kg) is `mass_kg` of the node's extras, and `upright`
///   keeps it upright in the hand.
/// - A node below a thing with "handle" in its name is the thing's handle.
///
/// Fails on files that parse_gltf refuses, on joints, and on more than kSceneMeshesMax meshes.
[[nodiscard]] Result<Scene> parse_scene(std::string_view bytes, std::string_view name,
                                        const SceneSettings& settings = {});
/// Reads a scene from a file, at most as large as a character's.
[[nodiscard]] Result<Scene> read_scene(const std::filesystem::path& path,
                                       const SceneSettings& settings = {});

}  // namespace shigusa
