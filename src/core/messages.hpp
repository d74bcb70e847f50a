// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace shigusa {

// A sentence for a person in English, as fmt formats it, and the key by which a page has it in
// other languages: the values stand in the order of the holes. Doubts and errors that a person may
// cause are made of these; the page tells by the text which of them a message is.
struct MessageText {
  std::string_view key;
  std::string_view text;
};

namespace messages {

inline constexpr MessageText kNoNodes{"no_nodes", "no body: there are no nodes"};
inline constexpr MessageText kNoSkeleton{"no_skeleton", "no skeleton in this file: {}"};
inline constexpr MessageText kOneNode{"one_node", "it has one node alone"};
inline constexpr MessageText kNodesAtOnePoint{"nodes_at_one_point",
                                              "its {} nodes stand at one point"};
inline constexpr MessageText kSeveralRoots{"several_roots",
                                           "no hips: the limbs hang on several roots"};
inline constexpr MessageText kFeetBackwards{
    "feet_backwards",
    "the feet point backwards, seen from the left and right of the names: the file is mirrored, or "
    "its left and right are exchanged"};
inline constexpr MessageText kByShape{
    "found_by_shape", "the names do not tell the {}: {} found by the skeleton's shape"};
inline constexpr MessageText kAllLimbs{"all_limbs", "all limbs were"};
inline constexpr MessageText kTheRest{"the_rest", "what they do not tell was"};
inline constexpr MessageText kMapWithoutLimb{
    "map_without_limb", "the file's own map has no whole {}: it was looked for by names"};
inline constexpr MessageText kLooseEnd{"loose_end",
                                       "{} stands at the end of the {} and does not hang on it"};
inline constexpr MessageText kEndByPlace{"end_by_place",
                                         "{} is taken as the end of the {}, by where it stands"};
inline constexpr MessageText kSidesGuessed{
    "sides_guessed",
    "left and right are a guess: neither names nor feet tell; {} is taken as left"};
inline constexpr MessageText kNoLimb{"no_limb", "no {}: {}"};
inline constexpr MessageText kNoBoneBelow{"no_bone_below", "no {}: below {} {}"};
inline constexpr MessageText kMapWithoutHips{
    "map_without_hips", "the file's own map has no hips above the legs: they were looked for"};
inline constexpr MessageText kLimbsElsewhere{
    "limbs_elsewhere", "the limbs hang on {} and not on the trunk, which is taken to begin at {}"};
inline constexpr MessageText kNoNeck{"no_neck",
                                     "no neck joint: none stands between the arms and the head"};
inline constexpr MessageText kNoHead{"no_head",
                                     "no head joint: no chain leaves the trunk between the arms"};
inline constexpr MessageText kNoLength{"no_length",
                                       "the {} {} has no length: {} and {} stand at one point"};
inline constexpr MessageText kUpFollowed{
    "up_followed", "up is {} in this posture, but {} at rest: the posture is followed"};
inline constexpr MessageText kNoUpright{
    "no_upright",
    "the body stands upright along no axis of the file: up is taken along its trunk and legs"};
inline constexpr MessageText kDoesNotStand{
    "does_not_stand", "the body does not stand: up is taken as {}, from its feet to its shoulders"};
inline constexpr MessageText kNoFacing{
    "no_facing",
    "the facing cannot be told: along {}, which is taken as up, the left hip and shoulder stand "
    "above, below or at the right ones"};
inline constexpr MessageText kWasMirrored{
    "was_mirrored", "the feet point backwards: the person was mirrored, so that left stays left"};
inline constexpr MessageText kFootGuessed{
    "foot_guessed", "nothing follows {}: the {} foot is taken as level, of average length"};
inline constexpr MessageText kHandGuessed{
    "hand_guessed", "nothing follows {}: the {} hand is taken as straight, of average length"};
inline constexpr MessageText kHeadGuessed{
    "head_guessed", "the head has no tip: the top of the head is placed by average proportions"};
inline constexpr MessageText kStatureRange{"stature_range",
                                           "a stature of {:g} m; {} to {} m are allowed"};
inline constexpr MessageText kStatureGuessed{
    "stature_guessed",
    "along the bones the person is {:g} units tall, and no unit makes that {} to {} m: a stature "
    "of {:.2f} m is guessed; with --stature it is another"};
inline constexpr MessageText kStatureUnusual{
    "stature_unusual", "a stature of {:.2f} m is unusual; the unit is taken as {}"};
inline constexpr MessageText kUnitGuessed{
    "unit_guessed", "the unit is taken as {}, a stature of {:.2f} m; it could be {}, {:.2f} m"};
inline constexpr MessageText kFootAbove{"foot_above", "the {} foot is {:.2f} m above the floor"};
inline constexpr MessageText kSoleAbove{"sole_above", "the {} sole is {:.0f} mm above the floor"};
inline constexpr MessageText kShortHand{
    "short_hand", "the {} hand is only {:.3f} m long: its fingers are missing"};
inline constexpr MessageText kUnequalSegments{
    "unequal_segments", "the left {} is {:.3f} m long, the right one {:.3f} m"};
inline constexpr MessageText kOddSegments{
    "odd_segments",
    "of the two segments of one {} one is {:.1f} times as long as the other; up to {} is taken"};
inline constexpr MessageText kOddLimbs{
    "odd_limbs", "one of its two {}s is {:.1f} times as long as the other; up to {} is taken"};
inline constexpr MessageText kFourLegs{
    "four_legs",
    "it stands on four legs: the trunk lies level, as long as {:.2f} legs, and the limbs in front, "
    "{:.2f}, reach down as far as those behind"};
inline constexpr MessageText kBroad{
    "broad",
    "shoulders or hips are {:.2f} times as broad as trunk and legs are long; up to {} is taken"};
inline constexpr MessageText kLongTrunk{
    "long_trunk", "the trunk is {:.2f} times as long as the legs; up to {} is taken"};
inline constexpr MessageText kOddArms{
    "odd_arms", "the arms are {:.2f} times as long as the legs; {} to {} is taken"};
inline constexpr MessageText kFootLifted{
    "foot_lifted", "the {}foot is lifted at the start: it carries nothing and keeps its angles"};
inline constexpr MessageText kStartOutside{
    "start_outside",
    "the start posture has {} at {:.0f}°, outside its limits: they are widened to hold it"};
inline constexpr MessageText kNoPerson{
    "no_person", "no person: {}; if it is one, say which nodes are its bones with --map"};
inline constexpr MessageText kOutOfRange{"out_of_range",
                                         "{} is {} {}; allowed are {:g} to {:g} {}"};
inline constexpr MessageText kMirroredFile{"mirrored_file",
                                           "files with the character's own skeleton keep the "
                                           "mirrored axes: goals are not where they stand in them"};
inline constexpr MessageText kOtherPerson{
    "other_person",
    "is not the person of the result, {}, who may have been mirrored or changed since"};
inline constexpr MessageText kSeatOfOneSide{"seat_of_one_side",
                                            "a seat is not for a body of one side"};
inline constexpr MessageText kRestOfNoAnimation{
    "rest_of_no_animation",
    "the rest pose is of no animation: leave the frame or the animation out"};
inline constexpr MessageText kNoAnimationFrame{
    "no_animation_frame",
    "frame {} does not exist: the file has no animation, only its rest pose; leave the frame out"};
inline constexpr MessageText kToesGuessed{
    "toes_guessed", "nothing follows {}: the toes are taken as of average length"};
inline constexpr MessageText kNoFrame{"no_frame", "frame {} does not exist; the file has {}"};
inline constexpr MessageText kOneFrame{"one_frame", "only frame 0"};
inline constexpr MessageText kFrames{"frames", "the frames 0 to {}"};
inline constexpr MessageText kBindPose{"bind_pose",
                                       "the nodes rest in the middle of a motion: the pose in "
                                       "which the mesh was bound is taken in that one's place"};
inline constexpr MessageText kNotStanding{"not_standing",
                                          "the nodes do not rest as who stands does{}"};
inline constexpr MessageText kStandingAnimation{
    "standing_animation", "; frame 0 of the animation '{}' does: --animation"};
inline constexpr MessageText kArmsSpread{
    "arms_spread",
    "the file begins with arms spread out: they hang at the start; with --frame 0 they do not"};
inline constexpr MessageText kNoGltf{"no_gltf", "no glTF file: asset.version is missing"};
inline constexpr MessageText kGltfVersion{"gltf_version", "is glTF version {}; 2.0 is read"};
inline constexpr MessageText kNoGltfNodes{"no_gltf_nodes", "holds no nodes, so no character"};
inline constexpr MessageText kRigidLimbs{
    "rigid_limbs",
    "the skins bind {} of {} nodes, which make no whole person: limbs are taken from nodes that "
    "show their meshes as rigid parts"};
inline constexpr MessageText kUnevenScale{"uneven_scale",
                                          "{}{} has different scales along its axes: the bones "
                                          "below keep the lengths that they have in the rest pose"};
inline constexpr MessageText kEmptyFile{"empty_file", "the file is empty"};
inline constexpr MessageText kMeshNotRead{
    "mesh_not_read", "the mesh was not read, so the floor is laid by the joints"};
inline constexpr MessageText kVrmMapWrong{
    "vrm_map_wrong", "the VRM map is wrong in {} places, the first of them: {}"};
inline constexpr MessageText kGlbCut{"glb_cut", "its header tells {} bytes, but it ends after {}"};
inline constexpr MessageText kEmptyBvh{"empty_bvh",
                                       "the file is empty; a BVH file starts with HIERARCHY"};
inline constexpr MessageText kBvhFound{"bvh_found", "found {} where {} is expected"};
inline constexpr MessageText kBvhEnds{"bvh_ends", "the file ends where {} is expected"};
inline constexpr MessageText kBvhCut{
    "bvh_cut", "the file ends after {} of the {} values that {} frames of {} channels need"};
inline constexpr MessageText kFbxNoBone{"fbx_no_bone",
                                        "no bone: there is no skeleton in this file"};
inline constexpr MessageText kNoFbx{"no_fbx", "no FBXVersion: this is no FBX file"};
inline constexpr MessageText kOldFbx{
    "old_fbx", "FBX of version {}.{}; versions from 7 on are read: export it as FBX 2011 or later"};
inline constexpr MessageText kTurnTwice{"turn_twice",
                                        "has a rotation and an axis; allowed is one of both"};
inline constexpr MessageText kNoUnitQuaternion{
    "no_unit_quaternion",
    "rotation is ({}, {}, {}, {}) of length {}; allowed is a unit quaternion x, y, z, w"};
inline constexpr MessageText kLoadRange{"load_range", "load is {} kg; allowed are 0 to {:g} kg"};
inline constexpr MessageText kCoordinateRange{
    "coordinate_range", "{} coordinate is {}; allowed are finite numbers from -{:g} to {:g} m"};
inline constexpr MessageText kToleranceRange{"tolerance_range",
                                             "{} tolerance is {}; allowed are 0 to {:g} m"};
inline constexpr MessageText kSoleBelowFloor{
    "sole_below_floor",
    "is {:.3f} m high, and its sole would end {:.0f} mm below the floor; allowed are {:.3f} m and "
    "more, as it is turned"};
inline constexpr MessageText kTooManyRows{
    "too_many_rows",
    "goals, contacts and supports take {} rows of the IK; allowed are {}: 3 for a position, 3 for "
    "a rotation or an axis, 6 for a foot that is not the base, 3 for a support"};
inline constexpr MessageText kObstaclesMost{"obstacles_most", "{} obstacles; allowed are {}"};
inline constexpr MessageText kObstacleRange{
    "obstacle_range", "{} is out of range: within {:g} m, sizes from 0, a unit quaternion"};
inline constexpr MessageText kNoHeels{"no_heels",
                                      "the preset {} knows no heels that lift; flat does"};
inline constexpr MessageText kDurationRange{"duration_range",
                                            "duration is {} s; allowed are {:g} to {:g} s"};
inline constexpr MessageText kEaseOfLayers{
    "ease_of_layers", "the preset {} has layers, which keep their own time; flat knows an ease"};
inline constexpr MessageText kNoGazeLead{"no_gaze_lead",
                                         "the preset {} turns no head to what is looked at"};
inline constexpr MessageText kNoWeights{
    "no_weights", "criteria weights must be finite, 0 or more, and not all 0; scales above 0"};
inline constexpr MessageText kNoGoal{"no_goal", "no goal: give at least one effector's position"};
inline constexpr MessageText kHandsAlone{
    "hands_alone",
    "layers bring hands to positions, and those of a whole human by the preset human to rotations "
    "and axes too; the preset flat takes rotations, axes and boxes"};
inline constexpr MessageText kFewerRuns{
    "fewer_runs", "{} of {} candidates: {} runs with other random numbers each ended in no others"};
inline constexpr MessageText kFewerJolts{"fewer_jolts", "{} of {} candidates: {} jolt"};
inline constexpr MessageText kOneSide{"one_side", "{} has one side only: it has {} and no {}"};
inline constexpr MessageText kNoCandidate{
    "no_candidate", "candidate {} does not exist; the result has the candidates 1 to {}"};
inline constexpr MessageText kFileNeeded{
    "file_needed", "needs the character's file, {}: give it by --character FILE"};
inline constexpr MessageText kOtherCharacters{"other_characters",
                                              "is for characters from {} files, and {} is none"};
inline constexpr MessageText kLongClipName{"long_clip_name", "has {} bytes; allowed are up to {}"};
inline constexpr MessageText kOwnJointNames{
    "own_joint_names", "are those of {} in its own files: leave the joint names out"};
inline constexpr MessageText kCannotLeave{"cannot_leave",
                                          "read back, {} is {} are allowed (frame {}): this "
                                          "character cannot leave so; leave the format out"};
inline constexpr MessageText kJointSlides{"joint_slides", "joint {} slides: it keeps its place"};
inline constexpr MessageText kJointsSlide{"joints_slide",
                                          "{} joints, {} the first, slide: they keep their places"};
inline constexpr MessageText kJointFollows{"joint_follows",
                                           "joint {} follows another joint: it keeps the angle 0"};
inline constexpr MessageText kJointsFollow{
    "joints_follow", "{} joints, {} the first, follow other joints: they keep the angle 0"};
inline constexpr MessageText kFileAbsent{
    "file_absent", "the file includes {}, which is not here: it was read without it"};
inline constexpr MessageText kFilesAbsent{
    "files_absent",
    "the file includes {} files that are not here, {} the first: it was read without them"};
inline constexpr MessageText kElementLeftOut{"element_left_out", "<{}> is left out"};
inline constexpr MessageText kElementsLeftOut{
    "elements_left_out", "{} elements that make bodies, {} the first, are left out"};
inline constexpr MessageText kBodyApart{"body_apart",
                                        "body {} of the world is no part of the robot"};
inline constexpr MessageText kBodiesApart{
    "bodies_apart", "{} bodies of the world, {} the first, are no part of the robot"};
inline constexpr MessageText kRootHeld{"root_held",
                                       "joint {} holds the root to the world: it is left out"};
inline constexpr MessageText kRootsHeld{
    "roots_held", "{} joints, {} the first, hold the root to the world: they are left out"};
inline constexpr MessageText kMeshMass{"mesh_mass",
                                       "body {} has its mass from a mesh, which is not read"};
inline constexpr MessageText kMeshMasses{
    "mesh_masses", "{} bodies, {} the first, have their mass from meshes, which are not read"};
inline constexpr MessageText kJointStill{
    "joint_still", "joint {} is of no limb, or of fingers, toes or face: it keeps its angle"};
inline constexpr MessageText kJointsStill{
    "joints_still",
    "{} joints, {} the first, each is of no limb, or of fingers, toes or face: it keeps its angle"};
inline constexpr MessageText kJointUnlimited{
    "joint_unlimited", "joint {} has no limits in the file: it gets a person's"};
inline constexpr MessageText kJointsUnlimited{
    "joints_unlimited",
    "{} joints, {} the first, each has no limits in the file: it gets a person's"};
inline constexpr MessageText kLinkMassless{
    "link_massless", "link {} has no mass in the file, nor what is fixed to it: it weighs nothing"};
inline constexpr MessageText kLinksMassless{"links_massless",
                                            "{} links, {} the first, each has no mass in the file, "
                                            "nor what is fixed to it: it weighs nothing"};
inline constexpr MessageText kNoEffort{
    "no_effort",
    "the file has no effort, or an impossible one, for {} of the freedoms, {} the first: they get "
    "a person's, by the weight"};
inline constexpr MessageText kSolesGuessed{
    "soles_guessed",
    "the feet have no shapes to tell their soles: they are as long and broad as a person's"};
inline constexpr MessageText kFootInAir{
    "foot_in_air", "one foot is in the air where all angles are 0: it carries nothing"};
inline constexpr MessageText kArmEnds{
    "arm_ends", "link '{}' ends its arm: the hand is taken to be {:.2f} m on, {}"};
inline constexpr MessageText kTwiceItsCentre{"twice_its_centre",
                                             "twice as far as its centre of mass"};
inline constexpr MessageText kWhereShapesEnd{"where_shapes_end", "where its shapes end"};
inline constexpr MessageText kAnklesAdded{"ankles_added",
                                          "the legs have no ankles: joints that the file lacks, "
                                          "'{}' the first, are added, about the axes of the knees"};
inline constexpr MessageText kFeetNotFlat{
    "feet_not_flat", "its limits do not let both feet stand flat as the file places them"};
inline constexpr MessageText kStraightKnees{
    "straight_knees",
    "it stands with straight knees: its limits do not let them bend above flat feet"};
inline constexpr MessageText kNoHumanoid{"no_humanoid", "no humanoid robot: {}"};
inline constexpr MessageText kNoMass{
    "no_mass", "no link has a mass; a motion is chosen by its torques and needs them"};
inline constexpr MessageText kNoTurningJoint{
    "no_turning_joint",
    "no turning joint is the {}; a body needs hips, knees, ankles, shoulders and elbows that turn"};
inline constexpr MessageText kOptionOfPerson{
    "option_of_person", "{} is of a person, and {} is a robot, which has its own: leave it out"};
inline constexpr MessageText kNoXml{"no_xml", "no element: this is no XML file"};
inline constexpr MessageText kNoUrdf{"no_urdf", "<{}> in place of <robot>: this is no URDF file"};
inline constexpr MessageText kNoMjcf{"no_mjcf", "<{}> in place of <mujoco>: this is no MJCF file"};
inline constexpr MessageText kXmlNeverClosed{"xml_never_closed", "<{}> is never closed"};
inline constexpr MessageText kXmlTagOpen{"xml_tag_open", "a tag is never closed"};
inline constexpr MessageText kXmlCloses{"xml_closes", "</{}> closes {}"};
inline constexpr MessageText kXmlDeep{"xml_deep", "<{}> is nested deeper than {} elements"};
inline constexpr MessageText kXmlDefinitions{"xml_definitions",
                                             "a document type with definitions; none is read"};
inline constexpr MessageText kXmlTags{"xml_tags", "more than {} tags"};
inline constexpr MessageText kBytesAllowed{"bytes_allowed", "{} bytes; {} are allowed"};
inline constexpr MessageText kZeroByte{"zero_byte", "a zero byte: this is no text"};
inline constexpr MessageText kXacro{
    "xacro", "<{}> is xacro's: expand the file first, as in `xacro FILE > robot.urdf`"};
inline constexpr MessageText kLinkAbsent{"link_absent",
                                         "joint '{}' names the link '{}', which is not there"};
inline constexpr MessageText kLinkCircle{"link_circle",
                                         "link '{}' hangs in a circle of joints, or below one"};
inline constexpr MessageText kLinkTwice{"link_twice",
                                        "link '{}' hangs on two joints; one is allowed"};
inline constexpr MessageText kTwoRoots{"two_roots",
                                       "links '{}' and '{}' hang on none; a robot has one root"};

// All of them.
inline constexpr std::array kAll{kNoNodes,
                                 kNoSkeleton,
                                 kOneNode,
                                 kNodesAtOnePoint,
                                 kSeveralRoots,
                                 kFeetBackwards,
                                 kByShape,
                                 kAllLimbs,
                                 kTheRest,
                                 kMapWithoutLimb,
                                 kLooseEnd,
                                 kEndByPlace,
                                 kSidesGuessed,
                                 kNoLimb,
                                 kNoBoneBelow,
                                 kMapWithoutHips,
                                 kLimbsElsewhere,
                                 kNoNeck,
                                 kNoHead,
                                 kNoLength,
                                 kUpFollowed,
                                 kNoUpright,
                                 kDoesNotStand,
                                 kNoFacing,
                                 kWasMirrored,
                                 kFootGuessed,
                                 kHandGuessed,
                                 kHeadGuessed,
                                 kStatureRange,
                                 kStatureGuessed,
                                 kStatureUnusual,
                                 kUnitGuessed,
                                 kFootAbove,
                                 kSoleAbove,
                                 kShortHand,
                                 kUnequalSegments,
                                 kOddSegments,
                                 kOddLimbs,
                                 kFourLegs,
                                 kBroad,
                                 kLongTrunk,
                                 kOddArms,
                                 kFootLifted,
                                 kStartOutside,
                                 kNoPerson,
                                 kOutOfRange,
                                 kMirroredFile,
                                 kOtherPerson,
                                 kSeatOfOneSide,
                                 kRestOfNoAnimation,
                                 kNoAnimationFrame,
                                 kToesGuessed,
                                 kNoFrame,
                                 kOneFrame,
                                 kFrames,
                                 kBindPose,
                                 kNotStanding,
                                 kStandingAnimation,
                                 kArmsSpread,
                                 kNoGltf,
                                 kGltfVersion,
                                 kNoGltfNodes,
                                 kRigidLimbs,
                                 kUnevenScale,
                                 kEmptyFile,
                                 kMeshNotRead,
                                 kVrmMapWrong,
                                 kGlbCut,
                                 kEmptyBvh,
                                 kBvhFound,
                                 kBvhEnds,
                                 kBvhCut,
                                 kFbxNoBone,
                                 kNoFbx,
                                 kOldFbx,
                                 kTurnTwice,
                                 kNoUnitQuaternion,
                                 kLoadRange,
                                 kCoordinateRange,
                                 kToleranceRange,
                                 kSoleBelowFloor,
                                 kTooManyRows,
                                 kObstaclesMost,
                                 kObstacleRange,
                                 kNoHeels,
                                 kDurationRange,
                                 kEaseOfLayers,
                                 kNoGazeLead,
                                 kNoWeights,
                                 kNoGoal,
                                 kHandsAlone,
                                 kFewerRuns,
                                 kFewerJolts,
                                 kOneSide,
                                 kNoCandidate,
                                 kFileNeeded,
                                 kOtherCharacters,
                                 kLongClipName,
                                 kOwnJointNames,
                                 kCannotLeave,
                                 kJointSlides,
                                 kJointsSlide,
                                 kJointFollows,
                                 kJointsFollow,
                                 kFileAbsent,
                                 kFilesAbsent,
                                 kElementLeftOut,
                                 kElementsLeftOut,
                                 kBodyApart,
                                 kBodiesApart,
                                 kRootHeld,
                                 kRootsHeld,
                                 kMeshMass,
                                 kMeshMasses,
                                 kJointStill,
                                 kJointsStill,
                                 kJointUnlimited,
                                 kJointsUnlimited,
                                 kLinkMassless,
                                 kLinksMassless,
                                 kNoEffort,
                                 kSolesGuessed,
                                 kFootInAir,
                                 kArmEnds,
                                 kTwiceItsCentre,
                                 kWhereShapesEnd,
                                 kAnklesAdded,
                                 kFeetNotFlat,
                                 kStraightKnees,
                                 kNoHumanoid,
                                 kNoMass,
                                 kNoTurningJoint,
                                 kOptionOfPerson,
                                 kNoXml,
                                 kNoUrdf,
                                 kNoMjcf,
                                 kXmlNeverClosed,
                                 kXmlTagOpen,
                                 kXmlCloses,
                                 kXmlDeep,
                                 kXmlDefinitions,
                                 kXmlTags,
                                 kBytesAllowed,
                                 kZeroByte,
                                 kXacro,
                                 kLinkAbsent,
                                 kLinkCircle,
                                 kLinkTwice,
                                 kTwoRoots};

}  // namespace messages
}  // namespace shigusa
