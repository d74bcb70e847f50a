// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <locale>
#include <shigusa/formats.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/check.hpp"

namespace shigusa {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Two joints and a tip; the motion follows.
const std::string kArm =
    "HIERARCHY\n"                                                                 // 1
    "ROOT Shoulder\n"                                                             // 2
    "{\n"                                                                         // 3
    "  OFFSET 0 0 0\n"                                                            // 4
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"  // 5
    "  JOINT Elbow\n"                                                             // 6
    "  {\n"                                                                       // 7
    "    OFFSET 0 1 0\n"                                                          // 8
    "    CHANNELS 3 Zrotation Xrotation Yrotation\n"                              // 9
    "    End Site\n"                                                              // 10
    "    {\n"                                                                     // 11
    "      OFFSET 0 0.5 0\n"                                                      // 12
    "    }\n"                                                                     // 13
    "  }\n"                                                                       // 14
    "}\n";                                                                        // 15
const std::string kMotion =
    "MOTION\n"                // 16
    "Frames: 2\n"             // 17
    "Frame Time: .0083333\n"  // 18
    "1 2 3 0 0 0 0 0 0\n"     // 19
    "1 2 3 90 0 0 0 90 0\n";  // 20

// A one-joint file with these channels and one frame of these values; its tip is at (0, 1, 0).
std::string one_joint(const std::string& channels, const std::string& values) {
  return "HIERARCHY\nROOT a\n{\nOFFSET 1 2 3\nCHANNELS " + channels +
         "\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n" + values + "\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

Vec3d tip_of(const std::string& text) {
  const auto motion = parse_bvh(text, "test.bvh");
  EXPECT_TRUE(motion) << motion.error().to_string();
  if (!motion) return {};
  return world_transforms(motion->skeleton, motion->clip, motion->clip.frames - 1)
      .back()
      .translation;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(BvhReader, NodesHaveTheFilesNamesParentsAndOffsets) {
  const auto motion = parse_bvh(kArm + kMotion, "arm.bvh");
  ASSERT_TRUE(motion) << motion.error().to_string();
  const auto& nodes = motion->skeleton.nodes;
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_EQ(nodes[0].name, "Shoulder");
  EXPECT_EQ(nodes[1].name, "Elbow");
  EXPECT_EQ(nodes[1].parent, 0);
  EXPECT_EQ(nodes[1].offset, (Vec3d{0, 1, 0}));
  EXPECT_EQ(nodes[2].name, "");
  EXPECT_TRUE(nodes[2].end_site);
  EXPECT_EQ(nodes[2].parent, 1);
}

TEST(BvhReader, FramesAndFrameTimeAreTheFiles) {
  const auto motion = parse_bvh(kArm + kMotion, "arm.bvh");
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->clip.frames, 2);
  EXPECT_EQ(motion->clip.frame_time, 0.0083333);
  EXPECT_EQ(motion->clip.local.size(), 6u);
}

TEST(BvhReader, RotationIsTheProductInChannelOrder) {
  // Rot(z, 90°) Rot(x, 90°) takes y to z; the other order would take y to -x
  expect_near(tip_of(one_joint("3 Zrotation Xrotation Yrotation", "90 90 0")), {1, 2, 4}, 1e-15);
  expect_near(tip_of(one_joint("3 Xrotation Zrotation Yrotation", "90 90 0")), {0, 2, 3}, 1e-15);
}

TEST(BvhReader, RotationsAddUpDownTheChain) {
  // the upper arm turns y to -x, then the forearm turns about its own x: its y becomes z
  expect_near(tip_of(kArm + kMotion), {1 - 1, 2, 3 + 0.5}, 1e-15);
}

TEST(BvhReader, OneAxisMayTurnTwice) {
  expect_near(tip_of(one_joint("3 Zrotation Xrotation Zrotation", "90 90 90")), {1, 1, 3}, 1e-15);
}

TEST(BvhReader, PositionChannelsReplaceTheOffsetOfTheRoot) {
  expect_near(tip_of(one_joint("3 Xposition Yposition Zposition", "7 8 9")), {7, 9, 9}, 0);
}

TEST(BvhReader, PositionChannelsReplaceTheOffsetOfAJoint) {
  const std::string text =
      replaced(replaced(kArm, "CHANNELS 3 Zr", "CHANNELS 5 Yposition Xposition Zr"), "0 1 0",
               "0 1 4") +
      "MOTION\nFrames: 1\nFrame Time: 1\n0 0 0 0 0 0 3 2 0 0 0\n";
  expect_near(tip_of(text), {2, 3.5, 4}, 0);
}

TEST(BvhReader, JointsMayHaveNoChannels) {
  EXPECT_EQ(tip_of(one_joint("0", "")), (Vec3d{1, 3, 3}));
  EXPECT_EQ(tip_of(replaced(one_joint("0", ""), "CHANNELS 0", "")), (Vec3d{1, 3, 3}));
}

TEST(BvhReader, ManyTurnsAreTheSameAsNone) {
  expect_near(tip_of(one_joint("1 Zrotation", "360000090")), {0, 2, 3}, 1e-15);
}

TEST(BvhReader, AnglesAsLargeAsTheBoundStayExact) {
  // 1e9 = 2777777 · 360 + 280
  const auto a = tip_of(one_joint("1 Zrotation", "-1e9"));
  expect_near(a, tip_of(one_joint("1 Zrotation", "80")), 1e-14);
}

TEST(BvhReader, NumbersComeInManyForms) {
  expect_near(tip_of(one_joint("3 Xposition Yposition Zposition", ".5 +1e-1 -0")), {0.5, 1.1, 0},
              1e-16);
  expect_near(tip_of(one_joint("3 Xposition Yposition Zposition", "-.5E+1 2. 1e-400")), {-5, 3, 0},
              0);
}

TEST(BvhReader, DecimalPointIsTheSameInEveryLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const auto motion = parse_bvh(kArm + kMotion, "arm.bvh");
  const std::string text = motion ? format_bvh(*motion) : "";
  std::locale::global(old);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->clip.frame_time, 0.0083333);
  EXPECT_EQ(text.find(','), text.npos);
}

TEST(BvhReader, LineEndsMayBeCrLfOrCr) {
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : kArm + kMotion) text += c == '\n' ? end : std::string(1, c);
    const auto motion = parse_bvh(text, "arm.bvh");
    ASSERT_TRUE(motion) << motion.error().to_string();
    EXPECT_EQ(motion->skeleton.nodes[1].name, "Elbow");
  }
}

