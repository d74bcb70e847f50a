// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <span>
#include <vector>

#include "paper/layered_values.hpp"
#include "paper/reduced_limits.hpp"
#include "paper/reduced_problem.hpp"
#include "rollout/posture_law.hpp"

namespace shigusa {

// World placement of a reduced body's links.
template <class S>
struct ReducedPlacement {
  std::vector<Mat3<S>> rotation;  // (dofs) R_WL
  std::vector<Vec3<S>> origin;    // (dofs) m, world: a hinge's centre, a slide's far end
  std::vector<Vec3<S>> axis;      // (dofs) world: of rotation or translation

  explicit ReducedPlacement(std::size_t dofs) : rotation(dofs), origin(dofs), axis(dofs) {}
};

// Places the links of a reduced body, or some of them.
template <class S>
class ReducedLinks {
 public:
  // `placed`: all dofs to be placed, with those that carry them. The body outlives the object.
  ReducedLinks(const ReducedBody& body, std::span<const int> placed)
      : base_{to_scalar<S>(body.base.rotation), to_scalar<S>(body.base.translation)} {
    for (const int d : placed) {
      const ReducedDof& dof = body.dofs[index(d)];
      links_.push_back({index(d), dof.parent, dof.axis, dof.sign < 0.0,
                        dof.kind == ReducedDof::Kind::slide, dof.offset == Vec3d{},
                        to_scalar<Element<S>>(dof.offset)});
    }
  }

  // Places the links for these angles and lengths (dofs, rad or m).
  void place(std::span<const S> q, ReducedPlacement<S>& placed) const {
    for (const Link& link : links_) {
      const bool on_base = link.parent < 0;
      const Mat3<S>& carrier = on_base ? base_.rotation : placed.rotation[index(link.parent)];
      const Vec3<S>& from = on_base ? base_.translation : placed.origin[index(link.parent)];
      const std::size_t d = link.dof;
      Vec3<S> x = carrier.cx;
      Vec3<S> y = carrier.cy;
      Vec3<S> z = carrier.cz;
      Vec3<S> origin = from;
      if (!link.at_parent) origin += carrier * to_scalar<S>(link.offset);
      const Vec3<S>& column = link.axis == Axis::x ? x : link.axis == Axis::y ? y : z;
      const Vec3<S> axis = link.negative ? -column : column;
      placed.axis[d] = {axis.x, axis.y, axis.z};
      if (link.slides) {
        origin += axis * q[d];
      } else {
        const SinCos<S> turn = sin_cos(link.negative ? -q[d] : q[d]);
        if (link.axis == Axis::x) turn_columns(y, z, turn);
        if (link.axis == Axis::y) turn_columns(z, x, turn);
        if (link.axis == Axis::z) turn_columns(x, y, turn);
      }
      placed.origin[d] = {origin.x, origin.y, origin.z};
      placed.rotation[d] = {x, y, z};
    }
  }

 private:
  struct Link {
    std::size_t dof = 0;
    int parent = -1;
    Axis axis = Axis::x;
    bool negative = false;
    bool slides = false;
    bool at_parent = false;     // the offset is 0
    Vec3<Element<S>> offset{};  // m, in the parent's frame
  };

  Transform<S> base_;
  std::vector<Link> links_;
};

// Placement of all links in the start posture.
[[nodiscard]] ReducedPlacement<double> start_placement(const ReducedBody& body);

// The direction of an arm (the dof of its length) in the frame of the chest that carries its
// clavicle (the dof of its elevation).
template <class S>
[[nodiscard]] Vec3<S> arm_in_chest(const ReducedBody& body, const ReducedPlacement<S>& placed,
                                   int slide, int elevation) {
  const int chest = body.dofs[index(elevation)].parent;
  const Vec3<S>& along = placed.axis[index(slide)];
  return chest < 0 ? transpose_times(to_scalar<S>(body.base.rotation), along)
                   : transpose_times(placed.rotation[index(chest)], along);
}

// The values of a layer's joints and contractions, in one of two codes. Dofs without a weight of
// their own are locked. The paper's code: (parameters of the layer) each 0..kContractionMax; a
// weight of 0 locks.
[[nodiscard]] LayeredValues decode_layer_genes(const Layer& layer,
                                               std::span<const std::uint16_t> genes);
// The same in a code uniform in the weights' logarithms (kLogWeightRange), without locks, and
// uniform in contraction: (parameters of the layer) each 0..1.
[[nodiscard]] LayeredValues decode_layer_point(const Layer& layer, std::span<const double> point);

// The parameters of a reduced body's motion, in the form of its rollout.
template <class S>
struct ReducedInput {
  std::span<const S> inverse_weights;  // (dofs) 0 where locked
  std::span<const S> contractions;     // (limbs) 0..kContractionMax
};

// The angles and lengths of a reduced body's dofs, frame by frame, with the resulting placements.
template <class S>
struct ReducedClip {
  int dofs = 0;
  std::vector<S> values;                            // (frames × dofs) rad or m
  std::vector<Transform<S>> trunk;                  // (frames) X_WB of the trunk's link
  std::vector<std::vector<Vec3<S>>> hands;          // [goal][frame] m, world
  std::vector<std::vector<Transform<S>>> carriers;  // [goal][frame] of the link with the shoulder
  S path_error{};  // m, largest distance of a hand from its path over all frames
  S foot_error{};  // m, largest slide of a planted foot; its tilt counts by kContactLength

