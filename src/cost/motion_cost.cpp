// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "body/seat.hpp"
#include "core/check.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "cost/angles.hpp"
#include "cost/courses.hpp"
#include "criteria/low_back.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace shigusa {
namespace {

// Standard deviation of people's strength as a share of the mean, within one sex (kStrengthBounds).
constexpr double kStrengthSpread = 0.25;
// Speed of the hands (m/s) above which the lifting equation does not apply (about 30 in/s).
constexpr double kFastLift = 0.76;

// Share of a normal distribution below a value: M. Abramowitz and I. Stegun, Handbook of
// Mathematical Functions, 26.2.17, to 7.5e-8.
double normal_share(double z) {
  constexpr std::array kTerms{0.319381530, -0.356563782, 1.781477937, -1.821255978, 1.330274429};
  const double x = min(abs(z), 30.0);
  const double t = 1.0 / (1.0 + 0.2316419 * x);
  double sum = 0.0;
  for (std::size_t k = kTerms.size(); k-- > 0;) sum = (sum + kTerms[k]) * t;
  const double tail = exponential(-0.5 * x * x) / sqrt(kTwoPi) * sum;
  return z < 0.0 ? tail : 1.0 - tail;
}

// The load of all hands in a frame, and each one's.
const HeldSpan* span_at(std::span<const HeldSpan> spans, int frame) {
  for (const HeldSpan& span : spans) {
    if (frame >= span.first && frame <= span.last) return &span;
  }
  return nullptr;
}

// Acceleration (m/s²) at a frame of a row of places; at an end that of the frame beside it.
Vec3d acceleration(std::span<const Vec3d> places, std::size_t frame, double frame_time) {
  if (places.size() < 3 || !(frame_time > 0.0)) return {};
  const std::size_t f = std::clamp<std::size_t>(frame, 1, places.size() - 2);
  const double rate = 1.0 / frame_time;
  return (places[f + 1] - places[f] - (places[f] - places[f - 1])) * (rate * rate);
}

// Solves a · m = torque for three axes a.
Vec3d moment_of(const std::array<Vec3d, 3>& axes, const std::array<double, 3>& torques) {
  const Vec3d bc = cross(axes[1], axes[2]);
  const double volume = dot(axes[0], bc);
  constexpr double kFlat = 1e-6;
  if (abs(volume) < kFlat) {
    return axes[0] * torques[0] + axes[1] * torques[1] + axes[2] * torques[2];
  }
  const Vec3d sum =
      bc * torques[0] + cross(axes[2], axes[0]) * torques[1] + cross(axes[0], axes[1]) * torques[2];
  return sum * (1.0 / volume);
}

class Coster {
 public:
  Coster(const CostInput& input, const Ergonomics& ergonomics)
      : input_(input),
        body_(input.posed.body),
        ergonomics_(ergonomics),
        meter_(body_, input.posed.home),
        placed_(body_) {
    using enum FreedomKind;
    for (const FreedomKind freedom : {flexion, lateral, rotation}) {
      if (const auto dof = body_.find_dof(JointKind::spine, freedom)) spine_.push_back(*dof);
    }
    if (!spine_.empty()) {
      for (int link = 0; link < body_.dof_count(); ++link) {
        if (body_.moves(spine_.back(), link)) above_.push_back(link);
      }
    }
    hips_ = body_.dofs_of(JointKind::hip, flexion);
  }

  std::optional<int> worst_reba() {
    std::optional<int> worst;
    for (int f = 0; f < clip().frames; ++f) {
      forward_kinematics<double>(body_, clip().frame(f), placed_);
      const PostureAngles angles = meter_.measure(placed_, clip().frame(f));
      for (const auto& side : reba_at(angles, load_at(f))) {
        if (side) worst = std::max(worst.value_or(0), side->score);
      }
    }
    return worst;
  }

