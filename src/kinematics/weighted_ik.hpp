// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/body_constants.hpp"
#include "core/check.hpp"
#include "core/index.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "math/ldlt.hpp"
#include "motion/effector_turn.hpp"

namespace shigusa {

// Target position of one point of the body, and target orientation of its link. A contact is met
// exactly and also keeps its orientation; a goal is damped where it cannot be met.
template <class S>
struct IkTarget {
  int link = 0;
  Vec3<Element<S>> point{};  // m, in the link frame
  Vec3<S> position{};        // m, world: target position of the point
  bool contact = false;      // planted foot: position and orientation
  Mat3<S> orientation{};     // target R_WL of the link; for contacts and Turning::whole
  S lag{};                   // m, the goal's previous error: raises its damping
  // Known shortfall of a step, as joints move on arcs: added to the remaining error.
  Vec3<S> lead{};                   // m
  Vec3<S> tilt_lead{};              // rad; used if turns() is true
  Turning turning = Turning::free;  // for goals
  Vec3<Element<S>> axis{};          // for Turning::axis: unit vector in the link's frame
  Vec3<S> direction{};              // target direction of the axis, unit vector in the world

  [[nodiscard]] bool turns() const { return contact || turning != Turning::free; }
};

// The world as the carrier of a fixed place.
inline constexpr int kWorldCarrier = -2;

// A point of one link held at a place on another, its carrier: a hand on a thigh. Met exactly, like
// a contact.
template <class S>
struct IkSupport {
  int link = 0;
  Vec3<Element<S>> point{};     // m, in the link frame
  int carrier = kWorldCarrier;  // link, or kWorldCarrier
  Vec3<S> place{};              // m, in the carrier's frame, or the world's
  S holds{};                    // 1, or 0 if the point is free
  Vec3<S> lead{};               // m, see IkTarget
};

// The inputs of one IK step.
template <class S>
struct IkStep {
  std::span<const IkTarget<S>> targets;
  // (dofs) 1 / w_i > 0, or 0 for a locked joint, which does not move at all
  std::span<const S> inverse_weights;
  // (dofs, rad) Δq_ref: the change made within the null space of the targets; or empty
  std::span<const S> reference{};
  std::span<const IkSupport<S>> supports{};
};

struct IkSettings {
  // Constant damping of the goals, as a share of the mean diagonal of J W⁻¹ Jᵀ.
  double damping = 1e-6;
  // Additional damping at a lag of `lag_scale`; grows with the lag squared.
  double lag_damping = 1.0;
  double lag_scale = 0.1;  // m
  // The damping of contacts, just enough for redundant rows.
  double contact_damping = 1e-9;
  double support_damping = 1e-9;  // damping of supports
  double max_step = 0.25;         // rad, largest change of an angle in one step
};

// Size of the largest system: a foot and two hands with orientations × 6 rows, head and hips × 3
// rows.
inline constexpr int kMaxIkRows = 24;
// Share of the diagonal below which a pivot counts as rounding: its row depends on others.
template <class T>
inline constexpr double kIkPivotFloor = 1e-14;
template <>
inline constexpr double kIkPivotFloor<float> = 1e-7;
// m; displacement equivalent to one radian of a contact's tilt, about half a foot's length.
inline constexpr double kContactLength = 0.1;

// Scratch memory of weighted_ik_step; one per thread.
template <class S>
struct IkWorkspace {
  // Three rows of the Jacobian: each target has a block for its position, and another for its
  // orientation, if it has one. Only the columns along the chain of dofs that move the target are
  // not 0.
  struct Block {
    std::span<const int> chain;
    const Vec3<S>* columns = nullptr;  // (dofs), of the chain: m/rad, or a tilt's axis
    Element<S> scale{1};               // m/rad equivalent to a tilt; 1 for a position
  };
  std::vector<Vec3<S>> columns;  // of positions, and of turns about two axes, (blocks × dofs)
  Block blocks[kMaxIkRows / 3];
  std::vector<S> pull;   // (dofs) Jᵀ y: times the inverse weight, the step of the last solve
  std::vector<S> step;   // (dofs, rad) that step as returned
  std::vector<int> all;  // (dofs) the chain of a support's block
  SmallSymmetric<S, kMaxIkRows> system;
  S residual[kMaxIkRows];

