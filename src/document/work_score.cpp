// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <shigusa/score.hpp>
#include <utility>

#include "body/load.hpp"
#include "clip_frames.hpp"
#include "core/index.hpp"
#include "core/say.hpp"
#include "kinematics/penetration.hpp"
#include "work/check_work.hpp"
#include "work/hold.hpp"
#include "work/sum_scores.hpp"
#include "work_times.hpp"

namespace shigusa {
namespace {

// Frames of a part of an action, with what the hands hold meanwhile.
struct Part {
  int from = 0;
  int to = 0;  // included
  Moment moment{};
};

// The actions of a recorded motion, one after the other.
class WorkReader {
 public:
  WorkReader(const RecordedMotion& recorded, const Task& task, const ScoreSettings& settings,
             const SmoothClip& smooth)
      : recorded_(recorded),
        task_(task),
        settings_(settings),
        smooth_(smooth),
        way_(recorded.body, smooth.clip),
        now_(smooth.first) {
    for (const Thing& thing : task.things) held_.things.push_back(start_pose(thing));
    timed_ = recorded.actions.size() == task.actions.size();
    if (!timed_) {
      score_.doubts.push_back(say("times_found", recorded.actions.size(), task.actions.size()));
    }
  }

  WorkScore read() {
    double all = 0.0;
    for (std::size_t k = 0; k < task_.actions.size(); ++k) {
      ActionScore& own = score_.actions.emplace_back();
      own.result.kind = *kind_of(task_.actions[k]);
      const auto [from, to] = range(k);
      own.result.start = time(from);
      parts_.clear();
      acting_.clear();
      now_ = end_of(task_.actions[k], from, to, own);
      if (timed_) now_ = to;
      own.result.end = time(now_);
      if (own.result.kind == ActionKind::place) own.result.placed = placed_;
      add_part(parts_.empty() ? from : parts_.back().to, now_);
      all += add_scores(own.result);
    }
    end_score(all, score_.score);
    return std::move(score_);
  }

  // The cost of all actions that read() has found.
  [[nodiscard]] Result<MotionCost> cost(const Ergonomics& ergonomics) {
    whole_.clip.dofs = smooth_.clip.dofs;
    whole_.clip.frame_time = smooth_.clip.frame_time;
    for (LiftSpan& lift : lifts_) {
      if (lift.put < lift.taken) lift.put = std::max(whole_.clip.frames - 1, lift.taken);
    }
    return motion_cost({recorded_, whole_, held_spans_, lifts_}, ergonomics);
  }

 private:
  [[nodiscard]] double time(int frame) const {
    return (frame - smooth_.first + settings_.first) * smooth_.clip.frame_time;
  }
  // First and last frame in which an action may be.
  [[nodiscard]] std::pair<int, int> range(std::size_t action) const {
    if (!timed_) return {now_, smooth_.last};
    const auto frame = [&](double seconds) {
      const double at = seconds / smooth_.clip.frame_time + 0.5 - settings_.first;
      return std::clamp(smooth_.first + static_cast<int>(at), now_, smooth_.last);
    };
    return {frame(recorded_.actions[action].start), frame(recorded_.actions[action].end)};
  }

  // Adds frames in which the hands hold what they hold now.
  void add_part(int from, int to) {
    Part& part = parts_.emplace_back(Part{from, to, held_});
    const auto angles = smooth_.clip.frame(from);
    part.moment.angles.assign(angles.begin(), angles.end());
  }

  // The frame in which an action that begins in `from` and ends by `to` is done.
  int end_of(const Action& action, int from, int to, ActionScore& own) {
    const int hold = static_cast<int>(action.hold / smooth_.clip.frame_time + 0.5);
    int end = to;
    switch (own.result.kind) {
      case ActionKind::goals:
        end = reach(action, from, to, own.result.goals);
        break;
      case ActionKind::wait:
        end = from + static_cast<int>(*action.wait / smooth_.clip.frame_time + 0.5);
        break;
      case ActionKind::grasp:
        end = grasp(action, from, to, own);
        break;
      case ActionKind::place:
      case ActionKind::release:
        end = let_go(action, from, to - (timed_ ? std::min(hold, to - from) : 0));
        break;
      case ActionKind::stand:
      case ActionKind::sit:
        acting_ = way_.upright_parts();
        end = way_.rise(recorded_, {from, to});
        break;
    }
    return std::min(end + hold, to);
  }

