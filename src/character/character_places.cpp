// SPDX-License-Identifier: MIT
#include "character_places.hpp"

#include <utility>

#include "character/character_rig.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/rig.hpp"
#include "math/axes.hpp"

namespace shigusa {
namespace {

constexpr double kSame = 1e-6;          // m
constexpr double kPlaceRange = 100.0;   // m
constexpr std::size_t kPlacesMax = 64;  // more than the nodes of any body

}  // namespace

std::vector<Vec3d> start_places(const PosedBody& posed, const Rig& rig) {
  Clip clip;
  clip.dofs = posed.body.dof_count();
  clip.frames = 1;
  clip.angles = posed.home.angles;
  const RigMotion motion = rig_motion(posed, clip, rig);
  std::vector<Transformd> placed;
  std::vector<Vec3d> places;
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
    const RigNode& node = rig.nodes[i];
    // with scales, so it is not a rigid transform
    const Transformd local{scaled_columns(to_matrix(motion.local[i].rotation), node.scale),
                           motion.local[i].translation};
    placed.push_back(node.parent < 0 ? local : placed[index(node.parent)] * local);
    const Vec3d& at = placed.back().translation;
    places.push_back(rig.placement.mirrored() ? rig.placement.to_world(at)
                                              : at * rig.placement.unit);
  }
  return places;
}

void find_places(const PosedBody& posed, CharacterSpec& spec) {
  if (!spec.rig) return;
  const std::vector<Vec3d> places = start_places(posed, spec.rig->rig);
  const Kinematics<double> start = home_kinematics(posed);
  spec.places.clear();
  for (const BodyNode& node : posed.body.nodes()) {
    const int of_file = node.name.empty() ? -1 : rig_node(spec, node.name);
    if (of_file < 0) continue;
    const Vec3d& place = places[index(of_file)];
    if (norm(place - start.point(node.link, node.point)) <= kSame) continue;
    spec.places.emplace_back(node.name, place);
  }
}

PosedBody placed_body(const CharacterSpec& spec, PosedBody posed) {
  if (spec.places.empty()) return posed;
  const Kinematics<double> start = home_kinematics(posed);
  std::vector<NodePlace> places;
  for (const auto& [name, at] : spec.places) {
    for (const BodyNode& node : posed.body.nodes()) {
      if (node.name != name) continue;
      places.push_back({name, transpose_times(start.link_rotation(node.link),
                                              at - start.link_origin(node.link))});
    }
  }
  posed.body = with_places(posed.body, std::move(places));
  return posed;
}

void read_places(JsonReader& character, std::vector<std::pair<std::string, Vec3d>>& places) {
  JsonReader reader = character.object("places_m");
  const Json& points = character.value("places_m");
  if (!points.is_object() || points.size() > kPlacesMax) {
    return character.wrong("places_m", say("points_object", kPlacesMax));
  }
  for (const auto& item : points.items()) {
    auto& place = places.emplace_back(item.key(), Vec3d{});
    reader.vector(item.key().c_str(), place.second, kPlaceRange);
  }
  character.absorb(reader.finish());
}

}  // namespace shigusa
