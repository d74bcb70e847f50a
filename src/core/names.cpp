// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/words.hpp>
#include <vector>

#include "core/say.hpp"
#include "core/text.hpp"

namespace shigusa {
namespace {

// Names in messages are cut here, so that no input makes a message endless or its work quadratic.
constexpr std::size_t kLongestName = 80;

// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above + 1, row[j - 1] + 1, changed});
      diagonal = above;
    }
  }
  return row.back();
}

// The words of a name: "right", "hand" of "Right-hand".
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

// The first name that has the same words in some order, or else more than these; else empty.
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

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string> known) {
  const std::string_view cut = name.substr(0, kLongestName);
  if (const std::string_view same = same_words(cut, known); !same.empty()) return same;
  std::string_view best;
  std::size_t best_distance = std::string_view::npos;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(cut, candidate);
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
  return nearest.empty() ? say("unknown_name", kind, cut, all)
                         : say("unknown_name_near", kind, cut, nearest, all);
}

}  // namespace shigusa
