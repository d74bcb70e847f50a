// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/core/enum_words.hpp>
#include <shigusa/criteria/criteria_settings.hpp>
#include <shigusa/layers/layered_settings.hpp>
#include <shigusa/search/searches.hpp>
#include <string_view>

namespace shigusa {

// Motions that the preset flat scores where a task says nothing else.
inline constexpr int kFlatEvaluations = 1800;
// The same of the preset human, whose upper motions are played in double one by one, each with a
// few swivels of its arms.
inline constexpr int kHumanEvaluations = 600;
// The same of the preset flat by NLP-IK, which takes some ten times as long for one and knows no
// lanes.
inline constexpr int kNlpEvaluations = 300;

// Candidates of the preset flat: what a person can look over.
inline constexpr int kFlatCandidates = 5;

// How the parameters are searched and what they are.
enum class Preset {
  paper,   // the paper's own: 4-bit weights of all joints at once, its three criteria and its GA
  flat,    // all parameters at once: logarithmic weights, posture, path; limits held; CMA-ES
  layers,  // the paper's hierarchy: first trunk and limb lengths, then arms from a limb library
  human,   // three layers: trunk and limb lengths, the swivel of arms, then what no goal moves
};

// What a preset is, and has where a task says nothing else.
struct PresetTraits {
  Preset preset;
  std::string_view word;
  SearchMethod search;
  CriteriaSettings (*criteria)();
  int candidates;                    // delivered at most
  int evaluations;                   // scored by searches that do not converge by themselves
  std::optional<LayerStack> layers;  // that it goes by
  // As people do: joints keep to their limits, eyes and free limbs go by PostureLaw, and candidates
  // differ by how they end. The paper knows none of these, and tells whole motions apart.
  bool natural;
};
inline constexpr std::array kPresets{
    PresetTraits{Preset::paper,
                 "paper",
                 SearchMethod::paper_ga,
                 paper_criteria,
                 kPaperPopulation,
                 kFlatEvaluations,
                 {},
                 false},
    PresetTraits{Preset::flat,
                 "flat",
                 SearchMethod::cma_es,
                 default_criteria,
                 kFlatCandidates,
                 kFlatEvaluations,
                 {},
                 true},
    PresetTraits{Preset::layers, "layers", SearchMethod::paper_ga, paper_criteria, kPaperPopulation,
                 kFlatEvaluations, LayerStack::paper, false},
    PresetTraits{Preset::human, "human", SearchMethod::cma_es, default_criteria, kFlatCandidates,
                 kHumanEvaluations, LayerStack::human, true},
};
template <>
inline constexpr auto kEnumWords<Preset> = words_of_table(kPresets, &PresetTraits::preset);

[[nodiscard]] constexpr const PresetTraits& traits_of(Preset preset) {
  return kPresets[static_cast<std::size_t>(preset)];
}

}  // namespace shigusa
