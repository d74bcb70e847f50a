// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <shigusa/body/anthropometry.hpp>
#include <shigusa/body/human_body.hpp>
#include <shigusa/body/landmarks.hpp>
#include <shigusa/core/check.hpp>
#include <utility>

#include "humanoid_names.hpp"
#include "humanoid_shape.hpp"
#include "skeleton_tree.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;
using F = StatureFractions;

// From the ankle joint to the tip of the toes, along the floor.
constexpr double kToeAhead = (1.0 - kHeelShare) * F::kFootLength;
// The vertex is at least this share of the stature beyond the head's joint.
constexpr double kLeastSkull = 0.05;
// A hand shorter than this share of the stature lacks its fingers.
constexpr double kShortHand = 0.05;
// Left and right segments of one person differ by less than this share.
constexpr double kAsymmetry = 0.1;

constexpr double kShortestPerson = 0.5;  // m
constexpr double kTallestPerson = 2.5;   // m
constexpr double kMeanStature = 1.7;     // m
// Beyond these statures (m) the unit is worth a look; between the wider two a second unit is too.
constexpr double kUsualLow = 1.3;
constexpr double kUsualHigh = 2.1;
constexpr double kPlausibleLow = 0.8;
constexpr double kPlausibleHigh = 2.2;

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits{{{"metres", 1.0},
                                      {"centimetres", 0.01},
                                      {"millimetres", 0.001},
                                      {"inches", 0.0254},
                                      {"1/0.45 inch, the CMU database's unit", 0.0254 / 0.45}}};

bool is_person(double stature) { return stature >= kShortestPerson && stature <= kTallestPerson; }
double oddness(double stature) { return abs(stature - kMeanStature); }

std::string_view side_word(Side side) { return side == Side::left ? "left" : "right"; }

struct LegBones {
  Bone hip, knee, ankle;
};
struct ArmBones {
  Bone shoulder, elbow, wrist;
};
LegBones leg_bones(Side side) {
  return side == Side::left
             ? LegBones{Bone::left_upper_leg, Bone::left_lower_leg, Bone::left_foot}
             : LegBones{Bone::right_upper_leg, Bone::right_lower_leg, Bone::right_foot};
}
ArmBones arm_bones(Side side) {
  return side == Side::left
             ? ArmBones{Bone::left_upper_arm, Bone::left_lower_arm, Bone::left_hand}
             : ArmBones{Bone::right_upper_arm, Bone::right_lower_arm, Bone::right_hand};
}

constexpr std::array kSides{Side::left, Side::right};

// The coordinate axis nearest to a direction, as a unit vector.
Vec3d nearest_axis(const Vec3d& v) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (abs(v[i]) > abs(v[axis])) axis = i;
  }
  Vec3d unit{};
  unit[axis] = v[axis] < 0.0 ? -1.0 : 1.0;
  return unit;
}

std::string axis_name(const Vec3d& axis) {
  const double sum = axis.x + axis.y + axis.z;
  const char* letter = axis.x != 0.0 ? "x" : axis.y != 0.0 ? "y" : "z";
  return std::string(sum < 0.0 ? "-" : "+") + letter;
}

// The direction of a trunk and legs in one posture.
struct Build {
  Vec3d trunk;  // from between the hips to between the shoulders
  Vec3d legs;   // from between the ankles to between the hips

  // The axis that both point along, or 0.
  [[nodiscard]] Vec3d common_axis() const {
    constexpr double kAlong = 0.8;
    const Vec3d axis = nearest_axis(legs);
    const bool both = dot(axis, normalized(legs)) > kAlong && dot(axis, normalized(trunk)) > kAlong;
    return both ? axis : Vec3d{};
  }
};

// Measures in the file's units and axes first, then moves the result into shigusa's world.
class Measurer {
 public:
  Measurer(const Skeleton& skeleton, const std::vector<Transformd>& world, const HumanoidMap& map)
      : skeleton_(skeleton), tree_(skeleton, world), map_(map) {
    for (int bone = 0; bone < kHumanoidBoneCount; ++bone) {
      const int node = map.node[static_cast<std::size_t>(bone)];
      const Bone b = static_cast<Bone>(bone);
      const bool optional = b == Bone::neck || b == Bone::head || b == Bone::left_toes ||
                            b == Bone::right_toes || b >= Bone::spine;
      SHG_CHECK((node >= 0 || optional) && node < tree_.size(),
                "a mapped node for " + std::string(humanoid_bone_name(b)));
    }
  }

