// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <shigusa/core/result.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "glb.hpp"
#include "json_splice.hpp"

namespace shigusa {

// All numbers that are read of one file, and what they are out of, are bounded.
inline constexpr std::size_t kAccessorMaxNumbers = 4'000'000;

// The numbers of a glTF file: accessors, by way of their buffer views, from the binary chunk of a
// GLB or from data in the text. Other files are not opened. Reads what is asked for and nothing
// else; the file's JSON must have been parsed before.
class GltfAccessors {
 public:
  GltfAccessors(const GlbParts& parts, std::string_view name);

  // The numbers of an accessor, `components` for each of its elements, which must have so many:
  // floats, or normalised integers, as they are meant. Errors name the accessor.
  [[nodiscard]] Result<std::vector<double>> numbers(const nlohmann::json& index, int components);

 private:
  struct View {
    std::string_view bytes;
    std::size_t stride = 0;  // 0: elements follow each other
  };
  [[nodiscard]] Result<nlohmann::json> entry(const char* list, const nlohmann::json& index);
  [[nodiscard]] Result<View> view(const nlohmann::json& index);
  [[nodiscard]] Result<std::string_view> buffer(const nlohmann::json& index);
  [[nodiscard]] tl::unexpected<Error> wrong(const std::string& what, const std::string& why) const;

  const GlbParts& parts_;
  std::string name_;
  JsonSplice json_;
  std::vector<JsonSplice::Value> accessors_;
  std::vector<JsonSplice::Value> views_;
  std::vector<JsonSplice::Value> buffers_;
  std::vector<std::string> decoded_;  // (buffers) of data in the text
  std::size_t taken_ = 0;             // numbers so far
};

// A small value of a JSON text, parsed; larger or deeper ones are refused.
[[nodiscard]] Result<nlohmann::json> parse_small_json(std::string_view text,
                                                      const std::string& place);

}  // namespace shigusa
