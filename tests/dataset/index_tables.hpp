// SPDX-License-Identifier: MIT
#pragma once

#include "dataset/hdf5.hpp"

// An independent reader of an index's tables, by HDF5's own library, which finds the shards' rows.
namespace shigusa::testing_support {

inline Result<hdf5::Handle> open_file(const std::filesystem::path& path) {
  hdf5::be_quiet();
  const hdf5::Handle access = hdf5::Handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.id(), false, true);
  hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  if (!file) return hdf5::failed("read", path.string());
  return file;
}

inline Result<std::string> read_text(const hdf5::Handle& object, const char* name) {
  const hdf5::Handle attribute(H5Aopen(object.id(), name, H5P_DEFAULT), H5Aclose);
  if (!attribute) return hdf5::failed("read an attribute", name);
  const hdf5::Handle stored(H5Aget_type(attribute.id()), H5Tclose);
  if (H5Tget_class(stored.id()) != H5T_STRING || H5Tis_variable_str(stored.id()) > 0) {
    return fail(ErrorCode::parse, "must be a text", name);
  }
  std::string text(H5Tget_size(stored.id()), '\0');
  if (H5Aread(attribute.id(), stored.id(), text.data()) < 0) {
    return hdf5::failed("read an attribute", name);
  }
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

inline Result<std::vector<std::string>> read_texts(const hdf5::Handle& object, const char* name) {
  std::vector<std::string> texts;
  if (H5Aexists(object.id(), name) <= 0) return texts;
  const hdf5::Handle attribute(H5Aopen(object.id(), name, H5P_DEFAULT), H5Aclose);
  const hdf5::Handle stored(H5Aget_type(attribute.id()), H5Tclose);
  const hdf5::Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Tget_class(stored.id()) != H5T_STRING || H5Tis_variable_str(stored.id()) > 0) {
    return fail(ErrorCode::parse, "must be texts", name);
  }
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  Column column{.name = name, .type = ElementType::text, .text_size = H5Tget_size(stored.id())};
  column.bytes.resize(static_cast<std::size_t>(std::max<hssize_t>(0, count)) * column.text_size);
  if (count > 0 && H5Aread(attribute.id(), stored.id(), column.bytes.data()) < 0) {
    return hdf5::failed("read an attribute", name);
  }
  return column.texts();
}

// Reads a column's shape, numbers and texts.
inline Result<void> read_column(const hdf5::Handle& group, const std::string& table,
                                Column& column) {
  const std::string place = table + "/" + column.name;
  const hdf5::Handle dataset(H5Dopen2(group.id(), column.name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset) return hdf5::failed("read", place);
  const hdf5::Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 1) return fail(ErrorCode::parse, "must have rows", place);
  std::vector<hsize_t> sides(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space.id(), sides.data(), nullptr);
  column.shape.assign(sides.begin() + 1, sides.end());
  column.bytes.resize(sides[0] * column.row_size());
  const hdf5::Handle type = hdf5::type_of(column, false);
  if (!column.bytes.empty() &&
      H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, column.bytes.data()) < 0) {
    return hdf5::failed("read", place);
  }
  for (const auto& [attribute, into] :
       {std::pair{"unit", &column.unit}, std::pair{"description", &column.says}}) {
    if (H5Aexists(dataset.id(), attribute) <= 0) continue;
    SHG_TRY_ASSIGN(*into, read_text(dataset, attribute));
  }
  SHG_TRY_ASSIGN(column.words, read_texts(dataset, "words"));
  return {};
}

// `table` must have its path, its columns' names and types and the names of its lists; all else is
// read.
inline Result<void> read_index(const std::filesystem::path& path, Table& table) {
  SHG_TRY_ASSIGN(const hdf5::Handle file, open_file(path));
  const hdf5::Handle group(H5Gopen2(file.id(), table.path.c_str(), H5P_DEFAULT), H5Gclose);
  if (!group) return hdf5::failed("read", path.string() + ": " + table.path);
  for (auto& [what, list] : table.names) {
    SHG_TRY_ASSIGN(list, read_texts(group, what.c_str()));
  }
  for (Column& column : table.columns) SHG_TRY(read_column(group, table.path, column));
  return {};
}

}  // namespace shigusa::testing_support
