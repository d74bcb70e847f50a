// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/kinematics.hpp>
#include <shigusa/report.hpp>
#include <shigusa/score.hpp>

#include "kinematics/forward_kinematics.hpp"

namespace shigusa {
namespace {

// Changes that are tried, chosen: by how much (m) everything is brought nearer, and higher or
// lower where it lies below the first or above the second height (shares of the stature), and the
// distance (m) of a hand from the middle between both where a second one helps.
constexpr double kNearer = 0.10;
constexpr double kHigher = 0.20;
constexpr double kKnuckles = 0.43;
constexpr double kShoulders = 0.82;
constexpr double kBeside = 0.10;
constexpr std::size_t kMostChanges = 3;  // returned

// Calls visit(place) for each place (m, world) to which hands go.
template <class AnyTask, class Visitor>
void visit_places(AnyTask& task, Visitor&& visit) {
  const auto of_goals = [&](auto& goals) {
    for (auto& goal : goals) {
      visit(goal.position);
      if (goal.via) visit(*goal.via);
    }
  };
  of_goals(task.goals);
  for (auto& thing : task.things) visit(thing.position);
  for (auto& action : task.actions) {
    of_goals(action.goals);
    if (action.position) visit(*action.position);
  }
}

// Moves all places with the obstacles.
Task moved(Task task, const Vec3d& by) {
  visit_places(task, [&by](Vec3d& place) { place += by; });
  for (Obstacle& obstacle : task.obstacles) obstacle.position += by;
  return task;
}

struct Change {
  std::string says;
  Task task;
};

class Changes {
 public:
  Changes(const Task& task, const Candidate& candidate) : task_(task), candidate_(candidate) {
    visit_places(task_, [this](const Vec3d& place) {
      lowest_ = places_ == 0 ? place.y : std::min(lowest_, place.y);
      highest_ = places_ == 0 ? place.y : std::max(highest_, place.y);
      middle_ += place;
      ++places_;
    });
    if (places_ > 0) middle_ = middle_ * (1.0 / places_);
  }

  [[nodiscard]] std::vector<Change> all() const {
    std::vector<Change> changes;
    if (places_ == 0) return changes;
    const Vec3d way{feet().x - middle_.x, 0.0, feet().z - middle_.z};
    if (norm(way) > kNearer) {
      changes.push_back({fmt::format("everything {:.0f} cm nearer", 100.0 * kNearer),
                         moved(task_, normalized(way) * kNearer)});
    }
    const double stature = task_.body.stature();
    if (lowest_ < kKnuckles * stature) {
      changes.push_back({fmt::format("everything {:.0f} cm higher", 100.0 * kHigher),
                         moved(task_, {0.0, kHigher, 0.0})});
    }
    if (highest_ > kShoulders * stature && lowest_ > kHigher) {
      changes.push_back({fmt::format("everything {:.0f} cm lower", 100.0 * kHigher),
                         moved(task_, {0.0, -kHigher, 0.0})});
    }
    if (auto task = lighter()) changes.push_back({"half the load", std::move(*task)});
    if (auto task = with_both_hands()) changes.push_back({"with both hands", std::move(*task)});
    return changes;
  }

 private:
  [[nodiscard]] Vec3d feet() const {
    const Kinematics<double> at = placed(task_.body, task_.start);
    Vec3d sum{};
    for (const Foot& foot : task_.body.feet()) sum += at.point(foot.link, foot.centre);
    return sum * (1.0 / std::max<double>(1.0, static_cast<double>(task_.body.feet().size())));
  }

  [[nodiscard]] std::optional<Task> lighter() const {
    Task task = task_;
    double all = 0.0;
    const auto halve = [&all](double& mass) {
      all += mass;
      mass *= 0.5;
    };
    for (Goal& goal : task.goals) halve(goal.load);
    for (Thing& thing : task.things) halve(thing.mass);
    if (!(all > 0.0)) return std::nullopt;
    return task;
  }

  [[nodiscard]] std::optional<Task> with_both_hands() const {
    const auto hands = task_.body.effectors();
    if (hands.size() != 2) return std::nullopt;
    Task task = task_;
    bool changed = false;
    for (Action& action : task.actions) {
      if (action.grasp.empty() || uses(action.grasp) != 1) continue;
      action.with = {hands[0].name, hands[1].name};
      changed = true;
    }
    if (task.goals.size() == 1 && task.goals[0].load > 0.0) {
      Goal& one = task.goals[0];
      const auto first = std::find_if(hands.begin(), hands.end(), [&one](const Effector& hand) {
        return hand.name == one.effector;
      });
      if (first == hands.end()) return std::nullopt;
      const double aside = first->part.side == Side::left ? kBeside : -kBeside;
      one.load *= 0.5;
      Goal other = one;
      other.effector = hands[first == hands.begin() ? 1 : 0].name;
      one.position.x += aside;
      other.position.x -= aside;
      // a rotation is of one hand alone
      other.rotation.reset();
      other.axis.reset();
      task.goals.push_back(std::move(other));
      changed = true;
    }
    if (!changed) return std::nullopt;
    return task;
  }

  // Number of hands that take a thing.
  [[nodiscard]] std::ptrdiff_t uses(const std::string& thing) const {
    return std::count_if(candidate_.hands.begin(), candidate_.hands.end(),
                         [&thing](const HandUse& use) { return use.thing == thing; });
  }

  const Task& task_;
  const Candidate& candidate_;
  Vec3d middle_{};  // m, of all places
  double lowest_ = 0.0;
  double highest_ = 0.0;
  int places_ = 0;
};

}  // namespace

Result<std::vector<TriedChange>> try_changes(const Task& task, const Candidate& candidate,
                                             const Ergonomics& ergonomics,
                                             const Progress& progress) {
  const auto rank = [](const CostPeaks& peaks) { return std::pair(peaks.worst(), peaks.mean()); };
  SHG_TRY_ASSIGN(const MotionCost present, candidate_cost(task, candidate, ergonomics));
  const auto now = rank(cost_peaks(present));
  std::vector<TriedChange> tried;
  for (Change& change : Changes(task, candidate).all()) {
    const auto found = change.task.actions.empty() ? generate(change.task, progress)
                                                   : perform(change.task, progress);
    if (!found && found.error().code == ErrorCode::cancelled) return tl::unexpected(found.error());
    if (!found || !found->meets_goals()) continue;
    const Candidate& best = found->candidates.front();
    SHG_TRY_ASSIGN(const MotionCost cost, candidate_cost(change.task, best, ergonomics));
    const CostPeaks peaks = cost_peaks(cost);
    if (rank(peaks) < now) tried.push_back({change.says, peaks, best.judgement.verdict});
  }
  std::stable_sort(tried.begin(), tried.end(), [&rank](const TriedChange& a, const TriedChange& b) {
    return rank(a.peaks) < rank(b.peaks);
  });
  if (tried.size() > kMostChanges) tried.resize(kMostChanges);
  return tried;
}

}  // namespace shigusa
