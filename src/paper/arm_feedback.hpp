// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/criteria.hpp>

#include "kinematics/penetration.hpp"
#include "paper/arm_search.hpp"
#include "paper/layered_problem.hpp"

namespace shigusa {

// Rule R11: an arm that passes through the trunk is returned to the lower layer (paper, section
// 3.4), if its forearm is deeper than kCollisionDepth in the rest of the body, and deeper than at
// the start. The lower layer searches the arm again with a penalty P = min(1, depth /
// kCollisionFull) of this weight.
inline constexpr double kCollisionWeight = 0.5;
// Factor on the weight in each further round, of kCollisionRounds.
inline constexpr double kCollisionGrowth = 4.0;

// Largest depth (m) of a goal's forearm and hand inside the rest of the body over all frames, less
// their depth at the start, if any; negative: distance.
[[nodiscard]] double collision_depth(const BodyModel& body, const Clip& clip,
                                     const Effector& effector);

// One motion of the upper layer, as input to the lower layer's search of one arm.
struct ArmFeedback {
  const PosedBody* arm = nullptr;  // an arm_body
  HandPath path;
  HandTurn<double> turn{};  // of the hand at the end
  double duration = 1.0;    // s
  // the capsules of the rest of the body, frame by frame, in the frame of `path`; (frames)
  std::vector<std::vector<Capsule>> obstacles;
  std::vector<Capsule> limb;  // of the arm from the elbow on, with its own links
};

// Feedback on one goal's arm in a motion. `clip` is the whole body's motion, with any motion of the
// arm; `turn` is for a hand with an orientation.
[[nodiscard]] ArmFeedback arm_feedback(const LayeredProblem& problem, std::size_t goal,
                                       const HandPath& path, const Clip& clip,
                                       const HandTurn<double>& turn = {});

// Depth of the arm from the elbow on in a feedback's obstacles (m, at least 0, less its depth at
// the start), frame by frame; 0 without obstacles. Feedback and kinematics are of the same arm.
template <class S>
class ArmDepth {
 public:
  // Clears the frames seen; the feedback outlives the following ones.
  void begin(const ArmFeedback* feedback) {
    feedback_ = feedback;
    frame_ = 0;
    at_start_ = deepest_ = S(0);
  }

  void add(const Kinematics<S>& placed) {
    if (feedback_ == nullptr || feedback_->obstacles.empty()) return;
    S now(0);
    for (const Capsule& part : feedback_->limb) {
      const PlacedCapsule<S> limb = placed_capsule(part, placed);
      for (const Capsule& obstacle : feedback_->obstacles[frame_]) {
        const PlacedCapsule<S> other{to_scalar<S>(obstacle.from), to_scalar<S>(obstacle.to), {}};
        now = max(now, depth_of(limb, part, other, obstacle));
      }
    }
    if (frame_++ == 0) at_start_ = now;
    deepest_ = max(deepest_, now - at_start_);
  }

  [[nodiscard]] const S& deepest() const { return deepest_; }

 private:
  const ArmFeedback* feedback_ = nullptr;
  std::size_t frame_ = 0;
  S at_start_{};
  S deepest_{};
};

// Depth (m, as collision_depth) of the hand in the body on its path, whatever the arm's posture:
// above kCollisionDepth no search of the arm helps.
[[nodiscard]] double unavoidable_depth(const ArmFeedback& feedback);

// The genome of the arm's best motion along the path by the lower layer's criteria, with a penalty
// for penetration of weight `weight`. None if no genome can follow the path.
[[nodiscard]] std::optional<FoundArm> search_free_arm(const ArmFeedback& feedback,
                                                      const CriteriaSettings& criteria,
                                                      double weight, LimbSearch search,
                                                      int threads);

}  // namespace shigusa
