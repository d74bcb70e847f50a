// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>
#include <vector>

#include "hdf5_source.hpp"
#include "table.hpp"

// Objects of HDF5 files in the form written by this program: the earliest version (HDF5 File Format
// Specification, version 3.0, "version 0 of the superblock"). Other features are refused, as no
// file of this program uses them: links to other files and places, external data, datasets of
// datasets, other filters.
namespace shigusa::hdf5 {

// Type of an element.
struct ElementForm {
  ElementType type = ElementType::f64;
  std::size_t size = 0;
};

struct Attribute {
  std::string name;
  ElementForm form;
  std::uint64_t count = 0;
  std::string bytes;
};

// Filters of a chunk.
enum class Filter { deflate = 1, shuffle = 2, sum = 3 };

// Location of a dataset's bytes.
struct Layout {
  bool chunked = false;
  std::uint64_t address = 0;         // of the bytes, or of the tree of chunks
  std::uint64_t size = 0;            // of the bytes that are not chunked
  std::vector<std::uint64_t> chunk;  // its sides, and the size of an element
};

// A group or a dataset.
struct Object {
  struct Members {
    std::uint64_t tree = 0;
    std::uint64_t names = 0;
  };
  std::optional<Members> members{};                   // of a group
  std::optional<ElementForm> form{};                  // of a dataset, as all below
  std::optional<std::vector<std::uint64_t>> sides{};  // empty for a single element
  std::optional<Layout> layout{};
  std::vector<Filter> filters{};  // in the order of packing
  std::vector<Attribute> attributes{};

  // Whether it has all the messages of a dataset.
  [[nodiscard]] bool is_dataset() const { return form && sides && layout; }
  [[nodiscard]] const Attribute* find(std::string_view name) const;
};

// Address of absent data.
inline constexpr std::uint64_t kNowhere = ~std::uint64_t{0};
// Largest number of dimensions of a dataset.
inline constexpr std::size_t kMostSides = 4;

// Number of elements; kNowhere on overflow.
[[nodiscard]] std::uint64_t count_of(const std::vector<std::uint64_t>& sides);

// Error "is no HDF5 as this program writes it: " with the reason.
[[nodiscard]] tl::unexpected<Error> foreign(std::string_view how);

[[nodiscard]] Result<Object> read_object(const Source& source, std::uint64_t address);

}  // namespace shigusa::hdf5
