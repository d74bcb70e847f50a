// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/criteria.hpp>
#include <shigusa/kinematics.hpp>

#include "criteria/collision.hpp"
#include "criteria/limit_excess.hpp"
#include "criteria/replay.hpp"
#include "criteria/support_margin.hpp"
#include "criteria/with_start.hpp"

namespace shigusa {
namespace {

// Collects the centre of pressure of each frame.
struct PressureMeter {
  std::vector<Vec3d> centres{};

  void add(const PlacedFrame<double>& frame) {
    const double up = max(frame.pressure.y, 1.0);
    centres.push_back({frame.pressure.x / up, 0.0, frame.pressure.z / up});
  }
};

}  // namespace

std::vector<Transformd> node_places(const BodyModel& body, std::span<const double> angles) {
  const Posture posture(body, angles);
  std::vector<Transformd> places;
  for (const BodyNode& node : body.nodes()) places.push_back(posture.place(node));
  return places;
}

std::vector<Vec3d> centres_of_pressure(const BodyModel& body, const Motion& motion) {
  PressureMeter meter;
  show_motion(body, motion, meter);
  return std::move(meter.centres);
}

std::vector<JointLoad> joint_loads(const BodyModel& body, const Motion& motion) {
  std::vector<JointLoad> loads;
  const Clip& clip = motion.clip;
  for (int d = 0; d < clip.dofs; ++d) {
    const Dof& dof = body.dof(d);
    JointLoad load{.dof = d};
    for (int f = 0; f < clip.frames; ++f) {
      const double torque = motion.torques[static_cast<std::size_t>(f * clip.dofs + d)];
      const double share =
          torque > 0.0 ? torque / dof.torque_positive : -torque / dof.torque_negative;
      if (share > load.share) load = {d, torque, share, f * clip.frame_time};
    }
    loads.push_back(load);
  }
  return loads;
}

std::vector<LimitExcess> limit_excess(const BodyModel& body, const Clip& clip) {
  PassedLimits<double> passed(body);
  for (int f = 0; f < clip.frames; ++f) passed.add(clip.frame(f));
  std::vector<LimitExcess> all;
  for (std::size_t d = 0; d < passed.most().size(); ++d) {
    if (passed.most()[d] > kSeenExcess) all.push_back({body.dofs()[d].name, passed.most()[d]});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const LimitExcess& a, const LimitExcess& b) { return a.excess > b.excess; });
  return all;
}

MotionMeasures measure_motion(const BodyModel& body, const Motion& motion,
                              const CriteriaContext& context) {
  return {joint_loads(body, motion), limit_excess(body, motion.clip),
          measure_support(body, with_start(context, motion.clip).start, motion).margins(),
          deepest_collision(body, motion.clip, context), suddenness(body, motion)};
}

const JointLoad* most_loaded(const MotionMeasures& measures) {
  const auto less = [](const JointLoad& a, const JointLoad& b) { return a.share < b.share; };
  const auto most = std::max_element(measures.loads.begin(), measures.loads.end(), less);
  return most == measures.loads.end() ? nullptr : &*most;
}

}  // namespace shigusa
