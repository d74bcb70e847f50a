// SPDX-License-Identifier: MIT
// The values that go in and out of the engine. JSON objects are those of the command line (docs/task.schema.json,
// docs/result.schema.json); units are metres, kilograms, seconds, radians; +Y is up, a body faces +Z, its left
// is +X; quaternions are [x, y, z, w].

import type { CharacterSpec, Quat, Task, Vec3 } from './task_types.js';

/** A task's file and its parts. The `character` of an engine is opened before: its file's bytes go beside the spec,
 *  its name is `source`. */
export type { CharacterSpec, Criteria, Goal, GoalAxis, Obstacle, Quat, Task, Vec3 } from './task_types.js';

export interface JointDescription {
  name: string; // "right_shoulder.flexion"
  parent: string | null;
  limits_rad: [number, number]; // never passed
  /** How the upper limit grows: from the first to the second as the driver's angle does. */
  limit_coupling?: { driver: string; driver_rad: [number, number]; upper_rad: [number, number] };
  strength_nm: [number, number];
  start_rad: number;
  file_joint?: string; // of robots, "" where the file has none
}

/** A node that node_translations and node_rotations move. A file's hang in the file's hierarchy, in its unit, and
 *  bring the character to where goals are, in the world's axes: `placement` is of the file at rest alone. */
export interface NodeDescription {
  name: string;
  parent: number; // index, or -1
  offset: Vec3; // where the start was measured, in units of node_unit_m
  rotation: Quat; // in its parent, there
  scale?: Vec3; // along its own axes, in all of a motion; absent where it is 1
  file_node?: number; // of glTF: its index in the file
  rest?: { offset: Vec3; rotation: Quat; scale: Vec3 }; // as the file has it at rest; absent where that is the same
}

/** A sentence of the engine's, or a value of one: a sentence of the facts by its key, with its values in order; a number,
 *  with its unit where it is a length; or text that is told as it is, such as a name from a file. `text` is English. */
export type Message = string | Sentence | Quantity;

export interface Sentence {
  text: string;
  key: string;
  values: Message[];
}

export interface Quantity {
  text: string; // its digits within the sentence
  number: number;
  unit?: 'm' | 'mm';
}

/** A character as it was understood: `shigusa body --json` and its nodes. */
export interface CharacterDescription {
  name: string;
  stature_m: number;
  mass_kg: number;
  dof: number;
  joints: JointDescription[];
  effectors: string[];
  places: { effector: string; node: string; start_m: Vec3 }[];
  /** The soles' corners from the effector, in its own frame; the floor that they may not end below, and the
   *  effector's least height where the sole lies as at the start. */
  feet: { effector: string; sole_m: Vec3[]; floor_m: number; least_m: number }[];
  humanoid: Record<string, string>;
  doubts: string[];
  /** The doubts as a page words them in its reader's language. */
  doubt_messages: Message[];
  nodes: NodeDescription[];
  node_unit_m: number;
  support_polygon: [number, number][];
  /** The parts of the body that nothing should pass through, in the start posture: lines with a thickness, at their
   *  first ends radius_m and at their second ones to_radius_m. A part may have two of one name. */
  capsules: { name: string; from_m: Vec3; to_m: Vec3; radius_m: number; to_radius_m: number }[];
  placement?: { unit_m: number; origin: Vec3; left: Vec3; up: Vec3; ahead: Vec3 };
  /** Of a file that was read: the names of a glTF file's animations (one without a name: its index); the frames of the
   *  motion that the start posture is of, 0 where it is the rest pose; whether no unit makes a person of it, so that
   *  the stature is a guess. */
  animations?: string[];
  frames?: number;
  stature_guessed?: boolean;
}

/** Why a motion is not possible: numbers of its kind, and the sentence that says them in English. */
export interface Reason {
  kind: 'strength' | 'pressure' | 'collision' | 'limit';
  verdict: 'strains' | 'impossible';
  joint?: string; // of strength and limit
  share?: number; // of strength, as the next two
  torque_nm?: number;
  strength_nm?: number;
  outside_mm?: number; // of pressure
  limb?: string; // of collision, as the next two
  other?: string;
  depth_mm?: number;
  excess_deg?: number; // of limit
  time_s?: number;
  words: string;
}

/** Where a goal's effector is at the end. Rotations are from standing upright with arms hanging; the error is of goals that
 *  ask for one. */
export interface ReachedGoal {
  effector: string;
  joint: string;
  goal_m: Vec3;
  reached_m: Vec3;
  error_mm: number;
  start_rotation_xyzw: Quat;
  rotation_xyzw: Quat;
  rotation_error_deg?: number;
}

