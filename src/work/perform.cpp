// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "generate/candidate.hpp"
#include "work/check_work.hpp"
#include "work/line.hpp"

namespace shigusa {
namespace {

// Least motions of a search after the first one, and those of a lift.
constexpr int kLeastMotions = 192;
constexpr int kLiftMotions = 64;
// Factor on them where none of the motions can be made.
constexpr int kMoreTimes = 4;

// Result of a step of one line.
struct Found {
  std::optional<GenerateResult> result{};
  std::optional<BodyModel> body{};  // that its candidates were made with
  int way = 0;                      // index of the task
  bool idle = false;                // nothing moves
  std::optional<Error> error{};

  [[nodiscard]] bool succeeds() const { return result && result->meets_goals(); }
};

// A search that has found no motion that can be made is repeated with more motions.
Result<GenerateResult> searched(const PreparedTask& prepared, const Progress& progress) {
  Result<GenerateResult> found = generate(prepared, progress);
  const Task& task = prepared.task();
  if (!found || found->status != ReachStatus::unsteady || !task.evaluations) return found;
  Task more = task;
  more.evaluations = kMoreTimes * *task.evaluations;
  SHG_TRY_ASSIGN(GenerateResult other, generate(more, progress));
  const int spent = found->log.evaluations + other.log.evaluations;
  if (other.status == ReachStatus::reached) found = std::move(other);
  found->log.evaluations = spent;
  return found;
}

// The first way of a step that succeeds and is possible, else the best of those that do not.
Found first_of(std::span<const Task> tasks, const Progress& progress) {
  Found best;
  for (std::size_t way = 0; way < tasks.size(); ++way) {
    const Task& task = tasks[way];
    const auto prepared = PreparedTask::of(task);
    if (!prepared) {
      if (!best.result && !best.error) best.error = prepared.error();
      continue;
    }
    auto result = searched(*prepared, progress);
    if (!result) {
      if (!best.result && !best.error) best.error = result.error();
      continue;
    }
    const auto rank = [](const GenerateResult& r) {
      return std::pair(!r.meets_goals(), r.status == ReachStatus::unsteady);
    };
    if (!best.result || rank(*result) < rank(*best.result)) {
      const int spent = best.result ? best.result->log.evaluations : 0;
      best.result = std::move(*result);
      best.result->log.evaluations += spent;
      best.body = prepared->task().body;
      best.way = static_cast<int>(way);
    }
    if (best.result->status == ReachStatus::reached) break;
  }
  return best;
}

// The motion of a step as it was made before.
Found played(std::vector<Task> tasks, const WorkMotion& motion) {
  Found found;
  const auto way = static_cast<std::size_t>(motion.way);
  if (way >= tasks.size()) {
    found.error =
        fail(ErrorCode::invalid_argument, say("no_such_way", motion.way, tasks.size())).value();
    return found;
  }
  Task& task = tasks[way];
  task.duration = motion.duration;
  const auto play = [&]() -> Result<GenerateResult> {
    SHG_TRY_ASSIGN(const PreparedTask prepared, PreparedTask::of(task));
    found.body = prepared.task().body;
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
    return player.play(motion.values);
  };
  Result<GenerateResult> result = play();
  if (result)
    found.result = std::move(*result);
  else
    found.error = result.error();
  found.way = motion.way;
  return found;
}

class Performance {
 public:
  // `known`: motions of actions that are made as before.
  Performance(const Task& task, std::span<const WorkMotion> known, const Progress& progress)
      : task_(task), progress_(progress), known_(known) {
    lines_.emplace_back(task_);
  }

  Result<GenerateResult> run() {
    for (std::size_t a = 0; a < task_.actions.size(); ++a) {
      for (const Step& step : steps_of(task_.actions[a])) {
        SHG_TRY(make(a, step));
        if (failed_) return deliver();
      }
    }
    return deliver();
  }

 private:
  Result<void> make(std::size_t action, const Step& step) {
    if (step.kind == StepKind::pause || step.kind == StepKind::take ||
        step.kind == StepKind::let_go) {
      for (Line& line : lines_) line.make(action, step);
      return {};
    }
    return branched_ ? go_on(action, step) : branch(action, step);
  }

  // Searches the first motion, each of whose candidates is a line.
  Result<void> branch(std::size_t action, const Step& step) {
    const std::vector<Task> tasks = lines_.front().tasks_of(action, step);
    if (tasks.empty()) return {};
    const WorkMotion* known = take_known(action);
    Found found = known != nullptr ? played(tasks, *known) : first_of(tasks, progress_);
    if (!found.result) return error_of(action, found);
    result_.log.spend(found.result->log);
    result_.parameters = found.result->parameters;
    if (!found.succeeds()) return fail_at(action, found);
    branched_ = known == nullptr;
    const Line before = lines_.front();
    lines_.clear();
    for (const Candidate& candidate : found.result->candidates) {
      lines_.emplace_back(before).add(action, *found.body, candidate, found.way);
    }
    single_ = motions_made_++ == 0 ? std::move(found.result) : std::nullopt;
    return {};
  }

