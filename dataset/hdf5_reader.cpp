// SPDX-License-Identifier: MIT
#include "hdf5_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shigusa::hdf5 {
namespace {

constexpr std::size_t kNodeHead = 24;      // bytes of a tree's node before its keys
constexpr std::uint64_t kMostLevels = 16;  // of a tree
constexpr std::uint64_t kMostNames = std::uint64_t{1} << 20;  // bytes of a group's names
constexpr std::size_t kMostText = std::size_t{16} << 20;

// A node of a version 1 B-tree.
struct Node {
  std::size_t entries = 0;
  std::string keys;  // and children, one after the other
};

Result<Node> read_node(const Source& source, std::uint64_t address, std::uint64_t kind,
                       std::uint64_t level, std::size_t entry_size) {
  const std::optional<std::string> head = source.bytes(address, kNodeHead);
  if (!head) return foreign("a node of a tree is not there");
  Bytes bytes(*head);
  const bool signed_so = bytes.text(4) == "TREE";
  const bool same = bytes.number(1) == kind && bytes.number(1) == level;
  const std::size_t entries = bytes.number(2);
  auto keys = source.bytes(address + kNodeHead, entries * entry_size);
  if (!signed_so || !same || !keys) return foreign("a node of a tree is another");
  return Node{entries, *std::move(keys)};
}

// Declared level of a tree's root.
std::uint64_t level_of(const Source& source, std::uint64_t tree) {
  const std::optional<std::string> head = source.bytes(tree, kNodeHead);
  return head ? static_cast<unsigned char>((*head)[5]) : 0;
}

// Names of a group's members, zero-terminated.
Result<std::string> read_names(const Source& source, std::uint64_t heap) {
  const std::optional<std::string> head = source.bytes(heap, 32);
  if (!head) return foreign("the names of a group are not there");
  Bytes bytes(*head);
  const bool same = bytes.text(4) == "HEAP" && bytes.number(4) == 0;
  const std::uint64_t size = bytes.number(8);
  bytes.skip(8);
  auto names = source.bytes(bytes.number(8), size);
  if (!same || size > kMostNames || !names) return foreign("the names of a group are others");
  return *std::move(names);
}

std::string text_at(std::string_view padded) {
  return std::string(padded.substr(0, padded.find('\0')));
}

// Number of rows of a column's chunk.
std::uint64_t chunk_rows(const StoredColumn& column) { return column.object.layout->chunk.front(); }

// Whether a column's chunks consist of whole rows.
bool has_whole_rows(const StoredColumn& column) {
  const std::vector<std::uint64_t>& sides = *column.object.sides;
  const std::vector<std::uint64_t>& chunk = column.object.layout->chunk;
  if (chunk.size() != sides.size() + 1 || chunk.back() != column.object.form->size) return false;
  return chunk.front() > 0 && chunk.front() <= sides.front() &&
         std::equal(sides.begin() + 1, sides.end(), chunk.begin() + 1);
}

}  // namespace

Result<Reader> Reader::open(Source source) {
  constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n\0\0\0\0\0\x08\x08", 15);
  constexpr std::size_t kBefore = 56;  // bytes of the first block before the root's entry
  const std::optional<std::string> head = source.bytes(0, kBefore + 40);
  if (!head || !head->starts_with(kSignature)) return foreign("it begins otherwise");
  Bytes bytes(*head);
  bytes.skip(kBefore + 8);
  return Reader(std::move(source), bytes.number(8));
}

std::uint64_t Reader::most_bytes() const {
  // deflate expands a byte to at most 1032
  constexpr std::uint64_t kMostUnpacked = 1100;
  return kMostUnpacked * source_.size();
}

Result<Object> Reader::object(std::string_view path) const {
  std::uint64_t address = root_;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    const std::string_view name = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    if (name.empty()) continue;
    SHG_TRY_ASSIGN(const Object group, read_object(source_, address));
    SHG_TRY_ASSIGN(const Entries all, entries(group));
    const auto found =
        std::find_if(all.begin(), all.end(), [name](const auto& one) { return one.first == name; });
    if (found == all.end()) {
      return fail(ErrorCode::parse, fmt::format("has no '{}'", name), "");
    }
    address = found->second;
  }
  return read_object(source_, address);
}

