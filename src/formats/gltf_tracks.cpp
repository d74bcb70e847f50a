// SPDX-License-Identifier: MIT
#include "gltf_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/say.hpp"
#include "formats/gltf.hpp"
#include "formats/gltf_json.hpp"

namespace shigusa {
namespace {

constexpr double kShortestQuat = 1e-6;  // of a quaternion

double length_of(const Quatd& q) { return sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w); }

Quatd scaled(const Quatd& q, double by) { return {q.x * by, q.y * by, q.z * by, q.w * by}; }

// Interpolation along the shorter arc, at a constant speed.
Quatd slerp(const Quatd& a, Quatd b, double share) {
  double cosine = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
  if (cosine < 0.0) {
    b = scaled(b, -1.0);
    cosine = -cosine;
  }
  constexpr double kNear = 0.9999;  // below it the arc is as good as its chord
  double to_a = 1.0 - share;
  double to_b = share;
  if (cosine < kNear) {
    const double angle = acos(cosine);
    const double over = 1.0 / sin_cos(angle).sin;
    to_a = sin_cos((1.0 - share) * angle).sin * over;
    to_b = sin_cos(share * angle).sin * over;
  }
  const Quatd q{a.x * to_a + b.x * to_b, a.y * to_a + b.y * to_b, a.z * to_a + b.z * to_b,
                a.w * to_a + b.w * to_b};
  return scaled(q, 1.0 / length_of(q));
}

Result<void> check_times(const std::vector<double>& times) {
  if (times.empty()) return fail(ErrorCode::parse, say("sampler_no_keys"));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] >= 0.0 && (i == 0 || times[i] > times[i - 1])) continue;
    return fail(ErrorCode::parse, say("sampler_times", i, times[i]));
  }
  return {};
}

// Whether a key is finite, and a rotation not zero.
bool is_good(const double* values, std::size_t per, bool rotation) {
  for (std::size_t k = 0; k < per; ++k) {
    if (!(abs(values[k]) <= kGltfMaxValue)) return false;
  }
  const double* v = per > 4 ? values + 4 : values;  // of a spline's three the middle one
  return !rotation || length_of({v[0], v[1], v[2], v[3]}) >= kShortestQuat;
}

// Takes the valid keys, `per` numbers each, in the order of their times.
void take_good_keys(const std::vector<double>& times, const std::vector<double>& values,
                    std::size_t per, bool rotation, GltfTrackKeys& keys,
                    std::vector<KeyGap>& gaps) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  double last = -1.0;
  bool open = times.empty();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool timed = times[i] >= 0.0 && times[i] <= kGltfMaxValue && times[i] > last;
    if (timed) keys.end = max(keys.end, times[i]);
    if (!timed || !is_good(values.data() + i * per, per, rotation)) {
      open = true;
      continue;
    }
    if (open) gaps.push_back({last, times[i]});
    open = false;
    last = times[i];
    keys.times.push_back(last);
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(i * per);
    keys.values.insert(keys.values.end(), from, from + static_cast<std::ptrdiff_t>(per));
  }
  if (open) gaps.push_back({last, kNever});
}

}  // namespace

GltfTrackKeys::Between GltfTrackKeys::between(double time) const {
  if (time <= times.front()) return {};
  if (time >= times.back()) return {times.size() - 1, 0.0, 0.0};
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  const auto from = static_cast<std::size_t>(next - times.begin()) - 1;
  const double step = times[from + 1] - times[from];
  return {from, (time - times[from]) / step, step};
}

const double* GltfTrackKeys::key(std::size_t index, std::size_t components, int part) const {
  if (interpolation != Interpolation::cubic) return values.data() + index * components;
  return values.data() + (index * 3 + static_cast<std::size_t>(part + 1)) * components;
}

