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

/// A message for a person: the English text, and a key with values for translation. Each value is a
/// Message too: a number, a sentence, or a text that stays untranslated, such as a name from a
/// file.
struct Message {
  Message() = default;                                       ///< an empty message
  Message(std::string words) : text(std::move(words)) {}     ///< a text without a key
  Message(std::string_view words) : text(words) {}           ///< a text without a key
  Message(const char* words) : text(words) {}                ///< a text without a key
  operator const std::string&() const { return text; }       ///< the English text
  [[nodiscard]] bool empty() const { return text.empty(); }  ///< whether the text is empty

  std::string text;  ///< English text; for a number its digits as in the sentence
  std::string_view
      key;  ///< key of a sentence of the library (listed by shigusa_facts); empty for other texts
  /// Values of a sentence with a key, in the order of its placeholders.
  std::vector<Message> values;
  std::optional<double> number;  ///< value of a number, in `unit`
  std::string_view unit;         ///< unit of a number: "m" or "mm" for a length, else empty

  /// Whether the English texts are equal.
  friend bool operator==(const Message& a, const Message& b) { return a.text == b.text; }
  /// Whether the English text equals a string.
  template <std::convertible_to<std::string_view> Text>
  requires(!std::same_as<Text, Message>) friend bool operator==(const Message& a, const Text& b) {
    return a.text == std::string_view(b);
  }
};

/// The kind of an Error.
enum class ErrorCode {
  invalid_argument,  ///< a value of the caller or the user is out of range
  not_found,         ///< no file, joint or effector has this name
  parse,             ///< a file's text does not follow its format
  io,                ///< the operating system refused a read or write
  unsupported,       ///< valid, but not supported by this version
  cancelled,         ///< the caller cancelled the work
};

/// A failure: its kind, a message with the value seen and the values allowed, and its place.
struct Error {
  ErrorCode code = ErrorCode::invalid_argument;  ///< kind of the failure
  Message message;                               ///< text for a person
  std::string place;  ///< location such as "line 12 of walk.bvh"; may be empty

  /// The place and the message in one line: "line 12 of walk.bvh: ...".
  [[nodiscard]] std::string to_string() const {
    return place.empty() ? message.text : place + ": " + message.text;
  }
  /// The place and the message as one translatable Message.
  [[nodiscard]] Message to_message() const;
};

/// A value or an Error. Used for failures of files, users and networks; a broken precondition of
/// the caller throws PreconditionError instead.
template <class T>
using Result = tl::expected<T, Error>;

/// Makes an Error to be returned as a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, Message message,
                                                std::string place = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(place)});
}

/// Evaluates an expression of type Result; if it is an error, returns that from the enclosing
/// function. A value is discarded.
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
/// Evaluates an expression of type Result; if it is an error, returns that from the enclosing
/// function, else assigns its value to the target, a declaration or an lvalue: SHG_TRY_ASSIGN(const
/// Clip clip, read_clip(path));
#define SHG_TRY_ASSIGN(target, ...) SHG_TRY_ASSIGN_AT(__LINE__, target, __VA_ARGS__)

/// The exception for a broken precondition: the caller violated a documented requirement.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The name in `known` most similar to a misspelt `name`, for error messages: one with the same
/// words in any order and case, else one that contains them, else one whose words begin with them
/// or with misspellings of them, else the nearest by edit distance; empty if none shares a third of
/// it.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            std::span<const std::string> known);

/// The message for an unknown name: "unknown effector 'right_hnad'; did you mean 'right_hand'?
/// Known: left_hand, right_hand".
[[nodiscard]] Message unknown_name(std::string_view kind, std::string_view name,
                                   std::span<const std::string> known);

/// A value of an enum and its word in files, options and messages.
template <class Enum>
struct EnumWord {
  Enum value;             ///< value of the enum
  std::string_view word;  ///< its word
};

template <class Enum>
EnumWord(Enum, std::string_view) -> EnumWord<Enum>;  ///< deduction guide, required by clang 14

/// The words of an enum, in the order of messages. Each enum with words specialises this next to
/// its declaration.
template <class Enum>
inline constexpr std::array<EnumWord<Enum>, 0> kEnumWords{};

/// Makes kEnumWords from a table whose rows hold an enum value, a `word` and further facts.
template <class Row, std::size_t size, class Enum>
[[nodiscard]] constexpr std::array<EnumWord<Enum>, size> words_of_table(
    const std::array<Row, size>& table, Enum Row::*value) {
  std::array<EnumWord<Enum>, size> words{};
  for (std::size_t i = 0; i < size; ++i) words[i] = {table[i].*value, table[i].word};
  return words;
}

/// The word of an enum value; empty if it has none.
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

/// The enum value of a word; else ErrorCode::invalid_argument with the nearest and all known words:
/// "unknown search 'cma'; did you mean 'cma_es'? Known: …". `kind` is the noun of the message, here
/// "search".
template <class Enum>
[[nodiscard]] Result<Enum> value_of(std::string_view word, std::string_view kind) {
  for (const EnumWord<Enum>& known : kEnumWords<Enum>) {
    if (known.word == word) return known.value;
  }
  return fail(ErrorCode::invalid_argument, unknown_name(kind, word, all_words<Enum>()));
}

}  // namespace shigusa
