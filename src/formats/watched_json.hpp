// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/error.hpp>
#include <string>
#include <string_view>

#include "core/c_locale.hpp"
#include "core/say.hpp"
#include "files/json_memory.hpp"

namespace shigusa {

// Parses JSON text while `watch`, nlohmann's callback, sees each event: it may throw a Message,
// which ends the parse and is the error's message. `wrong`: what the text is not ("glTF"), for
// text that is no JSON; errors name the place.
template <class Json, class Watch>
[[nodiscard]] Result<Json> parse_watched(std::string_view text, const Watch& watch,
                                         const std::string& wrong, const std::string& place) {
  // it reads numbers by strtod
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
