// SPDX-License-Identifier: MIT
#include <algorithm>
#include <initializer_list>

#include "core/index.hpp"
#include "part_shapes.hpp"
#include "person_measurer.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

constexpr std::size_t kSectors = 8;
constexpr std::size_t kFewestSectors = 4;
constexpr double kEnds = 0.1;           // share of a limb at either end that its neighbours shape
constexpr double kInLimb = 0.75;        // shares of vertices: of a sector of a limb, …
constexpr double kInTrunk = 0.5;        // … and of the trunk; …
constexpr double kOutermost = 0.02;     // … of a head those left out at each side
constexpr double kThickest = 0.75;      // a limb's radius, as a share of its length
constexpr double kThickestTrunk = 0.6;  // the trunk's, of hips to shoulders
constexpr double kThinnest = 0.005;     // m

// The value that a share of the values does not exceed; there must be some.
double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

// Distances of points from a line along y, by eight directions about it: the first is x, the third
// z.
class Sectors {
 public:
  Sectors(const std::vector<Vec3d>& points, double x, double z, double share) {
    std::array<std::vector<double>, kSectors> values;
    for (const Vec3d& p : points) {
      const double turn = atan2(p.z - z, p.x - x) * (kSectors / kTwoPi) + kSectors + 0.5;
      const auto sector = static_cast<std::size_t>(turn) % kSectors;
      values[sector].push_back(sqrt((p.x - x) * (p.x - x) + (p.z - z) * (p.z - z)));
    }
    for (std::size_t s = 0; s < kSectors; ++s) {
      if (values[s].empty()) continue;
      distance_[s] = quantile(std::move(values[s]), share);
      ++filled_;
    }
  }

  [[nodiscard]] std::size_t filled() const { return filled_; }
  [[nodiscard]] const std::optional<double>& at(std::size_t sector) const {
    return distance_[sector];
  }
  // of all directions the middle one
  [[nodiscard]] double middle() const {
    std::vector<double> known;
    for (const auto& distance : distance_) {
      if (distance) known.push_back(*distance);
    }
    return quantile(std::move(known), 0.5);
  }
  // How far the middle of a circle at these distances is off the line: the first term of their
  // Fourier series. Where a direction is empty nothing.
  [[nodiscard]] Vec3d off() const {
    Vec3d sum{};
    if (filled_ < kSectors) return sum;
    for (std::size_t s = 0; s < kSectors; ++s) {
      const SinCos<double> towards = sin_cos(static_cast<double>(s) * (kTwoPi / kSectors));
      sum += Vec3d{towards.cos, 0.0, towards.sin} * (*distance_[s] * (2.0 / kSectors));
    }
    return sum;
  }

 private:
  std::array<std::optional<double>, kSectors> distance_{};
  std::size_t filled_ = 0;
};

class PartFitter {
 public:
  PartFitter(const SkeletonTree& tree, const HumanoidMap& map, const MeasuredPerson& measured)
      : tree_(tree),
        map_(map),
        measured_(measured),
        person_(measured.landmarks),
        frames_(human_frames(measured.landmarks)) {
    find_bones();
  }

  PartShapes fit() {
    for (const Side side : kBothSides) {
      const auto [hip, knee, ankle] = leg_bones(side);
      const auto [shoulder, elbow, wrist] = arm_bones(side);
      const Landmarks::Leg& leg = person_.leg(side);
      const Landmarks::Arm& arm = person_.arm(side);
      const Landmarks::Leg& other = person_.leg(side == Side::left ? Side::right : Side::left);
      const double thighs = 0.25 * norm(leg.hip + leg.knee - other.hip - other.knee);
      const double shanks = 0.25 * norm(leg.knee + leg.ankle - other.knee - other.ankle);
      fit_limb(of_side(BodyPart::left_thigh, side), hip, norm(leg.knee - leg.hip), thighs);
      fit_limb(of_side(BodyPart::left_shank, side), knee, norm(leg.ankle - leg.knee), shanks);
      fit_limb(of_side(BodyPart::left_upper_arm, side), shoulder, norm(arm.elbow - arm.shoulder));
      fit_limb(of_side(BodyPart::left_forearm, side), elbow, norm(arm.wrist - arm.elbow));
      fit_limb(of_side(BodyPart::left_hand, side), wrist, norm(arm.fingertip - arm.wrist));
    }
    fit_trunk();
    if (map_[Bone::head] >= 0) fit_head();
    if (map_[Bone::neck] >= 0) fit_neck();
    return shapes_;
  }