  [[nodiscard]] std::span<const S> frame(int number) const {
    return std::span<const S>(values).subspan(index(number) * index(dofs), index(dofs));
  }
};

// rad²/m²: cost of one metre of deviation from its length for one of two legs, relative to a dof of
// weight 1.
inline constexpr double kLegStiffness = 1500.0;
// Largest share of the hand's approach by which LengthLaw::path shortens an arm: with all of it the
// shoulder could stay, but the elbow folds faster than a trunk yields.
inline constexpr double kPathShare = 0.5;
// Largest number of corrections in a frame, and the error (m) of a target above which they are
// made.
inline constexpr int kCorrections = 3;
inline constexpr double kStepSlack = 5e-5;

// Moves a reduced body by weighted IK along the hands' paths (rules R3 and R6):
//
//   L(t) = L_0 + (L_f - L_0) s(t),  L_f = longest - (longest - shortest) · contraction / 15,
//   min Σ w_i Δq_i²   s.t.   J Δq = e - J_L ΔL,
//
// with s(t) the minimum jerk of the motion. By LengthLaw::path, if the goal is no farther than
// `longest` from the shoulder's start position, L(t) is reduced by a share k ≤ ½ of
//   d_0 + (d_f - d_0) s(t) - d(t),
// with d(t) the distance of the hand's path from the shoulder's start position and k the largest
// value that keeps the limb between `shortest` and `longest`. The lengths of the arms that have a
// goal, and of a single standing leg, are exactly L(t). Two standing legs are a closed chain, whose
// lengths can both be prescribed only for a level pelvis: there L(t) is a soft target, with a metre
// of difference counting as kLegStiffness rad², and neither leg exceeds `longest`. A step adds the
// shortfall of the last one, as in Rollout; a frame takes more steps if needed. If the problem
// holds limits, ReducedLimits applies. Clavicles of arms with goals follow the line from shoulder
// to hand by PostureLaw, if the problem has it.
//
// S is double, or a pack whose lanes have separate parameters. Owns scratch memory: one per thread.
// The problem outlives it.
template <class S>
class ReducedRollout {
 public:
  explicit ReducedRollout(const ReducedProblem& problem)
      : problem_(&problem),
        body_(problem.body),
        links_(*problem.body, problem.used),
        placed_(problem.dofs().size()),
        q_(problem.dofs().size()),
        inverse_(q_),
        reference_(q_),
        final_lengths_(q_),
        shares_(q_),
        change_(q_),
        before_(q_),
        limits_(problem),
        ik_(q_.size()) {
    for (const auto& target : problem.targets) {
      targets_.push_back({.place = to_scalar<S>(target.position),
                          .exact = target.contact,
                          .turning = target.contact ? Turning::whole : Turning::free,
                          .orientation = to_scalar<S>(target.orientation)});
    }
    given_.resize(q_.size());
    stretched_.resize(q_.size());
    for (const ReducedLimb& limb : body_->limbs) {
      const std::size_t slide = index(limb.slide);
      given_[slide].exactly = limb.joints.kind == LimbKind::arm || problem.legs == 1;
      stretched_[slide] = static_cast<Element<S>>(max(limb.longest, body_->dofs[slide].start));
    }
    find_shorter();
  }

