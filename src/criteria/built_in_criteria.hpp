// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <tuple>
#include <utility>

#include "core/check.hpp"
#include "criteria/balance.hpp"
#include "criteria/balance_zone.hpp"
#include "criteria/centre_of_pressure.hpp"
#include "criteria/collision.hpp"
#include "criteria/coordination.hpp"
#include "criteria/discomfort.hpp"
#include "criteria/feasibility.hpp"
#include "criteria/hand_curve.hpp"
#include "criteria/head.hpp"
#include "criteria/joint_acceleration.hpp"
#include "criteria/joint_range.hpp"
#include "criteria/jolts.hpp"
#include "criteria/low_back.hpp"
#include "criteria/mass_ahead.hpp"
#include "criteria/torque.hpp"
#include "criteria/trunk_travel.hpp"
#include "criteria/work.hpp"

namespace shigusa {

// One built-in criterion: its class, its name, its weight, its settings and its reference scale.
template <template <class> class CriterionOf>
struct CriterionEntry {
  template <class S>
  using Criterion = CriterionOf<S>;
  using Settings = typename CriterionOf<double>::Settings;

  const char* name;    // in scores and in files
  const char* counts;  // for users: "quick starts and stops"
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

// All built-in criteria, in the order of a score's terms. The table that all readers, writers,
// checks and sums use.
inline constexpr std::tuple kCriteria{
    CriterionEntry<JointRange>{
        "joint_range", "joints beyond their limits", &CriteriaSettings::joint_range_weight,
        &CriteriaSettings::joint_range, "margin", &JointRangeSettings::margin},
    CriterionEntry<Balance>{"balance", "leaning away from above the feet",
                            &CriteriaSettings::balance_weight, &CriteriaSettings::balance, "lean",
                            &BalanceSettings::lean},
    CriterionEntry<Torque>{"torque", "effort of the joints beside their strength",
                           &CriteriaSettings::torque_weight, &CriteriaSettings::torque, "share",
                           &TorqueSettings::share},
    CriterionEntry<BalanceZone>{
        "balance_zone", "weight near the edge of the feet", &CriteriaSettings::balance_zone_weight,
        &CriteriaSettings::balance_zone, "margin_m", &BalanceZoneSettings::margin},
    CriterionEntry<Discomfort>{"discomfort", "joints far from their easy middle",
                               &CriteriaSettings::discomfort_weight, &CriteriaSettings::discomfort,
                               "share", &DiscomfortSettings::share},
    CriterionEntry<JointAcceleration>{"joint_acceleration", "quick starts and stops",
                                      &CriteriaSettings::joint_acceleration_weight,
                                      &CriteriaSettings::joint_acceleration, "acceleration_rad_s2",
                                      &JointAccelerationSettings::acceleration},
    CriterionEntry<Work>{"work", "work of lifting and braking", &CriteriaSettings::work_weight,
                         &CriteriaSettings::work, "share", &WorkSettings::share},
    CriterionEntry<LowBack>{"low_back", "load on the lower back",
                            &CriteriaSettings::low_back_weight, &CriteriaSettings::low_back,
                            "share", &LowBackSettings::share},
    CriterionEntry<Head>{"head", "head low, or eyes off the goal", &CriteriaSettings::head_weight,
                         &CriteriaSettings::head, "height", &HeadSettings::height},
    CriterionEntry<Collision>{"collision", "parts that pass through something",
                              &CriteriaSettings::collision_weight, &CriteriaSettings::collision,
                              "depth_m", &CollisionSettings::full},
    CriterionEntry<CentreOfPressure>{
        "centre_of_pressure", "pressure outside the feet", &CriteriaSettings::pressure_weight,
        &CriteriaSettings::pressure, "outside_m", &PressureSettings::outside},
    CriterionEntry<Feasibility>{"feasibility", "a worst moment beyond strength or footing",
                                &CriteriaSettings::feasibility_weight,
                                &CriteriaSettings::feasibility, "outside_m",
                                &FeasibilitySettings::outside},
    CriterionEntry<Coordination>{
        "coordination", "knees bent unlike people's", &CriteriaSettings::coordination_weight,
        &CriteriaSettings::coordination, "angle_rad", &CoordinationSettings::angle},
    CriterionEntry<HandCurve>{"hand_curve", "a way of the hand unlike people's",
                              &CriteriaSettings::hand_curve_weight, &CriteriaSettings::hand_curve,
                              "offset", &HandCurveSettings::offset},
    CriterionEntry<TrunkTravel>{"trunk_travel", "a trunk that goes too far or too little",
                                &CriteriaSettings::trunk_travel_weight,
                                &CriteriaSettings::trunk_travel, "distance_m",
                                &TrunkTravelSettings::distance},
    CriterionEntry<MassAhead>{"mass_ahead", "weight that does not go along with the hand",
                              &CriteriaSettings::mass_ahead_weight, &CriteriaSettings::mass_ahead,
                              "distance_m", &MassAheadSettings::distance},
    CriterionEntry<Jolts>{"jolts", "sudden changes of effort", &CriteriaSettings::jolts_weight,
                          &CriteriaSettings::jolts, "limit", &JoltsSettings::limit},
};

// Calls visit(entry) for each built-in criterion in the table's order.
template <class Visitor>
void for_each_criterion(Visitor&& visit) {
  std::apply([&visit](const auto&... entry) { (visit(entry), ...); }, kCriteria);
}

// The built-in criteria with a weight above 0, evaluated together frame by frame.
template <class S>
class BuiltInCriteria {
 public:
  BuiltInCriteria(const BodyModel& body, const CriteriaSettings& settings)
      : parts_(make_parts(body, settings, Indices{})) {}

