// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/messages/message_text.hpp"

namespace shigusa::messages {

// Sentences of tasks and their searches.
inline constexpr std::array kTasks{
    MessageText{"turn_twice", "has a rotation and an axis; allowed is one of both"},
    MessageText{
        "no_unit_quaternion",
        "rotation is ({}, {}, {}, {}) of length {}; allowed is a unit quaternion x, y, z, w"},
    MessageText{"load_range", "load is {} kg; allowed are 0 to {:g} kg"},
    MessageText{"coordinate_range",
                "{} coordinate is {}; allowed are finite numbers from -{:g} to {:g} m"},
    MessageText{"tolerance_range", "{} tolerance is {}; allowed are 0 to {:g} m"},
    MessageText{"sole_below_floor",
                "is {:.3f} m high, and its sole would end {:.0f} mm below the floor; allowed are "
                "{:.3f} m and more, as it is turned"},
    MessageText{
        "too_many_rows",
        "goals, contacts and supports take {} rows of the IK; allowed are {}: 3 for a position, 3 "
        "for a rotation or an axis, 6 for a foot that is not the base, 3 for a support"},
    MessageText{"obstacles_most", "{} obstacles; allowed are {}"},
    MessageText{"obstacle_size", "size along {} is {}; allowed are 0 to {:g} m"},
    MessageText{"obstacle_radius", "radius is {}; allowed are 0 to {:g} m"},
    MessageText{"no_heels", "the preset {} cannot lift heels; flat can"},
    MessageText{"duration_range", "duration is {} s; allowed are {:g} to {:g} s"},
    MessageText{"start_state",
                "a state has one finite angle for each of the {} dofs, and as many velocities or "
                "none; here are {}"},
    MessageText{"start_at_rest", "motions by nlp_ik begin at rest"},
    MessageText{"start_of_layers", "the preset {} begins at rest; flat also begins in a movement"},
    MessageText{"ease_of_layers",
                "the preset {} has layers, which keep their own time; flat has an ease"},
    MessageText{"no_habit", "the preset {} moves by the paper's method, without a habit"},
    MessageText{"no_reach_down", "nobody reaches down: no trunk leans by more than {:g}°"},
    MessageText{"no_gaze_lead", "the preset {} does not turn the head to the gaze target"},
    MessageText{"no_weights",
                "criteria weights must be finite, 0 or more, and not all 0; scales above 0"},
    MessageText{"goal_below_floor",
                "the goal of {} is {} m below the floor: the hand goes through it"},
    MessageText{
        "goal_in_floor",
        "the goal of {} is {} m above the floor, and the hand {} mm thick on either side: it "
        "goes into the floor"},
    MessageText{"goal_in_part",
                "the goal of {} is in the body's own {}, where that is at the start"},
    MessageText{"step_behind", "people take a step here: the goal of {} is behind them"},
    MessageText{"step_beside", "people take a step here: the goal of {} is low beside them"},
    MessageText{"step_far", "people take a step here: the goal of {} is far from their feet"},
    MessageText{"goal_in_the_way",
                "the goal of {} is in the way: all others are in reach without it"},
    MessageText{"goals_in_the_way",
                "these goals cannot be met together: without that of {} the others are in reach"},
    MessageText{"turn_in_the_way",
                "the turn of {} is in the way: with any other turn all goals are in reach"},
    MessageText{"no_goal", "no goal: give at least one effector's position"},
    MessageText{"hands_alone",
                "layers bring hands to positions, and those of a whole human by the preset human "
                "to rotations and axes too; the preset flat takes rotations, axes and boxes"},
    MessageText{"fewer_runs",
                "{} of {} candidates: {} runs with other random numbers each ended in no others"},
    MessageText{"fewer_kept", "{} of {} candidates: of the others that were kept, {}"},
    MessageText{"fewer_none", "there are none"},
    MessageText{"and_more", "{}; {}"},
    MessageText{"fewer_alike", "{} look like a better one"},
    MessageText{"fewer_near_copies", "{} move like a better one"},
    MessageText{"fewer_worse", "{} score over {} worse than the best"},
    MessageText{"fewer_jolting", "{} jolt"},
    MessageText{"fewer_strange", "{} end in an unnatural posture"},
    MessageText{"fewer_over_limit", "{} pass a joint's limit"},
    MessageText{"fewer_collided", "{} pass deeper through the body, an obstacle or the floor"},
    MessageText{"fewer_missed", "{} miss the goal, leave the path or move a foot when replayed"},
    MessageText{"fewer_jolts", "{} of {} candidates: {} jolt"},
    MessageText{"preset_cannot", "the preset {} {}"},
    MessageText{"no_pareto", "knows no Pareto front; flat does"},
    MessageText{"weighted_ik_only", "knows weighted IK only"},
    MessageText{"no_own_search", "takes no search of one's own"},
    MessageText{"no_starts", "takes no start motions; flat does"},
    MessageText{"hands_only", "brings hands to their goals; flat takes other joints too"},
    MessageText{"feet_kept", "keeps all feet where they are; flat lets one go"},
    MessageText{"fixed_elsewhere",
                "parameters can be fixed with the other presets; edit a result of the preset {}"},
    MessageText{"fewer_pareto",
                "{} of {} candidates: of {} motions that were kept, the others are no better by "
                "any criterion than one of these, or end within 10° of one"},
    MessageText{"fixed_of_another", "fixed parameters are of another body"},
    MessageText{"all_fixed",
                "every parameter is fixed: there is nothing to search, an edit plays them"},
    MessageText{
        "one_phase",
        "motions have one phase: leave it out, or write two tasks, the second of which begins in "
        "the last frame of the first (its character is the file that the first left, and "
        "frame says which)"},
    MessageText{"evaluations_range", "evaluations is {}; allowed are {} (the population) and more"},
    MessageText{"candidates_range", "candidates is {}; allowed are 1 and more"},
    MessageText{"ease_range", "ease is {}; allowed are {:g} to {:g}"},
    MessageText{"habit_range", "{} of the habit is {}; allowed are {:g} to {:g}"},
    MessageText{"gaze_lead_range", "gaze_lead is {}; allowed are {:g} to {:g} of the duration"},
    MessageText{"finite_numbers", "allowed are finite numbers from -{:g} to {:g} m"},
    MessageText{"reference_scales", "reference scales of criteria must be above 0"},
    MessageText{"two_goals", "two goals for {}"},
    MessageText{"foot_bears", "{} bears this body and cannot move: only the other foot can"},
    MessageText{"axis_vector",
                "axis or direction is ({}, {}, {}); allowed is a finite vector that is not 0"},
    MessageText{"foot_bears_contact",
                "{} bears this body and is not among them: only the other foot can move"},
    MessageText{"stands_and_goal", "{} is to stand and has a goal"},
    MessageText{"no_resting", "the preset {} cannot rest hands on supports; flat can"},
    MessageText{"generator_no_resting",
                "the generator {} cannot rest hands on supports; weighted_ik can"},
    MessageText{"support_out_of_reach",
                "the goals are out of reach, and hands rest in motions that meet them: leave the "
                "support out"},
    MessageText{"no_assignment", "'{}' is not {}"},
    MessageText{"no_assignment_posture", "'{}' is not {} or, of the posture, NAME=NUMBER"},
    MessageText{"assignment_range", "{} is '{}'; allowed are numbers from {:.4g} to {:.4g}"},
    MessageText{"locked_is", "locked is '{}'; allowed are true and false"},
    MessageText{"no_weight_assignment",
                "'{}' is not NAME.weight=NUMBER or NAME.locked=true|false, nor of the posture: {}"},
    MessageText{"layers_bodies",
                "layers are for bodies that stand, with arms of 3 + 1 or 3 + 2 + 2 and legs of 1 + "
                "1 + 3 or 2 + 1 + 3 degrees of freedom; {}"},
    MessageText{"plan_counts", "{} values, for a plan of {}"},
    MessageText{"parameter_range", "{} is {}; allowed are {:.4g} to {:.4g}"},
    MessageText{"arm_has_goal",
                "its arm has a goal, that of {}: only a free hand rests on something"},
    MessageText{"hand_does_not_reach",
                "the hand does not reach {} while the goals are met: {:.0f} mm are left; leave the "
                "support out, or move the place or the goals"},
    MessageText{"second_support", "is a second one for this hand"},
    MessageText{"no_thigh", "{} has no thigh of that side; an obstacle of the task is a place too"},
    MessageText{"robot_has_others", "a robot has others"},
    MessageText{"has_no_hand", "it has no hand"},
    MessageText{"standing_leg_differs", "the standing leg is different"},
    MessageText{"limb_differs", "{} is different"},
    MessageText{"not_on_base", "it does not stand on its base"},
};

}  // namespace shigusa::messages