  // Searches the next motion of each line.
  Result<void> go_on(std::size_t action, const Step& step) {
    single_.reset();
    ++motions_made_;
    std::vector<Found> found(lines_.size());
    const bool moves = lines_.size() > 1 || !lines_.front().tasks_of(action, step).empty();
    const WorkMotion* known = moves ? take_known(action) : nullptr;
    const int all = task_.evaluations.value_or(usual_evaluations(task_));
    const int each = std::max(all / static_cast<int>(lines_.size()), kLeastMotions);
    parallel_for(static_cast<int>(lines_.size()), task_.batch.threads, [&](int k, int) {
      std::vector<Task> tasks = lines_[index(k)].tasks_of(action, step);
      found[index(k)].idle = tasks.empty();
      if (tasks.empty()) return;
      for (Task& task : tasks) {
        task.candidates = 1;
        task.batch.threads = 1;
        if (task_.candidates > 1) task.evaluations = each;
        if (step.kind == StepKind::lift) task.evaluations = kLiftMotions;
      }
      found[index(k)] = known != nullptr ? played(tasks, *known) : first_of(tasks, {});
    });
    std::vector<Line> kept;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (found[k].result) result_.log.spend(found[k].result->log);
      if (found[k].idle) kept.push_back(std::move(lines_[k]));
      if (!found[k].succeeds()) continue;
      kept.push_back(std::move(lines_[k]));
      kept.back().add(action, *found[k].body, std::move(found[k].result->candidates.front()),
                      found[k].way);
    }
    if (kept.empty()) {
      const auto some = std::find_if(found.begin(), found.end(),
                                     [](const Found& f) { return f.result.has_value(); });
      if (some == found.end()) return error_of(action, found.front());
      return fail_at(action, *some);
    }
    lines_ = std::move(kept);
    return {};
  }

  // The next motion that the action had before, if it had one.
  const WorkMotion* take_known(std::size_t action) {
    while (next_known_ < known_.size() && known_[next_known_].action < action) ++next_known_;
    const bool own = next_known_ < known_.size() && known_[next_known_].action == action;
    return own ? &known_[next_known_++] : nullptr;
  }

  Result<void> error_of(std::size_t action, const Found& found) const {
    const Error& error = *found.error;
    return fail(error.code, say("of_action", action + 1, error.to_message()));
  }

  // Ends the work: what came before is delivered.
  Result<void> fail_at(std::size_t action, const Found& found) {
    failed_ = true;
    result_.status = ReachStatus::unreachable;
    result_.remaining_distance = found.result->remaining_distance;
    result_.remaining_turn = found.result->remaining_turn;
    result_.conflict = say("action_fails", action + 1, word_of(*kind_of(task_.actions[action])),
                           Millimetres{1e3 * found.result->remaining_distance},
                           degrees(found.result->remaining_turn));
    if (lines_.size() == 1 && !branched_) {
      lines_.front().add(action, *found.body, found.result->candidates.front());
    }
    return {};
  }

  Result<GenerateResult> deliver() {
    if (single_ && lines_.size() == single_->candidates.size() && task_.actions.size() == 1) {
      return one_action();
    }
    for (const Line& line : lines_) result_.candidates.push_back(line.joined());
    if (!result_.parameters) SHG_TRY(add_parameters());
    std::stable_sort(result_.candidates.begin(), result_.candidates.end(), ranks_of(task_));
    if (!failed_) result_.status = status_of(true, result_.candidates);
    result_.duration = result_.candidates.front().motion.clip.duration();
    return std::move(result_);
  }

  // Adds the parameters of work in which nothing moves.
  Result<void> add_parameters() {
    SHG_TRY_ASSIGN(ParameterList list, parameter_list(task_.body, task_.start, task_));
    for (Candidate& candidate : result_.candidates) candidate.parameters = list.start();
    result_.parameters = std::make_shared<const ParameterList>(std::move(list));
    return {};
  }

  // The motions of one action are those of the search.
  Result<GenerateResult> one_action() {
    GenerateResult& one = *single_;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      Candidate whole = lines_[k].joined();
      Candidate& own = one.candidates[k];
      own.motions = whole.motions;
      own.actions = std::move(whole.actions);
      if (task_.actions.front().hold > 0.0 || !task_.things.empty()) {
        whole.actions = std::move(own.actions);
        own = std::move(whole);
      }
    }
    one.duration = one.candidates.front().motion.clip.duration();
    return std::move(one);
  }

  const Task& task_;
  const Progress& progress_;
  std::span<const WorkMotion> known_;
  std::size_t next_known_ = 0;
  std::vector<Line> lines_{};
  bool branched_ = false;
  int motions_made_ = 0;
  bool failed_ = false;
  std::optional<GenerateResult> single_{};  // of the only motion so far
  GenerateResult result_{};
};

}  // namespace

Result<GenerateResult> perform(const Task& task, const Progress& progress) {
  SHG_TRY(check_work(task));
  return Performance(task, {}, progress).run();
}

Result<GenerateResult> perform_again(const Task& task, std::span<const WorkMotion> motions,
                                     const Progress& progress) {
  SHG_TRY(check_work(task));
  return Performance(task, motions, progress).run();
}

}  // namespace shigusa
