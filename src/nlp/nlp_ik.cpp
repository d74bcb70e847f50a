// SPDX-License-Identifier: MIT
#include "nlp/nlp_ik.hpp"

#include <algorithm>
#include <utility>

namespace shigusa {
namespace {

// Share of the contacts' error left by a correction above which they are stiffened, the factor, and
// its limit.
constexpr double kSlowCorrection = 0.25;
constexpr double kStiffer = 4.0;
constexpr double kStiffnessMax = 1e8;
// Error of the feet, in slacks after all corrections, above which they count as moved.
constexpr double kLostContact = 5.0;
// Share of a goal's error left by a correction above which the goal counts as out of reach.
constexpr double kIdleCorrection = 0.7;

void check(const NlpIkSettings& s) {
  SHG_CHECK(s.damping >= 1e-9 && s.damping <= 1.0, "damping of NLP-IK");
  SHG_CHECK(s.lag_damping >= 0.0 && s.lag_scale > 0.0, "lag damping of NLP-IK");
  SHG_CHECK(s.limit_approach > 0.0 && s.limit_approach <= 1.0, "limit_approach of NLP-IK");
  SHG_CHECK(s.max_change > 0.0, "max_change of NLP-IK");
  SHG_CHECK(s.contact_stiffness >= 1.0 && s.contact_stiffness <= 1e4,
            "contact_stiffness of NLP-IK");
  SHG_CHECK(s.contact_slack > 0.0, "contact_slack of NLP-IK");
  SHG_CHECK(s.contact_corrections >= 0 && s.contact_corrections <= 1000,
            "contact_corrections of NLP-IK");
  SHG_CHECK(s.goal_slack > 0.0 && s.lead_limit >= 0.0, "goal_slack and lead_limit of NLP-IK");
  SHG_CHECK(s.goal_corrections >= 0 && s.goal_corrections <= 1000, "goal_corrections of NLP-IK");
}

// Derivative of `lead` · rotation_sine(r, wanted) by a rotation of the columns r: a moment.
Vec3d lead_moment(const Mat3d& r, const Mat3d& wanted, const Vec3d& lead) {
  return (cross(r.cx, cross(wanted.cx, lead)) + cross(r.cy, cross(wanted.cy, lead)) +
          cross(r.cz, cross(wanted.cz, lead))) *
         0.5;
}

}  // namespace

NlpIk::NlpIk(const BodyModel& body, State start, const NlpIkSettings& settings)
    : body_(&body),
      start_(std::move(start)),
      settings_(settings),
      metric_(body.dof_count()),
      kinematics_(body),
      size_(body.dofs().size()),
      z_(size_),
      reference_(size_),
      angles_(size_),
      loads_(size_.size()) {
  check(settings);
  add_limits();
  limits_.reserve(angle_limits_.size());
  limit_of_.reserve(angle_limits_.size());
  limit_scale_.reserve(angle_limits_.size());
}

void NlpIk::add_limits() {
  const std::span<const double> start = start_.angles;
  for (int d = 0; d < body_->dof_count(); ++d) {
    const std::size_t k = index(d);
    double upper = max(body_->dof(d).upper, start[k]);
    for (const LimitCoupling& c : body_->couplings()) {
      if (c.dof != d) continue;
      SHG_CHECK(c.gain >= 0.0, "NLP-IK knows no coupling that lowers a limit");
      const double slope = c.gain / c.driver_full;
      const double driver = start[index(c.driver)];
      // at an overstretched driver the coupled limit adds nothing for a start posture beyond it
      if (start[k] - slope * driver > upper) continue;
      angle_limits_.push_back({d, 1.0, c.driver, slope, upper});
      upper += c.gain;
    }
    angle_limits_.push_back({.dof = d, .bound = upper});
    angle_limits_.push_back({.dof = d, .sign = -1.0, .bound = -min(body_->dof(d).lower, start[k])});
  }
}

void NlpIk::begin(std::span<const Constraint<double>> targets,
                  std::span<const double> inverse_weights) {
  std::fill(z_.begin(), z_.end(), 0.0);
  stiffness_ = settings_.contact_stiffness;
  weigh(targets, inverse_weights);
}

void NlpIk::weigh(std::span<const Constraint<double>> targets,
                  std::span<const double> inverse_weights) {
  SHG_CHECK(inverse_weights.size() == size_.size(), "one inverse weight per dof");
  double largest = 0.0;
  for (const double inverse : inverse_weights) {
    SHG_CHECK(inverse >= 0.0 && is_finite(inverse), "inverse weights are finite and not negative");
    largest = max(largest, inverse);
  }
  const double scale = largest > 0.0 ? 1.0 / largest : 0.0;
  for (std::size_t d = 0; d < size_.size(); ++d) {
    // the guess keeps its change of angle
    const double change = z_[d] * size_[d];
    size_[d] = sqrt(inverse_weights[d] * scale * body_->dofs()[d].give);
    z_[d] = size_[d] > 0.0 ? change / size_[d] : 0.0;
  }
  measure_goals(targets);
  metric_.reset();
  scale_limits();
}

// Measures the mean diagonal of J W⁻¹ Jᵀ in the start posture, and sets the values based on it.
void NlpIk::measure_goals(std::span<const Constraint<double>> targets) {
  forward_kinematics<double>(*body_, start_.angles, kinematics_);
  double sum = 0.0;
  int goals = 0;
  for (const Constraint<double>& target : targets) {
    if (target.exact) continue;
    ++goals;
    const Vec3d at = kinematics_.point(target.link, target.point);
    for (const int d : body_->chain(target.link)) {
      const Vec3d column = position_column(kinematics_, d, at) * size_[index(d)];
      sum += dot(column, column);
    }
  }
  // if no dof moves the goals, any scale will do
  mean_diagonal_ = sum > 0.0 ? sum / (3.0 * goals) : 1.0;
  epsilon_ = settings_.damping * mean_diagonal_;
}

// Converts the limits that the unlocked dofs can reach to the variables of the search.
void NlpIk::scale_limits() {
  limits_.clear();
  limit_of_.clear();
  limit_scale_.clear();
  for (std::size_t i = 0; i < angle_limits_.size(); ++i) {
    const AngleLimit& limit = angle_limits_[i];
    const double a = limit.sign * size_[index(limit.dof)];
    const double b = -limit.gain * size_[index(limit.driver)];
    const double length = sqrt(a * a + b * b);
    if (!(length > 0.0)) continue;
    limits_.push_back({limit.dof, limit.driver, a / length, b / length, 0.0});
    limit_of_.push_back(i);
    limit_scale_.push_back(length);
  }
}

// Weight of the angles' changes, by the lag of the targets.
double NlpIk::damping(std::span<const Constraint<double>> targets) const {
  double lag = 0.0;
  for (const Constraint<double>& target : targets) {
    if (!target.exact) lag = max(lag, target.lag);
  }
  const double ratio = lag / settings_.lag_scale;
  return mean_diagonal_ * (settings_.damping + settings_.lag_damping * ratio * ratio);
}

void NlpIk::bind(std::span<const Constraint<double>> targets, std::span<const double> from,
                 std::span<const double> reference) {
  targets_ = targets;
  from_ = from;
  for (std::size_t d = 0; d < size_.size(); ++d) {
    reference_[d] = !reference.empty() && size_[d] > 0.0 ? reference[d] / size_[d] : 0.0;
  }
}

void NlpIk::set_bounds() {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const AngleLimit& limit = angle_limits_[limit_of_[i]];
    const double now =
        limit.sign * from_[index(limit.dof)] - limit.gain * from_[index(limit.driver)];
    const double room = max(limit.bound - now, 0.0) * settings_.limit_approach;
    const double most = limit.gain == 0.0 ? min(room, settings_.max_change) : room;
    limits_[i].bound = most / limit_scale_[i];
  }
}

