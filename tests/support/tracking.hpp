// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/generate.hpp>
#include <string>
#include <vector>

#include "dynamics/centre_of_mass.hpp"
#include "dynamics/contact_forces.hpp"
#include "support/bodies.hpp"
#include "support/mujoco_body.hpp"

// Motions played by MuJoCo's forward simulation: a body on its two feet on a floor with friction,
// moved by the computed torques and a weak PD controller, without any other balance. A stiffer
// controller falls more often, as it moves the feet along.
namespace shigusa::testing_support {

inline constexpr double kHold = 1.0;  // s that the last posture is held
inline constexpr double kFallen =
    0.15;  // m that the centre of mass is off from where it was planned
inline constexpr double kArmature =
    0.01;  // kg m², without which joints without muscles would shake

inline constexpr double kFullStrength =
    radians(20.0);                       // a joint off by this uses all of its strength
inline constexpr double kDamping = 0.1;  // s, of speed beside angle

class Tracking {
 public:
  // `beside`, `constraints`: see MjcfWriter.
  explicit Tracking(const PosedBody& posed, const std::string& beside = {},
                    const std::string& constraints = {})
      : body_(posed), mujoco_(posed, MujocoBase::on_the_floor, beside, constraints) {
    for (int d = 0; d < posed.body.dof_count(); ++d) {
      const auto k = static_cast<std::size_t>(d);
      const Dof& dof = posed.body.dof(d);
      stiffness_.push_back(max(dof.torque_positive, dof.torque_negative) / kFullStrength);
      mujoco_.model()->dof_armature[mujoco_.address(k)] = kArmature;
      // MuJoCo integrates this part implicitly
      mujoco_.model()->dof_damping[mujoco_.address(k)] = kDamping * stiffness_.back();
    }
  }

  // The largest distance (m) of the centre of mass from the planned one until the end of a hold
  // (s). `before_step`: called with the time (s).
  double run(const Motion& motion, const std::function<void(double)>& before_step = {},
             double hold = kHold) {
    mj_resetData(model(), data());
    const Clip& clip = motion.clip;
    const double duration = clip.frame_time * (clip.frames - 1);
    const std::vector<double> still = held_torques(clip.frame(clip.frames - 1));
    const auto dofs = static_cast<std::size_t>(clip.dofs);
    for (std::size_t d = 0; d < dofs; ++d) data()->qpos[mujoco_.place(d)] = clip.frame(0)[d];
    double most = 0.0;
    std::vector<double> q(dofs);
    for (double t = 0.0; t < duration + hold; t += kMujocoStep) {
      const double at = t / clip.frame_time;
      const int frame = static_cast<int>(min(at, clip.frames - 2.0));
      const double share = min(at - frame, 1.0);
      const bool moves = t < duration;
      for (std::size_t d = 0; d < dofs; ++d) {
        const double before = clip.frame(frame)[d];
        const double after = clip.frame(frame + 1)[d];
        q[d] = before + (after - before) * share;
        const double speed = moves ? (after - before) / clip.frame_time : 0.0;
        const std::size_t i = static_cast<std::size_t>(frame) * dofs + d;
        const double planned =
            moves ? motion.torques[i] + (motion.torques[i + dofs] - motion.torques[i]) * share
                  : still[d];
        const double off = q[d] - data()->qpos[mujoco_.place(d)];
        data()->qfrc_applied[mujoco_.address(d)] =
            planned + stiffness_[d] * (off + kDamping * speed);
      }
      if (before_step) before_step(t);
      mj_step(model(), data());
      const Vec3d planned = centre_of_mass(body_, placed(body_, q));
      const double distance = norm(mujoco_.centre_of_mass() - planned);
      if (!(distance < 10.0)) return 10.0;
      most = max(most, distance);
    }
    return most;
  }

  [[nodiscard]] MujocoBody& mujoco() { return mujoco_; }

 private:
  mjModel* model() { return mujoco_.model(); }
  mjData* data() { return mujoco_.data(); }

  [[nodiscard]] std::vector<double> held_torques(std::span<const double> q) const {
    const std::vector<double> none(q.size(), 0.0);
    std::vector<double> torques(q.size());
    const Kinematics<double> kinematics = placed(body_, q);
    DynamicsWorkspace<double> work(body_);
    const Wrench<double> ground =
        inverse_dynamics<double>(body_, kinematics, {none, none}, work, torques);
    share_ground_wrench<double>(body_, kinematics, {}, ground, torques);
    return torques;
  }

  const PosedBody& body_;
  MujocoBody mujoco_;
  std::vector<double> stiffness_;  // (dofs) N m/rad
};

}  // namespace shigusa::testing_support
