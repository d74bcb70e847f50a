// SPDX-License-Identifier: MIT
// The pack has another name here, so that the linker does not use code with fused multiply-add for
// the other kernels.
#define Pack FusedPack
#include "pack_stages.hpp"

namespace shigusa::bench {

std::unique_ptr<Stages> make_avx2_fma_stages(const StagesInput& input) {
  return std::make_unique<PackStages<Pack<float, 8>>>(input);
}

}  // namespace shigusa::bench