/** One of the actions of a piece of work. */
export interface ActionSummary {
  kind: 'goals' | 'wait_s' | 'grasp' | 'place' | 'release' | 'stand' | 'sit';
  start_s: number;
  end_s: number; // it is done, and its hold is over
  reached: ReachedGoal[];
  steps: number;
  verdict: CandidateSummary['verdict'];
  reasons: Reason[];
  score: number;
  criteria: Record<string, number>;
  /** Of place: the thing where it was put. */
  placed?: { thing: string; position_m: Vec3; rotation_xyzw: Quat; error_mm: number; error_deg: number };
}

/** The greatest of a score and its mean over time. */
export interface ScoreCourse {
  worst: number;
  mean: number;
}

/** REBA or RULA over a motion: of the worse arm, of each, its sub-scores, and the share of the time from each level on. */
export interface PostureCourse extends ScoreCourse {
  time_s: number;
  side: 'left' | 'right';
  left?: ScoreCourse;
  right?: ScoreCourse;
  parts: Record<string, ScoreCourse>;
  share_from_level: Record<string, number>;
}

/** One end of a lift by the revised NIOSH lifting equation; without LI no load is allowed there. */
export interface LiftEnd {
  H_m: number;
  V_m: number;
  D_m: number;
  A_deg: number;
  HM: number;
  VM: number;
  DM: number;
  AM: number;
  FM: number;
  CM: number;
  RWL_kg: number;
  FIRWL_kg: number;
  LI?: number;
  notes?: string[];
}

/** What a motion costs the body (docs/ergonomics.md). */
export interface CostSummary {
  /** The task's, with their defaults. */
  ergonomics: NonNullable<Task['ergonomics']>;
  reba?: PostureCourse;
  rula?: PostureCourse;
  en_1005_4: {
    part: 'trunk' | 'trunk_aside' | 'upper_arm' | 'head' | 'head_inclination';
    side?: 'left' | 'right';
    greatest_deg: number;
    share: Record<string, number>; // of the time, by zone
    longest_s: Record<string, number>;
    verdict?: 'acceptable' | 'conditional' | 'not_acceptable';
  }[];
  /** At L5/S1; a rigid trunk has no forces. */
  low_back?: {
    moment_nm: number;
    moment_time_s: number;
    mean_moment_nm: number;
    compression_n?: number;
    compression_time_s?: number;
    mean_compression_n?: number;
    share_above_3400_n?: number;
    share_above_6400_n?: number;
    limit_by_age_n?: number;
    shear_n?: number;
    shear_time_s?: number;
  };
  /** The joints for which the fewest people are strong enough. */
  strengths: { joint: string; torque_Nm: number; strength_Nm: number; able: number; time_s: number }[];
  niosh: {
    thing: string;
    mass_kg: number;
    weight_limit_kg: number;
    taken_s: number;
    put_s: number;
    origin: LiftEnd;
    destination: LiftEnd;
    lifting_index?: number;
    notes?: string[];
  }[];
  composite_index?: number;
  composite_notes?: string[];
  notes: string[];
  /** The notes as a page words them. */
  note_messages: Message[];
}

export interface CandidateSummary {
  rank: number;
  /** Whether the body could make the motion, and why not. */
  verdict: 'possible' | 'strains' | 'impossible';
  reasons: Reason[];
  possible_in_s?: number;
  most_loaded?: { joint: string; share: number; torque_nm: number; time_s: number };
  score: number;
  criteria: Record<string, number>;
  /** Of work: of its last action that moves. */
  reached: ReachedGoal[];
  /** Of a task with actions: each of them, in their order, as far as the work has come. */
  actions?: ActionSummary[];
  /** Of a task with actions: its motions, by which it is made again. */
  motions?: {
    action: number;
    way: number;
    approach?: number;
    duration_s: number;
    parameters: object;
  }[];
  final_posture: { words: string; knee_flexion_deg: number; trunk_turn_deg: number };
  support?: { centre_of_mass: { least_mm: number; time_s: number }; pressure: { least_mm: number; time_s: number } };
  collision?: { depth_mm: number; limb: string; other: string; time_s: number };
  /** Of a task with cost: true, and of one with actions. */
  cost?: CostSummary;
  duration_s: number;
  frames: number; // of the motion itself
  /** Of what the command line wrote beside: names, and the SHA-256 of each file's bytes, by format. */
  files: Record<string, string>;
  sha256?: Record<string, string>;
  fps?: number; // of rated formats
  file_frames?: number;
  /** How far those files' nodes are from the motion, as they were read back. */
  read_back?: Record<string, { effector_mm: number; feet_mm: number; turn_deg: number }>;
  [key: string]: unknown;
}

