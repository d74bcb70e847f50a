// SPDX-License-Identifier: MIT
// Task files, as docs/task.schema.json has them: `scripts/make_schema` writes this file.

export type Vec3 = [number, number, number];
export type Quat = [number, number, number, number];

export interface Part {
  from_m: Vec3;
  to_m: Vec3;
  /** At from_m. */
  radius_m: number;
  /** At to_m; radius_m when not given. */
  to_radius_m?: number;
  /** Of a flat part, two lines side by side: to either of them. */
  aside_m?: Vec3;
}

/** A person as measured, in the start posture. */
export interface Landmarks {
  left_hip: Vec3;
  left_knee: Vec3;
  left_ankle: Vec3;
  left_toe: Vec3;
  right_hip: Vec3;
  right_knee: Vec3;
  right_ankle: Vec3;
  right_toe: Vec3;
  left_shoulder: Vec3;
  left_elbow: Vec3;
  left_wrist: Vec3;
  left_fingertip: Vec3;
  right_shoulder: Vec3;
  right_elbow: Vec3;
  right_wrist: Vec3;
  right_fingertip: Vec3;
  neck: Vec3;
  head_top: Vec3;
  /** Joints between pelvis and shoulders, from below. Of the extent human. */
  spine?: Vec3[];
  head?: Vec3;
  left_clavicle?: Vec3;
  right_clavicle?: Vec3;
  left_toes?: Vec3;
  right_toes?: Vec3;
  left_grip?: Vec3;
  right_grip?: Vec3;
  /** How far back the line from the hips to the shoulders leans of a trunk that is upright. */
  trunk_lean_rad?: number;
  left_sole?: [Vec3, Vec3, Vec3, Vec3];
  right_sole?: [Vec3, Vec3, Vec3, Vec3];
  /** Of a character with a mesh: what of it nothing should pass through. Each part is a line with a thickness in
   * its own frame: from the joint that it hangs on, y from its far end to that joint, x to the left, z ahead.
   * Parts that are absent are by stature. */
  parts?: {
    head?: Part;
    jaw?: Part;
    neck?: Part;
    trunk?: Part;
    pelvis?: Part;
    spine?: Part;
    chest?: Part;
    upper_chest?: Part;
    left_thigh?: Part;
    right_thigh?: Part;
    left_shank?: Part;
    right_shank?: Part;
    left_foot?: Part;
    right_foot?: Part;
    left_upper_arm?: Part;
    right_upper_arm?: Part;
    left_forearm?: Part;
    right_forearm?: Part;
    left_hand?: Part;
    right_hand?: Part;
  };
}

/** A built-in body, or a person or a robot from a file. */
export interface CharacterSpec {
  /** human, full_body, half_body or a BVH, GLB, glTF, VRM, FBX, URDF or MJCF (.xml) file; of a person with
   * landmarks or a robot with urdf, only a name. */
  source: string;
  /** Standing height. Of a person from a file: scales the file. */
  stature_m?: number;
  /** That of an average person of the stature when not given. Of a robot whose file has no masses: spread over its
   * links as a person's. */
  mass_kg?: number;
  /** The nodes of the file that some humanoid bones are: {"right_hand": "Bone_17"}. Goes before what the file and
   * its names tell. */
  map?: Record<string, string>;
  /** A robot as read: the text of its URDF file without meshes; one of an MJCF file as URDF. With it the file is
   * not needed. */
  urdf?: string;
  /** For mass distribution and strength. */
  sex?: 'male' | 'female';
  /** Height of the seat that the person sits on; they stand when it is not given. */
  seat_m?: number;
  /** Heels may lift, where people's do; of the body human, standing. */
  heels?: boolean;
  /** Of a person from a file: all freedoms that the file has joints for (human), 18 (full) or 9 (half). human when
   * not given, by the presets paper and layers full. */
  extent?: 'half' | 'full' | 'human';
  /** Of a person from a file: the frame that is the start posture, from 0, of glTF of an animation; or rest, the
   * file's rest pose, from which the person stands at ease. When not given, of BVH and of an animation the first
   * in which the person stands still on both feet, else the rest pose; of glTF without an animation the rest pose;
   * of BVH that begins with a T- or an A-pose that one, at ease. */
  frame?: number | 'rest';
  /** Of a glTF file: the name or the index of the animation that the frame is of, at 60 frames a second; the first
   * when not given. Of an MJCF file: the name or the index of the keyframe that the robot starts from. */
  animation?: string;
  /** Of a person with landmarks: guesses of the measuring; of a robot from an MJCF file: what was left out. */
  doubts?: string[];
  /** Of a person with landmarks: nodes of the file that are not where the body has those of their names, in the
   * start posture. Goals are for the file's. */
  places_m?: Record<string, Vec3>;
  /** The person as measured, in the start posture; stature_m stands beside it. */
  landmarks_m?: Landmarks;
}

