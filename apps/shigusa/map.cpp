// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <shigusa/explore.hpp>
#include <shigusa/files.hpp>
#include <shigusa/kinematics.hpp>

#include "commands.hpp"
#include "core/parse_number.hpp"
#include "files/file.hpp"
#include "files/path.hpp"
#include "next_step.hpp"
#include "task_input.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct MapOptions {
  TaskInput input;
  double spacing = MapSettings{}.spacing;
  std::string low;   // X,Y,Z
  std::string high;  // X,Y,Z
  std::string section;
  std::string out = "map";
};

// Numbers of a text with commas between.
Result<std::optional<Vec3d>> corner_of(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto numbers = parse_numbers(text, 3);
  if (numbers) return Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  return fail(ErrorCode::invalid_argument,
              fmt::format("'{}' is not X,Y,Z, such as -0.8,0,-0.4", text.substr(0, 80)), option);
}

struct SectionAt {
  Axis axis = Axis::x;
  double at = 0.0;  // m
};

// "x=-0.2"; when empty, through the root of the effector's limb.
Result<SectionAt> section_of(const std::string& text, const Task& task) {
  if (text.empty()) {
    const BodyModel& body = task.body;
    const auto index =
        task.goals.empty() ? std::nullopt : body.find_effector(task.goals.front().effector);
    if (!index) return SectionAt{};  // the map is refused
    const Dof& root = body.dof(body.effector(*index).limb_root);
    const Posture home(body, task.home.angles);
    return SectionAt{Axis::x, (home.place(root.parent) * root.offset).x};
  }
  const std::size_t axis = std::string_view("xyz").find(text.front());
  const auto at = text.size() > 2 && text[1] == '=' ? parse_number(text.substr(2)) : std::nullopt;
  if (axis == std::string_view::npos || !at) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' is not AXIS=METRES, such as x=-0.2", text.substr(0, 80)),
                "--section");
  }
  return SectionAt{static_cast<Axis>(axis), *at};
}

void print_map(const ReachMap& map) {
  std::array<std::size_t, kEnumWords<Verdict>.size()> counts{};
  std::size_t reached = 0;
  for (const MapPlace& place : map.places) {
    if (!place.verdict) continue;
    ++counts[static_cast<std::size_t>(*place.verdict)];
    ++reached;
  }
  print_out("{}: {} places of {:g} m, {} x {} x {}, from {:g},{:g},{:g}\n", printable(map.effector),
            map.places.size(), map.spacing, map.count[0], map.count[1], map.count[2], map.low.x,
            map.low.y, map.low.z);
  const double litres = 1000.0 * map.spacing * map.spacing * map.spacing;
  for (const auto& [verdict, word] : kEnumWords<Verdict>) {
    const std::size_t count = counts[static_cast<std::size_t>(verdict)];
    print_out("{:<12} {:>8} places {:>8.0f} litres\n", word, count,
              litres * static_cast<double>(count));
  }
  print_out("{:<12} {:>8} places\n", "unreachable", map.places.size() - reached);
}

Result<int> map(const MapOptions& options) {
  SHG_TRY_ASSIGN(const BatchSettings batch, batch_settings(options.input));
  MapSettings settings{.spacing = options.spacing};
  SHG_TRY_ASSIGN(settings.low, corner_of("--from", options.low));
  SHG_TRY_ASSIGN(settings.high, corner_of("--to", options.high));
  SHG_TRY_ASSIGN(TaskFile file, task_file_of(options.input));
  SHG_TRY_ASSIGN(Task task, make_task(file, folder_of(options.input)));
  task.batch = batch;
  SHG_TRY_ASSIGN(const SectionAt section, section_of(options.section, task));
  SHG_TRY(prepare_out(to_path(options.out)));
  const Result<ReachMap> made = reach_map(task, settings, terminal_progress());
  end_progress_line();
  if (!made) return tl::unexpected(in_task(made.error(), options.input, "map"));
  SHG_TRY_ASSIGN(const std::string svg,
                 placed("--section", map_section(task, *made, section.axis, section.at)));
  SHG_TRY_ASSIGN(const std::string npz, map_npz(task.body, *made));
  print_map(*made);
  const std::array<std::pair<const char*, std::string>, 4> written{{
      {"map.csv", map_csv(task.body, *made)},
      {"map.npz", npz},
      {"map.glb", map_glb(*made)},
      {"section.svg", svg},
  }};
  for (const auto& [name, bytes] : written) {
    const std::filesystem::path path = to_path(options.out) / name;
    SHG_TRY(write_file(path, bytes));
    print_out("{}\n", path.string());
  }
  const bool any = std::any_of(made->places.begin(), made->places.end(), [](const MapPlace& place) {
    return place.verdict == Verdict::possible;
  });
  return any ? kDone : kUnreachable;
}

}  // namespace

void add_map(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<MapOptions>();
  MapOptions& o = *options;
  CLI::App* c = app.add_subcommand("map", "Map what the places about a body cost one of its hands");
  c->group(kLook)->footer(
      "shigusa map --spacing 0.4 --out reach\n"
      "shigusa map --seat 0.45 --from -0.4,0.7,0.3 --to 0,0.9,0.5 --section y=0.8\n"
      "shigusa map task.json --spacing 0.5 --section z=0.25");
  add_task_input(*c, o.input);
  const std::string group = "The map";
  describe(c->add_option("--hand", o.input.goal_of),
           {.group = group,
            .brief = "Whose places, if there is no goal (default right_hand)",
            .full = "The hand, or other joint, whose places are mapped if the task has no goal; "
                    "right_hand when not given. Else it is the first goal's, wherever that is.",
            .form = "EFFECTOR"});
  o.input.goal_of = "right_hand";
  describe(c->add_option("--spacing", o.spacing)->check(number(-1e6, 1e6)),
           {.group = group,
            .brief = "Distance of neighbouring places (default 0.1)",
            .full = "Distance of neighbouring places in metres; 0.1 when not given.",
            .form = "METRES"});
  describe(c->add_option("--from", o.low),
           {.group = group,
            .brief = "First corner of the box of places (default: about the body)",
            .full = "The corner of the box of places with the least coordinates; when not given, "
                    "1.6 lengths of the arm to each side, from the floor to a length above the "
                    "shoulder.",
            .form = "X,Y,Z"});
  describe(c->add_option("--to", o.high),
           {.group = group, .brief = "Opposite corner of that box", .form = "X,Y,Z"});
  describe(c->add_option("--section", o.section),
           {.group = group,
            .brief = "Plane that is drawn (default: through the shoulder)",
            .full = "The plane of places that is drawn, as an axis and metres, x=-0.2; when not "
                    "given, from the side through the shoulder.",
            .form = "AXIS=METRES"});
  add_batch_options(*c, o.input);
  describe(c->add_option("--out", o.out),
           {.group = heading(OptionGroup::output),
            .brief = "Folder for CSV, NPZ, GLB and SVG (default map)",
            .form = "FOLDER"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(map(*options)); });
}

}  // namespace shigusa::app