/** The object of summary.json. */
export interface Summary {
  version: 1;
  status: 'reached' | 'unsteady' | 'unreachable';
  remaining_mm: number;
  remaining_deg?: number; // of goals that ask for a rotation
  seed: number;
  evaluations: number;
  /** Of the search with other random numbers each; more than 1 of the preset paper alone. */
  runs: number;
  candidates: CandidateSummary[];
  /** Where the character's file was, from the result's folder. */
  character_file?: string;
  /** Why there are fewer than asked for, in English. */
  fewer?: string;
  /** The same to word otherwise. */
  fewer_message?: Message;
  /** Which goals are in one another's way, out of reach, in English. */
  conflict?: string;
  /** The same to word otherwise. */
  conflict_message?: Message;
  /** Goals of hands that may be an oversight, in English. */
  file_notes?: string[]; // of what the command line wrote
  goal_notes?: string[];
  /** The same as a page words them. */
  goal_note_messages?: Message[];
  [key: string]: unknown;
}

/** A parameter that a person edits; `${name}=${value}` is an assignment. */
export interface Parameter {
  name: string;
  group: string;
  kind: 'weight' | 'angle' | 'share'; // of a weight also `${name with .locked for .weight}=true`
  value: number;
  low: number;
  high: number;
  scale: 'linear' | 'log';
  unit: string;
  locked: boolean;
}

/** A table of frames × columns, row by row. */
export interface Series {
  frames: number;
  columns: number;
  values: Float64Array;
}

export const seriesNames = [
  'time', 'angles', 'torques', 'centre_of_mass', 'support', 'effectors', 'node_translations', 'node_rotations', 'upper_limits',
  'things', // x, y, z, qx, qy, qz, qw of each of the task's things, in its order
] as const;
export type SeriesName = (typeof seriesNames)[number];

/** One motion with all that can be read of it. */
export interface Candidate {
  summary: CandidateSummary;
  parameters: Parameter[];
  series: Record<SeriesName, Series>;
}

export interface Generated {
  summary: Summary;
  candidates: Candidate[];
  engine_ms: number; // inside the engine, without the messages to and from the worker
}

export interface Progress {
  fraction: number; // 0..1
  evaluations: number;
  best_score: number;
}

export interface GenerateOptions {
  signal?: AbortSignal; // aborted: the promise is rejected with an AbortError
  onProgress?: (progress: Progress) => void;
}

/** A change of one candidate of a piece of work; actions count from 1. */
export interface WorkEdit {
  action?: number; // whose motion `set` changes; 1 when not given. Those behind it go on from where it now ends
  set?: string[]; // "squat_deg=60", of the action's parameters
  again?: number[]; // actions that are searched anew, for several candidates
  keep?: number[]; // actions that stay: without `again`, the others are searched anew
  seed?: number; // of that search; the task's when not given
}

/** The facts of a format of files. */
export interface FormatFacts {
  name: string; // "bvh", which files that are written end in
  about: string; // one sentence in English
  endings: string[]; // ".glb"
  media_type: string;
  person: boolean; // people are read from it,
  robot: boolean; // robots,
  clip: boolean; // and recorded motion
  written: boolean;
  rated: boolean; // it has frames at the rate that is asked for
  needs: string[]; // formats, of one of which the character must be; none: any will do
  max_bytes: number; // that are read
}

/** The name of a preset. */
export type PresetName = NonNullable<Task['preset']>;

/** A habit that has a name. */
export type HabitName = Extract<Task['habit'], string>;

/** The facts of a preset, and its settings where a task says nothing else. */
export interface PresetFacts {
  name: PresetName;
  mixture: string; // that it ranks by
  search: string;
  candidates: number;
  evaluations: number;
  layered: boolean;
  natural: boolean; // it moves as people do
}

/** All that a page has to know of the engine beside a body, from the engine's own tables. */
export interface Facts {
  version: 1;
  criteria: { name: string; scale: string }[];
  mixtures: Record<string, Readonly<Record<string, number>>>; // weights by criterion
  presets: PresetFacts[];
  pareto_mixture: string; // that a task with `pareto` ranks by, whatever its preset
  default_preset: PresetName; // of a task that names none
  default_body: string; // the body of such a task
  habits: { name: HabitName; about: string }[]; // the first is that of a task that names none; one phrase in English
  searches: string[];
  generators: string[];
  layer_readings: string[];
  sexes: string[];
  extents: string[];
  bodies: { name: string; dof: number }[];
  bones: string[];
  /** Least and most of what a person sets, by its key in files. */
  ranges: Record<
    | 'position_m' | 'load_kg' | 'tolerance_m' | 'stature_m' | 'mass_kg' | 'seat_m' | 'duration_s' | 'ease' | 'gaze_lead' | 'obstacles'
    | 'candidates' | 'evaluations' | 'fps',
    readonly [number, number]
  >;
  formats: FormatFacts[];
  /** Sentences that doubts and failures are made of, with `{}` or `{:.2f}` for each value. */
  messages: { key: string; text: string }[];
  /** The numbers of timing that a person sets: parameters of a motion, or fields of the task. Sentences in English. */
  timing: { name: string; low: number; high: number; of: 'motion' | 'task'; sentence: string }[];
  /** Whose names joints of built-in bodies may have in files: there, by their own names. */
  joint_names: { name: string; bones: Readonly<Record<string, string>> }[];
}

