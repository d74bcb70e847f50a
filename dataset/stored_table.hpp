// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <shigusa/error.hpp>
#include <string>
#include <vector>

#include "hdf5_reader.hpp"
#include "table.hpp"

namespace shigusa {

// Adds a place to an error.
template <class Value>
Result<Value> told_of(const std::string& place, Result<Value> result) {
  if (result) return result;
  Error error = std::move(result).error();
  error.place = error.place.empty() ? place : place + ": " + error.place;
  return tl::unexpected(std::move(error));
}

// A table of a shard, without rows.
struct StoredTable {
  Table names;  // with its path alone, and its lists
  std::vector<hdf5::StoredColumn> columns;

  [[nodiscard]] const hdf5::StoredColumn* find(const std::string& name) const {
    for (const hdf5::StoredColumn& one : columns) {
      if (one.column.name == name) return &one;
    }
    return nullptr;
  }
};

using StoredTables = std::map<std::string, StoredTable>;  // by their paths

// Tables of a shard's file, all in the form that this program writes. Fails if their declared size
// exceeds a shard's.
[[nodiscard]] Result<StoredTables> stored_tables(const hdf5::Reader& reader);

}  // namespace shigusa
