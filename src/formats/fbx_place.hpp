// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/math.hpp>
#include <string_view>

#include "fbx_records.hpp"

namespace shigusa {

// Lookup of properties by name: in a record, in its kind's template, else the default.
class FbxProperties {
 public:
  FbxProperties(const FbxRecord* own, const FbxRecord* kind) : lists_{own, kind} {}

  [[nodiscard]] const FbxRecord* find(std::string_view name) const {
    for (const FbxRecord* list : lists_) {
      if (list == nullptr) continue;
      for (const FbxRecord& each : list->within) {
        if (each.name == "P" && each.text(0) == name) return &each;
      }
    }
    return nullptr;
  }
  [[nodiscard]] Vec3d vector(std::string_view name, const Vec3d& otherwise = {}) const {
    const FbxRecord* p = find(name);
    return p == nullptr ? otherwise : Vec3d{p->number(4), p->number(5), p->number(6)};
  }
  [[nodiscard]] double number(std::string_view name, double otherwise) const {
    const FbxRecord* p = find(name);
    return p == nullptr ? otherwise : p->number(4);
  }

 private:
  std::array<const FbxRecord*, 2> lists_;
};

// Local transform: translation · rotation · scale.
struct FbxPlace {
  Vec3d at;
  Quatd turned;
  Vec3d scale;
};

// Local transform of Autodesk's SDK: T · Roff · Rp · Rpre · R · Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S ·
// Sp⁻¹.
[[nodiscard]] FbxPlace place_of(const FbxProperties& properties);

// Scale inheritance of a model: its parent's whole scale applied after its own rotation, before it,
// or only the scale that the parent inherited. In the order of the file's numbers.
enum class FbxInherit { after_turn, before_turn, but_the_parents_own };
[[nodiscard]] FbxInherit inherit_of(const FbxProperties& properties);

// Global transform of a model, T · R · inherited · S, as computed by Autodesk's SDK.
struct FbxWorldPlace {
  Vec3d at{};
  Mat3d turned{};
  Mat3d inherited{};  // scale and shear
  Vec3d scale{1, 1, 1};
};
[[nodiscard]] FbxWorldPlace below(const FbxWorldPlace& parent, const FbxPlace& place,
                                  FbxInherit inherit);

}  // namespace shigusa
