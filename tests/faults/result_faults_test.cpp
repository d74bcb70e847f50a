// SPDX-License-Identifier: MIT
// However a program ends while it writes a result, its folder has no summary, or one with its own
// complete files; and the next run works.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <set>
#include <shigusa/files.hpp>
#include <thread>

#include "document/result_folder.hpp"
#include "faults/system_calls.hpp"
#include "files/sha256.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

// A result to be written, with `candidates` motions in these formats.
struct Written {
  TaskFile file;
  Task task;
  GenerateResult generation;
  ExportSettings settings;

  Written(const Vec3d& goal, std::size_t candidates, const std::string& formats)
      : file(asked(goal)),
        task(of_one_thread(make_task(file, {}).value())),
        generation(regenerate(task, uniform_parameters(task.body)).value()),
        settings{.formats = parse_formats(formats).value()} {
    generation.candidates.resize(candidates, generation.candidates[0]);
  }

  // The tests fork: a child has none of its parent's threads, and would wait for them.
  static Task of_one_thread(Task task) {
    task.batch.threads = 1;
    return task;
  }

  [[nodiscard]] Result<WrittenResult> write(const fs::path& folder) const {
    return write_result(folder, {file, task, generation}, settings);
  }

  static TaskFile asked(const Vec3d& goal) {
    TaskFile task;
    task.character.source = "half_body";
    task.goals = {{"right_hand", goal}};
    return task;
  }
};

class ResultFaults : public testing::Test {
 protected:
  ResultFaults() {
    fs::create_directory(folder_);
    work_.put("result/mine.txt", "mine");
  }

  // Names in the folder, but for the user's own file.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      all.insert(entry.path().filename().string());
    }
    EXPECT_EQ(all.erase("mine.txt"), 1u);
    return all;
  }

  // The summary's text, "" where there is none; where there is one, all that it describes must be
  // there and be so.
  [[nodiscard]] std::string whole() const {
    if (!fs::exists(folder_ / kSummaryName)) return {};
    const std::string text = work_.get("result/summary.json");
    const auto stored = parse_result(text, "summary.json");
    EXPECT_TRUE(stored);
    if (!stored) return "broken";
    for (const CandidateFiles& files : stored->files) {
      EXPECT_FALSE(files.empty());
      for (const auto& [format, file] : files) {
        const auto bytes = read_text_file(folder_ / file.name, std::size_t{1} << 24);
        EXPECT_TRUE(bytes) << file.name;
        EXPECT_EQ(sha256(bytes.value_or("")), file.sha256) << file.name;
      }
    }
    return text;
  }

  // Writes in a process of its own, in which that call meets the fault; false where the run made
  // fewer calls. The outcome stands in `code`: 0 written, 1 refused, -1 killed.
  bool write_with(const Written& run, Fault fault, int call, int& code) const {
    const pid_t child = fork();
    if (child == 0) {
      arm(fault, call);
      const bool written = run.write(folder_).has_value();
      const bool reached = calls_made() >= call;
      arm(Fault::none, 0);
      _exit((written ? 0 : 1) + (reached ? 0 : 2));
    }
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    code = WIFEXITED(status) ? WEXITSTATUS(status) & 1 : -1;
    return !WIFEXITED(status) || (WEXITSTATUS(status) & 2) == 0;
  }

  // Meets the fault at every call of a run in turn, and the next run has no fault.
  void expect_whole_after(Fault fault, bool older) {
    const std::string wanted = newer_.write(folder_).value().summary;
    const std::set<std::string> names_wanted = names();
    int call = 1;
    for (int code = 0;; ++call) {
      for (const std::string& name : names()) fs::remove_all(folder_ / name);
      const std::string before = older ? older_.write(folder_).value().summary : std::string();
      const bool met = write_with(newer_, fault, call, code);
      const std::string after = whole();
      EXPECT_TRUE(after.empty() || after == before || after == wanted) << call;
      if (fault == Fault::disk_full && met) {
        EXPECT_EQ(code, 1) << "told, at call " << call;
        for (const std::string& name : names()) EXPECT_FALSE(name.starts_with(".shigusa")) << name;
      }
      EXPECT_EQ(newer_.write(folder_).value().summary, wanted) << call;
      EXPECT_EQ(whole(), wanted) << call;
      EXPECT_EQ(names(), names_wanted) << call;
      if (!met) break;
    }
    // three calls a file at least: it is made, written and settled
    EXPECT_GT(call, 3 * 5);
  }

  WorkFolder work_;
  fs::path folder_ = work_ / "result";
  const Written older_{{0.25, 0.55, 0.5}, 3, "bvh,csv"};
  const Written newer_{{0.25, 0.65, 0.5}, 2, "bvh,svg"};
};

TEST_F(ResultFaults, KilledBeforeAnyCallOfAFirstRun) {
  expect_whole_after(Fault::killed_before, false);
}
TEST_F(ResultFaults, KilledBeforeAnyCallOverAnOlderResult) {
  expect_whole_after(Fault::killed_before, true);
}
TEST_F(ResultFaults, KilledAfterAnyCallOverAnOlderResult) {
  expect_whole_after(Fault::killed_after, true);
}
TEST_F(ResultFaults, AFullDiskAtAnyCallOfAFirstRun) { expect_whole_after(Fault::disk_full, false); }
TEST_F(ResultFaults, AFullDiskAtAnyCallOverAnOlderResult) {
  expect_whole_after(Fault::disk_full, true);
}

// New files are written beside the older ones, which stay untouched until all are on the disk.
TEST_F(ResultFaults, AFullDiskLeavesTheOlderResultWhole) {
  const std::string before = older_.write(folder_).value().summary;
  const std::set<std::string> names_before = names();
  int code = 0;
  for (int call = 1; call <= 3 * 5; ++call) {
    ASSERT_TRUE(write_with(newer_, Fault::disk_full, call, code));
    EXPECT_EQ(whole(), before) << call;
    EXPECT_EQ(names(), names_before) << call;
  }
}

TEST_F(ResultFaults, ProgramsThatWriteAtOnceTakeTurns) {
  constexpr int kTimes = 20;
  const std::string one = older_.write(folder_).value().summary;
  const std::string other = newer_.write(folder_).value().summary;
  std::vector<pid_t> children;
  for (const Written* run : {&older_, &newer_, &older_}) {
    children.push_back(fork());
    if (children.back() != 0) continue;
    for (int i = 0; i < kTimes; ++i) {
      if (!run->write(folder_)) _exit(1);
    }
    _exit(0);
  }
  // a concurrent reader finds one of them complete, and never a file of the other
  int running = static_cast<int>(children.size());
  while (running > 0) {
    const auto read = read_result(folder_, 1);
    EXPECT_TRUE(read) << read.error().to_string();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    int status = 0;
    while (waitpid(-1, &status, WNOHANG) > 0) {
      EXPECT_EQ(status, 0);
      --running;
    }
  }
  const std::string last = whole();
  EXPECT_TRUE(last == one || last == other);
  const std::size_t files = last == one ? 3 * 2 + 1 : 2 * 2 + 1;
  EXPECT_EQ(names().size(), files);
}

TEST_F(ResultFaults, AProgramThatHangsIsNotWaitedForForEver) {
  const Descriptor hangs = open_folder(folder_);
  const Descriptor ours = open_folder(folder_);
  ASSERT_TRUE(lock_folder(hangs, LockKind::alone, folder_));
  const auto refused = lock_folder(ours, LockKind::alone, folder_, std::chrono::milliseconds(30));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.text.find("another program"), std::string::npos);
}

}  // namespace
}  // namespace shigusa
