// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <shigusa/math.hpp>

#include "core/text.hpp"
#include "strip_figure_canvas.hpp"

namespace shigusa::strip {
namespace {

// Default look stated by the group: a white piece within the usual rim.
constexpr Colour kGroupColour{0xffffff};
constexpr double kGroupWidth = 0.7;

// A point in hundredths of a point, finer than any printer.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

std::int64_t hundredths(double x) { return static_cast<std::int64_t>(nearest_integer(100.0 * x)); }

GridPoint on_grid(Point p) { return {hundredths(p.x), hundredths(p.y)}; }

// Shortest notation of a number of hundredths in SVG: .5, -3, 12.34.
std::string number_of(std::int64_t units) {
  const std::int64_t size = std::abs(units);
  std::string text = units < 0 ? "-" : "";
  if (size >= 100 || size == 0) text += fmt::to_string(size / 100);
  if (size % 100 == 0) return text;
  text += fmt::format(".{:02}", size % 100);
  if (text.back() == '0') text.pop_back();
  return text;
}

std::string number(double x) { return number_of(hundredths(x)); }

std::string hex(Colour colour) {
  std::string text = fmt::format("{:06x}", colour.rgb);
  if (text[0] == text[1] && text[2] == text[3] && text[4] == text[5]) {
    text = {text[0], text[2], text[4]};
  }
  return "#" + text;
}

// Attribute of a colour or a width; empty if it is the group's.
std::string stated(const char* name, Colour colour) {
  return colour.rgb == kGroupColour.rgb ? "" : fmt::format(" {}=\"{}\"", name, hex(colour));
}
std::string stated_width(double width) {
  return hundredths(width) == hundredths(kGroupWidth)
             ? ""
             : fmt::format(" stroke-width=\"{}\"", number(width));
}

Point on_rim(const Disc& disc, double angle) {
  const auto [sine, cosine] = sin_cos(angle);
  return {disc.centre.x + disc.radius * cosine, disc.centre.y + disc.radius * sine};
}

// Data of a path: an absolute point and relative steps. Each step leads between rounded points, so
// that errors do not add up.
class PathData {
 public:
  void move_to(Point p) { move_to(on_grid(p)); }
  void line_to(Point p) { line_to(on_grid(p)); }
  // Adds an arc of a disc's rim, from one angle to a larger one.
  void arc(const Arc& arc);
  void circle(const Disc& disc);
  void close() { begin('z'); }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void move_to(GridPoint p);
  void line_to(GridPoint to);
  void arc_to(std::int64_t radius, GridPoint to);
  void step_to(GridPoint to);
  void begin(char command);
  void append(std::int64_t units);

  std::string text_;
  GridPoint at_;
  char command_ = 0;            // the last command, which is not repeated
  bool with_fraction_ = false;  // whether the last number has a decimal point
};

void PathData::begin(char command) {
  if (command != command_ || command == 'M') text_ += command;
  command_ = command;
}

// Appends a number, with a separator unless a sign or a second decimal point starts it.
void PathData::append(std::int64_t units) {
  const std::string number = number_of(units);
  const bool after_digit = text_.back() >= '0' && text_.back() <= '9';
  const bool starts = number[0] == '-' || (number[0] == '.' && with_fraction_);
  if (after_digit && !starts) text_ += ' ';
  text_ += number;
  with_fraction_ = number.find('.') != std::string::npos;
}

void PathData::step_to(GridPoint to) {
  append(to.x - at_.x);
  append(to.y - at_.y);
  at_ = to;
}

void PathData::move_to(GridPoint p) {
  begin('M');
  append(p.x);
  append(p.y);
  at_ = p;
}

void PathData::line_to(GridPoint to) {
  if (to.x == at_.x && to.y == at_.y) return;
  begin('l');
  step_to(to);
}

void PathData::arc_to(std::int64_t radius, GridPoint to) {
  begin('a');
  append(radius);
  append(radius);
  text_ += " 0 0 1";
  with_fraction_ = false;
  step_to(to);
}

// Splits long arcs: half a turn is ambiguous, and near it rounding moves the centre far. Arcs
// flatter than the rounding become lines.
void PathData::arc(const Arc& arc) {
  constexpr double kLong = 0.75 * kPi;
  constexpr double kFlat = 0.005;
  const double turn = arc.to - arc.from;
  if (arc.disc.radius * turn * turn < 8.0 * kFlat) {
    line_to(on_rim(arc.disc, arc.to));
    return;
  }
  int parts = 1;
  while (turn > kLong * parts) ++parts;
  for (int i = 1; i <= parts; ++i) {
    const double angle = i == parts ? arc.to : arc.from + turn * i / parts;
    arc_to(hundredths(arc.disc.radius), on_grid(on_rim(arc.disc, angle)));
  }
}

// Adds a circle as two halves whose ends are a diameter apart even after rounding.
void PathData::circle(const Disc& disc) {
  const std::int64_t radius = hundredths(disc.radius);
  const GridPoint centre = on_grid(disc.centre);
  move_to(GridPoint{centre.x + radius, centre.y});
  arc_to(radius, {centre.x - radius, centre.y});
  arc_to(radius, {centre.x + radius, centre.y});
  close();
}

std::string hull_data(std::span<const Disc> discs) {
  const std::vector<Arc> outline = hull_outline(discs);
  PathData data;
  if (outline.size() == 1) {
    data.circle(outline[0].disc);
    return data.text();
  }
  for (const Arc& arc : outline) {
    const Point from = on_rim(arc.disc, arc.from);
    if (data.text().empty()) {
      data.move_to(from);
    } else {
      data.line_to(from);
    }
    data.arc(arc);
  }
  data.close();
  return data.text();
}

}  // namespace

Canvas::Canvas(double width, double height)
    : svg_(fmt::format(
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" "
          "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans,Verdana,sans-serif\">\n"
          "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
          "<g fill=\"{2}\" stroke=\"{2}\" stroke-width=\"{3}\" stroke-linecap=\"round\" "
          "stroke-linejoin=\"round\">\n",
          number(width), number(height), hex(kGroupColour), number(kGroupWidth))) {}

// Paints the rim as a stroke over a piece enlarged by half of it, so that each piece is one element
// in any SVG viewer.
void Canvas::hull(std::span<const Disc> discs, Colour fill, double rim) {
  if (discs.empty()) return;
  if (!(rim > 0.0)) {
    if (discs.size() == 1 && fill.rgb == kGroupColour.rgb && discs[0].radius > 0.5 * kGroupWidth) {
      dot(discs[0]);
      return;
    }
    add(stated("fill", fill) + " stroke=\"none\"", hull_data(discs));
    return;
  }
  std::vector<Disc> larger(discs.begin(), discs.end());
  for (Disc& disc : larger) disc.radius += 0.5 * rim;
  end_path();
  add(stated("fill", fill) + stated_width(rim), hull_data(larger));
  end_path();
}

// Adds a white disc within the group's rim.
void Canvas::dot(const Disc& disc) {
  end_texts();
  end_path();
  svg_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", number(disc.centre.x),
                      number(disc.centre.y), number(disc.radius - 0.5 * kGroupWidth));
}

