// SPDX-License-Identifier: MIT
#include "shard_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <shigusa/file.hpp>
#include <sstream>

#include "hdf5.hpp"
#include "io/descriptor.hpp"
#include "io/sha256.hpp"

namespace shigusa {
namespace {

using hdf5::failed;
using hdf5::Handle;

constexpr std::string_view kTitle = "shigusa data set, shard";
constexpr std::size_t kDigits = 64;  // of a SHA-256

// All of a head but its sum.
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

// A line "KEY A B" of a head.
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

// The column of a dataset, without its numbers.
Result<Column> column_of(const Handle& dataset, const std::string& name,
                         std::vector<hsize_t>& sides) {
  Column column{.name = name};
  const Handle stored(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 1 || rank > 4) return fail(ErrorCode::parse, "must have one to four sides", name);
  sides.resize(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.id(), sides.data(), nullptr);
  const std::size_t size = H5Tget_size(stored.id());
  const H5T_class_t kind = H5Tget_class(stored.id());
  if (kind == H5T_STRING && H5Tis_variable_str(stored.id()) == 0) {
    column.type = ElementType::text;
    column.text_size = size;
  } else if (kind == H5T_INTEGER) {
    column.type = size == 1   ? ElementType::u8
                  : size == 2 ? ElementType::u16
                  : size == 4 ? ElementType::u32
                              : ElementType::u64;
  } else if (kind == H5T_FLOAT) {
    column.type = size == 4 ? ElementType::f32 : ElementType::f64;
  } else {
    return fail(ErrorCode::parse, "must be numbers or texts", name);
  }
  column.shape.assign(sides.begin() + 1, sides.end());
  for (const auto& [attribute, into] :
       {std::pair{"unit", &column.unit}, std::pair{"description", &column.says}}) {
    if (H5Aexists(dataset.id(), attribute) <= 0) continue;
    SHG_TRY_ASSIGN(*into, hdf5::read_text(dataset, attribute));
  }
  SHG_TRY_ASSIGN(column.words, hdf5::read_texts(dataset, "words"));
  return column;
}

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}
Result<std::vector<std::string>> names_in_group(const Handle& group, const std::string& path) {
  std::vector<std::string> names;
  if (H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names) < 0) {
    return failed("read a group", path);
  }
  return names;
}

herr_t add_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  return add_name(0, name, nullptr, names);
}

}  // namespace

struct ShardReader::Open {
  Handle file;
  std::string path;
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
  ShardHead whole = head;
  whole.sha256 = sha256(head_text(head) + image);
  image.insert(0, format_head(whole));
  return image;
}

std::string first_bytes(const Descriptor& file) {
  std::string bytes(kHeadSize, '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t count = read_some(file, bytes.data() + size, bytes.size() - size);
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
  const Descriptor file = open_at(AT_FDCWD, path.c_str(), O_RDONLY | O_NONBLOCK);
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
  auto open = std::make_unique<Open>();
  open->path = path.string();
  SHG_TRY_ASSIGN(open->file, hdf5::open_file(path));
  return ShardReader(std::move(open), *head);
}

Result<std::string> ShardReader::plan_text() const {
  const Handle root(H5Gopen2(open_->file.id(), "/", H5P_DEFAULT), H5Gclose);
  return hdf5::read_long_text(root, "plan");
}

Result<std::vector<std::string>> ShardReader::motion_tables() const {
  std::vector<std::string> paths;
  if (H5Lexists(open_->file.id(), "/motions", H5P_DEFAULT) <= 0) return paths;
  const Handle group(H5Gopen2(open_->file.id(), "/motions", H5P_DEFAULT), H5Gclose);
  if (!group) return failed("read", open_->path + ": /motions");
  SHG_TRY_ASSIGN(const std::vector<std::string> names, names_in_group(group, "/motions"));
  for (const std::string& name : names) paths.push_back("/motions/" + name);
  return paths;
}

Result<Table> ShardReader::table(const std::string& path, const std::vector<std::string>& columns,
                                 const RowRange& rows) const {
  const std::string place = open_->path + ": " + path;
  const Handle group(H5Gopen2(open_->file.id(), path.c_str(), H5P_DEFAULT), H5Gclose);
  if (!group) return failed("read", place);
  Table table{.path = path};
  std::vector<std::string> lists;
  H5Aiterate2(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add_attribute, &lists);
  for (const std::string& list : lists) {
    SHG_TRY_ASSIGN(std::vector<std::string> names, hdf5::read_texts(group, list.c_str()));
    table.names.emplace_back(list, std::move(names));
  }
  std::vector<std::string> wanted = columns;
  if (wanted.empty()) {
    SHG_TRY_ASSIGN(wanted, names_in_group(group, path));
  }
  for (const std::string& name : wanted) {
    const Handle dataset(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset) return failed("read", place + "/" + name);
    std::vector<hsize_t> sides;
    SHG_TRY_ASSIGN(Column column, column_of(dataset, name, sides));
    const hsize_t first = std::min<hsize_t>(rows.first, sides[0]);
    const hsize_t last = std::min<hsize_t>(rows.last.value_or(sides[0]), sides[0]);
    std::vector<hsize_t> start(sides.size(), 0);
    std::vector<hsize_t> count = sides;
    start[0] = first;
    count[0] = last > first ? last - first : 0;
    const std::size_t size = count[0] * column.row_size();
    if (size > kShardFileMaxBytes * 4) {
      return fail(ErrorCode::parse, fmt::format("has {} bytes, which no shard has", size),
                  place + "/" + name);
    }
    column.bytes.resize(size);
    if (size > 0) {
      const Handle all(H5Dget_space(dataset.id()), H5Sclose);
      H5Sselect_hyperslab(all.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
      const Handle here(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                        H5Sclose);
      const Handle type = hdf5::type_of(column, false);
      if (H5Dread(dataset.id(), type.id(), here.id(), all.id(), H5P_DEFAULT, column.bytes.data()) <
          0) {
        return failed("read", place + "/" + name);
      }
    }
    table.columns.push_back(std::move(column));
  }
  return table;
}

}  // namespace shigusa
