// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <shigusa/character.hpp>
#include <shigusa/export.hpp>
#include <shigusa/random.hpp>
#include <shigusa/task_file.hpp>
#include <string>
#include <vector>

#include "rollout/reach_problem.hpp"
#include "support/exported.hpp"
#include "support/flesh.hpp"

// Random tasks, and what every result must keep: goals, feet, limits, what is free, verdicts.
namespace shigusa::testing_support {

// The requests of random tasks.
enum class TaskKind { place, both_hands, rotation, axis, load, obstacle, foot };
inline constexpr std::array kTaskKinds{TaskKind::place, TaskKind::both_hands, TaskKind::rotation,
                                       TaskKind::axis,  TaskKind::load,       TaskKind::obstacle,
                                       TaskKind::foot};
inline const char* task_kind_name(TaskKind kind) {
  switch (kind) {
    case TaskKind::place:
      return "a place";
    case TaskKind::both_hands:
      return "both hands";
    case TaskKind::rotation:
      return "a rotation";
    case TaskKind::axis:
      return "the way a palm faces";
    case TaskKind::load:
      return "a load of 1 to 40 kg";
    case TaskKind::obstacle:
      return "an obstacle in between";
    case TaskKind::foot:
      return "a foot";
  }
  return "";
}

inline TaskKind task_kind(std::uint64_t index) { return kTaskKinds[index % kTaskKinds.size()]; }

// The task of that index: always the same. Bodies of all statures, goals within and beyond reach.
inline TaskFile random_task(std::uint64_t index) {
  Random random(1912, index);
  const auto within = [&random](double low, double high) { return random.uniform(low, high); };
  TaskFile file;
  const TaskKind kind = task_kind(index);
  const bool whole = kind == TaskKind::rotation || kind == TaskKind::axis;
  file.character.source = whole || within(0, 1) < 0.7 ? "human" : "full_body";
  file.character.stature = within(1.45, 2.0);
  file.character.sex = within(0, 1) < 0.5 ? Sex::female : Sex::male;
  const bool layered = kind == TaskKind::place && within(0, 1) < 0.25;
  file.preset = layered ? Preset::human : Preset::flat;
  file.seed = index;
  const double size = *file.character.stature;
  const auto place = [&] {
    return Vec3d{within(-0.35, 0.3), within(0.03, 1.1), within(-0.2, 0.45)} * size;
  };
  Goal hand{.effector = "right_hand", .position = place()};
  const auto turn = [&] {
    const Quatd q{within(-1, 1), within(-1, 1), within(-1, 1), within(-1, 1)};
    const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    return Quatd{q.x / length, q.y / length, q.z / length, q.w / length};
  };
  switch (kind) {
    case TaskKind::place:
      break;
    case TaskKind::both_hands:
      file.goals.push_back({.effector = "left_hand", .position = place()});
      break;
    case TaskKind::rotation:
      hand.rotation = turn();
      break;
    case TaskKind::axis:
      hand.axis = GoalAxis{{1, 0, 0}, {within(-1, 1), within(-1, 1), within(-1, 1)}};
      break;
    case TaskKind::load:
      hand.load = within(1.0, 40.0);
      break;
    case TaskKind::obstacle:
      file.obstacles.push_back({.name = "box",
                                .position = place() + Vec3d{0, 0, 0.4} * size,
                                .size = Vec3d{0.4, 0.1, 0.2} * size});
      break;
    case TaskKind::foot:
      hand = {.effector = "left_foot",
              .position = Vec3d{within(0.02, 0.25), within(0.05, 0.3), within(-0.1, 0.3)} * size};
      break;
  }
  file.goals.push_back(hand);
  return file;
}

// The findings of many tasks.
struct Audit {
  int tasks = 0;
  int candidates = 0;
  std::map<std::string, int> statuses;  // by word
  std::map<std::string, int> verdicts;  // by word, of candidates
  std::map<std::string, int> best;      // … of the first candidates that meet their goals
  double goal = 0.0;                    // m, the worst miss of a goal that is told as met
  double turn = 0.0;                    // rad, the largest error of a rotation
  double slide = 0.0;                   // m, of planted feet
  double tilt = 0.0;                    // rad, of planted feet
  double limit = 0.0;                   // rad, beyond limits that is not told
  int over_limit = 0;                   // candidates that tell of a limit that they pass
  double head = -1.0;                   // m, the deepest in the head of what is told as free …
  double shank = -1.0;                  // … and in shanks
  int through = 0;                      // told as free, and deeper than kThroughFlesh in either
  std::vector<std::string> failures;    // what was promised and not kept, with the task
};

// rad: of goals' turns, with what a file's digits leave open
inline constexpr double kTurned = kTurnTolerance + 1e-4;
// rad: of feet and limits
inline constexpr double kTilted = 2e-3;
// m: capsules give way by kCollisionDepth, and their shape is not the flesh's
inline constexpr double kThroughFlesh = 0.010;

class Auditor {
 public:
  // Generates, judges by the exported file and by other geometry, and counts.
  void take(TaskFile file, std::optional<int> evaluations) {
    file.evaluations = evaluations;
    place_ = format_task(file);
    ++audit_.tasks;
    const Result<Task> task = make_task(file, {});
    if (!task) return fail(task.error().to_string());
    const Result<GenerateResult> generation = generate(*task);
    if (!generation) return fail(generation.error().to_string());
    ++audit_.statuses[std::string(word_of(generation->status))];
    judge_ranks(*generation);
    for (const Candidate& candidate : generation->candidates) {
      judge_candidate(*task, *generation, candidate);
    }
  }

  [[nodiscard]] const Audit& audit() const { return audit_; }

