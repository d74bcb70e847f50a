// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/index.hpp"
#include "core/say.hpp"
#include "formats/gltf.hpp"
#include "formats/gltf_nodes.hpp"
#include "gltf_json.hpp"
#include "gltf_pose.hpp"
#include "gltf_vrm.hpp"
#include "human/landmark_points.hpp"
#include "node_names.hpp"
#include "rig/find_humanoid.hpp"

namespace shigusa {
namespace {

// A node of the file.
struct FileNode {
  std::string name;
  int parent = -1;
  std::vector<int> children;
  Transformd place;     // in its parent; with the scale in its matrix
  GltfPlace parts;      // the same in parts
  bool uneven = false;  // scaled differently along its axes
  GltfExtras extras;
  bool mesh = false;  // shows a mesh, even if its index is invalid
  int mesh_index = -1;
  int skin_index = -1;
  bool joint = false;     // of a skin or of VRM
  bool needed = false;    // part of the skeleton
  bool added = false;     // by add_nodes
  bool left_out = false;  // damaged, or a descendant of a damaged node
};

// Replaces a damaged node, or a skin, by -1.
struct Fault {
  int node = -1;
  Error error;
};

// Index in another list of the file, or -1 if absent or invalid.
int index_or_none(const GltfJson& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_unsigned()) return -1;
  const auto index = found->get<std::uint64_t>();
  return index <= std::numeric_limits<int>::max() ? static_cast<int>(index) : -1;
}

GltfExtras read_extras(const GltfJson& json) {
  GltfExtras extras;
  const auto mass = json.find(kMassExtra);
  if (mass != json.end() && mass->is_number()) extras.mass = mass->get<double>();
  const auto upright = json.find(kUprightExtra);
  // some programs write 1 for true
  if (upright != json.end()) extras.upright = *upright == true || *upright == 1;
  return extras;
}

// Reader of one file. Each step returns false after it has recorded an error.
class GltfReader {
 public:
  GltfReader(const GltfJson& json, std::string_view name) : json_(json), name_(name) {}

  Result<GltfCharacter> read() {
    if (!version() || !nodes() || !parents() || !joints()) return tl::unexpected<Error>(error_);
    mark_needed();
    if (!leave_out_faulty() || !build()) return tl::unexpected<Error>(error_);
    if (!faults_.empty() && !is_person()) return tl::unexpected<Error>(faults_[0].error);
    if (!faults_.empty()) {
      result_.doubts.push_back(
          say("nodes_left_out", faults_.size(), faults_[0].error.to_message()));
    }
    if (!complete()) return tl::unexpected<Error>(error_);
    take_meshes();
    take_vrm();
    tell_uneven();
    return std::move(result_);
  }

 private:
  bool wrong(std::string place, Message message) {
    if (!place.empty()) place += " of ";
    error_ = {ErrorCode::parse, std::move(message), place + name_};
    return false;
  }

  FileNode& node(int i) { return nodes_[index(i)]; }
  [[nodiscard]] int count() const { return static_cast<int>(nodes_.size()); }
  // Name for messages, "node 3 'hips'".
  std::string described(int i) {
    return node(i).name.empty() ? fmt::format("node {}", i)
                                : fmt::format("node {} '{}'", i, node(i).name);
  }

  bool version() {
    const auto asset = json_.find("asset");
    if (asset == json_.end() || !asset->is_object() || !asset->contains("version")) {
      return wrong("", say("no_gltf"));
    }
    const GltfJson& version = (*asset)["version"];
    if (version.is_string() && version.get_ref<const std::string&>().starts_with("2.")) return true;
    return wrong("", say("gltf_version", json_shown(version)));
  }

  bool nodes() {
    const auto list = json_.find("nodes");
    if (list == json_.end() || !list->is_array() || list->empty()) {
      return wrong("", say("no_gltf_nodes"));
    }
    for (const GltfJson& json : *list) {
      nodes_.emplace_back();
      if (!read_node(json, count() - 1)) faults_.push_back({count() - 1, error_});
    }
    return true;
  }

