// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <shigusa/error.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace shigusa {

// The mirror image of a field's value.
enum class Mirroring {
  same,         // as it is: a length, a choice
  other_side,   // points and rotations are mirrored at x = 0, names become the other side's
  turn,         // an angle about the vertical changes its sign
  assignments,  // assignments such as "left_elbow.weight=3" become the other side's
};

// The groups of options in the help of `shigusa reach`.
enum class OptionGroup {
  none,    // for a field without an option
  body,    // the moving character
  goal,    // final positions and orientations of effectors
  motion,  // duration and timing of a motion
  around,  // obstacles and supports
  search,  // search of motions
  output,  // output files
};
// The headings of OptionGroup.
template <>
inline constexpr std::array kEnumWords<OptionGroup>{
    EnumWord{OptionGroup::none, ""},
    EnumWord{OptionGroup::body, "The body"},
    EnumWord{OptionGroup::goal, "The goal"},
    EnumWord{OptionGroup::motion, "The motion"},
    EnumWord{OptionGroup::around, "What is around"},
    EnumWord{OptionGroup::search, "The search"},
    EnumWord{OptionGroup::output, "The output"},
};

// The type of a value's bounds: std::uint64_t for integers and lists, double otherwise.
template <class Value>
struct BoundOf {
  // Bounds of other numbers.
  using type = double;
};
// Bounds of whole numbers.
template <std::integral Value>
struct BoundOf<Value> {
  // The type of such bounds.
  using type = std::uint64_t;
};
// Bounds of the length of a list.
template <class Item>
struct BoundOf<std::vector<Item>> {
  // The type of such bounds.
  using type = std::uint64_t;
};
template <class Value>
struct BoundOf<std::optional<Value>> : BoundOf<Value> {};

// Optional facts of a field.
template <class Holder, class Value>
struct FieldTraits {
  // Lower bound of a number or of each coordinate of a point.
  typename BoundOf<Value>::type low{};
  // Upper bound of the same, or of the length of a list of structs.
  typename BoundOf<Value>::type high{};
  // A word that stands for a number; empty: none.
  EnumWord<int> word{};
  bool required = false;         // required in files
  const char* option = nullptr;  // option of `shigusa reach`: "--look-at"
  const char* form = nullptr;    // form of the option's value: "X,Y,Z"
  OptionGroup group{};           // group of the option in --help
  const char* brief = nullptr;   // line of the option in --help, at most 62 characters
  bool rare = false;             // option shown only in --help-all and the manual
  // The mirror image of the value.
  Mirroring mirroring = Mirroring::same;
  // Whether files contain the value; null: if it differs from that of a new Holder.
  bool (*written)(const Holder&) = nullptr;
  // Whether a holder's files may contain the value; null: always.
  bool (*of)(const Holder&) = nullptr;
  // Sets the value and everything that depends on it; null: only the value.
  void (*adopt)(Holder&, const Value&) = nullptr;
};

// A described member of a plain struct. Readers, writers, schemas, options and mirror images follow
// from the struct's table of fields.
template <class Holder, class Value>
struct Field {
  const char* key;  // key in files, with its unit: "duration_s"
  // Pointer to the member.
  Value Holder::*member;
  const char* says;  // description in schema, --help-all and manual
  // Optional facts.
  FieldTraits<Holder, Value> traits{};

  // Sets the value, by `adopt` if there is one.
  void set(Holder& into, Value value) const {
    if (traits.adopt != nullptr) return traits.adopt(into, value);
    into.*member = std::move(value);
  }
};
// A field without further facts.
template <class Holder, class Value>
Field(const char*, Value Holder::*, const char*) -> Field<Holder, Value>;
// A field with further facts.
template <class Holder, class Value>
Field(const char*, Value Holder::*, const char*, FieldTraits<Holder, Value>)
    -> Field<Holder, Value>;

// All fields of a struct.
template <class... Fields>
struct FieldTable {
  const char* name;  // name of the struct in schemas: "goal"
  // Description in schemas.
  const char* says;
  // The fields, in the order of files.
  std::tuple<Fields...> fields;
};
// A table of the fields that are given.
template <class... Fields>
FieldTable(const char*, const char*, std::tuple<Fields...>) -> FieldTable<Fields...>;

// The fields of a struct, in file order. Each struct with a table specialises this.
template <class Holder>
inline constexpr FieldTable<> kFields{};

// A struct with a table of fields.
template <class Holder>
concept Tabled = std::tuple_size_v<decltype(kFields<Holder>.fields)> >
0;

// Calls visit(field) for each field of the struct.
template <Tabled Holder, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&visit](const auto&... field) { (visit(field), ...); }, kFields<Holder>.fields);
}

// A value of FieldTraits::written: files always contain the field.
template <class Holder>
[[nodiscard]] constexpr bool always(const Holder&) {
  return true;
}

}  // namespace shigusa
