// SPDX-License-Identifier: MIT
#include "task_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/goal.hpp>
#include <utility>

#include "core/parse_number.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "problem/request_fields.hpp"

namespace shigusa::app {
namespace {

using Texts = std::vector<std::string>;

// Parses "NAME=1,2.5,-3": a name and numbers.
struct Named {
  std::string name;
  std::vector<double> numbers;
};

// Splits "NAME=REST".
std::optional<std::pair<std::string, std::string>> split(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) return std::nullopt;
  return std::pair{text.substr(0, equals), text.substr(equals + 1)};
}

Texts split_at_commas(const std::string& text) {
  Texts parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  return parts;
}

std::optional<Named> parse_named(const std::string& text, std::size_t count) {
  const auto parts = split(text);
  if (!parts) return std::nullopt;
  auto numbers = parse_numbers(parts->second, count);
  if (!numbers) return std::nullopt;
  return Named{parts->first, std::move(*numbers)};
}

// Type of a value, or of an optional's value.
template <class Value>
struct PlainOf {
  using type = Value;
};
template <class Value>
struct PlainOf<std::optional<Value>> : PlainOf<Value> {};
template <class Value>
using Plain = typename PlainOf<Value>::type;

// Error about a value's numbers: "; 2 numbers are given", "; decimals have a point: 0.2".
std::string numbers_hint(const std::string& text, std::size_t wanted, bool is_named) {
  const std::size_t equals = text.find('=');
  if (is_named && equals == text.npos) return "; no '=' is in it";
  const std::string value = text.substr(is_named ? equals + 1 : 0);
  if (value.find(';') != value.npos) return "; commas stand between numbers";
  const Texts parts = split_at_commas(value);
  for (const std::string& part : parts) {
    if (!parse_number(part)) return fmt::format("; '{}' is no number", part.substr(0, 20));
  }
  if (parts.size() == wanted) return {};
  if (parts.size() == 2 * wanted) return "; decimals have a point: 0.2, and not 0,2";
  return fmt::format("; {} number{} given", parts.size(), parts.size() == 1 ? " is" : "s are");
}

tl::unexpected<Error> misread(const char* option, const std::string& text, const char* form,
                              const std::string& hint = {}) {
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} '{}' is not {}, such as {}{}", option, text.substr(0, 80), form,
                          option_example(option), hint));
}
template <class Holder, class Value>
tl::unexpected<Error> misread(const Field<Holder, Value>& field, const std::string& text,
                              std::size_t wanted) {
  const bool is_named = std::string_view(field.traits.form).find('=') != std::string_view::npos;
  return misread(field.traits.option, text, field.traits.form,
                 numbers_hint(text, wanted, is_named));
}

// Goal of an effector from any option.
Result<Goal*> goal_of(const char* option, const std::string& effector, Request& request) {
  for (Goal& goal : request.goals) {
    if (goal.effector == effector) return &goal;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} is for an effector with a goal, and {} has none: --goal {}=X,Y,Z",
                          option, effector, effector));
}

Quatd from_numbers(const std::vector<double>& n, Quatd) { return {n[0], n[1], n[2], n[3]}; }
Vec3d from_numbers(const std::vector<double>& n, Vec3d) { return {n[0], n[1], n[2]}; }
double from_numbers(const std::vector<double>& n, double) { return n[0]; }

// Reads "EFFECTOR=…" with the field's numbers, and sets the field of the effector's goal.
template <class Value>
Result<void> apply_to_goals(const Field<Goal, Value>& field, const Texts& texts, Request& request) {
  for (const std::string& text : texts) {
    // numbers, points and rotations consist of doubles only
    const std::size_t wanted = sizeof(Plain<Value>) / sizeof(double);
    const auto named = parse_named(text, wanted);
    if (!named) return misread(field, text, wanted);
    SHG_TRY_ASSIGN(Goal* const goal, goal_of(field.traits.option, named->name, request));
    field.set(*goal, from_numbers(named->numbers, Plain<Value>{}));
  }
  return {};
}

