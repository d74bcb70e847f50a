// SPDX-License-Identifier: MIT
#include "index_reader.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <optional>
#include <shigusa/dataset.hpp>

#include "hdf5.hpp"
#include "io/descriptor.hpp"
#include "io/sha256.hpp"
#include "shard_file.hpp"

namespace shigusa {
namespace {

// A table of more bytes is read otherwise.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;

// The text between `key` and the end of its line; empty where there is none.
std::string value_of_line(std::string_view text, std::string_view key) {
  const std::size_t begin = text.find(key);
  if (begin == std::string_view::npos) return {};
  const std::string_view rest = text.substr(begin + key.size());
  return std::string(rest.substr(0, rest.find('\n')));
}

// A head in the one form that heads have; none elsewhere.
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

// Fills in a column's shape, its numbers and what it says.
Result<void> read_column(const hdf5::Handle& group, const std::string& table, Column& column) {
  const std::string place = table + "/" + column.name;
  const hdf5::Handle dataset(H5Dopen2(group.id(), column.name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset) return hdf5::failed("read", place);
  const hdf5::Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 1) return fail(ErrorCode::parse, "must have rows", place);
  std::vector<hsize_t> sides(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.id(), sides.data(), nullptr);
  column.shape.assign(sides.begin() + 1, sides.end());
  if (column.row_size() > 0 && sides[0] > kMostBytes / column.row_size()) {
    return fail(ErrorCode::unsupported,
                fmt::format("has more than the {} bytes that are read at once", kMostBytes), place);
  }
  column.bytes.resize(sides[0] * column.row_size());
  const hdf5::Handle type = hdf5::type_of(column, false);
  if (!column.bytes.empty() &&
      H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, column.bytes.data()) < 0) {
    return hdf5::failed("read", place);
  }
  for (const auto& [attribute, into] :
       {std::pair{"unit", &column.unit}, std::pair{"description", &column.says}}) {
    if (H5Aexists(dataset.id(), attribute) <= 0) continue;
    SHG_TRY_ASSIGN(*into, hdf5::read_text(dataset, attribute));
  }
  SHG_TRY_ASSIGN(column.words, hdf5::read_texts(dataset, "words"));
  return {};
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
  const Descriptor file = open_at(AT_FDCWD, path.c_str(), O_RDONLY | O_NONBLOCK);
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

Result<void> read_index(const std::filesystem::path& path, Table& table) {
  SHG_TRY_ASSIGN(const hdf5::Handle file, hdf5::open_file(path));
  const hdf5::Handle group(H5Gopen2(file.id(), table.path.c_str(), H5P_DEFAULT), H5Gclose);
  if (!group) return hdf5::failed("read", path.string() + ": " + table.path);
  for (auto& [what, list] : table.names) {
    SHG_TRY_ASSIGN(list, hdf5::read_texts(group, what.c_str()));
  }
  for (Column& column : table.columns) SHG_TRY(read_column(group, table.path, column));
  return {};
}

}  // namespace shigusa
