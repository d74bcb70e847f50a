// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <span>
#include <vector>

namespace shigusa {

// Angles added to upper joint limits by the body's couplings (LimitCoupling).
template <class S>
class CoupledLimits {
 public:
  explicit CoupledLimits(const BodyModel& body) : added_(body.dofs().size(), S(0)) {
    for (const LimitCoupling& c : body.couplings()) {
      couplings_.push_back({static_cast<std::size_t>(c.dof), static_cast<std::size_t>(c.driver),
                            static_cast<T>(c.gain), static_cast<T>(1.0 / c.driver_full)});
      coupled_.push_back(couplings_.back().dof);
    }
  }

  // Updates them at these angles (dofs, rad).
  void update(std::span<const S> angles) {
    for (const Coupling& c : couplings_) added_[c.dof] = S(0);
    for (const Coupling& c : couplings_) {
      const S share = clamp(angles[c.driver] * S(c.per_driver), S(0), S(1));
      added_[c.dof] = added_[c.dof] + share * S(c.gain);
    }
  }

  // (dofs) rad, at the angles of the last update.
  [[nodiscard]] std::span<const S> added() const { return added_; }
  // Dofs with coupled limits.
  [[nodiscard]] std::span<const std::size_t> coupled() const { return coupled_; }

 private:
  using T = Element<S>;
  struct Coupling {
    std::size_t dof;
    std::size_t driver;
    T gain;        // rad
    T per_driver;  // 1/rad
  };

  std::vector<Coupling> couplings_;
  std::vector<std::size_t> coupled_;
  std::vector<S> added_;
};

}  // namespace shigusa
