// SPDX-License-Identifier: MIT
#include "pack_layers.hpp"

namespace shigusa {

std::unique_ptr<LayeredLanes> make_scalar_layers(const LayeredSetup& setup,
                                                 const CriteriaSettings& criteria) {
  return std::make_unique<PackLayers<1>>(setup, criteria);
}

}  // namespace shigusa