/** An axis of the effector and the direction that it is to have. */
export interface GoalAxis {
  /** In the effector's own frame; of hands also by a word. */
  axis: 'palm' | 'thumb' | 'fingers' | Vec3;
  /** In the world. */
  direction: 'up' | 'down' | 'left' | 'right' | 'ahead' | 'back' | 'in' | 'out' | Vec3;
}

/** The final place of one effector, and how it is turned there. */
export interface Goal {
  /** right_hand, left_foot, head, hips or another joint of the body: left or right shoulder, elbow, wrist, hip,
   * knee, foot, toes, clavicle; spine, chest, neck; or the name of another node. */
  effector: string;
  /** In the world. */
  position_m: Vec3;
  /** The mass that a hand with a goal holds all the way. */
  load_kg?: number;
  /** How the effector is turned at the end, a unit quaternion: from the world's axes, which its own are where the
   * body stands upright facing +Z with arms hanging and thumbs ahead. */
  rotation_xyzw?: Quat;
  /** In place of a rotation: an axis of the effector and the direction that it is to have; the effector may turn
   * about it. */
  axis?: GoalAxis;
  /** Half the sides, along the world's axes, of a box about the goal: anywhere in it will do. */
  tolerance_m?: Vec3;
}

/** A bar of a thing, around which a hand closes. */
export interface Handle {
  /** Its middle from the middle of the thing, along the thing's own axes. */
  position_m: Vec3;
  /** The bar's direction in the thing's own axes: [0, 1, 0], upright, when not given. */
  along?: Vec3;
}

/** A box of which a thing is made, with others. */
export interface PartOfThing {
  /** Its middle from the middle of the thing, along the thing's own axes. */
  position_m: Vec3;
  /** Its sides along the thing's own axes. */
  size_m: Vec3;
}

/** A rigid body that hands can grasp, carry and put down. */
export interface Thing {
  /** box when not given, cylinder (upright) or sphere. */
  shape?: 'box' | 'cylinder' | 'sphere';
  /** Its sides along its own axes; of a cylinder diameter, height, diameter; of a sphere three times its diameter. */
  size_m: Vec3;
  /** Of even density. */
  mass_kg?: number;
  /** Its middle at the start. In the air it stays where it is until it is grasped. */
  position_m: Vec3;
  /** Its turn about +Y at the start, degrees to the left; 0, when not given, has its sides along the world's axes. */
  turn_deg?: number;
  /** From its middle, along its own axes; when not given the middle, or that of its parts. */
  centre_of_mass_m?: Vec3;
  /** true: it stays upright in the hand, such as a cup. */
  upright?: boolean;
  /** A bar outside its shape, by which one hand takes it: a mug's, or a bucket's. */
  handle?: Handle;
  /** Of a box: boxes within its sides that are its form, such as those of a chair; all of it when not given. */
  parts?: PartOfThing[];
}

/** A place on the floor and a direction there. */
export interface Stance {
  /** Degrees from +Z, growing to the left; 0 when not given. */
  facing_deg?: number;
  /** Of a seat above the floor; 0.45 when not given. */
  height_m?: number;
  position_m?: [number, number];
}

