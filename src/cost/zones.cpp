// SPDX-License-Identifier: MIT
#include <shigusa/ergonomics.hpp>

namespace shigusa {
namespace {

using enum ZoneVerdict;

// Zones of a part, with the verdicts on held, rare and frequent postures. The standards EN 1005-4
// and ISO 11226 themselves were not read: the bands are those on which an ergonomics text and two
// programs agree, or one of them states; what only memory states is unknown.
struct Zone {
  ZonePart part;
  int zone;
  double over;  // rad, of zones from 0 up
  std::array<ZoneVerdict, 3> verdicts;
};
constexpr std::array kZones{
    Zone{ZonePart::trunk, -1, 0.0, {not_acceptable, unknown, unknown}},
    Zone{ZonePart::trunk, 0, -kPi, {acceptable, acceptable, acceptable}},
    Zone{ZonePart::trunk, 1, radians(20), {conditional, acceptable, conditional}},
    Zone{ZonePart::trunk, 2, radians(60), {not_acceptable, unknown, not_acceptable}},
    Zone{ZonePart::trunk_aside, 0, -kPi, {acceptable, acceptable, acceptable}},
    Zone{ZonePart::trunk_aside, 1, radians(10), {not_acceptable, conditional, not_acceptable}},
    Zone{ZonePart::upper_arm, 0, -kPi, {acceptable, acceptable, acceptable}},
    Zone{ZonePart::upper_arm, 1, radians(20), {conditional, acceptable, conditional}},
    Zone{ZonePart::upper_arm, 2, radians(60), {not_acceptable, conditional, not_acceptable}},
    Zone{ZonePart::head, -1, 0.0, {unknown, unknown, unknown}},
    Zone{ZonePart::head, 0, -kPi, {acceptable, acceptable, acceptable}},
    Zone{ZonePart::head, 1, radians(40), {not_acceptable, conditional, not_acceptable}},
    Zone{ZonePart::head_inclination, -1, 0.0, {not_acceptable, unknown, unknown}},
    Zone{ZonePart::head_inclination, 0, -kPi, {acceptable, unknown, unknown}},
    Zone{ZonePart::head_inclination, 1, radians(25), {conditional, unknown, unknown}},
    Zone{ZonePart::head_inclination, 2, radians(85), {not_acceptable, unknown, unknown}},
};
// Lean back that still counts as upright.
constexpr double kLeansBack = radians(5.0);

}  // namespace

int zone_of(ZonePart part, double angle) {
  int found = 0;
  for (const Zone& zone : kZones) {
    if (zone.part != part) continue;
    if (zone.zone < 0 ? angle < -kLeansBack : zone.zone > 0 && angle > zone.over) found = zone.zone;
  }
  return found;
}

ZoneVerdict zone_verdict(ZonePart part, int zone, Recurrence recurrence) {
  for (const Zone& row : kZones) {
    if (row.part == part && row.zone == zone) {
      return row.verdicts[static_cast<std::size_t>(recurrence)];
    }
  }
  return unknown;
}

}  // namespace shigusa
