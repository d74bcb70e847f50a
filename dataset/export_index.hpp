// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "export_writer.hpp"

namespace shigusa {

// A file written in pieces that gets its name when complete.
class LongFile {
 public:
  [[nodiscard]] Result<void> begin(const std::filesystem::path& path);
  [[nodiscard]] Result<void> add(std::string_view text);
  [[nodiscard]] Result<void> finish();

 private:
  [[nodiscard]] Result<void> write_out();

  std::filesystem::path path_;
  Staging staging_;
  Descriptor file_;
  std::string waiting_;
};

// A line of CSV (RFC 4180, but with LF line ends): numbers with the fewest digits that read back
// exactly, empty if absent.
class CsvLine {
 public:
  void add(std::string_view text);
  void add(double number);
  void add(std::uint64_t number);
  // Part `k` of a column's number in a row, by the column's type.
  void add(const Column& column, std::size_t row, std::size_t k);
  [[nodiscard]] std::string take();

 private:
  void part();
  std::string text_;
  bool begun_ = false;
};

// Writer of index.csv: a row per motion, with all of its numbers and those of its task. Borrows the
// job.
class ExportIndex {
 public:
  // Collects the columns of all shards.
  [[nodiscard]] Result<void> begin(const ExportJob& job);
  // `file`: of the motion, in the export's folder, or empty.
  [[nodiscard]] Result<void> add(const DataMotion& motion, std::string_view file);
  [[nodiscard]] Result<void> finish() { return file_.finish(); }
  [[nodiscard]] std::uint64_t motions() const { return motions_; }

 private:
  // A column of the motions' tables, or one number of a vector column.
  struct Number {
    std::string column;
    std::string list;  // that names the numbers of the column; empty of one number alone
    std::string name;  // in the list
    friend bool operator==(const Number&, const Number&) = default;
  };
  void know(const Table& table);
  void add_number(const Row& motion, const Number& number, CsvLine& line) const;

  const DatasetPlan* plan_ = nullptr;
  std::vector<Number> numbers_;
  std::size_t goals_ = 0;  // the most of a task
  LongFile file_;
  std::uint64_t motions_ = 0;
};

}  // namespace shigusa
