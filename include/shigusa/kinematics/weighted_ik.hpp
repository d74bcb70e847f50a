// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/core/check.hpp>
#include <shigusa/kinematics/forward_kinematics.hpp>
#include <shigusa/math/ldlt.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Where one point of the body is to be. A contact is met exactly and also keeps its orientation; a
// goal gives way (is damped) where it cannot be met.
template <class S>
struct IkTarget {
  int link = 0;
  Vec3d point{};          // m, in the link frame
  Vec3<S> position{};     // m, world: where the point is to be
  bool contact = false;   // a planted foot: position and orientation
  Mat3<S> orientation{};  // R_WL wanted of the link; read for contacts only
  S lag{};                // m, how far the goal was missed before: raises its damping
};

struct IkSettings {
  // Damping of the goals, as a share of the mean diagonal of J W⁻¹ Jᵀ: what is always there …
  double damping = 1e-6;
  // … and what is added where the goal lags behind by `lag_scale`; grows with the lag squared.
  double lag_damping = 1.0;
  double lag_scale = 0.1;  // m
  // Contacts are all but undamped: just enough for redundant rows.
  double contact_damping = 1e-9;
  double max_step = 0.25;  // rad, no angle changes by more in one step
};

// Size of the largest system: 2 hands × 3 rows, 2 feet × 6 rows, and room for more goals.
inline constexpr int kMaxIkRows = 24;
// m; one radian of a contact's tilt counts as this much displacement, about a foot's half length.
inline constexpr double kContactLength = 0.1;

// Scratch of weighted_ik_step; make one per thread.
template <class S>
struct IkWorkspace {
  std::vector<S> jacobian;  // (rows × dofs) m/rad
  SmallSymmetric<S, kMaxIkRows> system;
  S residual[kMaxIkRows];

  explicit IkWorkspace(const BodyModel& body)
      : jacobian(static_cast<std::size_t>(kMaxIkRows) * body.dofs().size()) {}
};

namespace ik_detail {

template <class S>
[[nodiscard]] int row_count(std::span<const IkTarget<S>> targets) {
  int rows = 0;
  for (const IkTarget<S>& target : targets) rows += target.contact ? 6 : 3;
  return rows;
}

// fills the Jacobian's rows and the residual, target by target
template <class S>
void fill_rows(const BodyModel& body, const Kinematics<S>& kinematics,
               std::span<const IkTarget<S>> targets, IkWorkspace<S>& workspace) {
  const int n = body.dof_count();
  int row = 0;
  const auto put = [&](int r, int dof, const Vec3<S>& v) {
    for (int k = 0; k < 3; ++k) {
      workspace.jacobian[static_cast<std::size_t>((r + k) * n + dof)] = v[k];
    }
  };
  for (const IkTarget<S>& target : targets) {
    const Vec3<S> at = kinematics.point(target.link, target.point);
    const Vec3<S> error = target.position - at;
    const Mat3<S>& now = kinematics.link_rotation(target.link);
    const Vec3<S> tilt =
        target.contact ? rotation_vector(target.orientation * transpose(now)) * S(kContactLength)
                       : Vec3<S>{};
    for (int k = 0; k < 3; ++k) {
      workspace.residual[row + k] = error[k];
      if (target.contact) workspace.residual[row + 3 + k] = tilt[k];
    }
    for (int dof = 0; dof < n; ++dof) {
      const bool moves = body.moves(dof, target.link);
      put(row, dof, moves ? position_column(kinematics, dof, at) : Vec3<S>{});
      if (!target.contact) continue;
      const Vec3<S> axis = kinematics.axis[static_cast<std::size_t>(dof)];
      put(row + 3, dof, moves ? axis * S(kContactLength) : Vec3<S>{});
    }
    row += target.contact ? 6 : 3;
  }
}

// fills J A Jᵀ and adds the damping of each target to its rows
template <class S>
void fill_system(int dofs, std::span<const S> inverse_weights, std::span<const IkTarget<S>> targets,
                 const IkSettings& settings, IkWorkspace<S>& workspace) {
  const int rows = row_count(targets);
  for (int i = 0; i < rows; ++i) {
    const S* a = workspace.jacobian.data() + i * dofs;
    for (int j = 0; j <= i; ++j) {
      const S* b = workspace.jacobian.data() + j * dofs;
      S sum(0);
      for (int d = 0; d < dofs; ++d) {
        sum = sum + a[d] * inverse_weights[static_cast<std::size_t>(d)] * b[d];
      }
      workspace.system(i, j) = sum;
    }
  }
  int row = 0;
  for (const IkTarget<S>& target : targets) {
    const int count = target.contact ? 6 : 3;
    S trace(0);
    for (int i = row; i < row + count; ++i) trace = trace + workspace.system(i, i);
    const S ratio = target.lag * S(1.0 / settings.lag_scale);
    const S share = target.contact ? S(settings.contact_damping)
                                   : S(settings.damping) + S(settings.lag_damping) * ratio * ratio;
    for (int i = row; i < row + count; ++i) {
      workspace.system(i, i) = workspace.system(i, i) + share * trace * S(1.0 / count);
    }
    row += count;
  }
}

}  // namespace ik_detail

