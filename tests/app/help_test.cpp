// SPDX-License-Identifier: MIT
// Help, manual and completion have the same commands and options, and fit their page.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <set>
#include <shigusa/request.hpp>
#include <sstream>

#include "problem/request_fields.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::IsSubsetOf;
using Words = std::vector<std::string>;

constexpr std::size_t kWidth = 100;  // characters of a line of help
constexpr int kTwoScreens = 60;      // lines

std::string told(Words call, const std::string& last) {
  call.push_back(last);
  const ProgramRun run = run_shigusa(call);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Words split(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::size_t characters(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(
      line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

const std::string& markdown() {
  static const std::string text = run_shigusa({"manual", "--as", "markdown"}).out;
  return text;
}

// The words of each command, {"dataset", "merge"}, from the headings of the manual.
std::vector<Words> commands() {
  std::vector<Words> all;
  for (const std::string& line : lines_of(markdown())) {
    const std::size_t at = line.find("# shigusa ");
    if (at == line.npos) continue;
    all.push_back(split(line.substr(at + 10)));
  }
  return all;
}

// The options, such as "--goal", of lines like "  --goal EFFECTOR=X,Y,Z …".
std::set<std::string> options_in(const std::string& text, const std::string& before) {
  std::set<std::string> options;
  const std::regex option("(^|\n)" + before + "(--[a-z-]+)");
  for (std::sregex_iterator at(text.begin(), text.end(), option), end; at != end; ++at) {
    options.insert((*at)[2]);
  }
  return options;
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

TEST(Help, HasEveryCommandInItsGroupWithAnExample) {
  const std::string help = told({}, "--help");
  for (const char* group : {"\nMake motions\n", "\nLook\n", "\nMany\n", "\nStudio and more\n"}) {
    EXPECT_THAT(help, HasSubstr(group));
  }
  EXPECT_GE(commands().size(), 15U);
  for (const Words& command : commands()) {
    if (command.size() > 1) continue;
    EXPECT_THAT(help, HasSubstr("\n  " + command[0] + " "));
    EXPECT_THAT(help, HasSubstr("  shigusa " + command[0]));
  }
  EXPECT_THAT(help, HasSubstr("shigusa manual COMMAND"));
  EXPECT_NE(told({}, "--version"), "");
}

TEST(Help, FitsTheScreen) {
  for (Words command : commands()) {
    for (const char* last : {"--help", "--help-all"}) {
      for (const std::string& line : lines_of(told(command, last))) {
        EXPECT_LE(characters(line), kWidth) << joined(command) << " " << last << ": " << line;
      }
    }
    command.insert(command.begin(), "manual");
    for (const std::string& line : lines_of(run_shigusa(command).out)) {
      EXPECT_LE(characters(line), kWidth) << joined(command) << ": " << line;
    }
  }
  for (const std::string& line : lines_of(told({}, "--help"))) EXPECT_LE(characters(line), kWidth);
  EXPECT_LE(lines_of(told({"reach"}, "--help")).size(), kTwoScreens);
}

TEST(Help, OptionsOfFieldsHaveAGroupAndALineThatFits) {
  const std::string all = told({"reach"}, "--help-all");
  const auto check = [&all](const auto& field) {
    if (field.traits.option == nullptr) return;
    EXPECT_THAT(all, HasSubstr(std::string("\n  ") + field.traits.option));
    EXPECT_NE(field.traits.group, OptionGroup::none) << field.traits.option;
    ASSERT_NE(field.traits.brief, nullptr) << field.traits.option;
    EXPECT_LE(characters(field.traits.brief), 62U) << field.traits.option;
  };
  for_each_field<Request>(check);
  for_each_field<Goal>(check);
}

TEST(Help, RareOptionsStandInTheLongOneAlone) {
  const std::string common = told({"reach"}, "--help");
  const std::string all = told({"reach"}, "--help-all");
  EXPECT_EQ(common.find("--layer-reading"), common.npos);
  EXPECT_THAT(all, HasSubstr("--layer-reading"));
  EXPECT_THAT(common, HasSubstr("more options"));
}

TEST(Help, ShortLongManPageAndCompletionHaveTheSameOptions) {
  const std::string bash = told({"completion"}, "bash");
  const std::string zsh = told({"completion"}, "zsh");
  const std::string fish = told({"completion"}, "fish");
  for (const Words& command : commands()) {
    SCOPED_TRACE(joined(command));
    const std::set<std::string> all = options_in(told(command, "--help-all"), "  ");
    EXPECT_THAT(options_in(told(command, "--help"), "  "), IsSubsetOf(all));
    EXPECT_FALSE(all.empty());

    Words manual{"manual"};
    manual.push_back(command[0]);
    manual.push_back("--as");
    std::string page = told(manual, "man");
    for (std::size_t at = 0; (at = page.find("\\-", at)) != page.npos;) page.erase(at, 1);
    EXPECT_THAT(all, IsSubsetOf(options_in(page, "\\.B ")));

    const std::size_t at = bash.find("'" + joined(command) + "|'*)");
    ASSERT_NE(at, bash.npos);
    const Words named = split(bash.substr(bash.find("options='", at) + 9, 2000));
    const std::string names = " " + joined(named);
    const auto has = [](const std::string& text, const std::string& pattern) {
      return std::regex_search(text, std::regex(pattern));
    };
    for (const std::string& option : all) {
      EXPECT_TRUE(has(names, " " + option + "[ ']")) << option;
      EXPECT_TRUE(has(zsh, "'[*]?" + option + "(\\[|=)")) << option;
      EXPECT_THAT(fish, HasSubstr("\"" + joined(command) + "\"' -l " + option.substr(2) + " "));
    }
  }
}

// All example lines of the manual, without "shigusa".
Words examples() {
  Words all;
  bool inside = false;
  for (const std::string& line : lines_of(markdown())) {
    if (line.starts_with("```")) inside = line == "```sh";
    if (inside && line.starts_with("shigusa ")) all.push_back(line.substr(8));
  }
  return all;
}

int run_shell(const std::string& command) { return WEXITSTATUS(std::system(command.c_str())); }

// The beginning of a shell line that calls the program in a folder.
std::string program_in(const WorkFolder& work) {
  return "cd '" + work.path().string() + "' && SHIGUSA_CACHE=/dev/null/cache '" +
         shigusa_program() + "' ";
}

// As in a shell: an example is a valid call, whether or not its files exist.
TEST(Help, ExamplesAreUnderstood) {
  const WorkFolder work;
  EXPECT_GE(examples().size(), 20U);
  for (const std::string& example : examples()) {
    // the page is not served: its folder is not there
    const std::string last = example.starts_with("studio") ? " --folder gone" : "";
    run_shell(program_in(work) + example + last + " > out.txt 2> err.txt < /dev/null");
    const std::string err = work.get("err.txt");
    EXPECT_EQ(err.find("tells what can be given"), err.npos) << example << ": " << err;
    EXPECT_EQ(err.find("unknown"), err.npos) << example << ": " << err;
    EXPECT_EQ(err.find("no command"), err.npos) << example << ": " << err;
  }
}

TEST(Help, ExamplesOfAFirstHourRun) {
  const WorkFolder work;
  int run = 0;
  const std::set<std::string> made{"reach", "edit", "mirror", "show", "render", "body", "score"};
  for (const std::string& example : examples()) {
    // others are of files that a person has
    const bool has_files = !std::regex_search(example, std::regex("json|walk|lift|hero"));
    if (!has_files || !made.contains(split(example)[0])) continue;
    run_shell(program_in(work) + example + " > out.txt 2> err.txt; echo $? > code.txt");
    EXPECT_EQ(work.get("code.txt"), "0\n") << example << ": " << work.get("err.txt");
    ++run;
  }
  EXPECT_GE(run, 9);
}

TEST(Manual, ManPagesAreFreeOfWarnings) {
  if (run_shell("command -v groff > /dev/null") != 0) GTEST_SKIP() << "no groff here";
  const WorkFolder work;
  ASSERT_EQ(
      run_shigusa({"manual", "--as", "man", "--out", "man1"}, {.folder = work.path()}).exit_code,
      0);
  int pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(work / "man1")) {
    const std::string call = "groff -man -Tutf8 -ww -z '" + entry.path().string() + "' > '" +
                             (work / "out.txt").string() + "' 2>&1";
    EXPECT_EQ(run_shell(call), 0);
    EXPECT_EQ(work.get("out.txt"), "") << entry.path();
    ++pages;
  }
  EXPECT_GE(pages, 13);  // of the program and of each command
}

TEST(Manual, TellsExitCodesAndEnvironmentInEachForm) {
  for (const char* form : {"text", "man", "markdown"}) {
    const std::string text = run_shigusa({"manual", "reach", "--as", form}).out;
    EXPECT_THAT(text, HasSubstr("SHIGUSA_CACHE")) << form;
    EXPECT_THAT(text, HasSubstr("130")) << form;
  }
}

TEST(Manual, IsOfACommandBelowAnother) {
  EXPECT_THAT(run_shigusa({"manual", "dataset", "export"}).out, HasSubstr("--character"));
}

// The words that bash offers after a call with an unfinished last word.
std::string completed(const WorkFolder& work, const Words& words) {
  std::string call =
      "cd '" + work.path().string() + "'; compopt() { :; }; . ./completion; COMP_WORDS=(";
  for (const std::string& word : words) call += "'" + word + "' ";
  call += "); COMP_CWORD=" + std::to_string(words.size() - 1) +
          "; _shigusa; printf '%s\\n' \"${COMPREPLY[@]}\" | sort | tr '\\n' ' '";
  work.put("call.sh", call);
  run_shell("bash '" + (work / "call.sh").string() + "' > '" + (work / "out.txt").string() + "'");
  return work.get("out.txt");
}

TEST(Completion, OfBashOffersCommandsOptionsWordsAndPaths) {
  if (run_shell("command -v bash > /dev/null") != 0) GTEST_SKIP() << "no bash here";
  const WorkFolder work;
  work.put("completion", told({"completion"}, "bash"));
  work.put("folder/file", "");
  work.put("task.json", "");
  EXPECT_EQ(completed(work, {"shigusa", "re"}), "reach render ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--pre"}), "--preset ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--preset", ""}), "flat human layers paper ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--preset", "=", "fl"}), "flat ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--formats", "b"}), "bvh ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--goal", "right_ha"}), "right_hand= ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--palm", ""}), "left_hand= right_hand= ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--goal", "right_hand", "="}), " ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "--out", "f"}), "folder ");
  EXPECT_EQ(completed(work, {"shigusa", "reach", "t"}), "task.json ");
  EXPECT_EQ(completed(work, {"shigusa", "dataset", "m"}), "merge ");
  EXPECT_EQ(completed(work, {"shigusa", "dataset", "merge", ""}), "folder ");
  EXPECT_EQ(completed(work, {"shigusa", "dataset", "export", "d", "--split", "v"}), "validation ");
}

TEST(Completion, IsReadByEachShell) {
  const WorkFolder work;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const std::string text = told({"completion"}, shell);
    work.put(shell, text);
    if (run_shell("command -v " + shell + " > /dev/null") != 0) continue;
    EXPECT_EQ(run_shell(shell + " -n '" + (work / shell).string() + "'"), 0) << shell;
  }
}

}  // namespace
}  // namespace shigusa
