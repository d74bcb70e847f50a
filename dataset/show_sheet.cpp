// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>

#include "formats/xml.hpp"
#include "show_page.hpp"
#include "show_plot.hpp"

namespace shigusa {
namespace {

// View from the side of the moving hand, slightly ahead of the body.
constexpr double kAzimuth = radians(62.0);  // from straight ahead
constexpr double kMargin = 12.0;            // cm, about all figures
constexpr double kFloorRoom = 8.0;          // cm, below the floor
constexpr std::size_t kPathStep = 2;        // frames between the points of a path that is drawn

// Node of an effector.
int node_of(const NodePlaces& places, const std::string& effector) {
  const int grip = places.find(effector + "_grip");
  return grip >= 0 ? grip : places.find(effector);
}

// Class of a bone by the node at its distal end: "trunk", "arm" or "leg".
std::string_view part_of(std::string_view node) {
  constexpr std::array<std::string_view, 3> kParts{"trunk", "arm", "leg"};
  return kParts[static_cast<std::size_t>(parse_joint_name(node).limb)];
}

bool is_left(std::string_view name) { return parse_joint_name(name).side == Side::left; }

void add_line(const FigureView& view, const Vec3d& from, const Vec3d& to, std::string& path) {
  path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", view.x(from), view.y(from), view.x(to),
                      view.y(to));
}

// Bones from an effector to the beginning of its limb.
std::string limb_path(const NodePlaces& places, std::size_t frame, const FigureView& view,
                      const std::string& effector) {
  std::string path;
  const Side side = is_left(effector) ? Side::left : Side::right;
  for (int n = node_of(places, effector); n >= 0;) {
    const int parent = places.parents[static_cast<std::size_t>(n)];
    if (parent < 0) break;
    if (parse_joint_name(places.names[static_cast<std::size_t>(parent)]).side != side) break;
    add_line(view, places.at(frame, parent), places.at(frame, n), path);
    n = parent;
  }
  return path;
}

FigureView view_of(const SheetMotion& motion) {
  const bool left = !motion.effectors.empty() && is_left(motion.effectors.front());
  const SinCos<double> turn = sin_cos(kAzimuth);
  return {.right = {turn.cos, 0.0, left ? -turn.sin : turn.sin}};
}

// Bounds (cm) of a motion in its picture. All pictures of the sheet have the size of the largest,
// and thus one scale.
struct Span {
  double left = 1e9;
  double right = -1e9;
  double top = 1e9;

