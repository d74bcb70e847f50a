// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/edit.hpp>
#include <utility>

#include "core/say.hpp"
#include "formats/json_reader.hpp"
#include "plan/assignment.hpp"

namespace shigusa {
namespace {

int count_of(const StoredResult& stored) { return static_cast<int>(stored.candidates.size()); }

// The candidates 1 to `count`, each made by `replayed`.
template <class Replayed>
Result<GenerateResult> each_of(int count, const Progress& progress, Replayed&& replayed) {
  Result<GenerateResult> all = replayed(1);
  for (int k = 2; all && k <= count; ++k) {
    if (progress.report) {
      progress.report({"replay", static_cast<double>(k - 1) / count, k - 1,
                       all->candidates.front().score.total});
    }
    if (progress.cancelled()) {
      return fail(ErrorCode::cancelled, say("stopped_after", k - 1, count));
    }
    Result<GenerateResult> next = replayed(k);
    if (!next) return next;
    all->candidates.push_back(std::move(next->candidates.front()));
    // a goal missed by one candidate is missed; a motion possible for one is possible
    const bool meets = all->meets_goals() && next->meets_goals();
    const ReachStatus either = std::min(all->status, next->status);
    all->status = meets ? either : ReachStatus::unreachable;
  }
  return all;
}

// Whether a motion is of the action, from 1.
auto is_of(int action) {
  return [action](const WorkMotion& motion) {
    return motion.action + 1 == static_cast<std::size_t>(action);
  };
}

// A list of actions, from 1.
void read_actions(JsonReader& reader, const char* key, std::vector<int>& into) {
  if (!reader.has(key)) return;
  const Json& list = reader.value(key);
  const auto is_action = [](const Json& item) {
    return item.is_number_unsigned() && item >= 1 && item <= kActionsMax;
  };
  if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_action)) {
    return reader.wrong(key, say("action_list", kActionsMax));
  }
  into = list.get<std::vector<int>>();
}

// The actions of a task with `actions` that an edit searches anew.
std::vector<int> searched_anew(const WorkEdit& edit, int actions) {
  if (!edit.again.empty() || edit.keep.empty()) return edit.again;
  std::vector<int> again;
  for (int action = 1; action <= actions; ++action) {
    const auto& keep = edit.keep;
    if (std::find(keep.begin(), keep.end(), action) == keep.end()) again.push_back(action);
  }
  return again;
}

}  // namespace

Result<std::vector<std::string>> parse_assignments(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  const auto is_text = [](const Json& item) { return item.is_string(); };
  if (!json.is_array() || !std::all_of(json.begin(), json.end(), is_text)) {
    return fail(ErrorCode::parse, say("assignments_list"), std::string(name));
  }
  return json.get<std::vector<std::string>>();
}

Result<GenerateResult> replay(MotionPlayer& player, StoredResult& stored, int candidate,
                              std::span<const std::string> assignments) {
  if (candidate < 1 || candidate > count_of(stored)) {
    return fail(ErrorCode::invalid_argument, say("no_candidate", candidate, count_of(stored)));
  }
  Parameters& parameters = stored.candidates[static_cast<std::size_t>(candidate - 1)];
  for (const std::string& assignment : assignments) {
    if (const auto ok = assign_parameter(player.parameters(), assignment, parameters); !ok) {
      return fail(ok.error().code, ok.error().message, assignment);
    }
  }
  return player.play(parameters);
}

Result<WorkEdit> parse_work_edit(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  JsonReader reader(json, std::string(name) + ": ");
  WorkEdit edit;
  reader.integer("action", edit.action, 1, kActionsMax);
  reader.texts("set", edit.assignments);
  read_actions(reader, "again", edit.again);
  read_actions(reader, "keep", edit.keep);
  if (reader.has("seed")) reader.integer("seed", edit.seed.emplace(), 0, UINT64_MAX);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return edit;
}

