// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <shigusa/formats.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "support/person_file.hpp"

namespace shigusa::testing_support {

inline std::string word_bytes(std::uint32_t word) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> 8 * i & 0xFF);
  return bytes;
}

// A GLB file of this padded JSON and a chunk of binary data.
inline std::string glb(std::string json, const std::string& binary = "mesh") {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string chunks = word_bytes(static_cast<std::uint32_t>(json.size())) + "JSON" + json +
                             word_bytes(static_cast<std::uint32_t>(binary.size())) +
                             std::string("BIN\0", 4) + binary;
  return "glTF" + word_bytes(2) + word_bytes(static_cast<std::uint32_t>(chunks.size() + 12)) +
         chunks;
}

// The node of a glTF file with that name.
inline int index_of(const nlohmann::json& gltf, const std::string& name) {
  for (std::size_t i = 0; i < gltf["nodes"].size(); ++i) {
    if (gltf["nodes"][i].value("name", "") == name) return static_cast<int>(i);
  }
  throw std::runtime_error("no node " + name);
}

// The first frame of person_bvh as glTF, in metres: the same nodes in the same order, with the same
// rotations.
inline nlohmann::json person_gltf() {
  const SkeletonMotion person = parse_bvh(person_bvh(), "person.bvh").value();
  nlohmann::json file{{"asset", {{"version", "2.0"}}}, {"nodes", nlohmann::json::array()}};
  nlohmann::json& nodes = file["nodes"];
  for (std::size_t i = 0; i < person.skeleton.nodes.size(); ++i) {
    const SkeletonNode& node = person.skeleton.nodes[i];
    const auto& [at, turn] = person.clip.frame(person.skeleton, 0)[i];
    nodes.push_back({{"translation", {0.01 * at.x, 0.01 * at.y, 0.01 * at.z}},
                     {"rotation", {turn.x, turn.y, turn.z, turn.w}}});
    if (!node.end_site) nodes.back()["name"] = node.name;
    if (node.parent >= 0) nodes[static_cast<std::size_t>(node.parent)]["children"].push_back(i);
  }
  return file;
}

// VRM's name of a bone: "leftHand" for "left_hand".
inline std::string camel_case(std::string_view snake) {
  std::string camel;
  for (std::size_t i = 0; i < snake.size(); ++i) {
    const bool capital = snake[i] == '_';
    if (capital) ++i;
    camel += capital ? static_cast<char>(snake[i] - 'a' + 'A') : snake[i];
  }
  return camel;
}

}  // namespace shigusa::testing_support
