// SPDX-License-Identifier: MIT
#include <shigusa/criteria.hpp>

#include "criteria/jolts.hpp"
#include "criteria/replay.hpp"

namespace shigusa {
namespace {

constexpr double kUsualSteps = 60.0;

// Records the greatest changes between frames.
class Changes {
 public:
  explicit Changes(const BodyModel& body) : body_(&body), torques_(body.dofs().size()) {}

  void add(const PlacedFrame<double>& frame) {
    const double force = max(frame.pressure.y, 1e-3);
    const Vec3d place{frame.pressure.x / force, 0.0, frame.pressure.z / force};
    if (seen_ && !body_->feet().empty()) {
      most_.pressure = max(most_.pressure, norm(place - place_));
    }
    for (std::size_t d = 0; d < torques_.size(); ++d) {
      const Dof& dof = body_->dofs()[d];
      const double share =
          abs(frame.torques[d] - torques_[d]) / (dof.torque_positive + dof.torque_negative);
      if (seen_) most_.torque = max(most_.torque, share);
      torques_[d] = frame.torques[d];
    }
    place_ = place;
    seen_ = true;
  }
  [[nodiscard]] const Suddenness& most() const { return most_; }

 private:
  const BodyModel* body_;
  std::vector<double> torques_;  // (dofs) N·m, of the frame before
  Vec3d place_{};                // m, centre of pressure of the frame before
  bool seen_ = false;
  Suddenness most_;
};

}  // namespace

bool Suddenness::jolts() const { return pressure > kPressureJolt || torque > kTorqueJolt; }

Suddenness suddenness(const BodyModel& body, const Motion& motion) {
  Changes changes(body);
  show_motion(body, motion, changes);
  Suddenness most = changes.most();
  const double in_usual = (motion.clip.frames - 1) / kUsualSteps;
  most.pressure *= in_usual;
  most.torque *= in_usual;
  return most;
}

}  // namespace shigusa
