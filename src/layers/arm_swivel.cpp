// SPDX-License-Identifier: MIT
#include "layers/arm_swivel.hpp"

#include <array>

#include "core/check.hpp"
#include "motion/minimum_jerk.hpp"

namespace shigusa {
namespace {

// The part of v across the unit vector u, as a unit vector.
Vec3d square_to(const Vec3d& u, const Vec3d& v) { return normalized(v - dot(u, v) * u); }

// v, square to u, after the shortest turn from u to w; both are unit vectors.
Vec3d carried(const Vec3d& v, const Vec3d& u, const Vec3d& w) {
  const double both = 1.0 + dot(u, w);
  // about half a turn any axis is as short, so v's own will do
  if (both < 1e-9) return v;
  return square_to(w, v - (dot(v, w) / both) * (u + w));
}

Vec3d turned_about(const Vec3d& axis, const Vec3d& square, double angle) {
  const SinCos<double> turn = sin_cos(angle);
  return turn.cos * square + turn.sin * cross(axis, square);
}

// Two unit vectors that are square to each other, and the third.
Mat3d frame_of(const Vec3d& along, const Vec3d& axis) { return {along, axis, cross(along, axis)}; }

// The hand in the upper arm's frame.
Vec3d hand_at(const HingedLimb& segments, double bend) {
  const double length = segments.length(bend);
  const SinCos<double> direction = sin_cos(segments.direction(bend));
  return {segments.across(), length * direction.cos, length * direction.sin};
}

constexpr Vec3d kHinge{1, 0, 0};

// The first of an arm's freedoms beyond the elbow, and how often the last wrist is taken anew.
constexpr std::size_t kForearm = 4;
constexpr int kWristSteps = 60;
constexpr double kWristTolerance = 1e-11;  // rad

// Turns about y, z and x, in this order, that make the rotation; |z| ≤ 90°.
std::array<double, 3> wrist_turns(const Mat3d& rotation) {
  const Vec3d& x = rotation.cx;
  const double y_turn = atan2(-x.z, x.x);
  const double z_turn = atan2(x.y, sqrt(x.x * x.x + x.z * x.z));
  const Mat3d rest =
      transpose(shigusa::rotation(Axis::y, y_turn) * shigusa::rotation(Axis::z, z_turn)) * rotation;
  return {y_turn, z_turn, atan2(rest.cy.z, rest.cy.y)};
}

}  // namespace

SwivelArm::SwivelArm(const BodyModel& arm, const BodyLimb& limb)
    : arm_(&arm), limb_(limb), outwards_(arm.dof(1).sign) {
  SHG_CHECK(arm.dof_count() == kArmDofs || arm.dof_count() == kTurningArmDofs,
            "an arm has four freedoms, or seven");
  limb_.flexion = 0;
  limb_.abduction = 1;
  limb_.rotation = 2;
  limb_.hinge = 3;
}

std::vector<SwivelArm::Line> SwivelArm::lines_of(std::span<const Vec3d> path, double swivel) const {
  const std::span<const double> q = arm_->start();
  const Mat3d start = ball_rotation(limb_.turns_of(*arm_, q));
  Vec3d along = normalized(start * hand_at(limb_.segments, q[3]));
  Vec3d axis = square_to(along, start * kHinge);
  std::vector<Line> lines{{along, axis, norm(path[0])}};
  for (std::size_t f = 1; f < path.size(); ++f) {
    const double distance = norm(path[f]);
    const Vec3d before = along;
    // a hand in the shoulder's centre has no direction of its own
    if (distance > 1e-9) along = (1.0 / distance) * path[f];
    axis = carried(axis, before, along);
    const double tau = static_cast<double>(f) / static_cast<double>(path.size() - 1);
    const Vec3d turned = turned_about(along, axis, outwards_ * swivel * minimum_jerk(tau));
    lines.push_back({along, turned, distance});
  }
  return lines;
}

SwivelArm::Placed SwivelArm::place(const HingedLimb& segments, const Line& line, double bend) {
  const double across = segments.across();
  const double square = line.distance * line.distance - across * across;
  Placed placed;
  placed.bend = unwrapped(segments.bend(sqrt(max(square, 0.0))), bend);
  const Vec3d hand = hand_at(segments, placed.bend);
  placed.reach = norm(hand);
  const Vec3d own = (1.0 / placed.reach) * hand;
  placed.upper = frame_of(line.along, line.axis) * transpose(frame_of(own, square_to(own, kHinge)));
  return placed;
}

HingedLimb SwivelArm::segments_at(std::span<const double> q) const {
  Vec3d hand = arm_->effectors()[0].point;
  for (std::size_t d = q.size() - 1; d >= kForearm; --d) {
    const Dof& dof = arm_->dof(static_cast<int>(d));
    hand = dof.offset + rotation(dof.axis, dof.sign * q[d]) * hand;
  }
  const Dof& elbow = arm_->dof(limb_.hinge);
  return HingedLimb(elbow.offset, hand, elbow.sign);
}

Mat3d SwivelArm::wrist_rotation(std::span<const double> q) const {
  Mat3d turned{};
  for (std::size_t d = kForearm; d < q.size(); ++d) {
    const Dof& dof = arm_->dof(static_cast<int>(d));
    turned = turned * rotation(dof.axis, dof.sign * q[d]);
  }
  return turned;
}

void SwivelArm::turn_hand(const EffectorTurn& turn, const Line& line, std::span<double> q) const {
  const Dof& elbow = arm_->dof(limb_.hinge);
  double change = 1.0;
  for (int k = 0; k < kWristSteps && change > kWristTolerance; ++k) {
    const Placed placed = place(segments_at(q), line, q[3]);
    const Mat3d forearm = placed.upper * rotation(Axis::x, elbow.sign * placed.bend);
    const Mat3d hand = forearm * wrist_rotation(q);
    // what turns about the axis is nobody's wish, and the wrist does not
    const Mat3d wanted = turn.kind == Turning::whole
                             ? turn.goal
                             : rotation_by(turn_between(hand * turn.axis, turn.direction)) * hand;
    const std::array<double, 3> turns = wrist_turns(transpose(forearm) * wanted);
    change = 0.0;
    for (std::size_t w = 0; w < turns.size(); ++w) {
      double& angle = q[kForearm + w];
      const double next = arm_->dof(static_cast<int>(kForearm + w)).sign * turns[w];
      change = max(change, abs(next - angle));
      angle = next;
    }
  }
}

double SwivelArm::run(std::span<const Vec3d> path, double swivel, std::vector<double>& angles,
                      const EffectorTurn& turn) const {
  const std::span<const double> start = arm_->start();
  std::vector<double> q(start.begin(), start.end());
  angles.assign(q.begin(), q.end());
  const std::vector<Line> lines = lines_of(path, swivel);
  const bool turns = turn.kind != Turning::free && q.size() > kForearm;
  std::vector<double> last = q;
  if (turns) turn_hand(turn, lines.back(), last);
  HingedLimb segments = limb_.segments;
  double worst = 0.0;
  for (std::size_t f = 1; f < path.size(); ++f) {
    if (turns) {
      const double share =
          minimum_jerk(static_cast<double>(f) / static_cast<double>(path.size() - 1));
      for (std::size_t d = kForearm; d < q.size(); ++d) {
        q[d] = start[d] + (last[d] - start[d]) * share;
      }
      segments = segments_at(q);
    }
    const Placed placed = place(segments, lines[f], q[3]);
    q[3] = placed.bend;
    limb_.put_turns(*arm_, ball_turns(placed.upper, limb_.turns_of(*arm_, q)), q);
    const double miss = abs(lines[f].distance - placed.reach);
    // NaN counts as far off
    worst = miss < 1e9 ? max(worst, miss) : 1e9;
    angles.insert(angles.end(), q.begin(), q.end());
  }
  return worst;
}

}  // namespace shigusa
