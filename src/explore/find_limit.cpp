// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <shigusa/explore.hpp>
#include <shigusa/kinematics.hpp>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "explored.hpp"

namespace shigusa {
namespace {

constexpr int kScanSteps = 12;       // of the range, with the first seed
constexpr double kPrecision = 0.02;  // of the value, at which the bisection ends
constexpr int kMoves = 12;           // of the limit while both sides are verified
// Share of kSharpMargin at which both sides are verified: few seeds tell where all hold only
// roughly, and other seeds shall hold at the whole of it.
constexpr double kVerified = 0.6;

// Facts of a kind.
struct KindTraits {
  LimitKind kind;
  std::string_view unit;
  double least_margin;  // in the unit
  double direction;     // of the values from the first to the bound
};
constexpr std::array kKinds{
    KindTraits{LimitKind::load, "kg", 0.1, 1.0},
    KindTraits{LimitKind::lowest, "m", 0.01, -1.0},
    KindTraits{LimitKind::highest, "m", 0.01, 1.0},
    KindTraits{LimitKind::farthest, "m", 0.01, 1.0},
};
const KindTraits& traits_of(LimitKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

bool is_hand(const BodyModel& body, const Goal& goal) {
  const auto effector = body.find_effector(goal.effector);
  return effector && index(*effector) < body.effectors().size();
}

// The index of the thing of that name, or of the first one, that an action grasps.
std::optional<std::size_t> thing_of(const Task& task, const std::string& name) {
  for (const Action& action : task.actions) {
    if (action.grasp.empty() || !(name.empty() || action.grasp == name)) continue;
    for (std::size_t k = 0; k < task.things.size(); ++k) {
      if (task.things[k].name == action.grasp) return k;
    }
  }
  return std::nullopt;
}

// The task at other values of the quantity that a limit is of.
class Varied {
 public:
  Varied(const Task& task, LimitKind kind, const std::string& thing) : task_(task), kind_(kind) {
    for (const Goal& goal : task.goals) {
      middle_ += goal.position * (1.0 / static_cast<double>(task.goals.size()));
      if (!is_hand(task.body, goal)) continue;
      ++hands_;
      load_ += goal.load;
    }
    thing_ = thing_of(task, thing);
    const Posture home(task.body, task.home.angles);
    const auto feet = task.body.feet();
    for (const Foot& foot : feet) {
      origin_ += (home.place(foot.link) * foot.centre) * (1.0 / static_cast<double>(feet.size()));
    }
    const Vec3d away{middle_.x - origin_.x, 0.0, middle_.z - origin_.z};
    distance_ = norm(away);
    direction_ = normalized(away, {0, 0, 1});
  }

  // Whether the hands hold what is varied.
  [[nodiscard]] bool holds() const { return hands_ > 0 || thing_; }
  // The value from which the limit is looked for.
  [[nodiscard]] double first() const {
    if (kind_ == LimitKind::load) return 0.0;
    return kind_ == LimitKind::farthest ? distance_ : middle_.y;
  }
  [[nodiscard]] double usual_bound() const {
    const double stature = task_.body.stature();
    const std::array<double, kKinds.size()> bounds{100.0, 0.0, 1.5 * stature, stature};
    return bounds[static_cast<std::size_t>(kind_)];
  }

  [[nodiscard]] Task at(double value, int seed) const {
    Task task = task_;
    task.seed += static_cast<std::uint64_t>(seed);
    task.batch.threads = 1;
    const double more = value - first();
    const Vec3d shift = kind_ == LimitKind::farthest ? direction_ * more : Vec3d{0.0, more, 0.0};
    if (thing_) task.things[*thing_].mass = value;
    for (Goal& goal : task.goals) {
      if (kind_ != LimitKind::load) {
        goal.position += shift;
        if (goal.via) *goal.via += shift;
      } else if (is_hand(task.body, goal)) {
        goal.load = load_ > 0.0 ? goal.load / load_ * value : value / hands_;
      }
    }
    return task;
  }

 private:
  const Task& task_;
  LimitKind kind_;
  int hands_ = 0;
  std::optional<std::size_t> thing_{};
  double load_ = 0.0;      // kg
  Vec3d middle_{};         // of the goals
  Vec3d origin_{};         // middle of the feet
  double distance_ = 0.0;  // of the middle from the origin, horizontally
  Vec3d direction_{};      // of the middle from the origin, horizontally
};

class LimitSearch {
 public:
  LimitSearch(const Task& task, const LimitSettings& settings, const Progress& progress)
      : settings_(settings),
        kind_(traits_of(settings.kind)),
        varied_(task, settings.kind, settings.thing),
        works_(!task.actions.empty()),
        threads_(task.batch.threads),
        progress_(progress) {}

  Result<Limit> run();

 private:
  // The searches of one value: one for each seed tried.
  struct Trial {
    std::vector<bool> holds{};  // (seeds tried)
    std::optional<Reason> reason{};
    bool out_of_reach = false;

    [[nodiscard]] int count() const {
      return static_cast<int>(std::count(holds.begin(), holds.end(), true));
    }
  };

  Result<void> check() const;
  // Tries values with the first `seeds` seeds, without what is known.
  Result<void> attempt(const std::vector<double>& values, int seeds);
  // Number of all seeds that hold at a value.
  Result<int> count(double value);
  // Whether all that was tried from the first value to this one holds.
  [[nodiscard]] bool holds_up_to(double value) const;
  Result<void> scan();
  Result<void> bisect(double fails);
  Result<void> verify();
  void tell_why();

  [[nodiscard]] double margin(double value) const {
    return kVerified * max(kSharpMargin * abs(value), kind_.least_margin);
  }
  // A value so far beyond another, up to the bound.
  [[nodiscard]] double beyond(double value, double by) const {
    const double other = value + kind_.direction * by;
    return kind_.direction > 0.0 ? min(other, bound_) : max(other, bound_);
  }
  [[nodiscard]] double within(double value, double by) const {
    const double other = value - kind_.direction * by;
    return kind_.direction > 0.0 ? max(other, first_) : min(other, first_);
  }

  const LimitSettings& settings_;
  const KindTraits& kind_;
  Varied varied_;
  bool works_;
  int threads_;
  const Progress& progress_;
  double first_ = 0.0;  // innermost value of the search
  double bound_ = 0.0;
  std::map<double, Trial> trials_;
  Limit limit_;
};

Result<void> LimitSearch::check() const {
  const auto wrong = [](const Message& what) { return fail(ErrorCode::invalid_argument, what); };
  if (works_ && settings_.kind != LimitKind::load) return wrong(say("limit_of_work"));
  if (settings_.kind == LimitKind::load && !varied_.holds()) {
    return wrong(works_ ? say("load_no_grasp") : say("load_no_hand"));
  }
  if (settings_.seeds < 1 || settings_.seeds > kLimitSeedsMax) {
    return wrong(say("seeds_range", settings_.seeds, kLimitSeedsMax));
  }
  if (settings_.score && !(*settings_.score > 0.0)) {
    return wrong(say("score_range", *settings_.score));
  }
  const double ahead = kind_.direction * (bound_ - first_);
  const double most = settings_.kind == LimitKind::load ? kLoadMax : kGoalRange;
  if (ahead > 0.0 && abs(bound_) <= most) return {};
  return wrong(say("limit_bound", word_of(settings_.kind), bound_, kind_.unit, first_, most));
}

Result<void> LimitSearch::attempt(const std::vector<double>& values, int seeds) {
  std::vector<Task> tasks;
  std::vector<double> of;
  for (const double value : values) {
    for (auto k = static_cast<int>(trials_[value].holds.size()); k < seeds; ++k) {
      tasks.push_back(varied_.at(value, k));
      of.push_back(value);
    }
  }
  Progress quiet = progress_;
  if (progress_.report) {
    quiet.report = [this](ProgressReport now) {
      now.stage = word_of(settings_.kind);
      progress_.report(now);
    };
  }
  const std::vector<Result<GenerateResult>> made = explore_all(tasks, threads_, quiet);
  if (progress_.cancelled()) return fail(ErrorCode::cancelled, say("stopped_before"));
  for (std::size_t k = 0; k < made.size(); ++k) {
    if (!made[k]) return tl::unexpected(made[k].error());
    const Candidate& best = made[k]->candidates.front();
    Trial& trial = trials_[of[k]];
    const bool scores = !settings_.score || best.score.total <= *settings_.score;
    const bool holds = made[k]->status == ReachStatus::reached &&
                       best.judgement.verdict == Verdict::possible && scores;
    trial.holds.push_back(holds);
    ++limit_.trials;
    if (holds) continue;
    trial.out_of_reach = !made[k]->meets_goals();
    trial.reason.reset();
    if (!best.judgement.reasons.empty()) trial.reason = best.judgement.reasons.front();
  }
  return {};
}

Result<int> LimitSearch::count(double value) {
  SHG_TRY(attempt({value}, settings_.seeds));
  return trials_[value].count();
}

bool LimitSearch::holds_up_to(double value) const {
  return std::all_of(trials_.begin(), trials_.end(), [&](const auto& each) {
    const auto& [at, trial] = each;
    const bool within =
        kind_.direction * (at - first_) >= 0.0 && kind_.direction * (value - at) >= 0.0;
    return !within || trial.count() == static_cast<int>(trial.holds.size());
  });
}

// Finds the first step of the range after which values end to hold.
Result<void> LimitSearch::scan() {
  std::vector<double> values;
  for (int k = 0; k <= kScanSteps; ++k) {
    values.push_back(first_ + (bound_ - first_) * k / kScanSteps);
  }
  SHG_TRY(attempt(values, 1));
  const auto holds = [this](double value) { return trials_[value].holds.front(); };
  const auto from = std::find_if(values.begin(), values.end(), holds);
  limit_.value = first_;
  if (from == values.end()) return {};
  const auto to = std::find_if_not(from, values.end(), holds);
  const auto again = std::find_if(to, values.end(), holds);
  if (again != values.end()) limit_.again = *again;
  first_ = *from;
  limit_.value = *(to - 1);
  limit_.end = LimitEnd::found;
  return to == values.end() ? Result<void>{} : bisect(*to);
}

Result<void> LimitSearch::bisect(double fails) {
  double holds = limit_.value;
  while (abs(fails - holds) > kPrecision * max(abs(holds), kind_.least_margin / kSharpMargin)) {
    const double middle = 0.5 * (holds + fails);
    SHG_TRY_ASSIGN(const int seeds, count(middle));
    (2 * seeds > settings_.seeds ? holds : fails) = middle;
  }
  limit_.value = holds;
  return {};
}

// Moves the limit inwards until all seeds hold within it, else outwards while any holds beyond it;
// once moved inwards it stays there, and is not sharp if a seed holds beyond.
Result<void> LimitSearch::verify() {
  bool inwards = false;
  for (int k = 0; k < kMoves; ++k) {
    const double value = limit_.value;
    const double inner = within(value, margin(value));
    SHG_TRY(count(inner));
    const double outer = beyond(value, margin(value));
    SHG_TRY_ASSIGN(const int outside, count(outer));
    const bool in = holds_up_to(inner);
    if (in && outer == bound_ && outside == settings_.seeds) {
      limit_.end = LimitEnd::beyond;
      limit_.value = bound_;
      limit_.sharp = true;
      return {};
    }
    limit_.sharp = in && outside == 0;
    if (in && (inwards || outside == 0)) return {};
    inwards = !in;
    const double by = 0.5 * margin(value);
    limit_.value = in ? beyond(value, by) : within(value, by);
    if (limit_.value == value) return {};
  }
  return {};
}

// Takes the reason from the nearest trial beyond the limit that fails.
void LimitSearch::tell_why() {
  double nearest = 0.0;
  const Trial* why = nullptr;
  for (const auto& [value, trial] : trials_) {
    const double off = kind_.direction * (value - limit_.value);
    const bool further = limit_.end == LimitEnd::nowhere ? off < 0.0 : off <= 0.0;
    if (further || trial.count() == static_cast<int>(trial.holds.size())) continue;
    if (why != nullptr && off >= nearest) continue;
    nearest = off;
    why = &trial;
  }
  if (why == nullptr) return;
  limit_.out_of_reach = why->out_of_reach;
  limit_.reason = why->reason;
}

Result<Limit> LimitSearch::run() {
  limit_.kind = settings_.kind;
  first_ = varied_.first();
  bound_ = settings_.bound.value_or(varied_.usual_bound());
  SHG_TRY(check());
  SHG_TRY(scan());
  if (limit_.end != LimitEnd::nowhere) SHG_TRY(verify());
  tell_why();
  return limit_;
}

}  // namespace

std::string_view limit_unit(LimitKind kind) { return traits_of(kind).unit; }

Result<Limit> find_limit(const Task& task, const LimitSettings& settings,
                         const Progress& progress) {
  if (task.actions.empty()) {
    if (task.goals.empty()) return fail(ErrorCode::invalid_argument, say("no_goal"));
    SHG_TRY(PreparedTask::of(task));
  }
  return LimitSearch(task, settings, progress).run();
}

}  // namespace shigusa
