// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cstring>
#include <map>
#include <shigusa/files.hpp>
#include <shigusa/human.hpp>

namespace shigusa {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::size_t number_at(const std::string& bytes, std::size_t at, int size) {
  std::size_t value = 0;
  for (int k = size; k-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
  }
  return value;
}

// The files of a .zip without compression, by the headers before each.
std::map<std::string, std::string> unzipped(const std::string& zip) {
  std::map<std::string, std::string> files;
  for (std::size_t at = 0; zip.compare(at, 4, "PK\x03\x04") == 0;) {
    EXPECT_EQ(number_at(zip, at + 8, 2), 0u) << "packed";
    const std::size_t name = number_at(zip, at + 26, 2);
    const std::size_t begin = at + 30 + name + number_at(zip, at + 28, 2);
    files[zip.substr(at + 30, name)] = zip.substr(begin, number_at(zip, at + 18, 4));
    at = begin + number_at(zip, at + 18, 4);
  }
  return files;
}

// The numbers of a .npy file, whose header must have these words.
template <class T>
std::vector<T> numbers_of(const std::string& file, const std::string& words) {
  EXPECT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t size = number_at(file, 8, 2);
  EXPECT_EQ((10 + size) % 64, 0u);
  EXPECT_EQ(file[9 + size], '\n');
  EXPECT_THAT(file.substr(10, size), HasSubstr(words));
  std::vector<T> values((file.size() - 10 - size) / sizeof(T));
  std::memcpy(values.data(), file.data() + 10 + size, sizeof(T) * values.size());
  return values;
}

TEST(MapNpz, HoldsEachPlace) {
  ReachMap map{
      .effector = "right_hand", .low = {-0.5, 1.0, 0.25}, .spacing = 0.25, .count = {2, 1, 1}};
  map.places = {{.verdict = Verdict::strains, .score = 0.5, .strength = 0.75, .dof = 3, .reba = 4},
                {}};
  const auto npz = map_npz(human_body().body, map);
  ASSERT_TRUE(npz) << npz.error().to_string();
  EXPECT_TRUE(*npz == *map_npz(human_body().body, map));
  const auto files = unzipped(*npz);
  EXPECT_THAT(numbers_of<double>(files.at("x.npy"), "'<f8', 'fortran_order': False, 'shape': (2,)"),
              ElementsAre(-0.5, -0.25));
  const std::string places = "'shape': (2,1,1)";
  EXPECT_THAT(numbers_of<std::int32_t>(files.at("verdict.npy"), places), ElementsAre(1, -1));
  EXPECT_THAT(numbers_of<float>(files.at("score.npy"), places), ElementsAre(0.5F, 0.0F));
  EXPECT_THAT(numbers_of<std::int32_t>(files.at("joint.npy"), places), ElementsAre(3, -1));
  EXPECT_THAT(numbers_of<std::int32_t>(files.at("reba.npy"), places), ElementsAre(4, -1));
  const auto effector = numbers_of<char32_t>(files.at("effector.npy"), "'<U10'");
  EXPECT_TRUE(std::u32string(effector.begin(), effector.end()) == U"right_hand");
}

}  // namespace
}  // namespace shigusa
