// SPDX-License-Identifier: MIT
#include "read_back.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/formats.hpp>

#include "character/character_places.hpp"
#include "character/character_rig.hpp"
#include "character_export.hpp"
#include "core/say.hpp"
#include "formats/gltf_animation.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "math/linear_map.hpp"

namespace shigusa {
namespace {

// Threshold below which a node's motion gets no track (see rig_motion).
constexpr double kStill = 1e-6;  // m

// Deviations beyond which a file counts as wrong; smaller ones are invisible.
constexpr double kSeenLength = 1e-3;  // m
constexpr double kSeenTurn = radians(0.1);

// Rounding of a BVH: three angles of six decimals of a degree; lengths of 1e-8 m.
constexpr ReadBackDigits kBvhDigits{3.0 * 0.5e-6 * kPi / 180.0, kStill + 1e-8, 0.0};
// Rounding of 32-bit floats: the four numbers of a unit quaternion are rounded by 2⁻²⁵ each, and
// the rotation error is twice the root of their squares' sum; lengths are rounded by 2⁻²⁴ relative.
constexpr ReadBackDigits kFloatDigits{4.0 / (1 << 25), kStill, 2.0 / (1 << 24)};

// Whether the node and its ancestors are scaled uniformly; other scales are not expressible as
// rotations.
bool scaled_evenly(const Rig& rig, int node) {
  for (; node >= 0; node = rig.nodes[static_cast<std::size_t>(node)].parent) {
    const Vec3d& s = rig.nodes[static_cast<std::size_t>(node)].scale;
    const double largest = max(abs(s.x), max(abs(s.y), abs(s.z)));
    const double smallest = min(abs(s.x), min(abs(s.y), abs(s.z)));
    if (largest - smallest > 1e-6 * largest) return false;
  }
  return true;
}

// Nearest node, from this one upwards, that is not part of a finger.
int without_fingers(const Rig& rig, int node) {
  const auto is_finger = [&](const FingerBone& finger) { return finger.node == node; };
  while (std::any_of(rig.fingers.begin(), rig.fingers.end(), is_finger)) {
    node = rig.nodes[static_cast<std::size_t>(node)].parent;
  }
  return node;
}

// Whether a segment shares its twist with other bones, so that it does not turn as the body's does.
bool is_twist_segment(std::string_view body_node) {
  const auto& segments = twist_segments();
  return std::any_of(segments.begin(), segments.end(), [&](const TwistSegment& segment) {
    return humanoid_bone_name(segment.bone) == body_node;
  });
}

tl::unexpected<Error> unreadable(const char* format, const Message& why) {
  return fail(ErrorCode::unsupported, say("not_read_back", why),
              std::string("the format ") + format);
}

// (nodes of the character) placements under a VRM animation's bones.
std::vector<Transformd> played(const CharacterRig& rig, const std::vector<int>& bone_of,
                               const std::vector<Transformd>& bones) {
  // players turn a character of VRM 0.x about, to face +Z as the animation does
  const double sign = rig.ahead.z < 0.0 ? -1.0 : 1.0;
  std::vector<Transformd> places;
  for (std::size_t i = 0; i < rig.skeleton.nodes.size(); ++i) {
    const SkeletonNode& node = rig.skeleton.nodes[i];
    const Vec3d offset{sign * node.offset.x, node.offset.y, sign * node.offset.z};
    const Transformd above =
        node.parent < 0 ? Transformd{} : places[static_cast<std::size_t>(node.parent)];
    Transformd place{above.rotation, above * offset};
    if (bone_of[i] >= 0) place.rotation = bones[static_cast<std::size_t>(bone_of[i])].rotation;
    // bone lengths are constant, except for the hips, which come first
    if (bone_of[i] == 0) place.translation = bones[0].translation;
    places.push_back(place);
  }
  return places;
}

}  // namespace

ReadBackCheck::ReadBackCheck(const CharacterSpec& character, const Task& task,
                             const Candidate& candidate, const Clip& clip, bool in_place)
    : character_(character), task_(task), body_(task.body), clip_(clip), in_place_(in_place) {
  if (character.rig) start_ = start_places(task, character.rig->rig);
  for (const GoalResult& goal : candidate.goals) {
    add_mark(goal.asked.effector, goal.node, false, goal.turn.error.has_value());
  }
  for (const ContactResult& contact : candidate.contacts) {
    add_mark(contact.effector, contact.node, true, true);
  }
}

void ReadBackCheck::add_mark(const std::string& name, const std::string& body_node, bool foot,
                             bool turns) {
  const auto nodes = body_.nodes();
  const auto found = std::find_if(nodes.begin(), nodes.end(),
                                  [&](const BodyNode& node) { return node.name == body_node; });
  if (found == nodes.end()) return;
  const int node = static_cast<int>(found - nodes.begin());
  turns = turns && !is_twist_segment(body_node);
  Mark mark{name, foot, turns, node, node, found->link, found->point};
  if (character_.rig) {
    mark.node = rig_node(character_, body_node);
    if (mark.node < 0) return;
    mark.turned = without_fingers(character_.rig->rig, mark.node);
    mark.point = in_link(mark.link, start_[static_cast<std::size_t>(mark.node)]);
    // the goal refers to the effector's point, wherever the file has its node
    const auto effector = foot ? std::nullopt : body_.find_effector(name);
    if (effector) mark.point = body_.effector(*effector).point;
  }
  marks_.push_back(std::move(mark));
}

ReadBackCheck::Mark ReadBackCheck::hips() const {
  const auto nodes = body_.nodes();
  const auto named = std::find_if(nodes.begin(), nodes.end(), [&](const BodyNode& node) {
    return character_.rig && node.name == humanoid_bone_name(HumanoidBone::hips);
  });
  const BodyNode& node = named == nodes.end() ? nodes.front() : *named;
  Mark mark;
  mark.link = node.link;
  mark.point = node.point;
  if (character_.rig) {
    const int bone = character_.rig->rig.bones[HumanoidBone::hips];
    mark.point = in_link(mark.link, start_[static_cast<std::size_t>(bone)]);
  }
  return mark;
}

Vec3d ReadBackCheck::in_link(int link, const Vec3d& at_start) const {
  const Kinematics<double> start = home_kinematics(task_);
  return transpose_times(start.link_rotation(link), at_start - start.link_origin(link));
}

ReadBackCheck::Places ReadBackCheck::in_world(Places places, double unit) const {
  if (!character_.rig || !character_.rig->rig.placement.mirrored()) {
    for (Transformd& node : places) node.translation = node.translation * unit;
    return places;
  }
  // a mirrored file keeps its own axes
  const Placement& file = character_.rig->rig.placement;
  const Mat3d axes = transpose(Mat3d{file.left, file.up, file.ahead});
  for (Transformd& node : places) {
    node = {axes * node.rotation * transpose(axes),
            file.to_world(node.translation * (unit / file.unit))};
  }
  return places;
}

ReadBackCheck::FileMotion ReadBackCheck::file_motion(const char* format, const SkeletonClip& clip,
                                                     const Skeleton& nodes,
                                                     const ReadBackDigits& digits) {
  FileMotion motion{.format = format,
                    .frames = clip.frames,
                    .frame_time = clip.frame_time,
                    .parents = {},
                    .node_of = {},
                    .digits = digits,
                    .places = {}};
  for (const SkeletonNode& node : nodes.nodes) {
    motion.node_of.push_back(static_cast<int>(motion.node_of.size()));
    motion.parents.push_back(node.parent);
  }
  return motion;
}

Result<ReadBack> ReadBackCheck::bvh(std::string_view bytes) const {
  const Result<BvhFile> file = parse_bvh_file(bytes, "bvh");
  if (!file) return unreadable("bvh", file.error().to_message());
  const SkeletonMotion& motion = file->motion;
  const Skeleton own = character_.rig ? character_.rig->skeleton : body_skeleton(body_);
  const std::vector<int> order = bvh_order(own);
  if (order.size() != motion.skeleton.nodes.size()) return unreadable("bvh", say("other_nodes"));
  FileMotion back = file_motion("bvh", motion.clip, motion.skeleton, kBvhDigits);
  for (std::size_t k = 0; k < order.size(); ++k) {
    back.node_of[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  }
  const double unit = bvh_unit(character_);
  back.places = [&](int frame) {
    return in_world(world_transforms(motion.skeleton, motion.clip, frame), unit);
  };
  return compare(back, marks_);
}

Result<ReadBack> ReadBackCheck::glb(std::string_view bytes, const std::string& animation) const {
  const Result<GltfMotion> file = parse_gltf_animation(
      bytes, "glb", {.animation = animation, .frame_rate = 1.0 / clip_.frame_time});
  if (!file) return unreadable("glb", file.error().to_message());
  const CharacterRig* const rig = character_.rig.get();
  const SkeletonMotion& motion = file->motion;
  const std::vector<int>& in_file = file->character.file_node;
  FileMotion back = file_motion("glb", motion.clip, motion.skeleton, kFloatDigits);
  if (rig == nullptr) {
    // the mannequin's file lists the body's nodes first
    for (std::size_t node = 0; node < body_.nodes().size(); ++node) {
      const auto at = std::find(in_file.begin(), in_file.end(), static_cast<int>(node));
      if (at == in_file.end()) return unreadable("glb", say("other_nodes"));
      back.node_of[node] = static_cast<int>(at - in_file.begin());
    }
  } else if (in_file.size() < rig->file_node.size() ||
             !std::equal(rig->file_node.begin(), rig->file_node.end(), in_file.begin())) {
    // things come after the file's own nodes
    return unreadable("glb", say("other_nodes"));
  }
  back.places = [&](int frame) {
    return in_world(world_transforms(motion.skeleton, motion.clip, frame), node_unit(character_));
  };
  std::vector<Mark> marks = marks_;
  for (Mark& mark : marks) {
    mark.turns = mark.turns && (rig == nullptr || scaled_evenly(rig->rig, mark.turned));
  }
  return compare(back, marks);
}

Result<ReadBack> ReadBackCheck::vrma(std::string_view bytes) const {
  const Result<GltfMotion> file =
      parse_gltf_animation(bytes, "vrma", {.frame_rate = 1.0 / clip_.frame_time});
  if (!file) return unreadable("vrma", file.error().to_message());
  const CharacterRig& rig = *character_.rig;
  const SkeletonMotion& motion = file->motion;
  std::vector<int> bone_of(rig.skeleton.nodes.size(), -1);
  for (std::size_t i = 0; i < bone_of.size(); ++i) {
    const std::string name = vrma_bone(rig, static_cast<int>(i), true);
    if (!name.empty()) bone_of[i] = motion.skeleton.find(name);
  }
  // bones moved by the animation are compared: for a finger the bone that carries it
  std::vector<Mark> marks;
  for (Mark mark : marks_) {
    while (mark.node >= 0 && bone_of[static_cast<std::size_t>(mark.node)] < 0) {
      mark.node = rig.skeleton.nodes[static_cast<std::size_t>(mark.node)].parent;
    }
    if (mark.node < 0) continue;
    mark.turned = without_fingers(rig.rig, mark.node);
    mark.point = in_link(mark.link, start_[static_cast<std::size_t>(mark.node)]);
    marks.push_back(std::move(mark));
  }
  FileMotion back = file_motion("vrma", motion.clip, rig.skeleton, kFloatDigits);
  back.places = [&](int frame) {
    return in_world(played(rig, bone_of, world_transforms(motion.skeleton, motion.clip, frame)),
                    rig.rig.placement.unit);
  };
  return compare(back, marks);
}

Result<ReadBack> ReadBackCheck::compare(const FileMotion& file,
                                        const std::vector<Mark>& marks) const {
  const double rate = 1.0 / clip_.frame_time;
  if (file.frames != clip_.frames || abs(file.frame_time * rate - 1.0) > 1e-9) {
    return unreadable(file.format, say("other_frames", file.frames, file.frame_time, clip_.frames,
                                       clip_.frame_time));
  }
  ReadBack back;
  Kinematics<double> now(body_);
  const Kinematics<double> start = home_kinematics(task_);
  Places first;
  const Mark root = hips();
  const Vec3d begins = start.point(root.link, root.point);
  for (int frame = 0; frame < file.frames; ++frame) {
    const Places places = file.places(frame);
    if (frame == 0) first = places;
    forward_kinematics<double>(body_, clip_.frame(frame), now);
    Vec3d travel = in_place_ ? now.point(root.link, root.point) - begins : Vec3d{};
    travel.y = 0.0;
    for (const Mark& mark : marks) {
      const int node = file.node_of[static_cast<std::size_t>(mark.node)];
      const auto at = static_cast<std::size_t>(node);
      const double off = norm(places[at].translation + travel - now.point(mark.link, mark.point));
      double& most = mark.foot ? back.feet : back.effector;
      most = max(most, off);
      const Allowance allowed = allowance(file, places, node);
      if (off > allowed.length) {
        const Message how = say("off_the_motion", 1e3 * off, 1e3 * allowed.length);
        if (off > kSeenLength) return wrong_by(file, mark, frame, how);
        back.off = say("off_a_little", mark.name, how, frame);
      }
      if (!mark.turns) continue;
      const auto turns =
          static_cast<std::size_t>(file.node_of[static_cast<std::size_t>(mark.turned)]);
      const Mat3d of_file = places[turns].rotation * transpose(first[turns].rotation);
      const Mat3d of_body =
          now.link_rotation(mark.link) * transpose(start.link_rotation(mark.link));
      const double turned = norm(rotation_vector(of_file * transpose(of_body)));
      back.turn = max(back.turn, turned);
      if (turned > allowed.turn) {
        const Message how = say("turned_against", degrees(turned), degrees(allowed.turn));
        if (turned > kSeenTurn) return wrong_by(file, mark, frame, how);
        back.off = say("off_a_little", mark.name, how, frame);
      }
    }
  }
  return back;
}

ReadBackCheck::Allowance ReadBackCheck::allowance(const FileMotion& file, const Places& places,
                                                  int node) {
  Allowance sum;
  const Vec3d& at = places[static_cast<std::size_t>(node)].translation;
  for (int j = node; j >= 0; j = file.parents[static_cast<std::size_t>(j)]) {
    const Vec3d& joint = places[static_cast<std::size_t>(j)].translation;
    const int parent = file.parents[static_cast<std::size_t>(j)];
    const Vec3d from = parent < 0 ? Vec3d{} : places[static_cast<std::size_t>(parent)].translation;
    sum.length += file.digits.turn * norm(at - joint) + file.digits.length +
                  file.digits.relative * norm(joint - from);
    sum.turn += file.digits.turn;
  }
  // doubled, as a rotation is interpolated between two frames that are both rounded
  constexpr double kSpare = 2.0;
  return {kSpare * sum.length, 2.0 * kSpare * sum.turn};
}

tl::unexpected<Error> ReadBackCheck::wrong_by(const FileMotion& file, const Mark& mark, int frame,
                                              const Message& how) {
  return fail(ErrorCode::unsupported, say("cannot_leave", mark.name, how, frame),
              std::string("the format ") + file.format);
}

}  // namespace shigusa
