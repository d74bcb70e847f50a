// SPDX-License-Identifier: MIT
#include "hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shigusa::hdf5 {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{256} << 10;
constexpr unsigned kDeflate = 4;  // beyond it files get little smaller, and writing much slower

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<std::size_t>(1, size));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

hid_t number_type(ElementType type, bool in_file) {
  switch (type) {
    case ElementType::u8:
      return in_file ? H5T_STD_U8LE : H5T_NATIVE_UINT8;
    case ElementType::u16:
      return in_file ? H5T_STD_U16LE : H5T_NATIVE_UINT16;
    case ElementType::u32:
      return in_file ? H5T_STD_U32LE : H5T_NATIVE_UINT32;
    case ElementType::u64:
      return in_file ? H5T_STD_U64LE : H5T_NATIVE_UINT64;
    case ElementType::f32:
      return in_file ? H5T_IEEE_F32LE : H5T_NATIVE_FLOAT;
    default:
      return in_file ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE;
  }
}

// Keeps the text of the innermost error.
herr_t keep_first(unsigned, const H5E_error2_t* error, void* text) {
  auto& kept = *static_cast<std::string*>(text);
  if (kept.empty() && error->desc != nullptr) kept = error->desc;
  return 0;
}

Handle new_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

// Dimensions of a column's dataset: its rows, then those of one row.
std::vector<hsize_t> sides_of(const Column& column, std::size_t rows) {
  std::vector<hsize_t> sides{rows};
  sides.insert(sides.end(), column.shape.begin(), column.shape.end());
  return sides;
}

bool is_empty(const std::vector<hsize_t>& sides) {
  return std::find(sides.begin(), sides.end(), 0) != sides.end();
}

Handle space_of(const std::vector<hsize_t>& sides) {
  return {H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr), H5Sclose};
}

// Data space with rows first to first + rows - 1 selected.
Handle rows_of_space(const Column& column, std::size_t all, std::size_t first, std::size_t rows) {
  Handle space = space_of(sides_of(column, all));
  const std::vector<hsize_t> count = sides_of(column, rows);
  std::vector<hsize_t> start(count.size(), 0);
  start[0] = first;
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  return space;
}

Result<Handle> create_dataset(const Handle& group, const Column& column, const Handle& space,
                              const Handle& creation) {
  const Handle stored = type_of(column, true);
  Handle dataset(H5Dcreate2(group.id(), column.name.c_str(), stored.id(), space.id(), H5P_DEFAULT,
                            creation.id(), H5P_DEFAULT),
                 H5Dclose);
  if (!dataset) return failed("make a column", column.name);
  return dataset;
}

// Fill value of a virtual dataset for a missing file.
void set_absent_value(const Handle& creation, const Column& column) {
  if (column.type == ElementType::text) return;
  Column absent{.name = column.name, .type = column.type};
  if (column.type == ElementType::f32 || column.type == ElementType::f64) {
    absent.push(kNoNumber);
  } else {
    absent.bytes.assign(size_of(column.type), '\xFF');
  }
  const Handle held = type_of(column, false);
  H5Pset_fill_value(creation.id(), held.id(), absent.bytes.data());
}

// Cache settings that keep few written virtual datasets: each holds its parts, 4 kB each, which the
// cache's own limits do not count.
void use_small_cache(const Handle& access) {
  constexpr std::size_t kBytes = std::size_t{256} << 10;
  H5AC_cache_config_t config{};
  config.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  if (H5Pget_mdc_config(access.id(), &config) < 0) return;
  config.set_initial_size = true;
  config.initial_size = config.min_size = config.max_size = kBytes;
  config.incr_mode = H5C_incr__off;
  config.flash_incr_mode = H5C_flash_incr__off;
  config.decr_mode = H5C_decr__off;
  H5Pset_mdc_config(access.id(), &config);
}

}  // namespace

void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

tl::unexpected<Error> failed(const char* action, const std::string& place) {
  std::string why;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &why);
  H5Eclear2(H5E_DEFAULT);
  return fail(ErrorCode::io,
              fmt::format("cannot {}: HDF5 says: {}", action, why.empty() ? "nothing" : why),
              place);
}

Handle type_of(const Column& column, bool in_file) {
  if (column.type == ElementType::text) return text_type(column.text_size);
  return {H5Tcopy(number_type(column.type, in_file)), H5Tclose};
}

