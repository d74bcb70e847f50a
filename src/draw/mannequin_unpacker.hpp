// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace shigusa {

// Unpacks the format of studio/figure/pack.mjs, array after array: triangles in the order of a walk
// over their edges, and numbers as residuals of a prediction from the preceding triangle.
class MannequinUnpacker {
 public:
  MannequinUnpacker(std::string_view bytes, int vertices) : bytes_(bytes), vertices_(vertices) {}

  // Vertices of the triangles; call before numbers(), whose prediction uses them.
  [[nodiscard]] const std::vector<int>& triangles(int count);
  // Reads `each` whole numbers per vertex, one vertex after another.
  [[nodiscard]] std::vector<int> numbers(int each);
  // Reads raw bytes.
  [[nodiscard]] std::string_view raw(std::size_t count);

 private:
  [[nodiscard]] std::vector<int> planes(std::size_t count);
  void find_known();

  std::string_view bytes_;
  int vertices_;
  std::vector<int> corners_;
  // (vertices) vertices that it is predicted from: the two on its edge and the one opposite, or the
  // one before it
  std::vector<std::array<int, 3>> from_;
};

}  // namespace shigusa