  Result<MeasuredPerson> measure(const MeasureSettings& settings) {
    if (auto done = read_limbs(); !done) return tl::unexpected<Error>(done.error());
    up_ = find_up();
    if (auto done = find_left(); !done) return tl::unexpected<Error>(done.error());
    read_tips();
    stature_ = measure_stature();
    place_missing_tips();
    find_grips();
    if (auto done = find_unit(settings); !done) return tl::unexpected<Error>(done.error());
    move_to_world();
    check_plausibility();
    return std::move(result_);
  }

 private:
  template <class... Args>
  void doubt(fmt::format_string<Args...> format, Args&&... args) {
    result_.doubts.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  [[nodiscard]] const Vec3d& at(Bone bone) const { return tree_.at(map_[bone]); }
  Landmarks& body() { return result_.landmarks; }
  Landmarks::Leg& leg(Side side) { return side == Side::left ? body().left_leg : body().right_leg; }
  Landmarks::Arm& arm(Side side) { return side == Side::left ? body().left_arm : body().right_arm; }

  [[nodiscard]] Result<void> check_length(Side side, std::string_view segment, Bone a,
                                          Bone b) const {
    if (tree_.apart(map_[a], map_[b])) return {};
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("the {} {} has no length: {} and {} stand at one point", side_word(side),
                    segment, tree_.described(map_[a]), tree_.described(map_[b])));
  }

  Result<void> read_limbs() {
    for (const Side side : kSides) {
      const auto [hip, knee, ankle] = leg_bones(side);
      const auto [shoulder, elbow, wrist] = arm_bones(side);
      for (const auto& checked :
           {check_length(side, "thigh", hip, knee), check_length(side, "shank", knee, ankle),
            check_length(side, "upper arm", shoulder, elbow),
            check_length(side, "forearm", elbow, wrist)}) {
        if (!checked) return checked;
      }
      leg(side) = {at(hip), at(knee), at(ankle), at(ankle)};
      arm(side) = {at(shoulder), at(elbow), at(wrist), at(wrist)};
    }
    mid_hip_ = (body().left_leg.hip + body().right_leg.hip) * 0.5;
    mid_shoulder_ = (body().left_arm.shoulder + body().right_arm.shoulder) * 0.5;
    return {};
  }

  Vec3d find_up() {
    const Vec3d ankles = (body().left_leg.ankle + body().right_leg.ankle) * 0.5;
    const Vec3d posture = Build{mid_shoulder_ - mid_hip_, mid_hip_ - ankles}.common_axis();
    const Vec3d rest = rest_build().common_axis();
    const Vec3d none{};
    if (posture != none) {
      if (rest != none && rest != posture) {
        doubt("up is {} in this posture, but {} at rest: the posture is followed",
              axis_name(posture), axis_name(rest));
      }
      return posture;
    }
    const Vec3d rise = mid_shoulder_ - ankles;
    if (rest != none && dot(rest, rise) > 0.0) return rest;
    doubt("the body does not stand: up is taken as {}, from its feet to its shoulders",
          axis_name(nearest_axis(rise)));
    return nearest_axis(rise);
  }

  [[nodiscard]] Build rest_build() const {
    const std::vector<Vec3d> rest = rest_origins(skeleton_);
    const auto mid = [&](Bone a, Bone b) {
      return (rest[static_cast<std::size_t>(map_[a])] + rest[static_cast<std::size_t>(map_[b])]) *
             0.5;
    };
    const Vec3d hips = mid(Bone::left_upper_leg, Bone::right_upper_leg);
    return {mid(Bone::left_upper_arm, Bone::right_upper_arm) - hips,
            hips - mid(Bone::left_foot, Bone::right_foot)};
  }

  Result<void> find_left() {
    const Vec3d hips = body().left_leg.hip - body().right_leg.hip;
    const Vec3d shoulders = body().left_arm.shoulder - body().right_arm.shoulder;
    const Vec3d both = normalized(hips, {}) + normalized(shoulders, {});
    const Vec3d level = both - up_ * dot(both, up_);
    constexpr double kLeast = 0.2;
    if (norm(level) < kLeast) {
      return fail(ErrorCode::invalid_argument,
                  fmt::format("the facing cannot be told: along {}, which is taken as up, the left "
                              "hip and shoulder stand above, below or at the right ones",
                              axis_name(up_)));
    }
    left_ = normalized(level);
    ahead_ = cross(left_, up_);
    if (feet_point_backwards(tree_, map_)) {
      ahead_ = -ahead_;
      doubt("the feet point backwards: the person was mirrored, so that left stays left");
    }
    return {};
  }

