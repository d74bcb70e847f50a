// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/scene.hpp>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "files/file.hpp"
#include "formats/gltf_pose.hpp"
#include "formats/gltf_skin.hpp"
#include "scene/boxes.hpp"
#include "scene/thing_shape.hpp"

namespace shigusa {
namespace {

// Height (m) up to which what ends there is the floor.
constexpr double kFloorTop = 0.01;
// Numbers of boxes that a mesh may have, tried in this order until the scene has few enough.
constexpr std::size_t kShares[] = {kMeshBoxesMax, 8, 5, 3, 2, 1};
// Heights (m) above the origin of the place where the body stands.
constexpr double kBodyHeights[] = {0.1, 0.4, 0.7, 1.0, 1.3, 1.6};
// Largest number of points of a handle (see each_point).
constexpr double kHandlePointsMost = 1e6;

// The name of a thing for a node's name: letters, digits, - and _.
std::string thing_name(std::string_view node) {
  constexpr std::size_t kLongest = 64;
  std::string name(node.substr(0, kLongest));
  for (char& c : name) {
    const bool allowed = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (!allowed) c = '_';
  }
  return name;
}

bool is_handle(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name.find("handle") != name.npos;
}

// A node of the scene.
struct SceneNode {
  std::string name{};
  Mat3d rotation{};   // R_WN at rest, without scale
  Surface surface{};  // of its own meshes, in the world
  int thing = -1;     // index of the thing that it belongs to
  bool handle = false;
  bool left_out = false;
};

// A mesh that is an obstacle.
struct Solid {
  const SceneNode* node = nullptr;
  Surface own{};                // along the node's axes
  std::vector<Vec3d> hollow{};  // where the body stands, along the same
  std::vector<Obstacle> boxes{};
  std::size_t grid = 0;  // see MeshBoxes
  std::size_t most = 0;  // boxes that it may have
};

class SceneReader {
 public:
  SceneReader(std::string_view name, const SceneSettings& settings)
      : name_(name), settings_(settings) {}

  Result<Scene> read(std::string_view bytes) {
    SHG_TRY_ASSIGN(const GltfCharacter file, parse_gltf(bytes, name_));
    if (!file.skins.empty() || !file.vrm_bones.empty()) return wrong(say("scene_joints"));
    Skin skin = read_gltf_skin(bytes, name_, file, file.places, SkinFaces::triangles);
    if (skin.vertices.empty()) return wrong(say("scene_no_mesh"));
    scene_.notes = std::move(skin.doubts);
    take_nodes(file);
    take_surfaces(skin);
    const auto meshes = std::count_if(nodes_.begin(), nodes_.end(), [](const SceneNode& node) {
      return !node.left_out && !node.surface.points.empty();
    });
    if (static_cast<std::size_t>(meshes) > kSceneMeshesMax) {
      return wrong(say("scene_meshes_most", meshes, kSceneMeshesMax));
    }
    for (std::size_t t = 0; t < settings_.things.size(); ++t) add_thing(static_cast<int>(t), file);
    SHG_TRY(add_obstacles());
    return std::move(scene_);
  }

 private:
  [[nodiscard]] tl::unexpected<Error> wrong(Message why) const {
    return fail(ErrorCode::parse, std::move(why), name_);
  }

  void take_nodes(const GltfCharacter& file) {
    const Skeleton& skeleton = file.rest.skeleton;
    const std::vector<Transformd> world = placed_nodes(skeleton, file.places);
    for (std::size_t i = 0; i < skeleton.nodes.size(); ++i) {
      SceneNode& node = nodes_.emplace_back();
      node.name = skeleton.nodes[i].name;
      const Quatd turn = parts_of(world[i]).rotation;
      if (is_unit(turn)) node.rotation = to_matrix(turn);  // else its meshes are flat
      const std::string thing = thing_name(node.name);
      scene_.names.push_back(thing);
      const auto asked = std::find(settings_.things.begin(), settings_.things.end(), thing);
      const int parent = skeleton.nodes[i].parent;
      if (parent >= 0) {
        const SceneNode& above = nodes_[index(parent)];
        node.thing = above.thing;
        node.handle = above.handle || (above.thing >= 0 && is_handle(node.name));
        node.left_out = above.left_out;
      }
      const bool left_out = std::find(settings_.left_out.begin(), settings_.left_out.end(),
                                      thing) != settings_.left_out.end();
      node.left_out = node.left_out || left_out;
      if (asked == settings_.things.end()) continue;
      const int own = static_cast<int>(asked - settings_.things.begin());
      if (std::any_of(nodes_.begin(), nodes_.end() - 1,
                      [own](const SceneNode& other) { return other.thing == own; })) {
        continue;
      }
      node.thing = own;
      node.handle = false;
    }
  }

  void take_surfaces(const Skin& skin) {
    std::vector<std::size_t> place(skin.vertices.size());
    for (std::size_t v = 0; v < skin.vertices.size(); ++v) {
      if (skin.vertices[v].node < 0) continue;
      std::vector<Vec3d>& points = nodes_[index(skin.vertices[v].node)].surface.points;
      place[v] = points.size();
      points.push_back(skin.vertices[v].position);
    }
    for (const auto& corners : skin.triangles) {
      const int node = skin.vertices[corners[0]].node;
      if (node < 0) continue;
      nodes_[index(node)].surface.triangles.push_back(
          {place[corners[0]], place[corners[1]], place[corners[2]]});
    }
  }

