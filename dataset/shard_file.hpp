// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <shigusa/dataset.hpp>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/descriptor.hpp"
#include "hdf5_reader.hpp"
#include "table.hpp"

namespace shigusa {

// Position of a shard in its data set. It is plain text at the beginning of the file, before the
// HDF5 data, with the SHA-256 of all following bytes; HDF5 readers skip it as a user block.
struct ShardHead {
  std::string plan;  // its digest
  std::uint64_t shard = 0;
  TaskRange tasks;
  std::string sha256{};  // of the lines above it and all bytes after the head

  friend bool same_place(const ShardHead& a, const ShardHead& b) {
    return a.plan == b.plan && a.shard == b.shard && a.tasks.first == b.tasks.first &&
           a.tasks.last == b.tasks.last;
  }
};

// Size of the head: the least user block of HDF5.
inline constexpr std::size_t kHeadSize = 512;
// Largest size of a shard.
inline constexpr std::size_t kShardFileMaxBytes = std::size_t{256} << 20;

// Bytes of a shard's file.
[[nodiscard]] Result<std::string> format_shard(const ShardHead& head, const std::string& plan_text,
                                               const std::vector<Table>& tables);

// First bytes of a file, at most kHeadSize.
[[nodiscard]] std::string first_bytes(const Descriptor& file);

// Parses a head; empty if it is no shard's.
[[nodiscard]] std::optional<ShardHead> parse_head(std::string_view bytes);
// Head of a shard's file; empty if there is no such file, and an error if it is no shard.
[[nodiscard]] Result<std::optional<ShardHead>> read_head(const std::filesystem::path& path);

// Bytes of a shard's file from its HDF5 part.
[[nodiscard]] std::string with_head(const ShardHead& head, std::string image);

using hdf5::RowRange;

// An untrusted shard opened for reading: its tables have the form that this program writes, with
// values in range.
class ShardReader {
 public:
  // Fails on a file whose checksum differs, and on tables of another form.
  [[nodiscard]] static Result<ShardReader> open(const std::filesystem::path& path);
  ShardReader(ShardReader&&) noexcept;
  ShardReader& operator=(ShardReader&&) noexcept;
  ~ShardReader();

  [[nodiscard]] const ShardHead& head() const { return head_; }
  // Sentence about the shard's axes.
  [[nodiscard]] Result<std::string> axes() const;
  // Text of the plan, as DatasetPlan::text.
  [[nodiscard]] Result<std::string> plan_text() const;
  // Sorted paths of the motions' tables.
  [[nodiscard]] Result<std::vector<std::string>> motion_tables() const;
  // A table with some or all of its columns, and only the rows first to last. Fails on values out
  // of range.
  [[nodiscard]] Result<Table> table(const std::string& path,
                                    const std::vector<std::string>& columns = {},
                                    const RowRange& rows = {}) const;

 private:
  struct Open;
  ShardReader(std::unique_ptr<Open> open, ShardHead head);
  std::unique_ptr<Open> open_;
  ShardHead head_;
};

}  // namespace shigusa