/** One of goals (or look_at_m alone), wait_s, grasp, place, release, stand and sit, with what belongs to it. */
export interface Action {
  /** The final places of effectors, as in a task of version 1. */
  goals?: Goal[];
  /** The point that the eyes are on. */
  look_at_m?: Vec3;
  /** The thing that the hands take, and lift by 5 cm. */
  grasp?: string;
  /** The hands that take it; when not given two for a box wider than a hand or a thing heavier than 3 kg, else one. */
  with?: string[];
  /** The thing in the hands that is put to position_m. */
  place?: string;
  /** Of place: where the middle of the thing is to be. */
  position_m?: Vec3;
  /** Of place: the thing's turn about +Y there, degrees to the left of the world's axes; 0 when not given. */
  turn_deg?: number;
  /** The thing in the hands that is let go where it is. */
  release?: string;
  /** Where to stand up straight: so far where the feet are. */
  stand?: Stance;
  /** Where to sit down: needs steps, which are not there yet. */
  sit?: Stance;
  /** Seconds for which the body stays as it is. */
  wait_s?: number;
  /** Seconds for which it stays at the action's end; 0 when not given. */
  hold_s?: number;
  /** true: goals are passed without a stop. */
  via?: boolean;
  /** Seconds of the action's main motion; from the distance when not given. */
  duration_s?: number;
}

/** A box with round edges: without size_m a sphere, with size along one axis a capsule. */
export interface Obstacle {
  /** For messages. */
  name?: string;
  /** Its middle. */
  position_m: Vec3;
  /** Along its own axes. */
  size_m?: Vec3;
  /** Of its round edges, beyond the size on all sides. */
  radius_m?: number;
  /** A unit quaternion. */
  rotation_xyzw?: Quat;
}

/** A hand without a goal, and what it rests on. */
export interface Support {
  /** left_hand or right_hand. */
  effector: string;
  /** thigh: that of the hand's own side, a little above the knee; or the name of an obstacle. */
  on: string;
}

/** A person's way of moving. */
export interface Habit {
  /** Flexion of the knees over the lean of a far leaning trunk; 1.7 when not given. */
  knees?: number;
  /** Bend of the back beside people's usual one with the pelvis tipped far, below 0 a straight back; 0 when not
   * given. */
  round_rad?: number;
  /** Angle by which the eyes look down from the head at a low goal; 15° when not given. */
  eyes_rad?: number;
  /** Flexion of a free arm's elbow over the forward turn of its shoulder; 0.6 when not given. */
  free_arm?: number;
}

/** Weights of the score, not all 0, and the scale at which each penalty is full (docs/criteria.md). Absent ones
 * are as in the preset's own mixture. */
export interface Criteria {
  joint_range?: {
    weight?: number;
    margin?: number;
  };
  balance?: {
    weight?: number;
    lean?: number;
  };
  torque?: {
    weight?: number;
    share?: number;
  };
  balance_zone?: {
    weight?: number;
    margin_m?: number;
  };
  discomfort?: {
    weight?: number;
    share?: number;
  };
  joint_acceleration?: {
    weight?: number;
    acceleration_rad_s2?: number;
  };
  work?: {
    weight?: number;
    share?: number;
  };
  low_back?: {
    weight?: number;
    share?: number;
  };
  head?: {
    weight?: number;
    height?: number;
  };
  collision?: {
    weight?: number;
    depth_m?: number;
  };
  centre_of_pressure?: {
    weight?: number;
    outside_m?: number;
  };
  feasibility?: {
    weight?: number;
    outside_m?: number;
  };
  coordination?: {
    weight?: number;
    angle_rad?: number;
  };
  hand_curve?: {
    weight?: number;
    offset?: number;
  };
  trunk_travel?: {
    weight?: number;
    distance_m?: number;
  };
  mass_ahead?: {
    weight?: number;
    distance_m?: number;
  };
  jolts?: {
    weight?: number;
    limit?: number;
  };
}

