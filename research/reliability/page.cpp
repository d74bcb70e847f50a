// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinds.hpp"

namespace shigusa::bench {
namespace {

constexpr std::size_t kFailuresTold = 20;

int count_of(const std::map<std::string, int>& counts, const char* name) {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : found->second;
}

Audit sum_of(const std::vector<Audit>& kinds) {
  Audit all;
  for (const Audit& kind : kinds) all.add(kind);
  return all;
}

std::string row(std::string_view name, const Audit& audit) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, audit.tasks,
                     count_of(audit.statuses, "reached"), count_of(audit.statuses, "unsteady"),
                     count_of(audit.statuses, "unreachable"), audit.refused, audit.candidates,
                     count_of(audit.verdicts, "possible"), count_of(audit.verdicts, "strains"),
                     count_of(audit.verdicts, "impossible"));
}

// Worst value of each promise, with its bound.
std::string worst_table(const Audit& all) {
  std::string text = "| | worst | allowed |\n|---|---|---|\n";
  for (std::size_t k = 0; k < kPromises; ++k) {
    const PromiseInfo& info = info_of(static_cast<Promise>(k));
    text += fmt::format("| {} | {:.4f}{} | {:.4g}{} |\n", info.words, info.scale * all.worst[k],
                        info.unit, info.scale * info.allowed, info.unit);
  }
  text += fmt::format(
      "| forearm in the head, told as free | {:.1f} mm | |\n"
      "| forearm in a shank, told as free | {:.1f} mm | |\n"
      "| … by more than {:.0f} mm | {} of {} | |\n"
      "| resting hand goes through what it rests on, on its way, by more than {:.0f} mm | {} of {} "
      "| "
      "|\n"
      "| candidates that tell of a limit that they pass | {} | |\n\n",
      1e3 * std::fmax(all.head, 0.0), 1e3 * std::fmax(all.shank, 0.0), 1e3 * kThroughFlesh,
      all.through, all.fleshed, 1e3 * kBoneInBox, all.rest_through, all.resting, all.over_limit);
  return text;
}

std::string beginning(const Audit& all, const Cast& cast, int evaluations) {
  return fmt::format(
      "# Reliability\n\n"
      "Written by `scripts/make_reliability`; not edited by hand.\n\n"
      "{} random tasks, the same each time: the built-in bodies in statures of 1.45 to 2.00 m and "
      "both sexes,\n"
      "{} persons from BVH, glTF, VRM and FBX files, {} robots from URDF and MJCF files, standing "
      "and on seats,\n"
      "all presets, goals within and beyond reach, {} motions scored for each.\n\n"
      "All is judged from outside, by files and numbers and none of the kernel's functions:\n\n"
      "- goals, feet, seats and hands that rest by the exported BVH's own forward kinematics, of "
      "a glTF or VRM\n"
      "  character's first candidate by its GLB's too; of a robot by the exported CSV's joints in "
      "the tree of\n"
      "  its URDF file, which a second reader parses, of MJCF in the URDF that the result holds,\n"
      "  and where MuJoCo reads the file by MuJoCo;\n"
      "- limits by every row of the exported CSV; a robot's by its file;\n"
      "- obstacles by the bones' lines, from point to point, in boxes with round edges; what a "
      "bone is in at the\n"
      "  start does not count;\n"
      "- what is delivered as free by an ellipsoid for the head and tapering limbs, which are "
      "another geometry\n"
      "  than the kernel's capsules, of built-in bodies;\n"
      "- torques of joints that hold no planted foot (in motions that jolt, less strictly: there "
      "those told\n  may swing by more than the limb does), and "
      "where the floor presses, by Newton's and "
      "Euler's laws\n"
      "  for each piece, of places from frame to frame; of robots by the masses of the file; "
      "verdicts by both,\n"
      "  and by every torque that is told.\n\n"
      "Each judge is shown to find a motion that is spoilt on purpose: `tests/reliability`.\n\n"
      "## What was promised and not kept: {}\n\n",
      all.tasks, cast.people.size(), cast.robots.size(), evaluations,
      all.failures.empty() ? "nothing" : "see below");
}

}  // namespace

std::string reliability_page(const std::vector<Audit>& kinds, const Cast& cast, int evaluations) {
  const Audit all = sum_of(kinds);
  std::string text = beginning(all, cast, evaluations) + worst_table(all);
  text +=
      "An obstacle is asked about the ends and the middle of each limb "
      "([limits](limits.md#collisions)), so that\n"
      "a bone may lie a little in an edge of it. A hand that rests is not asked about what it "
      "rests "
      "on, on its\n"
      "way there either.\n\n"
      "## Status and verdicts\n\n"
      "| asked for | tasks | reached | unsteady | unreachable | refused | candidates | possible | "
      "strains | impossible |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t k = 0; k < kinds.size(); ++k) text += row(all_kinds()[k].name, kinds[k]);
  text += row("all", all);
  const int met = count_of(all.best, "possible") + count_of(all.best, "strains") +
                  count_of(all.best, "impossible");
  text += fmt::format(
      "\nRefused are tasks in which a hand does not reach what it is to rest on. Of {} tasks whose "
      "goals are\n"
      "met, the first candidate is possible in {}, strains in {} and is impossible, and told so, "
      "in {}.\n",
      met, count_of(all.best, "possible"), count_of(all.best, "strains"),
      count_of(all.best, "impossible"));
  for (std::size_t i = 0; i < std::min(all.failures.size(), kFailuresTold); ++i) {
    text += fmt::format("\n```\n{}\n```\n", all.failures[i]);
  }
  return text;
}

std::string kinds_log(const std::vector<Audit>& kinds) {
  std::string text = fmt::format("{:28}{:>7}{:>10}{:>10}{:>9}{:>10}\n", "asked for", "tasks",
                                 "s a task", "unsteady", "refused", "failures");
  const auto line = [&](const std::string& name, const Audit& audit) {
    const double tasks = std::max(audit.tasks, 1);
    text += fmt::format("{:28}{:7}{:10.3f}{:9.1f}%{:9}{:10}\n", name, audit.tasks,
                        audit.seconds / tasks, 100.0 * count_of(audit.statuses, "unsteady") / tasks,
                        audit.refused, audit.failures.size());
  };
  for (std::size_t k = 0; k < kinds.size(); ++k) line(all_kinds()[k].name, kinds[k]);
  line("all", sum_of(kinds));
  return text;
}

}  // namespace shigusa::bench
