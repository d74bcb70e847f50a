// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <shigusa/core/result.hpp>
#include <shigusa/document/task_file.hpp>
#include <shigusa/generate/generator.hpp>
#include <shigusa/motion/clip.hpp>
#include <shigusa/rollout/parameters.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// The version of the format that is written.
inline constexpr int kResultVersion = 1;
// A larger file is refused.
inline constexpr std::size_t kResultMaxBytes = std::size_t{64} << 20;
// A result of more candidates is refused.
inline constexpr std::size_t kResultMaxCandidates = 1000;
// The name of a result's own file in its folder.
inline constexpr const char* kSummaryName = "summary.json";

// Facts about a run, which a result tells beside the motions; none of them changes a motion.
struct RunInfo {
  double elapsed_ms = 0.0;          // of the search
  int threads = 1;                  // that it had
  std::string simd = "scalar";      // name of its SIMD set
  std::string search = "paper_ga";  // "edit" where parameters were given instead of searched
};

// How far a written file's nodes are from the motion, as they were read back: the most in any
// frame.
struct ReadBack {
  double effector = 0.0;  // m, of goals' nodes
  double feet = 0.0;      // m, of planted feet's nodes
  double turn = 0.0;      // rad, of planted feet, and of effectors whose goal says how they turn
};

// The same of a task's file.
[[nodiscard]] TaskFile played_task(TaskFile file, const Generation& generation);

// A file of a candidate.
struct CandidateFile {
  std::string name;                     // in the result's folder: "candidate-1.bvh"
  std::string sha256{};                 // of its bytes, 64 hexadecimal digits
  std::optional<ReadBack> read_back{};  // of those that hold the motion of nodes
};
// By format: "bvh".
using CandidateFiles = std::map<std::string, CandidateFile>;

// The files that are written beside a result.
struct ResultFiles {
  double rate = kUsualRate;                  // Hz, of BVH, GLB and VRMA
  std::vector<CandidateFiles> candidates{};  // one for each, or none where nothing is written
  std::string character{};  // the character's file, from the result's folder; empty: not known
};

// The result as JSON text, the object of summary.json; docs/result.schema.json is its schema. The
// task stands in it with the measured character, so that the result can be edited without any
// other file.
[[nodiscard]] std::string format_result(const TaskFile& file, const Task& task,
                                        const Generation& generation, const RunInfo& info,
                                        const ResultFiles& files = {});

// A result as read back: enough to generate its motions again and to edit them.
struct StoredResult {
  TaskFile task;                       // that it is the result of
  std::vector<Parameters> candidates;  // in rank order
  std::vector<LayeredParameters>
      layered;                          // the same of layered presets, whose `candidates` are none
  std::vector<CandidateFiles> files{};  // of each candidate; what was read back is not kept
  std::string character{};              // as ResultFiles has it
  double rate = kUsualRate;             // Hz, as ResultFiles has it
};

// Parses a result. Errors name the place, the value seen and what is allowed.
[[nodiscard]] Result<StoredResult> parse_result(std::string_view text, std::string_view name);
// Reads a result: summary.json itself, or the folder that holds it. Fails where a file of that
// candidate (from 1; 0: of none) is there and is not the one that the summary describes; one that
// is not there is no failure.
[[nodiscard]] Result<StoredResult> read_result(const std::filesystem::path& path,
                                               int candidate = 0);

// Changes parameters by an assignment as a person writes it:
//   right_shoulder.flexion.weight=12    the weight of one freedom
//   right_shoulder.weight=12            of all freedoms of a joint
//   right_knee.flexion.locked=true      lock (or false: free) a freedom or a joint
//   squat_deg=60, lean_rad=0.5          the value of a posture mode, in degrees or radians
//   delay=0.1, bow=0.15, skew=0.3, sway=0.1      see PostureParameters
//   later.right_knee.weight=3, later.squat_deg=30, switch=0.6   the same of the second phase, and
//                                       when it begins; where there is none, it begins as the first
// Fails on an unknown name (the nearest is suggested), or a value that is not allowed.
[[nodiscard]] Result<void> assign_parameter(const BodyModel& body, std::string_view assignment,
                                            Parameters& parameters);
// The same, and notes what was set; `fixed` begins as no_fixed_parameters.
[[nodiscard]] Result<void> fix_parameter(const BodyModel& body, std::string_view assignment,
                                         FixedParameters& fixed);

// One layer of a hierarchy.
struct Layer;

// The same of layered parameters, whose `layers` are those to the goals:
//   right_hip.flexion.weight=12, right_hip.weight=12, right_hip.locked=true   of the upper layer
//   legs.contraction=8                      0..15: how much shorter the legs end
//   right_arm.right_elbow.flexion.weight=3  of the layer below that moves the arm
//   right_arm.swivel_deg=20                 where that layer swivels it: the elbow, outwards
//   left_elbow.final_deg=40                 where no goal moves a limb: the angle it ends at
[[nodiscard]] Result<void> assign_parameter(std::span<const Layer> layers,
                                            std::string_view assignment,
                                            LayeredParameters& parameters);

}  // namespace shigusa