TEST(BvhReader, ErrorsCountCrLfOnce) {
  std::string text;
  for (const char c : replaced(kArm, "OFFSET 0 1 0", "OFFSET 0 x 0")) {
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  EXPECT_EQ(parse_bvh(text, "a.bvh").error().place, "line 8 of a.bvh");
}

TEST(BvhReader, LayoutIsFree) {
  std::string text = kArm + kMotion;
  std::replace(text.begin(), text.end(), '\n', ' ');
  // a name needs the end of its line, or a brace
  const auto motion = parse_bvh("\n\t" + text + "\n\n", "arm.bvh");
  ASSERT_TRUE(motion) << motion.error().to_string();
  EXPECT_EQ(motion->skeleton.nodes[1].name, "Elbow");
}

TEST(BvhReader, KeywordsMayBeLowerCase) {
  std::string text = kArm + kMotion;
  for (const char* word : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "Zrotation", "JOINT",
                           "End Site", "MOTION", "Frames", "Frame Time"}) {
    std::string lower = word;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return static_cast<char>(std::tolower(c)); });
    text = replaced(text, word, lower);
  }
  EXPECT_TRUE(parse_bvh(text, "arm.bvh"));
}

TEST(BvhReader, ByteOrderMarkIsSkipped) {
  EXPECT_TRUE(parse_bvh("\xEF\xBB\xBF" + kArm + kMotion, "arm.bvh"));
}

TEST(BvhReader, SeveralRootsAreSeveralTrees) {
  const std::string text =
      "HIERARCHY ROOT a { OFFSET 0 0 0 } ROOT b { OFFSET 1 0 0 } MOTION Frames: 1 Frame Time: 1";
  const auto motion = parse_bvh(text, "two.bvh");
  ASSERT_TRUE(motion) << motion.error().to_string();
  EXPECT_EQ(motion->skeleton.nodes[1].parent, -1);
}

TEST(BvhReader, OneFrameMoreThanPromisedIsLeftOut) {
  const auto motion = parse_bvh(kArm + replaced(kMotion, "Frames: 2", "Frames: 1"), "arm.bvh");
  ASSERT_TRUE(motion) << motion.error().to_string();
  EXPECT_EQ(motion->clip.frames, 1);
}

std::string name_after_reading(const std::string& name) {
  const auto motion = parse_bvh(replaced(kArm, "Elbow", name) + kMotion, "arm.bvh");
  EXPECT_TRUE(motion) << motion.error().to_string();
  return motion ? motion->skeleton.nodes[1].name : "";
}

TEST(BvhReader, NamesKeepSpacesColonsAndUnicode) {
  EXPECT_EQ(name_after_reading("  Left Elbow \t"), "Left Elbow");
  EXPECT_EQ(name_after_reading("mixamorig:LeftForeArm"), "mixamorig:LeftForeArm");
  EXPECT_EQ(name_after_reading("左ひじ"), "左ひじ");
}

TEST(BvhReader, NamesBecomeValidUtf8WithoutControlCharacters) {
  // a Shift-JIS name, an overlong slash, a surrogate, a cut character
  EXPECT_EQ(name_after_reading("\x8D\xB6x"), "__x");
  EXPECT_EQ(name_after_reading("a\xC0\xAF"), "a__");
  EXPECT_EQ(name_after_reading("\xED\xA0\x80"), "___");
  EXPECT_EQ(name_after_reading("a\xE5\xB7"), "a__");
  EXPECT_EQ(name_after_reading(std::string("a\x01z")), "a_z");
}

TEST(BvhReader, MissingNamesAreFilledIn) { EXPECT_EQ(name_after_reading(""), "joint"); }

