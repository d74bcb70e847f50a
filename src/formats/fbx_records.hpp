// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "formats/fbx.hpp"

namespace shigusa {

// A value of a record; arrays and raw bytes are none of these, and keep their place alone.
struct FbxValue {
  std::string_view text;  // in the file's bytes
  double number = 0.0;
  std::int64_t integer = 0;  // of a whole number; ids do not fit into a double
};

// A record as both forms of FBX hold it, with those within it that are read.
struct FbxRecord {
  std::string_view name;
  std::vector<FbxValue> values;
  std::vector<FbxRecord> within;

  // The first record within of that name, or null.
  [[nodiscard]] const FbxRecord* find(std::string_view wanted) const;
  // Values that are not there are empty.
  [[nodiscard]] std::string_view text(std::size_t i) const;
  [[nodiscard]] std::int64_t integer(std::size_t i) const;
  [[nodiscard]] double number(std::size_t i) const;
};

struct FbxRecords {
  FbxRecord root;   // the file, without a name
  int version = 0;  // the file's: 7400
};

// Brings the records of version 6 into the form of version 7: there models have ids, by which they
// are connected, properties a label, and the settings stand beside the objects.
void take_as_version_7(FbxRecord& root);

// Reads what is needed of a file, text or binary, as version 7 has it; it borrows the bytes.
[[nodiscard]] Result<FbxRecords> read_fbx_records(std::string_view bytes, std::string_view name);

}  // namespace shigusa
