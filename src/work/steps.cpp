// SPDX-License-Identifier: MIT
// The steps of actions.
#include "work/line.hpp"

namespace shigusa {
namespace {

// Pauses of the hands on a thing before it moves and after it stands (s; people rest 0.09 and 0.13,
// within these).
constexpr double kGraspPause = 0.1;
constexpr double kReleasePause = 0.1;

}  // namespace

std::vector<Step> steps_of(const Action& action) {
  std::vector<Step> steps;
  switch (*kind_of(action)) {
    case ActionKind::goals:
      // a place that is passed is one of the next action's way
      if (!action.via) steps = {{StepKind::go}};
      break;
    case ActionKind::wait:
      steps = {{StepKind::pause, *action.wait}};
      break;
    case ActionKind::grasp:
      steps = {{StepKind::clear},
               {StepKind::reach},
               {StepKind::pause, kGraspPause},
               {StepKind::take},
               {StepKind::lift}};
      break;
    case ActionKind::place:
      steps = {{StepKind::carry}, {StepKind::pause, kReleasePause}, {StepKind::let_go}};
      break;
    case ActionKind::release:
      steps = {{StepKind::pause, kReleasePause}, {StepKind::let_go}};
      break;
    case ActionKind::stand:
    case ActionKind::sit:
      steps = {{StepKind::rise}, {StepKind::hang}};
      break;
  }
  if (action.hold > 0.0) steps.push_back({StepKind::pause, action.hold});
  return steps;
}

}  // namespace shigusa