  explicit IkWorkspace(const BodyModel& body) : IkWorkspace(body.dofs().size()) {}
  explicit IkWorkspace(std::size_t dofs)
      : columns(dofs * kMaxIkRows / 3), pull(dofs), step(pull), all(dofs) {
    for (std::size_t d = 0; d < dofs; ++d) all[d] = static_cast<int>(d);
  }
};

// Error of the target's point (m, world).
template <class S>
[[nodiscard]] Vec3<S> position_error(const Kinematics<S>& kinematics, const IkTarget<S>& target) {
  return target.position - kinematics.point(target.link, target.point);
}

// Position of a support's place (m, world).
template <class S>
[[nodiscard]] Vec3<S> place_in_world(const Kinematics<S>& kinematics, const IkSupport<S>& support) {
  if (support.carrier == kWorldCarrier) return support.place;
  return kinematics.link_origin(support.carrier) +
         kinematics.link_rotation(support.carrier) * support.place;
}

// Error of the support's point (m, world); 0 if it is free.
template <class S>
[[nodiscard]] Vec3<S> support_error(const Kinematics<S>& kinematics, const IkSupport<S>& support) {
  const Vec3<S> at = kinematics.point(support.link, support.point);
  return (place_in_world(kinematics, support) - at) * support.holds;
}

// Rotation of a contact's link back to its orientation (rad for small ones, world).
template <class S>
[[nodiscard]] Vec3<S> tilt_error(const Kinematics<S>& kinematics, const IkTarget<S>& target) {
  return rotation_sine(kinematics.link_rotation(target.link), target.orientation);
}

// Angle of a contact's link from its orientation (rad for small turns, see rotation_chord).
template <class S>
[[nodiscard]] S tilt(const Kinematics<S>& kinematics, const IkTarget<S>& target) {
  return rotation_chord(kinematics.link_rotation(target.link), target.orientation);
}

// Rotation of the link to the target's orientation (rotation vector, rad, world); for contacts as
// tilt_error.
template <class S>
[[nodiscard]] Vec3<S> turn_error(const Kinematics<S>& kinematics, const IkTarget<S>& target) {
  const Mat3<S>& now = kinematics.link_rotation(target.link);
  if (target.contact) return tilt_error(kinematics, target);
  if (target.turning == Turning::axis) {
    return turn_between(now * to_scalar<S>(target.axis), target.direction);
  }
  return rotation_vector(target.orientation * transpose(now));
}

// Number of rows of a target in the IK.
template <class S>
[[nodiscard]] int row_count(const IkTarget<S>& target) {
  return target.turns() ? 6 : 3;
}

namespace ik_detail {

template <class S>
[[nodiscard]] int row_count(std::span<const IkTarget<S>> targets) {
  int rows = 0;
  for (const IkTarget<S>& target : targets) rows += shigusa::row_count(target);
  return rows;
}

template <class S>
void put(S* rows, const Vec3<S>& v) {
  rows[0] = v.x;
  rows[1] = v.y;
  rows[2] = v.z;
}

// Fills the blocks and the residual, target by target.
template <class S>
void fill_rows(const BodyModel& body, const Kinematics<S>& kinematics,
               std::span<const IkTarget<S>> targets, IkWorkspace<S>& workspace) {
  const auto& dofs = body.constants<Element<S>>().dofs;
  Vec3<S>* columns = workspace.columns.data();
  std::size_t b = 0;
  for (const IkTarget<S>& target : targets) {
    const std::span<const int> chain = body.chain(target.link);
    const Vec3<S> at = kinematics.point(target.link, target.point);
    put(workspace.residual + 3 * b, target.position - at + target.lead);
    workspace.blocks[b++] = {chain, columns, Element<S>(1)};
    Vec3<S> arm{};  // from the joint
    for (const int d : chain) {
      const std::size_t k = index(d);
      if (dofs[k].starts_joint) arm = at - kinematics.origin[k];
      columns[k] = cross(kinematics.axis[k], arm);
    }
    columns += dofs.size();
    if (!target.turns()) continue;
    const Vec3<S> tilt = turn_error(kinematics, target) + target.tilt_lead;
    put(workspace.residual + 3 * b, tilt * S(kContactLength));
    const Vec3<S>* axes = kinematics.axis.data();
    if (target.turning == Turning::axis) {
      // a turn about the axis itself has no effect: only the perpendicular part of each joint
      // counts
      const Vec3<S> along = kinematics.link_rotation(target.link) * to_scalar<S>(target.axis);
      for (const int d : chain) {
        const std::size_t k = index(d);
        columns[k] = axes[k] - along * dot(along, axes[k]);
      }
      axes = columns;
      columns += dofs.size();
    }
    workspace.blocks[b++] = {chain, axes, static_cast<Element<S>>(kContactLength)};
  }
}

// One 3 × 3 block of J A Jᵀ, below the diagonal: Σ a_d A_d b_dᵀ over the dofs of the chain.
template <class S>
[[nodiscard, gnu::always_inline]] inline Mat3<S> block_product(const Vec3<S>* a, const Vec3<S>* b,
                                                               std::span<const int> chain,
                                                               std::span<const S> inverse_weights) {
  Vec3<S> x{};
  Vec3<S> y{};
  Vec3<S> z{};
  for (const int dof : chain) {
    const std::size_t d = index(dof);
    const Vec3<S> weighted = b[d] * inverse_weights[d];
    x += a[d] * weighted.x;
    y += a[d] * weighted.y;
    z += a[d] * weighted.z;
  }
  return {x, y, z};
}

// One block on the diagonal: it is symmetric, and elements above its own diagonal stay 0.
template <class S>
[[nodiscard, gnu::always_inline]] inline Mat3<S> square_product(
    const Vec3<S>* a, std::span<const int> chain, std::span<const S> inverse_weights) {
  Vec3<S> x{};
  S yy(0);
  S yz(0);
  S zz(0);
  for (const int dof : chain) {
    const std::size_t d = index(dof);
    const Vec3<S> weighted = a[d] * inverse_weights[d];
    x += a[d] * weighted.x;
    yy = yy + a[d].y * weighted.y;
    yz = yz + a[d].z * weighted.y;
    zz = zz + a[d].z * weighted.z;
  }
  return {x, {S(0), yy, yz}, {S(0), S(0), zz}};
}

template <class S>
void scale_block(Mat3<S>& m, S scale) {
  m = {m.cx * scale, m.cy * scale, m.cz * scale};
}

// Fills J A Jᵀ, block by block: two chains share their dofs up to their branching.
template <class S>
void fill_products(int blocks, std::span<const S> inverse_weights, IkWorkspace<S>& workspace) {
  for (int i = 0; i < blocks; ++i) {
    const auto& a = workspace.blocks[i];
    for (int j = 0; j <= i; ++j) {
      const auto& b = workspace.blocks[j];
      const Element<S> scale = a.scale * b.scale;
      if (i == j) {
        Mat3<S> m = square_product(a.columns, a.chain, inverse_weights);
        if (scale != Element<S>(1)) scale_block(m, S(scale));
        workspace.system(3 * i, 3 * i) = m.cx.x;
        workspace.system(3 * i + 1, 3 * i) = m.cx.y;
        workspace.system(3 * i + 1, 3 * i + 1) = m.cy.y;
        put(&workspace.system(3 * i + 2, 3 * i), {m.cx.z, m.cy.z, m.cz.z});
        continue;
      }
      const std::size_t most = a.chain.size() < b.chain.size() ? a.chain.size() : b.chain.size();
      std::size_t shared = 0;
      while (shared < most && a.chain[shared] == b.chain[shared]) ++shared;
      Mat3<S> m = block_product(a.columns, b.columns, a.chain.first(shared), inverse_weights);
      if (scale != Element<S>(1)) scale_block(m, S(scale));
      put(&workspace.system(3 * i, 3 * j), {m.cx.x, m.cy.x, m.cz.x});
      put(&workspace.system(3 * i + 1, 3 * j), {m.cx.y, m.cy.y, m.cz.y});
      put(&workspace.system(3 * i + 2, 3 * j), {m.cx.z, m.cy.z, m.cz.z});
    }
  }
}

// Computes e - J Δq_ref, without the locked dofs' part.
template <class S>
void take_off_reference(int blocks, std::span<const S> inverse_weights,
                        std::span<const S> reference, IkWorkspace<S>& workspace) {
  for (int b = 0; b < blocks; ++b) {
    const auto& block = workspace.blocks[b];
    Vec3<S> done{};
    for (const int dof : block.chain) {
      const std::size_t d = index(dof);
      done += block.columns[d] * select(inverse_weights[d] > S(0), reference[d], S(0));
    }
    S* residual = workspace.residual + 3 * b;
    put(residual, Vec3<S>{residual[0], residual[1], residual[2]} - done * S(block.scale));
  }
}

// Solves the system for the residual in place.
template <class S>
void solve(int rows, S pivot_floor, IkWorkspace<S>& workspace) {
  switch (rows) {
    case 3:  // a hand
      return ldlt_solve_fixed<3>(workspace.system, workspace.residual, pivot_floor);
    case 6:  // two hands, or a foot
      return ldlt_solve_fixed<6>(workspace.system, workspace.residual, pivot_floor);
    case 9:  // a hand and a foot
      return ldlt_solve_fixed<9>(workspace.system, workspace.residual, pivot_floor);
    case 12:  // two hands and a foot
      return ldlt_solve_fixed<12>(workspace.system, workspace.residual, pivot_floor);
    default:
      return ldlt_solve(workspace.system, workspace.residual, rows, pivot_floor);
  }
}

// Adds the damping of each target to its rows; returns the largest mean diagonal of a target.
template <class S>
S add_damping(std::span<const IkTarget<S>> targets, const IkSettings& settings,
              IkWorkspace<S>& workspace) {
  int row = 0;
  S largest(0);
  for (const IkTarget<S>& target : targets) {
    const int count = shigusa::row_count(target);
    S trace(0);
    for (int i = row; i < row + count; ++i) trace = trace + workspace.system(i, i);
    const S mean = trace * S(1.0 / count);
    const S ratio = target.lag * S(1.0 / settings.lag_scale);
    const S share = target.contact ? S(settings.contact_damping)
                                   : S(settings.damping) + S(settings.lag_damping) * ratio * ratio;
    const S added = share * mean;
    for (int i = row; i < row + count; ++i) workspace.system(i, i) = workspace.system(i, i) + added;
    largest = max(largest, mean);
    row += count;
  }
  return largest;
}

// Fills the blocks of supports, from block `b` on, and their residual: the columns of a point minus
// those of its place. They are 0 in free lanes, whose rows so drop out.
template <class S>
void fill_support_rows(const BodyModel& body, const Kinematics<S>& kinematics,
                       std::span<const IkSupport<S>> supports, std::size_t b,
                       IkWorkspace<S>& workspace) {
  const auto& dofs = body.constants<Element<S>>().dofs;
  for (const IkSupport<S>& support : supports) {
    // every block before this one has at most one array of columns
    Vec3<S>* columns = workspace.columns.data() + b * dofs.size();
    for (std::size_t d = 0; d < dofs.size(); ++d) columns[d] = {};
    const auto add = [&](int link, const Vec3<S>& at, const S& sign) {
      Vec3<S> arm{};  // from the joint
      for (const int d : body.chain(link)) {
        const std::size_t k = index(d);
        if (dofs[k].starts_joint) arm = at - kinematics.origin[k];
        columns[k] += cross(kinematics.axis[k], arm) * sign;
      }
    };
    add(support.link, kinematics.point(support.link, support.point), support.holds);
    if (support.carrier != kWorldCarrier) {
      add(support.carrier, place_in_world(kinematics, support), -support.holds);
    }
    put(workspace.residual + 3 * b,
        support_error(kinematics, support) + support.lead * support.holds);
    workspace.blocks[b++] = {workspace.all, columns, Element<S>(1)};
  }
}

// Fills the blocks of J A Jᵀ of supports, from block `first` on, with their damping; returns the
// largest mean diagonal of a block.
template <class S>
S fill_support_products(int first, int blocks, std::span<const S> inverse_weights, double damping,
                        IkWorkspace<S>& workspace) {
  S largest(0);
  for (int i = first; i < blocks; ++i) {
    const auto& a = workspace.blocks[i];
    for (int j = 0; j <= i; ++j) {
      const auto& b = workspace.blocks[j];
      // a support's columns are 0 outside its own chains
      Mat3<S> m = block_product(a.columns, b.columns, b.chain, inverse_weights);
      if (b.scale != Element<S>(1)) scale_block(m, S(b.scale));
      const Vec3<S> rows[] = {
          {m.cx.x, m.cy.x, m.cz.x}, {m.cx.y, m.cy.y, m.cz.y}, {m.cx.z, m.cy.z, m.cz.z}};
      for (int row = 0; row < 3; ++row) {
        const int columns = i == j ? row + 1 : 3;
        for (int k = 0; k < columns; ++k) {
          workspace.system(3 * i + row, 3 * j + k) = k == 0   ? rows[row].x
                                                     : k == 1 ? rows[row].y
                                                              : rows[row].z;
        }
      }
    }
    S trace(0);
    for (int row = 3 * i; row < 3 * i + 3; ++row) trace = trace + workspace.system(row, row);
    const S mean = trace * S(1.0 / 3.0);
    for (int row = 3 * i; row < 3 * i + 3; ++row) {
      workspace.system(row, row) = workspace.system(row, row) + mean * S(damping);
    }
    largest = max(largest, mean);
  }
  return largest;
}

// Adds the rows of a step's supports after those of its targets; returns the largest mean diagonal
// of a block. Kept out of line, as few motions have supports.
template <class S>
[[gnu::noinline]] S add_supports(const BodyModel& body, const Kinematics<S>& kinematics,
                                 const IkStep<S>& step, const IkSettings& settings,
                                 IkWorkspace<S>& workspace) {
  const int first = row_count(step.targets) / 3;
  const int blocks = first + static_cast<int>(step.supports.size());
  fill_support_rows(body, kinematics, step.supports, index(first), workspace);
  return fill_support_products(first, blocks, step.inverse_weights, settings.support_damping,
                               workspace);
}

// Computes Jᵀ y, with the solution y in the residual.
template <class S>
[[gnu::always_inline]] inline void pull_joints(int blocks, IkWorkspace<S>& workspace) {
  for (S& pull : workspace.pull) pull = S(0);
  for (int b = 0; b < blocks; ++b) {
    const auto& block = workspace.blocks[b];
    const S* solution = workspace.residual + 3 * b;
    const Vec3<S> force = Vec3<S>{solution[0], solution[1], solution[2]} * S(block.scale);
    for (const int dof : block.chain) {
      const std::size_t d = index(dof);
      workspace.pull[d] = workspace.pull[d] + dot(block.columns[d], force);
    }
  }
}

}  // namespace ik_detail

// One step of weighted inverse kinematics, by a damped and weighted pseudo-inverse of the Jacobian
// (paper, section 3; rule R6):
//
//   min Σ w_i (Δq_i - Δq_ref,i)²   s.t.   J Δq = e,
//   Δq = Δq_ref + A Jᵀ (J A Jᵀ + D)⁻¹ (e - J Δq_ref),   A = diag(1 / w_i), 0 where locked,
//
// where e is the whole remaining error of the points (closed loop with gain 1), plus the targets'
// leads. D is diagonal and damps each goal separately:
//
//   D = (ε + λ (lag / ℓ)²) · mean diag(J A Jᵀ),   over the rows of the goal,
//
// with ε, λ and ℓ the damping, lag_damping and lag_scale of IkSettings; contacts have
// contact_damping for the bracket, and supports, with the rows of their points minus those of their
// places, support_damping. The whole step is scaled down if an angle would change by more than
// settings.max_step. Scaling all weights has no effect.
//
// At most kMaxIkRows rows in all. Returns Δq (dofs, rad), which stays in the workspace.
template <class S>
std::span<const S> weighted_ik_step(const BodyModel& body, const Kinematics<S>& kinematics,
                                    const IkStep<S>& step, const IkSettings& settings,
                                    IkWorkspace<S>& workspace) {
  const int free = ik_detail::row_count(step.targets);
  const int rows = free + 3 * static_cast<int>(step.supports.size());
  SHG_CHECK(rows <= kMaxIkRows, "too many goals for one motion");
  const int blocks = rows / 3;
  const std::span<const S> inverse_weights = step.inverse_weights;
  const std::span<const S> reference = step.reference;
  ik_detail::fill_rows(body, kinematics, step.targets, workspace);
  ik_detail::fill_products(free / 3, inverse_weights, workspace);
  S diagonal = ik_detail::add_damping(step.targets, settings, workspace);
  if (!step.supports.empty()) {
    diagonal = max(diagonal, ik_detail::add_supports(body, kinematics, step, settings, workspace));
  }
  if (!reference.empty()) {
    ik_detail::take_off_reference(blocks, inverse_weights, reference, workspace);
  }
  ik_detail::solve(rows, diagonal * S(kIkPivotFloor<Element<S>>), workspace);
  ik_detail::pull_joints(blocks, workspace);
  const std::span<S> dq = workspace.step;
  S largest(0);
  for (std::size_t d = 0; d < dq.size(); ++d) {
    dq[d] = workspace.pull[d] * inverse_weights[d];
    if (!reference.empty()) {
      dq[d] = dq[d] + select(inverse_weights[d] > S(0), reference[d], S(0));
    }
    largest = max(largest, abs(dq[d]));
  }
  const S limit(settings.max_step);
  const S scale = limit / max(largest, limit);
  for (S& change : dq) change = change * scale;
  return dq;
}

}  // namespace shigusa