// Sets the direction of a hand's axis, by a word or three numbers: a second axis of a hand makes it
// a rotation.
Result<void> point(const char* option, const char* axis_word, const std::string& text,
                   Request& request) {
  const auto parts = split(text);
  if (!parts) return misread(option, text, "HAND=DIRECTION");
  SHG_TRY_ASSIGN(Goal* const goal, goal_of(option, parts->first, request));
  const Result<Vec3d> axis = hand_axis(axis_word, parts->first);
  if (!axis) return fail(axis.error().code, axis.error().message, option);
  Vec3d direction{};
  if (const auto numbers = parse_numbers(parts->second, 3)) {
    direction = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  } else {
    const Result<Vec3d> named = direction_named(parts->second, parts->first);
    if (!named) {
      return fail(named.error().code, named.error().message.text + ", or X,Y,Z", option);
    }
    direction = *named;
  }
  Goal& of = *goal;
  if (!of.axis || of.axis->axis == *axis) {
    of.axis = GoalAxis{*axis, direction};
    return {};
  }
  const Result<Quatd> rotation =
      rotation_pointing(of.axis->axis, of.axis->direction, *axis, direction);
  if (!rotation) return fail(rotation.error().code, rotation.error().message, option);
  of.axis.reset();
  of.rotation = *rotation;
  return {};
}

// Palm, thumb and finger options of hands.
struct HandOption {
  const char* option;
  const char* word;
  const Texts& texts;
};
std::array<HandOption, 3> hand_options(const TaskOptions& options) {
  return {{{"--palm", "palm", options.palms},
           {"--thumb", "thumb", options.thumbs},
           {"--fingers", "fingers", options.fingers}}};
}

// Replaces rotations of a task file by those of the command line.
void forget_turns(const Texts& texts, Request& request) {
  for (const std::string& text : texts) {
    for (Goal& goal : request.goals) {
      if (text.substr(0, text.find('=')) != goal.effector) continue;
      goal.rotation.reset();
      goal.axis.reset();
    }
  }
}

Result<void> apply_goal_fields(const TaskOptions& options, Request& request) {
  for (const HandOption& hand : hand_options(options)) forget_turns(hand.texts, request);
  Result<void> applied;
  for_each_option<Goal>(options.goal, [&](const auto& field, const Texts& texts) {
    using Value = std::remove_cvref_t<decltype(Goal{}.*field.member)>;
    if constexpr (requires(std::vector<double> n) { from_numbers(n, Plain<Value>{}); }) {
      if (std::string_view(field.key) == "rotation_xyzw") forget_turns(texts, request);
      if (applied) applied = apply_to_goals(field, texts, request);
    }
  });
  for (const HandOption& hand : hand_options(options)) {
    for (const std::string& text : hand.texts) {
      if (applied) applied = point(hand.option, hand.word, text, request);
    }
  }
  return applied;
}

// Name for messages, "layer reading" of "--layer-reading".
std::string kind_of(std::string_view option) {
  std::string kind(option.substr(2));
  std::replace(kind.begin(), kind.end(), '-', ' ');
  return kind;
}

// Parses a habit: a name, numbers such as "knees=2.1,round_deg=8", or the path of a file.
Result<Habit> habit_of(const std::string& text) {
  Texts words;
  for (const NamedHabit& named : kHabits) {
    if (text == named.word) return named.habit;
    words.emplace_back(named.word);
  }
  if (text.find_first_of("=./") == text.npos) {
    return fail(ErrorCode::invalid_argument,
                unknown_name("habit", text, words).text + ", or a path such as ./habit.json");
  }
  if (text.find('=') == text.npos) return read_habit(to_path(text));
  Habit habit;
  for (const std::string& part : split_at_commas(text)) {
    const auto named = parse_named(part, 1);
    bool known = false;
    Texts names;
    for_each_field<Habit>([&](const auto& field) {
      std::string name = field.key;
      const bool angle = name.ends_with("_rad");
      if (angle) name.replace(name.size() - 3, 3, "deg");
      names.push_back(name);
      if (!named || named->name != name) return;
      known = true;
      habit.*field.member = angle ? radians(named->numbers[0]) : named->numbers[0];
    });
    if (!named) return misread("--habit", part, "NAME=NUMBER");
    if (!known) {
      return fail(ErrorCode::invalid_argument,
                  unknown_name("number of a habit", named->name, names));
    }
  }
  return habit;
}