  [[nodiscard]] BonePart part(int i) const { return read_bone_name(tree_.node(i).name).part; }

  // The tips that the file has; where it has none, the limb ends at its last joint.
  void read_tips() {
    const auto is_thumb = [&](int i) { return part(i) == BonePart::thumb; };
    for (const Side side : kSides) {
      leg(side).toe = tree_.at(tree_.farthest(map_[leg_bones(side).ankle]));
      arm(side).fingertip = tree_.at(tree_.farthest(map_[arm_bones(side).wrist], is_thumb));
    }
    neck_ = map_[Bone::neck];
    head_ = map_[Bone::head];
    body().neck = neck_ >= 0 ? tree_.at(neck_) : mid_shoulder_;
    read_further_joints();
    if (head_ < 0) {
      head_tip_ = neck_ >= 0 && tree_.farthest(neck_) != neck_ ? tree_.farthest(neck_) : -1;
      return;
    }
    for (const int child : tree_.children(head_)) {
      const bool tip = tree_.node(child).end_site || part(child) == BonePart::tip;
      if (tip && head_tip_ < 0 && tree_.apart(child, head_)) head_tip_ = child;
    }
  }

  // Those of the extent human, as far as the file has them.
  void read_further_joints() {
    for (const Bone bone : {Bone::spine, Bone::chest, Bone::upper_chest}) {
      if (map_[bone] >= 0) body().spine.push_back(at(bone));
    }
    if (neck_ >= 0 && head_ >= 0 && tree_.apart(neck_, head_)) body().head = tree_.at(head_);
    if (map_[Bone::left_shoulder] >= 0) arm(Side::left).clavicle = at(Bone::left_shoulder);
    if (map_[Bone::right_shoulder] >= 0) arm(Side::right).clavicle = at(Bone::right_shoulder);
  }

  // Length of the way along the bones between two nodes.
  [[nodiscard]] double way(int a, int b) const {
    const int meet = tree_.common_ancestor(a, b);
    double length = 0.0;
    for (int end : {a, b}) {
      for (; end != meet; end = tree_.node(end).parent) {
        length += norm(tree_.at(end) - tree_.at(tree_.node(end).parent));
      }
    }
    return length;
  }

  // From between the hips to the neck.
  [[nodiscard]] double trunk_length(double leg_length) const {
    const int hips = map_[Bone::hips];
    const int chest =
        tree_.common_ancestor(map_[Bone::left_upper_arm], map_[Bone::right_upper_arm]);
    const Vec3d neck = neck_ >= 0 ? tree_.at(neck_) : mid_shoulder_;
    const int last = neck_ >= 0 ? neck_ : chest;
    const double to_hips = norm(tree_.at(hips) - mid_hip_);
    // hips far from the hip joints are a root on the floor, and hips below them would count the way
    // up to them twice: the straight way then
    constexpr double kClearly = 0.05;
    const Vec3d trunk = neck - mid_hip_;
    const bool low_hips = dot(mid_hip_ - tree_.at(hips), trunk) > kClearly * dot(trunk, trunk);
    if (last < 0 || tree_.common_ancestor(hips, last) < 0 || to_hips > 0.5 * leg_length ||
        low_hips) {
      return norm(neck - mid_hip_);
    }
    return to_hips + way(hips, last) + norm(neck - tree_.at(last));
  }

