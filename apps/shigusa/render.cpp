// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <shigusa/bvh.hpp>
#include <shigusa/file.hpp>
#include <shigusa/strip_figure.hpp>
#include <shigusa/words.hpp>

#include "commands.hpp"

namespace shigusa::app {
namespace {

Result<FigureFormat> format_of(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".svg") return FigureFormat::svg;
  if (ending == ".png") return FigureFormat::png;
  if (ending == ".pdf") return FigureFormat::pdf;
  return fail(ErrorCode::invalid_argument,
              "a picture's name must end in .svg, .png or .pdf; this ends in '" + ending + "'",
              path.string());
}

}  // namespace

Result<FrameRange> parse_frames(const std::string& text) {
  if (text.empty()) return FrameRange{};
  const char* end = text.data() + text.size();
  FrameRange range;
  int last = 0;
  const auto first = std::from_chars(text.data(), end, range.first);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ':') {
    const auto rest = std::from_chars(first.ptr + 1, end, last);
    const bool whole = rest.ec == std::errc{} && rest.ptr == end;
    if (whole && range.first >= 0 && last >= 0) {
      range.last = last;
      return range;
    }
  }
  return fail(ErrorCode::invalid_argument,
              "'" + text.substr(0, 80) + "' is not FIRST:LAST, two frame numbers from 0",
              "--frames");
}

Result<int> render(const RenderOptions& options) {
  const std::filesystem::path clip = options.clip;
  const std::filesystem::path out = options.out.empty() ? clip.filename().replace_extension(".svg")
                                                        : std::filesystem::path(options.out);
  StripSettings settings;
  settings.poses = options.poses;
  SHG_TRY_ASSIGN(const FrameRange frames, parse_frames(options.frames));
  settings.first_frame = frames.first;
  if (frames.last) settings.last_frame = *frames.last;
  SHG_TRY_ASSIGN(const SkeletonMotion motion, read_bvh(clip));
  SHG_TRY_ASSIGN(const FigureFormat format, format_of(out));
  std::error_code ignored;
  if (std::filesystem::equivalent(clip, out, ignored)) {
    return fail(ErrorCode::invalid_argument,
                "is the clip itself, which the picture would replace; give another name by --out",
                out.string());
  }
  const Result<std::string> no_person = understand_figure(motion, options.stature, settings);
  if (!no_person) {
    return fail(no_person.error().code, no_person.error().message, "--stature");
  }
  if (!no_person->empty()) {
    note(options.clip,
         fmt::format("no whole person: {}; drawn as it stands, +Y up, 1 unit = {:g} m", *no_person,
                     settings.metres_per_unit));
  }
  const Result<std::string> picture = draw_strip(motion, {}, settings, format);
  if (!picture) return fail(picture.error().code, picture.error().to_string(), options.clip);
  SHG_TRY(write_file(out, *picture));
  print_out("{}\n", out.string());
  return kDone;
}

}  // namespace shigusa::app
