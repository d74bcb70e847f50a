// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <shigusa/export.hpp>
#include <shigusa/parallel.hpp>
#include <shigusa/progress.hpp>
#include <shigusa/result.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "task_options.hpp"

namespace shigusa::app {

// Exit codes of the command line (a contract).
inline constexpr int kDone = 0;
inline constexpr int kFault = 1;        // a fault of the program
inline constexpr int kWrongInput = 2;   // the call or a file is wrong, the standard output too
inline constexpr int kUnreachable = 3;  // a goal is out of reach, or met by nothing that the body
                                        // could make; what is nearest is written

// The facts of a character beside its source, as they are typed.
struct CharacterOptions {
  std::optional<std::string> extent;
  std::optional<int> frame;
  std::optional<std::string> animation;  // of glTF
  std::optional<std::string> stature;    // m, or p5, p50, p95
  std::optional<double> mass;            // kg
  std::optional<double> seat;            // m
  bool heels = false;
  std::optional<std::string> sex;
  std::vector<std::string> map;  // BONE=NODE, or a JSON file of them
};

// The files of a result.
struct FileOptions {
  std::optional<std::string> formats;
  bool one_file = false;
  std::optional<double> fps;
  std::string clip;
  std::optional<std::string> joint_names;
  bool in_place = false;
};

struct ReachOptions {
  std::string task;  // file, or empty
  std::optional<std::string> character;
  CharacterOptions person;
  TaskOptions asked;
  std::optional<double> seconds;  // of the search at most
  int threads = 0;                // 0: one for each core
  std::optional<std::string> simd;
  std::string out = "out";
  FileOptions files;
  bool json = false;
};

struct EditOptions {
  std::string result;
  int candidate = 1;
  std::vector<std::string> assignments;
  bool mirror = false;                   // left for right
  std::optional<std::string> character;  // the file of the result's person
  std::string out;                       // empty: a new folder beside the result
  FileOptions files;
  bool json = false;
};

struct RenderOptions {
  std::string clip;
  std::string out;  // empty: the clip's name with .svg
  int poses = 7;
  std::string frames;             // FIRST:LAST, or empty for all
  std::optional<double> stature;  // m
};

struct ScoreOptions {
  std::string clip;
  std::optional<std::string> character;  // the clip's own person when not given
  CharacterOptions person;
  std::string frames;  // FIRST:LAST, or empty for all
  std::optional<std::string> criteria;
  std::optional<double> smooth;  // Hz
  bool json = false;
};

struct BodyOptions {
  std::string source;
  CharacterOptions person;
  bool json = false;
};

struct DatasetOptions {
  std::string plan;    // file
  std::string folder;  // of the data set, or of the one task
  std::string shards;  // FIRST:LAST, or empty for all
  std::string part;    // K/N, or empty for all
  bool check_plan = false;
  std::optional<std::uint64_t> task;
  int threads = 0;
  std::optional<std::string> simd;
  FileOptions files;  // of the one task
  bool json = false;  // of the one task
};

struct StudioOptions {
  int port = 0;        // any that is free
  bool open = true;    // in the person's browser
  std::string folder;  // of the built page; empty: where it is installed, or in the source tree
};

// The commands; their values are exit codes.
[[nodiscard]] Result<int> studio(const StudioOptions& options);
[[nodiscard]] Result<int> reach(const ReachOptions& options);
[[nodiscard]] Result<int> edit(const EditOptions& options);
[[nodiscard]] Result<int> render(const RenderOptions& options);
[[nodiscard]] Result<int> score(const ScoreOptions& options);
[[nodiscard]] Result<int> body(const BodyOptions& options);
[[nodiscard]] Result<int> dataset(const DatasetOptions& options);

// The SIMD set of that name; fails on one that this machine lacks.
[[nodiscard]] Result<SimdSet> simd_named(const std::string& name);

// Part of a clip: "FIRST:LAST", or all of it where the text is empty.
struct FrameRange {
  int first = 0;
  std::optional<int> last{};
};
[[nodiscard]] Result<FrameRange> parse_frames(const std::string& text);

// Fails on facts that a built-in body, or a person who was measured before, cannot take.
[[nodiscard]] Result<void> apply_character_options(const CharacterOptions& options,
                                                   CharacterSpec& spec);

// How to write a result: as the options ask, and else as in `usual`. Fails on formats that this
// character cannot leave in.
[[nodiscard]] Result<ExportSettings> export_settings(const FileOptions& options,
                                                     const CharacterSpec& spec,
                                                     ExportSettings usual);

// A text from a file as it may stand on a terminal: control characters become '?'.
[[nodiscard]] std::string printable(std::string_view text);

// Closed standard streams are opened, so that no file gets their numbers: what is printed to stderr
// goes nowhere, and writing to stdout fails.
void open_standard_streams();

// Writes to the standard output; what fails is kept for finish_output. Never throws.
void write_out(std::string_view text);
// Writes to stderr; nobody hears of a failure there.
void write_err(std::string_view text);

template <class... Args>
void print_out(fmt::format_string<Args...> format, Args&&... args) {
  write_out(fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void print_err(fmt::format_string<Args...> format, Args&&... args) {
  write_err(fmt::format(format, std::forward<Args>(args)...));
}

// The exit code of a command that has printed all of its output: its own, or kWrongInput, with a
// message, where not all of that could be written. A full disk may show only here.
int finish_output(int exit_code);

// The exit code of a command. Prints its error to stderr, "shigusa: place: message".
int exit_code_of(const Result<int>& command);

// Prints "shigusa: place: note: message" to stderr.
void note(std::string_view place, std::string_view message);

// Ctrl-C cancels terminal_progress(); a second one ends the program at once.
void catch_interrupts();

// True once Ctrl-C was pressed.
[[nodiscard]] const std::atomic<bool>& interrupted();

// A progress line on stderr, only where that is a terminal.
Progress terminal_progress();
void end_progress_line();

}  // namespace shigusa::app
