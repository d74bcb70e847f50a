// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

/// Motions that the preset flat scores where a task says nothing else.
inline constexpr int kFlatEvaluations = 864;
/// Motions that the preset human scores, each of which takes two of the preset flat.
inline constexpr int kHumanEvaluations = 600;
/// Motions that the preset flat scores by NLP-IK, which takes some ten times as long for one and
/// knows no lanes.
inline constexpr int kNlpEvaluations = 300;

/// Candidates of the preset flat: what a person can look over.
inline constexpr int kFlatCandidates = 5;

/// How the parameters are searched and what they are.
enum class Preset {
  paper,   ///< the paper's own: 4-bit weights of all joints at once, its three criteria and its GA
  flat,    ///< all parameters at once: logarithmic weights, posture, path; limits held; CMA-ES
  layers,  ///< the paper's hierarchy: first trunk and limb lengths, then arms from a limb library
  human,   ///< three layers: trunk and limb lengths, the swivel of arms, then what no goal moves
};

/// The facts about a preset, which hold where a task says nothing else.
struct PresetTraits {
  /// The preset that these are of.
  Preset preset;
  /// Its word in files.
  std::string_view word;
  /// Its search in one phrase, as the end of a sentence.
  std::string_view about;
  /// The search of its parameters.
  SearchMethod search;
  /// The criteria that score its motions.
  CriteriaSettings (*criteria)();
  int candidates;                    ///< delivered at most
  int evaluations;                   ///< scored by searches that do not converge by themselves
  std::optional<LayerStack> layers;  ///< that it goes by
  /// As people do: joints keep to their limits, eyes and free limbs go by PostureLaw, and
  /// candidates differ by how they end; fingers play. The paper knows none of these, and tells
  /// whole motions apart.
  bool natural;
};
/// All presets, in the order of Preset.
inline constexpr std::array kPresets{
    PresetTraits{Preset::paper,
                 "paper",
                 "the paper's search as published",
                 SearchMethod::paper_ga,
                 paper_criteria,
                 kPaperPopulation,
                 kFlatEvaluations,
                 {},
                 false},
    PresetTraits{Preset::flat,
                 "flat",
                 "all parameters at once, within joint limits",
                 SearchMethod::cma_es,
                 default_criteria,
                 kFlatCandidates,
                 kFlatEvaluations,
                 {},
                 true},
    PresetTraits{Preset::layers, "layers",
                 "the paper's hierarchy, first trunk and limb lengths, then arms",
                 SearchMethod::paper_ga, paper_criteria, kPaperPopulation, kFlatEvaluations,
                 LayerStack::paper, false},
    PresetTraits{Preset::human, "human",
                 "first trunk and limb lengths, then elbows, then free arms", SearchMethod::cma_es,
                 default_criteria, kFlatCandidates, kHumanEvaluations, LayerStack::human, true},
};
/// The words of Preset.
template <>
inline constexpr auto kEnumWords<Preset> = words_of_table(kPresets, &PresetTraits::preset);

/// The traits of one preset.
[[nodiscard]] constexpr const PresetTraits& traits_of(Preset preset) {
  return kPresets[static_cast<std::size_t>(preset)];
}

inline constexpr std::size_t kGoalsMax = 64;  ///< more than any body can meet
/// The most obstacles of a task.
inline constexpr std::size_t kObstaclesMax = 64;
/// The most supports of a task.
inline constexpr std::size_t kSupportsMax = 8;
inline constexpr double kTaskDurationMin = 0.05;  ///< s
inline constexpr double kTaskDurationMax = 60.0;  ///< s
/// How much earlier or later a motion makes its way, at the most: beyond 1.3 it would turn back.
inline constexpr double kEaseMax = 0.8;
inline constexpr double kGazeLeadMost = 0.35;    ///< share of the duration, of a head that is early
inline constexpr double kGazeLeadLeast = -0.45;  ///< … and of one that is late
inline constexpr int kPhasesMax = 2;             ///< of old tasks, which are read and refused

/// The method that makes a motion from parameters.
enum class MotionGenerator {
  weighted_ik,  ///< the weighted pseudo-inverse (WeightedIk)
  nlp_ik,       ///< constrained minimisation in each frame (Zhao and Badler), always within limits
};

/// The words of MotionGenerator.
template <>
inline constexpr std::array kEnumWords<MotionGenerator>{
    EnumWord{MotionGenerator::weighted_ik, "weighted_ik"},
    EnumWord{MotionGenerator::nlp_ik, "nlp_ik"},
};

/// The play of a character's fingers, of which neither search nor criteria know.
enum class FingerPlay {
  grip,  ///< a reaching hand opens on the way and closes to a relaxed grip, the other is relaxed
  none,  ///< they stay as the file has them
};

/// The words of FingerPlay.
template <>
inline constexpr std::array kEnumWords<FingerPlay>{
    EnumWord{FingerPlay::grip, "grip"},
    EnumWord{FingerPlay::none, "none"},
};

