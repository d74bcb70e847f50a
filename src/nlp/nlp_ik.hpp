// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/weighted_ik.hpp"
#include "nlp/variable_metric.hpp"

namespace shigusa {

struct NlpIkSettings {
  // How much the joints' reluctance to move counts beside the goals, as a share of the mean
  // diagonal of J W⁻¹ Jᵀ in the start posture, 1e-9..1 …
  double damping = 3e-5;
  // … and what is added where a goal lags behind by `lag_scale` (m, > 0); grows with the lag
  // squared. ≥ 0
  double lag_damping = 0.01;
  double lag_scale = 0.1;
  double limit_approach = 0.2;  // share of the room to a limit that one posture may take, (0, 1]
  double max_change = 0.25;     // rad, no angle changes by more from one posture to the next, > 0
  // Stiffness of the planted feet beside the goals', 1..1e4. It decides how fast the multipliers
  // come right, not where the feet end up.
  double contact_stiffness = 10.0;
  // Feet that are off by more than contact_slack (m, > 0) have their multipliers corrected, up to
  // so often (0..1000).
  double contact_slack = 2e-5;
  int contact_corrections = 20;
  // Goals have multipliers too while they are missed by less than lead_limit (m, ≥ 0), and these
  // are corrected up to so often (0..1000) while a goal is missed by more than goal_slack (m, > 0)
  // and that helps.
  double lead_limit = 0.05;
  double goal_slack = 1e-4;
  int goal_corrections = 8;
  double max_step = 0.25;   // rad, no angle changes by more in one iteration, > 0
  double tolerance = 1e-7;  // rad, steps smaller than this are not taken, > 0
  int iterations = 200;     // of the variable metric method, between corrections, 1..100000
};

struct NlpIkOutcome {
  // false: an iteration limit was met, rounding allowed no more descent, or feet would not stand
  bool converged = true;
  int evaluations = 0;  // of the objective and its gradient
};

// Inverse kinematics by nonlinear programming: one posture of a motion is
//
//   min  ½ Σ_goals |p_g - x_g(q)|² + ½ ε Σ w_i (q_i - q_i,from - Δq_ref,i)²,
//   and ½ |kContactLength · angle|² of each goal that turns,
//   s.t. planted feet stand, joints keep their limits,
//
// the same sum as weighted_ik_step's, but with the kinematics as they are instead of linear ones,
// and solved until it is least. The shorter the path between two postures, the more both
// take the same step.
//
//   J, W, ε := Jacobian, the weights' diagonal, damping · mean diagonal of J W⁻¹ Jᵀ at the start
//   z := √w_i (q_i - q_i,from), guessed to be the last posture's
//   H := (ε I + W^-½ Jᵀ J W^-½)⁻¹, Gauss and Newton's
//   until feet stand within contact_slack, and goals are met within goal_slack or will not be:
//     minimise over z by VariableMetric, from H and the active limits of the last posture
//     leads += what the targets are still off by; stiffen contacts where that helps too little
//
// Limits are linear inequalities: lower ≤ q ≤ upper, and for a coupled limit also
// q - gain / driver_full · q_driver ≤ upper and q ≤ upper + gain. One posture takes a share of the
// room to them only, so that joints come to rest there and not with a jolt. Feet are equality
// constraints by an augmented Lagrangian, ½ κ |c|² + κ cᵀ l, with the multipliers l in the targets'
// leads (m, rad) and c a foot's displacement and kContactLength times its tilt; goals that are
// nearly met have multipliers too, or ε would leave a little of their way. They stay from posture
// to posture, where they change little, so mostly one minimisation is enough. Where nothing makes a
// foot stand, the posture stays what it was. The gradient comes from the chain in one sweep from
// the hands to the base, which adds up forces and their moments.
//
// Source: J. Zhao and N. Badler, ACM Trans. Graphics 13 (1994) 313-336. Multipliers as shifts of
// the constraints: M. Powell, in Optimization, R. Fletcher (ed.), 1969. A share of the room: B.
// Faverjon and P. Tournassoud, IEEE Int. Conf. Robotics and Automation (1987) 1152-1159. Left out:
// goals of half spaces, which the project's reaches do not have.
class NlpIk : private SmoothFunction {
 public:
  // Settings outside their ranges throw PreconditionError, as does a body of more than
  // kMaxMetricVariables dofs or with a coupling that lowers a limit. The body outlives this.
  explicit NlpIk(const BodyModel& body, const NlpIkSettings& settings = {});

