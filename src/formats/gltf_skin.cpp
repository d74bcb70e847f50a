// SPDX-License-Identifier: MIT
#include "formats/gltf_skin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "formats/gltf_json.hpp"
#include "formats/skin_faces.hpp"
#include "gltf_accessor.hpp"
#include "gltf_pose.hpp"

namespace shigusa {
namespace {

// Locations of the numbers of a mesh part. Missing sets of joints and weights are absent.
struct Part {
  GltfNumbers positions;
  std::vector<GltfNumbers> joints;
  std::vector<GltfNumbers> weights;
  std::optional<GltfNumbers> indices;
  bool triangles = true;  // three indices each

  // largest number of drawn vertices
  [[nodiscard]] std::size_t most() const {
    return indices ? std::min(indices->count(), positions.count()) : positions.count();
  }
};

// Nodes that show a mesh, and its readable parts.
struct Mesh {
  std::vector<const GltfMeshNode*> shown_by;
  std::vector<Part> parts;
};

class SkinReader {
 public:
  SkinReader(const GlbParts& parts, std::string_view name, const GltfCharacter& character,
             std::span<const GltfPlace> places)
      : character_(character),
        name_(name),
        json_(parts.json),
        accessors_(parts, name),
        world_(placed_nodes(character.rest.skeleton, places)),
        bound_(character.skins.size()) {}

  Skin read(SkinFaces faces) {
    for (Mesh& mesh : meshes()) {
      for (const Part& part : mesh.parts) {
        for (const GltfMeshNode* node : mesh.shown_by) {
          const std::size_t before = skin_.vertices.size();
          if (const auto added = add(part, *node); added) {
            keep_triangles(part, before);
          } else {
            skin_.vertices.resize(before);
            leave_out(added.error());
          }
        }
      }
    }
    if (faces == SkinFaces::points) {
      add_faces(skin_.vertices, triangles_);
    } else {
      skin_.triangles = std::move(triangles_);
    }
    tell_left_out();
    return std::move(skin_);
  }

 private:
  void leave_out(const Error& why) {
    if (left_out_++ == 0) first_reason_ = why.to_message();
  }

  void tell_left_out() {
    if (left_out_ == 0) return;
    const Message which = read_ == 0 ? say("mesh_not_read")
                          : left_out_ == 1
                              ? say("mesh_part_left_out", read_ + left_out_)
                              : say("mesh_parts_left_out", left_out_, read_ + left_out_);
    skin_.doubts.push_back(say("at_place", which, first_reason_));
  }

  [[nodiscard]] tl::unexpected<Error> wrong(const Message& why) const {
    return fail(ErrorCode::parse, why, "mesh of " + name_);
  }

  // Opens all parts, and determines the sampling of vertices from their number.
  std::vector<Mesh> meshes() {
    const auto list = json_.elements(json_.member(json_.root(), "meshes"));
    std::vector<Mesh> meshes(list.size());
    for (const GltfMeshNode& node : character_.meshes) {
      const auto index = static_cast<std::size_t>(node.mesh);
      if (index < meshes.size()) {
        meshes[index].shown_by.push_back(&node);
      } else {
        leave_out(wrong(say("none_of_list", node.mesh, list.size())).value());
      }
    }
    std::size_t vertices = 0;
    std::size_t shown = 0;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      if (meshes[m].shown_by.empty()) continue;
      open_parts(list[m], shown, meshes[m]);
      for (const Part& part : meshes[m].parts) {
        vertices += part.most() * meshes[m].shown_by.size();
      }
    }
    stride_ = 1 + vertices / kSkinMaxVertices;
    return meshes;
  }

  void open_parts(const JsonSplice::Value& text, std::size_t& shown, Mesh& mesh) {
    for (const auto& primitive : json_.elements(json_.member(text, "primitives"))) {
      shown += mesh.shown_by.size();
      if (shown > kSkinMaxParts) {
        leave_out(wrong(say("parts_most", kSkinMaxParts)).value());
        return;
      }
      Result<Part> part = open_part(primitive);
      if (part) {
        mesh.parts.push_back(std::move(*part));
      } else {
        leave_out(part.error());
      }
    }
  }

