// SPDX-License-Identifier: MIT
#include "gltf_accessor.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <shigusa/io/gltf.hpp>

namespace shigusa {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxValueBytes = std::size_t{16} << 20;
constexpr int kMaxValueDepth = 16;

// A whole number that may be missing, up to 2^53.
std::optional<std::size_t> whole(const Json& object, const char* key, std::size_t otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned()) return std::nullopt;
  const auto value = found->get<std::uint64_t>();
  if (value > (std::uint64_t{1} << 53)) return std::nullopt;
  return static_cast<std::size_t>(value);
}

// One kind of a component: its bytes, and what an integer's largest value stands for 1.
struct Component {
  int type;
  std::size_t bytes;
  double largest;  // 0: a float
  bool has_sign;
};
constexpr std::array kComponents{Component{5120, 1, 127.0, true}, Component{5121, 1, 255.0, false},
                                 Component{5122, 2, 32767.0, true},
                                 Component{5123, 2, 65535.0, false}, Component{5126, 4, 0.0, true}};

double component_at(std::string_view bytes, std::size_t at, const Component& kind) {
  if (kind.largest == 0.0) {
    return static_cast<double>(__builtin_bit_cast(float, word_at(bytes, at)));
  }
  std::int32_t value = static_cast<std::uint8_t>(bytes[at]);
  if (kind.bytes == 2) value |= static_cast<std::uint8_t>(bytes[at + 1]) << 8;
  const std::int32_t sign = 1 << (8 * kind.bytes - 1);
  if (kind.has_sign && (value & sign) != 0) value -= 2 * sign;
  return max(static_cast<double>(value) / kind.largest, -1.0);
}

std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    std::uint32_t six = 0;
    if (c >= 'A' && c <= 'Z') {
      six = static_cast<std::uint32_t>(c - 'A');
    } else if (c >= 'a' && c <= 'z') {
      six = static_cast<std::uint32_t>(c - 'a') + 26;
    } else if (c >= '0' && c <= '9') {
      six = static_cast<std::uint32_t>(c - '0') + 52;
    } else if (c == '+' || c == '/') {
      six = c == '+' ? 62 : 63;
    } else {
      return std::nullopt;
    }
    group = (group << 6 | six) & 0xFFFFFF;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xFF);
  }
  return bytes;
}

}  // namespace

Result<Json> parse_small_json(std::string_view text, const std::string& place) {
  if (text.size() > kMaxValueBytes) {
    return fail(
        ErrorCode::parse,
        fmt::format("takes {} bytes of JSON; up to {} are allowed", text.size(), kMaxValueBytes),
        place);
  }
  const auto shallow = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > kMaxValueDepth)
      throw fmt::format("is nested deeper than {} levels", kMaxValueDepth);
    return true;
  };
  try {
    return Json::parse(text, shallow);
  } catch (const std::string& passed) {
    return fail(ErrorCode::parse, passed, place);
  } catch (const Json::exception&) {
    return fail(ErrorCode::parse, "is not JSON", place);
  }
}

GltfAccessors::GltfAccessors(const GlbParts& parts, std::string_view name)
    : parts_(parts), name_(name), json_(parts.json) {
  accessors_ = json_.elements(json_.member(json_.root(), "accessors"));
  views_ = json_.elements(json_.member(json_.root(), "bufferViews"));
  buffers_ = json_.elements(json_.member(json_.root(), "buffers"));
  decoded_.resize(buffers_.size());
}

tl::unexpected<Error> GltfAccessors::wrong(const std::string& what, const std::string& why) const {
  return fail(ErrorCode::parse, why, what + " of " + name_);
}

Result<Json> GltfAccessors::entry(const char* list, const Json& index) {
  const auto& entries = list == std::string_view("accessors")     ? accessors_
                        : list == std::string_view("bufferViews") ? views_
                                                                  : buffers_;
  const auto count = static_cast<std::uint64_t>(entries.size());
  if (!index.is_number_unsigned() || index >= count) {
    return wrong(
        list, fmt::format("{} is none of the {} there are",
                          index.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, 40),
                          count));
  }
  const auto& value = entries[index.get<std::size_t>()];
  const std::string place = fmt::format("{}[{}]", list, index.get<std::size_t>());
  // data in the text are not parsed but decoded
  if (const auto uri = json_.member(value, "uri"); uri) return Json(json_.text_of(uri));
  Result<Json> parsed = parse_small_json(json_.text_of(value), place + " of " + name_);
  if (parsed && !parsed->is_object()) return wrong(place, "is no object");
  return parsed;
}

