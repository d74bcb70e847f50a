// SPDX-License-Identifier: MIT
#include "jolt_meter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "criteria/replay.hpp"

namespace shigusa::bench {
namespace {

// The part of a frame that is kept.
struct Seen {
  Vec3d pressure;  // m, world, on the floor
  std::vector<double> speeds;
  std::vector<double> accelerations;
  std::vector<double> torques;
};

Vec3d place_of(const Vec3d& pressure) {
  const double force = std::fmax(pressure.y, 1.0);
  return {pressure.x / force, 0.0, pressure.z / force};
}

// Keeps all frames.
struct Keeper {
  std::vector<Seen> frames;
  void add(const PlacedFrame<double>& frame) {
    const auto copy = [](std::span<const double> from) {
      return std::vector<double>(from.begin(), from.end());
    };
    frames.push_back({place_of(frame.pressure), copy(frame.speeds), copy(frame.accelerations),
                      copy(frame.torques)});
  }
};

// Computes the dynamics of one posture with scaled accelerations.
class Posture {
 public:
  Posture(const BodyModel& body, std::span<const double> angles)
      : body_(&body), angles_(angles), placed_(body), work_(body), torques_(angles.size()) {
    forward_kinematics<double>(body, angles, placed_);
  }

  struct Effect {
    Vec3d pressure;
    std::vector<double> torques;
  };
  Effect of(std::span<const double> speeds, std::span<const double> accelerations) {
    const Wrench<double> ground =
        inverse_dynamics<double>(*body_, placed_, {speeds, accelerations}, work_, torques_);
    bear_on_feet<double>(*body_, placed_, angles_, ground, torques_);
    return {place_of(shigusa::pressure(ground, floor_height(*body_))), torques_};
  }

 private:
  const BodyModel* body_;
  std::span<const double> angles_;
  Kinematics<double> placed_;
  DynamicsWorkspace<double> work_;
  std::vector<double> torques_;
};

// Finds the degree of freedom whose change of acceleration contributes most to the jolt.
void find_driver(const BodyModel& body, const Motion& motion, const Keeper& kept, Jolt& jolt) {
  const auto f = static_cast<std::size_t>(jolt.frame);
  const std::span<const double> angles = motion.clip.frame(jolt.frame);
  const Seen& now = kept.frames[f];
  const Seen& before = kept.frames[f - 1];
  Posture posture(body, angles);
  const auto whole = posture.of(now.speeds, now.accelerations);
  const Vec3d way = now.pressure - before.pressure;
  double most = 0.0;
  for (std::size_t d = 0; d < angles.size(); ++d) {
    std::vector<double> accelerations = now.accelerations;
    accelerations[d] = before.accelerations[d];
    const auto without = posture.of(now.speeds, accelerations);
    double makes = dot(whole.pressure - without.pressure, way) / std::fmax(dot(way, way), 1e-12);
    if (jolt.joint >= 0) {
      const auto j = static_cast<std::size_t>(jolt.joint);
      makes = (whole.torques[j] - without.torques[j]) / (now.torques[j] - before.torques[j]);
    }
    if (makes <= most) continue;
    most = makes;
    jolt.driver = static_cast<int>(d);
  }
}

constexpr double kStopped = radians(0.4);  // of a step: a change of it that is seen
constexpr double kKink = radians(0.25);    // the same, of a step's change
constexpr double kNearLimit = radians(8.0);
constexpr double kAtLimit = radians(0.2);

// Steps (rad per frame) of one degree of freedom around a jolt's frame.
struct Steps {
  const BodyModel* body;
  const Clip* clip;
  int dof;

  [[nodiscard]] double angle(int frame) const { return held(frame)[static_cast<std::size_t>(dof)]; }
  [[nodiscard]] double step(int frame) const { return angle(frame) - angle(frame - 1); }
  // rad, to the nearest limit
  [[nodiscard]] double room(int frame) const {
    return std::fmin(angle(frame) - body->dof(dof).lower,
                     upper_limit(*body, dof, held(frame)) - angle(frame));
  }
  [[nodiscard]] bool stops(int frame) const {
    return room(frame) < kNearLimit &&
           std::fabs(step(frame)) - std::fabs(step(frame + 1)) > kStopped;
  }
  [[nodiscard]] bool leaves(int frame) const {
    return room(frame) < kAtLimit && std::fabs(step(frame + 1)) - std::fabs(step(frame)) > kStopped;
  }
  [[nodiscard]] bool kinks(int frame) const {
    return std::fabs(step(frame + 1) - 2.0 * step(frame) + step(frame - 1)) > kKink;
  }

 private:
  [[nodiscard]] std::span<const double> held(int frame) const {
    return clip->frame(std::clamp(frame, 0, clip->frames - 1));
  }
};

JoltEvent event_of(const BodyModel& body, const Clip& clip, int frame) {
  if (frame <= 2) return JoltEvent::first_frames;
  if (frame + 2 >= clip.frames) return JoltEvent::last_frames;
  const auto some = [&](bool (Steps::*does)(int) const) {
    for (int d = 0; d < clip.dofs; ++d) {
      const Steps steps{&body, &clip, d};
      for (int f = frame - 1; f <= frame + 1; ++f) {
        if ((steps.*does)(f)) return true;
      }
    }
    return false;
  };
  if (some(&Steps::stops)) return JoltEvent::to_limit;
  if (some(&Steps::leaves)) return JoltEvent::from_limit;
  return some(&Steps::kinks) ? JoltEvent::kink : JoltEvent::smooth;
}

void explain(const BodyModel& body, const Motion& motion, const Keeper& kept, Jolt& jolt) {
  find_driver(body, motion, kept, jolt);
  jolt.event = event_of(body, motion.clip, jolt.frame);
}

}  // namespace

Jolts jolts_of(const BodyModel& body, const Motion& motion) {
  Keeper kept;
  show_motion(body, motion, kept);
  Jolts jolts;
  for (int frame = 1; frame < motion.clip.frames; ++frame) {
    const Seen& now = kept.frames[static_cast<std::size_t>(frame)];
    const Seen& before = kept.frames[static_cast<std::size_t>(frame - 1)];
    const double moved = norm(now.pressure - before.pressure);
    if (moved > jolts.pressure.size) jolts.pressure = {.size = moved, .frame = frame};
    for (std::size_t d = 0; d < now.torques.size(); ++d) {
      const Dof& dof = body.dofs()[d];
      const double share = std::fabs(now.torques[d] - before.torques[d]) /
                           (dof.torque_positive + dof.torque_negative);
      if (share <= jolts.torque.size) continue;
      jolts.torque = {.size = share, .frame = frame, .joint = static_cast<int>(d)};
    }
  }
  if (jolts.pressure_jolts()) explain(body, motion, kept, jolts.pressure);
  if (jolts.torque_jolts()) explain(body, motion, kept, jolts.torque);
  return jolts;
}

}  // namespace shigusa::bench