/// The plain data of a task: all that its file holds beside the character. Ranges are checked by
/// generate(), whose errors state them.
struct Request {
  /// Final states of effectors, at most one of each effector and kGoalsMax in all.
  std::vector<Goal> goals{};
  /// m, world: the point that the eyes look at; empty: the first goal of a limb, or the middle of
  /// two hands' goals.
  std::optional<Vec3d> look_at{};
  /// Names of the feet that stay on the floor, at least one; empty: all feet without a goal. A foot
  /// that has neither a name here nor a goal lifts.
  std::optional<std::vector<std::string>> contacts{};
  /// Obstacles that the criterion `collision` measures, at most kObstaclesMax.
  std::vector<Obstacle> obstacles{};
  /// Hands without a goal that may rest on something, at most one support of each hand.
  std::vector<Support> supports{};
  /// s, kTaskDurationMin..kTaskDurationMax; empty: by the distance.
  std::optional<double> duration{};
  /// -kEaseMax..kEaseMax: above 0 the first half is quicker, below 0 the second; 0 is the minimum
  /// jerk. Not of presets with layers.
  double ease = 0.0;
  /// kGazeLeadLeast..kGazeLeadMost: share of the duration by which the head turns earlier than
  /// people's, below 0 later. Of the presets flat and human.
  double gaze_lead = 0.0;
  /// The parameters that are searched, and how; adopt_preset changes it with its criteria.
  Preset preset = Preset::flat;
  /// The parameters of the first layer, of presets with layers.
  LayerReading layer_reading = LayerReading::shared_contractions;
  /// The search algorithm; empty: the preset's own.
  std::optional<SearchMethod> search{};
  /// Whether candidates are a front of the criteria, of which none is better by all of them;
  /// adopt_pareto sets it. Of the preset flat.
  bool pareto = false;
  /// The criteria that score motions.
  CriteriaSettings criteria = traits_of(Preset::flat).criteria();
  /// Parameters that the search keeps: "squat_deg=60", "right_elbow.flexion.locked=true".
  std::vector<std::string> fixed_assignments{};
  /// The method that makes motions from parameters; nlp_ik not of presets with layers.
  MotionGenerator generator = MotionGenerator::weighted_ik;
  /// 1; kPhasesMax of old tasks, which are refused.
  int phases = 1;
  /// The motion of the character's fingers, where it has some.
  FingerPlay finger_play = FingerPlay::grip;
  /// The seed of all random numbers: the same seed gives the same motions.
  std::uint64_t seed = 0;
  /// The most candidates that are delivered, 1..1000.
  int candidates = traits_of(Preset::flat).candidates;
  /// The most motions that the search scores, from kPaperPopulation; empty: the paper's genetic
  /// algorithm runs until it converges, other algorithms score usual_evaluations.
  std::optional<int> evaluations{};
};

/// Gives the request a preset, with its criteria and number of candidates where it is another one.
void adopt_preset(Request& request, const Preset& preset);
/// Asks for a front of the criteria or for none; a front brings its own mixture of them.
void adopt_pareto(Request& request, const bool& pareto);

/// A foot that neither stands nor has a goal lifts by this (m).
inline constexpr double kFootLift = 0.10;

/// A request on a body, with the settings of its run: `generate` takes it. Another preset's
/// criteria and number of candidates come by with_preset.
struct Task : Request {
  /// The request on that body.
  explicit Task(BodyModel of, Request asked = {})
      : Request(std::move(asked)), body(std::move(of)) {}

  BodyModel body;               ///< in its start posture
  SearchFunction own_search{};  ///< in the place of the named ones, when given; not of layers
  GeneticSettings genetic{};    ///< of the searches paper_ga and log_ga, which take the task's seed
  /// The values of fixed_assignments, decoded: the search leaves them as they are.
  std::optional<FixedParameters> fixed{};
  /// Of the preset flat: motions that are known to be good for tasks like this one, as
  /// Candidate::parameters of a body with the same freedoms. The search scores them first and
  /// begins beside the best, as it does with its own table of such motions; 16 of them take that
  /// table's place, fewer are put before it. None changes nothing.
  std::vector<Parameters> starts{};
  int most_runs = 10;        ///< of the preset paper, see generate; ≥ 1
  LayeredSettings layers{};  ///< of layered presets
  BatchSettings batch{};     ///< SIMD set and threads; change no result
};

/// Motions that are scored for a task that does not say how many, but for the paper's search.
[[nodiscard]] int usual_evaluations(const Task& task);

/// The search of a task: the method that it names, or its preset's.
[[nodiscard]] SearchMethod search_of(const Task& task);

/// The task by a preset, with its criteria and number of candidates.
[[nodiscard]] Task with_preset(Task task, Preset preset);

/// The criteria that the task's motions are scored by: its own, with the eyes on look_at, or on the
/// first goal of a limb, or between those of two hands, where nothing else is said.
[[nodiscard]] CriteriaSettings task_criteria(const Task& task);

/// The parameters of the motions that a request's preset makes for its goals on a body. Fails where
/// a preset of several layers does not know the body, a goal or supports.
[[nodiscard]] Result<ParameterList> parameter_list(const BodyModel& body, const Request& request);

/// Whether some posture of the task's body on its feet meets the goals: a quick look that may miss
/// one. Fails where a foot or a goal is not one that motions can have.
[[nodiscard]] Result<bool> seems_in_reach(const Task& task);

/// Notes on goals of hands that may be an oversight: in the body's own head or a foot, where these
/// are at the start, below the floor (y < 0), or nearer to it than the hand is thick. They refuse
/// nothing.
[[nodiscard]] std::vector<Message> goal_notes(const Task& task);

}  // namespace shigusa
