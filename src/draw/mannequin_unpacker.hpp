// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace shigusa {

// Unpacks what studio/figure/pack.mjs packed, array after array: triangles in the order of a walk
// over their edges, and numbers as what is left of them after a guess by the triangle that was
// there before.
class MannequinUnpacker {
 public:
  MannequinUnpacker(std::string_view bytes, int vertices) : bytes_(bytes), vertices_(vertices) {}

  // The triangles' vertices; before the numbers, which are guessed by them.
  [[nodiscard]] const std::vector<int>& triangles(int count);
  // So many whole numbers of each vertex, one vertex after another.
  [[nodiscard]] std::vector<int> numbers(int each);
  // The bytes themselves.
  [[nodiscard]] std::string_view raw(std::size_t count);

 private:
  [[nodiscard]] std::vector<int> planes(std::size_t count);
  void find_known();

  std::string_view bytes_;
  int vertices_;
  std::vector<int> corners_;
  // (vertices) those that it is guessed from: the two on its edge and the one behind that, or the
  // one before it
  std::vector<std::array<int, 3>> from_;
};

}  // namespace shigusa
