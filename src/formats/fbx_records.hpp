// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "formats/fbx.hpp"

namespace shigusa {

// Value of a record; arrays and raw bytes are represented by an empty value.
struct FbxValue {
  std::string_view text;  // in the file's bytes
  double number = 0.0;
  std::int64_t integer = 0;  // of a whole number; ids do not fit into a double
};

// A record in either form of FBX, with those of its children that are read.
struct FbxRecord {
  std::string_view name;
  std::vector<FbxValue> values;
  std::vector<FbxRecord> within;

  // First child of that name, or null.
  [[nodiscard]] const FbxRecord* find(std::string_view wanted) const;
  // Values by index; missing ones are empty.
  [[nodiscard]] std::string_view text(std::size_t i) const;
  [[nodiscard]] std::int64_t integer(std::size_t i) const;
  [[nodiscard]] double number(std::size_t i) const;
};

struct FbxRecords {
  FbxRecord root;   // the file, without a name
  int version = 0;  // the file's: 7400
};

// Converts records of version 6 to version 7, in which models are connected by ids, properties have
// a label, and the settings are separate from the objects.
void take_as_version_7(FbxRecord& root);

// Reads the required records of a file, text or binary, in the form of version 7; borrows the
// bytes.
[[nodiscard]] Result<FbxRecords> read_fbx_records(std::string_view bytes, std::string_view name);

}  // namespace shigusa
