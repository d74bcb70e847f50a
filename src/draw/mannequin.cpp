// SPDX-License-Identifier: MIT
#include "mannequin.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "kinematics/rig_fingers.hpp"

namespace shigusa {

// Builder of a mannequin, bone by bone.
class Mannequin::Builder {
 public:
  Builder(const Skeleton& body, const MannequinMesh& mesh, double stature, Mannequin& out)
      : bones_(body), fitter_(bones_, mesh, stature), out_(out), places_(rest_origins(body)) {
    turns_.resize(places_.size());
    for (const SkinBone& bone : mesh.bones) {
      if (bone.kind == SkinBone::Kind::finger) {
        add_finger(bone);
      } else if (bone.kind == SkinBone::Kind::node) {
        const SkinFit fit = fitter_.of(bone.name);
        hang(bones_.node(fit.bone), fit.place);
      } else {
        add_follower(bone);
      }
    }
    // readers treat skin joints as bones, and would leave out the hands' grips otherwise
    for (std::size_t i = 0; i < body.nodes.size(); ++i) {
      if (!is_joint(static_cast<int>(i))) hang(static_cast<int>(i), {{}, places_[i]});
    }
  }

 private:
  int add(const std::string& name, int parent, const Vec3d& place, const Quatd& turn = {}) {
    const Vec3d offset = place - places_[index(parent)];
    out_.skeleton_.nodes.push_back({name, parent, offset});
    out_.rest_.push_back({offset, turn});
    places_.push_back(place);
    turns_.push_back(turn);
    return static_cast<int>(places_.size()) - 1;
  }

  [[nodiscard]] bool is_joint(int node) const {
    return std::find(out_.joints_.begin(), out_.joints_.end(), node) != out_.joints_.end();
  }

  // Attaches skin to a node. A node may occur once in a file's skin, so a second part gets a node
  // of its own.
  void hang(int node, const Transformd& place) {
    if (is_joint(node)) {
      const std::string& name = out_.skeleton_.nodes[index(node)].name;
      node = add(name + "_part_" + std::to_string(out_.joints_.size()), node, places_[index(node)]);
    }
    out_.joints_.push_back(node);
    out_.inverses_.push_back(
        inverse(Transformd{to_matrix(turns_[index(node)]), places_[index(node)]}) * place);
  }

  void add_follower(const SkinBone& bone) {
    const SkinFit fit = fitter_.of(bone.of);
    const int joint = bones_.node(fit.bone);
    if (fit.bone != bone.of) return hang(joint, fit.place);  // a limb that the body lacks
    const std::string side = bone.of.substr(0, bone.of.find('_') + 1);
    const bool arm = bone.of.ends_with("arm");
    std::string above = arm ? side + "shoulder" : "hips";
    if (bone.of.find("lower") != bone.of.npos) above = side + (arm ? "upper_arm" : "upper_leg");
    const Quatd hanging = fitter_.of(fitter_.carrier(above)).turn;
    const MannequinFollower turn{bone.kind, joint, fit.turn, hanging,
                                 bones_.axes() * Vec3d{0, -1, 0}};
    const int parent = out_.skeleton_.nodes[index(joint)].parent;
    // the skin is placed about the limb at rest, and the follower about the hanging limb
    const int node = add(bone.name, parent, places_[index(joint)], hanging);
    hang(node, fitter_.hanging(bone, hanging));
    out_.rest_[index(node)].rotation = turn.follow({});
    out_.followers_.push_back({node, turn});
  }

  void add_finger(const SkinBone& bone) {
    const std::string hand = bone.name.substr(0, bone.name.find('_')) + "_hand";
    const SkinFit fit = fitter_.of(hand);
    if (fit.bone != hand) return hang(bones_.node(fit.bone), fit.place);  // moves with its carrier
    const int before = out_.skeleton_.find(bone.of);
    const Quatd hanging = axis_rotation(Axis::z, bone.angle);
    const int node = add(bone.name, before, fit.place * bone.place);
    const Vec3d axis = normalized(fit.place.rotation * (to_matrix(hanging) * bone.axis));
    hang(node, fit.place);
    out_.fingers_.push_back({node, &bone, axis});
  }

  RestBones bones_;
  SkinFitter fitter_;
  Mannequin& out_;
  std::vector<Vec3d> places_;  // (nodes) m, world, at rest
  std::vector<Quatd> turns_;   // (nodes) rotations with the skin as placed
};

Mannequin::Mannequin(const Skeleton& body, const MannequinMesh& mesh, double stature)
    : skeleton_(body), body_nodes_(body.nodes.size()) {
  for (const SkeletonNode& node : body.nodes) rest_.push_back({node.offset, {}});
  Builder(body, mesh, stature, *this);
  bend({}, rest_.data());
}

void Mannequin::bend(std::array<double, 2> closed, LocalTransform* local) const {
  for (const Finger& finger : fingers_) {
    const double hand = closed[finger.bone->name.starts_with("left") ? 0 : 1];
    local[finger.node].rotation = axis_turn(finger.axis, finger_bend(*finger.bone, hand));
  }
}

double Mannequin::closed_at(const HandPlay& hands, std::size_t side, double share) const {
  if (!hands.fingers || fingers_.empty()) return 0.0;
  const std::vector<FingerKey>& keys = hands.keys[side];
  if (keys.empty()) return hands.reaches[side] ? hand_closed(share) : 0.0;
  const FingerKey now = finger_posture(keys, share);
  // by the mean bend of all bones
  std::array<double, 3> bends{};
  for (const Finger& finger : fingers_) {
    for (std::size_t k = 0; k < bends.size(); ++k) bends[k] += finger.bone->bends[k];
  }
  const double bend =
      now.flexion * mean_flexion(HandPosture::relaxed) * static_cast<double>(fingers_.size());
  const auto [open, relaxed, grip] = bends;
  const double over = bend - relaxed;
  const double closed = over / (over < 0.0 ? relaxed - open : grip - relaxed);
  return (1.0 - now.start) * clamp(closed, -1.0, 1.0);
}

std::vector<LocalTransform> Mannequin::play(const SkeletonClip& body, const HandPlay& hands) const {
  std::vector<LocalTransform> all;
  all.reserve(index(body.frames) * rest_.size());
  for (int f = 0; f < body.frames; ++f) {
    const double share = body.frames > 1 ? static_cast<double>(f) / (body.frames - 1) : 0.0;
    all.insert(all.end(), rest_.begin(), rest_.end());
    LocalTransform* local = &all[all.size() - rest_.size()];
    std::copy_n(body.local.data() + index(f) * body_nodes_, body_nodes_, local);
    for (const auto& [node, follower] : followers_) {
      local[node].rotation = follower.follow(local[follower.joint].rotation);
    }
    bend({closed_at(hands, 0, share), closed_at(hands, 1, share)}, local);
  }
  return all;
}

}  // namespace shigusa