  Result<MotionCost> cost() {
    place_frames();
    for (int f = 0; f < clip().frames; ++f) add_frame(f);
    cost_.reba = reba_course(cost_.frames);
    cost_.rula = rula_course(cost_.frames);
    cost_.zones = zone_courses(cost_.frames, clip().frame_time, ergonomics_);
    cost_.back = back_course(cost_.frames, ergonomics_);
    add_strengths();
    SHG_TRY(add_lifts());
    add_notes();
    return std::move(cost_);
  }

 private:
  [[nodiscard]] const Clip& clip() const { return input_.motion.clip; }

  // Places of the upper body's centre of mass and of the hands in all frames.
  void place_frames() {
    hands_.resize(body_.effectors().size());
    for (int f = 0; f < clip().frames; ++f) {
      forward_kinematics<double>(body_, clip().frame(f), placed_);
      Vec3d moment{};
      upper_mass_ = 0.0;
      for (const int link : above_) {
        const MassProperties& own = body_.link_mass(link);
        if (!(own.mass > 0.0)) continue;
        moment += placed_.point(link, own.com) * own.mass;
        upper_mass_ += own.mass;
      }
      upper_.push_back(upper_mass_ > 0.0 ? moment * (1.0 / upper_mass_) : Vec3d{});
      for (std::size_t e = 0; e < hands_.size(); ++e) {
        const Effector& hand = body_.effectors()[e];
        hands_[e].push_back(placed_.point(hand.link, hand.point));
      }
      ankles_.push_back(meter_.ankles(placed_));
    }
  }

  // With the left arm, with the right.
  [[nodiscard]] std::array<std::optional<RebaScore>, 2> reba_at(const PostureAngles& angles,
                                                                const PostureLoad& load) const {
    std::array<std::optional<RebaScore>, 2> scores;
    for (const Side side : {Side::left, Side::right}) {
      const auto parts = reba_parts(angles, side, load, ergonomics_);
      if (parts) scores[side == Side::left ? 0 : 1] = reba_score(*parts);
    }
    return scores;
  }

  void add_frame(int f) {
    forward_kinematics<double>(body_, clip().frame(f), placed_);
    FrameCost& frame = cost_.frames.emplace_back();
    frame.time = f * clip().frame_time;
    frame.angles = meter_.measure(placed_, clip().frame(f));
    const PostureLoad load = load_at(f);
    frame.reba = reba_at(frame.angles, load);
    for (const Side side : {Side::left, Side::right}) {
      const std::size_t k = side == Side::left ? 0 : 1;
      if (const auto parts = rula_parts(frame.angles, side, load, ergonomics_)) {
        frame.rula[k] = rula_score(*parts, ergonomics_.rula_edition);
      }
    }
    add_back(f, frame);
  }

  [[nodiscard]] PostureLoad load_at(int f) const {
    PostureLoad load;
    if (const HeldSpan* span = span_at(input_.held, f)) {
      for (const HeldLoad& held : span->loads) load.mass += held.mass;
    }
    for (const RestingHand& hand : input_.motion.resting) {
      const auto& side = body_.effector(hand.effector).part.side;
      if (side && norm(hand.forces[index(f)]) > 0.0) {
        load.supported[*side == Side::left ? 0 : 1] = true;
      }
    }
    return load;
  }

  [[nodiscard]] double torque(int f, int dof) const {
    return input_.motion.torques[index(f) * body_.dofs().size() + index(dof)];
  }

  // Force (N) through L5/S1 on the body above it.
  [[nodiscard]] Vec3d back_force(int f) const {
    const Vec3d up{0.0, kGravity, 0.0};
    Vec3d force = (acceleration(upper_, index(f), clip().frame_time) + up) * upper_mass_;
    if (const HeldSpan* span = span_at(input_.held, f)) {
      for (const HeldLoad& held : span->loads) {
        if (index(held.effector) >= hands_.size() ||
            !body_.moves(spine_.back(), body_.effector(held.effector).link)) {
          continue;
        }
        force += (acceleration(hands_[index(held.effector)], index(f), clip().frame_time) + up) *
                 held.mass;
      }
    }
    for (const RestingHand& hand : input_.motion.resting) {
      force = force - hand.forces[index(f)];
    }
    return force;
  }

