// SPDX-License-Identifier: MIT
#include "shard_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <sstream>

#include "files/descriptor.hpp"
#include "files/file.hpp"
#include "files/sha256.hpp"
#include "hdf5.hpp"
#include "shard_form.hpp"
#include "stored_table.hpp"
#include "task_rows.hpp"

namespace shigusa {
namespace {

using hdf5::Handle;

constexpr std::string_view kTitle = "shigusa data set, shard";
constexpr std::size_t kDigits = 64;  // of a SHA-256

// Head without its checksum.
std::string head_text(const ShardHead& head) {
  return fmt::format("{} version {}\nplan {}\nshard {}\ntasks {} {}\n", kTitle, kDatasetVersion,
                     head.plan, head.shard, head.tasks.first, head.tasks.last);
}

std::string format_head(const ShardHead& head) {
  std::string text = head_text(head) + fmt::format("sha256 {}\n", head.sha256);
  text.resize(kHeadSize, '\0');
  return text;
}

Result<void> write_table(const Handle& file, const Table& table) {
  SHG_TRY_ASSIGN(const Handle group, hdf5::create_group(file, table.path));
  for (const auto& [what, list] : table.names) {
    SHG_TRY(hdf5::write_texts(group, what.c_str(), list));
  }
  for (const Column& column : table.columns) {
    SHG_TRY(hdf5::write_column(group, column));
  }
  return {};
}

// Parses a line "KEY A B" of a head.
bool take_line(std::istringstream& lines, std::string_view key, std::string& value) {
  std::string line;
  if (!std::getline(lines, line) || !line.starts_with(key) || line.size() <= key.size()) {
    return false;
  }
  value = line.substr(key.size() + 1);
  return line[key.size()] == ' ';
}

bool take_number(std::string_view& text, std::uint64_t& number) {
  const char* const end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, number);
  text = std::string_view(stop, static_cast<std::size_t>(end - stop));
  return code == std::errc{};
}

bool is_digest(const std::string& text) {
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

struct ShardReader::Open {
  hdf5::Reader reader;
  std::string path;
  StoredTables tables;
};

ShardReader::ShardReader(std::unique_ptr<Open> open, ShardHead head)
    : open_(std::move(open)), head_(std::move(head)) {}
ShardReader::ShardReader(ShardReader&&) noexcept = default;
ShardReader& ShardReader::operator=(ShardReader&&) noexcept = default;
ShardReader::~ShardReader() = default;

Result<std::string> format_shard(const ShardHead& head, const std::string& plan_text,
                                 const std::vector<Table>& tables) {
  SHG_TRY_ASSIGN(const Handle file, hdf5::create_in_memory());
  SHG_TRY_ASSIGN(const Handle root, [&]() -> Result<Handle> {
    return Handle(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
  }());
  SHG_TRY(hdf5::write_text(root, "format", "shigusa data set"));
  SHG_TRY(hdf5::write_number(root, "version", kDatasetVersion));
  SHG_TRY(hdf5::write_long_text(root, "plan", plan_text));
  SHG_TRY(hdf5::write_text(root, "plan_sha256", head.plan));
  SHG_TRY(hdf5::write_number(root, "shard", head.shard));
  SHG_TRY(hdf5::write_number(root, "first_task", head.tasks.first));
  SHG_TRY(hdf5::write_number(root, "last_task", head.tasks.last));
  SHG_TRY(hdf5::write_text(
      root, "axes",
      "metres, seconds, kilograms, radians; y up, x to the left of the body, which faces z"));
  for (const Table& table : tables) {
    SHG_TRY(write_table(file, table));
  }
  SHG_TRY_ASSIGN(std::string image, hdf5::image_of(file));
  return with_head(head, std::move(image));
}

std::string with_head(const ShardHead& head, std::string image) {
  ShardHead whole = head;
  whole.sha256 = sha256(head_text(head) + image);
  image.insert(0, format_head(whole));
  return image;
}

std::string first_bytes(const Descriptor& file) {
  std::string bytes(kHeadSize, '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const std::ptrdiff_t count = read_some(file, bytes.data() + size, bytes.size() - size);
    if (count <= 0) break;
    size += static_cast<std::size_t>(count);
  }
  bytes.resize(size);
  return bytes;
}

std::optional<ShardHead> parse_head(std::string_view bytes) {
  if (bytes.size() < kHeadSize) return std::nullopt;
  std::istringstream lines{std::string(bytes.substr(0, kHeadSize))};
  ShardHead head;
  std::string version;
  std::string shard;
  std::string tasks;
  const bool whole = take_line(lines, fmt::format("{} version", kTitle), version) &&
                     take_line(lines, "plan", head.plan) && take_line(lines, "shard", shard) &&
                     take_line(lines, "tasks", tasks) && take_line(lines, "sha256", head.sha256);
  if (!whole || version != std::to_string(kDatasetVersion)) return std::nullopt;
  std::string_view number = shard;
  std::string_view range = tasks;
  const bool read = take_number(number, head.shard) && number.empty() &&
                    take_number(range, head.tasks.first) && range.starts_with(' ') &&
                    (range.remove_prefix(1), take_number(range, head.tasks.last)) && range.empty();
  if (!read || !is_digest(head.plan) || !is_digest(head.sha256)) return std::nullopt;
  return head;
}

Result<std::optional<ShardHead>> read_head(const std::filesystem::path& path) {
  const Descriptor file = open_to_read(path);
  if (!file && errno == ENOENT) return std::optional<ShardHead>{};
  if (!file) return refused(path, "read", errno);
  const std::optional<ShardHead> head = parse_head(first_bytes(file));
  if (!head) {
    return fail(ErrorCode::parse, "is no shard of a data set, or a damaged one", path.string());
  }
  return head;
}

Result<ShardReader> ShardReader::open(const std::filesystem::path& path) {
  const auto damaged = [&path](std::string_view how) {
    return fail(ErrorCode::parse, fmt::format("is damaged: {}", how), path.string());
  };
  SHG_TRY_ASSIGN(const std::string bytes, read_text_file(path, kShardFileMaxBytes));
  const std::optional<ShardHead> head = parse_head(bytes);
  if (!head) return damaged("its first bytes are no shard's");
  if (bytes.compare(0, kHeadSize, format_head(*head)) != 0 ||
      sha256(head_text(*head) + bytes.substr(kHeadSize)) != head->sha256) {
    return damaged("its bytes are not those that it was written with");
  }
  SHG_TRY_ASSIGN(hdf5::Reader reader,
                 told_of(path.string(), hdf5::Reader::open(hdf5::Source(bytes.substr(kHeadSize)))));
  SHG_TRY_ASSIGN(StoredTables tables, told_of(path.string(), stored_tables(reader)));
  return ShardReader(
      std::make_unique<Open>(Open{std::move(reader), path.string(), std::move(tables)}), *head);
}

Result<std::string> ShardReader::plan_text() const {
  return told_of(open_->path, open_->reader.text("/plan"));
}

Result<std::string> ShardReader::axes() const {
  SHG_TRY_ASSIGN(const hdf5::Object root, told_of(open_->path, open_->reader.object("/")));
  return told_of(open_->path, hdf5::text_of(root, "axes"));
}

Result<std::vector<std::string>> ShardReader::motion_tables() const {
  std::vector<std::string> paths;
  for (const auto& [path, table] : open_->tables) {
    if (path.starts_with(kMotionsGroup)) paths.push_back(path);
  }
  return paths;
}

Result<Table> ShardReader::table(const std::string& path, const std::vector<std::string>& columns,
                                 const RowRange& rows) const {
  const std::string place = open_->path + ": " + path;
  const auto stored = open_->tables.find(path);
  if (stored == open_->tables.end()) return fail(ErrorCode::parse, "is not there", place);
  std::vector<std::string> wanted = columns;
  if (wanted.empty()) {
    for (const hdf5::StoredColumn& one : stored->second.columns) wanted.push_back(one.column.name);
  }
  Table table = stored->second.names;
  for (const std::string& name : wanted) {
    const hdf5::StoredColumn* const one = stored->second.find(name);
    if (one == nullptr) return fail(ErrorCode::parse, "is not there", place + "/" + name);
    Column column = one->column;
    SHG_TRY_ASSIGN(column.bytes, told_of(place + "/" + name, open_->reader.rows(*one, rows)));
    table.columns.push_back(std::move(column));
  }
  SHG_TRY(told_of(place, check_values(table)));
  return table;
}

}  // namespace shigusa
