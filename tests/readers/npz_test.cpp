// SPDX-License-Identifier: MIT
// Arrays for controllers of robots as numpy reads them.
#include <fmt/format.h>

#include <cstdlib>

#include "app/result_checks.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

TEST(NpzReaders, NumpyFindsDerivativesAndTheTorquesOfTheCsv) {
  constexpr const char* kPython = "/usr/bin/python3";
  const WorkFolder work;
  const auto runs = [&](const std::string& command) {
    const std::string folder = work.path().string();
    return std::system(fmt::format("cd '{}' && {} > said 2>&1", folder, command).c_str()) == 0;
  };
  if (!runs(fmt::format("{} -c 'import numpy'", kPython))) {
    GTEST_SKIP() << "no numpy: apt-get install python3-numpy";
  }
  work.put("small.urdf", RobotFile().text());
  const struct {
    std::vector<std::string> call;
    const char* more;
    const char* said;
  } motions[]{
      {{"--goal", "right_hand=-0.2,0.5,0.4"}, "hips", "50.0 "},
      {{"--goal", "right_hand=-0.2,0.4,0.35", "--character", "small.urdf", "--fps", "120"},
       "pelvis out/candidate-1.csv",
       "120.0 "},
  };
  for (const auto& [call, more, said] : motions) {
    std::vector<std::string> words{"reach", "--formats", "npz,csv", "--evaluations", "200"};
    words.insert(words.end(), call.begin(), call.end());
    const ProgramRun run = run_shigusa(words, {.folder = work.path()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(runs(fmt::format("{} '{}/tests/readers/read_npz.py' out/candidate-1.npz {}",
                                 kPython, SHIGUSA_SOURCE_DIR, more)))
        << work.get("said");
    EXPECT_THAT(work.get("said"), testing::StartsWith(said));
    // an edit keeps the rate
    ASSERT_EQ(run_shigusa({"edit", "out", "--out", "edited"}, {.folder = work.path()}).exit_code,
              0);
    EXPECT_EQ(work.get("edited/candidate-1.npz"), work.get("out/candidate-1.npz"));
    EXPECT_EQ(work.get("edited/candidate-1.csv"), work.get("out/candidate-1.csv"));
  }
}

}  // namespace
}  // namespace shigusa
