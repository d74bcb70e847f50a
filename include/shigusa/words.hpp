// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/result.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The name of `known` that has the words of `name` in any order and case, or else these and more,
/// or else words that begin so or are misspelt so, or else is nearest by edit distance; empty when
/// none shares a third of it. For messages about misspelt names.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string> known);

/// "unknown effector 'right_hnad'; did you mean 'right_hand'? Known: left_hand, right_hand".
[[nodiscard]] Message unknown_name(std::string_view kind, std::string_view name,
                                   std::span<const std::string> known);

/// The number that the whole text writes, "-0.5", "+1e3", ".5" or "inf", nearest double. It has a
/// point in every locale that the program may have chosen. A number too large for a double becomes
/// infinite, what is too small 0. None for anything else: blanks around it, "1,5", "0x10".
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// A value of an enum and the word that files, options and messages have for it.
template <class Enum>
struct EnumWord {
  Enum value;             ///< of the enum
  std::string_view word;  ///< in files
};

template <class Enum>
EnumWord(Enum, std::string_view) -> EnumWord<Enum>;  ///< clang 14 deduces no aggregates by itself

/// The words of an enum, in the order in which messages list them. Each enum with words specialises
/// this beside its declaration; the library has them nowhere else.
template <class Enum>
inline constexpr std::array<EnumWord<Enum>, 0> kEnumWords{};

/// The words of a table whose rows have a value and a word: kEnumWords of what has more to tell.
template <class Row, std::size_t size, class Enum>
[[nodiscard]] constexpr std::array<EnumWord<Enum>, size> words_of_table(
    const std::array<Row, size>& table, Enum Row::*value) {
  std::array<EnumWord<Enum>, size> words{};
  for (std::size_t i = 0; i < size; ++i) words[i] = {table[i].*value, table[i].word};
  return words;
}

/// The word for a value; empty where it has none.
template <class Enum>
[[nodiscard]] constexpr std::string_view word_of(Enum value) {
  for (const EnumWord<Enum>& known : kEnumWords<Enum>) {
    if (known.value == value) return known.word;
  }
  return {};
}

/// All words of an enum, in the order of kEnumWords.
template <class Enum>
[[nodiscard]] std::vector<std::string> all_words() {
  std::vector<std::string> words;
  for (const EnumWord<Enum>& known : kEnumWords<Enum>) words.emplace_back(known.word);
  return words;
}

/// The value of a word; else ErrorCode::invalid_argument with the nearest word and all that are
/// known: "unknown search 'cma'; did you mean 'cma_es'? Known: …". `kind` is "search".
template <class Enum>
[[nodiscard]] Result<Enum> value_of(std::string_view word, std::string_view kind) {
  for (const EnumWord<Enum>& known : kEnumWords<Enum>) {
    if (known.word == word) return known.value;
  }
  return fail(ErrorCode::invalid_argument, unknown_name(kind, word, all_words<Enum>()));
}

}  // namespace shigusa