Result<GenerateResult> replay_work(const Task& task, StoredResult& stored, int candidate,
                                   const WorkEdit& edit, const Progress& progress) {
  if (candidate < 1 || candidate > count_of(stored)) {
    return fail(ErrorCode::invalid_argument, say("no_candidate", candidate, count_of(stored)));
  }
  const int actions = static_cast<int>(task.actions.size());
  const auto check = [actions](int action) -> Result<void> {
    if (action >= 1 && action <= actions) return {};
    return fail(ErrorCode::invalid_argument, say("no_action", action, actions));
  };
  SHG_TRY(check(edit.action));
  for (const int action : edit.again) SHG_TRY(check(action));
  for (const int action : edit.keep) SHG_TRY(check(action));
  std::vector<WorkMotion>& motions = stored.motions[static_cast<std::size_t>(candidate - 1)];
  for (const int action : searched_anew(edit, actions)) std::erase_if(motions, is_of(action));
  if (!edit.assignments.empty()) {
    const auto own = std::find_if(motions.begin(), motions.end(), is_of(edit.action));
    if (own == motions.end()) {
      return fail(ErrorCode::invalid_argument, say("action_at_rest", edit.action));
    }
    SHG_TRY_ASSIGN(const ParameterList list, parameter_list(task.body, task.start, task));
    for (const std::string& assignment : edit.assignments) {
      if (const auto ok = assign_parameter(list, assignment, own->values); !ok) {
        return fail(ok.error().code, ok.error().message, assignment);
      }
    }
  }
  if (!edit.seed) return perform_again(task, motions, progress);
  Task seeded = task;
  seeded.seed = stored.task.seed = *edit.seed;
  return perform_again(seeded, motions, progress);
}

std::vector<EditableParameter> action_parameters(const ParameterList& list,
                                                 const Candidate& candidate, int action) {
  const auto& motions = candidate.motions;
  const auto own = std::find_if(motions.begin(), motions.end(), is_of(action));
  if (own == motions.end()) return {};
  return editable_parameters(list, own->values);
}

Result<GenerateResult> replay_all(MotionPlayer& player, StoredResult& stored,
                                  const Progress& progress) {
  return each_of(count_of(stored), progress, [&](int k) { return replay(player, stored, k); });
}

Result<GenerateResult> replay_all(const Task& task, StoredResult& stored,
                                  const Progress& progress) {
  if (task.actions.empty()) {
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
    return replay_all(player, stored, progress);
  }
  return each_of(count_of(stored), progress, [&](int k) -> Result<GenerateResult> {
    SHG_TRY_ASSIGN(GenerateResult one, replay_work(task, stored, k));
    // an action that the result has no motion of was searched
    one.candidates.erase(one.candidates.begin() + 1, one.candidates.end());
    return one;
  });
}

Result<void> mirror_result(StoredResult& stored) {
  SHG_TRY_ASSIGN(const PosedBody body, build_body(stored.task));
  SHG_TRY_ASSIGN(TaskFile image, mirrored(stored.task));
  SHG_TRY_ASSIGN(const Task task, make_task(image, {}));
  SHG_TRY_ASSIGN(const ParameterList own, parameter_list(body, body.home, stored.task));
  SHG_TRY_ASSIGN(const ParameterList other, parameter_list(task.body, task.start, task));
  stored.task = std::move(image);
  const auto reflect = [&](Parameters& values) {
    const bool reflected = !values.reflected;
    values = mirrored(own, other, values);
    values.reflected = reflected;
  };
  for (Parameters& values : stored.candidates) reflect(values);
  for (std::vector<WorkMotion>& motions : stored.motions) {
    for (WorkMotion& motion : motions) reflect(motion.values);
  }
  return {};
}

StoredResult stored_result(const TaskFile& file, const GenerateResult& generation) {
  StoredResult stored{.task = played_task(file, generation), .candidates = {}};
  for (const Candidate& candidate : generation.candidates) {
    stored.candidates.push_back(candidate.parameters);
    if (!stored.task.actions.empty()) stored.motions.push_back(candidate.motions);
  }
  return stored;
}

}  // namespace shigusa
