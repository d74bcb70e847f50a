// SPDX-License-Identifier: MIT
// A candidate of a whole piece of work from its pieces.
#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "work/check_work.hpp"
#include "work/line.hpp"
#include "work/sum_scores.hpp"

namespace shigusa {
namespace {

// Adds the worst of the measures of a motion that begins at `start` (s).
void add_measures(const MotionMeasures& measures, double start, bool first, MotionMeasures& all) {
  if (all.loads.empty()) all.loads.resize(measures.loads.size());
  for (std::size_t d = 0; d < measures.loads.size(); ++d) {
    JointLoad load = measures.loads[d];
    load.time += start;
    if (first || load.share > all.loads[d].share) all.loads[d] = load;
  }
  for (const LimitExcess& over : measures.over_limit) {
    const auto same = [&over](const LimitExcess& other) { return other.dof == over.dof; };
    const auto at = std::find_if(all.over_limit.begin(), all.over_limit.end(), same);
    if (at == all.over_limit.end())
      all.over_limit.push_back(over);
    else
      at->excess = max(at->excess, over.excess);
  }
  if (measures.support) {
    SupportMargins margins = *measures.support;
    margins.centre_of_mass.time += start;
    margins.pressure.time += start;
    if (!all.support) all.support = margins;
    if (margins.centre_of_mass.distance < all.support->centre_of_mass.distance) {
      all.support->centre_of_mass = margins.centre_of_mass;
    }
    if (margins.pressure.distance < all.support->pressure.distance) {
      all.support->pressure = margins.pressure;
    }
  }
  if (measures.collides.depth > all.collides.depth) {
    all.collides = measures.collides;
    all.collides.time += start;
  }
  all.sudden.pressure = max(all.sudden.pressure, measures.sudden.pressure);
  all.sudden.torque = max(all.sudden.torque, measures.sudden.torque);
}

void add_contacts(const std::vector<ContactResult>& contacts, std::vector<ContactResult>& all) {
  for (const ContactResult& contact : contacts) {
    const auto same = [&](const ContactResult& c) { return c.effector == contact.effector; };
    const auto at = std::find_if(all.begin(), all.end(), same);
    if (at == all.end()) {
      all.push_back(contact);
      continue;
    }
    at->max_slide = max(at->max_slide, contact.max_slide);
    if (!contact.heel) continue;
    if (!at->heel) at->heel.emplace();
    at->heel->angle = max(at->heel->angle, contact.heel->angle);
    at->heel->height = max(at->heel->height, contact.heel->height);
  }
}

// Ends the last action but one where its places are passed in the piece that begins at `start` (s).
void pass(const Task& task, const Action& via, const Piece& piece, double start,
          std::vector<ActionResult>& actions) {
  ActionResult& action = actions[actions.size() - 2];
  const Clip& clip = piece.clip;
  Kinematics<double> placed(task.body);
  for (const Goal& goal : via.goals) {
    const Effector& effector = task.body.effector(task.body.find_effector(goal.effector).value());
    GoalResult& result = action.goals.emplace_back();
    result.asked = goal;
    result.node = effector.node;
    result.error = norm(goal.position);
    Vec3d before{};
    for (int f = 0; f < clip.frames; ++f) {
      forward_kinematics<double>(task.body, clip.frame(f), placed);
      const Vec3d at = placed.point(effector.link, effector.point);
      // on the way from the frame before
      const Vec3d way = f > 0 ? at - before : Vec3d{};
      const double along =
          clamp(dot(goal.position - before, way) / max(dot(way, way), 1e-12), 0.0, 1.0);
      const Vec3d nearest = f > 0 ? before + way * along : at;
      const double error = norm(nearest - goal.position);
      if (f == 0 || error < result.error) {
        result.error = error;
        result.reached = nearest;
        action.end = start + f * clip.frame_time;
      }
      before = at;
    }
  }
  actions.back().start = action.end;
}

// Joins the frames of pieces, each of which begins with the last frame of the one before.
class Joiner {
 public:
  Joiner(const Task& task, std::vector<int> effectors)
      : task_(task), effectors_(std::move(effectors)) {
    joined_.motion.clip = {
        .dofs = task.body.dof_count(), .frames = 0, .frame_time = 0.0, .angles = {}};
    joined_.motion.effectors.resize(effectors_.size());
    for (const Thing& thing : task.things) joined_.things.push_back({thing, {}});
  }

  // Time (s) of the last frame.
  [[nodiscard]] double now() const {
    const Clip& clip = joined_.motion.clip;
    return clip.frames > 0 ? (clip.frames - 1) * clip.frame_time : 0.0;
  }

