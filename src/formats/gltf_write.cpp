// SPDX-License-Identifier: MIT
#include "formats/gltf_write.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "core/check.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "formats/base64.hpp"
#include "glb.hpp"
#include "gltf_accessor.hpp"
#include "gltf_animation_layout.hpp"
#include "gltf_json.hpp"
#include "gltf_keyed.hpp"
#include "json_splice.hpp"
#include "node_names.hpp"

namespace shigusa {
namespace {

using Value = JsonSplice::Value;

// Cardboard, #c8a878, linear.
constexpr const char* kThingMaterial =
    R"({"name":"thing","pbrMetallicRoughness":{"baseColorFactor":[0.5776,0.3916,0.1878,1],)"
    R"("metallicFactor":0,"roughnessFactor":0.8}})";

// Adds animations to one file.
class AnimationAdder {
 public:
  AnimationAdder(const GlbParts& parts, std::string_view name)
      : parts_(parts),
        name_(name),
        json_(parts.json),
        root_(json_.root()),
        buffers_(json_.elements(json_.member(root_, "buffers"))) {}

  [[nodiscard]] Result<void> check() const {
    SHG_TRY(are_lists({"accessors", "animations", "buffers", "bufferViews"}));
    for (const char* list : {"buffers", "images"}) {
      SHG_TRY(refers_to_no_file(list));
    }
    if (buffers_.empty() || !in_chunk()) return {};
    if (!parts_.binary) return wrong(say("no_binary_chunk"));
    return json_.member(buffers_[0], "byteLength") ? Result<void>{} : wrong(say("no_byte_length"));
  }

  Result<std::string> add(std::span<const GltfAnimation> animations, OwnAnimations own) {
    SHG_TRY(check());
    const bool chunk = in_chunk();
    std::string binary(chunk ? parts_.binary.value_or("") : "");
    binary.resize((binary.size() + 3) / 4 * 4);
    GltfAnimationLayout layout(json_.count(json_.member(root_, "accessors")),
                               json_.count(json_.member(root_, "bufferViews")),
                               chunk ? 0 : buffers_.size(), binary.size());
    const int things = static_cast<int>(json_.count(json_.member(root_, "nodes")));
    if (!animations.empty()) {
      SHG_TRY(add_things(animations.front().things, layout));
    }
    const bool kept = own == OwnAnimations::kept;
    const std::vector<GltfKeyed> held = kept ? keyed_properties(json_) : std::vector<GltfKeyed>{};
    for (const GltfAnimation& animation : animations) {
      layout.add(animation, held, things);
      free_matrices(animation);
    }
    json_.append("accessors", layout.accessors);
    json_.append("bufferViews", layout.views);
    if (kept) {
      json_.prepend("animations", layout.animations);
    } else {
      json_.assign("animations", layout.animations);
    }
    if (!chunk) {
      json_.append(
          "buffers",
          fmt::format(R"({{"byteLength":{},"uri":"data:application/octet-stream;base64,{}"}})",
                      layout.data.size(), to_base64(layout.data)));
      return assemble(parts_.binary);
    }
    binary += layout.data;
    tell_length(binary.size());
    return assemble(binary);
  }

 private:
  [[nodiscard]] Result<void> are_lists(std::initializer_list<const char*> members) const {
    for (const char* member : members) {
      const Value list = json_.member(root_, member);
      if (list && !json_.text_of(list).starts_with('[')) return wrong(say("not_a_list", member));
    }
    return {};
  }

  [[nodiscard]] Result<void> wrong(Message message) const {
    return fail(ErrorCode::parse, std::move(message), std::string(name_));
  }

  // The binary chunk is the first buffer's if that has no URI.
  [[nodiscard]] bool in_chunk() const {
    return buffers_.empty() || (parts_.glb && !json_.member(buffers_[0], "uri"));
  }

  [[nodiscard]] Result<void> refers_to_no_file(const char* list) const {
    std::size_t i = 0;
    if (json_.count(json_.member(root_, list)) > JsonSplice::kMostElements) {
      return wrong(say("list_most", JsonSplice::kMostElements, list));
    }
    for (const Value& each : json_.elements(json_.member(root_, list))) {
      const std::string_view uri = json_.text_of(json_.member(each, "uri"));
      if (!uri.empty() && !uri.starts_with("\"data:")) {
        return fail(ErrorCode::unsupported, say("lies_elsewhere", list, i, printable(uri)),
                    std::string(name_));
      }
      ++i;
    }
    return {};
  }

  static std::string printable(std::string_view text) {
    constexpr std::size_t kLongest = 80;
    std::string shown;
    for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c < 0x7F ? c : '?';
    return shown;
  }

