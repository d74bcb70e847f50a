// SPDX-License-Identifier: MIT
// Loop of a rollout, assembled from MuJoCo.
#include "rival.hpp"
#include "support/mujoco_body.hpp"

namespace shigusa::bench {
namespace {

class MujocoEngine {
 public:
  explicit MujocoEngine(const ReachProblem& problem)
      : body_(*problem.body), hand_(moved_hand(problem)), foot_(second_foot(*problem.body)) {}

  [[nodiscard]] int address(int dof) const { return body_.address(static_cast<std::size_t>(dof)); }

  void place(const Eigen::VectorXd& q) {
    mju_copy(body_.data()->qpos, q.data(), model()->nq);
    mj_kinematics(model(), body_.data());
    mj_comPos(model(), body_.data());
  }

  [[nodiscard]] Vec3d hand() const { return body_.frame(hand_.link) * hand_.point; }
  [[nodiscard]] Transformd foot() const {
    const Transformd frame = body_.frame(foot_->link);
    return {frame.rotation, frame * foot_->centre};
  }

  void hand_rows(double* rows) const { fill(rows, nullptr, hand(), hand_.link); }
  void foot_rows(double* position, double* rotation) const {
    fill(position, rotation, foot().translation, foot_->link);
  }

  void torques(const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd, Eigen::VectorXd& tau) {
    mju_copy(body_.data()->qvel, qd.data(), model()->nv);
    mju_copy(body_.data()->qacc, qdd.data(), model()->nv);
    mj_comVel(model(), body_.data());
    mj_rne(model(), body_.data(), 1, tau.data());
  }

 private:
  [[nodiscard]] const mjModel* model() const { return body_.model(); }

  void fill(double* position, double* rotation, const Vec3d& at, int link) const {
    const double point[3] = {at.x, at.y, at.z};
    mj_jac(model(), body_.data(), position, rotation, point, body_.body_of(link));
  }

  testing_support::MujocoBody body_;
  const Effector& hand_;
  const Foot* foot_;
};

const bool kRegistered = register_rival<MujocoEngine>("rival/mujoco");

}  // namespace
}  // namespace shigusa::bench
