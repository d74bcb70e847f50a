// SPDX-License-Identifier: MIT
#include "mannequin_mesh.hpp"

#include "core/bytes.hpp"
#include "core/index.hpp"
#include "files/json_memory.hpp"
#include "mannequin_data.hpp"
#include "mannequin_unpacker.hpp"

namespace shigusa {
namespace {

using Json = nlohmann::json;

Vec3d vector_of(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

std::vector<SkinBone> bones_of(const Json& list) {
  static const std::map<std::string, SkinBone::Kind> kKinds{{"node", SkinBone::Kind::node},
                                                            {"half", SkinBone::Kind::half},
                                                            {"swing", SkinBone::Kind::swing},
                                                            {"roll", SkinBone::Kind::roll},
                                                            {"finger", SkinBone::Kind::finger}};
  std::vector<SkinBone> bones;
  for (const Json& one : list) {
    SkinBone& bone = bones.emplace_back();
    bone.name = one.at("name");
    bone.kind = kKinds.at(one.at("kind"));
    bone.of = one.value("of", "");
    bone.place = vector_of(one.at("place"));
    bone.angle = one.at("angle");
    if (bone.kind != SkinBone::Kind::finger) continue;
    bone.axis = vector_of(one.at("axis"));
    bone.bends = one.at("bends");
  }
  return bones;
}

// The half of the mesh that the file holds, and its mirror image; they share the vertices in the
// plane of symmetry.
class Halves {
 public:
  explicit Halves(std::string_view data)
      : head_(Json::parse(data.substr(4, integer_at<std::uint32_t>(data, 0)))),
        vertices_(head_.at("vertices")),
        pack_(data.substr(4 + integer_at<std::uint32_t>(data, 0)), vertices_) {}

  MannequinMesh whole() {
    MannequinMesh mesh;
    mesh.stature = head_.at("stature");
    mesh.measures = head_.at("measures");
    mesh.volumes = head_.at("volumes");
    mesh.bones = bones_of(head_.at("bones"));
    const std::vector<int> corners = pack_.triangles(head_.at("triangles"));
    const std::vector<int> positions = pack_.numbers(3);
    mirror(positions);
    mesh.positions = vectors(positions, 3, 0, head_.at("step"));
    add_shifts(mesh);
    add_corners(corners, mesh);
    add_weights(mesh);
    return mesh;
  }

 private:
  void mirror(const std::vector<int>& positions) {
    for (int v = 0; v < vertices_; ++v) source_.push_back(v);
    for (int v = 0; v < vertices_; ++v) {
      const bool shared = positions[3 * index(v)] == 0;
      other_.push_back(shared ? v : static_cast<int>(source_.size()));
      if (!shared) source_.push_back(v);
    }
  }

  [[nodiscard]] bool mirrored(std::size_t v) const { return v >= index(vertices_); }

  // Vectors from the numbers at offset `first` in each vertex's group of `each`, scaled by `step`.
  [[nodiscard]] std::vector<Vec3d> vectors(const std::vector<int>& numbers, std::size_t each,
                                           std::size_t first, double step) const {
    std::vector<Vec3d> out;
    for (std::size_t v = 0; v < source_.size(); ++v) {
      const int* at = numbers.data() + each * index(source_[v]) + first;
      out.push_back(Vec3d{mirrored(v) ? -1.0 * at[0] : 1.0 * at[0], 1.0 * at[1], 1.0 * at[2]} *
                    step);
    }
    return out;
  }

  void add_shifts(MannequinMesh& mesh) {
    const std::vector<std::string> morphs = head_.at("morphs");
    const std::vector<int> numbers = pack_.numbers(3 * static_cast<int>(morphs.size()));
    for (std::size_t m = 0; m < morphs.size(); ++m) {
      mesh.shifts[morphs[m]] = vectors(numbers, 3 * morphs.size(), 3 * m, head_.at("shiftStep"));
    }
  }

  void add_corners(const std::vector<int>& corners, MannequinMesh& mesh) const {
    const auto add = [&](int v) { mesh.corners.push_back(static_cast<std::uint16_t>(v)); };
    for (const int v : corners) add(v);
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      for (const std::size_t k : {0u, 2u, 1u}) add(other_[index(corners[t + k])]);
    }
  }

  void add_weights(MannequinMesh& mesh) {
    const int scale = 255 / head_.at("weightSum").get<int>();
    const std::vector<int> other_side = head_.at("otherSide");
    const std::vector<int> weights = pack_.numbers(4);
    (void)pack_.numbers(3);  // the colours of joints and visor
    const std::string_view bones = pack_.raw(4 * index(vertices_));
    for (std::size_t v = 0; v < source_.size(); ++v) {
      const std::size_t from = index(source_[v]);
      auto& joints = mesh.joints.emplace_back();
      auto& shares = mesh.weights.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        const auto bone = static_cast<unsigned char>(bones[index(vertices_) * k + from]);
        joints[k] = static_cast<std::uint8_t>(mirrored(v) ? other_side[bone] : bone);
        shares[k] = static_cast<std::uint8_t>(scale * weights[4 * from + k]);
      }
    }
  }

  Json head_;
  int vertices_;
  MannequinUnpacker pack_;
  std::vector<int> source_;  // per vertex, the one in the file
  std::vector<int> other_;   // per vertex in the file, its mirror image
};

}  // namespace

const MannequinMesh& mannequin_mesh() {
  static const MannequinMesh mesh = Halves(mannequin_data()).whole();
  return mesh;
}

std::vector<Vec3d> MannequinMesh::skin(bool female, double mass) const {
  // larger shifts show creases
  constexpr double kHeaviest = 1.5;
  constexpr double kLightest = 1.2;
  const auto share = [&](const char* name, double most) {
    return min((mass - 1.0) / (volumes.at(name) / volumes.at("male") - 1.0), most);
  };
  const std::map<std::string, double> amounts{
      {"female", female ? 1.0 : 0.0},
      {"heavy", mass > 1.0 ? share("heavy", kHeaviest) : 0.0},
      {"light", mass < 1.0 ? share("light", kLightest) : 0.0}};
  std::vector<Vec3d> moved = positions;
  for (const auto& [name, amount] : amounts) {
    const std::vector<Vec3d>& shift = shifts.at(name);
    for (std::size_t v = 0; v < moved.size(); ++v) moved[v] = moved[v] + shift[v] * amount;
  }
  return moved;
}

std::vector<Vec3d> vertex_normals(const std::vector<Vec3d>& positions,
                                  const std::vector<std::uint16_t>& corners) {
  std::vector<Vec3d> normals(positions.size());
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const Vec3d& a = positions[corners[t]];
    const Vec3d doubled = cross(positions[corners[t + 1]] - a, positions[corners[t + 2]] - a);
    for (std::size_t k = 0; k < 3; ++k) normals[corners[t + k]] = normals[corners[t + k]] + doubled;
  }
  for (Vec3d& normal : normals) normal = normalized(normal);
  return normals;
}

}  // namespace shigusa
