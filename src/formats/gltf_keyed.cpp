// SPDX-License-Identifier: MIT
#include "gltf_keyed.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/index.hpp"
#include "files/json_memory.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kMostTargets = 1024;

// Default of a property that the node lacks.
struct Usual {
  std::string_view path;
  std::vector<double> values;
};
const std::vector<Usual>& usual_values() {
  static const std::vector<Usual> usual{
      {"translation", {0, 0, 0}}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, 1, 1}}};
  return usual;
}

class KeyedFinder {
  using Json = nlohmann::json;
  using Value = JsonSplice::Value;

 public:
  explicit KeyedFinder(const JsonSplice& json)
      : json_(json),
        nodes_(json.elements(json.member(json.root(), "nodes"))),
        meshes_(json.elements(json.member(json.root(), "meshes"))) {}

  std::vector<GltfKeyed> find() {
    for (const Value& animation : json_.elements(json_.member(json_.root(), "animations"))) {
      for (const Value& channel : json_.elements(json_.member(animation, "channels"))) {
        add(json_.member(channel, "target"));
      }
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] Json parsed(const Value& value) const {
    return value ? Json::parse(json_.text_of(value), nullptr, false) : Json();
  }

  // Index within a list of that size, or empty.
  [[nodiscard]] std::optional<std::size_t> index_in(std::size_t count, const Value& value) const {
    const Json json = parsed(value);
    if (!json.is_number_unsigned() || json.get<std::size_t>() >= count) return std::nullopt;
    return json.get<std::size_t>();
  }

  // Numbers of a list of that size; empty for another size.
  [[nodiscard]] std::optional<std::vector<double>> numbers(const Value& value,
                                                           std::size_t count) const {
    const Json json = parsed(value);
    const auto is_number = [](const Json& each) { return each.is_number(); };
    if (!json.is_array() || json.size() != count) return std::nullopt;
    if (!std::all_of(json.begin(), json.end(), is_number)) return std::nullopt;
    return json.get<std::vector<double>>();
  }

  void add(const Value& target) {
    const auto node = index_in(nodes_.size(), json_.member(target, "node"));
    const Json path = parsed(json_.member(target, "path"));
    if (!node || !path.is_string() || json_.member(nodes_[*node], "matrix")) return;
    if (!seen_.emplace(*node, path.get<std::string>()).second) return;
    GltfKeyed keyed{static_cast<int>(*node), path.get<std::string>(), {}};
    keyed.values =
        keyed.path == "weights" ? weights(nodes_[*node]) : place(nodes_[*node], keyed.path);
    if (!keyed.values.empty()) found_.push_back(std::move(keyed));
  }

  [[nodiscard]] std::vector<double> place(const Value& node, std::string_view path) const {
    for (const Usual& usual : usual_values()) {
      if (usual.path != path) continue;
      return numbers(json_.member(node, path), usual.values.size()).value_or(usual.values);
    }
    return {};
  }

  // Morph weights of a node's mesh, or of the node itself.
  [[nodiscard]] std::vector<double> weights(const Value& node) const {
    const auto mesh = index_in(meshes_.size(), json_.member(node, "mesh"));
    if (!mesh) return {};
    const std::vector<Value> parts = json_.elements(json_.member(meshes_[*mesh], "primitives"));
    if (parts.empty()) return {};
    const std::size_t targets = json_.count(json_.member(parts[0], "targets"));
    if (targets == 0 || targets > kMostTargets) return {};
    for (const Value& holder : {node, meshes_[*mesh]}) {
      if (auto own = numbers(json_.member(holder, "weights"), targets)) return std::move(*own);
    }
    return std::vector<double>(targets, 0.0);
  }

  const JsonSplice& json_;
  std::vector<Value> nodes_;
  std::vector<Value> meshes_;
  std::set<std::pair<std::size_t, std::string>> seen_;
  std::vector<GltfKeyed> found_;
};

}  // namespace

std::vector<GltfKeyed> keyed_properties(const JsonSplice& json) { return KeyedFinder(json).find(); }

}  // namespace shigusa
