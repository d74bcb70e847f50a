// SPDX-License-Identifier: MIT
#include "page_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>

#include "body/joint_name.hpp"
#include "candidate_strip.hpp"
#include "core/index.hpp"
#include "draw/strip_figure_body.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "work_strip.hpp"

namespace shigusa {
namespace {

using PagePoint = std::array<std::int32_t, 3>;  // mm, world

constexpr double kPageMillimetres = 1e3;
constexpr double kPageFarthest = 1e6;  // mm; nothing further away is drawn there

std::int32_t to_millimetres(double metres) {
  const double mm = clamp(kPageMillimetres * metres, -kPageFarthest, kPageFarthest);
  return static_cast<std::int32_t>(mm < 0.0 ? mm - 0.5 : mm + 0.5);
}
PagePoint to_millimetres(const Vec3d& p) {
  return {to_millimetres(p.x), to_millimetres(p.y), to_millimetres(p.z)};
}

// Longest diagonal, as the size of a figure with unknown limbs.
double page_extent(const std::vector<Transformd>& nodes) {
  Vec3d low = nodes.front().translation;
  Vec3d high = low;
  for (const Transformd& node : nodes) {
    for (int i = 0; i < 3; ++i) {
      low[i] = min(low[i], node.translation[i]);
      high[i] = max(high[i], node.translation[i]);
    }
  }
  return max(norm(high - low), 1e-3);
}

// Numbers of the poses of a motion on the page and of the frames in which they stand evenly; a
// shorter motion stays at its end.
struct PagePoses {
  int count = 0;
  int frames = 0;
};
PagePoses poses_of(const Candidate& candidate, const GenerateResult& generation) {
  int frames = candidate.motion.clip.frames;
  int most = kPagePoses;
  if (is_work(generation)) {
    for (const Candidate& each : generation.candidates) {
      frames = std::max(frames, each.motion.clip.frames);
      most = std::max(most, kPagePoses * static_cast<int>(each.actions.size()));
    }
  }
  return {std::min(frames, most), frames};
}

// Frame position of a pose, between two frames if the motion has more frames than poses.
struct FramePlace {
  int before = 0;
  double share = 0.0;  // fraction of the step to the next frame
};
FramePlace frame_of(const Clip& clip, const PagePoses& poses, int pose) {
  if (poses.count < 2) return {};
  const int last = clip.frames - 1;
  const double place = static_cast<double>(pose) * (poses.frames - 1) / (poses.count - 1);
  const int before = std::min(static_cast<int>(place), last);
  return {before, before == last ? 0.0 : place - before};
}

// Points of a thing in its own axes (see page_figures).
std::vector<Vec3d> points_of(const Thing& thing) {
  if (thing.shape == ThingShape::sphere) return {Vec3d{}};
  if (thing.shape == ThingShape::box) return moving_thing({thing, {}}).corners;
  const double half = 0.5 * thing.size.y;
  return {{0, -half, 0}, {0, half, 0}};
}

// Figure of a body in all poses of a motion. Its points are the balls of its parts, followed by the
// points that go to goals, or by those of things.
struct PosedFigure {
  double size = 0.0;                           // m
  std::vector<strip::Part> parts;              // in the first pose
  std::vector<std::vector<PagePoint>> points;  // (points × poses)
};

class FigurePoser {
 public:
  FigurePoser(const Task& task, const Candidate& candidate, const PagePoses& poses)
      : motion_(candidate.motion),
        things_(candidate.things),
        works_(!candidate.actions.empty()),
        poses_(poses),
        moves_(skeleton_motion(task.body, motion_.clip)),
        body_(moves_.skeleton, strip_settings(task, candidate), {{0, 1, 0}, {0, 0, 1}}) {}

  [[nodiscard]] PosedFigure figure() {
    PosedFigure figure;
    figure.size = size_ = body_.stature() > 0.0 ? body_.stature() : page_extent(nodes(0));
    figure.parts = body_.parts(nodes(0), size_);
    for (int pose = 0; pose < poses_.count; ++pose) {
      add(frame_of(motion_.clip, poses_, pose), figure);
    }
    return figure;
  }

 private:
  [[nodiscard]] std::vector<Transformd> nodes(int frame) const {
    return world_transforms(moves_.skeleton, moves_.clip, frame);
  }
  [[nodiscard]] std::vector<Vec3d> places(int frame) const {
    std::vector<Vec3d> places;
    for (const strip::Part& part : body_.parts(nodes(frame), size_)) {
      for (const strip::Ball& ball : part.balls) places.push_back(ball.centre);
    }
    for (const auto& effector : motion_.effectors) {
      if (!works_) places.push_back(effector[index(frame)]);
    }
    for (const auto& [thing, poses] : things_) {
      for (const Vec3d& point : points_of(thing)) places.push_back(poses[index(frame)] * point);
    }
    return places;
  }
  void add(const FramePlace& at, PosedFigure& figure) const {
    std::vector<Vec3d> here = places(at.before);
    if (at.share > 0.0) {
      const std::vector<Vec3d> next = places(at.before + 1);
      for (std::size_t i = 0; i < here.size(); ++i) here[i] += (next[i] - here[i]) * at.share;
    }
    figure.points.resize(here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      figure.points[i].push_back(to_millimetres(here[i]));
    }
  }

