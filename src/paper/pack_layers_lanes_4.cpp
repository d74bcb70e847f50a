// SPDX-License-Identifier: MIT
#include "pack_layers.hpp"

namespace shigusa {

std::unique_ptr<LayeredLanes> make_lanes_4_layers(const LayeredSetup& setup,
                                                  const CriteriaSettings& criteria) {
  return std::make_unique<PackLayers<4>>(setup, criteria);
}

}  // namespace shigusa
