// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <shigusa/math.hpp>
#include <string>
#include <variant>
#include <vector>

#include "rig/stick_figure.hpp"

namespace shigusa::testing_support {

// One record of an FBX file, in either form.
struct FbxRecord {
  std::string name;
  std::vector<std::variant<std::int32_t, std::int64_t, double, std::string>> values;
  std::vector<FbxRecord> children;
};

// A skeleton as an FBX file of version 7.4: the joints of a figure as limb nodes.
class FbxFile {
 public:
  explicit FbxFile(const StickFigure& figure) : figure_(figure) {
    for (std::size_t i = 0; i < figure_.points.size(); ++i) {
      if (figure_.points[i].name.empty()) figure_.points[i].name = fmt::format("tip{}", i);
    }
  }

  double unit = 0.01;                         // m, of the file's numbers
  std::array<int, 6> axes{1, 1, 2, 1, 0, 1};  // up, its sign, front, its sign, coord, its sign
  // degrees, rotation of each node: undone in its children
  Vec3d pre_rotation{};
  Vec3d rotation{};
  Vec3d post_rotation{};
  bool root_link = true;  // the node above all joints hangs on the file's root
  std::string kind = "LimbNode";
  bool meshes = false;      // with a node that is no joint
  double root_scale = 1.0;  // of a node above all joints
  // of each joint, which hands it on to no other (Maya's segment scale compensation)
  Vec3d joint_scale{1, 1, 1};
  std::vector<FbxRecord> more;  // of Objects
  std::vector<std::array<std::int64_t, 2>> more_links;

  // Both forms of the same records.
  [[nodiscard]] std::string text(std::uint32_t version = 7400) const {
    std::string out = "; FBX project file\n";
    for (const FbxRecord& record : records(version)) write_text(record, 0, out);
    return out;
  }
  [[nodiscard]] std::string bytes(std::uint32_t version = 7400) const {
    std::string out("Kaydara FBX Binary  \0\x1a\0", 23);
    put(out, version);
    const std::size_t size = version < 7500 ? 4 : 8;  // of a head's numbers
    for (const FbxRecord& record : records(version)) write_bytes(record, size, out);
    return out + std::string(3 * size + 1, '\0');
  }

  [[nodiscard]] std::vector<FbxRecord> records(std::uint32_t version = 7400) const {
    std::vector<FbxRecord> all{{"FBXHeaderExtension",
                                {},
                                {{"FBXHeaderVersion", {std::int32_t{1003}}, {}},
                                 {"FBXVersion", {static_cast<std::int32_t>(version)}, {}}}},
                               settings(),
                               {"Objects", {}, objects()},
                               {"Connections", {}, links()}};
    if (version < 7000) make_old(all);
    return all;
  }

 private:
  static constexpr std::int64_t kFirst = 1000;
  static constexpr std::int64_t kRoot = 900;

  // As version 6 has it: names in the place of ids, properties without a label, settings among the
  // objects.
  static void make_old(std::vector<FbxRecord>& all) {
    std::map<std::int64_t, std::string> names{{0, "Model::Scene"}};
    std::vector<FbxRecord>& objects = all[2].children;
    for (FbxRecord& model : objects) {
      names[std::get<std::int64_t>(model.values[0])] = std::get<std::string>(model.values[1]);
      model.values.erase(model.values.begin());
    }
    objects.push_back(all[1]);
    for (FbxRecord& object : objects) {
      for (FbxRecord& list : object.children) {
        if (list.name != "Properties70") continue;
        list.name = "Properties60";
        for (FbxRecord& property : list.children) {
          property.name = "Property";
          property.values.erase(property.values.begin() + 2);
        }
      }
    }
    for (FbxRecord& link : all[3].children) {
      link.name = "Connect";
      for (auto& value : link.values) {
        if (const auto* id = std::get_if<std::int64_t>(&value)) value = std::string(names.at(*id));
      }
    }
    all.erase(all.begin() + 1);
  }

  static FbxRecord integer(const char* name, std::int32_t value) {
    return {"P", {name, "int", "Integer", "", value}, {}};
  }
  [[nodiscard]] static FbxRecord vector(const char* name, const Vec3d& v) {
    // readers go by the type, not by the name
    const std::string type = std::string(name).starts_with("Lcl") ? name : "Vector3D";
    return {"P", {name, type, "Vector", "A", v.x, v.y, v.z}, {}};
  }

  [[nodiscard]] FbxRecord settings() const {
    return {"GlobalSettings",
            {},
            {{"Version", {std::int32_t{1000}}, {}},
             {"Properties70",
              {},
              {integer("UpAxis", axes[0]),
               integer("UpAxisSign", axes[1]),
               integer("FrontAxis", axes[2]),
               integer("FrontAxisSign", axes[3]),
               integer("CoordAxis", axes[4]),
               integer("CoordAxisSign", axes[5]),
               {"P", {"UnitScaleFactor", "double", "Number", "", unit * 100.0}, {}}}}}};
  }

  static Mat3d turn(const Vec3d& degrees_xyz) {
    Mat3d m;
    for (const auto& [axis, angle] :
         {std::pair(Axis::z, degrees_xyz.z), std::pair(Axis::y, degrees_xyz.y),
          std::pair(Axis::x, degrees_xyz.x)}) {
      m = rotated(m, axis, sin_cos(radians(angle)));
    }
    return m;
  }

