// SPDX-License-Identifier: MIT
#include "kinematics/weighted_ik.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainiksolvervel_wdls.hpp>

#include "rollout/reach_problem.hpp"
#include "support/bodies.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Targets = std::vector<Constraint<double>>;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// Goals are to be met exactly and no step is cut short.
const IkSettings kExact{
    .damping = 0.0, .lag_damping = 0.0, .contact_damping = 0.0, .max_step = 1e3};

struct Step {
  std::vector<double> q{};
  Targets targets{};
  std::vector<double> inverse_weights{};
  std::vector<double> reference{};  // or empty
  IkSettings settings = kExact;
};

Vector shigusas_step(const PosedBody& posed, const Step& step) {
  IkWorkspace<double> workspace(posed);
  const auto dq = weighted_ik_step<double>(posed, placed(posed, step.q),
                                           {step.targets, step.inverse_weights, step.reference},
                                           step.settings, workspace);
  return Eigen::Map<const Vector>(dq.data(), static_cast<Eigen::Index>(dq.size()));
}

// (dofs) 1 / w, with w uniform in its logarithm
std::vector<double> random_inverse_weights(const PosedBody& posed, Random& random) {
  std::vector<double> inverse;
  for (int d = 0; d < posed.body.dof_count(); ++d)
    inverse.push_back(std::exp(random.uniform(-2.5, 2.5)));
  return inverse;
}

// An effector's goal up to 10 cm from its position.
Constraint<double> random_goal(const Kinematics<double>& kinematics, const Effector& effector,
                               Random& random) {
  const Vec3d away{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
  return {.link = effector.link,
          .point = effector.point,
          .place = kinematics.point(effector.link, effector.point) + away};
}

// The chain from the standing foot to a hand for Orocos KDL.
KDL::Chain kdl_chain(const PosedBody& posed, const Effector& effector) {
  const auto vector = [](const Vec3d& v) { return KDL::Vector(v.x, v.y, v.z); };
  const Mat3d& r = posed.body.base().rotation;
  const KDL::Rotation base(vector(r.cx), vector(r.cy), vector(r.cz));
  KDL::Chain chain;
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    if (!posed.body.moves(d, effector.link)) continue;
    const Dof& dof = posed.body.dof(d);
    if (chain.getNrOfSegments() == 0) {
      const KDL::Frame frame(base,
                             vector(posed.body.base().translation) + base * vector(dof.offset));
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame));
    }
    // a segment's joint comes first and its frame, the way to the next joint, second
    const bool last = d == effector.link;
    int next = d + 1;
    while (!last && !posed.body.moves(next, effector.link)) ++next;
    const Vec3d tip = last ? effector.point : posed.body.dof(next).offset;
    const auto type =
        static_cast<KDL::Joint::JointType>(KDL::Joint::RotX + static_cast<int>(dof.axis));
    chain.addSegment(KDL::Segment(KDL::Joint(dof.name, type, dof.sign), KDL::Frame(vector(tip))));
  }
  return chain;
}

TEST(WeightedIkAgainstKdl, OneHandTakesTheSameStep) {
  const PosedBody posed = half_body();
  const Effector& hand = posed.body.effectors()[0];
  const KDL::Chain chain = kdl_chain(posed, hand);
  ASSERT_EQ(static_cast<int>(chain.getNrOfJoints()), posed.body.dof_count());
  KDL::ChainIkSolverVel_wdls solver(chain, 1e-12, 500);
  solver.setLambda(1e-9);
  // the hand's position counts, its orientation does not
  Matrix task = Matrix::Zero(6, 6);
  task.topLeftCorner(3, 3).setIdentity();
  solver.setWeightTS(task);
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    Step step{.q = random_posture(posed, random)};
    const Kinematics<double> kinematics = placed(posed, step.q);
    step.targets = {random_goal(kinematics, hand, random)};
    step.inverse_weights = random_inverse_weights(posed, random);
    // KDL minimises |M⁻¹ Δq|²
    Matrix m = Matrix::Zero(posed.body.dof_count(), posed.body.dof_count());
    KDL::JntArray q(chain.getNrOfJoints());
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      m(d, d) = std::sqrt(step.inverse_weights[static_cast<std::size_t>(d)]);
      q(static_cast<unsigned>(d)) = step.q[static_cast<std::size_t>(d)];
    }
    solver.setWeightJS(m);
    const Vec3d way = step.targets[0].place - kinematics.point(hand.link, hand.point);
    KDL::JntArray expected(chain.getNrOfJoints());
    solver.CartToJnt(q, KDL::Twist(KDL::Vector(way.x, way.y, way.z), KDL::Vector::Zero()),
                     expected);
    ASSERT_LT((shigusas_step(posed, step) - expected.data).norm(), 1e-9 * expected.data.norm());
  }
}

