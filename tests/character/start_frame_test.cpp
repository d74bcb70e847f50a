// SPDX-License-Identifier: MIT
// The frame of a recording in which a motion starts: the first in which the person stands still.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <bit>
#include <shigusa/formats.hpp>

#include "character/character_file.hpp"
#include "character/character_rig.hpp"
#include "character/recording.hpp"
#include "human/landmark_points.hpp"
#include "rig/find_humanoid.hpp"
#include "rig/stick_figure.hpp"
#include "support/gltf_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct Turn {
  const char* joint;
  Axis axis;
  double angle_deg;
};

// A posture of the standing figure, whose OFFSETs form a T-pose: the joints' turns, with hanging
// arms unless they are spread, and the hips moved (m) and turned as a whole.
struct Posture {
  std::vector<Turn> turns{};
  Vec3d hips{};
  Quatd whole{};
  bool spread = false;
};

Quatd about(Axis axis, double angle_deg) { return to_quat(rotation(axis, radians(angle_deg))); }

// A recording of such postures, each held for a number of frames, at 30 frames a second.
class FilmedFigure {
 public:
  FilmedFigure() : motion_{standing_figure().skeleton(), {}} {
    motion_.clip.frame_time = 1.0 / 30.0;
  }

  void hold(const Posture& posture, int frames = 1) {
    std::vector<LocalTransform> frame;
    for (const SkeletonNode& node : motion_.skeleton.nodes) frame.push_back({node.offset, {}});
    const auto turn = [&](const char* joint, const Quatd& by) {
      LocalTransform& local = frame.at(static_cast<std::size_t>(motion_.skeleton.find(joint)));
      local.rotation = by * local.rotation;
    };
    if (!posture.spread) {
      turn("LeftArm", about(Axis::z, -80));
      turn("RightArm", about(Axis::z, 80));
    }
    for (const auto& [joint, axis, angle_deg] : posture.turns) turn(joint, about(axis, angle_deg));
    LocalTransform& hips = frame.front();
    hips.translation = to_matrix(posture.whole) * (hips.translation + posture.hips);
    hips.rotation = posture.whole * hips.rotation;
    for (int k = 0; k < frames; ++k) {
      motion_.clip.local.insert(motion_.clip.local.end(), frame.begin(), frame.end());
    }
    motion_.clip.frames += frames;
  }

  // A step: one thigh ahead, the other behind, on straight legs.
  void step(double angle_deg, double along) {
    hold({.turns = {{"LeftUpLeg", Axis::x, -angle_deg}, {"RightUpLeg", Axis::x, angle_deg}},
          .hips = {0, -0.05, along}});
  }
  // Steps at 1.2 m/s.
  void walk(int frames) {
    for (int k = 0; k < frames; ++k) {
      step(25.0 * sin_cos(0.2 * k + 1.0).sin, 0.04 * k);
    }
  }

  // The same motion with OFFSETs that are no posture: each bone lies along its own x, as in files
  // of some recording studios.
  [[nodiscard]] std::string bvh_along_bones() const {
    SkeletonMotion other = motion_;
    const std::vector<SkeletonNode>& nodes = motion_.skeleton.nodes;
    std::vector<Quatd> own(nodes.size());
    const auto back = [&](int node) {
      const Quatd& q = own[static_cast<std::size_t>(node)];
      return Quatd{-q.x, -q.y, -q.z, q.w};
    };
    for (std::size_t i = nodes.size(); i-- > 1;) {
      const Vec3d x = normalized(nodes[i].offset);
      const Vec3d z = normalized(cross(x, abs(x.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1}));
      own[static_cast<std::size_t>(nodes[i].parent)] = to_quat({x, cross(z, x), z});
    }
    for (std::size_t k = 0; k < other.clip.local.size(); ++k) {
      const std::size_t i = k % nodes.size();
      LocalTransform& local = other.clip.local[k];
      local.rotation = local.rotation * own[i];
      if (nodes[i].parent < 0) continue;
      local.rotation = back(nodes[i].parent) * local.rotation;
      local.translation = to_matrix(back(nodes[i].parent)) * local.translation;
      other.skeleton.nodes[i].offset = local.translation;
    }
    return format_bvh(other);
  }

  [[nodiscard]] std::string bvh() const { return format_bvh(motion_); }

 private:
  SkeletonMotion motion_;
};

// Thighs level, shanks upright.
Posture sitting() {
  return {.turns = {{"LeftUpLeg", Axis::x, -90},
                    {"RightUpLeg", Axis::x, -90},
                    {"LeftLeg", Axis::x, 90},
                    {"RightLeg", Axis::x, 90}},
          .hips = {0, -0.4, 0}};
}

