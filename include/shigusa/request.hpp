// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <shigusa/criteria.hpp>
#include <shigusa/field.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/layered_settings.hpp>
#include <shigusa/search.hpp>
#include <shigusa/words.hpp>
#include <string>
#include <string_view>
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

/// The plain data of a task: all that its file says beside the character. Its table of fields,
/// below, says what each member is.
struct Request {
  /// The final places of effectors, each of another one.
  std::vector<Goal> goals{};
  std::optional<Vec3d> look_at{};  ///< m, world
  /// Names of feet, the base among them. A foot that lifts does so by kFootLift.
  std::optional<std::vector<std::string>> contacts{};
  /// Things that the criterion `collision` sees.
  std::vector<Obstacle> obstacles{};
  /// Hands that may rest on something, each another one.
  std::vector<Support> supports{};
  std::optional<double> duration{};  ///< s
  double ease = 0.0;                 ///< see its field
  double gaze_lead = 0.0;            ///< share of the duration
  /// The way in which parameters are searched.
  Preset preset = Preset::flat;
  /// The parameters of the first layer, of layered presets.
  LayerReading layer_reading = LayerReading::shared_contractions;
  /// The preset's own when not given.
  std::optional<SearchMethod> search{};
  bool pareto = false;  ///< see pareto_criteria
  /// The criteria that score its motions.
  CriteriaSettings criteria = traits_of(Preset::flat).criteria();
  std::vector<std::string> fixed_assignments{};              ///< "squat_deg=60"
  MotionGenerator generator = MotionGenerator::weighted_ik;  ///< the other not of layered presets
  int phases = 1;                             ///< 1; motions of two phases are no longer made
  FingerPlay finger_play = FingerPlay::grip;  ///< of characters that have fingers
  /// The same seed gives the same motions.
  std::uint64_t seed = 0;
  /// The most candidates that are delivered.
  int candidates = traits_of(Preset::flat).candidates;
  /// Without it the paper's genetic algorithm runs until it converges, and the others score
  /// usual_evaluations.
  std::optional<int> evaluations{};
};

/// Gives the request a preset, with its criteria and number of candidates where it is another one.
void adopt_preset(Request& request, const Preset& preset);
/// Asks for a front of the criteria or for none; a front brings its own mixture of them.
void adopt_pareto(Request& request, const bool& pareto);