  bool read_node(const GltfJson& json, int index) {
    if (!json.is_object()) return wrong(described(index), say("and_no_object", json_shown(json)));
    FileNode& read = nodes_.back();
    const auto name = json.find("name");
    constexpr std::size_t kMaxName = 256;
    if (name != json.end() && name->is_string()) {
      read.name = name->get<std::string>();
      if (read.name.size() > kMaxName) {
        const std::size_t length = read.name.size();
        read.name.clear();
        return wrong(described(index), say("name_bytes", length, kMaxName));
      }
    }
    read.mesh = json.contains("mesh");
    const auto extras = json.find("extras");
    if (extras != json.end() && extras->is_object()) {
      read.added = extras->contains(kAddedNode);
      read.extras = read_extras(*extras);
    }
    read.mesh_index = index_or_none(json, "mesh");
    read.skin_index = index_or_none(json, "skin");
    return indices(json, "children", described(index), read.children) && read_place(json, index);
  }

  // Reads a list of nodes; ranges are checked at the end.
  bool indices(const GltfJson& json, const char* key, const std::string& place,
               std::vector<int>& into) {
    const auto list = json.find(key);
    if (list == json.end()) return true;
    if (!list->is_array()) return wrong(place, say("and_no_list", key, json_shown(*list)));
    for (const GltfJson& index : *list) {
      const auto nodes = static_cast<std::uint64_t>(json_["nodes"].size());
      if (!index.is_number_unsigned() || index >= nodes) {
        return wrong(place, say("holds_node", key, json_shown(index), nodes - 1));
      }
      into.push_back(index.get<int>());
    }
    return true;
  }

  template <std::size_t N>
  bool numbers(const GltfJson& json, const char* key, int index, std::array<double, N>& into) {
    const auto list = json.find(key);
    if (list == json.end()) return true;
    bool valid = list->is_array() && list->size() == N;
    for (std::size_t k = 0; valid && k < N; ++k) {
      const GltfJson& value = (*list)[k];
      valid = value.is_number() && abs(value.get<double>()) <= kGltfMaxValue;
      if (valid) into[k] = value.get<double>();
    }
    return valid || wrong(described(index), say("must_be_numbers", key, json_shown(*list), N,
                                                -kGltfMaxValue, kGltfMaxValue));
  }