NlpIkOutcome NlpIk::solve(std::span<Constraint<double>> targets, std::span<const double> from,
                          std::span<const double> reference, std::span<double> to) {
  bind(targets, from, reference);
  set_bounds();
  epsilon_ = damping(targets);
  set_curvature();
  NlpIkOutcome outcome;
  Misses before{__builtin_inf(), __builtin_inf()};
  for (int k = 0;; ++k) {
    minimise(outcome);
    place(to);
    const Misses now = correct_leads(targets);
    const bool feet_off = now.contact > settings_.contact_slack;
    const bool correct_feet = feet_off && k < settings_.contact_corrections;
    const bool correct_goals = now.goal > settings_.goal_slack && now.goal < settings_.lead_limit &&
                               now.goal < kIdleCorrection * before.goal &&
                               k < settings_.goal_corrections;
    if (!correct_feet && !correct_goals) {
      if (now.contact > kLostContact * settings_.contact_slack) stand_still(targets, to, outcome);
      return outcome;
    }
    if (feet_off && now.contact > kSlowCorrection * before.contact) stiffen(targets);
    before = now;
  }
}

// Minimises from the last posture's change, a good guess of the present one's.
void NlpIk::minimise(NlpIkOutcome& outcome) {
  const VariableMetricSettings settings{.tolerance = settings_.tolerance,
                                        .max_step = settings_.max_step,
                                        .iterations = settings_.iterations};
  const VariableMetricOutcome found = metric_.minimise(*this, limits_, size_, settings, z_);
  outcome.converged = outcome.converged && found.converged;
  outcome.evaluations += found.evaluations;
}

