// SPDX-License-Identifier: MIT
#include "gltf_accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/say.hpp"
#include "formats/base64.hpp"
#include "formats/gltf.hpp"
#include "formats/gltf_json.hpp"
#include "watched_json.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kMaxValueBytes = std::size_t{16} << 20;
constexpr int kMaxValueDepth = 16;

// Optional whole number up to 2^53.
std::optional<std::size_t> whole(const GltfJson& object, const char* key, std::size_t otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned()) return std::nullopt;
  const auto value = found->get<std::uint64_t>();
  if (value > (std::uint64_t{1} << 53)) return std::nullopt;
  return static_cast<std::size_t>(value);
}

struct Kind {
  int type;
  AccessorComponent component;
};
constexpr std::array kKinds{Kind{5120, {1, 127.0, true}},         Kind{5121, {1, 255.0, false}},
                            Kind{5122, {2, 32767.0, true}},       Kind{5123, {2, 65535.0, false}},
                            Kind{5125, {4, 4294967295.0, false}}, Kind{5126, {4, 0.0, true}}};

const AccessorComponent* component_of(std::optional<std::size_t> type) {
  for (const Kind& kind : kKinds) {
    if (type == static_cast<std::size_t>(kind.type)) return &kind.component;
  }
  return nullptr;
}

bool may_hold(AccessorContent content, const AccessorComponent& component, bool normalised) {
  if (content == AccessorContent::indices) return !component.has_sign && !normalised;
  const bool wide = component.bytes == 4 && component.largest > 0.0;
  if (wide) return false;
  return content == AccessorContent::coordinates || component.largest == 0.0 || normalised;
}

const char* allowed(AccessorContent content) {
  switch (content) {
    case AccessorContent::indices:
      return "whole numbers without a sign (5121, 5123, 5125)";
    case AccessorContent::coordinates:
      return "floats (5126), bytes or shorts";
    default:
      return "floats (5126) or normalised bytes or shorts";
  }
}

double decoded(std::string_view bytes, std::size_t at, const AccessorComponent& kind) {
  std::uint32_t bits = 0;
  for (std::size_t i = kind.bytes; i-- > 0;) {
    bits = bits << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  }
  if (kind.largest == 0.0) return static_cast<double>(__builtin_bit_cast(float, bits));
  const std::int64_t sign = std::int64_t{1} << (8 * kind.bytes - 1);
  const std::int64_t value = bits;
  return static_cast<double>(kind.has_sign && value >= sign ? value - 2 * sign : value);
}

