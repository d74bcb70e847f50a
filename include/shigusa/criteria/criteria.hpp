// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/core/check.hpp>
#include <shigusa/criteria/criteria_settings.hpp>
#include <string>
#include <utility>
#include <vector>

namespace shigusa {

// One line of a score's breakdown.
struct ScoreTerm {
  std::string name;
  double weight = 0.0;
  double penalty = 0.0;  // 0..1
};

struct Score {
  double total = 0.0;  // Σ weight · penalty
  // the built-in criteria whose weight is above 0, in the table's order, then the user's in theirs
  std::vector<ScoreTerm> terms;
};

// The score that a motion gets which misses its goal, leaves its path or moves a planted foot: no
// other is worse.
[[nodiscard]] double worst_score(const CriteriaSettings& settings);

// Scores a whole motion.
[[nodiscard]] Score score_motion(const BodyModel& body, const Motion& motion,
                                 const CriteriaSettings& settings);

// The built-in criteria whose weight is above 0, together, frame by frame.
template <class S>
class BuiltInCriteria {
 public:
  BuiltInCriteria(const BodyModel& body, const CriteriaSettings& settings)
      : parts_(make_parts(body, settings, Indices{})) {}

  // Forgets the frames seen.
  void reset() {
    for_each_part([](auto& part) { part.criterion->reset(); }, parts_);
  }

  void add(const PlacedFrame<S>& frame) {
    for_each_part([&frame](auto& part) { part.criterion->add(frame); }, parts_);
  }
  // Where nothing needs placement.
  void add(const MotionFrame<S>& frame) {
    SHG_CHECK(!needs_placement(), "a criterion looks at the body's placement");
    const auto show = [&frame](auto& criterion) {
      if constexpr (!looks_at_placement<std::remove_reference_t<decltype(criterion)>, S>)
        criterion.add(frame);
    };
    for_each_part([&show](auto& part) { show(*part.criterion); }, parts_);
  }

  // Whether one of them looks at the body's placement.
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

  // Calls visit(name, weight, penalty) for each in the table's order.
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
    std::optional<Criterion> criterion;  // empty where its weight is 0
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
