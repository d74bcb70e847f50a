// SPDX-License-Identifier: MIT
#include <shigusa/score_clip.hpp>

#include "door.hpp"

using namespace shigusa;
using namespace shigusa::door;

extern "C" shigusa_status shigusa_score_clip(const char* name, const void* file, size_t file_size,
                                             const char* options, shigusa_bytes** json) {
  return guarded([&] {
    if (const auto null = need("name", name, "file", file, "json", json)) return null;
    auto request = parse_clip_request(options == nullptr ? "{}" : options, "options");
    if (!request) return refuse(request.error());
    CharacterSpec character;
    character.source = name;
    character.frame = request->settings.first;
    if (request->character) character = std::move(*request->character);
    if (character.source != name && !is_complete(character)) {
      return refuse(SHIGUSA_INVALID_ARGUMENT,
                    "options: character: must be built in, or be left out for the clip's person");
    }
    const std::string_view bytes(static_cast<const char*>(file), file_size);
    const auto recorded = parse_recorded(bytes, name, std::move(character), request->settings.first,
                                         request->animation);
    if (!recorded) return refuse(recorded.error());
    const auto score = score_clip(*recorded, request->settings);
    if (!score) return refuse(score.error());
    return give(format_clip_score(name, *recorded, request->settings, *score), json);
  });
}
