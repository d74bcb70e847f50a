// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <shigusa/action.hpp>
#include <shigusa/body.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/ergonomics.hpp>
#include <shigusa/error.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/habit.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/run.hpp>
#include <shigusa/search.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

/// Default evaluations of the preset flat.
inline constexpr int kFlatEvaluations = 864;
/// Default evaluations of the preset human, each as costly as two of the preset flat.
inline constexpr int kHumanEvaluations = 600;
/// Default evaluations with MotionGenerator::nlp_ik, which takes some ten times as long per motion
/// and has no SIMD.
inline constexpr int kNlpEvaluations = 300;

/// Default candidates of the preset flat.
inline constexpr int kFlatCandidates = 5;

/// The parameters of motions, and their search and criteria, under one name.
enum class Preset {
  paper,  ///< as published: 4-bit weights of all dofs, the paper's three criteria and genetic
          ///< algorithm
  flat,   ///< all parameters at once: logarithmic weights, posture, path; joint limits held; CMA-ES
  layers,  ///< the paper's hierarchy: trunk and limb lengths, then arms from a limb library
  human,   ///< three layers: trunk and limb lengths, swivel of arms, idle limbs
};

/// The defaults and facts of a preset.
struct PresetTraits {
  /// The preset.
  Preset preset;
  /// Word in files.
  std::string_view word;
  /// Description, one phrase.
  std::string_view about;
  /// Default search.
  SearchMethod search;
  /// Default criteria.
  CriteriaSettings (*criteria)();
  int candidates;                    ///< default number of candidates
  int evaluations;                   ///< default evaluations of searches without convergence
  std::optional<LayerStack> layers;  ///< stack of layers; empty: none
  /// Whether motions are made natural: joint limits hold, eyes, fingers and idle limbs move as
  /// people's do, and candidates differ in their final postures. The paper's presets do none of
  /// this and compare whole motions.
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

inline constexpr std::size_t kGoalsMax = 64;  ///< largest number of goals
/// Largest number of obstacles.
inline constexpr std::size_t kObstaclesMax = 64;
/// Largest number of supports.
inline constexpr std::size_t kSupportsMax = 8;
inline constexpr double kTaskDurationMin = 0.05;  ///< shortest duration, s
inline constexpr double kTaskDurationMax = 60.0;  ///< longest duration, s
/// Largest magnitude of Request::ease; beyond 1.3 a motion would turn back.
inline constexpr double kEaseMax = 0.8;
inline constexpr double kGazeLeadMost =
    0.35;  ///< largest gaze_lead: head early, share of the duration
inline constexpr double kGazeLeadLeast =
    -0.45;                            ///< smallest gaze_lead: head late, share of the duration
inline constexpr int kPhasesMax = 2;  ///< value of old tasks, which are refused

/// The method that makes a motion from parameters.
enum class MotionGenerator {
  weighted_ik,  ///< weighted pseudo-inverse
  nlp_ik,       ///< constrained minimisation in each frame (Zhao and Badler), within joint limits
};

/// The words of MotionGenerator.
template <>
inline constexpr std::array kEnumWords<MotionGenerator>{
    EnumWord{MotionGenerator::weighted_ik, "weighted_ik"},
    EnumWord{MotionGenerator::nlp_ik, "nlp_ik"},
};

/// The motion of a character's fingers, which neither search nor criteria consider.
enum class FingerPlay {
  grip,  ///< a reaching hand opens on the way and closes to a relaxed grip; the other is relaxed
  none,  ///< fingers stay as in the file
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
  /// Actions that follow each other, at most kActionsMax, in place of goals; see perform().
  std::vector<Action> actions{};
  /// Things that actions grasp and that nothing else passes through, at most kThingsMax.
  std::vector<Thing> things{};
  /// Path of a GLB or glTF file whose meshes are further obstacles and things; add_scene adds them
  /// and empties it.
  std::string scene{};
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
  /// The person's way of moving; adopt_habit changes it with its weight. Of the presets flat and
  /// human.
  Habit habit{};
  /// The parameters that are searched, and how; adopt_preset changes it with its criteria.
  Preset preset = Preset::flat;
  /// The reading of the parameters of the first layer; only for presets with layers.
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
  /// The method that makes motions from parameters; nlp_ik does not support presets with layers.
  MotionGenerator generator = MotionGenerator::weighted_ik;
  /// Number of phases: 1. Tasks with more are refused.
  int phases = 1;
  /// The motion of the character's fingers, where it has some.
  FingerPlay finger_play = FingerPlay::grip;
  /// Whether results tell what each motion costs the body, see motion_cost.
  bool cost = false;
  /// Facts that a motion does not tell, for its cost.
  Ergonomics ergonomics{};
  /// The seed of all random numbers: the same seed gives the same motions.
  std::uint64_t seed = 0;
  /// Largest number of candidates delivered, 1..1000.
  int candidates = traits_of(Preset::flat).candidates;
  /// Largest number of motions that the search scores, at least kPaperPopulation; empty: the
  /// paper's genetic algorithm runs until it converges, other algorithms score usual_evaluations.
  std::optional<int> evaluations{};
};

/// Sets the preset of a request; if it changes, also the preset's criteria and number of
/// candidates.
void adopt_preset(Request& request, const Preset& preset);
/// Factor on the weight of coordination for a person's own knees: one person differs less from
/// reach to reach than people do from each other.
inline constexpr double kOwnKneesWeigh = 4.0;
/// Sets the habit of a request, and with knees of its own also the weight of coordination.
void adopt_habit(Request& request, const Habit& habit);
/// Sets Request::pareto; turning it on also sets pareto_criteria().
void adopt_pareto(Request& request, const bool& pareto);

/// Height (m) to which a foot without contact and goal lifts.
inline constexpr double kFootLift = 0.10;

/// A request on a body, with the settings of a run; the input of generate(). with_preset changes
/// the preset together with its criteria and number of candidates.
struct Task : Request, PosedBody {
  /// Combines a body in its state and a request.
  explicit Task(PosedBody of, Request asked = {})
      : Request(std::move(asked)), PosedBody(std::move(of)), start(home) {}