  void add_back(int f, FrameCost& frame) const {
    const std::optional<Vec3d> line = meter_.trunk_line(placed_);
    if (spine_.size() != 3 || !line) {
      if (hips_.empty()) return;
      double sum = 0.0;
      for (const int hip : hips_) sum += torque(f, hip);
      frame.back_moment = kBackShareOfHips * abs(sum);
      return;
    }
    std::array<Vec3d, 3> axes;
    std::array<double, 3> torques{};
    for (std::size_t k = 0; k < 3; ++k) {
      axes[k] = placed_.axis[index(spine_[k])];
      torques[k] = torque(f, spine_[k]);
    }
    const Vec3d moment = moment_of(axes, torques);
    const Vec3d force = back_force(f);
    // the muscle lies along the trunk, and bears no twist
    frame.back_moment = norm(moment - *line * dot(moment, *line));
    const double along = dot(force, *line);
    const double across = norm(force - *line * along);
    frame.back =
        back_forces(*frame.back_moment, norm(force), atan2(across, along), ergonomics_.back_lever);
  }

  void add_strengths() {
    if (body_.is_robot()) return;
    for (int d = 0; d < body_.dof_count(); ++d) {
      const Dof& dof = body_.dof(d);
      StrengthCost own{dof.name};
      double worst = -1.0;
      for (int f = 0; f < clip().frames; ++f) {
        const double needed = torque(f, d);
        const double strength = needed < 0.0 ? dof.torque_negative : dof.torque_positive;
        if (!(abs(needed) / strength > worst)) continue;
        worst = abs(needed) / strength;
        own.torque = abs(needed);
        own.strength = strength;
        own.time = f * clip().frame_time;
      }
      own.able = normal_share((1.0 - worst) / kStrengthSpread);
      cost_.strengths.push_back(std::move(own));
    }
  }

  // Middle of the hands that hold a thing.
  [[nodiscard]] Vec3d middle_of(const LiftSpan& span, int f) const {
    Vec3d sum{};
    for (const int hand : span.hands) sum += hands_[index(hand)][index(f)];
    return sum * (1.0 / static_cast<double>(span.hands.size()));
  }

  [[nodiscard]] Lift lift_at(const LiftSpan& span, int f) const {
    const Vec3d at = middle_of(span, f) - *ankles_[index(f)];
    const Vec3d ahead = meter_.ahead();
    const Vec3d level{at.x, 0.0, at.z};
    Lift lift;
    lift.load = span.mass;
    lift.horizontal = norm(level);
    lift.vertical = max(middle_of(span, f).y, 0.0);
    lift.asymmetry = atan2(norm(cross(ahead, level)), dot(ahead, level));
    lift.frequency = ergonomics_.lifts_per_min;
    lift.time = ergonomics_.lifting_time;
    lift.coupling = ergonomics_.coupling;
    return lift;
  }

