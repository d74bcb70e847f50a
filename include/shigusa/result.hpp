// SPDX-License-Identifier: MIT
#pragma once

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
  std::string message;                           ///< for a person
  std::string place;                             ///< where it is, or empty

  /// One line for a person: "line 12 of walk.bvh: ...".
  [[nodiscard]] std::string to_string() const {
    return place.empty() ? message : place + ": " + message;
  }
};

/// A value, or the reason why there is none. Used for files, users and networks; a caller's broken
/// precondition is SHG_CHECK's.
template <class T>
using Result = tl::expected<T, Error>;

/// Makes an error to be returned as a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message,
                                                std::string place = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(place)});
}

/// Thrown by SHG_CHECK: the caller broke a documented precondition.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace shigusa
