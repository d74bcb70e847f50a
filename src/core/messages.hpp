// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

#include "core/messages/characters.hpp"
#include "core/messages/cost.hpp"
#include "core/messages/files.hpp"
#include "core/messages/people.hpp"
#include "core/messages/results.hpp"
#include "core/messages/robots.hpp"
#include "core/messages/tasks.hpp"
#include "core/messages/words.hpp"

namespace shigusa::messages {

// The catalogue: all sentences of doubts and failures (core/say.hpp).
inline constexpr std::array<std::span<const MessageText>, 8> kAll{
    kWords, kPeople, kRobots, kFiles, kCharacters, kTasks, kResults, kCost};

// The sentence of a key. Evaluated at compile time, which fails for an unknown key.
[[nodiscard]] consteval MessageText sentence(std::string_view key) {
  for (const std::span<const MessageText>& table : kAll) {
    for (const MessageText& message : table) {
      if (message.key == key) return message;
    }
  }
  throw std::invalid_argument("the catalogue of messages has no such key");
}

}  // namespace shigusa::messages
