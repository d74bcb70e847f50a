// SPDX-License-Identifier: MIT
#include "strip_figure_body.hpp"

#include <algorithm>
#include <shigusa/math.hpp>

#include "core/index.hpp"
#include "human/landmark_points.hpp"
#include "math/axes.hpp"

namespace shigusa::strip {
namespace {

// Thickness of a slender figure, as shares of its stature; limbs taper from the first to the
// second.
struct Taper {
  double from;
  double to;
};
constexpr Taper kUpperArm{0.021, 0.017};
constexpr Taper kLowerArm{0.017, 0.012};
constexpr Taper kHand{0.012, 0.009};
constexpr double kFist =
    0.5;  // least length of a hand with curled fingers, relative to an open one
constexpr Taper kUpperLeg{0.034, 0.024};
constexpr Taper kLowerLeg{0.024, 0.015};
constexpr Taper kFoot{0.016, 0.009};
constexpr Taper kNeck{0.020, 0.018};
constexpr double kShoulder = 0.026;
constexpr double kHip = 0.040;
constexpr double kWaist = 0.044;
constexpr double kWaistSide = 0.030;  // from the spine to the middle of either side of the waist
constexpr double kCranium = 0.050;
constexpr double kJaw = 0.026;
// Lengths of leg (thigh and shank), arm (to the wrist) and trunk (hips to shoulders), stature 1.
constexpr double kLegLength = 0.491;
constexpr double kArmLength = 0.332;
constexpr double kTrunkLength = 0.288;

std::size_t at(int node) { return index(node); }

Vec3d middle(const Vec3d& a, const Vec3d& b) { return (a + b) * 0.5; }

// The point at a share of the way along a polyline.
Vec3d along(const std::vector<Vec3d>& line, double share) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  double left = share * length;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = norm(line[i] - line[i - 1]);
    if (step > 0.0 && left <= step) return line[i - 1] + (line[i] - line[i - 1]) * (left / step);
    left -= step;
  }
  return line.back();
}

}  // namespace

FigureBody::FigureBody(const Skeleton& skeleton, const StripSettings& settings,
                       const Upright& upright)
    : skeleton_(skeleton), floor_(settings.floor) {
  find_bones(settings);
  measure_rest(upright);
  find_plain_bones();
}

void FigureBody::find_bones(const StripSettings& settings) {
  using enum HumanoidBone;
  const auto node = [&](HumanoidBone bone) {
    return settings.humanoid ? (*settings.humanoid)[bone]
                             : skeleton_.find(humanoid_bone_name(bone));
  };
  legs_[0].toes = node(left_toes);
  legs_[1].toes = node(right_toes);
  hips_ = node(hips);
  neck_ = node(neck);
  head_ = node(head);

  const auto accented = [&](Limb limb) {
    return std::find(settings.accented.begin(), settings.accented.end(), limb) !=
           settings.accented.end();
  };
  constexpr std::array kLimbs{Limb::left_leg, Limb::right_leg, Limb::left_arm, Limb::right_arm};
  for (std::size_t i = 0; i < kLimbs.size(); ++i) {
    Chain& limb = i < 2 ? legs_[i] : arms_[i - 2];
    for (std::size_t k = 0; k < 3; ++k) limb.joint[k] = node(kLimbBones[i][k]);
    limb.tone = accented(kLimbs[i]) ? Tone::accent : i % 2 == 0 ? Tone::left : Tone::right;
    if (limb.joint[2] >= 0) limb.tips = tips_below(limb.joint[2]);
  }
  find_trunk();
}

void FigureBody::find_trunk() {
  for (std::size_t i = 0; i < 2; ++i) {
    const bool other_arm = arms_[1 - i].joint[0] >= 0;
    const bool other_leg = legs_[1 - i].joint[0] >= 0;
    shoulders_[i] = arms_[i].joint[0] < 0 && other_arm ? neck_ : arms_[i].joint[0];
    pelvis_[i] = legs_[i].joint[0] < 0 && other_leg ? hips_ : legs_[i].joint[0];
  }
  if (!has_trunk()) return;
  int chest = skeleton_.nodes[at(shoulders_[1])].parent;
  while (chest >= 0 && !below(shoulders_[0], chest)) chest = skeleton_.nodes[at(chest)].parent;
  for (; chest >= 0 && !below(pelvis_[0], chest) && chest != hips_;
       chest = skeleton_.nodes[at(chest)].parent) {
    spine_.insert(spine_.begin(), chest);
  }
}

