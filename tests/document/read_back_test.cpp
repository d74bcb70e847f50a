// SPDX-License-Identifier: MIT
#include "document/read_back.hpp"

#include <gmock/gmock.h>

#include <array>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>

#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// A micrometre is above the rounding of digits, and below anything visible.
constexpr double kFine = 1e-6;  // m

// A person of a file, and their motion at 30 frames a second.
struct Moved {
  CharacterSpec character;
  Task task;
  Candidate candidate;
  Clip clip;

  [[nodiscard]] std::string file(FileFormat format) const {
    return export_candidate(character, task, candidate, format, {.rate = 30.0}).value();
  }
  [[nodiscard]] ReadBackCheck check() const { return {character, task, candidate, clip}; }
};

Moved moved_from(const std::string& name, std::string bytes) {
  TaskFile file;
  file.character.source = name;
  EXPECT_TRUE(load_character(std::move(bytes), file.character));
  file.goals = {{"right_hand", {-0.2, 0.7, 0.4}}};
  const Task task = make_task(file, {}).value();
  const Candidate best = regenerate(task, uniform_parameters(task.body)).value().candidates[0];
  return {file.character, task, best, motion_at(task.body, best, 30.0)};
}
Moved of_bvh() { return moved_from("person.bvh", person_bvh()); }
Moved of_gltf() { return moved_from("person.glb", glb(person_gltf().dump(), "data")); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ReadBack, FilesAreWhereTheMotionIs) {
  const Moved bvh = of_bvh();
  const Moved gltf = of_gltf();
  for (const auto& back :
       {bvh.check().bvh(bvh.file(FileFormat::bvh)), gltf.check().bvh(gltf.file(FileFormat::bvh)),
        gltf.check().glb(gltf.file(FileFormat::glb), "shigusa")}) {
    ASSERT_TRUE(back) << back.error().to_string();
    EXPECT_LT(back->effector, kFine);
    EXPECT_LT(back->feet, kFine);
    EXPECT_LT(degrees(back->turn), 1e-4);
  }
}

// A file whose channels are named in another order than their numbers.
TEST(ReadBack, ChannelsInAnotherOrderAreFound) {
  const Moved moved = of_bvh();
  const std::string text = replaced(moved.file(FileFormat::bvh), "Zrotation Xrotation Yrotation",
                                    "Xrotation Yrotation Zrotation");
  const auto back = moved.check().bvh(text);
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, ErrorCode::unsupported);
  EXPECT_THAT(back.error().to_string(),
              AllOf(HasSubstr("the format bvh: read back, "), HasSubstr(" mm off the motion"),
                    HasSubstr("leave it out")));
}

TEST(ReadBack, AHandThatIsATenthOfAMillimetreOffIsToldAndTwoAreRefused) {
  const Moved moved = of_bvh();
  BvhFile file = parse_bvh_file(moved.file(FileFormat::bvh), "x.bvh").value();
  const int hand = file.motion.skeleton.find("right_hand");
  const std::size_t nodes = file.motion.skeleton.nodes.size();
  // in one frame of the middle alone
  const std::size_t frame = static_cast<std::size_t>(file.motion.clip.frames / 2);
  for (LocalTransform& local : file.motion.clip.local) {
    local.translation = local.translation * 0.01;
  }
  for (SkeletonNode& node : file.motion.skeleton.nodes) node.offset = node.offset * 0.01;
  const std::string same = format_bvh(file.motion, {.channels = file.channels});
  EXPECT_TRUE(moved.check().bvh(same).value().off.empty());
  double& height =
      file.motion.clip.local[frame * nodes + static_cast<std::size_t>(hand)].translation.y;
  height += 1e-4;
  EXPECT_THAT(moved.check().bvh(format_bvh(file.motion)).value().off,
              HasSubstr("right_hand is 0.1"));
  height += 2e-3;
  EXPECT_THAT(moved.check().bvh(format_bvh(file.motion)).error().message,
              HasSubstr("right_hand is 2.1"));
}

TEST(ReadBack, AFootThatTiltsIsFound) {
  const Moved moved = of_bvh();
  SkeletonMotion motion = parse_bvh(moved.file(FileFormat::bvh), "x.bvh").value();
  const int foot = motion.skeleton.find("left_foot");
  const std::size_t nodes = motion.skeleton.nodes.size();
  for (LocalTransform& local : motion.clip.local) local.translation = local.translation * 0.01;
  for (SkeletonNode& node : motion.skeleton.nodes) node.offset = node.offset * 0.01;
  LocalTransform& last =
      motion.clip.local[motion.clip.local.size() - nodes + static_cast<std::size_t>(foot)];
  last.rotation = last.rotation * axis_rotation(Axis::x, radians(0.01));
  EXPECT_THAT(moved.check().bvh(format_bvh(motion)).value().off,
              HasSubstr("left_foot is turned by 0.01"));
  last.rotation = last.rotation * axis_rotation(Axis::x, radians(0.2));
  EXPECT_THAT(moved.check().bvh(format_bvh(motion)).error().message,
              HasSubstr("left_foot is turned by 0.21"));
}

TEST(ReadBack, AFileOfAnotherRateOrOtherNodesIsFound) {
  const Moved moved = of_bvh();
  const std::string text = moved.file(FileFormat::bvh);
  const std::string slower = replaced(text, "Frame Time: 0.0333", "Frame Time: 0.0334");
  EXPECT_THAT(moved.check().bvh(slower).error().message, HasSubstr("frames of 0.0334"));
  EXPECT_THAT(moved.check().bvh(person_bvh()).error().message, HasSubstr("it has 3 frames"));
  EXPECT_THAT(moved.check().bvh(one_joint_bvh()).error().message, HasSubstr("other nodes"));
  EXPECT_THAT(moved.check().bvh("no BVH").error().message, HasSubstr("cannot be read back"));
}

// Flips one exponent bit of each number of the animation in turn: any change that moves a hand or a
// foot by more than a float's rounding is found.
TEST(ReadBack, WrongNumbersOfAGlbAreFound) {
  const Moved moved = of_gltf();
  const std::string good = moved.file(FileFormat::glb);
  int found = 0;
  int tried = 0;
  for (std::size_t at = good.size() - 1; at > good.size() / 2; at -= 396) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x40);
    ++tried;
    found += moved.check().glb(bad, "shigusa") ? 0 : 1;
  }
  EXPECT_GT(tried, 15);
  EXPECT_GT(found, tried / 4) << "most nodes carry neither the hand nor a foot";
}

}  // namespace
}  // namespace shigusa
