// SPDX-License-Identifier: MIT
#include "gltf_animation_layout.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/check.hpp"
#include "glb.hpp"
#include "json_splice.hpp"

namespace shigusa {
namespace {

constexpr int kFloat = 5126;  // glTF's componentType

void append_float(std::string& bytes, double value) {
  append_word(bytes, __builtin_bit_cast(std::uint32_t, static_cast<float>(value)));
}

void item(std::string& list, const std::string& text) {
  if (!list.empty()) list += ',';
  list += text;
}

bool moves(const GltfAnimation& animation, const GltfKeyed& keyed) {
  for (const GltfTrack& track : animation.tracks) {
    if (track.node != keyed.node) continue;
    if (keyed.path == "rotation") return !track.rotations.empty();
    if (keyed.path == "translation") return !track.translations.empty();
    if (keyed.path == "scale") return !track.scales.empty();
  }
  return false;
}

}  // namespace

void GltfAnimationLayout::add(const GltfAnimation& animation, const std::vector<GltfKeyed>& held) {
  SHG_CHECK(animation.frames >= 1 && !animation.tracks.empty(), "an animation has tracks");
  view_begin_ = data.size();
  channels_.clear();
  samplers_.clear();
  sampler_ = 0;
  times_ = add_times(animation, animation.frames);
  for (const GltfTrack& track : animation.tracks) {
    if (!track.rotations.empty()) add_rotations(track);
    if (!track.translations.empty()) add_vectors(track.node, "translation", track.translations);
    if (!track.scales.empty()) add_vectors(track.node, "scale", track.scales);
  }
  add_held(animation, held);
  item(views, fmt::format(R"({{"buffer":{},"byteOffset":{},"byteLength":{}}})", buffer_,
                          offset_ + view_begin_, data.size() - view_begin_));
  ++view_;
  item(animations, fmt::format(R"({{"name":{},"channels":[{}],"samplers":[{}]}})",
                               json_quoted(animation.name), channels_, samplers_));
}

std::size_t GltfAnimationLayout::add_accessor(std::size_t count, const char* type,
                                              const std::string& more) {
  item(accessors,
       fmt::format(
           R"({{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"{}"{}}})",
           view_, data.size() - view_begin_, kFloat, count, type, more));
  return accessor_++;
}

std::size_t GltfAnimationLayout::add_times(const GltfAnimation& animation, int frames) {
  const double length = (animation.frames - 1) * animation.frame_time;
  const double step = frames == animation.frames ? animation.frame_time : length;
  // the ends are stated exactly as in the data: as floats
  const double last = static_cast<float>(length);
  const std::size_t times = add_accessor(static_cast<std::size_t>(frames), "SCALAR",
                                         fmt::format(R"(,"min":[0],"max":[{}])", last));
  for (int f = 0; f < frames; ++f) append_float(data, f * step);
  return times;
}

void GltfAnimationLayout::add_channel(int node, const char* path, std::size_t times,
                                      std::size_t output) {
  item(channels_, fmt::format(R"({{"sampler":{},"target":{{"node":{},"path":"{}"}}}})", sampler_++,
                              node, path));
  item(samplers_,
       fmt::format(R"({{"input":{},"interpolation":"LINEAR","output":{}}})", times, output));
}

void GltfAnimationLayout::add_rotations(const GltfTrack& track) {
  add_channel(track.node, "rotation", times_, add_accessor(track.rotations.size(), "VEC4"));
  Quatd before = track.rest.rotation;
  for (const Quatd& rotation : track.rotations) {
    const Quatd q = before = nearer(rotation, before);
    for (const double value : {q.x, q.y, q.z, q.w}) append_float(data, value);
  }
}

void GltfAnimationLayout::add_vectors(int node, const char* path,
                                      const std::vector<Vec3d>& vectors) {
  add_channel(node, path, times_, add_accessor(vectors.size(), "VEC3"));
  for (const Vec3d& p : vectors) {
    for (const double value : {p.x, p.y, p.z}) append_float(data, value);
  }
}

void GltfAnimationLayout::add_held(const GltfAnimation& animation,
                                   const std::vector<GltfKeyed>& held) {
  const int frames = animation.frames > 1 ? 2 : 1;
  std::optional<std::size_t> ends;
  for (const GltfKeyed& keyed : held) {
    if (moves(animation, keyed)) continue;
    if (!ends) ends = add_times(animation, frames);
    const bool weights = keyed.path == "weights";
    const std::size_t count =
        static_cast<std::size_t>(frames) * (weights ? keyed.values.size() : 1);
    const char* type = weights ? "SCALAR" : keyed.path == "rotation" ? "VEC4" : "VEC3";
    const std::size_t output = add_accessor(count, type);
    for (int f = 0; f < frames; ++f) {
      for (const double value : keyed.values) append_float(data, value);
    }
    add_channel(keyed.node, keyed.path.c_str(), *ends, output);
  }
}

}  // namespace shigusa
