// SPDX-License-Identifier: MIT
#include "generate/posture_meter.hpp"

#include <shigusa/motion.hpp>

#include "body/seat.hpp"

namespace shigusa {
namespace {

constexpr double kLeastDrop = 0.1;  // share of the stature
// Largest height of a wrist above the knees, as a share of the stature, in a squat or stoop.
constexpr double kLowWrist = 0.05;
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
// Least differences that a person sees.
constexpr double kSeenLean = radians(12.0);
constexpr double kSeenKnees = radians(20.0);
constexpr double kSeenTurn = radians(20.0);
constexpr double kSeenHips = 0.07;   // m
constexpr double kSeenElbow = 0.12;  // m

using Bone = HumanoidBone;
constexpr std::array kPlaceBones{
    Bone::left_upper_leg, Bone::right_upper_leg, Bone::left_upper_arm, Bone::right_upper_arm,
    Bone::left_lower_arm, Bone::right_lower_arm, Bone::left_hand,      Bone::right_hand,
    Bone::left_lower_leg, Bone::right_lower_leg};
constexpr std::size_t kLeftWrist = 6;
constexpr std::size_t kLeftKnee = 8;

double mean_knee(const BodyModel& body, std::span<const double> angles) {
  const std::vector<int> knees = body.dofs_of(JointKind::knee, FreedomKind::flexion);
  double sum = 0.0;
  for (const int knee : knees) sum += angles[static_cast<std::size_t>(knee)];
  return knees.empty() ? 0.0 : sum / static_cast<double>(knees.size());
}

// An angle between -2π and 2π, brought to -π to π.
double wrapped(double angle) {
  return angle > kPi ? angle - kTwoPi : angle < -kPi ? angle + kTwoPi : angle;
}

// The nodes of a person's bones; all nodes of a body that has none of them.
std::vector<const BodyNode*> seen_nodes(const BodyModel& body) {
  std::vector<const BodyNode*> seen;
  for (int bone = 0; bone < kHumanoidBoneCount; ++bone) {
    const BodyNode* node = body.find_node(humanoid_bone_name(static_cast<Bone>(bone)));
    if (node != nullptr) seen.push_back(node);
  }
  if (!seen.empty()) return seen;
  for (const BodyNode& node : body.nodes()) seen.push_back(&node);
  return seen;
}

}  // namespace

double look_distance(const Look& a, const Look& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.places.size(); ++k) sum += norm(a.places[k] - b.places[k]);
  return a.places.empty() ? 0.0 : sum / static_cast<double>(a.places.size());
}

bool look_alike(const Look& a, const Look& b, double slack) {
  if (look_distance(a, b) < slack * kSeenDistance) return true;
  return a.arms && abs(a.lean - b.lean) < slack * kSeenLean &&
         abs(a.knees - b.knees) < slack * kSeenKnees &&
         abs(wrapped(a.turn - b.turn)) < slack * kSeenTurn &&
         norm(a.hips - b.hips) < slack * kSeenHips &&
         norm(a.elbows[0] - b.elbows[0]) < slack * kSeenElbow &&
         norm(a.elbows[1] - b.elbows[1]) < slack * kSeenElbow;
}

PostureMeter::PostureMeter(const BodyModel& body, const State& home, int hand)
    : body_(body), seen_(seen_nodes(body)), kinematics_(placed(body, home)), sits_(sits(body)) {
  for (std::size_t p = 0; p < kPlaces; ++p) {
    nodes_[p] = body.find_node(humanoid_bone_name(kPlaceBones[p]));
  }
  const JointPlace& part = body.effector(hand).part;
  if (part.joint_kind == JointKind::hand && part.side) hand_ = *part.side == Side::left ? 0 : 1;
  hip_height_ = between(kLeftHip).y;
  shoulder_height_ = between(kLeftShoulder).y;
  knee_height_ = between(kLeftKnee).y;
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

// Whether the wrist is below the knees of the body at home, or little above.
bool PostureMeter::is_low() const {
  const bool knees = known(kLeftKnee) || known(kLeftKnee + 1);
  if (!knees || !hand_ || !known(kLeftWrist + *hand_)) return true;
  return at(kLeftWrist + *hand_).y < knee_height_ + kLowWrist * body_.stature();
}

std::optional<double> PostureMeter::index_now() const {
  const bool hips = known(kLeftHip) || known(kRightHip);
  const bool shoulders = known(kLeftShoulder) || known(kRightShoulder);
  const double down = shoulder_height_ - between(kLeftShoulder).y;
  if (!hips || !shoulders || !(down >= kLeastDrop * body_.stature()) || !is_low()) {
    return std::nullopt;
  }
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

double PostureMeter::elbow_swivel() const {
  if (!hand_) return 0.0;
  const std::size_t right = *hand_;
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

FinalPosture PostureMeter::measure(std::span<const double> angles) {
  forward_kinematics<double>(body_, angles, kinematics_);
  FinalPosture posture;
  posture.sits = sits_;
  posture.knee_flexion = mean_knee(body_, angles);
  posture.stoop_squat_index = index_now();
  posture.trunk_lean = trunk_lean();
  posture.trunk_turn = wrapped(heading() - heading_);
  posture.elbow_swivel = elbow_swivel();
  return posture;
}

Look PostureMeter::look(std::span<const double> angles) {
  forward_kinematics<double>(body_, angles, kinematics_);
  Look look{.arms = known(kLeftElbow) || known(kRightElbow),
            .elbows = {at(kLeftElbow), at(kRightElbow)},
            .hips = between(kLeftHip),
            .lean = trunk_lean(),
            .turn = heading(),
            .knees = mean_knee(body_, angles),
            .swivel = elbow_swivel()};
  for (const BodyNode* node : seen_) {
    look.places.push_back(kinematics_.point(node->link, node->point));
  }
  return look;
}

bool is_strange(const FinalPosture& posture) {
  const bool folded = posture.trunk_lean >= kFolded && posture.knee_flexion < kBentKnees;
  const bool crouches = !posture.stoop_squat_index && posture.knee_flexion > kBentKnees &&
                        posture.trunk_lean < kLeaning;
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
