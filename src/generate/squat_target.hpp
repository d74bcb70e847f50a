// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/task.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace shigusa {

// The squat that a person has fixed, as the knees' flexion at the end. Weights and the other modes
// leave more or less of it, so the search is told how much. A later phase that is fixed to another
// squat ends somewhere between them, so that then there is no such target.
class SquatTarget {
 public:
  // None where the task fixes no squat.
  static std::optional<SquatTarget> of(const Task& task) {
    const std::optional<double> squat = fixed_value(task, "squat");
    if (!squat || fixed_value(task, "later.squat").value_or(*squat) != *squat) return std::nullopt;
    SquatTarget target;
    for (const char* knee : {"left_knee.flexion", "right_knee.flexion"}) {
      const std::optional<int> dof = task.body.find_dof(knee);
      if (!dof) continue;
      target.knees_.push_back(static_cast<std::size_t>(*dof));
      target.wanted_ += *squat + task.body.start()[target.knees_.back()];
    }
    if (target.knees_.empty()) return std::nullopt;
    return target;
  }

  // How far (rad) the mean of the knees' angles is off.
  [[nodiscard]] double off(std::span<const float> angles) const {
    double sum = -wanted_;
    for (const std::size_t knee : knees_) sum += static_cast<double>(angles[knee]);
    return abs(sum) / static_cast<double>(knees_.size());
  }

 private:
  static std::optional<double> fixed_value(const Task& task, std::string_view name) {
    if (!task.fixed) return std::nullopt;
    Parameters values = task.fixed->values;
    const Plan plan = whole_body_plan(task.body);
    const std::vector<Parameter> all = parameters_of(plan, values);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].info->name == name && task.fixed->set[i]) return all[i].value();
    }
    return std::nullopt;
  }

  std::vector<std::size_t> knees_;
  double wanted_ = 0.0;  // rad, of all knees together
};

// How near (rad) the target's motions come to it, what the search aims at, and what a radian off
// costs there; no criterion is 1 for more than that.
inline constexpr double kSquatSlack = radians(8.0);
inline constexpr double kSquatAim = radians(4.0);
inline constexpr double kSquatPull = 1.0;

}  // namespace shigusa
