// SPDX-License-Identifier: MIT
#include <shigusa/score.hpp>

#include "door.hpp"

using namespace shigusa;
using namespace shigusa::door;

extern "C" shigusa_status shigusa_score_clip(const char* name, const void* file, size_t file_size,
                                             const char* options, shigusa_bytes** json) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("name", name, "file", file, "json", json));
    SHG_TRY_ASSIGN(auto request,
                   parse_clip_request(options == nullptr ? "{}" : options, "options"));
    CharacterSpec character;
    character.source = name;
    character.frame = request.settings.first;
    if (request.character) character = std::move(*request.character);
    if (character.source != name && !is_complete(character)) {
      return fail(ErrorCode::invalid_argument,
                  "options: character: must be built in, or be left out for the clip's person");
    }
    const std::string_view bytes(static_cast<const char*>(file), file_size);
    SHG_TRY_ASSIGN(const auto recorded, parse_recorded(bytes, name, std::move(character),
                                                       request.settings.first, request.animation));
    SHG_TRY_ASSIGN(const auto score, score_clip(recorded, request.settings));
    return give(format_clip_score(name, recorded, request.settings, score), json);
  });
}
