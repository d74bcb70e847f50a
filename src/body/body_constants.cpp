// SPDX-License-Identifier: MIT
#include "body/body_constants.hpp"

#include <algorithm>
#include <shigusa/body.hpp>

namespace shigusa {
namespace {

template <class T>
Mat3<T> matrix(const Mat3d& m) {
  return {to_scalar<T>(m.cx), to_scalar<T>(m.cy), to_scalar<T>(m.cz)};
}

// Ratio to its neighbours below which a number is rounding, and set to 0.
constexpr double kRounding = 1e-12;

bool is_upright(const Vec3d& v) { return max(abs(v.x), abs(v.z)) <= kRounding * abs(v.y); }

bool carries_upright(const BodyDefinition& body, int link) {
  return std::all_of(body.dofs.begin(), body.dofs.end(), [link](const Dof& dof) {
    return dof.parent != link || is_upright(dof.offset);
  });
}

bool is_principal(const Mat3d& inertia) {
  const double off = max(abs(inertia.cx.y), max(abs(inertia.cx.z), abs(inertia.cy.z)));
  return off <= kRounding * (inertia.cx.x + inertia.cy.y + inertia.cz.z);
}

// Whether the link has mass or children other than dofs.
bool carries(const BodyDefinition& body, int link) {
  const auto is_there = [link](const auto& thing) { return thing.link == link; };
  return body.masses[static_cast<std::size_t>(link)].mass > 0.0 ||
         std::any_of(body.effectors.begin(), body.effectors.end(), is_there) ||
         std::any_of(body.feet.begin(), body.feet.end(), is_there) ||
         std::any_of(body.capsules.begin(), body.capsules.end(), is_there) ||
         std::any_of(body.nodes.begin(), body.nodes.end(), is_there);
}

// Whether the dof shares the joint of its parent.
bool continues_joint(const BodyDefinition& body, int dof) {
  const Dof& own = body.dofs[static_cast<std::size_t>(dof)];
  if (own.parent == kBaseLink || own.parent != dof - 1 || own.offset != Vec3d{}) return false;
  // a slanting axis is a separate joint
  if (own.turn || body.dofs[static_cast<std::size_t>(own.parent)].turn) return false;
  if (carries(body, own.parent)) return false;
  int children = 0;
  for (const Dof& other : body.dofs) children += other.parent == own.parent ? 1 : 0;
  return children == 1;
}

}  // namespace

template <class T>
BodyConstants<T>::BodyConstants(const BodyDefinition& body)
    : base_rotation(matrix<T>(body.base.rotation)),
      base_origin(to_scalar<T>(body.base.translation)),
      base_mass(static_cast<T>(body.base_mass.mass)),
      base_com(to_scalar<T>(body.base_mass.com)),
      total_mass(static_cast<T>(body.mass)) {
  std::vector<int> joint_of(body.dofs.size());
  for (std::size_t i = 0; i < body.dofs.size(); ++i) {
    const shigusa::Dof& dof = body.dofs[i];
    dofs.push_back({dof.parent, dof.axis, true, dof.sign < 0.0, to_scalar<T>(dof.offset)});
    const int link = static_cast<int>(i);
    dofs.back().starts_joint = !continues_joint(body, link);
    if (dofs.back().starts_joint) {
      const int parent =
          dof.parent == kBaseLink ? -1 : joint_of[static_cast<std::size_t>(dof.parent)];
      joints.push_back({.first = link, .parent = parent, .hangs = is_upright(dof.offset)});
      joints.back().slants = dof.turn.has_value();
      turns.push_back(matrix<T>(dof.turn.value_or(Mat3d{})));
    }
    joint_of[i] = static_cast<int>(joints.size()) - 1;
    const MassProperties& mass = body.masses[i];
    Joint& joint = joints.back();
    joint.link = link;
    joint.massive = mass.mass > 0.0;
    joint.upright = is_upright(mass.com) && carries_upright(body, link);
    joint.principal = is_principal(mass.inertia);
    joint.mass = static_cast<T>(mass.mass);
    joint.com = to_scalar<T>(mass.com);
    joint.inertia = matrix<T>(mass.inertia);
    joint.gyroscopic = {joint.inertia.cz.z - joint.inertia.cy.y,
                        joint.inertia.cx.x - joint.inertia.cz.z,
                        joint.inertia.cy.y - joint.inertia.cx.x};
  }
}

template struct BodyConstants<float>;
template struct BodyConstants<double>;

}  // namespace shigusa
