// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <shigusa/math.hpp>
#include <string>
#include <string_view>
#include <vector>

// An independent reader of a GLB file: chunks, JSON, and positions of nodes in an animation's
// frames by the file's own numbers. It knows nothing of BodyModel.
namespace shigusa::testing_support {

class ExportedGlb {
 public:
  explicit ExportedGlb(std::string_view bytes) {
    const std::size_t json_length = word(bytes, 12);
    text_ = bytes.substr(20, json_length);
    json_ = nlohmann::ordered_json::parse(text_);
    if (bytes.size() > 28 + json_length) {
      binary_ = bytes.substr(28 + json_length, word(bytes, 20 + json_length));
    }
  }

  [[nodiscard]] const nlohmann::ordered_json& json() const { return json_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::string& binary() const { return binary_; }

  [[nodiscard]] int frames(const std::string& animation) const {
    const auto& samplers = find_animation(animation).at("samplers");
    return json_.at("accessors").at(samplers.at(0).at("input").get<std::size_t>()).at("count");
  }

  // World transform of a node (with scales), at rest or in a frame of an animation.
  [[nodiscard]] Transformd place(int node, const std::string& animation = {}, int frame = 0) const {
    Transformd x = local(node, animation, frame);
    for (int p = parent(node); p >= 0; p = parent(p)) x = local(p, animation, frame) * x;
    return x;
  }
  [[nodiscard]] Vec3d at(int node, const std::string& animation, int frame) const {
    return place(node, animation, frame).translation;
  }

  [[nodiscard]] int parent(int node) const {
    const auto& nodes = json_.at("nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].contains("children")) continue;
      for (const int child : nodes[i]["children"]) {
        if (child == node) return static_cast<int>(i);
      }
    }
    return -1;
  }

  // The numbers of an accessor's element.
  [[nodiscard]] std::vector<double> element(std::size_t accessor, int index) const {
    const auto& a = json_.at("accessors").at(accessor);
    const auto& view = json_.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    const std::string type = a.at("type");
    const std::size_t count = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t offset = view.value("byteOffset", std::size_t{0}) +
                                 a.value("byteOffset", std::size_t{0}) +
                                 4 * (static_cast<std::size_t>(index) * count + k);
      values.push_back(std::bit_cast<float>(word(binary_, offset)));
    }
    return values;
  }

 private:
  static std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
      value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
    }
    return value;
  }

  [[nodiscard]] const nlohmann::ordered_json& find_animation(const std::string& name) const {
    for (const auto& each : json_.at("animations")) {
      if (each.value("name", "") == name) return each;
    }
    throw std::runtime_error("no animation " + name);
  }

  [[nodiscard]] Transformd local(int node, const std::string& animation, int frame) const {
    const auto& json = json_.at("nodes").at(static_cast<std::size_t>(node));
    if (json.contains("matrix")) {
      const std::vector<double> m = json["matrix"];
      return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}};
    }
    std::vector<double> t = json.value("translation", std::vector<double>{0, 0, 0});
    std::vector<double> r = json.value("rotation", std::vector<double>{0, 0, 0, 1});
    std::vector<double> s = json.value("scale", std::vector<double>{1, 1, 1});
    if (!animation.empty()) {
      const auto& found = find_animation(animation);
      for (const auto& channel : found.at("channels")) {
        if (channel.at("target").at("node") != node) continue;
        const auto& sampler = found.at("samplers").at(channel.at("sampler").get<std::size_t>());
        const std::string path = channel.at("target").at("path");
        (path == "rotation" ? r
         : path == "scale"  ? s
                            : t) = element(sampler.at("output").get<std::size_t>(), frame);
      }
    }
    const Mat3d turn = to_matrix(Quatd{r[0], r[1], r[2], r[3]});
    return {{turn.cx * s[0], turn.cy * s[1], turn.cz * s[2]}, {t[0], t[1], t[2]}};
  }

  nlohmann::ordered_json json_;
  std::string text_;
  std::string binary_;
};

}  // namespace shigusa::testing_support