  void add(const FigureView& view, const Vec3d& point) {
    if (!is_finite(point.x + point.y + point.z)) return;
    left = min(left, view.x(point));
    right = max(right, view.x(point));
    top = min(top, view.y(point));
  }
};

Span span_of(const SheetMotion& motion) {
  Span span;
  const FigureView view = view_of(motion);
  for (const Vec3d& place : motion.places.places) span.add(view, place);
  for (const Vec3d& goal : motion.goals) span.add(view, goal);
  return span;
}

struct PictureSize {
  double width = 0.0;   // cm
  double height = 0.0;  // cm, above the floor
};

PictureSize size_of(const std::vector<SheetMotion>& motions) {
  PictureSize size;
  for (const SheetMotion& motion : motions) {
    const Span span = span_of(motion);
    size.width = max(size.width, span.right - span.left + 2.0 * kMargin);
    size.height = max(size.height, kMargin - span.top);
  }
  return size;
}

// Edges of the boxes.
std::string obstacles_svg(const SheetMotion& motion, const FigureView& view) {
  std::string path;
  for (const ShownBox& box : motion.obstacles) {
    const Mat3d turn = to_matrix(box.turn);
    const auto corner = [&](int k) {
      const Vec3d own{(k & 1 ? 0.5 : -0.5) * box.size.x, (k & 2 ? 0.5 : -0.5) * box.size.y,
                      (k & 4 ? 0.5 : -0.5) * box.size.z};
      return box.middle + turn * own;
    };
    for (int k = 0; k < 8; ++k) {
      for (const int side : {1, 2, 4}) {
        if ((k & side) == 0) add_line(view, corner(k), corner(k | side), path);
      }
    }
  }
  return path.empty() ? "" : fmt::format(R"(<path class="obstacle" d="{}"/>)", path);
}

// Path of an effector, and a ringed cross at its goal.
std::string path_svg(const SheetMotion& motion, const FigureView& view) {
  std::string svg;
  for (std::size_t g = 0; g < motion.goals.size(); ++g) {
    const int node = node_of(motion.places, motion.effectors[g]);
    std::string path;
    for (std::size_t f = 0; node >= 0 && f < motion.places.frames(); f += kPathStep) {
      const Vec3d& place = motion.places.at(f, node);
      path +=
          fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", view.x(place), view.y(place));
    }
    if (!path.empty()) svg += fmt::format(R"(<path class="way" d="{}"/>)", path);
    const double x = view.x(motion.goals[g]);
    const double y = view.y(motion.goals[g]);
    svg += fmt::format(
        R"(<circle class="goal" cx="{0:.1f}" cy="{1:.1f}" r="5"/><path class="goal" d="M{2:.1f} {1:.1f}h18M{0:.1f} {3:.1f}v18"/>)",
        x, y, x - 9.0, y - 9.0);
  }
  return svg;
}

std::string picture(const SheetMotion& motion, const PictureSize& size) {
  const FigureView view = view_of(motion);
  const Span span = span_of(motion);
  const double left = 0.5 * (span.left + span.right - size.width);
  const std::size_t last = motion.places.frames() - 1;
  std::string body =
      fmt::format(R"(<path class="floor" d="M{:.0f} 0H{:.0f}"/>)", left, left + size.width);
  if (motion.seat) {
    const int hips = motion.places.find("hips");
    const double x = hips < 0 ? 0.0 : view.x(motion.places.at(last, hips));
    body += fmt::format(R"(<path class="seat" d="M{:.1f} {:.1f}h36M{:.1f} {:.1f}V0"/>)", x - 18.0,
                        -100.0 * *motion.seat, x, -100.0 * *motion.seat);
  }
  body += obstacles_svg(motion, view);
  body += figure_svg(motion.places, 0, view, "start");
  body += figure_svg(motion.places, last / 2, view, "middle");
  body += figure_svg(motion.places, last, view, "ending");
  for (const std::string& effector : motion.effectors) {
    const std::string limb = limb_path(motion.places, last, view, effector);
    if (!limb.empty()) {
      body += fmt::format(R"(<path class="{} moving" d="{}"/>)", part_of(effector), limb);
    }
  }
  body += path_svg(motion, view);
  return fmt::format(
      R"(<svg viewBox="{:.0f} {:.0f} {:.0f} {:.0f}" role="img" aria-label="motion {}: {}">{}</svg>)",
      left, -size.height, size.width, size.height + kFloorRoom, motion.id,
      xml_escaped(motion.words), body);
}

std::string card(const SheetMotion& motion, const PictureSize& size) {
  constexpr auto kSigns = [](std::string_view verdict) {
    return verdict == "possible" ? "\u25CF" : verdict == "strains" ? "\u25B2" : "\u2715";
  };
  return fmt::format(
      "<li>{}\n<p class=\"words\">{}</p>\n<p class=\"judged\"><span class=\"verdict {}\">{} "
      "{}</span> <span>score\u00a0{:.2f}</span></p>\n<p>{}</p>\n<p>{}</p>\n<p "
      "class=\"id\">motion {}</p></li>\n",
      picture(motion, size), xml_escaped(motion.words), xml_escaped(motion.verdict),
      kSigns(motion.verdict), xml_escaped(motion.verdict), motion.score, xml_escaped(motion.goal),
      xml_escaped(motion.person), motion.id);
}

std::string person_words(const Row& task) {
  const std::string who = task.text("character");
  const auto file = format_of_file(who);
  const bool robot = file && info_of(*file).robot;
  const std::string size = fmt::format("{:.2f}\u00a0m, {:.0f}\u00a0kg", task.number("stature_m"),
                                       task.number("mass_kg"));
  if (robot) return who + ", " + size;
  const std::string person = task.text("sex") + ", " + size;
  return who == "human" ? person : who + ", " + person;
}

std::string goal_words(const std::vector<Row>& goals) {
  std::string words;
  for (const Row& goal : goals) {
    std::string effector = goal.text("effector");
    std::replace(effector.begin(), effector.end(), '_', ' ');
    words += fmt::format("{}{} to {:.2f}\u00a0m", words.empty() ? "" : "; ", effector,
                         goal.number("position_m", 1));
    const double load = goal.number("load_kg");
    if (load > 0.0) words += fmt::format(", {:.1f}\u00a0kg", load);
  }
  return words;
}

Result<SheetMotion> sheet_motion(const Poses& poses, const DataMotion& motion) {
  SHG_TRY_ASSIGN(NodePlaces places, poses.places(motion));
  SheetMotion sheet{.id = motion.id(),
                    .words = motion.motion.text("words"),
                    .verdict = motion.motion.text("verdict"),
                    .person = person_words(motion.task),
                    .goal = goal_words(motion.goals),
                    .score = motion.motion.number("score"),
                    .places = std::move(places),
                    .goals = {},
                    .effectors = {},
                    .obstacles = {}};
  for (const Row& goal : motion.goals) {
    sheet.goals.push_back(goal.point("position_m"));
    sheet.effectors.push_back(goal.text("effector"));
  }
  for (const Row& box : motion.obstacles) {
    const std::vector<double> q = box.numbers("rotation_xyzw");
    sheet.obstacles.push_back(
        {box.point("position_m"), box.point("size_m"), {q[0], q[1], q[2], q[3]}});
  }
  const double seat = motion.task.number("seat_m");
  if (is_finite(seat)) sheet.seat = seat;
  return sheet;
}

}  // namespace