double GltfTrackKeys::spline(const Between& at, std::size_t components, std::size_t c) const {
  const double from = key(at.from, components, 0)[c];
  if (at.share == 0.0) return from;
  const double to = key(at.from + 1, components, 0)[c];
  const double out = key(at.from, components, 1)[c] * at.step;
  const double in = key(at.from + 1, components, -1)[c] * at.step;
  const double t = at.share;
  const double square = t * t;
  const double cube = square * t;
  return (2.0 * cube - 3.0 * square + 1.0) * from + (cube - 2.0 * square + t) * out +
         (-2.0 * cube + 3.0 * square) * to + (cube - square) * in;
}

Vec3d GltfTrackKeys::vector_at(double time) const {
  const Between at = between(time);
  if (interpolation == Interpolation::cubic) {
    return {spline(at, 3, 0), spline(at, 3, 1), spline(at, 3, 2)};
  }
  const double* a = key(at.from, 3, 0);
  const Vec3d from{a[0], a[1], a[2]};
  if (interpolation == Interpolation::step || at.share == 0.0) return from;
  const double* b = key(at.from + 1, 3, 0);
  return from + (Vec3d{b[0], b[1], b[2]} - from) * at.share;
}

Quatd GltfTrackKeys::rotation_at(double time) const {
  const Between at = between(time);
  const auto unit = [](const Quatd& q) {
    const double length = length_of(q);
    // a spline may pass through 0
    return length < kShortestQuat ? Quatd{} : scaled(q, 1.0 / length);
  };
  if (interpolation == Interpolation::cubic) {
    return unit({spline(at, 4, 0), spline(at, 4, 1), spline(at, 4, 2), spline(at, 4, 3)});
  }
  const double* a = key(at.from, 4, 0);
  const Quatd from = unit({a[0], a[1], a[2], a[3]});
  if (interpolation == Interpolation::step || at.share == 0.0) return from;
  const double* b = key(at.from + 1, 4, 0);
  return slerp(from, unit({b[0], b[1], b[2], b[3]}), at.share);
}

Result<GltfTrackKeys> read_track_keys(const GltfJson& sampler, int components,
                                      GltfAccessors& accessors, std::vector<KeyGap>* gaps) {
  GltfTrackKeys keys;
  if (!sampler.contains("input") || !sampler.contains("output")) {
    return fail(ErrorCode::parse, say("sampler_lacks"));
  }
  const auto kind = sampler.find("interpolation");
  if (kind != sampler.end()) {
    if (is_text(*kind, "STEP")) {
      keys.interpolation = Interpolation::step;
    } else if (is_text(*kind, "CUBICSPLINE")) {
      keys.interpolation = Interpolation::cubic;
    } else if (!is_text(*kind, "LINEAR")) {
      return fail(ErrorCode::parse,
                  say("interpolation",
                      kind->dump(-1, ' ', true, GltfJson::error_handler_t::replace).substr(0, 40)));
    }
  }
  SHG_TRY_ASSIGN(std::vector<double> times,
                 accessors.numbers(sampler["input"], 1, gaps != nullptr));
  if (gaps == nullptr) SHG_TRY(check_times(times));
  SHG_TRY_ASSIGN(std::vector<double> values,
                 accessors.numbers(sampler["output"], components, gaps != nullptr));
  const std::size_t per = keys.interpolation == Interpolation::cubic ? 3 : 1;
  const std::size_t needed = times.size() * per * static_cast<std::size_t>(components);
  if (values.size() != needed) {
    return fail(ErrorCode::parse, say("sampler_values", times.size(), values.size(), needed));
  }
  if (gaps != nullptr) {
    take_good_keys(times, values, per * static_cast<std::size_t>(components), components == 4, keys,
                   *gaps);
    return keys;
  }
  keys.end = times.back();
  keys.times = std::move(times);
  keys.values = std::move(values);
  if (components == 4) {
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
      const std::size_t at = (per == 3 ? i * 3 + 1 : i) * 4;
      const double* v = keys.values.data() + at;
      if (length_of({v[0], v[1], v[2], v[3]}) >= kShortestQuat) continue;
      return fail(ErrorCode::parse, say("sampler_quaternion", i));
    }
  }
  return keys;
}

}  // namespace shigusa
