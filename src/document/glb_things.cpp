// SPDX-License-Identifier: MIT
#include "glb_things.hpp"

#include "problem/thing_parts.hpp"

namespace shigusa {
namespace {

constexpr int kThingSides = 24;  // sides of a round thing
constexpr int kThingRings = 12;  // rings of a sphere, from its lower pole to its upper one

void add_triangle(std::size_t a, std::size_t b, std::size_t c, GltfMesh& mesh) {
  for (const std::size_t corner : {a, b, c}) {
    mesh.corners.push_back(static_cast<std::uint16_t>(corner));
  }
}

GltfMesh box_mesh(const Vec3d& half) {
  GltfMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      Vec3d normal{};
      normal[axis] = side;
      const std::size_t first = mesh.positions.size();
      for (const double across : {-1.0, 1.0}) {
        for (const double along : {-1.0, 1.0}) {
          Vec3d at{};
          at[axis] = side * half[axis];
          at[u] = side * across * half[u];
          at[v] = along * half[v];
          mesh.positions.push_back(at);
          mesh.normals.push_back(normal);
        }
      }
      add_triangle(first, first + 2, first + 3, mesh);
      add_triangle(first, first + 3, first + 1, mesh);
    }
  }
  return mesh;
}

// A ring of a round thing about its upright axis.
struct Ring {
  double radius = 0.0;
  double height = 0.0;
  double out = 0.0;  // normal: outwards and upwards
  double up = 0.0;
};

// Mesh of rings, of which the `strips` give pairs to be joined, from below.
GltfMesh round_mesh(std::span<const Ring> rings, std::span<const std::size_t> strips) {
  GltfMesh mesh;
  for (const Ring& ring : rings) {
    for (int k = 0; k < kThingSides; ++k) {
      const auto [sine, cosine] = sin_cos(kTwoPi * k / kThingSides);
      mesh.positions.push_back({ring.radius * sine, ring.height, ring.radius * cosine});
      mesh.normals.push_back({ring.out * sine, ring.up, ring.out * cosine});
    }
  }
  for (const std::size_t below : strips) {
    for (std::size_t k = 0; k < kThingSides; ++k) {
      const std::size_t a = below * kThingSides + k;
      const std::size_t b = below * kThingSides + (k + 1) % kThingSides;
      // at a pole one of both has no area
      if (rings[below].radius > 0.0) add_triangle(a, b, b + kThingSides, mesh);
      if (rings[below + 1].radius > 0.0) add_triangle(a, b + kThingSides, a + kThingSides, mesh);
    }
  }
  return mesh;
}

GltfMesh cylinder_mesh(const Vec3d& half) {
  const double r = half.x;
  const double h = half.y;
  const Ring rings[] = {{0.0, -h, 0.0, -1.0}, {r, -h, 0.0, -1.0}, {r, -h, 1.0, 0.0},
                        {r, h, 1.0, 0.0},     {r, h, 0.0, 1.0},   {0.0, h, 0.0, 1.0}};
  constexpr std::size_t kStrips[] = {0, 2, 4};
  return round_mesh(rings, kStrips);
}

GltfMesh sphere_mesh(const Vec3d& half) {
  std::vector<Ring> rings;
  std::vector<std::size_t> strips;
  for (int k = 0; k <= kThingRings; ++k) {
    const auto [sine, cosine] = sin_cos(kPi * k / kThingRings);
    const double out = k == 0 || k == kThingRings ? 0.0 : sine;
    rings.push_back({half.x * out, -half.x * cosine, out, -cosine});
    if (k < kThingRings) strips.push_back(static_cast<std::size_t>(k));
  }
  return round_mesh(rings, strips);
}

GltfMesh mesh_of_parts(const Thing& thing, double unit) {
  GltfMesh all;
  for (const ThingPart& part : thing.parts) {
    GltfMesh own = box_mesh(part.size * (0.5 / unit));
    const auto before = static_cast<std::uint16_t>(all.positions.size());
    for (Vec3d& at : own.positions) at += part.position * (1.0 / unit);
    for (std::uint16_t& corner : own.corners) corner = static_cast<std::uint16_t>(corner + before);
    all.positions.insert(all.positions.end(), own.positions.begin(), own.positions.end());
    all.normals.insert(all.normals.end(), own.normals.begin(), own.normals.end());
    all.corners.insert(all.corners.end(), own.corners.begin(), own.corners.end());
  }
  return all;
}

}  // namespace

GltfMesh mesh_of(const Thing& thing, double unit) {
  if (!thing.parts.empty()) return mesh_of_parts(thing, unit);
  const Vec3d half = thing.size * (0.5 / unit);
  switch (thing.shape) {
    case ThingShape::box:
      return box_mesh(half);
    case ThingShape::cylinder:
      return cylinder_mesh(half);
    case ThingShape::sphere:
      return sphere_mesh(half);
  }
  return {};
}

std::vector<GltfThing> things_in_file(std::span<const ThingMotion> ways, const Placement& file,
                                      std::span<const Vec3d> kept) {
  const bool mirrored = file.mirrored();
  const Mat3d axes = mirrored ? Mat3d{file.left, file.up, file.ahead} : Mat3d{};
  const Vec3d origin = mirrored ? file.origin : Vec3d{};
  std::vector<GltfThing> things;
  for (const auto& [thing, poses] : ways) {
    Thing shape = thing;
    for (ThingPart& part : shape.parts) part.position.x *= mirrored ? -1.0 : 1.0;
    GltfThing& own = things.emplace_back(GltfThing{thing.name, mesh_of(shape, file.unit), {}, {}});
    for (std::size_t f = 0; f < poses.size(); ++f) {
      const auto& [turn, at] = poses[f];
      Mat3d turned = axes * turn;
      // boxes and round shapes equal their mirror images
      if (mirrored) turned.cx = -turned.cx;
      own.rotations.push_back(to_quat(turned));
      const Vec3d off = f < kept.size() ? kept[f] : Vec3d{};
      own.translations.push_back(axes * (at * (1.0 / file.unit)) + origin - off);
    }
  }
  return things;
}

std::vector<GltfMarker> markers_of(const Candidate& candidate) {
  std::vector<GltfMarker> markers;
  for (const ActionResult& action : candidate.actions) {
    markers.push_back({word_of(action.kind), action.start, action.end});
  }
  return markers;
}

}  // namespace shigusa
