// SPDX-License-Identifier: MIT
#include "pictures_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>

#include "draw/strip_figure_canvas.hpp"
#include "dynamics/centre_of_mass.hpp"
#include "graph.hpp"
#include "kinematics/skeleton_motion.hpp"
#include "measures.hpp"
#include "recorded_curves.hpp"

namespace shigusa::bench {
namespace {

using strip::Align;
using strip::Canvas;
using strip::Colour;

constexpr double kWidth = 482.0;  // points, a page's
constexpr double kText = 7.5;
constexpr Colour kInk{0x222222};
constexpr Colour kPeople{0x8a949c};
constexpr Colour kPeopleBand{0xe9edf0};
constexpr std::array kMade{Colour{0xc8502d}, Colour{0x1f6f8b}, Colour{0x7a9a2e}};

constexpr const char* kBoxLifters = "two-handed box from the floor, squat asked for";
constexpr const char* kPickUp = "A: reach down one hand, pick up";

// Best-scored motion to a goal, with its picture.
struct Made {
  SkeletonMotion motion;
  Track track;
  std::vector<SidePoint> mass;  // (frames)

  [[nodiscard]] int last() const { return motion.clip.frames - 1; }
  [[nodiscard]] SidePoint joint(Joint joint, std::size_t frame) const {
    return from_the_side(track.joints[frame][joint]);
  }
  [[nodiscard]] SidePoint end(Joint joint) const {
    return from_the_side(track.joints.back()[joint]);
  }
  [[nodiscard]] double trunk() const { return degrees(trunk_lean(track.joints.back())); }
  [[nodiscard]] double knee() const { return degrees(mean_knee(track.joints.back())); }
};

class Maker {
 public:
  Maker() : body_(human_body()) {}

  Made one_hand(double aside, double up, double ahead) const {
    Task task(body_);
    task.goals = {{"right_hand", {-aside, up, ahead}}};
    return made(task);
  }
  Made both_hands(double up, double ahead, std::optional<double> duration = {}) const {
    constexpr double kHalfWidth = 0.165;  // m
    Task task(body_);
    task.goals = {{"right_hand", {-kHalfWidth, up, ahead}}, {"left_hand", {kHalfWidth, up, ahead}}};
    task.duration = duration;
    return made(task);
  }

 private:
  Made made(const Task& task) const {
    const GenerateResult generation = generate(task).value();
    const Clip& clip = generation.candidates.front().motion.clip;
    Made made{skeleton_motion(body_, clip), joints_track(body_, clip), {}};
    Kinematics<double> placed(body_);
    for (int f = 0; f < clip.frames; ++f) {
      forward_kinematics<double>(body_, clip.frame(f), placed);
      made.mass.push_back(from_the_side(centre_of_mass(body_, placed)));
    }
    return made;
  }

