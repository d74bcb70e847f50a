// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <shigusa/body/landmarks.hpp>
#include <shigusa/core/names.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/io/strip_figure.hpp>

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

Result<void> parse_frames(const std::string& text, StripSettings& settings) {
  if (text.empty()) return {};
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, settings.first_frame);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ':') {
    const auto last = std::from_chars(first.ptr + 1, end, settings.last_frame);
    if (last.ec == std::errc{} && last.ptr == end) return {};
  }
  return fail(ErrorCode::invalid_argument, "--frames '" + text + "' is not FIRST:LAST");
}

// what is known of the figure: axes, scale and bones; anything else is drawn as it stands
void understand_figure(const SkeletonMotion& motion, const RenderOptions& options,
                       StripSettings& settings) {
  const int frame = std::min(std::max(settings.first_frame, 0), motion.clip.frames - 1);
  const std::vector<Transformd> world = world_transforms(motion.skeleton, motion.clip, frame);
  const Result<HumanoidMap> map = find_humanoid(motion.skeleton, world);
  if (!map) {
    fmt::print(stderr, "shigusa: {}: note: drawn as plain bones, +Y up: {}\n", options.clip,
               map.error().to_string());
    return;
  }
  settings.humanoid = *map;
  const Result<MeasuredPerson> person =
      measure_person(motion.skeleton, world, *map, {.stature = options.stature});
  if (!person) {
    fmt::print(stderr, "shigusa: {}: note: {}\n", options.clip, person.error().to_string());
    return;
  }
  settings.metres_per_unit = person->unit;
  settings.up = person->up;
}

}  // namespace

int render(const RenderOptions& options) {
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(options.clip).filename().replace_extension(".svg")
                          : std::filesystem::path(options.out);
  const Result<FigureFormat> format = format_of(out);
  if (!format) return report(format.error());
  StripSettings settings;
  settings.poses = options.poses;
  if (const auto ok = parse_frames(options.frames, settings); !ok) return report(ok.error());
  const Result<SkeletonMotion> motion = read_bvh(options.clip);
  if (!motion) return report(motion.error());
  understand_figure(*motion, options, settings);
  const Result<std::string> picture = draw_strip(*motion, {}, settings, *format);
  if (!picture) return report(picture.error());
  if (const auto written = write_file(out, *picture); !written) return report(written.error());
  fmt::print("{}\n", out.string());
  return kDone;
}

}  // namespace shigusa::app