void FigureBody::measure_rest(const Upright& upright) {
  upright_ = upright;
  rest_ = rest_origins(skeleton_);
  measure_stature();
  if (!has_trunk()) return;
  // the axis nearest to the trunk: a rest posture may lean, the axes do not
  const Vec3d rise = middle(rest_[at(shoulders_[0])], rest_[at(shoulders_[1])]) -
                     middle(rest_[at(pelvis_[0])], rest_[at(pelvis_[1])]);
  const Vec3d up = nearest_axis(rise);
  const Vec3d left = rest_[at(pelvis_[0])] - rest_[at(pelvis_[1])];
  const Vec3d forward = cross(left, up);
  if (norm(forward) > 1e-6 * stature_) upright_ = {up, normalized(forward)};
}

// Mean of the estimates from limbs and trunk: cartoon characters have short legs.
void FigureBody::measure_stature() {
  double sum = 0.0;
  int found = 0;
  const auto add = [&](double length, double share) {
    if (!(length > 0.0)) return;
    sum += length / share;
    ++found;
  };
  for (const Chain& leg : legs_) add(chain_length(leg), kLegLength);
  for (const Chain& arm : arms_) add(chain_length(arm), kArmLength);
  if (has_trunk()) {
    const auto between = [&](const std::array<int, 2>& pair) {
      return middle(rest_[at(pair[0])], rest_[at(pair[1])]);
    };
    add(norm(between(shoulders_) - between(pelvis_)), kTrunkLength);
  }
  stature_ = found > 0 ? sum / found : 0.0;
  if (found == 0) head_ = -1;  // among plain bones, a plain bone too
}

// Nodes inside a limb or the trunk, or descendants of a hand, a foot or the head.
std::vector<char> FigureBody::hidden_nodes() const {
  std::vector<char> hidden(skeleton_.nodes.size(), 0);
  std::vector<char> carried(skeleton_.nodes.size(), 0);
  const auto hide = [&](int from, int before) {
    for (int node = from; node >= 0 && node != before; node = skeleton_.nodes[at(node)].parent) {
      hidden[at(node)] = 1;
    }
  };
  for (const Chain* limb : {&arms_[0], &arms_[1], &legs_[0], &legs_[1]}) {
    if (limb->joint[0] >= 0) hide(limb->joint[1], limb->joint[0]);
    if (limb->joint[1] >= 0) hide(limb->joint[2], limb->joint[1]);
    if (limb->joint[2] >= 0) carried[at(limb->joint[2])] = 1;
  }
  if (head_ >= 0) hidden[at(head_)] = carried[at(head_)] = 1;
  if (has_trunk()) {
    for (const int corner : {shoulders_[0], shoulders_[1], pelvis_[0], pelvis_[1]}) {
      hide(corner, -1);
    }
  }
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    const int parent = skeleton_.nodes[i].parent;
    if (parent >= 0 && carried[at(parent)] != 0) hidden[i] = carried[i] = 1;
  }
  return hidden;
}

// Finds lines for the nodes that no anatomical piece shows. If trunk and head are drawn, the
// remaining nodes are twist, skirt and control bones, which are not part of the posture.
void FigureBody::find_plain_bones() {
  if (has_trunk() && head_ >= 0) return;
  const std::vector<char> hidden = hidden_nodes();
  std::vector<double> weight(hidden.size(), 0.0);
  for (std::size_t i = hidden.size(); i-- > 0;) {
    const int parent = skeleton_.nodes[i].parent;
    weight[i] += norm(skeleton_.nodes[i].offset);
    if (parent >= 0) weight[at(parent)] += weight[i];
  }
  const double heaviest = *std::max_element(weight.begin(), weight.end());
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    if (hidden[i] != 0) continue;
    const int node = static_cast<int>(i);
    const int parent = skeleton_.nodes[i].parent;
    // branches with more descendants are thicker
    const double share = heaviest > 0.0 ? sqrt(weight[i] / heaviest) : 0.0;
    bones_.push_back({parent < 0 ? node : parent, node, 0.005 + 0.020 * share});
  }
}

