// SPDX-License-Identifier: MIT
#include <shigusa/character.hpp>
#include <shigusa/score.hpp>

#include "door.hpp"

using namespace shigusa;
using namespace shigusa::door;

extern "C" {

shigusa_status shigusa_character_create(const char* spec, const void* file, size_t file_size,
                                        shigusa_character** character) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("spec", spec, "character", character));
    SHG_TRY_ASSIGN(CharacterSpec parsed, parse_character_spec(spec, "character"));
    if (is_complete(parsed)) {
      if (file != nullptr) {
        return fail(ErrorCode::invalid_argument,
                    parsed.source + " needs no file, and one is given");
      }
    } else {
      if (file == nullptr) {
        return fail(ErrorCode::invalid_argument,
                    "the bytes of the file " + parsed.source + " are not given");
      }
      std::string bytes(static_cast<const char*>(file), file_size);
      SHG_TRY(load_character(std::move(bytes), parsed));
    }
    // refuses a body that cannot be built
    SHG_TRY(build_character(parsed));
    *character = new shigusa_character{std::move(parsed)};
    return {};
  });
}

shigusa_status shigusa_character_of_nodes(const char* spec, const char* nodes,
                                          shigusa_character** character) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("spec", spec, "nodes", nodes, "character", character));
    SHG_TRY_ASSIGN(CharacterSpec parsed, parse_character_spec(spec, "character"));
    if (!parsed.source.ends_with(".glb")) {
      return fail(ErrorCode::invalid_argument, "is " + parsed.source + "; nodes are of a NAME.glb",
                  "character: source");
    }
    SHG_TRY(load_nodes(nodes, parsed));
    SHG_TRY(build_character(parsed));
    *character = new shigusa_character{std::move(parsed)};
    return {};
  });
}

void shigusa_character_free(shigusa_character* character) { delete character; }

shigusa_status shigusa_character_describe(const shigusa_character* character,
                                          shigusa_bytes** json) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("character", character, "json", json));
    SHG_TRY_ASSIGN(const PosedBody body, build_character(character->spec));
    return give(format_character(character->spec, body), json);
  });
}

}  // extern "C"