Result<Handle> create_in_memory() {
  be_quiet();
  constexpr std::size_t kStep = std::size_t{1} << 20;
  const Handle access = new_list(H5P_FILE_ACCESS);
  const Handle creation = new_list(H5P_FILE_CREATE);
  H5Pset_fapl_core(access.id(), kStep, false);
  // earliest format: H5Fget_file_image gives wrong checksums for later ones
  H5Pset_obj_track_times(creation.id(), false);
  Handle file(H5Fcreate("in memory", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  if (!file) return failed("begin a file", "HDF5");
  return file;
}

Result<std::string> image_of(const Handle& file) {
  if (H5Fflush(file.id(), H5F_SCOPE_LOCAL) < 0) return failed("finish a file", "HDF5");
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  if (size < 0) return failed("finish a file", "HDF5");
  std::string image(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file.id(), image.data(), image.size()) < 0) {
    return failed("finish a file", "HDF5");
  }
  return image;
}

Result<Handle> create_on_disk(const std::filesystem::path& path, std::size_t user_bytes) {
  be_quiet();
  const Handle access = new_list(H5P_FILE_ACCESS);
  const Handle creation = new_list(H5P_FILE_CREATE);
  H5Pset_file_locking(access.id(), false, true);
  use_small_cache(access);
  H5Pset_obj_track_times(creation.id(), false);
  H5Pset_userblock(creation.id(), user_bytes);
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  if (!file) return failed("begin a file", path.string());
  return file;
}

Result<Handle> create_group(const Handle& file, const std::string& path) {
  const Handle creation = new_list(H5P_GROUP_CREATE);
  H5Pset_obj_track_times(creation.id(), false);
  // created one by one: intermediate groups created by the library have timestamps
  for (std::size_t end = path.find('/', 1); end != std::string::npos;
       end = path.find('/', end + 1)) {
    const std::string outer = path.substr(0, end);
    if (H5Lexists(file.id(), outer.c_str(), H5P_DEFAULT) > 0) continue;
    const Handle group(
        H5Gcreate2(file.id(), outer.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
    if (!group) return failed("make a group", outer);
  }
  Handle group(H5Gcreate2(file.id(), path.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
               H5Gclose);
  if (!group) return failed("make a group", path);
  return group;
}

Result<void> write_text(const Handle& object, const char* name, const std::string& text) {
  const Handle type = text_type(text.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const std::string bytes = text.empty() ? std::string(1, '\0') : text;
  if (!attribute || H5Awrite(attribute.id(), type.id(), bytes.data()) < 0) {
    return failed("write an attribute", name);
  }
  return {};
}

Result<void> write_texts(const Handle& object, const char* name,
                         const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string bytes;
  for (const std::string& text : texts) {
    bytes += text;
    bytes.append(longest - text.size(), '\0');
  }
  const Handle type = text_type(longest);
  const hsize_t count = texts.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle attribute(
      H5Acreate2(object.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute || (count > 0 && H5Awrite(attribute.id(), type.id(), bytes.data()) < 0)) {
    return failed("write an attribute", name);
  }
  return {};
}

Result<void> write_number(const Handle& object, const char* name, std::uint64_t number) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object.id(), name, H5T_STD_U64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute || H5Awrite(attribute.id(), H5T_NATIVE_UINT64, &number) < 0) {
    return failed("write an attribute", name);
  }
  return {};
}

Result<void> write_long_text(const Handle& group, const char* name, const std::string& text) {
  const Handle creation = new_list(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(creation.id(), false);
  const Handle type = text_type(text.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle dataset(
      H5Dcreate2(group.id(), name, type.id(), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose);
  const std::string bytes = text.empty() ? std::string(1, '\0') : text;
  if (!dataset ||
      H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) {
    return failed("write a text", name);
  }
  return {};
}

Result<void> describe(const Handle& dataset, const Column& column) {
  if (!column.unit.empty()) SHG_TRY(write_text(dataset, "unit", column.unit));
  if (!column.says.empty()) SHG_TRY(write_text(dataset, "description", column.says));
  if (!column.words.empty()) SHG_TRY(write_texts(dataset, "words", column.words));
  return {};
}

Result<Handle> create_column(const Handle& group, const Column& column, std::size_t rows) {
  const std::vector<hsize_t> sides = sides_of(column, rows);
  const Handle creation = new_list(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(creation.id(), false);
  if (!is_empty(sides)) {
    std::vector<hsize_t> chunk = sides;
    chunk[0] = std::clamp<hsize_t>(kChunkBytes / column.row_size(), 1, sides[0]);
    H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(creation.id());
    H5Pset_deflate(creation.id(), kDeflate);
    H5Pset_fletcher32(creation.id());
  }
  return create_dataset(group, column, space_of(sides), creation);
}

Result<void> write_rows(const Handle& dataset, const Column& column, std::size_t first) {
  const std::vector<hsize_t> sides = sides_of(column, column.rows());
  if (is_empty(sides)) return {};
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::vector<hsize_t> start(sides.size(), 0);
  start[0] = first;
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, sides.data(), nullptr);
  const Handle held = type_of(column, false);
  if (H5Dwrite(dataset.id(), held.id(), space_of(sides).id(), space.id(), H5P_DEFAULT,
               column.bytes.data()) < 0) {
    return failed("write a column", column.name);
  }
  return {};
}

Result<void> write_column(const Handle& group, const Column& column) {
  SHG_TRY_ASSIGN(const Handle dataset, create_column(group, column, column.rows()));
  SHG_TRY(write_rows(dataset, column, 0));
  return describe(dataset, column);
}

Result<void> write_virtual_column(const Handle& group, const Column& column,
                                  std::span<const VirtualPart> parts) {
  std::size_t rows = 0;
  for (const VirtualPart& part : parts) rows += part.rows;
  if (is_empty(sides_of(column, rows))) {
    SHG_TRY_ASSIGN(const Handle none, create_column(group, column, rows));
    return describe(none, column);
  }
  const Handle creation = new_list(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(creation.id(), false);
  set_absent_value(creation, column);
  std::size_t first = 0;
  for (const VirtualPart& part : parts) {
    const Handle here = rows_of_space(column, rows, first, part.rows);
    const Handle there = space_of(sides_of(column, part.rows));
    if (H5Pset_virtual(creation.id(), here.id(), part.file.c_str(), part.dataset.c_str(),
                       there.id()) < 0) {
      return failed("make a virtual column", column.name);
    }
    first += part.rows;
  }
  SHG_TRY_ASSIGN(const Handle dataset,
                 create_dataset(group, column, space_of(sides_of(column, rows)), creation));
  return describe(dataset, column);
}

}  // namespace shigusa::hdf5
