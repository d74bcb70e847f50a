// SPDX-License-Identifier: MIT
#include "nodes_glb.hpp"

#include <cstdint>
#include <cstring>
#include <optional>
#include <shigusa/math.hpp>
#include <utility>
#include <vector>

#include "core/index.hpp"
#include "core/say.hpp"
#include "formats/gltf.hpp"
#include "formats/gltf_json.hpp"
#include "formats/json_reader.hpp"
#include "glb.hpp"

namespace shigusa {
namespace {

// Largest absolute value of a number.
constexpr double kMost = 1e6;

struct Place {
  Vec3d translation{};
  Quatd rotation{};
  Vec3d scale{1, 1, 1};
};

void read(JsonReader& reader, Place& place) {
  reader.vector("translation", place.translation, kMost);
  reader.quaternion("rotation", place.rotation);
  reader.vector("scale", place.scale, kMost);
}

GltfJson list_of(const Vec3d& v) { return GltfJson::array({v.x, v.y, v.z}); }
GltfJson list_of(const Quatd& q) { return GltfJson::array({q.x, q.y, q.z, q.w}); }

struct Node {
  std::string name{};
  int parent = -1;
  Place rest{};
  std::optional<Place> pose{};
  std::vector<std::size_t> children{};
};

// An animation of one key, at time 0.
class PoseWriter {
 public:
  PoseWriter() { add(GltfJson::array({0.0}), "SCALAR"); }

  void add(std::size_t node, const Place& pose) {
    add(node, "translation", list_of(pose.translation), "VEC3");
    add(node, "rotation", list_of(pose.rotation), "VEC4");
    add(node, "scale", list_of(pose.scale), "VEC3");
  }

  // The file's parts, and its binary chunk.
  std::string finish(GltfJson& file) {
    file["animations"] = GltfJson::array(
        {{{"name", std::string(kPosedNodes)}, {"channels", channels_}, {"samplers", samplers_}}});
    file["accessors"] = accessors_;
    file["bufferViews"] = views_;
    file["buffers"] = GltfJson::array({{{"byteLength", bytes_.size()}}});
    return std::move(bytes_);
  }

 private:
  void add(std::size_t node, const char* path, const GltfJson& values, const char* type) {
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", 0}, {"output", accessors_.size()}});
    add(values, type);
  }

  void add(const GltfJson& values, const char* type) {
    GltfJson accessor{{"bufferView", views_.size()},
                      {"componentType", 5126},  // float
                      {"count", 1},
                      {"type", type}};
    if (accessors_.empty()) accessor["min"] = accessor["max"] = values;
    accessors_.push_back(std::move(accessor));
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", 4 * values.size()}});
    for (const GltfJson& value : values) {
      const auto x = static_cast<float>(value.get<double>());
      std::uint32_t word = 0;
      std::memcpy(&word, &x, sizeof x);
      append_word(bytes_, word);
    }
  }

  std::string bytes_;
  GltfJson channels_ = GltfJson::array();
  GltfJson samplers_ = GltfJson::array();
  GltfJson accessors_ = GltfJson::array();
  GltfJson views_ = GltfJson::array();
};

Result<std::vector<Node>> read_nodes(std::string_view json, const std::string& name) {
  SHG_TRY_ASSIGN(const Json text, parse_json(json, name));
  JsonReader reader(text, name + ": ");
  reader.require("nodes");
  std::vector<Node> nodes;
  if (reader.has("nodes")) {
    const Json& listed = reader.value("nodes");
    if (!listed.is_array() || listed.empty() || listed.size() > kJsonMaxObjects) {
      reader.wrong("nodes", say("nodes_list", kJsonMaxObjects));
    } else {
      nodes.resize(listed.size());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        JsonReader one(listed[i], reader.place_of("nodes") + "[" + std::to_string(i) + "]");
        Node& node = nodes[i];
        one.require("name");
        one.text("name", node.name);
        if (one.has("parent") && one.value("parent") != -1) {
          one.integer("parent", node.parent, 0, nodes.size() - 1);
        }
        read(one, node.rest);
        if (one.has("pose")) {
          JsonReader pose = one.object("pose");
          read(pose, node.pose.emplace(node.rest));
          one.absorb(pose.finish());
        }
        reader.absorb(one.finish());
      }
    }
  }
  if (const auto wrong = reader.finish()) return tl::unexpected(*wrong);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent >= 0) nodes[index(nodes[i].parent)].children.push_back(i);
  }
  return nodes;
}

// Number of nodes that hang on a root.
std::size_t hanging(const std::vector<Node>& nodes, std::vector<std::size_t> roots) {
  std::size_t count = 0;
  while (!roots.empty()) {
    const Node& node = nodes[roots.back()];
    roots.pop_back();
    ++count;
    roots.insert(roots.end(), node.children.begin(), node.children.end());
  }
  return count;
}

}  // namespace

Result<NodesFile> glb_of_nodes(std::string_view json, const std::string& name) {
  SHG_TRY_ASSIGN(const std::vector<Node> nodes, read_nodes(json, name));
  GltfJson written = GltfJson::array();
  std::vector<std::size_t> roots;
  std::vector<std::size_t> joints;
  PoseWriter pose;
  NodesFile file;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    GltfJson one{{"name", node.name},
                 {"translation", list_of(node.rest.translation)},
                 {"rotation", list_of(node.rest.rotation)},
                 {"scale", list_of(node.rest.scale)}};
    if (!node.children.empty()) one["children"] = node.children;
    written.push_back(std::move(one));
    joints.push_back(i);
    if (node.parent < 0) roots.push_back(i);
    if (node.pose) pose.add(i, *node.pose);
    file.posed = file.posed || node.pose;
  }
  if (hanging(nodes, roots) < nodes.size()) {
    return fail(ErrorCode::parse, say("nodes_in_ring"), name);
  }
  GltfJson gltf{{"asset", {{"version", "2.0"}, {"generator", "shigusa"}}},
                {"scene", 0},
                {"scenes", GltfJson::array({{{"nodes", roots}}})},
                {"nodes", std::move(written)},
                {"skins", GltfJson::array({{{"joints", joints}}})}};
  std::optional<std::string> binary;
  if (file.posed) binary = pose.finish(gltf);
  file.bytes = glb_file(gltf.dump(), binary);
  return file;
}

}  // namespace shigusa
