// SPDX-License-Identifier: MIT
#include <shigusa/strip_figure.hpp>

#include "draw/candidate_strip.hpp"
#include "export_file.hpp"

namespace shigusa {
namespace {

Result<MadeFile> motion_strip(const WriteRequest& request, FigureFormat format) {
  const MotionStrip strip = candidate_strip(request.task, request.candidate);
  return unread(draw_strip(strip.motion, strip.overlay, strip.settings, format));
}

}  // namespace

template <>
Result<MadeFile> write_as<FileFormat::svg>(const WriteRequest& request) {
  return motion_strip(request, FigureFormat::svg);
}

template <>
Result<MadeFile> write_as<FileFormat::png>(const WriteRequest& request) {
  return motion_strip(request, FigureFormat::png);
}

template <>
Result<MadeFile> write_as<FileFormat::pdf>(const WriteRequest& request) {
  return motion_strip(request, FigureFormat::pdf);
}

}  // namespace shigusa
