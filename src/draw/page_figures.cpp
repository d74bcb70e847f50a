// SPDX-License-Identifier: MIT
#include "page_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>

#include "body/joint_name.hpp"
#include "candidate_strip.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "page_poser.hpp"
#include "problem/thing_parts.hpp"
#include "work_strip.hpp"

namespace shigusa {
namespace {

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
    for (const Thing& part : split(thing)) {
      const bool round = part.shape != ThingShape::box;
      text += fmt::format("{}[{},[{}]]", text.empty() ? "" : ",",
                          round ? to_millimetres(0.5 * part.size.x) : 0,
                          writer.points(points_of(part).size()));
    }
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
    actions.push_back(actions_json(candidate));
    figures.push_back(posed_figure(task, candidate, generation));
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
