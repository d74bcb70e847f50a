// SPDX-License-Identifier: MIT
#include "hdf5_object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace shigusa::hdf5 {
namespace {

// Message types of an object's header.
enum Kind : std::uint64_t {
  none = 0x0,
  space = 0x1,
  old_fill_value = 0x4,
  type = 0x3,
  fill_value = 0x5,
  layout = 0x8,
  filters = 0xB,
  attribute = 0xC,
  goes_on = 0x10,
  members = 0x11,
};
constexpr std::size_t kMostMessages = 512;                    // of an object
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20;  // of a block of messages
constexpr std::uint64_t kShared = 2;                          // flag of messages stored elsewhere

std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }

// Properties of the two floating-point types, after their sizes.
constexpr std::string_view kFloat("\0\0\x20\0\x17\x08\0\x17\x7F\0\0\0", 12);
constexpr std::string_view kDouble("\0\0\x40\0\x34\x0B\0\x34\xFF\x03\0\0", 12);

std::optional<ElementForm> whole_number(std::uint64_t bits, std::size_t size, Bytes& bytes) {
  constexpr std::array kTypes{ElementType::u8, ElementType::u16, ElementType::u32,
                              ElementType::u64};
  const std::uint64_t offset = bytes.number(2);
  const std::uint64_t precision = bytes.number(2);
  for (const ElementType one : kTypes) {
    if (size_of(one) != size) continue;
    if (bits == 0 && offset == 0 && precision == 8 * size) return ElementForm{one, size};
  }
  return std::nullopt;
}

std::optional<ElementForm> fraction(std::uint64_t bits, std::size_t size, Bytes& bytes) {
  constexpr std::uint64_t kFloatBits = 0x1F20;
  constexpr std::uint64_t kDoubleBits = 0x3F20;
  const std::string_view properties = bytes.text(kFloat.size());
  if (size == 4 && bits == kFloatBits && properties == kFloat) {
    return ElementForm{ElementType::f32, size};
  }
  if (size == 8 && bits == kDoubleBits && properties == kDouble) {
    return ElementForm{ElementType::f64, size};
  }
  return std::nullopt;
}

std::optional<ElementForm> form_of(Bytes& bytes) {
  constexpr std::uint64_t kVersion = 1;
  constexpr std::uint64_t kMostPaddings = 2;
  const std::uint64_t kind = bytes.number(1);
  const std::uint64_t bits = bytes.number(3);
  const std::size_t size = bytes.number(4);
  if (!bytes.whole() || size == 0 || kind >> 4 != kVersion) return std::nullopt;
  switch (kind & 0xF) {
    case 0:
      return whole_number(bits, size, bytes);
    case 1:
      return fraction(bits, size, bytes);
    case 3:
      if ((bits & 0xF) > kMostPaddings || bits >> 4 > 1) return std::nullopt;
      return ElementForm{ElementType::text, size};
    default:
      return std::nullopt;
  }
}

std::optional<std::vector<std::uint64_t>> sides_of(Bytes& bytes) {
  constexpr std::uint64_t kVersion = 1;
  constexpr std::uint64_t kHasMost = 1;
  const std::uint64_t version = bytes.number(1);
  const std::size_t rank = bytes.number(1);
  const std::uint64_t flags = bytes.number(1);
  bytes.skip(5);
  if (version != kVersion || rank > kMostSides || flags > kHasMost) return std::nullopt;
  std::vector<std::uint64_t> sides(rank);
  for (std::uint64_t& side : sides) side = bytes.number(8);
  if (flags == kHasMost) bytes.skip(8 * rank);
  if (!bytes.whole()) return std::nullopt;
  return sides;
}

std::optional<Layout> layout_of(Bytes& bytes) {
  constexpr std::uint64_t kVersion = 3;
  constexpr std::uint64_t kContiguous = 1;
  constexpr std::uint64_t kChunked = 2;
  const std::uint64_t version = bytes.number(1);
  const std::uint64_t kind = bytes.number(1);
  if (version != kVersion || (kind != kContiguous && kind != kChunked)) return std::nullopt;
  Layout layout{.chunked = kind == kChunked, .chunk = {}};
  const std::size_t rank = layout.chunked ? bytes.number(1) : 0;
  layout.address = bytes.number(8);
  if (!layout.chunked) layout.size = bytes.number(8);
  if (rank > kMostSides + 1) return std::nullopt;
  for (std::size_t k = 0; k < rank; ++k) layout.chunk.push_back(bytes.number(4));
  if (!bytes.whole()) return std::nullopt;
  return layout;
}

