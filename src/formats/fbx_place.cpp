// SPDX-License-Identifier: MIT
#include "fbx_place.hpp"

#include "core/index.hpp"
#include "math/axes.hpp"

namespace shigusa {
namespace {

// Rotation by degrees about x, y and z, in one of FBX's numbered orders.
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

}  // namespace

FbxPlace place_of(const FbxProperties& p) {
  // if inactive, there are no further rotations, and the order is x, y, z
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

FbxInherit inherit_of(const FbxProperties& p) {
  const double number = p.number("InheritType", 1.0);
  return number == 0.0   ? FbxInherit::after_turn
         : number == 2.0 ? FbxInherit::but_the_parents_own
                         : FbxInherit::before_turn;
}

FbxWorldPlace below(const FbxWorldPlace& parent, const FbxPlace& place, FbxInherit inherit) {
  const Mat3d scaled = scaled_columns(parent.inherited, parent.scale);
  const Mat3d turned = to_matrix(place.turned);
  FbxWorldPlace result{parent.at + parent.turned * (scaled * place.at), parent.turned * turned,
                       scaled, place.scale};
  if (inherit == FbxInherit::before_turn) result.inherited = transpose(turned) * scaled * turned;
  if (inherit == FbxInherit::but_the_parents_own) result.inherited = parent.inherited;
  return result;
}

}  // namespace shigusa
