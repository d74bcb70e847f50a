// SPDX-License-Identifier: MIT
#include "json_text.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "io/watched_json.hpp"

namespace shigusa {
namespace {

// Watches a text being parsed and ends it by throwing what is wrong.
class JsonLimits {
 public:
  void see(int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > kJsonMaxDepth) {
      throw fmt::format("nested deeper than {} levels", kJsonMaxDepth);
    }
    if (++values_ > kJsonMaxValues) throw fmt::format("more than {} values", kJsonMaxValues);
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key) see_key(parsed.get_ref<const std::string&>());
  }

 private:
  void see_key(const std::string& key) {
    if (!keys_.back().insert(key).second) {
      throw fmt::format("the key '{}' stands twice in one object", key.substr(0, 80));
    }
    if (keys_.back().size() > kJsonMaxMembers) {
      throw fmt::format("more than {} members in one object", kJsonMaxMembers);
    }
  }

  std::size_t values_ = 0;
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

}  // namespace

Result<Json> parse_json(std::string_view text, std::string_view name) {
  JsonLimits limits;
  const auto watch = [&limits](int depth, Json::parse_event_t event, const Json& parsed) {
    limits.see(depth, event, parsed);
    return true;
  };
  const std::string place(name);
  if (text.empty()) return fail(ErrorCode::parse, "the file is empty", place);
  return parse_watched<Json>(text, watch, "JSON", place);
}

}  // namespace shigusa
