// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/error.hpp>
#include <vector>

#include "core/say.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

// Length at which names in messages are cut, to bound messages and work for any input.
constexpr std::size_t kLongestName = 80;

// Number of letters to add, drop or change, and of neighbours to swap, to turn one text into the
// other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> cost((a.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return cost[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
      }
    }
  }
  return cost.back();
}

// The words of a name: "right", "hand" for "Right-hand".
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c == '_' || c == '-' || c == '.' || c == ' ') {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += lower(c);
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// The first name with the same words in any order, or else with these and more; else empty.
std::string_view same_words(std::string_view name, std::span<const std::string> known) {
  const std::vector<std::string> asked = words_of(name);
  if (asked.empty()) return {};
  std::string_view longer;
  for (const std::string& candidate : known) {
    const std::vector<std::string> words = words_of(candidate);
    const bool has_all = std::all_of(asked.begin(), asked.end(), [&words](const std::string& word) {
      return contains(words, word);
    });
    if (has_all && longer.empty()) longer = candidate;
    if (std::is_permutation(asked.begin(), asked.end(), words.begin(), words.end())) {
      return candidate;
    }
  }
  return longer;
}

// Whether a requested word is the beginning of a word, or equals it with at most a third of the
// letters wrong.
bool means(const std::string& asked, const std::string& word) {
  if (asked.size() < 3) return asked == word;
  return word.starts_with(asked) || edit_distance(asked, word) * 3 <= asked.size();
}

// The first name with as many words as requested, each possibly abbreviated or misspelt, in any
// order; or else one with more words; else empty.
std::string_view meant_words(std::string_view name, std::span<const std::string> known) {
  const std::vector<std::string> asked = words_of(name);
  std::string_view longer;
  for (const std::string& candidate : known) {
    const std::vector<std::string> words = words_of(candidate.substr(0, kLongestName));
    const bool all = std::all_of(asked.begin(), asked.end(), [&words](const std::string& one) {
      return std::any_of(words.begin(), words.end(),
                         [&one](const std::string& word) { return means(one, word); });
    });
    if (!all || asked.empty()) continue;
    if (words.size() == asked.size()) return candidate;
    if (longer.empty()) longer = candidate;
  }
  return longer;
}

// The same name on the body's other side, if the side was not given: "left_hand" beside
// "right_hand".
std::string_view of_other_side(std::string_view name, std::string_view nearest,
                               std::span<const std::string> known) {
  const std::vector<std::string> asked = words_of(name);
  if (asked.empty()) return {};
  for (const auto& [side, other] : {std::pair{"right", "left"}, std::pair{"left", "right"}}) {
    if (!nearest.starts_with(side) || edit_distance(asked.front(), side) <= 2) continue;
    const std::string wanted = other + std::string(nearest.substr(std::string_view(side).size()));
    const auto found = std::find(known.begin(), known.end(), wanted);
    if (found != known.end()) return *found;
  }
  return {};
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string> known) {
  const std::string_view cut = name.substr(0, kLongestName);
  if (const std::string_view same = same_words(cut, known); !same.empty()) return same;
  if (const std::string_view meant = meant_words(cut, known); !meant.empty()) return meant;
  std::string_view best;
  std::size_t best_distance = std::string_view::npos;
  for (const std::string& candidate : known) {
    const std::size_t distance =
        edit_distance(cut, std::string_view(candidate).substr(0, kLongestName));
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  const bool alike = best_distance * 3 <= std::max(cut.size(), best.size()) * 2;
  return alike ? best : std::string_view{};
}

Message unknown_name(std::string_view kind, std::string_view name,
                     std::span<const std::string> known) {
  std::string all;
  for (std::size_t i = 0; i < known.size(); ++i) all += (i == 0 ? "" : ", ") + known[i];
  const std::string_view cut = name.substr(0, kLongestName);
  const std::string_view nearest = nearest_name(name, known);
  if (nearest.empty()) return say("unknown_name", kind, cut, all);
  const std::string_view other = of_other_side(cut, nearest, known);
  return other.empty() ? say("unknown_name_near", kind, cut, nearest, all)
                       : say("unknown_name_sides", kind, cut, nearest, other, all);
}

}  // namespace shigusa
