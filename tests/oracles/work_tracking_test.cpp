// SPDX-License-Identifier: MIT
// Drawn pieces of work played by MuJoCo's forward simulation: the thing is a body of its own, which
// is welded to the hands while they hold it, and to the world before and after.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/pieces.hpp"
#include "support/tracking.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

constexpr int kPieces = 30;

std::string numbers(const Vec3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z);
}
std::string pose_text(const Transformd& pose) {
  const Quatd q = to_quat(pose.rotation);
  return fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g}", numbers(pose.translation), q.w, q.x, q.y,
                     q.z);
}

// Inertia (kg m²) about the middle, of even density; a cylinder stands.
Vec3d inertia_of(const Thing& thing) {
  const auto [x, y, z] = thing.size;
  const double m = thing.mass;
  if (thing.shape != ThingShape::cylinder) {
    return Vec3d{y * y + z * z, x * x + z * z, x * x + y * y} * (m / 12.0);
  }
  const double across = m * (0.75 * x * x + y * y) / 12.0;
  return {across, m * x * x / 8.0, across};
}

// The time (s) in which hands hold the only thing of a piece, and their links.
struct Hold {
  double from = 0.0;
  double to = 0.0;
  std::vector<int> links{};
  std::vector<Transformd> in_hands{};  // pose of the thing in each
};

Hold hold_of(const Task& task, const Candidate& candidate) {
  Hold hold;
  const ThingMotion& thing = candidate.things.front();
  const Clip& clip = candidate.motion.clip;
  const auto moves = [&](const Transformd& pose) {
    return norm(pose.translation - thing.poses.front().translation) > 1e-6;
  };
  const auto first = std::find_if(thing.poses.begin(), thing.poses.end(), moves);
  const auto frame = static_cast<int>(first - thing.poses.begin()) - 1;
  hold.from = frame * clip.frame_time;
  const Posture posture(task.body, clip.frame(frame));
  for (std::size_t a = 0; a < candidate.actions.size(); ++a) {
    if (candidate.actions[a].kind == ActionKind::place) hold.to = candidate.actions[a].end;
    if (candidate.actions[a].kind != ActionKind::grasp) continue;
    for (const GoalResult& goal : candidate.actions[a].goals) {
      const int link = task.body.effector(*task.body.find_effector(goal.asked.effector)).link;
      hold.links.push_back(link);
      hold.in_hands.push_back(inverse(posture.place(link)) * thing.poses.front());
    }
  }
  return hold;
}

// A thing as a body of MuJoCo's, with welds to the world at its first and its last place, and to
// the hands.
class WeldedThing {
 public:
  WeldedThing(const Task& task, const Candidate& candidate)
      : way_(candidate.things.front()),
        hold_(hold_of(task, candidate)),
        tracking_(task, body_text(), weld_text()) {
    for (std::size_t k = 0; k < hold_.links.size(); ++k) {
      model()->eq_obj1id[2 + k] = tracking_.mujoco().body_of(hold_.links[k]);
    }
  }

  // Plays a part of the motion, which begins at rest at a frame, at `start` (s).
  double play(const Motion& part, std::size_t frame, double start, double hold) {
    return tracking_.run(
        part,
        [&](double time) {
          if (time == 0.0) put(way_.poses[frame]);
          weld(start + time);
        },
        hold);
  }

 private:
  mjModel* model() { return tracking_.mujoco().model(); }

  [[nodiscard]] std::string body_text() const {
    return fmt::format(
        "<body name=\"thing\" pos=\"{}\"><freejoint/><inertial pos=\"0 0 0\" mass=\"{:.17g}\" "
        "diaginertia=\"{}\"/></body>",
        numbers(way_.poses.front().translation), way_.thing.mass, numbers(inertia_of(way_.thing)));
  }

  [[nodiscard]] std::string weld_text() const {
    std::string welds = "<equality>";
    for (const Transformd& at : {way_.poses.front(), way_.poses.back()}) {
      welds += fmt::format("<weld body1=\"thing\" relpose=\"{}\"/>", pose_text(inverse(at)));
    }
    for (const Transformd& in_hand : hold_.in_hands) {
      welds +=
          fmt::format("<weld body1=\"base\" body2=\"thing\" relpose=\"{}\"/>", pose_text(in_hand));
    }
    return welds + "</equality>";
  }

  void put(const Transformd& pose) {
    const int body = mj_name2id(model(), mjOBJ_BODY, "thing");
    double* const at =
        tracking_.mujoco().data()->qpos + model()->jnt_qposadr[model()->body_jntadr[body]];
    const Quatd q = to_quat(pose.rotation);
    const double values[] = {
        pose.translation.x, pose.translation.y, pose.translation.z, q.w, q.x, q.y, q.z};
    std::copy(std::begin(values), std::end(values), at);
  }

  void weld(double time) {
    model()->eq_active[0] = time < hold_.from ? 1 : 0;
    model()->eq_active[1] = time >= hold_.to ? 1 : 0;
    for (std::size_t k = 0; k < hold_.links.size(); ++k) {
      model()->eq_active[2 + k] = time >= hold_.from && time < hold_.to ? 1 : 0;
    }
  }

  const ThingMotion& way_;
  Hold hold_;
  Tracking tracking_;
};

// The frames from `first` to `last` of a motion.
Motion part_of(const Motion& motion, int first, int last) {
  const auto cut = [&](const std::vector<double>& all) {
    const auto at = [&](int frame) {
      return all.begin() + static_cast<std::ptrdiff_t>(frame) * motion.clip.dofs;
    };
    return std::vector<double>(at(first), at(last + 1));
  };
  Motion part;
  part.clip = {.dofs = motion.clip.dofs,
               .frames = last - first + 1,
               .frame_time = motion.clip.frame_time,
               .angles = cut(motion.clip.angles)};
  part.torques = cut(motion.torques);
  return part;
}

// The largest distance (m) of the centre of mass from where it was planned, in any action, each of
// which begins where it was planned: without balance, ankles bear a body for some seconds only.
double farthest_off(const Task& task, const Candidate& candidate) {
  WeldedThing thing(task, candidate);
  const double frame_time = candidate.motion.clip.frame_time;
  double most = 0.0;
  for (const ActionResult& action : candidate.actions) {
    const int first = static_cast<int>(action.start / frame_time + 0.5);
    const int last = static_cast<int>(action.end / frame_time + 0.5);
    if (last <= first) continue;
    const bool ends = &action == &candidate.actions.back();
    most = max(most, thing.play(part_of(candidate.motion, first, last),
                                static_cast<std::size_t>(first), action.start, ends ? kHold : 0.0));
  }
  return most;
}

TEST(WorkTracking, TwoOfTenPiecesFallAtMost) {
  int played = 0;
  int fallen = 0;
  for (int k = 0; played < kPieces; ++k) {
    const Task task = drawn_piece(static_cast<std::uint64_t>(k));
    const GenerateResult result = perform(task).value();
    const Candidate& first = result.candidates.front();
    if (!result.meets_goals() || first.judgement.verdict == Verdict::impossible) continue;
    ++played;
    const double off = farthest_off(task, first);
    fallen += off > kFallen ? 1 : 0;
  }
  RecordProperty("fallen", fallen);
  EXPECT_LE(fallen, 2 * kPieces / 10);
}

}  // namespace
}  // namespace shigusa