TEST(BvhReader, RepeatedNamesAreNumbered) {
  EXPECT_EQ(name_after_reading("Shoulder"), "Shoulder_2");
}

std::string deep(int count) {
  std::string text = "HIERARCHY\nROOT r {\nOFFSET 0 0 0\n";
  for (int i = 0; i < count; ++i) text += "JOINT j {\nOFFSET 0 0 0\n";
  return text;
}

const std::string kValues = "1 2 3 90 0 0 0 90 0\n";

TEST(BvhReader, MalformedFilesAreRefusedWithTheLineAndTheValue) {
  struct Malformed {
    int line;
    std::string text;
    std::string told;
  };
  const Malformed table[] = {
      {1, "", "the file is empty"},
      {3, " \n\n \t", "the file is empty"},
      {1, "glTF\x02 binary", "'glTF?' where HIERARCHY"},
      {1, std::string(100, '\0'), "where HIERARCHY is expected"},
      {1, std::string(100000, 'a'), "aaa…' where"},
      {2, "HIERARCHY\nMOTION", "'MOTION' where ROOT"},
      {2, "HIERARCHY\n", "ends where ROOT is expected"},
      {3, "HIERARCHY\nROOT a\nOFFSET 0 0 0\n", "'OFFSET' where { is expected"},
      {15, kArm.substr(0, kArm.size() - 2),
       "ends where OFFSET, CHANNELS, JOINT, End Site or } is expected"},
      {16, kArm, "ends where ROOT or MOTION"},
      {16, kArm + "}", "'}' where ROOT or MOTION"},
      {13, replaced(kArm, "    OFFSET 0 1 0\n", "") + kMotion, "joint 'Elbow' has no OFFSET"},
      {12, replaced(kArm, "      OFFSET 0 0.5 0\n", "") + kMotion, "the End Site has no OFFSET"},
      {8, replaced(kArm, "OFFSET 0 1 0", "OFFSET 0 1 0 OFFSET"), "second OFFSET"},
      {9, replaced(kArm, "OFFSET 0 1 0", "OFFSET 0 1"),
       "'CHANNELS' where the third number of an OFFSET is expected"},
      {8, replaced(kArm, "OFFSET 0 1 0", "OFFSET 0 one 0"), "'one' where the second number"},
      {12, replaced(kArm, "0 0.5 0", "0 0,5 0"), "'0,5' where"},
      {12, replaced(kArm, "0 0.5 0", "0 0x5 0"), "'0x5'"},
      {12, replaced(kArm, "0 0.5 0", "0 nan 0"), "'nan' is not between -1e+09 and 1e+09"},
      {12, replaced(kArm, "0 0.5 0", "0 -inf 0"), "'-inf' is not between"},
      {12, replaced(kArm, "0 0.5 0", "0 1.1e9 0"), "'1.1e9' is not between"},
      {12, replaced(kArm, "0 0.5 0", "0 1e999 0"), "'1e999' is not between"},
      {9, replaced(kArm, "CHANNELS 3", "CHANNELS 0 CHANNELS 3"), "second CHANNELS"},
      {9, replaced(kArm, "CHANNELS 3", "CHANNELS 10"), "'10' where a number of channels, 0 to 9,"},
      {9, replaced(kArm, "CHANNELS 3", "CHANNELS -1"), "'-1' where a number of channels"},
      {10, replaced(kArm, "CHANNELS 3", "CHANNELS 4"), "'End' where a channel"},
      {9, replaced(kArm, "CHANNELS 3", "CHANNELS 2"), "'Yrotation' where OFFSET, CHANNELS"},
      {5, replaced(kArm, "Zposition", "Wposition"), "'Wposition' where a channel, Xposition to"},
      {5, replaced(kArm, "Zposition", "Xposition"), "joint 'Shoulder' has a second Xposition"},
      {12, replaced(kArm, "OFFSET 0 0.5 0", "JOINT a"),
       "'JOINT' where the OFFSET or the } of an End Site"},
      {11, replaced(kArm, "End Site", "End"), "'{' where Site is expected"},
      {8194, deep(kBvhMaxNodes), "more than 4096 joints"},
      {6, replaced(kArm, "Elbow", std::string(300, 'n')), "a name of 300 bytes"},
      {17, kArm + "MOTION\n", "ends where Frames"},
      {17, kArm + "MOTION\nFrames 2\n", "'2' where :"},
      {17, kArm + "MOTION\nFrames: 0\n", "'0' where a number of frames, 1 to 200000,"},
      {17, kArm + "MOTION\nFrames: -2\n", "'-2' where"},
      {17, kArm + "MOTION\nFrames: 2.5\n", "'2.5'"},
      {17, kArm + "MOTION\nFrames: 200001\n", "'200001' where"},
      {17, kArm + "MOTION\nFrames: 99999999999999999999\n", "'99999999999999999999' where"},
      {18, kArm + "MOTION\nFrames: 2\n1 2 3\n", "'1' where Frame is expected"},
      {18, kArm + "MOTION\nFrames: 2\nFrame Time: fast\n",
       "'fast' where the frame time in seconds"},
      {18, kArm + replaced(kMotion, ".0083333", "0"),
       "a frame time of 0 s; 1e-06 to 1000 are allowed"},
      {18, kArm + replaced(kMotion, ".0083333", "-1"), "a frame time of -1 s"},
      {21, kArm + replaced(kMotion, "Frames: 2", "Frames: 200000"),
       "ends after 18 of the 1800000 values that 200000 frames of 9 channels need"},
      {20, kArm + kMotion.substr(0, kMotion.size() - 10), "ends after 14 of the 18 values"},
      {20, kArm + replaced(kMotion, "90 0 0 0 90", "90 0 x 0 90"),
       "'x', value 6 of frame 2, is not a number"},
      {20, kArm + replaced(kMotion, "90 0 0 0 90", "90 0 nan 0 90"), "'nan', value 6 of frame 2"},
      {20, kArm + replaced(kMotion, "90 0 0 0 90", "90 0 -2e9 0 90"), "'-2e9', value 6 of frame 2"},
      {21, kArm + kMotion + "7\n", "found '7' after the last of the 18 values of 2 frames"},
      {21, kArm + kMotion + kValues + kValues, "found '1' after the last"},
      {21, kArm + kMotion + "the end", "found 'the' after the last"},
      {21, kArm + kMotion + "1 2 3 a b c 7 8 9", "found '1' after the last"},
  };
  for (const auto& [line, text, told] : table) {
    const auto motion = parse_bvh(text, "x.bvh");
    ASSERT_FALSE(motion) << told;
    EXPECT_EQ(motion.error().code, ErrorCode::parse);
    EXPECT_EQ(motion.error().place, "line " + std::to_string(line) + " of x.bvh") << told;
    EXPECT_THAT(motion.error().message, HasSubstr(told));
  }
}

