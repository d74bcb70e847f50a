// SPDX-License-Identifier: MIT
#include "body/joint_name.hpp"

#include <algorithm>
#include <array>

namespace shigusa {
namespace {

constexpr std::string_view kLeft = "left_";
constexpr std::string_view kRight = "right_";

constexpr std::array<std::string_view, 6> kLegWords{"hip", "knee", "ankle", "toes", "foot", "leg"};

bool has_leg_word(std::string_view joint) {
  return std::any_of(kLegWords.begin(), kLegWords.end(),
                     [joint](std::string_view word) { return joint.find(word) != joint.npos; });
}

// A name shared by both legs or arms has no side: "hip" of a weight, "legs" of a contraction.
bool is_of_both_legs(std::string_view joint) {
  return joint == "legs" || std::find(kLegWords.begin(), kLegWords.end(), joint) != kLegWords.end();
}

// Value of a word, or `other`.
template <class Kind>
Kind kind_of(std::string_view word) {
  for (const EnumWord<Kind>& known : kEnumWords<Kind>) {
    if (known.word == word) return known.value;
  }
  return Kind::other;
}

LimbKind limb_of(const std::optional<Side>& side, std::string_view joint) {
  if (side) return has_leg_word(joint) ? LimbKind::leg : LimbKind::arm;
  if (is_of_both_legs(joint)) return LimbKind::leg;
  return joint == "arms" ? LimbKind::arm : LimbKind::trunk;
}

}  // namespace

std::string side_prefix(Side side) { return std::string(side == Side::left ? kLeft : kRight); }

std::string_view without_side(std::string_view name) {
  for (const std::string_view side : {kLeft, kRight}) {
    if (name.starts_with(side)) return name.substr(side.size());
  }
  return name;
}

JointPlace parse_joint_name(std::string_view name) {
  JointPlace part;
  if (name.starts_with(kLeft)) part.side = Side::left;
  if (name.starts_with(kRight)) part.side = Side::right;
  const std::string_view rest = without_side(name);
  const std::size_t dot = rest.find('.');
  part.joint = rest.substr(0, dot);
  if (dot != rest.npos) part.freedom = rest.substr(dot + 1);
  part.limb = limb_of(part.side, part.joint);
  part.joint_kind = kind_of<JointKind>(part.joint);
  part.freedom_kind = kind_of<FreedomKind>(part.freedom);
  return part;
}

std::string with_other_side(std::string_view name) {
  const std::string rest(without_side(name));
  if (name.starts_with(kLeft)) return std::string(kRight) + rest;
  if (name.starts_with(kRight)) return std::string(kLeft) + rest;
  return rest;
}

}  // namespace shigusa