export interface ExportOptions {
  fps?: number; // of rated formats; 60 when not given
  clip?: string; // what the animation is called in GLB and VRMA; of all candidates with their numbers after it
  joint_names?: string; // of a built-in body in BVH: one of the facts' joint_names
  in_place?: boolean; // what the hips travel along the floor is left out
  only_this_clip?: boolean; // of GLB: the animations that the file has are left out
}

/** The series that can be had at any rate, as files have them: all. */
export type SampledName = SeriesName;

/** How a series is read as a table. */
export interface TableOptions {
  fps?: number; // as files have them; the motion's own frames when not given
  place?: 'world' | 'file'; // where nodes move: file: where the character stands in its file, in the file's axes
}

/** A series with what its columns mean. */
export interface SeriesTable extends Series {
  name: SeriesName;
  unit: string; // 's', 'rad', 'N m', 'm' or ''
  fps: number;
  shape: number[]; // frames × names × components, where columns have these
  names?: string[]; // of joints, nodes, effectors, things, or the two of support
  components?: string[]; // ['x', 'y', 'z', 'w']
}

/** A refusal of the engine: a code of the C interface and a sentence for a person, in English. */
export interface EngineFailure {
  /** Of what the engine refused: what it is about (may be empty), and the sentence without that. */
  reason?: { place: string; message: Message };
  code: 'invalid_argument' | 'not_found' | 'parse' | 'io' | 'unsupported' | 'cancelled' | 'out_of_memory' | 'fault';
  message: string;
}

/** Where a node stands in its parent: [x, y, z], [x, y, z, w] and [x, y, z]; what is absent is none. */
export interface NodePlace {
  translation?: readonly number[];
  rotation?: readonly number[];
  scale?: readonly number[];
}

/** A node of a host's skeleton at rest, and as it is now, from which motions start. */
export interface HostNode extends NodePlace {
  name: string;
  /** Index of the parent; -1 or absent: none. */
  parent?: number;
  pose?: NodePlace;
}

/** A character that the engine has; plain data, so that it survives a worker's end. */
export interface Character {
  readonly id: number;
  readonly spec: CharacterSpec;
  readonly bytes?: Uint8Array;
  readonly description: CharacterDescription;
}

/** The engine: computes in workers of its own, one for searches and one for what must be quick. Failures
 *  reject with an Error whose `failure` is an EngineFailure. */
export interface Engine {
  readonly facts: Facts;
  open(spec: CharacterSpec, bytes?: Uint8Array): Promise<Character>;
  close(character: Character): void;
  /** A whole search. An abort ends it at once. */
  generate(character: Character, task: Task, options?: GenerateOptions): Promise<Generated>;
  /** A quick search for a goal that is being dragged; of calls that wait the newest alone is answered, the
   *  others resolve to undefined. */
  preview(character: Character, task: Task): Promise<Generated | undefined>;
  /** A candidate (from 1) anew, with changed parameters; like preview, of the calls of one `slot` that wait the newest alone
   *  is answered. */
  replay(
    character: Character, summary: Summary, candidate: number, assignments: string[], slot?: string,
  ): Promise<Generated | undefined>;
  /** A candidate (from 1) of a piece of work after an edit of one of its actions, or with some of them searched anew. An
   *  abort ends it at once. */
  replayWork(
    character: Character, summary: Summary, candidate: number, edit: WorkEdit, options?: GenerateOptions,
  ): Promise<Generated>;
  /** All candidates of a result anew, from its JSON. An abort ends it at once. */
  restore(character: Character, summary: Summary, options?: GenerateOptions): Promise<Generated>;
  mirror(character: Character, summary: Summary): Promise<Generated>;
  /** `format`: the name of one that is written; `candidate` 0: all, in one GLB. Refused where the file, read back, is not where the motion is. */
  export(
    character: Character, summary: Summary, candidate: number, format: string, options?: ExportOptions,
  ): Promise<Uint8Array>;
  /** A candidate's series at `fps` frames a second. */
  sampled<Name extends SampledName>(
    character: Character, summary: Summary, candidate: number, names: readonly Name[], fps: number,
  ): Promise<Record<Name, Series>>;
  scoreClip(name: string, bytes: Uint8Array, options?: object): Promise<object>;
  /** Bytes that the two modules have taken, most of them free again: modules never shrink. */
  memory(): Promise<{ search: number; quick: number }>;
  dispose(): void;
}
