// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <tuple>

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

// The built-in criteria with a weight above 0, evaluated together frame by frame.
template <class S>
class BuiltInCriteria {
 public:
  // `context`: with the start.
  BuiltInCriteria(const BodyModel& body, const CriteriaContext& context,
                  const CriteriaSettings& settings)
      : parts_{part<JointRange>(body, context, settings),
               part<Balance>(body, context, settings),
               part<Torque>(body, context, settings),
               part<BalanceZone>(body, context, settings),
               part<Discomfort>(body, context, settings),
               part<JointAcceleration>(body, context, settings),
               part<Work>(body, context, settings),
               part<LowBack>(body, context, settings),
               part<Head>(body, context, settings),
               part<Collision>(body, context, settings),
               part<CentreOfPressure>(body, context, settings),
               part<Feasibility>(body, context, settings),
               part<Coordination>(body, context, settings),
               part<HandCurve>(body, context, settings),
               part<TrunkTravel>(body, context, settings),
               part<MassAhead>(body, context, settings),
               part<Jolts>(body, context, settings)} {}

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
    visit_penalties([&sum](std::string_view, double weight, const S& penalty) {
      sum = sum + penalty * S(weight);
    });
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
    std::string_view name;
    double weight;
    std::optional<Criterion> criterion;  // empty if its weight is 0
  };
  template <template <class> class CriterionOf>
  static Part<CriterionOf<S>> part(const BodyModel& body, const CriteriaContext& context,
                                   const CriteriaSettings& settings) {
    constexpr CriterionKind kKind = CriterionOf<S>::kKind;
    const CriterionSetting& setting = settings[kKind];
    Part<CriterionOf<S>> part{word_of(kKind), setting.weight, std::nullopt};
    if (part.weight > 0.0) part.criterion.emplace(body, context, setting.scale);
    return part;
  }

  template <class Visitor, class All>
  static void for_each_part(Visitor&& visit, All& parts) {
    const auto visit_one = [&visit](auto& part) {
      if (part.criterion) visit(part);
    };
    std::apply([&visit_one](auto&... part) { (visit_one(part), ...); }, parts);
  }

  template <template <class> class... CriteriaOf>
  using Parts = std::tuple<Part<CriteriaOf<S>>...>;
  // in the order of CriterionKind
  Parts<JointRange, Balance, Torque, BalanceZone, Discomfort, JointAcceleration, Work, LowBack,
        Head, Collision, CentreOfPressure, Feasibility, Coordination, HandCurve, TrunkTravel,
        MassAhead, Jolts>
      parts_;
};

}  // namespace shigusa