 private:
  // The bone that each node goes with, and whether it is that bone or lies on the way to another.
  void find_bones() {
    bone_.assign(static_cast<std::size_t>(tree_.size()), -1);
    own_.assign(bone_.size(), false);
    for (const Bone bone : kHumanoidBones) {
      int node = map_[bone];
      if (node < 0) continue;
      bone_[index(node)] = static_cast<int>(bone);
      for (; node >= 0 && !own_[index(node)]; node = tree_.node(node).parent) {
        own_[index(node)] = true;
      }
    }
    for (std::size_t i = 0; i < bone_.size(); ++i) {
      const int parent = tree_.node(static_cast<int>(i)).parent;
      if (bone_[i] < 0 && parent >= 0) bone_[i] = bone_[index(parent)];
    }
  }

  // The vertices that go with one of the bones, in a frame of the world.
  [[nodiscard]] std::vector<Vec3d> flesh(std::initializer_list<Bone> bones, bool own,
                                         const Transformd& frame) const {
    const Transformd to_part = inverse(frame);
    std::vector<Vec3d> points = flesh_of(tree_.skin(), [&](const SkinVertex& vertex) {
      if (vertex.node < 0 || (own && !own_[index(vertex.node)])) return false;
      return std::any_of(bones.begin(), bones.end(), [&](Bone bone) {
        return bone_[index(vertex.node)] == static_cast<int>(bone);
      });
    });
    for (Vec3d& p : points) p = to_part * measured_.placement.to_world(p);
    return points;
  }

  static std::vector<Vec3d> between(const std::vector<Vec3d>& points, double low, double high) {
    std::vector<Vec3d> within;
    for (const Vec3d& p : points) {
      if (p.y >= low && p.y <= high) within.push_back(p);
    }
    return within;
  }

  // A limb from its joint at y = 0 down to -length.
  void fit_limb(BodyPart part, Bone bone, double length, double room = 1e300) {
    const std::vector<Vec3d> all = flesh({bone}, false, part_frame(part, person_, frames_));
    std::vector<Vec3d> points = between(all, (kEnds - 1.0) * length, -kEnds * length);
    // a coarse limb has vertices at its ends alone
    if (points.size() < kFewestVertices)
      points = between(all, -(1.0 + kEnds) * length, kEnds * length);
    const auto column = round_column(points, min(kThickest * length, room));
    if (!column) return;
    shapes_[part] = {{column->from.x, 0.0, column->from.z},
                     {column->from.x, -length, column->from.z},
                     column->radius};
  }

  // A line along y through the middle of the points, and how far they lie about it.
  static std::optional<PartShape> round_column(const std::vector<Vec3d>& points, double thickest) {
    if (points.size() < kFewestVertices) return std::nullopt;
    Sectors about(points, 0.0, 0.0, kInLimb);
    if (about.filled() < kFewestSectors) return std::nullopt;
    const double rough = min(about.middle(), thickest);
    Vec3d centre = about.off();
    // a bone lies within its limb
    centre = centre * min(1.0, 0.5 * rough / max(norm(centre), 1e-9));
    about = Sectors(points, centre.x, centre.z, kInLimb);
    if (about.filled() < kFewestSectors) return std::nullopt;
    const double radius = clamp(about.middle(), kThinnest, max(thickest, kThinnest));
    return PartShape{centre, centre, radius};
  }

  void fit_trunk() {
    const std::vector<Vec3d> points =
        flesh({Bone::hips, Bone::spine, Bone::chest, Bone::upper_chest, Bone::left_shoulder,
               Bone::right_shoulder},
              true, part_frame(BodyPart::trunk, person_, frames_));
    fit_trunk_piece(BodyPart::trunk, points);
    const std::size_t joints = std::min(person_.spine.size(), kSpineJoints);
    for (std::size_t j = 0; joints > 0 && j <= joints; ++j) {
      fit_trunk_piece(static_cast<BodyPart>(static_cast<std::size_t>(BodyPart::pelvis) + j),
                      points);
    }
  }

