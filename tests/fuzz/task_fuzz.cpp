// SPDX-License-Identifier: MIT
// From the bytes of a task file to a motion in a BVH file: no crash, hang or memory exhaustion, no
// file is opened, every number stays finite, and the task can be written and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <string_view>

#include "kinematics/skeleton_motion.hpp"
#include "problem/make_problem.hpp"
#include "rollout/rollout.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shigusa;
  auto file = parse_task(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.json");
  if (!file) return 0;
  const std::string text = format_task(*file);
  const auto again = parse_task(text, "written.json");
  if (!again || format_task(*again) != text) std::abort();
  if (!is_built_in(file->character) && !file->character.landmarks) return 0;
  const auto task = make_task(*file, {});
  if (!task) return 0;
  const auto problem = make_problem(*task);
  if (!problem) return 0;
  if (!(problem->duration > 0.0)) std::abort();
  // any people in any posture: all angles and torques are numbers
  const Motion motion = roll_out(*problem, uniform_parameters(task->body)).motion;
  if (!is_finite(score_motion(task->body, motion, task->criteria).total)) std::abort();
  if (!parse_bvh(format_bvh(skeleton_motion(task->body, motion.clip)), "written.bvh")) std::abort();
  return 0;
}
