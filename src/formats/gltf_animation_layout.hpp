// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gltf_keyed.hpp"
#include "gltf_write.hpp"

namespace shigusa {

inline constexpr int kGltfFloat = 5126;  // componentType

// Lays out the data of animations and meshes, and their JSON entries.
class GltfAnimationLayout {
 public:
  // Numbers of existing accessors and buffer views, and the data to which it appends.
  GltfAnimationLayout(std::size_t accessor, std::size_t view, std::size_t buffer,
                      std::size_t offset)
      : accessor_(accessor), view_(view), buffer_(buffer), offset_(offset) {}

  // `held`: properties that keep their values unless the animation has a track for them; `things`:
  // node of the first thing.
  void add(const GltfAnimation& animation, const std::vector<GltfKeyed>& held, int things);
  // Adds the data of a mesh; returns the JSON of its primitive.
  [[nodiscard]] std::string add_mesh(const GltfMesh& mesh, std::size_t material);

  std::string accessors;
  std::string views;
  std::string animations;
  std::string data;

 private:
  // Ends the buffer view that began at view_begin_; `more`: further members.
  void add_view(const std::string& more = {});
  // Adds an accessor that begins at the present end of the data; `more`: further members.
  std::size_t add_accessor(std::size_t count, const char* type, const std::string& more = {},
                           int component = kGltfFloat);
  // Adds vectors of vertices with a view of their own; returns the accessor.
  std::size_t add_vertices(const std::vector<Vec3d>& vectors, const std::string& more = {});
  // Times of that many frames, evenly spaced from first to last.
  std::size_t add_times(const GltfAnimation& animation, int frames);
  void add_channel(int node, const char* path, std::size_t times, std::size_t output);
  void add_rotations(int node, Quatd before, const std::vector<Quatd>& rotations);
  void add_vectors(int node, const char* path, const std::vector<Vec3d>& vectors);
  void add_held(const GltfAnimation& animation, const std::vector<GltfKeyed>& held);

  std::size_t accessor_;
  std::size_t view_;
  std::size_t buffer_;
  std::size_t offset_;  // of the data in its buffer
  std::size_t view_begin_ = 0;
  std::size_t times_ = 0;  // accessor
  std::size_t sampler_ = 0;
  std::string channels_;
  std::string samplers_;
};

}  // namespace shigusa
