// SPDX-License-Identifier: MIT
#include "hand_play.hpp"

#include "body/joint_name.hpp"
#include "kinematics/rig_fingers.hpp"

namespace shigusa {
namespace {

// Time (s) in which fingers close about a thing, until the hand holds it: the end of the way, in
// which the hand is nearly there, and its pause there.
constexpr double kCloses = 0.3;
// Time (s) before and after a thing is let go in which fingers open, and then go back to where they
// were at the start.
constexpr double kOpens = 0.1;
constexpr double kGoesBack = 0.5;

// The keys of one hand, in the order of time.
class KeyWriter {
 public:
  // `duration`: of the motion, s
  KeyWriter(double duration, std::vector<FingerKey>& keys)
      : per_second_(duration > 0.0 ? 1.0 / duration : 0.0), keys_(keys) {}

  void add(const HandUse& use) {
    begin(use.start);
    const double open = min(kOpenShare, use.flexion);
    const double widest = use.start + kWidestAt * (use.there - use.start);
    add(widest, open);
    if (!use.thing.empty()) add(use.there - kCloses, open);
    add(use.there, use.flexion);
    if (!use.end) return;
    add(*use.end - kOpens, use.flexion);
    add(*use.end + kOpens, open);
    add(*use.end + kOpens + kGoesBack, 1.0, 1.0);
  }

 private:
  // Leaves the posture at a time (s), which cuts off what was to come.
  void begin(double time) {
    FingerKey now = finger_posture(keys_, time * per_second_);
    while (!keys_.empty() && keys_.back().share >= now.share) keys_.pop_back();
    keys_.push_back(now);
  }

  void add(double time, double flexion, double start = 0.0) {
    const double share = time * per_second_;
    if (share > keys_.back().share) keys_.push_back({share, flexion, start});
  }

  double per_second_;
  std::vector<FingerKey>& keys_;
};

}  // namespace

HandPlay hand_play(const Task& task, const Candidate& candidate) {
  // the paper's model has no fingers
  const bool plays = task.finger_play == FingerPlay::grip && traits_of(task.preset).natural;
  HandPlay hands{plays, {}};
  const auto side_of = [](const std::string& effector) -> std::optional<std::size_t> {
    const JointPlace part = parse_joint_name(effector);
    if (part.joint_kind != JointKind::hand || !part.side) return std::nullopt;
    return part.side == Side::left ? 0 : 1;
  };
  for (const Goal& goal : task.goals) {
    if (const auto side = side_of(goal.effector)) hands.reaches[*side] = true;
  }
  const double duration = candidate.motion.clip.duration();
  for (const HandUse& use : candidate.hands) {
    if (const auto side = side_of(use.effector)) KeyWriter(duration, hands.keys[*side]).add(use);
  }
  return hands;
}

}  // namespace shigusa
