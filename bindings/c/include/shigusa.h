// SPDX-License-Identifier: MIT
/** @file
 * shigusa's C interface: the one door by which games, browsers and other languages come in.
 *
 * A character is a body with what its file tells; a result is what a task came to: candidates with
 * their motions. Tasks, results and descriptions are UTF-8 JSON, the same objects that the command
 * line reads and writes (docs/task.schema.json, docs/result.schema.json). Numbers have a point,
 * whatever locale the host has chosen. Units are metres, kilograms, seconds and radians, the world
 * is right-handed with +Y up, and a body faces +Z with its left at +X.
 *
 * Every function but those that free or tell a version returns a status, and on failure leaves what
 * its pointers point to as it was; shigusa_message() then says in a sentence what is wrong, where,
 * and what is allowed. No C++ exception comes out, and null pointers are refused
 * (SHIGUSA_INVALID_ARGUMENT) where nothing else is said. Objects may be used from one thread at a
 * time, different objects from several at once; a result keeps what it needs of its character, so
 * either may be freed first.
 *
 * Every function computes in the arithmetic that results are made of, rounded to nearest and with
 * numbers near 0 as they are, whatever the host has set; the host's comes back before it returns,
 * and before a function of the host's is called. Where memory runs out, a function that returns a
 * status says so (SHIGUSA_OUT_OF_MEMORY), and what was there before stays usable.
 *
 * Within one SHIGUSA_ABI_VERSION functions and numbers are only added. */
#ifndef SHIGUSA_H
#define SHIGUSA_H

#include <stddef.h>
#include <stdint.h>

/** Lets a function be seen outside the library. */
#if defined(__EMSCRIPTEN__)
#define SHIGUSA_API __attribute__((used, visibility("default")))
#elif defined(__GNUC__)
#define SHIGUSA_API __attribute__((visibility("default")))
#else
#define SHIGUSA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The version of this header's functions and numbers, which an incompatible change raises. */
#define SHIGUSA_ABI_VERSION 1

/** The SHIGUSA_ABI_VERSION that the library was built with. */
SHIGUSA_API uint32_t shigusa_abi_version(void);
/** The library's own version ("0.1.0"). */
SHIGUSA_API const char* shigusa_version(void);

/** What came of a call: one of the numbers below. */
typedef int32_t shigusa_status;
/** The values of shigusa_status. */
enum {
  SHIGUSA_OK = 0,               /**< done */
  SHIGUSA_INVALID_ARGUMENT = 1, /**< a value is outside what is allowed */
  SHIGUSA_NOT_FOUND = 2,        /**< no file, joint or effector of that name */
  SHIGUSA_PARSE = 3,            /**< bytes that do not follow their format */
  SHIGUSA_IO = 4,               /**< the operating system refused */
  SHIGUSA_UNSUPPORTED = 5,      /**< understood, but outside what this build does */
  SHIGUSA_CANCELLED = 6,        /**< stopped before there was anything to give */
  SHIGUSA_OUT_OF_MEMORY = 7,    /**< there was no memory for it */
  SHIGUSA_FAULT = 8,            /**< a fault of the library itself: please report it */
  SHIGUSA_HOST = 9              /**< a function of the caller's own threw, and the message is its */
};

/** The reason of the calling thread's last failure, "" if none failed yet. Valid until this
 * thread's next failure. */
SHIGUSA_API const char* shigusa_message(void);

/** Text or a file, owned by the caller. Text ends with a zero that `size` does not count. */
typedef struct shigusa_bytes shigusa_bytes;
/** The bytes themselves, valid until they are freed. */
SHIGUSA_API const char* shigusa_bytes_data(const shigusa_bytes* bytes);
/** The number of bytes. */
SHIGUSA_API size_t shigusa_bytes_size(const shigusa_bytes* bytes);
/** Gives the bytes back; null is allowed. */
SHIGUSA_API void shigusa_bytes_free(shigusa_bytes* bytes);

/** The same reason as JSON, for a user interface that speaks to its user in another language:
 * {"place" (what it is about, "goal of left_foot" or "line 3 of hero.bvh"; may be empty),
 * "message"}. A message is {"text" (in English), "key" (of its sentence in shigusa_facts),
 * "values"}, each value a message, or {"text" (its digits), "number", "unit" ("m" or "mm", of
 * lengths alone)}, or text such as a name from a file; a message that has no key is text too. Does
 * not change the reason. */
SHIGUSA_API shigusa_status shigusa_failure(shigusa_bytes** json);

