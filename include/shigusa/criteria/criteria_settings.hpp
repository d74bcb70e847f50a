// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <shigusa/criteria/balance.hpp>
#include <shigusa/criteria/balance_zone.hpp>
#include <shigusa/criteria/centre_of_pressure.hpp>
#include <shigusa/criteria/collision.hpp>
#include <shigusa/criteria/discomfort.hpp>
#include <shigusa/criteria/feasibility.hpp>
#include <shigusa/criteria/head.hpp>
#include <shigusa/criteria/joint_acceleration.hpp>
#include <shigusa/criteria/joint_range.hpp>
#include <shigusa/criteria/low_back.hpp>
#include <shigusa/criteria/torque.hpp>
#include <shigusa/criteria/work.hpp>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
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

// What a motion is scored by: score = Σ weight · penalty, lower is better. Weights are 0 or more;
// what has a weight of 0 is not computed.
struct CriteriaSettings {
  double joint_range_weight = kPaperRangeWeight;
  double balance_weight = kPaperBalanceWeight;
  double torque_weight = kPaperTorqueWeight;
  double balance_zone_weight = 0.0;
  double discomfort_weight = 0.0;
  double joint_acceleration_weight = 0.0;
  double work_weight = 0.0;
  double low_back_weight = 0.0;
  double head_weight = 0.0;
  double collision_weight = 0.0;
  double pressure_weight = 0.0;
  double feasibility_weight = 0.0;
  JointRangeSettings joint_range{};
  BalanceSettings balance{};
  TorqueSettings torque{};
  BalanceZoneSettings balance_zone{};
  DiscomfortSettings discomfort{};
  JointAccelerationSettings joint_acceleration{};
  WorkSettings work{};
  LowBackSettings low_back{};
  HeadSettings head{};
  CollisionSettings collision{};
  PressureSettings pressure{};
  FeasibilitySettings feasibility{};
  std::vector<UserCriterion> user{};
};

// One built-in criterion: its class, its name, and where its weight and its reference scale are.
template <template <class> class CriterionOf>
struct CriterionEntry {
  template <class S>
  using Criterion = CriterionOf<S>;
  using Settings = typename CriterionOf<double>::Settings;

  const char* name;  // in scores and in files
  double CriteriaSettings::*weight_member;
  Settings CriteriaSettings::*settings_member;
  const char* scale_name;  // in files
  double Settings::*scale_member;

  // The criterion's members of CriteriaSettings, const or not.
  template <class Criteria>
  [[nodiscard]] constexpr auto& weight(Criteria& criteria) const {
    return criteria.*weight_member;
  }
  template <class Criteria>
  [[nodiscard]] constexpr auto& settings(Criteria& criteria) const {
    return criteria.*settings_member;
  }
  template <class Criteria>
  [[nodiscard]] constexpr auto& scale(Criteria& criteria) const {
    return settings(criteria).*scale_member;
  }
};

// All built-in criteria, in the order of a score's terms. Whatever reads, writes, checks or sums
// them goes by this table.
inline constexpr std::tuple kCriteria{
    CriterionEntry<JointRange>{"joint_range", &CriteriaSettings::joint_range_weight,
                               &CriteriaSettings::joint_range, "margin",
                               &JointRangeSettings::margin},
    CriterionEntry<Balance>{"balance", &CriteriaSettings::balance_weight,
                            &CriteriaSettings::balance, "lean", &BalanceSettings::lean},
    CriterionEntry<Torque>{"torque", &CriteriaSettings::torque_weight, &CriteriaSettings::torque,
                           "share", &TorqueSettings::share},
    CriterionEntry<BalanceZone>{"balance_zone", &CriteriaSettings::balance_zone_weight,
                                &CriteriaSettings::balance_zone, "margin_m",
                                &BalanceZoneSettings::margin},
    CriterionEntry<Discomfort>{"discomfort", &CriteriaSettings::discomfort_weight,
                               &CriteriaSettings::discomfort, "share", &DiscomfortSettings::share},
    CriterionEntry<JointAcceleration>{"joint_acceleration",
                                      &CriteriaSettings::joint_acceleration_weight,
                                      &CriteriaSettings::joint_acceleration, "acceleration_rad_s2",
                                      &JointAccelerationSettings::acceleration},
    CriterionEntry<Work>{"work", &CriteriaSettings::work_weight, &CriteriaSettings::work, "share",
                         &WorkSettings::share},
    CriterionEntry<LowBack>{"low_back", &CriteriaSettings::low_back_weight,
                            &CriteriaSettings::low_back, "share", &LowBackSettings::share},
    CriterionEntry<Head>{"head", &CriteriaSettings::head_weight, &CriteriaSettings::head, "height",
                         &HeadSettings::height},
    CriterionEntry<Collision>{"collision", &CriteriaSettings::collision_weight,
                              &CriteriaSettings::collision, "depth_m", &CollisionSettings::full},
    CriterionEntry<PressureZone>{"centre_of_pressure", &CriteriaSettings::pressure_weight,
                                 &CriteriaSettings::pressure, "outside_m",
                                 &PressureSettings::outside},
    CriterionEntry<Feasibility>{"feasibility", &CriteriaSettings::feasibility_weight,
                                &CriteriaSettings::feasibility, "outside_m",
                                &FeasibilitySettings::outside},
};

// Calls visit(entry) for each built-in criterion in the table's order.
template <class Visitor>
void for_each_criterion(Visitor&& visit) {
  std::apply([&visit](const auto&... entry) { (visit(entry), ...); }, kCriteria);
}

// The paper's three by rule R8's weights: what CriteriaSettings is by default.
[[nodiscard]] CriteriaSettings paper_criteria();

// The mixture that came nearest to a recorded man's reaches to the floor among those tried, with
// more of the low back (docs/criteria.md): joint range 0.25, balance zone 0.20, discomfort 0.27,
// joint acceleration 0.22, low back 0.20; and, of no weight against what is free, stands and is
// within the body's strength, collision 0.5, centre of pressure 0.35 and feasibility 1.
[[nodiscard]] CriteriaSettings default_criteria();

// What a Pareto view weighs against each other: joint range, as discomfort near its ends (no motion
// within limits has any of the paper's own), balance and torque, a third each.
[[nodiscard]] CriteriaSettings pareto_criteria();

// A mixture that files and the command line call by its name.
struct CriteriaPreset {
  std::string_view name;
  CriteriaSettings (*settings)();
};
// "paper", "default" and "pareto".
[[nodiscard]] std::span<const CriteriaPreset> criteria_presets();

}  // namespace shigusa