/** Thresholds that REBA and RULA leave open; a border belongs to the better band. */
export interface PostureThresholds {
  /** Trunk that counts as upright; 5°. */
  upright_rad?: number;
  /** Wrist that counts as neutral in RULA; 5°. */
  straight_wrist_rad?: number;
  /** Neck beyond which it is extended; 5°. */
  neck_extends_rad?: number;
  /** Trunk bent sideways or twisted beyond this; 10°. */
  trunk_aside_rad?: number;
  /** Neck bent sideways or twisted beyond this; 15°. */
  neck_aside_rad?: number;
  /** Upper arm abducted beyond this; 30°. */
  arm_abducted_rad?: number;
  /** Shoulder raised by more than this; 0.025. */
  shoulder_raised_m?: number;
  /** Hand bent sideways beyond this; 10°. */
  wrist_deviates_rad?: number;
  /** Share of the forearm's range at either end that is its end; 0.25. */
  forearm_end?: number;
  /** Share of the weight above which one foot bears it; 0.75. */
  one_foot?: number;
  /** Upper arm that hangs so near to the vertical is helped by gravity in REBA; 20°. */
  gravity_helps_rad?: number;
  /** Wrist beyond the middle of the trunk that works across it in RULA; 0. */
  hand_across_m?: number;
  /** Wrist outside its shoulder that works out to the side in RULA; 0.1. */
  hand_out_m?: number;
}

/** What a motion does not tell, for what it costs the body. */
export interface Ergonomics {
  /** Grip on the load: good, when not given, fair, poor or, in REBA, unacceptable. */
  coupling?: 'good' | 'fair' | 'poor' | 'unacceptable';
  /** true: a part of the body is held for more than a minute. */
  held?: boolean;
  /** true: small-range actions recur more than 4 times a minute. */
  repeated?: boolean;
  /** true: rapid large changes of posture, or an unstable base. */
  rapid?: boolean;
  /** true: forces build up rapidly. */
  shock?: boolean;
  /** Recurrence of each lift of the motion, lifts a minute; 0.2, the least of the lifting equation, when not given. */
  lifts_per_min?: number;
  /** Duration of lifting in a shift with its rests: short, up to 1 h, when not given, moderate, up to 2 h, or long,
   * up to 8 h. */
  lifting_time?: 'short' | 'moderate' | 'long';
  /** Whether lifts end with control, so that both ends count; true when not given. */
  placed_with_care?: boolean;
  /** Recurrence of the motion a minute, for EN 1005-4; when not given, postures that are held for 4 s alone are
   * judged. */
  moves_per_min?: number;
  /** For the limit of compression at L5/S1 by age and sex; none when not given. */
  age_years?: number;
  /** For that limit; the character's when not given. */
  sex?: 'male' | 'female';
  /** Of the back's muscles about L5/S1; 0.05 when not given, texts have up to 0.07. */
  back_lever_m?: number;
  /** Of RULA's table A: present, when not given, or older. */
  rula_edition?: 'present' | 'older';
  /** Where REBA and RULA name none. */
  thresholds?: PostureThresholds;
}

/** A request: a body and the final places of its hands, feet or other joints. Metres, kilograms, seconds,
 * radians; +Y up, the body faces +Z, its left is +X, origin on the floor between the feet. */
