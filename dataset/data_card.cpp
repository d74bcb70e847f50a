// SPDX-License-Identifier: MIT
#include "data_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/dataset_merge.hpp>

#include "motion_table.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

// Largest number of tasks drawn to find one with a body.
constexpr std::uint64_t kTriedTasks = 20;
// Number of words up to which all counts are listed; of more, the commonest.
constexpr std::size_t kToldWords = 20;

// Text of the plan's author, escaped for a line of Markdown.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

// Counts such as "reached 30; unsteady 5", the commonest first.
std::string counts_text(const Counts& counts) {
  std::vector<std::pair<std::string, std::uint64_t>> sorted(counts.begin(), counts.end());
  std::erase_if(sorted, [](const auto& one) { return one.second == 0; });
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (std::size_t k = 0; k < sorted.size() && k < kToldWords; ++k) {
    if (k > 0) text += "; ";
    text += fmt::format("{} {}", one_line(sorted[k].first), sorted[k].second);
  }
  if (sorted.size() > kToldWords) {
    text += fmt::format("; and {} more words", sorted.size() - kToldWords);
  }
  return text.empty() ? "none" : text;
}

std::string range_text(const Moments& moments, std::string_view unit) {
  if (moments.count == 0) return "none";
  return fmt::format("{:.3g} to {:.3g} {}, mean {:.3g}", moments.least, moments.most, unit,
                     moments.mean);
}

std::string_view kept_text(KeptMotions kept) {
  switch (kept) {
    case KeptMotions::possible:
      return "motions that meet their goals and that the body could make (`possible` or `strains`)";
    case KeptMotions::reached:
      return "motions that meet their goals, whether the body could make them or not (`verdict`)";
    default:
      return "all motions, also those that end nearest to goals out of reach (see `/missed`)";
  }
}

constexpr std::string_view kAboutCard = R"(
Whole-body motions from goals, made by the program shigusa. A task is a body with goals: places
where a hand, a foot or another joint is to be at the end, perhaps with a rotation, a load, or
obstacles on the way. For each task the program searched several different motions from the body's
start posture to its goals. Nobody was recorded.
)";

std::string beginning(const CardFacts& facts) {
  const DatasetPlan& plan = facts.plan;
  const std::string name = one_line(plan.name());
  std::string text =
      fmt::format("# {}\n{}\n", name.empty() ? "A data set of motions" : name, kAboutCard);
  if (facts.statistics == nullptr) {
    return text + fmt::format(
                      "The plan asks for {} tasks in {} files. This card was written before "
                      "they were made;\n`shigusa dataset merge .` writes it again with "
                      "their numbers.\n",
                      plan.tasks(), plan.shards());
  }
  const DatasetStatistics& all = *facts.statistics;
  text += fmt::format("| | |\n|---|---|\n| tasks | {} of the plan's {} |\n| motions | {} |\n",
                      all.tasks, plan.tasks(), all.motions);
  text += fmt::format("| tasks by status | {} |\n", counts_text(all.statuses));
  text += fmt::format("| tasks whose goals are not met | {} |\n", all.missed);
  text += fmt::format("| tasks that were refused | {} |\n", all.refused);
  text += fmt::format("| motions that were scored to find them | {} |\n", all.evaluations);
  if (facts.missing > 0) {
    text += fmt::format("\n{} of the plan's {} shards are not made yet.\n", facts.missing,
                        plan.shards());
  }
  return text;
}

// Template of the tasks as an indented block of Markdown, which no text in it can end.
std::string template_text(const DatasetPlan& plan) {
  const Json json = Json::parse(plan.text(), nullptr, false);
  if (!json.is_object() || !json.contains("task")) return "";
  std::string text = "    ";
  for (const char c : json["task"].dump(2, ' ', false, Json::error_handler_t::replace)) {
    text += c;
    if (c == '\n') text += "    ";
  }
  return text + "\n";
}

std::string origin(const CardFacts& facts) {
  const DatasetPlan& plan = facts.plan;
  const bool files = !plan.character_files().empty();
  std::string text = fmt::format(R"(
## How it was made

- Program: {}. Version of the format: {}.
- Plan: `{}`. SHA-256 of what it says{}: `{}`. Each shard names it.
- Seed: {}. Every number is drawn from the seed, the task and the place in the plan alone.
- `shigusa dataset {} --out FOLDER` makes the same files again, byte for byte, with the same program,
  HDF5 and zlib.
- Kept are {}.
)",
                                 facts.program, kDatasetVersion, kPlanName,
                                 files ? " and of its characters' files" : "", plan.digest(),
                                 plan.seed(), kPlanName, kept_text(plan.motions()));
  if (plan.people() > 0) {
    text +=
        fmt::format("- {} people share the tasks: each task draws one of them.\n", plan.people());
  }
  for (const std::string& file : plan.character_files()) {
    text += fmt::format(
        "- A character comes from the file `{}`, which is not part of the data. Where that has a "
        "recorded\n  posture, the motions may start from it.\n",
        one_line(file));
  }
  return text +
         "\nEach task is drawn from this template. An object such as `{\"uniform\": [0, 15]}` "
         "stands "
         "for a value\nthat is drawn.\n\n" +
         template_text(plan);
}