// Parses a thing: NAME=X,Y,Z,SX,SY,SZ,KG.
Result<Thing> thing_of(const std::string& text, const char* form) {
  const auto named = parse_named(text, 7);
  if (!named) return misread("--thing", text, form);
  const std::vector<double>& n = named->numbers;
  return Thing{.name = named->name,
               .size = {n[3], n[4], n[5]},
               .mass = n[6],
               .position = {n[0], n[1], n[2]}};
}

// Adds one part of an action, "right_hand=-0.2,1.1,0.4", "place=box,0,0.9,0.4" or "hold=1"; false
// if it is none.
bool add_part(const std::string& part, Action& action) {
  const auto parts = split(part);
  const std::string& word = parts ? parts->first : part;
  if (!parts) {
    if (word == "stand") action.stand.emplace();
    if (word == "via") action.via = true;
    return word == "stand" || word == "via";
  }
  const std::string& value = parts->second;
  const auto number = parse_numbers(value, 1);
  if (word == "wait" && number) action.wait = (*number)[0];
  if (word == "hold" && number) action.hold = (*number)[0];
  if (word == "wait" || word == "hold") return number.has_value();
  if (word == "grasp") action.grasp = value;
  if (word == "release") action.release = value;
  if (word == "with") action.with = split_at_commas(value);
  if (word == "grasp" || word == "release" || word == "with") return true;
  if (word == "place") {
    const std::size_t comma = value.find(',');
    const std::string rest = comma == value.npos ? "" : value.substr(comma + 1);
    const auto turned = parse_numbers(rest, 4);
    const auto at = turned ? turned : parse_numbers(rest, 3);
    if (!at) return false;
    action.place = value.substr(0, comma);
    action.position = Vec3d{(*at)[0], (*at)[1], (*at)[2]};
    action.turn_deg = turned ? (*at)[3] : 0.0;
    return true;
  }
  const auto at = parse_numbers(value, 3);
  if (!at) return false;
  const Vec3d place{(*at)[0], (*at)[1], (*at)[2]};
  if (word == "look")
    action.look_at = place;
  else
    action.goals.push_back({.effector = word, .position = place});
  return true;
}

// Parses an action: parts with semicolons between them.
Result<Action> action_of(const std::string& text, const char* form) {
  Action action;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (!add_part(text.substr(begin, end - begin), action)) return misread("--then", text, form);
    begin = end + 1;
  }
  return action;
}

// Makes the goals the first action of a task with actions.
void goals_first(const TaskOptions& options, Request& request) {
  if (request.actions.empty() && !options.hold) return;
  if (!request.goals.empty()) {
    Action first;
    first.goals = std::move(request.goals);
    request.actions.insert(request.actions.begin(), std::move(first));
    request.goals.clear();
  }
  if (options.hold && !request.actions.empty()) request.actions.front().hold = *options.hold;
}

// Parses an option's text; of a list option, one item.
template <class Value, class AnyField>
Result<Value> parse(const AnyField& field, const std::string& text) {
  if constexpr (std::is_enum_v<Value>) {
    return placed(field.traits.option, value_of<Value>(text, kind_of(field.traits.option)));
  } else if constexpr (std::same_as<Value, CriteriaSettings>) {
    return placed(field.traits.option, mixture_named(text));
  } else if constexpr (std::same_as<Value, Habit>) {
    return placed(field.traits.option, habit_of(text));
  } else if constexpr (std::same_as<Value, std::string>) {
    return text;
  } else if constexpr (std::same_as<Value, Texts>) {
    return split_at_commas(text);
  } else if constexpr (std::same_as<Value, Vec3d>) {
    const auto n = parse_numbers(text, 3);
    if (!n) return misread(field, text, 3);
    return Vec3d{(*n)[0], (*n)[1], (*n)[2]};
  } else if constexpr (std::same_as<Value, Thing>) {
    return thing_of(text, field.traits.form);
  } else if constexpr (std::same_as<Value, Action>) {
    return action_of(text, field.traits.form);
  } else if constexpr (std::same_as<Value, Support>) {
    const auto parts = split(text);
    if (!parts) return misread(field.traits.option, text, field.traits.form);
    return Support{.effector = parts->first, .on = parts->second};
  } else {
    const std::size_t wanted = std::same_as<Value, Goal> ? 3 : 6;
    const auto named = parse_named(text, wanted);
    if (!named) return misread(field, text, wanted);
    const std::vector<double>& n = named->numbers;
    if constexpr (std::same_as<Value, Goal>) {
      return Goal{.effector = named->name, .position = {n[0], n[1], n[2]}};
    } else {
      return Obstacle{
          .name = named->name, .position = {n[0], n[1], n[2]}, .size = {n[3], n[4], n[5]}};
    }
  }
}