  [[nodiscard]] std::vector<FbxRecord> objects() const {
    std::vector<FbxRecord> list;
    list.push_back({"Model",
                    {kRoot, std::string("Model::Armature"), std::string("Null")},
                    {{"Version", {std::int32_t{232}}, {}},
                     {"Properties70", {}, {vector("Lcl Scaling", Vec3d{1, 1, 1} * root_scale)}}}});
    const Mat3d own = turn(pre_rotation) * turn(rotation) * transpose(turn(post_rotation));
    for (std::size_t i = 0; i < figure_.points.size(); ++i) {
      const StickFigure::Point& point = figure_.points[i];
      const bool root = point.parent < 0;
      const Vec3d from = root ? Vec3d{} : figure_.points[static_cast<std::size_t>(point.parent)].at;
      // every joint has the same turn in the world: below the root the others turn no more
      const Vec3d offset = (point.at - from) * (1.0 / unit);
      const Vec3d turned = transpose_times(own, offset);
      const Vec3d& scale = joint_scale;
      const bool scaled = scale != Vec3d{1, 1, 1};
      const double above = scaled ? 1.0 : root_scale;
      std::vector<FbxRecord> properties{
          vector("Lcl Translation",
                 root ? offset * (1.0 / root_scale)
                      : Vec3d{turned.x / scale.x, turned.y / scale.y, turned.z / scale.z} *
                            (1.0 / above)),
          vector("Lcl Rotation", root ? rotation : Vec3d{})};
      if (scaled) {
        properties.push_back(vector("Lcl Scaling", scale));
        properties.push_back({"P", {"InheritType", "enum", "", "", std::int32_t{2}}, {}});
      }
      if (root) {
        properties.push_back({"P", {"RotationActive", "bool", "", "", std::int32_t{1}}, {}});
        properties.push_back(vector("PreRotation", pre_rotation));
        properties.push_back(vector("PostRotation", post_rotation));
      }
      list.push_back({"Model",
                      {kFirst + static_cast<std::int64_t>(i), "Model::" + point.name, kind},
                      {{"Version", {std::int32_t{232}}, {}}, {"Properties70", {}, properties}}});
    }
    if (meshes) {
      list.push_back({"Model",
                      {std::int64_t{800}, std::string("Model::Body_mesh"), std::string("Mesh")},
                      {{"Version", {std::int32_t{232}}, {}}}});
    }
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }

  [[nodiscard]] std::vector<FbxRecord> links() const {
    std::vector<FbxRecord> list;
    const auto link = [&](std::int64_t child, std::int64_t parent) {
      list.push_back({"C", {std::string("OO"), child, parent}, {}});
    };
    if (root_link) link(kRoot, 0);
    for (std::size_t i = 0; i < figure_.points.size(); ++i) {
      const int parent = figure_.points[i].parent;
      link(kFirst + static_cast<std::int64_t>(i), parent < 0 ? kRoot : kFirst + parent);
    }
    if (meshes) link(800, kRoot);
    for (const auto& [child, parent] : more_links) link(child, parent);
    return list;
  }

  static void write_text(const FbxRecord& record, int depth, std::string& out) {
    out += std::string(static_cast<std::size_t>(depth), '\t') + record.name + ": ";
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      if (i > 0) out += ',';
      if (const auto* whole = std::get_if<std::int32_t>(&record.values[i])) {
        out += fmt::format("{}", *whole);
      } else if (const auto* id = std::get_if<std::int64_t>(&record.values[i])) {
        out += fmt::format("{}", *id);
      } else if (const auto* number = std::get_if<double>(&record.values[i])) {
        out += fmt::format("{:.15f}", *number);
      } else {
        out += '"' + std::get<std::string>(record.values[i]) + '"';
      }
    }
    if (!record.children.empty()) {
      out += " {\n";
      for (const FbxRecord& child : record.children) write_text(child, depth + 1, out);
      out += std::string(static_cast<std::size_t>(depth), '\t') + "}";
    }
    out += '\n';
  }

  template <class T>
  static void put(std::string& out, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));  // both sides are little-endian
    out.append(raw, sizeof(T));
  }

  static void write_bytes(const FbxRecord& record, std::size_t size, std::string& out) {
    const std::size_t begin = out.size();
    out.append(3 * size, '\0');
    out += static_cast<char>(record.name.size());
    out += record.name;
    const std::size_t values = out.size();
    for (const auto& value : record.values) {
      if (const auto* whole = std::get_if<std::int32_t>(&value)) {
        out += 'I';
        put(out, *whole);
      } else if (const auto* id = std::get_if<std::int64_t>(&value)) {
        out += 'L';
        put(out, *id);
      } else if (const auto* number = std::get_if<double>(&value)) {
        out += 'D';
        put(out, *number);
      } else {
        std::string text = std::get<std::string>(value);
        // "Model::Hips" is stored the other way round
        if (const std::size_t at = text.find("::"); at != text.npos) {
          text = text.substr(at + 2) + std::string("\0\x01", 2) + text.substr(0, at);
        }
        out += 'S';
        put(out, static_cast<std::uint32_t>(text.size()));
        out += text;
      }
    }
    const std::uint64_t length = out.size() - values;
    for (const FbxRecord& child : record.children) write_bytes(child, size, out);
    if (!record.children.empty()) out.append(3 * size + 1, '\0');
    const std::uint64_t head[] = {out.size(), record.values.size(), length};
    for (std::size_t k = 0; k < 3; ++k) std::memcpy(&out[begin + k * size], &head[k], size);
  }

  StickFigure figure_;
};

}  // namespace shigusa::testing_support