// On the back, at the height of half a trunk, feet towards z.
Posture lying() {
  const Quatd back = about(Axis::x, -90);
  const Vec3d place{0, 0.12, 0};
  const double hip = standing_figure()["Hips"].at.y;
  return {
      .turns = {}, .hips = transpose(to_matrix(back)) * place - Vec3d{0, hip, 0}, .whole = back};
}

Result<CharacterSpec> loaded(const std::string& bvh, CharacterSpec spec = {}) {
  spec.source = "filmed.bvh";
  const Result<void> done = load_character(bvh, spec);
  if (!done) return tl::unexpected(done.error());
  return spec;
}

// Largest distance of a joint between two starts (m).
double apart(const CharacterSpec& a, const CharacterSpec& b) {
  std::vector<Vec3d> points;
  for_each_point(*a.landmarks, [&](const Vec3d& p) { points.push_back(p); });
  double most = 0.0;
  std::size_t k = 0;
  for_each_point(*b.landmarks, [&](const Vec3d& p) { most = max(most, norm(p - points.at(k++))); });
  return most;
}

double knee_deg(const CharacterSpec& spec) {
  const Landmarks::Leg& leg = spec.landmarks->left_leg;
  const Vec3d thigh = leg.knee - leg.hip;
  const Vec3d shank = leg.ankle - leg.knee;
  return degrees(atan2(norm(cross(thigh, shank)), dot(thigh, shank)));
}

TEST(StartFrame, OfWhoStandsAtOnceIsTheFirst) {
  FilmedFigure figure;
  figure.hold({}, 10);
  figure.walk(20);
  const CharacterSpec spec = loaded(figure.bvh()).value();
  EXPECT_FALSE(spec.frame);
  EXPECT_THAT(spec.doubts, Not(Contains(HasSubstr("stands still"))));
}

TEST(StartFrame, OfWhoWalksFirstIsThatInWhichTheyStandStill) {
  FilmedFigure figure;
  figure.walk(37);
  figure.hold({.turns = {{"LeftForeArm", Axis::y, -30}}, .hips = {0, 0, 1.5}}, 10);
  const CharacterSpec spec = loaded(figure.bvh()).value();
  // two frames off the last step are enough to be still for 0.05 s
  ASSERT_TRUE(spec.frame);
  EXPECT_GE(*spec.frame, 37);
  EXPECT_LE(*spec.frame, 39);
  EXPECT_THAT(spec.doubts, Contains(HasSubstr(fmt::format("starts from frame {}", *spec.frame))));
  EXPECT_LT(knee_deg(spec), 1.0);
  EXPECT_EQ(apart(loaded(figure.bvh(), {.frame = spec.frame}).value(), spec), 0.0);
}

TEST(StartFrame, OfWhoOnlyWalksIsTheRestPoseAtEase) {
  FilmedFigure figure;
  figure.walk(60);
  const CharacterSpec spec = loaded(figure.bvh()).value();
  EXPECT_EQ(spec.frame, kRestPose);
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("starts from the rest pose, at ease")));
  EXPECT_EQ(apart(loaded(figure.bvh(), {.frame = kRestPose}).value(), spec), 0.0);
}

TEST(StartFrame, WhereOffsetsAreNoPostureIsOneThatStandsAndMoves) {
  FilmedFigure figure;
  figure.walk(60);
  const CharacterSpec spec = loaded(figure.bvh_along_bones()).value();
  EXPECT_GT(spec.frame.value_or(0), 0);
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("nor in the rest pose")));
  FilmedFigure stands;
  stands.hold({}, 10);
  EXPECT_FALSE(loaded(stands.bvh_along_bones())->frame);
}

TEST(StartFrame, StepThatIsStillIsNoStance) {
  FilmedFigure figure;
  figure.step(25.0, 0.0);
  EXPECT_EQ(loaded(figure.bvh())->frame, kRestPose);
}

// A person stepping on the spot stands upright on both feet for moments.
TEST(StartFrame, FeetThatMoveAreNoStance) {
  FilmedFigure figure;
  for (int k = 0; k < 30; ++k) {
    const double angle = 8.0 * sin_cos(1.0 * k).sin;
    figure.hold({.turns = {{"LeftUpLeg", Axis::x, -angle}, {"RightUpLeg", Axis::x, angle}}});
  }
  EXPECT_EQ(loaded(figure.bvh())->frame, kRestPose);
}

