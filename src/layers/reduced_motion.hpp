// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/parameters.hpp>
#include <span>
#include <vector>

#include "layers/reduced_limits.hpp"
#include "rollout/posture_law.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {

// Where a reduced body's links are.
struct ReducedPlacement {
  std::vector<Mat3d> rotation;  // (dofs) R_WL
  std::vector<Vec3d> origin;    // (dofs) m, world: a hinge's centre, a slide's far end
  std::vector<Vec3d> axis;      // (dofs) world: turned about, or slid along
};
void place_reduced(const ReducedBody& body, std::span<const double> q, ReducedPlacement& placed);

// The values of a layer's joints and contractions, in one of two codes. Freedoms without a weight
// of their own are locked. The paper's code: (parameters of the layer) each 0..kContractionMax; a
// weight of 0 locks.
[[nodiscard]] Parameters decode_layer_genes(const Layer& layer,
                                            std::span<const std::uint16_t> genes);
// A code even in the weights' logarithms (kLogWeightRange), without locks, and even in contraction:
// (parameters of the layer) each 0..1.
[[nodiscard]] Parameters decode_layer_point(const Layer& layer, std::span<const double> point);

// The angles and lengths of a reduced body's dofs, frame after frame, and where that brings it.
struct ReducedClip {
  int dofs = 0;
  std::vector<double> values;                     // (frames × dofs) rad or m
  std::vector<Transformd> trunk;                  // (frames) X_WB of the trunk's link
  std::vector<std::vector<Vec3d>> hands;          // [goal][frame] m, world
  std::vector<std::vector<Transformd>> carriers;  // [goal][frame] of the link with the shoulder
  double path_error = 0.0;  // m, largest distance of a hand from its path at any frame
  double foot_error = 0.0;  // m, largest slide of a planted foot; its tilt counts by kContactLength

  [[nodiscard]] std::span<const double> frame(int index) const {
    return std::span<const double>(values).subspan(
        static_cast<std::size_t>(index) * static_cast<std::size_t>(dofs),
        static_cast<std::size_t>(dofs));
  }
};

// Moves a reduced body by weighted IK along the hands' paths (rules R3 and R6):
//
//   L(t) = L_0 + (L_f - L_0) s(t),  L_f = longest - (longest - shortest) · contraction / 15,
//   min Σ w_i Δq_i²   s.t.   J Δq = e - J_L ΔL,
//
// with s(t) the minimum jerk of the motion. By LengthLaw::path, where the goal is no farther than
// `longest` from where the shoulder starts, L(t) is less by a share k ≤ ½ of
//   d_0 + (d_f - d_0) s(t) - d(t),
// d(t) being the distance of the hand's path from where the shoulder starts and k the most that
// keeps the limb between `shortest` and `longest`. The lengths of the arms that have a goal, and of
// a leg that stands alone, are exactly L(t). Two legs that both stand are a closed chain, in which
// both lengths at once can be given for a pelvis that keeps level only: there L(t) is what lengths
// are drawn to, a metre of difference counting as kLegStiffness rad², and neither leg gets longer
// than `longest`. Each frame takes two steps, the second for what joints on arcs leave the first
// short by.
// Where the problem holds limits, so does this (ReducedLimits). Clavicles of arms with goals go
// with the line from shoulder to hand by PostureLaw, where the problem has it.
//
// Holds its scratch memory: make one per thread. Layer and problem outlive it.
class ReducedRollout {
 public:
  ReducedRollout(const ReducedBody& body, const ReachProblem& problem);

  void run(const Parameters& parameters, ReducedClip& clip);

 private:
  struct Target {
    int link = 0;
    int carrier = -1;  // of a hand: the link with its shoulder
    bool contact = false;
    Vec3d position{};     // m, world
    Mat3d orientation{};  // of a contact's link
    std::vector<int> chain;
    double lag = 0.0;  // m
  };

  void add_hand(int effector);
  void add_planted_foot(const ReducedLimb& leg);
  void set_up(const Parameters& parameters);
  void shorten_by_paths();
  void draw_lengths(int frame, bool first);
  void apply_change();
  void step(int frame, bool first);
  void add_clavicle(const ReducedLimb& limb);
  [[nodiscard]] PostureLaw<double>::Shrug<double> shrugged(int slide, int elevation) const;
  void draw_clavicles();
  void keep_frame(ReducedClip& clip) const;
  void fill_rows();
  void take_off_reference();
  void solve();
  double measure(ReducedClip& clip);

  const ReducedBody* body_;
  const ReachProblem* problem_;
  std::vector<Target> targets_;    // hands in the order of the goals, then planted feet
  std::vector<bool> moves_;        // (limbs) that have a length to keep to
  std::vector<std::size_t> used_;  // dofs that a target's place depends on
  std::size_t rows_ = 0;
  ReducedPlacement placed_;
  std::vector<double> q_;
  std::vector<double> final_lengths_;  // (dofs) m, of slides
  std::vector<double> stretched_;      // (dofs) m, of slides: what they never exceed if drawn
  // (dofs) of slides by LengthLaw::path, (frames) m: by how much they are shorter; else empty
  std::vector<std::vector<double>> shorter_;
  std::vector<bool> given_;  // (dofs) of slides: exactly their length, not drawn to it
  // A clavicle's freedoms, and what they are where its law wants nothing (rad).
  struct Clavicle {
    int slide = 0;  // the arm's
    int elevation = 0;
    int protraction = 0;
    double elevation_start = 0.0;
    double protraction_start = 0.0;
  };
  std::vector<Clavicle> clavicles_;      // of arms with goals
  std::vector<double> force_;            // (dofs) Jᵀλ of the last step
  std::optional<ReducedLimits> limits_;  // where the problem holds them
  std::vector<double> inverse_;          // (dofs)
  std::vector<double> reference_;        // (dofs) what slides are to change by
  std::vector<double> jacobian_;         // (rows × dofs)
  std::vector<double> residual_;         // (rows)
  std::vector<double> change_;           // (dofs)
};

// rad²/m²: what being off its length by a metre costs a leg of two, beside a freedom of weight 1.
inline constexpr double kLegStiffness = 1500.0;

}  // namespace shigusa
