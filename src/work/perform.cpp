// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <memory>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "generate/candidate.hpp"
#include "generate/joint_progress.hpp"
#include "generate/pareto.hpp"
#include "generate/posture_meter.hpp"
#include "problem/task_search.hpp"
#include "work/check_work.hpp"
#include "work/line.hpp"

namespace shigusa {
namespace {

// Motions of a candidate's later steps as shares of a search's, and their least number. Work with
// things needs more: they leave fewer postures. Chosen by 24 pieces of four reaches and 120 with
// things: twice as many lower scores by some 7 %, and half as many lose candidates.
constexpr double kLaterShare = 0.093;
constexpr double kThingShare = 0.185;
constexpr double kLiftShare = 0.11;
constexpr int kLeastMotions = 80;
// Lines that go on although some of them cannot be made.
constexpr std::ptrdiff_t kLeastLines = 3;
// Factor on them where none of the motions can be made.
constexpr int kMoreTimes = 4;

// Result of a step of one line.
struct Found {
  std::optional<GenerateResult> result{};
  std::optional<BodyModel> body{};  // that its candidates were made with
  std::vector<Found> others{};      // by further tasks
  int way = 0;                      // index of the task
  bool idle = false;                // nothing moves
  std::optional<Error> error{};

  [[nodiscard]] bool succeeds() const { return result && result->meets_goals(); }
  // Whether the motion can be made as well.
  [[nodiscard]] bool is_steady() const { return result && result->status == ReachStatus::reached; }
};

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
    auto result = generate(*prepared, progress);
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

// Adds what the tasks after the one of `found` lead to, where it looks different, until there are
// `most` candidates.
void add_other_ways(std::span<const Task> tasks, int most, const Progress& progress, Found& found) {
  if (!found.is_steady()) return;
  const Task& first = tasks.front();
  PostureMeter meter(*found.body, first.start,
                     first.body.find_effector(first.goals[0].effector).value());
  std::vector<Look> looks;
  for (const Candidate& made : found.result->candidates) {
    looks.push_back(meter.look(made.motion.clip));
  }
  for (auto way = index(found.way) + 1; way < tasks.size(); ++way) {
    if (static_cast<int>(looks.size()) >= most) return;
    Found other = first_of(tasks.subspan(way, 1), progress);
    if (!other.result) continue;
    found.result->log.evaluations += other.result->log.evaluations;
    if (!other.is_steady()) continue;
    const Look look = meter.look(other.result->candidates.front().motion.clip);
    if (std::any_of(looks.begin(), looks.end(),
                    [&look](const Look& known) { return look_alike(known, look); })) {
      continue;
    }
    looks.push_back(look);
    other.way = static_cast<int>(way);
    found.others.push_back(std::move(other));
  }
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
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(std::move(task), motion.approach));
    found.body = player.body();
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
      : task_(task), joint_(progress), known_(known) {
    lines_.emplace_back(task_);
    for (const Action& action : task.actions) {
      for (const Step& step : steps_of(action)) motions_left_ += moves(step);
    }
    share_ = 1.0 / std::max(motions_left_, 1);
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
  static bool moves(const Step& step) {
    return step.kind != StepKind::pause && step.kind != StepKind::take &&
           step.kind != StepKind::let_go;
  }

  double share_of(StepKind kind) const {
    if (task_.things.empty()) return kLaterShare;
    return kind == StepKind::lift ? kLiftShare : kThingShare;
  }

  Result<void> make(std::size_t action, const Step& step) {
    if (moves(step)) {
      const Result<void> moved = move(action, step);
      --motions_left_;
      return moved;
    }
    for (Line& line : lines_) line.make(action, step);
    return {};
  }

  // Searches the next motion of each line.
  Result<void> move(std::size_t action, const Step& step) {
    if (std::all_of(lines_.begin(), lines_.end(),
                    [&](const Line& line) { return line.tasks_of(action, step).empty(); })) {
      if (step.kind != StepKind::reach) return {};
      return fail(ErrorCode::invalid_argument,
                  say("of_action", action + 1, say("no_hold", task_.actions[action].grasp)));
    }
    const WorkMotion* known = take_known(action);
    single_.reset();
    const bool first = motions_made_++ == 0;
    std::vector<Found> found =
        known != nullptr ? again(action, step, *known) : searched(action, step, first, 1);
    for (const Found& one : found) spend(one);
    const auto steady = [](const Found& one) { return one.idle || one.is_steady(); };
    if (known == nullptr && !first && std::none_of(found.begin(), found.end(), steady)) {
      found = searched(action, step, false, kMoreTimes);
      for (const Found& one : found) spend(one);
    }
    // who can go on leaves behind who cannot, but for a few to choose from
    auto spare = kLeastLines - std::count_if(found.begin(), found.end(), steady);
    std::vector<Line> kept;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (found[k].idle) kept.push_back(lines_[k]);
      if (found[k].idle || !found[k].succeeds()) continue;
      if (!found[k].is_steady() && spare-- <= 0) continue;
      const auto keep = [&](const Found& one) {
        for (const Candidate& candidate : one.result->candidates) {
          kept.emplace_back(lines_[k]).add(action, *one.body, candidate, one.way);
        }
      };
      keep(found[k]);
      for (const Found& other : found[k].others) keep(other);
    }
    if (kept.empty()) {
      const auto told = std::find_if(found.begin(), found.end(),
                                     [](const Found& f) { return f.result.has_value(); });
      if (told == found.end()) return error_of(action, found.front());
      return fail_at(action, *told);
    }
    if (first) single_ = std::move(found.front().result);
    lines_ = std::move(kept);
    return {};
  }

