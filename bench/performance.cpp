// SPDX-License-Identifier: MIT
// Writes docs/performance.md from the measurements of shigusa_bench.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int kSteps = 60;           // IK steps of a motion; it has one frame more
constexpr int kSearchMotions = 300;  // of search/…
// Scatter of rounds above which the machine counts as busy and no page is written. Virtual machines
// with shared cores have some 10 % at rest; the page states the value.
constexpr double kScatterLimit = 0.2;
constexpr const char* kAbsent = "–";  // table cell without a measurement

// Medians of a run of shigusa_bench.
class Measurements {
 public:
  explicit Measurements(const nlohmann::json& run) {
    for (const nlohmann::json& entry : run.at("benchmarks")) {
      const auto name = entry.at("run_name").get<std::string>();
      if (entry.value("error_occurred", false)) {
        throw std::runtime_error(name + ": " + entry.at("error_message").get<std::string>());
      }
      if (entry.value("aggregate_name", "") == "median") medians_[name] = entry;
      if (entry.value("aggregate_name", "") == "cv") {
        scatter_.push_back(entry.at("cpu_time").get<double>());
      }
    }
    std::sort(scatter_.begin(), scatter_.end());
    if (scatter_.empty()) throw std::runtime_error("nothing was measured more than once");
  }

  // Standard deviation of the rounds' times relative to their mean: median over the benchmarks.
  [[nodiscard]] double scatter() const { return scatter_[scatter_.size() / 2]; }

  [[nodiscard]] bool has(const std::string& name) const { return medians_.contains(name); }
  [[nodiscard]] double value(const std::string& name, const char* key) const {
    const auto found = medians_.find(name);
    if (found == medians_.end()) throw std::runtime_error("not measured: " + name);
    return found->second.at(key).get<double>();
  }
  [[nodiscard]] double micros_per_motion(const std::string& name) const {
    return 1e6 / value(name, "motions/s");
  }
  // over all frames of one motion, which is the number of runs of the stage
  [[nodiscard]] double stage_micros(const std::string& body, const std::string& stage,
                                    const std::string& set, int times) const {
    const std::string name = "stage/" + body + "/" + stage + "/" + set;
    return value(name, "cpu_time") * 1e-3 * times / value(name, "lanes");
  }

 private:
  std::map<std::string, nlohmann::json> medians_;
  std::vector<double> scatter_;  // of each benchmark, ascending
};

// Name of a set on the page.
std::string title(const std::string& set) {
  static const std::map<std::string, std::string> titles = {
      {"avx512", "AVX-512"}, {"avx2", "AVX2"}, {"sse2", "SSE2"}, {"double", "scalar double"}};
  const auto found = titles.find(set);
  return found == titles.end() ? set : found->second;
}

// Measured sets of lanes, widest first.
std::vector<std::string> wide_sets(const Measurements& m) {
  std::vector<std::string> sets;
  for (const char* set : {"avx512", "avx2", "sse2", "simd128"}) {
    if (m.has(std::string("peak/") + set)) sets.emplace_back(set);
  }
  return sets;
}

// Name of the processor, without other data of the machine.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::map<std::string, std::string> first;
  for (std::string line; std::getline(file, line) && !line.empty();) {
    const std::size_t colon = line.find(':');
    const std::size_t key = line.find_last_not_of(" \t", colon - 1);
    if (colon == std::string::npos || colon + 2 > line.size()) continue;
    first[line.substr(0, key + 1)] = line.substr(colon + 2);
  }
  if (!first.contains("model name")) return "an unknown processor";
  return fmt::format("{} (family {}, model {})", first["model name"], first["cpu family"],
                     first["model"]);
}

std::string introduction(const Measurements& m, const nlohmann::json& run) {
  std::string caches;
  for (const nlohmann::json& cache : run.at("context").at("caches")) {
    caches += fmt::format(", L{} {} {} KiB", cache.at("level").get<int>(),
                          cache.at("type").get<std::string>(), cache.at("size").get<int>() / 1024);
  }
  return fmt::format(
      "# Performance\n\nThis page is written by `scripts/make_performance` from one run of "
      "`shigusa_bench`; change `bench/`, or `docs/performance_remarks.md` where the last part is "
      "kept, not the page.\n\nMeasured on {}, {} cores{}, with g++ {}. Times are medians, of the "
      "processor's time on one core where nothing else is said; from round to round they scatter "
      "by {:.1f} %. Motion: the paper's first "
      "experiment, {} steps; parameters: random genomes of the paper's code.\n",
      processor(), run.at("context").at("num_cpus").get<int>(), caches, __VERSION__,
      100 * m.scatter(), kSteps);
}

