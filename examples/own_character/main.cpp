// SPDX-License-Identifier: MIT
// A character's file in memory becomes a body, and a motion leaves on the character's own skeleton.
#include <cstdio>
#include <shigusa/file.hpp>
#include <shigusa/shigusa.hpp>
#include <utility>

namespace {

int fail(const shigusa::Error& error) {
  std::fprintf(stderr, "%s\n", error.to_string().c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: example_own_character hero.glb\n"), 2;
  auto bytes = shigusa::read_text_file(argv[1], shigusa::kCharacterMaxBytes);
  if (!bytes) return fail(bytes.error());

  // the bytes may come from anywhere; the name tells what kind of file they are
  shigusa::CharacterSpec hero;
  hero.source = std::filesystem::path(argv[1]).filename().string();
  if (const auto loaded = shigusa::load_character(std::move(*bytes), hero); !loaded) {
    return fail(loaded.error());
  }
  for (const std::string& doubt : hero.doubts) std::printf("note: %s\n", doubt.c_str());

  auto body = shigusa::build_character(hero);
  if (!body) return fail(body.error());
  const double stature = body->stature();
  shigusa::Task task(std::move(*body));
  task.goals = {{"right_hand", {-0.15 * stature, 0.4 * stature, 0.3 * stature}}};
  const auto result = shigusa::generate(task);
  if (!result) return fail(result.error());

  for (const auto& [format, name] : {std::pair{shigusa::FileFormat::glb, "reach.glb"},
                                     {shigusa::FileFormat::bvh, "reach.bvh"}}) {
    if (!shigusa::check_formats(hero, {format})) continue;  // a BVH has no mesh
    const auto file = shigusa::export_candidate(hero, task, result->candidates[0], format);
    if (!file) return fail(file.error());
    if (!shigusa::write_file(name, *file)) return 1;
    std::printf("%s: score %.4f\n", name, result->candidates[0].score.total);
  }
  return 0;
}
