// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace shigusa {

/// A sentence for a person: in English, and as the key and values by which a page words it in
/// another language. A value is a Message as well: a number, a sentence, or a text such as a name
/// from a file, which stays as it is.
struct Message {
  Message() = default;                                       ///< says nothing
  Message(std::string words) : text(std::move(words)) {}     ///< a text without a key
  Message(std::string_view words) : text(words) {}           ///< a text without a key
  Message(const char* words) : text(words) {}                ///< a text without a key
  operator const std::string&() const { return text; }       ///< in English
  [[nodiscard]] bool empty() const { return text.empty(); }  ///< says nothing

  std::string text;              ///< in English; of a number its digits within the sentence
  std::string_view key;          ///< of the engine's sentence (shigusa_facts); empty of others
  std::vector<Message> values;   ///< of such a sentence, in the order of its holes
  std::optional<double> number;  ///< of a number, in `unit`
  std::string_view unit;         ///< of a number that is a length, "m" or "mm"; else empty

  /// Whether the English texts are the same; then the values are.
  friend bool operator==(const Message& a, const Message& b) { return a.text == b.text; }
  /// Whether that is the English text.
  template <std::convertible_to<std::string_view> Text>
  requires(!std::same_as<Text, Message>) friend bool operator==(const Message& a, const Text& b) {
    return a.text == std::string_view(b);
  }
};

/// The kind of an error.
enum class ErrorCode {
  invalid_argument,  ///< the caller's or the user's value is outside what is allowed
  not_found,         ///< a file, joint or effector of that name does not exist
  parse,             ///< a file's text does not follow its format
  io,                ///< the operating system refused to read or write
  unsupported,       ///< understood, but outside what this version does
  cancelled,         ///< the user stopped the work
};

/// A failure with its place and the remedy. `place` is empty or a location such as
/// "line 12 of walk.bvh"; `message` names the value seen and the values allowed.
struct Error {
  ErrorCode code = ErrorCode::invalid_argument;  ///< the kind
  Message message;                               ///< for a person
  std::string place;                             ///< where it is, or empty

  /// One line for a person: "line 12 of walk.bvh: ...".
  [[nodiscard]] std::string to_string() const {
    return place.empty() ? message.text : place + ": " + message.text;
  }
  /// The same, of which a page can word the message.
  [[nodiscard]] Message to_message() const;
};

/// A value, or the reason why there is none. Used for files, users and networks; a caller's broken
/// precondition is SHG_CHECK's.
template <class T>
using Result = tl::expected<T, Error>;

/// Makes an error to be returned as a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, Message message,
                                                std::string place = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(place)});
}

/// Returns the expression's error from this function, where it is one; its value is dropped.
#define SHG_TRY(...)                                    \
  do {                                                  \
    if (auto tried_ = (__VA_ARGS__); !tried_) {         \
      return tl::unexpected(std::move(tried_).error()); \
    }                                                   \
  } while (false)

#define SHG_TRY_ASSIGN_TO(tried, target, ...)                  \
  auto tried = (__VA_ARGS__);                                  \
  if (!tried) return tl::unexpected(std::move(tried).error()); \
  target = *std::move(tried)
#define SHG_TRY_ASSIGN_LINE(line, target, ...) \
  SHG_TRY_ASSIGN_TO(tried_##line##_, target, __VA_ARGS__)
#define SHG_TRY_ASSIGN_AT(line, target, ...) SHG_TRY_ASSIGN_LINE(line, target, __VA_ARGS__)
/// Returns the expression's error from this function, where it is one; else its value goes to the
/// target, a declaration or what can be assigned to:
/// SHG_TRY_ASSIGN(const Clip clip, read_clip(path));
#define SHG_TRY_ASSIGN(target, ...) SHG_TRY_ASSIGN_AT(__LINE__, target, __VA_ARGS__)

/// Thrown by SHG_CHECK: the caller broke a documented precondition.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The name of `known` that has the words of `name` in any order and case, or else these and more,
/// or else words that begin so or are misspelt so, or else is nearest by edit distance; empty when
/// none shares a third of it. For messages about misspelt names.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string> known);

/// "unknown effector 'right_hnad'; did you mean 'right_hand'? Known: left_hand, right_hand".
[[nodiscard]] Message unknown_name(std::string_view kind, std::string_view name,
                                   std::span<const std::string> known);

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
