// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/messages/message_text.hpp"

namespace shigusa::messages {

// Sentences of characters: their files, settings and start postures.
inline constexpr std::array kCharacters{
    MessageText{"no_person",
                "no person: {}; if it is one, say which nodes are its bones with --map"},
    MessageText{"length_out_of_range", "{} is {} m; allowed are {:g} to {:g} m"},
    MessageText{"out_of_range", "{} is {} {}; allowed are {:g} to {:g} {}"},
    MessageText{"mirrored_file",
                "files with the character's own skeleton keep the mirrored axes: goals are not "
                "where they stand in them"},
    MessageText{"other_person",
                "is not the person of the result, {}, who may have been mirrored or changed since"},
    MessageText{"seat_of_one_side", "a body of one side cannot sit on a seat"},
    MessageText{"rest_of_no_animation",
                "the rest pose is of no animation: leave the frame or the animation out"},
    MessageText{"no_animation_frame",
                "frame {} does not exist: the file has no animation, only its rest pose; leave the "
                "frame out"},
    MessageText{"toes_guessed", "nothing follows {}: toes of average length are assumed"},
    MessageText{"no_frame", "frame {} does not exist; the file has {}"},
    MessageText{"one_frame", "only frame 0"},
    MessageText{"frames", "the frames 0 to {}"},
    MessageText{"bind_pose",
                "the nodes rest in the middle of a motion: the pose in which the mesh was bound is "
                "taken in that one's place"},
    MessageText{"not_standing", "the rest pose of the nodes is no standing pose{}"},
    MessageText{"standing_animation", "; frame 0 of the animation '{}' does: --animation"},
    MessageText{"arms_spread",
                "the file has the arms spread out or held ahead: at the start they hang{}"},
    MessageText{"arms_of_frame", "; with --frame 0 they do not"},
    MessageText{"own_pose",
                "the start is the pose that the file shows; with --frame rest it is at ease"},
    MessageText{"frame_unread", "frame {} has values that are no numbers; give another frame"},
    MessageText{"frame_lies",
                "in frame {} the person lies, and motions begin standing or seated; give another "
                "frame, or rest"},
    MessageText{"frame_sits",
                "the person sits in frame {}: give --seat {:.2f} for a seat of that height"},
    MessageText{"frame_seat",
                "in frame {} the person sits {:.2f} m high, not {:.2f} m: the frame is kept"},
    MessageText{"frame_no_seat",
                "the person does not sit in frame {}: they are seated upright, with the hands on "
                "the thighs"},
    MessageText{"frame_no_stance",
                "the body could not hold the start that was asked for, frame {}, still; if no "
                "frame is given, one that stands is sought"},
    MessageText{"later_frame",
                "the file does not begin with a person who stands still on both feet: the motion "
                "starts from frame {}, the first one that does"},
    MessageText{"no_stance",
                "in no frame the person stands still on both feet: the motion starts from the rest "
                "pose, at ease"},
    MessageText{
        "nothing_stands",
        "in no frame the person stands still on both feet, nor in the rest pose: the motion "
        "starts from frame {} as it is"},
    MessageText{"no_motion", "the file has no motion: the rest pose is the start, at ease"},
    MessageText{"no_humanoid", "no humanoid robot: {}"},
    MessageText{"option_of_person",
                "{} is of a person, and {} is a robot, which has its own: leave it out"},
    MessageText{"hand_axis_alone",
                "is of left_hand and right_hand; {} takes a rotation, or an axis as a vector"},
    MessageText{"square_axes",
                "two axes of a hand are square to each other and cannot point along one line"},
    MessageText{"unknown_character", "{}, or a file that ends in {}"},
    MessageText{"not_as_glb", "motions cannot be written as GLB: {}"},
    MessageText{"one_motion", "holds one motion without a name: leave the animation out"},
    MessageText{
        "heels_no_toes",
        "heels lift about the toes, and no node is found to be {}: with --map {}=NODE one is"},
    MessageText{"heels_short_toes",
                "heels lift about the toes, and {} stands {:.3f} m ahead of its ankle; allowed are "
                "{:g} m and more"},
    MessageText{"points_object", "must be an object {{ … }} of at most {} points"},
    MessageText{"no_node_of_name", "{} has no '{}' for {}; its nodes are {}"},
    MessageText{"no_node_of_name_near", "{} has no '{}' for {}; did you mean '{}'?"},
    MessageText{"bone_twice", "{} is given twice"},
    MessageText{"node_of_two_bones", "'{}' is given for two bones"},
    MessageText{"bones_object",
                "must be an object of bones and nodes: {{\"right_hand\": \"Bone_17\"}}"},
    MessageText{"names_no_bones",
                "names no bones: it is neither an object of bones and nodes {{\"right_hand\": "
                "\"Bone_17\"}}, nor what `shigusa body` prints"},
    MessageText{"limb_coincides", "two joints of a limb coincide"},
    MessageText{"four_corners", "must be four corners"},
    MessageText{"sole_corners", "must be the four corners of a sole, counter-clockwise from above"},
    MessageText{"heels_of_human",
                "heels can lift for the body human only: it has all joints of a foot"},
    MessageText{"heels_who_sit", "heels can lift for a standing body only, and this one sits"},
    MessageText{"robot_extent",
                "robots cannot have an extent: {} is a robot, which has the joints of its file"},
    MessageText{"robot_seat", "robots cannot sit: {} is a robot, which stands"},
    MessageText{"robot_heels",
                "robots cannot lift their heels: {} is a robot, whose feet stay flat"},
    MessageText{
        "robot_frame",
        "robots cannot start from a frame: {} is a robot, whose file has no recorded motion"},
    MessageText{
        "robot_fingers",
        "robots cannot play with their fingers: {} is a robot, whose fingers keep their angles"},
    MessageText{
        "robot_sex",
        "robots cannot have a sex: {} is a robot, whose masses and strengths are of its file"},
};

}  // namespace shigusa::messages