std::string figure_svg(const NodePlaces& places, std::size_t frame, const FigureView& view,
                       std::string_view style) {
  std::map<std::string_view, std::string> paths;
  for (std::size_t n = 0; n < places.names.size(); ++n) {
    const int parent = places.parents[n];
    const std::string& name = places.names[n];
    if (parent < 0 || name == "head_end") continue;
    add_line(view, places.at(frame, parent), places.at(frame, static_cast<int>(n)),
             paths[part_of(name)]);
  }
  std::string svg;
  for (const std::string_view part : {"leg", "trunk", "arm"}) {
    if (!paths[part].empty()) {
      svg += fmt::format(R"(<path class="{}" d="{}"/>)", part, paths[part]);
    }
  }
  const int head = places.find("head");
  const int top = places.find("head_end");
  if (head >= 0 && top >= 0) {
    const Vec3d& low = places.at(frame, head);
    const Vec3d& high = places.at(frame, top);
    const Vec3d middle = low + 0.45 * (high - low);
    svg += fmt::format(R"(<circle class="head" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)",
                       view.x(middle), view.y(middle), 55.0 * norm(high - low));
  }
  return fmt::format(R"(<g class="body {}">{}</g>)", style, svg);
}

Result<std::vector<SheetMotion>> read_sheet(const DataFolder& data,
                                            const std::vector<ChosenMotion>& chosen) {
  const Poses poses(data.plan);
  // by shard, so that each is read once
  std::map<std::uint64_t, std::vector<std::size_t>> by_shard;
  for (std::size_t k = 0; k < chosen.size(); ++k) by_shard[chosen[k].shard].push_back(k);
  std::vector<std::optional<SheetMotion>> made(chosen.size());
  for (const auto& [shard, places] : by_shard) {
    SHG_TRY_ASSIGN(const ShardRows rows, read_rows(data, shard, poses.series_for_places()));
    for (const std::size_t k : places) {
      const auto motion =
          std::find_if(rows.motions.begin(), rows.motions.end(), [&](const DataMotion& one) {
            return one.number() == chosen[k].task && one.rank() == chosen[k].rank;
          });
      if (motion == rows.motions.end()) continue;
      SHG_TRY_ASSIGN(made[k], sheet_motion(poses, *motion));
    }
  }
  std::vector<SheetMotion> sheet;
  for (std::optional<SheetMotion>& motion : made) {
    if (motion) sheet.push_back(*std::move(motion));
  }
  return sheet;
}

std::string sheet_html(const std::vector<SheetMotion>& motions) {
  if (motions.empty()) return "<p>No motion is drawn.</p>\n";
  const PictureSize size = size_of(motions);
  std::string cards;
  for (const SheetMotion& motion : motions) cards += card(motion, size);
  return "<ul class=\"sheet\">\n" + cards + "</ul>\n";
}

}  // namespace shigusa
