// SPDX-License-Identifier: MIT
#include "pack_stages.hpp"

namespace shigusa::bench {

std::unique_ptr<Stages> make_avx512_stages(const StagesInput& input) {
  return std::make_unique<PackStages<Pack<float, 16>>>(input);
}

}  // namespace shigusa::bench
