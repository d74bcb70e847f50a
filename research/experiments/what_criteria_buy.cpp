// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>

#include "../people/evenness.hpp"
#include "../people/jolt_meter.hpp"
#include "../people/measures.hpp"
#include "../people/random_tasks.hpp"
#include "core/check.hpp"
#include "criteria/built_in_criteria.hpp"
#include "files/file.hpp"
#include "plan/assignment.hpp"
#include "plan/plan.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr int kJoltTasks = 100;
constexpr std::size_t kFoundMaxBytes = 1 << 20;
constexpr const char* kClip = "cmu_02_06_60hz.bvh";

// A method to choose motions, for tasks made here and for the command line.
struct Variant {
  std::string name;
  Preset preset = Preset::flat;
  std::optional<CriteriaPreset> mixture{};  // in place of the preset's own
  std::vector<std::string> left_out{};      // criteria
  std::vector<std::string> fixed{};         // "bow=0"
  bool by_default = false;                  // criteria of the preset flat for any preset
};

std::vector<std::string> default_names() {
  std::vector<std::string> names;
  const CriteriaSettings settings = default_criteria();
  for (const CriterionTraits& criterion : kCriteria) {
    if (settings[criterion.kind].weight > 0.0) names.emplace_back(criterion.word);
  }
  return names;
}

// The five latest ones.
std::vector<std::string> newest() {
  return {"coordination", "hand_curve", "trunk_travel", "mass_ahead", "jolts"};
}

std::vector<Variant> variants(const Plan& plan) {
  const CriteriaPreset paper = criteria_presets().front();
  std::vector<Variant> all{{.name = "preset `flat`"}};
  if (plan.quick) return all;
  for (const std::string& name : default_names()) {
    all.push_back({.name = "without `" + name + "`", .left_out = {name}});
  }
  all.push_back({.name = "without the five newest", .left_out = newest()});
  all.push_back({.name = "a straight way: no bow, no sway", .fixed = {"bow=0", "sway=0"}});
  all.push_back({.name = "the paper's criteria", .mixture = paper});
  all.push_back({.name = "preset `human`", .preset = Preset::human});
  all.push_back(
      {.name = "`human` without the five newest", .preset = Preset::human, .left_out = newest()});
  all.push_back(
      {.name = "`human` by the paper's criteria", .preset = Preset::human, .mixture = paper});
  all.push_back({.name = "preset `layers` by the criteria of `flat`",
                 .preset = Preset::layers,
                 .by_default = true});
  return all;
}

void apply(const Variant& variant, Task& task) {
  task = with_preset(std::move(task), variant.preset);
  if (variant.mixture) task.criteria = variant.mixture->settings();
  if (variant.by_default) task.criteria = default_criteria();
  for (const CriterionTraits& criterion : kCriteria) {
    const auto& out = variant.left_out;
    if (std::find(out.begin(), out.end(), criterion.word) != out.end()) {
      task.criteria[criterion.kind].weight = 0.0;
    }
  }
  if (variant.fixed.empty()) return;
  const ParameterList list = parameter_list(whole_body_plan(task.body));
  task.fixed = no_fixed_parameters(list);
  for (const std::string& assignment : variant.fixed) {
    SHG_CHECK(fix_parameter(list, assignment, *task.fixed), "cannot fix " + assignment);
  }
}

// Options for `shigusa reach` with the same effect; preset and criteria are in a file of that
// folder, as a preset option would set its own criteria.
std::string options_of(const Variant& variant, const std::filesystem::path& folder) {
  nlohmann::json task{{"preset", std::string(word_of(variant.preset))}};
  if (variant.mixture) task["criteria"] = variant.mixture->name;
  if (variant.by_default) task["criteria"] = "default";
  for (const std::string& name : variant.left_out) task["criteria"][name]["weight"] = 0.0;
  const std::filesystem::path file = folder / "task.json";
  std::ofstream(file) << task.dump();
  std::string options = file.string();
  for (const std::string& assignment : variant.fixed) options += " --fix " + assignment;
  return options;
}

// Regularities that hold, by the tests of the shared folder.
struct Regularities {
  int held = 0;
  std::vector<std::pair<std::string, bool>> tests{};
};

