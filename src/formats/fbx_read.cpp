// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/index.hpp"
#include "core/say.hpp"
#include "fbx_place.hpp"
#include "files/json_memory.hpp"
#include "formats/gltf_json.hpp"
#include "glb.hpp"
#include "math/axes.hpp"

namespace shigusa {
namespace {

struct Model {
  std::int64_t id = 0;
  std::string_view name;
  std::string_view kind;  // "LimbNode", "Mesh", …
  FbxProperties properties;
  int parent = -1;
  std::vector<int> children;
};

// Name of a model: "Model::Hips" in the text form, "Hips", bytes 0 and 1, and "Model" in the binary
// form.
std::string_view plain_name(std::string_view name) {
  if (const std::size_t end = name.find(std::string_view("\0\1", 2)); end != name.npos) {
    return name.substr(0, end);
  }
  constexpr std::string_view kModel = "Model::";
  return name.starts_with(kModel) ? name.substr(kModel.size()) : name;
}

class FbxReader {
 public:
  FbxReader(const FbxRecord& root, std::string_view name) : root_(root), name_(name) {}

  Result<std::string> read() {
    if (!list_models() || !connect() || !order_models()) return tl::unexpected(*error_);
    choose_nodes();
    if (joints_.empty()) {
      wrong(say("fbx_no_bone"));
      return tl::unexpected(*error_);
    }
    if (!find_places()) return tl::unexpected(*error_);
    GltfJson nodes = GltfJson::array();
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (node_[i] >= 0 && !write_node(i, nodes)) return tl::unexpected(*error_);
    }
    return glb(nodes);
  }

 private:
  static constexpr std::array kTurns{"Lcl Rotation", "PreRotation", "PostRotation"};

  bool wrong(Message message) {
    error_ = Error{ErrorCode::parse, std::move(message), name_};
    return false;
  }

  static std::string described(const Model& model) {
    std::string text;
    for (const char c : model.name.substr(0, 60)) text += c >= ' ' && c != 0x7F ? c : '?';
    return fmt::format("model '{}'", text);
  }

  bool list_models() {
    const FbxRecord* kind = nullptr;
    if (const FbxRecord* definitions = root_.find("Definitions")) {
      for (const FbxRecord& type : definitions->within) {
        const FbxRecord* whole = type.text(0) == "Model" ? type.find("PropertyTemplate") : nullptr;
        if (whole != nullptr) kind = whole->find("Properties70");
      }
    }
    for (const FbxRecord& section : root_.within) {
      if (section.name != "Objects") continue;
      for (const FbxRecord& model : section.within) {
        if (model.name != "Model") continue;
        if (static_cast<int>(models_.size()) == kFbxMaxNodes) {
          return wrong(say("fbx_models_most", kFbxMaxNodes));
        }
        const int place = static_cast<int>(models_.size());
        models_.push_back({model.integer(0),
                           plain_name(model.text(1)),
                           model.text(2),
                           FbxProperties(model.find("Properties70"), kind),
                           -1,
                           {}});
        if (!by_id_.emplace(model.integer(0), place).second) {
          return wrong(say("fbx_same_id", model.integer(0)));
        }
      }
    }
    return !models_.empty() || wrong(say("fbx_no_model"));
  }

  // Connects models; one with several parents gets the first.
  bool connect() {
    std::vector<bool> hung(models_.size(), false);
    for (const FbxRecord& section : root_.within) {
      if (section.name != "Connections") continue;
      for (const FbxRecord& c : section.within) {
        const auto child = by_id_.find(c.integer(1));
        const auto parent = by_id_.find(c.integer(2));
        if (child == by_id_.end() || (parent == by_id_.end() && c.integer(2) != 0)) continue;
        const auto i = index(child->second);
        if (hung[i]) continue;
        hung[i] = true;
        if (parent == by_id_.end()) continue;
        models_[i].parent = parent->second;
        models_[index(parent->second)].children.push_back(child->second);
      }
    }
    return true;
  }