  double measure_stature() {
    double legs = 0.0;
    for (const Side side : kSides) {
      legs += 0.5 * (norm(leg(side).hip - leg(side).knee) + norm(leg(side).knee - leg(side).ankle));
    }
    const double below_neck = legs + trunk_length(legs);
    if (head_ >= 0) {
      head_length_ = neck_ >= 0 ? way(neck_, head_) : norm(tree_.at(head_) - mid_shoulder_);
    }
    if (head_tip_ >= 0) {
      head_length_ = head_ >= 0 ? head_length_ + norm(tree_.at(head_tip_) - tree_.at(head_))
                                : way(neck_, head_tip_);
      return (below_neck + head_length_) / (1.0 - F::kAnkleHeight);
    }
    const double stature = below_neck / (1.0 - F::kAnkleHeight - F::kHeadLength);
    if (head_length_ + kLeastSkull * stature <= F::kHeadLength * stature) {
      head_length_ = F::kHeadLength * stature;
      return stature;
    }
    const double tall = (below_neck + head_length_) / (1.0 - F::kAnkleHeight - kLeastSkull);
    head_length_ += kLeastSkull * tall;
    return tall;
  }

  void place_missing_tips() {
    for (const Side side : kSides) {
      Landmarks::Leg& l = leg(side);
      if (l.toe == l.ankle) {
        const Vec3d shank = normalized(l.knee - l.ankle);
        const Vec3d turned = cross(left_, shank) * (dot(ahead_, cross(left_, up_)));
        l.toe = l.ankle + normalized(turned, ahead_) * (kToeAhead * stature_) -
                shank * (F::kAnkleHeight * stature_);
        doubt("nothing follows {}: the {} foot is taken as level, of average length",
              tree_.described(map_[leg_bones(side).ankle]), side_word(side));
      }
      Landmarks::Arm& a = arm(side);
      if (a.fingertip == a.wrist) {
        a.fingertip = a.wrist + normalized(a.wrist - a.elbow) * (F::kHand * stature_);
        doubt("nothing follows {}: the {} hand is taken as straight, of average length",
              tree_.described(map_[arm_bones(side).wrist]), side_word(side));
      }
    }
    if (head_tip_ >= 0) {
      body().head_top = tree_.at(head_tip_);
      return;
    }
    const Vec3d trunk = normalized(body().neck - mid_hip_, up_);
    const Vec3d head = head_ >= 0 ? tree_.at(head_) - body().neck : Vec3d{};
    body().head_top = body().neck + normalized(head, trunk) * head_length_;
    doubt("the head has no tip: the top of the head is placed by average proportions");
  }

  // A goal's effector is a node of the file, so that anybody finds it there.
  void find_grips() {
    for (const Side side : kSides) {
      Landmarks::Arm& a = arm(side);
      const Vec3d nominal = grip_of(a);
      const int hand = map_[arm_bones(side).wrist];
      int best = hand;
      std::vector<int> open{hand};
      while (!open.empty()) {
        const int i = open.back();
        open.pop_back();
        if (part(i) == BonePart::thumb || tree_.node(i).end_site) continue;
        if (norm(tree_.at(i) - nominal) < norm(tree_.at(best) - nominal)) best = i;
        open.insert(open.end(), tree_.children(i).rbegin(), tree_.children(i).rend());
      }
      a.grip = tree_.at(best);
      result_.grip_nodes[static_cast<std::size_t>(side)] = best;
    }
  }

  Result<void> find_unit(const MeasureSettings& settings) {
    if (settings.stature) {
      result_.stature = *settings.stature;
      result_.placement.unit = *settings.stature / stature_;
      if (is_person(*settings.stature)) return {};
      return fail(ErrorCode::invalid_argument,
                  fmt::format("a stature of {:g} m; {} to {} m are allowed", *settings.stature,
                              kShortestPerson, kTallestPerson));
    }
    const Unit* best = kUnits.data();
    for (const Unit& unit : kUnits) {
      if (oddness(stature_ * unit.metres) < oddness(stature_ * best->metres)) best = &unit;
    }
    result_.placement.unit = best->metres;
    result_.stature = stature_ * best->metres;
    if (!is_person(result_.stature)) {
      return fail(
          ErrorCode::invalid_argument,
          fmt::format("no unit gives a person of {} to {} m: along the bones the file's is "
                      "{:g} units tall, {:g} m in {}; the stature must be given",
                      kShortestPerson, kTallestPerson, stature_, result_.stature, best->name));
    }
    doubt_unit(*best);
    return {};
  }

  void doubt_unit(const Unit& best) {
    if (result_.stature < kUsualLow || result_.stature > kUsualHigh) {
      doubt("a stature of {:.2f} m is unusual; the unit is taken as {}", result_.stature,
            best.name);
    }
    for (const Unit& unit : kUnits) {
      const double stature = stature_ * unit.metres;
      if (&unit == &best || stature < kPlausibleLow || stature > kPlausibleHigh) continue;
      doubt("the unit is taken as {}, a stature of {:.2f} m; it could be {}, {:.2f} m", best.name,
            result_.stature, unit.name, stature);
    }
  }

