// SPDX-License-Identifier: MIT
#include "fitted_parts.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/index.hpp"
#include "human/part_shapes.hpp"
#include "limb_fit.hpp"
#include "person_measurer.hpp"
#include "rig/humanoid_names.hpp"

namespace shigusa {
namespace {

using Bone = HumanoidBone;

constexpr double kBehind = 0.5;         // share of vertices behind the trunk, where capes hang
constexpr double kOutermost = 0.02;     // share of a head's vertices left out at each side
constexpr double kLopsided = 0.33;      // offset to the side, share of half its breadth, beyond
                                        // which it is no head
constexpr double kThickestTrunk = 0.9;  // a trunk's radius, as a share of hips to shoulders
constexpr double kThicker = 1.3;        // ratio of thickness beyond which a limb has a shape of its
                                        // own

// Words in the names of bones that move soft tissue.
constexpr std::string_view kFleshWords[] = {"belly",   "tummy", "stomach", "breast",   "breasts",
                                            "bust",    "boob",  "pec",     "pectoral", "butt",
                                            "buttock", "glute", "胸",      "乳",       "腹"};

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
    const Landmarks::Leg& left = person_.left_leg;
    const Landmarks::Leg& right = person_.right_leg;
    const double thighs = 0.25 * norm(left.hip + left.knee - right.hip - right.knee);
    const double shanks = 0.25 * norm(left.knee + left.ankle - right.knee - right.ankle);
    fit_limbs(BodyPart::left_thigh, leg_bones, 0, thighs);
    fit_limbs(BodyPart::left_shank, leg_bones, 1, shanks);
    fit_limbs(BodyPart::left_upper_arm, arm_bones, 0);
    fit_limbs(BodyPart::left_forearm, arm_bones, 1);
    fit_hands();
    fit_trunk();
    // a mesh without a body's head, such as arrows at all bones, is no body
    if (map_[Bone::head] >= 0 && !fit_head()) return {};
    if (map_[Bone::neck] >= 0) fit_neck();
    return shapes_;
  }

  PartShapes fit_hands() {
    fit_limbs(BodyPart::left_hand, arm_bones, 2);
    return shapes_;
  }

