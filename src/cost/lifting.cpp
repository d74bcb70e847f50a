// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/ergonomics.hpp>
#include <utility>

#include "core/say.hpp"

namespace shigusa {
namespace {

// Table 5 of the manual: FM by lifts a minute; brief, moderate and lengthy work, each with the
// hands at the origin below the knuckles and above.
struct FrequencyRow {
  double frequency;
  std::array<double, 6> factors;
};
constexpr std::array kFrequencies{
    FrequencyRow{0.2, {1.00, 1.00, 0.95, 0.95, 0.85, 0.85}},
    FrequencyRow{0.5, {0.97, 0.97, 0.92, 0.92, 0.81, 0.81}},
    FrequencyRow{1, {0.94, 0.94, 0.88, 0.88, 0.75, 0.75}},
    FrequencyRow{2, {0.91, 0.91, 0.84, 0.84, 0.65, 0.65}},
    FrequencyRow{3, {0.88, 0.88, 0.79, 0.79, 0.55, 0.55}},
    FrequencyRow{4, {0.84, 0.84, 0.72, 0.72, 0.45, 0.45}},
    FrequencyRow{5, {0.80, 0.80, 0.60, 0.60, 0.35, 0.35}},
    FrequencyRow{6, {0.75, 0.75, 0.50, 0.50, 0.27, 0.27}},
    FrequencyRow{7, {0.70, 0.70, 0.42, 0.42, 0.22, 0.22}},
    FrequencyRow{8, {0.60, 0.60, 0.35, 0.35, 0.18, 0.18}},
    FrequencyRow{9, {0.52, 0.52, 0.30, 0.30, 0.00, 0.15}},
    FrequencyRow{10, {0.45, 0.45, 0.26, 0.26, 0.00, 0.13}},
    FrequencyRow{11, {0.41, 0.41, 0.00, 0.23, 0.00, 0.00}},
    FrequencyRow{12, {0.37, 0.37, 0.00, 0.21, 0.00, 0.00}},
    FrequencyRow{13, {0.00, 0.34, 0.00, 0.00, 0.00, 0.00}},
    FrequencyRow{14, {0.00, 0.31, 0.00, 0.00, 0.00, 0.00}},
    FrequencyRow{15, {0.00, 0.28, 0.00, 0.00, 0.00, 0.00}},
};
constexpr double kMostAsymmetry = radians(135.0);
constexpr double kPerDegree = 0.0032;

struct FrequencyFactor {
  double factor = 0.0;
  bool between = false;  // a row and a row of 0
};

FrequencyFactor frequency_factor(double frequency, LiftingTime time, double origin,
                                 const LiftConstants& constants) {
  const std::size_t column =
      2 * static_cast<std::size_t>(time) + (origin < constants.knuckles ? 0 : 1);
  if (frequency > kFrequencies.back().frequency) return {};
  const double f = max(frequency, kFrequencies.front().frequency);
  std::size_t k = 0;
  while (k + 2 < kFrequencies.size() && kFrequencies[k + 1].frequency <= f) ++k;
  const double low = kFrequencies[k].factors[column];
  const double high = kFrequencies[k + 1].factors[column];
  const double span = kFrequencies[k + 1].frequency - kFrequencies[k].frequency;
  const double part = (f - kFrequencies[k].frequency) / span;
  if (part >= 1.0) return {high, false};
  return {low + (high - low) * part, part > 0.0 && low > 0.0 && high == 0.0};
}

// A number of a lift with its name in messages.
using Given = std::pair<std::string_view, double>;
Result<void> check_numbers(std::initializer_list<Given> numbers) {
  for (const auto& [name, value] : numbers) {
    if (value >= 0.0 && is_finite(value)) continue;
    return fail(ErrorCode::invalid_argument, say("lift_number", value), std::string(name));
  }
  return {};
}

double grip_factor(Coupling coupling, bool low) {
  return coupling == Coupling::good ? 1.0 : coupling != Coupling::fair ? 0.9 : low ? 0.95 : 1.0;
}

}  // namespace

Result<LiftIndex> lift_index(const Lift& lift, const LiftConstants& c) {
  SHG_TRY(check_numbers({{"load", lift.load},
                         {"horizontal", lift.horizontal},
                         {"vertical", lift.vertical},
                         {"travel", lift.travel},
                         {"asymmetry", lift.asymmetry},
                         {"frequency", lift.frequency},
                         {"origin_vertical", lift.origin_vertical}}));
  LiftIndex index;
  if (lift.horizontal <= c.far) index.horizontal = c.near / max(lift.horizontal, c.near);
  if (lift.vertical <= c.high) {
    index.vertical = 1.0 - c.per_height * abs(lift.vertical - c.knuckles);
  }
  if (lift.travel <= c.longest_travel) {
    index.travel = 0.82 + c.of_travel / max(lift.travel, c.least_travel);
  }
  if (lift.asymmetry <= kMostAsymmetry) {
    index.asymmetry = 1.0 - kPerDegree * degrees(lift.asymmetry);
  }
  const FrequencyFactor often =
      frequency_factor(lift.frequency, lift.time, lift.origin_vertical, c);
  index.frequency = often.factor;
  index.between = often.between;
  index.coupling = grip_factor(lift.coupling, lift.vertical < c.knuckles);
  index.free_limit =
      c.load * index.horizontal * index.vertical * index.travel * index.asymmetry * index.coupling;
  index.limit = index.free_limit * index.frequency;
  if (index.limit > 0.0) index.index = lift.load / index.limit;
  const auto note = [&](bool applies, Message words) {
    if (applies) index.notes.push_back(std::move(words));
  };
  note(lift.horizontal > c.far, say("lift_too_far"));
  note(lift.vertical > c.high, say("lift_too_high"));
  note(lift.travel > c.longest_travel, say("lift_too_long"));
  note(lift.asymmetry > kMostAsymmetry, say("lift_too_turned"));
  note(!(often.factor > 0.0), say("lift_too_often", lift.frequency));
  note(often.between, say("lift_between", lift.frequency));
  return index;
}

Result<CompositeIndex> composite_index(std::span<const LiftTask> tasks,
                                       const LiftConstants& constants) {
  CompositeIndex composite;
  bool allowed = true;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const LiftTask& task = tasks[k];
    SHG_TRY(check_numbers({{"free_limit", task.free_limit},
                           {"greatest", task.greatest},
                           {"mean", task.mean},
                           {"frequency", task.frequency},
                           {"origin_vertical", task.origin_vertical}}));
    LiftTaskIndex own{k};
    own.frequency =
        frequency_factor(task.frequency, task.time, task.origin_vertical, constants).factor;
    own.limit = task.free_limit * own.frequency;
    if (own.limit > 0.0) {
      own.free_index = task.greatest / task.free_limit;
      own.index = task.mean / own.limit;
    } else {
      allowed = false;
    }
    composite.tasks.push_back(own);
  }
  if (composite.tasks.empty()) return composite;
  if (!allowed) {
    composite.notes.push_back(say("lift_none_allowed"));
    return composite;
  }
  std::stable_sort(composite.tasks.begin(), composite.tasks.end(),
                   [&](const LiftTaskIndex& a, const LiftTaskIndex& b) {
                     return a.index != b.index ? a.index > b.index
                                               : tasks[a.task].frequency > tasks[b.task].frequency;
                   });
  double often = 0.0;  // of the tasks so far
  double sum = 0.0;
  for (LiftTaskIndex& own : composite.tasks) {
    const LiftTask& task = tasks[own.task];
    const auto factor = [&](double frequency) {
      return frequency_factor(frequency, task.time, task.origin_vertical, constants).factor;
    };
    const double before = often;
    often += task.frequency;
    if (&own == composite.tasks.data()) {
      own.added = own.index;
    } else {
      const double now = factor(often);
      if (!(now > 0.0)) {
        composite.notes.push_back(say("lift_too_often", often));
        return composite;
      }
      own.added = own.free_index * (1.0 / now - 1.0 / factor(before));
    }
    sum += own.added;
  }
  composite.index = sum;
  return composite;
}

}  // namespace shigusa
