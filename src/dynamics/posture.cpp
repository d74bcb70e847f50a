// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/error.hpp>
#include <shigusa/kinematics.hpp>

#include "core/check.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "dynamics/contact_forces.hpp"

namespace shigusa {
namespace {

constexpr double kAngleMax = 1e6;  // rad: as far as sin_cos is exact

Transformd carried(const Transformd& link, const Vec3d& point) {
  return {link.rotation, link * point};
}

}  // namespace

struct Posture::Placed {
  const BodyModel& body;
  std::vector<double> angles;
  Kinematics<double> links;

  Placed(const BodyModel& of, std::span<const double> at)
      : body(of), angles(at.begin(), at.end()), links(of) {
    SHG_CHECK(angles.size() == body.dofs().size(),
              fmt::format("a posture of this body has {} angles; {} are given", body.dof_count(),
                          angles.size()));
    for (const double angle : angles) {
      SHG_CHECK(
          abs(angle) <= kAngleMax,
          fmt::format("an angle is a number of at most {} rad; {} is given", kAngleMax, angle));
    }
    forward_kinematics<double>(body, angles, links);
    // links between the freedoms of one joint have no mass, and no rotation in the kernel
    const auto& constants = body.constants<double>();
    for (const auto& joint : constants.joints) {
      Mat3d turned = links.link_rotation(constants.dofs[index(joint.first)].parent);
      for (int d = joint.first; d < joint.link; ++d) {
        turned = rotated(turned, constants.dofs[index(d)].axis, links.turn[index(d)]);
        links.rotation[index(d)] = turned;
      }
    }
  }
};

Posture::Posture(const BodyModel& body, std::span<const double> angles)
    : placed_(std::make_shared<const Placed>(body, angles)) {}

const BodyModel& Posture::body() const { return placed_->body; }

std::span<const double> Posture::angles() const { return placed_->angles; }

Transformd Posture::place(int link) const {
  SHG_CHECK(link >= kBaseLink && link < body().dof_count(),
            fmt::format("links of this body are {} to {}; {} is given", kBaseLink,
                        body().dof_count() - 1, link));
  return {placed_->links.link_rotation(link), placed_->links.link_origin(link)};
}

Transformd Posture::place(const BodyNode& node) const {
  return carried(place(node.link), node.point);
}

Transformd Posture::place(const Effector& effector) const {
  return carried(place(effector.link), effector.point);
}

Result<Transformd> Posture::effector_place(std::string_view name) const {
  if (const auto found = body().find_effector(name)) return place(body().effector(*found));
  std::vector<std::string> names;
  for (int k = 0; k < body().effector_count(); ++k) names.push_back(body().effector(k).name);
  return fail(ErrorCode::not_found, unknown_name("effector", name, names));
}

Result<Transformd> Posture::node_place(std::string_view name) const {
  std::vector<std::string> names;
  for (const BodyNode& node : body().nodes()) {
    if (node.end_site) continue;
    if (node.name == name) return place(node);
    names.push_back(node.name);
  }
  return fail(ErrorCode::not_found, unknown_name("node", name, names));
}

PointJacobian Posture::jacobian(int link, const Vec3d& point) const {
  const Vec3d at = place(link) * point;
  PointJacobian columns{std::vector<Vec3d>(angles().size()), std::vector<Vec3d>(angles().size())};
  for (const int d : body().chain(link)) {
    columns.linear[index(d)] = position_column(placed_->links, d, at);
    columns.angular[index(d)] = placed_->links.axis[index(d)];
  }
  return columns;
}

Vec3d Posture::centre_of_mass() const { return shigusa::centre_of_mass(body(), placed_->links); }

std::vector<double> Posture::holding_torques() const {
  const std::vector<double> still(angles().size());
  std::vector<double> torques(still.size());
  DynamicsWorkspace<double> work(body());
  const Wrench<double> ground =
      inverse_dynamics<double>(body(), placed_->links, {still, still}, work, torques);
  bear_on_feet<double>(body(), placed_->links, angles(), ground, torques);
  return torques;
}

}  // namespace shigusa