TEST(BvhReader, EveryCutOfAFileIsRefusedOrRead) {
  const std::string text = kArm + kMotion;
  for (std::size_t length = 0; length < text.size() - 2; ++length) {
    EXPECT_FALSE(parse_bvh(text.substr(0, length), "cut.bvh")) << length;
  }
}

TEST(BvhReader, DamagedFilesGiveWhatTheyStillHaveWhereFaultsAreTold) {
  struct Damaged {
    std::string text;
    int frames;
    std::string doubt;  // none: ""
  };
  const Damaged table[] = {
      {kArm + kMotion, 2, ""},
      {kArm, 0, ""},
      {kArm + "MOTION\n", 0, ""},
      {kArm + "MOTION\nFrames: 0\nFrame Time: 0.1\n", 0, ""},
      {kArm + replaced(kMotion, ".0083333", "0"), 2, "a frame time of 0 s: 0.0333 s is taken"},
      {kArm + replaced(kMotion, "Frames: 2", "Frames: 200000"), 2, "ends after 2 of 200000 frames"},
      {kArm + kMotion.substr(0, kMotion.size() - 10), 1, "ends after 1 of 2 frames"},
      {kArm + kMotion.substr(0, kMotion.size() - 30), 0, "ends after 0 of 2 frames"},
      {kArm + kMotion + kValues, 2, ""},
      {kArm + kMotion + kValues + kValues, 2, "after the 2 frames that the file tells come 2 more"},
  };
  for (const auto& [text, frames, doubt] : table) {
    SCOPED_TRACE(text);
    const auto file = parse_bvh_file(text, "x.bvh", BvhFaults::told);
    ASSERT_TRUE(file) << file.error().to_string();
    EXPECT_EQ(file->motion.skeleton.nodes.size(), 3u);
    EXPECT_EQ(file->motion.clip.frames, frames);
    EXPECT_EQ(file->motion.clip.local.size(), 3u * static_cast<unsigned>(frames));
    EXPECT_EQ(file->doubts.size(), doubt.empty() ? 0u : 1u);
    for (const Message& told : file->doubts) EXPECT_THAT(told, HasSubstr(doubt));
    EXPECT_TRUE(file->unread_frames.empty());
  }
}

TEST(BvhReader, ValuesThatAreNoNumbersCostTheirFrameAlone) {
  for (const char* none : {"nan", "-nan(ind)", "-1.#IND", "inf", "1e999"}) {
    const std::string text =
        replaced(kMotion, "90 0 0 0 90", std::string("90 0 ") + none + " 0 90");
    const auto file = parse_bvh_file(kArm + text, "x.bvh", BvhFaults::told);
    ASSERT_TRUE(file) << none << ": " << file.error().to_string();
    EXPECT_EQ(file->unread_frames, std::vector<int>{1});
    EXPECT_THAT(file->doubts, ::testing::ElementsAre(HasSubstr("1 of them, frame 1 first")));
    expect_near(world_transforms(file->motion.skeleton, file->motion.clip, 0).back().translation,
                {1, 3.5, 3}, 1e-15);
  }
}

