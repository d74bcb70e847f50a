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
#include <shigusa/score.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "task_options.hpp"

namespace shigusa::app {

// Exit codes of the command line (a contract).
inline constexpr int kDone = 0;
inline constexpr int kFault = 1;        // a fault of the program
inline constexpr int kWrongInput = 2;   // the call or a file is wrong, the standard output too
inline constexpr int kUnreachable = 3;  // a goal is out of reach, or no possible motion was found;
                                        // the nearest one is written

// A character's options beside its source, as typed.
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

// Options for the files of a result.
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

// Headings of commands in `shigusa --help`.
inline constexpr const char* kMakeMotions = "Make motions";
inline constexpr const char* kLook = "Look";
inline constexpr const char* kMany = "Many";
inline constexpr const char* kMore = "Studio and more";

// Heading of a group of options.
[[nodiscard]] inline std::string heading(OptionGroup group) { return std::string(word_of(group)); }

// The commands; each function adds one to the program, whose call sets the exit code.
void add_reach(CLI::App& app, int& exit_code);
void add_edit(CLI::App& app, int& exit_code);
void add_mirror(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_score(CLI::App& app, int& exit_code);
void add_habit(CLI::App& app, int& exit_code);
void add_limit(CLI::App& app, int& exit_code);
void add_map(CLI::App& app, int& exit_code);
void add_body(CLI::App& app, int& exit_code);
void add_dataset(CLI::App& app, int& exit_code);
void add_studio(CLI::App& app, int& exit_code);
void add_mcp(CLI::App& app, int& exit_code);
void add_schema(CLI::App& app);

// The words of an enum as an option's form (see OptionHelp): "paper|flat".
template <class Enum>
[[nodiscard]] std::string choices() {
  return fmt::format("{}", fmt::join(all_words<Enum>(), "|"));
}

// Form "human|full_body|half_body|FILE", and the sentence that explains it.
[[nodiscard]] std::string character_form();
[[nodiscard]] std::string character_help();
// Adds the options of a character other than its source.
void add_character_options(CLI::App& command, CharacterOptions& options);

// Help texts of file options that depend on the command.
struct FileHelp {
  std::string usual;  // default formats
  std::string rate;   // Hz, default rate
  bool rare = false;  // all of these options are
};
void add_file_options(CLI::App& command, FileOptions& options, const FileHelp& help);
// Formats that reach writes, "bvh, csv, svg and png; for characters …".
[[nodiscard]] std::string usual_formats_help();
// Whether a format is the character's own file with the motion added.
[[nodiscard]] bool needs_file(const FormatInfo& info);

// Creates the folder of --out with prepare_folder.
[[nodiscard]] Result<void> prepare_out(const std::filesystem::path& folder);

// SIMD set of that name; fails if this machine lacks it.
[[nodiscard]] Result<SimdSet> simd_named(const std::string& name);
// Names of the SIMD sets as a form.
[[nodiscard]] std::string simd_choices();

// Range of a clip: "FIRST:LAST", or all of it for an empty text.
[[nodiscard]] Result<FrameRange> parse_frames(const std::string& text);
inline constexpr const char* kFramesHelp = "Part of the clip, by its frames from 0";

// Fails on options that a built-in body, or an already measured person, does not support.
[[nodiscard]] Result<void> apply_character_options(const CharacterOptions& options,
                                                   CharacterSpec& spec);

// Reads a clip on a character with these options, whose animation is the clip's; see read_recorded.
[[nodiscard]] Result<RecordedMotion> read_clip(const std::string& clip,
                                               const CharacterOptions& options,
                                               CharacterSpec character, int first);

// Settings for writing a result: from the options, and else from `usual`. Fails on formats to which
// this character cannot be exported.
[[nodiscard]] Result<ExportSettings> export_settings(const FileOptions& options,
                                                     const CharacterSpec& spec,
                                                     ExportSettings usual);

// Text from a file made safe for a terminal: control characters become '?'.
[[nodiscard]] std::string printable(std::string_view text);

// Count with a noun: "1 shard", "2 shards".
[[nodiscard]] inline std::string number_of(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// Opens closed standard streams, so that no file gets their numbers: output to stderr is discarded,
// and writing to stdout fails. Of Windows, lets them pass every byte as it is.
void open_standard_streams();

// The arguments of main() in UTF-8, and their number, as Windows may count them otherwise.
[[nodiscard]] char** utf8_arguments(int& count, char** arguments);

// Lines of the standard input.
class InputLines {
 public:
  // At most `most` + 1 bytes of a line are kept.
  explicit InputLines(std::size_t most) : most_(most) {}

  // The next line, without its end; nothing at the end of the input and after Ctrl-C, or, without
  // waiting, if no whole line is there yet.
  [[nodiscard]] std::optional<std::string> next(bool wait);

 private:
  [[nodiscard]] bool read_block(bool wait);

  std::size_t most_;
  std::string block_{};   // bytes that were read
  std::size_t used_ = 0;  // of them in lines
  std::string line_{};    // a line's beginning
  bool ended_ = false;
};

// Whether stderr is a terminal.
[[nodiscard]] bool is_terminal();

// Writes to the standard output; a failure is kept for finish_output. Never throws.
void write_out(std::string_view text);
// Writes to stderr; failures are ignored.
void write_err(std::string_view text);

template <class... Args>
void print_out(fmt::format_string<Args...> format, Args&&... args) {
  write_out(fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void print_err(fmt::format_string<Args...> format, Args&&... args) {
  write_err(fmt::format(format, std::forward<Args>(args)...));
}

// Exit code of a command after all of its output: its own, or kWrongInput, with a message, if
// output failed. A full disk may be reported only here.
int finish_output(int exit_code);

// Exit code for an error, which is printed to stderr as "shigusa: place: message".
int exit_code_of(const Result<int>& command);

// Prints "shigusa: place: note: message" to stderr.
void note(std::string_view place, std::string_view message);

// Makes Ctrl-C cancel terminal_progress(); a second one ends the program at once.
void catch_interrupts();

// Whether Ctrl-C was pressed.
[[nodiscard]] const std::atomic<bool>& interrupted();

// Blocks Ctrl-C and kill in this thread and later ones, so that they can be waited for.
void block_ends();
void wait_for_end();

// A function of a shared library; null if it is not available.
[[nodiscard]] void* find_function(const char* library, const char* name);

// Path of the program's own file; empty if unknown.
[[nodiscard]] std::filesystem::path program_path();

// Opens a page in the user's browser, if possible; the address is printed in any case. The opener
// runs in the background, and is reaped by the system.
void open_browser(std::string address);

// Progress line on stderr, if that is a terminal.
Progress terminal_progress();
void end_progress_line();

}  // namespace shigusa::app
