// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "core/check.hpp"
#include "core/index.hpp"
#include "kinematics/fit_clip.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "math/ldlt.hpp"
#include "math/turn_about.hpp"
#include "rig_drivers.hpp"
#include "rig_twist.hpp"

namespace shigusa {
namespace {

constexpr int kMaxDofs = 128;
constexpr double kTurnLength = 0.03;  // m, distance equivalent to a turn of 1 rad
constexpr double kDamping = 1e-9;     // minimum, as a share of the mean squared column
constexpr double kMostDamping = 1e6;
constexpr int kSteps = 60;
constexpr int kFirstSteps = 500;  // for the first frame, which may be far from the start posture
constexpr double kLeastStep = 1e-10;  // rad: termination by step size

// The rotation vector of a rotation (rad).
Vec3d turn_of(const Mat3d& rotation) {
  const Quatd q = to_quat(rotation);
  const Vec3d v{q.x, q.y, q.z};
  const double sine = norm(v);
  return sine < 1e-12 ? v * 2.0 : v * (2.0 * atan2(sine, q.w) / sine);
}

class ClipFitter {
 public:
  ClipFitter(const PosedBody& posed, const Rig& rig)
      : body_(posed.body),
        rig_(rig),
        axes_(transpose(Mat3d{rig.placement.left, rig.placement.up, rig.placement.ahead})),
        rest_(at_rest(rig)),
        placed_(body_),
        angles_(posed.home.angles),
        tried_(angles_),
        step_(angles_),
        normal_(std::make_unique<SmallSymmetric<double, kMaxDofs>>()) {
    SHG_CHECK(body_.dof_count() <= kMaxDofs, "a body of at most 128 freedoms");
    find_targets(home_kinematics(posed));
  }

  ClipFit fit(const SkeletonMotion& recorded, const FitFrames& frames) {
    const SkeletonClip& clip = recorded.clip;
    const auto [first, last, around] = frames;
    SHG_CHECK(0 <= first && first <= last && last < clip.frames, "frames of the record");
    SHG_CHECK(recorded.skeleton.nodes.size() == rig_.nodes.size(), "the rig's skeleton");
    const int from = first - std::min(first, around);
    const int to = last + std::min(clip.frames - 1 - last, around);
    const std::size_t dofs = angles_.size();
    ClipFit result;
    result.before = first - from;
    result.clip = {body_.dof_count(), to - from + 1, clip.frame_time, {}};
    result.clip.angles.resize(index(to - from + 1) * dofs);
    const auto bring = [&](int frame, int steps) {
      show(world_transforms(recorded.skeleton, clip, frame));
      settle(steps);
      const auto k = static_cast<std::ptrdiff_t>(index(frame - from) * dofs);
      std::copy(angles_.begin(), angles_.end(), result.clip.angles.begin() + k);
    };
    double sum = 0.0;
    for (int f = first; f <= to; ++f) {
      bring(f, f == first ? kFirstSteps : kSteps);
      if (f == first) first_angles_ = angles_;
      if (f > last) continue;
      sum += measure(f, result);
      follow_feet(f == first, result);
    }
    angles_ = first_angles_;
    for (int f = first - 1; f >= from; --f) bring(f, kSteps);
    result.mean_distance = sum / (last - first + 1);
    return result;
  }

 private:
  // A bone that moves with a link of the body, with its recorded placement.
  struct Target {
    HumanoidBone bone;
    std::size_t node = 0;
    int link = kBaseLink;
    Vec3d point{};  // m, link frame
    Mat3d turn{};   // R_link = (turn of the node from rest) · turn
    bool turns = false;
    std::optional<ForearmTurn> twist{};  // excluded from the node's turn
    Vec3d axis{};                        // unit, link frame: axis of that twist
    Vec3d position{};                    // m, world, as recorded
    Mat3d rotation{};                    // of the link, as recorded
  };

