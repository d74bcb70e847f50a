// SPDX-License-Identifier: MIT
#include "picture.hpp"

#ifdef SHIGUSA_HAS_LIBRSVG
#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

#include <exception>
#include <memory>

#include "commands.hpp"
#endif

namespace shigusa::app {
namespace {

tl::unexpected<Error> no_librsvg() {
  return fail(ErrorCode::unsupported, "there is no librsvg here, which makes PNG and PDF; use svg",
              "picture");
}

}  // namespace

Result<FileFormat> picture_format(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  for (const FileFormat format : {FileFormat::svg, FileFormat::png, FileFormat::pdf}) {
    if (ending == info_of(format).endings.front()) return format;
  }
  return fail(ErrorCode::invalid_argument,
              "a picture's name must end in .svg, .png or .pdf; this ends in '" + ending + "'",
              path.string());
}

#ifdef SHIGUSA_HAS_LIBRSVG
namespace {

// Function of librsvg, cairo or glib, loaded with the first picture: linking them would cost each
// start of the program 5 ms and 6 MiB.
#define SHG_RSVG(function) \
  reinterpret_cast<decltype(&(function))>(find_function("librsvg-2.so.2", #function))

constexpr double kPngDpi = 300.0;
constexpr double kPointsPerInch = 72.0;  // PDF's unit

struct Release {
  void operator()(RsvgHandle* svg) const { SHG_RSVG(g_object_unref)(svg); }
  void operator()(cairo_surface_t* surface) const { SHG_RSVG(cairo_surface_destroy)(surface); }
  void operator()(cairo_t* context) const { SHG_RSVG(cairo_destroy)(context); }
};

// Called from C: exceptions must not escape.
cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

cairo_surface_t* png_surface(const RsvgRectangle& page) {
  return SHG_RSVG(cairo_image_surface_create)(
      CAIRO_FORMAT_RGB24, static_cast<int>(page.width + 0.5), static_cast<int>(page.height + 0.5));
}

cairo_surface_t* pdf_surface(const RsvgRectangle& page, std::string* bytes) {
  cairo_surface_t* pdf =
      SHG_RSVG(cairo_pdf_surface_create_for_stream)(append, bytes, page.width, page.height);
  // the current date would make each file different
  SHG_RSVG(cairo_pdf_surface_set_metadata)
  (pdf, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  return pdf;
}

}  // namespace

Result<std::string> picture_from(const std::string& svg, FileFormat format) {
  if (format == FileFormat::svg) return svg;
  if (SHG_RSVG(rsvg_handle_new_from_data) == nullptr) return no_librsvg();
  const bool is_png = format == FileFormat::png;
  const std::unique_ptr<RsvgHandle, Release> handle(SHG_RSVG(rsvg_handle_new_from_data)(
      reinterpret_cast<const unsigned char*>(svg.data()), svg.size(), nullptr));
  if (!handle) return fail(ErrorCode::io, "librsvg does not read the strip figure", "picture");
  SHG_RSVG(rsvg_handle_set_dpi)(handle.get(), is_png ? kPngDpi : kPointsPerInch);
  RsvgRectangle page{};
  SHG_RSVG(rsvg_handle_get_intrinsic_size_in_pixels)(handle.get(), &page.width, &page.height);
  std::string bytes;
  const std::unique_ptr<cairo_surface_t, Release> surface(is_png ? png_surface(page)
                                                                 : pdf_surface(page, &bytes));
  const std::unique_ptr<cairo_t, Release> context(SHG_RSVG(cairo_create)(surface.get()));
  // the figure's white background covers the last pixels only partly
  SHG_RSVG(cairo_set_source_rgb)(context.get(), 1.0, 1.0, 1.0);
  SHG_RSVG(cairo_paint)(context.get());
  bool drawn =
      SHG_RSVG(rsvg_handle_render_document)(handle.get(), context.get(), &page, nullptr) != 0;
  if (is_png) {
    const auto status = SHG_RSVG(cairo_surface_write_to_png_stream)(surface.get(), append, &bytes);
    drawn = drawn && status == CAIRO_STATUS_SUCCESS;
  }
  SHG_RSVG(cairo_surface_finish)(surface.get());
  if (drawn && SHG_RSVG(cairo_surface_status)(surface.get()) == CAIRO_STATUS_SUCCESS) return bytes;
  return fail(ErrorCode::io, "librsvg does not draw the strip figure", "picture");
}
#else
Result<std::string> picture_from(const std::string& svg, FileFormat format) {
  if (format == FileFormat::svg) return svg;
  return no_librsvg();
}
#endif

}  // namespace shigusa::app