  // Adds the things as root nodes, each with its mesh.
  Result<void> add_things(const std::vector<GltfThing>& things, GltfAnimationLayout& layout) {
    if (things.empty()) return {};
    SHG_TRY(are_lists({"materials", "meshes"}));
    nodes_ = json_.elements(json_.member(root_, "nodes"));
    NodeNames names;
    for (const Value& node : nodes_) {
      const auto name = parse_small_json(json_.text_of(json_.member(node, "name")), "a name");
      if (name && name->is_string()) (void)names.take(name->get_ref<const std::string&>());
    }
    std::size_t mesh = json_.count(json_.member(root_, "meshes"));
    std::size_t node = nodes_.size();
    const std::size_t material = json_.count(json_.member(root_, "materials"));
    std::string meshes;
    std::string nodes;
    std::string roots;
    for (const GltfThing& thing : things) {
      const char* comma = nodes.empty() ? "" : ",";
      const std::string name = json_quoted(names.take(thing.name));
      const Vec3d& t = thing.translations.front();
      const Quatd& r = thing.rotations.front();
      meshes += fmt::format(R"({}{{"name":{},"primitives":[{}]}})", comma, name,
                            layout.add_mesh(thing.mesh, material));
      nodes +=
          fmt::format(R"({}{{"name":{},"mesh":{},"translation":{},"rotation":{}}})", comma, name,
                      mesh++, json_numbers({t.x, t.y, t.z}), json_numbers({r.x, r.y, r.z, r.w}));
      roots += fmt::format("{}{}", comma, node++);
    }
    json_.append("meshes", meshes);
    json_.append("nodes", nodes);
    json_.append("materials", kThingMaterial);
    add_roots(roots);
    return {};
  }

  // Adds nodes to the scene that is shown; a file without one shows what its reader likes.
  void add_roots(const std::string& roots) {
    const auto scenes = json_.elements(json_.member(root_, "scenes"));
    const std::string_view shown = json_.text_of(json_.member(root_, "scene"));
    std::size_t scene = 0;
    std::from_chars(shown.data(), shown.data() + shown.size(), scene);
    if (scene >= scenes.size()) return;
    const Value list = json_.member(scenes[scene], "nodes");
    if (list) {
      json_.replace(list.end - 1, list.end - 1, (json_.count(list) == 0 ? "" : ",") + roots);
      return;
    }
    const std::size_t close = scenes[scene].end - 1;
    const bool empty = json_.text_of(scenes[scene]).find(':') == std::string_view::npos;
    json_.replace(close, close, fmt::format(R"({}"nodes":[{}])", empty ? "" : ",", roots));
  }

  // glTF animates only translation, rotation and scale.
  void free_matrices(const GltfAnimation& animation) {
    if (nodes_.empty()) nodes_ = json_.elements(json_.member(root_, "nodes"));
    freed_.resize(nodes_.size());
    for (const GltfTrack& track : animation.tracks) {
      const auto i = index(track.node);
      SHG_CHECK(track.node >= 0 && i < nodes_.size(), "a node of the file");
      const Value matrix = json_.member(nodes_[i], "matrix");
      if (!matrix || freed_[i]) continue;
      freed_[i] = true;
      const auto& [t, r, s] = track.rest;
      json_.replace(
          matrix.key_begin, matrix.end,
          fmt::format(R"("translation":{},"rotation":{},"scale":{})", json_numbers({t.x, t.y, t.z}),
                      json_numbers({r.x, r.y, r.z, r.w}), json_numbers({s.x, s.y, s.z})));
    }
  }

  void tell_length(std::size_t length) {
    if (buffers_.empty()) {
      json_.append("buffers", fmt::format(R"({{"byteLength":{}}})", length));
      return;
    }
    const Value stated = json_.member(buffers_[0], "byteLength");
    json_.replace(stated.begin, stated.end, fmt::format("{}", length));
  }

  [[nodiscard]] std::string assemble(std::optional<std::string_view> binary) const {
    std::string text = json_.finish();
    // a byte order mark has no place in a GLB
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
    return glb_file(std::move(text), binary, parts_.further);
  }

  const GlbParts& parts_;
  std::string_view name_;
  JsonSplice json_;
  Value root_;
  std::vector<Value> buffers_;
  std::vector<Value> nodes_;
  std::vector<bool> freed_;  // (nodes) its matrix was replaced
};

}  // namespace

Result<void> check_animations_fit(std::string_view bytes, std::string_view name) {
  SHG_TRY_ASSIGN(const GlbParts parts, glb_parts(bytes, name));
  return AnimationAdder(parts, name).check();
}

Result<std::string> add_animations(std::string_view bytes, std::string_view name,
                                   std::span<const GltfAnimation> animations, OwnAnimations own) {
  SHG_TRY(read_gltf_json(bytes, name));
  SHG_TRY_ASSIGN(const GlbParts parts, glb_parts(bytes, name));
  return AnimationAdder(parts, name).add(animations, own);
}

Result<std::string> format_vrm_animation(const VrmAnimation& motion) {
  std::string nodes;
  std::string map;
  for (std::size_t i = 0; i < motion.bones.size(); ++i) {
    const auto& [name, parent, offset] = motion.bones[i];
    std::string children;
    for (std::size_t k = i + 1; k < motion.bones.size(); ++k) {
      if (motion.bones[k].parent != static_cast<int>(i)) continue;
      children += fmt::format("{}{}", children.empty() ? "" : ",", k);
    }
    if (!children.empty()) children = fmt::format(R"(,"children":[{}])", children);
    const char* comma = i == 0 ? "" : ",";
    nodes += fmt::format(R"({}{{"name":{},"translation":{}{}}})", comma, json_quoted(name),
                         json_numbers({offset.x, offset.y, offset.z}), children);
    map += fmt::format(R"({}{}:{{"node":{}}})", comma, json_quoted(name), i);
  }
  const std::string text = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"shigusa"}},"extensionsUsed":["VRMC_vrm_animation"],)"
      R"("extensions":{{"VRMC_vrm_animation":{{"specVersion":"1.0","humanoid":{{"humanBones":{{{}}}}}}}}},)"
      R"("scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}]}})",
      map, nodes);
  return add_animations(text, "VRM animation", std::span(&motion.animation, 1));
}

}  // namespace shigusa
