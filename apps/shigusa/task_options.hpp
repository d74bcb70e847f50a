// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <optional>
#include <shigusa/request.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "problem/request_fields.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace shigusa::app {

// Type in which an option of a field is stored until it is applied: numbers and flags directly,
// others as text. Options of a goal name their effector and are repeatable.
template <class Holder, class Value>
struct TypedOf {
  using Text = std::optional<std::string>;
  using Number = std::conditional_t<std::is_arithmetic_v<Value>, std::optional<Value>, Text>;
  using type = std::conditional_t<std::same_as<Value, bool>, bool, Number>;
};
template <class Holder, class Item>
struct TypedOf<Holder, std::vector<Item>> {
  using type = std::vector<std::string>;
};
template <class Holder, class Value>
struct TypedOf<Holder, std::optional<Value>> : TypedOf<Holder, Value> {};
template <class Holder>
struct TypedOf<Holder, std::optional<std::vector<std::string>>> {
  using type = std::optional<std::string>;
};
template <class Value>
struct TypedOf<Goal, Value> {
  using type = std::vector<std::string>;
};
template <class Value>
struct TypedOf<Goal, std::optional<Value>> {
  using type = std::vector<std::string>;
};

// Options of a struct's fields, in the order of its table.
template <class... Fields>
struct FieldOptionsOf;
template <class Holder, class... Values>
struct FieldOptionsOf<std::tuple<Field<Holder, Values>...>> {
  std::tuple<typename TypedOf<Holder, Values>::type...> typed{};
};
template <class Holder>
using FieldOptions = FieldOptionsOf<std::remove_const_t<decltype(kFields<Holder>.fields)>>;

// Calls visit(field, typed) for each field with an option.
template <class Holder, class Options, class Visit>
void for_each_option(Options& options, Visit&& visit) {
  const auto visit_one = [&](const auto& field, auto& typed) {
    if (field.traits.option != nullptr) visit(field, typed);
  };
  const auto& fields = kFields<Holder>.fields;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit_one(std::get<I>(fields), std::get<I>(options.typed)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(options.typed)>>{});
}

template <class Typed>
[[nodiscard]] bool is_given(const Typed& typed) {
  if constexpr (std::same_as<Typed, bool>) {
    return typed;
  } else if constexpr (requires { typed.has_value(); }) {
    return typed.has_value();
  } else {
    return !typed.empty();
  }
}

// Example of an option's value, "right_hand=-0.2,1.1,0.4", for help and messages; empty for most
// options.
[[nodiscard]] std::string_view option_example(std::string_view option);

// Options of a task, as typed.
struct TaskOptions {
  FieldOptions<Request> request;
  FieldOptions<Goal> goal;
  std::vector<std::string> palms;  // HAND=DIRECTION, and so thumbs and fingers
  std::vector<std::string> thumbs;
  std::vector<std::string> fingers;
  std::optional<double> hold{};  // s, at the end of the first action

  // Whether the request's option of that name is given.
  [[nodiscard]] bool has(std::string_view option) const;
};

// Adds the options of a task to a command, with their help.
void add_task_options(CLI::App& command, TaskOptions& options);

// Mixture of criteria by name; fails on unknown names.
[[nodiscard]] Result<CriteriaSettings> mixture_named(const std::string& name);
// Names of all mixtures as an option's form: "paper|default|pareto".
[[nodiscard]] std::string mixture_choices();

// Applies the given options to the request; goals replace the existing ones. Fails on malformed
// values, unknown words, and options for an effector without a goal.
[[nodiscard]] Result<void> apply_task_options(const TaskOptions& options, Request& request);

// Numbers of a text with commas between; nothing unless they are `count`. Infinite ones are refused
// by the range checks.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(const std::string& text,
                                                               std::size_t count);

}  // namespace shigusa::app