void Canvas::stroke(Colour colour, double width, double dash, const std::string& data) {
  const std::string dashes =
      dash > 0.0 ? fmt::format(" stroke-dasharray=\"{}\"", number(dash)) : std::string();
  add(" fill=\"none\"" + stated("stroke", colour) + stated_width(width) + dashes, data);
}

void Canvas::ring(Disc disc, Colour colour, double width) {
  PathData data;
  data.circle(disc);
  stroke(colour, width, 0.0, data.text());
}

void Canvas::line(std::span<const Point> points, Colour colour, double width, double dash) {
  if (points.empty()) return;
  PathData data;
  data.move_to(points[0]);
  const std::string start = data.text();
  for (const Point& point : points.subspan(1)) data.line_to(point);
  // a line of one point is a dot
  if (data.text() == start) data.close();
  stroke(colour, width, dash, data.text());
}

void Canvas::quartered(Disc disc, Colour colour) {
  const Disc halo{disc.centre, 1.25 * disc.radius};
  hull(std::span(&halo, 1), {0xffffff}, 0.0);
  PathData data;
  for (const double start : {0.0, kPi}) {
    data.move_to(disc.centre);
    data.line_to(on_rim(disc, start));
    data.arc({disc, start, start + 0.5 * kPi});
    data.close();
  }
  add(stated("fill", colour) + " stroke=\"none\"", data.text());
  ring(disc, colour, 0.25 * disc.radius);
}

void Canvas::text(Point at, const std::string& text, double size, Colour colour, Align align) {
  constexpr std::array<const char*, 3> kAnchor{"", " text-anchor=\"middle\"",
                                               " text-anchor=\"end\""};
  end_path();
  const std::string look =
      fmt::format(" fill=\"{}\" stroke=\"none\" font-size=\"{}\"", hex(colour), number(size));
  if (look != text_look_) {
    end_texts();
    svg_ += "<g" + look + ">\n";
    text_look_ = look;
  }
  // other fonts are scaled to the width that the layout assumed
  const std::string length = has_known_width(text)
                                 ? fmt::format(" textLength=\"{}\"", number(text_width(text, size)))
                                 : std::string();
  svg_ += fmt::format("<text x=\"{}\" y=\"{}\"{}{}>{}</text>\n", number(at.x), number(at.y),
                      kAnchor[static_cast<std::size_t>(align)], length, markup_text(text));
}

// Joins paths of one look if that paints the same: fills of the same orientation, and strokes.
void Canvas::add(const std::string& look, const std::string& data) {
  end_texts();
  if (look != look_) end_path();
  look_ = look;
  data_ += data;
}

void Canvas::end_path() {
  if (!data_.empty()) svg_ += fmt::format("<path{} d=\"{}\"/>\n", look_, data_);
  data_.clear();
}

void Canvas::end_texts() {
  if (!text_look_.empty()) svg_ += "</g>\n";
  text_look_.clear();
}

std::string Canvas::finish() {
  end_path();
  end_texts();
  svg_ += "</g>\n</svg>\n";
  return std::move(svg_);
}

}  // namespace shigusa::strip
