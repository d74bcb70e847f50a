// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

namespace shigusa {

// Head of an index: plain text before the HDF5 data, as in shards, with a checksum of all following
// bytes and one canonical form.
struct IndexHead {
  std::string plan;          // its digest
  std::uint64_t shards = 0;  // that it is of
  std::string sha256{};      // of all bytes after the head
};

// Bytes of a head, kHeadSize of them.
[[nodiscard]] std::string format_index_head(const IndexHead& head);

// Parses the head of an index and verifies its checksum. Fails on a file that is no index, or a
// damaged one.
[[nodiscard]] Result<IndexHead> verified_index(const std::filesystem::path& path);

// The list of an index's shards.
inline constexpr const char* kShardsTable = "/shards";
inline constexpr std::size_t kSumSize = 64;  // of a SHA-256 in digits

// A shard in the list of an index.
struct ListedShard {
  std::uint64_t number = 0;
  std::string sha256;
};
// List of shards of an untrusted index.
[[nodiscard]] Result<std::vector<ListedShard>> listed_shards(const std::filesystem::path& path);

}  // namespace shigusa
