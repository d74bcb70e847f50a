// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/generate.hpp>
#include <utility>

#include "dynamics/clip_dynamics.hpp"
#include "generate/candidate.hpp"

namespace shigusa {
namespace {

// Collects the reasons that exceed their bounds.
class Reasons {
 public:
  void add(VerdictBounds bounds, Reason reason) {
    if (!(reason.amount > bounds.strains)) return;
    const bool impossible = reason.amount > bounds.impossible;
    reason.verdict = impossible ? Verdict::impossible : Verdict::strains;
    found_.push_back({reason.amount / bounds.impossible, std::move(reason)});
  }

  // Sorts the reasons by their ratio to the impossible bound, the largest first.
  Judgement judgement() && {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Found& a, const Found& b) { return a.beyond > b.beyond; });
    Judgement judgement;
    for (Found& found : found_) {
      judgement.verdict = std::max(judgement.verdict, found.reason.verdict);
      judgement.reasons.push_back(std::move(found.reason));
    }
    return judgement;
  }

 private:
  struct Found {
    double beyond;
    Reason reason;
  };
  std::vector<Found> found_;
};

std::string when(const Reason& reason) {
  return reason.time ? fmt::format(" at {:.2f} s", *reason.time) : std::string();
}

// The verdict on a motion in another duration: limits and collisions are unchanged.
Verdict verdict_in(double duration, const BodyModel& body, const Motion& motion,
                   MotionMeasures measures, ClipDynamics& dynamics) {
  Clip clip = motion.clip;
  clip.frame_time = duration / (clip.frames - 1);
  const Motion slower = dynamics.completed(std::move(clip), motion.resting);
  measures.loads = joint_loads(body, slower);
  measures.support = support_margins(body, slower);
  return judge(body, measures).verdict;
}

}  // namespace

std::string reason_words(const Reason& reason) {
  switch (reason.kind) {
    case ReasonKind::strength:
      return fmt::format("{} needs {:.0f} N·m{}, {:.1f} times its strength of {:.0f}",
                         reason.subject, reason.torque, when(reason), reason.amount,
                         reason.strength);
    case ReasonKind::pressure:
      if (reason.amount > kFarOutside) {
        return fmt::format("the floor would have to press far outside the feet{}", when(reason));
      }
      return fmt::format("the floor would have to press {:.0f} mm outside the feet{}",
                         1e3 * reason.amount, when(reason));
    case ReasonKind::collision:
      return fmt::format("{} is {:.0f} mm in {}{}", reason.subject, 1e3 * reason.amount,
                         reason.other, when(reason));
    case ReasonKind::limit:
      return fmt::format("{} is {:.0f}° beyond its range", reason.subject, degrees(reason.amount));
  }
  return "";
}

Judgement judge(const BodyModel& body, const MotionMeasures& measures) {
  Reasons reasons;
  for (const JointLoad& load : measures.loads) {
    const Dof& dof = body.dof(load.dof);
    reasons.add(body.is_robot() ? kEffortBounds : kStrengthBounds,
                {.kind = ReasonKind::strength,
                 .amount = load.share,
                 .subject = dof.name,
                 .torque = abs(load.torque),
                 .strength = load.torque > 0.0 ? dof.torque_positive : dof.torque_negative,
                 .time = load.time});
  }
  if (measures.support) {
    const SupportMargin& pressure = measures.support->pressure;
    reasons.add(
        kPressureBounds,
        {.kind = ReasonKind::pressure, .amount = -pressure.distance, .time = pressure.time});
  }
  const CollisionFound& collides = measures.collides;
  reasons.add(collides.hard ? kHardCollisionBounds : kCollisionBounds,
              {.kind = ReasonKind::collision,
               .amount = collides.depth,
               .subject = collides.limb,
               .other = collides.other,
               .time = collides.time});
  for (const LimitExcess& over : measures.over_limit) {
    reasons.add(kLimitBounds,
                {.kind = ReasonKind::limit, .amount = over.excess, .subject = over.dof});
  }
  return std::move(reasons).judgement();
}

Judgement judge_start(const BodyModel& body, const State& start) {
  const Motion held = held_still(body, start);
  MotionMeasures measures;
  measures.loads = joint_loads(body, held);
  measures.support = support_margins(body, held);
  Judgement judgement = judge(body, measures);
  for (Reason& reason : judgement.reasons) reason.time = std::nullopt;
  return judgement;
}

Judgement judge(const BodyModel& body, const Motion& motion, const MotionMeasures& measures) {
  Judgement judgement = judge(body, measures);
  judgement.possible_in = possible_in(judgement, body, motion, measures);
  return judgement;
}

std::optional<double> possible_in(const Judgement& judgement, const BodyModel& body,
                                  const Motion& motion, const MotionMeasures& measures) {
  constexpr int kHalvings = 6;
  if (judgement.verdict != Verdict::impossible) return std::nullopt;
  double fast = motion.clip.duration();
  double slow = kSlowest * fast;
  ClipDynamics dynamics(body);
  const auto in = [&](double duration) {
    return verdict_in(duration, body, motion, measures, dynamics);
  };
  const Verdict best = in(slow);
  if (best == Verdict::impossible) return std::nullopt;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (fast + slow);
    (in(middle) <= best ? slow : fast) = middle;
  }
  return slow;
}

}  // namespace shigusa
