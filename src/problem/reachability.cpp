// SPDX-License-Identifier: MIT
#include "problem/reachability.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <shigusa/run.hpp>

#include "dynamics/centre_of_mass.hpp"
#include "kinematics/penetration.hpp"
#include "problem/make_problem.hpp"
#include "rollout/detour.hpp"
#include "rollout/limit_guard.hpp"
#include "tiptoe.hpp"

namespace shigusa {
namespace {

// Range of the goals' damping in the descent, and its factors after a failed and a successful step.
constexpr double kDampingMin = 1e-9;
constexpr double kDampingMax = 1e3;
constexpr double kDampingUp = 8.0;
constexpr double kDampingDown = 0.25;
// Contact error (m) beyond which a posture is rejected.
constexpr double kContactSlack = 1e-5;
// Gain (m) below which a descent counts as stalled, and the number of such steps at which it ends.
constexpr double kStall = 1e-9;
constexpr int kStallSteps = 12;
// Difference of distances (m) that counts as equal if the goal is out of reach.
constexpr double kNearEqual = 5e-3;
// Steps of the walk to a random posture, and the share of the remaining way made in each.
constexpr int kWanderSteps = 60;
constexpr double kWanderRate = 0.1;
// Largest number of corrections of the planted feet after each step.
constexpr int kContactSteps = 4;
// Largest and smallest steps (m) of the plumb line over the forefeet, shortened on failure, and
// their largest number.
constexpr double kPoiseStep = 0.01;
constexpr double kLeastPoiseStep = 1e-4;
constexpr int kPoiseSteps = 200;

class Descent {
 public:
  Descent(const ReachProblem& problem)
      : problem_(problem),
        body_(*problem.body),
        constraints_(constraints(problem)),
        weights_(body_.dofs().size(), 1.0),
        trial_(weights_),
        kinematics_(body_),
        trial_kinematics_(body_),
        workspace_(body_) {
    if (problem.hold_limits) limits_.emplace(body_, problem.start());
  }

  // Whether some dof yields last.
  [[nodiscard]] bool has_stiff() const {
    return limits_ && std::any_of(body_.dofs().begin(), body_.dofs().end(),
                                  [](const Dof& dof) { return dof.give < 1.0; });
  }
  void loosen() { limits_->loosen(); }

  // Walks from the start posture towards a random one with the feet planted, so that the body can
  // make the motion.
  std::vector<double> wander(Random& random) {
    std::vector<double> angles(problem_.start().angles);
    std::vector<double> aim(angles);
    for (std::size_t d = 0; d < aim.size(); ++d) {
      const double anywhere = random.uniform(body_.dofs()[d].lower, body_.dofs()[d].upper);
      // limbs without a goal or a foot are irrelevant, and heels stay down
      const bool gives = body_.dofs()[d].give >= 1.0;
      if (gives && moves_point(static_cast<int>(d))) aim[d] = anywhere;
    }
    forward_kinematics<double>(body_, angles, kinematics_);
    std::vector<double> pull(aim);
    for (int k = 0; k < kWanderSteps; ++k) {
      for (std::size_t d = 0; d < aim.size(); ++d) pull[d] = kWanderRate * (aim[d] - angles[d]);
      trial_ = angles;
      trial_kinematics_ = kinematics_;
      advance(contacts(), problem_.ik, pull);
      hold_contacts(problem_.ik);
      if (contact_error(trial_kinematics_) > kContactSlack) break;
      angles = trial_;
      std::swap(kinematics_, trial_kinematics_);
    }
    return angles;
  }

  ClosestReach run(std::vector<double> angles, int iterations) {
    forward_kinematics<double>(body_, angles, kinematics_);
    // damped like goals, as hands too may be out of reach of their places
    for (Constraint<double>& hand : hands()) hand.exact = false;
    IkSettings ik = problem_.ik;
    ik.damping = 1e-3;
    double cost = distance(kinematics_);
    int stalled = 0;
    for (int k = 0; k < iterations && cost > problem_.goal_tolerance; ++k) {
      propose(angles, ik);
      const double trial = distance(trial_kinematics_);
      const bool stands = contact_error(trial_kinematics_) <= kContactSlack;
      if (trial < cost && stands) {
        stalled = cost - trial < kStall ? stalled + 1 : 0;
        cost = trial;
        angles = trial_;
        std::swap(kinematics_, trial_kinematics_);
        ik.damping = max(kDampingMin, ik.damping * kDampingDown);
      } else {
        ++stalled;
        ik.damping = min(kDampingMax, ik.damping * kDampingUp);
      }
      if (stalled > kStallSteps) break;
    }
    if (contact_error(kinematics_) > kContactSlack) cost = std::numeric_limits<double>::infinity();
    ClosestReach reach{angles, {}, {}, cost};
    for (std::size_t g = 0; g < problem_.goals.size(); ++g) {
      reach.positions.push_back(place(kinematics_, g));
      reach.turns.push_back(kinematics_.link_rotation(constraints_[g].link));
    }
    return reach;
  }

