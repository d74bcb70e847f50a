// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <string>

#include "bench_problem.hpp"
#include "count_motions.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "rollout/reach_problem.hpp"

// Loop of a rollout assembled from another library in double precision: 60 steps of weighted
// inverse kinematics along the hand's path, velocities and accelerations by central differences,
// joint torques by the recursive Newton-Euler algorithm in each frame. Left out, in favour of the
// rivals: criteria, the check of feet and path, further steps if hand or foot is off, and the
// floor's share of the second foot.
namespace shigusa::bench {

// Rollout with the library's Engine, which has these members. Vectors and columns are in the
// library's own order of the degrees of freedom.
//
//   Engine(const ReachProblem&)
//   int address(int dof)                      index of the body's dof in that order
//   void place(const VectorXd& q)             forward kinematics
//   Vec3d hand();  Transformd foot()          m, world; sole centre of the foot off the base
//   void hand_rows(double* rows)              (3 × dofs) of the position, row by row
//   void foot_rows(double* position, double* rotation)  (3 × dofs) each
//   void torques(const VectorXd& qd, const VectorXd& qdd, VectorXd& tau)  at the last placement
template <class Engine, int Rows>  // 3: the hand; 9: hand and foot
class Rival {
 public:
  using Vector = Eigen::VectorXd;
  static constexpr double kHandTolerance = 5e-3;    // m
  static constexpr double kFootTolerance = 1e-3;    // m
  static constexpr double kTorqueTolerance = 1e-6;  // N·m

  explicit Rival(const ReachProblem& problem)
      : problem_(problem), engine_(problem), dofs_(problem.body->dof_count()) {
    jacobian_.resize(Rows, dofs_);
    weighted_.resize(Rows, dofs_);
    for (Vector* v : {&start_, &before_, &now_, &next_, &qd_, &qdd_, &tau_}) v->setZero(dofs_);
    start_ = in_order(problem.start().angles);
    for (int frame = 0; frame <= problem.steps; ++frame) {
      path_.push_back(problem.goals[0].path.at(static_cast<double>(frame) / problem.steps));
    }
    engine_.place(start_);
    if constexpr (Rows == 9) planted_ = engine_.foot();
  }

  [[nodiscard]] Vector in_order(std::span<const double> per_dof) const {
    Vector result(dofs_);
    for (int d = 0; d < dofs_; ++d) {
      result[engine_.address(d)] = per_dof[static_cast<std::size_t>(d)];
    }
    return result;
  }

  // Computes one motion.
  void run(const Vector& inverse_weights) {
    const double rate = problem_.steps / problem_.duration;
    before_ = now_ = start_;
    for (int frame = 0; frame <= problem_.steps; ++frame) {
      engine_.place(now_);
      next_ = now_;
      if (frame < problem_.steps) step(path_[static_cast<std::size_t>(frame) + 1], inverse_weights);
      qd_ = (next_ - before_) * (0.5 * rate);
      qdd_ = (next_ - 2.0 * now_ + before_) * (rate * rate);
      engine_.torques(qd_, qdd_, tau_);
      benchmark::DoNotOptimize(tau_.data());
      before_.swap(now_);
      now_.swap(next_);
    }
  }

  // Error of the solution, or empty: checks goal, foot and body weight.
  [[nodiscard]] std::string fault() {
    run(in_order(std::vector<double>(static_cast<std::size_t>(dofs_), 1.0)));
    if (!(norm(engine_.hand() - path_.back()) < kHandTolerance)) return "the hand misses its goal";
    if constexpr (Rows == 9) {
      const double slide = norm(engine_.foot().translation - planted_.translation);
      if (!(slide < kFootTolerance)) return "the foot slides";
    }
    const BodyModel& body = *problem_.body;
    Kinematics<double> kinematics(body);
    forward_kinematics<double>(body, problem_.start().angles, kinematics);
    DynamicsWorkspace<double> work(body);
    const std::vector<double> still(body.dofs().size(), 0.0);
    std::vector<double> tau(still);
    inverse_dynamics<double>(body, kinematics, {still, still}, work, tau);
    engine_.place(start_);
    engine_.torques(Vector::Zero(dofs_), Vector::Zero(dofs_), tau_);
    const double off = (tau_ - in_order(tau)).cwiseAbs().maxCoeff();
    return off < kTorqueTolerance ? "" : "the torques differ";
  }

