// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/weighted_ik.hpp"
#include "nlp/variable_metric.hpp"

namespace shigusa {

struct NlpIkSettings {
  // Weight of the joints' changes relative to the goals, as a share of the mean diagonal of J W⁻¹
  // Jᵀ in the start posture, 1e-9..1.
  double damping = 3e-5;
  // Additional weight at a goal's lag of `lag_scale` (m, > 0); grows with the lag squared. ≥ 0.
  double lag_damping = 0.01;
  double lag_scale = 0.1;
  double limit_approach = 0.2;  // share of the way to a limit for one posture, (0, 1]
  double max_change = 0.25;     // rad, largest change of an angle from one posture to the next, > 0
  // Stiffness of the planted feet relative to the goals', 1..1e4. It affects the convergence of the
  // multipliers, not the feet's final position.
  double contact_stiffness = 10.0;
  // Error of the feet (m, > 0) above which their multipliers are corrected, and the largest number
  // of corrections (0..1000).
  double contact_slack = 2e-5;
  int contact_corrections = 20;
  // Goals have multipliers too while their error is below lead_limit (m, ≥ 0), which are corrected
  // up to this many times (0..1000) while the error is above goal_slack (m, > 0) and decreases
  // enough.
  double lead_limit = 0.05;
  double goal_slack = 1e-4;
  int goal_corrections = 8;
  double max_step = 0.25;   // rad, largest change of an angle in one iteration, > 0
  double tolerance = 1e-7;  // rad, smaller steps are not taken, > 0
  int iterations = 200;     // of the variable metric method, between corrections, 1..100000
};

struct NlpIkOutcome {
  // false: an iteration limit was reached, rounding allowed no more descent, or feet did not stand
  bool converged = true;
  int evaluations = 0;  // of the objective and its gradient
};

// Inverse kinematics by nonlinear programming: one posture of a motion is
//
//   min  ½ Σ_goals |p_g - x_g(q)|² + ½ ε Σ w_i (q_i - q_i,from - Δq_ref,i)²,
//   plus ½ |kContactLength · angle|² for each goal with an orientation,
//   s.t. planted feet stand, joints keep their limits,
//
// the same sum as weighted_ik_step's, but with the true kinematics instead of linear ones, and
// solved to its minimum. The shorter the path between two postures, the more both take the same
// step.
//
//   J, W, ε := Jacobian, the weights' diagonal, damping · mean diagonal of J W⁻¹ Jᵀ at the start
//   z := √w_i (q_i - q_i,from), initially the last posture's
//   H := (ε I + W^-½ Jᵀ J W^-½)⁻¹, Gauss and Newton's
//   until feet stand within contact_slack, and goals are within goal_slack or out of reach:
//     minimise over z by VariableMetric, from H and the active limits of the last posture
//     leads += remaining errors of the targets; stiffen contacts if that helps too little
//
// Limits are linear inequalities: lower ≤ q ≤ upper, and for a coupled limit also q - gain /
// driver_full · q_driver ≤ upper and q ≤ upper + gain. One posture covers only a share of the
// distance to them, so that joints come to rest there without a jolt. Feet are equality constraints
// by an augmented Lagrangian, ½ κ |c|² + κ cᵀ l, with the multipliers l in the targets' leads (m,
// rad) and c a foot's displacement and kContactLength times its tilt; goals that are nearly met
// have multipliers too, or ε would leave a small error. They carry over from posture to posture,
// where they change little, so one minimisation is usually enough. If the feet cannot be made to
// stand, the posture stays unchanged. The gradient is computed in one sweep along the chain from
// the hands to the base, which accumulates forces and their moments.
//
// Source: J. Zhao and N. Badler, ACM Trans. Graphics 13 (1994) 313-336. Multipliers as shifts of
// the constraints: M. Powell, in Optimization, R. Fletcher (ed.), 1969. Share of the distance: B.
// Faverjon and P. Tournassoud, IEEE Int. Conf. Robotics and Automation (1987) 1152-1159. Left out:
// goals of half spaces, which do not occur in these reaches.
class NlpIk : private SmoothFunction {
 public:
  // Settings outside their ranges throw PreconditionError, as does a body of more than
  // kMaxMetricVariables dofs or with a coupling that lowers a limit. The body outlives the object.
  NlpIk(const BodyModel& body, State start, const NlpIkSettings& settings = {});

