// SPDX-License-Identifier: MIT
#include "point_scorer.hpp"

#include <algorithm>
#include <shigusa/run.hpp>
#include <string_view>
#include <utility>

#include "approaches.hpp"
#include "core/index.hpp"
#include "criteria/user_criteria.hpp"

namespace shigusa {
namespace {

// Tolerance (rad) within which a motion meets a fixed squat, the smaller error (rad) that the
// search aims for, and the cost per radian beyond the aim, which outweighs any criterion.
constexpr double kSquatSlack = radians(8.0);
constexpr double kSquatAim = radians(4.0);
constexpr double kSquatPull = 1.0;

}  // namespace

std::optional<SquatTarget> SquatTarget::of(const Problem& problem) {
  const std::optional<double> squat = fixed_value(problem, "squat_rad");
  if (!squat) return std::nullopt;
  const BodyModel& body = problem.task.body;
  SquatTarget target;
  for (const Side side : {Side::left, Side::right}) {
    const auto knee = body.find_dof(JointKind::knee, FreedomKind::flexion, side);
    if (!knee) continue;
    target.knees_.push_back(static_cast<std::size_t>(*knee));
    const std::size_t k = target.knees_.back();
    target.wanted_ += *squat + problem.task.start.angles[k];
    if (!problem.reach.rise.empty()) target.wanted_ += problem.reach.rise[k];
  }
  if (target.knees_.empty()) return std::nullopt;
  return target;
}

double SquatTarget::off(std::span<const float> angles) const {
  double sum = -wanted_;
  for (const std::size_t knee : knees_) sum += static_cast<double>(angles[knee]);
  return abs(sum) / static_cast<double>(knees_.size());
}

bool scores_whole_motions(const Task& task, const CriteriaSettings& criteria) {
  return !criteria.user.empty() || task.generator != MotionGenerator::weighted_ik;
}

PointScorer::PointScorer(const Problem& problem, const ReachProblem& approach,
                         const CriteriaSettings& criteria, const ParameterSpace& space, int threads)
    : task_(problem.task),
      approach_(approach),
      criteria_(criteria),
      space_(space),
      threads_(threads),
      batch_(approach, criteria, {.simd = task_.batch.simd, .threads = threads}),
      archive_(task_, approach.goals.front().effector),
      squat_(SquatTarget::of(problem)) {}

void PointScorer::score(std::span<const double> points, std::span<double> scores) {
  const std::size_t dofs = task_.body.dofs().size();
  const bool kept = task_.preset != Preset::paper;
  angles_.resize(kept ? scores.size() * dofs : 0);
  if (scores_whole_motions(task_, criteria_)) {
    score_motions_of(points, scores);
  } else {
    batch_.score(space_.rows(points), scores, angles_);
  }
  if (!kept) return;
  kept_scores_.assign(scores.begin(), scores.end());
  for (std::size_t i = 0; squat_ && i < scores.size(); ++i) {
    const double off = squat_->off({angles_.data() + i * dofs, dofs});
    if (off > kSquatSlack) kept_scores_[i] = worst_score(criteria_);
    scores[i] += kSquatPull * max(0.0, off - kSquatAim);
  }
  archive_.add(points, kept_scores_, angles_, worst_score(criteria_));
}

void PointScorer::score_motions_of(std::span<const double> points, std::span<double> scores) {
  const auto genes = static_cast<std::size_t>(space_.genes());
  const std::size_t dofs = angles_.empty() ? 0 : task_.body.dofs().size();
  std::vector<std::optional<Motion>> motions(scores.size());
  parallel_for(static_cast<int>(scores.size()), threads_, [&](int i, int) {
    const std::size_t k = index(i);
    RolledOut rolled =
        play(approach_, space_.decode(points.subspan(k * genes, genes)), task_.generator);
    copy_end(rolled.motion.clip, std::span(angles_).subspan(k * dofs, dofs));
    if (rolled.outcome.met(approach_.tolerance)) motions[k] = std::move(rolled.motion);
  });
  score_motions(task_.body, motions, criteria_, approach_.context, threads_, scores);
}

}  // namespace shigusa