 private:
  void fail(const std::string& what) { audit_.failures.push_back(what + "\n" + place_); }
  void require(bool kept, const char* what) {
    if (!kept) fail(what);
  }
  void most(double value, double allowed, double& worst, const char* what) {
    worst = std::fmax(worst, value);
    if (!(value <= allowed)) fail(fmt::format("{}: {:g}", what, value));
  }

  void judge_ranks(const GenerateResult& generation) {
    const std::vector<Candidate>& all = generation.candidates;
    require(!all.empty(), "there is no candidate");
    const auto is_impossible = [](const Candidate& candidate) {
      return candidate.judgement.verdict == Verdict::impossible;
    };
    const bool none = std::all_of(all.begin(), all.end(), is_impossible);
    if (generation.meets_goals()) {
      require((generation.status == ReachStatus::unsteady) == none, "the status is not unsteady");
      ++audit_.best[std::string(word_of(all.front().judgement.verdict))];
    }
    for (std::size_t i = 1; i < all.size(); ++i) {
      require(!is_impossible(all[i - 1]) || is_impossible(all[i]), "an impossible one ranks above");
      if (is_impossible(all[i - 1]) != is_impossible(all[i])) continue;
      require(all[i - 1].score.total <= all[i].score.total, "candidates are not in their order");
    }
  }

  void judge_candidate(const Task& task, const GenerateResult& generation,
                       const Candidate& candidate) {
    ++audit_.candidates;
    ++audit_.verdicts[std::string(word_of(candidate.judgement.verdict))];
    const auto bvh = export_candidate(task, candidate, FileFormat::bvh);
    if (!bvh) return fail(bvh.error().to_string());
    const ExportedMotion exported(*bvh, BvhFormat{}.unit);
    require(exported.finite(), "numbers are not finite");
    for (const ContactResult& foot : candidate.contacts) {
      most(exported.slide(foot.node), 1e-3, audit_.slide, "a foot slides (m)");
      if (!foot.heel) most(exported.tilt(foot.node), kTilted, audit_.tilt, "a foot tilts (rad)");
    }
    if (generation.meets_goals()) judge_goals(task, candidate, exported);
    // closed forms of layers may pass limits, where no candidate keeps them; then that is told
    if (!candidate.measures.over_limit.empty()) {
      ++audit_.over_limit;
      require(task.preset == Preset::human, "a limit is passed by steps of IK, which hold limits");
    } else {
      judge_limits(task.body, candidate.motion.clip);
    }
    judge_flesh(task.body, candidate);
    judge_verdict(task.body, candidate);
  }

  void judge_goals(const Task& task, const Candidate& candidate, const ExportedMotion& exported) {
    for (std::size_t g = 0; g < task.goals.size(); ++g) {
      const std::string& node = candidate.goals[g].node;
      most(norm(exported.at_end(node) - task.goals[g].position), 1e-3, audit_.goal,
           "a goal is missed (m)");
      const Mat3d& turned = exported.rotation_at_end(node);
      if (task.goals[g].rotation) {
        const Mat3d asked = to_matrix(*task.goals[g].rotation);
        most(norm(rotation_vector(turned * transpose(asked))), kTurned, audit_.turn,
             "a rotation is missed (rad)");
      }
      if (task.goals[g].axis) {
        const Vec3d axis = turned * normalized(task.goals[g].axis->axis);
        const Vec3d way = normalized(task.goals[g].axis->direction);
        most(std::atan2(norm(cross(axis, way)), dot(axis, way)), kTurned, audit_.turn,
             "an axis is missed (rad)");
      }
    }
  }

  void judge_limits(const BodyModel& body, const Clip& clip) {
    for (int f = 0; f < clip.frames; ++f) {
      for (int d = 0; d < clip.dofs; ++d) {
        const double angle = clip.frame(f)[static_cast<std::size_t>(d)];
        const auto [lower, upper] = widest_limits(body, d);
        most(std::fmax(lower - angle, angle - upper), kTilted, audit_.limit,
             "a limit is passed (rad)");
      }
    }
  }

  void judge_flesh(const BodyModel& body, const Candidate& candidate) {
    if (candidate.measures.collides.depth > kCollisionDepth) return;
    const Flesh::Depths depths = Flesh(body, candidate.motion.clip).deepest();
    audit_.head = std::fmax(audit_.head, depths.head);
    audit_.shank = std::fmax(audit_.shank, depths.shank);
    if (std::fmax(depths.head, depths.shank) > kThroughFlesh) ++audit_.through;
  }

  // By the torques of every frame themselves.
  void judge_verdict(const BodyModel& body, const Candidate& candidate) {
    const Judgement& judgement = candidate.judgement;
    const Motion& motion = candidate.motion;
    double share = 0.0;
    for (std::size_t k = 0; k < motion.torques.size(); ++k) {
      const Dof& dof = body.dofs()[k % body.dofs().size()];
      const double torque = motion.torques[k];
      share = std::fmax(
          share, torque > 0.0 ? torque / dof.torque_positive : -torque / dof.torque_negative);
    }
    const bool impossible = judgement.verdict == Verdict::impossible;
    require(share <= 1.5 || impossible, "1.5 times a joint's strength is not told as impossible");
    require(share <= 1.0 || judgement.verdict != Verdict::possible,
            "more than a joint's strength is told as possible");
    require(judgement.reasons.empty() == (judgement.verdict == Verdict::possible),
            "a verdict without a reason, or a reason without a verdict");
    for (const Reason& reason : judgement.reasons) {
      require(reason.verdict >= judgement.reasons.back().verdict,
              "reasons are not the worst first");
      require(!reason_words(reason).empty(), "a reason without words");
    }
  }

  Audit audit_;
  std::string place_;
};

}  // namespace shigusa::testing_support