  Result<Part> open_part(const JsonSplice::Value& text) {
    // further data of a primitive, such as morph targets, may be large
    GltfJson primitive = GltfJson::object();
    for (const char* key : {"attributes", "indices", "extensions"}) {
      const auto value = json_.member(text, key);
      if (!value) continue;
      SHG_TRY_ASSIGN(primitive[key], parse_small_json(json_.text_of(value), "mesh of " + name_));
    }
    if (!primitive["attributes"].is_object() || !primitive["attributes"].contains("POSITION")) {
      return wrong(say("no_position"));
    }
    static const std::array kWanted{GltfAttribute{"POSITION", 3, AccessorContent::coordinates},
                                    GltfAttribute{"JOINTS_0", 4, AccessorContent::indices},
                                    GltfAttribute{"WEIGHTS_0", 4, AccessorContent::reals},
                                    GltfAttribute{"JOINTS_1", 4, AccessorContent::indices},
                                    GltfAttribute{"WEIGHTS_1", 4, AccessorContent::reals}};
    SHG_TRY_ASSIGN(GltfPrimitive opened, accessors_.open(primitive, kWanted));
    if (!opened.attributes[0]) return wrong(say("no_position"));
    if (opened.attributes[0]->count() > kSkinMaxIndices) {
      return wrong(say("vertices_most", opened.attributes[0]->count(), kSkinMaxIndices));
    }
    Part part{std::move(*opened.attributes[0]), {}, {}, std::move(opened.indices)};
    for (const std::size_t set : {std::size_t{1}, std::size_t{3}}) {
      if (!opened.attributes[set] || !opened.attributes[set + 1]) break;
      SHG_TRY(add_set(std::move(*opened.attributes[set]), std::move(*opened.attributes[set + 1]),
                      part));
    }
    const std::string_view mode = json_.text_of(json_.member(text, "mode"));
    part.triangles = mode.empty() || mode == "4";
    return part;
  }

  // Joints of a part's vertices with their weights.
  Result<void> add_set(GltfNumbers&& joints, GltfNumbers&& weights, Part& part) {
    if (joints.count() != part.positions.count() || weights.count() != part.positions.count()) {
      return wrong(say("sets_of_joints", part.positions.count(), joints.count(), weights.count()));
    }
    part.joints.push_back(std::move(joints));
    part.weights.push_back(std::move(weights));
    return {};
  }

  // Skinning matrix of a joint: transform · inverse bind matrix.
  Result<const std::vector<Transformd>*> bound(int skin) {
    std::vector<Transformd>& moves = bound_[index(skin)];
    const GltfSkin& of = character_.skins[index(skin)];
    if (!moves.empty()) return &moves;
    std::optional<GltfNumbers> inverse;
    if (of.inverse_bind_poses >= 0) {
      SHG_TRY_ASSIGN(GltfNumbers poses,
                     accessors_.open(static_cast<unsigned>(of.inverse_bind_poses), 16,
                                     AccessorContent::reals));
      if (poses.count() < of.joints.size()) {
        return wrong(say("inverse_bind_poses", of.joints.size(), poses.count()));
      }
      inverse = std::move(poses);
    }
    for (std::size_t j = 0; j < of.joints.size(); ++j) {
      Transformd pose;
      if (inverse) {
        const auto column = [&](std::size_t c) {
          return Vec3d{inverse->at(j, c), inverse->at(j, c + 1), inverse->at(j, c + 2)};
        };
        pose = {{column(0), column(4), column(8)}, column(12)};
      }
      moves.push_back(world_[index(of.joints[j])] * pose);
    }
    return &moves;
  }

  Result<void> add(const Part& part, const GltfMeshNode& node) {
    ++read_;  // unless it turns out that it cannot be
    const bool skinned = node.skin >= 0 && !part.joints.empty();
    const std::vector<Transformd>* moves = nullptr;
    if (skinned) {
      const Result<const std::vector<Transformd>*> found = bound(node.skin);
      if (!found) return not_read(found.error());
      moves = *found;
    }
    const Transformd place = node.node < 0 ? node.place : world_[index(node.node)] * node.place;
    const auto take = [&](std::size_t vertex) -> Result<void> {
      if (taken_++ % stride_ != 0) return {};
      const Vec3d at{part.positions.at(vertex, 0), part.positions.at(vertex, 1),
                     part.positions.at(vertex, 2)};
      SHG_TRY_ASSIGN(SkinVertex placed,
                     skinned ? bent(part, vertex, at, character_.skins[index(node.skin)], *moves)
                             : SkinVertex{place * at, node.node, true});
      if (!is_within(placed.position, kGltfMaxValue)) {
        return wrong(say("vertex_beyond", vertex, kGltfMaxValue));
      }
      skin_.vertices.push_back(placed);
      return {};
    };
    const auto done = each_drawn(part, take);
    return done ? done : not_read(done.error());
  }

