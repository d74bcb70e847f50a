// SPDX-License-Identifier: MIT
#include <shigusa/draw.hpp>

#include "core/say.hpp"
#include "draw/candidate_strip.hpp"
#include "export_file.hpp"

namespace shigusa {
namespace {

Result<std::string> svg_of(const WriteRequest& request) {
  const MotionStrip strip = candidate_strip(request.task, request.candidate);
  return draw_strip(strip.motion, strip.overlay, strip.settings);
}

Result<MadeFile> from_svg(const WriteRequest& request, FileFormat format) {
  const PictureMaker& maker = request.settings.from_svg;
  if (!maker) return fail(ErrorCode::unsupported, say("svg_alone"), std::string(word_of(format)));
  SHG_TRY_ASSIGN(const std::string svg, svg_of(request));
  return unread(maker(svg, format));
}

}  // namespace

template <>
Result<MadeFile> write_as<FileFormat::svg>(const WriteRequest& request) {
  return unread(svg_of(request));
}

template <>
Result<MadeFile> write_as<FileFormat::png>(const WriteRequest& request) {
  return from_svg(request, FileFormat::png);
}

template <>
Result<MadeFile> write_as<FileFormat::pdf>(const WriteRequest& request) {
  return from_svg(request, FileFormat::pdf);
}

}  // namespace shigusa
