// SPDX-License-Identifier: MIT
#include "audit.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace shigusa::bench {
namespace {

constexpr double kMillimetre = 1e3;
constexpr double kDegree = 180.0 / kPi;
constexpr std::array<PromiseInfo, kPromises> kInfo{{
    {"goal that is told as met", "a goal is missed", kPlaced, kMillimetre, " mm"},
    {"its rotation", "a rotation is missed", kTurned, kDegree, "°"},
    {"planted foot slides", "a foot slides", kPlaced, kMillimetre, " mm"},
    {"planted foot tilts", "a foot tilts", kTilted, kDegree, "°"},
    {"joint beyond its limit, not told", "a limit is passed", kTilted, kDegree, "°"},
    {"bone in an obstacle, told as free", "a bone is in an obstacle", kBoneInBox, kMillimetre,
     " mm"},
    {"seated person's hips off their height", "hips are off the seat", kPlaced, kMillimetre, " mm"},
    {"heel's height beside what is told", "a heel is not as high as told", kTold, kMillimetre,
     " mm"},
    {"resting hand slides", "a resting hand slides", kPlaced, kMillimetre, " mm"},
    {"resting hand off its box", "a resting hand is off its box", kPlaced, kMillimetre, " mm"},
    {"torque beside what is told", "a torque is not as told", kTorqueDiffers, 100.0,
     " % of the strength and swing"},
}};

void add_counts(const std::map<std::string, int>& counts, std::map<std::string, int>& to) {
  for (const auto& [name, count] : counts) to[name] += count;
}

}  // namespace

const PromiseInfo& info_of(Promise promise) { return kInfo[static_cast<std::size_t>(promise)]; }

void Audit::add(const Audit& part) {
  for (int Audit::*sum :
       {&Audit::tasks, &Audit::refused, &Audit::candidates, &Audit::over_limit, &Audit::fleshed,
        &Audit::through, &Audit::torques, &Audit::resting, &Audit::rest_through}) {
    this->*sum += part.*sum;
  }
  seconds += part.seconds;
  add_counts(part.statuses, statuses);
  add_counts(part.verdicts, verdicts);
  add_counts(part.best, best);
  for (std::size_t k = 0; k < kPromises; ++k) worst[k] = std::fmax(worst[k], part.worst[k]);
  head = std::fmax(head, part.head);
  shank = std::fmax(shank, part.shank);
  failures.insert(failures.end(), part.failures.begin(), part.failures.end());
}

void Audit::require(bool kept, const std::string& what) {
  if (!kept) failures.push_back(what + "\n" + place);
}

void Audit::most(Promise promise, double value, const std::string& of) {
  double& most = worst[static_cast<std::size_t>(promise)];
  most = std::fmax(most, value);
  const PromiseInfo& info = info_of(promise);
  if (value <= info.allowed) return;
  require(false, fmt::format("{}: {:.4g}{}{}{}", info.what, info.scale * value, info.unit,
                             of.empty() ? "" : ", ", of));
}

}  // namespace shigusa::bench