// The wanted step as the solution of its optimality conditions, all at once:
//
//   min Σ w_i (Δq_i - Δq_ref,i)² + Σ |J_g Δq - e_g|² / d_g   s.t.  J_c Δq = e_c, locked Δq = 0
//
// with the goals' damping d_g = share · mean diagonal of J_g W⁻¹ J_gᵀ.
class KktSystem {
 public:
  KktSystem(const PosedBody& posed, const Step& step) : body_(posed), step_(step) {
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      if (step.inverse_weights[static_cast<std::size_t>(d)] > 0.0) free_.push_back(d);
    }
    const auto n = static_cast<Eigen::Index>(free_.size());
    hessian_ = Matrix::Zero(n, n);
    gradient_ = Vector::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto d = static_cast<std::size_t>(free_[static_cast<std::size_t>(i)]);
      hessian_(i, i) = 1.0 / step.inverse_weights[d];
      if (!step.reference.empty()) gradient_(i) = hessian_(i, i) * step.reference[d];
    }
    const Kinematics<double> kinematics = placed(posed, step.q);
    for (const Constraint<double>& target : step.targets) add_target(kinematics, target);
  }

  // (dofs)
  [[nodiscard]] Vector solution() const {
    const Eigen::Index n = hessian_.rows();
    const Eigen::Index m = rows_.rows();
    Matrix kkt = Matrix::Zero(n + m, n + m);
    kkt.topLeftCorner(n, n) = hessian_;
    kkt.topRightCorner(n, m) = rows_.transpose();
    kkt.bottomLeftCorner(m, n) = rows_;
    Vector right(n + m);
    right << gradient_, residual_;
    const Vector solved = kkt.fullPivLu().solve(right);
    Vector dq = Vector::Zero(body_.body.dof_count());
    for (Eigen::Index i = 0; i < n; ++i) dq(free_[static_cast<std::size_t>(i)]) = solved(i);
    return dq;
  }

 private:
  void add_target(const Kinematics<double>& kinematics, const Constraint<double>& target) {
    const Eigen::Index count = target.exact ? 6 : 3;
    const auto n = static_cast<Eigen::Index>(free_.size());
    const Vec3d at = kinematics.point(target.link, target.point);
    const Vec3d error = target.place - at;
    Matrix j = Matrix::Zero(count, n);
    Vector e = Vector::Zero(count);
    for (int k = 0; k < 3; ++k) e(k) = error[k];
    if (target.exact) {
      const Vec3d tilt = rotation_sine(kinematics.link_rotation(target.link), target.orientation);
      for (int k = 0; k < 3; ++k) e(3 + k) = kContactLength * tilt[k];
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      const int d = free_[static_cast<std::size_t>(i)];
      if (!body_.body.moves(d, target.link)) continue;
      const auto index = static_cast<std::size_t>(d);
      const Vec3d arm = at - kinematics.origin[index];
      const Vec3d v = cross(kinematics.axis[index], arm);
      for (int k = 0; k < 3; ++k) {
        j(k, i) = v[k];
        if (target.exact) j(3 + k, i) = kContactLength * kinematics.axis[index][k];
      }
    }
    const double ratio = target.lag / step_.settings.lag_scale;
    const double share = step_.settings.damping + step_.settings.lag_damping * ratio * ratio;
    if (target.exact || share == 0.0) return add_constraint(j, e);
    double trace = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto d = static_cast<std::size_t>(free_[static_cast<std::size_t>(i)]);
      trace += step_.inverse_weights[d] * j.col(i).squaredNorm();
    }
    const double damping = share * trace / 3.0;
    hessian_ += j.transpose() * j / damping;
    gradient_ += j.transpose() * e / damping;
  }

  void add_constraint(const Matrix& j, const Vector& e) {
    rows_.conservativeResize(rows_.rows() + j.rows(), j.cols());
    rows_.bottomRows(j.rows()) = j;
    residual_.conservativeResize(residual_.size() + e.size());
    residual_.tail(e.size()) = e;
  }

  const PosedBody& body_;
  const Step& step_;
  std::vector<int> free_;
  Matrix hessian_;
  Vector gradient_;
  Matrix rows_{0, 0};
  Vector residual_{0};
};

