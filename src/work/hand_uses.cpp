// SPDX-License-Identifier: MIT
// Ways of the hands in a piece of work, from its motions and pauses.
#include <algorithm>

#include "work/check_work.hpp"
#include "work/finger_contact.hpp"
#include "work/line.hpp"

namespace shigusa {
namespace {

// The uses of one hand, piece by piece.
class UseFinder {
 public:
  UseFinder(const Task& task, int hand, std::vector<HandUse>& uses)
      : task_(task), hand_(hand), name_(task.body.effector(hand).name), uses_(uses) {}

  void add(const Piece& piece) {
    follow(grip_in(piece.grips));
    const double end = now_ + piece.clip.duration();
    if (!held_ && piece.candidate && goes(task_.actions[piece.action])) {
      uses_.push_back({.effector = name_, .start = now_, .there = end});
    }
    if (piece.candidate) left_ = now_;
    now_ = end;
  }

  // Takes or lets go as the grips after the last piece say.
  void end(std::span<const Grip> grips) { follow(grip_in(grips)); }

 private:
  [[nodiscard]] const Grip* grip_in(std::span<const Grip> grips) const {
    const auto own = std::find_if(grips.begin(), grips.end(),
                                  [this](const Grip& grip) { return grip.hand == hand_; });
    return own == grips.end() ? nullptr : &*own;
  }

  void follow(const Grip* grip) {
    if (held_ && (grip == nullptr || grip->thing != *held_)) {
      uses_.back().end = now_;
      held_.reset();
    }
    if (grip == nullptr || held_) return;
    const Thing& thing = task_.things[grip->thing];
    uses_.push_back({.effector = name_,
                     .thing = thing.name,
                     .start = left_,
                     .there = now_,
                     .flexion = flexion_about(task_.body, *grip, thing)});
    held_ = grip->thing;
  }

  [[nodiscard]] bool goes(const Action& action) const {
    return std::any_of(action.goals.begin(), action.goals.end(),
                       [this](const Goal& goal) { return goal.effector == name_; });
  }

  const Task& task_;
  int hand_;
  const std::string& name_;
  std::vector<HandUse>& uses_;
  double now_ = 0.0;                   // s
  double left_ = 0.0;                  // s, when the last motion began
  std::optional<std::size_t> held_{};  // index of the thing
};

}  // namespace

std::vector<HandUse> hand_uses(const Task& task, std::span<const Piece> pieces,
                               std::span<const Grip> grips) {
  std::vector<HandUse> uses;
  for (const Side side : {Side::left, Side::right}) {
    const auto hand = task.body.find_effector(JointKind::hand, side);
    if (!hand) continue;
    UseFinder finder(task, *hand, uses);
    for (const Piece& piece : pieces) finder.add(piece);
    finder.end(grips);
  }
  return uses;
}

}  // namespace shigusa
