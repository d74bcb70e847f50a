// SPDX-License-Identifier: MIT
#include "recording.hpp"

#include <algorithm>
#include <array>

#include "core/index.hpp"
#include "human/at_ease.hpp"
#include "human/landmark_points.hpp"
#include "human/segment_mass.hpp"
#include "human/stance.hpp"
#include "math/axes.hpp"
#include "rig/trunk_and_legs.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

// Bones that the landmarks move with, in their order.
constexpr std::array kCarriers{Bone::left_upper_leg,
                               Bone::left_lower_leg,
                               Bone::left_foot,
                               Bone::left_foot,
                               Bone::right_upper_leg,
                               Bone::right_lower_leg,
                               Bone::right_foot,
                               Bone::right_foot,
                               Bone::left_upper_arm,
                               Bone::left_lower_arm,
                               Bone::left_hand,
                               Bone::left_hand,
                               Bone::right_upper_arm,
                               Bone::right_lower_arm,
                               Bone::right_hand,
                               Bone::right_hand,
                               Bone::neck,
                               Bone::head};

Vec3d mid_ankle(const Landmarks& person) {
  return (person.left_leg.ankle + person.right_leg.ankle) * 0.5;
}

TrunkAndLegs build_of(const Landmarks& person) {
  return {mid_shoulder(person) - mid_hip(person), mid_hip(person) - mid_ankle(person)};
}

double lowest(const Landmarks& person, const Vec3d& up) {
  double low = 1e300;
  for_each_landmark(person, [&](const char*, const Vec3d& p) { low = min(low, dot(p, up)); });
  return low;
}

// Indices of ±x, ±y, ±z.
constexpr std::size_t kAxisCount = 6;
std::size_t number_of(const Vec3d& axis) {
  const int k = main_axis(axis);
  return index(2 * k + (axis[k] < 0.0 ? 1 : 0));
}
Vec3d axis_of(std::size_t number) {
  Vec3d axis{};
  axis[static_cast<int>(number / 2)] = number % 2 == 0 ? 1.0 : -1.0;
  return axis;
}

}  // namespace

Recording::Recording(const CharacterFile& file, const HumanoidMap& map,
                     const MeasuredPerson& person, const std::vector<Transformd>& world)
    : skeleton_(file.skeleton),
      clip_(file.motion),
      map_(map),
      person_(person),
      world_(world),
      y_is_up_(file.rig.format != FileFormat::bvh),
      unread_(index(file.motion.frames), false) {
  for (const int frame : file.unread_frames) unread_[index(frame)] = true;
  // a trunk without neck and head moves with the parent of the arms
  const int chest = skeleton_.nodes[index(map[Bone::left_upper_arm])].parent;
  std::vector<bool> needed(skeleton_.nodes.size(), false);
  const auto carry = [&](Bone bone, const Vec3d& point) {
    const int own = map[bone] >= 0 ? map[bone] : bone == Bone::head ? map[Bone::neck] : -1;
    const int node = own >= 0 ? own : std::max(chest, 0);
    for (int i = node; i >= 0 && !needed[index(i)]; i = skeleton_.nodes[index(i)].parent) {
      needed[index(i)] = true;
    }
    return attach(node, point);
  };
  for_each_landmark(person.landmarks, [&](const char*, const Vec3d& point) {
    landmarks_.push_back(carry(kCarriers[landmarks_.size()], point));
  });
  for (const Side side : kBothSides) {
    const std::optional<SoleOutline>& sole = person.landmarks.leg(side).sole;
    for (std::size_t k = 0; sole && k < sole->size(); ++k) {
      corners_.push_back(carry(leg_bones(side)[2], (*sole)[k]));
    }
  }
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) needed_.push_back(static_cast<int>(i));
  }
  up_ = find_up();
}

Recording::Attached Recording::attach(int node, const Vec3d& point) const {
  const Placement& placement = person_.placement;
  const Vec3d p = point * (1.0 / placement.unit);
  const Vec3d in_file =
      placement.origin + placement.left * p.x + placement.up * p.y + placement.ahead * p.z;
  return {node, inverse(world_[index(node)]) * in_file};
}

// Landmarks in the file's axes and unit.
Landmarks Recording::in_file(int frame) const {
  std::vector<Transformd> placed(skeleton_.nodes.size());
  const LocalTransform* local = clip_.frame(skeleton_, frame);
  for (const int i : needed_) {
    const int parent = skeleton_.nodes[index(i)].parent;
    const Transformd own{to_matrix(local[i].rotation), local[i].translation};
    placed[index(i)] = parent < 0 ? own : placed[index(parent)] * own;
  }
  const auto at = [&](const Attached& a) { return placed[index(a.node)] * a.point; };
  Landmarks person;
  std::size_t next = 0;
  for_each_landmark(person, [&](const char*, Vec3d& point) { point = at(landmarks_[next++]); });
  next = 0;
  for (const Side side : kBothSides) {
    if (!person_.landmarks.leg(side).sole) continue;
    SoleOutline& sole = person.leg(side).sole.emplace();
    for (Vec3d& corner : sole) corner = at(corners_[next++]);
  }
  return person;
}