Result<Reader::Entries> Reader::entries(const Object& group) const {
  if (!group.members) return foreign("a group is none");
  SHG_TRY_ASSIGN(const std::string names, read_names(source_, group.members->names));
  const std::uint64_t tree = group.members->tree;
  std::size_t budget = source_.size() / kNodeHead;
  Entries found;
  SHG_TRY(add_entries(tree, level_of(source_, tree), names, budget, found));
  return found;
}

// `budget`: number of nodes left to read, as a tree may contain cycles.
Result<void> Reader::add_entries(std::uint64_t node, std::uint64_t level, std::string_view names,
                                 std::size_t& budget, Entries& entries) const {
  constexpr std::uint64_t kOfGroups = 0;
  if (budget == 0 || level > kMostLevels) return foreign("a group's tree has no end");
  --budget;
  SHG_TRY_ASSIGN(const Node read, read_node(source_, node, kOfGroups, level, 16));
  Bytes bytes(read.keys);
  for (std::size_t k = 0; k < read.entries; ++k) {
    bytes.skip(8);
    const std::uint64_t child = bytes.number(8);
    SHG_TRY(level > 0 ? add_entries(child, level - 1, names, budget, entries)
                      : add_leaf(child, names, entries));
  }
  return {};
}

Result<void> Reader::add_leaf(std::uint64_t leaf, std::string_view names, Entries& entries) const {
  constexpr std::size_t kEntry = 40;
  constexpr std::uint64_t kLink = 2;
  const std::optional<std::string> head = source_.bytes(leaf, 8);
  if (!head || !head->starts_with("SNOD\1")) return foreign("members of a group are not there");
  Bytes count(std::string_view(*head).substr(6));
  const std::size_t size = count.number(2) * kEntry;
  const std::optional<std::string> all = source_.bytes(leaf + 8, size);
  if (!all) return foreign("members of a group are not there");
  for (Bytes bytes(*all); !bytes.rest().empty();) {
    const std::uint64_t at = bytes.number(8);
    const std::uint64_t address = bytes.number(8);
    const std::uint64_t kind = bytes.number(4);
    bytes.skip(20);
    if (kind >= kLink) return foreign("a member of a group is a link");
    std::string name = at < names.size() ? text_at(names.substr(at)) : "";
    // strictly ascending, so that names are unique
    const bool next = entries.empty() || entries.back().first < name;
    if (name.empty() || name.find('/') != std::string::npos || !next) {
      return foreign("a name in a group is none");
    }
    entries.emplace_back(std::move(name), address);
  }
  return {};
}

Result<StoredColumn> Reader::column(std::uint64_t address, const std::string& name) const {
  StoredColumn stored{.column = {.name = name}, .object = {}};
  SHG_TRY_ASSIGN(stored.object, read_object(source_, address));
  const Object& object = stored.object;
  if (!object.is_dataset() || object.sides->empty()) {
    return fail(ErrorCode::parse, "must have one to four sides", name);
  }
  stored.rows = object.sides->front();
  stored.column.type = object.form->type;
  if (object.form->type == ElementType::text) stored.column.text_size = object.form->size;
  stored.column.shape.assign(object.sides->begin() + 1, object.sides->end());
  const std::uint64_t row = count_of({object.sides->begin() + 1, object.sides->end()});
  const std::uint64_t count = count_of(*object.sides);
  if (std::max(row, count) > most_bytes() / object.form->size) {
    return fail(ErrorCode::parse, "has more bytes than its file can have", name);
  }
  SHG_TRY_ASSIGN(stored.column.unit, text_of(object, "unit"));
  SHG_TRY_ASSIGN(stored.column.says, text_of(object, "description"));
  SHG_TRY_ASSIGN(stored.column.words, texts_of(object, "words"));
  return stored;
}

