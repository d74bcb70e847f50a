// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body_model.hpp>
#include <shigusa/words.hpp>
#include <string_view>

namespace shigusa {

/// The sex that tables of masses and strengths are taken for.
enum class Sex {
  male,    ///< of the tables of men
  female,  ///< of the tables of women
};
/// The words of Sex.
template <>
inline constexpr std::array kEnumWords<Sex>{EnumWord{Sex::male, "male"},
                                            EnumWord{Sex::female, "female"}};

/// A standing person's build.
struct BodyBuild {
  double stature = 1.741;   ///< m, 0.5..2.5
  double mass = 73.0;       ///< kg, 2..300
  Sex sex = Sex::male;      ///< of the tables
  Side base = Side::right;  ///< the foot that bears the body
  bool heels = false;       ///< they may lift; of human_body
};

/// Standing height (m) of the group's mean.
[[nodiscard]] double mean_stature(Sex sex);

/// Mass in kg of a person of that stature with the body-mass index of the group's mean.
[[nodiscard]] double default_mass(double stature, Sex sex);

/// Standing height (m) that 5, 50 or 95 of a hundred people do not exceed, by the names "p5", "p50"
/// and "p95"; nothing for other names. Source: C. Gordon et al., 1988 Anthropometric Survey of U.S.
/// Army Personnel, Natick TR-89/044 (1989), stature.
[[nodiscard]] std::optional<double> stature_percentile(std::string_view name, Sex sex);

}  // namespace shigusa
