// SPDX-License-Identifier: MIT
#include "index_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <random>
#include <system_error>

#include "files/sha256.hpp"
#include "shard_file.hpp"

namespace shigusa {
namespace {

// Rows are written when they are this many: of what is packed together in the file a few times.
constexpr std::size_t kHeldRows = std::size_t{1} << 16;

// Beside the file's place: a name as Staging has them, which removes it where this program is
// killed.
std::filesystem::path beside(const std::filesystem::path& path) {
  std::random_device random;
  return path.parent_path() / fmt::format(".shigusa-{:08x}{:08x}.tmp", random(), random());
}

}  // namespace

IndexFile::IndexFile(std::filesystem::path path, std::filesystem::path made)
    : path_(std::move(path)), made_(std::move(made)) {}

IndexFile::IndexFile(IndexFile&& other) noexcept
    : path_(std::move(other.path_)),
      made_(std::exchange(other.made_, {})),
      self_(std::move(other.self_)),
      file_(std::move(other.file_)) {}

IndexFile::~IndexFile() {
  std::error_code ignored;
  if (!made_.empty()) std::filesystem::remove(made_, ignored);
}

Result<IndexFile> IndexFile::create(const std::filesystem::path& path) {
  IndexFile index(path, beside(path));
  index.self_ = open_at(AT_FDCWD, index.made_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW);
  if (!index.self_) {
    index.made_.clear();
    return refused(path, "write", errno);
  }
  (void)flock(index.self_.number(), LOCK_EX | LOCK_NB);
  SHG_TRY_ASSIGN(index.file_, hdf5::create_on_disk(index.made_, kHeadSize));
  return index;
}

Result<std::uint64_t> IndexFile::finish(const IndexHead& head) {
  // HDF5 writes the last of it when the file is closed, and tells of a full disk before that
  if (H5Fflush(file_.id(), H5F_SCOPE_LOCAL) < 0) return hdf5::failed("write", path_.string());
  file_ = {};
  IndexHead whole = head;
  if (lseek(self_.number(), kHeadSize, SEEK_SET) < 0) return refused(path_, "write", errno);
  whole.sha256 = sha256_of(self_);
  const off_t size = lseek(self_.number(), 0, SEEK_END);
  if (whole.sha256.empty() || size < 0) return refused(path_, "write", errno);
  if (lseek(self_.number(), 0, SEEK_SET) != 0) return refused(path_, "write", errno);
  if (const int reason = write_all(self_, format_index_head(whole))) {
    return refused(path_, "write", reason);
  }
  if (fsync(self_.number()) != 0 || std::rename(made_.c_str(), path_.c_str()) != 0) {
    return refused(path_, "write", errno);
  }
  made_.clear();
  const Descriptor folder = open_at(AT_FDCWD, path_.parent_path().c_str(), O_RDONLY | O_DIRECTORY);
  if (folder) fsync(folder.number());
  return static_cast<std::uint64_t>(size);
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
