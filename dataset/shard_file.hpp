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

// The place of a shard in its data set. It stands in plain text in the first bytes of the file,
// before what HDF5 has, with the SHA-256 of all that follows: a change of any byte can be found,
// and no reader of HDF5 minds.
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

// The bytes that the head has at the beginning of a file: the least that HDF5 lets a user have.
inline constexpr std::size_t kHeadSize = 512;
// A larger file is no shard.
inline constexpr std::size_t kShardFileMaxBytes = std::size_t{256} << 20;

// The bytes of a shard's file.
[[nodiscard]] Result<std::string> format_shard(const ShardHead& head, const std::string& plan_text,
                                               const std::vector<Table>& tables);

// The bytes that a file begins with, at most kHeadSize.
[[nodiscard]] std::string first_bytes(const Descriptor& file);

// Parses a head; none where that is no shard's.
[[nodiscard]] std::optional<ShardHead> parse_head(std::string_view bytes);
// The head of a shard's file; nothing where there is no such file, and an error where it is no
// shard.
[[nodiscard]] Result<std::optional<ShardHead>> read_head(const std::filesystem::path& path);

// The bytes of a shard's file by what HDF5 has of it.
[[nodiscard]] std::string with_head(const ShardHead& head, std::string image);

using hdf5::RowRange;

// A shard that is open for reading, which a stranger may have made: what it holds are the tables
// that this program writes, of numbers that may stand there.
class ShardReader {
 public:
  // Fails on a file whose bytes are not those that its head tells, and on tables of another form.
  [[nodiscard]] static Result<ShardReader> open(const std::filesystem::path& path);
  ShardReader(ShardReader&&) noexcept;
  ShardReader& operator=(ShardReader&&) noexcept;
  ~ShardReader();

  [[nodiscard]] const ShardHead& head() const { return head_; }
  // The sentence about the shard's axes.
  [[nodiscard]] Result<std::string> axes() const;
  // The plan's text, as DatasetPlan::text.
  [[nodiscard]] Result<std::string> plan_text() const;
  // The paths of the motions' tables, sorted.
  [[nodiscard]] Result<std::vector<std::string>> motion_tables() const;
  // A table with these of its columns, or all; and of these only rows first to last. Fails on
  // numbers that cannot stand there.
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