TEST(BvhReader, AFrameThatIsCutBehindANumberThatIsNoneIsNoFrame) {
  const std::string text = replaced(kMotion, "90 0 0 0 90", "nan");
  const auto file = parse_bvh_file(kArm + text, "x.bvh", BvhFaults::told);
  ASSERT_TRUE(file) << file.error().to_string();
  EXPECT_EQ(file->motion.clip.frames, 1);
  EXPECT_EQ(file->unread_frames, std::vector<int>());
  EXPECT_THAT(file->doubts, ::testing::ElementsAre(HasSubstr("ends after 1 of 2 frames")));
}

TEST(BvhReader, OtherFaultsAreRefusedWhereFaultsAreTold) {
  for (const std::string& text :
       {kArm + kMotion + "7\n", kArm + kMotion + "the end", kArm.substr(0, kArm.size() - 2),
        kArm + replaced(kMotion, "90 0 0 0 90", "90 0 x 0 90"), std::string()}) {
    EXPECT_FALSE(parse_bvh_file(text, "x.bvh", BvhFaults::told)) << text;
  }
}

TEST(BvhReader, FramesWithoutChannelsAreRefused) {
  const auto motion = parse_bvh(replaced(one_joint("0", ""), "Frames: 1", "Frames: 9"), "x.bvh");
  ASSERT_FALSE(motion);
  EXPECT_THAT(motion.error().message, HasSubstr("9 frames, but no joint has a channel"));
}

TEST(BvhReader, ManyFramesOfManyJointsAreRefusedBeforeMemoryIsTaken) {
  std::string text = replaced(deep(1000), "OFFSET", "CHANNELS 1 Xposition OFFSET");
  text += std::string(1001, '}') + " MOTION Frames: 200000 Frame Time: 1";
  const auto motion = parse_bvh(text, "x.bvh");
  ASSERT_FALSE(motion);
  EXPECT_THAT(motion.error().message, HasSubstr("their product may be 8000000"));
}

TEST(BvhReader, TextLargerThanAFileMayBeIsRefused) {
  const std::string text(kBvhMaxBytes + 1, ' ');
  const auto motion = parse_bvh(text, "x.bvh");
  ASSERT_FALSE(motion);
  EXPECT_THAT(motion.error().message, HasSubstr("67108865 bytes"));
}

TEST(BvhReader, MissingFileIsNotFound) {
  const auto motion = read_bvh("/nowhere/walk.bvh");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().code, ErrorCode::not_found);
  EXPECT_THAT(motion.error().to_string(), HasSubstr("/nowhere/walk.bvh"));
}

TEST(BvhReader, FolderIsNoFile) { EXPECT_FALSE(read_bvh(fs::temp_directory_path())); }

TEST(BvhReader, ErrorsInAFileNameIt) {
  const fs::path path =
      fs::temp_directory_path() / ("shigusa-bvh-test-" + std::to_string(getpid()) + ".bvh");
  std::ofstream(path) << kArm;
  const auto motion = read_bvh(path);
  fs::remove(path);
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().place, "line 16 of " + path.filename().string());
}

// Origins of the joints by name; an end site has its parent's name and a star.
std::vector<std::pair<std::string, Vec3d>> origins(const SkeletonMotion& motion, int frame) {
  const auto world = world_transforms(motion.skeleton, motion.clip, frame);
  std::vector<std::pair<std::string, Vec3d>> result;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const SkeletonNode& node = motion.skeleton.nodes[i];
    const std::string name =
        node.end_site ? motion.skeleton.nodes[static_cast<std::size_t>(node.parent)].name + "*"
                      : node.name;
    result.emplace_back(name, world[i].translation);
  }
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return result;
}

// Largest displacement of any origin when the motion is written and read back (m).
double moved_by_writing(const SkeletonMotion& motion, double unit = 0.01) {
  const auto read = parse_bvh(format_bvh(motion, {.unit = unit}), "written.bvh");
  EXPECT_TRUE(read) << read.error().to_string();
  if (!read || read->skeleton.nodes.size() != motion.skeleton.nodes.size()) return 1e9;
  double worst = 0.0;
  for (int frame = 0; frame < motion.clip.frames; ++frame) {
    const auto before = origins(motion, frame);
    const auto after = origins(*read, frame);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].first != after[i].first) return 1e9;
      worst = std::max(worst, norm(before[i].second - after[i].second * unit));
    }
  }
  return worst;
}

Quatd turned(double z, double x, double y) {
  return axis_rotation(Axis::z, radians(z)) * axis_rotation(Axis::x, radians(x)) *
         axis_rotation(Axis::y, radians(y));
}

// A chain of `rotations.size()` joints of 0.1 m, and its tip; the rotations of one frame, in
// sequence.
SkeletonMotion chain(const std::vector<std::vector<Quatd>>& frames) {
  SkeletonMotion motion;
  auto& nodes = motion.skeleton.nodes;
  const std::size_t joints = frames.front().size();
  for (std::size_t i = 0; i < joints; ++i) {
    nodes.push_back(
        {"j" + std::to_string(i), static_cast<int>(i) - 1, {0, i == 0 ? 0 : 0.1, 0}, false});
  }
  nodes.push_back({"", static_cast<int>(joints) - 1, {0, 0.1, 0}, true});
  motion.clip.frames = static_cast<int>(frames.size());
  for (const auto& rotations : frames) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      motion.clip.local.push_back({nodes[i].offset, i < joints ? rotations[i] : Quatd{}});
    }
  }
  return motion;
}

