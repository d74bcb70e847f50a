// SPDX-License-Identifier: MIT
#include <shigusa/dataset_export.hpp>

#include "export_npy.hpp"

namespace shigusa {

Result<std::string> map_npz(const BodyModel& body, const ReachMap& map) {
  npy::Shape shape;
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
  return npy::archive({{"x", npy::doubles(axes[0], {shape[0]})},
                       {"y", npy::doubles(axes[1], {shape[1]})},
                       {"z", npy::doubles(axes[2], {shape[2]})},
                       {"verdict", npy::integers(verdicts, shape)},
                       {"verdicts", npy::texts(all_words<Verdict>())},
                       {"score", npy::floats(scores, shape)},
                       {"strength", npy::floats(strengths, shape)},
                       {"reba", npy::integers(rebas, shape)},
                       {"joint", npy::integers(dofs, shape)},
                       {"joints", npy::texts(joints)},
                       {"effector", npy::text(map.effector)}});
}

}  // namespace shigusa
