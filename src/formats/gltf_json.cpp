// SPDX-License-Identifier: MIT
#include "gltf_json.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "formats/gltf.hpp"
#include "formats/gltf_nodes.hpp"
#include "glb.hpp"
#include "watched_json.hpp"

namespace shigusa {
namespace {

constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxNodeValues = 500'000;

// Parser callback that keeps the skeleton's data, and ends the parse by throwing at the first value
// beyond the limits. A mesh embedded in the text may be a hundred times as long as all bones
// together.
class SkeletonFilter {
 public:
  // `depth`: number of open objects and lists around an event
  bool keep(int depth, GltfJson::parse_event_t event, const GltfJson& parsed) {
    using Event = GltfJson::parse_event_t;
    if (depth >= kMaxDepth) throw say("nested_levels", kMaxDepth);
    if (depth > dropped_) return false;
    const auto level = index(depth);
    if (event == Event::key) {
      path_[level] = parsed.get_ref<const std::string&>();
      const bool is_wanted = wanted(depth);
      dropped_ = is_wanted ? std::numeric_limits<int>::max() : depth;
      return is_wanted;
    }
    // only some members of extras are needed
    if (event == Event::array_start && path_[1] == "nodes" && path_[level] == "extras") {
      dropped_ = depth;
      return false;
    }
    if (event == Event::object_start || event == Event::array_start) {
      // nlohmann scans a whole list when one of its members ends
      if (++members_[level] > kGltfMaxNodes) {
        throw say("entries_most", kGltfMaxNodes, path_[1]);
      }
      members_[level + 1] = 0;
    }
    if (++values_ > kMaxNodeValues) throw say("node_values_most", kMaxNodeValues);
    return true;
  }

 private:
  [[nodiscard]] bool wanted(int depth) const {
    constexpr std::array<std::string_view, 4> kTop{"asset", "nodes", "skins", "extensions"};
    constexpr std::array<std::string_view, 9> kNode{
        "name", "children", "mesh", "skin", "translation", "rotation", "scale", "matrix", "extras"};
    constexpr std::array<std::string_view, 3> kExtras{kAddedNode, kMassExtra, kUprightExtra};
    constexpr std::array<std::string_view, 2> kSkin{"joints", "inverseBindMatrices"};
    constexpr std::array<std::string_view, 2> kVrm{"VRM", "VRMC_vrm"};
    constexpr int kNodeDepth = 3;  // of a node's members, in the list of the root's
    const std::string& key = path_[index(depth)];
    if (depth == 1) return contains(kTop, key);
    if (path_[1] == "asset") return depth > 2 || key == "version";
    if (path_[1] == "nodes") {
      return depth == kNodeDepth ? contains(kNode, key)
                                 : path_[kNodeDepth] == "extras" && contains(kExtras, key);
    }
    if (path_[1] == "skins") return contains(kSkin, key);
    if (depth == 2) return contains(kVrm, key);
    if (depth == 3) return key == "humanoid";
    return depth > 4 || key == "humanBones";
  }

  std::array<std::string, kMaxDepth> path_;        // the last key at each depth
  std::array<int, kMaxDepth + 1> members_{};       // objects and lists so far at each depth
  int dropped_ = std::numeric_limits<int>::max();  // depth of the key that is dropped
  std::size_t values_ = 0;
};

}  // namespace

std::string json_shown(const GltfJson& value, std::size_t longest) {
  const std::string text = value.dump(-1, ' ', true, GltfJson::error_handler_t::replace);
  return text.size() > longest ? text.substr(0, longest) + "…" : text;
}

Result<GltfJson> read_gltf_json(std::string_view bytes, std::string_view name) {
  const std::string place(name);
  if (bytes.empty()) return fail(ErrorCode::parse, say("empty_file"), place);
  SHG_TRY_ASSIGN(const std::string_view text, gltf_text(bytes, name));
  // a parser needs several times the memory of its longest text
  if (text.size() > kGltfMaxJsonBytes) {
    return fail(ErrorCode::parse, say("gltf_json_bytes", text.size(), kGltfMaxJsonBytes), place);
  }
  SkeletonFilter filter;
  const auto watch = [&filter](int depth, GltfJson::parse_event_t event, const GltfJson& parsed) {
    return filter.keep(depth, event, parsed);
  };
  Result<GltfJson> json = parse_watched<GltfJson>(text, watch, "glTF", place);
  if (!json || json->is_object()) return json;
  return fail(ErrorCode::parse, say("gltf_no_object"), place);
}

}  // namespace shigusa
