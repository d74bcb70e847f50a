// SPDX-License-Identifier: MIT
#include "export_caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace shigusa {
namespace {

// Heights as shares of the stature.
constexpr double kFloor = 0.12;
constexpr double kLow = 0.5;
constexpr double kHigh = 0.95;
constexpr double kVeryHigh = 1.15;
// Directions (deg) from straight ahead.
constexpr double kAhead = 20.0;
constexpr double kBeside = 65.0;
constexpr double kBehind = 115.0;
constexpr double kBack = 160.0;
constexpr double kOver = 0.12;     // m: nearer to the body's middle than this has no direction
constexpr double kTogether = 0.6;  // m: hands that are nearer to each other reach as one
constexpr double kLoadTold = 0.5;  // kg
constexpr double kReached = 0.01;  // m: a goal missed by more is reached towards

// A word of a sentence with its token.
struct Token {
  std::string_view word;
  std::string_view token;
};
constexpr std::array kTokens{
    Token{"a", "a/DET"},
    Token{"the", "the/DET"},
    Token{"both", "both/DET"},
    Token{"and", "and/CCONJ"},
    Token{"with", "with/ADP"},
    Token{"to", "to/ADP"},
    Token{"in", "in/ADP"},
    Token{"towards", "towards/ADP"},
    Token{"person", "person/NOUN"},
    Token{"floor", "floor/NOUN"},
    Token{"front", "front/NOUN"},
    Token{"hand", "hand/NOUN"},
    Token{"hands", "hand/NOUN"},
    Token{"foot", "foot/NOUN"},
    Token{"knees", "knee/NOUN"},
    Token{"elbow", "elbow/NOUN"},
    Token{"kg", "kg/NOUN"},
    Token{"seated", "seated/ADJ"},
    Token{"straight", "straight/ADJ"},
    Token{"right", "right/ADJ"},
    Token{"left", "left/ADJ"},
    Token{"down", "down/ADV"},
    Token{"forward", "forward/ADV"},
    Token{"up", "up/ADV"},
    Token{"high", "high/ADV"},
    Token{"behind", "behind/ADV"},
    Token{"upright", "upright/ADV"},
    Token{"halfway", "halfway/ADV"},
    Token{"out", "out/ADV"},
    Token{"stands", "stand/VERB"},
    Token{"squats", "squat/VERB"},
    Token{"bends", "bend/VERB"},
    Token{"leans", "lean/VERB"},
    Token{"turns", "turn/VERB"},
    Token{"reaches", "reach/VERB"},
    Token{"moves", "move/VERB"},
    Token{"holding", "hold/VERB"},
};

// Verbs for the posture, such as "bends down with straight knees", "turns left".
std::vector<std::string> posture_verbs(const DataMotion& motion) {
  const std::vector<PostureWord> words = words_for(motion.ends());
  const auto has = [&words](PostureWord word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  const bool seated = has(PostureWord::sitting);
  std::vector<std::string> verbs;
  const auto add = [&verbs](bool said, const char* verb) {
    if (said) verbs.emplace_back(verb);
  };
  const bool straight = has(PostureWord::straight_knees);
  add(seated && has(PostureWord::leaning), "bends forward");
  add(has(PostureWord::half_squat), "squats halfway down");
  add(has(PostureWord::squat), "squats");
  add(has(PostureWord::stoop), straight ? "bends down with straight knees" : "bends down");
  add(!seated && has(PostureWord::leaning), "leans");
  add(!seated && has(PostureWord::knees_bent), "bends the knees");
  add(has(PostureWord::turned_left), "turns left");
  add(has(PostureWord::turned_right), "turns right");
  add(verbs.empty() && !seated, "stands upright");
  return verbs;
}

// Direction with a leading blank, such as "down to the floor in front", "up to the left".
std::string way_to(const Vec3d& goal, double stature) {
  const double height = goal.y / stature;
  std::string way = height < kFloor      ? " down to the floor"
                    : height < kLow      ? " down"
                    : height > kVeryHigh ? " high up"
                    : height > kHigh     ? " up"
                                         : "";
  if (sqrt(goal.x * goal.x + goal.z * goal.z) < kOver) return way;
  const double turn_deg = degrees(atan2(goal.x, goal.z));
  const double away = abs(turn_deg);
  const char* const side = turn_deg > 0.0 ? " to the left" : " to the right";
  if (away < kBeside) way += " in front";
  if (away > kBehind) way += " behind";
  if (away > kAhead && away < kBack) way += side;
  return way;
}

std::string with_blanks(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Load in one or both hands, such as ", holding 5 kg".
std::string load_words(double load) {
  return load < kLoadTold ? "" : fmt::format(", holding {:.0f} kg", load);
}

bool is_hand(const Row& goal) {
  return parse_joint_name(goal.text("effector")).joint_kind == JointKind::hand;
}

// Goal in words, such as "reaches down in front with the right hand".
std::string goal_words(const Row& goal, double stature, bool missed) {
  const std::string effector = with_blanks(goal.text("effector"));
  const std::string way = way_to(goal.point("position_m"), stature);
  const char* const towards = missed && way.empty() ? " out" : "";
  if (!is_hand(goal)) return fmt::format("moves the {}{}", effector, way);
  return fmt::format("reaches{}{} with the {}{}", towards, way, effector,
                     load_words(goal.number("load_kg")));
}

std::vector<std::string> goal_verbs(const DataMotion& motion) {
  const double stature = motion.task.number("stature_m");
  const bool missed = motion.motion.number("error_m") > kReached;
  const auto& goals = motion.goals;
  const bool hands = goals.size() == 2 && is_hand(goals[0]) && is_hand(goals[1]);
  if (hands && norm(goals[0].point("position_m") - goals[1].point("position_m")) < kTogether) {
    const Vec3d middle = 0.5 * (goals[0].point("position_m") + goals[1].point("position_m"));
    const double load = goals[0].number("load_kg") + goals[1].number("load_kg");
    return {fmt::format("reaches{} with both hands{}", way_to(middle, stature), load_words(load))};
  }
  std::vector<std::string> verbs;
  for (const Row& goal : goals) verbs.push_back(goal_words(goal, stature, missed));
  return verbs;
}

// List in words, "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    text += k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ";
    text += parts[k];
  }
  return text;
}

}  // namespace

std::string caption_of(const DataMotion& motion) {
  std::vector<std::string> verbs = posture_verbs(motion);
  for (std::string& verb : goal_verbs(motion)) verbs.push_back(std::move(verb));
  const bool seated = is_finite(motion.task.number("seat_m"));
  return fmt::format("a {}person {}", seated ? "seated " : "", listed(verbs));
}

std::string tokens_of(const std::string& caption) {
  std::string tokens;
  std::string word;
  const auto end_word = [&] {
    if (word.empty()) return;
    const auto known = std::find_if(kTokens.begin(), kTokens.end(),
                                    [&word](const Token& one) { return one.word == word; });
    tokens += tokens.empty() ? "" : " ";
    tokens += known == kTokens.end() ? word + "/NOUN" : std::string(known->token);
    word.clear();
  };
  for (const char c : caption) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter) {
      word += c;
    } else {
      end_word();
    }
  }
  end_word();
  return tokens;
}

}  // namespace shigusa
