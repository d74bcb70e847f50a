// SPDX-License-Identifier: MIT
#include "strip_figure_painter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/math.hpp>

namespace shigusa::strip {
namespace {

// Colours. Tones differ in lightness alone, so that a grey print keeps them: the acting limb is the
// darkest, the near side darker than the far one.
constexpr Colour kAccent{0xa32b19};
constexpr Colour kNear{0x607387};
constexpr Colour kTrunk{0x8b99a6};
constexpr Colour kFar{0xb7c1ca};
constexpr Colour kJoint{0xffffff};
constexpr Colour kGoal{0x0b5c66};
constexpr Colour kPath{0xc9705f};
constexpr Colour kMass{0x1d242b};
constexpr Colour kPlumb{0x4d5965};
constexpr Colour kFloor{0x98a2ab};
constexpr Colour kSole{0xe4e8eb};
constexpr Colour kThing{0xf1ebdd};
constexpr Colour kThingEdge{0xb5a684};
constexpr Colour kMovingThing{0xe3cfa2};
constexpr Colour kMovingEdge{0x7d6a3f};
constexpr Colour kInk{0x2f3942};

// Width of the white rim (points) that separates crossing limbs; thin pieces have less of it.
constexpr double kRim = 0.7;
constexpr double kRimShare = 0.4;     // share of the piece's thickest radius
constexpr double kJointShare = 0.35;  // size of a joint's mark, share of the limb's thickness
constexpr double kThinnest = 0.3;
constexpr double kEdge = 0.5;
constexpr double kMassRadius = 2.6;
constexpr double kGoalRadius = 3.2;

// Largest of 1, 2, 5, 10, 20, … times 10^-20 that is not above `length`.
double round_length(double length) {
  double result = 1e-20;
  for (double decade = result; decade <= length; decade *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (digit * decade <= length) result = digit * decade;
    }
  }
  return result;
}

// Draws a goal's ringed cross.
void draw_goal(Canvas& canvas, Point at) {
  canvas.ring({at, kGoalRadius}, {0xffffff}, 2.2);
  canvas.ring({at, kGoalRadius}, kGoal, 0.9);
  const double arm = 1.7 * kGoalRadius;
  const Point level[] = {{at.x - arm, at.y}, {at.x + arm, at.y}};
  const Point plumb[] = {{at.x, at.y - arm}, {at.x, at.y + arm}};
  canvas.line(level, kGoal, 0.9);
  canvas.line(plumb, kGoal, 0.9);
}

void draw_mass(Canvas& canvas, Point at) { canvas.quartered({at, kMassRadius}, kMass); }

// Painter of one strip of a page.
class Painter {
 public:
  Painter(Canvas& canvas, const PlacedStrip& placed, double width)
      : canvas_(canvas),
        strip_(placed.strip),
        settings_(*placed.settings),
        width_(width),
        floor_(placed.floor) {}

  void floor();
  void slot(const Slot& slot);
  void time_labels(double base, double frame_time);
  void action_names(const std::vector<ActionLabel>& labels, double base);

 private:
  [[nodiscard]] Point page(const Slot& slot, Point p) const {
    return {slot.x + strip_.scale * p.x, floor_ - strip_.scale * p.y};
  }
  [[nodiscard]] std::vector<Disc> page(const Slot& slot, const std::vector<Disc>& discs) const;
  [[nodiscard]] Colour colour(const Shape& shape, double share) const;
  void things(const Slot& slot);
  void thing(const Slot& slot, const SeenThing& thing);
  void edges(const Slot& slot, const SeenThing& thing);
  void arrow(Point at, Point away);

