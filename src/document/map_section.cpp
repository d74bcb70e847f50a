// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/files.hpp>
#include <shigusa/kinematics.hpp>

#include "core/say.hpp"
#include "map_colour.hpp"

namespace shigusa {
namespace {

using strip::Align;
using strip::Canvas;
using strip::Disc;
using strip::Point;

constexpr double kPage = 380.0;     // points, the longer side of the section
constexpr double kMargin = 34.0;    // points, for the numbers of the axes
constexpr double kLegend = 46.0;    // points, below
constexpr double kLetter = 8.0;     // points
constexpr double kTick = 0.5;       // m
constexpr double kDotShare = 0.38;  // of the spacing
constexpr Colour kInk{0x333333};
constexpr Colour kBody{0xDDE3EA};
constexpr Colour kLine{0x999999};

// Horizontal and vertical axis of a section, seen from the person's right, from above with ahead
// up, or from behind.
struct View {
  Axis across;
  double right;  // +1 or -1: direction of the axis that points to the right
  Axis up;
};
constexpr std::array kViews{View{Axis::z, 1.0, Axis::y}, View{Axis::x, -1.0, Axis::z},
                            View{Axis::x, -1.0, Axis::y}};

class Section {
 public:
  Section(const ReachMap& map, const View& view)
      : map_(map),
        view_(view),
        across_(range(view.across)),
        up_(range(view.up)),
        scale_(kPage / max(across_.second - across_.first, up_.second - up_.first)),
        canvas_(2.0 * kMargin + scale_ * (across_.second - across_.first),
                kMargin + kLegend + scale_ * (up_.second - up_.first)) {}

  [[nodiscard]] Point at(const Vec3d& place) const {
    const double x = place[static_cast<int>(view_.across)];
    const double from_left = view_.right > 0.0 ? x - across_.first : across_.second - x;
    return {kMargin + scale_ * from_left,
            0.5 * kMargin + scale_ * (up_.second - place[static_cast<int>(view_.up)])};
  }
  void draw_body(const PosedBody& body) {
    const Posture posture(body.body, body.home.angles);
    for (const Capsule& capsule : body.body.capsules()) {
      const Transformd link = posture.place(capsule.link);
      const std::array discs{Disc{at(link * capsule.from), scale_ * capsule.radius},
                             Disc{at(link * capsule.to), scale_ * capsule.to_radius}};
      canvas_.hull(discs, kBody);
    }
  }
  void draw_places(Axis axis, int plane) {
    for (std::size_t k = 0; k < map_.places.size(); ++k) {
      const Vec3d place = map_.position(k);
      const int a = static_cast<int>(axis);
      if (place[a] != map_.coordinate(axis, plane) || !map_.places[k].verdict) continue;
      const std::array disc{Disc{at(place), kDotShare * scale_ * map_.spacing}};
      canvas_.hull(disc, colour_of(map_.places[k]));
    }
  }
  void draw_axes() {
    const auto corner = [this](double across, double up) {
      Vec3d place{};
      place[static_cast<int>(view_.across)] = across;
      place[static_cast<int>(view_.up)] = up;
      return at(place);
    };
    const auto ticks = [](const Range& range, const auto& mark) {
      for (double k = range.first / kTick; k <= range.second / kTick + 1.0; k += 1.0) {
        const double x = kTick * nearest_integer(k);
        if (x >= range.first && x <= range.second) mark(x);
      }
    };
    const double edge = view_.right > 0.0 ? across_.first : across_.second;
    const Point low = corner(edge, up_.first);
    ticks(across_, [&](double x) {
      const Point p = corner(x, up_.first);
      const std::array line{p, Point{p.x, p.y + 3.0}};
      canvas_.line(line, kLine, 0.7);
      canvas_.text({p.x, p.y + 12.0}, fmt::format("{:g}", x), kLetter, kInk, Align::centre);
    });
    ticks(up_, [&](double y) {
      const Point p = corner(edge, y);
      const std::array line{p, Point{p.x - 3.0, p.y}};
      canvas_.line(line, kLine, 0.7);
      canvas_.text({p.x - 5.0, p.y + 3.0}, fmt::format("{:g}", y), kLetter, kInk, Align::right);
    });
    const std::array frame{corner(edge, up_.second), low,
                           corner(across_.first + across_.second - edge, up_.first)};
    canvas_.line(frame, kLine, 0.7);
  }
  void draw_legend(const std::string& title) {
    const double top = 0.5 * kMargin + scale_ * (up_.second - up_.first) + 28.0;
    canvas_.text({kMargin, top}, title, kLetter, kInk, Align::left);
    double x = kMargin;
    const auto entry = [&](const MapPlace& place, const std::string& word) {
      const std::array disc{Disc{{x + 4.0, top + 11.0}, 3.5}};
      canvas_.hull(disc, colour_of(place));
      canvas_.text({x + 11.0, top + 14.0}, word, kLetter, kInk, Align::left);
      x += 22.0 + strip::text_width(word, kLetter);
    };
    for (const double score : {0.1, 0.5, 2.0}) {
      entry({.verdict = Verdict::possible, .score = score}, fmt::format("score {:g}", score));
    }
    entry({.verdict = Verdict::strains}, "strains");
    entry({.verdict = Verdict::impossible}, "impossible");
  }
  [[nodiscard]] std::string finish() { return canvas_.finish(); }

 private:
  using Range = std::pair<double, double>;

  // Range of an axis, with half a spacing beyond the places.
  [[nodiscard]] Range range(Axis axis) const {
    const int last = map_.count[static_cast<std::size_t>(axis)] - 1;
    return {map_.coordinate(axis, 0) - 0.5 * map_.spacing,
            map_.coordinate(axis, last) + 0.5 * map_.spacing};
  }

  const ReachMap& map_;
  const View& view_;
  Range across_;
  Range up_;
  double scale_;  // points per metre
  Canvas canvas_;
};

}  // namespace

Result<std::string> map_section(const PosedBody& body, const ReachMap& map, Axis axis, double at) {
  const auto plane = map.plane(axis, at);
  const auto a = static_cast<std::size_t>(axis);
  if (!plane) {
    return fail(ErrorCode::invalid_argument,
                say("no_section", "xyz"[a], at, map.coordinate(axis, 0),
                    map.coordinate(axis, map.count[a] - 1)));
  }
  Section section(map, kViews[a]);
  section.draw_body(body);
  section.draw_places(axis, *plane);
  section.draw_axes();
  section.draw_legend(fmt::format("{} at {} = {:g} m; numbers are metres", map.effector, "xyz"[a],
                                  map.coordinate(axis, *plane)));
  return section.finish();
}

}  // namespace shigusa
