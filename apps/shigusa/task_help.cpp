// SPDX-License-Identifier: MIT
// Help texts and registration of the options of a task.
#include <fmt/format.h>

#include <shigusa/error.hpp>

#include "commands.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

// Words of an enum, or of the mixtures of criteria; for other values the form of their text.
template <class Value>
std::string words_or(const char* form) {
  if constexpr (std::is_enum_v<Value>) {
    return choices<Value>();
  } else if constexpr (std::same_as<Value, CriteriaSettings>) {
    return mixture_choices();
  } else {
    return form == nullptr ? "" : form;
  }
}
template <class Holder, class Value>
std::string form_of(const Field<Holder, Value>& field) {
  return words_or<Value>(field.traits.form);
}
template <class Holder, class Value>
std::string form_of(const Field<Holder, std::optional<Value>>& field) {
  return words_or<Value>(field.traits.form);
}

// Example, " Example: `--palm right_hand=up`.", if the option has one.
std::string example_of(const char* option) {
  const std::string_view example = option_example(option);
  return example.empty() ? "" : fmt::format(" Example: `{} {}`.", option, example);
}

// Description of a field's option, from the field's row.
OptionHelp help_of_field(const auto& field, const char* more) {
  const auto& traits = field.traits;
  return {.group = heading(traits.group),
          .brief = traits.brief == nullptr ? field.says : traits.brief,
          .full = std::string(field.says) + more + example_of(traits.option),
          .form = form_of(field),
          .rare = traits.rare};
}

// Adds the option of each field, with the bounds of whole numbers.
template <class Holder>
void add_field_options(CLI::App& c, FieldOptions<Holder>& o) {
  for_each_option<Holder>(o, [&c](const auto& field, auto& typed) {
    using Typed = std::remove_cvref_t<decltype(typed)>;
    const auto& traits = field.traits;
    if constexpr (std::same_as<Typed, bool>) {
      describe(c.add_flag(traits.option, typed), help_of_field(field, ""));
    } else if constexpr (std::same_as<Typed, std::vector<std::string>>) {
      describe(c.add_option(traits.option, typed)->allow_extra_args(false),
               help_of_field(field, " Repeatable."));
    } else {
      CLI::Option* option = c.add_option(traits.option, typed);
      if constexpr (std::integral<decltype(traits.low)>) {
        if (traits.high > 0) option->check(whole_number(traits.low, traits.high));
      }
      describe(option, help_of_field(field, ""));
    }
  });
}

void add_hand_options(CLI::App& c, TaskOptions& o) {
  const auto add = [&](const char* name, std::vector<std::string>& into, const char* brief,
                       const char* full, bool rare) {
    describe(c.add_option(name, into)->allow_extra_args(false),
             {.group = heading(OptionGroup::goal),
              .brief = brief,
              .full = std::string(full) + " Repeatable." + example_of(name),
              .form = "HAND=DIRECTION",
              .rare = rare});
  };
  add("--palm", o.palms, "Direction of the palm: up, down, left, right, ahead, back, in, out",
      "The direction that the palm faces at the end: up, down, left, right, ahead, back, in, out, "
      "or X,Y,Z; "
      "the hand may turn about it.",
      false);
  add("--thumb", o.thumbs, "Direction of the thumb's side, along what the hand grips",
      "The direction, as of --palm, of the thumb's side, along what the hand grips; with --palm or "
      "--fingers the whole rotation.",
      true);
  add("--fingers", o.fingers, "Direction of the fingers",
      "The direction, as of --palm, that the fingers point to; with --palm or --thumb the whole "
      "rotation.",
      true);
}

}  // namespace

void add_task_options(CLI::App& command, TaskOptions& options) {
  add_field_options<Request>(command, options.request);
  add_field_options<Goal>(command, options.goal);
  add_hand_options(command, options);
  describe(command.add_option("--hold", options.hold)->check(number(0.0, kPauseMax)),
           {.group = heading(OptionGroup::goal),
            .brief = "Seconds for which the body stays at its goals",
            .full = "Seconds for which the body stays at the goals, as the first of the actions.",
            .form = "SECONDS"});
}

}  // namespace shigusa::app
