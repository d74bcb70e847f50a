// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace shigusa::testing_support {

using Json = nlohmann::ordered_json;

// A quick task for assistants' tools.
inline const Json kLowTask{
    {"goals", Json::array({{{"effector", "right_hand"}, {"position_m", {-0.2, 0.5, 0.4}}}})},
    {"evaluations", 200},
    {"candidates", 2}};

// Requests of the assistants' protocol.
inline Json request(int id, const std::string& method, const Json& params = Json::object()) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}};
}
inline Json call(int id, const std::string& tool, const Json& arguments) {
  return request(id, "tools/call", {{"name", tool}, {"arguments", arguments}});
}

}  // namespace shigusa::testing_support
