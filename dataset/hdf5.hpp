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

// Writers of HDF5, using its library. Files are read by hdf5_reader.hpp, since they may come from
// untrusted sources.
namespace shigusa::hdf5 {

// Owner of an HDF5 object.
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

// Turns off the library's printing of errors, which are returned as results.
void be_quiet();

// Message "cannot ACTION: " and the text of the library's last error.
[[nodiscard]] tl::unexpected<Error> failed(const char* action, const std::string& place);

// Number type of a column, in the file or in memory.
[[nodiscard]] Handle type_of(const Column& column, bool in_file);

// A file in memory. Its bytes depend only on its contents: timestamps are disabled.
[[nodiscard]] Result<Handle> create_in_memory();
// Bytes of such a file. They may follow a user block of a multiple of 512 bytes: readers search for
// the beginning of HDF5.
[[nodiscard]] Result<std::string> image_of(const Handle& file);

// A new file on the disk, with a user block of `user_bytes`. Timestamps and file locking are
// disabled.
[[nodiscard]] Result<Handle> create_on_disk(const std::filesystem::path& path,
                                            std::size_t user_bytes);

// A group within a file, created with its parents.
[[nodiscard]] Result<Handle> create_group(const Handle& file, const std::string& path);
[[nodiscard]] Result<void> write_text(const Handle& object, const char* name,
                                      const std::string& text);
[[nodiscard]] Result<void> write_texts(const Handle& object, const char* name,
                                       const std::vector<std::string>& texts);
[[nodiscard]] Result<void> write_number(const Handle& object, const char* name,
                                        std::uint64_t number);

// Adds a column's unit, meaning and words to its dataset.
[[nodiscard]] Result<void> describe(const Handle& dataset, const Column& column);
// A text of any length, as a dataset: attributes are limited to 64 kB.
[[nodiscard]] Result<void> write_long_text(const Handle& group, const char* name,
                                           const std::string& text);
[[nodiscard]] Result<void> write_column(const Handle& group, const Column& column);

// Dataset of a column with `rows` rows to be written in parts; the column's own rows are ignored.
[[nodiscard]] Result<Handle> create_column(const Handle& group, const Column& column,
                                           std::size_t rows);
// Writes all rows of a column into a dataset, starting at row `first`.
[[nodiscard]] Result<void> write_rows(const Handle& dataset, const Column& column,
                                      std::size_t first);

// Rows of a virtual dataset: a whole dataset of another file.
struct VirtualPart {
  std::string file;  // as seen from the folder of the file with the virtual dataset
  std::string dataset;
  std::size_t rows = 0;  // above 0
};
// A virtual dataset of the parts' rows in sequence. For a missing file HDF5 returns a fill value:
// NaN, or the largest whole number.
[[nodiscard]] Result<void> write_virtual_column(const Handle& group, const Column& column,
                                                std::span<const VirtualPart> parts);

}  // namespace shigusa::hdf5