void NlpIk::place(std::span<double> to) {
  for (std::size_t d = 0; d < to.size(); ++d) to[d] = from_[d] + size_[d] * z_[d];
  forward_kinematics<double>(*body_, to, kinematics_);
}

// Keeps the last posture rather than let the feet move.
void NlpIk::stand_still(std::span<Constraint<double>> targets, std::span<double> to,
                        NlpIkOutcome& outcome) {
  outcome.converged = false;
  std::fill(z_.begin(), z_.end(), 0.0);
  place(to);
  for (Constraint<double>& target : targets) target.lead = target.tilt_lead = {};
}

// Adds the errors of the targets to their leads; returns the largest errors.
NlpIk::Misses NlpIk::correct_leads(std::span<Constraint<double>> targets) const {
  Misses worst;
  for (Constraint<double>& target : targets) {
    const Vec3d miss = position_error(kinematics_, target);
    if (!target.exact) {
      const double distance = norm(miss);
      target.lead = distance < settings_.lead_limit ? target.lead + miss : Vec3d{};
      worst.goal = max(distance, worst.goal);
      continue;
    }
    const Vec3d tilt = tilt_error(kinematics_, target);
    target.lead += miss;
    target.tilt_lead += tilt;
    worst.contact = max(max(norm(miss), kContactLength * norm(tilt)), worst.contact);
  }
  return worst;
}

// Increases the contacts' stiffness, with the forces of their leads unchanged.
void NlpIk::stiffen(std::span<Constraint<double>> targets) {
  if (stiffness_ >= kStiffnessMax) return;
  stiffness_ = stiffness_ * kStiffer;
  for (Constraint<double>& target : targets) {
    if (!target.exact) continue;
    target.lead = target.lead * (1.0 / kStiffer);
    target.tilt_lead = target.tilt_lead * (1.0 / kStiffer);
  }
  set_curvature();
}

// Sets Gauss and Newton's curvature: ε and J, at the guess.
void NlpIk::set_curvature() {
  for (std::size_t d = 0; d < size_.size(); ++d) angles_[d] = from_[d] + size_[d] * z_[d];
  forward_kinematics<double>(*body_, angles_, kinematics_);
  rows_.clear();
  rows_.reserve(6 * targets_.size() * size_.size());
  for (const Constraint<double>& target : targets_) {
    const Vec3d at = kinematics_.point(target.link, target.point);
    const double scale = target.exact ? sqrt(stiffness_) : 1.0;
    add_rows(target.link, scale, [&](int d) { return position_column(kinematics_, d, at); });
    if (!target.turns()) continue;
    const Vec3d along = kinematics_.link_rotation(target.link) * target.axis;
    const bool one_axis = target.turning == Turning::axis;
    add_rows(target.link, scale * kContactLength, [&](int d) {
      const Vec3d& axis = kinematics_.axis[index(d)];
      return one_axis ? axis - along * dot(along, axis) : axis;
    });
  }
  metric_.set_curvature(epsilon_, rows_);
}