  // Moves the centre of mass over the forefeet if heels are lifted, with feet and effectors in
  // place: the nearest posture may be off balance. False if no heel is lifted.
  bool poise(std::vector<double>& angles) {
    const Tiptoe tiptoe(problem_, angles);
    if (!tiptoe.lifted()) return false;
    forward_kinematics<double>(body_, angles, kinematics_);
    for (std::size_t g = 0; g < problem_.goals.size(); ++g) {
      constraints_[g].place = place(kinematics_, g);
    }
    for (Constraint<double>& hand : hands()) hand.exact = true;
    double step = kPoiseStep;
    for (int k = 0; k < kPoiseSteps && step >= kLeastPoiseStep; ++k) {
      Vec3d offset = tiptoe.offset_from(shigusa::centre_of_mass(body_, kinematics_));
      if (offset == Vec3d{}) break;
      offset = offset * (step / max(norm(offset), step));
      trial_ = angles;
      trial_kinematics_ = kinematics_;
      advance(constraints_, problem_.ik, change_of_plumb_line(body_, kinematics_, offset));
      hold_contacts(problem_.ik);
      if (contact_error(trial_kinematics_) > kContactSlack) {
        step *= 0.5;
        continue;
      }
      step = min(2.0 * step, kPoiseStep);
      angles = trial_;
      std::swap(kinematics_, trial_kinematics_);
    }
    return true;
  }

 private:
  [[nodiscard]] bool moves_point(int dof) const {
    return std::any_of(constraints_.begin(), constraints_.end(),
                       [&](const auto& constraint) { return body_.moves(dof, constraint.link); });
  }

  [[nodiscard]] std::span<Constraint<double>> hands() {
    return std::span(constraints_).last(problem_.supports.size());
  }
  // The planted feet.
  [[nodiscard]] std::span<const Constraint<double>> contacts() const {
    const std::size_t others = problem_.goals.size() + problem_.supports.size();
    return std::span(constraints_).subspan(problem_.goals.size(), constraints_.size() - others);
  }

  // Makes one step towards the goals, then corrects the contacts alone.
  void propose(const std::vector<double>& angles, const IkSettings& ik) {
    trial_ = angles;
    trial_kinematics_ = kinematics_;
    for (std::size_t g = 0; g < problem_.goals.size(); ++g) {
      constraints_[g].place = problem_.goals[g].nearest(place(kinematics_, g), kBoxInset);
    }
    advance(constraints_, ik, {});
    hold_contacts(ik);
  }

  // Corrects the effect of a step on the planted feet.
  void hold_contacts(const IkSettings& ik) {
    for (int k = 0; k < kContactSteps && contact_error(trial_kinematics_) > 0.1 * kContactSlack;
         ++k) {
      advance(contacts(), ik, {});
    }
  }

  void advance(std::span<const Constraint<double>> held, const IkSettings& ik,
               std::span<const double> reference) {
    std::span<const double> weights = weights_;
    std::span<const double> drawn = reference;
    if (limits_) {
      weights = limits_->soften(weights_, trial_);
      if (!reference.empty()) drawn = limits_->allowed(reference);
    }
    const auto step =
        weighted_ik_step<double>(body_, trial_kinematics_, {held, weights, drawn}, ik, workspace_);
    for (std::size_t d = 0; d < step.size(); ++d) trial_[d] += step[d];
    if (limits_) {
      limits_->learn(weights_, workspace_.pull, reference);
      limits_->hold(trial_);
    }
    forward_kinematics<double>(body_, trial_, trial_kinematics_);
  }

  [[nodiscard]] double distance(const Kinematics<double>& kinematics) {
    double squares = 0.0;
    for (std::size_t g = 0; g < problem_.goals.size(); ++g) {
      const Vec3d at = place(kinematics, g);
      const Vec3d miss = problem_.goals[g].nearest(at, kBoxInset) - at;
      squares += dot(miss, miss);
      if (!constraints_[g].turns()) continue;
      const Vec3d turn = turn_error(kinematics, constraints_[g]) * kTurnLength;
      squares += dot(turn, turn);
    }
    for (const Constraint<double>& hand : hands()) {
      const Vec3d miss = position_error(kinematics, hand);
      squares += dot(miss, miss);
    }
    return sqrt(squares);
  }

