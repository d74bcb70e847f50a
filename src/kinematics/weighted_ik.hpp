// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "body/body_constants.hpp"
#include "core/check.hpp"
#include "core/index.hpp"
#include "kinematics/constraint.hpp"
#include "math/ldlt.hpp"

namespace shigusa {

// The inputs of one IK step.
template <class S>
struct IkStep {
  std::span<const Constraint<S>> constraints;
  // (dofs) 1 / w_i > 0, or 0 for a locked joint, which does not move at all
  std::span<const S> inverse_weights;
  // (dofs, rad) Δq_ref: the change made within the null space of the constraints; or empty
  std::span<const S> reference{};
};

struct IkSettings {
  // Constant damping of the goals, as a share of the mean diagonal of J W⁻¹ Jᵀ.
  double damping = 1e-6;
  // Additional damping at a lag of `lag_scale`; grows with the lag squared.
  double lag_damping = 1.0;
  double lag_scale = 0.1;  // m
  // The damping of contacts, just enough for redundant rows.
  double contact_damping = 1e-9;
  double max_step = 0.25;  // rad, largest change of an angle in one step
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
  // Three rows of the Jacobian: each constraint has a block for its position, and another for its
  // orientation, if it has one. Columns beside the chain count as 0.
  struct Block {
    std::span<const int> chain;
    const Vec3<S>* columns = nullptr;  // (dofs), of the chain: m/rad, or a tilt's axis
    Element<S> scale{1};               // m/rad equivalent to a tilt; 1 for a position
  };
  std::vector<Vec3<S>> columns;  // (blocks × dofs), but for turns about all axes
  Block blocks[kMaxIkRows / 3];
  std::vector<S> pull;   // (dofs) Jᵀ y: times the inverse weight, the step of the last solve
  std::vector<S> step;   // (dofs, rad) that step as returned
  std::vector<int> all;  // (dofs) the chain of a point whose place moves with a link
  SmallSymmetric<S, kMaxIkRows> system;
  S residual[kMaxIkRows];