TEST(StartFrame, OfWhoCrouchesFirstIsThatInWhichTheyStand) {
  FilmedFigure figure;
  figure.hold({.turns = {{"LeftUpLeg", Axis::x, -100},
                         {"RightUpLeg", Axis::x, -100},
                         {"LeftLeg", Axis::x, 130},
                         {"RightLeg", Axis::x, 130},
                         {"LeftFoot", Axis::x, -30},
                         {"RightFoot", Axis::x, -30}},
               .hips = {0, -0.5, 0}},
              5);
  figure.hold({}, 9);
  const CharacterSpec spec = loaded(figure.bvh()).value();
  EXPECT_GE(spec.frame.value_or(0), 5);
}

TEST(StartFrame, NoiseOfAFewMillimetresIsStill) {
  FilmedFigure figure;
  for (int k = 0; k < 20; ++k) {
    const double a = k % 3 - 1.0;
    const double b = k % 2;
    figure.hold({.turns = {{"LeftUpLeg", Axis::x, 0.4 * a}, {"RightUpLeg", Axis::z, 0.4 * b}},
                 .hips = {0.004 * a, 0.004 * b, 0}});
  }
  EXPECT_FALSE(loaded(figure.bvh())->frame);
}

TEST(StartFrame, TPoseInTheMiddleIsNoStart) {
  FilmedFigure figure;
  figure.walk(10);
  figure.hold({.hips = {0, 0, 0.5}, .spread = true}, 20);
  figure.walk(10);
  figure.hold({.hips = {0, 0, 0.5}}, 20);
  EXPECT_GE(loaded(figure.bvh())->frame.value_or(0), 40);
}

TEST(StartFrame, WhoBeginsSeatedIsToldToTakeASeat) {
  FilmedFigure figure;
  figure.hold(sitting(), 5);
  const CharacterSpec spec = loaded(figure.bvh()).value();
  EXPECT_EQ(spec.frame, kRestPose);
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("the person sits in frame 0: give --seat 0.4")));
  EXPECT_THAT(loaded(figure.bvh(), {.frame = 2})->doubts,
              Contains(HasSubstr("the person sits in frame 2")));
}

TEST(StartFrame, OfWhoSitsIsKeptWithASeat) {
  FilmedFigure figure;
  Posture posture = sitting();
  posture.turns.push_back({"Spine", Axis::x, 15});
  figure.hold(posture, 2);
  const CharacterSpec seated = loaded(figure.bvh(), {.frame = 0, .seat = 0.42}).value();
  const CharacterSpec plain = loaded(figure.bvh(), {.frame = 0}).value();
  EXPECT_EQ(apart(seated, plain), 0.0);
  EXPECT_THAT(seated.doubts, Not(Contains(HasSubstr("frame 0"))));
  EXPECT_THAT(loaded(figure.bvh(), {.frame = 0, .seat = 0.6})->doubts,
              Contains(HasSubstr("not 0.60 m: the frame is kept")));
  const CharacterSpec upright = loaded(figure.bvh(), {.seat = 0.42}).value();
  EXPECT_GT(norm(upright.landmarks->left_arm.wrist - plain.landmarks->left_arm.wrist), 0.05);
}

TEST(StartFrame, OfWhoStandsIsSeatedUprightWithADoubt) {
  FilmedFigure figure;
  figure.hold({}, 2);
  EXPECT_THAT(loaded(figure.bvh(), {.frame = 1, .seat = 0.45})->doubts,
              Contains(HasSubstr("the person does not sit in frame 1")));
}

TEST(StartFrame, OfWhoLiesIsRefusedInWords) {
  FilmedFigure figure;
  figure.hold(lying(), 3);
  figure.hold({}, 10);
  const auto refused = loaded(figure.bvh(), {.frame = 1});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("in frame 1 the person lies"));
  EXPECT_TRUE(loaded(figure.bvh(), {.frame = 8}));
}

TEST(StartFrame, OfWhoLiesFirstIsThatInWhichTheyStand) {
  FilmedFigure figure;
  figure.hold(lying(), 30);
  figure.hold({}, 10);
  EXPECT_GE(loaded(figure.bvh())->frame.value_or(0), 30);
  FilmedFigure sleeper;
  sleeper.hold(lying(), 30);
  EXPECT_EQ(loaded(sleeper.bvh())->frame, kRestPose);
}

// A file with z up may have OFFSETs with y up, which does not mean that the person lies.
TEST(StartFrame, WhoStandsAlongAnotherAxisThanAtRestDoesNotLie) {
  FilmedFigure figure;
  figure.hold({.whole = about(Axis::x, 90)}, 10);
  EXPECT_FALSE(loaded(figure.bvh())->frame);
  EXPECT_TRUE(loaded(figure.bvh(), {.frame = 3}));
  // nor where the floor is below the file's 0
  FilmedFigure at_hips;
  at_hips.hold({.hips = Vec3d{} - standing_figure()["Hips"].at, .whole = about(Axis::x, 90)}, 10);
  EXPECT_FALSE(loaded(at_hips.bvh())->frame);
  EXPECT_TRUE(loaded(at_hips.bvh(), {.frame = 3}));
}

