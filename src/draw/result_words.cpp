// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>

#include "body/joint_name.hpp"
#include "core/text.hpp"
#include "criteria/built_in_criteria.hpp"

namespace shigusa {
namespace {

// Words for a height as a share of the stature, such as "at hip height".
std::string_view height_words(double share) {
  struct Level {
    double below;
    std::string_view words;
  };
  constexpr std::array<Level, 6> kLevels{{{0.03, "on the floor"},
                                          {0.18, "near the floor"},
                                          {0.42, "low"},
                                          {0.60, "at hip height"},
                                          {0.80, "at chest height"},
                                          {1.02, "at head height"}}};
  for (const Level& level : kLevels) {
    if (share < level.below) return level.words;
  }
  return "overhead";
}

// Words for a region, such as "low in front on the left".
std::string region_words(const Vec3d& place, double stature) {
  constexpr double kNear = 0.08;   // of the stature: right above or below the body
  constexpr double kAside = 0.35;  // share of the other direction above which both are named
  std::string words(height_words(place.y / stature));
  const double across = abs(place.x);
  const double along = abs(place.z);
  if (max(across, along) < kNear * stature) return words;
  if (along > kAside * across) words += place.z > 0.0 ? " in front" : " behind";
  if (across > kAside * along) words += place.x > 0.0 ? " on the left" : " on the right";
  return words;
}

// Midpoint of the goals of two limbs of a kind that are near one another; empty if there are none.
std::optional<Vec3d> goals_middle(std::span<const Goal> goals, JointKind kind) {
  constexpr double kApart = 0.6;  // m
  if (goals.size() != 2) return std::nullopt;
  const JointPlace a = parse_joint_name(goals[0].effector);
  const JointPlace b = parse_joint_name(goals[1].effector);
  const bool both =
      a.joint_kind == kind && b.joint_kind == kind && a.side && b.side && a.side != b.side;
  if (!both || norm(goals[0].position - goals[1].position) > kApart) return std::nullopt;
  return (goals[0].position + goals[1].position) * 0.5;
}

std::string moment_words(const Reason& reason) {
  return reason.time ? fmt::format(" at {:.2f} s", *reason.time) : std::string();
}

}  // namespace

std::string part_words(std::string_view name) {
  const std::size_t dot = name.find('.');
  std::string words(name.substr(0, dot));
  std::replace(words.begin(), words.end(), '_', ' ');
  if (dot != name.npos) words += fmt::format(" ({})", name.substr(dot + 1));
  return words;
}

std::string length_words(double metres) {
  if (metres < 0.0995) return fmt::format("{:.0f} mm", 1e3 * metres);
  if (metres < 0.995) return fmt::format("{:.0f} cm", 1e2 * metres);
  return fmt::format("{:.2f} m", metres);
}

std::string enough_words(double seconds) {
  return fmt::format("{:.1f} s", std::ceil(10.0 * seconds - 1e-6) / 10.0);
}

std::string place_words(const Vec3d& place) {
  std::string words;
  const auto add = [&words](double metres, std::string_view above, std::string_view below) {
    if (metres == 0.0) return;
    words += fmt::format("{}{:g} m {}", words.empty() ? "" : ", ", abs(metres),
                         metres > 0.0 ? above : below);
  };
  add(place.x, "left", "right");
  if (place.y == 0.0) words += words.empty() ? "the floor" : ", on the floor";
  add(place.y, "up", "below the floor");
  add(place.z, "ahead", "behind");
  return words;
}

std::string_view action_name(ActionKind kind) {
  const std::string_view word = word_of(kind);
  return word.substr(0, word.find('_'));  // without a unit
}

std::string action_words(const Action& action) {
  const std::optional<ActionKind> kind = kind_of(action);
  const std::string& thing = !action.grasp.empty()   ? action.grasp
                             : !action.place.empty() ? action.place
                                                     : action.release;
  std::string words(kind ? action_name(*kind) : "nothing");
  if (!thing.empty()) words += fmt::format(" the {}", part_words(thing));
  if (action.position) words += fmt::format(" at {}", place_words(*action.position));
  if (action.wait) words += fmt::format(" for {:g} s", *action.wait);
  if (kind != ActionKind::goals) return words;
  words.clear();
  for (const Goal& goal : action.goals) {
    words += fmt::format("{}{}", words.empty() ? "" : " and ", goal_words(goal));
  }
  return words.empty() ? "look" : words;
}

std::string actions_title(std::span<const Action> actions) {
  std::string title;
  constexpr std::size_t kTold = 4;
  for (std::size_t i = 0; i < std::min(actions.size(), kTold); ++i) {
    Action brief = actions[i];
    brief.position.reset();
    std::string words;
    for (const Goal& goal : brief.goals) {
      words += fmt::format("{} the {}", words.empty() ? "move" : " and", part_words(goal.effector));
    }
    title += (i == 0 ? "" : ", ") + (words.empty() ? action_words(brief) : words);
  }
  if (actions.size() > kTold) title += fmt::format(", and {} more", actions.size() - kTold);
  return capitalised(title);
}

std::string goal_words(const Goal& goal) {
  std::string words =
      fmt::format("{} to {}", part_words(goal.effector), place_words(goal.position));
  if (goal.rotation || goal.axis) words += ", turned as asked";
  if (goal.tolerance != Vec3d{}) words += ", or near it";
  if (goal.load > 0.0) words += fmt::format(", holding {:g} kg", goal.load);
  return words;
}

std::string asked_words(const Request& request) {
  std::string words;
  for (const Goal& goal : request.goals) {
    words += fmt::format("{}{}", words.empty() ? "" : "; ", goal_words(goal));
  }
  for (const Action& action : request.actions) {
    words += fmt::format("{}{}", words.empty() ? "" : "; ", action_words(action));
  }
  if (!request.contacts) return words;
  std::string feet;
  for (const std::string& foot : *request.contacts) {
    feet += fmt::format("{}the {}", feet.empty() ? "standing on " : " and ", part_words(foot));
  }
  return fmt::format("{}{}{}", words, words.empty() ? "" : "; ", feet);
}

std::string goals_title(std::span<const Goal> goals, double stature) {
  if (goals.empty()) return "A foot that lifts";
  for (const auto& [kind, both] :
       {std::pair{JointKind::hand, "hands"}, {JointKind::foot, "feet"}}) {
    if (const auto middle = goals_middle(goals, kind)) {
      return fmt::format("Both {} {}", both, region_words(*middle, stature));
    }
  }
  std::string title;
  constexpr std::size_t kTold = 2;
  for (std::size_t i = 0; i < std::min(goals.size(), kTold); ++i) {
    title += fmt::format("{}{} {}", i == 0 ? "" : ", ", part_words(goals[i].effector),
                         region_words(goals[i].position, stature));
  }
  if (goals.size() > kTold) title += fmt::format(", and {} more goals", goals.size() - kTold);
  return capitalised(title);
}

std::string criterion_words(std::string_view name) {
  for (const CriterionTraits& criterion : kCriteria) {
    if (criterion.word == name) return std::string(criterion.counts);
  }
  return std::string(name);
}

std::string verdict_sentence(const Judgement& judgement) {
  if (judgement.possible_in) {
    return fmt::format("Impossible so fast: {} would do.", enough_words(*judgement.possible_in));
  }
  switch (judgement.verdict) {
    case Verdict::possible:
      return "Possible: strong and steady enough.";
    case Verdict::strains:
      return "Strains: some of this build could.";
    case Verdict::impossible:
      return "Impossible: nobody of this build could.";
  }
  return "";
}

std::string reason_sentence(const Reason& reason) {
  const std::string when = moment_words(reason);
  switch (reason.kind) {
    case ReasonKind::strength:
      return fmt::format("The {} needs {:.0f} N·m{}, {:.1f} times its strength of {:.0f}.",
                         part_words(reason.subject), reason.torque, when, reason.amount,
                         reason.strength);
    case ReasonKind::pressure:
      return fmt::format("The floor would have to press {} outside the feet{}.",
                         reason.amount < kFarOutside ? length_words(reason.amount) : "far", when);
    case ReasonKind::collision:
      return fmt::format("The {} is {} in the {}{}.", part_words(reason.subject),
                         length_words(reason.amount), part_words(reason.other), when);
    case ReasonKind::limit:
      return fmt::format("The {} goes {:.0f}° beyond its range.", part_words(reason.subject),
                         degrees(reason.amount));
  }
  return "";
}

}  // namespace shigusa
