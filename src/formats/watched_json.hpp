// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

#include "core/c_locale.hpp"
#include "core/say.hpp"
#include "files/json_memory.hpp"

namespace shigusa {

// Parses JSON text with nlohmann's callback `watch`, which sees each event and may throw a Message
// to end the parse with that error. `wrong`: the expected format ("glTF"), for text that is no
// JSON; errors state the place.
template <class Json, class Watch>
[[nodiscard]] Result<Json> parse_watched(std::string_view text, const Watch& watch,
                                         const std::string& wrong, const std::string& place) {
  // it parses numbers with strtod
  const WithinCLocale point;
  try {
    return Json::parse(text, watch);
  } catch (const Message& passed) {
    return fail(ErrorCode::parse, passed, place);
  } catch (const typename Json::exception& error) {
    const std::string_view what = error.what();
    const std::size_t cut = what.find("] ");
    return fail(ErrorCode::parse,
                say("not_json", wrong, cut == std::string_view::npos ? what : what.substr(cut + 2)),
                place);
  }
}

}  // namespace shigusa
