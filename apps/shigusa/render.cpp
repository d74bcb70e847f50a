// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <shigusa/core/names.hpp>
#include <shigusa/figure/strip_figure.hpp>
#include <shigusa/io/bvh.hpp>
#include <shigusa/io/file.hpp>
#include <shigusa/person/landmarks.hpp>

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

// Metres per unit of a figure that is no whole person: nobody is 3 m tall, so it is in centimetres,
// as animation tools expect of BVH and shigusa writes it.
double guessed_unit(const std::vector<Transformd>& world, std::optional<double> stature) {
  constexpr double kTallest = 3.0;
  double low = world.front().translation.y;
  double high = low;
  for (const Transformd& node : world) {
    low = min(low, node.translation.y);
    high = max(high, node.translation.y);
  }
  if (stature && high > low) return *stature / (high - low);
  return high - low > kTallest ? 0.01 : 1.0;
}

// What is known of the figure: axes, scale and bones; anything else is drawn as it stands.
Result<void> understand_figure(const SkeletonMotion& motion, const RenderOptions& options,
                               StripSettings& settings) {
  const int frame = std::min(settings.first_frame, motion.clip.frames - 1);
  const std::vector<Transformd> world = world_transforms(motion.skeleton, motion.clip, frame);
  const Result<HumanoidMap> map = find_humanoid(motion.skeleton, world);
  const Result<MeasuredPerson> person =
      map ? measure_person(motion.skeleton, world, *map, {.stature = options.stature})
          : Result<MeasuredPerson>(tl::unexpected(map.error()));
  if (map) settings.humanoid = *map;
  if (person) {
    settings.metres_per_unit = person->placement.unit;
    settings.up = person->placement.up;
    return {};
  }
  if (options.stature && !(*options.stature >= 0.5 && *options.stature <= 2.5)) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("is {} m; allowed are 0.5 to 2.5 m", *options.stature), "--stature");
  }
  settings.metres_per_unit = guessed_unit(world, options.stature);
  note(options.clip, fmt::format("no whole person: {}; drawn as it stands, +Y up, 1 unit = {:g} m",
                                 person.error().to_string(), settings.metres_per_unit));
  return {};
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

int render(const RenderOptions& options) {
  const std::filesystem::path clip = options.clip;
  const std::filesystem::path out = options.out.empty() ? clip.filename().replace_extension(".svg")
                                                        : std::filesystem::path(options.out);
  StripSettings settings;
  settings.poses = options.poses;
  const Result<FrameRange> frames = parse_frames(options.frames);
  if (!frames) return report(frames.error());
  settings.first_frame = frames->first;
  if (frames->last) settings.last_frame = *frames->last;
  const Result<SkeletonMotion> motion = read_bvh(clip);
  if (!motion) return report(motion.error());
  const Result<FigureFormat> format = format_of(out);
  if (!format) return report(format.error());
  std::error_code ignored;
  if (std::filesystem::equivalent(clip, out, ignored)) {
    return report(
        {ErrorCode::invalid_argument,
         "is the clip itself, which the picture would replace; give another name by --out",
         out.string()});
  }
  if (const auto known = understand_figure(*motion, options, settings); !known) {
    return report(known.error());
  }
  const Result<std::string> picture = draw_strip(*motion, {}, settings, *format);
  if (!picture) return report({picture.error().code, picture.error().to_string(), options.clip});
  if (const auto written = write_file(out, *picture); !written) return report(written.error());
  print_out("{}\n", out.string());
  return kDone;
}

}  // namespace shigusa::app
