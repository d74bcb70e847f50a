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

// Limits on the numbers read from one file, and on the data that contains them.
inline constexpr std::size_t kAccessorMaxNumbers = 4'000'000;

// Permitted content of an accessor, depending on its use: floats and normalised integers; also
// plain integers, scaled by the nodes' transforms; unsigned integers.
enum class AccessorContent { reals, coordinates, indices };

// Elements in sequence.
struct AccessorElements {
  std::string_view bytes;  // from the first one on
  std::size_t stride = 0;  // bytes from one to the next
};

// Numbers of one accessor in the file, decoded on access. Their range has been checked.
class GltfNumbers {
 public:
  [[nodiscard]] std::size_t count() const { return count_; }  // of elements
  // Decoded number; it may be any value of a float.
  [[nodiscard]] double at(std::size_t element, std::size_t component) const;

 private:
  friend class GltfAccessors;
  std::size_t count_ = 0;
  AccessorComponent kind_;
  bool normalised_ = false;
  AccessorElements elements_;           // none: zeros
  std::vector<std::size_t> elsewhere_;  // indices of a sparse accessor, ascending
  AccessorElements replaced_;           // their values
};

// An attribute requested of a primitive, with its components and content.
struct GltfAttribute {
  std::string name;
  int components = 0;
  AccessorContent content = AccessorContent::reals;
};

struct GltfPrimitive {
  std::vector<std::optional<GltfNumbers>> attributes;  // as requested; empty if absent
  std::optional<GltfNumbers> indices;                  // of its vertices
};

// Reader of a glTF file's numbers: accessors, through their buffer views, from the binary chunk of
// a GLB or from embedded data, decoded if packed by meshopt or Draco. Other files are not opened,
// and only requested data is read; the file's JSON must have been parsed before.
class GltfAccessors {
 public:
  GltfAccessors(const GlbParts& parts, std::string_view name);

  // Accessor with that number of components: 1, 3, 4, or 16 for a matrix. Errors name the accessor.
  [[nodiscard]] Result<GltfNumbers> open(const nlohmann::json& index, int components,
                                         AccessorContent content);
  // Attributes of a primitive, from Draco's mesh if it is packed.
  [[nodiscard]] Result<GltfPrimitive> open(const nlohmann::json& primitive,
                                           std::span<const GltfAttribute> wanted);
  // All numbers of an accessor of reals, element by element; `any`: accepts NaN and values beyond
  // the limits.
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
  // Bytes referred to by an object with buffer, byteOffset and byteLength.
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
  std::map<std::size_t, std::string> unpacked_;  // (views) unpacked on first use
  std::deque<std::string> columns_;              // of Draco's meshes
  std::size_t room_ = kUnpackedMaxBytes;         // left for unpacked data
  std::size_t taken_ = 0;                        // numbers so far
};

// Parses a small value of a JSON text; larger or deeper ones are refused.
[[nodiscard]] Result<nlohmann::json> parse_small_json(std::string_view text,
                                                      const std::string& place);

}  // namespace shigusa
