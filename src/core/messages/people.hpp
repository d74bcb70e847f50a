// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/messages/message_text.hpp"

namespace shigusa::messages {

// Sentences of people from files: their bones, measures and bodies.
inline constexpr std::array kPeople{
    MessageText{"no_nodes", "no body: there are no nodes"},
    MessageText{"no_skeleton", "no skeleton in this file: {}"},
    MessageText{"one_node", "it has one node alone"},
    MessageText{"nodes_at_one_point", "its {} nodes stand at one point"},
    MessageText{"several_roots", "no hips: the limbs hang on several roots"},
    MessageText{"feet_backwards",
                "the feet point backwards, seen from the left and right of the names: the file is "
                "mirrored, or its left and right are exchanged"},
    MessageText{"found_by_shape",
                "the names do not identify the {}: {} found by the skeleton's shape"},
    MessageText{"all_limbs", "all limbs were"},
    MessageText{"the_rest", "what they do not identify was"},
    MessageText{"map_without_limb",
                "the file's own map has no whole {}: it was looked for by names"},
    MessageText{"loose_end", "{} stands at the end of the {} and does not hang on it"},
    MessageText{"end_by_place", "{} is taken as the end of the {}, by where it stands"},
    MessageText{
        "sides_guessed",
        "left and right are a guess: neither names nor feet show them; {} is taken as left"},
    MessageText{"no_limb", "no {}: {}"},
    MessageText{"no_bone_below", "no {}: below {} {}"},
    MessageText{"map_without_hips",
                "the file's own map has no hips above the legs: they were looked for"},
    MessageText{"limbs_elsewhere",
                "the limbs hang on {} and not on the trunk, which is taken to begin at {}"},
    MessageText{"no_neck", "no neck joint: none stands between the arms and the head"},
    MessageText{"no_head", "no head joint: no chain leaves the trunk between the arms"},
    MessageText{"no_length", "the {} {} has no length: {} and {} stand at one point"},
    MessageText{"up_followed", "up is {} in this posture, but {} at rest: the posture is followed"},
    MessageText{
        "no_upright",
        "the body stands upright along no axis of the file: up is taken along its trunk and legs"},
    MessageText{"does_not_stand",
                "the body does not stand: up is taken as {}, from its feet to its shoulders"},
    MessageText{"no_facing",
                "the facing cannot be determined: along {}, which is taken as up, the left hip and "
                "shoulder stand above, below or at the right ones"},
    MessageText{"was_mirrored",
                "the feet point backwards: the person was mirrored, so that left stays left"},
    MessageText{"foot_guessed",
                "nothing follows {}: the {} foot is taken as level, of average length"},
    MessageText{"foot_guessed_at_heel",
                "only a heel follows {}: the {} foot is taken as level, of average length"},
    MessageText{"hand_guessed",
                "nothing follows {}: the {} hand is taken as straight, of average length"},
    MessageText{
        "limb_ends_at",
        "nothing follows joint '{}': the {} is put where a person's would be before the end "
        "of its mesh"},
    MessageText{"head_guessed",
                "the head has no tip: the top of the head is placed by average proportions"},
    MessageText{"stature_range", "a stature of {:g} m; {} to {} m are allowed"},
    MessageText{"stature_guessed",
                "along the bones the person is {:g} units tall, and no unit makes that {} to {} m: "
                "a stature of {:.2f} m is guessed; with --stature it is another"},
    MessageText{"stature_unusual", "a stature of {:.2f} m is unusual; the unit is taken as {}"},
    MessageText{"unit_by_stature",
                "the unit is taken as {}, for a stature of {:.2f} m; with --stature it is another"},
    MessageText{"unit_guessed",
                "the unit is taken as {}, a stature of {:.2f} m; it could be {}, {:.2f} m"},
    MessageText{"foot_above", "the {} foot is {:.2f} m above the floor"},
    MessageText{"sole_above", "the {} sole is {:.0f} mm above the floor"},
    MessageText{"short_hand", "the {} hand is only {:.3f} m long: its fingers are missing"},
    MessageText{"unequal_segments", "the left {} is {:.3f} m long, the right one {:.3f} m"},
    MessageText{"odd_segments",
                "of the two segments of one {} one is {:.1f} times as long as the other; up to {} "
                "is taken"},
    MessageText{"odd_limbs",
                "one of its two {}s is {:.1f} times as long as the other; up to {} is taken"},
    MessageText{"four_legs",
                "it stands on four legs: the trunk lies level, as long as {:.2f} legs, and the "
                "limbs in front, {:.2f}, reach down as far as those behind"},
    MessageText{"broad",
                "shoulders or hips are {:.2f} times as broad as trunk and legs are long; up to {} "
                "is taken"},
    MessageText{"odd_trunk", "the trunk is {:.2f} times as long as the legs; {} to {} is taken"},
    MessageText{"animals_limb", "{} is called as an animal's limb"},
    MessageText{"fingers_for_limbs", "{} is called a finger, so it is a hand alone"},
    MessageText{"arms_on_head", "its arms would hang on {}"},
    MessageText{"more_legs", "it has more legs than two, one of which begins at {}"},
    MessageText{"more_arms", "it has more arms than two, one of which begins at {}"},
    MessageText{"legs_to_the_floor",
                "{} more limbs reach the floor beside its legs, one of which begins at {}"},
    MessageText{"four_limbs_down",
                "its four limbs point one way, the trunk does not lead up from them, and no names "
                "tell legs from arms"},
    MessageText{"four_legs_and_tail",
                "it stands on four legs: the trunk lies level, all limbs reach down alike, and it "
                "has a tail, {}"},
    MessageText{"odd_arms", "the arms are {:.2f} times as long as the legs; {} to {} is taken"},
    MessageText{"foot_lifted",
                "the {}foot is lifted at the start: it carries nothing and keeps its angles"},
    MessageText{
        "start_outside",
        "the start posture has {} at {:.0f}°, outside its limits: they are widened to hold it"},
    MessageText{"cannot_be_bone", "{} cannot be {}: it does not hang where that bone does"},
    MessageText{"cannot_be_bone_found",
                "{} cannot be {}: it does not hang where that bone does; found is {}"},
    MessageText{"no_two_pairs",
                "no two legs and two arms: of long chains in pairs of about the same shape, the "
                "longest start at {} and {}, and beside them is no pair with the joints of a limb"},
    MessageText{"no_chains", "{} has no chains"},
    MessageText{"no_chains_down", "{} has no chains that go down"},
    MessageText{"one_chain", "{} has 1 chain: {}"},
    MessageText{"one_chain_down", "{} has 1 chain that goes down: {}"},
    MessageText{"chains", "{} has {} chains: {}"},
    MessageText{"chains_down", "{} has {} chains that go down: {}"},
};

}  // namespace shigusa::messages
