// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <shigusa/character.hpp>

#include "commands.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct BodyOptions {
  std::string source;
  CharacterOptions person;
  bool json = false;
};

// rounded, so that -0 is never printed
double rounded_to(double parts, double x) {
  const double rounded = std::round(parts * x) / parts;
  return rounded == 0.0 ? 0.0 : rounded;
}
double tenths(double degrees) { return rounded_to(10.0, degrees); }
double thousandths(double metres) { return rounded_to(1000.0, metres); }

void print_body(const PosedBody& posed, const CharacterSpec& spec) {
  const BodyModel& body = posed.body;
  print_out("{}: {:.3f} m, {:.1f} kg, {} dof\n", printable(body.name()), body.stature(),
            body.mass(), body.dof_count());
  print_out("{:<26} {:>8} {:>16} {:>18}\n", "freedom", "start °", "limits °", "strength N m");
  for (int d = 0; d < body.dof_count(); ++d) {
    const Dof& dof = body.dof(d);
    const std::string source = printable(file_joint(posed, d));
    print_out("{:<26} {:>8.1f} {:>7.0f} to {:>5.0f} {:>8.0f} to {:>5.0f}{}{}\n", dof.name,
              tenths(degrees(posed.home.angles[static_cast<std::size_t>(d)])),
              tenths(degrees(dof.lower)), tenths(degrees(dof.upper)), -dof.torque_negative,
              dof.torque_positive, source.empty() ? "" : "  ", source);
    if (const LimitCoupling* coupling = body.coupling_of(d)) {
      print_out("{:<26} {:>8} {:>7} to {:>5.0f} as {} goes from 0 to {:.0f}\n", "", "", "",
                tenths(degrees(widest_limits(body, d).second)), body.dof(coupling->driver).name,
                tenths(degrees(coupling->driver_full)));
    }
  }
  print_out("{:<26} {:>24}\n", "goals can be given for", "start x y z m");
  for (const GoalPlace& place : goal_places(posed)) {
    print_out("{:<26} {:>8.3f}{:>8.3f}{:>8.3f}\n", printable(place.effector),
              thousandths(place.start.x), thousandths(place.start.y), thousandths(place.start.z));
  }
  for (const auto& [bone, node] : spec.humanoid) print_out("{:<18} {}\n", bone, printable(node));
  for (const auto& [node, bone, share] : twist_shares(spec)) {
    print_out("{:<18} {}, {:.0f} % along {}\n", "twist bone", printable(node), 100.0 * share, bone);
  }
  for (const Message& doubt : posed.doubts) print_out("note: {}\n", printable(doubt.text));
}

Result<int> body(const BodyOptions& options) {
  CharacterSpec spec;
  spec.source = options.source;
  SHG_TRY(apply_character_options(options.person, spec));
  SHG_TRY(measure_character(spec, {}));
  SHG_TRY_ASSIGN(const PosedBody posed, build_character(spec));
  if (options.json) {
    print_out("{}", format_character(spec, posed));
  } else {
    print_body(posed, spec);
  }
  return kDone;
}

}  // namespace

void add_body(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<BodyOptions>();
  BodyOptions& o = *options;
  CLI::App* c = app.add_subcommand("body", "Show how a body is understood, and its effectors");
  c->group(kLook)->footer("shigusa body human\nshigusa body hero.vrm --stature 1.62");
  describe(c->add_option("source", o.source)->required(),
           {.brief = "A built-in body, or a person's or a robot's file",
            .full = character_help(),
            .form = character_form()});
  add_character_options(*c, o.person);
  describe(c->add_flag("--json", o.json),
           {.group = heading(OptionGroup::output), .brief = "Print JSON"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(body(*options)); });
}

}  // namespace shigusa::app