  // Before a motion's first posture. inverse_weights (dofs): as for weighted_ik_step; only their
  // ratios matter. `targets` are the motion's, for the scale of the goals. The limits let the start
  // posture be.
  void begin(std::span<const IkTarget<double>> targets, std::span<const double> inverse_weights);

  // Other weights from the next posture on, as begin() takes them; the motion goes on.
  void weigh(std::span<const IkTarget<double>> targets, std::span<const double> inverse_weights);

  // The next posture after `from` (dofs, rad; within the limits), written to `to`. The targets'
  // leads, 0 before a motion's first posture, are the multipliers, which are corrected here.
  // reference: (dofs, rad) or empty. Afterwards kinematics() is the placement in `to`.
  NlpIkOutcome solve(std::span<IkTarget<double>> targets, std::span<const double> from,
                     std::span<const double> reference, std::span<double> to);

  // The objective at the angles `at` (dofs, rad), as solve() with these arguments minimises it, and
  // its gradient per radian (dofs).
  double objective(std::span<const IkTarget<double>> targets, std::span<const double> from,
                   std::span<const double> reference, std::span<const double> at,
                   std::span<double> gradient);

  [[nodiscard]] const Kinematics<double>& kinematics() const { return kinematics_; }

 private:
  // a joint limit, in radians: angle[dof] - gain · angle[driver] ≤ bound, or -angle[dof] ≤ bound
  struct AngleLimit {
    int dof = 0;
    double sign = 1.0;
    int driver = 0;
    double gain = 0.0;
    double bound = 0.0;
  };
  // what the targets do to a link: a force (N, say) and its moment about the world's origin
  struct Load {
    Vec3d force{};
    Vec3d moment{};
  };

  // how far targets are off (m), a tilt as kContactLength times itself
  struct Misses {
    double goal = 0.0;
    double contact = 0.0;
  };

  double evaluate(std::span<const double> z, std::span<double> gradient) override;
  void add_limits();
  void measure_goals(std::span<const IkTarget<double>> targets);
  void scale_limits();
  double load_links();
  double pull_contact(const IkTarget<double>& target, const Vec3d& at);
  void unload_links(std::span<double> gradient);
  void bind(std::span<const IkTarget<double>> targets, std::span<const double> from,
            std::span<const double> reference);
  void set_bounds();
  void set_curvature();
  void minimise(NlpIkOutcome& outcome);
  void place(std::span<double> to);
  void stand_still(std::span<IkTarget<double>> targets, std::span<double> to,
                   NlpIkOutcome& outcome);
  void stiffen(std::span<IkTarget<double>> targets);
  template <class Column>
  void add_rows(int link, double scale, Column&& column);
  [[nodiscard]] double damping(std::span<const IkTarget<double>> targets) const;
  [[nodiscard]] Misses correct_leads(std::span<IkTarget<double>> targets) const;

  const BodyModel* body_;
  NlpIkSettings settings_;
  VariableMetric metric_;
  Kinematics<double> kinematics_;
  std::vector<AngleLimit> angle_limits_;
  std::vector<LinearLimit> limits_;    // of those, what the unlocked dofs can meet
  std::vector<std::size_t> limit_of_;  // … and which each is
  std::vector<double> limit_scale_;    // … and how many radians one unit of it is
  std::vector<double> size_;           // (dofs) √(1 / w_i), the largest being 1: radians per z
  std::vector<double> z_;              // (dofs) (q - from) / size
  std::vector<double> reference_;      // (dofs) the reference, in the unit of z
  std::vector<double> angles_;         // (dofs, rad)
  std::vector<Load> loads_;            // (dofs)
  std::vector<double> rows_;           // (rows × dofs) m, of the scaled Jacobian
  double mean_diagonal_ = 0.0;         // m², of J W⁻¹ Jᵀ in the start posture
  double stiffness_ = 1.0;             // of the contacts beside the goals
  double epsilon_ = 0.0;               // m², of the posture being solved for
  std::span<const IkTarget<double>> targets_;  // … and its arguments
  std::span<const double> from_;
};

}  // namespace shigusa
