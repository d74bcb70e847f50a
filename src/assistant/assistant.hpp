// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "assistant_tools.hpp"

namespace shigusa {

// Largest line (bytes), and number of messages in one.
inline constexpr std::size_t kAssistantLineMost = std::size_t{16} << 20;
inline constexpr std::size_t kAssistantBatchMost = 32;

// The program around a session; functions may be empty.
struct AssistantHost {
  std::string version{};                              // of the program
  std::function<void(std::string_view line)> send{};  // sends a line that is no answer
  std::function<bool()> stops{};  // asked during a search: true ends it with the best so far
};

// A server of the Model Context Protocol: JSON-RPC 2.0, a message or a batch of them a line.
class Assistant {
 public:
  Assistant(AssistantSettings settings, AssistantHost host)
      : tools_(std::move(settings)), host_(std::move(host)) {}

  // The answer to a line, without its end; nothing if none is due.
  [[nodiscard]] std::optional<std::string> answer(std::string_view line);

  // Whether the line cancels the call that answer() is at, which then ends without an answer.
  bool cancel_by(std::string_view line);

 private:
  [[nodiscard]] std::optional<Json> answer_one(const Json& message);
  [[nodiscard]] Result<Json> call_tool(const Json& params);
  [[nodiscard]] Progress progress(const Json& params);

  AssistantTools tools_;
  AssistantHost host_;
  std::atomic<bool> cancel_{false};
  bool cancelled_by_client_ = false;
  Json id_{};  // of the call
};

}  // namespace shigusa