  int reach(const Action& action, int from, int to, std::vector<GoalResult>& results) {
    std::vector<int> effectors;
    for (const Goal& goal : action.goals) {
      effectors.push_back(recorded_.body.find_effector(goal.effector).value());
    }
    acting_ = effectors;
    const auto error = [&](std::size_t k, int frame) {
      return distance(action.goals[k], way_.at(effectors[k], frame));
    };
    const int end = way_.settles(effectors, {from, to}, !action.via, [&](int frame) {
      double worst = 0.0;
      for (std::size_t k = 0; k < effectors.size(); ++k) worst = max(worst, error(k, frame));
      return worst;
    });
    for (std::size_t k = 0; k < effectors.size(); ++k) {
      GoalResult& result = results.emplace_back();
      result.asked = action.goals[k];
      result.node = recorded_.body.effector(effectors[k]).node;
      result.reached = way_.at(effectors[k], end);
      result.error = error(k, end);
      result.turn.reached = to_quat(way_.place(effectors[k], end).rotation);
    }
    return end;
  }

  // Distance (m) of a place from a goal or its box.
  static double distance(const Goal& goal, const Vec3d& at) {
    Vec3d off = at - goal.position;
    for (int k = 0; k < 3; ++k) off[k] = max(abs(off[k]) - goal.tolerance[k], 0.0);
    return norm(off);
  }

  int grasp(const Action& action, int from, int to, ActionScore& own) {
    const std::size_t thing = thing_named(task_, action.grasp);
    const std::vector<PlacedBox> boxes =
        placed_boxes(obstacles_of(task_.things[thing], held_.things[thing]));
    const auto gap = [&](int hand, int frame) {
      return least_distance(boxes, way_.at(hand, frame));
    };
    const std::vector<int> hands = hands_of(action, task_.things[thing], {from, to}, gap);
    acting_ = hands;
    const int take = way_.settles(hands, {from, to}, true, [&](int frame) {
      double widest = 0.0;
      for (const int hand : hands) widest = max(widest, gap(hand, frame) - kPalm);
      return widest;
    });
    add_part(from, take);
    own.taken = time(take);
    lifts_.push_back(
        {task_.things[thing].name, task_.things[thing].mass, hands, take - smooth_.first, -1});
    for (const int hand : hands) {
      own.hands.push_back({recorded_.body.effector(hand).name, gap(hand, take)});
      held_.grips.push_back({hand, recorded_.body.effector(hand).link, thing,
                             inverse(way_.place(hand, take)) * held_.things[thing]});
    }
    // until it is lifted
    const double height = held_.things[thing].translation.y + kLifted;
    for (int frame = take; frame <= to; ++frame) {
      if (pose(thing, frame).translation.y >= height) return frame;
    }
    return timed_ ? to : take;
  }

  template <class Gap>
  [[nodiscard]] std::vector<int> hands_of(const Action& action, const Thing& thing, Frames frames,
                                          const Gap& gap) const {
    std::vector<int> hands;
    for (const std::string& name : action.with) {
      if (const auto hand = recorded_.body.find_effector(name)) hands.push_back(*hand);
    }
    if (!hands.empty()) return hands;
    for (const Side side : {Side::right, Side::left}) {
      if (const auto hand = recorded_.body.find_effector(JointKind::hand, side)) {
        if (!held_.in(*hand)) hands.push_back(*hand);
      }
    }
    if (takes_two(thing) || hands.size() < 2) return hands;
    const auto nearest = [&](int hand) {
      double least = gap(hand, frames.from);
      for (int frame = frames.from; frame <= frames.to; ++frame) {
        least = min(least, gap(hand, frame));
      }
      return least;
    };
    return {nearest(hands[1]) < nearest(hands[0]) ? hands[1] : hands[0]};
  }

  // Pose of a thing in a frame.
  [[nodiscard]] Transformd pose(std::size_t thing, int frame) const {
    const std::vector<Grip> grips = held_.on(thing);
    return grips.empty() ? held_.things[thing] : held_pose(way_.placed(frame), grips);
  }