bool Recording::reads(int frame) const { return !unread_[index(frame)]; }

Landmarks Recording::at(int frame) const {
  Landmarks person = in_file(frame);
  const auto level = [&](const Vec3d& v) { return v - up_ * dot(v, up_); };
  const Vec3d across = normalized(person.left_leg.hip - person.right_leg.hip, {}) +
                       normalized(person.left_arm.shoulder - person.right_arm.shoulder, {});
  const Vec3d any = level(main_axis(up_) == 0 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0});
  const Vec3d left = normalized(level(across), normalized(any));
  const Vec3d ahead = cross(left, up_) * (person_.placement.mirrored() ? -1.0 : 1.0);
  const Placement placement{left, up_, ahead, mid_ankle(person), person_.placement.unit};
  for_each_point(person, [&](Vec3d& p) { p = placement.to_world(p); });
  double floor = 1e300;
  for (const Side side : kBothSides) {
    const Landmarks::Leg& leg = person.leg(side);
    const double sole = sole_outline(leg, person_.stature)[0].y;
    floor = min(floor, leg.sole ? sole : min(sole, leg.toe.y));
  }
  for_each_point(person, [&](Vec3d& p) { p.y -= floor; });
  return person;
}

// Finds the up axis. Standing alone does not determine it: lying people stand along another axis,
// and files with z up have OFFSETs along y.
Vec3d Recording::find_up() const {
  // statures from the file's 0 to the lowest joint, and least height of the hips, for a person on
  // the floor
  constexpr double kLow = -0.05;
  constexpr double kHigh = 0.15;
  constexpr double kHips = 0.02;
  struct Axis {
    bool on_floor = false;  // in most frames
    int stands = 0;         // frames
    bool rests = false;
    auto operator<=>(const Axis&) const = default;
  };
  std::array<Axis, kAxisCount> axes{};
  std::array<int, kAxisCount> on_floor{};
  const Vec3d rests = TrunkAndLegs::at_rest(skeleton_, map_).common_axis();
  if (y_is_up_ && rests == Vec3d{0, 1, 0}) return rests;
  int frames = 0;
  for (int frame = 0; frame < clip_.frames; frame += 1 + (clip_.frames - 1) / kFramesForUp) {
    if (!reads(frame)) continue;
    ++frames;
    const Landmarks person = in_file(frame);
    const Vec3d stands = build_of(person).common_axis();
    if (stands != Vec3d{}) ++axes[number_of(stands)].stands;
    const double per_stature = person_.placement.unit / person_.stature;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
      const double low = lowest(person, axis_of(k)) * per_stature;
      const double hips = dot(mid_hip(person), axis_of(k)) * per_stature;
      if (low >= kLow && low <= kHigh && hips >= kHips) ++on_floor[k];
    }
  }
  if (rests != Vec3d{}) axes[number_of(rests)].rests = true;
  for (std::size_t k = 0; k < kAxisCount; ++k) {
    axes[k].on_floor = 4 * on_floor[k] >= 3 * frames && (axes[k].stands > 0 || axes[k].rests);
  }
  const auto best = std::max_element(axes.begin(), axes.end());
  const bool none = best->stands == 0 && !best->rests;
  return none ? person_.placement.up : axis_of(static_cast<std::size_t>(best - axes.begin()));
}

bool Recording::stands_still(int frame) const {
  constexpr double kWindow = 0.05;  // s, before and after
  constexpr double kSpeed = 0.4;    // statures a second, of a foot or the pelvis
  const int reach = std::max(1, static_cast<int>(kWindow / clip_.frame_time + 0.5));
  const double most = kSpeed * person_.stature * reach * clip_.frame_time / person_.placement.unit;
  const Landmarks now = in_file(frame);
  for (const int other : {frame - reach, frame + reach}) {
    if (other < 0 || other >= clip_.frames || !reads(other)) continue;
    const Landmarks then = in_file(other);
    if (norm(then.left_leg.ankle - now.left_leg.ankle) > most ||
        norm(then.right_leg.ankle - now.right_leg.ankle) > most ||
        norm(mid_hip(then) - mid_hip(now)) > most) {
      return false;
    }
  }
  return true;
}

std::optional<int> Recording::first_stand(
    bool still, const std::function<bool(const Landmarks&)>& holds) const {
  constexpr double kApart = 0.25;  // s, between starts that are looked at closely
  const int apart = std::max(1, static_cast<int>(kApart / clip_.frame_time));
  int tried = 0;
  for (int frame = 0; frame < clip_.frames && tried < kStartsTried; ++frame) {
    if (!reads(frame)) continue;
    const Landmarks person = at(frame);
    if (!stands_on_both_feet(person, person_.stature) || spreads_arms(person)) continue;
    if (still && !stands_still(frame)) continue;
    if (holds(person)) return frame;
    ++tried;
    frame += apart - 1;
  }
  return std::nullopt;
}

}  // namespace shigusa
