// SPDX-License-Identifier: MIT
// The stream of each output, the same bytes for the same seed, and interrupts of a long search.
#include "app/result_checks.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;
using std::chrono_literals::operator""ms;

class Streams : public testing::Test {
 protected:
  ProgramRun reach(const std::string& out, Words more = {}, RunSettings settings = {}) {
    Words call{"reach", "--goal", "right_hand=-0.2,1.1,0.4", "--out", out};
    call.insert(call.end(), more.begin(), more.end());
    settings.folder = work_.path();
    return run_shigusa(call, settings);
  }

  // All files of a folder; the summary without the time it took.
  std::map<std::string, std::string> bytes(const std::string& folder) {
    const StoredRun stored(work_, folder);
    std::map<std::string, std::string> all;
    for (const std::string& name : stored.files()) all[name] = stored.get(name);
    Json summary = stored.summary();
    summary.erase("elapsed_ms");
    all["summary.json"] = summary.dump();
    return all;
  }

  // Enough for hours.
  const Words long_search_{"--evaluations", "100000000"};
  WorkFolder work_;
};

TEST_F(Streams, SameSeedSameBytes) {
  const Words settings{"--seed", "7", "--formats", "bvh,csv,svg,png,pdf"};
  ASSERT_EQ(reach("one", settings).exit_code, 0);
  ASSERT_EQ(reach("two", settings).exit_code, 0);
  EXPECT_EQ(bytes("one"), bytes("two"));
  EXPECT_GE(bytes("one").size(), 6u);
}

TEST_F(Streams, LargestSeedIsKeptExactly) {
  ASSERT_EQ(reach("one", {"--seed", "18446744073709551615"}).exit_code, 0);
  EXPECT_EQ(StoredRun(work_, "one").summary().at("seed"), UINT64_MAX);
}

TEST_F(Streams, JsonIsTheSummaryOfTheFolder) {
  const ProgramRun reached = reach("one", {"--json"});
  EXPECT_EQ(reached.out, work_.get("one/summary.json"));
  const ProgramRun edited = run_shigusa({"edit", "one", "--json"}, {.folder = work_.path()});
  EXPECT_EQ(edited.out, work_.get("one/edit-1/summary.json"));
}

TEST_F(Streams, ResultsGoToStdoutAndNothingElseDoes) {
  const ProgramRun run = reach("one", {"--candidates", "1"});
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out,
              testing::StartsWith("reached: human, right hand to 0.2 m right, 1.1 m up, 0.4 m "
                                  "ahead\n"));
  EXPECT_THAT(run.out, HasSubstr("one/candidate-1.svg\n"));
  EXPECT_THAT(run.out, testing::EndsWith("one/summary.json\n"));
}

TEST_F(Streams, TableNamesOnlyPicturesOfThisRun) {
  ASSERT_EQ(reach("one").exit_code, 0);
  EXPECT_THAT(reach("one", {"--formats", "bvh"}).out, Not(HasSubstr(".svg")));
  const std::string both = reach("one", {"--formats", "svg,png"}).out;
  EXPECT_THAT(both, AllOf(HasSubstr("one/candidate-1.png\n"), Not(HasSubstr(".svg"))));
}

TEST_F(Streams, MessagesGoToStderr) {
  const ProgramRun run = run_shigusa(
      {"reach", "--goal", "right_hand=0,4,0", "--json", "--out", "far"}, {.folder = work_.path()});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("out of reach"));
  EXPECT_EQ(Json::parse(run.out).at("status"), "unreachable");
}

TEST_F(Streams, NoColoursAndNoProgressWhereNobodyLooks) {
  const ProgramRun run = reach("one", {"--evaluations", "4000"});
  EXPECT_THAT(run.out + run.err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(run.out + run.err, Not(HasSubstr("\r")));
}

TEST_F(Streams, ProgressIsShownOnATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminals here: /dev/pts is not mounted";
  const ProgramRun run = reach("one", long_search_, {.terminal = true, .interrupt_after = 800ms});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr(" motions, best score "));
  // the line is removed before any other output
  const std::size_t last = run.err.rfind(" motions, best score ");
  EXPECT_THAT(run.err.substr(last), HasSubstr("\r\x1b[K"));
}

TEST_F(Streams, InterruptedSearchGivesTheBestSoFar) {
  const auto start = std::chrono::steady_clock::now();
  const ProgramRun run = reach("one", long_search_, {.interrupt_after = 500ms});
  // a generation and the writing of eight candidates; a sanitizer on a busy machine takes long
  EXPECT_LT(std::chrono::steady_clock::now() - start, 30'000ms);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("stopped early"));
  const StoredRun stored(work_, "one");
  EXPECT_EQ(stored.summary().at("search_detail").at("end"), "cancelled");
  EXPECT_GE(stored.summary().at("evaluations").get<int>(), 8);
  expect_promises_kept(stored);
}

// Commands that print, each as called in a shell.
std::vector<std::string> printing_calls() {
  std::vector<std::string> calls;
  for (const char* arguments :
       {"body half_body", "body human --json", "--help", "reach --help", "--version",
        "reach --goal right_hand=-0.2,1.1,0.4 --out one", "edit result", "edit result --json",
        "mirror result", "render clip.bvh", "score clip.bvh", "score clip.bvh --json", "schema"}) {
    calls.push_back("'" + shigusa_program() + "' " + arguments);
  }
  return calls;
}

class Outputs : public Streams {
 protected:
  void SetUp() override {
    ASSERT_EQ(reach("result", {"--candidates", "1"}).exit_code, 0);
    work_.put("clip.bvh", work_.get("result/candidate-1.bvh"));
  }

  // The exit code of a call by the shell.
  int shell(const std::string& call) {
    const std::string in_folder = "cd '" + work_.path().string() + "' && " + call;
    const int status = std::system(in_folder.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
};

TEST_F(Outputs, AFullDiskBehindStdoutIsToldByTheExitCode) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  for (const std::string& call : printing_calls()) {
    EXPECT_EQ(shell(call + " >/dev/full 2>messages"), 2) << call;
    EXPECT_THAT(work_.get("messages"), HasSubstr("cannot write to the standard output")) << call;
    EXPECT_THAT(work_.get("messages"), Not(HasSubstr("internal fault"))) << call;
  }
}

TEST_F(Outputs, AClosedStdoutIsToldByTheExitCode) {
  for (const std::string& call : printing_calls()) {
    EXPECT_EQ(shell(call + " <&- >&- 2>messages"), 2) << call;
    EXPECT_THAT(work_.get("messages"), HasSubstr("cannot write to the standard output")) << call;
  }
}

TEST_F(Outputs, ClosedStreamsLeaveExitCodesAndFilesAsTheyAre) {
  const std::string reach = printing_calls()[5];
  EXPECT_EQ(shell(reach + " >said <&- 2>&-"), 0);
  EXPECT_THAT(work_.get("said"), testing::StartsWith("reached: human"));
  const auto with_streams = bytes("one");
  EXPECT_EQ(shell(reach + " <&- >&- 2>&-"), 2);
  EXPECT_EQ(bytes("one"), with_streams);
  EXPECT_EQ(shell("'" + shigusa_program() + "' body nobody.bvh <&- >&- 2>&-"), 2);
}

}  // namespace
}  // namespace shigusa
