// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/request.hpp>
#include <tuple>

#include "core/field.hpp"
#include "problem/ergonomics_fields.hpp"

namespace shigusa {

// Bounds of a thing's sides (m), and of turns (degrees).
inline constexpr double kThingLeast = 0.005;
inline constexpr double kThingMost = 5.0;
inline constexpr double kTurnMost = 360.0;
// Least length of the direction of a handle.
inline constexpr double kBarLeast = 1e-6;

// The fields of an obstacle.
template <>
inline constexpr FieldTable kFields<Obstacle>{
    "obstacle",
    "A box with round edges: without size_m a sphere, with size along one axis a capsule.",
    std::tuple{
        Field{"name", &Obstacle::name, "For messages.", {.written = always}},
        Field{"position_m",
              &Obstacle::position,
              "Its middle.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"size_m",
              &Obstacle::size,
              "Along its own axes.",
              {.high = kGoalRange, .written = always}},
        Field{"radius_m",
              &Obstacle::radius,
              "Of its round edges, beyond the size on all sides.",
              {.high = kGoalRange, .written = always}},
        Field{"rotation_xyzw",
              &Obstacle::rotation,
              "A unit quaternion.",
              {.mirroring = Mirroring::other_side, .written = always}},
    }};

// The fields of a support.
template <>
inline constexpr FieldTable kFields<Support>{
    "support", "A hand without a goal, and what it rests on.",
    std::tuple{
        Field{"effector",
              &Support::effector,
              "left_hand or right_hand.",
              {.required = true, .mirroring = Mirroring::other_side, .written = always}},
        Field{"on",
              &Support::on,
              "thigh: that of the hand's own side, a little above the knee; or the name of an "
              "obstacle.",
              {.required = true, .written = always}},
    }};

// The fields of a goal's axis.
template <>
inline constexpr FieldTable kFields<GoalAxis>{
    "goal_axis", "An axis of the effector and the direction that it is to have.",
    std::tuple{
        Field{"axis",
              &GoalAxis::axis,
              "In the effector's own frame; of hands also by a word.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"direction",
              &GoalAxis::direction,
              "In the world.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
    }};

// The fields of a goal.
template <>
inline constexpr FieldTable kFields<Goal>{
    "goal", "The final place of one effector, and how it is turned there.",
    std::tuple{
        Field{"effector",
              &Goal::effector,
              "right_hand, left_foot, head, hips or another joint of the body: left or right "
              "shoulder, elbow, wrist, hip, knee, foot, toes, clavicle; spine, chest, neck; or the "
              "name of another node.",
              {.required = true, .mirroring = Mirroring::other_side, .written = always}},
        Field{"position_m",
              &Goal::position,
              "In the world.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"load_kg",
              &Goal::load,
              "The mass that a hand with a goal holds all the way.",
              {.high = kLoadMax,
               .option = "--load",
               .form = "EFFECTOR=KILOGRAMS",
               .group = OptionGroup::goal,
               .brief = "Mass that a hand with a goal holds all the way"}},
        Field{"rotation_xyzw",
              &Goal::rotation,
              "How the effector is turned at the end, a unit quaternion: from the world's axes, "
              "which its own are where the body stands upright facing +Z with arms hanging and "
              "thumbs ahead.",
              {.option = "--rotation",
               .form = "EFFECTOR=X,Y,Z,W",
               .group = OptionGroup::goal,
               .brief = "How the effector is turned at the end: a unit quaternion",
               .rare = true,
               .mirroring = Mirroring::other_side}},
        Field{"axis",
              &Goal::axis,
              "In place of a rotation: an axis of the effector and the direction that it is to "
              "have; the effector may turn about it.",
              {.mirroring = Mirroring::other_side}},
        Field{"tolerance_m",
              &Goal::tolerance,
              "Half the sides, along the world's axes, of a box about the goal: anywhere in it "
              "will do.",
              {.high = kToleranceMax,
               .option = "--tolerance",
               .form = "EFFECTOR=X,Y,Z",
               .group = OptionGroup::goal,
               .brief = "Half the sides of a box about the goal where any place will do"}},
    }};

// The fields of a handle.
template <>
inline constexpr FieldTable kFields<ThingHandle>{
    "handle", "A bar of a thing, around which a hand closes.",
    std::tuple{
        Field{"position_m",
              &ThingHandle::position,
              "Its middle from the middle of the thing, along the thing's own axes.",
              {.low = -kThingMost,
               .high = kThingMost,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"along",
              &ThingHandle::along,
              "The bar's direction in the thing's own axes: [0, 1, 0], upright, when not given.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .mirroring = Mirroring::other_side,
               .written = always}},
    }};

// The fields of a part.
template <>
inline constexpr FieldTable kFields<ThingPart>{
    "part_of_thing", "A box of which a thing is made, with others.",
    std::tuple{
        Field{"position_m",
              &ThingPart::position,
              "Its middle from the middle of the thing, along the thing's own axes.",
              {.low = -kThingMost,
               .high = kThingMost,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"size_m",
              &ThingPart::size,
              "Its sides along the thing's own axes.",
              {.high = kThingMost, .required = true, .written = always}},
    }};

// The fields of a thing; its name is its key.
template <>
inline constexpr FieldTable kFields<Thing>{
    "thing", "A rigid body that hands can grasp, carry and put down.",
    std::tuple{
        Field{"shape",
              &Thing::shape,
              "box when not given, cylinder (upright) or sphere.",
              {.written = always}},
        Field{"size_m",
              &Thing::size,
              "Its sides along its own axes; of a cylinder diameter, height, diameter; of a sphere "
              "three times its diameter.",
              {.low = kThingLeast, .high = kThingMost, .required = true, .written = always}},
        Field{"mass_kg", &Thing::mass, "Of even density.", {.high = kLoadMax, .written = always}},
        Field{"position_m",
              &Thing::position,
              "Its middle at the start. In the air it stays where it is until it is grasped.",
              {.low = -kGoalRange,
               .high = kGoalRange,
               .required = true,
               .mirroring = Mirroring::other_side,
               .written = always}},
        Field{"turn_deg",
              &Thing::turn_deg,
              "Its turn about +Y at the start, degrees to the left; 0, when not given, has its "
              "sides along the world's axes.",
              {.low = -kTurnMost, .high = kTurnMost, .mirroring = Mirroring::turn}},
        Field{
            "centre_of_mass_m",
            &Thing::centre,
            "From its middle, along its own axes; when not given the middle, or that of its parts.",
            {.low = -kThingMost,
             .high = kThingMost,
             .mirroring = Mirroring::other_side,
             .written = [](const Thing& thing) { return !thing.parts.empty(); }}},
        Field{"upright", &Thing::upright, "true: it stays upright in the hand, such as a cup."},
        Field{"handle",
              &Thing::handle,
              "A bar outside its shape, by which one hand takes it: a mug's, or a bucket's.",
              {.mirroring = Mirroring::other_side}},
        Field{
            "parts",
            &Thing::parts,
            "Of a box: boxes within its sides that are its form, such as those of a chair; all of "
            "it when not given.",
            {.high = kPartsMax, .mirroring = Mirroring::other_side}},
    }};

// The fields of a stance.
template <>
inline constexpr FieldTable kFields<Stance>{
    "stance", "A place on the floor and a direction there.",
    std::tuple{
        Field{"facing_deg",
              &Stance::facing_deg,
              "Degrees from +Z, growing to the left; 0 when not given.",
              {.low = -kTurnMost, .high = kTurnMost, .mirroring = Mirroring::turn}},
        Field{"height_m",
              &Stance::height,
              "Of a seat above the floor; 0.45 when not given.",
              {.low = 0.1, .high = 2.0}},
    }};

// The fields of an action.
template <>
inline constexpr FieldTable kFields<Action>{
    "action",
    "One of goals (or look_at_m alone), wait_s, grasp, place, release, stand and sit, with what "
    "belongs to it.",
    std::tuple{
        Field{"goals",
              &Action::goals,
              "The final places of effectors, as in a task of version 1.",
              {.high = kGoalsMax, .mirroring = Mirroring::other_side}},
        Field{"look_at_m",
              &Action::look_at,
              "The point that the eyes are on.",
              {.low = -kGoalRange, .high = kGoalRange, .mirroring = Mirroring::other_side}},
        Field{"grasp", &Action::grasp, "The thing that the hands take, and lift by 5 cm."},
        Field{"with",
              &Action::with,
              "The hands that take it; when not given two for a box wider than a hand or a thing "
              "heavier than 3 kg, else one.",
              {.mirroring = Mirroring::other_side}},
        Field{"place", &Action::place, "The thing in the hands that is put to position_m."},
        Field{"position_m",
              &Action::position,
              "Of place: where the middle of the thing is to be.",
              {.low = -kGoalRange, .high = kGoalRange, .mirroring = Mirroring::other_side}},
        Field{"turn_deg",
              &Action::turn_deg,
              "Of place: the thing's turn about +Y there, degrees to the left of the world's axes; "
              "0 when not given.",
              {.low = -kTurnMost, .high = kTurnMost, .mirroring = Mirroring::turn}},
        Field{"release", &Action::release, "The thing in the hands that is let go where it is."},
        Field{"stand",
              &Action::stand,
              "Where to stand up straight: so far where the feet are.",
              {.mirroring = Mirroring::other_side}},
        Field{"sit", &Action::sit, "Where to sit down: needs steps, which are not there yet."},
        Field{"wait_s",
              &Action::wait,
              "Seconds for which the body stays as it is.",
              {.high = kPauseMax}},
        Field{"hold_s",
              &Action::hold,
              "Seconds for which it stays at the action's end; 0 when not given.",
              {.high = kPauseMax}},
        Field{"via", &Action::via, "true: goals are passed without a stop."},
        Field{"duration_s",
              &Action::duration,
              "Seconds of the action's main motion; from the distance when not given.",
              {.low = kTaskDurationMin, .high = kTaskDurationMax}},
    }};

// The fields of a habit.
template <>
inline constexpr FieldTable kFields<Habit>{
    "habit", "A person's way of moving.",
    std::tuple{
        Field{"knees",
              &Habit::knees,
              "Flexion of the knees over the lean of a far leaning trunk; 1.7 when not given.",
              {.high = kHabitKneesMost, .written = always}},
        Field{"round_rad",
              &Habit::round,
              "Bend of the back beside people's usual one with the pelvis tipped far, below 0 a "
              "straight back; 0 when not given.",
              {.low = kHabitRoundLeast, .high = kHabitRoundMost, .written = always}},
        Field{"eyes_rad",
              &Habit::eyes,
              "Angle by which the eyes look down from the head at a low goal; 15° when not given.",
              {.high = kHabitEyesMost, .written = always}},
        Field{"free_arm",
              &Habit::free_arm,
              "Flexion of a free arm's elbow over the forward turn of its shoulder; 0.6 when not "
              "given.",
              {.high = kHabitFreeArmMost, .written = always}},
    }};

// The fields of a request.
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
        Field{"things",
              &Request::things,
              "Of version 2: things by their names, which actions grasp; the command line knows "
              "boxes, by their middle, size and mass.",
              {.high = kThingsMax,
               .option = "--thing",
               .form = "NAME=X,Y,Z,SX,SY,SZ,KG",
               .group = OptionGroup::around,
               .brief = "Box to grasp: its middle, its size in metres, and kilograms",
               .mirroring = Mirroring::other_side}},
        Field{"scene",
              &Request::scene,
              "A GLB or glTF file, relative to the task file, whose meshes are further obstacles, "
              "or things if an action names them. Results hold what was read of it instead.",
              {.option = "--scene",
               .form = "FILE",
               .group = OptionGroup::around,
               .brief = "GLB file whose meshes are obstacles, and things by name"}},
        Field{"actions",
              &Request::actions,
              "Of version 2, in place of goals: actions that follow each other. On the command "
              "line goals, or stand, wait=S, grasp=THING, place=THING,X,Y,Z or release=THING, with "
              "hold=S, look=X,Y,Z or via, and semicolons between them.",
              {.high = kActionsMax,
               .option = "--then",
               .form = "EFFECTOR=X,Y,Z|stand|…",
               .group = OptionGroup::goal,
               .brief = "What follows: goals, stand, wait=S, grasp=, place=, release=",
               .mirroring = Mirroring::other_side}},
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
        Field{"habit",
              &Request::habit,
              "The person's way of moving: natural, when not given, as most people; half: knees "
              "bend as much as the trunk leans; squat: knees bend much; stoop: knees stay almost "
              "straight; or numbers, such as `shigusa habit` measures in a recorded motion. Of the "
              "presets flat and human.",
              {.option = "--habit",
               .form = "natural|half|squat|stoop|NAME=NUMBER,…|FILE",
               .group = OptionGroup::motion,
               .brief = "Way of moving: a word, numbers, or a file of `shigusa habit`",
               .adopt = adopt_habit}},
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
        Field{"cost",
              &Request::cost,
              "true: results tell what each motion costs the body by REBA, RULA, EN 1005-4 and the "
              "revised NIOSH lifting equation, the loads at L5/S1, and joint torques beside "
              "people's strengths.",
              {.option = "--cost",
               .group = OptionGroup::output,
               .brief = "Tell the cost to the body: REBA, RULA, NIOSH, L5/S1, strengths",
               .rare = true}},
        Field{"ergonomics",
              &Request::ergonomics,
              "What the motion does not tell, such as how often it recurs, for that cost.",
              {.option = "--ergonomics",
               .form = "NAME=VALUE,…",
               .group = OptionGroup::output,
               .brief = "For --cost: coupling=poor,lifts_per_min=4,lifting_time=long",
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
