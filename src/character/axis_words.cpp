// SPDX-License-Identifier: MIT
#include <array>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>

#include "body/joint_name.hpp"
#include "core/say.hpp"

namespace shigusa {
namespace {

const std::array<std::string, 3> kAxes{"palm", "thumb", "fingers"};
const std::array<std::string, 8> kDirections{"up",    "down", "left", "right",
                                             "ahead", "back", "in",   "out"};
// Directions of the words; in and out are those of a right hand.
constexpr std::array<Vec3d, 8> kToward{
    {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}}};
// Sine of the angle below which two directions count as parallel.
constexpr double kAlong = 0.05;

// a frame with x along a, y as near to b as that allows
Mat3d frame_of(const Vec3d& a, const Vec3d& b) {
  const Vec3d x = normalized(a);
  const Vec3d z = normalized(cross(x, b));
  return {x, cross(z, x), z};
}

// Side of a hand's effector; empty for other effectors.
std::optional<Side> side_of_hand(std::string_view effector) {
  const JointPlace part = parse_joint_name(effector);
  const bool hand = part.joint_kind == JointKind::hand || part.joint_kind == JointKind::wrist;
  return hand ? part.side : std::nullopt;
}

}  // namespace

std::span<const std::string> hand_axis_words() { return kAxes; }
std::span<const std::string> direction_words() { return kDirections; }

Result<Vec3d> hand_axis(std::string_view word, std::string_view effector) {
  const std::optional<Side> side = side_of_hand(effector);
  const bool left = side == Side::left;
  if (!side) {
    return fail(ErrorCode::invalid_argument, say("hand_axis_alone", effector.substr(0, 80)),
                std::string(word));
  }
  if (word == kAxes[0]) return Vec3d{left ? -1.0 : 1.0, 0, 0};
  if (word == kAxes[1]) return Vec3d{0, 0, 1};
  if (word == kAxes[2]) return Vec3d{0, -1, 0};
  return fail(ErrorCode::invalid_argument, unknown_name("axis", word, kAxes));
}

Result<Vec3d> direction_named(std::string_view word, std::string_view hand) {
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    const bool turned = (word == "in" || word == "out") && side_of_hand(hand) == Side::left;
    if (kDirections[i] == word) return turned ? -kToward[i] : kToward[i];
  }
  return fail(ErrorCode::invalid_argument, unknown_name("direction", word, kDirections));
}

Result<Quatd> rotation_pointing(const Vec3d& a, const Vec3d& to_a, const Vec3d& b,
                                const Vec3d& to_b) {
  if (!(norm(cross(normalized(to_a), normalized(to_b))) > kAlong)) {
    return fail(ErrorCode::invalid_argument, say("square_axes"));
  }
  return to_quat(frame_of(to_a, to_b) * transpose(frame_of(a, b)));
}

}  // namespace shigusa