  void run(const ReducedInput<S>& input, ReducedClip<S>& clip) {
    set_up(input);
    begin(clip);
    keep_frame(0, clip);
    for (int frame = 1; frame <= steps(); ++frame) {
      for (std::size_t g = 0; g < goals(); ++g) {
        targets_[g].place = to_scalar<S>(problem_->paths[index(frame) * goals() + g]);
      }
      step(frame, true);
      const S slack(frame == steps() ? kLastMiss<S> : kStepSlack);
      const int most = frame == steps() ? kLastSteps + 1 : kCorrections;
      S missed = measure(true);
      for (int k = 0; k < most && any(missed > slack); ++k) {
        correct(frame, missed > slack);
        missed = measure(false);
      }
      clip.path_error = max(clip.path_error, hands_missed_);
      clip.foot_error = max(clip.foot_error, feet_missed_);
      keep_frame(frame, clip);
    }
  }

 private:
  using T = Element<S>;
  // Shortening of a limb relative to its schedule by LengthLaw::path.
  struct Shorter {
    std::size_t slide = 0;
    const ReducedLimb* limb = nullptr;
    std::vector<S> less{};  // (frames) m
  };
  struct Given {
    bool exactly = false;
  };

  [[nodiscard]] int steps() const { return problem_->reach->steps; }
  [[nodiscard]] std::size_t goals() const { return problem_->reach->goals.size(); }
  [[nodiscard]] bool slides(std::size_t dof) const {
    return body_->dofs[dof].kind == ReducedDof::Kind::slide;
  }

  void find_shorter() {
    for (std::size_t d = 0; d < q_.size(); ++d) q_[d] = S(body_->dofs[d].start);
    links_.place(q_, placed_);
    for (std::size_t g = 0; g < goals(); ++g) {
      const auto& target = problem_->targets[g];
      const ReducedLimb& limb = body_->limbs[index(target.limb)];
      if (limb.law != LengthLaw::path) continue;
      const Vec3<S> shoulder = placed_.origin[index(body_->dofs[index(target.link)].parent)];
      const auto distance = [&](int frame) {
        return norm(to_scalar<S>(problem_->paths[index(frame) * goals() + g]) - shoulder);
      };
      const S first = distance(0);
      const S last = distance(steps());
      // a shoulder that must move nearer does not stay
      if (any(last > S(limb.longest))) continue;
      shorter_.push_back({index(target.link), &limb});
      for (int frame = 0; frame <= steps(); ++frame) {
        const S line = first + (last - first) * S(schedule(frame));
        shorter_.back().less.push_back(frame == 0 ? S(0) : line - distance(frame));
      }
    }
  }

  [[nodiscard]] double schedule(int frame) const {
    return minimum_jerk(static_cast<double>(frame) / steps());
  }

  void set_up(const ReducedInput<S>& input) {
    for (std::size_t d = 0; d < q_.size(); ++d) {
      const ReducedDof& dof = body_->dofs[d];
      q_[d] = S(dof.start);
      reference_[d] = S(0);
      const std::size_t shared = dof.weight_of >= 0 ? index(dof.weight_of) : d;
      inverse_[d] = slides(d) ? S(0) : input.inverse_weights[shared];
      final_lengths_[d] = q_[d];
    }
    limits_.reset(inverse_);
    for (const int number : problem_->moving) {
      const ReducedLimb& limb = body_->limbs[index(number)];
      const S share = input.contractions[index(number)] * S(1.0 / kContractionMax);
      final_lengths_[index(limb.slide)] = S(limb.longest) - S(limb.longest - limb.shortest) * share;
    }
    for (Constraint<S>& target : targets_) {
      target.lag = S(0);
      target.lead = target.tilt_lead = {};
    }
    links_.place(q_, placed_);
    for (const Shorter& shorter : shorter_) shorten(shorter);
  }

  // Finds the share by which a limb is shortened.
  void shorten(const Shorter& shorter) {
    const std::size_t slide = shorter.slide;
    const double start = body_->dofs[slide].start;
    const S least(min(shorter.limb->shortest, start));
    S share(kPathShare);
    for (int frame = 1; frame <= steps(); ++frame) {
      const S less = shorter.less[index(frame)];
      const S length = S(start) + (final_lengths_[slide] - S(start)) * S(schedule(frame));
      const S room = select(less > S(0), length - least, S(stretched_[slide]) - length);
      const auto tight = abs(less) > room;
      const S held = max(room, S(0)) / max(abs(less), S(1e-12));
      share = select(tight, min(share, held), share);
    }
    shares_[slide] = share;
  }

