// SPDX-License-Identifier: MIT
#include "mannequin_unpacker.hpp"

#include <map>
#include <utility>

#include "core/check.hpp"
#include "core/index.hpp"

namespace shigusa {

std::string_view MannequinUnpacker::raw(std::size_t count) {
  SHG_CHECK(count <= bytes_.size(), "the mannequin has all its bytes");
  const std::string_view taken = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return taken;
}

// Signed numbers from two planes of bytes.
std::vector<int> MannequinUnpacker::planes(std::size_t count) {
  const std::string_view low = raw(count);
  const std::string_view high = raw(count);
  std::vector<int> values;
  values.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const int code = static_cast<unsigned char>(low[k]) | static_cast<unsigned char>(high[k]) << 8;
    values.push_back(code % 2 != 0 ? -(code + 1) / 2 : code / 2);
  }
  return values;
}

const std::vector<int>& MannequinUnpacker::triangles(int count) {
  corners_ = planes(3 * index(count));
  int newest = 0;
  for (int& corner : corners_) corner = corner == 0 ? newest++ : newest - corner;
  find_known();
  return corners_;
}

void MannequinUnpacker::find_known() {
  from_.assign(index(vertices_), {});
  std::vector<bool> met(index(vertices_), false);
  std::map<std::pair<int, int>, int> behind;  // vertex opposite an edge
  for (std::size_t t = 0; t < corners_.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = corners_[t + k];
      const int a = corners_[t + (k + 1) % 3];
      const int b = corners_[t + (k + 2) % 3];
      if (met[index(v)]) continue;
      met[index(v)] = true;
      const auto edge = met[index(a)] && met[index(b)] ? behind.find({b, a}) : behind.end();
      from_[index(v)] =
          edge == behind.end() ? std::array{v - 1, v, v} : std::array{a, b, edge->second};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      behind[{corners_[t + k], corners_[t + (k + 1) % 3]}] = corners_[t + (k + 2) % 3];
    }
  }
}

std::vector<int> MannequinUnpacker::numbers(int each) {
  const std::vector<int> left = planes(index(each) * index(vertices_));
  std::vector<int> out(left.size());
  for (int k = 0; k < each; ++k) {
    const auto at = [&](int v) { return v < 0 ? 0 : out[index(each * v + k)]; };
    for (int v = 0; v < vertices_; ++v) {
      const auto [a, b, opposite] = from_[index(v)];
      const int guess = opposite == v ? at(a) : at(a) + at(b) - at(opposite);
      out[index(each * v + k)] = left[index(k * vertices_ + v)] + guess;
    }
  }
  return out;
}

}  // namespace shigusa
