// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

namespace shigusa {

// The first bytes of an index, in plain text before what HDF5 has, as a shard's: a change of any
// byte after them can be found, and the head has one form alone.
struct IndexHead {
  std::string plan;          // its digest
  std::uint64_t shards = 0;  // that it is of
  std::string sha256{};      // of all bytes after the head
};

// The bytes of a head, kHeadSize of them.
[[nodiscard]] std::string format_index_head(const IndexHead& head);

// Parses the head of an index and compares the sum of its bytes. Fails on a file that is no index,
// or a damaged one.
[[nodiscard]] Result<IndexHead> verified_index(const std::filesystem::path& path);

// The list of an index's shards.
inline constexpr const char* kShardsTable = "/shards";
inline constexpr std::size_t kSumSize = 64;  // of a SHA-256 in digits

// A shard as an index lists it.
struct ListedShard {
  std::uint64_t number = 0;
  std::string sha256;
};
// The list of an index that a stranger may have made.
[[nodiscard]] Result<std::vector<ListedShard>> listed_shards(const std::filesystem::path& path);

}  // namespace shigusa
