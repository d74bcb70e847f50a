// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/body.hpp>
#include <utility>

#include "body/body_constants.hpp"
#include "body/joint_name.hpp"
#include "core/check.hpp"
#include "core/index.hpp"
#include "further_effectors.hpp"

namespace shigusa {
namespace {

bool is_rotation(const Mat3d& r) {
  constexpr double kRotationRounding = 1e-9;
  return rotation_chord(r * transpose(r), Mat3d{}) < kRotationRounding &&
         dot(cross(r.cx, r.cy), r.cz) > 0.0;
}

void check_dofs(const BodyDefinition& body) {
  const int count = static_cast<int>(body.dofs.size());
  for (int i = 0; i < count; ++i) {
    const Dof& dof = body.dofs[index(i)];
    SHG_CHECK(dof.parent >= kBaseLink && dof.parent < i, "parent of " + dof.name);
    SHG_CHECK(dof.lower < dof.upper, "limits of " + dof.name);
    SHG_CHECK(dof.sign == 1.0 || dof.sign == -1.0, "sign of " + dof.name);
    SHG_CHECK(!dof.turn || is_rotation(*dof.turn), "turn of " + dof.name);
    SHG_CHECK(dof.torque_positive > 0.0 && dof.torque_negative > 0.0, "strength of " + dof.name);
    SHG_CHECK(dof.give > 0.0 && dof.give <= 1.0, "give of " + dof.name);
  }
}

BodyDefinition checked(BodyDefinition body) {
  const int count = static_cast<int>(body.dofs.size());
  SHG_CHECK(count > 0, "a body needs at least one dof");
  SHG_CHECK(body.masses.size() == body.dofs.size(), "one mass per dof of " + body.name);
  check_dofs(body);
  const auto is_link = [count](int link) { return link >= kBaseLink && link < count; };
  for (const Effector& effector : body.effectors) {
    SHG_CHECK(is_link(effector.link), effector.name);
    SHG_CHECK(effector.limb_root >= 0 && effector.limb_root < count, effector.name);
  }
  for (const Capsule& capsule : body.capsules) {
    SHG_CHECK(is_link(capsule.link) && capsule.radius > 0.0 && capsule.to_radius > 0.0,
              capsule.name);
  }
  for (const Foot& foot : body.feet) {
    SHG_CHECK(is_link(foot.link), foot.name);
    if (!foot.heel) continue;
    const auto is_dof = [count](int dof) { return dof >= 0 && dof < count; };
    SHG_CHECK(is_dof(foot.heel->toes) && is_dof(foot.heel->ankle), "heel of " + foot.name);
  }
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    SHG_CHECK(is_link(body.nodes[i].link), body.nodes[i].name);
    SHG_CHECK(body.nodes[i].parent < static_cast<int>(i), body.nodes[i].name);
  }
  for (const LimitCoupling& coupling : body.couplings) {
    SHG_CHECK(coupling.dof >= 0 && coupling.dof < count, "limit coupling");
    SHG_CHECK(coupling.driver >= 0 && coupling.driver < count, "limit coupling");
    SHG_CHECK(coupling.driver_full > 0.0, "limit coupling");
  }
  for (Dof& dof : body.dofs) dof.part = parse_joint_name(dof.name);
  for (Effector& effector : body.effectors) effector.part = parse_joint_name(effector.name);
  return body;
}

template <class Items>
std::optional<int> find_named(const Items& items, std::string_view name) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return static_cast<int>(i);
  }
  return std::nullopt;
}

}  // namespace

BodyModel::BodyModel(BodyDefinition definition)
    : definition_(checked(std::move(definition))),
      further_(further_effectors(definition_)),
      constants_(std::make_shared<const BodyConstants<double>>(definition_)),
      constants_float_(std::make_shared<const BodyConstants<float>>(definition_)) {
  const std::size_t count = definition_.dofs.size();
  ancestry_.assign(count * count, 0);
  for (std::size_t link = 0; link < count; ++link) {
    for (int d = static_cast<int>(link); d != kBaseLink; d = definition_.dofs[index(d)].parent) {
      ancestry_[link * count + index(d)] = 1;
    }
    chain_begin_.push_back(chains_.size());
    for (std::size_t d = 0; d < count; ++d) {
      if (ancestry_[link * count + d] != 0) chains_.push_back(static_cast<int>(d));
    }
  }
  chain_begin_.push_back(chains_.size());
}

double upper_limit(const BodyModel& body, int dof, std::span<const double> angles) {
  double added = 0.0;
  for (const LimitCoupling& c : body.couplings()) {
    if (c.dof != dof) continue;
    added += clamp(angles[index(c.driver)] * (1.0 / c.driver_full), 0.0, 1.0) * c.gain;
  }
  return body.dof(dof).upper + added;
}

BodyModel with_places(const BodyModel& body, std::vector<NodePlace> places) {
  BodyDefinition placed = body.definition();
  placed.places = std::move(places);
  return BodyModel(std::move(placed));
}

const LimitCoupling* BodyModel::coupling_of(int dof) const {
  const auto& all = definition_.couplings;
  const auto is_its = [dof](const LimitCoupling& coupling) { return coupling.dof == dof; };
  const auto found = std::find_if(all.begin(), all.end(), is_its);
  return found == all.end() ? nullptr : &*found;
}

const BodyNode* BodyModel::find_node(std::string_view name) const {
  for (const BodyNode& node : nodes()) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

double BodyModel::limb_length(const Effector& effector) const {
  double length = norm(effector.point);
  for (int d = effector.link; d != effector.limb_root && d != kBaseLink; d = dof(d).parent) {
    length += norm(dof(d).offset);
  }
  return length;
}

std::optional<int> BodyModel::find_effector(std::string_view name) const {
  for (const std::string& word : {std::string(name), joint_word(name)}) {
    for (int i = 0; i < effector_count(); ++i) {
      if (effector(i).name == word) return i;
    }
  }
  for (int i = 0; i < effector_count(); ++i) {
    if (effector(i).node == name) return i;
  }
  return std::nullopt;
}

std::optional<int> BodyModel::find_effector(JointKind joint, Side side) const {
  for (int i = 0; i < effector_count(); ++i) {
    const JointPlace& part = effector(i).part;
    if (part.joint_kind == joint && part.side == side) return i;
  }
  return std::nullopt;
}

std::optional<int> BodyModel::find_dof(std::string_view name) const {
  return find_named(definition_.dofs, name);
}

std::optional<int> BodyModel::find_dof(JointKind joint, FreedomKind freedom,
                                       std::optional<Side> side) const {
  for (int d = 0; d < dof_count(); ++d) {
    if (dof(d).part.is(joint, freedom) && dof(d).part.side == side) return d;
  }
  return std::nullopt;
}

std::vector<int> BodyModel::dofs_of(JointKind joint, FreedomKind freedom) const {
  std::vector<int> found;
  for (int d = 0; d < dof_count(); ++d) {
    if (dof(d).part.is(joint, freedom)) found.push_back(d);
  }
  return found;
}

}  // namespace shigusa
