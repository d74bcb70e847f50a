// SPDX-License-Identifier: MIT
#include "pack_stages.hpp"

namespace shigusa::bench {

std::unique_ptr<Stages> make_lanes_4_stages(const StagesInput& input) {
  return std::make_unique<PackStages<Pack<float, 4>>>(input);
}

}  // namespace shigusa::bench