struct Goal {
  const char* title;
  const char* name;  // without the set
  bool search;       // ms per search, else µs per motion
  std::map<std::string, double> goals;
};

const Goal kGoals[] = {
    {"rollout/half_body, µs per motion",
     "rollout/half_body/",
     false,
     {{"avx512", 1.8}, {"avx2", 3.2}, {"double", 20.0}}},
    {"rollout/full_body, µs per motion",
     "rollout/full_body/",
     false,
     {{"avx512", 4.2}, {"avx2", 7.5}, {"double", 48.0}}},
    {"search/paper_half, ms", "search/paper_half/", true, {}},
    {"search/paper_full, ms", "search/paper_full/", true, {{"avx512", 1.2}, {"avx2", 1.9}}},
};

std::string goal_table(const Measurements& m) {
  std::string page =
      "\n## One motion, one search\n\nMeasured, and in brackets the goal. A search scores 300 "
      "motions.\n\n| on one core | AVX-512 | AVX2 | SSE2 | scalar double "
      "|\n|---|---|---|---|---|\n";
  for (const Goal& goal : kGoals) {
    page += fmt::format("| {} |", goal.title);
    for (const char* set : {"avx512", "avx2", "sse2", "double"}) {
      const std::string name = goal.name + std::string(set);
      if (!m.has(name)) {
        page += fmt::format(" {} |", kAbsent);
        continue;
      }
      page += fmt::format(" {:.3g}",
                          goal.search ? m.value(name, "cpu_time") : m.micros_per_motion(name));
      const auto aim = goal.goals.find(set);
      page += aim == goal.goals.end() ? " |" : fmt::format(" (≤ {:g}) |", aim->second);
    }
    page += "\n";
  }
  const std::string set = wide_sets(m).front();
  const double full = m.micros_per_motion("rollout/full_body/" + set) * kSearchMotions * 1e-3;
  const double searched = m.value("search/paper_full/" + set, "cpu_time");
  const double filled = m.value("search/paper_full/" + set, "lanes_filled");
  return page + fmt::format(
                    "\nWith all lanes full, 300 motions of the full body would take {:.2f} ms with "
                    "{}. The search reaches {:.0f} % of that speed: its batches fill {:.0f} % of "
                    "the lanes, and the rest is the search itself.\n",
                    full, title(set), 100 * full / searched, 100 * filled);
}

// Queries of interactive use.
std::string query_table(const Measurements& m) {
  struct Row {
    const char* words;
    const char* name;
    double goal;  // ms, with AVX2
    bool wall;
  };
  constexpr Row kRows[] = {
      {"full_body, one core", "query/full_body/", 20.0, false},
      {"human, one core", "query/human/", 25.0, false},
      // 0.58 of one core's
      {"human, two cores, by the clock", "query/human/two_threads/", 14.5, true}};
  std::string page =
      "\n## One query\n\n`generate()` with nothing said but the goal: up to five candidates, by "
      "the default's budget. Milliseconds.\n\n| | AVX-512 | AVX2 | SSE2 |\n|---|---|---|---|\n";
  for (const Row& row : kRows) {
    page += fmt::format("| {} |", row.words);
    for (const std::string set : {"avx512", "avx2", "sse2"}) {
      const std::string name = row.name + set + (row.wall ? "/real_time" : "");
      if (!m.has(name)) {
        page += fmt::format(" {} |", kAbsent);
        continue;
      }
      page += fmt::format(" {:.1f}", m.value(name, row.wall ? "real_time" : "cpu_time"));
      page += set == "avx2" ? fmt::format(" (≤ {:g}) |", row.goal) : " |";
    }
    page += "\n";
  }
  for (const std::string set : {"avx512", "avx2"}) {
    const std::string query = "query/human/two_threads/" + set + "/real_time";
    if (!m.has(query)) continue;
    page += fmt::format(
        "\nWith {}, the human's query on two cores takes {:.0f} bare motions of the full body "
        "(≤ 2100: a frame of 60 Hz).\n",
        title(set),
        1e3 * m.value(query, "real_time") / m.micros_per_motion("rollout/full_body/" + set));
  }
  return page +
         fmt::format(
             "\nA character from a VRM file of {:.1f} MB, read and measured: {:.1f} ms (≤ 100).\n",
             1e-6 * m.value("load/vrm", "bytes"), m.value("load/vrm", "cpu_time"));
}

