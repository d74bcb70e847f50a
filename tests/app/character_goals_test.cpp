// SPDX-License-Identifier: MIT
// Goals for joints of characters from files: the file's own nodes arrive, even if their positions
// differ from the body's.
#include <fmt/format.h>

#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Words = std::vector<std::string>;

class CharacterGoals : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::string shared = SHIGUSA_SHARED_DIR;
    file_ = std::filesystem::path(shared) / "characters" / GetParam();
    if (shared.empty() || !std::filesystem::exists(file_)) GTEST_SKIP() << "no " << file_;
  }

  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }

  // where goals for the effector begin
  Vec3d start(const std::string& effector) {
    const ProgramRun told = run({"body", file_.string(), "--extent", "human", "--json"});
    const Json body = Json::parse(told.out);
    for (const Json& place : body.at("places")) {
      if (place.at("effector") == effector) return to_vec(place.at("start_m"));
    }
    ADD_FAILURE() << "no place of " << effector;
    return {};
  }

  std::filesystem::path file_;
  WorkFolder work_;
};

TEST_P(CharacterGoals, NodesOfTheFileArrive) {
  const std::pair<const char*, Vec3d> ways[] = {{"hips", {0.0, -0.05, -0.02}},
                                                {"chest", {0.01, -0.04, 0.02}},
                                                {"head", {0.0, -0.06, 0.03}},
                                                {"left_elbow", {0.03, 0.04, 0.04}},
                                                {"left_foot", {0.0, 0.0, 0.08}}};
  for (const auto& [effector, way] : ways) {
    const Vec3d goal = start(effector) + way;
    const ProgramRun done =
        run({"reach", "--character", file_.string(), "--extent", "human", "--formats", "bvh",
             "--evaluations", "60", "--candidates", "1", "--goal",
             fmt::format("{}={},{},{}", effector, goal.x, goal.y, goal.z)});
    EXPECT_THAT(done.exit_code, delivered()) << effector << ": " << done.err;
    expect_promises_kept(StoredRun(work_, "out"));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, CharacterGoals,
                         testing::Values("lab0_CesiumMan.glb", "pybvh__bvh_test1.bvh",
                                         "blender-cli-rendering__102_01.bvh"),
                         [](const auto& of) {
                           std::string name;
                           for (const char c : of.param) name += std::isalnum(c) ? c : '_';
                           return name;
                         });

}  // namespace
}  // namespace shigusa