  explicit IkWorkspace(const BodyModel& body) : IkWorkspace(body.dofs().size()) {}
  explicit IkWorkspace(std::size_t dofs)
      : columns(dofs * kMaxIkRows / 3), pull(dofs), step(pull), all(dofs) {
    for (std::size_t d = 0; d < dofs; ++d) all[d] = static_cast<int>(d);
  }
};

namespace ik_detail {

template <class S>
[[nodiscard]] int row_count(std::span<const Constraint<S>> constraints) {
  int rows = 0;
  for (const Constraint<S>& constraint : constraints) rows += constraint.rows();
  return rows;
}

template <class S>
void put(S* rows, const Vec3<S>& v) {
  rows[0] = v.x;
  rows[1] = v.y;
  rows[2] = v.z;
}

// Takes the movement of a constraint's place, which is on a link, off the columns of its point.
// Kept out of line, as few motions need it.
template <class S>
[[gnu::noinline]] void take_off_place(const BodyModel& body, const Kinematics<S>& kinematics,
                                      const Constraint<S>& constraint, Vec3<S>* columns) {
  for (int d = 0; d < body.dof_count(); ++d) {
    if (!body.moves(d, constraint.link)) columns[index(d)] = {};
  }
  const Vec3<S> place = place_in_world(kinematics, constraint);
  for (const int d : body.chain(constraint.carrier)) {
    columns[index(d)] = columns[index(d)] - position_column(kinematics, d, place);
  }
}

// Makes the rows of a block 0 in lanes in which its constraint is not active, so that they drop
// out. `columns`: for those of the block.
template <class S>
[[gnu::noinline]] void switch_rows(const S& active, typename IkWorkspace<S>::Block& block,
                                   Vec3<S>* columns, S* residual) {
  for (const int d : block.chain) columns[index(d)] = block.columns[index(d)] * active;
  block.columns = columns;
  for (int row = 0; row < 3; ++row) residual[row] = residual[row] * active;
}

// Fills the columns of the direction of a link's axis: a turn about the axis itself has no effect,
// so only the perpendicular part of each joint's counts.
template <class S>
void fill_direction(const Kinematics<S>& kinematics, const Constraint<S>& constraint,
                    std::span<const int> chain, Vec3<S>* columns) {
  const Vec3<S> along = kinematics.link_rotation(constraint.link) * to_scalar<S>(constraint.axis);
  for (const int d : chain) {
    const Vec3<S>& axis = kinematics.axis[index(d)];
    columns[index(d)] = axis - along * dot(along, axis);
  }
}

// Fills the blocks and the residual, constraint by constraint.
template <class S>
void fill_rows(const BodyModel& body, const Kinematics<S>& kinematics,
               std::span<const Constraint<S>> constraints, IkWorkspace<S>& workspace) {
  const auto& dofs = body.constants<Element<S>>().dofs;
  Vec3<S>* columns = workspace.columns.data();
  auto* block = workspace.blocks;
  S* residual = workspace.residual;
  const auto end_block = [&](const S& active) {
    if (any(active < S(1))) switch_rows(active, *block, columns, residual);
    columns += dofs.size();
    ++block;
    residual += 3;
  };
  for (const Constraint<S>& constraint : constraints) {
    const std::span<const int> chain = body.chain(constraint.link);
    const Vec3<S> at = kinematics.point(constraint.link, constraint.point);
    put(residual, place_in_world(kinematics, constraint) - at + constraint.lead);
    *block = {chain, columns, Element<S>(1)};
    Vec3<S> arm{};  // from the joint
    for (const int d : chain) {
      const std::size_t k = index(d);
      if (dofs[k].starts_joint) arm = at - kinematics.origin[k];
      columns[k] = cross(kinematics.axis[k], arm);
    }
    if (constraint.carrier != kWorldCarrier) {
      take_off_place(body, kinematics, constraint, columns);
      block->chain = workspace.all;
    }
    end_block(constraint.active);
    if (!constraint.turns()) continue;
    const Vec3<S> tilt = turn_error(kinematics, constraint) + constraint.tilt_lead;
    put(residual, tilt * S(kContactLength));
    *block = {chain, kinematics.axis.data(), static_cast<Element<S>>(kContactLength)};
    if (constraint.turning == Turning::axis) {
      fill_direction(kinematics, constraint, chain, columns);
      block->columns = columns;
    }
    end_block(constraint.active);
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

// The dofs of two blocks in which neither has columns of 0.
inline std::span<const int> shared_chain(std::span<const int> a, std::span<const int> b,
                                         std::size_t dofs) {
  // columns of a point whose place moves with a link are 0 beside their own chains
  if (a.size() == dofs) return b;
  if (b.size() == dofs) return a;
  // two chains share their dofs up to their branching
  const std::size_t most = a.size() < b.size() ? a.size() : b.size();
  std::size_t shared = 0;
  while (shared < most && a[shared] == b[shared]) ++shared;
  return a.first(shared);
}

// Fills J A Jᵀ, block by block.
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
      const std::span<const int> shared = shared_chain(a.chain, b.chain, workspace.all.size());
      Mat3<S> m = block_product(a.columns, b.columns, shared, inverse_weights);
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

// Adds the damping of each constraint to its rows; returns the largest mean diagonal of one.
template <class S>
S add_damping(std::span<const Constraint<S>> constraints, const IkSettings& settings,
              IkWorkspace<S>& workspace) {
  int row = 0;
  S largest(0);
  for (const Constraint<S>& constraint : constraints) {
    const int count = constraint.rows();
    S trace(0);
    for (int i = row; i < row + count; ++i) trace = trace + workspace.system(i, i);
    const S mean = trace * S(1.0 / count);
    const S ratio = constraint.lag * S(1.0 / settings.lag_scale);
    const S share = constraint.exact
                        ? S(settings.contact_damping)
                        : S(settings.damping) + S(settings.lag_damping) * ratio * ratio;
    const S added = share * mean;
    for (int i = row; i < row + count; ++i) workspace.system(i, i) = workspace.system(i, i) + added;
    largest = max(largest, mean);
    row += count;
  }
  return largest;
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
// where e is the whole remaining error of the points (closed loop with gain 1), plus the
// constraints' leads, and J has the rows of the points less those of their places, which may move
// with a link. D is diagonal and damps each goal separately:
//
//   D = (ε + λ (lag / ℓ)²) · mean diag(J A Jᵀ),   over the rows of the goal,
//
// with ε, λ and ℓ the damping, lag_damping and lag_scale of IkSettings; contacts have
// contact_damping for the bracket. The whole step is scaled down if an angle would change by more
// than settings.max_step. Scaling all weights has no effect.
//
// At most kMaxIkRows rows in all. Returns Δq (dofs, rad), which stays in the workspace.
template <class S>
std::span<const S> weighted_ik_step(const BodyModel& body, const Kinematics<S>& kinematics,
                                    const IkStep<S>& step, const IkSettings& settings,
                                    IkWorkspace<S>& workspace) {
  const int rows = ik_detail::row_count(step.constraints);
  SHG_CHECK(rows <= kMaxIkRows, "too many goals for one motion");
  const int blocks = rows / 3;
  const std::span<const S> inverse_weights = step.inverse_weights;
  const std::span<const S> reference = step.reference;
  ik_detail::fill_rows(body, kinematics, step.constraints, workspace);
  ik_detail::fill_products(blocks, inverse_weights, workspace);
  const S diagonal = ik_detail::add_damping(step.constraints, settings, workspace);
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
