// SPDX-License-Identifier: MIT
#include "generate/posture_meter.hpp"

#include <shigusa/motion.hpp>

#include "body/seat.hpp"

namespace shigusa {
namespace {

constexpr double kLeastDrop = 0.1;  // share of the stature
// Thresholds of the words for postures.
constexpr double kLeaning = radians(15.0);
constexpr double kKneesGive = radians(12.0);
constexpr double kTurned = radians(20.0);
constexpr double kElbowOut = radians(50.0);
// Thresholds of unnatural final postures.
constexpr double kFolded = radians(110.0);
constexpr double kBentKnees = radians(25.0);
constexpr double kElbowIn = radians(-60.0);
constexpr double kStraightArm = 0.05;  // of its length: offset of a bent elbow

using Bone = HumanoidBone;
constexpr std::array kPlaceBones{
    Bone::left_upper_leg, Bone::right_upper_leg, Bone::left_upper_arm, Bone::right_upper_arm,
    Bone::left_lower_arm, Bone::right_lower_arm, Bone::left_hand,      Bone::right_hand};
constexpr std::size_t kLeftWrist = 6;

double mean_knee(const BodyModel& body, std::span<const double> angles) {
  const std::vector<int> knees = body.dofs_of(JointKind::knee, FreedomKind::flexion);
  double sum = 0.0;
  for (const int knee : knees) sum += angles[static_cast<std::size_t>(knee)];
  return knees.empty() ? 0.0 : sum / static_cast<double>(knees.size());
}

}  // namespace

PostureMeter::PostureMeter(const BodyModel& body, const State& home)
    : body_(body), kinematics_(placed(body, home)), sits_(sits(body)) {
  for (std::size_t p = 0; p < kPlaces; ++p) {
    nodes_[p] = body.find_node(humanoid_bone_name(kPlaceBones[p]));
  }
  hip_height_ = between(kLeftHip).y;
  shoulder_height_ = between(kLeftShoulder).y;
  heading_ = heading();
}

Vec3d PostureMeter::at(std::size_t place) const {
  return known(place) ? kinematics_.point(nodes_[place]->link, nodes_[place]->point) : Vec3d{};
}

Vec3d PostureMeter::between(std::size_t left) const {
  const std::size_t right = left + 1;
  if (known(left) && known(right)) return 0.5 * (at(left) + at(right));
  return known(left) ? at(left) : at(right);
}

std::optional<double> PostureMeter::index_now() const {
  const bool hips = known(kLeftHip) || known(kRightHip);
  const bool shoulders = known(kLeftShoulder) || known(kRightShoulder);
  const double down = shoulder_height_ - between(kLeftShoulder).y;
  if (!hips || !shoulders || !(down >= kLeastDrop * body_.stature())) return std::nullopt;
  return 100.0 * (1.0 - (hip_height_ - between(kLeftHip).y) / down);
}

double PostureMeter::trunk_lean() const {
  const bool hips = known(kLeftHip) || known(kRightHip);
  const bool shoulders = known(kLeftShoulder) || known(kRightShoulder);
  if (!hips || !shoulders) return 0.0;
  const Vec3d trunk = between(kLeftShoulder) - between(kLeftHip);
  return atan2(trunk.z, trunk.y);
}

// Heading of the line from the right shoulder to the left, seen from above; 0 faces +Z.
double PostureMeter::heading() const {
  if (!known(kLeftShoulder) || !known(kRightShoulder)) return 0.0;
  const Vec3d across = at(kLeftShoulder) - at(kRightShoulder);
  return atan2(-across.z, across.x);
}

double PostureMeter::elbow_swivel(int effector) const {
  const JointPlace& hand = body_.effector(effector).part;
  if (hand.joint_kind != JointKind::hand || !hand.side) return 0.0;
  const std::size_t right = hand.side == Side::left ? 0 : 1;
  const std::size_t needed[] = {kLeftShoulder + right, kRightShoulder - right, kLeftElbow + right,
                                kLeftWrist + right};
  for (const std::size_t place : needed) {
    if (!known(place)) return 0.0;
  }
  const Vec3d shoulder = at(needed[0]);
  const Vec3d reach = at(needed[3]) - shoulder;
  const double length = norm(reach);
  if (!(length > 0.0)) return 0.0;
  const Vec3d along = (1.0 / length) * reach;
  const auto across = [&](const Vec3d& v) { return v - dot(v, along) * along; };
  const Vec3d bend = across(at(needed[2]) - shoulder);
  if (norm(bend) < kStraightArm * length) return 0.0;
  const Vec3d down = across({0.0, -1.0, 0.0});
  const Vec3d out = across(shoulder - at(needed[1]));
  if (!(norm(down) > 0.0) || !(norm(out) > 0.0)) return 0.0;
  return atan2(dot(bend, out) / norm(out), dot(bend, down) / norm(down));
}

std::optional<double> PostureMeter::index(std::span<const double> angles) {
  forward_kinematics<double>(body_, angles, kinematics_);
  return index_now();
}

FinalPosture PostureMeter::measure(std::span<const double> angles, int effector) {
  forward_kinematics<double>(body_, angles, kinematics_);
  FinalPosture posture;
  posture.sits = sits_;
  posture.knee_flexion = mean_knee(body_, angles);
  posture.stoop_squat_index = index_now();
  posture.trunk_lean = trunk_lean();
  const double turn = heading() - heading_;
  posture.trunk_turn = turn > kPi ? turn - kTwoPi : turn < -kPi ? turn + kTwoPi : turn;
  posture.elbow_swivel = elbow_swivel(effector);
  return posture;
}

bool is_strange(const FinalPosture& posture) {
  const bool folded = posture.trunk_lean >= kFolded && posture.knee_flexion < kBentKnees;
  const bool crouches = !posture.stoop_squat_index && posture.knee_flexion > kBentKnees;
  return folded || crouches || posture.elbow_swivel < kElbowIn;
}

std::vector<PostureWord> words_for(const FinalPosture& posture) {
  using enum PostureWord;
  std::vector<PostureWord> words{posture.sits ? sitting : upright};
  const bool bends = !posture.sits && posture.stoop_squat_index.has_value();
  if (bends) {
    const double index = *posture.stoop_squat_index;
    words[0] = index < kSquatIndex ? squat : index > kStoopIndex ? stoop : half_squat;
  }
  const auto add = [&words](bool said, PostureWord word) {
    if (said) words.push_back(word);
  };
  add(!bends && posture.trunk_lean > kLeaning, leaning);
  add(!bends && posture.knee_flexion > kKneesGive, knees_bent);
  add(words[0] == stoop && posture.knee_flexion < kBentKnees, straight_knees);
  add(posture.trunk_turn > kTurned, turned_left);
  add(posture.trunk_turn < -kTurned, turned_right);
  add(posture.elbow_swivel > kElbowOut, elbow_out);
  return words;
}

std::string posture_words(const FinalPosture& posture) {
  std::string text;
  for (const PostureWord word : words_for(posture)) {
    text.append(text.empty() ? "" : ", ").append(word_of(word));
  }
  return text;
}

}  // namespace shigusa
