// SPDX-License-Identifier: MIT
#include "json_text.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "core/index.hpp"
#include "core/say.hpp"
#include "watched_json.hpp"

namespace shigusa {
namespace {

// Parser callback that ends the parse by throwing at an error.
class JsonLimits {
 public:
  void see(int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > kJsonMaxDepth) {
      throw say("nested_levels", kJsonMaxDepth);
    }
    if (++values_ > kJsonMaxValues) throw say("values_most", kJsonMaxValues);
    using Event = Json::parse_event_t;
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key) see_key(parsed.get_ref<const std::string&>());
    // `depth` of an event: number of open objects and lists around it
    const auto level = index(depth);
    if (event == Event::array_start || event == Event::object_start) objects_[level + 1] = 0;
    if (event == Event::object_start && ++objects_[level] > kJsonMaxObjects) {
      throw say("objects_most", kJsonMaxObjects);
    }
  }

 private:
  void see_key(const std::string& key) {
    if (!keys_.back().insert(key).second) {
      throw say("key_twice", key.substr(0, 80));
    }
    if (keys_.back().size() > kJsonMaxMembers) {
      throw say("members_most", kJsonMaxMembers);
    }
  }

  std::size_t values_ = 0;
  std::vector<std::set<std::string>> keys_;               // of the objects that are open
  std::array<std::size_t, kJsonMaxDepth + 2> objects_{};  // number of objects, by depth
};

}  // namespace

Result<Json> parse_json(std::string_view text, std::string_view name) {
  JsonLimits limits;
  const auto watch = [&limits](int depth, Json::parse_event_t event, const Json& parsed) {
    limits.see(depth, event, parsed);
    return true;
  };
  const std::string place(name);
  if (text.empty()) return fail(ErrorCode::parse, say("empty_file"), place);
  return parse_watched<Json>(text, watch, "JSON", place);
}

}  // namespace shigusa