// A body of bones up to 0.15 m and at most 16 of them: no chain is longer than 2.4 m, as in people.
// Rounding an angle to 1e-6 degrees moves a point r away by 8.7e-9 r; three angles in each of 16
// joints, with levers of 0.15 k m, make 5.4e-7 m at most.
SkeletonMotion random_body() {
  const auto number = [](int size) { return *rc::gen::inRange(-size, size + 1); };
  SkeletonMotion motion;
  auto& nodes = motion.skeleton.nodes;
  const int joints = *rc::gen::inRange(1, 16);
  for (int i = 0; i < joints; ++i) {
    const Vec3d offset{number(80) * 1e-3, number(80) * 1e-3, number(80) * 1e-3};
    const int parent = i == 0 ? -1 : *rc::gen::inRange(-1, i);
    nodes.push_back({"j" + std::to_string(i), parent, offset, false});
  }
  for (int i = 0; i < joints; ++i) {
    if (*rc::gen::inRange(0, 3) == 0) nodes.push_back({"", i, {0, 0.1, 1.0 / 30.0}, true});
  }
  motion.clip.frames = *rc::gen::inRange(1, 5);
  for (int k = 0; k < motion.clip.frames; ++k) {
    for (const SkeletonNode& node : nodes) {
      LocalTransform local{node.offset, {}};
      if (!node.end_site) {
        // steps of 45° bring gimbal lock, the small parts come near to it
        const auto angle = [&] {
          return 45.0 * number(8) + number(9) * std::pow(10.0, *rc::gen::inRange(-12, 1));
        };
        local.rotation = turned(angle(), angle(), angle());
        const bool moves = node.parent < 0 || *rc::gen::inRange(0, 8) == 0;
        if (moves) local.translation += Vec3d{number(9) / 7.0, number(9) / 7.0, number(9) / 7.0};
      }
      motion.clip.local.push_back(local);
    }
  }
  return motion;
}

RC_GTEST_PROP(BvhWriter, ReadingBackMovesNoOriginByAMicrometre, ()) {
  const SkeletonMotion motion = random_body();
  const double unit = *rc::gen::element(0.01, 1.0, 0.001, 0.0254);
  RC_ASSERT(moved_by_writing(motion, unit) < 1e-6);
}

// Channels of three rotations in that order, and of the position if `moves`.
std::vector<BvhChannel> channels_of(const std::vector<Axis>& order, bool moves) {
  std::vector<BvhChannel> channels;
  for (const Axis axis : order) channels.push_back({true, axis});
  if (moves) {
    for (const Axis axis : {Axis::y, Axis::z, Axis::x}) channels.push_back({false, axis});
  }
  return channels;
}

RC_GTEST_PROP(BvhWriter, AnyOrderOfChannelsTellsTheSameMotion, ()) {
  const SkeletonMotion motion = random_body();
  std::vector<Axis> order{Axis::x, Axis::y, Axis::z};
  for (int k = *rc::gen::inRange(0, 6); k > 0; --k) {
    std::next_permutation(order.begin(), order.end());
  }
  BvhFormat format;
  for (const SkeletonNode& node : motion.skeleton.nodes) {
    format.channels.push_back(node.end_site ? std::vector<BvhChannel>{} : channels_of(order, true));
  }
  const BvhFile read = parse_bvh_file(format_bvh(motion, format), "written.bvh").value();
  const auto at = [&](const SkeletonMotion& of, double unit, std::size_t i, int frame) {
    return world_transforms(of.skeleton, of.clip, frame)[i].translation * unit;
  };
  for (std::size_t i = 0; i < motion.skeleton.nodes.size(); ++i) {
    const std::string& name = motion.skeleton.nodes[i].name;
    const int k = read.motion.skeleton.find(name);
    if (motion.skeleton.nodes[i].end_site || k < 0) continue;
    const auto& channels = read.channels[static_cast<std::size_t>(k)];
    // one that does not move has no positions
    const bool moves = channels.size() == 6u;
    RC_ASSERT(channels.size() == (moves ? 6u : 3u));
    RC_ASSERT(channels[0].axis == order[0] && channels[2].axis == order[2]);
    if (moves) RC_ASSERT(!channels[3].rotates && channels[3].axis == Axis::y);
    for (int f = 0; f < motion.clip.frames; ++f) {
      RC_ASSERT(norm(at(motion, 1.0, i, f) -
                     at(read.motion, 0.01, static_cast<std::size_t>(k), f)) < 1e-6);
    }
  }
}