  Canvas& canvas_;
  const Strip& strip_;
  const StripSettings& settings_;
  double width_;
  double floor_;
};

std::vector<Disc> Painter::page(const Slot& slot, const std::vector<Disc>& discs) const {
  std::vector<Disc> result;
  for (const Disc& disc : discs) {
    result.push_back({page(slot, disc.centre), max(strip_.scale * disc.radius, kThinnest)});
  }
  return result;
}

void Painter::floor() {
  for (const Slot& slot : strip_.slots) canvas_.hull(page(slot, slot.soles), kSole);
  const Point ends[] = {{kMargin, floor_}, {width_ - kMargin, floor_}};
  canvas_.line(ends, kFloor, 0.6);
  for (const Slot& slot : strip_.slots) {
    const Point tick[] = {{slot.x, floor_}, {slot.x, floor_ + kTick}};
    canvas_.line(tick, kFloor, 0.6);
  }
}

// `share` is the shape's place in the order from far (0) to near (1).
Colour Painter::colour(const Shape& shape, double share) const {
  const bool left_is_near = settings_.azimuth_deg < 0.0;
  switch (shape.tone) {
    case Tone::accent:
      return kAccent;
    case Tone::middle:
      return kTrunk;
    case Tone::left:
      return left_is_near ? kNear : kFar;
    case Tone::right:
      return left_is_near ? kFar : kNear;
    default:
      break;
  }
  Colour mixed;
  for (const int shift : {16, 8, 0}) {
    const double far = (kFar.rgb >> shift) & 0xff;
    const double near = (kNear.rgb >> shift) & 0xff;
    mixed.rgb |= static_cast<std::uint32_t>(far + (near - far) * share + 0.5) << shift;
  }
  return mixed;
}

// Paints things that stay: all of them behind the figure, and the edges of near ones once more in
// front of it.
void Painter::things(const Slot& slot) {
  for (const SeenThing& each : slot.things) {
    if (!each.moves) thing(slot, each);
  }
}

void Painter::thing(const Slot& slot, const SeenThing& thing) {
  std::vector<Disc> corners;
  for (const Point& p : thing.face) corners.push_back({page(slot, p), kThinnest});
  canvas_.hull(corners, thing.moves ? kMovingThing : kThing);
  edges(slot, thing);
}

void Painter::edges(const Slot& slot, const SeenThing& thing) {
  for (const Segment& edge : thing.edges) {
    const Point ends[] = {page(slot, edge[0]), page(slot, edge[1])};
    canvas_.line(ends, thing.moves ? kMovingEdge : kThingEdge, kEdge);
  }
}

void Painter::slot(const Slot& slot) {
  things(slot);
  const double last = static_cast<double>(std::max<std::size_t>(slot.shapes.size() - 1, 1));
  std::vector<const SeenThing*> moving;  // those not painted yet, the nearest first
  for (const SeenThing& each : slot.things) {
    if (each.moves) moving.push_back(&each);
  }
  std::stable_sort(moving.begin(), moving.end(),
                   [](const SeenThing* a, const SeenThing* b) { return a->depth > b->depth; });
  const auto paint_before = [&](double depth) {
    for (; !moving.empty() && moving.back()->depth < depth; moving.pop_back()) {
      thing(slot, *moving.back());
    }
  };
  for (std::size_t i = 0; i < slot.shapes.size(); ++i) {
    const Shape& shape = slot.shapes[i];
    paint_before(shape.depth);
    const std::vector<Disc> discs = page(slot, shape.discs);
    double thickest = 0.0;
    for (const Disc& disc : discs) thickest = max(thickest, disc.radius);
    canvas_.hull(discs, colour(shape, static_cast<double>(i) / last),
                 min(kRim, kRimShare * thickest));
    for (std::size_t j = 0; j < static_cast<std::size_t>(shape.joints); ++j) {
      const Disc dot{discs[j].centre, kJointShare * discs[j].radius};
      canvas_.hull(std::span(&dot, 1), kJoint);
    }
  }
  paint_before(kFarthest * kFarthest);
  for (const SeenThing& thing : slot.things) {
    if (thing.near) edges(slot, thing);
  }
  for (const std::vector<Point>& piece : slot.path) {
    std::vector<Point> points;
    for (const Point& p : piece) points.push_back(page(slot, p));
    canvas_.line(points, kPath, 0.7);
  }
  if (!slot.mass.empty()) {
    const Point plumb[] = {page(slot, slot.mass[0]), page(slot, slot.mass[1])};
    canvas_.line(plumb, kPlumb, 0.5, 1.8);
    const Disc foot{plumb[1], 0.9};
    canvas_.hull(std::span(&foot, 1), kPlumb);
    draw_mass(canvas_, plumb[0]);
  }
  for (const GoalMark& mark : slot.goals) {
    if (mark.arrow) {
      arrow(page(slot, mark.at), {mark.away.x, -mark.away.y});
    } else {
      draw_goal(canvas_, page(slot, mark.at));
    }
  }
}

// Mark of a goal beyond the slot: its ring, and an arrow towards it.
void Painter::arrow(Point at, Point away) {
  canvas_.ring({at, kGoalRadius}, kGoal, 0.9);
  const auto point = [&](double ahead, double aside) {
    return Point{at.x + kGoalRadius * (ahead * away.x - aside * away.y),
                 at.y + kGoalRadius * (ahead * away.y + aside * away.x)};
  };
  const Point shaft[] = {point(1.0, 0.0), point(2.8, 0.0)};
  const Point head[] = {point(2.0, 0.7), point(2.8, 0.0), point(2.0, -0.7)};
  canvas_.line(shaft, kGoal, 0.9);
  canvas_.line(head, kGoal, 0.9);
}

void Painter::action_names(const std::vector<ActionLabel>& labels, double base) {
  for (const ActionLabel& label : labels) {
    canvas_.text({label.x, base + label.row * kLine * kText}, std::string(label.name), kText, kGoal,
                 Align::centre);
  }
}

// Times of the poses; every second, third, … where labels are wider than the steps.
void Painter::time_labels(double base, double frame_time) {
  const int first = strip_.slots.front().frame;
  const int last = strip_.slots.back().frame;
  const int digits = (last - first) * frame_time < 0.1 && last > first ? 3 : 2;
  const auto label = [&](const Slot& slot) {
    return fmt::format("{:.{}f} s", (slot.frame - first) * frame_time, digits);
  };
  const double room = 1.15 * text_width(label(strip_.slots.back()), kText);
  std::size_t every = 1;
  while (static_cast<double>(every) * strip_.spacing < room && every < strip_.slots.size()) ++every;
  for (std::size_t i = 0; i < strip_.slots.size(); i += every) {
    const std::string text = label(strip_.slots[i]);
    const double half = 0.5 * text_width(text, kText);
    const double x = clamp(strip_.slots[i].x, kMargin + half, width_ - kMargin - half);
    canvas_.text({x, base}, text, kText, kInk, Align::centre);
  }
}

}  // namespace

