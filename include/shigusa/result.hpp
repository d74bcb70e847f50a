// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/message.hpp>
#include <stdexcept>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace shigusa {

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

}  // namespace shigusa
