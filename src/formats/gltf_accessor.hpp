// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <shigusa/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/json_memory.hpp"
#include "glb.hpp"
#include "json_splice.hpp"
#include "unpack.hpp"

namespace shigusa {

// All numbers that are read of one file, and what they are out of, are bounded.
inline constexpr std::size_t kAccessorMaxNumbers = 4'000'000;

// The content that an accessor may have where it is used: floats and normalised integers; also
// integers as they are, which the nodes' places scale; whole numbers without a sign.
enum class AccessorContent { reals, coordinates, indices };

// Elements one after the other.
struct AccessorElements {
  std::string_view bytes;  // from the first one on
  std::size_t stride = 0;  // bytes from one to the next
};

// The numbers of one accessor where they lie in the file, decoded one by one. They have been found
// to lie in it.
class GltfNumbers {
 public:
  [[nodiscard]] std::size_t count() const { return count_; }  // of elements
  // A number as it is meant; it may be anything that a float can be.
  [[nodiscard]] double at(std::size_t element, std::size_t component) const;

 private:
  friend class GltfAccessors;
  std::size_t count_ = 0;
  AccessorComponent kind_;
  bool normalised_ = false;
  AccessorElements elements_;           // none: zeros
  std::vector<std::size_t> elsewhere_;  // of a sparse accessor: elements, rising, …
  AccessorElements replaced_;           // … that are these
};

// One of the attributes that a primitive is asked for, with its components and content.
struct GltfAttribute {
  std::string name;
  int components = 0;
  AccessorContent content = AccessorContent::reals;
};

struct GltfPrimitive {
  std::vector<std::optional<GltfNumbers>> attributes;  // as asked for; none where it has none
  std::optional<GltfNumbers> indices;                  // of its vertices
};

// The numbers of a glTF file: accessors, by way of their buffer views, from the binary chunk of a
// GLB or from data in the text, unpacked where meshopt or Draco packs them. Other files are not
// opened. Reads what is asked for and nothing else; the file's JSON must have been parsed before.
class GltfAccessors {
 public:
  GltfAccessors(const GlbParts& parts, std::string_view name);

  // An accessor whose elements have that number of components: 1, 3, 4, or 16 of a matrix. Errors
  // name the accessor.
  [[nodiscard]] Result<GltfNumbers> open(const nlohmann::json& index, int components,
                                         AccessorContent content);
  // Those of a primitive, from Draco's mesh where one packs it.
  [[nodiscard]] Result<GltfPrimitive> open(const nlohmann::json& primitive,
                                           std::span<const GltfAttribute> wanted);
  // All numbers of an accessor of reals, element by element; `any`: also those that are none, or
  // too large.
  [[nodiscard]] Result<std::vector<double>> numbers(const nlohmann::json& index, int components,
                                                    bool any = false);

 private:
  struct View {
    std::string_view bytes;
    std::size_t stride = 0;  // 0: elements follow each other
  };
  [[nodiscard]] Result<nlohmann::json> entry(const char* list, const nlohmann::json& index);
  [[nodiscard]] Result<View> view(const nlohmann::json& index);
  [[nodiscard]] Result<std::string_view> buffer(const nlohmann::json& index);
  // The bytes that an object with buffer, byteOffset and byteLength names.
  [[nodiscard]] Result<std::string_view> slice(const nlohmann::json& of, const std::string& place);
  [[nodiscard]] Result<std::string_view> unpacked(std::size_t view, std::size_t length,
                                                  const nlohmann::json& packed,
                                                  const std::string& place);
  [[nodiscard]] Result<GltfPrimitive> unpacked(const nlohmann::json& primitive,
                                               const nlohmann::json& packed,
                                               std::span<const GltfAttribute> wanted);
  // An accessor without its elements.
  [[nodiscard]] Result<GltfNumbers> declared(const nlohmann::json& accessor,
                                             const std::string& place, int components,
                                             AccessorContent content) const;
  [[nodiscard]] Result<AccessorElements> elements(const std::string& place,
                                                  const nlohmann::json& holder, std::size_t count,
                                                  std::size_t size);
  [[nodiscard]] Result<void> read_sparse(const std::string& place, const nlohmann::json& sparse,
                                         std::size_t size, GltfNumbers& numbers);
  [[nodiscard]] tl::unexpected<Error> wrong(const std::string& what, const Message& why) const;

  const GlbParts& parts_;
  std::string name_;
  JsonSplice json_;
  std::vector<JsonSplice::Value> accessors_;
  std::vector<JsonSplice::Value> views_;
  std::vector<JsonSplice::Value> buffers_;
  std::vector<std::string> decoded_;             // (buffers) of data in the text
  std::map<std::size_t, std::string> unpacked_;  // (views) once they are asked for
  std::deque<std::string> columns_;              // of Draco's meshes
  std::size_t room_ = kUnpackedMaxBytes;         // for what is unpacked
  std::size_t taken_ = 0;                        // numbers so far
};

// A small value of a JSON text, parsed; larger or deeper ones are refused.
[[nodiscard]] Result<nlohmann::json> parse_small_json(std::string_view text,
                                                      const std::string& place);

}  // namespace shigusa
