// SPDX-License-Identifier: MIT
#include "paper/arm_feedback.hpp"

#include <algorithm>
#include <memory>
#include <shigusa/run.hpp>

#include "body/capsules.hpp"
#include "core/index.hpp"
#include "criteria/built_in_criteria.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "kinematics/penetration.hpp"

namespace shigusa {
namespace {

// Plays one arm with one genome after another. One per thread.
class FreeArm {
 public:
  FreeArm(const ArmFeedback& feedback, const CriteriaSettings& criteria)
      : feedback_(&feedback),
        criteria_(&criteria),
        rollout_(*feedback.arm),
        dynamics_(*feedback.arm),
        placed_(*feedback.arm) {}

  double score(const ArmGenes& genes, double weight) {
    Clip clip{.dofs = kArmDofs,
              .frames = static_cast<int>(feedback_->path.size()),
              .frame_time = feedback_->duration / static_cast<double>(feedback_->path.size() - 1),
              .angles = {}};
    const std::vector<double> inverse = inverse_weights(arm_weights(genes));
    const double miss = rollout_.run(feedback_->path, inverse, clip.angles);
    const double worst = worst_score(*criteria_) + weight;
    if (!(miss <= kReachTolerance)) return worst;
    depth_.begin(feedback_);
    for (int f = 0; f < clip.frames; ++f) {
      forward_kinematics<double>(*feedback_->arm, clip.frame(f), placed_);
      depth_.add(placed_);
    }
    const double depth = depth_.deepest();
    const Motion motion = dynamics_.completed(std::move(clip));
    return score_motion(*feedback_->arm, motion, *criteria_).total +
           weight * clamp(depth / kCollisionFull, 0.0, 1.0);
  }

 private:
  const ArmFeedback* feedback_;
  const CriteriaSettings* criteria_;
  ArmRollout<double> rollout_;
  ArmDepth<double> depth_;
  ClipDynamics dynamics_;
  Kinematics<double> placed_;
};

}  // namespace

double collision_depth(const BodyModel& body, const Clip& clip, const Effector& effector) {
  Kinematics<double> placed(body);
  double at_start = 0.0;
  double deepest = -1e9;
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), placed);
    const double depth = limb_penetration(body, placed, effector).depth;
    if (f == 0) at_start = max(depth, 0.0);
    deepest = max(deepest, depth - at_start);
  }
  return deepest;
}

ArmFeedback arm_feedback(const LayeredProblem& problem, std::size_t goal, const HandPath& path,
                         const Clip& clip, const HandTurn<double>& turn) {
  const BodyModel& body = *problem.reach.body;
  const BodyLimb& arm = problem.limbs.arms[index(problem.arms[goal])];
  ArmFeedback feedback{.arm = &problem.arm_bodies[goal],
                       .path = path,
                       .turn = turn,
                       .duration = problem.reach.duration,
                       .obstacles = {},
                       .limb = {}};
  // the arm's links are numbered from its shoulder on; its elbow holds all links beyond its dofs
  const auto dofs = arm_dofs(arm, feedback.arm->body.dof_count() == kTurningArmDofs);
  for (const Capsule& capsule : body.capsules()) {
    if (capsule.link != arm.hinge && !body.moves(arm.hinge, capsule.link)) continue;
    const auto own = std::find(dofs.begin(), dofs.end(), capsule.link);
    if (own != dofs.end()) {
      feedback.limb.push_back(capsule);
      feedback.limb.back().link = static_cast<int>(own - dofs.begin());
      continue;
    }
    const Transformd held = held_place(body, problem.reach.start(), arm.hinge, capsule.link);
    Capsule with_elbow = capsule;
    with_elbow.link = kArmDofs - 1;
    with_elbow.from = held * capsule.from;
    with_elbow.to = held * capsule.to;
    feedback.limb.push_back(std::move(with_elbow));
  }
  Kinematics<double> placed(body);
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), placed);
    const Mat3d& carrier = placed.link_rotation(arm.carrier);
    const Vec3d& shoulder = placed.origin[index(arm.flexion)];
    std::vector<Capsule> obstacles;
    for (Capsule capsule : body.capsules()) {
      if (body.moves(arm.flexion, capsule.link)) continue;
      capsule.from = transpose_times(carrier, placed.point(capsule.link, capsule.from) - shoulder);
      capsule.to = transpose_times(carrier, placed.point(capsule.link, capsule.to) - shoulder);
      obstacles.push_back(capsule);
    }
    feedback.obstacles.push_back(std::move(obstacles));
  }
  return feedback;
}

double unavoidable_depth(const ArmFeedback& feedback) {
  // the hand's point moves with the limb, at a fixed distance from the limb's axis
  const Vec3d& hand = feedback.arm->body.effectors()[0].point;
  double at_start = 0.0;
  double deepest = -1e9;
  for (std::size_t f = 0; f < feedback.path.size(); ++f) {
    double now = -1e9;
    for (const Capsule& part : feedback.limb) {
      const SegmentPair off = nearest_points(hand, hand, part.from, part.to);
      const Capsule sphere{
          .name = {},
          .from = feedback.path[f],
          .to = feedback.path[f],
          .radius = part.radius + off.along_b * taper_of(part) - norm(off.on_a - off.on_b)};
      for (const Capsule& obstacle : feedback.obstacles[f]) {
        now = max(now, capsule_depth(sphere, obstacle));
      }
    }
    if (f == 0) at_start = max(now, 0.0);
    deepest = max(deepest, now - at_start);
  }
  return deepest;
}

std::optional<FoundArm> search_free_arm(const ArmFeedback& feedback,
                                        const CriteriaSettings& criteria, double weight,
                                        LimbSearch search, int threads) {
  std::vector<std::unique_ptr<FreeArm>> arms(index(thread_count(threads)));
  return search_arm(search, worst_score(criteria) + weight,
                    [&](std::span<const ArmGenes> genomes, std::span<double> scores) {
                      parallel_for(static_cast<int>(genomes.size()), threads,
                                   [&](int i, int worker) {
                                     auto& arm = arms[index(worker)];
                                     if (!arm) arm = std::make_unique<FreeArm>(feedback, criteria);
                                     scores[index(i)] = arm->score(genomes[index(i)], weight);
                                   });
                    });
}

}  // namespace shigusa