std::optional<Regularities> regularities(const Plan& plan, const std::string& program,
                                         const std::string& options, const std::string& shared,
                                         const std::filesystem::path& folder) {
  const std::filesystem::path tests = std::filesystem::path(shared) / "people" / "regularities.py";
  if (!std::filesystem::exists(tests)) return std::nullopt;
  const std::filesystem::path found = folder / "regularities.json";
  std::filesystem::remove(found);
  const std::string command = fmt::format(
      "python3 '{}' '{}' --json '{}' --seeds {} --with \"{}\" >'{}' 2>&1", tests.string(), program,
      found.string(), plan.quick ? 1 : 3, options, (folder / "regularities.txt").string());
  // failed regularities set the exit status, and are counted below
  if (std::system(command.c_str()) == -1) return std::nullopt;
  const Result<std::string> text = read_text_file(found, kFoundMaxBytes);
  if (!text) return std::nullopt;
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  Regularities result;
  for (const auto& test : json) {
    const bool holds = test.at("holds").get<bool>();
    result.held += holds ? 1 : 0;
    result.tests.emplace_back(test.at("test").get<std::string>(), holds);
  }
  return result;
}

// Tests with an unusual result: "− low-paths-bow-forward, + one-waveform".
std::string changed(const Regularities& usual, const Regularities& other) {
  std::string text;
  for (const auto& [name, holds] : other.tests) {
    const auto same = std::find(usual.tests.begin(), usual.tests.end(), std::pair(name, holds));
    if (same != usual.tests.end()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", holds ? "+" : "−", name);
  }
  return text.empty() ? "–" : text;
}

// Reaches of the recorded man; empty if the recording is missing.
std::vector<Recorded> recorded_man_of(const std::string& shared) {
  const std::filesystem::path folder = std::filesystem::path(shared) / "reach";
  std::vector<Recorded> reaches;
  const auto segments = downward_segments(folder / "manifest.tsv");
  if (!segments) return reaches;
  for (const Segment& segment : *segments) {
    if (auto reach = read_reach(folder / kClip, segment)) reaches.push_back(std::move(*reach));
  }
  return reaches;
}

double middle(std::vector<double> values) {
  return 0.5 * (quantile(values, 0.499) + quantile(values, 0.501));
}

// Medians over the man's reaches of the distance between the best-scored motion and his: "11.7",
// "16.2".
std::vector<std::string> from_him(const Variant& variant, const std::vector<Recorded>& man) {
  std::vector<double> places, angles;
  for (const Recorded& reach : man) {
    Task task = reach.task();
    apply(variant, task);
    task.candidates = 8;
    const auto generation = generate(task);
    if (!generation) continue;
    const Apart off = apart(reach, track_of(reach, generation->candidates.front().motion.clip));
    places.push_back(100.0 * off.final_place);
    angles.push_back(degrees(off.nine));
  }
  if (places.empty()) return {"–", "–"};
  return {fmt::format("{:.1f}", middle(places)), fmt::format("{:.1f}", middle(angles))};
}

// Share of first choices with jolts.
std::string jolting(const Plan& plan, const Variant& variant) {
  const int tasks = plan.quick ? 5 : kJoltTasks;
  std::vector<int> jolts(static_cast<std::size_t>(tasks), -1);
  parallel_for(tasks, 0, [&](int i, int) {
    Task task = hand_task(i);
    apply(variant, task);
    const auto generation = generate(task);
    if (!generation || !generation->meets_goals()) return;
    const BodyModel body = PreparedTask::of(task).value().task().body;
    const bool any = jolts_of(body, generation->candidates.front().motion).any();
    jolts[static_cast<std::size_t>(i)] = any ? 1 : 0;
  });
  const auto met = tasks - std::count(jolts.begin(), jolts.end(), -1);
  if (met == 0) return "–";
  const auto count = std::count(jolts.begin(), jolts.end(), 1);
  return percent(static_cast<double>(count), static_cast<double>(met), 0);
}

// Number of instructions (callgrind's) of the program; empty without valgrind.
std::optional<double> instructions(const std::string& program, const std::string& options,
                                   int evaluations, const std::filesystem::path& folder) {
  const std::string command = fmt::format(
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null '{}' reach --character human "
      "--goal right_hand=-0.15,0.2,0.4 --simd avx2 --threads 1 --search random --evaluations {} "
      "--formats csv "
      "--out '{}' {} 2>&1",
      program, evaluations, (folder / "out").string(), options);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::optional<double> counted;
  char line[4096];
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    const std::string_view text = line;
    const std::size_t at = text.find("Collected : ");
    if (at != text.npos) counted = std::atof(line + at + 12);
  }
  pclose(pipe);
  return counted;
}

