// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <shigusa/math.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

// Value of a missing number.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// Number type of a column.
enum class ElementType { u8, u16, u32, u64, f32, f64, text };

// Bytes of one number; for texts see Column::text_size.
[[nodiscard]] constexpr std::size_t size_of(ElementType type) {
  constexpr std::size_t kSizes[] = {1, 2, 4, 8, 4, 8, 1};
  return kSizes[static_cast<std::size_t>(type)];
}

// One column of a table: a dataset of an HDF5 file, whose first dimension is the rows.
struct Column {
  std::string name;
  ElementType type = ElementType::f64;
  std::vector<std::size_t> shape{};  // of one row; none: a single number
  std::string unit{};                // "m"
  std::string says{};                // description
  std::vector<std::string> words{};  // of numbers that stand for words: word k is that of k
  std::size_t text_size = 0;         // bytes of a text, the rest of which are 0
  std::string bytes{};               // of all rows, as the machine has them

  // Bytes of one row.
  [[nodiscard]] std::size_t row_size() const {
    std::size_t size = type == ElementType::text ? text_size : size_of(type);
    for (const std::size_t side : shape) size *= side;
    return size;
  }
  // Number of rows; 0 for a column of width 0.
  [[nodiscard]] std::size_t rows() const { return row_size() == 0 ? 0 : bytes.size() / row_size(); }

  void push_bytes(const void* from, std::size_t size) {
    bytes.append(static_cast<const char*>(from), size);
  }
  // Adds a number, converted to the column's type.
  void push(double value) {
    switch (type) {
      case ElementType::u8:
        return push_as(static_cast<std::uint8_t>(value));
      case ElementType::u16:
        return push_as(static_cast<std::uint16_t>(value));
      case ElementType::u32:
        return push_as(static_cast<std::uint32_t>(value));
      case ElementType::u64:
        return push_as(static_cast<std::uint64_t>(value));
      case ElementType::f32:
        return push_as(static_cast<float>(value));
      default:
        return push_as(value);
    }
  }
  void push(const Vec3d& v) {
    for (int k = 0; k < 3; ++k) push(v[k]);
  }
  void push(const Quatd& q) {
    for (const double part : {q.x, q.y, q.z, q.w}) push(part);
  }
  template <class T>
  void push_as(T value) {
    push_bytes(&value, sizeof value);
  }
  // Adds a text, cut to the column's size at a character boundary.
  void push(std::string_view text);

  // Numbers of some rows as the given type, which must be the column's.
  template <class T>
  [[nodiscard]] std::vector<T> as() const {
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
  }
  // Texts of a column.
  [[nodiscard]] std::vector<std::string> texts() const;
};

// Rows with named columns: a group of an HDF5 file.
struct Table {
  std::string path;  // "/motions/human-1f2e3d"
  std::vector<Column> columns{};
  // lists of names: of joints, of nodes
  std::vector<std::pair<std::string, std::vector<std::string>>> names{};

  // Column of that name, which must exist.
  [[nodiscard]] Column& operator[](std::string_view name);
  [[nodiscard]] const Column* find(std::string_view name) const;
  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().rows(); }
  [[nodiscard]] const std::vector<std::string>* names_of(std::string_view what) const;
};

// Appends the rows of tables to those of the same path, and adds tables with new paths.
void append(std::vector<Table>&& more, std::vector<Table>& tables);

}  // namespace shigusa