  Result<void> add_lifts() {
    std::vector<LiftTask> tasks;
    for (const LiftSpan& span : input_.lifts) {
      const auto known = [&](int hand) { return hand >= 0 && index(hand) < hands_.size(); };
      if (span.hands.empty() || !std::all_of(span.hands.begin(), span.hands.end(), known) ||
          span.taken < 0 || span.put >= clip().frames || span.put < span.taken ||
          !ankles_[index(span.taken)]) {
        continue;
      }
      LiftCost& lift = cost_.lifts.emplace_back();
      lift.span = span;
      lift.origin = lift_at(span, span.taken);
      lift.destination = lift_at(span, span.put);
      const double travel = abs(lift.origin.vertical - lift.destination.vertical);
      for (Lift* end : {&lift.origin, &lift.destination}) {
        end->travel = travel;
        end->origin_vertical = lift.origin.vertical;
      }
      SHG_TRY_ASSIGN(lift.at_origin, lift_index(lift.origin));
      SHG_TRY_ASSIGN(lift.at_destination, lift_index(lift.destination));
      const bool both = ergonomics_.placed_with_care;
      const LiftIndex& worse = both && lift.at_destination.limit < lift.at_origin.limit
                                   ? lift.at_destination
                                   : lift.at_origin;
      lift.limit = worse.limit;
      lift.index = worse.index;
      tasks.push_back({worse.free_limit, span.mass, span.mass, ergonomics_.lifts_per_min,
                       ergonomics_.lifting_time, lift.origin.vertical});
      if (span.hands.size() < 2) lift.notes.push_back(say("lift_one_hand", span.thing));
      if (sits(body_)) lift.notes.push_back(say("lift_sits"));
      const double fast = speed_of(span);
      if (fast > kFastLift) lift.notes.push_back(say("lift_fast", fast));
    }
    if (tasks.size() < 2) return {};
    SHG_TRY_ASSIGN(cost_.repeated, composite_index(tasks));
    return {};
  }

  // Greatest speed (m/s) of the hands from frame to frame.
  [[nodiscard]] double speed_of(const LiftSpan& span) const {
    double fastest = 0.0;
    for (int f = span.taken; f < span.put; ++f) {
      fastest = max(fastest, norm(middle_of(span, f + 1) - middle_of(span, f)));
    }
    return clip().frame_time > 0.0 ? fastest / clip().frame_time : 0.0;
  }

  void add_notes() {
    const auto note = [this](bool applies, Message words) {
      if (applies) cost_.notes.push_back(std::move(words));
    };
    note(meter_.home_leans(), say("cost_home_leans"));
    if (cost_.frames.empty()) return;
    const PostureAngles& angles = cost_.frames.front().angles;
    note(!cost_.reba, say("cost_lacks_parts"));
    note(cost_.reba && !angles.neck, say("cost_no_neck"));
    const auto lacks_wrist = [](const auto& arm) { return arm && !arm->wrist; };
    note(std::any_of(angles.arms.begin(), angles.arms.end(), lacks_wrist), say("cost_no_wrists"));
    note(cost_.back && !cost_.back->forces, say("cost_rigid_trunk"));
  }

  const CostInput& input_;
  const BodyModel& body_;
  const Ergonomics& ergonomics_;
  AngleMeter meter_;
  Kinematics<double> placed_;
  std::vector<int> spine_{};  // dofs of L5/S1, from the pelvis up
  std::vector<int> above_{};  // links that it carries
  std::vector<int> hips_{};
  double upper_mass_ = 0.0;                     // kg
  std::vector<Vec3d> upper_{};                  // (frames) m, centre of mass above L5/S1
  std::vector<std::vector<Vec3d>> hands_{};     // (hands)(frames) m
  std::vector<std::optional<Vec3d>> ankles_{};  // (frames) m, the middle of both
  MotionCost cost_{};
};

}  // namespace

std::optional<int> worst_reba(const CostInput& input, const Ergonomics& ergonomics) {
  return Coster(input, ergonomics).worst_reba();
}

Result<MotionCost> motion_cost(const CostInput& input, const Ergonomics& ergonomics) {
  const std::size_t frames = index(input.motion.clip.frames);
  SHG_CHECK(input.motion.torques.size() == frames * input.posed.body.dofs().size(),
            "a motion has a torque for each freedom in each frame");
  if (!(ergonomics.back_lever > 0.0) || !is_finite(ergonomics.back_lever)) {
    return fail(ErrorCode::invalid_argument,
                say("cost_option", ergonomics.back_lever, "more than 0"), "back_lever_m");
  }
  return Coster(input, ergonomics).cost();
}

}  // namespace shigusa