  void fit_trunk_piece(BodyPart part, const std::vector<Vec3d>& points) {
    const Transformd to_part = inverse(part_frame(part, person_, frames_));
    const TrunkPiece piece = trunk_piece(part, person_);
    const Vec3d from = to_part * piece.from;
    const Vec3d to = to_part * piece.to;
    const std::vector<Vec3d> within = between(points, from.y, to.y);
    if (within.size() < kFewestVertices) return;
    const double line = 0.5 * (from.z + to.z);
    const Sectors about(within, 0.0, line, kInTrunk);
    if (!about.at(2) || !about.at(6)) return;
    const double depth = 0.5 * (*about.at(2) + *about.at(6));
    const double breadth = about.at(0) && about.at(4) ? 0.5 * (*about.at(0) + *about.at(4)) : depth;
    const Vec3d rise = (person_.left_arm.shoulder + person_.right_arm.shoulder -
                        person_.left_leg.hip - person_.right_leg.hip) *
                       0.5;
    const double radius =
        clamp(min(depth, breadth), kThinnest, max(kThickestTrunk * norm(rise), kThinnest));
    const double ahead = line + 0.5 * (*about.at(2) - *about.at(6));
    // the upper end is round: it begins a radius within
    const double top = piece.last ? max(to.y - radius, from.y) : to.y;
    shapes_[part] = {{from.x, from.y, ahead}, {to.x, top, ahead}, radius};
  }

  void fit_head() {
    const std::vector<Vec3d> points =
        flesh({Bone::head}, true, part_frame(BodyPart::head, person_, frames_));
    if (points.size() < kFewestVertices) return;
    const auto at = [&](int axis, double share) {
      std::vector<double> values;
      for (const Vec3d& p : points) values.push_back(p[axis]);
      return quantile(std::move(values), share);
    };
    const auto half = [&](int axis) {
      return 0.5 * (at(axis, 1.0 - kOutermost) - at(axis, kOutermost));
    };
    const auto middle = [&](int axis) {
      return 0.5 * (at(axis, 1.0 - kOutermost) + at(axis, kOutermost));
    };
    const double top = dot(frames_.trunk.cy, person_.head_top - head_joint(person_));
    const double low = min(at(1, kOutermost), top);
    const double radius = min(min(half(0), half(2)), 0.5 * (top - low));
    if (!(radius >= kThinnest)) return;
    const Vec3d centre{middle(0), top - radius, middle(2)};
    // along the longer of breadth and depth
    const Vec3d reach{max(half(0) - radius, 0.0), 0.0, max(half(2) - radius, 0.0)};
    const Vec3d along = reach.x > reach.z ? Vec3d{reach.x, 0.0, 0.0} : Vec3d{0.0, 0.0, reach.z};
    shapes_[BodyPart::head] = {centre - along, centre + along, radius};
    // down to the chin, where the skull does not reach
    const double chin = min(radius, max(kChin * radius, 0.5 * (top - low) - radius));
    Vec3d face = centre + Vec3d{0.0, 0.0, along.z + radius - chin};
    Vec3d down = face;
    down.y = min(low + chin, face.y);
    shapes_[BodyPart::jaw] = {face, down, chin};
  }

  void fit_neck() {
    const Vec3d joint = head_joint(person_);
    const Transformd along{along_segment(frames_.trunk, joint, person_.neck), joint};
    const double length = norm(joint - person_.neck);
    const std::vector<Vec3d> points = between(flesh({Bone::neck}, true, along), -length, 0.0);
    const double thickest = shapes_[BodyPart::head] ? shapes_[BodyPart::head]->radius : length;
    const auto column = round_column(points, thickest);
    if (!column) return;
    const Transformd to_part = inverse(part_frame(BodyPart::neck, person_, frames_)) * along;
    const Vec3d bottom = column->from - Vec3d{0.0, length, 0.0};
    shapes_[BodyPart::neck] = {to_part * bottom, to_part * column->from, column->radius};
  }

  static constexpr double kChin = 0.75;  // the jaw's radius, as a share of the skull's

  const SkeletonTree& tree_;
  const HumanoidMap& map_;
  const MeasuredPerson& measured_;
  const Landmarks& person_;
  HumanFrames frames_;
  std::vector<int> bone_;  // (nodes) the nearest humanoid bone at or above, or -1
  std::vector<bool> own_;  // (nodes) it is a bone, or lies above one
  PartShapes shapes_;
};

}  // namespace

PartShapes fitted_parts(const SkeletonTree& tree, const HumanoidMap& map,
                        const MeasuredPerson& person) {
  return PartFitter(tree, map, person).fit();
}

}  // namespace shigusa
