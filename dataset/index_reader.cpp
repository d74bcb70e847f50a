// SPDX-License-Identifier: MIT
#include "index_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <shigusa/dataset.hpp>

#include "files/descriptor.hpp"
#include "files/sha256.hpp"
#include "hdf5_reader.hpp"
#include "shard_file.hpp"
#include "shard_form.hpp"

namespace shigusa {
namespace {

// Text between `key` and the end of its line; empty if absent.
std::string value_of_line(std::string_view text, std::string_view key) {
  const std::size_t begin = text.find(key);
  if (begin == std::string_view::npos) return {};
  const std::string_view rest = text.substr(begin + key.size());
  return std::string(rest.substr(0, rest.find('\n')));
}

// Parses the canonical form of a head; empty for any other text.
std::optional<IndexHead> parse_index_head(std::string_view bytes) {
  IndexHead head{.plan = value_of_line(bytes, "\nplan "),
                 .sha256 = value_of_line(bytes, "\nsha256 ")};
  const std::string shards = value_of_line(bytes, "\nshards ");
  if (shards.empty() || shards.size() > 9) return std::nullopt;
  for (const char digit : shards) {
    if (digit < '0' || digit > '9') return std::nullopt;
    head.shards = head.shards * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  if (format_index_head(head) != bytes) return std::nullopt;
  return head;
}

}  // namespace

std::string format_index_head(const IndexHead& head) {
  std::string text =
      fmt::format("shigusa data set, index version {}\nplan {}\nshards {}\nsha256 {}\n",
                  kDatasetVersion, head.plan, head.shards, head.sha256);
  text.resize(kHeadSize, '\0');
  return text;
}

Result<IndexHead> verified_index(const std::filesystem::path& path) {
  const auto damaged = [&path](std::string_view how) {
    return fail(ErrorCode::parse, fmt::format("is damaged: {}", how), path.string());
  };
  const Descriptor file = open_to_read(path);
  if (!file) return refused(path, "read", errno);
  const std::string bytes = first_bytes(file);
  const std::optional<IndexHead> head =
      bytes.size() == kHeadSize ? parse_index_head(bytes) : std::nullopt;
  if (!head) return damaged("its first bytes are no index's");
  const std::string sum = sha256_of(file);
  if (sum.empty()) return refused(path, "read", errno);
  if (sum != head->sha256) return damaged("its bytes are not those that it was written with");
  return *head;
}

Result<std::vector<ListedShard>> listed_shards(const std::filesystem::path& path) {
  Descriptor file = open_to_read(path);
  if (!file) return refused(path, "read", errno);
  SHG_TRY_ASSIGN(const hdf5::Reader reader,
                 hdf5::Reader::open(hdf5::Source(std::move(file), kHeadSize)));
  SHG_TRY_ASSIGN(const hdf5::Object group, reader.object(kShardsTable));
  SHG_TRY_ASSIGN(const hdf5::Reader::Entries entries, reader.entries(group));
  const Column number{.name = "shard", .type = ElementType::u64};
  const Column sum{.name = "sha256", .type = ElementType::text, .text_size = kSumSize};
  std::vector<Column> columns;
  for (const Column& wanted : {number, sum}) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto& one) { return one.first == wanted.name; });
    if (entry == entries.end()) return fail(ErrorCode::parse, "is not there", wanted.name);
    SHG_TRY_ASSIGN(hdf5::StoredColumn stored, reader.column(entry->second, wanted.name));
    if (!same_column(stored.column, wanted) || stored.rows > kDatasetMaxShards) {
      return fail(ErrorCode::parse, "has another form than this program writes", wanted.name);
    }
    SHG_TRY_ASSIGN(stored.column.bytes, reader.rows(stored, {}));
    columns.push_back(std::move(stored.column));
  }
  const auto numbers = columns[0].as<std::uint64_t>();
  const std::vector<std::string> sums = columns[1].texts();
  if (numbers.size() != sums.size()) return fail(ErrorCode::parse, "has unlike columns", "");
  std::vector<ListedShard> list;
  for (std::size_t k = 0; k < sums.size(); ++k) list.push_back({numbers[k], sums[k]});
  return list;
}

}  // namespace shigusa
