// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/generate.hpp>
#include <string>
#include <vector>

#include "work/hold.hpp"
#include "work/moment.hpp"

namespace shigusa {

// Frames a second of a piece of work.
inline constexpr double kWorkRate = kUsualRate;

// A motion or a pause of a piece of work.
struct Piece {
  std::size_t action = 0;
  BodyModel body;                        // with the things in its hands
  Clip clip{};                           // at kWorkRate
  std::vector<Grip> grips{};             // of all hands meanwhile
  std::vector<Transformd> things{};      // (things) X_WT at its start
  std::optional<Candidate> candidate{};  // of a motion
  int way = 0;                           // which of the step's tasks it is for
};

// Parts of an action, one after the other.
enum class StepKind {
  clear,   // hands go over what is in their way to a thing
  go,      // effectors go to the goals of the action
  reach,   // hands go to a thing
  pause,   // the body stays as it is
  take,    // the hands hold the thing from here on
  lift,    // the thing is lifted clear
  carry,   // the thing is carried to its place
  let_go,  // the hands let the thing go
  rise,    // the body stands up straight
  hang,    // arms that do not hang yet go down
};
struct Step {
  StepKind kind = StepKind::go;
  double seconds = 0.0;  // of a pause
};
[[nodiscard]] std::vector<Step> steps_of(const Action& action);

// Ways of the hands in a row of pieces; `grips`: those after the last one.
[[nodiscard]] std::vector<HandUse> hand_uses(const Task& task, std::span<const Piece> pieces,
                                             std::span<const Grip> grips);

// A way to do a piece of work, as far as it has come.
class Line {
 public:
  explicit Line(const Task& task);

  // Makes a step that needs no search.
  void make(std::size_t action, const Step& step);

  // The tasks of which the first one that succeeds is the step's motion; empty: nothing moves.
  [[nodiscard]] std::vector<Task> tasks_of(std::size_t action, const Step& step) const;
  // Adds a motion of one of those, of the body that it was prepared with.
  void add(std::size_t action, const BodyModel& body, Candidate candidate, int way = 0);

  // The motions made so far as one candidate.
  [[nodiscard]] Candidate joined() const;
  // Whether nothing has moved yet.
  [[nodiscard]] bool is_new() const { return pieces_.empty(); }

 private:
  [[nodiscard]] std::size_t thing_of(const Action& action) const;
  [[nodiscard]] Task plain() const;
  [[nodiscard]] std::vector<Task> reaches(const Action& action) const;
  // Height (m) by which the thing that is grasped is put higher later.
  [[nodiscard]] double put_higher(const Action& grasp) const;
  // A motion over what is in the way of the hands; empty: nothing is.
  [[nodiscard]] std::vector<Task> clears(const Action& action) const;
  [[nodiscard]] Task goes(std::size_t action) const;
  [[nodiscard]] Task carries(std::size_t thing, const Transformd& to, bool rigid) const;
  // Standing up; who is bent leaves the arms free unless `arms` are led to where they hang.
  [[nodiscard]] Task rises(bool arms) const;
  // Whether free hands are near where they hang.
  [[nodiscard]] bool hangs() const;
  // Goals of hands that carry a thing along a way.
  [[nodiscard]] std::vector<Goal> carried(std::size_t thing, const Transformd& to,
                                          bool rigid) const;
  [[nodiscard]] Vec3d before_belly(const Thing& thing) const;
  // Whether a thing hangs from its handle in a hand whose fingers point down.
  [[nodiscard]] bool hangs_from(std::size_t thing, const Grip& grip) const;
  // Middle of a thing that hangs from a hand beside the leg.
  [[nodiscard]] Vec3d beside_leg(std::size_t thing, const Grip& grip) const;
  void keep(const Piece& piece);

  const Task* task_;
  Moment now_;
  std::vector<Piece> pieces_{};
  std::optional<double> knees_{};  // habit of the first low posture
};

}  // namespace shigusa
