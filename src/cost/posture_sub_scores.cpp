// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/cost.hpp>

namespace shigusa {
namespace {

// Loads (kg) that borders of the methods name.
constexpr double kRebaSome = 5.0;
constexpr double kRebaMuch = 10.0;
constexpr double kRulaSome = 2.0;
constexpr double kRulaMuch = 10.0;
constexpr double kKneesBend = radians(30.0);
constexpr double kKneesBendFar = radians(60.0);

std::size_t index_of(Side side) { return side == Side::left ? 0 : 1; }

// Whether one foot bears the weight.
bool on_one_foot(const PostureAngles& angles, const PostureThresholds& t) {
  if (angles.sits || !angles.on_left) return false;
  return max(*angles.on_left, 1.0 - *angles.on_left) > t.one_foot;
}

bool twisted(const std::optional<TrunkAngles>& part, double over) {
  return part && abs(part->twist) > over;
}
bool aside(const std::optional<TrunkAngles>& part, double over) {
  return part && abs(part->lateral) > over;
}
double flexion_of(const std::optional<TrunkAngles>& part) { return part ? part->flexion : 0.0; }

bool deviates(const ArmAngles& arm, const PostureThresholds& t) {
  return arm.deviation && abs(*arm.deviation) > t.wrist_deviates;
}
bool forearm_ends(const ArmAngles& arm, const PostureThresholds& t) {
  return arm.forearm && (*arm.forearm < t.forearm_end || *arm.forearm > 1.0 - t.forearm_end);
}

int score_of_upper_arm(PostureMethod method, const ArmAngles& arm, bool supported,
                       const PostureThresholds& t) {
  int score = base_score(method, PosturePart::upper_arm, arm.flexion, t);
  const bool hangs = method == PostureMethod::reba && score > 1 && arm.elevation <= t.gravity_helps;
  score += (arm.raised > t.shoulder_raised ? 1 : 0) + (arm.abduction > t.arm_abducted ? 1 : 0) -
           (supported || hangs ? 1 : 0);
  return std::clamp(score, 1, 6);
}

int legs_of_reba(const PostureAngles& angles, const PostureThresholds& t) {
  if (angles.sits) return 1;
  const double knee = max(angles.knees[0].value_or(0.0), angles.knees[1].value_or(0.0));
  return (on_one_foot(angles, t) ? 2 : 1) + (knee > kKneesBendFar ? 2 : knee > kKneesBend ? 1 : 0);
}

int force_of_rula(double mass, const Ergonomics& e) {
  const bool lasting = e.held || e.repeated;
  if (e.shock || mass > kRulaMuch) return 3;
  return mass < kRulaSome ? 0 : lasting ? 2 : 1;
}

}  // namespace

std::optional<RebaParts> reba_parts(const PostureAngles& angles, Side side, const PostureLoad& load,
                                    const Ergonomics& e) {
  using enum PosturePart;
  const auto& arm = angles.arms[index_of(side)];
  if (!arm) return std::nullopt;
  const PostureThresholds& t = e.thresholds;
  constexpr auto kMethod = PostureMethod::reba;
  RebaParts parts;
  parts.neck = base_score(kMethod, neck, flexion_of(angles.neck), t) +
               (twisted(angles.neck, t.neck_aside) || aside(angles.neck, t.neck_aside) ? 1 : 0);
  parts.trunk =
      base_score(kMethod, trunk, flexion_of(angles.trunk), t) +
      (twisted(angles.trunk, t.trunk_aside) || aside(angles.trunk, t.trunk_aside) ? 1 : 0);
  parts.legs = legs_of_reba(angles, t);
  parts.load = (load.mass > kRebaMuch ? 2 : load.mass >= kRebaSome ? 1 : 0) + (e.shock ? 1 : 0);
  parts.upper_arm = score_of_upper_arm(kMethod, *arm, load.supported[index_of(side)], t);
  parts.lower_arm = base_score(kMethod, lower_arm, arm->elbow, t);
  parts.wrist = base_score(kMethod, wrist, arm->wrist.value_or(0.0), t) +
                (deviates(*arm, t) || forearm_ends(*arm, t) ? 1 : 0);
  parts.coupling = static_cast<int>(e.coupling);
  parts.activity = (e.held ? 1 : 0) + (e.repeated ? 1 : 0) + (e.rapid ? 1 : 0);
  return parts;
}

std::optional<RulaParts> rula_parts(const PostureAngles& angles, Side side, const PostureLoad& load,
                                    const Ergonomics& e) {
  using enum PosturePart;
  const auto& arm = angles.arms[index_of(side)];
  if (!arm) return std::nullopt;
  const PostureThresholds& t = e.thresholds;
  constexpr auto kMethod = PostureMethod::rula;
  RulaParts parts;
  parts.upper_arm = score_of_upper_arm(kMethod, *arm, load.supported[index_of(side)], t);
  parts.lower_arm = base_score(kMethod, lower_arm, arm->elbow, t) +
                    (arm->across < -t.hand_across || arm->outside > t.hand_out ? 1 : 0);
  parts.wrist =
      base_score(kMethod, wrist, arm->wrist.value_or(0.0), t) + (deviates(*arm, t) ? 1 : 0);
  parts.wrist_twist = forearm_ends(*arm, t) ? 2 : 1;
  parts.muscle = e.held || e.repeated ? 1 : 0;
  parts.force = force_of_rula(load.mass, e);
  parts.neck = base_score(kMethod, neck, flexion_of(angles.neck), t) +
               (twisted(angles.neck, t.neck_aside) ? 1 : 0) +
               (aside(angles.neck, t.neck_aside) ? 1 : 0);
  parts.trunk = base_score(kMethod, trunk, flexion_of(angles.trunk), t) +
                (twisted(angles.trunk, t.trunk_aside) ? 1 : 0) +
                (aside(angles.trunk, t.trunk_aside) ? 1 : 0);
  parts.legs = on_one_foot(angles, t) ? 2 : 1;
  return parts;
}

}  // namespace shigusa
