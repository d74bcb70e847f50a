// SPDX-License-Identifier: MIT
#include "strip_figure_cairo.hpp"

#include <cairo-pdf.h>

#include <exception>
#include <shigusa/scalar.hpp>

namespace shigusa::strip {
namespace {

// Called from C: no exception may leave.
cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

// Outlines and widths without rounding to pixels, so that all formats have the same layout.
cairo_font_options_t* font_options() {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  return options;
}

cairo_font_face_t* font_face() {
  return cairo_toy_font_face_create("DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                                    CAIRO_FONT_WEIGHT_NORMAL);
}

void trace(cairo_t* context, const std::vector<Arc>& outline) {
  cairo_new_path(context);
  for (const Arc& arc : outline) {
    const Point c = arc.disc.centre;
    cairo_arc(context, c.x, c.y, arc.disc.radius, arc.from, arc.to);
  }
  cairo_close_path(context);
}

cairo_surface_t* create_surface(FigureFormat format, double width, double height, double scale,
                                std::string* bytes) {
  if (format == FigureFormat::pdf) {
    cairo_surface_t* pdf = cairo_pdf_surface_create_for_stream(append, bytes, width, height);
    // a date of the day would make each run's file another one
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    return pdf;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width * scale + 0.5),
                                    static_cast<int>(height * scale + 0.5));
}

}  // namespace

double cairo_text_width(const std::string& text, double size) {
  cairo_font_options_t* options = font_options();
  cairo_font_face_t* face = font_face();
  cairo_matrix_t scale;
  cairo_matrix_t identity;
  cairo_matrix_init_scale(&scale, size, size);
  cairo_matrix_init_identity(&identity);
  cairo_scaled_font_t* font = cairo_scaled_font_create(face, &scale, &identity, options);
  cairo_text_extents_t extents{};
  cairo_scaled_font_text_extents(font, text.c_str(), &extents);
  cairo_scaled_font_destroy(font);
  cairo_font_face_destroy(face);
  cairo_font_options_destroy(options);
  return extents.x_advance;
}

CairoCanvas::CairoCanvas(FigureFormat format, double width, double height, double pixels_per_point)
    : format_(format),
      surface_(create_surface(format, width, height, pixels_per_point, bytes_.get())),
      context_(cairo_create(surface_.get())) {
  if (format == FigureFormat::png) cairo_scale(context_.get(), pixels_per_point, pixels_per_point);
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_font_options_t* options = font_options();
  cairo_set_font_options(context_.get(), options);
  cairo_font_options_destroy(options);
  cairo_font_face_t* face = font_face();
  cairo_set_font_face(context_.get(), face);
  cairo_font_face_destroy(face);
  source({0xffffff});
  cairo_paint(context_.get());
}

void CairoCanvas::source(Colour colour) {
  const auto part = [&](int shift) { return ((colour.rgb >> shift) & 0xff) / 255.0; };
  cairo_set_source_rgb(context_.get(), part(16), part(8), part(0));
}

void CairoCanvas::hull(std::span<const Disc> discs, Colour fill, double rim) {
  if (discs.empty()) return;
  trace(context_.get(), hull_outline(discs));
  if (rim > 0.0) {
    source({0xffffff});
    cairo_set_line_width(context_.get(), 2.0 * rim);
    cairo_stroke_preserve(context_.get());
  }
  source(fill);
  cairo_fill(context_.get());
}

void CairoCanvas::ring(Disc disc, Colour colour, double width) {
  source(colour);
  cairo_set_line_width(context_.get(), width);
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), disc.centre.x, disc.centre.y, disc.radius, 0.0, kTwoPi);
  cairo_close_path(context_.get());
  cairo_stroke(context_.get());
}

void CairoCanvas::line(std::span<const Point> points, Colour colour, double width, double dash) {
  if (points.empty()) return;
  source(colour);
  cairo_set_line_width(context_.get(), width);
  cairo_set_dash(context_.get(), &dash, dash > 0.0 ? 1 : 0, 0.0);
  cairo_new_path(context_.get());
  for (const Point& point : points) cairo_line_to(context_.get(), point.x, point.y);
  cairo_stroke(context_.get());
  cairo_set_dash(context_.get(), nullptr, 0, 0.0);
}

void CairoCanvas::quartered(Disc disc, Colour colour) {
  const Point c = disc.centre;
  hull(std::span(&disc, 1), {0xffffff}, 0.25 * disc.radius);
  source(colour);
  for (const double start : {0.0, kPi}) {
    cairo_new_path(context_.get());
    cairo_move_to(context_.get(), c.x, c.y);
    cairo_arc(context_.get(), c.x, c.y, disc.radius, start, start + 0.5 * kPi);
    cairo_close_path(context_.get());
    cairo_fill(context_.get());
  }
  ring(disc, colour, 0.25 * disc.radius);
}

void CairoCanvas::text(Point at, const std::string& text, double size, Colour colour, Align align) {
  const double share = align == Align::left ? 0.0 : align == Align::centre ? 0.5 : 1.0;
  const double width = text_width(text, size);
  const double drawn = has_known_width(text) ? cairo_text_width(text, size) : width;
  source(colour);
  cairo_set_font_size(context_.get(), size);
  cairo_save(context_.get());
  cairo_translate(context_.get(), at.x - share * width, at.y);
  // another font is made to keep the width that the layout has taken
  if (drawn > 0.0) cairo_scale(context_.get(), width / drawn, 1.0);
  cairo_new_path(context_.get());
  cairo_move_to(context_.get(), 0.0, 0.0);
  cairo_text_path(context_.get(), text.c_str());
  cairo_fill(context_.get());
  cairo_restore(context_.get());
}

Result<std::string> CairoCanvas::finish() {
  cairo_status_t status = cairo_status(context_.get());
  if (status == CAIRO_STATUS_SUCCESS && format_ == FigureFormat::png) {
    status = cairo_surface_write_to_png_stream(surface_.get(), append, bytes_.get());
  }
  cairo_surface_finish(surface_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  if (status != CAIRO_STATUS_SUCCESS) {
    return fail(ErrorCode::io, cairo_status_to_string(status), "strip figure");
  }
  return std::move(*bytes_);
}

}  // namespace shigusa::strip