constexpr std::array kMeshopt{"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr std::array kDraco{"KHR_draco_mesh_compression"};

// First of these extensions that an object has.
template <std::size_t N>
const GltfJson* extension(const GltfJson& of, const std::array<const char*, N>& names) {
  const auto extensions = of.find("extensions");
  if (extensions == of.end() || !extensions->is_object()) return nullptr;
  for (const char* name : names) {
    const auto found = extensions->find(name);
    if (found != extensions->end() && found->is_object()) return &*found;
  }
  return nullptr;
}

std::string text_or_none(const GltfJson& of, const char* key) {
  const auto found = of.find(key);
  return found != of.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

Result<GltfJson> parse_small_json(std::string_view text, const std::string& place) {
  if (text.size() > kMaxValueBytes) {
    return fail(ErrorCode::parse, say("json_bytes", text.size(), kMaxValueBytes), place);
  }
  const auto shallow = [](int depth, GltfJson::parse_event_t, const GltfJson&) {
    if (depth > kMaxValueDepth) throw say("is_nested_levels", kMaxValueDepth);
    return true;
  };
  return parse_watched<GltfJson>(text, shallow, "JSON", place);
}

GltfAccessors::GltfAccessors(const GlbParts& parts, std::string_view name)
    : parts_(parts), name_(name), json_(parts.json) {
  accessors_ = json_.elements(json_.member(json_.root(), "accessors"));
  views_ = json_.elements(json_.member(json_.root(), "bufferViews"));
  buffers_ = json_.elements(json_.member(json_.root(), "buffers"));
  decoded_.resize(buffers_.size());
}

tl::unexpected<Error> GltfAccessors::wrong(const std::string& what, const Message& why) const {
  return fail(ErrorCode::parse, why, what + " of " + name_);
}

Result<GltfJson> GltfAccessors::entry(const char* list, const GltfJson& index) {
  const auto& entries = list == std::string_view("accessors")     ? accessors_
                        : list == std::string_view("bufferViews") ? views_
                                                                  : buffers_;
  const auto count = static_cast<std::uint64_t>(entries.size());
  if (!index.is_number_unsigned() || index >= count) {
    return wrong(
        list,
        say("none_of_list",
            index.dump(-1, ' ', true, GltfJson::error_handler_t::replace).substr(0, 40), count));
  }
  const auto& value = entries[index.get<std::size_t>()];
  const std::string place = fmt::format("{}[{}]", list, index.get<std::size_t>());
  // embedded data are decoded without parsing
  if (const auto uri = json_.member(value, "uri"); uri) return GltfJson(json_.text_of(uri));
  // one entry may be requested many times
  constexpr std::size_t kMaxEntryBytes = std::size_t{64} << 10;
  if (json_.text_of(value).size() > kMaxEntryBytes) {
    return wrong(place, say("json_bytes", json_.text_of(value).size(), kMaxEntryBytes));
  }
  Result<GltfJson> parsed = parse_small_json(json_.text_of(value), place + " of " + name_);
  if (parsed && !parsed->is_object()) return wrong(place, say("no_object"));
  return parsed;
}

Result<std::string_view> GltfAccessors::buffer(const GltfJson& index) {
  SHG_TRY_ASSIGN(const GltfJson found, entry("buffers", index));
  const auto i = index.get<std::size_t>();
  const std::string place = fmt::format("buffers[{}]", i);
  if (found.is_object()) {
    if (i == 0 && parts_.binary) return *parts_.binary;
    return wrong(place, say("buffer_no_data"));
  }
  if (!decoded_[i].empty()) return std::string_view(decoded_[i]);
  const std::string& uri = found.get_ref<const std::string&>();  // with its quotes
  constexpr std::string_view kBase64 = ";base64,";
  const std::size_t comma = uri.find(kBase64);
  if (!uri.starts_with("\"data:") || comma == uri.npos) {
    return wrong(place, say("other_file", uri.substr(0, 80)));
  }
  const std::size_t begin = comma + kBase64.size();
  auto bytes = from_base64(std::string_view(uri).substr(begin, uri.size() - 1 - begin));
  if (!bytes) return wrong(place, say("data_not_encoded"));
  decoded_[i] = std::move(*bytes);
  return std::string_view(decoded_[i]);
}

Result<std::string_view> GltfAccessors::slice(const GltfJson& of, const std::string& place) {
  const auto offset = whole(of, "byteOffset", 0);
  const auto length = whole(of, "byteLength", 0);
  if (!of.contains("buffer") || !offset || !length) return wrong(place, say("buffer_numbers"));
  SHG_TRY_ASSIGN(const std::string_view bytes, buffer(of["buffer"]));
  if (*offset > bytes.size() || *length > bytes.size() - *offset) {
    return wrong(place, say("bytes_beyond", *offset, *offset + *length, bytes.size()));
  }
  return bytes.substr(*offset, *length);
}

Result<GltfAccessors::View> GltfAccessors::view(const GltfJson& index) {
  SHG_TRY_ASSIGN(const GltfJson found, entry("bufferViews", index));
  const auto i = index.get<std::size_t>();
  const std::string place = fmt::format("bufferViews[{}]", i);
  const auto length = whole(found, "byteLength", 0);
  const auto stride = whole(found, "byteStride", 0);
  constexpr std::size_t kMaxStride = 252;
  if (!length || !stride || *stride > kMaxStride) return wrong(place, say("buffer_numbers"));
  if (const GltfJson* packed = extension(found, kMeshopt)) {
    SHG_TRY_ASSIGN(const std::string_view bytes, unpacked(i, *length, *packed, place));
    return View{bytes, *stride};
  }
  SHG_TRY_ASSIGN(const std::string_view bytes, slice(found, place));
  return View{bytes, *stride};
}

Result<std::string_view> GltfAccessors::unpacked(std::size_t view, std::size_t length,
                                                 const GltfJson& packed, const std::string& place) {
  if (const auto kept = unpacked_.find(view); kept != unpacked_.end()) return kept->second;
  const auto count = whole(packed, "count", 0);
  const auto stride = whole(packed, "byteStride", 0);
  if (!count || !stride || *stride == 0 || *count > length / *stride ||
      *count * *stride != length) {
    return wrong(place, say("packed_view", length));
  }
  if (length > room_) return wrong(place, say("unpacked_bytes", kUnpackedMaxBytes));
  SHG_TRY_ASSIGN(const std::string_view bytes, slice(packed, place));
  const MeshoptView told{*count, *stride, text_or_none(packed, "mode"),
                         text_or_none(packed, "filter")};
  SHG_TRY_ASSIGN(std::string plain, unpack_meshopt(told, bytes, place + " of " + name_));
  room_ -= length;
  return unpacked_[view] = std::move(plain);
}

Result<AccessorElements> GltfAccessors::elements(const std::string& place, const GltfJson& holder,
                                                 std::size_t count, std::size_t size) {
  const auto offset = whole(holder, "byteOffset", 0);
  if (!offset) return wrong(place, say("byte_offset"));
  SHG_TRY_ASSIGN(const View found, view(holder["bufferView"]));
  const std::size_t stride = found.stride > 0 ? found.stride : size;
  const std::size_t room = found.bytes.size();
  const bool fits = count == 0 || (*offset <= room && size <= room - *offset &&
                                   count - 1 <= (room - *offset - size) / stride);
  if (!fits || stride < size) {
    return wrong(place, say("elements_do_not_fit", count, size, room));
  }
  return AccessorElements{count == 0 ? std::string_view{} : found.bytes.substr(*offset), stride};
}

// Sparse elements: their indices, ascending, and their numbers.
Result<void> GltfAccessors::read_sparse(const std::string& place, const GltfJson& sparse,
                                        std::size_t size, GltfNumbers& numbers) {
  const auto count = sparse.is_object() ? whole(sparse, "count", 0) : std::nullopt;
  const bool whole_list = count && *count <= numbers.count_ && sparse.contains("indices") &&
                          sparse["indices"].is_object() && sparse.contains("values") &&
                          sparse["values"].is_object();
  if (!whole_list || !sparse["indices"].contains("bufferView") ||
      !sparse["values"].contains("bufferView")) {
    return wrong(place, say("sparse_lacks"));
  }
  const GltfJson& indices = sparse["indices"];
  const AccessorComponent* kind = component_of(whole(indices, "componentType", 0));
  if (kind == nullptr || !may_hold(AccessorContent::indices, *kind, false)) {
    return wrong(place, say("sparse_indices", allowed(AccessorContent::indices)));
  }
  SHG_TRY_ASSIGN(const AccessorElements which, elements(place, indices, *count, kind->bytes));
  SHG_TRY_ASSIGN(const AccessorElements values, elements(place, sparse["values"], *count, size));
  numbers.elsewhere_.reserve(*count);
  for (std::size_t i = 0; i < *count; ++i) {
    const auto index = static_cast<std::size_t>(decoded(which.bytes, i * which.stride, *kind));
    if (index >= numbers.count_ || (i > 0 && index <= numbers.elsewhere_.back())) {
      return wrong(place, say("sparse_index", i, index, numbers.count_));
    }
    numbers.elsewhere_.push_back(index);
  }
  numbers.replaced_ = values;
  return {};
}

Result<GltfNumbers> GltfAccessors::declared(const GltfJson& accessor, const std::string& place,
                                            int components, AccessorContent content) const {
  constexpr std::array kTypes{"", "SCALAR", "", "VEC3", "VEC4"};
  const char* type = components == 16 ? "MAT4" : kTypes[static_cast<std::size_t>(components)];
  if (!accessor.contains("type") || !is_text(accessor["type"], type)) {
    return wrong(place, say("accessor_type", type));
  }
  const auto count = whole(accessor, "count", 0);
  const AccessorComponent* kind = component_of(whole(accessor, "componentType", 0));
  const bool normalised = accessor.contains("normalized") && accessor["normalized"] == true;
  if (!count || kind == nullptr || !may_hold(content, *kind, normalised)) {
    return wrong(place, say("accessor_numbers", allowed(content)));
  }
  GltfNumbers numbers;
  numbers.count_ = *count;
  numbers.kind_ = *kind;
  numbers.normalised_ = normalised && kind->largest > 0.0;
  return numbers;
}

Result<GltfNumbers> GltfAccessors::open(const GltfJson& index, int components,
                                        AccessorContent content) {
  SHG_TRY_ASSIGN(const GltfJson accessor, entry("accessors", index));
  const std::string place = fmt::format("accessors[{}]", index.get<std::size_t>());
  SHG_TRY_ASSIGN(GltfNumbers numbers, declared(accessor, place, components, content));
  const std::size_t size = static_cast<std::size_t>(components) * numbers.kind_.bytes;
  const bool sparse = accessor.contains("sparse");
  if (!accessor.contains("bufferView") && !sparse) {
    return wrong(place, say("no_buffer_view"));
  }
  if (accessor.contains("bufferView")) {
    SHG_TRY_ASSIGN(numbers.elements_, elements(place, accessor, numbers.count_, size));
  }
  if (sparse) {
    SHG_TRY(read_sparse(place, accessor["sparse"], size, numbers));
  }
  return numbers;
}

Result<GltfPrimitive> GltfAccessors::open(const GltfJson& primitive,
                                          std::span<const GltfAttribute> wanted) {
  if (const GltfJson* packed = extension(primitive, kDraco)) {
    return unpacked(primitive, *packed, wanted);
  }
  GltfPrimitive opened;
  const GltfJson& attributes = primitive["attributes"];
  for (const auto& [name, components, content] : wanted) {
    opened.attributes.emplace_back();
    if (!attributes.contains(name)) continue;
    SHG_TRY_ASSIGN(opened.attributes.back(), open(attributes[name], components, content));
  }
  if (primitive.contains("indices")) {
    SHG_TRY_ASSIGN(opened.indices, open(primitive["indices"], 1, AccessorContent::indices));
  }
  return opened;
}

Result<GltfPrimitive> GltfAccessors::unpacked(const GltfJson& primitive, const GltfJson& packed,
                                              std::span<const GltfAttribute> wanted) {
  const auto ids = packed.find("attributes");
  if (ids == packed.end() || !ids->is_object() || !packed.contains("bufferView")) {
    return wrong("mesh", say("draco_lacks"));
  }
  const GltfJson& attributes = primitive["attributes"];
  GltfPrimitive opened;
  std::vector<DracoAttribute> columns;
  for (const auto& [name, components, content] : wanted) {
    std::optional<GltfNumbers>& numbers = opened.attributes.emplace_back();
    const auto id = whole(*ids, name.c_str(), kAccessorMaxNumbers);
    if (!attributes.contains(name) || !id || *id >= kAccessorMaxNumbers) continue;
    SHG_TRY_ASSIGN(const GltfJson accessor, entry("accessors", attributes[name]));
    SHG_TRY_ASSIGN(numbers, declared(accessor, "accessors of mesh", components, content));
    columns.push_back({static_cast<std::uint32_t>(*id), components, numbers->kind_});
  }
  SHG_TRY_ASSIGN(const View view, this->view(packed["bufferView"]));
  SHG_TRY_ASSIGN(DracoMesh mesh, unpack_draco(view.bytes, columns, room_, "mesh of " + name_));
  const auto put = [&](GltfNumbers& numbers, std::size_t count, std::string&& bytes) {
    numbers.count_ = count;
    numbers.elements_ = {columns_.emplace_back(std::move(bytes)),
                         count == 0 ? 0 : columns_.back().size() / count};
  };
  std::size_t column = 0;
  for (std::optional<GltfNumbers>& numbers : opened.attributes) {
    if (numbers) put(*numbers, mesh.points, std::move(mesh.columns[column++]));
  }
  opened.indices.emplace().kind_ = {4, 4294967295.0, false};
  const std::size_t corners = mesh.corners.size() / 4;
  put(*opened.indices, corners, std::move(mesh.corners));
  return opened;
}

Result<std::vector<double>> GltfAccessors::numbers(const GltfJson& index, int components,
                                                   bool any) {
  SHG_TRY_ASSIGN(const GltfNumbers found, open(index, components, AccessorContent::reals));
  const std::string place = fmt::format("accessors[{}]", index.get<std::size_t>());
  const auto per = static_cast<std::size_t>(components);
  if (found.count() > (kAccessorMaxNumbers - taken_) / per) {
    return wrong(place, say("animation_numbers", found.count(), kAccessorMaxNumbers));
  }
  taken_ += found.count() * per;
  std::vector<double> values;
  values.reserve(found.count() * per);
  for (std::size_t i = 0; i < found.count(); ++i) {
    for (std::size_t k = 0; k < per; ++k) {
      const double value = found.at(i, k);
      if (!any && !(abs(value) <= kGltfMaxValue)) {
        return wrong(place, say("element_range", i, value, -kGltfMaxValue, kGltfMaxValue));
      }
      values.push_back(value);
    }
  }
  return values;
}

double GltfNumbers::at(std::size_t element, std::size_t component) const {
  const auto other = std::lower_bound(elsewhere_.begin(), elsewhere_.end(), element);
  const bool moved = other != elsewhere_.end() && *other == element;
  // values missing from a sparse accessor are 0
  if (!moved && elements_.bytes.empty()) return 0.0;
  const AccessorElements& in = moved ? replaced_ : elements_;
  const std::size_t row = moved ? static_cast<std::size_t>(other - elsewhere_.begin()) : element;
  const double value = decoded(in.bytes, row * in.stride + component * kind_.bytes, kind_);
  return normalised_ ? max(value / kind_.largest, -1.0) : value;
}

}  // namespace shigusa