  // The surface of a thing, or of its handle.
  [[nodiscard]] Surface surface_of(int thing, bool handle) const {
    Surface all;
    for (const SceneNode& node : nodes_) {
      if (node.thing != thing || node.handle != handle || node.left_out) continue;
      const std::size_t before = all.points.size();
      all.points.insert(all.points.end(), node.surface.points.begin(), node.surface.points.end());
      for (auto corners : node.surface.triangles) {
        for (std::size_t& corner : corners) corner += before;
        all.triangles.push_back(corners);
      }
    }
    return all;
  }

  void add_thing(int number, const GltfCharacter& file) {
    const auto node = std::find_if(nodes_.begin(), nodes_.end(), [number](const SceneNode& each) {
      return each.thing == number;
    });
    const Surface surface = surface_of(number, false);
    if (node == nodes_.end() || surface.points.empty()) return;
    Thing thing = thing_of_surface(surface, turn_of_thing(node->rotation));
    thing.name = settings_.things[index(number)];
    const GltfExtras& extras = file.extras[static_cast<std::size_t>(node - nodes_.begin())];
    thing.upright = extras.upright;
    if (!extras.mass) {
      scene_.notes.push_back(say("scene_no_mass", thing.name));
    } else if (*extras.mass >= 0.0 && *extras.mass <= kLoadMax) {
      thing.mass = *extras.mass;
    } else {
      scene_.notes.push_back(say("scene_mass", thing.name, *extras.mass, kLoadMax));
    }
    const Surface handle = surface_of(number, true);
    const double spacing = max(1e-6, handle.bounds().longest() / 40.0);
    if (!handle.points.empty() && count_points(handle, spacing) < kHandlePointsMost) {
      thing.handle = handle_of_surface(handle, thing);
    }
    scene_.things.push_back(std::move(thing));
  }

  Result<void> add_obstacles() {
    std::vector<Solid> solids;
    for (const SceneNode& node : nodes_) {
      if (node.left_out || node.thing >= 0 || node.surface.points.empty()) continue;
      Solid& solid = solids.emplace_back();
      solid.node = &node;
      solid.own = node.surface;
      for (Vec3d& point : solid.own.points) point = transpose_times(node.rotation, point);
      for (const double height : kBodyHeights) {
        solid.hollow.push_back(transpose_times(node.rotation, Vec3d{0, height, 0}));
      }
    }
    std::size_t boxes = 0;
    for (const std::size_t most : kShares) {
      boxes = 0;
      for (Solid& solid : solids) {
        if (solid.most == 0 || solid.boxes.size() > most) fill(solid, most);
        boxes += solid.boxes.size();
      }
      if (boxes <= settings_.boxes) break;
    }
    if (boxes > settings_.boxes) return wrong(say("scene_boxes_most", boxes, settings_.boxes));
    for (Solid& solid : solids) {
      tell_left_out(solid);
      std::move(solid.boxes.begin(), solid.boxes.end(), std::back_inserter(scene_.obstacles));
    }
    return {};
  }

  // Finds the boxes of a mesh.
  static void fill(Solid& solid, std::size_t most) {
    solid.most = most;
    solid.boxes.clear();
    const Mat3d& axes = solid.node->rotation;
    const MeshBoxes found = boxes_of(solid.own, most, solid.hollow, solid.grid);
    solid.grid = found.grid;
    for (const Bounds& box : found.boxes) {
      if (lies_at_floor(box, axes) || !is_near(box) || is_around(box, solid)) continue;
      const std::size_t number = solid.boxes.size() + 1;
      solid.boxes.push_back(
          {.name = number == 1 ? solid.node->name : fmt::format("{} {}", solid.node->name, number),
           .position = axes * box.middle(),
           .rotation = to_quat(axes),
           .size = box.size()});
    }
  }

  static bool lies_at_floor(const Bounds& box, const Mat3d& axes) {
    const Vec3d half = box.size() * 0.5;
    const double up = abs(axes.cx.y) * half.x + abs(axes.cy.y) * half.y + abs(axes.cz.y) * half.z;
    return (axes * box.middle()).y + up <= kFloorTop;
  }

  static bool is_near(const Bounds& box) {
    return norm(box.middle()) <= kGoalRange && box.longest() <= kGoalRange;
  }

  static bool is_around(const Bounds& box, const Solid& solid) {
    return std::any_of(solid.hollow.begin(), solid.hollow.end(), [&box](const Vec3d& point) {
      for (int k = 0; k < 3; ++k) {
        if (point[k] < box.low[k] || point[k] > box.high[k]) return false;
      }
      return true;
    });
  }

  void tell_left_out(const Solid& solid) {
    if (!solid.boxes.empty()) return;
    const Bounds all = solid.own.bounds();
    const std::string& name = solid.node->name;
    scene_.notes.push_back(lies_at_floor(all, solid.node->rotation) ? say("scene_floor", name)
                           : is_near(all)                           ? say("scene_around", name)
                                          : say("scene_far", name, Metres{kGoalRange}));
  }

  std::string name_;
  const SceneSettings& settings_;
  std::vector<SceneNode> nodes_;  // parents first
  Scene scene_;
};

}  // namespace

Result<Scene> parse_scene(std::string_view bytes, std::string_view name,
                          const SceneSettings& settings) {
  return SceneReader(name, settings).read(bytes);
}

Result<Scene> read_scene(const std::filesystem::path& path, const SceneSettings& settings) {
  SHG_TRY_ASSIGN(const std::string bytes, read_text_file(path, kGltfMaxBytes));
  return parse_scene(bytes, path.filename().string(), settings);
}

}  // namespace shigusa
