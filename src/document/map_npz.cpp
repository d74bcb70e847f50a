// SPDX-License-Identifier: MIT
#include <shigusa/files.hpp>

#include "formats/npz.hpp"

namespace shigusa {

Result<std::string> map_npz(const BodyModel& body, const ReachMap& map) {
  std::vector<std::size_t> shape;
  std::vector<std::vector<double>> axes;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    std::vector<double>& along = axes.emplace_back();
    const int count = map.count[static_cast<std::size_t>(axis)];
    for (int k = 0; k < count; ++k) along.push_back(map.coordinate(axis, k));
    shape.push_back(along.size());
  }
  std::vector<std::int32_t> verdicts;
  std::vector<std::int32_t> dofs;
  std::vector<std::int32_t> rebas;
  std::vector<float> scores;
  std::vector<float> strengths;
  for (const MapPlace& place : map.places) {
    verdicts.push_back(place.verdict ? static_cast<std::int32_t>(*place.verdict) : -1);
    dofs.push_back(place.dof);
    rebas.push_back(place.reba.value_or(-1));
    scores.push_back(static_cast<float>(place.score));
    strengths.push_back(static_cast<float>(place.strength));
  }
  std::vector<std::string> joints;
  for (const Dof& dof : body.dofs()) joints.push_back(dof.name);
  return format_npz(
      std::vector<NpzArray>{{"x", {shape[0]}, axes[0]},
                            {"y", {shape[1]}, axes[1]},
                            {"z", {shape[2]}, axes[2]},
                            {"verdict", shape, verdicts},
                            {"verdicts", {all_words<Verdict>().size()}, all_words<Verdict>()},
                            {"score", shape, scores},
                            {"strength", shape, strengths},
                            {"reba", shape, rebas},
                            {"joint", shape, dofs},
                            {"joints", {joints.size()}, joints},
                            {"effector", {}, std::vector{map.effector}}});
}

}  // namespace shigusa