  const Motion& motion_;
  const std::vector<ThingMotion>& things_;
  bool works_;
  PagePoses poses_;
  SkeletonMotion moves_;
  strip::FigureBody body_;  // of the skeleton above
  double size_ = 0.0;
};

// Factor on a part's thickness. Strips are slender; here limbs and trunk have about a person's
// thickness. Neck and head, made of two balls, and feet, which would sink into the floor, keep
// theirs.
double girth_of(const strip::Part& part) {
  constexpr double kGirth = 1.2;
  const bool stays = part.foot || (part.tone == strip::Tone::middle && part.balls.size() < 3);
  return stays ? 1.0 : kGirth;
}

// For each point the first one that coincides with it in all poses of all motions.
std::vector<std::size_t> equal_points(const std::vector<PosedFigure>& figures) {
  const std::size_t count = figures.front().points.size();
  std::vector<std::size_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto is_same = [&](std::size_t k) {
      return std::all_of(figures.begin(), figures.end(), [&](const PosedFigure& figure) {
        return figure.points[k] == figure.points[i];
      });
    };
    std::size_t k = 0;
    while (k < i && !is_same(k)) ++k;
    first[i] = k;
  }
  return first;
}

void append_vlq(std::int64_t value, std::string& code) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::uint64_t kMore = 32;
  auto rest = static_cast<std::uint64_t>(value < 0 ? -value : value) * 2 + (value < 0 ? 1 : 0);
  do {
    const std::uint64_t digit = rest % kMore;
    rest /= kMore;
    code += kDigits[digit + (rest > 0 ? kMore : 0)];
  } while (rest > 0);
}

void append_series(const std::vector<PagePoint>& places, std::size_t axis, std::string& code) {
  std::int64_t last = 0;
  std::int64_t growth = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::int64_t value = places[k][axis];
    const std::int64_t step = value - last;
    append_vlq(k < 1 ? value : step - growth, code);
    growth = k < 1 ? 0 : step;
    last = value;
  }
}

// Writer of parts, the points of goals' paths, and motions; each distinct point is written once.
class FigureWriter {
 public:
  explicit FigureWriter(const std::vector<PosedFigure>& figures)
      : figures_(figures), first_(equal_points(figures)), number_(first_.size()) {
    for (std::size_t i = 0; i < first_.size(); ++i) {
      if (first_[i] == i) kept_.push_back(i);
      number_[i] = first_[i] == i ? kept_.size() - 1 : number_[first_[i]];
    }
  }

  [[nodiscard]] std::string parts() {
    std::string text;
    for (const strip::Part& part : figures_.front().parts) {
      text += fmt::format("{}[{},{},{},[", text.empty() ? "" : ",", static_cast<int>(part.tone),
                          to_millimetres(part.setback), part.foot ? 1 : 0);
      for (std::size_t b = 0; b < part.balls.size(); ++b) {
        text += fmt::format("{}[{},{}]", b == 0 ? "" : ",", number_[next_++],
                            to_millimetres(girth_of(part) * part.balls[b].radius));
      }
      text += "]]";
    }
    return text;
  }

  // So many points more; call after parts().
  [[nodiscard]] std::string points(std::size_t count) {
    std::string text;
    for (std::size_t k = 0; k < count; ++k) {
      text += fmt::format("{}{}", k == 0 ? "" : ",", number_[next_++]);
    }
    return text;
  }

  // `more`: further members of each.
  [[nodiscard]] std::string motions(const std::vector<std::string>& more) const {
    std::string text;
    for (std::size_t m = 0; m < figures_.size(); ++m) {
      const PosedFigure& figure = figures_[m];
      std::string code;
      for (const std::size_t i : kept_) {
        for (std::size_t axis = 0; axis < 3; ++axis) append_series(figure.points[i], axis, code);
      }
      text += fmt::format("{}{{\"poses\":{}{},\"code\":\"{}\"}}", text.empty() ? "\n" : ",\n",
                          figure.points.front().size(), more[m], code);
    }
    return text;
  }

 private:
  const std::vector<PosedFigure>& figures_;
  std::vector<std::size_t> first_;   // (points) the first that coincides
  std::vector<std::size_t> number_;  // (points) its number among those kept
  std::vector<std::size_t> kept_;
  std::size_t next_ = 0;  // next point to write
};

