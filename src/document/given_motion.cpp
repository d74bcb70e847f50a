// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <shigusa/score.hpp>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "generate/posture_meter.hpp"

namespace shigusa {
namespace {

constexpr double kAngleMost = 1e6;  // rad, see Posture

Result<void> check_angles(const BodyModel& body, const Clip& clip) {
  const std::size_t asked = index(std::max(clip.frames, 0)) * body.dofs().size();
  if (clip.dofs != body.dof_count() || clip.frames < 2 || clip.angles.size() != asked) {
    return fail(ErrorCode::invalid_argument,
                say("angles_shape", clip.frames, clip.dofs, body.dof_count()));
  }
  if (!(clip.frame_time > 0.0)) {
    return fail(ErrorCode::invalid_argument, say("no_speeds", clip.frame_time));
  }
  const auto is_angle = [](double angle) { return abs(angle) <= kAngleMost; };
  if (std::all_of(clip.angles.begin(), clip.angles.end(), is_angle)) return {};
  return fail(ErrorCode::invalid_argument, say("no_angle", kAngleMost));
}

}  // namespace

Result<GenerateResult> given_motion(const Task& task, Clip clip) {
  SHG_TRY(check_angles(task.body, clip));
  const CriteriaContext context{.start = clip.state(0), .obstacles = task.obstacles};
  SHG_TRY_ASSIGN(ParameterList list, parameter_list(task.body, task.start, task));
  GenerateResult result;
  result.duration = clip.duration();
  Candidate& candidate = result.candidates.emplace_back();
  candidate.parameters = list.start();
  result.parameters = std::make_shared<const ParameterList>(std::move(list));
  candidate.motion = ClipDynamics(task.body).completed(std::move(clip));
  const Motion& motion = candidate.motion;
  candidate.score = score_motion(task.body, motion, task.criteria, context);
  candidate.measures = measure_motion(task.body, motion, context);
  candidate.judgement = judge(task.body, motion, candidate.measures);
  PostureMeter meter(task.body, task.home, 0);
  candidate.final_posture = meter.measure(motion.clip.frame(motion.clip.frames - 1));
  return result;
}

}  // namespace shigusa