  void reset() {
    for_each_part([](auto& part) { part.criterion->reset(); }, parts_);
  }

  void add(const PlacedFrame<S>& frame) {
    for_each_part([&frame](auto& part) { part.criterion->add(frame); }, parts_);
  }
  // Adds a frame if no criterion needs the body's placement.
  void add(const MotionFrame<S>& frame) {
    SHG_CHECK(!needs_placement(), "a criterion looks at the body's placement");
    const auto show = [&frame](auto& criterion) {
      if constexpr (!looks_at_placement<std::remove_reference_t<decltype(criterion)>, S>)
        criterion.add(frame);
    };
    for_each_part([&show](auto& part) { show(*part.criterion); }, parts_);
  }

  // Whether some criterion needs the body's placement.
  [[nodiscard]] bool needs_placement() const {
    bool needs = false;
    const auto ask = [&needs]<class Criterion>(const Criterion&) {
      needs = needs || looks_at_placement<Criterion, S>;
    };
    for_each_part([&ask](const auto& part) { ask(*part.criterion); }, parts_);
    return needs;
  }

  // Σ weight · penalty.
  [[nodiscard]] S score() const {
    S sum(0);
    visit_penalties(
        [&sum](const char*, double weight, const S& penalty) { sum = sum + penalty * S(weight); });
    return sum;
  }

  // Calls visit(name, weight, penalty) for each criterion in the table's order.
  template <class Visitor>
  void visit_penalties(Visitor&& visit) const {
    for_each_part(
        [&visit](const auto& part) { visit(part.name, part.weight, part.criterion->penalty()); },
        parts_);
  }

 private:
  template <class Criterion>
  struct Part {
    const char* name;
    double weight;
    std::optional<Criterion> criterion;  // empty if its weight is 0
  };
  using Indices = std::make_index_sequence<std::tuple_size_v<decltype(kCriteria)>>;

  template <std::size_t I>
  static auto make_part(const BodyModel& body, const CriteriaSettings& settings) {
    constexpr auto& kEntry = std::get<I>(kCriteria);
    using Criterion = typename std::tuple_element_t<I, decltype(kCriteria)>::template Criterion<S>;
    Part<Criterion> part{kEntry.name, settings.*kEntry.weight_member, std::nullopt};
    if (part.weight > 0.0) part.criterion.emplace(body, settings.*kEntry.settings_member);
    return part;
  }
  template <std::size_t... I>
  static auto make_parts(const BodyModel& body, const CriteriaSettings& settings,
                         std::index_sequence<I...>) {
    return std::tuple{make_part<I>(body, settings)...};
  }

  template <class Visitor, class Parts>
  static void for_each_part(Visitor&& visit, Parts& parts) {
    const auto visit_one = [&visit](auto& part) {
      if (part.criterion) visit(part);
    };
    std::apply([&visit_one](auto&... part) { (visit_one(part), ...); }, parts);
  }

  decltype(make_parts(std::declval<const BodyModel&>(), std::declval<const CriteriaSettings&>(),
                      Indices{})) parts_;
};

}  // namespace shigusa