/** All that a user interface has to know beside a body, from the engine's own tables, of this
 * build:
 * {"criteria": [{"name", "scale" (the key of its scale)}], "mixtures": {name: {criterion: weight}},
 * "presets": [{"name", "mixture" (that it ranks by), "search", "candidates", "evaluations",
 * "layered", "natural"}], "pareto_mixture" (that a task with "pareto" ranks by, whatever its
 * preset), "default_preset" and "default_body" (of a task that names none), "searches",
 * "generators", "layer_readings", "sexes", "extents" and "bones" (words), "bodies": [{"name",
 * "dof"}], "ranges": {key in files: [least, most]}, "formats": [{"name", "about", "endings"
 * ([".glb", …]), "media_type", "person", "robot", "clip" (read from it), "written", "rated" (it has
 * frames at the rate asked for), "needs" (formats, of one of which the character must be; none: any
 * will do), "max_bytes" (that are read)}], "timing": [{"name", "low", "high", "of" ("motion": a
 * parameter, or "task"), "sentence"}], "joint_names": [{"name", "bones" ({own: there})}],
 * "messages": [{"key", "text" (in English, with {} or {:.2f} for each value)}], the sentences that
 * doubts and failures are made of}. */
SHIGUSA_API shigusa_status shigusa_facts(shigusa_bytes** json);

/* ---- Characters ------------------------------------------------------------------------------ */

/** A body with what its file tells. */
typedef struct shigusa_character shigusa_character;

/** `spec`: the `character` of a task file, such as {"source": "human", "stature_m": 1.6} or
 * {"source": "hero.vrm", "map": {"right_hand": "Bone_17"}}. For a file `source` is its name, whose
 * ending tells the format (shigusa_facts), and `file` its bytes; for a built-in body (there too)
 * `file` is null and `file_size` 0. No file is ever opened. */
SHIGUSA_API shigusa_status shigusa_character_create(const char* spec, const void* file,
                                                    size_t file_size,
                                                    shigusa_character** character);
/** Gives a character back; null is allowed. */
SHIGUSA_API void shigusa_character_free(shigusa_character* character);

/** The character as it was understood: the object that `shigusa body --json` prints, with the nodes
 * that SHIGUSA_NODE_TRANSLATIONS and _ROTATIONS move: "nodes": [{"name", "parent" (index or -1),
 * "offset" [x, y, z], "scale" [x, y, z] (along its own axes, in all of a motion; absent where it is
 * 1), "file_node" (of glTF: index in the file)}], "node_unit_m" (metres per unit of their
 * translations), "support_polygon" [[x, z], …] (m, what the feet stand on), and "feet":
 * [{"effector", "sole_m" [[x, y, z], …] (its corners from the effector, in the effector's frame),
 * "floor_m" (no corner may end below), "least_m" (the effector's height with the sole as it is at
 * the start)}], and "doubt_messages": the doubts as messages (shigusa_failure). */
SHIGUSA_API shigusa_status shigusa_character_describe(const shigusa_character* character,
                                                      shigusa_bytes** json);

/* ---- Motions --------------------------------------------------------------------------------- */

/** What a task came to: candidates with their motions. */
typedef struct shigusa_result shigusa_result;

/** How a caller watches and stops a search. */
typedef struct shigusa_watch {
  /** Called on the calling thread now and then, with the share of the budget that is used (0..1),
   * motions scored and the lowest score so far; returns 0 to go on, anything else to stop with the
   * best so far. What it throws ends the call (SHIGUSA_HOST). */
  int32_t (*report)(void* user, double fraction, int32_t evaluations, double best_score);
  void* user; /**< handed to `report` */
} shigusa_watch;

/** Searches motions. `task` is a task file's text; `character`, where given, takes the place of the
 * task's own; null: the task's, which must need no file. `watch` may be null. A goal out of reach
 * is no failure: the result's status says so, and its one candidate ends as near as it gets.
 * `threads`: 0 for one a core; changes no result. */
SHIGUSA_API shigusa_status shigusa_generate(const shigusa_character* character, const char* task,
                                            int32_t threads, const shigusa_watch* watch,
                                            shigusa_result** result);

/** Generates a result's motions again from its JSON (summary.json), without a search. `character`
 * as above: with it they can leave on its own skeleton. It must be the one of the result. */
SHIGUSA_API shigusa_status shigusa_restore(const shigusa_character* character, const char* summary,
                                           shigusa_result** result);

/** Restores a result, watched as a search is: evaluations are the motions that are done. Where the
 * caller stops it there is no result (SHIGUSA_CANCELLED). A result of 1000 candidates, the most
 * there may be, takes some seconds. */
SHIGUSA_API shigusa_status shigusa_restore_watched(const shigusa_character* character,
                                                   const char* summary, const shigusa_watch* watch,
                                                   shigusa_result** result);

/** Generates a candidate's motion again with changed parameters: a result of one candidate.
 * `assignments`: JSON list of what `shigusa edit --set` takes, ["squat_deg=60", …]; none or null
 * leaves all as it is. Candidates count from 1. */
SHIGUSA_API shigusa_status shigusa_replay(const shigusa_result* result, int32_t candidate,
                                          const char* assignments, shigusa_result** edited);

/** All candidates with the other side's hands and feet, by the same character from the same start.
 */
