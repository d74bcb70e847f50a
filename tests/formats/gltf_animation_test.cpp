// SPDX-License-Identifier: MIT
#include "formats/gltf_animation.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <functional>

#include "formats/gltf_write.hpp"
#include "support/gltf_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::json;

std::string floats(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) {
    bytes += word_bytes(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  return bytes;
}

// A root with one child, 1 m above it, whose `path` has these keys.
struct Channel {
  std::vector<double> times{0.0, 1.0};
  std::vector<double> values{0, 0, 0, 1, 0, 0, 1, 0};  // a half turn about z
  std::string path = "rotation";
  std::string interpolation = "LINEAR";
};

Json two_nodes(const Channel& channel, std::string& binary) {
  const bool turns = channel.path == "rotation";
  const std::size_t per = turns ? 4 : 3;
  binary = floats(channel.times) + floats(channel.values);
  const std::size_t split = 4 * channel.times.size();
  Json file{{"asset", {{"version", "2.0"}}}};
  file["nodes"] = {{{"name", "root"}, {"children", {1}}},
                   {{"name", "arm"}, {"translation", {0, 1, 0}}, {"children", {2}}},
                   {{"name", "hand"}, {"translation", {1, 0, 0}}}};
  file["buffers"] = {{{"byteLength", binary.size()}}};
  file["bufferViews"] = {
      {{"buffer", 0}, {"byteLength", split}},
      {{"buffer", 0}, {"byteOffset", split}, {"byteLength", binary.size() - split}}};
  file["accessors"] = {{{"bufferView", 0},
                        {"componentType", 5126},
                        {"count", channel.times.size()},
                        {"type", "SCALAR"}},
                       {{"bufferView", 1},
                        {"componentType", 5126},
                        {"count", channel.values.size() / per},
                        {"type", turns ? "VEC4" : "VEC3"}}};
  file["animations"] = {
      {{"name", "wave"},
       {"samplers", {{{"input", 0}, {"output", 1}, {"interpolation", channel.interpolation}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", channel.path}}}}}}}};
  return file;
}

Result<GltfMotion> read(const Channel& channel, double rate = 4.0) {
  std::string binary;
  const Json file = two_nodes(channel, binary);
  return parse_gltf_animation(glb(file.dump(), binary), "wave.glb", {.frame_rate = rate});
}

// Position of the hand in a frame.
Vec3d hand(const GltfMotion& motion, int frame) {
  return world_transforms(motion.motion.skeleton, motion.motion.clip, frame).back().translation;
}

void expect_at(const Vec3d& p, const Vec3d& q) {
  EXPECT_LT(norm(p - q), 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(GltfAnimationReader, TurnsAtAConstantSpeed) {
  const GltfMotion motion = read({}).value();
  EXPECT_EQ(motion.animation, "wave");
  ASSERT_EQ(motion.motion.clip.frames, 5);
  for (int f = 0; f < 5; ++f) {
    const double angle = f * kPi / 4.0;
    expect_at(hand(motion, f), {std::cos(angle), 1.0 + std::sin(angle), 0.0});
  }
}

TEST(GltfAnimationReader, StepsHoldTheirKey) {
  const GltfMotion motion = read({.interpolation = "STEP"}).value();
  expect_at(hand(motion, 3), {1, 1, 0});
  expect_at(hand(motion, 4), {-1, 1, 0});
}

// Hermite's cubic: p(½) = ½ (p0 + p1) + ⅛ (m0 - m1).
TEST(GltfAnimationReader, CubicSplinesGoByTheirTangents) {
  const GltfMotion motion = read({.times = {0.0, 2.0},
                                  .values = {9, 9, 9, 0, 1, 0, 1, 0, 0,  //
                                             0, 2, 0, 4, 1, 0, 9, 9, 9},
                                  .path = "translation",
                                  .interpolation = "CUBICSPLINE"})
                                .value();
  ASSERT_EQ(motion.motion.clip.frames, 9);
  expect_at(hand(motion, 0), {1, 1, 0});
  expect_at(hand(motion, 4), Vec3d{1, 0, 0} + Vec3d{2.0 + 0.25, 1.0 - 0.5, 0});
  expect_at(hand(motion, 8), {5, 1, 0});
}

TEST(GltfAnimationReader, BeforeTheFirstKeyThatHolds) {
  const GltfMotion motion = read({.times = {0.5, 1.0}}).value();
  expect_at(hand(motion, 0), {1, 1, 0});
  expect_at(hand(motion, 1), {1, 1, 0});
  expect_at(hand(motion, 4), {-1, 1, 0});
}

TEST(GltfAnimationReader, ScalesMoveWhatIsBelow) {
  const GltfMotion motion = read({.values = {1, 1, 1, 3, 3, 3}, .path = "scale"}).value();
  expect_at(hand(motion, 2), {2, 1, 0});
}

TEST(GltfAnimationReader, ReadsNormalisedShorts) {
  std::string binary;
  Json file = two_nodes({}, binary);
  binary = floats({0.0, 1.0});
  for (const int value : {0, 0, 0, 32767, 0, -23170, 0, 23170}) {  // a quarter turn about -y
    binary += static_cast<char>(value & 0xFF);
    binary += static_cast<char>(value >> 8 & 0xFF);
  }
  file["bufferViews"][1]["byteLength"] = 16;
  file["accessors"][1]["componentType"] = 5122;
  file["accessors"][1]["normalized"] = true;
  const GltfMotion motion =
      parse_gltf_animation(glb(file.dump(), binary), "wave.glb", {.frame_rate = 4.0}).value();
  expect_at(hand(motion, 4), {0, 1, 1});
}

TEST(GltfAnimationReader, ReadsDataInTheText) {
  std::string binary;
  Json file = two_nodes({.times = {0.0}, .values = {0, 0, 1, 0}}, binary);
  // 0.f, then 0 0 1 0
  file["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAA=";
  const GltfMotion motion = parse_gltf_animation(file.dump(), "wave.gltf").value();
  ASSERT_EQ(motion.motion.clip.frames, 1);
  expect_at(hand(motion, 0), {-1, 1, 0});
}

// Angles written by add_animations are read back, in single precision.
TEST(GltfAnimationReader, ReadsWhatIsWrittenHere) {
  const std::string file = person_gltf().dump();
  const GltfCharacter person = parse_gltf(file, "person.gltf").value();
  GltfAnimation animation{"nod", 1.0 / 60.0, 31, {}};
  const int head = person.rest.skeleton.find("head");
  ASSERT_GE(head, 0);
  const auto h = static_cast<std::size_t>(head);
  GltfTrack track{person.file_node[h], person.places[h], {}, {}};
  for (int f = 0; f < animation.frames; ++f) {
    track.rotations.push_back(axis_rotation(Axis::x, 0.02 * f) * person.places[h].rotation);
  }
  animation.tracks.push_back(track);
  const std::string written = add_animations(file, "person.gltf", std::span(&animation, 1)).value();
  const GltfMotion motion = parse_gltf_animation(written, "nod.glb").value();
  EXPECT_EQ(motion.animation, "nod");
  ASSERT_EQ(motion.motion.clip.frames, 31);
  const auto parent = static_cast<std::size_t>(person.rest.skeleton.nodes[h].parent);
  for (const int f : {0, 7, 30}) {
    const auto world = world_transforms(motion.motion.skeleton, motion.motion.clip, f);
    // from the turn at rest, which is that of frame 0
    const Quatd q = to_quat(transpose(world[parent].rotation) * world[h].rotation);
    EXPECT_NEAR(2.0 * std::acos(std::min(1.0, q.w)), 0.02 * f, 2e-3) << f;
  }
}

TEST(GltfAnimationReader, ChoosesByNameAndIndex) {
  std::string binary;
  Json file = two_nodes({}, binary);
  file["animations"].push_back(file["animations"][0]);
  file["animations"][1]["name"] = "other";
  const std::string bytes = glb(file.dump(), binary);
  EXPECT_EQ(parse_gltf_animation(bytes, "a.glb", {.animation = "other"})->animation, "other");
  EXPECT_EQ(parse_gltf_animation(bytes, "a.glb", {.animation = "1"})->animation, "other");
  EXPECT_THAT(parse_gltf_animation(bytes, "a.glb")->doubts,
              testing::Contains(HasSubstr("of 2 animations the first, 'wave', is taken")));
  EXPECT_THAT(parse_gltf_animation(bytes, "a.glb", {.animation = "jump"}).error().to_string(),
              HasSubstr("no animation 'jump'; it has 'wave', 'other'"));
}

struct Malformed {
  const char* what;
  std::function<void(Json&)> change;
  const char* message;
};

TEST(GltfAnimationReader, EveryCutOfAFileIsRefusedOrHasNames) {
  const std::string whole = glb(R"({"animations": [{"name": "wave"}]})", "data");
  EXPECT_THAT(gltf_animation_names(whole, "x.glb").value(), testing::ElementsAre("wave"));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto names = gltf_animation_names(whole.substr(0, size), "x.glb");
    EXPECT_EQ(names.has_value(), size < 4) << size;
    EXPECT_TRUE(names.value_or(std::vector<std::string>{}).empty()) << size;
  }
}

TEST(GltfAnimationReader, MalformedFilesAreRefusedWithAReason) {
  const std::vector<Malformed> files{
      {"none", [](Json& f) { f.erase("animations"); }, "holds no animation"},
      {"no samplers", [](Json& f) { f["animations"][0].erase("samplers"); }, "no list of samplers"},
      {"sampler", [](Json& f) { f["animations"][0]["channels"][0]["sampler"] = 5; },
       "sampler is none"},
      {"interpolation",
       [](Json& f) { f["animations"][0]["samplers"][0]["interpolation"] = "BEZIER"; },
       "allowed are LINEAR"},
      {"accessor", [](Json& f) { f["animations"][0]["samplers"][0]["output"] = 7; },
       "7 is none of the 2"},
      {"type", [](Json& f) { f["accessors"][1]["type"] = "VEC3"; }, "must be VEC4"},
      {"component", [](Json& f) { f["accessors"][1]["componentType"] = 5125; }, "floats (5126)"},
      {"sparse", [](Json& f) { f["accessors"][1]["sparse"] = Json::object(); }, "is sparse"},
      {"count", [](Json& f) { f["accessors"][1]["count"] = 1u << 31; }, "do not fit"},
      {"beyond its view", [](Json& f) { f["accessors"][1]["count"] = 3; }, "do not fit"},
      {"offset", [](Json& f) { f["accessors"][1]["byteOffset"] = 9'000'000'000'000u; },
       "do not fit"},
      {"view", [](Json& f) { f["bufferViews"][1]["byteLength"] = 1000; }, "lie beyond the"},
      {"stride", [](Json& f) { f["bufferViews"][1]["byteStride"] = 4; }, "do not fit"},
      {"other file", [](Json& f) { f["buffers"][0]["uri"] = "wave.bin"; }, "is in another file"},
      {"base64", [](Json& f) { f["buffers"][0]["uri"] = "data:x;base64,!!!!"; }, "no base64"},
      {"equal times",
       [](Json& f) {
         f["accessors"][0]["bufferView"] = 1;
         f["accessors"][0]["count"] = 2;
       },
       "times must be 0 or more and rise"},
      {"few values", [](Json& f) { f["accessors"][1]["count"] = 1; }, "it must have 8"},
  };
  for (const Malformed& malformed : files) {
    std::string binary;
    Json file = two_nodes({}, binary);
    malformed.change(file);
    const auto read = parse_gltf_animation(glb(file.dump(), binary), "wave.glb");
    ASSERT_FALSE(read.has_value()) << malformed.what;
    EXPECT_THAT(read.error().to_string(), HasSubstr(malformed.message)) << malformed.what;
    EXPECT_THAT(read.error().to_string(), HasSubstr("wave.glb")) << malformed.what;
  }
}

TEST(GltfAnimationReader, NumbersThatAreNoneAreRefused) {
  const double nan = std::nan("");
  EXPECT_THAT(read({.values = {0, 0, 0, 1, 0, nan, 1, 0}}).error().to_string(),
              HasSubstr("element 1 holds nan"));
  EXPECT_THAT(read({.values = {0, 0, 0, 1, 0, 0, 0, 0}}).error().to_string(),
              HasSubstr("quaternion of length 0"));
  EXPECT_THAT(read({.times = {0.0, 1e8}}).error().to_string(), HasSubstr("are allowed"));
}

Result<GltfMotion> read_with_gaps(const Channel& channel,
                                  const std::function<void(Json&)>& change = {}) {
  std::string binary;
  Json file = two_nodes(channel, binary);
  if (change) change(file);
  return parse_gltf_animation(glb(file.dump(), binary), "wave.glb",
                              {.frame_rate = 10.0, .gaps = true});
}

TEST(GltfAnimationReader, DamagedKeysAreLeftOutWhereThatIsAskedFor) {
  const double nan = std::nan("");
  const auto gap_of = [&](const Channel& channel) {
    const GltfMotion moving = read_with_gaps(channel).value();
    EXPECT_EQ(moving.motion.clip.frames, 21);
    EXPECT_EQ(moving.gaps.size(), 1u);
    EXPECT_THAT(moving.doubts, testing::Contains(HasSubstr("the first of node 'arm'")));
    return std::pair(moving.gaps.at(0).first, moving.gaps.at(0).last);
  };
  const std::vector<double> times{0.0, 1.0, 2.0};
  // the frames next to good keys are known
  EXPECT_EQ(gap_of({times, {0, 0, 0, 1, nan, 0, 0, 1, 0, 0, 1, 0}}), std::pair(1, 19));
  EXPECT_EQ(gap_of({times, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}}), std::pair(11, 20));
  EXPECT_EQ(gap_of({times, {1e20, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0}}), std::pair(0, 9));
  EXPECT_EQ(gap_of({{0.0, nan, 2.0}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0}}), std::pair(1, 19));
  EXPECT_EQ(gap_of({times, {nan, 0, 0, 1, nan, 0, 0, 1, nan, 0, 1, 0}}), std::pair(0, 20));
  const GltfMotion between =
      read_with_gaps({times, {0, 0, 0, 1, nan, 0, 0, 1, 0, 0, 1, 0}}).value();
  const GltfMotion straight = read_with_gaps({{0.0, 2.0}, {0, 0, 0, 1, 0, 0, 1, 0}}).value();
  for (std::size_t k = 0; k < between.motion.clip.local.size(); ++k) {
    EXPECT_NEAR(between.motion.clip.local[k].rotation.z, straight.motion.clip.local[k].rotation.z,
                1e-9);
  }
}

TEST(GltfAnimationReader, DamagedTracksAreLeftOutWhereThatIsAskedFor) {
  const auto lost = [](const std::function<void(Json&)>& change) {
    const Result<GltfMotion> moving = read_with_gaps({}, change);
    ASSERT_TRUE(moving) << moving.error().to_string();
    EXPECT_THAT(moving->doubts, testing::Contains(HasSubstr("1 tracks of the animation")));
    EXPECT_EQ(moving->gaps.size(), 1u);
  };
  lost([](Json& f) { f["animations"][0]["samplers"][0]["output"] = 7; });
  lost([](Json& f) { f["animations"][0]["samplers"][0]["interpolation"] = "BEZIER"; });
  lost([](Json& f) { f["animations"][0]["channels"][0]["sampler"] = 5; });
}

}  // namespace
}  // namespace shigusa
