// SPDX-License-Identifier: MIT
// A character from its file, a reach, and the motion on the character's own skeleton.
#include <cstdio>
#include <shigusa/shigusa.hpp>

int complain(const shigusa::Error& error) {
  return std::fprintf(stderr, "%s\n", error.to_string().c_str()), 2;
}

int main(int argc, char** argv) {
  const auto hero = shigusa::open_character({.source = argc > 1 ? argv[1] : "human"});
  if (!hero) return complain(hero.error());
  for (const std::string& doubt : hero->doubts) std::printf("note: %s\n", doubt.c_str());
  const double stature = hero->body.stature();
  shigusa::Task task(*hero);
  task.goals = {{"right_hand", {-0.15 * stature, 0.4 * stature, 0.3 * stature}}};
  const auto result = shigusa::generate(task);
  if (!result) return complain(result.error());
  std::printf("score %.4f\n", result->candidates[0].score.total);
  for (const char* file : {"reach.bvh", "reach.glb"}) {
    const auto saved = shigusa::save(file, hero->spec, task, result->candidates[0]);
    // a file of a skeleton alone leaves as BVH alone
    if (!saved) std::printf("%s: %s\n", file, saved.error().to_string().c_str());
  }
  return 0;
}
