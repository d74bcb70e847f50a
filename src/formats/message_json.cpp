// SPDX-License-Identifier: MIT
#include "formats/message_json.hpp"

namespace shigusa {

Json message_to_json(const Message& message) {
  if (message.key.empty() && !message.number) return message.text;
  Json json{{"text", message.text}};
  if (message.number) {
    json["number"] = *message.number;
    if (!message.unit.empty()) json["unit"] = message.unit;
    return json;
  }
  json["key"] = message.key;
  json["values"] = messages_to_json(message.values);
  return json;
}

Json messages_to_json(std::span<const Message> messages) {
  Json list = Json::array();
  for (const Message& message : messages) list.push_back(message_to_json(message));
  return list;
}

Json texts_to_json(std::span<const Message> messages) {
  Json list = Json::array();
  for (const Message& message : messages) list.push_back(message.text);
  return list;
}

}  // namespace shigusa
