// SPDX-License-Identifier: MIT
// Loop of a rollout, assembled from Orocos KDL.
#include <kdl/tree.hpp>
#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl/treejnttojacsolver.hpp>

#include "rival.hpp"

namespace shigusa::bench {
namespace {

KDL::Vector vector(const Vec3d& v) { return {v.x, v.y, v.z}; }
Vec3d vector(const KDL::Vector& v) { return {v.x(), v.y(), v.z()}; }

KDL::RigidBodyInertia inertia(const MassProperties& m) {
  const Mat3d& i = m.inertia;
  return KDL::RigidBodyInertia(
      m.mass, vector(m.com),
      KDL::RotationalInertia(i.cx.x, i.cy.y, i.cz.z, i.cy.x, i.cz.x, i.cz.y));
}

// A segment per dof, and a massless one at each tracked point. KDL often looks segments up by name,
// so the names are short.
KDL::Tree make_tree(const ReachProblem& problem) {
  const BodyModel& body = *problem.body;
  const auto link_name = [&](int link) {
    return link == kBaseLink ? std::string("base") : std::to_string(link);
  };
  KDL::Tree tree("root");
  const Mat3d& r = body.base().rotation;
  const KDL::Rotation turned(vector(r.cx), vector(r.cy), vector(r.cz));
  tree.addSegment(KDL::Segment("base", KDL::Joint("base", KDL::Joint::Fixed),
                               KDL::Frame(turned, vector(body.base().translation))),
                  "root");
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    const KDL::Vector axis(dof.axis == Axis::x ? dof.sign : 0, dof.axis == Axis::y ? dof.sign : 0,
                           dof.axis == Axis::z ? dof.sign : 0);
    const KDL::Vector centre = vector(dof.offset);
    const KDL::Joint joint(link_name(d), centre, axis, KDL::Joint::RotAxis);
    tree.addSegment(
        KDL::Segment(link_name(d), joint, KDL::Frame(centre), inertia(body.link_mass(d))),
        link_name(dof.parent));
  }
  const auto add_point = [&](const std::string& name, int link, const Vec3d& point) {
    tree.addSegment(
        KDL::Segment(name, KDL::Joint(name, KDL::Joint::Fixed), KDL::Frame(vector(point))),
        link_name(link));
  };
  const Effector& hand = moved_hand(problem);
  add_point("hand", hand.link, hand.point);
  if (const Foot* foot = second_foot(body)) add_point("foot", foot->link, foot->centre);
  return tree;
}

class KdlEngine {
 public:
  explicit KdlEngine(const ReachProblem& problem)
      : tree_(make_tree(problem)),
        has_foot_(second_foot(*problem.body) != nullptr),
        dofs_(tree_.getNrOfJoints()),
        positions_(tree_),
        jacobians_(tree_),
        dynamics_(tree_, {0, -kGravity, 0}),
        q_(dofs_),
        qd_(dofs_),
        qdd_(dofs_),
        tau_(dofs_),
        jacobian_(dofs_) {
    for (int d = 0; d < problem.body->dof_count(); ++d) {
      addresses_.push_back(static_cast<int>(tree_.getSegment(std::to_string(d))->second.q_nr));
    }
  }

  [[nodiscard]] int address(int dof) const { return addresses_[static_cast<std::size_t>(dof)]; }

  void place(const Eigen::VectorXd& q) {
    q_.data = q;
    positions_.JntToCart(q_, hand_frame_, kHand);
    if (has_foot_) positions_.JntToCart(q_, foot_frame_, kFoot);
  }

  [[nodiscard]] Vec3d hand() const { return vector(hand_frame_.p); }
  [[nodiscard]] Transformd foot() const {
    const KDL::Rotation& r = foot_frame_.M;
    return {{vector(r.UnitX()), vector(r.UnitY()), vector(r.UnitZ())}, vector(foot_frame_.p)};
  }

  void hand_rows(double* rows) {
    jacobians_.JntToJac(q_, jacobian_, kHand);
    rows_at(rows) = jacobian_.data.topRows<3>();
  }
  void foot_rows(double* position, double* rotation) {
    jacobians_.JntToJac(q_, jacobian_, kFoot);
    rows_at(position) = jacobian_.data.topRows<3>();
    rows_at(rotation) = jacobian_.data.bottomRows<3>();
  }

  void torques(const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd, Eigen::VectorXd& tau) {
    qd_.data = qd;
    qdd_.data = qdd;
    dynamics_.CartToJnt(q_, qd_, qdd_, no_forces_, tau_);
    tau = tau_.data;
  }

 private:
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  [[nodiscard]] Eigen::Map<Rows> rows_at(double* rows) const { return {rows, 3, dofs_}; }

  static inline const std::string kHand = "hand";
  static inline const std::string kFoot = "foot";
  KDL::Tree tree_;
  bool has_foot_;
  unsigned dofs_;
  KDL::TreeFkSolverPos_recursive positions_;
  KDL::TreeJntToJacSolver jacobians_;
  KDL::TreeIdSolver_RNE dynamics_;
  const KDL::WrenchMap no_forces_;
  KDL::JntArray q_, qd_, qdd_, tau_;
  KDL::Jacobian jacobian_;
  KDL::Frame hand_frame_, foot_frame_;
  std::vector<int> addresses_;  // (dofs)
};

const bool kRegistered = register_rival<KdlEngine>("rival/kdl");

}  // namespace
}  // namespace shigusa::bench
