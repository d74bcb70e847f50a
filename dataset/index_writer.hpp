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

// An index under construction: a temporary file that is renamed when complete and flushed, and
// removed otherwise.
class IndexFile {
 public:
  [[nodiscard]] static Result<IndexFile> create(const std::filesystem::path& path);

  [[nodiscard]] const hdf5::Handle& file() const { return file_; }
  // Writes the head and renames the file; returns its size.
  [[nodiscard]] Result<std::uint64_t> finish(const IndexHead& head);

 private:
  std::filesystem::path path_;
  Staging staging_;
  Descriptor self_;
  hdf5::Handle file_;
};

// A table written in batches of rows.
class RowWriter {
 public:
  // `columns`: the columns without rows; `rows`: the final number of rows.
  [[nodiscard]] static Result<RowWriter> create(const hdf5::Handle& group, Table columns,
                                                std::size_t rows);
  // The table to which rows are added; call flush() regularly.
  [[nodiscard]] Table& rows() { return table_; }
  // Adds the rows of a table with the same columns.
  void add(const Table& more);
  // Writes the pending rows if there are many; `all`: in any case.
  [[nodiscard]] Result<void> flush(bool all = false);

 private:
  Table table_;
  std::vector<hdf5::Handle> datasets_;
  std::size_t written_ = 0;
};

}  // namespace shigusa
