// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "moving_body.hpp"
#include "table.hpp"

namespace shigusa::bench {

// A person's links, placed by the angles of an exported table and the body's own numbers.
class PlacedLinks {
 public:
  PlacedLinks(const BodyModel& body, const Table& table);

  [[nodiscard]] int frames() const { return static_cast<int>(base_.size()); }
  // Frame of a link in the world; kBaseLink is allowed.
  [[nodiscard]] const Transformd& at(int link, int frame) const;
  // Axis (world) of a degree of freedom.
  [[nodiscard]] Vec3d axis(int dof, int frame) const;

 private:
  const BodyModel& body_;
  std::vector<Transformd> base_;                // (frames)
  std::vector<std::vector<Transformd>> links_;  // [frame][dof]
};

// Rigid pieces of a person's motion: links, loads of the goals, forces on resting hands. Hinges are
// those without a planted foot beyond them, so that the distribution of the floor's force is
// irrelevant.
[[nodiscard]] MovingBody pieces_of(const BodyModel& body, const PlacedLinks& links,
                                   const Task& task, const Candidate& candidate);

}  // namespace shigusa::bench