SHIGUSA_API shigusa_status shigusa_mirror(const shigusa_result* result, shigusa_result** mirrored);

/** Gives a result back; null is allowed. */
SHIGUSA_API void shigusa_result_free(shigusa_result* result);

/** Candidates in it, lowest score first; 0 of null. */
SHIGUSA_API int32_t shigusa_result_candidates(const shigusa_result* result);

/** The object of summary.json, but for `files`, which are none; what shigusa_restore takes. */
SHIGUSA_API shigusa_status shigusa_result_describe(const shigusa_result* result,
                                                   shigusa_bytes** json);

/** The parameters of a candidate that a person edits, in order: [{"name", "group"
 * ("posture", "path", "trunk", "right_arm", "legs", …), "kind" ("weight", "angle" or "share"),
 * "value", "low", "high", "scale"
 * ("linear" or "log"), "unit" ("" or "deg"), "locked"}]. "NAME=VALUE" is an assignment, and of
 * "right_knee.flexion.weight" also "right_knee.flexion.locked=true". */
SHIGUSA_API shigusa_status shigusa_result_parameters(const shigusa_result* result,
                                                     int32_t candidate, shigusa_bytes** json);

/** A candidate as a file of a format that is written (shigusa_facts): "bvh". One that this build or
 * the character lacks is refused. Candidate 0: all of them in one GLB. */
SHIGUSA_API shigusa_status shigusa_result_export(const shigusa_result* result, int32_t candidate,
                                                 const char* format, shigusa_bytes** file);

/** Exports with `options`: {"fps": 24, "clip": "Reach", "joint_names": "mixamo", "in_place": true}.
 * fps: frames a second of rated formats, 1 to 240 (60 where none are given); clip: what the
 * animation is called in GLB and VRMA, of all candidates with their numbers after it; joint_names
 * (shigusa_facts): of a built-in body in BVH; in_place: what the hips travel along the floor is
 * left out. The last frame is the first that is not before the motion's end, and exactly its last.
 * The file is read back before it is given: where its nodes are not with the motion there is none
 * (SHIGUSA_UNSUPPORTED). The others have the frames of the series. `options` may be null. */
SHIGUSA_API shigusa_status shigusa_result_export_with(const shigusa_result* result,
                                                      int32_t candidate, const char* format,
                                                      const char* options, shigusa_bytes** file);

/** The numbers that can be read of each frame of a candidate. */
typedef int32_t shigusa_series;
/** The values of shigusa_series. */
enum {
  SHIGUSA_TIME = 0,    /**< 1 column: s */
  SHIGUSA_ANGLES = 1,  /**< a column a freedom, in the order of the description's joints: rad */
  SHIGUSA_TORQUES = 2, /**< a column for each freedom: N·m */
  SHIGUSA_CENTRE_OF_MASS = 3, /**< x, y, z: m, world */
  /** how far inside what the feet stand on the plumb line of the centre of mass and the floor's
   * centre of pressure are, less than 0 outside: m; no columns of a body without feet */
  SHIGUSA_SUPPORT = 4,
  SHIGUSA_EFFECTORS = 5,         /**< x, y, z of each goal's effector: m, world */
  SHIGUSA_NODE_TRANSLATIONS = 6, /**< x, y, z of each node in its parent: units of node_unit_m */
  SHIGUSA_NODE_ROTATIONS = 7,    /**< x, y, z, w of each node in its parent */
  /** the largest angle that each freedom may have then: rad; hips flex further with bent knees */
  SHIGUSA_UPPER_LIMITS = 8
};

/** A table of frames × columns, row by row; `values` stays valid until the result is freed. */
SHIGUSA_API shigusa_status shigusa_result_series(const shigusa_result* result, int32_t candidate,
                                                 shigusa_series series, const double** values,
                                                 size_t* frames, size_t* columns);

/** The series of time, angles and nodes at `fps` frames a second (1 to 240), as files have them: a
 * table of frames × columns, doubles row by row, in `table`. The others are of the motion's own
 * frames alone (SHIGUSA_UNSUPPORTED). */
SHIGUSA_API shigusa_status shigusa_result_series_at(const shigusa_result* result, int32_t candidate,
                                                    shigusa_series series, double fps,
                                                    shigusa_bytes** table, size_t* frames,
                                                    size_t* columns);

/* ---- Recorded motion ------------------------------------------------------------------------- */

/** The criteria of a clip's motion (BVH, or an animation of glTF, VRM or VRMA): the object that
 * `shigusa score --json` prints. `options` may be null, or {"criteria": "default", "first": 0,
 * "last": 80, "smoothed_hz": 6, "animation": "Take 1", "character": "human"}; without a character
 * it is scored on its own person. */
SHIGUSA_API shigusa_status shigusa_score_clip(const char* name, const void* file, size_t file_size,
                                              const char* options, shigusa_bytes** json);

#ifdef __cplusplus
}
#endif

#endif