// One step of weighted inverse kinematics (paper, section 3; rule R6):
//
//   min Σ w_i (Δq_i - Δq_ref,i)²   s.t.   J Δq = e,
//   Δq = Δq_ref + A Jᵀ (J A Jᵀ + D)⁻¹ (e - J Δq_ref),   A = diag(1 / w_i), 0 where locked,
//
// where e is the whole way from where the points are to where they are to be (closed loop with
// gain 1) and D damps the goals, not the contacts. The step is scaled down as a whole where an
// angle would change by more than settings.max_step. Scaling all weights changes nothing.
//
// inverse_weights (dofs): 1 / w_i > 0, or 0 for a locked joint, which then does not move at all.
// reference (dofs, rad) or empty. At most kMaxIkRows rows in all. Result: dq (dofs, rad).
template <class S>
void weighted_ik_step(const BodyModel& body, const Kinematics<S>& kinematics,
                      std::span<const IkTarget<S>> targets, std::span<const S> inverse_weights,
                      std::span<const S> reference, const IkSettings& settings,
                      IkWorkspace<S>& workspace, std::span<S> dq) {
  const int n = body.dof_count();
  const int rows = ik_detail::row_count(targets);
  SHG_CHECK(rows <= kMaxIkRows, "too many goals for one motion");
  ik_detail::fill_rows(body, kinematics, targets, workspace);
  ik_detail::fill_system(n, inverse_weights, targets, settings, workspace);
  const auto reference_of = [&](int d) {
    const auto i = static_cast<std::size_t>(d);
    return reference.empty() ? S(0) : select(inverse_weights[i] > S(0), reference[i], S(0));
  };
  if (!reference.empty()) {
    for (int r = 0; r < rows; ++r) {
      for (int d = 0; d < n; ++d) {
        workspace.residual[r] =
            workspace.residual[r] -
            workspace.jacobian[static_cast<std::size_t>(r * n + d)] * reference_of(d);
      }
    }
  }
  ldlt_solve(workspace.system, workspace.residual, rows, 1e-14);
  S largest(0);
  for (int d = 0; d < n; ++d) {
    S sum(0);
    for (int r = 0; r < rows; ++r) {
      sum = sum + workspace.jacobian[static_cast<std::size_t>(r * n + d)] * workspace.residual[r];
    }
    const S step = reference_of(d) + inverse_weights[static_cast<std::size_t>(d)] * sum;
    dq[static_cast<std::size_t>(d)] = step;
    largest = max(largest, abs(step));
  }
  const S limit(settings.max_step);
  const S scale = select(largest > limit, limit / max(largest, limit), S(1));
  for (S& step : dq) step = step * scale;
}

}  // namespace shigusa