std::string contents(const CardFacts& facts) {
  if (facts.statistics == nullptr) return "";
  const DatasetStatistics& all = *facts.statistics;
  std::string text = "\n## Bodies and goals\n\n";
  text += fmt::format("- Characters (tasks): {}. Sexes: {}.\n", counts_text(all.characters),
                      counts_text(all.sexes));
  text += fmt::format("- Stature: {}. Mass: {}.\n", range_text(all.stature_m, "m"),
                      range_text(all.mass_kg, "kg"));
  text += fmt::format("- Presets of the search (tasks): {}.\n", counts_text(all.presets));
  text += fmt::format("- Goals by effector: {}.\n", counts_text(all.effectors));
  for (std::size_t k = 0; k < 3; ++k) {
    text += fmt::format("- Goals, {}: {}.\n", std::string_view("xyz").substr(k, 1),
                        range_text(all.goal_m[k], "m"));
  }
  text += fmt::format("- Loads, of goals that have one: {}.\n", range_text(all.load_kg, "kg"));
  for (const auto& [path, motions] : all.tables) {
    text += fmt::format(
        "- `{}`: {} motions; {}. They end: {}. Score: median {:.3g}, 5 to 95 % "
        "within {:.3g} to {:.3g}; less is better.\n",
        path, motions.motions, counts_text(motions.verdicts), counts_text(motions.postures),
        motions.scores.at(0.5), motions.scores.at(0.05), motions.scores.at(0.95));
  }
  return text;
}

std::string shape_text(const Column& column) {
  std::string text = "rows";
  for (const std::size_t side : column.shape) text += fmt::format(" × {}", side);
  return text;
}

std::string_view type_text(ElementType type) {
  constexpr std::string_view kWords[] = {"u8", "u16", "u32", "u64", "f32", "f64", "text"};
  return kWords[static_cast<std::size_t>(type)];
}

std::string columns_text(const CardFacts& facts) {
  std::string text =
      "\n## Columns\n\nA row of `/tasks` is a task, of `/goals` a goal, of `/motions/…` a motion. "
      "The "
      "column `task` tells the\ntask that it belongs to.\n";
  std::vector<Table> tables = empty_tables();
  tables.insert(tables.end(), facts.motions.begin(), facts.motions.end());
  for (const Table& table : tables) {
    text += fmt::format("\n### `{}`\n\n| column | shape | type | unit | |\n|---|---|---|---|---|\n",
                        table.path);
    for (const Column& column : table.columns) {
      std::string says = column.says;
      for (std::size_t k = 0; k < column.words.size(); ++k) {
        says +=
            fmt::format("{}{} {}", k == 0 ? (says.empty() ? "" : ": ") : ", ", k, column.words[k]);
      }
      text += fmt::format("| `{}` | {} | {} | {} | {} |\n", column.name, shape_text(column),
                          type_text(column.type), column.unit, says);
    }
  }
  return text;
}

std::string files_text(const CardFacts& facts) {
  return fmt::format(R"(
## Files

- `shard-000000.h5`, …: the data, HDF5. Each has the tables `/tasks`, `/goals`, `/obstacles` and
  `/missed`, and in `/motions` a table for each kind of body: bodies with the same joints, nodes and
  parameters. The first 512 bytes of a file are text: its plan, its tasks and a SHA-256.
- `{}`: {}`/shards` with each file's SHA-256 and rows, `/splits` and `/statistics`.
- `{}`: the statistics as JSON, with mean, standard deviation, least and most of each joint.
- `{}`: the plan.
)",
                     kIndexName,
                     facts.mapped ? "each table of the shards as one (virtual datasets, which read "
                                    "from the shards beside it), "
                                  : "",
                     kStatisticsName, kPlanName);
}

constexpr std::string_view kConventions = R"(
## Conventions

- Metres, seconds, kilograms, radians, newton metres.
- World: right-handed, y up. At the start the body faces +z, and its left is +x.
- A motion has 61 frames at equal times: frame k is at `duration_s` · k / 60. Frame 0 is the start
  posture, frame 60 the end. A piece of work has 241, and `actions` and `things` name what it does
  with what.
- Quaternions are x, y, z, w, and unit. That of a node is its turn in its parent.
- The attributes `joints`, `nodes`, `node_parents`, `parameters`, `criteria` and `feet` of a table of
  motions name what its columns have side by side.
- Joints have one order whichever foot the body stands on. Those of robots have the names and the
  directions of their file.
- NaN stands where there is no number. Numbers that stand for words have the attribute `words`.
)";

std::string split_row(std::string_view name, const SplitShares& shares) {
  std::string text = fmt::format("| `{}` |", name);
  for (const SplitCounts& counts : shares) {
    text += fmt::format(" {} ({}) |", counts.tasks, counts.motions);
  }
  return text + "\n";
}

