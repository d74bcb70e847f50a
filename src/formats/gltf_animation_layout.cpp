// SPDX-License-Identifier: MIT
#include "gltf_animation_layout.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/bytes.hpp"
#include "core/check.hpp"
#include "glb.hpp"
#include "json_splice.hpp"

namespace shigusa {
namespace {

// Constants of glTF.
constexpr int kUnsignedShort = 5123;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

void append_float(std::string& bytes, double value) {
  append_word(bytes, __builtin_bit_cast(std::uint32_t, static_cast<float>(value)));
}

void item(std::string& list, const std::string& text) {
  if (!list.empty()) list += ',';
  list += text;
}

void append_vectors(std::string& bytes, const std::vector<Vec3d>& vectors) {
  for (const Vec3d& v : vectors) {
    for (const double value : {v.x, v.y, v.z}) append_float(bytes, value);
  }
}

// Members of an accessor that state the bounds of positions, as in the data: as floats.
std::string bounds_of(const std::vector<Vec3d>& positions) {
  Vec3d low = positions.front();
  Vec3d high = low;
  for (const Vec3d& at : positions) {
    for (int i = 0; i < 3; ++i) {
      low[i] = min(low[i], at[i]);
      high[i] = max(high[i], at[i]);
    }
  }
  const auto list = [](const Vec3d& v) {
    const auto single = [](double value) -> double { return static_cast<float>(value); };
    return json_numbers({single(v.x), single(v.y), single(v.z)});
  };
  return fmt::format(R"(,"min":{},"max":{})", list(low), list(high));
}

// Member of an animation with its markers; empty without any.
std::string extras_of(const std::vector<GltfMarker>& markers) {
  std::string list;
  for (const GltfMarker& marker : markers) {
    item(list, fmt::format(R"({{"name":{},"start_s":{},"end_s":{}}})",
                           json_quoted(std::string(marker.name)), marker.start, marker.end));
  }
  if (!list.empty()) list = fmt::format(R"(,"extras":{{"shigusa_actions":[{}]}})", list);
  return list;
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

void GltfAnimationLayout::add(const GltfAnimation& animation, const std::vector<GltfKeyed>& held,
                              int things) {
  SHG_CHECK(animation.frames >= 1 && !animation.tracks.empty(), "an animation has tracks");
  view_begin_ = data.size();
  channels_.clear();
  samplers_.clear();
  sampler_ = 0;
  times_ = add_times(animation, animation.frames);
  for (const GltfTrack& track : animation.tracks) {
    if (!track.rotations.empty()) add_rotations(track.node, track.rest.rotation, track.rotations);
    if (!track.translations.empty()) add_vectors(track.node, "translation", track.translations);
    if (!track.scales.empty()) add_vectors(track.node, "scale", track.scales);
  }
  for (const GltfThing& thing : animation.things) {
    add_rotations(things, thing.rotations.front(), thing.rotations);
    add_vectors(things++, "translation", thing.translations);
  }
  add_held(animation, held);
  add_view();
  item(animations, fmt::format(R"({{"name":{},"channels":[{}],"samplers":[{}]{}}})",
                               json_quoted(animation.name), channels_, samplers_,
                               extras_of(animation.markers)));
}

std::string GltfAnimationLayout::add_mesh(const GltfMesh& mesh, std::size_t material) {
  const std::size_t positions = add_vertices(mesh.positions, bounds_of(mesh.positions));
  const std::size_t normals = add_vertices(mesh.normals);
  view_begin_ = data.size();
  const std::size_t corners = add_accessor(mesh.corners.size(), "SCALAR", {}, kUnsignedShort);
  for (const std::uint16_t corner : mesh.corners) append_bytes(data, corner);
  add_view(fmt::format(R"(,"target":{})", kIndices));
  data.resize((data.size() + 3) / 4 * 4);
  return fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{}}},"indices":{},"material":{}}})",
                     positions, normals, corners, material);
}

std::size_t GltfAnimationLayout::add_vertices(const std::vector<Vec3d>& vectors,
                                              const std::string& more) {
  view_begin_ = data.size();
  const std::size_t accessor = add_accessor(vectors.size(), "VEC3", more);
  append_vectors(data, vectors);
  add_view(fmt::format(R"(,"target":{})", kVertices));
  return accessor;
}

void GltfAnimationLayout::add_view(const std::string& more) {
  item(views, fmt::format(R"({{"buffer":{},"byteOffset":{},"byteLength":{}{}}})", buffer_,
                          offset_ + view_begin_, data.size() - view_begin_, more));
  ++view_;
}

std::size_t GltfAnimationLayout::add_accessor(std::size_t count, const char* type,
                                              const std::string& more, int component) {
  item(accessors,
       fmt::format(
           R"({{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"{}"{}}})",
           view_, data.size() - view_begin_, component, count, type, more));
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

void GltfAnimationLayout::add_rotations(int node, Quatd before,
                                        const std::vector<Quatd>& rotations) {
  add_channel(node, "rotation", times_, add_accessor(rotations.size(), "VEC4"));
  for (const Quatd& rotation : rotations) {
    const Quatd q = before = nearer(rotation, before);
    for (const double value : {q.x, q.y, q.z, q.w}) append_float(data, value);
  }
}

void GltfAnimationLayout::add_vectors(int node, const char* path,
                                      const std::vector<Vec3d>& vectors) {
  add_channel(node, path, times_, add_accessor(vectors.size(), "VEC3"));
  append_vectors(data, vectors);
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
