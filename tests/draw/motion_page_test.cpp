// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <shigusa/draw.hpp>

#include "document/result_sample.hpp"
#include "draw/candidate_strip.hpp"
#include "draw/page_figures.hpp"
#include "draw/strip_figure_body.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "support/work.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

const ResultSample& sample(const std::string& body = "human") {
  const auto make = [](const std::string& source) {
    TaskFile file;
    file.character.source = source;
    file.goals = {{"right_hand", {-0.2, 1.1, 0.4}}};
    file.evaluations = 100;
    file.obstacles = {{.name = "table", .position = {0.0, 0.2, 0.8}, .size = {1.0, 0.4, 0.4}}};
    return ResultSample(file);
  };
  static const ResultSample human = make("human");
  static const ResultSample half = make("half_body");
  return body == "human" ? human : half;
}

// The numbers of a code, decoded anew from the description in page_figures.hpp.
std::vector<std::vector<int>> decoded(const std::string& code, std::size_t poses) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<int> numbers;
  int value = 0;
  int shift = 0;
  for (const char c : code) {
    const int digit = static_cast<int>(digits.find(c));
    value |= (digit & 31) << shift;
    shift += 5;
    if ((digit & 32) != 0) continue;
    numbers.push_back((value & 1) != 0 ? -(value >> 1) : value >> 1);
    value = shift = 0;
  }
  EXPECT_EQ(numbers.size() % poses, 0u);
  std::vector<std::vector<int>> series;
  for (std::size_t at = 0; at < numbers.size(); at += poses) {
    std::vector<int> places{numbers[at]};
    int growth = 0;
    for (std::size_t k = 1; k < poses; ++k) {
      growth += numbers[at + k];
      places.push_back(places.back() + growth);
    }
    series.push_back(places);
  }
  return series;
}

// Within half a millimetre along each axis, the page's rounding.
TEST(PageFigures, PointsAreWhereTheFigureHasThem) {
  for (const char* body : {"human", "half_body"}) {
    const ResultSample& made = sample(body);
    const Json json = Json::parse(page_figures(made.task, made.generation));
    const Candidate& candidate = made.generation.candidates.back();
    const Json& motion = json.at("motions").back();
    const std::size_t poses = motion.at("poses");
    ASSERT_EQ(poses, static_cast<std::size_t>(candidate.motion.clip.frames));
    const auto series = decoded(motion.at("code"), poses);
    const SkeletonMotion moves = skeleton_motion(made.task.body, candidate.motion.clip);
    const strip::FigureBody figure(moves.skeleton, strip_settings(made.task, candidate),
                                   {{0, 1, 0}, {0, 0, 1}});
    for (std::size_t pose = 0; pose < poses; pose += 7) {
      const auto parts = figure.parts(
          world_transforms(moves.skeleton, moves.clip, static_cast<int>(pose)), figure.stature());
      ASSERT_EQ(parts.size(), json.at("parts").size());
      for (std::size_t p = 0; p < parts.size(); ++p) {
        for (std::size_t b = 0; b < parts[p].balls.size(); ++b) {
          const std::size_t point = json.at("parts")[p].at(3).at(b).at(0);
          for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(series.at(3 * point + static_cast<std::size_t>(axis))[pose],
                        1e3 * parts[p].balls[b].centre[axis], 0.5 + 1e-6);
          }
        }
      }
      const std::size_t hand = json.at("paths").at(0);
      EXPECT_NEAR(series.at(3 * hand)[pose], 1e3 * candidate.motion.effectors[0][pose].x,
                  0.5 + 1e-6);
    }
  }
}

TEST(PageFigures, MotionsOfManyFramesAreThinnedOut) {
  ResultSample made = sample();
  Candidate& candidate = made.generation.candidates.front();
  made.generation.candidates.resize(1);
  candidate.motion.clip = resampled(candidate.motion.clip, 120.0);
  const auto frames = static_cast<std::size_t>(candidate.motion.clip.frames);
  ASSERT_GT(frames, static_cast<std::size_t>(kPagePoses));
  candidate.motion.effectors[0].resize(frames, candidate.motion.effectors[0].back());
  const Json motion = Json::parse(page_figures(made.task, made.generation)).at("motions").at(0);
  EXPECT_EQ(motion.at("poses"), kPagePoses);
}

TEST(PageFigures, GoalsFeetAndObstaclesAreInMillimetres) {
  const ResultSample& made = sample();
  const Json json = Json::parse(page_figures(made.task, made.generation));
  EXPECT_EQ(json.at("goals"), Json::parse("[[-200,1100,400]]"));
  EXPECT_EQ(json.at("soles").size(), 2u);
  for (const Json& corner : json.at("soles").at(0)) EXPECT_LE(std::abs(corner.at(1).get<int>()), 1);
  EXPECT_EQ(json.at("boxes").at(0).size(), 9u);
  EXPECT_EQ(json.at("boxes").at(0).at(0), Json::parse("[-500,0,600]"));
}