 private:
  // next = now + A Jᵀ (J A Jᵀ + D)⁻¹ e, as in weighted_ik_step
  void step(const Vec3d& hand, const Vector& inverse_weights) {
    put(0, hand - engine_.hand());
    engine_.hand_rows(jacobian_.data());
    if constexpr (Rows == 9) {
      const Transformd foot = engine_.foot();
      put(3, planted_.translation - foot.translation);
      put(6, rotation_sine(foot.rotation, planted_.rotation) * kContactLength);
      engine_.foot_rows(jacobian_.row(3).data(), jacobian_.row(6).data());
      jacobian_.template bottomRows<3>() *= kContactLength;
    }
    weighted_.noalias() = jacobian_ * inverse_weights.asDiagonal();
    system_.noalias() = weighted_.lazyProduct(jacobian_.transpose());
    const double goal = problem_.ik.damping * system_.diagonal().template head<3>().mean();
    system_.diagonal().template head<3>().array() += goal;
    if constexpr (Rows == 9) {
      const double contact =
          problem_.ik.contact_damping * system_.diagonal().template tail<6>().mean();
      system_.diagonal().template tail<6>().array() += contact;
    }
    factors_.compute(system_);
    residual_ = factors_.solve(residual_);
    next_.noalias() += weighted_.transpose() * residual_;
  }

  void put(int row, const Vec3d& v) {
    residual_.template segment<3>(row) = Eigen::Vector3d(v.x, v.y, v.z);
  }

  using Square = Eigen::Matrix<double, Rows, Rows>;
  const ReachProblem& problem_;
  Engine engine_;
  int dofs_;
  std::vector<Vec3d> path_;  // (frames) m, world
  Transformd planted_;
  Eigen::Matrix<double, Rows, Eigen::Dynamic, Eigen::RowMajor> jacobian_, weighted_;
  Square system_;
  Eigen::LDLT<Square> factors_;
  Eigen::Matrix<double, Rows, 1> residual_;
  Vector start_, before_, now_, next_, qd_, qdd_, tau_;
};

template <class Engine, int Rows>
void measure_rival(benchmark::State& state, const char* character) {
  const Measured measured(character, 32);
  Rival<Engine, Rows> rival(measured.problem);
  const std::string fault = rival.fault();
  if (!fault.empty()) {
    state.SkipWithError(fault.c_str());
    return;
  }
  std::vector<Eigen::VectorXd> weights;
  for (const Parameters& p : measured.parameters) {
    weights.push_back(rival.in_order(inverse_weights(measured.task.body, p)));
  }
  const MotionCounter counter(state);
  for (auto _ : state) {
    for (const Eigen::VectorXd& inverse : weights) rival.run(inverse);
  }
  counter.count(static_cast<double>(weights.size()));
}

template <class Engine>
bool register_rival(const std::string& name) {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark((name + "/half_body").c_str(), measure_rival<Engine, 3>, "half_body");
  RegisterBenchmark((name + "/full_body").c_str(), measure_rival<Engine, 9>, "full_body");
  return true;
}

// The planted foot that is not the base; null if there is none.
inline const Foot* second_foot(const BodyModel& body) {
  for (const Foot& foot : body.feet()) {
    if (foot.link != kBaseLink) return &foot;
  }
  return nullptr;
}

inline const Effector& moved_hand(const ReachProblem& problem) {
  return problem.body->effectors()[static_cast<std::size_t>(problem.goals[0].effector)];
}

}  // namespace shigusa::bench
