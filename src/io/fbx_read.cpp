// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <shigusa/quat.hpp>

#include "core/index.hpp"
#include "core/say.hpp"
#include "fbx_records.hpp"
#include "glb.hpp"
#include "io/gltf_json.hpp"
#include "math/axes.hpp"

namespace shigusa {
namespace {

// Properties by their names: of a record, of its kind's template, of none.
class Properties {
 public:
  Properties(const FbxRecord* own, const FbxRecord* kind) : lists_{own, kind} {}

  [[nodiscard]] const FbxRecord* find(std::string_view name) const {
    for (const FbxRecord* list : lists_) {
      if (list == nullptr) continue;
      for (const FbxRecord& each : list->within) {
        if (each.name == "P" && each.text(0) == name) return &each;
      }
    }
    return nullptr;
  }
  [[nodiscard]] Vec3d vector(std::string_view name, const Vec3d& otherwise = {}) const {
    const FbxRecord* p = find(name);
    return p == nullptr ? otherwise : Vec3d{p->number(4), p->number(5), p->number(6)};
  }
  [[nodiscard]] double number(std::string_view name, double otherwise) const {
    const FbxRecord* p = find(name);
    return p == nullptr ? otherwise : p->number(4);
  }

 private:
  std::array<const FbxRecord*, 2> lists_;
};

struct Model {
  std::int64_t id = 0;
  std::string_view name;
  std::string_view kind;  // "LimbNode", "Mesh", …
  Properties properties;
  int parent = -1;
  std::vector<int> children;
};

// Degrees about x, y and z, turned one after the other in that order, as FBX numbers the orders.
Quatd turn(const Vec3d& degrees, std::int64_t order) {
  constexpr std::array<std::array<Axis, 3>, 6> kOrders{{{Axis::x, Axis::y, Axis::z},
                                                        {Axis::x, Axis::z, Axis::y},
                                                        {Axis::y, Axis::z, Axis::x},
                                                        {Axis::y, Axis::x, Axis::z},
                                                        {Axis::z, Axis::x, Axis::y},
                                                        {Axis::z, Axis::y, Axis::x}}};
  Quatd q;
  for (const Axis axis : kOrders[static_cast<std::size_t>(order)]) {
    q = axis_rotation(axis, radians(degrees[static_cast<int>(axis)])) * q;
  }
  return q;
}

Quatd conjugate(const Quatd& q) { return {-q.x, -q.y, -q.z, q.w}; }
Vec3d product(const Vec3d& a, const Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

// A place in its parent: translation · rotation · scale.
struct Place {
  Vec3d at;
  Quatd turned;
  Vec3d scale;
};

// The product of Autodesk's SDK: T · Roff · Rp · Rpre · R · Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S · Sp⁻¹.
Place place_of(const Properties& p) {
  // else there are no other turns, and x goes before y and z
  const bool active = p.number("RotationActive", 0.0) != 0.0;
  const auto order = static_cast<std::int64_t>(p.number("RotationOrder", 0.0));
  Quatd turned = turn(p.vector("Lcl Rotation"), active && order > 0 && order < 6 ? order : 0);
  if (active) {
    turned =
        turn(p.vector("PreRotation"), 0) * turned * conjugate(turn(p.vector("PostRotation"), 0));
  }
  const Vec3d scale = p.vector("Lcl Scaling", {1, 1, 1});
  const Vec3d pivot = p.vector("RotationPivot");
  const Vec3d scaling = p.vector("ScalingPivot");
  const Vec3d inner = p.vector("ScalingOffset") + scaling - product(scale, scaling) - pivot;
  const Vec3d at =
      p.vector("Lcl Translation") + p.vector("RotationOffset") + pivot + to_matrix(turned) * inner;
  return {at, turned, scale};
}

// "Model::Hips" of the text form, "Hips", a zero, a one and "Model" of the binary form.
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
    if (!list_models() || !connect() || !check_tree()) return tl::unexpected(*error_);
    choose_nodes();
    if (joints_.empty()) {
      wrong(say("fbx_no_bone"));
      return tl::unexpected(*error_);
    }
    GltfJson nodes = GltfJson::array();
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (node_[i] >= 0 && !write_node(i, nodes)) return tl::unexpected(*error_);
    }
    return glb(nodes);
  }

 private:
  bool wrong(Message message) {
    error_ = Error{ErrorCode::parse, std::move(message), name_};
    return false;
  }

  [[nodiscard]] std::string described(std::size_t i) const {
    std::string text;
    for (const char c : models_[i].name.substr(0, 60)) text += c >= ' ' && c != 0x7F ? c : '?';
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
        if (static_cast<int>(models_.size()) == kFbxMaxNodes) {
          return wrong(say("fbx_models_most", kFbxMaxNodes));
        }
        const int place = static_cast<int>(models_.size());
        models_.push_back({model.integer(0),
                           plain_name(model.text(1)),
                           model.text(2),
                           Properties(model.find("Properties70"), kind),
                           -1,
                           {}});
        if (!by_id_.emplace(model.integer(0), place).second) {
          return wrong(say("fbx_same_id", model.integer(0)));
        }
      }
    }
    return !models_.empty() || wrong(say("fbx_no_model"));
  }

  // A model that hangs on several ones is taken where it is connected first.
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

  bool check_tree() {
    for (std::size_t i = 0; i < models_.size(); ++i) {
      std::size_t steps = 0;
      for (int at = models_[i].parent; at >= 0; at = models_[index(at)].parent) {
        if (++steps > models_.size()) return wrong(say("hangs_in_circle", described(i)));
      }
    }
    return true;
  }

  // Meshes, cameras and lights are no part of the skeleton, unless a bone hangs on them. Nodes
  // keep the models' order.
  void choose_nodes() {
    node_.assign(models_.size(), -1);
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (!is_bone(models_[i].kind)) continue;
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

  // The file's axes and unit, for nodes that hang on none.
  bool to_metres(Place& place) {
    const FbxRecord* settings = root_.find("GlobalSettings");
    const Properties p(settings == nullptr ? nullptr : settings->find("Properties70"), nullptr);
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
    // nodes have rotations alone: the figure of a left-handed file is its mirror image
    if (dot(cross(axes.cx, axes.cy), axes.cz) < 0.0) axes.cx = -axes.cx;
    const Quatd turned = to_quat(axes);
    place = {axes * place.at * unit, turned * place.turned, place.scale * unit};
    return true;
  }

  bool write_node(std::size_t i, GltfJson& nodes) {
    const Model& model = models_[i];
    for (const char* turns : {"Lcl Rotation", "PreRotation", "PostRotation"}) {
      if (is_within(model.properties.vector(turns), kFbxMaxValue)) continue;
      return wrong(say("turned_more", described(i), kFbxMaxValue));
    }
    Place place = place_of(model.properties);
    if (!is_within(place.at, kFbxMaxValue) || !is_within(place.scale, kFbxMaxValue)) {
      return wrong(say("stands_beyond", described(i), kFbxMaxValue));
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
  std::vector<int> node_;    // (models) in the GLB file, or -1
  std::vector<int> joints_;  // nodes
  std::optional<Error> error_;
};

}  // namespace

Result<std::string> glb_of_fbx(std::string_view bytes, std::string_view name) {
  SHG_TRY_ASSIGN(const FbxRecords records, read_fbx_records(bytes, name));
  return FbxReader(records.root, name).read();
}

}  // namespace shigusa
