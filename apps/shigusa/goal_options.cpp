// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/character/axis_words.hpp>
#include <shigusa/core/enum_words.hpp>
#include <utility>

#include "commands.hpp"

namespace shigusa::app {
namespace {

using Texts = std::vector<std::string>;

// "NAME=1,2.5,-3": a name and so many numbers.
struct Named {
  std::string name;
  std::vector<double> numbers;
};

// "NAME=REST"
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

// Infinite ones are refused where their ranges are known.
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

std::optional<Named> parse_named(const std::string& text, std::size_t count) {
  const auto parts = split(text);
  if (!parts) return std::nullopt;
  auto numbers = parse_numbers(parts->second, count);
  if (!numbers) return std::nullopt;
  return Named{parts->first, std::move(*numbers)};
}

tl::unexpected<Error> misread(const char* option, const std::string& text, const char* form) {
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} '{}' is not {}", option, text.substr(0, 80), form));
}

// The effector's goal, wherever that was given.
Result<Goal*> goal_of(const char* option, const std::string& effector, TaskFile& file) {
  for (Goal& goal : file.goals) {
    if (goal.effector == effector) return &goal;
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("{} is for an effector with a goal, and {} has none", option, effector));
}

// Reads "EFFECTOR=…" with so many numbers each, and sets what they say of the effector's goal.
template <class Set>
Result<void> set_all(const char* option, const Texts& texts, std::size_t count, const char* form,
                     TaskFile& file, Set&& set) {
  for (const std::string& text : texts) {
    const auto named = parse_named(text, count);
    if (!named) return misread(option, text, form);
    const Result<Goal*> goal = goal_of(option, named->name, file);
    if (!goal) return tl::unexpected(goal.error());
    set(**goal, named->numbers);
  }
  return {};
}

// Points an axis of a hand, a word or three numbers: the second one of a hand makes it a rotation.
Result<void> point(const char* option, const char* axis_word, const std::string& text,
                   TaskFile& file) {
  const auto parts = split(text);
  if (!parts) return misread(option, text, "HAND=DIRECTION");
  const Result<Goal*> goal = goal_of(option, parts->first, file);
  if (!goal) return tl::unexpected(goal.error());
  const Result<Vec3d> axis = hand_axis(axis_word, parts->first);
  if (!axis) return fail(axis.error().code, axis.error().message, option);
  Vec3d direction{};
  if (const auto numbers = parse_numbers(parts->second, 3)) {
    direction = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  } else {
    const Result<Vec3d> named = direction_named(parts->second);
    if (!named) return fail(named.error().code, named.error().message, option);
    direction = *named;
  }
  Goal& of = **goal;
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

Result<void> apply_turns(const GoalOptions& options, TaskFile& file) {
  // what the command line says of a turn takes the place of what a task file says
  for (const Texts* texts :
       {&options.rotations, &options.palms, &options.thumbs, &options.fingers}) {
    for (const std::string& text : *texts) {
      for (Goal& goal : file.goals) {
        if (text.substr(0, text.find('=')) != goal.effector) continue;
        goal.rotation.reset();
        goal.axis.reset();
      }
    }
  }
  const auto turned = set_all("--rotation", options.rotations, 4,
                              "EFFECTOR=X,Y,Z,W with the four numbers of a quaternion", file,
                              [](Goal& goal, const std::vector<double>& n) {
                                goal.rotation = Quatd{n[0], n[1], n[2], n[3]};
                              });
  if (!turned) return turned;
  const struct {
    const char* option;
    const char* word;
    const Texts& texts;
  } axes[] = {{"--palm", "palm", options.palms},
              {"--thumb", "thumb", options.thumbs},
              {"--fingers", "fingers", options.fingers}};
  for (const auto& axis : axes) {
    for (const std::string& text : axis.texts) {
      if (const auto done = point(axis.option, axis.word, text, file); !done) return done;
    }
  }
  return {};
}

Result<void> apply_obstacles(const GoalOptions& options, TaskFile& file) {
  for (const std::string& text : options.obstacles) {
    const auto box = parse_named(text, 6);
    if (!box) {
      return misread("--obstacle", text,
                     "NAME=X,Y,Z,SX,SY,SZ: a box's middle and its size in metres");
    }
    const std::vector<double>& n = box->numbers;
    file.obstacles.push_back(
        {.name = box->name, .position = {n[0], n[1], n[2]}, .size = {n[3], n[4], n[5]}});
  }
  return {};
}

}  // namespace

Result<void> apply_goal_options(const GoalOptions& options, TaskFile& file) {
  if (!options.goals.empty()) file.goals.clear();
  for (const std::string& text : options.goals) {
    const auto goal = parse_named(text, 3);
    if (!goal) return misread("--goal", text, "EFFECTOR=X,Y,Z with three numbers in metres");
    const std::vector<double>& n = goal->numbers;
    file.goals.push_back({.effector = goal->name, .position = {n[0], n[1], n[2]}});
  }
  const auto loaded = set_all("--load", options.loads, 1, "EFFECTOR=KILOGRAMS", file,
                              [](Goal& goal, const std::vector<double>& n) { goal.load = n[0]; });
  if (!loaded) return loaded;
  if (const auto turned = apply_turns(options, file); !turned) return turned;
  const auto boxed =
      set_all("--tolerance", options.tolerances, 3, "EFFECTOR=X,Y,Z with three numbers in metres",
              file, [](Goal& goal, const std::vector<double>& n) {
                goal.tolerance = {n[0], n[1], n[2]};
              });
  if (!boxed) return boxed;
  if (options.look_at) {
    const auto n = parse_numbers(*options.look_at, 3);
    if (!n) return misread("--look-at", *options.look_at, "X,Y,Z with three numbers in metres");
    file.look_at = Vec3d{(*n)[0], (*n)[1], (*n)[2]};
  }
  if (options.contacts) file.contacts = split_at_commas(*options.contacts);
  return apply_obstacles(options, file);
}

}  // namespace shigusa::app
