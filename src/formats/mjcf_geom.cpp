// SPDX-License-Identifier: MIT
#include "mjcf_geom.hpp"

#include "core/say.hpp"

namespace shigusa {
namespace {

constexpr double kDensity = 1000.0;  // kg/m³, the default density

enum class Shape { sphere, capsule, cylinder, ellipsoid, box };

struct NamedShape {
  std::string_view name;
  Shape shape;
  std::size_t sizes;  // number of size values
};
constexpr NamedShape kShapes[] = {{"sphere", Shape::sphere, 1},
                                  {"capsule", Shape::capsule, 2},
                                  {"cylinder", Shape::cylinder, 2},
                                  {"ellipsoid", Shape::ellipsoid, 3},
                                  {"box", Shape::box, 3}};

// Volume (m³) of a shape, and its moments about its own axes per kilogram (m²).
struct Solid {
  double volume;
  Vec3d moments;
};

// `s`: m, radius and half the length of round shapes, else half sizes. A capsule is a cylinder with
// two hemispheres of the same density.
Solid solid(Shape shape, const Vec3d& s) {
  const double r2 = s.x * s.x;
  switch (shape) {
    case Shape::sphere:
      return {4.0 / 3.0 * kPi * r2 * s.x, Vec3d{1, 1, 1} * (0.4 * r2)};
    case Shape::cylinder: {
      const double across = r2 / 4.0 + s.y * s.y / 3.0;
      return {kTwoPi * r2 * s.y, {across, across, 0.5 * r2}};
    }
    case Shape::capsule: {
      const double ball = 4.0 / 3.0 * s.x / (4.0 / 3.0 * s.x + 2.0 * s.y);
      const double cylinder = 1.0 - ball;
      const double across = cylinder * (r2 / 4.0 + s.y * s.y / 3.0) +
                            ball * (0.4 * r2 + 0.75 * s.x * s.y + s.y * s.y);
      return {kPi * r2 * (4.0 / 3.0 * s.x + 2.0 * s.y),
              {across, across, r2 * (0.5 * cylinder + 0.4 * ball)}};
    }
    default: {
      const bool box = shape == Shape::box;
      const Vec3d squares{s.x * s.x, s.y * s.y, s.z * s.z};
      return {(box ? 8.0 : 4.0 / 3.0 * kPi) * s.x * s.y * s.z,
              Vec3d{squares.y + squares.z, squares.z + squares.x, squares.x + squares.y} *
                  (box ? 1.0 / 3.0 : 0.2)};
    }
  }
}

Vec3d half_sizes(Shape shape, const Vec3d& s) {
  switch (shape) {
    case Shape::sphere:
      return {s.x, s.x, s.x};
    case Shape::cylinder:
      return {s.x, s.x, s.y};
    case Shape::capsule:
      return {s.x, s.x, s.x + s.y};
    default:
      return s;
  }
}

Robot::Shape::Kind kind_of(Shape shape) {
  using Kind = Robot::Shape::Kind;
  if (shape == Shape::sphere) return Kind::ball;
  return shape == Shape::capsule || shape == Shape::cylinder ? Kind::cylinder : Kind::box;
}

Mat3d diagonal(const Vec3d& d) { return {{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}; }

Mat3d turned(const Mat3d& r, const Mat3d& inertia) { return r * inertia * transpose(r); }

// Size and transform of a shape; two end points may define its length and axis.
Vec3d read_size(MjcfFiles& files, MjcfValues& values, const MjcfPart& part, const NamedShape& kind,
                MjcfGeom& geom) {
  std::array<double, 3> size{};
  std::array<double, 6> ends{};
  const bool between = kind.shape != Shape::sphere && values.numbers(part, "fromto", ends, 6) == 6;
  const std::size_t least = between ? 1 : kind.sizes;
  if (values.numbers(part, "size", size, least) == 0) {
    files.wrong(part.element, say("shape_without_size", kind.name));
  }
  Transformd& place = geom.shape.place;
  place = values.place(part);
  if (between) {
    const Vec3d from{ends[0], ends[1], ends[2]};
    const Vec3d to{ends[3], ends[4], ends[5]};
    const double length = norm(to - from);
    if (!(length > 0.0)) files.wrong(part.element, say("fromto_one_point"));
    place = {length > 0.0 ? turned_to((from - to) * (1.0 / length)) : Mat3d{}, (from + to) * 0.5};
    size = kind.sizes == 2 ? std::array{size[0], 0.5 * length, 0.0}
                           : std::array{size[0], size[0], 0.5 * length};
  }
  for (std::size_t k = 0; k < kind.sizes; ++k) {
    if (!(size[k] > 0.0)) {
      files.wrong(part.element, say("size_range", shown(values.word(part, "size")), kind.name));
    }
  }
  return {size[0], size[1], size[2]};
}

}  // namespace

MjcfGeom read_geom(MjcfFiles& files, MjcfValues& values, const MjcfPart& part) {
  MjcfGeom geom;
  const bool meets = values.number(part, "contype", 1.0) != 0.0;
  geom.collides = meets || values.number(part, "conaffinity", 1.0) != 0.0;
  std::string_view type = values.word(part, "type");
  if (type.empty()) type = values.has(part, "mesh") ? "mesh" : "sphere";
  const double group = values.number(part, "group", 0.0);
  const auto [first, last] = values.settings().groups;
  const bool weighs = group >= first && group <= last;
  const double given = values.number(part, "mass", -1.0);
  const double density = values.number(part, "density", kDensity);
  if (density < 0.0) files.wrong(part.element, say("density_range", density));
  for (const NamedShape& kind : kShapes) {
    // a mesh fitted by a primitive shape has no size here
    if (kind.name != type || values.has(part, "mesh")) continue;
    const Vec3d size = read_size(files, values, part, kind, geom);
    geom.solid = true;
    geom.shape.half = half_sizes(kind.shape, size);
    geom.shape.kind = kind_of(kind.shape);
    const Solid body = solid(kind.shape, size);
    const double mass = !weighs ? 0.0 : given >= 0.0 ? given : density * body.volume;
    const Transformd& place = geom.shape.place;
    geom.mass = LinkMass::of(mass, place.translation,
                             turned(place.rotation, diagonal(body.moments * mass)));
    return geom;
  }
  const bool mesh = type == "mesh" || type == "sdf" || values.has(part, "mesh");
  if (!mesh && type != "plane" && type != "hfield") {
    files.wrong(part.element, say("no_shape", shown(type)));
  }
  geom.mesh = mesh && weighs && given != 0.0 && density > 0.0;
  return geom;
}

LinkMass read_inertial(MjcfFiles& files, MjcfValues& values, const MjcfPart& part) {
  const double mass = values.number(part, "mass", -1.0);
  if (mass < 0.0) files.wrong(part.element, say("inertial_mass"));
  const Transformd place = values.place(part);
  std::array<double, 6> full{};
  Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  if (values.numbers(part, "fullinertia", full, 6) == 6) {
    inertia = {
        {full[0], full[3], full[4]}, {full[3], full[1], full[5]}, {full[4], full[5], full[2]}};
  } else {
    inertia = turned(place.rotation, diagonal(values.vector(part, "diaginertia")));
  }
  return LinkMass::of(max(mass, 0.0), place.translation, inertia);
}

}  // namespace shigusa
