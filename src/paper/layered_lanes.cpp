// SPDX-License-Identifier: MIT
#include "paper/layered_lanes.hpp"

#include <algorithm>
#include <array>
#include <shigusa/run.hpp>

#include "simd/usable_set.hpp"

namespace shigusa {
namespace {

// in the order of SimdSet
constexpr std::array kMakers{
#ifdef __wasm_simd128__
    make_lanes_4_layers,  // a module has no scalar set, which require_usable refuses
#else
    make_scalar_layers,
#endif
    make_lanes_4_layers,
#ifdef SHIGUSA_HAS_AVX
    make_avx2_layers,
    make_avx512_layers,
#endif
};

}  // namespace

struct LayeredBatch::Call {
  LayeredInputs inputs;
  std::size_t lanes;
  std::span<double> scores;
  std::span<float> final_angles;
  std::vector<Vec3d> hands;  // (motions × goals)
  std::vector<float> arms;   // (motions × arms by weights × kArmDofs)

  [[nodiscard]] std::size_t motions() const { return scores.size(); }
  [[nodiscard]] std::size_t first(std::size_t batch) const { return batch * lanes; }
  [[nodiscard]] std::size_t count(std::size_t batch) const {
    return std::min(lanes, motions() - first(batch));
  }
  // The rows of a batch.
  template <class T>
  [[nodiscard]] std::span<T> rows(std::span<T> all, std::size_t batch) const {
    const std::size_t columns = all.size() / motions();
    return all.subspan(first(batch) * columns, count(batch) * columns);
  }
};

LayeredBatch::LayeredBatch(const LayeredSetup& setup, const CriteriaSettings& criteria,
                           const BatchSettings& settings)
    : setup_(&setup),
      criteria_(&criteria),
      settings_(settings),
      lanes_(index(thread_count(settings.threads))) {
  require_usable(settings.simd);
}

LayeredBatch::~LayeredBatch() = default;

LayeredLanes& LayeredBatch::lanes(std::size_t slot) {
  if (!lanes_[slot])
    lanes_[slot] = kMakers[static_cast<std::size_t>(settings_.simd)](*setup_, *criteria_);
  return *lanes_[slot];
}

std::size_t LayeredBatch::arms_by_weights() const {
  std::size_t count = 0;
  for (const LayeredSetup::GoalArm& arm : setup_->arms) count += arm.by_swivel ? 0 : 1;
  return count;
}

void LayeredBatch::run_upper(Call& call, std::size_t batch, std::size_t slot) {
  lanes(slot).run_upper(call.inputs.part(call.first(batch), call.count(batch), call.motions()),
                        call.rows(std::span(call.hands), batch));
}

// Chooses the arms' weights on one thread, which may have to build libraries.
void LayeredBatch::choose_arms(Call& call, const ChooseArms& choose, std::size_t first,
                               std::size_t count) {
  const std::size_t goals = setup_->arms.size();
  for (std::size_t i = first; i < first + count; ++i) {
    const std::vector<float> arms =
        choose(std::span<const Vec3d>(call.hands).subspan(i * goals, goals));
    call.arms.insert(call.arms.end(), arms.begin(), arms.end());
  }
}

void LayeredBatch::expand(Call& call, std::size_t batch, std::size_t slot) {
  LayeredInputs part = call.inputs.part(call.first(batch), call.count(batch), call.motions());
  const std::size_t columns = kArmDofs * arms_by_weights();
  part.arms = std::span<const float>(call.arms).subspan(call.first(batch) * columns,
                                                        call.count(batch) * columns);
  lanes(slot).expand(part, call.rows(call.scores, batch), call.rows(call.final_angles, batch));
}

void LayeredBatch::score(const LayeredInputs& inputs, const ChooseArms& choose,
                         std::span<double> scores, std::span<float> final_angles) {
  if (scores.empty()) return;
  Call call{inputs,
            index(simd_lanes(settings_.simd)),
            scores,
            final_angles,
            std::vector<Vec3d>(scores.size() * setup_->arms.size()),
            {}};
  const std::size_t batches = (scores.size() + call.lanes - 1) / call.lanes;
  if (arms_by_weights() == 0) {
    parallel_for(static_cast<int>(batches), settings_.threads, [&](int batch, int worker) {
      run_upper(call, index(batch), index(worker));
      expand(call, index(batch), index(worker));
    });
    return;
  }
  // one batch per thread at a time, since each keeps its upper motions meanwhile
  for (std::size_t first = 0; first < batches; first += lanes_.size()) {
    const std::size_t some = std::min(lanes_.size(), batches - first);
    const auto each = [&](auto work) {
      parallel_for(static_cast<int>(some), settings_.threads,
                   [&](int slot, int) { (this->*work)(call, first + index(slot), index(slot)); });
    };
    each(&LayeredBatch::run_upper);
    const std::size_t motion = call.first(first);
    choose_arms(call, choose, motion, std::min(some * call.lanes, scores.size() - motion));
    each(&LayeredBatch::expand);
  }
}

}  // namespace shigusa