  void begin(ReducedClip<S>& clip) const {
    const std::size_t frames = index(steps() + 1);
    clip.dofs = static_cast<int>(q_.size());
    clip.values.resize(frames * q_.size());
    clip.trunk.resize(frames);
    clip.hands.resize(goals());
    clip.carriers.resize(goals());
    for (std::size_t g = 0; g < goals(); ++g) {
      clip.hands[g].resize(frames);
      clip.carriers[g].resize(frames);
    }
    clip.path_error = clip.foot_error = S(0);
  }

  void keep_frame(int frame, ReducedClip<S>& clip) const {
    const std::size_t f = index(frame);
    const std::size_t trunk = index(body_->trunk);
    for (std::size_t d = 0; d < q_.size(); ++d) clip.values[f * q_.size() + d] = q_[d];
    clip.trunk[f] = {placed_.rotation[trunk], placed_.origin[trunk]};
    for (std::size_t g = 0; g < goals(); ++g) {
      const auto& target = problem_->targets[g];
      const std::size_t carrier = index(target.carrier);
      clip.hands[g][f] = placed_.origin[index(target.link)];
      clip.carriers[g][f] = {placed_.rotation[carrier], placed_.origin[carrier]};
    }
  }

  // Measures the present errors; returns the largest (m). `learn`: adds the errors to the leads,
  // see Rollout.
  S measure(bool learn) {
    hands_missed_ = feet_missed_ = S(0);
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      Constraint<S>& target = targets_[t];
      const std::size_t link = index(problem_->targets[t].link);
      const Vec3<S> error = target.place - placed_.origin[link];
      const S miss = norm(error);
      const auto follows = miss < S(problem_->reach->lead_limit);
      target.lag = miss;
      if (learn) target.lead = select(follows, target.lead + error, Vec3<S>{});
      if (!target.exact) {
        hands_missed_ = far_off(max(miss, hands_missed_), miss);
        continue;
      }
      const Vec3<S> tilted = rotation_sine(placed_.rotation[link], target.orientation);
      if (learn) target.tilt_lead = select(follows, target.tilt_lead + tilted, Vec3<S>{});
      const S tilt = S(kContactLength) * rotation_chord(placed_.rotation[link], target.orientation);
      feet_missed_ = far_off(max(max(miss, tilt), feet_missed_), miss);
    }
    return max(hands_missed_, feet_missed_);
  }

  // Counts a NaN as far off.
  static S far_off(const S& most, const S& now) { return select(now < S(1e9), most, S(1e9)); }

  void step(int frame, bool first) {
    draw_lengths(frame, first);
    if (first) limits_.soften(q_, inverse_);
    draw_clavicles(first);
    fill_rows(first);
    solve();
    if (first) limits_.learn(ik_.pull, change_);
    apply_change();
    limits_.follow_length(change_, q_);
    limits_.hold(q_, inverse_);
    if (first) links_.place(q_, placed_);
  }

  // One more step in the lanes with errors.
  template <class Condition>
  void correct(int frame, const Condition& off) {
    for (std::size_t d = 0; d < q_.size(); ++d) before_[d] = q_[d];
    step(frame, false);
    for (std::size_t d = 0; d < q_.size(); ++d) q_[d] = select(off, q_[d], before_[d]);
    links_.place(q_, placed_);
  }

  // Sets the change of each length in this step.
  void draw_lengths(int frame, bool first) {
    const S done(schedule(frame));
    for (std::size_t d = 0; d < q_.size(); ++d) {
      if (!slides(d)) continue;
      const S start(body_->dofs[d].start);
      reference_[d] = start + (final_lengths_[d] - start) * done - q_[d];
      if (first) inverse_[d] = given_[d].exactly ? S(0) : S(1.0 / kLegStiffness);
      if (first || given_[d].exactly) continue;
      // a leg that yielded in the first step stays, but a stretched leg cannot yield: the other
      // must
      const S longest(stretched_[d]);
      const auto stretched = q_[d] > longest;
      inverse_[d] = select(stretched, S(0), inverse_[d]);
      reference_[d] = select(stretched, longest - q_[d], S(0));
    }
    for (const Shorter& shorter : shorter_) {
      const std::size_t d = shorter.slide;
      reference_[d] = reference_[d] - shorter.less[index(frame)] * shares_[d];
    }
  }