std::string rival_table(const Measurements& m) {
  std::string page =
      "\n## Beside MuJoCo and Orocos KDL\n\nThe same loop assembled from these libraries, as "
      "Debian has them, in the same run: how many times as fast shigusa is. The rivals compute in "
      "double and are spared the criteria, all checks, the further steps where a foot is off, and "
      "the floor's share of the second foot. Goal on the full body: 35 × MuJoCo with AVX-512, "
      "20 × with AVX2.\n\n| body | rival | its µs per motion |";
  const std::vector<std::string> sets = {"avx512", "avx2", "sse2", "double"};
  for (const std::string& set : sets) page += fmt::format(" {} |", title(set));
  page += "\n|---|---|---|---|---|---|---|\n";
  for (const char* body : {"half_body", "full_body"}) {
    for (const auto& [rival, words] :
         {std::pair{"mujoco", "MuJoCo"}, std::pair{"kdl", "Orocos KDL"}}) {
      const std::string name = fmt::format("rival/{}/{}", rival, body);
      if (!m.has(name)) continue;
      const double theirs = m.micros_per_motion(name);
      page += fmt::format("| {} | {} | {:.0f} |", body, words, theirs);
      for (const std::string& set : sets) {
        const std::string ours = fmt::format("rollout/{}/{}", body, set);
        page += m.has(ours) ? fmt::format(" {:.1f} × |", theirs / m.micros_per_motion(ours))
                            : fmt::format(" {} |", kAbsent);
      }
      page += "\n";
    }
  }
  return page;
}

std::string thread_table(const Measurements& m) {
  const auto name = [](int threads) {
    return fmt::format("scaling/threads/{}/real_time", threads);
  };
  std::string page = fmt::format(
      "\n## Threads\n\nMotions of the full body with {}, by the clock on the wall. Goal: two "
      "threads 1.8 times as fast as one.\n\n| threads | motions/s | × one |\n|---|---|---|\n",
      title(wide_sets(m).front()));
  for (int threads = 1; m.has(name(threads)); threads *= 2) {
    page += fmt::format("| {} | {:.0f} | {:.2f} |\n", threads, m.value(name(threads), "motions/s"),
                        m.value(name(threads), "motions/s") / m.value(name(1), "motions/s"));
  }
  return page;
}

std::string stage_table(const Measurements& m, const std::string& body,
                        const std::vector<std::string>& sets) {
  struct Row {
    const char* words;
    std::vector<double> micros;
  };
  std::vector<Row> rows = {{"forward kinematics", {}},
                           {"IK: Jacobian and residual", {}},
                           {"IK: J A Jᵀ", {}},
                           {"IK: factors and solution", {}},
                           {"IK: damping, back to the joints", {}},
                           {"inverse dynamics, feet, centre of mass", {}},
                           {"criteria", {}},
                           {"all else", {}}};
  std::vector<double> wholes;
  for (const std::string& set : sets) {
    const auto micros = [&](const char* stage, int times) {
      return m.stage_micros(body, stage, set, times);
    };
    std::vector<double> parts = {micros("forward_kinematics", kSteps + 1),
                                 micros("ik_rows", kSteps), micros("ik_products", kSteps),
                                 micros("ik_solve", kSteps)};
    parts.push_back(micros("ik", kSteps) - parts[1] - parts[2] - parts[3]);
    parts.push_back(micros("dynamics", kSteps + 1));
    parts.push_back(micros("criteria", kSteps + 1));
    wholes.push_back(micros("motion", 1));
    double rest = wholes.back();
    for (const double part : parts) rest -= part;
    parts.push_back(rest);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].micros.push_back(parts[i]);
  }
  std::string page = fmt::format("\n| {} |", body);
  for (const std::string& set : sets)
    page += fmt::format(" {}, µs per motion | share |", title(set));
  page += "\n|---|";
  for (std::size_t s = 0; s < sets.size(); ++s) page += "---|---|";
  page += "\n";
  for (const Row& row : rows) {
    page += fmt::format("| {} |", row.words);
    for (std::size_t s = 0; s < sets.size(); ++s) {
      page += fmt::format(" {:.2f} | {:.0f} % |", row.micros[s], 100 * row.micros[s] / wholes[s]);
    }
    page += "\n";
  }
  page += "| the whole motion |";
  for (const double whole : wholes) page += fmt::format(" {:.2f} | |", whole);
  return page + "\n";
}