TEST(MotionPage, TellsWhatWasAskedAndWhatCameOfIt) {
  const ResultSample& made = sample();
  const std::vector<ShownResult> shown{{made.task, made.generation}};
  const std::string page = motion_page(shown, "All").value();
  EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("<h1>All</h1>"));
  EXPECT_THAT(page, HasSubstr("right hand to 0.2 m right, 1.1 m up, 0.4 m ahead"));
  EXPECT_THAT(page, HasSubstr("In the way: table."));
  for (const Candidate& candidate : made.generation.candidates) {
    EXPECT_THAT(page, HasSubstr(posture_words(candidate.final_posture).substr(1)));
  }
  EXPECT_EQ(page, motion_page(shown, "All").value());
}

TEST(MotionPage, OfNothingIsAPageToo) {
  EXPECT_THAT(motion_page({}).value(), HasSubstr("<h1>Motions by shigusa</h1>"));
}

TEST(MotionPage, DrawsFiguresWhereTheyAreTold) {
  if (std::system("command -v node > /dev/null") != 0) GTEST_SKIP() << "no Node.js here";
  const WorkFolder folder;
  folder.put("page.html", motion_page({}).value());
  const std::string page = (folder / "page.html").string();
  EXPECT_EQ(
      std::system(
          ("node '" SHIGUSA_SOURCE_DIR "/tests/draw/page_script.mjs' '" + page + "'").c_str()),
      0);
}

// Things are where the candidate has them, within the page's rounding and a step between poses.
TEST(PageFigures, ThingsGoWithTheirMotions) {
  const Work& work = box_work();
  const Json json = Json::parse(page_figures(work.task, work.generation));
  ASSERT_EQ(json.at("things").size(), 2u);
  EXPECT_EQ(json.at("things").at(1).at(0), 40);
  EXPECT_TRUE(json.at("paths").empty());
  for (std::size_t k = 0; k < work.generation.candidates.size(); ++k) {
    const Candidate& candidate = work.generation.candidates[k];
    const Json& motion = json.at("motions").at(k);
    EXPECT_EQ(motion.at("actions").size(), 2u);
    EXPECT_EQ(motion.at("actions").at(0).at(0), "grasp");
    const std::size_t poses = motion.at("poses");
    const auto series = decoded(motion.at("code"), poses);
    for (std::size_t pose = 0; pose < poses; ++pose) {
      Vec3d middle{};
      for (const std::size_t point : json.at("things").at(0).at(1)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          middle[static_cast<int>(axis)] += series.at(3 * point + axis)[pose] / 8.0;
        }
      }
      const double time = json.at("seconds").get<double>() * static_cast<double>(pose) /
                          static_cast<double>(poses - 1);
      const double frame =
          min(time, candidate.motion.clip.duration()) / candidate.motion.clip.frame_time;
      EXPECT_LE(norm(middle - pose_at(candidate.things[0], frame).translation * 1e3), 1.0);
    }
  }
}

TEST(MotionPage, OfAPieceOfWorkMovesThingsAndTellsTheAction) {
  const Work& work = box_work();
  const std::vector<ShownResult> shown{{work.task, work.generation}};
  const std::string page = motion_page(shown).value();
  EXPECT_THAT(page, HasSubstr("Grasp the box, place the box</h2>"));
  EXPECT_THAT(page, HasSubstr("place the box at 0.9 m up, 0.45 m ahead"));
  EXPECT_THAT(page, HasSubstr("</canvas><p class=\"label\">grasp</p>"));
  EXPECT_THAT(motion_page({}).value(), testing::Not(HasSubstr("actionAt")));
  if (std::system("command -v node > /dev/null") != 0) GTEST_SKIP() << "no Node.js here";
  const WorkFolder folder;
  folder.put("page.html", page);
  const std::string file = (folder / "page.html").string();
  EXPECT_EQ(std::system(
                ("node '" SHIGUSA_SOURCE_DIR "/tests/draw/page_work.mjs' '" + file + "'").c_str()),
            0);
}

TEST(MotionPage, MoreCandidatesThanItShowsAreRefused) {
  ResultSample made = sample();
  made.generation.candidates.resize(1);
  made.generation.candidates.resize(kPageMostCandidates + 1, made.generation.candidates[0]);
  const std::vector<ShownResult> shown{{made.task, made.generation}};
  const auto refused = motion_page(shown);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("2001 candidates; up to 2000 are allowed"));
}

TEST(MotionPage, StripsHaveTheTitlesAsCaptions) {
  const ResultSample& made = sample();
  const std::vector<ShownResult> shown{{made.task, made.generation, "The first"},
                                       {made.task, made.generation}};
  const std::string picture = result_strips(shown).value();
  EXPECT_THAT(picture, HasSubstr("<svg"));
  EXPECT_NE(picture, result_strips(std::span(shown).first(1)).value());
}

}  // namespace
}  // namespace shigusa
