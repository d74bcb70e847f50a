// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/math.hpp>
#include <vector>

#include "gltf_accessor.hpp"

namespace shigusa {

enum class Interpolation { linear, step, cubic };

// Keys of one channel of an animation (glTF 2.0, 3.11 and appendix C).
struct GltfTrackKeys {
  std::vector<double> times;  // s, from 0 on, each later than the one before; at least one
  // (keys × components), for a cubic spline (keys × 3 × components): in-tangent, value, out-tangent
  std::vector<double> values;
  Interpolation interpolation = Interpolation::linear;
  double end = 0.0;  // s, of the last key, read or not

  [[nodiscard]] Vec3d vector_at(double time) const;
  [[nodiscard]] Quatd rotation_at(double time) const;

 private:
  // Time between the keys `from` and `from` + 1: `share` of the interval `step` (s); share is 0
  // before the first key and after the last.
  struct Between {
    std::size_t from = 0;
    double share = 0.0;
    double step = 0.0;
  };
  [[nodiscard]] Between between(double time) const;
  // `part`: 0 value, -1 in-tangent, 1 out-tangent
  [[nodiscard]] const double* key(std::size_t index, std::size_t components, int part) const;
  // component c of the spline
  [[nodiscard]] double spline(const Between& at, std::size_t components, std::size_t c) const;
};

// Intervals (s) in which a track is unknown because of keys with invalid values; they may be
// infinite.
struct KeyGap {
  double after = 0.0;
  double before = 0.0;
};

// Reads a sampler whose values have 3 or 4 components, the latter rotations. Invalid keys are
// dropped if `gaps` is given, which may leave no key; otherwise they are errors.
[[nodiscard]] Result<GltfTrackKeys> read_track_keys(const nlohmann::json& sampler, int components,
                                                    GltfAccessors& accessors,
                                                    std::vector<KeyGap>* gaps = nullptr);

}  // namespace shigusa
