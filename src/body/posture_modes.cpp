// SPDX-License-Identifier: MIT
#include "body/posture_modes.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "body/anthropometry.hpp"
#include "body/joint_name.hpp"

namespace shigusa {
namespace {

// Ankle angle in a lean, as a share of the hips': leaning people move the hips back, so that the
// centre of mass stays over the feet (A. Alexandrov, A. Frolov, J. Massion, Experimental Brain
// Research 118 (1998) 210-220: ankle, knee and hip move as one). Without it 3000 motions of `human`
// end with 1.6 times the score, mean of ten goals, and 60,000 do not make up for it; 0.2 to 0.5 are
// much the same.
constexpr double kHipsBack = 0.3;

// A description of each mode, for users.
constexpr std::string_view kSquatSentence =
    "The knees bend by the angle and the trunk stays upright: half of the angle goes to each hip "
    "and ankle, which keeps the leg's line for a thigh as long as the shank.";
constexpr std::string_view kLeanSentence = "The hips bend and go back over the ankles.";
constexpr std::string_view kRoundSentence = "The spine bends forwards.";
constexpr std::string_view kRoundMoreSentence =
    "The spine bends forwards by more than goes with the pelvis, or by less.";
constexpr std::string_view kTwistSentence = "The trunk turns to the left over the feet.";
constexpr std::string_view kElbowSentence = "The elbow bends: the arm's contraction.";
constexpr std::string_view kSwivelSentence = "The upper arm turns outwards about its axis.";
constexpr std::string_view kWristSentence = "The hand bends to the palm's side, or back.";

// Displacement of a degree of freedom by a mode, and that of its left counterpart.
struct Moved {
  JointKind joint;
  FreedomKind freedom;
  double share = 1.0;
  double of_left = share;
};

class ModeBuilder {
 public:
  explicit ModeBuilder(const BodyModel& body) : body_(body) {}

  // a mode over the existing degrees of freedom, on both sides or one; no mode without any
  void add(PostureMode mode, const std::vector<Moved>& moved, std::optional<Side> of = {}) {
    mode.direction.resize(body_.dofs().size());
    for (const Moved& m : moved) {
      for (const int d : body_.dofs_of(m.joint, m.freedom)) {
        const std::optional<Side> side = body_.dof(d).part.side;
        if (of && side != of) continue;
        mode.direction[static_cast<std::size_t>(d)] = side == Side::left ? m.of_left : m.share;
      }
    }
    const auto is_0 = [](double share) { return share == 0.0; };
    if (std::all_of(mode.direction.begin(), mode.direction.end(), is_0)) return;
    modes_.push_back(std::move(mode));
  }

  std::vector<PostureMode> take() { return std::move(modes_); }

 private:
  const BodyModel& body_;
  std::vector<PostureMode> modes_;
};

// A spine bends in proportion to its joints' ranges, and turns before the hips do. A robot's waist
// is one joint.
void add_trunk_modes(const BodyModel& body, ModeBuilder& modes) {
  constexpr double kSpine = 0.6;
  constexpr double kHips = 1.0 - kSpine;
  if (!body.find_dof(JointKind::spine, FreedomKind::rotation)) {
    modes.add({"twist", kTwistSentence, {}, radians(-40.0), radians(40.0)},
              {{JointKind::hip, FreedomKind::rotation, 1.0, -1.0}});
    return;
  }
  const bool waist = !body.find_dof(JointKind::chest, FreedomKind::rotation);
  const std::size_t joints = waist ? 1 : std::max<std::size_t>(back_joints(body), 1);
  std::vector<Moved> round;
  std::vector<Moved> twist{{JointKind::hip, FreedomKind::rotation, kHips, -kHips}};
  for (std::size_t j = 0; j < joints; ++j) {
    const SpineShares shares = spine_shares(j, joints);
    round.push_back({kBackJoints[j], FreedomKind::flexion, shares.flexion});
    twist.push_back({kBackJoints[j], FreedomKind::rotation, kSpine * shares.rotation});
  }
  if (waist) {
    modes.add({"round", kRoundSentence, {}, radians(-15.0), radians(70.0)}, round);
  } else {
    // chosen: with 10 below, searches undo the law's difference between men and women (decision 45)
    modes.add({"round", kRoundMoreSentence, {}, radians(-6.0), radians(10.0)}, round);
  }
  modes.add({"twist", kTwistSentence, {}, radians(-65.0), radians(65.0)}, twist);
}

// Lays a hand that reaches the floor flat. Without the wrist's mode a quarter of the goals 5 cm
// above the floor ends with the hand in it, and the mean score of seven low goals is 0.22, not
// 0.19.
void add_arm_modes(ModeBuilder& modes) {
  const std::vector<std::pair<PostureMode, Moved>> arm{
      {{"elbow", kElbowSentence, {}, 0.0, radians(110.0)},
       {JointKind::elbow, FreedomKind::flexion}},
      {{"swivel", kSwivelSentence, {}, radians(-60.0), radians(60.0)},
       {JointKind::shoulder, FreedomKind::rotation}},
      {{"wrist", kWristSentence, {}, radians(-60.0), radians(60.0)},
       {JointKind::wrist, FreedomKind::flexion}}};
  for (const auto& [mode, moved] : arm) {
    for (const Side side : {Side::right, Side::left}) {
      PostureMode sided = mode;
      sided.name = side_prefix(side) + mode.name;
      modes.add(std::move(sided), {moved}, side);
    }
  }
}

}  // namespace

std::size_t back_joints(const BodyModel& body) {
  std::size_t joints = 0;
  while (joints < kBackJoints.size() && body.find_dof(kBackJoints[joints], FreedomKind::flexion)) {
    ++joints;
  }
  return joints;
}

std::vector<PostureMode> posture_modes(const BodyModel& body) {
  ModeBuilder modes(body);
  if (body.find_dof(JointKind::knee, FreedomKind::flexion, Side::right)) {
    modes.add({"squat", kSquatSentence, {}, 0.0, radians(130.0)},
              {{JointKind::knee, FreedomKind::flexion},
               {JointKind::hip, FreedomKind::flexion, kOfKnee},
               {JointKind::ankle, FreedomKind::flexion, kOfKnee}});
  }
  modes.add({"lean", kLeanSentence, {}, radians(-20.0), radians(110.0)},
            {{JointKind::hip, FreedomKind::flexion},
             {JointKind::ankle, FreedomKind::flexion, -kHipsBack}});
  add_trunk_modes(body, modes);
  add_arm_modes(modes);
  return modes.take();
}

}  // namespace shigusa