// Number of frames examined closely in a recording of a standing person without any steady frame.
int starts_tried(int frames) {
  FilmedFigure figure;
  figure.hold({}, frames);
  CharacterSpec spec;
  spec.source = "filmed.bvh";
  const CharacterFile file = parse_character(figure.bvh(), spec).value();
  const std::vector<Transformd> world = world_transforms(file.skeleton, file.rest.clip(), 0);
  const HumanoidMap map = find_humanoid(file.skeleton, world).value();
  const MeasuredPerson person = measure_person(file.skeleton, world, map).value();
  int tried = 0;
  const auto never = [&tried](const Landmarks&) { return ++tried == 0; };
  EXPECT_FALSE(Recording(file, map, person, world).first_stand(true, never));
  return tried;
}

TEST(StartFrame, IsTriedFourTimesASecondForSixSeconds) {
  EXPECT_EQ(starts_tried(7), 1);
  EXPECT_EQ(starts_tried(8), 2);
  EXPECT_EQ(starts_tried(50), 8);
  EXPECT_EQ(starts_tried(500), 24);
}

TEST(StartFrame, ThatNobodyCouldHoldIsToldWhereItWasAskedFor) {
  FilmedFigure figure;
  figure.hold({.turns = {{"Spine", Axis::x, 20}}, .whole = about(Axis::x, 20)}, 3);
  figure.hold({}, 10);
  EXPECT_THAT(loaded(figure.bvh(), {.frame = 1})->doubts,
              Contains(HasSubstr("that was asked for, frame 1, still")));
  EXPECT_THAT(loaded(figure.bvh(), {.frame = 8})->doubts,
              Not(Contains(HasSubstr("could not hold the start"))));
  EXPECT_GE(loaded(figure.bvh())->frame.value_or(0), 3);
}

TEST(StartFrame, WithoutNumbersIsLeftOutAndRefused) {
  FilmedFigure figure;
  figure.hold({}, 4);
  std::string text = figure.bvh();
  const std::size_t motion = text.find("Frame Time:");
  const std::size_t row = text.find('\n', motion) + 1;
  text.replace(row, text.find(' ', row) - row, "nan");
  const CharacterSpec spec = loaded(text).value();
  EXPECT_EQ(spec.frame, 1);
  EXPECT_THAT(loaded(text, {.frame = 0}).error().to_string(), HasSubstr("no numbers"));
}

TEST(StartFrame, OfAFileWithoutMotionIsTheRestPose) {
  FilmedFigure figure;
  figure.hold({});
  std::string text = figure.bvh();
  text.resize(text.find("MOTION"));
  const CharacterSpec spec = loaded(text).value();
  EXPECT_EQ(spec.frame, kRestPose);
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("the file has no motion")));
  EXPECT_THAT(loaded(text, {.frame = kRestPose})->doubts, Not(Contains(HasSubstr("no motion"))));
  EXPECT_THAT(loaded(text, {.frame = 0}).error().to_string(), HasSubstr("does not exist"));
}

// A person whose nodes turn by the given rotations at 0 s, and are at rest from 0.5 s to 1 s.
std::string rising_glb(const std::vector<Turn>& turns) {
  nlohmann::json file = person_gltf();
  std::string binary;
  const auto put = [&](double x) {
    binary += word_bytes(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  };
  for (const double time : {0.0, 0.5, 1.0}) put(time);
  file["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 12}});
  file["accessors"].push_back(
      {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "SCALAR"}});
  nlohmann::json animation{{"name", "rise"}};
  for (const auto& [joint, axis, angle_deg] : turns) {
    std::size_t node = 0;
    while (file["nodes"][node].value("name", "") != joint) ++node;
    const std::vector<double> r = file["nodes"][node]["rotation"];
    const Quatd rest{r[0], r[1], r[2], r[3]};
    file["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", 48}});
    for (const Quatd& q : {about(axis, angle_deg) * rest, rest, rest}) {
      for (const double x : {q.x, q.y, q.z, q.w}) put(x);
    }
    const std::size_t count = file["accessors"].size();
    file["accessors"].push_back(
        {{"bufferView", count}, {"componentType", 5126}, {"count", 3}, {"type", "VEC4"}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size()},
                                     {"target", {{"node", node}, {"path", "rotation"}}}});
    animation["samplers"].push_back({{"input", 0}, {"output", count}});
  }
  file["buffers"].push_back({{"byteLength", binary.size()}});
  file["animations"].push_back(animation);
  return glb(file.dump(), binary);
}

