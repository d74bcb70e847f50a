// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/criteria/balance.hpp>
#include <shigusa/criteria/joint_range.hpp>
#include <shigusa/criteria/torque.hpp>
#include <string>
#include <vector>

namespace shigusa {

// The paper's order of importance, range > balance > torque (section 3.3), with rule R8's weights.
inline constexpr double kPaperRangeWeight = 0.5;
inline constexpr double kPaperBalanceWeight = 0.3;
inline constexpr double kPaperTorqueWeight = 0.2;

// A criterion of the user's own: any scalar function of the motion; smaller is better. Its penalty
// is value / scale, held to [0, 1] as the built-in ones are. NaN makes the motion the worst of all.
struct UserCriterion {
  std::string name;
  double weight = 0.1;  // ≥ 0
  double scale = 1.0;   // value at which the penalty is full, > 0
  std::function<double(const BodyModel&, const Motion&)> value{};
};

// What a motion is scored by: score = Σ weight · penalty, lower is better.
struct CriteriaSettings {
  double joint_range_weight = kPaperRangeWeight;  // ≥ 0
  double balance_weight = kPaperBalanceWeight;    // ≥ 0
  double torque_weight = kPaperTorqueWeight;      // ≥ 0
  JointRangeSettings joint_range{};
  BalanceSettings balance{};
  TorqueSettings torque{};
  std::vector<UserCriterion> user{};
};

// One line of a score's breakdown.
struct ScoreTerm {
  std::string name;
  double weight = 0.0;
  double penalty = 0.0;  // 0..1
};

struct Score {
  double total = 0.0;            // Σ weight · penalty
  std::vector<ScoreTerm> terms;  // joint_range, balance, torque, then the user's in their order
};

// The score that a motion gets which misses its goal, leaves its path or moves a planted foot: no
// other is worse.
[[nodiscard]] double worst_score(const CriteriaSettings& settings);

// Scores a whole motion.
[[nodiscard]] Score score_motion(const BodyModel& body, const Motion& motion,
                                 const CriteriaSettings& settings);

// The paper's three criteria together, frame by frame.
template <class S>
class BuiltInCriteria {
 public:
  BuiltInCriteria(const BodyModel& body, const CriteriaSettings& settings)
      : settings_(&settings),
        joint_range_(body, settings.joint_range),
        balance_(body, settings.balance),
        torque_(body, settings.torque) {}

  // Forgets the frames seen.
  void reset() {
    joint_range_.reset();
    balance_.reset();
    torque_.reset();
  }

  void add(const MotionFrame<S>& frame) {
    joint_range_.add(frame);
    balance_.add(frame);
    torque_.add(frame);
  }

  // Σ weight · penalty of the three.
  [[nodiscard]] S score() const {
    return joint_range_.penalty() * S(settings_->joint_range_weight) +
           balance_.penalty() * S(settings_->balance_weight) +
           torque_.penalty() * S(settings_->torque_weight);
  }

 private:
  const CriteriaSettings* settings_;
  JointRange<S> joint_range_;
  Balance<S> balance_;
  Torque<S> torque_;
};

}  // namespace shigusa
