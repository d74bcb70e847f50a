// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/result.hpp>
#include <shigusa/task_file.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The version of the format that is written.
inline constexpr int kResultVersion = 1;
/// A larger file is refused.
inline constexpr std::size_t kResultMaxBytes = std::size_t{64} << 20;
/// A result of more candidates is refused.
inline constexpr std::size_t kResultMaxCandidates = 1000;
/// The name of a result's own file in its folder.
inline constexpr const char* kSummaryName = "summary.json";

/// Facts about a run that stand in a result beside the motions; none of them changes a motion.
struct RunInfo {
  double elapsed_ms = 0.0;          ///< of the search
  int threads = 1;                  ///< that it had
  std::string simd = "scalar";      ///< name of its SIMD set
  std::string search = "paper_ga";  ///< "edit" where parameters were given instead of searched
};

/// The facts of a search of the task that began then and has just ended.
[[nodiscard]] RunInfo search_info(const Task& task, std::chrono::steady_clock::time_point begin);
/// The facts of a run from given parameters; `how` stands in the place of the search.
[[nodiscard]] RunInfo replay_info(std::string how, std::chrono::steady_clock::time_point begin);

/// The run of a task, which a result is written of. Borrows everything except the facts.
struct FinishedRun {
  const TaskFile& file;              ///< the task as its file has it
  const Task& task;                  ///< make_task of that file
  const GenerateResult& generation;  ///< the motions
  RunInfo info{};                    ///< facts beside them
};

/// How far a written file's nodes are from the motion, as they were read back: the most in any
/// frame.
struct ReadBack {
  double effector = 0.0;  ///< m, of goals' nodes
  double feet = 0.0;      ///< m, of planted feet's nodes
  double turn = 0.0;      ///< rad, of planted feet, and of effectors whose goal says how they turn
  Message off{};  ///< what is off by more than the format's digits explain; empty: nothing is
};

/// The task's file with the duration that its motions have, where they were slowed down.
[[nodiscard]] TaskFile played_task(TaskFile file, const GenerateResult& generation);

/// A file of a candidate.
struct CandidateFile {
  std::string name;                     ///< in the result's folder: "candidate-1.bvh"
  std::string sha256{};                 ///< of its bytes, 64 hexadecimal digits
  std::optional<ReadBack> read_back{};  ///< of those that hold the motion of nodes
};
/// By format: "bvh".
using CandidateFiles = std::map<std::string, CandidateFile>;

/// The files that are written beside a result.
struct ResultFiles {
  double rate = kUsualRate;                  ///< Hz, of BVH, GLB and VRMA
  std::vector<CandidateFiles> candidates{};  ///< one for each, or none where nothing is written
  std::string character{};  ///< the character's file, from the result's folder; empty: not known
  std::vector<Message> notes{};  ///< files that could not be written, and those a little off
};

/// The result as JSON text, the object of summary.json; docs/result.schema.json is its schema. The
/// task stands in it with the measured character, so that the result can be edited without any
/// other file.
[[nodiscard]] std::string format_result(const FinishedRun& run, const ResultFiles& files = {});

/// A result as read back: enough to generate its motions again and to edit them.
struct StoredResult {
  TaskFile task;                        ///< that it is the result of
  std::vector<Parameters> candidates;   ///< in rank order
  std::vector<CandidateFiles> files{};  ///< of each candidate, without ReadBack
  std::string character{};              ///< as ResultFiles has it
  double rate = kUsualRate;             ///< Hz, as ResultFiles has it
};

/// Parses a result. Errors name the place, the value seen and what is allowed.
[[nodiscard]] Result<StoredResult> parse_result(std::string_view text, std::string_view name);
/// Reads a result: summary.json itself, or the folder that holds it. Fails where a file of that
/// candidate (from 1; 0: of none) is there and is not the one that the summary describes; one that
/// is not there is no failure.
[[nodiscard]] Result<StoredResult> read_result(const std::filesystem::path& path,
                                               int candidate = 0);

}  // namespace shigusa