  // Begins a motion. inverse_weights (dofs): as for weighted_ik_step; only their ratios matter.
  // `targets` are the motion's, for the scale of the goals. Limits are widened to the start
  // posture.
  void begin(std::span<const Constraint<double>> targets, std::span<const double> inverse_weights);

  // Sets other weights from the next posture on, as begin() takes them; the motion continues.
  void weigh(std::span<const Constraint<double>> targets, std::span<const double> inverse_weights);

  // Solves for the next posture after `from` (dofs, rad; within the limits), and writes it to `to`.
  // The targets' leads, 0 before a motion's first posture, are the multipliers, which are corrected
  // here. reference: (dofs, rad) or empty. Afterwards kinematics() is the placement in `to`.
  NlpIkOutcome solve(std::span<Constraint<double>> targets, std::span<const double> from,
                     std::span<const double> reference, std::span<double> to);

  // The objective at the angles `at` (dofs, rad), as minimised by solve() with these arguments, and
  // its gradient per radian (dofs).
  double objective(std::span<const Constraint<double>> targets, std::span<const double> from,
                   std::span<const double> reference, std::span<const double> at,
                   std::span<double> gradient);

  [[nodiscard]] const Kinematics<double>& kinematics() const { return kinematics_; }

 private:
  // A joint limit, in radians: angle[dof] - gain · angle[driver] ≤ bound, or -angle[dof] ≤ bound.
  struct AngleLimit {
    int dof = 0;
    double sign = 1.0;
    int driver = 0;
    double gain = 0.0;
    double bound = 0.0;
  };
  // Load of the targets on a link: a force (in N, for example) and its moment about the world's
  // origin.
  struct Load {
    Vec3d force{};
    Vec3d moment{};
  };

  // Errors of the targets (m), a tilt as kContactLength times itself.
  struct Misses {
    double goal = 0.0;
    double contact = 0.0;
  };

  double evaluate(std::span<const double> z, std::span<double> gradient) override;
  void add_limits();
  void measure_goals(std::span<const Constraint<double>> targets);
  void scale_limits();
  double load_links();
  double pull_contact(const Constraint<double>& target, const Vec3d& at);
  void unload_links(std::span<double> gradient);
  void bind(std::span<const Constraint<double>> targets, std::span<const double> from,
            std::span<const double> reference);
  void set_bounds();
  void set_curvature();
  void minimise(NlpIkOutcome& outcome);
  void place(std::span<double> to);
  void stand_still(std::span<Constraint<double>> targets, std::span<double> to,
                   NlpIkOutcome& outcome);
  void stiffen(std::span<Constraint<double>> targets);
  template <class Column>
  void add_rows(int link, double scale, Column&& column);
  [[nodiscard]] double damping(std::span<const Constraint<double>> targets) const;
  [[nodiscard]] Misses correct_leads(std::span<Constraint<double>> targets) const;

  const BodyModel* body_;
  State start_;
  NlpIkSettings settings_;
  VariableMetric metric_;
  Kinematics<double> kinematics_;
  std::vector<AngleLimit> angle_limits_;
  std::vector<LinearLimit> limits_;    // those that the unlocked dofs can reach
  std::vector<std::size_t> limit_of_;  // index of each in angle_limits_
  std::vector<double> limit_scale_;    // radians per unit of each
  std::vector<double> size_;           // (dofs) √(1 / w_i), the largest being 1: radians per z
  std::vector<double> z_;              // (dofs) (q - from) / size
  std::vector<double> reference_;      // (dofs) the reference, in the unit of z
  std::vector<double> angles_;         // (dofs, rad)
  std::vector<Load> loads_;            // (dofs)
  std::vector<double> rows_;           // (rows × dofs) m, of the scaled Jacobian
  double mean_diagonal_ = 0.0;         // m², of J W⁻¹ Jᵀ in the start posture
  double stiffness_ = 1.0;             // of the contacts relative to the goals
  double epsilon_ = 0.0;               // m², of the present posture
  std::span<const Constraint<double>> targets_;  // arguments of the present posture
  std::span<const double> from_;
};

}  // namespace shigusa
