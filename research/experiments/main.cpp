// SPDX-License-Identifier: MIT
// shigusa_experiments runs the experiments of docs/experiments.md and writes that page.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <shigusa/run.hpp>

#include "report.hpp"
#include "rollout/batch_rollout.hpp"
#include "sections.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr const char* kUsage =
    "usage: shigusa_experiments DOCS_FOLDER [--quick] [--goal-seed N] [--only SECTION]\n"
    "sections: paper searches layers styles nlp parameters criteria limits best query, and "
    "remarks,\n"
    "which measures nothing and puts docs/experiments_remarks.md in anew\n";
constexpr std::string_view kSections[] = {"paper",  "searches",   "layers",   "styles",
                                          "nlp",    "parameters", "criteria", "cost",
                                          "limits", "best",       "query",    "remarks"};

struct Arguments {
  std::filesystem::path docs;
  Plan plan;
  std::string only;
};

std::optional<Arguments> read(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool valued = i + 1 < words.size();
    if (words[i] == "--quick") {
      const std::uint64_t seed = arguments.plan.goal_seed;
      arguments.plan = quick_plan();
      arguments.plan.goal_seed = seed;
    } else if (words[i] == "--goal-seed" && valued) {
      const std::string& word = words[++i];
      const auto read =
          std::from_chars(word.data(), word.data() + word.size(), arguments.plan.goal_seed);
      if (read.ec != std::errc{} || read.ptr != word.data() + word.size()) return std::nullopt;
    } else if (words[i] == "--only" && valued) {
      arguments.only = words[++i];
      if (std::find(std::begin(kSections), std::end(kSections), arguments.only) ==
          std::end(kSections)) {
        return std::nullopt;
      }
    } else if (arguments.docs.empty() && words[i].rfind("--", 0) != 0) {
      arguments.docs = words[i];
    } else {
      return std::nullopt;
    }
  }
  return arguments.docs.empty() ? std::nullopt : std::optional(arguments);
}

// Folder of recorded people, if any.
std::string shared_folder() {
  const char* given = std::getenv("SHIGUSA_SHARED_DIR");
  return given != nullptr ? given : "../shared";
}

std::string introduction(const Plan& plan) {
  return fmt::format(
      "# Experiments\n\nThis page is written by `scripts/make_experiments`; change "
      "`research/experiments`, not the page.\n\nThe right hand of the two built-in bodies (a man "
      "of "
      "1.741 m and 73 kg) reaches for {} goals a body, drawn evenly from a box around it (seed {}; "
      "`--goal-seed N` draws others) and kept where a method that shares nothing with the search "
      "finds a posture for them: many starts of a bounded minimiser on the final posture alone, "
      "within all limits, with planted feet. Besides these, three goals have names: low front-left "
      "(0.25, 0.55, 0.50), at the feet (-0.05, 0.10, 0.30) and high right (-0.45, 1.75, 0.35) m. "
      "A score is the weighted sum of penalties between 0 and 1, lower is better; a motion that "
      "misses its goal, leaves its path or moves a foot has the worst. Where a number stands with "
      "two in brackets, these are median "
      "and quartiles over the drawn goals, each goal being the median over its seeds. {}Measured "
      "on {} core{}, widest SIMD set {}.\n",
      plan.goals, plan.goal_seed, plan.quick ? "**A quick run: the numbers mean nothing.** " : "",
      thread_count(0), thread_count(0) == 1 ? "" : "s", simd_name(widest_simd_set()));
}

struct Section {
  const char* name;
  const char* title;
  std::function<std::string()> measure;
};

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Text below a title, up to the next one; empty if the page has no such title.
std::string part_of(const std::string& page, const std::string& title) {
  const std::string head = "\n## " + title + "\n\n";
  const std::size_t at = page.find(head);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + head.size();
  const std::size_t end = page.find("\n## ", begin);
  return page.substr(begin, end == std::string::npos ? end : end - begin);
}

// Runs all sections, or one, in which case the others are taken from the existing page.
int write_page(const Arguments& arguments, const std::filesystem::path& programs) {
  const Plan& plan = arguments.plan;
  const std::vector<Subject> subjects = make_subjects(plan);
  std::vector<Picture> pictures;
  const Section sections[] = {
      {"paper", "The preset flat against the paper's search",
       [&] { return against_paper(plan, subjects, pictures); }},
      {"searches", "The searches beside one another, and beside pagmo2",
       [&] { return against_searches(plan, subjects, pictures); }},
      {"layers", "Layers against all parameters at once",
       [&] { return against_layers(plan, subjects); }},
      {"styles", "Stoop and squat", [&] { return stoop_and_squat(plan, subjects); }},
      {"nlp", "NLP-IK against weighted IK", [&] { return against_nlp(plan, subjects); }},
      {"parameters", "What earns its place", [&] { return what_earns_its_place(plan, subjects); }},
      {"criteria", "What each criterion buys",
       [&] { return what_criteria_buy(plan, (programs / "shigusa").string(), shared_folder()); }},
      {"cost", "What each criterion costs",
       [&] { return what_criteria_cost(plan, (programs / "shigusa").string()); }},
      {"limits", "Limits, and goals that are met", [&] { return limits_and_goals(plan); }},
      {"best", "Near the best", [&] { return near_the_best(plan); }},
      {"query", "A default query",
       [&] { return one_query(plan, (programs / "shigusa_query").string()); }},
  };
  const std::filesystem::path file = arguments.docs / "experiments.md";
  const std::string before = file_text(file);
  std::string page = introduction(plan);
  for (const Section& section : sections) {
    const bool asked = arguments.only.empty() || arguments.only == section.name;
    if (!asked && (plan.quick || part_of(before, section.title).empty())) continue;
    page += fmt::format("\n## {}\n\n", section.title);
    const auto begin = std::chrono::steady_clock::now();
    page += asked ? section.measure() : part_of(before, section.title);
    if (asked)
      std::cerr << fmt::format(
          "{}: {:.0f} s\n", section.name,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  page += "\n" + file_text(arguments.docs / "experiments_remarks.md");
  if (plan.quick) {
    std::cout << page;
    return 0;
  }
  std::ofstream(file, std::ios::binary) << page;
  const std::filesystem::path images = arguments.docs / "images" / "experiments";
  std::filesystem::create_directories(images);
  for (const Picture& picture : pictures) {
    std::ofstream(images / (picture.name + ".svg"), std::ios::binary) << picture.svg;
  }
  std::cout << file.string() << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto arguments = read(words);
  if (!arguments) {
    std::cerr << kUsage;
    return 2;
  }
  // those beside this one
  return write_page(*arguments, std::filesystem::path(argv[0]).parent_path());
}