// Appends to a list; goals replace those of the same effector.
template <class Item>
Result<void> apply_field(const Field<Request, std::vector<Item>>& field, const Texts& texts,
                         Request& request) {
  std::vector<Item> list = request.*field.member;
  if (std::same_as<Item, Goal>) list.clear();
  for (const std::string& text : texts) {
    SHG_TRY_ASSIGN(Item item, parse<Item>(field, text));
    list.push_back(std::move(item));
  }
  field.set(request, std::move(list));
  return {};
}
template <class Value>
Result<void> apply_field(const Field<Request, Value>& field, const std::optional<std::string>& text,
                         Request& request) {
  SHG_TRY_ASSIGN(Plain<Value> value, parse<Plain<Value>>(field, *text));
  field.set(request, std::move(value));
  return {};
}
template <class Value, class Number>
Result<void> apply_field(const Field<Request, Value>& field, const std::optional<Number>& number,
                         Request& request) {
  field.set(request, *number);
  return {};
}
Result<void> apply_field(const Field<Request, Ergonomics>& field,
                         const std::optional<std::string>& text, Request& request) {
  SHG_TRY_ASSIGN(request.ergonomics,
                 placed(field.traits.option, with_assignments(request.ergonomics, *text)));
  return {};
}
Result<void> apply_field(const Field<Request, bool>& field, bool truth, Request& request) {
  field.set(request, truth);
  return {};
}

}  // namespace

std::optional<std::vector<double>> parse_numbers(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : split_at_commas(text)) {
    const std::optional<double> number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

Result<CriteriaSettings> mixture_named(const std::string& name) {
  Texts known;
  for (const CriteriaPreset& mixture : criteria_presets()) {
    if (name == mixture.name) return mixture.settings();
    known.emplace_back(mixture.name);
  }
  return fail(ErrorCode::invalid_argument, unknown_name("criteria", name, known));
}

std::string mixture_choices() {
  std::vector<std::string_view> names;
  for (const CriteriaPreset& mixture : criteria_presets()) names.push_back(mixture.name);
  return fmt::format("{}", fmt::join(names, "|"));
}

std::string_view option_example(std::string_view option) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kExamples{{
      {"--goal", "right_hand=-0.2,1.1,0.4"},
      {"--load", "right_hand=5"},
      {"--rotation", "right_hand=0,0,0,1"},
      {"--tolerance", "right_hand=0.05,0,0.05"},
      {"--palm", "right_hand=up"},
      {"--thumb", "right_hand=up"},
      {"--fingers", "right_hand=ahead"},
      {"--look-at", "0,1.2,0.6"},
      {"--contacts", "left_foot"},
      {"--obstacle", "table=0,0.7,0.5,1,0.05,0.6"},
      {"--support", "left_hand=thigh"},
      {"--fix", "squat_deg=60"},
      {"--habit", "knees=2.1,round_deg=8"},
      {"--ergonomics", "coupling=poor,lifts_per_min=4"},
      {"--thing", "cup=-0.2,0.9,0.4,0.08,0.1,0.08,0.3"},
      {"--then", "right_hand=-0.2,1.1,0.4"},
  }};
  for (const auto& [name, example] : kExamples) {
    if (name == option) return example;
  }
  return {};
}

bool TaskOptions::has(std::string_view option) const {
  bool given = false;
  for_each_option<Request>(request, [&](const auto& field, const auto& typed) {
    given = given || (option == field.traits.option && is_given(typed));
  });
  return given;
}

Result<void> apply_task_options(const TaskOptions& options, Request& request) {
  Result<void> applied;
  for_each_option<Request>(options.request, [&](const auto& field, const auto& typed) {
    if (applied && is_given(typed)) applied = apply_field(field, typed, request);
  });
  if (applied) applied = apply_goal_fields(options, request);
  if (applied) goals_first(options, request);
  return applied;
}

}  // namespace shigusa::app
