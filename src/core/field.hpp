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
  other_side,   // points and rotations go across x = 0, names become the other side's
  assignments,  // texts "left_elbow.weight=3" become the other side's
};

// The groups of options in the help of `shigusa reach`.
enum class OptionGroup {
  none,    // of a field without an option
  body,    // who moves
  goal,    // where effectors end, and how they are turned there
  motion,  // the time that a motion takes, and what its parts do in it
  around,  // obstacles and supports
  search,  // how motions are found
  output,  // what is written, and where
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

// The type of a value's bounds: whole numbers and lengths of lists have whole ones.
template <class Value>
struct BoundOf {
  // The type of bounds of other numbers.
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

// The facts of a field that most fields do without.
template <class Holder, class Value>
struct FieldTraits {
  // Allowed of numbers, of each coordinate of a point and, the upper one, of the length of a list
  // of structs.
  typename BoundOf<Value>::type low{};
  // The upper one of these bounds.
  typename BoundOf<Value>::type high{};
  // A word that may stand for one number in its place; none when empty.
  EnumWord<int> word{};
  bool required = false;         // in files
  const char* option = nullptr;  // of `shigusa reach`: "--look-at"
  const char* form = nullptr;    // of the option's text: "X,Y,Z"
  OptionGroup group{};           // of the option in --help
  const char* brief = nullptr;   // the option's line in --help, of at most 62 characters
  bool rare = false;             // the option stands in --help-all and the manual alone
  // The mirror image of the value.
  Mirroring mirroring = Mirroring::same;
  // Files hold the value where it differs from that of a new Holder, or where this is so.
  bool (*written)(const Holder&) = nullptr;
  // The holders whose files may hold it; all when null.
  bool (*of)(const Holder&) = nullptr;
  // Does what `set` does, where more than the value follows from it.
  void (*adopt)(Holder&, const Value&) = nullptr;
};

// One member of a struct of plain data. Readers, writers, schemas, options and mirror images of
// the struct follow from its table of fields.
template <class Holder, class Value>
struct Field {
  const char* key;  // in files, with its unit: "duration_s"
  // The place of the value in the struct.
  Value Holder::*member;
  const char* says;  // the sentence of schema, --help-all and manual
  // The facts that most fields do without.
  FieldTraits<Holder, Value> traits{};

  // Puts a value into its place, with what follows from it.
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
  const char* name;  // of the struct in schemas: "goal"
  // The sentence of the schema.
  const char* says;
  // The fields, in the order of files.
  std::tuple<Fields...> fields;
};
// A table of the fields that are given.
template <class... Fields>
FieldTable(const char*, const char*, std::tuple<Fields...>) -> FieldTable<Fields...>;

// The fields of a struct in the order of its files. Each struct with a table specialises this
// beside its declaration.
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

// For `written`: files hold the value of each holder.
template <class Holder>
[[nodiscard]] constexpr bool always(const Holder&) {
  return true;
}

}  // namespace shigusa
