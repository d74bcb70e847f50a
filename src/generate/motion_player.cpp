// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <shigusa/generate.hpp>
#include <utility>

#include "candidate.hpp"
#include "problem/mirror_request.hpp"
#include "problem_search.hpp"
#include "reflection.hpp"

namespace shigusa {

struct MotionPlayer::Made {
  Task task;
  std::unique_ptr<const Problem> problem;
  std::unique_ptr<Planner> planner;     // planner of `problem`
  std::optional<MotionPlayer> other{};  // player of the mirrored task, made on demand

  Result<Candidate> play(const Parameters& values);

 private:
  Result<std::optional<Candidate>> reflect(const Parameters& values);
};

Result<Candidate> MotionPlayer::Made::play(const Parameters& values) {
  if (values.reflected) {
    SHG_TRY_ASSIGN(std::optional<Candidate> image, reflect(values));
    if (image) return std::move(*image);
  }
  return played(*planner, values);
}

// The mirror image of the motion that the mirrored values make; none if the body has no mirror
// image.
Result<std::optional<Candidate>> MotionPlayer::Made::reflect(const Parameters& values) {
  if (!other) {
    // a body on one foot has no mirrored task: it is its own image
    Result<MotionPlayer> made = MotionPlayer::of(mirrored_task(task));
    if (!made) return std::optional<Candidate>{};
    other = std::move(*made);
  }
  const Made& there = *other->made_;
  Parameters source = mirrored_values(*problem->parameters, *there.problem->parameters, values);
  SHG_TRY_ASSIGN(const GenerateResult played_there, other->play(source));
  const Candidate& of = played_there.candidates.front();
  Arrival arrival = planner->nearest(values);
  std::optional<Motion> image = reflection(*arrival.approach, of.motion);
  if (!image) return std::optional<Candidate>{};
  arrival.rolled.motion = std::move(*image);
  Candidate candidate =
      make_candidate(*problem, *arrival.approach, values, std::move(arrival.rolled));
  candidate.arm_collision = of.arm_collision;
  return candidate;
}

Result<MotionPlayer> MotionPlayer::of(Task task, int approach) {
  SHG_TRY_ASSIGN(auto problem, prepare(task));
  if (approach >= 0) problem->way = approach;
  SHG_TRY_ASSIGN(auto planner, make_planner(*problem));
  auto made = std::make_unique<Made>(
      Made{std::move(task), std::move(problem), std::move(planner), std::nullopt});
  return MotionPlayer(std::move(made));
}

MotionPlayer::MotionPlayer(std::unique_ptr<Made> made) : made_(std::move(made)) {}
MotionPlayer::MotionPlayer(MotionPlayer&&) noexcept = default;
MotionPlayer& MotionPlayer::operator=(MotionPlayer&&) noexcept = default;
MotionPlayer::~MotionPlayer() = default;

const Task& MotionPlayer::task() const { return made_->task; }
const BodyModel& MotionPlayer::body() const { return made_->problem->task.body; }
const ParameterList& MotionPlayer::parameters() const { return *made_->problem->parameters; }

Result<GenerateResult> MotionPlayer::play(const Parameters& values) {
  const Problem& problem = *made_->problem;
  SHG_TRY(problem.parameters->check(values));
  GenerateResult generation;
  generation.parameters = problem.parameters;
  generation.duration = problem.reach.duration;
  SHG_TRY_ASSIGN(Candidate candidate, made_->play(values));
  generation.candidates.push_back(std::move(candidate));
  find_possible_in(problem.task.body, generation);
  tell_status(made_->planner->in_reach(), generation);
  return generation;
}

Result<GenerateResult> regenerate(const Task& task, const Parameters& values) {
  SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
  return player.play(values);
}

}  // namespace shigusa