  // Height of the lowest part of a foot's sole (m, above the world's zero).
  [[nodiscard]] double sole(Side side) const {
    const Landmarks::Leg& l = result_.landmarks.leg(side);
    return min(l.ankle.y - F::kAnkleHeight * result_.stature, l.toe.y);
  }

  void move_to_world() {
    const Vec3d between = (body().left_leg.ankle + body().right_leg.ankle) * 0.5;
    const auto move = [&](Vec3d& p) {
      const Vec3d d = (p - between) * result_.placement.unit;
      p = {dot(d, left_), dot(d, up_), dot(d, ahead_)};
    };
    const auto each = [&](const auto& action) {
      for (const Side side : kSides) {
        for (Vec3d* p : {&leg(side).hip, &leg(side).knee, &leg(side).ankle, &leg(side).toe}) {
          action(*p);
        }
        for (Vec3d* p :
             {&arm(side).shoulder, &arm(side).elbow, &arm(side).wrist, &arm(side).fingertip}) {
          action(*p);
        }
        action(*arm(side).grip);
        if (arm(side).clavicle) action(*arm(side).clavicle);
      }
      for (Vec3d& joint : body().spine) action(joint);
      if (body().head) action(*body().head);
      action(body().neck);
      action(body().head_top);
    };
    each(move);
    const double floor = min(sole(Side::left), sole(Side::right));
    each([&](Vec3d& p) { p.y -= floor; });
    result_.placement = {left_, up_, ahead_, between + up_ * (floor / result_.placement.unit),
                         result_.placement.unit};
  }

  void check_plausibility() {
    for (const Side side : kSides) {
      if (sole(side) > kLiftedFoot) {
        doubt("the {} foot is {:.2f} m above the floor", side_word(side), sole(side));
      }
      const double hand = norm(arm(side).fingertip - arm(side).wrist);
      if (hand < kShortHand * result_.stature) {
        doubt("the {} hand is only {:.3f} m long: its fingers are missing", side_word(side), hand);
      }
    }
    const Landmarks& b = result_.landmarks;
    const auto compare = [&](std::string_view segment, double left, double right) {
      if (abs(left - right) <= kAsymmetry * max(left, right)) return;
      doubt("the left {} is {:.3f} m long, the right one {:.3f} m", segment, left, right);
    };
    compare("thigh", norm(b.left_leg.hip - b.left_leg.knee),
            norm(b.right_leg.hip - b.right_leg.knee));
    compare("shank", norm(b.left_leg.knee - b.left_leg.ankle),
            norm(b.right_leg.knee - b.right_leg.ankle));
    compare("upper arm", norm(b.left_arm.shoulder - b.left_arm.elbow),
            norm(b.right_arm.shoulder - b.right_arm.elbow));
    compare("forearm", norm(b.left_arm.elbow - b.left_arm.wrist),
            norm(b.right_arm.elbow - b.right_arm.wrist));
  }

  const Skeleton& skeleton_;
  SkeletonTree tree_;
  const HumanoidMap& map_;
  MeasuredPerson result_;
  Vec3d up_{};  // directions in the file's axes
  Vec3d left_{};
  Vec3d ahead_{};
  Vec3d mid_hip_{};
  Vec3d mid_shoulder_{};
  int neck_ = -1;
  int head_ = -1;
  int head_tip_ = -1;
  double head_length_ = 0.0;  // neck to vertex, file units
  double stature_ = 0.0;      // file units
};

}  // namespace

Vec3d grip_of(const Landmarks::Arm& arm) {
  return arm.grip.value_or(arm.wrist + (arm.fingertip - arm.wrist) * kGripFraction);
}

Vec3d Placement::to_world(const Vec3d& p) const {
  const Vec3d d = (p - origin) * unit;
  return {dot(d, left), dot(d, up), dot(d, ahead)};
}

Result<MeasuredPerson> measure_person(const Skeleton& skeleton,
                                      const std::vector<Transformd>& world, const HumanoidMap& map,
                                      const MeasureSettings& settings) {
  return Measurer(skeleton, world, map).measure(settings);
}

}  // namespace shigusa
