// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plan/layer.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// The data shared by all motions of a reduced body towards a problem's goals. Body and problem
// outlive it.
struct ReducedProblem {
  // A hand, or a planted foot.
  struct Target {
    int link = 0;
    int limb = -1;     // for a hand: index among the body's limbs
    int carrier = -1;  // for a hand: the link with its shoulder
    bool contact = false;
    Vec3d position{};        // for a contact: m, world
    Mat3d orientation{};     // for a contact's link
    std::vector<int> chain;  // dofs that move it, from the base on
  };
  // The dofs of an arm's clavicle, and their angles without the law's contribution (rad).
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
  ~ReducedProblem();  // defined in the source file, shared by all SIMD sets

  [[nodiscard]] std::span<const ReducedDof> dofs() const { return body->dofs; }

  const ReducedBody* body;
  const ReachProblem* reach;
  std::vector<Target> targets;      // hands in the order of the goals, then planted feet
  std::vector<Clavicle> clavicles;  // of arms with goals
  std::vector<int> moving;          // limbs with a prescribed length
  std::vector<int> used;            // dofs in the chain of some target, such as the trunk's
  std::vector<int> limited;         // used dofs with limits, if the problem holds them
  std::vector<Vec3d> paths;         // (frames × goals) m, world
  int legs = 0;                     // number of standing legs

 private:
  void add_hand(int effector);
  void add_clavicle(const ReducedLimb& limb);
  void add_planted_foot(const ReducedLimb& leg);
  void find_used();
};

}  // namespace shigusa
