// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "table.hpp"

// Writers of HDF5, by its own library. Files are read by hdf5_reader.hpp, as a stranger may have
// made them.
namespace shigusa::hdf5 {

// An object of HDF5, closed when this goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  [[nodiscard]] hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

// Errors are told by results: the library prints none of them.
void be_quiet();

// "cannot ACTION: " and what the library says of its last error.
[[nodiscard]] tl::unexpected<Error> failed(const char* action, const std::string& place);

// The type of a column's numbers, in the file or in memory.
[[nodiscard]] Handle type_of(const Column& column, bool in_file);

// A file that is made in memory. Its bytes depend on what is written alone: no times are in it.
[[nodiscard]] Result<Handle> create_in_memory();
// The bytes of such a file. Others may stand before them, in a multiple of 512: readers look for
// where HDF5 begins.
[[nodiscard]] Result<std::string> image_of(const Handle& file);

// A file on the disk, made anew, with room for `user_bytes` of another kind before what HDF5 has.
// No times are in it, and nobody is kept from opening it meanwhile.
[[nodiscard]] Result<Handle> create_on_disk(const std::filesystem::path& path,
                                            std::size_t user_bytes);

// A group within a file, with the groups that it is in.
[[nodiscard]] Result<Handle> create_group(const Handle& file, const std::string& path);
[[nodiscard]] Result<void> write_text(const Handle& object, const char* name,
                                      const std::string& text);
[[nodiscard]] Result<void> write_texts(const Handle& object, const char* name,
                                       const std::vector<std::string>& texts);
[[nodiscard]] Result<void> write_number(const Handle& object, const char* name,
                                        std::uint64_t number);

// Adds a column's unit, meaning and words to its dataset.
[[nodiscard]] Result<void> describe(const Handle& dataset, const Column& column);
// A text of any length, as a dataset: an attribute has no room for more than 64 kB.
[[nodiscard]] Result<void> write_long_text(const Handle& group, const char* name,
                                           const std::string& text);
[[nodiscard]] Result<void> write_column(const Handle& group, const Column& column);

// The dataset of a column with `rows` rows, which are to be written in parts; the column's own rows
// do not matter.
[[nodiscard]] Result<Handle> create_column(const Handle& group, const Column& column,
                                           std::size_t rows);
// Writes all rows of a column into a dataset, from row `first` of it on.
[[nodiscard]] Result<void> write_rows(const Handle& dataset, const Column& column,
                                      std::size_t first);

// Rows of a virtual dataset: all rows of a dataset of another file.
struct VirtualPart {
  std::string file;  // as seen from the folder of the file with the virtual dataset
  std::string dataset;
  std::size_t rows = 0;  // above 0
};
// A dataset that has the parts' rows one after the other and none of its own. Where a file of them
// cannot be opened, HDF5 gives rows of the value that it is told to: NaN, of whole numbers the
// largest.
[[nodiscard]] Result<void> write_virtual_column(const Handle& group, const Column& column,
                                                std::span<const VirtualPart> parts);

}  // namespace shigusa::hdf5
