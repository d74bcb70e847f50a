// SPDX-License-Identifier: MIT
// Soles and skull from the mesh; joints alone would leave them to a guess.
#include <algorithm>

#include "fitted_parts.hpp"
#include "person_measurer.hpp"

namespace shigusa {
namespace {

// Height of the layer of vertices that form a sole, as a share of the ankle's height over its
// lowest point.
constexpr double kSoleLayer = 0.3;
// Length of a sole, as a share of its foot, below which it is only the tip that the foot stands or
// hangs on.
constexpr double kTipOfFoot = 0.5;
// Cosine of the largest angle from straight ahead at which vertices determine a foot's direction.
constexpr double kForwards = 0.5;
// Length of a sole, as a share of an average foot, below which the leg ends in a peg.
constexpr double kPeg = 0.5;
// Breadth of a sole, as a share of the average, below which it is a sheet.
constexpr double kSheet = 0.1;
// Least horizontal share of a foot's direction.
constexpr double kLevel = 0.3;
// Half-widths of the middle of the head, which contains the vertex, as a share of its breadth and
// depth.
constexpr double kMiddle = 0.25;

struct Range {
  double low = 1e300;
  double high = -1e300;

  void add(double value) {
    low = min(low, value);
    high = max(high, value);
  }
  [[nodiscard]] double size() const { return high - low; }
  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

Range range_along(const std::vector<Vec3d>& points, const Vec3d& direction) {
  Range range;
  for (const Vec3d& p : points) range.add(dot(p, direction));
  return range;
}

}  // namespace

// Vertices of a foot and its descendants, no further from the ankle than the leg's length; for a
// foot without a mesh those of the shank, which ends in a peg or a boot.
std::vector<Vec3d> PersonMeasurer::flesh_of_foot(Side side) const {
  const auto [hip, knee, ankle] = leg_bones(side);
  const double leg = norm(at(hip) - at(knee)) + norm(at(knee) - at(ankle));
  for (const Bone bone : {ankle, knee}) {
    std::vector<Vec3d> points;
    for (const SkinVertex& vertex : tree_.skin()) {
      const bool hangs = vertex.node >= 0 && tree_.below(vertex.node, map_[bone]);
      if (hangs && norm(vertex.position - at(ankle)) <= leg) points.push_back(vertex.position);
    }
    if (!points.empty()) return points;
  }
  return {};
}

void PersonMeasurer::read_soles() {
  for (const Side side : kBothSides) {
    const std::vector<Vec3d> flesh = flesh_of_foot(side);
    if (flesh.empty()) continue;
    Landmarks::Leg& l = leg(side);
    const auto level = [&](const Vec3d& v) { return v - up_ * dot(v, up_); };
    Vec3d ahead = level(l.toe - l.ankle);
    if (norm(ahead) <= kLevel * norm(l.toe - l.ankle)) {
      Vec3d sum{};
      for (const Vec3d& p : flesh) sum += level(p - l.ankle);
      const Vec3d mean = sum * (1.0 / static_cast<double>(flesh.size()));
      const double breadth = range_along(flesh, left_).size();
      const bool forwards = dot(mean, ahead_) > kForwards * norm(mean);
      ahead = forwards && norm(mean) > 0.5 * kLevel * breadth ? mean : ahead_;
    }
    ahead = normalized(ahead, ahead_);
    l.sole = outline_of(flesh, l.ankle, ahead);
    const Vec3d front = ((*l.sole)[0] + (*l.sole)[3]) * 0.5;
    const double reach = dot(front - l.ankle, ahead);
    const double height = dot(l.ankle - front, up_);
    // straight ahead of the ankle, whatever the orientation of the sole
    if (reach > kLevel * abs(height)) l.toe = l.ankle + ahead * reach - up_ * height;
  }
}

// Left of a viewing direction, also in mirrored files.
Vec3d PersonMeasurer::left_of(const Vec3d& ahead) const {
  return cross(up_, ahead) * (dot(cross(up_, ahead_), left_) < 0.0 ? -1.0 : 1.0);
}

// The sole with another breadth.
SoleOutline PersonMeasurer::broadened(const SoleOutline& sole, double breadth) const {
  const Vec3d half = normalized(left_of(sole[0] - sole[1]), left_) * (0.5 * breadth);
  const Vec3d tip = (sole[0] + sole[3]) * 0.5;
  const Vec3d heel = (sole[1] + sole[2]) * 0.5;
  return {tip + half, heel + half, heel - half, tip - half};
}

// Corners of the sole, at the height of its lowest vertex; file units.
SoleOutline PersonMeasurer::outline_of(const std::vector<Vec3d>& flesh, const Vec3d& ankle,
                                       const Vec3d& ahead) const {
  const Vec3d left = left_of(ahead);
  const double low = range_along(flesh, up_).low;
  const double layer = low + kSoleLayer * max(dot(ankle, up_) - low, 0.0);
  std::vector<Vec3d> sole;
  for (const Vec3d& p : flesh) {
    if (dot(p, up_) <= layer) sole.push_back(p);
  }
  const Range whole = range_along(flesh, ahead);
  Range along = range_along(sole, ahead);
  Range across = range_along(sole, left);
  if (along.size() < kTipOfFoot * whole.size()) {
    along = whole;
    across = range_along(flesh, left);
  }
  const auto corner = [&](double forwards, double leftwards) {
    return ahead * forwards + left * leftwards + up_ * low;
  };
  return {corner(along.high, across.high), corner(along.low, across.high),
          corner(along.low, across.low), corner(along.high, across.low)};
}

// Replaces a peg or a sheet by an average sole, as nobody could stand on less.
void PersonMeasurer::widen_peg(Side side) {
  using F = StatureFractions;
  Landmarks::Leg& l = leg(side);
  if (!l.sole) return;
  SoleOutline& sole = *l.sole;
  const double length = F::kFootLength * stature_;
  const double breadth = F::kFootBreadth * stature_;
  if (norm(sole[0] - sole[1]) >= kPeg * length) {
    if (norm(sole[0] - sole[3]) < kSheet * breadth) sole = broadened(sole, breadth);
    return;
  }
  const Vec3d half =
      normalized(sole[0] - sole[3], left_) * (0.5 * max(norm(sole[0] - sole[3]), breadth));
  const Vec3d toe = l.toe - l.ankle;
  const Vec3d ahead = normalized(toe - up_ * dot(toe, up_), ahead_);
  const Vec3d below = l.ankle + up_ * dot(sole[0] - l.ankle, up_);
  const Vec3d tip = below + ahead * ((1.0 - kHeelShare) * length);
  const Vec3d heel = below - ahead * (kHeelShare * length);
  sole = {tip + half, heel + half, heel - half, tip - half};
}

// Vector from the head's joint straight up to the vertex (file units), from the mesh; empty if it
// shows no head. For a person who is not upright it is along the trunk.
std::optional<Vec3d> PersonMeasurer::skull_by_mesh() const {
  constexpr double kUpright = 0.9;
  const Vec3d trunk = normalized(mid_shoulder_ - mid_hip_, up_);
  const Vec3d up = dot(trunk, up_) > kUpright ? up_ : trunk;
  const Vec3d& joint = tree_.at(head_);
  std::vector<Vec3d> flesh =
      flesh_of(tree_.skin(), [&](const SkinVertex& vertex) { return vertex.node == head_; });
  if (flesh.size() < kFewestVertices) return std::nullopt;
  for (Vec3d& p : flesh) p = p - joint;
  const Vec3d deep = normalized(cross(left_, up), ahead_);
  const Range breadth = range_along(flesh, left_);
  const Range depth = range_along(flesh, deep);
  const double all = range_along(flesh, up).high;
  std::vector<double> heights;
  for (const Vec3d& p : flesh) heights.push_back(dot(p, up));
  const auto half = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), half, heights.end());
  Range over;  // the middle of the head
  for (const Vec3d& p : flesh) {
    if (abs(dot(p, left_) - breadth.middle()) > kMiddle * breadth.size()) continue;
    if (abs(dot(p, deep) - depth.middle()) > kMiddle * depth.size()) continue;
    over.add(dot(p, up));
  }
  // a coarse head may have no vertex there, or only a nose
  const double top = over.high > *half ? over.high : all;
  const double skull = min(top, kTallestSkull * max(breadth.size(), depth.size()));
  if (!(skull > 0.0)) return std::nullopt;
  return up * skull;
}

void PersonMeasurer::fit_parts() {
  if (!tree_.skin().empty()) body().parts = fitted_parts(tree_, map_, result_);
}

}  // namespace shigusa
