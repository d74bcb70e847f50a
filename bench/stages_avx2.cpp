// SPDX-License-Identifier: MIT
#include "pack_stages.hpp"

namespace shigusa::bench {

std::unique_ptr<Stages> make_avx2_stages(const StagesInput& input) {
  return std::make_unique<PackStages<Pack<float, 8>>>(input);
}

}  // namespace shigusa::bench
