// SPDX-License-Identifier: MIT
#include "export_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <tuple>

#include "shard_list.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;  // that is written at once

// Columns of the tasks' table, without the task number and columns that motions have too.
constexpr std::array kTaskFields{"person",    "character", "preset", "sex",
                                 "stature_m", "mass_kg",   "seat_m", "status"};

// Columns of a goal, with their widths.
struct GoalColumn {
  std::string_view column;
  std::size_t parts;
};
constexpr std::array kGoalFields{GoalColumn{"position_m", 3},    GoalColumn{"load_kg", 1},
                                 GoalColumn{"rotation_xyzw", 4}, GoalColumn{"axis", 3},
                                 GoalColumn{"direction", 3},     GoalColumn{"tolerance_m", 3}};

// List of names of a column's numbers; empty if it has none.
std::string list_of(const Column& column) {
  if (column.name == "penalties") return "criteria";
  if (column.name.starts_with("action_")) return "actions";
  if (column.name == "thing_mass_kg") return "things";
  return column.name == "parameters" ? column.name : std::string();
}

// Column name of one number: "penalties.balance", "parameters.bow", "position_m.x",
// "rotation_xyzw.w".
std::string part_name(std::string_view column, std::size_t k, std::size_t parts) {
  if (parts == 1) return std::string(column);
  return fmt::format("{}.{}", column, "xyzw"[k]);
}

}  // namespace

Result<void> LongFile::begin(const std::filesystem::path& path) {
  path_ = path;
  int reason = staging_.open(path.parent_path());
  if (reason == 0) reason = staging_.make();
  if (reason != 0) return refused(path, "write", reason);
  file_ = staging_.create(path.filename().string());
  return file_ ? Result<void>{} : refused(path, "write", errno);
}

Result<void> LongFile::write_out() {
  if (const int reason = write_all(file_, waiting_); reason != 0) {
    return refused(path_, "write", reason);
  }
  waiting_.clear();
  return {};
}

Result<void> LongFile::add(std::string_view text) {
  waiting_ += text;
  if (waiting_.size() < kPiece) return {};
  return write_out();
}

Result<void> LongFile::finish() {
  SHG_TRY(write_out());
  int reason = file_.close();
  const std::string name = path_.filename().string();
  if (reason == 0) reason = staging_.move_out(name, name);
  return reason == 0 ? Result<void>{} : refused(path_, "write", reason);
}

void CsvLine::part() {
  if (begun_) text_ += ',';
  begun_ = true;
}

void CsvLine::add(std::string_view text) {
  part();
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    text_ += text;
    return;
  }
  text_ += '"';
  for (const char c : text) {
    if (c == '"') text_ += '"';
    text_ += c;
  }
  text_ += '"';
}

void CsvLine::add(double number) {
  part();
  if (is_finite(number)) text_ += fmt::format("{}", number);
}

void CsvLine::add(std::uint64_t number) {
  part();
  text_ += fmt::format("{}", number);
}

void CsvLine::add(const Column& column, std::size_t row, std::size_t k) {
  const double number = number_in(column, row, k);
  if (column.type == ElementType::f64 || !is_finite(number)) return add(number);
  part();
  // with the digits of the number
  text_ += column.type == ElementType::f32 ? fmt::format("{}", static_cast<float>(number))
                                           : fmt::format("{}", static_cast<std::uint64_t>(number));
}

std::string CsvLine::take() {
  std::string line = std::move(text_) + "\n";
  text_.clear();
  begun_ = false;
  return line;
}

void ExportIndex::know(const Table& table) {
  const auto learn = [this](Number number) {
    if (std::find(numbers_.begin(), numbers_.end(), number) == numbers_.end()) {
      numbers_.push_back(std::move(number));
    }
  };
  for (const Column& column : table.columns) {
    const std::string list = list_of(column);
    if (column.name == "task" || column.name == "rank" || column.shape.size() > 1) continue;
    if (list.empty()) {
      learn({column.name, "", ""});
      continue;
    }
    for (const std::string& name : *table.names_of(list)) learn({column.name, list, name});
  }
}

Result<void> ExportIndex::begin(const ExportJob& job) {
  plan_ = &job.data.plan;
  for (const std::uint64_t shard : job.data.shards) {
    SHG_TRY_ASSIGN(const ShardReader reader, open_shard(*plan_, job.data.folder, shard));
    SHG_TRY_ASSIGN(const std::vector<std::string> paths, reader.motion_tables());
    for (const std::string& path : paths) {
      SHG_TRY_ASSIGN(const Table empty, reader.table(path, {}, {0, 0}));
      know(empty);
    }
    SHG_TRY_ASSIGN(const Table goals, reader.table(kGoalsTable, {"task"}));
    std::map<std::uint64_t, std::size_t> of_task;
    for (std::size_t at = 0; at < goals.rows(); ++at) {
      goals_ = std::max(goals_, ++of_task[Row{&goals, at}.whole("task")]);
    }
  }
  // single numbers first, then lists, whichever body is first
  std::stable_sort(numbers_.begin(), numbers_.end(), [](const Number& a, const Number& b) {
    return std::tie(a.list, a.name) < std::tie(b.list, b.name);
  });
  CsvLine line;
  for (const char* name : {"motion", "file", "split", "task", "rank"}) line.add(name);
  for (const char* name : kTaskFields) line.add(name);
  for (std::size_t g = 1; g <= goals_; ++g) {
    line.add(fmt::format("goal{}.effector", g));
    for (const auto& [column, parts] : kGoalFields) {
      for (std::size_t k = 0; k < parts; ++k) {
        line.add(fmt::format("goal{}.{}", g, part_name(column, k, parts)));
      }
    }
  }
  for (const Number& number : numbers_) {
    line.add(number.list.empty() ? number.column : number.column + "." + number.name);
  }
  SHG_TRY(file_.begin(job.settings.to / "index.csv"));
  return file_.add(line.take());
}

void ExportIndex::add_number(const Row& motion, const Number& number, CsvLine& line) const {
  const Column* column = motion.table->find(number.column);
  if (column == nullptr) return line.add("");
  if (number.list.empty()) {
    const bool told = column->type == ElementType::text || !column->words.empty();
    return told ? line.add(motion.text(number.column)) : line.add(*column, motion.at, 0);
  }
  const std::vector<std::string>& names = *motion.table->names_of(number.list);
  const auto place = std::find(names.begin(), names.end(), number.name);
  if (place == names.end()) return line.add("");
  line.add(*column, motion.at, static_cast<std::size_t>(place - names.begin()));
}

Result<void> ExportIndex::add(const DataMotion& motion, std::string_view file) {
  CsvLine line;
  line.add(motion.id());
  line.add(file);
  line.add(word_of(split_of(motion, *plan_)));
  line.add(motion.number());
  line.add(motion.rank());
  for (const char* name : kTaskFields) {
    const Column* column = motion.task.table->find(name);
    const bool told =
        column == nullptr || column->type == ElementType::text || !column->words.empty();
    told ? line.add(motion.task.text(name)) : line.add(*column, motion.task.at, 0);
  }
  for (std::size_t g = 0; g < goals_; ++g) {
    const bool there = g < motion.goals.size();
    line.add(there ? motion.goals[g].text("effector") : "");
    for (const auto& [column, parts] : kGoalFields) {
      for (std::size_t k = 0; k < parts; ++k) {
        line.add(there ? motion.goals[g].number(column, k) : kNoNumber);
      }
    }
  }
  for (const Number& number : numbers_) add_number(motion.motion, number, line);
  ++motions_;
  return file_.add(line.take());
}

}  // namespace shigusa