  PosedBody body_;
};

const RecordedCurve* find_curve(const std::vector<RecordedCurve>& curves, std::string_view reach) {
  const auto found = std::find_if(curves.begin(), curves.end(),
                                  [&](const RecordedCurve& curve) { return curve.reach == reach; });
  return found == curves.end() ? nullptr : &*found;
}

// A path in terms of its straight line: progress along it and forward deviation from it, relative
// to its length.
std::vector<GraphPoint> along_the_way(const std::vector<SidePoint>& path) {
  const double ahead = path.back().ahead - path.front().ahead;
  const double up = path.back().up - path.front().up;
  const double squared = ahead * ahead + up * up;
  const double forward = up < 0.0 ? -1.0 : 1.0;  // the way's normal looks ahead
  std::vector<GraphPoint> points;
  for (const SidePoint& point : path) {
    const double x = point.ahead - path.front().ahead;
    const double y = point.up - path.front().up;
    points.push_back({(x * ahead + y * up) / squared, forward * (x * up - y * ahead) / squared});
  }
  return points;
}

std::vector<SidePoint> wrist_path(const Made& made) {
  std::vector<SidePoint> path;
  for (const Joints& joints : made.track.joints) path.push_back(from_the_side(joints[right_wrist]));
  return path;
}

// A path of a hand with its name in the picture.
struct NamedMade {
  std::string name;
  Made made;
};

// A row of the picture of hands' paths: a figure that shows one of them, and a graph of all.
struct PathRow {
  const std::vector<NamedMade>& made;
  std::size_t shown;  // index of the one in the figure
  std::vector<std::pair<std::string, std::vector<GraphPoint>>> people;
  double band[2];  // people's range of the largest deviation from the straight line
  const char* band_name;
};

void draw_paths(Canvas& canvas, double top, const PathRow& row) {
  constexpr double kFigureScale = 82.0;  // points a metre
  constexpr double kHeight = 178.0;
  SideView view(canvas, {72.0, top + kHeight}, kFigureScale);
  const Made& shown = row.made[row.shown].made;
  view.floor(-0.55, 0.95);
  view.person(shown.motion, 0, kPaleColours);
  view.person(shown.motion, shown.last());
  view.line({shown.joint(right_wrist, 0), shown.end(right_wrist)}, kInk, 0.8, 3.0);
  view.line(wrist_path(shown), kMade[row.shown], 1.6);
  Graph graph(canvas, {{200.0, top + 24.0}, 162.0, kHeight - 44.0},
              {"share of the straight way", {0.0, 0.25, 0.5, 0.75, 1.0}},
              {"in front of the straight way / its length", {-0.2, -0.1, 0.0, 0.1, 0.2}});
  graph.band(row.band[0], row.band[1], kPeopleBand);
  graph.line({{0.0, 0.0}, {1.0, 0.0}}, kInk, 0.8, 3.0);
  for (const auto& [name, points] : row.people) graph.line(points, kPeople, 1.2);
  for (std::size_t i = 0; i < row.made.size(); ++i) {
    graph.line(along_the_way(wrist_path(row.made[i].made)), kMade[i], 1.6);
  }
  double y = top + 34.0;
  const auto legend = [&](const std::string& text, Colour colour) {
    canvas.text({374.0, y}, text, kText, colour, Align::left);
    y += 1.5 * kText;
  };
  for (std::size_t i = 0; i < row.made.size(); ++i) legend(row.made[i].name, kMade[i]);
  legend(row.band_name, kPeople);
  for (const auto& [name, points] : row.people) {
    const auto off = [](const GraphPoint& a, const GraphPoint& b) {
      return std::abs(a.y) < std::abs(b.y);
    };
    const GraphPoint most = *std::max_element(points.begin(), points.end(), off);
    graph.words({most.x, most.y + 0.012}, name.substr(0, 1), kPeople, Align::centre);
    legend(name, kPeople);
  }
}

std::string hand_paths(const Maker& maker, const std::vector<RecordedCurve>& curves) {
  std::vector<NamedMade> low;
  low.push_back({"floor, 30 cm ahead", maker.one_hand(0.15, 0.12, 0.30)});
  low.push_back({"25 cm high, 35 ahead", maker.one_hand(0.15, 0.25, 0.35)});
  low.push_back({"both hands, 20 high", maker.both_hands(0.20, 0.35)});
  std::vector<NamedMade> high;
  high.push_back({"shelf of 1.30 m", maker.one_hand(0.2, 1.30, 0.60)});
  high.push_back({"shelf of 1.55 m", maker.one_hand(0.2, 1.55, 0.58)});
  high.push_back({"shelf of 1.80 m", maker.one_hand(0.2, 1.80, 0.50)});
  const auto people = [&](std::initializer_list<std::pair<const char*, const char*>> named) {
    std::vector<std::pair<std::string, std::vector<GraphPoint>>> found;
    for (const auto& [reach, name] : named) {
      if (const RecordedCurve* curve = find_curve(curves, reach)) {
        found.emplace_back(name, along_the_way(curve->wrist));
      }
    }
    return found;
  };
  constexpr double kRow = 214.0;
  Canvas canvas(kWidth, 2.0 * kRow);
  draw_paths(canvas, 4.0,
             {low,
              1,
              people({{kBoxLifters, "7 men, a box"},
                      {kPickUp, "A, one hand"},
                      {"D: squat to the floor, both hands", "D, both hands"}}),
              {0.05, 0.17},
              "people: .05 to .17"});
  draw_paths(canvas, 4.0 + kRow,
             {high,
              1,
              people({{"F: press a button at chest height", "F, a button"},
                      {"D: reach up one hand (fruit)", "D, a fruit overhead"}}),
              {-0.07, -0.03},
              "people: -.07 to -.03"});
  return canvas.finish();
}

std::string heights(const Maker& maker) {
  constexpr std::array kHeights{5, 12, 19, 28, 38, 48, 57, 66, 76};  // cm
  constexpr double kScale = 82.0;
  constexpr double kFloor = 168.0;
  Canvas canvas(kWidth, 330.0);
  std::vector<GraphPoint> trunk, knee;
  for (std::size_t i = 0; i < kHeights.size(); ++i) {
    const Made made = maker.both_hands(0.01 * kHeights[i], 0.40);
    trunk.push_back({static_cast<double>(kHeights[i]), made.trunk()});
    knee.push_back({static_cast<double>(kHeights[i]), made.knee()});
    if (i % 2 != 0) continue;
    const double x = 46.0 + 48.0 * static_cast<double>(i);
    SideView view(canvas, {x, kFloor}, kScale);
    view.floor(-0.45, 0.55);
    view.person(made.motion, made.last());
    view.goal(made.end(right_grip));
    canvas.text({x, kFloor + 12.0}, fmt::format("{} cm", kHeights[i]), kText, kInk, Align::centre);
    canvas.text({x, kFloor + 22.0},
                fmt::format("trunk {:.0f}, knee {:.0f}", trunk.back().y, knee.back().y), kText,
                kInk, Align::centre);
  }
  Graph graph(canvas, {{46.0, 216.0}, 300.0, 82.0},
              {"height of the hands, cm", {0.0, 20.0, 40.0, 60.0, 80.0}},
              {"degrees at the end", {0.0, 30.0, 60.0, 90.0, 120.0}});
  graph.line(trunk, kMade[0], 1.6);
  graph.line(knee, kMade[1], 1.6);
  for (const GraphPoint& point : trunk) graph.dot(point, kMade[0]);
  for (const GraphPoint& point : knee) graph.dot(point, kMade[1]);
  canvas.text({356.0, 230.0}, "trunk, hips to shoulders", kText, kMade[0], Align::left);
  canvas.text({356.0, 242.0}, "knee", kText, kMade[1], Align::left);
  return canvas.finish();
}

std::string distances(const Maker& maker) {
  constexpr std::array kDistances{35, 50, 62};  // cm
  constexpr double kScale = 96.0;
  constexpr double kFloor = 190.0;
  constexpr double kFoot = 0.26;  // m
  Canvas canvas(kWidth, 232.0);
  for (std::size_t i = 0; i < kDistances.size(); ++i) {
    const Made made = maker.one_hand(0.1, 0.26, 0.01 * kDistances[i]);
    const double x = 62.0 + 160.0 * static_cast<double>(i);
    SideView view(canvas, {x, kFloor}, kScale);
    view.floor(-0.5, 0.8);
    view.person(made.motion, 0, kPaleColours);
    view.person(made.motion, made.last());
    view.goal(made.end(right_grip));
    const auto plumb = [&](const SidePoint& mass, Colour colour, double dash) {
      view.line({mass, {mass.ahead, -0.03}}, colour, 1.0, dash);
      canvas.quartered({view.at(mass), 3.5}, colour);
    };
    plumb(made.mass.front(), kPeople, 2.0);
    plumb(made.mass.back(), kInk, 0.0);
    const double back = made.joint(right_hip, 0).ahead - made.end(right_hip).ahead;
    const double forward = made.mass.back().ahead - made.mass.front().ahead;
    canvas.text({x + 10.0, kFloor + 16.0}, fmt::format("{} cm ahead", kDistances[i]), kText, kInk,
                Align::centre);
    canvas.text({x + 10.0, kFloor + 27.0},
                fmt::format("hips back {:.0f} cm, mass forward {:.0f} %", 100.0 * back,
                            100.0 * forward / kFoot),
                kText, kInk, Align::centre);
  }
  return canvas.finish();
}

// Completed share of a quantity's total change.
std::vector<GraphPoint> shares(const std::vector<double>& time, const std::vector<double>& values) {
  std::vector<GraphPoint> points;
  const double whole = values.back() - values.front();
  for (std::size_t i = 0; i < time.size(); ++i) {
    points.push_back({time[i], (values[i] - values.front()) / whole});
  }
  return points;
}

Result<std::string> timing(const Maker& maker, const std::vector<RecordedCurve>& curves) {
  const RecordedCurve* men = find_curve(curves, kBoxLifters);
  if (men == nullptr) return fail(ErrorCode::parse, "has no box lifters", "curves.tsv");
  const SidePoint goal = men->wrist.back();
  const Made made = maker.both_hands(goal.up, goal.ahead + 0.05, men->duration);
  std::vector<double> time;
  std::array<std::vector<double>, 3> ours;
  for (std::size_t f = 0; f < made.track.joints.size(); ++f) {
    const Joints& joints = made.track.joints[f];
    time.push_back(static_cast<double>(f) / static_cast<double>(made.last()));
    ours[0].push_back(trunk_lean(joints));
    ours[1].push_back(mean_knee(joints));
    ours[2].push_back(joints[right_wrist].y);
  }
  std::vector<double> height;
  for (const SidePoint& wrist : men->wrist) height.push_back(wrist.up);
  const std::array<std::vector<double>, 3> theirs{men->trunk, men->knee, height};
  constexpr std::array kNames{"trunk", "knee", "height of the hands"};
  Canvas canvas(kWidth, 160.0);
  for (std::size_t q = 0; q < kNames.size(); ++q) {
    Graph graph(canvas, {{34.0 + 154.0 * static_cast<double>(q), 26.0}, 120.0, 96.0},
                {"share of the time", {0.0, 0.25, 0.5, 0.75, 1.0}},
                {std::string(kNames[q]) + ", share of change", {0.0, 0.25, 0.5, 0.75, 1.0}});
    graph.line(shares(men->time, theirs[q]), kPeople, 2.2);
    graph.line(shares(time, ours[q]), kMade[q], 1.6);
  }
  return canvas.finish();
}

// The recorded man's reach from standing, and the best-scored one to the same place.
Result<std::string> low_reach(const std::filesystem::path& folder,
                              std::vector<NamedPicture>& pictures) {
  SHG_TRY_ASSIGN(const auto segments, downward_segments(folder / "manifest.tsv"));
  SHG_TRY_ASSIGN(const Recorded reach, read_reach(folder / "cmu_02_06_60hz.bvh", segments.front()));
  Task task = reach.task();
  task.candidates = 8;
  SHG_TRY_ASSIGN(const GenerateResult generation, generate(task));
  const Track made = track_of(reach, generation.candidates.front().motion.clip);
  SHG_TRY_ASSIGN(std::string recorded_svg, side_strip(reach, reach.track));
  SHG_TRY_ASSIGN(std::string made_svg, side_strip(reach, made));
  pictures.push_back({"low-reach-recorded", std::move(recorded_svg)});
  pictures.push_back({"low-reach-best-scored", std::move(made_svg)});
  const auto words = [](const Track& track) {
    const Looks looks = looks_of(track);
    return fmt::format("trunk {:.0f}°, knee {:.0f}°, pelvis {:.0f} cm lower and {:.0f} back",
                       degrees(looks.trunk), degrees(looks.knee), 100.0 * looks.drop,
                       100.0 * looks.back);
  };
  return fmt::format(
      "A low reach from standing in {:.2f} s, by the recorded man (*{}*; the body that is fitted "
      "to "
      "him): {}.\n\n![the recorded man](images/people/low-reach-recorded.svg)\n\nThe best-scored "
      "motion to the same place in the same time: {}.\n\n![the best-scored "
      "motion](images/people/low-reach-best-scored.svg)\n",
      reach.track.duration(), reach.segment.name, words(reach.track), words(made));
}

}  // namespace

Result<Drawn> pictures_section(const std::filesystem::path& shared) {
  Drawn drawn;
  SHG_TRY_ASSIGN(const std::string low, low_reach(shared / "reach", drawn.pictures));
  SHG_TRY_ASSIGN(const auto curves, read_recorded_curves(shared / "people" / "curves.tsv"));
  const Maker maker;
  SHG_TRY_ASSIGN(std::string clocks, timing(maker, curves));
  drawn.pictures.push_back({"hand-paths", hand_paths(maker, curves)});
  drawn.pictures.push_back({"heights", heights(maker)});
  drawn.pictures.push_back({"distances", distances(maker)});
  drawn.pictures.push_back({"timing", std::move(clocks)});
  drawn.text =
      "## What it looks like\n\nSeen from the right; best-scored motions of the default preset, "
      "seed 0; in grey what was recorded of people (`../shared/people/curves.tsv`) and the posture "
      "at the start.\n\n" +
      low +
      "\nPaths of the wrist beside the straight way (dashed): low reaches bow forwards (B38), "
      "those "
      "to a shelf back (A2). The bands are where people's paths are farthest from it.\n\n"
      "![paths of the wrist](images/people/hand-paths.svg)\n"
      "\nBoth hands 40 cm ahead: the lower they go the more both the trunk and the knees bend "
      "(B11), in the same proportion (B15).\n\n![postures by "
      "height](images/people/heights.svg)\n"
      "\nOne hand 26 cm high, at three distances: the farther, the less the hips go back (B2) and "
      "the more the mass forwards (B1, B3). The quartered disc is the centre of mass at the start "
      "(grey) and at the end, with its plumb line; shares are of the foot's length.\n\n"
      "![postures by distance](images/people/distances.svg)\n"
      "\nWhen trunk, knees and hands do their part: seven men who lower themselves to a box "
      "(grey), "
      "and a motion to the same place in the same time.\n\n![shares of the change over "
      "time](images/people/timing.svg)\n";
  return drawn;
}

}  // namespace shigusa::bench