Result<CharacterSpec> loaded_glb(std::string bytes, CharacterSpec spec) {
  spec.source = "rising.glb";
  const Result<void> done = load_character(std::move(bytes), spec);
  if (!done) return tl::unexpected(done.error());
  return spec;
}

TEST(StartFrame, OfAnAnimationIsFoundAsOfARecording) {
  const std::string rising = rising_glb({{"left_upper_leg", Axis::x, -80.0}});
  const CharacterSpec spec = loaded_glb(rising, {.animation = "rise"}).value();
  EXPECT_GE(spec.frame.value_or(0), 25);
  EXPECT_THAT(spec.doubts, Contains(HasSubstr("starts from frame")));
  const CharacterSpec again =
      loaded_glb(rising, {.frame = spec.frame, .animation = "rise"}).value();
  EXPECT_EQ(apart(again, spec), 0.0);
  // on request it is used unchanged
  const CharacterSpec lifted = loaded_glb(rising, {.frame = 0, .animation = "rise"}).value();
  EXPECT_GT(lifted.landmarks->left_leg.knee.y, spec.landmarks->left_leg.knee.y + 0.2);
}

TEST(StartFrame, OfAnAnimationInWhichThePersonLiesIsRefused) {
  const auto refused = loaded_glb(rising_glb({{"hips", Axis::x, -90.0}}), {.frame = 0});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("in frame 0 the person lies"));
}

// The start does not depend on nodes of meshes or tools.
TEST(StartFrame, KeysWithoutNumbersCountOfThePersonsBonesAlone) {
  const auto first = [](const char* node) {
    const std::string file = rising_glb({{node, Axis::x, std::nan("")}});
    return loaded_glb(file, {.animation = "rise"}).value().frame.value_or(0);
  };
  EXPECT_EQ(first("right_hand_grip"), 0);
  EXPECT_EQ(first("right_lower_arm"), 30);  // of 0.5 s
  EXPECT_EQ(first("hips"), 30);
}

TEST(StartFrame, StancesThatCannotBeHeldAreTriedAQuarterOfASecondApart) {
  FilmedFigure figure;
  figure.hold({}, (kStartsTried + 2) * 7);
  CharacterSpec spec;
  spec.source = "filmed.bvh";
  CharacterFile file = parse_character(figure.bvh(), spec).value();
  const PersonStart found = find_person(file, spec).value();
  const std::vector<Transformd> world = world_transforms(file.skeleton, found.measured.clip(), 0);
  const Recording recording(file, found.map, found.person, world);
  int tried = 0;
  const auto third = [&](const Landmarks&) { return ++tried == 3; };
  EXPECT_EQ(recording.first_stand(true, third), 2 * 7);
  EXPECT_EQ(recording.first_stand(true, third), std::nullopt);
  EXPECT_EQ(tried, 3 + kStartsTried);
}

class AttachedFrame : public testing::Test {
 protected:
  // Whether a result of these settings finds its start in the file again.
  void expect_found(const FilmedFigure& figure, CharacterSpec spec) {
    const std::string path = folder_.put("filmed.bvh", figure.bvh());
    CharacterSpec measured = loaded(figure.bvh(), spec).value();
    measured.rig = nullptr;
    const Result<void> attached = attach_file(measured, path);
    EXPECT_TRUE(attached) << attached.error().to_string();
  }

  WorkFolder folder_;
};

TEST_F(AttachedFrame, IsTheOneThatTheResultTells) {
  FilmedFigure figure;
  figure.walk(10);
  figure.hold({}, 10);
  expect_found(figure, {});
  FilmedFigure walker;
  walker.walk(10);
  expect_found(walker, {});
  expect_found(walker, {.seat = 0.45});
  FilmedFigure sitter;
  sitter.hold(sitting(), 3);
  expect_found(sitter, {.frame = 1, .seat = 0.42});
}

TEST_F(AttachedFrame, OfAnOlderResultIsTheFirst) {
  FilmedFigure figure;
  figure.walk(10);
  figure.hold({}, 10);
  const std::string path = folder_.put("filmed.bvh", figure.bvh());
  CharacterSpec old = loaded(figure.bvh(), {.frame = 0}).value();
  old.frame = std::nullopt;
  old.rig = nullptr;
  EXPECT_TRUE(attach_file(old, path));
}

}  // namespace
}  // namespace shigusa