  void find_targets(const Kinematics<double>& standing) {
    const HumanFrames rest = human_frames(rig_.rest);
    const HumanFrames start = human_frames(rig_.start);
    std::vector<bool> given(body_.dofs().size(), false);
    for (int b = 0; b < kHumanoidBoneCount; ++b) {
      const auto bone = static_cast<HumanoidBone>(b);
      if (rig_.bones[bone] < 0) continue;
      const auto driver = bone_driver(bone, body_, rig_, rest, start);
      if (!driver || !driver->carries) continue;
      const std::size_t node = index(rig_.bones[bone]);
      const Transformd link{standing.link_rotation(driver->link),
                            standing.link_origin(driver->link)};
      const Vec3d at = driver->to_start * rig_.placement.to_world(rest_[node].translation);
      Target target{bone, node, driver->link, inverse(link) * at,
                    transpose(driver->to_start.rotation) * link.rotation};
      if (driver->link != kBaseLink) give_turn(target, link.rotation, given);
      targets_.push_back(target);
    }
  }

  // Chooses the turn that a bone contributes. If twist bones take up its twist, an upper limb's
  // bone contributes no turn, and a forearm's contributes its turn without the twist.
  void give_turn(Target& target, const Mat3d& link, std::vector<bool>& given) const {
    const bool apart = untwisted(rig_.twists, target.bone);
    bool upper = false;
    for (const TwistSegment& segment : twist_segments()) {
      upper = upper || (segment.bone == target.bone && !segment.lower);
    }
    const std::size_t d = index(target.link);
    target.turns = !given[d] && !(apart && upper);
    if (apart) target.twist = forearm_turn(body_, target.bone);
    given[d] = given[d] || (target.turns && !target.twist);
    if (!target.twist) return;
    const bool left = target.bone == HumanoidBone::left_lower_arm;
    const Landmarks::Arm& arm = rig_.start.arm(left ? Side::left : Side::right);
    target.axis = normalized(transpose_times(link, arm.elbow - arm.wrist), {0, 1, 0});
  }

  void show(const std::vector<Transformd>& world) {
    for (Target& target : targets_) {
      target.position = rig_.placement.to_world(world[target.node].translation);
      const Mat3d turned = world[target.node].rotation * transpose(rest_[target.node].rotation);
      target.rotation = axes_ * turned * transpose(axes_) * target.turn;
    }
  }

  // Cost of the angles with the present placement.
  [[nodiscard]] double cost() const {
    double sum = 0.0;
    for (const Target& target : targets_) {
      if (target.link == kBaseLink) continue;
      const Vec3d off = target.position - placed_.point(target.link, target.point);
      sum += dot(off, off);
      if (!target.turns) continue;
      const Vec3d turn = turn_left(target) * kTurnLength;
      sum += dot(turn, turn);
    }
    return sum;
  }

  [[nodiscard]] Vec3d turn_left(const Target& target) const {
    Mat3d now = placed_.link_rotation(target.link);
    if (target.twist) now = now * turn_about(target.axis, -target.twist->angle(placed_));
    return turn_of(target.rotation * transpose(now));
  }

  // Minimises the cost from angles_ on.
  void settle(int steps) {
    double damping = kDamping;
    forward_kinematics<double>(body_, angles_, placed_);
    double now = cost();
    for (int k = 0; k < steps && damping < kMostDamping; ++k) {
      const double largest = find_step(damping);
      for (std::size_t d = 0; d < step_.size(); ++d) tried_[d] = angles_[d] + step_[d];
      forward_kinematics<double>(body_, tried_, placed_);
      const double then = cost();
      if (then <= now) {
        angles_.swap(tried_);
        now = then;
        damping = max(0.1 * damping, kDamping);
        if (largest < kLeastStep) return;
      } else {
        if (largest < kLeastStep) break;
        damping *= 10.0;
        forward_kinematics<double>(body_, angles_, placed_);
      }
    }
    forward_kinematics<double>(body_, angles_, placed_);
  }

