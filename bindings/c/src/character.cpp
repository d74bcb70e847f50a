// SPDX-License-Identifier: MIT
#include <shigusa/character.hpp>
#include <shigusa/score_clip.hpp>

#include "door.hpp"

using namespace shigusa;
using namespace shigusa::door;

extern "C" {

shigusa_status shigusa_character_create(const char* spec, const void* file, size_t file_size,
                                        shigusa_character** character) {
  return guarded([&] {
    if (const auto null = need("spec", spec, "character", character)) return null;
    Result<CharacterSpec> parsed = parse_character_spec(spec, "character");
    if (!parsed) return refuse(parsed.error());
    if (is_complete(*parsed)) {
      if (file != nullptr) {
        return refuse(SHIGUSA_INVALID_ARGUMENT,
                      parsed->source + " needs no file, and one is given");
      }
    } else {
      if (file == nullptr) {
        return refuse(SHIGUSA_INVALID_ARGUMENT,
                      "the bytes of the file " + parsed->source + " are not given");
      }
      std::string bytes(static_cast<const char*>(file), file_size);
      const auto loaded = load_character(std::move(bytes), *parsed);
      if (!loaded) return refuse(loaded.error());
    }
    // what cannot be built is better known now
    if (const auto body = build_character(*parsed); !body) return refuse(body.error());
    *character = new shigusa_character{std::move(*parsed)};
    return shigusa_status{SHIGUSA_OK};
  });
}

void shigusa_character_free(shigusa_character* character) { delete character; }

shigusa_status shigusa_character_describe(const shigusa_character* character,
                                          shigusa_bytes** json) {
  return guarded([&] {
    if (const auto null = need("character", character, "json", json)) return null;
    const Result<BodyModel> body = build_character(character->spec);
    if (!body) return refuse(body.error());
    return give(format_character(character->spec, *body), json);
  });
}

}  // extern "C"
