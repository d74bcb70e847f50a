// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Search space of mixtures: weights on a logarithmic scale, each a coordinate in [0, 1].
namespace shigusa::bench {

// Range of a searched weight; one below kDropped is 0.
inline constexpr double kLeastWeight = 0.002;
inline constexpr double kMostWeight = 4.0;
inline constexpr double kDropped = 0.004;

// Mapping from points of a search to mixtures.
class MixtureSpace {
 public:
  // Weights of `fixed` for the criteria that ensure a possible motion, searched weights for the
  // others; with `scales`, the scales of those that compare with people are searched too.
  MixtureSpace(CriteriaSettings fixed, bool scales);

  [[nodiscard]] int genes() const { return static_cast<int>(members_.size()); }
  [[nodiscard]] CriteriaSettings mixture(std::span<const double> point) const;
  [[nodiscard]] std::vector<double> point(const CriteriaSettings& mixture) const;

 private:
  struct Member {
    double* (*of)(CriteriaSettings&, const std::string&);
    std::string name;
    double least;
    double most;
    bool weight;
  };
  CriteriaSettings fixed_;
  std::vector<Member> members_;
};

// Sets "name=weight,name.scale=value,…", names as in task files.
[[nodiscard]] Result<void> set_weights(std::string_view text, CriteriaSettings& mixture);

// Weights in the format of set_weights, "joint_range=0.25,…".
[[nodiscard]] std::string weights_text(const CriteriaSettings& mixture);
// Lines for default_criteria().
[[nodiscard]] std::string weights_code(const CriteriaSettings& mixture);
// The criteria of a task file.
[[nodiscard]] std::string weights_json(const CriteriaSettings& mixture);

}  // namespace shigusa::bench