  // Faces of a part whose vertices were added in the order of each_drawn, from `first` on.
  void keep_triangles(const Part& part, std::size_t first) {
    if (!part.triangles || stride_ > 1 || part.positions.count() > kSkinMaxVertices) return;
    const std::size_t steps = part.indices ? part.indices->count() : part.positions.count();
    if (triangles_.size() + steps / 3 > kSkinMaxFaces) return;
    constexpr auto kUnseen = static_cast<std::size_t>(-1);
    std::vector<std::size_t> place(part.positions.count(), kUnseen);
    std::size_t next = first;
    std::array<std::size_t, 3> corners{};
    for (std::size_t i = 0; i < steps; ++i) {
      const std::size_t vertex =
          part.indices ? static_cast<std::size_t>(part.indices->at(i, 0)) : i;
      if (place[vertex] == kUnseen) place[vertex] = next++;
      corners[i % 3] = place[vertex];
      if (i % 3 == 2) triangles_.push_back(corners);
    }
  }

  Result<void> not_read(const Error& why) {
    --read_;
    return tl::unexpected<Error>(why);
  }

  // Visits each drawn vertex once.
  template <class Take>
  Result<void> each_drawn(const Part& part, Take&& take) {
    const std::size_t count = part.positions.count();
    const std::size_t steps = part.indices ? part.indices->count() : count;
    constexpr std::size_t kMarks = 64;  // of vertices that were seen, cleared at once
    const std::size_t cost = steps + (part.indices ? count / kMarks : 0);
    if (cost > kSkinMaxIndices - indices_) {
      return wrong(say("indices_most", kSkinMaxIndices));
    }
    indices_ += cost;
    std::vector<bool> seen(part.indices ? count : 0);
    for (std::size_t i = 0; i < steps; ++i) {
      const std::size_t vertex =
          part.indices ? static_cast<std::size_t>(part.indices->at(i, 0)) : i;
      if (vertex >= count) {
        return wrong(say("index_vertices", i, vertex, count));
      }
      if (part.indices && seen[vertex]) continue;
      if (part.indices) seen[vertex] = true;
      SHG_TRY(take(vertex));
    }
    return {};
  }

  // A skinned vertex.
  Result<SkinVertex> bent(const Part& part, std::size_t vertex, const Vec3d& at,
                          const GltfSkin& skin, const std::vector<Transformd>& moves) const {
    std::array<std::size_t, 8> joint{};
    std::array<double, 8> weight{};
    double sum = 0.0;
    const std::size_t influences = 4 * part.joints.size();
    for (std::size_t k = 0; k < influences; ++k) {
      const double given = part.weights[k / 4].at(vertex, k % 4);
      weight[k] = given > 0.0 ? given : 0.0;  // NaN is none
      joint[k] = static_cast<std::size_t>(part.joints[k / 4].at(vertex, k % 4));
      // unused entries of files may hold any number
      if (weight[k] > 0.0 && joint[k] >= moves.size()) {
        return wrong(say("vertex_bound", vertex, joint[k], moves.size()));
      }
      sum += weight[k];
    }
    if (!(sum > 0.0)) {
      // viewers use the first joint
      if (joint[0] >= moves.size()) return wrong(say("vertex_no_joint", vertex));
      weight[0] = sum = 1.0;
    }
    Vec3d placed{};
    std::size_t strongest = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < influences; ++k) {
      if (!(weight[k] > 0.0)) continue;
      placed += moves[joint[k]] * at * (weight[k] / sum);
      double together = 0.0;  // a joint may come twice
      for (std::size_t l = 0; l < influences; ++l)
        together += joint[l] == joint[k] ? weight[l] : 0.0;
      if (together > most) strongest = joint[k];
      most = max(most, together);
    }
    return SkinVertex{placed, skin.joints[strongest], false};
  }

  const GltfCharacter& character_;
  std::string name_;
  JsonSplice json_;
  GltfAccessors accessors_;
  std::vector<Transformd> world_;               // (nodes of the skeleton)
  std::vector<std::vector<Transformd>> bound_;  // (skins × joints) computed on first use
  Skin skin_;
  std::vector<std::array<std::size_t, 3>> triangles_;  // indices of vertices kept
  std::size_t stride_ = 1;
  std::size_t taken_ = 0;    // vertices so far, kept or not
  std::size_t indices_ = 0;  // so far
  std::size_t read_ = 0;     // parts, as often as they are shown
  std::size_t left_out_ = 0;
  Message first_reason_;
};

}  // namespace

Skin read_gltf_skin(std::string_view bytes, std::string_view name, const GltfCharacter& character,
                    std::span<const GltfPlace> places, SkinFaces faces) {
  if (character.meshes.empty()) return {};
  const Result<GlbParts> parts = glb_parts(bytes, name);
  if (!parts)
    return {{}, {}, {say("at_place", say("mesh_was_not_read"), parts.error().to_message())}};
  return SkinReader(*parts, name, character, places).read(faces);
}

}  // namespace shigusa