  // The motion that was made before; there is one line.
  std::vector<Found> again(std::size_t action, const Step& step, const WorkMotion& known) const {
    std::vector<Found> found;
    for (const Line& line : lines_) {
      found.push_back(played(line.tasks_of(action, step), known));
    }
    return found;
  }

  // One motion of each line, and of the best one as many as there are too few lines.
  std::vector<Found> searched(std::size_t action, const Step& step, bool first, int times) {
    std::vector<Found> found(lines_.size());
    const int all = task_.evaluations.value_or(usual_evaluations(task_));
    const int each = std::max(static_cast<int>(share_of(step.kind) * all), kLeastMotions);
    const int missing = std::max(task_.candidates - static_cast<int>(lines_.size()), 0);
    std::vector<Progress> progress;
    for (std::size_t k = 0; k < lines_.size(); ++k) progress.push_back(part_of_line());
    const int threads = threads_for({&task_, 1}, task_.batch.threads);
    parallel_for(static_cast<int>(lines_.size()), threads, [&](int k, int) {
      std::vector<Task> tasks = lines_[index(k)].tasks_of(action, step);
      found[index(k)].idle = tasks.empty();
      if (tasks.empty()) return;
      for (Task& task : tasks) {
        task.candidates = k == 0 ? 1 + missing : 1;
        if (lines_.size() > 1 && threads != 1) task.batch.threads = 1;
        // the first motion spreads the front, the others are the best by the mixture
        task.pareto = task.pareto && first;
        if (!first) task.evaluations = times * task.candidates * each;
      }
      found[index(k)] = first_of(tasks, progress[index(k)]);
      if (k > 0 || missing == 0 || step.kind != StepKind::reach || task_.pareto) return;
      for (Task& task : tasks) {
        task.candidates = 1;
        task.evaluations = each;
      }
      add_other_ways(tasks, 1 + missing, progress[0], found[0]);
    });
    return found;
  }

  // Progress of one line's motion, with an equal share of the time that is left.
  Progress part_of_line() {
    Progress own = joint_.part(share_ / static_cast<double>(lines_.size()));
    if (!own.deadline) return own;
    const auto now = std::chrono::steady_clock::now();
    own.deadline = now + (*own.deadline - now) / std::max(motions_left_, 1);
    return own;
  }

  void spend(const Found& found) {
    if (!found.result) return;
    result_.log.spend(found.result->log);
    result_.parameters = found.result->parameters;
    if (found.result->end == SearchEnd::cancelled) result_.end = SearchEnd::cancelled;
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
    const Action& asked = task_.actions[action];
    const std::string_view kind = word_of(*kind_of(asked));
    const Millimetres remains{1e3 * result_.remaining_distance};
    const double turn = degrees(result_.remaining_turn);
    const bool upright =
        !asked.place.empty() && task_.things[thing_named(task_, asked.place)].upright;
    result_.conflict = upright ? say("upright_fails", action + 1, kind, remains, turn, asked.place)
                               : say("action_fails", action + 1, kind, remains, turn);
    if (lines_.size() == 1) {
      lines_.front().add(action, *found.body, found.result->candidates.front());
    }
    return {};
  }

  Result<GenerateResult> deliver() {
    if (single_ && lines_.size() == single_->candidates.size() && task_.actions.size() == 1) {
      return one_action();
    }
    for (const Line& line : lines_) result_.candidates.push_back(line.joined());
    if (task_.pareto) {
      result_.candidates =
          spread_over(not_dominated(std::move(result_.candidates)), task_.candidates);
    }
    const auto found = static_cast<int>(result_.candidates.size());
    if (!failed_ && known_.empty() && found < task_.candidates) {
      result_.fewer = say("fewer_work", found, task_.candidates);
    }
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
      own.hands = whole.hands;
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
  JointProgress joint_;
  int motions_left_ = 0;
  double share_ = 1.0;  // of a motion in the whole
  std::span<const WorkMotion> known_;
  std::size_t next_known_ = 0;
  std::vector<Line> lines_{};
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
