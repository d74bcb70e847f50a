// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <shigusa/draw.hpp>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>

#include "commands.hpp"
#include "files/file.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "number_range.hpp"
#include "picture.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct RenderOptions {
  std::string clip;
  std::string out;  // empty: the clip's name with .svg
  int poses = StripSettings{}.poses;
  std::string frames;             // FIRST:LAST, or empty for all
  std::optional<double> stature;  // m
};

// Advice for a file that is no BVH.
std::string clip_hint(const std::filesystem::path& clip) {
  std::error_code ignored;
  if (std::filesystem::is_directory(clip, ignored)) {
    return "; give a clip in it, such as candidate-1.bvh";
  }
  const bool is_bvh = file_ending(clip.string()) == info_of(FileFormat::bvh).endings[0];
  return is_bvh ? "" : "; render draws BVH files alone";
}

Result<int> render(const RenderOptions& options) {
  const std::filesystem::path clip = to_path(options.clip);
  const std::filesystem::path out =
      options.out.empty() ? clip.filename().replace_extension(".svg") : to_path(options.out);
  StripSettings settings;
  settings.poses = options.poses;
  SHG_TRY_ASSIGN(const FrameRange frames, parse_frames(options.frames));
  settings.first_frame = frames.first;
  if (frames.last) settings.last_frame = *frames.last;
  SHG_TRY_ASSIGN(const SkeletonMotion motion, with_hint(read_bvh(clip), clip_hint(clip)));
  SHG_TRY_ASSIGN(const FileFormat format, picture_format(out));
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
  const Result<std::string> svg = draw_strip(motion, {}, settings);
  if (!svg) return fail(svg.error().code, svg.error().to_string(), options.clip);
  SHG_TRY_ASSIGN(const std::string picture, picture_from(*svg, format));
  SHG_TRY(write_file(out, picture));
  print_out("{}\n", out.string());
  return kDone;
}

}  // namespace

Result<FrameRange> parse_frames(const std::string& text) {
  if (text.empty()) return FrameRange{};
  const std::optional<NumberRange> range = parse_range(text);
  const auto is_frame = [](std::optional<std::uint64_t> number) {
    return !number || *number <= std::uint64_t{kFrameMax};
  };
  if (range && is_frame(range->first) && is_frame(range->last)) {
    FrameRange frames{.first = static_cast<int>(range->first.value_or(0))};
    if (range->last) frames.last = static_cast<int>(*range->last);
    return frames;
  }
  return fail(ErrorCode::invalid_argument,
              "'" + text.substr(0, 80) + "' is not FIRST:LAST, two frames from 0, such as 0:120",
              "--frames");
}

void add_render(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<RenderOptions>();
  RenderOptions& o = *options;
  CLI::App* c = app.add_subcommand("render", "Draw a motion as a strip of poses");
  c->group(kLook)->footer(
      "shigusa render out/candidate-1.bvh --out strip.svg\n"
      "shigusa render walk.bvh --frames 0:120 --poses 5 --out walk.png");
  const std::string clip = "The clip";
  describe(c->add_option("clip", o.clip)->required(),
           {.brief = "BVH file, recorded or made", .form = "FILE"});
  describe(c->add_option("--frames", o.frames),
           {.group = clip, .brief = kFramesHelp, .form = "FIRST:LAST"});
  describe(c->add_option("--stature", o.stature),
           {.group = clip,
            .brief = "Standing height, where the file's unit misleads",
            .full = "Standing height in metres, where the file's unit misleads.",
            .form = "METRES"});
  describe(c->add_option("--out", o.out),
           {.group = heading(OptionGroup::output),
            .brief = "Picture: .svg, .png or .pdf (default: CLIP's name with .svg)",
            .form = "FILE"});
  describe(c->add_option("--poses", o.poses),
           {.group = heading(OptionGroup::output),
            .brief = fmt::format("Poses to draw (default {})", o.poses),
            .form = "N"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(render(*options)); });
}

}  // namespace shigusa::app
