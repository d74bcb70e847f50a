// SPDX-License-Identifier: MIT
#include "tiptoe.hpp"

#include <algorithm>
#include <optional>

namespace shigusa {
namespace {

// Flexion of the toes (rad) from which their heel counts as lifted.
constexpr double kHeelLeaves = radians(0.5);

// (dofs) m/rad: derivative of the centre of mass by each angle.
std::vector<Vec3d> mass_columns(const BodyModel& body, const Kinematics<double>& kinematics) {
  std::vector<Vec3d> columns(body.dofs().size());
  for (int link = 0; link < body.dof_count(); ++link) {
    const MassProperties& mass = body.link_mass(link);
    if (!(mass.mass > 0.0)) continue;
    const Vec3d at = kinematics.point(link, mass.com);
    for (const int d : body.chain(link)) {
      const auto k = static_cast<std::size_t>(d);
      columns[k] +=
          cross(kinematics.axis[k], at - kinematics.origin[k]) * (mass.mass / body.mass());
    }
  }
  return columns;
}

}  // namespace

std::vector<double> change_of_plumb_line(const BodyModel& body,
                                         const Kinematics<double>& kinematics,
                                         const Vec3d& offset) {
  const std::vector<Vec3d> columns = mass_columns(body, kinematics);
  double xx = 0.0;
  double xz = 0.0;
  double zz = 0.0;
  for (const Vec3d& c : columns) {
    xx += c.x * c.x;
    xz += c.x * c.z;
    zz += c.z * c.z;
  }
  std::vector<double> change(columns.size());
  const double determinant = xx * zz - xz * xz;
  if (!(determinant > 0.0)) return change;
  const double x = (zz * offset.x - xz * offset.z) / determinant;
  const double z = (xx * offset.z - xz * offset.x) / determinant;
  for (std::size_t d = 0; d < change.size(); ++d) change[d] = columns[d].x * x + columns[d].z * z;
  return change;
}

Tiptoe::Tiptoe(const ReachProblem& problem, std::span<const double> angles) {
  const BodyModel& body = *problem.body;
  for (std::size_t f = 0; f < body.feet().size(); ++f) {
    const std::optional<Heel>& heel = body.feet()[f].heel;
    if (heel && angles[static_cast<std::size_t>(heel->toes)] > kHeelLeaves) lifted_ |= 1U << f;
  }
  if (lifted_ == 0) return;
  edges_ = support_edges(body, problem.start(), lifted_);
  const std::vector<Vec3d> corners = support_polygon(body, problem.start(), lifted_);
  for (const Vec3d& corner : corners) {
    middle_ += corner * (1.0 / static_cast<double>(corners.size()));
  }
}

Vec3d Tiptoe::offset_from(const Vec3d& c) const {
  const auto outside = [&c](const SupportEdge& edge) {
    return edge.offset + edge.x * c.x + edge.z * c.z < kPoised;
  };
  if (std::none_of(edges_.begin(), edges_.end(), outside)) return {};
  return {middle_.x - c.x, 0.0, middle_.z - c.z};
}

}  // namespace shigusa