  bool read_place(const GltfJson& json, int index) {
    FileNode& read = node(index);
    if (json.contains("matrix")) {
      std::array<double, 16> m{};
      if (!numbers(json, "matrix", index, m)) return false;
      read.place = {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}},
                    {m[12], m[13], m[14]}};
      read.parts = parts_of(read.place);
    } else {
      std::array<double, 3> t{};
      std::array<double, 4> r{0.0, 0.0, 0.0, 1.0};
      std::array<double, 3> s{1.0, 1.0, 1.0};
      if (!numbers(json, "translation", index, t) || !numbers(json, "rotation", index, r) ||
          !numbers(json, "scale", index, s)) {
        return false;
      }
      const double length = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
      constexpr double kShortest = 1e-6;
      if (length < kShortest) {
        return wrong(described(index), say("rotation_length", length));
      }
      const Quatd rotation{r[0] / length, r[1] / length, r[2] / length, r[3] / length};
      read.parts = {{t[0], t[1], t[2]}, rotation, {s[0], s[1], s[2]}};
      read.place = read.parts.transform();
    }
    const Mat3d& m = read.place.rotation;
    const double longest = max(norm(m.cx), max(norm(m.cy), norm(m.cz)));
    const double least = min(norm(m.cx), min(norm(m.cy), norm(m.cz)));
    constexpr double kUneven = 1e-3;
    read.uneven = longest - least > kUneven * longest;
    return true;
  }

  // Checks that each node has at most one parent and all have roots, so that `children` is a
  // forest.
  bool parents() {
    for (int i = 0; i < count(); ++i) {
      for (const int child : node(i).children) {
        if (node(child).parent >= 0) {
          return wrong(described(child),
                       say("two_parents", described(node(child).parent), described(i)));
        }
        node(child).parent = i;
      }
    }
    // depth first, as in BVH; the order is kept when nodes are removed
    for (int root = 0; root < count(); ++root) {
      if (node(root).parent >= 0) continue;
      std::vector<int> open{root};
      while (!open.empty()) {
        const int i = open.back();
        open.pop_back();
        order_.push_back(i);
        open.insert(open.end(), node(i).children.rbegin(), node(i).children.rend());
      }
    }
    if (order_.size() == nodes_.size()) return true;
    std::vector<bool> reached(nodes_.size());
    for (const int i : order_) reached[index(i)] = true;
    const auto first =
        static_cast<int>(std::find(reached.begin(), reached.end(), false) - reached.begin());
    (void)wrong(described(first), say("own_descendant"));
    faults_.push_back({first, error_});
    return true;
  }

  bool joints() {
    const auto skins = json_.find("skins");
    if (skins != json_.end()) {
      if (!skins->is_array()) return wrong("", say("and_no_list", "skins", json_shown(*skins)));
      int number = 0;
      for (const GltfJson& skin : *skins) {
        std::vector<int> joints;
        if (!indices(skin, "joints", fmt::format("skin {}", number++), joints)) {
          faults_.push_back({-1, error_});
          joints.clear();
        }
        for (const int i : joints) node(i).joint = true;
        result_.skins.push_back({std::move(joints), index_or_none(skin, "inverseBindMatrices")});
      }
    }
    vrm_ = read_vrm_bones(json_, count());
    for (const auto& [name, i] : vrm_.all) node(i).joint = true;
    return true;
  }

  // Removes damaged nodes and their descendants from the skeleton; fails if they include joints.
  bool leave_out_faulty() {
    for (const Fault& fault : faults_) {
      if (fault.node < 0) continue;
      std::vector<int> open{fault.node};
      while (!open.empty()) {
        FileNode& each = node(open.back());
        open.pop_back();
        if (each.left_out) continue;
        each.left_out = true;
        if (each.joint) {
          error_ = fault.error;
          return false;
        }
        each.needed = false;
        open.insert(open.end(), each.children.begin(), each.children.end());
      }
    }
    return true;
  }

  void mark_needed() {
    bool any = false;
    for (int i = 0; i < count(); ++i) {
      if (!node(i).joint) continue;
      any = true;
      for (int k = i; k >= 0 && !node(k).needed; k = node(k).parent) node(k).needed = true;
    }
    for (FileNode& each : nodes_) {
      const bool tip =
          each.parent >= 0 && node(each.parent).joint && each.children.empty() && !each.mesh;
      each.needed = each.needed || !any || tip || (each.added && !each.mesh);
    }
  }

  // Chooses between joints and all nodes: rigid limbs may be children of the joints of a skin that
  // binds only the trunk. If only all nodes make a person, they are the skeleton.
  bool complete() {
    if (result_.skins.empty() || !vrm_.all.empty() || is_person()) return true;
    const std::size_t joints = result_.file_node.size();
    const std::vector<FileNode> before = nodes_;
    mark_all();
    if (!build()) return false;
    if (is_person()) {
      result_.doubts.push_back(say("rigid_limbs", joints, result_.file_node.size()));
      return true;
    }
    nodes_ = before;
    return build();
  }

  bool is_person() {
    const SkeletonMotion& rest = result_.rest;
    return find_humanoid(rest.skeleton, world_transforms(rest.skeleton, rest.clip, 0)).has_value();
  }

  // All nodes except those that only show meshes.
  void mark_all() {
    for (auto i = order_.rbegin(); i != order_.rend(); ++i) {
      FileNode& each = node(*i);
      each.needed = !each.mesh && !each.left_out;
      for (const int child : each.children) each.needed = each.needed || node(child).needed;
    }
  }

  bool build() {
    result_.file_node.clear();
    result_.places.clear();
    result_.extras.clear();
    result_.rest = {};
    std::vector<Transformd> world(nodes_.size());  // with scales, by the file's own index
    std::vector<int> place(nodes_.size(), -1);     // in the skeleton
    NodeNames names;
    for (const int i : order_) {
      if (!node(i).needed) continue;
      const auto own = static_cast<std::size_t>(i);
      const int parent = node(i).parent;
      const auto above = static_cast<std::size_t>(parent);
      world[own] = parent < 0 ? node(i).place : world[above] * node(i).place;
      const Vec3d& at = world[own].translation;
      for (int k = 0; k < 3; ++k) {
        if (abs(at[k]) <= kGltfMaxValue) continue;  // false for NaN
        return wrong(described(i), say("far_from_origin", at[k], kGltfMaxValue));
      }
      place[own] = static_cast<int>(result_.file_node.size());
      result_.file_node.push_back(i);
      result_.places.push_back(node(i).parts);
      result_.extras.push_back(node(i).extras);
      const std::string name = node(i).name.empty() ? fmt::format("node {}", i) : node(i).name;
      result_.rest.skeleton.nodes.push_back({names.take(name), parent < 0 ? -1 : place[above],
                                             parent < 0 ? at : at - world[above].translation});
      result_.rest.clip.local.push_back({result_.rest.skeleton.nodes.back().offset, {}});
    }
    result_.rest.clip.frames = 1;
    place_ = std::move(place);
    return true;
  }

  // Finds the nodes that show meshes; all indices are now those of the skeleton.
  void take_meshes() {
    for (GltfSkin& skin : result_.skins) {
      for (int& joint : skin.joints) joint = place_[index(joint)];
    }
    for (int i = 0; i < count(); ++i) {
      if (node(i).mesh_index < 0 || node(i).left_out) continue;
      const bool skinned =
          node(i).skin_index >= 0 && node(i).skin_index < static_cast<int>(result_.skins.size());
      GltfMeshNode& shown = result_.meshes.emplace_back();
      shown.mesh = node(i).mesh_index;
      shown.skin = skinned ? node(i).skin_index : -1;
      int on = i;
      for (; on >= 0 && !node(on).needed; on = node(on).parent) {
        shown.place = node(on).place * shown.place;
      }
      shown.node = on < 0 ? -1 : place_[index(on)];
    }
  }

  void take_vrm() {
    result_.vrm = vrm_.version;
    result_.doubts.insert(result_.doubts.end(), vrm_.doubts.begin(), vrm_.doubts.end());
    for (auto& [name, i] : vrm_.all) {
      result_.vrm_bones.emplace_back(std::move(name), place_[index(i)]);
    }
    for (const HumanoidBone bone : kHumanoidBones) {
      if (vrm_.map[bone] < 0) continue;
      result_.humanoid[bone] = place_[index(vrm_.map[bone])];
    }
  }

  void tell_uneven() {
    int uneven = 0;
    int first = -1;
    for (const int i : result_.file_node) {
      bool bones_below = false;
      for (const int child : node(i).children) bones_below = bones_below || node(child).needed;
      if (!node(i).uneven || !bones_below) continue;
      if (++uneven == 1) first = i;
    }
    if (uneven == 0) return;
    result_.doubts.push_back(
        say("uneven_scale", described(first), uneven == 1 ? "" : say("as_more", uneven - 1)));
  }

  const GltfJson& json_;
  const std::string name_;
  std::vector<FileNode> nodes_;
  std::vector<int> order_;  // of all nodes, parents first
  std::vector<int> place_;  // (nodes of the file) index in the skeleton, or -1
  VrmBones vrm_;
  GltfCharacter result_;
  std::vector<Fault> faults_;
  Error error_;
};

}  // namespace

Result<GltfCharacter> parse_gltf(std::string_view bytes, std::string_view name) {
  SHG_TRY_ASSIGN(const GltfJson json, read_gltf_json(bytes, name));
  return GltfReader(json, name).read();
}

}  // namespace shigusa
