// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <shigusa/error.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hdf5_object.hpp"
#include "table.hpp"

namespace shigusa::hdf5 {

// Range of rows of a table, [first, last).
struct RowRange {
  std::size_t first = 0;
  std::optional<std::size_t> last{};  // none: to the end
};

// A column in a file.
struct StoredColumn {
  Column column;  // without rows
  std::uint64_t rows = 0;
  Object object;  // the dataset
};

// Reader of groups and datasets of untrusted files. HDF5's own library follows links to other
// files, and crashes on damaged ones; this reader supports only what is described here.
class Reader {
 public:
  // Opens a file; fails without the signature.
  [[nodiscard]] static Result<Reader> open(Source source);

  // Upper bound on the bytes of all columns, however they are compressed.
  [[nodiscard]] std::uint64_t most_bytes() const;
  // Object by its path, "/" or "/motions/human-1f2e3d".
  [[nodiscard]] Result<Object> object(std::string_view path) const;
  // Sorted names of a group's members, with their addresses.
  using Entries = std::vector<std::pair<std::string, std::uint64_t>>;
  [[nodiscard]] Result<Entries> entries(const Object& group) const;
  // A dataset of one to four dimensions as a column of a table.
  [[nodiscard]] Result<StoredColumn> column(std::uint64_t address, const std::string& name) const;
  // Bytes of some of its rows. Fails if the file lacks them.
  [[nodiscard]] Result<std::string> rows(const StoredColumn& column, const RowRange& range) const;
  // A dataset that is a single text.
  [[nodiscard]] Result<std::string> text(std::string_view path) const;

 private:
  struct Chunk {
    std::uint64_t address = 0;
    std::uint64_t size = 0;
    std::uint64_t left_out = 0;  // filters, a bit each
  };
  Reader(Source source, std::uint64_t root) : source_(std::move(source)), root_(root) {}

  [[nodiscard]] Result<void> add_entries(std::uint64_t node, std::uint64_t level,
                                         std::string_view names, std::size_t& budget,
                                         Entries& entries) const;
  [[nodiscard]] Result<void> add_leaf(std::uint64_t leaf, std::string_view names,
                                      Entries& entries) const;
  [[nodiscard]] Result<void> add_chunks(std::uint64_t node, std::uint64_t level,
                                        const StoredColumn& column, std::size_t& budget,
                                        std::vector<Chunk>& chunks) const;
  [[nodiscard]] Result<std::vector<Chunk>> chunks_of(const StoredColumn& column) const;
  [[nodiscard]] Result<std::string> unpacked(const Chunk& chunk, const Object& object,
                                             std::size_t size) const;

  Source source_;
  std::uint64_t root_ = 0;  // address of the object "/"
};

// Text of an attribute; empty if absent. Fails if it is no text.
[[nodiscard]] Result<std::string> text_of(const Object& object, std::string_view name);
// Texts of an attribute that is a list.
[[nodiscard]] Result<std::vector<std::string>> texts_of(const Object& object,
                                                        std::string_view name);

}  // namespace shigusa::hdf5
