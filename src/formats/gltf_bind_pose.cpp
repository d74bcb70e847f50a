// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/index.hpp"
#include "formats/gltf_animation.hpp"
#include "formats/gltf_json.hpp"
#include "gltf_accessor.hpp"
#include "gltf_pose.hpp"
#include "math/linear_map.hpp"

namespace shigusa {
namespace {

// Difference of poses, as a share of the figure's size, below which they count as equal.
constexpr double kSame = 0.01;

std::optional<Transformd> inverse_affine(const Transformd& x) {
  const std::optional<Mat3d> back = inverse_of(x.rotation);
  if (!back) return std::nullopt;
  return Transformd{*back, (*back * x.translation) * -1.0};
}

bool is_tame(const Transformd& x) {
  for (const Vec3d& v : {x.rotation.cx, x.rotation.cy, x.rotation.cz, x.translation}) {
    if (!(abs(v.x) + abs(v.y) + abs(v.z) <= kGltfMaxValue)) return false;
  }
  return true;
}

class BindPose {
 public:
  BindPose(const GlbParts& parts, std::string_view name, const GltfCharacter& character)
      : json_(parts.json),
        accessors_(parts, name),
        character_(character),
        skeleton_(character.rest.skeleton),
        resting_(placed_nodes(skeleton_, character.places)),
        bound_(skeleton_.nodes.size()) {}

  std::optional<GltfPose> find() {
    for (const auto& skin : json_.elements(json_.member(json_.root(), "skins"))) {
      if (!read(skin)) return std::nullopt;
    }
    const std::vector<Transformd> world = bring_to_rest();
    double apart = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (!is_tame(world[i])) return std::nullopt;
      apart = max(apart, norm(world[i].translation - resting_[i].translation));
      size = max(size, norm(resting_[i].translation - resting_[0].translation));
    }
    if (!(apart > kSame * size)) return std::nullopt;
    GltfPose pose{turned_from_rest(skeleton_, resting_, world), {}};
    for (std::size_t i = 0; i < world.size(); ++i) {
      const int parent = skeleton_.nodes[i].parent;
      const auto above = parent < 0 ? std::optional<Transformd>{Transformd{}}
                                    : inverse_affine(world[index(parent)]);
      if (!above) return std::nullopt;
      pose.places.push_back(parts_of(*above * world[i]));
    }
    return pose;
  }

 private:
  // Joints of one skin, in the space of the bind pose.
  bool read(const JsonSplice::Value& skin) {
    const auto matrices = json_.member(skin, "inverseBindMatrices");
    const Result<GltfJson> joints =
        parse_small_json(json_.text_of(json_.member(skin, "joints")), "");
    if (!joints || !joints->is_array() || !matrices) return true;
    const Result<GltfJson> accessor = parse_small_json(json_.text_of(matrices), "");
    if (!accessor) return false;
    const Result<std::vector<double>> numbers = accessors_.numbers(*accessor, 16);
    if (!numbers || numbers->size() < 16 * joints->size()) return false;
    for (std::size_t k = 0; k < joints->size(); ++k) {
      if (!(*joints)[k].is_number_unsigned()) return false;
      const auto& of = character_.file_node;
      const auto node = std::find(of.begin(), of.end(), (*joints)[k].get<int>());
      if (node == of.end()) continue;
      const double* m = numbers->data() + 16 * k;
      const auto bound = inverse_affine(
          {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}, {m[12], m[13], m[14]}});
      if (!bound || !is_tame(*bound)) return false;
      bound_[static_cast<std::size_t>(node - of.begin())] = *bound;
    }
    return true;
  }

  // World transforms of all nodes in the bind pose. The meshes' space is placed at the origin, at a
  // node above the joints, or at one that shows a mesh: the candidate that best preserves bone
  // lengths, and then joint positions, of the rest pose.
  [[nodiscard]] std::vector<Transformd> bring_to_rest() const {
    std::vector<Transformd> candidates{Transformd{}};
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      if (!bound_[i]) candidates.push_back(resting_[i]);
      if (bound_[i]) break;
    }
    for (const GltfMeshNode& mesh : character_.meshes) {
      if (mesh.skin < 0) continue;
      candidates.push_back(mesh.node < 0 ? mesh.place : resting_[index(mesh.node)] * mesh.place);
    }
    std::vector<Transformd> best;
    double least = 0.0;
    bool best_in_scale = false;
    for (const Transformd& to : candidates) {
      std::vector<Transformd> world;
      double off = 0.0;
      double bones = 0.0;
      double resting_bones = 0.0;
      for (std::size_t i = 0; i < bound_.size(); ++i) {
        const int parent = skeleton_.nodes[i].parent;
        const Transformd local = character_.places[i].transform();
        world.push_back(bound_[i]    ? to * *bound_[i]
                        : parent < 0 ? resting_[i]
                                     : world[index(parent)] * local);
        const Vec3d apart = world.back().translation - resting_[i].translation;
        if (bound_[i]) off += dot(apart, apart);
        if (!bound_[i] || parent < 0) continue;
        bones += norm(world.back().translation - world[index(parent)].translation);
        resting_bones += norm(resting_[i].translation - resting_[index(parent)].translation);
      }
      // bone lengths are nearly preserved
      constexpr double kScale = 1.5;
      const bool in_scale = bones < kScale * resting_bones && resting_bones < kScale * bones;
      const bool better = in_scale != best_in_scale ? in_scale : off < least;
      if (!best.empty() && !better) continue;
      best = std::move(world);
      least = off;
      best_in_scale = in_scale;
    }
    return best;
  }

  JsonSplice json_;
  GltfAccessors accessors_;
  const GltfCharacter& character_;
  const Skeleton& skeleton_;
  std::vector<Transformd> resting_;               // (nodes)
  std::vector<std::optional<Transformd>> bound_;  // (nodes) of joints in a readable skin
};

}  // namespace

std::optional<GltfPose> gltf_bind_pose(std::string_view bytes, std::string_view name,
                                       const GltfCharacter& character) {
  const Result<GlbParts> parts = glb_parts(bytes, name);
  if (!parts) return std::nullopt;
  return BindPose(*parts, name, character).find();
}

}  // namespace shigusa
