// SPDX-License-Identifier: MIT
#include "layers/reduced_motion.hpp"

#include <algorithm>

#include "core/check.hpp"
#include "core/index.hpp"
#include "math/ldlt.hpp"

namespace shigusa {
namespace {

// LengthLaw::path shortens an arm by this share at the most of what its hand comes nearer: by all
// of it the shoulder could stay, but the elbow folds faster than a trunk yields.
constexpr double kPathShare = 0.5;

std::vector<int> chain_to(const ReducedBody& body, int link) {
  std::vector<int> chain;
  for (int d = link; d >= 0; d = body.dofs[index(d)].parent) chain.push_back(d);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

void place_reduced(const ReducedBody& body, std::span<const double> q, ReducedPlacement& placed) {
  placed.rotation.resize(body.dofs.size());
  placed.origin.resize(body.dofs.size());
  placed.axis.resize(body.dofs.size());
  for (std::size_t d = 0; d < body.dofs.size(); ++d) {
    const ReducedDof& dof = body.dofs[d];
    const Mat3d& carrier = dof.parent < 0 ? body.base.rotation : placed.rotation[index(dof.parent)];
    const Vec3d& from = dof.parent < 0 ? body.base.translation : placed.origin[index(dof.parent)];
    placed.axis[d] = carrier.column(static_cast<int>(dof.axis)) * dof.sign;
    placed.origin[d] = from + carrier * dof.offset;
    placed.rotation[d] = carrier;
    if (dof.kind == ReducedDof::Kind::slide) {
      placed.origin[d] += placed.axis[d] * q[d];
    } else {
      placed.rotation[d] = rotated(carrier, dof.axis, sin_cos(dof.sign * q[d]));
    }
  }
}

ReducedRollout::ReducedRollout(const ReducedBody& body, const ReachProblem& problem)
    : body_(&body), problem_(&problem), moves_(body.limbs.size(), false) {
  for (const ReducedDof& dof : body.dofs) q_.push_back(dof.start);
  place_reduced(body, q_, placed_);
  for (const ReachGoal& goal : problem.goals) add_hand(goal.effector);
  SHG_CHECK(targets_.size() == problem.goals.size(), "each goal is for an arm of the layer's body");
  for (std::size_t i = 0; i < body.limbs.size(); ++i) {
    if (body.limbs[i].joints.kind != LimbKind::leg) continue;
    moves_[i] = true;
    if (!body.limbs[i].joints.carries) add_planted_foot(body.limbs[i]);
  }
  std::vector<bool> used(q_.size(), false);
  for (const Target& target : targets_) {
    rows_ += target.contact ? 6 : 3;
    for (const int d : target.chain) used[index(d)] = true;
  }
  for (std::size_t d = 0; d < used.size(); ++d) {
    if (used[d]) used_.push_back(d);
  }
  SHG_CHECK(rows_ <= kMaxIkRows, "too many goals for one motion");
  for (auto* of_dofs : {&inverse_, &reference_, &final_lengths_, &stretched_, &change_, &force_}) {
    of_dofs->resize(q_.size());
  }
  given_.resize(q_.size());
  shorter_.resize(q_.size());
  jacobian_.resize(rows_ * q_.size());
  residual_.resize(rows_);
  if (problem.hold_limits) limits_.emplace(body, used_);
}

void ReducedRollout::add_hand(int effector) {
  for (std::size_t i = 0; i < body_->limbs.size(); ++i) {
    const ReducedLimb& limb = body_->limbs[i];
    if (limb.joints.kind != LimbKind::arm || limb.joints.effector != effector) continue;
    moves_[i] = true;
    targets_.push_back(
        {.link = limb.slide, .carrier = limb.carrier, .chain = chain_to(*body_, limb.slide)});
    add_clavicle(limb);
  }
}

void ReducedRollout::add_planted_foot(const ReducedLimb& leg) {
  // the last of the ankle's freedoms, which follow the slide
  const int foot = leg.slide + (leg.joints.inversion < 0 ? 1 : 2);
  targets_.push_back({.link = foot,
                      .contact = true,
                      .position = placed_.origin[index(foot)],
                      .orientation = placed_.rotation[index(foot)],
                      .chain = chain_to(*body_, foot)});
}

void ReducedRollout::set_up(const Parameters& parameters) {
  int legs = 0;
  for (const ReducedLimb& limb : body_->limbs) legs += limb.joints.kind == LimbKind::leg ? 1 : 0;
  for (std::size_t d = 0; d < q_.size(); ++d) {
    q_[d] = body_->dofs[d].start;
    const JointWeight& joint = parameters.joints[d];
    inverse_[d] =
        joint.locked || body_->dofs[d].kind == ReducedDof::Kind::slide ? 0.0 : 1.0 / joint.weight;
    const int shared = body_->dofs[d].weight_of;
    if (shared >= 0) inverse_[d] = inverse_[index(shared)];
  }
  if (limits_) limits_->reset(inverse_);
  for (std::size_t i = 0; i < body_->limbs.size(); ++i) {
    const ReducedLimb& limb = body_->limbs[i];
    const double share = parameters.contractions[i] / kContractionMax;
    const auto slide = index(limb.slide);
    final_lengths_[slide] =
        moves_[i] ? limb.longest - (limb.longest - limb.shortest) * share : q_[slide];
    given_[slide] = limb.joints.kind == LimbKind::arm || legs == 1;
    stretched_[slide] = max(limb.longest, q_[slide]);
  }
  for (Target& target : targets_) target.lag = 0.0;
  place_reduced(*body_, q_, placed_);
  shorten_by_paths();
}

void ReducedRollout::shorten_by_paths() {
  for (std::size_t g = 0; g < problem_->goals.size(); ++g) {
    const auto slide = index(targets_[g].link);
    const ReducedLimb& limb =
        *std::find_if(body_->limbs.begin(), body_->limbs.end(),
                      [&](const ReducedLimb& l) { return l.slide == targets_[g].link; });
    if (limb.law != LengthLaw::path) continue;
    const EffectorPath& path = problem_->goals[g].path;
    const Vec3d& shoulder = placed_.origin[index(body_->dofs[slide].parent)];
    const auto distance = [&](double tau) { return norm(path.at(tau) - shoulder); };
    const double first = distance(0.0);
    const double last = distance(1.0);
    std::vector<double>& shorter = shorter_[slide];
    shorter.clear();
    // a shoulder that must be brought nearer does not stay
    if (last > limb.longest) continue;
    const double least = min(limb.shortest, q_[slide]);
    shorter.assign(1, 0.0);
    double share = kPathShare;
    for (int frame = 1; frame <= problem_->steps; ++frame) {
      const double tau = static_cast<double>(frame) / problem_->steps;
      const double schedule = minimum_jerk(tau);
      const double less = first + (last - first) * schedule - distance(tau);
      const double length = q_[slide] + (final_lengths_[slide] - q_[slide]) * schedule;
      const double room = less > 0.0 ? length - least : stretched_[slide] - length;
      if (abs(less) > room) share = min(share, max(room, 0.0) / abs(less));
      shorter.push_back(less);
    }
    for (double& less : shorter) less *= share;
  }
}

void ReducedRollout::run(const Parameters& parameters, ReducedClip& clip) {
  set_up(parameters);
  clip.dofs = static_cast<int>(q_.size());
  clip.values.clear();
  clip.trunk.clear();
  clip.hands.assign(problem_->goals.size(), {});
  clip.carriers.assign(problem_->goals.size(), {});
  keep_frame(clip);
  clip.path_error = clip.foot_error = 0.0;
  for (int frame = 1; frame <= problem_->steps; ++frame) {
    const double tau = static_cast<double>(frame) / problem_->steps;
    for (std::size_t g = 0; g < problem_->goals.size(); ++g) {
      targets_[g].position = problem_->goals[g].path.at(tau);
    }
    step(frame, true);
    step(frame, false);
    if (frame == problem_->steps) {
      ReducedClip last;
      for (int k = 0; k < kLastSteps && measure(last) > kLastTolerance; ++k) {
        step(frame, false);
        last = {};
      }
    }
    measure(clip);
    keep_frame(clip);
  }
}

void ReducedRollout::keep_frame(ReducedClip& clip) const {
  const auto trunk = index(body_->trunk);
  clip.values.insert(clip.values.end(), q_.begin(), q_.end());
  clip.trunk.push_back({placed_.rotation[trunk], placed_.origin[trunk]});
  for (std::size_t g = 0; g < clip.hands.size(); ++g) {
    clip.hands[g].push_back(placed_.origin[index(targets_[g].link)]);
    const auto carrier = index(targets_[g].carrier);
    clip.carriers[g].push_back({placed_.rotation[carrier], placed_.origin[carrier]});
  }
}

// adds what is missed now to the clip's largest errors; returns what is missed now (m)
double ReducedRollout::measure(ReducedClip& clip) {
  double worst = 0.0;
  for (Target& target : targets_) {
    const double miss = norm(target.position - placed_.origin[index(target.link)]);
    target.lag = miss;
    worst = max(worst, miss);
    if (!target.contact) {
      clip.path_error = max(clip.path_error, miss);
      continue;
    }
    const double tilt =
        kContactLength * rotation_chord(placed_.rotation[index(target.link)], target.orientation);
    worst = max(worst, tilt);
    clip.foot_error = max(clip.foot_error, max(miss, tilt));
  }
  // NaN counts as far off
  if (!(worst < 1e9)) clip.path_error = worst = 1e9;
  return worst;
}

// sets by how much each length is to change in this step
void ReducedRollout::draw_lengths(int frame, bool first) {
  const double schedule = minimum_jerk(static_cast<double>(frame) / problem_->steps);
  for (std::size_t d = 0; d < q_.size(); ++d) {
    const ReducedDof& dof = body_->dofs[d];
    if (dof.kind != ReducedDof::Kind::slide) continue;
    double length = dof.start + (final_lengths_[d] - dof.start) * schedule;
    if (!shorter_[d].empty()) length -= shorter_[d][index(frame)];
    if (first) inverse_[d] = given_[d] ? 0.0 : 1.0 / kLegStiffness;
    // a leg that gave way in the first step is left there by the second, but stretched out it
    // cannot give way: then the other one must
    const bool stretched = !given_[d] && !first && q_[d] > stretched_[d];
    if (stretched) inverse_[d] = 0.0;
    if (given_[d] || first) {
      reference_[d] = length - q_[d];
    } else {
      reference_[d] = stretched ? stretched_[d] - q_[d] : 0.0;
    }
  }
}

// changes lengths in full, and angles by no more than a step's limit
void ReducedRollout::apply_change() {
  double largest = 0.0;
  for (std::size_t d = 0; d < q_.size(); ++d) {
    if (body_->dofs[d].kind == ReducedDof::Kind::hinge) largest = max(largest, abs(change_[d]));
  }
  const double limit = problem_->ik.max_step;
  const double scale = limit / max(largest, limit);
  for (std::size_t d = 0; d < q_.size(); ++d) {
    q_[d] += change_[d] * (body_->dofs[d].kind == ReducedDof::Kind::hinge ? scale : 1.0);
  }
}

void ReducedRollout::step(int frame, bool first) {
  draw_lengths(frame, first);
  if (first) {
    if (limits_) limits_->soften(q_, inverse_);
    draw_clavicles();
  } else {
    for (const Clavicle& clavicle : clavicles_) {
      reference_[index(clavicle.elevation)] = reference_[index(clavicle.protraction)] = 0.0;
    }
  }
  fill_rows();
  if (limits_) limits_->lean_with_length(jacobian_);
  take_off_reference();
  solve();
  if (limits_ && first) limits_->learn(force_, change_);
  apply_change();
  if (limits_) {
    limits_->follow_length(change_, q_);
    limits_->hold(q_, inverse_);
  }
  place_reduced(*body_, q_, placed_);
}

void ReducedRollout::fill_rows() {
  const std::size_t dofs = q_.size();
  std::fill(jacobian_.begin(), jacobian_.end(), 0.0);
  std::size_t row = 0;
  const auto put = [&](std::size_t at, int dof, const Vec3d& v) {
    for (int k = 0; k < 3; ++k) jacobian_[(at + index(k)) * dofs + index(dof)] = v[k];
  };
  const auto miss = [&](std::size_t at, const Vec3d& v) {
    for (int k = 0; k < 3; ++k) residual_[at + index(k)] = v[k];
  };
  for (const Target& target : targets_) {
    const Vec3d& at = placed_.origin[index(target.link)];
    miss(row, target.position - at);
    for (const int d : target.chain) {
      const auto k = index(d);
      const bool slides = body_->dofs[k].kind == ReducedDof::Kind::slide;
      put(row, d, slides ? placed_.axis[k] : cross(placed_.axis[k], at - placed_.origin[k]));
      if (target.contact && !slides) put(row + 3, d, placed_.axis[k] * kContactLength);
    }
    row += 3;
    if (!target.contact) continue;
    miss(row,
         rotation_sine(placed_.rotation[index(target.link)], target.orientation) * kContactLength);
    row += 3;
  }
}

// e - J_L ΔL, of lengths that are given and of those that are drawn
void ReducedRollout::take_off_reference() {
  const std::size_t dofs = q_.size();
  for (std::size_t r = 0; r < rows_; ++r) {
    for (const std::size_t d : used_) residual_[r] -= jacobian_[r * dofs + d] * reference_[d];
  }
}

void ReducedRollout::solve() {
  const std::size_t dofs = q_.size();
  SmallSymmetric<double, kMaxIkRows> system{};
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (const std::size_t d : used_) {
        sum += jacobian_[i * dofs + d] * jacobian_[j * dofs + d] * inverse_[d];
      }
      system(static_cast<int>(i), static_cast<int>(j)) = sum;
    }
  }
  const IkSettings& ik = problem_->ik;
  int row = 0;
  double diagonal = 0.0;
  for (const Target& target : targets_) {
    const int count = target.contact ? 6 : 3;
    double mean = 0.0;
    for (int i = row; i < row + count; ++i) mean += system(i, i) / count;
    const double ratio = target.lag / ik.lag_scale;
    const double share =
        target.contact ? ik.contact_damping : ik.damping + ik.lag_damping * ratio * ratio;
    for (int i = row; i < row + count; ++i) system(i, i) += share * mean;
    diagonal = max(diagonal, mean);
    row += count;
  }
  ldlt_solve(system, residual_.data(), row, diagonal * kIkPivotFloor<double>);
  std::fill(change_.begin(), change_.end(), 0.0);
  for (const std::size_t d : used_) {
    double force = 0.0;
    for (std::size_t r = 0; r < rows_; ++r) force += jacobian_[r * dofs + d] * residual_[r];
    force_[d] = force;
    change_[d] = reference_[d] + force * inverse_[d];
  }
}

}  // namespace shigusa
