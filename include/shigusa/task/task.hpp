// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/body/body_model.hpp>
#include <shigusa/core/enum_words.hpp>
#include <shigusa/core/result.hpp>
#include <shigusa/criteria/criteria.hpp>
#include <shigusa/layers/layered_settings.hpp>
#include <shigusa/layers/plan.hpp>
#include <shigusa/rollout/batch_rollout.hpp>
#include <shigusa/rollout/goal.hpp>
#include <shigusa/rollout/parameters.hpp>
#include <shigusa/search/genetic.hpp>
#include <shigusa/search/searches.hpp>
#include <string>
#include <vector>

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

// A foot that neither stands nor has a goal lifts by this (m).
inline constexpr double kFootLift = 0.10;

// A goal's coordinates may not exceed this (m): nobody reaches so far, and numbers stay harmless.
inline constexpr double kGoalRange = 100.0;
inline constexpr std::size_t kObstaclesMax = 64;
inline constexpr double kTaskDurationMin = 0.05;  // s
inline constexpr double kTaskDurationMax = 60.0;  // s

inline constexpr int kPhasesMax = 2;  // weights and posture change once at most

// What generates a motion from parameters.
enum class MotionGenerator {
  weighted_ik,  // the weighted pseudo-inverse (WeightedIk)
  nlp_ik,       // constrained minimisation in each frame (Zhao and Badler), always within limits
};

template <>
inline constexpr std::array kEnumWords<MotionGenerator>{
    EnumWord{MotionGenerator::weighted_ik, "weighted_ik"},
    EnumWord{MotionGenerator::nlp_ik, "nlp_ik"},
};

// What is asked for. Another preset's criteria and number of candidates come by with_preset.
struct Task {
  BodyModel body;
  std::vector<Goal> goals{};         // 1 or more, each for another effector
  std::optional<double> duration{};  // s; from the distance (reach_duration) when not given
  Preset preset = Preset::flat;
  std::vector<Obstacle> obstacles{};  // at most kObstaclesMax; the criterion `collision` sees them
  CriteriaSettings criteria = default_criteria();
  std::optional<SearchMethod> search{};  // the preset's own when not given
  SearchFunction own_search{};           // in the place of all these, when given; not of layers
  std::uint64_t seed = 0;
  GeneticSettings genetic{};  // of the searches paper_ga and log_ga, which take the task's seed
  // What the search leaves as it is; nothing when not given.
  std::optional<FixedParameters> fixed{};
  int candidates = kFlatCandidates;  // at most so many are delivered, ≥ 1
  // Of the preset flat: candidates are those of which none is better by joint range, balance and
  // torque at once, each the best of a search by other weights of the three (see pareto.hpp).
  bool pareto = false;
  MotionGenerator generator = MotionGenerator::weighted_ik;  // not of layered presets
  // Of the preset flat: 2 looks for a LaterPhase too, twice as many parameters.
  int phases = 1;
  // Motions that the search may score, at least a population's. When given, every search uses all
  // of them: it starts again, with other random numbers, until they are used up. When not, the
  // paper's genetic algorithm runs until it converges, and the others score usual_evaluations.
  std::optional<int> evaluations{};
  int most_runs = 10;              // of the preset paper, see generate; ≥ 1
  LayeredSettings layers{};        // of layered presets
  BatchSettings batch{};           // SIMD set and threads; change no result
  std::optional<Vec3d> look_at{};  // m, world: what the eyes are on; else the first goal of a limb
  // Feet that stay on the floor, the base among them; when not given all without a goal. A foot
  // that is neither among them nor has a goal lifts by kFootLift.
  std::optional<std::vector<std::string>> contacts{};
};

// Motions that are scored for a task that does not say how many, but for the paper's search.
[[nodiscard]] int usual_evaluations(const Task& task);

// What searches for a task: the method that it names, or its preset's.
[[nodiscard]] SearchMethod search_of(const Task& task);

// The task by a preset, with its criteria and number of candidates.
[[nodiscard]] Task with_preset(Task task, Preset preset);

// What the task's motions are scored by: its criteria, with the eyes on look_at, or on the first
// goal of a limb where nothing else is said.
[[nodiscard]] CriteriaSettings task_criteria(const Task& task);

// The plan that a preset has for a body's goals; `criteria` are those of its layers. Fails where a
// preset of several layers does not know the body or a goal (layers_to_goals).
[[nodiscard]] Result<Plan> plan_of(const BodyModel& body, std::span<const Goal> goals,
                                   Preset preset, LayerReading reading,
                                   const CriteriaSettings& criteria = {});
[[nodiscard]] Result<Plan> plan_of(const Task& task);

// The task with its goals' loads in the body's hands, standing on its contacts; fails as
// make_problem does, and where a foot has no way to be what is asked of it.
[[nodiscard]] Result<Task> prepared(const Task& task);
// Whether that is another task.
[[nodiscard]] bool needs_preparing(const Task& task);

// The problem that a task poses to the search: paths from the start posture to the goals, and the
// time for them. Fails with a message that names the goal and what is allowed: unknown effector
// (with the nearest name), two goals for one effector, coordinates that are not finite or beyond
// kGoalRange, no goal at all, a duration outside 0.05 to 60 s, criteria weights below 0 or all 0,
// phases that the preset does not know or that a fixed parameter is not of, a load, an obstacle, a
// rotation, an axis or a box out of range, more goals than kMaxIkRows allows.
// The problem points into the task.
[[nodiscard]] Result<ReachProblem> make_problem(const Task& task);

}  // namespace shigusa