/// The fields of a request.
template <>
inline constexpr FieldTable kFields<Request>{
    "task",
    "A request: a body and the final places of its hands, feet or other joints. Metres, kilograms, "
    "seconds, radians; +Y up, the body faces +Z, its left is +X, origin on the floor between the "
    "feet.",
    std::tuple{
        Field{"goals",
              &Request::goals,
              "The final places of effectors, such as right_hand, head, hips, left_elbow, "
              "right_knee, left_foot or any joint that `shigusa body` names: metres, +Y up, the "
              "body faces +Z, its left is +X. One for each effector at most; one at least is "
              "given, or a foot is left out of contacts.",
              {.high = kGoalsMax,
               .option = "--goal",
               .form = "EFFECTOR=X,Y,Z",
               .group = OptionGroup::goal,
               .brief = "Final place of a hand, foot, head or other joint, in metres",
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"look_at_m",
              &Request::look_at,
              "The point that the eyes are on; when not given, the first goal of a limb, or "
              "between two hands'.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .option = "--look-at",
               .form = "X,Y,Z",
               .group = OptionGroup::goal,
               .brief = "Point that the eyes are on (default: the goal)",
               .mirroring = Mirroring::other_side}},
        Field{"contacts",
              &Request::contacts,
              "Feet that stay on the floor, one at least; all without a goal when not given. A "
              "foot that is not named and has no goal lifts.",
              {.option = "--contacts",
               .form = "left_foot,right_foot",
               .group = OptionGroup::goal,
               .brief = "Feet that stay on the floor; a foot that is not named lifts",
               .mirroring = Mirroring::other_side}},
        Field{"obstacles",
              &Request::obstacles,
              "Things that nothing of the body should pass through; the command line knows boxes, "
              "by their middle and size in metres.",
              {.high = kObstaclesMax,
               .option = "--obstacle",
               .form = "NAME=X,Y,Z,SX,SY,SZ",
               .group = OptionGroup::around,
               .brief = "Box to keep out of: its middle and its size in metres",
               .mirroring = Mirroring::other_side}},
        Field{"support",
              &Request::supports,
              "Of the preset flat: hands without a goal that may rest on the thigh, or on an "
              "obstacle by its name, and do where it pays. What they press with, from 0 to 0.25 of "
              "the body's weight, is a parameter, such as left_hand.support; below 0 the hand "
              "stays free.",
              {.high = kSupportsMax,
               .option = "--support",
               .form = "HAND=PLACE",
               .group = OptionGroup::around,
               .brief = "Free hand that may rest on the thigh or on an obstacle",
               .mirroring = Mirroring::other_side}},
        Field{"duration_s",
              &Request::duration,
              "Seconds of the motion; from the distance when not given.",
              {.low = kTaskDurationMin,
               .high = kTaskDurationMax,
               .option = "--duration",
               .form = "SECONDS",
               .group = OptionGroup::motion,
               .brief = "Of the motion (default: from the distance)"}},
        Field{
            "ease",
            &Request::ease,
            "How early the motion makes its way: above 0 it is quicker in its first half and slows "
            "down for longer, below 0 it is slow to begin; 0, as people move, when not given. Not "
            "of presets with layers.",
            {.low = -kEaseMax,
             .high = kEaseMax,
             .option = "--ease",
             .form = "SHARE",
             .group = OptionGroup::motion,
             .brief = "Quicker to begin above 0, slower below (default 0)",
             .rare = true}},
        Field{"gaze_lead",
              &Request::gaze_lead,
              "The share of the duration by which the head turns earlier to what is looked at, or "
              "later below 0, than people's do; 0 when not given. Of the presets flat and human.",
              {.low = kGazeLeadLeast,
               .high = kGazeLeadMost,
               .option = "--gaze-lead",
               .form = "SHARE",
               .group = OptionGroup::motion,
               .brief = "How much earlier the head turns than people's do (default 0)",
               .rare = true}},
        Field{"preset",
              &Request::preset,
              "paper, as published; flat, when not given: all parameters at once, within joint "
              "limits; layers: the paper's hierarchy, first trunk and limb lengths, then arms; or "
              "human: trunk and limb lengths, then the elbows' swivel, then free arms. Criteria, "
              "search and number of candidates are its own where nothing else is said.",
              {.option = "--preset",
               .group = OptionGroup::search,
               .brief = "Parameters, criteria and search together (default flat)",
               .written = always,
               .adopt = adopt_preset}},
        Field{"layer_reading",
              &Request::layer_reading,
              "Of the presets layers and human, the meaning of the paper's 14 parameters of the "
              "whole body: shared_contractions, when not given: 12 weights and 2 contractions, or "
              "contraction_a_limb: 10 and 4.",
              {.option = "--layer-reading",
               .group = OptionGroup::search,
               .brief = "What the paper's 14 parameters of the whole body are",
               .rare = true,
               .written =
                   [](const Request& request) {
                     return traits_of(request.preset).layers.has_value();
                   }}},
        Field{"search",
              &Request::search,
              "The algorithm; the preset's own when not given.",
              {.option = "--search",
               .group = OptionGroup::search,
               .brief = "Algorithm (default: the preset's)",
               .rare = true}},
        Field{"pareto",
              &Request::pareto,
              "Of the preset flat: candidates are a front of the criteria, motions of which none "
              "is better by all of them; criteria are then the mixture pareto where nothing else "
              "is said.",
              {.option = "--pareto",
               .group = OptionGroup::search,
               .brief = "Deliver a front of the criteria (preset flat)",
               .rare = true,
               .adopt = adopt_pareto}},
        Field{"criteria",
              &Request::criteria,
              "The mixture that motions are scored by: paper, default or pareto, or in files "
              "weights and scales; the preset's own when not given.",
              {.option = "--criteria",
               .group = OptionGroup::search,
               .brief = "Mixture that motions are scored by (default: the preset's)",
               .written = always}},
        Field{"fixed",
              &Request::fixed_assignments,
              "Parameters that the search leaves as given, such as squat_deg=60 or "
              "right_shoulder.flexion.locked=true (as --set of edit).",
              {.option = "--fix",
               .form = "NAME=VALUE",
               .group = OptionGroup::search,
               .brief = "Parameter that the search leaves as given: squat_deg=60",
               .mirroring = Mirroring::assignments}},
        Field{"generator",
              &Request::generator,
              "The maker of motions from parameters: weighted_ik when not given, or nlp_ik, "
              "constrained minimisation in each frame, ten times slower.",
              {.option = "--generator",
               .group = OptionGroup::search,
               .brief = "Maker of motions from parameters (default weighted_ik)",
               .rare = true}},
        Field{"phases",
              &Request::phases,
              "1: motions have one phase. Old tasks with 2 are refused with what to write.",
              {.low = 1, .high = kPhasesMax}},
        Field{
            "finger_play",
            &Request::finger_play,
            "Of a character with fingers, by the presets flat and human: grip, when not given: a "
            "reaching hand opens "
            "on the way and closes to a relaxed grip, the other is relaxed; or none: fingers stay "
            "as the file has them.",
            {.option = "--finger-play",
             .group = OptionGroup::motion,
             .brief = "none leaves fingers as the file has them (default grip)",
             .rare = true}},
        Field{"seed",
              &Request::seed,
              "Same seed, same bytes; 0 when not given.",
              {.high = UINT64_MAX,
               .option = "--seed",
               .form = "N",
               .group = OptionGroup::search,
               .brief = "Same seed, same bytes (default 0)",
               .written = always}},
        Field{"candidates",
              &Request::candidates,
              "Candidates to deliver, at most; the preset's own number when not given.",
              {.low = 1,
               .high = 1000,
               .option = "--candidates",
               .form = "N",
               .group = OptionGroup::search,
               .brief = "Motions to deliver at most (default: the preset's)",
               .written = always}},
        Field{"evaluations",
              &Request::evaluations,
              "Motions that the search may score: it starts again, with other random numbers, "
              "until they are used up. When not given, it runs once.",
              {.low = kPaperPopulation,
               .high = 1'000'000'000,
               .option = "--evaluations",
               .form = "N",
               .group = OptionGroup::search,
               .brief = "Motions that the search may score (default: it runs once)",
               .rare = true}},
    }};

}  // namespace shigusa
