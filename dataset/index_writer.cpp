// SPDX-License-Identifier: MIT
#include "index_writer.hpp"

#include <fmt/format.h>

#include <cerrno>

#include "files/sha256.hpp"
#include "shard_file.hpp"

namespace shigusa {
namespace {

// Number of rows written at once: a few compressed chunks.
constexpr std::size_t kHeldRows = std::size_t{1} << 16;

}  // namespace

Result<IndexFile> IndexFile::create(const std::filesystem::path& path) {
  IndexFile index;
  index.path_ = path;
  const std::string name = path.filename().string();
  int reason = index.staging_.open(path.parent_path());
  if (reason == 0) reason = index.staging_.make();
  if (reason != 0) return refused(path, "write", reason);
  index.self_ = index.staging_.create(name);
  if (!index.self_) return refused(path, "write", errno);
  SHG_TRY_ASSIGN(index.file_, hdf5::create_on_disk(index.staging_.path_of(name), kHeadSize));
  return index;
}

Result<std::uint64_t> IndexFile::finish(const IndexHead& head) {
  // HDF5 writes the last data on closing, after its last report of errors such as a full disk
  if (H5Fflush(file_.id(), H5F_SCOPE_LOCAL) < 0) return hdf5::failed("write", path_.string());
  file_ = {};
  IndexHead whole = head;
  int reason = go_to(self_, kHeadSize);
  if (reason != 0) return refused(path_, "write", reason);
  whole.sha256 = sha256_of(self_);
  const std::optional<std::uint64_t> size = go_to_end(self_);
  if (whole.sha256.empty() || !size) return refused(path_, "write", errno);
  const std::string name = path_.filename().string();
  reason = go_to(self_, 0);
  if (reason == 0) reason = write_all(self_, format_index_head(whole));
  if (reason == 0) reason = settle(self_);
  if (reason == 0) reason = staging_.move_out(name, name);
  if (reason != 0) return refused(path_, "write", reason);
  (void)settle(staging_.folder());
  return *size;
}

Result<RowWriter> RowWriter::create(const hdf5::Handle& group, Table columns, std::size_t rows) {
  RowWriter writer;
  for (const Column& column : columns.columns) {
    SHG_TRY_ASSIGN(hdf5::Handle dataset, hdf5::create_column(group, column, rows));
    SHG_TRY(hdf5::describe(dataset, column));
    writer.datasets_.push_back(std::move(dataset));
  }
  writer.table_ = std::move(columns);
  return writer;
}

void RowWriter::add(const Table& more) {
  for (std::size_t k = 0; k < table_.columns.size(); ++k) {
    table_.columns[k].bytes += more.columns[k].bytes;
  }
}

Result<void> RowWriter::flush(bool all) {
  const std::size_t rows = table_.rows();
  if (rows == 0 || (!all && rows < kHeldRows)) return {};
  for (std::size_t k = 0; k < datasets_.size(); ++k) {
    SHG_TRY(hdf5::write_rows(datasets_[k], table_.columns[k], written_));
    table_.columns[k].bytes.clear();
  }
  written_ += rows;
  return {};
}

}  // namespace shigusa
