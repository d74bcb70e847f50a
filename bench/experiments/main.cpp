// SPDX-License-Identifier: MIT
// shigusa_experiments measures what docs/experiments.md says and writes that page.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <shigusa/core/parallel.hpp>
#include <shigusa/rollout/batch_rollout.hpp>

#include "report.hpp"
#include "sections.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr const char* kUsage =
    "usage: shigusa_experiments DOCS_FOLDER [--quick] [--goal-seed N] [--only SECTION]\n"
    "sections: paper searches layers styles nlp parameters limits query\n";

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
    } else if (arguments.docs.empty() && words[i].rfind("--", 0) != 0) {
      arguments.docs = words[i];
    } else {
      return std::nullopt;
    }
  }
  return arguments.docs.empty() ? std::nullopt : std::optional(arguments);
}

std::string introduction(const Plan& plan) {
  return fmt::format(
      "# Experiments\n\nThis page is written by `scripts/make_experiments`; change "
      "`bench/experiments`, not the page.\n\nThe right hand of the two built-in bodies (a man of "
      "1.741 m and 73 kg) reaches for {} goals a body, drawn evenly from a box around it (seed {}; "
      "`--goal-seed N` draws others) and kept where a method that shares nothing with the search "
      "finds a posture for them: many starts of a bounded minimiser on the final posture alone, "
      "within all limits, with planted feet. Besides these, three goals have names: low front-left "
      "(0.25, 0.55, 0.50), at the feet (-0.05, 0.10, 0.30) and high right (-0.45, 1.75, 0.35) m. "
      "Scores lie between 0 and 1, lower is better; a motion that misses its goal, leaves its path "
      "or moves a foot has the worst. Where a number stands with two in brackets, these are median "
      "and quartiles over the drawn goals, each goal being the median over its seeds. {}Measured "
      "on {} core{}, widest SIMD set {}.\n",
      plan.goals, plan.goal_seed, plan.quick ? "**A quick run: the numbers mean nothing.** " : "",
      thread_count(0), thread_count(0) == 1 ? "" : "s", simd_name(widest_simd_set()));
}

int write_page(const Arguments& arguments, const std::string& program) {
  const Plan& plan = arguments.plan;
  const std::vector<Subject> subjects = make_subjects(plan);
  const std::pair<const char*, std::function<std::string()>> sections[] = {
      {"paper", [&] { return against_paper(plan, subjects); }},
      {"searches", [&] { return against_searches(plan, subjects); }},
      {"layers", [&] { return against_layers(plan, subjects); }},
      {"styles", [&] { return stoop_and_squat(plan, subjects); }},
      {"nlp", [&] { return against_nlp(plan, subjects); }},
      {"parameters", [&] { return what_earns_its_place(plan, subjects); }},
      {"limits", [&] { return limits_and_goals(plan); }},
      {"query", [&] { return one_query(plan, program); }},
  };
  std::string page = introduction(plan);
  bool any = false;
  for (const auto& [name, section] : sections) {
    if (!arguments.only.empty() && arguments.only != name) continue;
    const Stopwatch watch;
    page += "\n" + section();
    std::cerr << fmt::format("{}: {:.0f} s\n", name, 1e-3 * watch.milliseconds());
    any = true;
  }
  if (!any) {
    std::cerr << "no section '" << arguments.only << "'\n" << kUsage;
    return 2;
  }
  std::ifstream remarks(arguments.docs / "experiments_remarks.md");
  page += "\n";
  page.append(std::istreambuf_iterator<char>(remarks), {});
  // a part of it is for looking at; a page is whole
  if (!arguments.only.empty() || plan.quick) {
    std::cout << page;
    return 0;
  }
  std::ofstream(arguments.docs / "experiments.md", std::ios::binary) << page;
  std::cout << (arguments.docs / "experiments.md").string() << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "--query") return run_query(words[1], std::stoi(words[2]));
  const auto arguments = read(words);
  if (!arguments) {
    std::cerr << kUsage;
    return 2;
  }
  return write_page(*arguments, argv[0]);
}
