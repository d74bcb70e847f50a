// SPDX-License-Identifier: MIT
#include "strip_figure_svg.hpp"

#include <fmt/format.h>

#include <array>
#include <shigusa/scalar.hpp>

#include "core/index.hpp"
#include "core/text.hpp"

namespace shigusa::strip {
namespace {

// Advance widths of DejaVu Sans from the space to the tilde, in 1/2048 of the font's size.
constexpr double kUnitsPerEm = 2048.0;
constexpr int kFirst = 32;
constexpr std::array<int, 95> kAdvance{
    651,  821,  942,  1716, 1303, 1946, 1597, 563,  799,  799,  1024, 1716, 651,  739,  651,  690,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690,  690,  1716, 1716, 1716, 1087,
    2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604,  604,  1343, 1141, 1767, 1532, 1612,
    1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799,  690,  799,  1716, 1024,
    1024, 1255, 1300, 1126, 1300, 1260, 721,  1300, 1298, 569,  569,  1186, 569,  1995, 1298, 1253,
    1300, 1300, 842,  1067, 803,  1298, 1212, 1675, 1212, 1212, 1075, 1303, 690,  1303, 1716};
// Narrow enough for Latin letters with accents, and what most fonts give to ideographs.
constexpr int kLetter = 1303;
constexpr int kIdeograph = 2048;

// Hundredths of a point are finer than any printer.
std::string number(double x) {
  std::string text = fmt::format("{:.2f}", x);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string pair(Point p) { return number(p.x) + "," + number(p.y); }

std::string hex(Colour colour) { return fmt::format("#{:06x}", colour.rgb); }

Point on_rim(const Disc& disc, double angle) {
  const auto [sine, cosine] = sin_cos(angle);
  return {disc.centre.x + disc.radius * cosine, disc.centre.y + disc.radius * sine};
}

// In two where it is long: an arc between points that are one after rounding would not be drawn,
// and one of half a turn could be either half.
std::string arc_to(const Disc& disc, double from, double to) {
  constexpr double kLong = 0.75 * kPi;
  if (to - from > kLong) {
    const double middle = 0.5 * (from + to);
    return arc_to(disc, from, middle) + arc_to(disc, middle, to);
  }
  return fmt::format("A{0} {0} 0 0 1 {1}", number(disc.radius), pair(on_rim(disc, to)));
}

std::string path_of(const std::vector<Arc>& outline) {
  std::string path;
  for (const Arc& arc : outline) {
    path += (path.empty() ? "M" : "L") + pair(on_rim(arc.disc, arc.from));
    path += arc_to(arc.disc, arc.from, arc.to);
  }
  return path + "Z";
}

// XML's own characters escaped, and those left out that it does not allow.
std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    text.remove_prefix(character.size());
    if (character == "&") {
      result += "&amp;";
    } else if (character == "<") {
      result += "&lt;";
    } else if (character == ">") {
      result += "&gt;";
    } else if (length > 0 && static_cast<unsigned char>(character[0]) >= kFirst &&
               character != "\xef\xbf\xbe" && character != "\xef\xbf\xbf") {
      result += character;
    }
  }
  return result;
}

}  // namespace

double svg_text_width(const std::string& text, double size) {
  int units = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = utf8_length(rest);
    const int code = static_cast<unsigned char>(rest[0]) - kFirst;
    if (code >= 0 && code < static_cast<int>(kAdvance.size())) {
      units += kAdvance[index(code)];
    } else if (length > 1) {
      units += length == 2 ? kLetter : kIdeograph;
    }
    rest.remove_prefix(length == 0 ? 1 : length);
  }
  return units * size / kUnitsPerEm;
}

SvgCanvas::SvgCanvas(double width, double height)
    : svg_(fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}pt\" height=\"{1}pt\" "
                       "viewBox=\"0 0 {0} {1}\">\n"
                       "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
                       "<g stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                       number(width), number(height))) {}

void SvgCanvas::hull(std::span<const Disc> discs, Colour fill, double rim) {
  if (discs.empty()) return;
  const std::string path = path_of(hull_outline(discs));
  if (rim > 0.0) {
    svg_ += fmt::format("<path fill=\"none\" stroke=\"#ffffff\" stroke-width=\"{}\" d=\"{}\"/>\n",
                        number(2.0 * rim), path);
  }
  svg_ += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", hex(fill), path);
}

void SvgCanvas::ring(Disc disc, Colour colour, double width) {
  svg_ += fmt::format(
      "<circle fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
      hex(colour), number(width), number(disc.centre.x), number(disc.centre.y),
      number(disc.radius));
}

void SvgCanvas::line(std::span<const Point> points, Colour colour, double width, double dash) {
  if (points.empty()) return;
  std::string path;
  for (const Point& point : points) path += (path.empty() ? "M" : "L") + pair(point);
  // a line of one point is a dot
  if (points.size() == 1) path += "Z";
  const std::string dashes =
      dash > 0.0 ? fmt::format(" stroke-dasharray=\"{}\"", number(dash)) : std::string();
  svg_ += fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{} d=\"{}\"/>\n",
                      hex(colour), number(width), dashes, path);
}

void SvgCanvas::quartered(Disc disc, Colour colour) {
  hull(std::span(&disc, 1), {0xffffff}, 0.25 * disc.radius);
  std::string path;
  for (const double start : {0.0, kPi}) {
    path += "M" + pair(disc.centre) + "L" + pair(on_rim(disc, start)) +
            arc_to(disc, start, start + 0.5 * kPi) + "Z";
  }
  svg_ += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", hex(colour), path);
  ring(disc, colour, 0.25 * disc.radius);
}

void SvgCanvas::text(Point at, const std::string& text, double size, Colour colour, Align align) {
  constexpr std::array<const char*, 3> kAnchor{"start", "middle", "end"};
  bool ascii = true;
  for (const char c : text) ascii = ascii && static_cast<unsigned char>(c) < 0x80;
  // where the table knows the width, other fonts are made to keep it
  const std::string length =
      ascii && !text.empty() ? fmt::format(" textLength=\"{}\"", number(svg_text_width(text, size)))
                             : std::string();
  svg_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"{}\" "
      "text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
      number(at.x), number(at.y), number(size), kAnchor[static_cast<std::size_t>(align)],
      hex(colour), length, escaped(text));
}

Result<std::string> SvgCanvas::finish() {
  svg_ += "</g>\n</svg>\n";
  return std::move(svg_);
}

}  // namespace shigusa::strip