  void add(const Piece& piece) {
    Clip& clip = joined_.motion.clip;
    clip.frame_time = piece.clip.frame_time;
    const Motion motion = ClipDynamics(piece.body).completed(piece.clip);
    Kinematics<double> placed(task_.body);
    for (int f = clip.frames == 0 ? 0 : 1; f < piece.clip.frames; ++f) {
      const auto angles = piece.clip.frame(f);
      clip.angles.insert(clip.angles.end(), angles.begin(), angles.end());
      ++clip.frames;
      const auto torques =
          std::span(motion.torques).subspan(index(f) * angles.size(), angles.size());
      joined_.motion.torques.insert(joined_.motion.torques.end(), torques.begin(), torques.end());
      joined_.motion.centre_of_mass.push_back(motion.centre_of_mass[index(f)]);
      forward_kinematics<double>(task_.body, angles, placed);
      for (std::size_t e = 0; e < effectors_.size(); ++e) {
        const Effector& effector = task_.body.effector(effectors_[e]);
        joined_.motion.effectors[e].push_back(placed.point(effector.link, effector.point));
      }
      for (std::size_t t = 0; t < joined_.things.size(); ++t) {
        std::vector<Grip> grips;
        for (const Grip& grip : piece.grips) {
          if (grip.thing == t) grips.push_back(grip);
        }
        joined_.things[t].poses.push_back(grips.empty() ? piece.things[t]
                                                        : held_pose(placed, grips));
      }
    }
  }

  [[nodiscard]] Candidate& joined() { return joined_; }

 private:
  const Task& task_;
  std::vector<int> effectors_;
  Candidate joined_;
};

}  // namespace

Candidate Line::joined() const {
  std::vector<int> effectors;
  for (const Piece& piece : pieces_) {
    if (!piece.candidate) continue;
    for (const GoalResult& goal : piece.candidate->goals) {
      const int effector = task_->body.find_effector(goal.asked.effector).value();
      if (std::find(effectors.begin(), effectors.end(), effector) == effectors.end()) {
        effectors.push_back(effector);
      }
    }
  }
  Joiner joiner(*task_, effectors);
  Candidate& whole = joiner.joined();
  double moving = 0.0;
  std::vector<double> action_moving;
  for (const Piece& piece : pieces_) {
    while (whole.actions.size() <= piece.action) {
      whole.actions.push_back({.kind = *kind_of(task_->actions[whole.actions.size()]),
                               .start = joiner.now(),
                               .end = joiner.now()});
      action_moving.push_back(0.0);
    }
    ActionResult& action = whole.actions.back();
    const double start = joiner.now();
    joiner.add(piece);
    action.end = joiner.now();
    if (const Action* via = via_before(*task_, piece.action)) {
      pass(*task_, *via, piece, start, whole.actions);
    }
    if (!piece.candidate) continue;
    const Candidate& own = *piece.candidate;
    const double seconds = piece.clip.duration();
    const bool first = moving == 0.0;
    moving += seconds;
    action_moving.back() += seconds;
    add_score(own.score, seconds, action.score);
    add_score(own.score, seconds, whole.score);
    add_judgement(own.judgement, start, action.judgement);
    add_judgement(own.judgement, start, whole.judgement);
    add_measures(own.measures, start, first, whole.measures);
    add_contacts(own.contacts, whole.contacts);
    action.goals = own.goals;
    whole.motions.push_back(
        {piece.action, piece.way, own.motion.clip.duration(), own.parameters, own.approach});
    whole.path_error = max(whole.path_error, own.path_error);
    whole.final_posture = own.final_posture;
    if (first) whole.parameters = own.parameters;
  }
  whole.hands = hand_uses(*task_, pieces_, now_.grips);
  end_score(moving, whole.score);
  for (std::size_t a = 0; a < whole.actions.size(); ++a) {
    ActionResult& action = whole.actions[a];
    end_score(action_moving[a], action.score);
    const Action& asked = task_->actions[a];
    if (action.kind != ActionKind::place) continue;
    const std::size_t thing = thing_named(*task_, asked.place);
    const auto frame = index(static_cast<int>(action.end / whole.motion.clip.frame_time + 0.5));
    const Transformd& pose = whole.things[thing].poses[frame];
    const Transformd to = upright_pose(*asked.position, asked.turn_deg);
    action.placed = PlacedThing{asked.place, pose.translation, to_quat(pose.rotation),
                                norm(pose.translation - to.translation),
                                norm(rotation_vector(to.rotation * transpose(pose.rotation)))};
  }
  for (const int effector : effectors) {
    // the last goal of each
    for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
      if (!piece->candidate) continue;
      const auto& goals = piece->candidate->goals;
      const auto own = std::find_if(goals.begin(), goals.end(), [&](const GoalResult& goal) {
        return task_->body.find_effector(goal.asked.effector) == effector;
      });
      if (own == goals.end()) continue;
      whole.goals.push_back(*own);
      break;
    }
  }
  return std::move(whole);
}

}  // namespace shigusa
