// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/gltf_file.hpp"
#include "support/person_file.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using Words = std::vector<std::string>;
using Json = nlohmann::ordered_json;

class ScoreCommand : public testing::Test {
 protected:
  ScoreCommand() { work_.put("person.bvh", person_bvh()); }

  ProgramRun score(Words arguments) {
    arguments.insert(arguments.begin(), "score");
    return run_shigusa(arguments, {.folder = work_.path()});
  }

  WorkFolder work_;
};

TEST_F(ScoreCommand, PrintsATableWithTheCriteria) {
  const ProgramRun run = score({"person.bvh", "--criteria", "paper"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* name : {"joint_range", "balance", "torque", "right_foot moves by up to 0.00"}) {
    EXPECT_THAT(run.out, HasSubstr(name));
  }
}

// A character's motion has the same score in each written format.
TEST_F(ScoreCommand, AnAnimatedCharacterScoresAsItsSummaryHasIt) {
  work_.put("person.gltf", person_gltf().dump());
  const ProgramRun made =
      run_shigusa({"reach", "--character", "person.gltf", "--goal", "right_hand=-0.1,0.5,0.4",
                   "--formats", "glb,bvh", "--evaluations", "100", "--candidates", "1", "--json",
                   "--duration", "1.5"},  // in haste jolts depend on the rate
                  {.folder = work_.path()});
  const Json candidate = Json::parse(made.out).at("candidates").at(0);
  const double total = candidate.at("score");
  for (const Words& clip : {Words{"out/candidate-1.bvh"},
                            Words{"out/candidate-1.glb", "--animation", "shigusa candidate 1"}}) {
    Words call = clip;
    call.insert(call.end(), {"--smooth", "0", "--json"});
    const ProgramRun run = score(call);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json.at("frames"), Json({0, candidate.at("file_frames").get<int>() - 1}));
    for (const auto& [name, penalty] : candidate.at("criteria").items()) {
      EXPECT_TRUE(json.at("criteria").contains(name)) << name;
    }
    EXPECT_NEAR(json.at("score").get<double>(), total, 0.15 * total + 0.03) << clip.front();
    // a GLB's numbers are single precision
    EXPECT_LT(json.at("follows").at("worst_mm").get<double>(), 0.1) << clip.front();
  }
  EXPECT_THAT(score({"out/candidate-1.glb", "--animation", "jump"}).err,
              HasSubstr("no animation 'jump'; it has 'shigusa candidate 1'"));
}

}  // namespace
}  // namespace shigusa
