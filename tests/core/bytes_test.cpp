// SPDX-License-Identifier: MIT
#include "core/bytes.hpp"

#include <gtest/gtest.h>

namespace shigusa {
namespace {

TEST(Bytes, OfAnIntegerComeTheLowestFirst) {
  std::string bytes = "#";
  append_bytes(bytes, std::uint16_t{0xA1B2});
  append_bytes(bytes, std::uint32_t{0x01020304});
  append_bytes(bytes, std::uint64_t{0xF102030405060708});
  EXPECT_EQ(bytes, "#\xB2\xA1\x04\x03\x02\x01\x08\x07\x06\x05\x04\x03\x02\xF1");
  EXPECT_EQ(integer_at<std::uint16_t>(bytes, 1), 0xA1B2);
  EXPECT_EQ(integer_at<std::uint32_t>(bytes, 3), 0x01020304u);
  EXPECT_EQ(integer_at<std::uint64_t>(bytes, 7), 0xF102030405060708u);
}

}  // namespace
}  // namespace shigusa
