// SPDX-License-Identifier: MIT
#include <shigusa/human.hpp>

#include "core/say.hpp"
#include "person_measurer.hpp"

namespace shigusa {

struct FileUnit {
  std::string_view name;
  double metres;
  bool rare = false;
};

namespace {

using F = StatureFractions;

// Length of a hand, as a share of the stature, below which it lacks its fingers.
constexpr double kShortHand = 0.05;
// Largest relative difference between left and right segments of one person.
constexpr double kSideAsymmetry = 0.1;

constexpr double kShortestPerson = 0.5;  // m
constexpr double kTallestPerson = 2.5;   // m
constexpr double kMeanStature = 1.7;     // m
// Statures (m) beyond which the unit is reported; between the plausible ones a second unit is too,
// unless it gives an unusual stature and the first a usual one.
constexpr double kUsualLow = 1.3;
constexpr double kUsualHigh = 2.1;
constexpr double kPlausibleLow = 0.8;
constexpr double kPlausibleHigh = 2.2;

// Share of legs, hip to ankle, in the stature of a child under kUsualLow, at most; an adult's is
// 0.49.
constexpr double kLegsOfChild = 0.46;

constexpr std::array<FileUnit, 6> kUnits{
    {{"metres", 1.0},
     {"centimetres", 0.01},
     {"millimetres", 0.001},
     {"decimetres", 0.1, true},
     {"inches", 0.0254, true},
     {"1/0.45 inch, the CMU database's unit", 0.0254 / 0.45, true}}};

bool is_person(double stature) { return stature >= kShortestPerson && stature <= kTallestPerson; }
// Whether a stature is evidence for its unit: for rare units only a usual stature, or that of a
// child with a child's proportions.
bool tells(const FileUnit& unit, double stature, double legs) {
  if (!unit.rare) return is_person(stature);
  const double least = legs < kLegsOfChild * stature ? kPlausibleLow : kUsualLow;
  return stature >= least && stature <= kPlausibleHigh;
}
bool is_usual(double stature) { return stature >= kUsualLow && stature <= kUsualHigh; }
double oddness(double stature) { return abs(stature - kMeanStature); }

}  // namespace

Result<void> PersonMeasurer::find_unit(const MeasureSettings& settings) {
  if (settings.stature) {
    result_.stature = *settings.stature;
    result_.placement.unit = *settings.stature / stature_;
    if (is_person(*settings.stature)) return {};
    return fail(ErrorCode::invalid_argument, say("stature_range", Metres{*settings.stature},
                                                 Metres{kShortestPerson}, Metres{kTallestPerson}));
  }
  const FileUnit* best = kUnits.data();
  for (const FileUnit& unit : kUnits) {
    if (oddness(stature_ * unit.metres) < oddness(stature_ * best->metres)) best = &unit;
  }
  const double legs = legs_ * best->metres;
  if (tells(*best, stature_ * best->metres, legs)) {
    result_.placement.unit = best->metres;
    result_.stature = stature_ * best->metres;
    doubt_unit(*best);
  } else {
    result_.placement.unit = kMeanStature / stature_;
    result_.stature = kMeanStature;
    result_.stature_guessed = true;
    doubt("stature_guessed", stature_, Metres{kShortestPerson}, Metres{kTallestPerson},
          Metres{kMeanStature});
  }
  return {};
}

void PersonMeasurer::doubt_unit(const FileUnit& best) {
  if (!is_usual(result_.stature)) {
    doubt("stature_unusual", Metres{result_.stature}, best.name);
  }
  for (const FileUnit& unit : kUnits) {
    const double stature = stature_ * unit.metres;
    if (&unit == &best || stature < kPlausibleLow || stature > kPlausibleHigh) continue;
    if (is_usual(result_.stature) && !is_usual(stature)) continue;
    doubt("unit_guessed", best.name, Metres{result_.stature}, unit.name, Metres{stature});
    return;
  }
  // only the stature supports it
  if (best.rare) doubt("unit_by_stature", best.name, Metres{result_.stature});
}

// Height (m) of the lowest point of a foot's sole above the world's zero.
double PersonMeasurer::sole(Side side) const {
  const Landmarks::Leg& l = result_.landmarks.leg(side);
  if (l.sole) return (*l.sole)[0].y;
  return min(l.ankle.y - F::kAnkleHeight * result_.stature, l.toe.y);
}

void PersonMeasurer::move_to_world() {
  const Vec3d between = (body().left_leg.ankle + body().right_leg.ankle) * 0.5;
  Placement& placement = result_.placement;
  placement = {left_, up_, ahead_, between, placement.unit};
  for_each_point(body(), [&](Vec3d& p) { p = placement.to_world(p); });
  double floor = min(sole(Side::left), sole(Side::right));
  // the file's own zero, if the soles are on it
  const double zero = -dot(between, up_) * placement.unit;
  if (body().left_leg.sole && abs(floor - zero) <= kFileFloor) floor = zero;
  for_each_point(body(), [&](Vec3d& p) { p.y -= floor; });
  placement.origin = between + up_ * (floor / placement.unit);
}

void PersonMeasurer::check_plausibility() {
  for (const Side side : kBothSides) {
    const bool by_mesh = leg(side).sole.has_value();
    if (sole(side) > kLiftedFoot) {
      doubt("foot_above", side_word(side), Metres{sole(side)});
    } else if (by_mesh && sole(side) > kFileFloor) {
      doubt("sole_above", side_word(side), Millimetres{1e3 * sole(side)});
    }
    const double hand = norm(arm(side).fingertip - arm(side).wrist);
    if (hand < kShortHand * result_.stature) {
      doubt("short_hand", side_word(side), Metres{hand});
    }
  }
  constexpr std::array kSegments{"thigh", "shank", "upper arm", "forearm"};
  const auto left = segment_lengths(body(), Side::left);
  const auto right = segment_lengths(body(), Side::right);
  for (std::size_t i = 0; i < kSegments.size(); ++i) {
    if (abs(left[i] - right[i]) <= kSideAsymmetry * max(left[i], right[i])) continue;
    doubt("unequal_segments", kSegments[i], Metres{left[i]}, Metres{right[i]});
  }
}

}  // namespace shigusa