  // Solves (JᵀJ + damping) step = Jᵀ residual; returns the step's largest absolute value.
  double find_step(double damping) {
    const int dofs = body_.dof_count();
    SmallSymmetric<double, kMaxDofs>& a = *normal_;
    for (int i = 0; i < dofs; ++i) {
      step_[index(i)] = 0.0;
      for (int j = 0; j <= i; ++j) a(i, j) = 0.0;
    }
    for (const Target& target : targets_) {
      if (target.link == kBaseLink) continue;
      const Vec3d at = placed_.point(target.link, target.point);
      const Vec3d off = target.position - at;
      const Vec3d turn = target.turns ? turn_left(target) * kTurnLength : Vec3d{};
      const int own = target.twist ? target.twist->dof : -1;
      const auto turns = [&](int dof) { return target.turns && dof != own ? kTurnLength : 0.0; };
      const std::span<const int> chain = body_.chain(target.link);
      for (std::size_t m = 0; m < chain.size(); ++m) {
        const std::size_t i = index(chain[m]);
        const Vec3d column = position_column(placed_, chain[m], at);
        const Vec3d axis = placed_.axis[i] * turns(chain[m]);
        step_[i] += dot(column, off) + dot(axis, turn);
        for (std::size_t n = 0; n <= m; ++n) {
          const Vec3d other = position_column(placed_, chain[n], at);
          const Vec3d about = placed_.axis[index(chain[n])] * turns(chain[n]);
          a(chain[m], chain[n]) += dot(column, other) + dot(axis, about);
        }
      }
    }
    double trace = 0.0;
    for (int i = 0; i < dofs; ++i) trace += a(i, i);
    // dofs that no bone determines stay
    const double floor = trace / dofs * damping;
    for (int i = 0; i < dofs; ++i) a(i, i) += floor;
    ldlt_solve(a, step_.data(), dofs, 0.0);
    double largest = 0.0;
    for (const double s : step_) largest = max(largest, abs(s));
    return largest;
  }

  // The mean distance in this frame.
  double measure(int frame, ClipFit& result) const {
    double sum = 0.0;
    int count = 0;
    for (const Target& target : targets_) {
      if (target.link == kBaseLink) continue;
      const double off = norm(target.position - placed_.point(target.link, target.point));
      sum += off;
      ++count;
      if (off <= result.worst_distance) continue;
      result.worst_distance = off;
      result.worst_joint = humanoid_bone_name(target.bone);
      result.worst_frame = frame;
    }
    return count > 0 ? sum / count : 0.0;
  }

  // Tracks the travel of the feet; with lifted heels, the toes are the contact.
  void follow_feet(bool first, ClipFit& result) {
    using enum HumanoidBone;
    const auto feet = body_.feet();
    const bool toes = std::any_of(feet.begin(), feet.end(),
                                  [](const Foot& foot) { return foot.heel.has_value(); });
    std::size_t k = 0;
    for (const Target& target : targets_) {
      const HumanoidBone bone = target.bone;
      if (bone != (toes ? left_toes : left_foot) && bone != (toes ? right_toes : right_foot)) {
        continue;
      }
      if (first) {
        result.feet.push_back({std::string(humanoid_bone_name(target.bone)),
                               static_cast<int>(target.node), target.link == kBaseLink});
        first_feet_.push_back({target.rotation, target.position});
      }
      const Transformd& from = first_feet_[k];
      FootTravel& travel = result.feet[k++];
      travel.travel = max(travel.travel, norm(target.position - from.translation));
      travel.turn = max(travel.turn, norm(turn_of(target.rotation * transpose(from.rotation))));
    }
  }

  const BodyModel& body_;
  const Rig& rig_;
  Mat3d axes_;                    // from the file's axes to the world's
  std::vector<Transformd> rest_;  // (nodes) file's world
  std::vector<Target> targets_;
  std::vector<Transformd> first_feet_;
  Kinematics<double> placed_;
  std::vector<double> angles_;  // (dofs) rad
  std::vector<double> first_angles_;
  std::vector<double> tried_;
  std::vector<double> step_;
  std::unique_ptr<SmallSymmetric<double, kMaxDofs>> normal_;
};

}  // namespace

ClipFit fit_clip(const PosedBody& body, const Rig& rig, const SkeletonMotion& recorded,
                 const FitFrames& frames) {
  return ClipFitter(body, rig).fit(recorded, frames);
}

}  // namespace shigusa
