// SPDX-License-Identifier: MIT
#include "assistant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

namespace shigusa {
namespace {

// Newest first: a client that asks for another version is offered the newest.
constexpr std::array<std::string_view, 4> kVersions{"2025-11-25", "2025-06-18", "2025-03-26",
                                                    "2024-11-05"};
constexpr const char* kCancelled = "notifications/cancelled";
constexpr const char* kInstructions =
    "Finds natural whole-body motions that bring hands, feet or other joints to their goals. "
    "Metres, kilograms, seconds, radians; +Y up, the body faces +Z, its left is +X, the origin is "
    "on the floor between the feet. body tells where effectors start and how far they may go, "
    "reach finds motions, edit changes one of them without a search, limit says how far a task can "
    "go, score judges a recorded motion. Verdicts are possible, strains and impossible; of scores "
    "less is better.";

// Numbers of JSON-RPC.
enum Fault {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kNoMethod = -32601,
  kBadParams = -32602
};

std::string line_of(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json fault(const Json& id, Fault number, const std::string& text) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", int{number}}, {"message", text}}}};
}

const Json& member(const Json& object, const char* key) {
  static const Json none;
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

Result<Json> initialize(const Json& params, const std::string& version) {
  const std::string asked = text_of(member(params, "protocolVersion"));
  const bool known = std::find(kVersions.begin(), kVersions.end(), asked) != kVersions.end();
  return Json{{"protocolVersion", known ? asked : std::string(kVersions.front())},
              {"capabilities", {{"tools", Json::object()}}},
              {"serverInfo", {{"name", "shigusa"}, {"version", version}}},
              {"instructions", kInstructions}};
}

Json text_content(const std::string& text) { return {{"type", "text"}, {"text", text}}; }

}  // namespace

std::optional<std::string> Assistant::answer(std::string_view line) {
  if (line.find_first_not_of(" \t\r") == line.npos) return std::nullopt;
  if (line.size() > kAssistantLineMost) {
    return line_of(
        fault({}, kInvalidRequest,
              fmt::format("the line is too long; allowed are {} bytes", kAssistantLineMost)));
  }
  const Result<Json> message = parse_json(line, "message");
  if (!message) return line_of(fault({}, kParseError, message.error().to_string()));
  if (!message->is_array()) {
    const std::optional<Json> answered = answer_one(*message);
    return answered ? std::optional(line_of(*answered)) : std::nullopt;
  }
  if (message->empty() || message->size() > kAssistantBatchMost) {
    return line_of(fault({}, kInvalidRequest,
                         fmt::format("a batch of {} messages; allowed are 1 to {}", message->size(),
                                     kAssistantBatchMost)));
  }
  Json all = Json::array();
  for (const Json& each : *message) {
    if (std::optional<Json> answered = answer_one(each)) all.push_back(std::move(*answered));
  }
  return all.empty() ? std::nullopt : std::optional(line_of(all));
}

std::optional<Json> Assistant::answer_one(const Json& message) {
  const Json& id = member(message, "id");
  const bool has_id = message.is_object() && message.contains("id");
  const bool valid_id = id.is_string() || id.is_number_integer();
  if (text_of(member(message, "jsonrpc")) != "2.0" || (has_id && !valid_id)) {
    return fault(valid_id ? id : Json(), kInvalidRequest,
                 "a message is an object with \"jsonrpc\": \"2.0\", an \"id\" that is a text or a "
                 "whole number, and a \"method\"");
  }
  if (message.contains("result") || message.contains("error")) return std::nullopt;
  if (!member(message, "method").is_string()) {
    return fault(id, kInvalidRequest, "the \"method\" is missing, or no text");
  }
  if (!has_id) return std::nullopt;  // notifications change nothing between calls
  const std::string method = text_of(member(message, "method"));
  const Json& params = member(message, "params");
  if (!params.is_null() && !params.is_object()) {
    return fault(id, kBadParams, "\"params\" must be an object");
  }
  id_ = id;
  cancel_ = cancelled_by_client_ = false;
  Result<Json> result = Json::object();
  if (method == "initialize") {
    result = initialize(params, host_.version);
  } else if (method == "tools/list") {
    result = Json{{"tools", AssistantTools::list()}};
  } else if (method == "tools/call") {
    result = call_tool(params);
  } else if (method != "ping") {
    static const std::vector<std::string> known{"initialize", "ping", "tools/list", "tools/call"};
    return fault(id, kNoMethod, unknown_name("method", method, known).text);
  }
  id_ = {};
  if (cancelled_by_client_) return std::nullopt;
  if (!result) return fault(id, kBadParams, result.error().to_string());
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(*result)}};
}

Result<Json> Assistant::call_tool(const Json& params) {
  const std::string tool = text_of(member(params, "name"));
  SHG_TRY(AssistantTools::check_name(tool));
  const Json& given = member(params, "arguments");
  if (!given.is_null() && !given.is_object()) {
    return fail(ErrorCode::invalid_argument, "must be an object", "arguments");
  }
  // what a tool refuses is its answer, which the assistant reads and mends
  const auto refused = [](const std::string& text) {
    return Json{{"content", Json::array({text_content(text)})}, {"isError", true}};
  };
  try {
    Result<Told> told =
        tools_.call(tool, given.is_null() ? Json::object() : given, progress(params));
    if (!told) return refused(told.error().to_string());
    Json content = Json::array({text_content(told->text)});
    for (Json& picture : told->pictures) content.push_back(std::move(picture));
    return Json{{"content", std::move(content)}, {"isError", false}};
  } catch (const std::exception& error) {
    return refused(fmt::format("an internal fault of shigusa: {}", error.what()));
  }
}

Progress Assistant::progress(const Json& params) {
  constexpr double kStep = 0.05;  // between notifications, which must grow
  Progress progress;
  progress.cancel = &cancel_;
  const Json token = member(member(params, "_meta"), "progressToken");
  progress.report = [this, token, sent = 0.0](const ProgressReport& now) mutable {
    if (host_.stops && host_.stops()) cancel_ = true;
    if (token.is_null() || !host_.send || now.fraction < sent + kStep) return;
    sent = now.fraction;
    host_.send(line_of({{"jsonrpc", "2.0"},
                        {"method", "notifications/progress"},
                        {"params",
                         {{"progressToken", token},
                          {"progress", now.fraction},
                          {"total", 1},
                          {"message", fmt::format("{} motions", now.evaluations)}}}}));
  };
  return progress;
}

bool Assistant::cancel_by(std::string_view line) {
  if (id_.is_null() || line.find(kCancelled) == line.npos) return false;
  const Result<Json> message = parse_json(line, "message");
  if (!message || text_of(member(*message, "method")) != kCancelled) return false;
  if (member(member(*message, "params"), "requestId") != id_) return false;
  cancel_ = cancelled_by_client_ = true;
  return true;
}

}  // namespace shigusa