 private:
  // Finds the bone of each node, and whether the node is that bone or lies on the path to another.
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
      if (is_flesh(tree_.node(static_cast<int>(i)).name)) own_[i] = true;
    }
  }

  // Whether a bone moves the body's own soft tissue, rather than hair or cloth.
  static bool is_flesh(std::string_view name) {
    const std::vector<std::string> words = words_of(name);
    return std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return std::find(std::begin(kFleshWords), std::end(kFleshWords), word) !=
             std::end(kFleshWords);
    });
  }

  // Vertices bound to one of the bones, in the coordinates of a frame.
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

  // Fits the limbs of both sides with one shape from the vertices of both; a limb that is thicker
  // than that, such as an armoured one, has its own.
  void fit_limbs(BodyPart left, const LimbBones& (*bones)(Side), std::size_t bone,
                 double room = 1e300) {
    std::array<LimbPoints, 2> limbs;
    std::array<Transformd, 2> along;
    LimbPoints both{.points = {},
                    .rises = left == BodyPart::left_thigh || left == BodyPart::left_hand,
                    .hand = left == BodyPart::left_hand};
    for (const Side side : kBothSides) {
      LimbPoints& limb = limbs[static_cast<std::size_t>(side)];
      const BodyPart part = of_side(left, side);
      Transformd& frame = along[static_cast<std::size_t>(side)];
      frame = limb_frame(part);
      limb = {.points = flesh({bones(side)[bone]}, false, frame),
              .length = limb_length(part, person_),
              .rises = both.rises,
              .hand = both.hand};
      both.length += 0.5 * limb.length;
      for (Vec3d p : limb.points) {
        p.x *= side_sign(side);
        both.points.push_back(p);
      }
    }
    const std::optional<PartShape> common = fit_limb(both, room);
    const std::array<std::optional<PartShape>, 2> owns{fit_limb(limbs[0], room),
                                                       fit_limb(limbs[1], room)};
    const bool unlike =
        owns[0] && owns[1] && (thicker(*owns[0], *owns[1]) || thicker(*owns[1], *owns[0]));
    for (const Side side : kBothSides) {
      const LimbPoints& limb = limbs[static_cast<std::size_t>(side)];
      std::optional<PartShape> own = owns[static_cast<std::size_t>(side)];
      if (common && !unlike) {
        own = common;
        for (Vec3d* at : {&own->from, &own->to, &own->aside}) at->x *= side_sign(side);
        own->to.y *= limb.length / both.length;
      }
      if (!own) continue;
      const BodyPart part = of_side(left, side);
      const Transformd to_part =
          inverse(part_frame(part, person_, frames_)) * along[static_cast<std::size_t>(side)];
      own->from = to_part * own->from;
      own->to = to_part * own->to;
      own->aside = to_part.rotation * own->aside;
      shapes_[part] = own;
    }
  }

  // Frame of a part with y along the limb; a hand may be bent relative to its forearm.
  [[nodiscard]] Transformd limb_frame(BodyPart part) const {
    Transformd frame = part_frame(part, person_, frames_);
    for (const Side side : kBothSides) {
      if (part != of_side(BodyPart::left_hand, side)) continue;
      const Landmarks::Arm& arm = person_.arm(side);
      frame.rotation = along_segment(frame.rotation, arm.wrist, arm.fingertip);
    }
    return frame;
  }

  static bool thicker(const PartShape& own, const PartShape& other) {
    return own.radius > kThicker * other.radius || own.to_radius > kThicker * other.to_radius;
  }

  void fit_trunk() {
    std::vector<Vec3d> points;
    for (const bool own : {true, false}) {
      points = flesh({Bone::hips, Bone::spine, Bone::chest, Bone::upper_chest, Bone::left_shoulder,
                      Bone::right_shoulder},
                     own, part_frame(BodyPart::trunk, person_, frames_));
      fit_trunk_piece(BodyPart::trunk, points);
      if (shapes_[BodyPart::trunk]) break;
    }
    if (person_.spine.empty()) return;
    for (const BodyPart piece : trunk_parts(person_)) fit_trunk_piece(piece, points);
  }

  void fit_trunk_piece(BodyPart part, const std::vector<Vec3d>& points) {
    const Transformd to_part = inverse(part_frame(part, person_, frames_));
    const TrunkPiece piece = trunk_piece(part, person_);
    const Vec3d from = to_part * piece.from;
    const Vec3d to = to_part * piece.to;
    const std::vector<Vec3d> within = between(points, from.y, to.y);
    const double line = 0.5 * (from.z + to.z);
    const Sectors about(within, 0.0, line, kInLimb);
    const Sectors caped(within, 0.0, line, kBehind);
    if (within.size() < kFewestVertices || !about.at(2) || !about.at(6)) {
      return fit_as_trunk(part, from, to, piece.last);
    }
    const double depth = 0.5 * (*about.at(2) + *caped.at(6));
    const double breadth = about.at(0) && about.at(4) ? 0.5 * (*about.at(0) + *about.at(4)) : depth;
    const Vec3d rise = (person_.left_arm.shoulder + person_.right_arm.shoulder -
                        person_.left_leg.hip - person_.right_leg.hip) *
                       0.5;
    const double radius =
        clamp(min(depth, breadth), kThinnest, max(kThickestTrunk * norm(rise), kThinnest));
    const double ahead = line + 0.5 * (*about.at(2) - *caped.at(6));
    // the upper end is round: its centre is a radius below
    const double top = piece.last ? max(to.y - radius, from.y) : to.y;
    const double aside = clamp(breadth - radius, 0.0, radius);
    shapes_[part] = {{from.x, from.y, ahead}, {to.x, top, ahead}, radius, radius, {aside, 0, 0}};
  }

  // Gives a piece with few vertices the thickness of the whole trunk.
  void fit_as_trunk(BodyPart part, const Vec3d& from, const Vec3d& to, bool last) {
    if (part == BodyPart::trunk || !shapes_[BodyPart::trunk]) return;
    PartShape shape = *shapes_[BodyPart::trunk];
    const double top = last ? max(to.y - shape.radius, from.y) : to.y;
    shape.from = {from.x, from.y, shape.from.z};
    shape.to = {to.x, top, shape.to.z};
    shapes_[part] = shape;
  }

  // Fits the head; false if its vertices do not form a head.
  bool fit_head() {
    const std::vector<Vec3d> points =
        flesh({Bone::head}, true, part_frame(BodyPart::head, person_, frames_));
    if (points.size() < kFewestVertices) return true;
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
    if (abs(middle(0)) > kLopsided * half(0)) return false;
    if (!(radius >= kThinnest)) return true;
    const Vec3d centre{middle(0), top - radius, middle(2)};
    // along the longer of breadth and depth; a flat head is two capsules side by side
    const Vec3d broad{max(half(0) - radius, 0.0), 0.0, 0.0};
    const Vec3d deep{0.0, 0.0, max(half(2) - radius, 0.0)};
    const bool across = broad.x > deep.z;
    const Vec3d& along = across ? broad : deep;
    shapes_[BodyPart::head] = {centre - along, centre + along, radius, radius,
                               across ? deep : broad};
    // down to the chin, below the skull's sphere
    const double chin = min(radius, max(kChin * radius, 0.5 * (top - low) - radius));
    Vec3d face = centre + Vec3d{0.0, 0.0, deep.z + radius - chin};
    Vec3d down = face;
    down.y = min(low + chin, face.y);
    shapes_[BodyPart::jaw] = {face, down, chin};
    return true;
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
  std::vector<bool> own_;  // (nodes) whether it is a bone, or lies above one
  PartShapes shapes_;
};

}  // namespace

PartShapes fitted_hands(const Skeleton& skeleton, const std::vector<Transformd>& world,
                        std::span<const SkinVertex> hands, const HumanoidMap& map,
                        const MeasuredPerson& person) {
  const SkeletonTree tree(skeleton, world, hands);
  return PartFitter(tree, map, person).fit_hands();
}

PartShapes fitted_parts(const SkeletonTree& tree, const HumanoidMap& map,
                        const MeasuredPerson& person) {
  return PartFitter(tree, map, person).fit();
}

}  // namespace shigusa
