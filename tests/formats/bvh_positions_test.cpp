// SPDX-License-Identifier: MIT
// Position channels relative to the OFFSET, and those that are whole positions.
#include "formats/bvh_positions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace shigusa {
namespace {

// A root with a row of joints below it, each 1 up and with six channels, and two frames of values
// for all of them.
std::string row_of(int joints, const std::string& first, const std::string& second) {
  const std::string channels =
      "OFFSET 0 1 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
  std::string text = "HIERARCHY\nROOT root\n{\n" + channels;
  std::string frames[2] = {"5 5 5 0 0 0 ", "6 6 6 0 0 0 "};
  for (int i = 0; i < joints; ++i) {
    text += fmt::format("JOINT j{}\n{{\n{}", i, channels);
    frames[0] += first + " 0 0 0 ";
    frames[1] += second + " 0 0 0 ";
  }
  text += "End Site\n{\nOFFSET 0 1 0\n}\n";
  for (int i = 0; i <= joints; ++i) text += "}\n";
  return text + "MOTION\nFrames: 2\nFrame Time: 0.1\n" + frames[0] + "\n" + frames[1] + "\n";
}

Vec3d place(const BvhFile& file, int frame, std::size_t node) {
  return file.motion.clip.frame(file.motion.skeleton, frame)[node].translation;
}

TEST(BvhPositions, OfZeroWhereOffsetsAreNotAreAdded) {
  const BvhFile file = parse_bvh_file(row_of(5, "0 1e-6 0", "0 0.5 0"), "test.bvh").value();
  EXPECT_EQ(place(file, 0, 0), (Vec3d{5, 5, 5}));
  EXPECT_EQ(place(file, 0, 2), (Vec3d{0, 1 + 1e-6, 0}));
  EXPECT_EQ(place(file, 1, 2), (Vec3d{0, 1.5, 0}));
  // so that the written values are relative to it for any reader
  EXPECT_EQ(file.channels[0].size(), 6u);
  EXPECT_EQ(file.channels[2].size(), 3u);
}

TEST(BvhPositions, AsLargeAsTheOffsetsAreWholePlaces) {
  const BvhFile file = parse_bvh_file(row_of(5, "0 1 0", "0 1.5 0"), "test.bvh").value();
  EXPECT_EQ(place(file, 0, 2), (Vec3d{0, 1, 0}));
  EXPECT_EQ(place(file, 1, 2), (Vec3d{0, 1.5, 0}));
  EXPECT_EQ(file.channels[2].size(), 6u);
}

TEST(BvhPositions, OfFewJointsAreWholePlaces) {
  const BvhFile file = parse_bvh_file(row_of(1, "0 0 0", "0 0 0"), "test.bvh").value();
  EXPECT_EQ(place(file, 0, 1), (Vec3d{0, 0, 0}));
}

}  // namespace
}  // namespace shigusa
