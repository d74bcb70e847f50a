// SPDX-License-Identifier: MIT
#include "kinematics/held_resample.hpp"

#include "core/index.hpp"
#include "kinematics/weighted_ik.hpp"

namespace shigusa {
namespace {

void append(const Vec3d& v, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

// Corrects the held points, frame by frame.
class Holder {
 public:
  Holder(const BodyModel& body, const Clip& clip, double rate, std::span<const HeldPoint> held)
      : body_(body), held_(held), now_(body), workspace_(body) {
    forward_kinematics<double>(body, clip.frame(0), now_);
    for (const HeldPoint& point : held) first_.push_back(now_.link_rotation(point.link));
    ways_ = resampled(ways_of(clip), rate);
    inverse_weights_.assign(body.dofs().size(), 0.0);
    for (std::size_t i = 0; i < clip.angles.size(); ++i) {
      const std::size_t d = i % inverse_weights_.size();
      if (clip.angles[i] != clip.angles[d]) inverse_weights_[d] = 1.0;
    }
  }

  // `angles`: of the frame at the new rate.
  void hold(int frame, std::span<double> angles) {
    constexpr int kResampleSteps = 4;
    constexpr double kNear = 1e-7;  // m
    const std::vector<Constraint<double>> targets = targets_at(frame);
    for (int k = 0; k < kResampleSteps; ++k) {
      forward_kinematics<double>(body_, angles, now_);
      double off = 0.0;
      for (const Constraint<double>& target : targets) {
        off = max(off, norm(position_error(now_, target)));
        if (target.turning == Turning::whole)
          off = max(off, kContactLength * norm(tilt_error(now_, target)));
      }
      if (off < kNear) return;
      const auto step =
          weighted_ik_step<double>(body_, now_, {targets, inverse_weights_}, {}, workspace_);
      for (std::size_t d = 0; d < step.size(); ++d) angles[d] += step[d];
    }
  }

 private:
  // (frames × 6 for each point that turns and 3 for others) m and rad: positions, and turns since
  // the first frame.
  Clip ways_of(const Clip& clip) {
    Clip ways{.dofs = 0, .frames = clip.frames, .frame_time = clip.frame_time, .angles = {}};
    for (const HeldPoint& point : held_) ways.dofs += point.turns ? 6 : 3;
    for (int f = 0; f < clip.frames; ++f) {
      forward_kinematics<double>(body_, clip.frame(f), now_);
      for (std::size_t i = 0; i < held_.size(); ++i) {
        const HeldPoint& point = held_[i];
        append(now_.point(point.link, point.point), ways.angles);
        if (!point.turns) continue;
        append(rotation_vector(now_.link_rotation(point.link) * transpose(first_[i])), ways.angles);
      }
    }
    return ways;
  }

  [[nodiscard]] std::vector<Constraint<double>> targets_at(int frame) const {
    std::vector<Constraint<double>> targets;
    const double* at = ways_.frame(frame).data();
    const auto next = [&at] {
      at += 3;
      return Vec3d{at[-3], at[-2], at[-1]};
    };
    for (std::size_t i = 0; i < held_.size(); ++i) {
      Constraint<double>& target = targets.emplace_back();
      target.link = held_[i].link;
      target.point = held_[i].point;
      target.exact = held_[i].exact;
      target.place = next();
      if (!held_[i].turns) continue;
      target.turning = Turning::whole;
      target.orientation = rotation_by(next()) * first_[i];
    }
    return targets;
  }

  const BodyModel& body_;
  std::span<const HeldPoint> held_;
  Kinematics<double> now_;
  IkWorkspace<double> workspace_;
  std::vector<double> inverse_weights_;  // (dofs)
  std::vector<Mat3d> first_;             // (points) R_WL in the first frame
  Clip ways_;
};

}  // namespace

Clip resampled(const BodyModel& body, const Clip& clip, double rate,
               std::span<const HeldPoint> held) {
  Clip result = resampled(clip, rate);
  if (held.empty()) return result;
  Holder holder(body, clip, rate, held);
  const std::size_t dofs = index(clip.dofs);
  // the first and the last frame are the clip's own
  for (int f = 1; f < result.frames - 1; ++f) {
    holder.hold(f, std::span<double>(result.angles).subspan(index(f) * dofs, dofs));
  }
  return result;
}

}  // namespace shigusa