// Additional instructions per random motion of the body human; the motions are the same for all
// criteria.
std::optional<double> instructions_a_motion(const std::string& program, const std::string& options,
                                            const std::filesystem::path& folder) {
  const auto few = instructions(program, options, 1000, folder);
  const auto more = instructions(program, options, 3000, folder);
  if (!few || !more) return std::nullopt;
  return (*more - *few) / 2000.0;
}

// A folder that is removed at the end of its scope.
class Scratch {
 public:
  Scratch() { std::filesystem::create_directories(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                fmt::format("shigusa_criteria_{:08x}", std::random_device()());
};

}  // namespace

std::string what_criteria_buy(const Plan& plan, const std::string& program,
                              const std::string& shared) {
  const Scratch scratch;
  const std::filesystem::path& folder = scratch.path();
  const std::vector<Recorded> man = recorded_man_of(shared);
  Table table({"", "regularities that hold", "beside the first", "from the man, cm",
               "nine angles, °", "uneven pairs", "worst, °", "first choices that jolt"});
  std::optional<Regularities> usual;
  for (const Variant& variant : variants(plan)) {
    std::fprintf(stderr, "%s\n", variant.name.c_str());
    const std::string options = options_of(variant, folder);
    const auto found = regularities(plan, program, options, shared, folder);
    if (!usual) usual = found;
    std::vector<std::string> cells{variant.name};
    cells.push_back(found ? fmt::format("{} of {}", found->held, found->tests.size()) : "–");
    cells.push_back(found && usual ? changed(*usual, *found) : "–");
    for (std::string& cell : from_him(variant, man)) cells.push_back(std::move(cell));
    const Evenness even =
        plan.quick ? Evenness{} : evenness_of([&](Task& task) { apply(variant, task); });
    cells.push_back(even.pairs == 0 ? "–" : percent(even.uneven, even.pairs));
    cells.push_back(fmt::format("{:.0f}", degrees(even.worst)));
    cells.push_back(jolting(plan, variant));
    table.add(cells);
  }
  return fmt::format(
             "Each criterion of the default mixture left out, the others at their weights; the way "
             "made straight; and what the layered preset `human` is made of: its criteria, and "
             "`layers`, which has trunk and limb lengths as its parameters too, but arms from a "
             "library. Body `human`. *Regularities*: the tests of `../shared/people` (median of 3 "
             "seeds), and those that hold otherwise than in the first row. *From the man*: how far "
             "the best-scored ends from the recorded man, and its nine angles (medians over {} "
             "reaches, as in `docs/people.md`). *Uneven pairs*: of goals 4 cm apart, those whose "
             "knees end more than 20° apart. *Jolt*: first choices of {} random tasks of "
             "hands.\n\n",
             man.size(), plan.quick ? 5 : kJoltTasks) +
         table.text();
}

std::string what_criteria_cost(const Plan& plan, const std::string& program) {
  const Scratch scratch;
  Table table({"", "instructions a motion, thousands", "beside the first"});
  std::optional<double> usual;
  for (const Variant& variant : variants(plan)) {
    if (variant.preset == Preset::layers) continue;  // a library is searched anew each time
    const auto cost =
        instructions_a_motion(program, options_of(variant, scratch.path()), scratch.path());
    if (!usual) usual = cost;
    table.add({variant.name, cost ? fmt::format("{:.0f}", 1e-3 * *cost) : "–",
               cost && usual ? fmt::format("{:.3f}", *cost / *usual) : "–"});
  }
  return "The same ways to choose: what one more motion of the body `human` takes, by valgrind's "
         "callgrind in AVX2 lanes, for a goal 20 cm high and 40 ahead. The motions are random ones "
         "(`--search random`), the same whatever the criteria are.\n\n" +
         table.text();
}

}  // namespace shigusa::bench
