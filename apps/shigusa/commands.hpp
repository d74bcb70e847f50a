// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "task_options.hpp"

namespace shigusa::app {

// Exit codes of the command line (a contract).
inline constexpr int kDone = 0;
inline constexpr int kFault = 1;        // a fault of the program
inline constexpr int kWrongInput = 2;   // the call or a file is wrong, the standard output too
inline constexpr int kUnreachable = 3;  // a goal is out of reach, or no motion was found that
                                        // the body could make; what is nearest is written

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
  bool only_this_clip = false;

  bool operator==(const FileOptions&) const = default;
};

// The headings of commands in `shigusa --help`.
inline constexpr const char* kMakeMotions = "Make motions";
inline constexpr const char* kLook = "Look";
inline constexpr const char* kMany = "Many";
inline constexpr const char* kMore = "Studio and more";

// The heading of a group of options.
[[nodiscard]] inline std::string heading(OptionGroup group) { return std::string(word_of(group)); }

// The commands, each added to the program; a call of it sets the exit code.
void add_reach(CLI::App& app, int& exit_code);
void add_edit(CLI::App& app, int& exit_code);
void add_mirror(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_score(CLI::App& app, int& exit_code);
void add_body(CLI::App& app, int& exit_code);
void add_dataset(CLI::App& app, int& exit_code);
void add_studio(CLI::App& app, int& exit_code);
void add_schema(CLI::App& app);

// The words of an enum as a form (see OptionHelp) of an option: "paper|flat".
template <class Enum>
[[nodiscard]] std::string choices() {
  return fmt::format("{}", fmt::join(all_words<Enum>(), "|"));
}

// "human|full_body|half_body|FILE", and the sentence about these.
[[nodiscard]] std::string character_form();
[[nodiscard]] std::string character_help();
// Adds the options of a character beside its source.
void add_character_options(CLI::App& command, CharacterOptions& options);

// Words for the help of files' options, which depend on the command.
struct FileHelp {
  std::string usual;  // formats that are written where nothing is said
  std::string rate;   // Hz, likewise
  bool rare = false;  // all of these options are
};
void add_file_options(CLI::App& command, FileOptions& options, const FileHelp& help);
// "bvh, csv, svg and png; for characters …", what reach writes.
[[nodiscard]] std::string usual_formats_help();
// Whether a format is the character's own file with the motion in it.
[[nodiscard]] bool needs_file(const FormatInfo& info);

// Makes the folder of --out, as prepare_folder does.
[[nodiscard]] Result<void> prepare_out(const std::filesystem::path& folder);

// The SIMD set of that name; fails on one that this machine lacks.
[[nodiscard]] Result<SimdSet> simd_named(const std::string& name);
// Their names as a form.
[[nodiscard]] std::string simd_choices();

// Part of a clip: "FIRST:LAST", or all of it where the text is empty.
struct FrameRange {
  int first = 0;
  std::optional<int> last{};
};
[[nodiscard]] Result<FrameRange> parse_frames(const std::string& text);
inline constexpr const char* kFramesHelp = "Part of the clip, by its frames from 0";

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

// "1 shard", "2 shards".
[[nodiscard]] inline std::string number_of(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// Closed standard streams are opened, so that no file gets their numbers: what is printed to stderr
// goes nowhere, and writing to stdout fails.
void open_standard_streams();

// Whether stderr is a terminal.
[[nodiscard]] bool is_terminal();

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

// Ctrl-C and kill no longer end the program, or a thread that starts later, but can be waited for.
void block_ends();
void wait_for_end();

// A function of a shared library; null where the machine lacks it.
[[nodiscard]] void* find_function(const char* library, const char* name);

// The program's own file; empty where that cannot be told.
[[nodiscard]] std::filesystem::path program_path();

// Shows a page in the person's browser; where that cannot be done they have the address. Nobody
// waits for the opener's end: the system clears it away with the program.
void open_browser(std::string address);

// A progress line on stderr, only where that is a terminal.
Progress terminal_progress();
void end_progress_line();

}  // namespace shigusa::app