Result<std::string_view> GltfAccessors::buffer(const Json& index) {
  const Result<Json> found = entry("buffers", index);
  if (!found) return tl::unexpected(found.error());
  const auto i = index.get<std::size_t>();
  if (found->is_object()) {
    if (i == 0 && parts_.binary) return *parts_.binary;
    return wrong(fmt::format("buffers[{}]", i), "has no data in the file");
  }
  if (!decoded_[i].empty()) return std::string_view(decoded_[i]);
  const std::string& uri = found->get_ref<const std::string&>();  // with its quotes
  constexpr std::string_view kBase64 = ";base64,";
  const std::size_t comma = uri.find(kBase64);
  if (!uri.starts_with("\"data:") || comma == uri.npos) {
    return wrong(fmt::format("buffers[{}]", i),
                 fmt::format("is in another file, {}, which is not opened: export the character as "
                             "one .glb file",
                             uri.substr(0, 80)));
  }
  const std::size_t begin = comma + kBase64.size();
  auto bytes = from_base64(std::string_view(uri).substr(begin, uri.size() - 1 - begin));
  if (!bytes) return wrong(fmt::format("buffers[{}]", i), "its data is no base64");
  decoded_[i] = std::move(*bytes);
  return std::string_view(decoded_[i]);
}

Result<GltfAccessors::View> GltfAccessors::view(const Json& index) {
  const Result<Json> found = entry("bufferViews", index);
  if (!found) return tl::unexpected(found.error());
  const std::string place = fmt::format("bufferViews[{}]", index.get<std::size_t>());
  const auto offset = whole(*found, "byteOffset", 0);
  const auto length = whole(*found, "byteLength", 0);
  const auto stride = whole(*found, "byteStride", 0);
  if (!found->contains("buffer") || !offset || !length || !stride || *stride > 252) {
    return wrong(place,
                 "buffer, byteOffset, byteLength and byteStride (0 to 252) must be whole "
                 "numbers");
  }
  const Result<std::string_view> bytes = buffer((*found)["buffer"]);
  if (!bytes) return tl::unexpected(bytes.error());
  if (*offset > bytes->size() || *length > bytes->size() - *offset) {
    return wrong(place, fmt::format("bytes {} to {} lie beyond the {} of its buffer", *offset,
                                    *offset + *length, bytes->size()));
  }
  return View{bytes->substr(*offset, *length), *stride};
}

Result<std::vector<double>> GltfAccessors::numbers(const Json& index, int components) {
  const Result<Json> found = entry("accessors", index);
  if (!found) return tl::unexpected(found.error());
  const std::string place = fmt::format("accessors[{}]", index.get<std::size_t>());
  const Json& accessor = *found;
  constexpr std::array kTypes{"", "SCALAR", "", "VEC3", "VEC4"};
  const char* type = kTypes[static_cast<std::size_t>(components)];
  if (!accessor.contains("type") || accessor["type"] != type) {
    return wrong(place, fmt::format("its type must be {} here", type));
  }
  if (accessor.contains("sparse") || !accessor.contains("bufferView")) {
    return wrong(place,
                 "is sparse, or has no bufferView; only accessors that hold their numbers are "
                 "read");
  }
  const auto offset = whole(accessor, "byteOffset", 0);
  const auto count = whole(accessor, "count", 0);
  const auto kind_number = whole(accessor, "componentType", 0);
  const Component* kind = nullptr;
  for (const Component& each : kComponents) {
    if (kind_number == static_cast<std::size_t>(each.type)) kind = &each;
  }
  const bool normalised = accessor.contains("normalized") && accessor["normalized"] == true;
  if (!offset || !count || kind == nullptr || (kind->largest > 0.0 && !normalised)) {
    return wrong(place,
                 "byteOffset and count must be whole numbers, and componentType floats (5126) "
                 "or normalised bytes or shorts");
  }
  const auto per = static_cast<std::size_t>(components);
  if (*count > (kAccessorMaxNumbers - taken_) / per) {
    return wrong(place,
                 fmt::format("{} elements are too many; animations may have {} numbers in all",
                             *count, kAccessorMaxNumbers));
  }
  const Result<View> view_found = view(accessor["bufferView"]);
  if (!view_found) return tl::unexpected(view_found.error());
  const std::size_t size = per * kind->bytes;
  const std::size_t stride = view_found->stride > 0 ? view_found->stride : size;
  const std::size_t room = view_found->bytes.size();
  const bool fits = *count == 0 || (*offset <= room && size <= room - *offset &&
                                    *count - 1 <= (room - *offset - size) / stride);
  if (!fits || stride < size) {
    return wrong(place, fmt::format("{} elements of {} bytes do not fit into its view of {} bytes",
                                    *count, size, room));
  }
  taken_ += *count * per;
  std::vector<double> values;
  values.reserve(*count * per);
  for (std::size_t i = 0; i < *count; ++i) {
    for (std::size_t k = 0; k < per; ++k) {
      const double value =
          component_at(view_found->bytes, *offset + i * stride + k * kind->bytes, *kind);
      if (!(abs(value) <= kGltfMaxValue)) {
        return wrong(place, fmt::format("element {} holds {:g}; allowed are {:g} to {:g}", i, value,
                                        -kGltfMaxValue, kGltfMaxValue));
      }
      values.push_back(value);
    }
  }
  return values;
}

}  // namespace shigusa