export interface Task {
  version?: number;
  /** human when not given, full_body, half_body, a person's BVH, GLB, glTF, VRM or FBX file, or a robot's URDF or
   * MJCF (.xml) file, relative to the task file. */
  character?: string | CharacterSpec;
  /** The final places of effectors, such as right_hand, head, hips, left_elbow, right_knee, left_foot or any joint
   * that `shigusa body` names: metres, +Y up, the body faces +Z, its left is +X. One for each effector at most;
   * one at least is given, or a foot is left out of contacts. */
  goals?: Goal[];
  /** Of version 2: things by their names, which actions grasp; the command line knows boxes, by their middle, size
   * and mass. */
  things?: Record<string, Thing>;
  /** A GLB or glTF file, relative to the task file, whose meshes are further obstacles, or things if an action
   * names them. Results hold what was read of it instead. */
  scene?: string;
  /** Of version 2, in place of goals: actions that follow each other. On the command line goals, or stand, wait=S,
   * grasp=THING, place=THING,X,Y,Z or release=THING, with hold=S, look=X,Y,Z or via, and semicolons between them. */
  actions?: Action[];
  /** The point that the eyes are on; when not given, the first goal of a limb, or between two hands'. */
  look_at_m?: Vec3;
  /** Feet that stay on the floor, one at least; all without a goal when not given. A foot that is not named and has
   * no goal lifts. */
  contacts?: string[];
  /** Things that nothing of the body should pass through; the command line knows boxes, by their middle and size in
   * metres. */
  obstacles?: Obstacle[];
  /** Of the preset flat: hands without a goal that may rest on the thigh, or on an obstacle by its name, and do
   * where it pays. What they press with, from 0 to 0.25 of the body's weight, is a parameter, such as
   * left_hand.support; below 0 the hand stays free. */
  support?: Support[];
  /** Seconds of the motion; from the distance when not given. */
  duration_s?: number;
  /** How early the motion makes its way: above 0 it is quicker in its first half and slows down for longer, below 0
   * it is slow to begin; 0, as people move, when not given. Not of presets with layers. */
  ease?: number;
  /** The share of the duration by which the head turns earlier to what is looked at, or later below 0, than
   * people's do; 0 when not given. Of the presets flat and human. */
  gaze_lead?: number;
  /** paper, as published; flat, when not given: all parameters at once, within joint limits; layers: the paper's
   * hierarchy, first trunk and limb lengths, then arms; or human: trunk and limb lengths, then the elbows' swivel,
   * then free arms. Criteria, search and number of candidates are its own where nothing else is said. */
  preset?: 'paper' | 'flat' | 'layers' | 'human';
  /** The person's way of moving: natural, when not given, as most people; half: knees bend as much as the trunk
   * leans; squat: knees bend much; stoop: knees stay almost straight; or numbers, such as `shigusa habit` measures
   * in a recorded motion. Of the presets flat and human. */
  habit?: 'natural' | 'half' | 'squat' | 'stoop' | Habit;
  /** Of the presets layers and human, the meaning of the paper's 14 parameters of the whole body:
   * shared_contractions, when not given: 12 weights and 2 contractions, or contraction_a_limb: 10 and 4. */
  layer_reading?: 'shared_contractions' | 'contraction_a_limb';
  /** The algorithm; the preset's own when not given. */
  search?: 'paper_ga' | 'log_ga' | 'annealing' | 'cma_es' | 'de' | 'random';
  /** Of the preset flat: candidates are a front of the criteria, motions of which none is better by all of them;
   * criteria are then the mixture pareto where nothing else is said. */
  pareto?: boolean;
  /** The mixture that motions are scored by: paper, default or pareto, or in files weights and scales; the preset's
   * own when not given. */
  criteria?: 'paper' | 'default' | 'pareto' | Criteria;
  /** Parameters that the search leaves as given, such as squat_deg=60 or right_shoulder.flexion.locked=true (as
   * --set of edit). */
  fixed?: string[];
  /** The maker of motions from parameters: weighted_ik when not given, or nlp_ik, constrained minimisation in each
   * frame, ten times slower. */
  generator?: 'weighted_ik' | 'nlp_ik';
  /** 1: motions have one phase. Old tasks with 2 are refused with what to write. */
  phases?: number;
  /** Of a character with fingers, by the presets flat and human: grip, when not given: a reaching hand opens on the
   * way and closes to a relaxed grip, the other is relaxed; or none: fingers stay as the file has them. */
  finger_play?: 'grip' | 'none';
  /** true: results tell what each motion costs the body by REBA, RULA, EN 1005-4 and the revised NIOSH lifting
   * equation, the loads at L5/S1, and joint torques beside people's strengths. */
  cost?: boolean;
  /** What the motion does not tell, such as how often it recurs, for that cost. */
  ergonomics?: Ergonomics;
  /** Same seed, same bytes; 0 when not given. */
  seed?: number;
  /** Candidates to deliver, at most; the preset's own number when not given. */
  candidates?: number;
  /** Motions that the search may score: it starts again, with other random numbers, until they are used up. When
   * not given, it runs once. */
  evaluations?: number;
}