  // Lists the models from the roots on, parents before children.
  bool order_models() {
    std::vector<bool> listed(models_.size(), false);
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (models_[i].parent < 0) order_.push_back(static_cast<int>(i));
    }
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const Model& model = models_[index(order_[at])];
      listed[index(order_[at])] = true;
      order_.insert(order_.end(), model.children.begin(), model.children.end());
    }
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (!listed[i]) return wrong(say("hangs_in_circle", described(models_[i])));
    }
    return true;
  }

  // Whether a model has numbers that are not finite or exceed the limits.
  static bool is_damaged(const Model& model) {
    const FbxPlace place = place_of(model.properties);
    bool good = is_within(place.at, kFbxMaxValue) && is_within(place.scale, kFbxMaxValue);
    for (const char* turns : kTurns) {
      good = good && is_within(model.properties.vector(turns), kFbxMaxValue);
    }
    return !good;
  }

  // (models) damaged models and their descendants, if they carry no limb.
  [[nodiscard]] std::vector<bool> damaged_scenery() const {
    std::vector<bool> carries(models_.size(), false);
    bool limbs = false;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (!is_limb(models_[i].kind)) continue;
      limbs = true;
      for (int at = static_cast<int>(i); at >= 0 && !carries[index(at)];
           at = models_[index(at)].parent) {
        carries[index(at)] = true;
      }
    }
    std::vector<bool> damaged(models_.size(), false);
    for (const int i : order_) {
      const int parent = models_[index(i)].parent;
      const bool below = parent >= 0 && damaged[index(parent)];
      damaged[index(i)] = limbs && !carries[index(i)] && (below || is_damaged(models_[index(i)]));
    }
    return damaged;
  }

  // Selects the nodes, in the models' order. Meshes, cameras and lights are excluded unless they
  // have bones below them.
  void choose_nodes() {
    node_.assign(models_.size(), -1);
    const std::vector<bool> damaged = damaged_scenery();
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (!is_bone(models_[i].kind) || damaged[i]) continue;
      for (int at = static_cast<int>(i); at >= 0 && node_[index(at)] < 0;
           at = models_[index(at)].parent) {
        node_[index(at)] = 0;
      }
    }
    int count = 0;
    bool limbs = false;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (node_[i] == 0) node_[i] = count++;
      limbs = limbs || is_limb(models_[i].kind);
    }
    for (std::size_t i = 0; i < models_.size(); ++i) {
      const bool joint = limbs ? is_limb(models_[i].kind) : is_bone(models_[i].kind);
      if (joint) joints_.push_back(node_[i]);
    }
  }

  static bool is_limb(std::string_view kind) {
    return kind == "LimbNode" || kind == "Limb" || kind == "Root";
  }
  static bool is_bone(std::string_view kind) {
    return kind != "Mesh" && kind != "Camera" && kind != "Light" && kind != "CameraSwitcher";
  }

  // Axes and unit of the file, applied to root nodes.
  bool to_metres(FbxPlace& place) {
    const FbxRecord* settings = root_.find("GlobalSettings");
    const FbxProperties p(settings == nullptr ? nullptr : settings->find("Properties70"), nullptr);
    const double unit = p.number("UnitScaleFactor", 1.0) * 0.01;
    if (!(unit > 0.0) || !(unit < kFbxMaxValue)) {
      return wrong(say("unit_scale", unit * 100.0));
    }
    Mat3d axes;
    Vec3d* columns[] = {&axes.cx, &axes.cy, &axes.cz};
    const std::array<std::pair<const char*, const char*>, 3> kNames{
        {{"CoordAxis", "CoordAxisSign"}, {"UpAxis", "UpAxisSign"}, {"FrontAxis", "FrontAxisSign"}}};
    std::array<bool, 3> taken{};
    for (int k = 0; k < 3; ++k) {
      const auto& [axis, sign] = kNames[index(k)];
      const double from = p.number(axis, k);
      const int file = from == 0.0 ? 0 : from == 1.0 ? 1 : from == 2.0 ? 2 : -1;
      if (file < 0 || std::exchange(taken[index(file)], true)) {
        return wrong(say("fbx_axes"));
      }
      Vec3d& column = *columns[file];
      column = {};
      column[k] = p.number(sign, 1.0) < 0.0 ? -1.0 : 1.0;
    }
    // nodes have proper rotations only: the figure of a left-handed file becomes its mirror image
    if (dot(cross(axes.cx, axes.cy), axes.cz) < 0.0) axes.cx = -axes.cx;
    const Quatd turned = to_quat(axes);
    place = {axes * place.at * unit, turned * place.turned, place.scale * unit};
    return true;
  }

  // Local transforms. Nodes of glTF scale all their descendants: if a model inherits its scale
  // otherwise, all transforms come from Autodesk's formula, without scales.
  bool find_places() {
    places_.resize(models_.size());
    std::vector<FbxWorldPlace> world(models_.size());
    bool as_gltf = true;
    for (const int i : order_) {
      const Model& model = models_[index(i)];
      if (node_[index(i)] < 0) continue;
      if (!check_turns(model)) return false;
      const FbxPlace& place = places_[index(i)] = place_of(model.properties);
      const FbxWorldPlace parent = parent_of(model, world);
      world[index(i)] = below(parent, place, inherit_of(model.properties));
      as_gltf = as_gltf && alike(world[index(i)].inherited,
                                 below(parent, place, FbxInherit::before_turn).inherited);
    }
    for (std::size_t i = 0; !as_gltf && i < models_.size(); ++i) {
      const FbxWorldPlace parent = parent_of(models_[i], world);
      places_[i].at = transpose_times(parent.turned, world[i].at - parent.at);
      places_[i].scale = {1, 1, 1};
    }
    return true;
  }

  static FbxWorldPlace parent_of(const Model& model, const std::vector<FbxWorldPlace>& world) {
    return model.parent < 0 ? FbxWorldPlace{} : world[index(model.parent)];
  }

  // Whether scales are equal up to the rounding of files.
  static bool alike(const Mat3d& a, const Mat3d& b) {
    constexpr double kRounding = 1e-6;
    const double most = kRounding * max(norm(b.cx), max(norm(b.cy), norm(b.cz)));
    return norm(a.cx - b.cx) <= most && norm(a.cy - b.cy) <= most && norm(a.cz - b.cz) <= most;
  }

  bool check_turns(const Model& model) {
    for (const char* turns : kTurns) {
      if (is_within(model.properties.vector(turns), kFbxMaxValue)) continue;
      return wrong(say("turned_more", described(model), kFbxMaxValue));
    }
    return true;
  }

  bool write_node(std::size_t i, GltfJson& nodes) {
    const Model& model = models_[i];
    FbxPlace place = places_[i];
    if (!is_within(place.at, kFbxMaxValue) || !is_within(place.scale, kFbxMaxValue)) {
      return wrong(say("stands_beyond", described(model), kFbxMaxValue));
    }
    if (model.parent < 0 && !to_metres(place)) return false;
    GltfJson node{{"name", std::string(model.name)}};
    node["translation"] = {place.at.x, place.at.y, place.at.z};
    node["rotation"] = {place.turned.x, place.turned.y, place.turned.z, place.turned.w};
    node["scale"] = {place.scale.x, place.scale.y, place.scale.z};
    for (const int child : model.children) {
      if (node_[index(child)] >= 0) node["children"].push_back(node_[index(child)]);
    }
    nodes.push_back(std::move(node));
    return true;
  }

  [[nodiscard]] std::string glb(const GltfJson& nodes) const {
    std::vector<int> roots;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (models_[i].parent < 0 && node_[i] >= 0) roots.push_back(node_[i]);
    }
    const GltfJson file{{"asset", {{"version", "2.0"}, {"generator", "shigusa"}}},
                        {"scene", 0},
                        {"scenes", {{{"nodes", roots}}}},
                        {"nodes", nodes},
                        {"skins", {{{"joints", joints_}}}}};
    // names may be in any encoding
    return glb_file(file.dump(-1, ' ', false, GltfJson::error_handler_t::replace));
  }

  const FbxRecord& root_;
  const std::string name_;
  std::vector<Model> models_;
  std::map<std::int64_t, int> by_id_;
  std::vector<int> order_;        // the models, parents first
  std::vector<FbxPlace> places_;  // (models) in their parents
  std::vector<int> node_;         // (models) in the GLB file, or -1
  std::vector<int> joints_;       // nodes
  std::optional<Error> error_;
};

}  // namespace

Result<std::string> glb_of_fbx(std::string_view bytes, std::string_view name) {
  SHG_TRY_ASSIGN(const FbxRecords records, read_fbx_records(bytes, name));
  return FbxReader(records.root, name).read();
}

}  // namespace shigusa