std::string goals_json(const std::vector<Vec3d>& goals) {
  std::string text;
  for (const Vec3d& goal : goals) {
    const PagePoint at = to_millimetres(goal);
    text += fmt::format("{}[{},{},{}]", text.empty() ? "" : ",", at[0], at[1], at[2]);
  }
  return text;
}

// Member "actions" of a motion; empty if it has none.
std::string actions_json(const Candidate& candidate) {
  std::string text;
  for (const StripAction& action : work_actions(candidate)) {
    const double step = candidate.motion.clip.frame_time;
    text += fmt::format("{}[\"{}\",{:.4f},{:.4f},[{}]]", text.empty() ? "" : ",", action.name,
                        action.first * step, action.last * step, goals_json(action.goals));
  }
  return text.empty() ? text : fmt::format(",\"actions\":[{}]", text);
}

// Member "things" of a piece of work.
std::string things_json(const Candidate& candidate, FigureWriter& writer) {
  std::string text;
  for (const auto& [thing, poses] : candidate.things) {
    const bool round = thing.shape != ThingShape::box;
    text += fmt::format("{}[{},[{}]]", text.empty() ? "" : ",",
                        round ? to_millimetres(0.5 * thing.size.x) : 0,
                        writer.points(points_of(thing).size()));
  }
  return fmt::format(",\"things\":[{}]", text);
}

// Soles of the planted feet in the first frame.
std::string soles_json(const Task& task, const Candidate& candidate) {
  Kinematics<double> kinematics(task.body);
  forward_kinematics<double>(task.body, candidate.motion.clip.frame(0), kinematics);
  std::string text;
  for (const Foot& foot : task.body.feet()) {
    const auto& contacts = candidate.contacts;
    const bool stands = std::any_of(
        contacts.begin(), contacts.end(),
        [&foot](const ContactResult& contact) { return contact.effector == foot.name; });
    if (!stands || foot.outline.empty()) continue;
    std::string corners;
    for (const Vec3d& corner : foot.outline) {
      const PagePoint at = to_millimetres(kinematics.point(foot.link, corner));
      corners += fmt::format("{}[{},{},{}]", corners.empty() ? "" : ",", at[0], at[1], at[2]);
    }
    text += fmt::format("{}[{}]", text.empty() ? "" : ",", corners);
  }
  return text;
}

std::string box_json(const StripThing& box) {
  std::string text;
  for (const Vec3d& corner : box.corners) {
    const PagePoint at = to_millimetres(corner);
    text += fmt::format("[{},{},{}],", at[0], at[1], at[2]);
  }
  return fmt::format("[{}{}]", text, to_millimetres(box.radius));
}

std::string boxes_json(const Task& task) {
  std::string text;
  for (const StripThing& box : things_around(task)) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", box_json(box));
  }
  return text;
}

}  // namespace

bool is_work(const GenerateResult& generation) {
  const auto& all = generation.candidates;
  return std::any_of(all.begin(), all.end(),
                     [](const Candidate& candidate) { return !candidate.actions.empty(); });
}

double page_seconds(const GenerateResult& generation) {
  double seconds = generation.duration;
  for (const Candidate& candidate : generation.candidates) {
    if (!candidate.actions.empty()) seconds = max(seconds, candidate.motion.clip.duration());
  }
  return seconds;
}

std::string page_figures(const Task& task, const GenerateResult& generation) {
  std::vector<PosedFigure> figures;
  std::vector<std::string> actions;
  for (const Candidate& candidate : generation.candidates) {
    const PagePoses poses = poses_of(candidate, generation);
    actions.push_back(actions_json(candidate));
    figures.push_back(FigurePoser(task, candidate, poses).figure());
  }
  const bool left =
      !task.goals.empty() &&
      parse_joint_name(task.goals.front().effector).side.value_or(Side::right) == Side::left;
  FigureWriter writer(figures);
  const Candidate& first = generation.candidates.front();
  const bool works = is_work(generation);
  const std::string parts = writer.parts();
  const std::string paths = writer.points(works ? 0 : first.motion.effectors.size());
  const std::string things = works ? things_json(first, writer) : std::string();
  std::vector<Vec3d> goals;
  for (const Goal& goal : task.goals) goals.push_back(goal.position);
  return fmt::format(
      "{{\"size\":{},\"side\":{},\"seconds\":{:.4f},\"parts\":[{}],\"paths\":[{}],\n"
      "\"goals\":[{}],\"soles\":[{}],\"boxes\":[{}]{},\"motions\":[{}]}}",
      to_millimetres(figures.front().size), left ? -1 : 1, page_seconds(generation), parts, paths,
      goals_json(goals), soles_json(task, first), boxes_json(task), things,
      writer.motions(actions));
}

}  // namespace shigusa
