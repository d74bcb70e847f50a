// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/messages/message_text.hpp"

namespace shigusa::messages {

// Sentences of results, their edits and files that they leave as.
inline constexpr std::array kResults{
    MessageText{"one_side", "{} has one side only: it has {} and no {}"},
    MessageText{"no_candidate",
                "candidate {} does not exist; the result has the candidates 1 to {}"},
    MessageText{"file_needed", "needs the character's file, {}: give it by --character FILE"},
    MessageText{"other_characters", "is for characters from {} files, and {} is none"},
    MessageText{"long_clip_name", "has {} bytes; allowed are up to {}"},
    MessageText{"own_joint_names", "are those of {} in its own files: leave the joint names out"},
    MessageText{"cannot_leave",
                "read back, {} is {} are allowed (frame {}): the format cannot hold the motion of "
                "this character; leave it out"},
    MessageText{"off_a_little", "read back, {} is {} are of its digits (frame {})"},
    MessageText{"vrma_one_root",
                "a VRM animation needs all bones below the hips, and {} hangs beside them: leave "
                "the format out"},
    MessageText{"not_read_back", "cannot be read back: {}; leave the format out"},
    MessageText{"other_nodes", "it has other nodes"},
    MessageText{"no_clip", "is no clip that can be scored; allowed are {}"},
    MessageText{"no_frame_of", "frame {} does not exist; the file has 0 to {}"},
    MessageText{"foot_travels",
                "the {} moves by {:.1f} cm: score the frames in which the feet stand (--frames)"},
    MessageText{"base_travels",
                "the {} moves by {:.1f} cm, and the body stands on it, which cannot follow: score "
                "the frames in which the feet stand (--frames)"},
    MessageText{"joints_far",
                "the body's joints are {:.1f} cm from the recorded ones on average: another motion "
                "is scored"},
    MessageText{"frames_too_few", "{:.1f} frames a second are too few to smooth at {:g} Hz"},
    MessageText{"times_found",
                "the file tells times of {} actions, and the task has {}: they are found from the "
                "motion"},
    MessageText{"robot_not_scored", "{} is a robot; recorded motion is scored on people"},
    MessageText{"frames_none", "the frames {} to {} are none; the file has 0 to {}"},
    MessageText{"no_speeds", "a frame time of {:g} s has no speeds; allowed is more than 0"},
    MessageText{"smoothing_range", "is {:g} Hz; allowed is 0, for none, or more"},
    MessageText{"read_alone", "is read alone"},
    MessageText{"svg_alone", "is made of svg by the command line alone; ask for svg"},
    MessageText{"rate_range", "is {:g} frames a second; allowed are {:g} to {:g}"},
    MessageText{"no_such_freedom", "names a degree of freedom that this body lacks"},
    MessageText{"other_frames", "it has {} frames of {:g} s and not {} of {:g} s"},
    MessageText{"must_be", "must be {}"},
    MessageText{"must_be_a_number", "must be a number"},
    MessageText{"version_is", "version is {}; allowed is {}"},
    MessageText{"urdf_missing", "urdf is missing: a result holds the robot as read"},
    MessageText{"landmarks_missing",
                "landmarks_m is missing: a result holds the person as measured"},
    MessageText{"candidates_empty", "candidates is an empty list"},
    MessageText{"candidates_most", "{} candidates; up to {} are allowed"},
    MessageText{"no_result", "not a result of shigusa: it has no task and candidates"},
    MessageText{"landmarks_beside_urdf", "is of a robot, and landmarks_m of a person"},
    MessageText{"of_a_file", "is of a character from a file, and {} is built in: leave it out"},
    MessageText{"beside_rotation", "stands beside rotation_xyzw; allowed is one of both"},
    MessageText{"all_weights_zero",
                "all weights are 0; allowed are weights of which one or more is above 0"},
    MessageText{"of_landmarks", "is of a person with landmarks_m, and there are none"},
    MessageText{"second_goal", "is a second goal for '{}'; allowed is one for each effector"},
    MessageText{"file_frames",
                "{} frames of {} nodes are more than a file may hold, {}: ask for fewer frames a "
                "second by --fps"},
    MessageText{"robot_mirror", "{} is a robot, whose mirror image is another robot"},
    MessageText{"assignments_list", "must be a list [ … ] of texts such as \"squat_deg=60\""},
    MessageText{"angles_shape",
                "{} frames of {} angles; allowed are 2 frames and more of {} angles, one for each "
                "degree of freedom"},
    MessageText{"no_angle", "an angle is no finite number up to {:g} rad"},
    MessageText{"stopped_after", "stopped after {} of {} candidates"},
    MessageText{"stopped_before", "stopped before this task began"},
    MessageText{"off_the_motion", "{:.4f} mm off the motion; {:.4f} mm"},
    MessageText{"turned_against", "turned by {:.5f}° against the motion; {:.5f}°"},
    MessageText{"list_of_texts", "must be a list [ … ] of texts"},
};

}  // namespace shigusa::messages