std::vector<int> FigureBody::tips_below(int node) const {
  std::vector<char> has_child(skeleton_.nodes.size(), 0);
  for (const SkeletonNode& child : skeleton_.nodes) {
    if (child.parent >= 0) has_child[at(child.parent)] = 1;
  }
  std::vector<int> tips;
  for (std::size_t i = 0; i < has_child.size(); ++i) {
    const int tip = static_cast<int>(i);
    if (has_child[i] == 0 && below(tip, node)) tips.push_back(tip);
  }
  return tips;
}

bool FigureBody::below(int node, int ancestor) const {
  while (node >= 0 && node != ancestor) node = skeleton_.nodes[at(node)].parent;
  return node >= 0;
}

bool FigureBody::has_trunk() const {
  return shoulders_[0] >= 0 && shoulders_[1] >= 0 && pelvis_[0] >= 0 && pelvis_[1] >= 0;
}

double FigureBody::chain_length(const Chain& chain) const {
  for (const int node : chain.joint) {
    if (node < 0) return 0.0;
  }
  return norm(rest_[at(chain.joint[1])] - rest_[at(chain.joint[0])]) +
         norm(rest_[at(chain.joint[2])] - rest_[at(chain.joint[1])]);
}

Vec3d FigureBody::leftwards(const std::vector<Transformd>& world) const {
  for (const auto& pair : {pelvis_, shoulders_}) {
    if (pair[0] < 0 || pair[1] < 0) continue;
    return world[at(pair[0])].translation - world[at(pair[1])].translation;
  }
  return {};
}

Vec3d FigureBody::place(const std::vector<Transformd>& world) const {
  if (hips_ >= 0) return world[at(hips_)].translation;
  Vec3d mean{};
  for (const Transformd& node : world) {
    mean += node.translation * (1.0 / static_cast<double>(world.size()));
  }
  return mean;
}

Vec3d FigureBody::stance(const std::vector<Transformd>& world) const {
  const int left = legs_[0].joint[2];
  const int right = legs_[1].joint[2];
  if (left < 0 && right < 0) return place(world);
  return middle(world[at(left < 0 ? right : left)].translation,
                world[at(right < 0 ? left : right)].translation);
}

std::vector<Part> FigureBody::parts(const std::vector<Transformd>& world, double size) const {
  std::vector<Part> parts;
  for (const Bone& bone : bones_) {
    const double radius = bone.thickness * size;
    parts.push_back({{{world[at(bone.from)].translation, radius},
                      {world[at(bone.to)].translation, 0.8 * radius}},
                     stature_ > 0.0 ? Tone::middle : Tone::bone});
  }
  if (has_trunk()) add_trunk(world, size, parts);
  if (head_ >= 0) add_head(world, size, parts);
  for (const Chain& leg : legs_) add_limb(leg, true, world, size, parts);
  for (const Chain& arm : arms_) add_limb(arm, false, world, size, parts);
  return parts;
}

// Adds a rib cage and a pelvis that meet at the waist, so that a bent spine shows.
void FigureBody::add_trunk(const std::vector<Transformd>& world, double size,
                           std::vector<Part>& parts) const {
  const auto origin = [&](int node) { return world[at(node)].translation; };
  const Vec3d shoulders[2] = {origin(shoulders_[0]), origin(shoulders_[1])};
  const Vec3d hips[2] = {origin(pelvis_[0]), origin(pelvis_[1])};
  std::vector<Vec3d> spine{middle(hips[0], hips[1])};
  for (const int node : spine_) spine.push_back(origin(node));
  spine.push_back(middle(shoulders[0], shoulders[1]));
  const Vec3d centre = along(spine, 0.35);
  const Vec3d side =
      normalized(shoulders[0] - shoulders[1], {}) + normalized(hips[0] - hips[1], {});
  const Vec3d aside = side * (0.5 * kWaistSide * size);
  const Ball waist[] = {{centre + aside, kWaist * size}, {centre - aside, kWaist * size}};

  Part pelvis{{waist[0], waist[1], {hips[0], kHip * size}, {hips[1], kHip * size}}, Tone::middle};
  Part chest{
      {waist[0], waist[1], {shoulders[0], kShoulder * size}, {shoulders[1], kShoulder * size}},
      Tone::middle};
  if (neck_ >= 0) chest.balls.push_back({origin(neck_), kNeck.from * size});
  parts.push_back(std::move(pelvis));
  parts.push_back(std::move(chest));
}