std::string splits_text(const CardFacts& facts) {
  const bool numbered = facts.plan.people() > 0;
  std::string text = fmt::format(R"(
## Splits

`/splits` of the index has a row for each task. `by_person` keeps each person in one part alone ({}).
`by_region` keeps each region of the first goal in one part alone: cells of {} m in height, {} m in
distance and {:.0f}° in direction, so that the regions of a part are unseen in the others. A hash puts
{} % of people, or of regions, into `train`, {} % into `validation` and {} % into `test`, the same in
every data set. Of few people or regions a part may have none. Refused tasks are in `none`.
)",
                                 numbered ? "by the person's number"
                                          : "the same character, sex, stature to the centimetre "
                                            "and mass to the kilogram",
                                 kRegionSize, kRegionSize, kRegionTurnDeg, kSplitPercent[0],
                                 kSplitPercent[1], kSplitPercent[2]);
  if (facts.statistics == nullptr) return text;
  text += "\nTasks, and motions in brackets:\n\n| |";
  std::string line = "|---|";
  for (const auto& [split, word] : kEnumWords<Split>) {
    text += fmt::format(" {} |", word);
    line += "---|";
  }
  return text + "\n" + line + "\n" + split_row("by_person", facts.statistics->by_person) +
         split_row("by_region", facts.statistics->by_region);
}

constexpr std::string_view kLimits = R"(
## Limits

- The motions are synthetic. A search made them; none was captured, and no person took part. People
  of a stature, a mass and a sex are scaled models.
- They are good by the program's criteria and no better: joint limits, balance, strength, discomfort,
  collisions, pressure under the feet, and a few laws of how people reach. The criteria know nothing of
  pain, fatigue, habit, age, clothes, mood or skill, of what the eyes see, of slipping, or of soft
  tissue.
- Beside recorded people they differ; the program's `docs/people.md` measures by how much. Do not take
  them for a measurement of people, nor for a proof that a movement is safe.
- There is one kind of task: from a start posture, feet planted or sitting, to goals at the end. There
  is no walking, no contact that begins on the way, no object that answers, and no other person.
- The motions of one task are ways to do it, not a sample of what people would do. How often a style
  comes here says nothing of how often people choose it.
- A `verdict` of `impossible` means that the body could not make the motion. Leave such motions out
  where they are to be real.
- Torques are computed from the motion (inverse dynamics of rigid segments), not measured. The
  program gives motions their durations, where the plan does not.
)";

std::string licence(const CardFacts& facts) {
  const std::string given = one_line(facts.plan.licence());
  return fmt::format("\n## Licence\n\n{}\n",
                     given.empty() ? "No licence was given: ask whoever made the data." : given);
}

constexpr std::string_view kManyFiles = R"(
HDF5 keeps each shard open that a column was read from. Beyond the system's limit of open files
(`ulimit -n`), and where a shard is not there, it gives NaN, and of whole numbers the largest, without
an error. Of many shards read stretches of rows and open the index anew between them, or read the
shards one by one; `/shards/rows` tells how many rows each has.
)";

// An example to run in the folder.
std::string loading(const CardFacts& facts) {
  const Table& table = facts.motions.front();
  const Column* angles = table.find("angles");
  const std::string from =
      facts.mapped ? "index" : fmt::format("h5py.File(\"{}\")", shard_name(facts.first_shard));
  return fmt::format(R"(
## How to load it

```python
import h5py, numpy as np
index = h5py.File("{}")
motions = {}["{}"]
row = np.searchsorted(index["splits/task"][:], motions["task"][:])  # of each motion's task
train = np.flatnonzero(index["splits/by_person"][:][row] == 0)
one = motions["{}"][train[0]]{}
```
)",
                     kIndexName, from, table.path.substr(1), angles != nullptr ? "angles" : "score",
                     angles == nullptr ? ""
                                       : fmt::format("  # {} frames × {} joints, rad",
                                                     angles->shape.front(), angles->shape.back())) +
         std::string(facts.mapped ? kManyFiles : "");
}

constexpr std::string_view kChecking = R"(
## How to check it

`shigusa dataset check .` in this folder compares every byte with the sums that the files have, makes
a share of the tasks again and compares all of their numbers. `--share 1` makes all of them again.
)";

}  // namespace

std::string format_card(const CardFacts& facts) {
  std::string text = beginning(facts) + origin(facts) + contents(facts) + files_text(facts);
  text += kConventions;
  text += columns_text(facts) + splits_text(facts);
  text += kLimits;
  text += licence(facts);
  // without shards there is no index to load
  if (facts.statistics != nullptr && !facts.motions.empty()) text += loading(facts);
  text += kChecking;
  return text;
}

std::vector<Table> planned_tables(const DatasetPlan& plan) {
  for (std::uint64_t number = 0; number < std::min(plan.tasks(), kTriedTasks); ++number) {
    Result<DrawnTask> drawn = plan.task(number);
    if (!drawn) continue;
    const Result<Task> task = make_task(drawn->file, {});
    if (!task) continue;
    return {MotionTable(drawn->file, *task, plan.series()).take()};
  }
  return {};
}

}  // namespace shigusa