  [[nodiscard]] double contact_error(const Kinematics<double>& kinematics) const {
    double worst = 0.0;
    for (const Constraint<double>& foot : contacts()) {
      worst = max(worst, norm(position_error(kinematics, foot)));
      worst = max(worst, kContactLength * tilt(kinematics, foot));
    }
    return worst;
  }

  [[nodiscard]] Vec3d place(const Kinematics<double>& kinematics, std::size_t goal) const {
    return kinematics.point(constraints_[goal].link, constraints_[goal].point);
  }

  const ReachProblem& problem_;
  const BodyModel& body_;
  std::vector<Constraint<double>> constraints_;
  std::vector<double> weights_;
  std::vector<double> trial_;
  Kinematics<double> kinematics_;
  Kinematics<double> trial_kinematics_;
  IkWorkspace<double> workspace_;
  std::optional<LimitGuard<double>> limits_;
};

ClosestReach search_postures(const ReachProblem& problem, const ReachabilitySettings& settings,
                             Descent& descent) {
  Random random(static_cast<std::uint64_t>(settings.other), 0x5EAC4);
  ClosestReach best;
  best.distance = std::numeric_limits<double>::infinity();
  for (int s = 0; s < settings.starts; ++s) {
    std::vector<double> angles =
        s == 0 && settings.other == 0 ? problem.start().angles : descent.wander(random);
    ClosestReach found = descent.run(std::move(angles), settings.iterations);
    // among near equals the first, in the neighbourhood of the start posture, is the most natural
    const bool nearer = found.distance < best.distance - kNearEqual;
    const bool meets = found.reached() && !best.reached();
    if (nearer || meets) best = std::move(found);
    if (best.reached()) break;
  }
  return best;
}

}  // namespace

ClosestReach closest_reach(const ReachProblem& problem, const ReachabilitySettings& settings) {
  Descent descent(problem);
  ClosestReach best = search_postures(problem, settings, descent);
  if (!descent.has_stiff()) return best;
  descent.loosen();
  if (!best.reached()) {
    // goals out of reach with flat feet, from the nearest such posture
    ClosestReach lifted = descent.run(best.angles, settings.iterations);
    if (lifted.distance < best.distance) best = std::move(lifted);
  }
  std::vector<double> angles = best.angles;
  if (!descent.poise(angles)) return best;
  ClosestReach poised = descent.run(std::move(angles), settings.iterations);
  const bool as_near =
      best.reached() ? poised.reached() : poised.distance < best.distance + kNearEqual;
  return as_near ? poised : best;
}

ReachProblem clear_goals(const ReachProblem& problem, const ClosestReach& reach) {
  const BodyModel& body = *problem.body;
  std::vector<CapsulePair> pairs;
  for (const ReachGoal& goal : problem.goals) {
    const std::vector<CapsulePair> limb = limb_pairs(body, body.effector(goal.effector));
    pairs.insert(pairs.end(), limb.begin(), limb.end());
  }
  pairs = allowed_as_at(placed(body, problem.start()), body, std::move(pairs));
  for (CapsulePair& pair : pairs) pair.allowed += give_of(body, pair);
  const auto clear = [&](const std::vector<double>& angles) {
    Kinematics<double> kinematics(body);
    forward_kinematics<double>(body, angles, kinematics);
    return deepest_of(body, kinematics, pairs).depth <= kDetourDepth;
  };
  if (clear(reach.angles)) return problem;
  ReachProblem nearer = problem;
  for (int tenths = 9; tenths > 0; --tenths) {
    for (std::size_t g = 0; g < problem.goals.size(); ++g) {
      const EffectorPath& path = problem.goals[g].path;
      nearer.goals[g].path.goal = path.start + (path.goal - path.start) * (0.1 * tenths);
      nearer.goals[g].tolerance = {};
    }
    if (clear(closest_reach(nearer).angles)) return nearer;
  }
  return problem;
}

Result<bool> seems_in_reach(const Task& task) {
  // a few initial postures decide most cases, in a tenth of a search's time
  constexpr ReachabilitySettings kQuick{.starts = 3, .iterations = 40};
  SHG_TRY_ASSIGN(const ReachProblem problem, make_problem(task));
  return closest_reach(problem, kQuick).reached();
}

}  // namespace shigusa