// Goals for both hands, and the second foot held at its place, from a posture near the start that
// has moved the foot slightly.
Step both_hands_and_foot(const PosedBody& posed, Random& random) {
  Step step{.q = {posed.home.angles.begin(), posed.home.angles.end()}};
  for (double& angle : step.q) angle += random.uniform(-0.3, 0.3);
  const Kinematics<double> kinematics = placed(posed, step.q);
  for (const Effector& effector : posed.body.effectors()) {
    step.targets.push_back(random_goal(kinematics, effector, random));
  }
  const Foot& foot = posed.body.feet()[1];
  const Kinematics<double> start = placed(posed, posed.home.angles);
  step.targets.push_back({.link = foot.link,
                          .point = foot.centre,
                          .place = start.point(foot.link, foot.centre),
                          .exact = true,
                          .turning = Turning::whole,
                          .orientation = start.link_rotation(foot.link)});
  step.inverse_weights = random_inverse_weights(posed, random);
  return step;
}

// Runs 200 random steps, each changed by change(step, random), against the KKT system. J A Jᵀ
// squares the condition number of J, which costs up to six of a double's sixteen digits here.
template <class Change>
void compare_with_kkt(Change change) {
  const PosedBody posed = full_body();
  Random random(22);
  for (int trial = 0; trial < 200; ++trial) {
    Step step = both_hands_and_foot(posed, random);
    change(step, random);
    const Vector expected = KktSystem(posed, step).solution();
    const Vector seen = shigusas_step(posed, step);
    ASSERT_LT((seen - expected).norm(), 1e-9 * (1.0 + expected.norm())) << trial;
  }
}

TEST(WeightedIkAgainstKkt, MeetsGoalsAndContactsAtTheLeastCost) {
  compare_with_kkt([](Step&, Random&) {});
}

TEST(WeightedIkAgainstKkt, StaysNearTheReference) {
  compare_with_kkt([](Step& step, Random& random) {
    for (std::size_t d = 0; d < step.q.size(); ++d) {
      step.reference.push_back(random.uniform(-0.5, 0.5));
    }
  });
}

TEST(WeightedIkAgainstKkt, DoesWithoutLockedJoints) {
  compare_with_kkt([](Step& step, Random& random) {
    // one of each arm's four: the legs have none to spare
    step.inverse_weights[5 + random.below(4)] = 0.0;
    step.inverse_weights[9 + random.below(4)] = 0.0;
    for (std::size_t d = 0; d < step.q.size(); ++d) {
      step.reference.push_back(random.uniform(-0.5, 0.5));
    }
  });
}

TEST(WeightedIkAgainstKkt, DampedGoalsGiveWayAndContactsDoNot) {
  compare_with_kkt(
      [](Step& step, Random& random) { step.settings.damping = random.uniform(0.01, 1.0); });
}

TEST(WeightedIkAgainstKkt, DampingGrowsWithTheSquareOfTheLag) {
  compare_with_kkt([](Step& step, Random& random) {
    step.settings.damping = 0.01;
    step.settings.lag_damping = 2.0;
    step.settings.lag_scale = 0.2;
    for (Constraint<double>& target : step.targets) target.lag = random.uniform(0.0, 0.5);
  });
}

}  // namespace
}  // namespace shigusa
