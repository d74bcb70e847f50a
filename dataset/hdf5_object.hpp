// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/error.hpp>
#include <vector>

#include "hdf5_source.hpp"
#include "table.hpp"

// Objects of HDF5 files, in the one form that this program's files have: that of the
// earliest version (HDF5 File Format Specification, version 3.0, "version 0 of the superblock").
// Whatever a file may say beside it is refused, as none of ours says so: links to other files and
// places, bytes that other files have, datasets of datasets, filters of others.
namespace shigusa::hdf5 {

// The type of an element.
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

// How a chunk was packed.
enum class Filter { deflate = 1, shuffle = 2, sum = 3 };

// Where a dataset's bytes are.
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
  std::optional<std::vector<std::uint64_t>> sides{};  // none of a single element
  std::optional<Layout> layout{};
  std::vector<Filter> filters{};  // in the order of packing
  std::vector<Attribute> attributes{};

  // Whether all is there that makes a dataset.
  [[nodiscard]] bool is_dataset() const { return form && sides && layout; }
  [[nodiscard]] const Attribute* find(std::string_view name) const;
};

// The address of what is not there.
inline constexpr std::uint64_t kNowhere = ~std::uint64_t{0};
// Sides of a dataset at most.
inline constexpr std::size_t kMostSides = 4;

// How many elements there are; kNowhere where that is no number.
[[nodiscard]] std::uint64_t count_of(const std::vector<std::uint64_t>& sides);

// "is no HDF5 as this program writes it: " and how.
[[nodiscard]] tl::unexpected<Error> foreign(std::string_view how);

[[nodiscard]] Result<Object> read_object(const Source& source, std::uint64_t address);

}  // namespace shigusa::hdf5