  /// The state in which motions begin, with the feet on the floor that stand: home, or the end of
  /// another motion. Presets with layers begin at rest.
  State start;
  SearchFunction
      own_search{};  ///< user-defined search in place of `search`; not for presets with layers
  GeneticSettings genetic{};  ///< settings of paper_ga and log_ga, whose seed is the task's
  /// Fixed parameters, decoded from fixed_assignments; the search keeps them.
  std::optional<FixedParameters> fixed{};
  /// Initial guesses for the preset flat: parameters of good motions of similar tasks
  /// (Candidate::parameters of a body with the same dofs). The search scores them first and begins
  /// near the best, as with its built-in table; 16 or more replace that table, fewer precede it. An
  /// empty list has no effect.
  std::vector<Parameters> starts{};
  int most_runs = 10;        ///< most runs of the preset paper, see generate; ≥ 1
  LayeredSettings layers{};  ///< settings of presets with layers
  BatchSettings batch{};     ///< SIMD set and threads; they do not change results
};

/// Default number of evaluations of a task whose search is not the paper's.
[[nodiscard]] int usual_evaluations(const Task& task);

/// The search method of a task: its own, or its preset's.
[[nodiscard]] SearchMethod search_of(const Task& task);

/// The task with another preset, and the preset's criteria and number of candidates.
[[nodiscard]] Task with_preset(Task task, Preset preset);

/// The circumstances in which the task's motions are scored. The gaze target is look_at, else the
/// first goal of a limb, or the middle of two hands' goals.
[[nodiscard]] CriteriaContext criteria_context(const Task& task);

/// The parameters of a request's motions on a body that begins in a state. Fails if a preset with
/// layers does not support the body, a goal or supports.
[[nodiscard]] Result<ParameterList> parameter_list(const BodyModel& body, const State& start,
                                                   const Request& request);

/// Whether some posture of the task's body on its feet meets the goals: a quick test, whose "no"
/// may be wrong. Fails on an invalid foot or goal.
[[nodiscard]] Result<bool> seems_in_reach(const Task& task);

/// Warnings about likely mistakes in hand goals: inside the body's own head or a foot at the start,
/// below the floor (y < 0), or nearer to the floor than half the hand's thickness. They are not
/// errors.
[[nodiscard]] std::vector<Message> goal_notes(const Task& task);

}  // namespace shigusa