TEST(BvhWriter, ChannelsThatCannotTellAMotionAreReplaced) {
  SkeletonMotion motion = chain({{{}, {}, {}}, {turned(10, 20, 30), turned(10, 20, 30), {}}});
  BvhFormat format;
  format.channels = {{{true, Axis::x}, {true, Axis::y}, {true, Axis::x}},
                     {{true, Axis::x}},
                     {{true, Axis::x}},
                     {}};
  format.channels.resize(motion.skeleton.nodes.size());
  const BvhFile read = parse_bvh_file(format_bvh(motion, format), "written.bvh").value();
  EXPECT_EQ(read.channels[0].size(), 6u);
  EXPECT_EQ(read.channels[1].size(), 3u);
  EXPECT_EQ(read.channels[1][0].axis, Axis::z);
  EXPECT_EQ(read.channels[2].size(), 1u);
}

// A file whose hips hang on another node: they move in it, and have no channels for that.
TEST(BvhWriter, ANodeThatGetsPositionsKeepsTheOrderOfItsRotations) {
  SkeletonMotion motion = chain({{{}, turned(30, 40, 50)}});
  motion.clip.local[1].translation += Vec3d{0.1, 0.2, 0.3};
  BvhFormat format;
  const std::vector<Axis> order{Axis::x, Axis::y, Axis::z};
  format.channels = {channels_of(order, true), channels_of(order, false)};
  format.channels.resize(motion.skeleton.nodes.size());
  const std::string text = format_bvh(motion, format);
  const BvhFile read = parse_bvh_file(text, "written.bvh").value();
  ASSERT_EQ(read.channels[1].size(), 6u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(read.channels[1][3 + k].axis, order[k]);
  const auto tip = [](const SkeletonMotion& of) {
    return world_transforms(of.skeleton, of.clip, 0).back().translation;
  };
  EXPECT_LT(norm(tip(motion) - tip(read.motion) * 0.01), 1e-6);
}

TEST(BvhWriter, GimbalLockIsWrittenExactly) {
  for (const double x : {90.0, -90.0}) {
    for (const double off : {0.0, 1e-4, 1e-7, 1e-9, 1e-12}) {
      EXPECT_LT(moved_by_writing(chain({{turned(20, x - off, 30), turned(-70, x + off, 170)}})),
                5e-9)
          << x << " " << off;
    }
  }
}

// The numbers of one column of the motion.
std::vector<double> column(const std::string& text, std::size_t index) {
  std::istringstream lines(text.substr(text.find("Frame Time")));
  std::string line;
  std::getline(lines, line);
  std::vector<double> values;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    double value = 0.0;
    for (std::size_t i = 0; i <= index; ++i) numbers >> value;
    values.push_back(value);
  }
  return values;
}

double largest_step(const std::vector<double>& values) {
  double step = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    step = std::max(step, std::abs(values[i] - values[i - 1]));
  }
  return step;
}

TEST(BvhWriter, AnglesGoOnPastAHalfTurn) {
  for (const std::size_t axis : {0u, 1u, 2u}) {
    std::vector<std::vector<Quatd>> frames;
    for (int k = 0; k <= 80; ++k) {
      const double angle = 10.0 * k;
      frames.push_back(
          {turned(axis == 0 ? angle : 0, axis == 1 ? angle : 0, axis == 2 ? angle : 0)});
    }
    const auto written = column(format_bvh(chain(frames)), 3 + axis);
    EXPECT_NEAR(written.back(), 800.0, 1e-5);
    EXPECT_NEAR(largest_step(written), 10.0, 1e-5);
  }
}

TEST(BvhWriter, AnglesDoNotJumpThroughGimbalLock) {
  std::vector<std::vector<Quatd>> frames;
  for (int k = 0; k <= 100; ++k) frames.push_back({turned(40 + k, 60 + 0.6 * k, 20 - k)});
  const std::string text = format_bvh(chain(frames));
  // steps of 1°, but in the frame of the lock (x = 90°) the first angle waits and then catches up
  for (const std::size_t axis : {0u, 1u, 2u}) {
    EXPECT_LT(largest_step(column(text, 3 + axis)), 2.1);
  }
}

TEST(BvhWriter, OnlyMovingNodesHavePositionChannels) {
  SkeletonMotion motion = chain({{{}, {}, {}}, {{}, {}, {}}});
  motion.clip.local[2].translation.x += 0.25;
  const std::string text = format_bvh(motion);
  EXPECT_THAT(text, HasSubstr("JOINT j1\n\t{\n\t\tOFFSET 0.000000 10.000000 0.000000\n"
                              "\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n"));
  EXPECT_THAT(text, HasSubstr("JOINT j2\n\t\t{\n\t\t\tOFFSET 0.000000 0.000000 0.000000\n"
                              "\t\t\tCHANNELS 6 Xposition Yposition Zposition "));
  EXPECT_LT(moved_by_writing(motion), 1e-9);
}

