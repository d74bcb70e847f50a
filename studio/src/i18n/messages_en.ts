// SPDX-License-Identifier: MIT
// The engine's sentences that name an option of the command line, as the page says them: by its own controls.
import { en } from './en';

const { boneMap, startPosture, startFrame, startRest, stature, seat, fps } = en;

export const englishMessages: Readonly<Record<string, string>> = {
  no_person: 'no person: {0}; if it is one, give its nodes the usual names of bones, as Hips or LeftArm',
  file_needed: 'needs the character’s file, {0}: drop it together with the result',
  foot_travels: 'the {0} moves by {1} cm: score only the frames in which the feet stand',
  base_travels: 'the {0} moves by {1} cm, and the body stands on it, which cannot follow: score only the frames in which the feet stand',
  file_frames: `{0} frames of {1} nodes are more than a file may hold, {2}: lower “${fps}”`,
  stature_guessed: `along the bones the person is {0} units tall, and no unit makes that {1} to {2} m: a stature of {3} m is guessed; “${stature}” changes it`,
  unit_by_stature: `the unit is taken as {0}, for a stature of {1} m; “${stature}” changes it`,
  standing_animation: `; frame 0 of the animation '{0}' does: choose “${startFrame}” beside “${startPosture}”`,
  arms_of_frame: `; with “${startFrame}” beside “${startPosture}”, 0, they do not`,
  own_pose: `the start is the pose that the file shows; “${startRest}” beside “${startPosture}” has it at ease`,
  frame_sits: `the person sits in frame {0}: set “${seat}” to {1} m`,
  heels_no_toes: `heels lift about the toes, and no node is found to be {0}: choose one for {1} under “${boneMap}”`,
  no_mass: 'no link has a mass, and a motion is chosen by its torques: give the links’ masses in the file',
};
