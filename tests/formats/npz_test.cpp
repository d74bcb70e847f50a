// SPDX-License-Identifier: MIT
#include "formats/npz.hpp"

#include <gmock/gmock.h>

#include "core/bytes.hpp"

namespace shigusa {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<NpzArray> kArrays{{"turn", {2, 2}, std::vector{1.0, 2.0, 3.0, 4.0}},
                                    {"fps", {}, std::vector{50.0}},
                                    {"names", {2}, std::vector<std::string>{"a", "手\xff"}},
                                    {"stands", {1, 2}, std::vector<std::uint8_t>{0, 1}}};

// A directory at the end names all files, each with the offset of its own header.
TEST(Npz, IsAnArchiveOfStoredFiles) {
  const std::string bytes = format_npz(kArrays);
  const std::size_t end = bytes.size() - 22;
  EXPECT_EQ(integer_at<std::uint32_t>(bytes, end), 0x06054B50u);
  EXPECT_EQ(integer_at<std::uint16_t>(bytes, end + 10), kArrays.size());
  std::size_t at = integer_at<std::uint32_t>(bytes, end + 16);
  for (const NpzArray& array : kArrays) {
    EXPECT_EQ(integer_at<std::uint32_t>(bytes, at), 0x02014B50u);
    const std::size_t length = integer_at<std::uint16_t>(bytes, at + 28);
    EXPECT_EQ(bytes.substr(at + 46, length), array.name + ".npy");
    const std::size_t begin = integer_at<std::uint32_t>(bytes, at + 42);
    EXPECT_EQ(integer_at<std::uint32_t>(bytes, begin), 0x04034B50u);
    EXPECT_THAT(bytes.substr(begin + 30 + length), StartsWith("\x93NUMPY"));
    at += 46 + length;
  }
  EXPECT_EQ(at, end);
}

TEST(Npz, HeadersAreAlignedAndSayTheType) {
  const std::string bytes = format_npz(kArrays);
  EXPECT_THAT(bytes, HasSubstr("{'descr': '<f8', 'fortran_order': False, 'shape': (2,2), }"));
  EXPECT_THAT(bytes, HasSubstr("'shape': (), }"));
  EXPECT_THAT(bytes, HasSubstr("{'descr': '<U2', 'fortran_order': False, 'shape': (2,), }"));
  EXPECT_THAT(bytes, HasSubstr("{'descr': '|b1'"));
  const std::size_t begin = bytes.find("\x93NUMPY");
  EXPECT_EQ((10 + integer_at<std::uint16_t>(bytes, begin + 8)) % 64, 0);
}

TEST(Npz, SameArraysSameBytes) { EXPECT_EQ(format_npz(kArrays), format_npz(kArrays)); }

}  // namespace
}  // namespace shigusa
