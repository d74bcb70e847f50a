// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/files.hpp>
#include <shigusa/scene.hpp>
#include <utility>

#include "core/say.hpp"
#include "files/path.hpp"

namespace shigusa {

Result<std::vector<Message>> add_scene(TaskFile& file, const std::filesystem::path& folder) {
  if (file.scene.empty()) return std::vector<Message>{};
  SceneSettings settings;
  const auto is_in = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  // what the task describes itself takes precedence
  for (const Thing& thing : file.things) settings.left_out.push_back(thing.name);
  for (const Obstacle& obstacle : file.obstacles) settings.left_out.push_back(obstacle.name);
  for (const Action& action : file.actions) {
    for (const std::string& name : {action.grasp, action.place, action.release}) {
      if (name.empty() || is_in(settings.left_out, name) || is_in(settings.things, name)) continue;
      settings.things.push_back(name);
    }
  }
  settings.boxes = kObstaclesMax - std::min(kObstaclesMax, file.obstacles.size());
  SHG_TRY_ASSIGN(Scene scene, read_scene(folder / to_path(file.scene), settings));
  for (std::size_t a = 0; a < file.actions.size(); ++a) {
    const std::string& name = file.actions[a].grasp;
    const bool known = name.empty() || is_in(settings.left_out, name) ||
                       std::any_of(scene.things.begin(), scene.things.end(),
                                   [&name](const Thing& thing) { return thing.name == name; });
    if (known) continue;
    return fail(ErrorCode::not_found, unknown_name("thing", name, scene.names),
                fmt::format("actions[{}]", a));
  }
  std::move(scene.obstacles.begin(), scene.obstacles.end(), std::back_inserter(file.obstacles));
  std::move(scene.things.begin(), scene.things.end(), std::back_inserter(file.things));
  file.scene.clear();
  return std::move(scene.notes);
}

}  // namespace shigusa