  void draw_clavicles(bool first) {
    for (const auto& clavicle : problem_->clavicles) {
      const auto draw = [&](int dof, const S& wanted) {
        const ReducedDof& of = body_->dofs[index(dof)];
        reference_[index(dof)] =
            first ? clamp(wanted, S(of.lower), S(of.upper)) - q_[index(dof)] : S(0);
      };
      const auto shrug =
          shrugged(arm_in_chest(*body_, placed_, clavicle.slide, clavicle.elevation));
      draw(clavicle.elevation, S(clavicle.elevation_start) + shrug.elevation);
      draw(clavicle.protraction, S(clavicle.protraction_start) + shrug.protraction);
    }
  }

  // Sets the remaining error, including the leads in a frame's first step.
  void fill_rows(bool first) {
    Vec3<S>* columns = ik_.columns.data();
    std::size_t b = 0;
    for (std::size_t t = 0; t < targets_.size(); ++t) {
      const auto& of = problem_->targets[t];
      const std::span<const int> chain(of.chain.data(), of.chain.size());
      const Vec3<S> at = placed_.origin[index(of.link)];
      for (const int dof : chain) {
        const std::size_t d = index(dof);
        columns[d] = slides(d) ? placed_.axis[d] : cross(placed_.axis[d], at - placed_.origin[d]);
      }
      const Vec3<S> lead = first ? targets_[t].lead : Vec3<S>{};
      add_block(b++, chain, columns, targets_[t].place - at + lead, 1.0);
      columns += q_.size();
      if (!of.contact) continue;
      for (const int dof : chain) {
        columns[index(dof)] = slides(index(dof)) ? Vec3<S>{} : placed_.axis[index(dof)];
      }
      Vec3<S> tilt = rotation_sine(placed_.rotation[index(of.link)], targets_[t].orientation);
      if (first) tilt += targets_[t].tilt_lead;
      add_block(b++, chain, columns, tilt * S(kContactLength), kContactLength);
      columns += q_.size();
    }
    blocks_ = static_cast<int>(b);
  }

  // Adds one block of three rows; its residual excludes the prescribed changes of lengths.
  void add_block(std::size_t b, std::span<const int> chain, Vec3<S>* columns,
                 const Vec3<S>& residual, double scale) {
    limits_.lean_with_length(chain, {columns, q_.size()});
    ik_.blocks[b] = {chain, columns, static_cast<T>(scale)};
    Vec3<S> done{};
    for (const int dof : chain) done += columns[index(dof)] * reference_[index(dof)];
    ik_detail::put(ik_.residual + 3 * b, residual - done * S(scale));
  }

  void solve() {
    ik_detail::fill_products<S>(blocks_, inverse_, ik_);
    const S diagonal = ik_detail::add_damping<S>(targets_, problem_->reach->ik, ik_);
    ik_detail::solve(3 * blocks_, diagonal * S(kIkPivotFloor<T>), ik_);
    ik_detail::pull_joints(blocks_, ik_);
    for (std::size_t d = 0; d < q_.size(); ++d) {
      change_[d] = reference_[d] + ik_.pull[d] * inverse_[d];
    }
  }

  // Applies changes of lengths in full, and of angles up to a step's limit.
  void apply_change() {
    S largest(0);
    for (std::size_t d = 0; d < q_.size(); ++d) {
      if (!slides(d)) largest = max(largest, abs(change_[d]));
    }
    const S limit(problem_->reach->ik.max_step);
    const S scale = limit / max(largest, limit);
    for (std::size_t d = 0; d < q_.size(); ++d) {
      q_[d] = q_[d] + (slides(d) ? change_[d] : change_[d] * scale);
    }
  }

  const ReducedProblem* problem_;
  const ReducedBody* body_;
  std::vector<Constraint<S>> targets_;  // in the problem's order; links and points are unused
  std::vector<Shorter> shorter_;
  std::vector<Given> given_;  // (dofs) for slides: exact length, or a soft target
  std::vector<T> stretched_;  // (dofs) m, for slides: upper bound of a soft target
  ReducedLinks<S> links_;
  ReducedPlacement<S> placed_;
  std::vector<S> q_;
  std::vector<S> inverse_;        // (dofs)
  std::vector<S> reference_;      // (dofs) prescribed change of slides and clavicles
  std::vector<S> final_lengths_;  // (dofs) m, of slides
  std::vector<S> shares_;         // (dofs) for slides in `shorter_`: applied share of it
  std::vector<S> change_;         // (dofs)
  std::vector<S> before_;         // (dofs) q_ before a correction
  ReducedLimits<S> limits_;
  IkWorkspace<S> ik_;
  int blocks_ = 0;
  S hands_missed_{};  // m, present error
  S feet_missed_{};
};

}  // namespace shigusa