  int let_go(const Action& action, int from, int to) {
    const bool places = !action.place.empty();
    const std::size_t thing = thing_named(task_, places ? action.place : action.release);
    std::vector<int> hands;
    for (const Grip& grip : held_.on(thing)) hands.push_back(grip.hand);
    acting_ = hands;
    const Transformd there =
        places ? upright_pose(*action.position, action.turn_deg) : Transformd{};
    const int end = timed_ ? to : way_.settles(hands, {from, to}, true, [&](int frame) {
      return places ? norm(pose(thing, frame).translation - there.translation) : 0.0;
    });
    const Transformd last = pose(thing, end);
    if (places) {
      placed_ = PlacedThing{task_.things[thing].name, last.translation, to_quat(last.rotation),
                            norm(last.translation - there.translation),
                            norm(rotation_vector(there.rotation * transpose(last.rotation)))};
    }
    add_part(from, end);
    for (LiftSpan& lift : lifts_) {
      if (lift.thing == task_.things[thing].name && lift.put < 0) lift.put = end - smooth_.first;
    }
    held_.things[thing] = last;
    std::erase_if(held_.grips, [thing](const Grip& grip) { return grip.thing == thing; });
    return end;
  }

  [[nodiscard]] std::vector<HeldLoad> context_loads(const Part& part) const {
    return state_of(recorded_.body, task_.things, part.moment).held;
  }
  // Adds the frames of a part, each once, to the motion whose cost is told.
  void add_frames(const Motion& motion, const Part& part, std::vector<HeldLoad> loads) {
    const auto dofs = static_cast<std::size_t>(motion.clip.dofs);
    const int first = smooth_.first + whole_.clip.frames;
    for (int f = std::max(first, part.from); f <= part.to; ++f) {
      const std::size_t k = index(f - part.from);
      const auto angles = motion.clip.frame(f - part.from);
      whole_.clip.angles.insert(whole_.clip.angles.end(), angles.begin(), angles.end());
      const auto torques = std::span(motion.torques).subspan(k * dofs, dofs);
      whole_.torques.insert(whole_.torques.end(), torques.begin(), torques.end());
      ++whole_.clip.frames;
    }
    held_spans_.push_back({first - smooth_.first, whole_.clip.frames - 1, std::move(loads)});
  }

  // Scores the parts of an action; returns their duration (s).
  double add_scores(ActionResult& action) {
    double seconds = 0.0;
    for (const Part& part : parts_) {
      if (part.to <= part.from) continue;
      SmoothClip frames{.clip = smooth_.clip, .first = part.from, .last = part.to};
      CriteriaContext context{.start = state_of(recorded_.body, task_.things, part.moment),
                              .effectors = acting_,
                              .obstacles = task_.obstacles};
      BodyModel body = recorded_.body;
      for (const HeldLoad& load : context.start.held) body = with_load(body, load);
      const ClipScore own = score_frames(body, std::move(context), frames, settings_.criteria);
      const double duration = own.motion.clip.duration();
      const Judgement judgement = judge(body, own.measures);
      add_score(own.score, duration, action.score);
      add_score(own.score, duration, score_.score);
      add_judgement(judgement, time(part.from), action.judgement);
      add_judgement(judgement, time(part.from), score_.judgement);
      if (settings_.ergonomics) add_frames(own.motion, part, context_loads(part));
      seconds += duration;
    }
    end_score(seconds, action.score);
    return seconds;
  }

  const RecordedMotion& recorded_;
  const Task& task_;
  const ScoreSettings& settings_;
  const SmoothClip& smooth_;
  RecordedWay way_;
  Moment held_{};  // things where they stood last, and the hands on them
  int now_;        // frame in which the last action ended
  bool timed_ = false;
  std::vector<Part> parts_{};
  std::vector<int> acting_{};  // effectors of the action
  std::optional<PlacedThing> placed_{};
  // motion without gaps, loads and lifts, by frames from the first scored one
  Motion whole_{};
  std::vector<HeldSpan> held_spans_{};
  std::vector<LiftSpan> lifts_{};
  WorkScore score_{};
};

}  // namespace

Result<WorkScore> score_work(const RecordedMotion& recorded, const Task& task,
                             const ScoreSettings& settings) {
  SHG_TRY(check_work(task));
  SHG_TRY_ASSIGN(SmoothClip smooth, smooth_clip(recorded, settings));
  WorkReader reader(recorded, task, settings, smooth);
  WorkScore score = reader.read();
  if (settings.ergonomics) {
    SHG_TRY_ASSIGN(score.cost, reader.cost(*settings.ergonomics));
  }
  score.fit = std::move(smooth.fit);
  score.doubts.insert(score.doubts.end(), smooth.doubts.begin(), smooth.doubts.end());
  return score;
}

}  // namespace shigusa