std::string stages(const Measurements& m) {
  std::string page =
      "\n## Where the time goes\n\nEach stage measured by itself, over and over on the same "
      "numbers, times how often a motion needs it at least. What is left of the whole motion is "
      "the choice of targets, measuring what was missed, speeds and accelerations, further steps "
      "that some lane needs, and waiting for numbers that one stage by itself finds in the nearest "
      "cache.\n";
  std::vector<std::string> sets = wide_sets(m);
  if (sets.size() > 2) sets.resize(2);
  for (const char* body : {"half_body", "full_body"}) page += stage_table(m, body, sets);
  return page;
}

std::string operations(const Measurements& m) {
  const auto name = [](const std::string& body) { return "operations/" + body + "/iterations:1"; };
  std::string page =
      "\n## Operations and the core's peak\n\nCounted, not estimated: the kernel was run with a "
      "scalar that counts, over the same motions.\n\n| of one motion | additions | "
      "multiplications | divisions | square roots | comparisons | placements of the body "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const std::string body : {"half_body", "full_body"}) {
    page += fmt::format("| {} |", body);
    for (const char* key :
         {"additions", "multiplications", "divisions", "square_roots", "comparisons"}) {
      page += fmt::format(" {:.0f} |", m.value(name(body), key));
    }
    page += fmt::format(" {:.2f} |\n", m.value(name(body), "placements"));
  }
  page +=
      "\nPeak: separate multiplications and additions in registers, as many of each, none waiting "
      "for another. Achieved: the motion's additions and multiplications in its time.\n\n"
      "| set | peak, 10⁹/s | half_body, 10⁹/s | of peak | full_body, 10⁹/s | of peak "
      "|\n|---|---|---|---|---|---|\n";
  for (const std::string& set : wide_sets(m)) {
    const double peak = 1e-9 * m.value("peak/" + set, "operations/s");
    page += fmt::format("| {} | {:.1f} |", title(set), peak);
    for (const std::string body : {"half_body", "full_body"}) {
      const double count =
          m.value(name(body), "additions") + m.value(name(body), "multiplications");
      const double achieved = 1e-3 * count / m.micros_per_motion("rollout/" + body + "/" + set);
      page += fmt::format(" {:.1f} | {:.0f} % |", achieved, 100 * achieved / peak);
    }
    page += "\n";
  }
  return page;
}

std::string fused(const Measurements& m) {
  std::string page =
      "\n## What forbidding fused multiply-add costs\n\nResults are the same bytes on every "
      "machine only if each product is rounded before it is added. The same kernel, compiled once "
      "more for this measurement with fused multiply-add allowed:\n\n| body | set | as it is, µs "
      "per motion | fused, µs | as it is takes more by |\n|---|---|---|---|---|\n";
  for (const std::string body : {"half_body", "full_body"}) {
    for (const std::string& set : wide_sets(m)) {
      if (!m.has("stage/" + body + "/motion/" + set + "_fma")) continue;
      const double plain = m.stage_micros(body, "motion", set, 1);
      const double with = m.stage_micros(body, "motion", set + "_fma", 1);
      page += fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.0f} % |\n", body, title(set), plain,
                          with, 100 * (plain / with - 1));
    }
  }
  return page;
}

std::string performance_page(const nlohmann::json& run, const std::filesystem::path& docs) {
  const Measurements m(run);
  if (m.scatter() > kScatterLimit) {
    throw std::runtime_error(
        fmt::format("the machine was not at rest: times scatter by {:.0f} %, allowed are {:.0f} %",
                    100 * m.scatter(), 100 * kScatterLimit));
  }
  std::string page = introduction(m, run) + goal_table(m) + query_table(m) + rival_table(m) +
                     thread_table(m) + stages(m) + operations(m) + fused(m);
  std::ifstream remarks(docs / "performance_remarks.md");
  page += "\n";
  page.append(std::istreambuf_iterator<char>(remarks), {});
  return page;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: shigusa_performance MEASURED.json DOCS_FOLDER\n";
    return 2;
  }
  try {
    std::ifstream file(argv[1]);
    const std::filesystem::path docs = argv[2];
    const std::string page = performance_page(nlohmann::json::parse(file), docs);
    std::ofstream(docs / "performance.md", std::ios::binary) << page;
    std::cout << (docs / "performance.md").string() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "shigusa_performance: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