void paint_strip(Canvas& canvas, const PlacedStrip& placed, double width) {
  Painter painter(canvas, placed, width);
  painter.floor();
  for (const Slot& slot : placed.strip.slots) painter.slot(slot);
  painter.time_labels(placed.times, placed.motion->clip.frame_time);
  painter.action_names(placed.labels, placed.times + kLine * kText);
  double base = placed.caption_above;
  for (const std::string& line : placed.caption) {
    base += kLine * kCaptionText;
    canvas.text({kMargin, base}, line, kCaptionText, kInk, Align::left);
  }
}

void paint_legend(Canvas& canvas, const std::vector<PlacedStrip>& strips, double base) {
  double x = kMargin;
  const double middle = base - 0.36 * kText;
  const auto any = [&](auto StripOverlay::*marks) {
    return std::any_of(strips.begin(), strips.end(), [&](const PlacedStrip& placed) {
      return !(placed.overlay->*marks).empty();
    });
  };
  const auto entry = [&](double symbol, const char* name) {
    canvas.text({x + symbol + 3.0, base}, name, kText, kInk, Align::left);
    x += symbol + 3.0 + text_width(name, kText) + 12.0;
  };
  const bool acts = std::any_of(strips.begin(), strips.end(), [](const PlacedStrip& placed) {
    const auto& actions = placed.overlay->actions;
    return std::any_of(actions.begin(), actions.end(),
                       [](const StripAction& action) { return !action.goals.empty(); });
  });
  if (any(&StripOverlay::goals) || acts) {
    draw_goal(canvas, {x + 1.7 * kGoalRadius, middle});
    entry(3.4 * kGoalRadius, "goal");
  }
  if (any(&StripOverlay::hand_path)) {
    const Point sample[] = {{x, middle}, {x + 12.0, middle}};
    canvas.line(sample, kPath, 0.7);
    entry(12.0, "path");
  }
  if (any(&StripOverlay::centre_of_mass)) {
    draw_mass(canvas, {x + kMassRadius, middle});
    entry(2.0 * kMassRadius, "centre of mass");
  }
}

void paint_scale_bar(Canvas& canvas, double metre, double width, double base) {
  const double metres = round_length(0.12 * width / metre);
  const std::string label = fmt::format("{:g} m", metres);
  const double y = base - 0.36 * kText;
  const double right = width - kMargin - text_width(label, kText) - 4.0;
  const double left = right - metres * metre;
  const Point bar[] = {{left, y}, {right, y}};
  canvas.line(bar, kInk, 0.9);
  for (const double x : {left, right}) {
    const Point tick[] = {{x, y - 2.0}, {x, y + 2.0}};
    canvas.line(tick, kInk, 0.9);
  }
  canvas.text({width - kMargin, base}, label, kText, kInk, Align::right);
}

}  // namespace shigusa::strip
