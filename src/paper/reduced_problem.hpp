// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plan/layer.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// All that the motions of a reduced body towards a problem's goals have in common. Body and problem
// outlive it.
struct ReducedProblem {
  // A hand, or a planted foot.
  struct Target {
    int link = 0;
    int limb = -1;     // of a hand: of the body's limbs
    int carrier = -1;  // of a hand: the link with its shoulder
    bool contact = false;
    Vec3d position{};        // of a contact: m, world
    Mat3d orientation{};     // of a contact's link
    std::vector<int> chain;  // dofs that move it, from the base on
  };
  // The freedoms of an arm's clavicle, and what they are where its law wants nothing (rad).
  struct Clavicle {
    int slide = 0;  // the arm's
    int elevation = 0;
    int protraction = 0;
    double elevation_start = 0.0;
    double protraction_start = 0.0;
  };

  ReducedProblem(const ReducedBody& body, const ReachProblem& problem);
  ReducedProblem(const ReducedProblem&) = delete;
  ReducedProblem& operator=(const ReducedProblem&) = delete;
  ~ReducedProblem();  // in the source file, where all SIMD sets share it

  [[nodiscard]] std::span<const ReducedDof> dofs() const { return body->dofs; }

  const ReducedBody* body;
  const ReachProblem* reach;
  std::vector<Target> targets;      // hands in the order of the goals, then planted feet
  std::vector<Clavicle> clavicles;  // of arms with goals
  std::vector<int> moving;          // limbs that have a length to keep to
  std::vector<int> used;            // dofs that some target hangs on, as the trunk does
  std::vector<int> limited;         // those that have limits, where the problem holds them
  std::vector<Vec3d> paths;         // (frames × goals) m, world
  int legs = 0;                     // that stand

 private:
  void add_hand(int effector);
  void add_clavicle(const ReducedLimb& limb);
  void add_planted_foot(const ReducedLimb& leg);
  void find_used();
};

}  // namespace shigusa
