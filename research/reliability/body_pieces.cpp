// SPDX-License-Identifier: MIT
#include "body_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace shigusa::bench {
namespace {

std::size_t piece_of(int link) { return static_cast<std::size_t>(link + 1); }

Vec3d unit(Axis axis) {
  return {axis == Axis::x ? 1.0 : 0.0, axis == Axis::y ? 1.0 : 0.0, axis == Axis::z ? 1.0 : 0.0};
}

// of a degree of freedom, in its parent's frame
Vec3d axis_in_parent(const Dof& dof) {
  const Vec3d axis = unit(dof.axis) * dof.sign;
  return dof.turn ? *dof.turn * axis : axis;
}

// Rodrigues' formula, column by column.
Mat3d turn_about(const Vec3d& axis, double angle) {
  const auto turned = [&](const Vec3d& v) {
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) +
           axis * (dot(axis, v) * (1.0 - std::cos(angle)));
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

bool holds(const BodyModel& body, int dof, int link) {
  for (; link != kBaseLink; link = body.dof(link).parent) {
    if (link == dof) return true;
  }
  return false;
}

void add_link(const BodyModel& body, const PlacedLinks& links, int link, MovingBody& moving) {
  const MassProperties& mass = body.link_mass(link);
  MovingPiece& piece = moving.pieces.emplace_back();
  piece.mass = mass.mass;
  piece.inertia = mass.inertia;
  for (int f = 0; f < moving.frames; ++f) {
    piece.centre.push_back(links.at(link, f) * mass.com);
    piece.turn.push_back(links.at(link, f).rotation);
  }
}

// a point mass in the hand
void add_load(const Effector& hand, double load, const PlacedLinks& links, MovingBody& moving) {
  MovingPiece& piece = moving.pieces.emplace_back();
  piece.mass = load;
  for (int f = 0; f < moving.frames; ++f) {
    piece.centre.push_back(links.at(hand.link, f) * hand.point);
    piece.turn.push_back(links.at(hand.link, f).rotation);
  }
}

}  // namespace

PlacedLinks::PlacedLinks(const BodyModel& body, const Table& table) : body_(body) {
  std::vector<const std::vector<double>*> angles;
  for (const Dof& dof : body.dofs()) angles.push_back(&table.column(dof.name + " [rad]"));
  for (std::size_t f = 0; f < table.rows(); ++f) {
    base_.push_back(body.base());
    std::vector<Transformd>& links = links_.emplace_back();
    for (std::size_t d = 0; d < angles.size(); ++d) {
      const Dof& dof = body.dofs()[d];
      const Transformd& parent =
          dof.parent == kBaseLink ? body.base() : links[static_cast<std::size_t>(dof.parent)];
      links.push_back(parent *
                      Transformd{turn_about(axis_in_parent(dof), (*angles[d])[f]), dof.offset});
    }
  }
}

const Transformd& PlacedLinks::at(int link, int frame) const {
  const auto f = static_cast<std::size_t>(frame);
  return link == kBaseLink ? base_[f] : links_[f][static_cast<std::size_t>(link)];
}

Vec3d PlacedLinks::axis(int dof, int frame) const {
  return at(dof, frame).rotation * axis_in_parent(body_.dof(dof));
}

MovingBody pieces_of(const BodyModel& body, const PlacedLinks& links, const Task& task,
                     const Candidate& candidate) {
  MovingBody moving;
  moving.frame_time = candidate.motion.clip.frame_time;
  moving.frames = links.frames();
  for (int link = kBaseLink; link < body.dof_count(); ++link) add_link(body, links, link, moving);
  std::vector<int> loaded;
  for (const Goal& goal : task.goals) {
    if (!(goal.load > 0.0)) continue;
    const Effector& hand = body.effector(body.find_effector(goal.effector).value());
    loaded.push_back(hand.link);
    add_load(hand, goal.load, links, moving);
  }
  for (const RestingHand& rest : candidate.motion.resting) {
    moving.forces.push_back(
        {piece_of(body.effector(rest.effector).link), rest.places, rest.forces});
    if (!rest.thigh) continue;
    MovingForce back{piece_of(*rest.thigh), rest.places, rest.forces};
    for (Vec3d& force : back.force) force = force * -1.0;
    moving.forces.push_back(std::move(back));
  }
  for (int d = 0; d < body.dof_count(); ++d) {
    const bool stands = std::any_of(body.feet().begin(), body.feet().end(),
                                    [&](const Foot& foot) { return holds(body, d, foot.link); });
    if (stands) continue;
    MovingHinge& hinge = moving.hinges.emplace_back();
    hinge.name = body.dof(d).name;
    hinge.positive = body.dof(d).torque_positive;
    hinge.negative = body.dof(d).torque_negative;
    for (int link = 0; link < body.dof_count(); ++link) {
      if (holds(body, d, link)) hinge.carries.push_back(piece_of(link));
    }
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      if (holds(body, d, loaded[k])) hinge.carries.push_back(piece_of(body.dof_count()) + k);
    }
    for (int f = 0; f < moving.frames; ++f) {
      hinge.at.push_back(links.at(d, f).translation);
      hinge.axis.push_back(links.axis(d, f));
    }
  }
  return moving;
}

}  // namespace shigusa::bench