TEST(BvhWriter, TextIsTheClassicLayout) {
  SkeletonMotion motion = chain({{turned(90, 0, 0)}});
  motion.clip.local[0].translation = {0.5, -1e-12, 1.0 / 3.0};
  motion.clip.frame_time = 0.1;
  EXPECT_EQ(format_bvh(motion),
            "HIERARCHY\n"
            "ROOT j0\n"
            "{\n"
            "\tOFFSET 0.000000 0.000000 0.000000\n"
            "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
            "\tEnd Site\n"
            "\t{\n"
            "\t\tOFFSET 0.000000 10.000000 0.000000\n"
            "\t}\n"
            "}\n"
            "MOTION\n"
            "Frames: 1\n"
            "Frame Time: 0.1\n"
            "50.000000 0.000000 33.333333 90.000000 0.000000 0.000000\n");
}

TEST(BvhWriter, NodesComeDepthFirst) {
  SkeletonMotion motion;
  motion.skeleton.nodes = {{"a", -1, {}, false},
                           {"b", 0, {}, false},
                           {"c", 0, {}, false},
                           {"d", 1, {}, false},
                           {"e", -1, {}, false}};
  motion.clip = {1.0, 1, std::vector<LocalTransform>(5)};
  const auto read = parse_bvh(format_bvh(motion), "x.bvh");
  ASSERT_TRUE(read) << read.error().to_string();
  std::string order;
  for (const SkeletonNode& node : read->skeleton.nodes) order += node.name;
  EXPECT_EQ(order, "abdce");
}

TEST(BvhWriter, NamesAreMadeFitForEveryReader) {
  SkeletonMotion motion;
  motion.skeleton.nodes = {{"left {arm}", -1, {}, false},
                           {"左ひじ", 0, {}, false},
                           {"", 0, {}, false},
                           {"left _arm_", 0, {}, false},
                           {" Bip01 L Hand ", 0, {}, false},
                           {std::string(1000, 'x'), 0, {}, false}};
  motion.clip = {1.0, 1, std::vector<LocalTransform>(6)};
  const auto read = parse_bvh(format_bvh(motion), "x.bvh");
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->skeleton.nodes[0].name, "left__arm_");
  EXPECT_EQ(read->skeleton.nodes[1].name, "左ひじ");
  EXPECT_EQ(read->skeleton.nodes[2].name, "joint");
  EXPECT_EQ(read->skeleton.nodes[3].name, "left__arm__2");
  EXPECT_EQ(read->skeleton.nodes[4].name, "Bip01_L_Hand");
  EXPECT_EQ(read->skeleton.nodes[5].name, std::string(240, 'x'));
}

TEST(BvhWriter, FrameTimeReadsBackExactly) {
  SkeletonMotion motion = chain({{{}}});
  motion.clip.frame_time = 1.0 / 60.0;
  EXPECT_EQ(parse_bvh(format_bvh(motion), "x.bvh")->clip.frame_time, 1.0 / 60.0);
}

TEST(BvhWriter, MotionWithoutFramesIsACallersMistake) {
  SkeletonMotion motion = chain({{{}}});
  motion.clip.frames = 0;
  motion.clip.local.clear();
  EXPECT_THROW(static_cast<void>(format_bvh(motion)), PreconditionError);
}

TEST(BvhWriter, NumbersThatAreNotFiniteAreACallersMistake) {
  SkeletonMotion motion = chain({{{}}});
  motion.clip.local[0].rotation.x = std::nan("");
  EXPECT_THROW(static_cast<void>(format_bvh(motion)), PreconditionError);
}

struct RealFile {
  const char* path;
  std::size_t nodes;
  int frames;
};

class RealBvh : public ::testing::TestWithParam<RealFile> {
 protected:
  [[nodiscard]] static fs::path path() { return fs::path(SHIGUSA_SHARED_DIR) / GetParam().path; }
};

TEST_P(RealBvh, IsReadWholly) {
  if (!fs::exists(path())) GTEST_SKIP() << "no " << path();
  const auto motion = read_bvh(path());
  ASSERT_TRUE(motion) << motion.error().to_string();
  EXPECT_EQ(motion->skeleton.nodes.size(), GetParam().nodes);
  EXPECT_EQ(motion->clip.frames, GetParam().frames);
}

// The bound holds for a person in metres; in their own units these bodies are up to 100 times as
// large.
TEST_P(RealBvh, SurvivesWritingAndReading) {
  if (!fs::exists(path())) GTEST_SKIP() << "no " << path();
  const auto motion = read_bvh(path());
  ASSERT_TRUE(motion);
  EXPECT_LT(moved_by_writing(*motion, 1.0), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, RealBvh,
    ::testing::Values(RealFile{"characters/assimp__Boxing_Toes.bvh", 26, 3069},
                      RealFile{"characters/blender-cli-rendering__102_01.bvh", 38, 277},
                      RealFile{"characters/fairmotion__pfnn_hierarchy.bvh", 38, 60},
                      RealFile{"characters/pybvh__bvh_test1.bvh", 29, 75},
                      RealFile{"characters/pybvh__standard_skeleton.bvh", 29, 1},
                      RealFile{"reach/cmu_02_06_60hz.bvh", 38, 1118}),
    [](const auto& test) {
      std::string name = fs::path(test.param.path).stem().string();
      std::replace_if(
          name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
      return name;
    });

}  // namespace
}  // namespace shigusa
