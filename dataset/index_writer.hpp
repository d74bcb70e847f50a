// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

#include "files/staging.hpp"
#include "hdf5.hpp"
#include "index_reader.hpp"
#include "table.hpp"

namespace shigusa {

// An index that is being written: a file beside its place, which gets its name when it is whole and
// on the disk, and goes where it is not.
class IndexFile {
 public:
  [[nodiscard]] static Result<IndexFile> create(const std::filesystem::path& path);

  [[nodiscard]] const hdf5::Handle& file() const { return file_; }
  // Gives the file its head and its name; its bytes.
  [[nodiscard]] Result<std::uint64_t> finish(const IndexHead& head);

 private:
  std::filesystem::path path_;
  Staging staging_;
  Descriptor self_;
  hdf5::Handle file_;
};

// A table whose rows come little by little, and of which few are held at a time.
class RowWriter {
 public:
  // `columns` has the columns without rows; `rows` is how many there will be.
  [[nodiscard]] static Result<RowWriter> create(const hdf5::Handle& group, Table columns,
                                                std::size_t rows);
  // The table to which rows are added; flush() is to be called now and then.
  [[nodiscard]] Table& rows() { return table_; }
  // Adds the rows of a table with the same columns.
  void add(const Table& more);
  // Writes what there is, if it is much; `all`: whatever it is.
  [[nodiscard]] Result<void> flush(bool all = false);

 private:
  Table table_;
  std::vector<hdf5::Handle> datasets_;
  std::size_t written_ = 0;
};

}  // namespace shigusa