std::optional<std::vector<Filter>> filters_of(Bytes& bytes) {
  constexpr std::uint64_t kVersion = 1;
  constexpr std::size_t kMost = 3;
  const std::uint64_t version = bytes.number(1);
  const std::size_t count = bytes.number(1);
  bytes.skip(6);
  if (version != kVersion || count > kMost) return std::nullopt;
  std::vector<Filter> filters;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t number = bytes.number(2);
    const std::size_t name = bytes.number(2);
    bytes.skip(2);  // whether it may be left out
    const std::size_t values = bytes.number(2);
    bytes.skip(padded(name) + 4 * (values + values % 2));
    const auto filter = static_cast<Filter>(number);
    const bool again = std::find(filters.begin(), filters.end(), filter) != filters.end();
    if (!bytes.whole() || number < 1 || number > kMost || again) return std::nullopt;
    filters.push_back(filter);
  }
  return filters;
}

std::optional<Attribute> attribute_of(Bytes& bytes) {
  constexpr std::uint64_t kVersion = 1;
  const std::uint64_t version = bytes.number(1);
  bytes.skip(1);
  const std::size_t name_size = bytes.number(2);
  const std::size_t type_size = bytes.number(2);
  const std::size_t space_size = bytes.number(2);
  if (version != kVersion) return std::nullopt;
  const std::string_view name = bytes.text(padded(name_size));
  Bytes type(bytes.text(padded(type_size)));
  Bytes space(bytes.text(padded(space_size)));
  const auto form = form_of(type);
  const auto sides = sides_of(space);
  if (!bytes.whole() || !form || !sides) return std::nullopt;
  const std::uint64_t count = count_of(*sides);
  if (count > bytes.rest().size() / form->size) return std::nullopt;
  return Attribute{.name = std::string(name.substr(0, name.find('\0'))),
                   .form = *form,
                   .count = count,
                   .bytes = std::string(bytes.text(count * form->size))};
}

// Addresses of continuation blocks.
struct Block {
  std::uint64_t address = 0;
  std::uint64_t size = 0;
};

// Reads a message; false if it is not supported.
bool take(std::uint64_t kind, Bytes bytes, Object& object, std::vector<Block>& blocks) {
  switch (kind) {
    case none:
    case old_fill_value:
    case fill_value:
      return true;
    case space:
      return (object.sides = sides_of(bytes)).has_value();
    case type:
      return (object.form = form_of(bytes)).has_value();
    case layout:
      return (object.layout = layout_of(bytes)).has_value();
    case filters: {
      auto found = filters_of(bytes);
      if (found) object.filters = *std::move(found);
      return found.has_value();
    }
    case attribute: {
      auto found = attribute_of(bytes);
      if (found) object.attributes.push_back(*std::move(found));
      return found.has_value();
    }
    case goes_on: {
      const std::uint64_t address = bytes.number(8);
      blocks.push_back({address, bytes.number(8)});
      return bytes.whole();
    }
    case members: {
      const std::uint64_t tree = bytes.number(8);
      object.members = Object::Members{tree, bytes.number(8)};
      return bytes.whole();
    }
    default:
      return false;
  }
}

}  // namespace

const Attribute* Object::find(std::string_view name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& one) { return one.name == name; });
  return found == attributes.end() ? nullptr : &*found;
}

std::uint64_t count_of(const std::vector<std::uint64_t>& sides) {
  std::uint64_t count = 1;
  if (std::find(sides.begin(), sides.end(), 0) != sides.end()) return 0;
  for (const std::uint64_t side : sides) {
    if (count > kNowhere / side) return kNowhere;
    count *= side;
  }
  return count;
}

tl::unexpected<Error> foreign(std::string_view how) {
  return fail(ErrorCode::parse, fmt::format("is no HDF5 as this program writes it: {}", how), "");
}

Result<Object> read_object(const Source& source, std::uint64_t address) {
  constexpr std::uint64_t kVersion = 1;
  constexpr std::size_t kHeadBytes = 16;
  const std::optional<std::string> head = source.bytes(address, kHeadBytes);
  if (!head) return foreign("an object is not there");
  Bytes numbers(*head);
  const std::uint64_t version = numbers.number(1);
  numbers.skip(1);
  std::size_t left = numbers.number(2);
  numbers.skip(4);
  std::vector<Block> blocks{{address + kHeadBytes, numbers.number(4)}};
  if (version != kVersion || left > kMostMessages) return foreign("an object's header is another");
  Object object;
  for (std::size_t b = 0; b < blocks.size() && left > 0; ++b) {
    if (blocks.size() > kMostMessages || blocks[b].size > kMostBytes) {
      return foreign("an object's header is too long");
    }
    const std::optional<std::string> block = source.bytes(blocks[b].address, blocks[b].size);
    if (!block) return foreign("a part of an object's header is not there");
    for (Bytes bytes(*block); !bytes.rest().empty() && left > 0; --left) {
      const std::uint64_t kind = bytes.number(2);
      const std::size_t size = bytes.number(2);
      const std::uint64_t flags = bytes.number(1);
      bytes.skip(3);
      const Bytes message(bytes.text(size));
      if (!bytes.whole()) return foreign("a message of a header ends too early");
      if ((flags & kShared) != 0 || !take(kind, message, object, blocks)) {
        return foreign(fmt::format("an object has a message {:#x} that is not ours", kind));
      }
    }
  }
  return object;
}

}  // namespace shigusa::hdf5