// Adds three rows of the scaled Jacobian; column(d): of dof d, per radian.
template <class Column>
void NlpIk::add_rows(int link, double scale, Column&& column) {
  const std::size_t n = size_.size();
  const std::size_t begin = rows_.size();
  rows_.resize(begin + 3 * n, 0.0);
  for (const int d : body_->chain(link)) {
    const std::size_t k = index(d);
    const Vec3d v = column(d) * (scale * size_[k]);
    for (std::size_t i = 0; i < 3; ++i) rows_[begin + i * n + k] = v[static_cast<int>(i)];
  }
}

double NlpIk::objective(std::span<const Constraint<double>> targets, std::span<const double> from,
                        std::span<const double> reference, std::span<const double> at,
                        std::span<double> gradient) {
  bind(targets, from, reference);
  epsilon_ = damping(targets);
  for (std::size_t d = 0; d < size_.size(); ++d) {
    z_[d] = size_[d] > 0.0 ? (at[d] - from[d]) / size_[d] : 0.0;
  }
  const double value = evaluate(z_, gradient);
  for (std::size_t d = 0; d < size_.size(); ++d) {
    gradient[d] = size_[d] > 0.0 ? gradient[d] / size_[d] : 0.0;
  }
  return value;
}

double NlpIk::evaluate(std::span<const double> z, std::span<double> gradient) {
  for (std::size_t d = 0; d < size_.size(); ++d) angles_[d] = from_[d] + size_[d] * z[d];
  forward_kinematics<double>(*body_, angles_, kinematics_);
  double value = load_links();
  unload_links(gradient);
  double squares = 0.0;
  for (std::size_t d = 0; d < size_.size(); ++d) {
    const double change = z[d] - reference_[d];
    squares += size_[d] > 0.0 ? change * change : 0.0;
    gradient[d] = size_[d] * gradient[d] + (size_[d] > 0.0 ? epsilon_ * change : 0.0);
  }
  return value + 0.5 * epsilon_ * squares;
}

// Adds the targets' terms to the objective; each loads its link.
double NlpIk::load_links() {
  std::fill(loads_.begin(), loads_.end(), Load{});
  double value = 0.0;
  for (const Constraint<double>& target : targets_) {
    if (target.link == kBaseLink) continue;
    const Vec3d at = kinematics_.point(target.link, target.point);
    if (target.exact) {
      value += pull_contact(target, at);
      continue;
    }
    const Vec3d miss = at - target.place - target.lead;
    Load& load = loads_[index(target.link)];
    load.force += miss;
    load.moment += cross(at, miss);
    value += 0.5 * dot(miss, miss);
    if (!target.turns()) continue;
    const Vec3d turn = turn_error(kinematics_, target) * kContactLength;
    load.moment += -turn * kContactLength;
    value += 0.5 * dot(turn, turn);
  }
  return value;
}

double NlpIk::pull_contact(const Constraint<double>& target, const Vec3d& at) {
  const Vec3d miss = at - target.place - target.lead;
  const Mat3d& now = kinematics_.link_rotation(target.link);
  const Vec3d sine = rotation_sine(now, target.orientation);
  const double chord = rotation_chord(now, target.orientation);
  const double turning = stiffness_ * kContactLength * kContactLength;
  Load& load = loads_[index(target.link)];
  load.force += miss * stiffness_;
  load.moment += cross(at, miss) * stiffness_ +
                 (lead_moment(now, target.orientation, target.tilt_lead) - sine) * turning;
  return 0.5 * stiffness_ * dot(miss, miss) +
         turning * (0.5 * chord * chord + dot(sine, target.tilt_lead));
}

// Computes the gradient per radian of each joint: the load of the links beyond it, about its axis.
void NlpIk::unload_links(std::span<double> gradient) {
  for (std::size_t d = loads_.size(); d-- > 0;) {
    const Load& load = loads_[d];
    gradient[d] = dot(kinematics_.axis[d], load.moment - cross(kinematics_.origin[d], load.force));
    const int parent = body_->dof(static_cast<int>(d)).parent;
    if (parent == kBaseLink) continue;
    Load& carrier = loads_[index(parent)];
    carrier.force += load.force;
    carrier.moment += load.moment;
  }
}

}  // namespace shigusa
