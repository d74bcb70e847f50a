// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/score.hpp>

#include "core/say.hpp"
#include "criteria/coordination.hpp"
#include "criteria/head.hpp"
#include "kinematics/fit_clip.hpp"
#include "rollout/posture_law.hpp"

namespace shigusa {
namespace {

// Lean (rad) beyond which a person reaches down.
constexpr double kLeansDown = radians(30);
// Tip of the pelvis (rad) from which the back is measured.
constexpr double kTipsLeast = radians(10);
// Height (m) by which a free hand is above the reaching one.
constexpr double kFreeAbove = 0.15;
// Forward turn of a free arm's shoulder (rad) from which its elbow is measured.
constexpr double kShoulderTurns = radians(20);

double median(std::vector<double> values, double otherwise) {
  if (values.empty()) return otherwise;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// The numbers of a habit in the lowest postures of reaches.
class HabitMeter {
 public:
  explicit HabitMeter(const PosedBody& posed)
      : body_(posed),
        home_(posed.home),
        points_(posture_points(body_, home_)),
        knees_(body_.dofs_of(JointKind::knee, FreedomKind::flexion)),
        placed_(body_) {
    for (const Effector& hand : body_.effectors()) {
      if (hand.part.joint_kind == JointKind::hand && hand.limb_root >= 0) hands_.push_back(&hand);
    }
  }

  [[nodiscard]] bool fits() const {
    return points_.found && !knees_.empty() && !hands_.empty() && nods(body_);
  }

  void place(std::span<const double> angles) {
    angles_.assign(angles.begin(), angles.end());
    forward_kinematics<double>(body_, angles, placed_);
  }

  [[nodiscard]] double lean() const {
    const Vec3d line = points_.trunk(placed_);
    return atan2(line.z, line.y);
  }

  // Height (m) of the lowest hand.
  [[nodiscard]] double low() const { return at(*lowest()).y; }

  void measure() {
    measure_knees();
    measure_back();
    measure_eyes();
    measure_free_arm();
  }

  [[nodiscard]] LearnedHabit learned() const {
    const Habit usual;
    LearnedHabit result{.reaches = static_cast<int>(knees_per_trunk_.size())};
    result.habit = {.knees = clamp(median(knees_per_trunk_, usual.knees), 0.0, kHabitKneesMost),
                    .round = clamp(median(round_, usual.round), kHabitRoundLeast, kHabitRoundMost),
                    .eyes = clamp(median(eyes_, usual.eyes), 0.0, kHabitEyesMost),
                    .free_arm = clamp(median(free_arm_, usual.free_arm), 0.0, kHabitFreeArmMost)};
    return result;
  }

 private:
  [[nodiscard]] Vec3d at(const Effector& hand) const {
    return placed_.point(hand.link, hand.point);
  }
  [[nodiscard]] const Effector* lowest() const {
    return *std::min_element(hands_.begin(), hands_.end(),
                             [&](const auto* a, const auto* b) { return at(*a).y < at(*b).y; });
  }

  void measure_knees() {
    double bent = 0.0;
    for (const int knee : knees_) bent += angles_[index(knee)] - home_.angles[index(knee)];
    const Vec3d hand = at(*lowest()) - points_.ankles;
    const double far = sqrt(hand.x * hand.x + hand.z * hand.z);
    const double usual = usual_knees<double>(lean(), far / (kHandAhead * body_.stature()));
    knees_per_trunk_.push_back(bent / static_cast<double>(knees_.size()) / usual);
  }

  void measure_back() {
    const std::size_t joints = back_joints(body_);
    if (joints < 2) return;
    double bent = 0.0;
    for (std::size_t j = 0; j < joints; ++j) {
      const int dof = *body_.find_dof(kBackJoints[j], FreedomKind::flexion);
      bent += angles_[index(dof)] - home_.angles[index(dof)];
    }
    const int lowest = *body_.find_dof(kBackJoints.front(), FreedomKind::flexion);
    const double share = bend_of_back(placed_.link_rotation(body_.dof(lowest).parent));
    if (share < bend_of_back(kTipsLeast)) return;
    round_.push_back(bent / share - back_bend(body_, {.start = home_}));
  }

  void measure_eyes() {
    const auto neck = body_.find_dof(JointKind::neck, FreedomKind::flexion);
    const HeadPoints head = head_points(body_, home_);
    const Vec3d gaze = at(*lowest()) - placed_.origin[index(*neck)];
    const double down = atan2(-gaze.y, sqrt(gaze.x * gaze.x + gaze.z * gaze.z));
    const Vec3d& ahead = placed_.link_rotation(head.head_link).cz;
    const double head_down = atan2(-ahead.y, sqrt(ahead.x * ahead.x + ahead.z * ahead.z));
    const double eyes = clamp(down - head_down, 0.0, 0.9 * down);
    // see PostureLaw: of a habit e the eyes make d = e n / sqrt(n² + e²) at a gaze n
    eyes_.push_back(eyes * down / sqrt(max(down * down - eyes * eyes, 1e-9)));
  }

  void measure_free_arm() {
    for (const Effector* hand : hands_) {
      if (at(*hand).y < low() + kFreeAbove || !hand->part.side) continue;
      const auto shoulder =
          body_.find_dof(JointKind::shoulder, FreedomKind::flexion, *hand->part.side);
      const auto elbow = body_.find_dof(JointKind::elbow, FreedomKind::flexion, *hand->part.side);
      if (!shoulder || !elbow) continue;
      const double side = *hand->part.side == Side::left ? 1.0 : -1.0;
      const int parent = body_.dof(*shoulder).parent;
      const double turned = hanging(placed_.link_rotation(parent), side).flexion;
      if (turned < kShoulderTurns) continue;
      free_arm_.push_back((angles_[index(*elbow)] - home_.angles[index(*elbow)]) / turned);
    }
  }

  const BodyModel& body_;
  const State& home_;
  PosturePoints points_;
  std::vector<int> knees_;
  std::vector<const Effector*> hands_;
  Kinematics<double> placed_;
  std::vector<double> angles_;
  std::vector<double> knees_per_trunk_;
  std::vector<double> round_;     // rad
  std::vector<double> eyes_;      // rad
  std::vector<double> free_arm_;  // of reaches with one hand
};

// Measures the lowest posture of each reach down in a clip.
void measure_reaches(const Clip& clip, HabitMeter& meter) {
  int lowest = -1;
  double least = 0.0;
  for (int f = 0; f <= clip.frames; ++f) {
    bool down = false;
    if (f < clip.frames) {
      meter.place(clip.frame(f));
      down = meter.lean() > kLeansDown;
    }
    if (down && (lowest < 0 || meter.low() < least)) {
      lowest = f;
      least = meter.low();
    }
    if (down || lowest < 0) continue;
    meter.place(clip.frame(lowest));
    meter.measure();
    lowest = -1;
  }
}

}  // namespace

Result<LearnedHabit> learn_habit(const RecordedMotion& recorded,
                                 std::span<const FrameRange> ranges) {
  HabitMeter meter(recorded);
  const int frames = recorded.motion.clip.frames;
  const std::vector<FrameRange> all{{0, frames - 1}};
  for (const FrameRange& range : ranges.empty() ? std::span<const FrameRange>(all) : ranges) {
    const int last = range.last.value_or(frames - 1);
    if (range.first < 0 || last < range.first || last >= frames) {
      return fail(ErrorCode::invalid_argument, say("frames_none", range.first, last, frames - 1),
                  "frames");
    }
    if (!meter.fits()) break;
    const ClipFit fit = fit_clip(recorded, *recorded.rig, recorded.motion, {range.first, last});
    measure_reaches(fit.clip, meter);
  }
  const LearnedHabit learned = meter.learned();
  if (learned.reaches == 0) {
    return fail(ErrorCode::invalid_argument, say("no_reach_down", degrees(kLeansDown)), "clip");
  }
  return learned;
}

}  // namespace shigusa