Result<std::string> Reader::rows(const StoredColumn& column, const RowRange& range) const {
  const std::uint64_t row = column.column.row_size();
  const std::uint64_t last = std::min<std::uint64_t>(range.last.value_or(kNowhere), column.rows);
  const std::uint64_t first = std::min<std::uint64_t>(range.first, last);
  if (row == 0 || first == last) return std::string();
  const Layout& layout = *column.object.layout;
  if (!layout.chunked) {
    auto bytes = source_.bytes(layout.address, layout.size);
    if (!bytes || layout.size != row * column.rows) return foreign("rows are not there");
    return bytes->substr(first * row, (last - first) * row);
  }
  SHG_TRY_ASSIGN(const std::vector<Chunk> chunks, chunks_of(column));
  const std::uint64_t step = chunk_rows(column);
  std::string read;
  for (std::uint64_t k = first / step; k * step < last; ++k) {
    SHG_TRY_ASSIGN(const std::string part, unpacked(chunks[k], column.object, step * row));
    const std::uint64_t begin = std::max(first, k * step) - k * step;
    const std::uint64_t end = std::min(last, (k + 1) * step) - k * step;
    read.append(part, begin * row, (end - begin) * row);
  }
  return read;
}

Result<std::vector<Reader::Chunk>> Reader::chunks_of(const StoredColumn& column) const {
  if (!has_whole_rows(column)) return foreign("a column's chunks are of no whole rows");
  const std::uint64_t count = (column.rows - 1) / chunk_rows(column) + 1;
  const std::uint64_t tree = column.object.layout->address;
  std::size_t budget = source_.size() / kNodeHead;
  std::vector<Chunk> chunks;
  SHG_TRY(add_chunks(tree, level_of(source_, tree), column, budget, chunks));
  if (chunks.size() != count) return foreign("chunks of a column are not there");
  return chunks;
}

Result<void> Reader::add_chunks(std::uint64_t node, std::uint64_t level, const StoredColumn& column,
                                std::size_t& budget, std::vector<Chunk>& chunks) const {
  constexpr std::uint64_t kOfChunks = 1;
  if (budget == 0 || level > kMostLevels) return foreign("a column's tree has no end");
  --budget;
  const std::size_t offsets = column.object.layout->chunk.size();
  const std::size_t entry = 8 + 8 * offsets + 8;
  SHG_TRY_ASSIGN(const Node read, read_node(source_, node, kOfChunks, level, entry));
  Bytes bytes(read.keys);
  for (std::size_t k = 0; k < read.entries; ++k) {
    Chunk chunk{.size = bytes.number(4)};
    chunk.left_out = bytes.number(4);
    const std::uint64_t first = bytes.number(8);
    std::uint64_t others = 0;
    for (std::size_t side = 1; side < offsets; ++side) others |= bytes.number(8);
    chunk.address = bytes.number(8);
    if (level > 0) {
      SHG_TRY(add_chunks(chunk.address, level - 1, column, budget, chunks));
      continue;
    }
    const bool next = first == chunks.size() * chunk_rows(column) && first < column.rows;
    if (!next || others != 0) return foreign("chunks of a column have other places");
    chunks.push_back(chunk);
  }
  return {};
}

Result<std::string> Reader::text(std::string_view path) const {
  SHG_TRY_ASSIGN(const Object found, object(path));
  const bool one = found.is_dataset() && found.sides->empty() && !found.layout->chunked &&
                   found.form->type == ElementType::text &&
                   found.layout->size == found.form->size && found.form->size <= kMostText;
  if (!one) return fail(ErrorCode::parse, "must be a text", std::string(path));
  const std::optional<std::string> bytes = source_.bytes(found.layout->address, found.layout->size);
  if (!bytes) return foreign("a text is not there");
  return text_at(*bytes);
}

Result<std::string> text_of(const Object& object, std::string_view name) {
  SHG_TRY_ASSIGN(const std::vector<std::string> texts, texts_of(object, name));
  return texts.empty() ? std::string() : texts.front();
}

Result<std::vector<std::string>> texts_of(const Object& object, std::string_view name) {
  const Attribute* attribute = object.find(name);
  if (attribute == nullptr) return std::vector<std::string>{};
  if (attribute->form.type != ElementType::text) {
    return fail(ErrorCode::parse, "must be texts", std::string(name));
  }
  return Column{.name = attribute->name,
                .type = ElementType::text,
                .text_size = attribute->form.size,
                .bytes = attribute->bytes}
      .texts();
}

}  // namespace shigusa::hdf5