// Adds a skull, and a jaw in front of it that shows the facing direction.
void FigureBody::add_head(const std::vector<Transformd>& world, double size,
                          std::vector<Part>& parts) const {
  const Transformd& head = world[at(head_)];
  const Vec3d up = head.rotation * upright_.up;
  const Vec3d forward = head.rotation * upright_.forward;
  const Vec3d skull = head.translation + (up * 0.052 + forward * 0.006) * size;
  const Vec3d jaw = head.translation + (up * 0.004 + forward * 0.034) * size;
  int base = neck_ >= 0 ? neck_ : skeleton_.nodes[at(head_)].parent;
  if (base < 0) base = head_;
  Part neck{{{world[at(base)].translation, kNeck.from * size},
             {head.translation + up * (0.02 * size), kNeck.to * size}},
            Tone::middle};
  neck.setback = 0.2 * size;  // behind the chest and the head, which it joins
  parts.push_back(std::move(neck));
  parts.push_back({{{skull, kCranium * size}, {jaw, kJaw * size}}, Tone::middle});
}

void FigureBody::add_limb(const Chain& limb, bool leg, const std::vector<Transformd>& world,
                          double size, std::vector<Part>& parts) const {
  const Taper taper[2] = {leg ? kUpperLeg : kUpperArm, leg ? kLowerLeg : kLowerArm};
  for (std::size_t i = 0; i < 2; ++i) {
    const int from = limb.joint[i];
    const int to = limb.joint[i + 1];
    if (from < 0 || to < 0) continue;
    parts.push_back({{{world[at(from)].translation, taper[i].from * size},
                      {world[at(to)].translation, taper[i].to * size}},
                     limb.tone,
                     2});
  }
  if (limb.joint[2] < 0) return;
  parts.push_back(leg ? foot(limb, world, size) : hand(limb, world, size));
}

// Hand from the wrist to the mean of all finger tips, or to the grip; on the floor fingers curl.
Part FigureBody::hand(const Chain& arm, const std::vector<Transformd>& world, double size) const {
  Vec3d tip{};
  for (const int node : arm.tips) tip += world[at(node)].translation;
  tip = tip * (1.0 / static_cast<double>(arm.tips.size()));
  const Vec3d& wrist = world[at(arm.joint[2])].translation;
  const Vec3d line = tip - wrist;
  const double drop = -dot(line, upright_.up);
  const double above = floor_ ? dot(wrist, upright_.up) - *floor_ : drop;
  if (above < drop) tip = wrist + line * clamp(above / drop, kFist, 1.0);
  return {{{wrist, kHand.from * size}, {tip, kHand.to * size}}, arm.tone, 1};
}

// Foot of ankle, ball and tips of the toes, and a heel below and behind the ankle, which files
// lack.
Part FigureBody::foot(const Chain& leg, const std::vector<Transformd>& world, double size) const {
  const int ankle = leg.joint[2];
  Part foot{{{world[at(ankle)].translation, kFoot.from * size}}, leg.tone, 1, true};
  if (leg.toes >= 0) {
    foot.balls.push_back({world[at(leg.toes)].translation, 0.8 * kFoot.from * size});
  }
  Vec3d tip{};
  for (const int node : leg.tips) {
    foot.balls.push_back({world[at(node)].translation, kFoot.to * size});
    tip += rest_[at(node)] * (1.0 / static_cast<double>(leg.tips.size()));
  }
  const Vec3d reach = tip - rest_[at(ankle)];
  const double drop = -dot(reach, upright_.up);
  const Vec3d ahead = reach + upright_.up * drop;
  if (norm(ahead) < 0.01 * size) return foot;
  const double depth = max(drop - (0.8 * kFoot.from - kFoot.to) * size, 0.0);
  const Vec3d heel = upright_.up * -depth - normalized(ahead) * (0.025 * size);
  foot.balls.push_back(
      {world[at(ankle)].translation + world[at(ankle)].rotation * heel, 0.8 * kFoot.from * size});
  return foot;
}

}  // namespace shigusa::strip
