// SPDX-License-Identifier: MIT
#include "gltf_nodes.hpp"

#include <fmt/format.h>

#include <vector>

#include "core/check.hpp"
#include "core/index.hpp"
#include "glb.hpp"
#include "json_splice.hpp"

namespace shigusa {

Result<std::string> add_nodes(std::string_view bytes, std::string_view name,
                              std::span<const GltfNewNode> added) {
  SHG_TRY_ASSIGN(const GlbParts parts, glb_parts(bytes, name));
  JsonSplice json(parts.json);
  const std::vector<JsonSplice::Value> nodes = json.elements(json.member(json.root(), "nodes"));
  std::vector<std::string> children(nodes.size());
  std::string items;
  std::size_t count = nodes.size();
  const auto add = [&](const std::string& called, const Vec3d& at, const std::string& more) {
    items += fmt::format(R"({}{{"name":{},"translation":{},"extras":{{"{}":true}}{}}})",
                         items.empty() ? "" : ",", json_quoted(called),
                         json_numbers({at.x, at.y, at.z}), kAddedNode, more);
    return count++;
  };
  for (const GltfNewNode& node : added) {
    SHG_CHECK(index(node.parent) < nodes.size(), "a node of the file");
    std::string& list = children[index(node.parent)];
    const std::string tip = fmt::format(R"(,"children":[{}])", count + 1);
    list += fmt::format("{}{}", list.empty() ? "" : ",",
                        add(node.name, node.translation, node.tip ? tip : ""));
    if (node.tip) add(node.name + " end", *node.tip, "");
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (children[i].empty()) continue;
    const JsonSplice::Value list = json.member(nodes[i], "children");
    const bool some = list && json.count(list) > 0;
    if (list) {
      json.replace(list.end - 1, list.end, (some ? "," : "") + children[i] + "]");
    } else {
      const bool empty = json.text_of(nodes[i]).find(':') == std::string_view::npos;
      json.replace(nodes[i].end - 1, nodes[i].end,
                   fmt::format(R"({}"children":[{}]}})", empty ? "" : ",", children[i]));
    }
  }
  json.append("nodes", items);
  if (!parts.glb) return json.finish();
  return glb_file(json.finish(), parts.binary, parts.further);
}

}  // namespace shigusa
