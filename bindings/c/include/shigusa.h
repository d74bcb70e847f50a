// SPDX-License-Identifier: MIT
/** @file
 * C interface of shigusa, for games, browsers and bindings to other languages.
 *
 * A character is a body with the data of its file; a result holds the candidates of a task with
 * their motions. Tasks, results and descriptions are UTF-8 JSON, the same objects that the command
 * line reads and writes (docs/task.schema.json, docs/result.schema.json). Numbers have a decimal
 * point in every locale. Units are metres, kilograms, seconds and radians; the world is
 * right-handed with +Y up, and a body faces +Z with its left at +X.
 *
 * Every function that can fail returns a status, and on failure leaves its outputs unchanged;
 * shigusa_message() then states the error, its place and the permitted values. C++ exceptions never
 * escape, and null pointers are refused (SHIGUSA_INVALID_ARGUMENT) unless stated otherwise. An
 * object may be used from one thread at a time, different objects concurrently; a result keeps the
 * data that it needs of its character, so either may be freed first.
 *
 * Every function computes with rounding to nearest and with denormals, whatever the host's
 * floating-point environment; the host's is restored before a function returns and before it calls
 * a function of the host. If memory runs out, a function that returns a status reports it
 * (SHIGUSA_OUT_OF_MEMORY), and existing objects stay usable.
 *
 * Within one SHIGUSA_ABI_VERSION functions and numbers are only added. */
#ifndef SHIGUSA_H
#define SHIGUSA_H

#include <stddef.h>
#include <stdint.h>

/** Exports a function from the library; of a static library in Windows define SHIGUSA_STATIC. */
#if defined(__EMSCRIPTEN__)
#define SHIGUSA_API __attribute__((used, visibility("default")))
#elif defined(_WIN32) && defined(SHIGUSA_BUILDS_C)
#define SHIGUSA_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(SHIGUSA_STATIC)
#define SHIGUSA_API __declspec(dllimport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define SHIGUSA_API __attribute__((visibility("default")))
#else
#define SHIGUSA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Version of the functions and numbers of this header; incremented by incompatible changes. */
#define SHIGUSA_ABI_VERSION 1

/** Version of the library that this header is of. */
#define SHIGUSA_HEADER_VERSION "0.2.0"

/** SHIGUSA_ABI_VERSION of the library's build. */
SHIGUSA_API uint32_t shigusa_abi_version(void);
/** Version of the library ("0.2.0"). */
SHIGUSA_API const char* shigusa_version(void);

/** Result of a call: one of the numbers below. */
typedef int32_t shigusa_status;
/** Values of shigusa_status. */
enum {
  SHIGUSA_OK = 0,               /**< done */
  SHIGUSA_INVALID_ARGUMENT = 1, /**< a value is out of range */
  SHIGUSA_NOT_FOUND = 2,        /**< no file, joint or effector of that name */
  SHIGUSA_PARSE = 3,            /**< bytes that do not follow their format */
  SHIGUSA_IO = 4,               /**< the operating system refused */
  SHIGUSA_UNSUPPORTED = 5,      /**< valid, but not supported by this build */
  SHIGUSA_CANCELLED = 6,        /**< stopped without a result */
  SHIGUSA_OUT_OF_MEMORY = 7,    /**< out of memory */
  SHIGUSA_FAULT = 8,            /**< an error within the library: please report it */
  SHIGUSA_HOST = 9              /**< a function of the caller threw; the message is from it */
};

/** Whether this library has all of a header, to be called first, as
 * shigusa_check_version(SHIGUSA_ABI_VERSION, SHIGUSA_HEADER_VERSION). Fails with a message that
 * names both versions if the ABI is another one, or the library older than the header
 * (SHIGUSA_UNSUPPORTED). */
SHIGUSA_API shigusa_status shigusa_check_version(uint32_t abi_version, const char* header_version);

/** Message of the calling thread's last failure, "" if there was none. Valid until this thread's
 * next failure. */
SHIGUSA_API const char* shigusa_message(void);

/** Text or a file, owned by the caller. Text ends with a zero that `size` does not count. */
typedef struct shigusa_bytes shigusa_bytes;
/** Contents, valid until they are freed. */
SHIGUSA_API const char* shigusa_bytes_data(const shigusa_bytes* bytes);
/** Number of bytes. */
SHIGUSA_API size_t shigusa_bytes_size(const shigusa_bytes* bytes);
/** Frees the bytes; null is allowed. */
SHIGUSA_API void shigusa_bytes_free(shigusa_bytes* bytes);

/** The last failure as JSON, for user interfaces in other languages: {"place" (the subject, "goal
 * of left_foot" or "line 3 of hero.bvh"; may be empty), "message"}. A message is {"text" (in
 * English), "key" (of its sentence in shigusa_facts), "values"}; each value is a message, or
 * {"text" (its digits), "number", "unit" ("m" or "mm", only for lengths)}, or text such as a name
 * from a file; a message without a key is text too. Does not change the last failure. */
SHIGUSA_API shigusa_status shigusa_failure(shigusa_bytes** json);

/** Body-independent data for user interfaces, from the tables of this build:
 * {"criteria": [{"name", "scale" (the key of its scale)}], "mixtures": {name: {criterion: weight}},
 * "presets": [{"name", "mixture" (that it ranks by), "search", "candidates", "evaluations",
 * "layered", "natural"}], "pareto_mixture" (that a task with "pareto" ranks by, whatever its
 * preset), "default_preset" and "default_body" (defaults of a task), "habits": [{"name", "about"}]
 * (the first is a task's default), "searches", "generators", "layer_readings", "sexes", "extents"
 * and "bones" (words), "bodies": [{"name", "dof"}], "ranges": {key in files: [least, most]},
 * "formats": [{"name", "about", "endings" ([".glb", …]), "media_type", "person", "robot", "clip"
 * (read from it), "written", "rated" (it has frames at the rate asked for), "needs" (formats, of
 * one of which the character must be; none: any will do), "max_bytes" (that are read)}],
 * "timing": [{"name", "low", "high", "of" ("motion": a
 * parameter, or "task"), "sentence"}], "joint_names": [{"name", "bones" ({own: there})}],
 * "messages": [{"key", "text" (in English, with {} or {:.2f} for each value)}], the sentences of
 * doubts and failures}. */
SHIGUSA_API shigusa_status shigusa_facts(shigusa_bytes** json);

/* ---- Characters ------------------------------------------------------------------------------ */

/** A body, with the data of its file. */
typedef struct shigusa_character shigusa_character;

/** Creates a character. `spec`: the `character` of a task file, such as {"source": "human",
 * "stature_m": 1.6} or {"source": "hero.vrm", "map": {"right_hand": "Bone_17"}}. For a file,
 * `source` is its name, whose ending determines the format (shigusa_facts), and `file` its bytes;
 * for a built-in body (listed there too) `file` is null and `file_size` 0. No file is opened. */
SHIGUSA_API shigusa_status shigusa_character_create(const char* spec, const void* file,
                                                    size_t file_size,
                                                    shigusa_character** character);
/** Frees a character; null is allowed. */
SHIGUSA_API void shigusa_character_free(shigusa_character* character);

/** Creates a character from the nodes of a host's skeleton, in any order and axes, as of a GLB file
 * that has them. `spec`: as above; its `source` is the name "NAME.glb" by which messages and
 * summaries call it, and which need not be there. `nodes`: JSON {"nodes": [{"name", "parent"
 * (index; -1 or absent: none), "translation" [x, y, z], "rotation" [x, y, z, w] and "scale" [x, y,
 * z] (in the parent, at rest; absent: none), "pose": {"translation", "rotation", "scale"} (as the
 * node is now; what is absent is as at rest)}, …]}, 1 to 2048. If any node has a pose, motions
 * start from it. A node's index is "file_node" of the description, and nodes that stand above the
 * others place, turn and scale them: the series with {"place": "file"} have the host's own axes. */
SHIGUSA_API shigusa_status shigusa_character_of_nodes(const char* spec, const char* nodes,
                                                      shigusa_character** character);

/** Description of a character: the object that `shigusa body --json` prints, with the nodes of
 * SHIGUSA_NODE_TRANSLATIONS and _ROTATIONS: "nodes": [{"name", "parent" (index or -1), "offset"
 * [x, y, z] and "rotation" [x, y, z, w] (in its parent, in the posture that was measured), "scale"
 * [x, y, z] (along its own axes, constant in a motion; absent if 1), "file_node" (glTF: index in
 * the file), "rest" {"offset", "rotation", "scale"} (as the file has it at rest; absent if the
 * same)}], "node_unit_m" (metres per unit of their translations),
 * "support_polygon" [[x, z], …] (m, of the feet), "placement" (of a file: {"unit_m", "origin",
 * "left", "up", "ahead"}, with which a place p of the file is at unit_m · ((p - origin) · left, (p
 * - origin) · up, (p - origin) · ahead) in the world), and "feet": [{"effector", "sole_m" [[x, y,
 * z], …] (its corners relative to the effector, in the effector's frame), "floor_m" (lower bound of
 * the corners), "least_m" (the effector's height with the sole oriented as at the start)}], and
 * "doubt_messages": the doubts as messages (shigusa_failure). */
SHIGUSA_API shigusa_status shigusa_character_describe(const shigusa_character* character,
                                                      shigusa_bytes** json);

/* ---- Motions --------------------------------------------------------------------------------- */

/** Result of a task: candidates with their motions. */
typedef struct shigusa_result shigusa_result;

/** Progress callback, which can stop a search. */
typedef struct shigusa_watch {
  /** Called on the calling thread now and then, with the used share of the budget (0..1), the
   * number of motions scored and the lowest score so far. Returns 0 to continue, any other value
   * to stop with the best so far. An exception thrown by it ends the call (SHIGUSA_HOST). */
  int32_t (*report)(void* user, double fraction, int32_t evaluations, double best_score);
  void* user; /**< passed to `report` */
} shigusa_watch;

/** Searches motions. `task`: text of a task file. `character`: replaces the task's; null: the
 * task's own, which must need no file. `watch` may be null. A goal out of reach is no failure: it
 * is the status of the result, whose only candidate ends as near as possible. Of a task with
 * actions (version 2) candidates are whole pieces of work; where an action fails they hold what
 * came before it. `threads`: 0 for one per core; does not change results. */
SHIGUSA_API shigusa_status shigusa_generate(const shigusa_character* character, const char* task,
                                            int32_t threads, const shigusa_watch* watch,
                                            shigusa_result** result);

/** Motions that a criterion of the host scores, of equal shapes. Tables are row by row, and valid
 * during the call. */
typedef struct shigusa_motions {
  size_t motions;               /**< 1 and more */
  size_t frames;                /**< of each */
  size_t dofs;                  /**< degrees of freedom, in the order of the description's joints */
  size_t effectors;             /**< of the task's goals, in their order */
  double frame_time;            /**< s between frames */
  const double* angles;         /**< motions × frames × dofs: rad */
  const double* torques;        /**< motions × frames × dofs: N·m */
  const double* centre_of_mass; /**< motions × frames × 3: m, world */
  const double* effector_places; /**< motions × frames × effectors × 3: m, world */
} shigusa_motions;

/** A criterion of the host: a number of a whole motion, where less is better. Its penalty is value
 * / scale, held between 0 and 1, and adds weight · penalty to a score, as built-in criteria do. */
typedef struct shigusa_criterion {
  const char* name; /**< in scores; not that of a built-in criterion */
  double weight;    /**< 0 and more */
  double scale;     /**< value at which the penalty is 1, above 0 */
  /** Writes the values (motions) of all motions of a step of the search; a motion of the value NaN
   * ranks last. Called on the calling thread. Returns 0; any other value, or an exception, ends the
   * call (SHIGUSA_HOST). */
  int32_t (*values)(void* user, const shigusa_motions* motions, double* values);
  void* user; /**< passed to `values` */
} shigusa_criterion;

/** Searches motions as shigusa_generate, which score also by `count` criteria of the host. These
 * are called during this call alone: edits of the result are scored without them. */
SHIGUSA_API shigusa_status shigusa_generate_by(const shigusa_character* character, const char* task,
                                               const shigusa_criterion* criteria, size_t count,
                                               int32_t threads, const shigusa_watch* watch,
                                               shigusa_result** result);

/** Searches motions for `count` tasks in one call, on `threads` threads in all, with the results of
 * shigusa_generate for each. `results`: room for `count` results; null for a task that fails, which
 * does not fail the call. `failures`: JSON list of null, or the failure of that task as of
 * shigusa_failure, with the place "tasks[3]: …" where its text is wrong. `watch` tells the share
 * of all tasks, then that of each with actions; a stopped call gives what it has, and
 * tasks that have not begun fail. */
SHIGUSA_API shigusa_status shigusa_generate_all(const shigusa_character* character,
                                                const char* const* tasks, size_t count,
                                                int32_t threads, const shigusa_watch* watch,
                                                shigusa_result** results, shigusa_bytes** failures);

/** A result of one candidate from given angles, at rest before and after: its score, verdict,
 * series and files are those of a motion. `angles`: frames (2 and more) × columns (a degree of
 * freedom each, in the order of the description's joints; rad), row by row, at `fps` (Hz, 1 to
 * 240). The base foot stands as the body does at its start. `task`: null, or text of a task file,
 * whose criteria and obstacles are taken and whose goals are not. There are no parameters that
 * would make the motion again, so that such a result cannot be restored, replayed or mirrored. */
SHIGUSA_API shigusa_status shigusa_result_of_angles(const shigusa_character* character,
                                                    const char* task, const double* angles,
                                                    size_t frames, size_t columns, double fps,
                                                    shigusa_result** result);

/** Generates a result's motions again from its JSON (summary.json), without a search. `character`:
 * as above, and the same as that of the result; it is needed to export motions on its own
 * skeleton. */
SHIGUSA_API shigusa_status shigusa_restore(const shigusa_character* character, const char* summary,
                                           shigusa_result** result);

/** Restores a result with a progress callback; evaluations are the motions generated. If stopped,
 * there is no result (SHIGUSA_CANCELLED). A result of 1000 candidates, the maximum, takes some
 * seconds. */
SHIGUSA_API shigusa_status shigusa_restore_watched(const shigusa_character* character,
                                                   const char* summary, const shigusa_watch* watch,
                                                   shigusa_result** result);

/** Generates a candidate's motion again with changed parameters, as a result of one candidate.
 * `assignments`: JSON list of assignments as in `shigusa edit --set`, ["squat_deg=60", …]; empty
 * or null changes nothing. In a task with actions the first motion is changed, and the others go on
 * from where it now ends. Candidates count from 1. */
SHIGUSA_API shigusa_status shigusa_replay(const shigusa_result* result, int32_t candidate,
                                          const char* assignments, shigusa_result** edited);

/** Edits one candidate of a task with actions. `edit`: JSON such as {"action": 2, "set":
 * ["squat_deg=60"], "again": [3], "keep": [1, 2], "seed": 5}, as the options of `shigusa edit`;
 * null changes nothing. `set` changes the first motion of `action` (default 1), and the actions
 * behind it go on from where it now ends. Actions in `again` are searched anew, for several
 * candidates; with `keep` alone all actions but these are. Another `seed` than the task's finds
 * other motions. `watch` may be null; a stopped search ends with its best so far. Candidates and
 * actions count from 1. Fails on a task without actions and an unknown action. */
SHIGUSA_API shigusa_status shigusa_replay_work(const shigusa_result* result, int32_t candidate,
                                               const char* edit, const shigusa_watch* watch,
                                               shigusa_result** edited);

/** Mirror images of all candidates, with the other side's hands and feet, by the same character
 * from the same start. */
SHIGUSA_API shigusa_status shigusa_mirror(const shigusa_result* result, shigusa_result** mirrored);

/** Frees a result; null is allowed. */
SHIGUSA_API void shigusa_result_free(shigusa_result* result);

/** Number of candidates, which are sorted by score, lowest first; 0 for null. */
SHIGUSA_API int32_t shigusa_result_candidates(const shigusa_result* result);

/** The object of summary.json without `files`; input of shigusa_restore. */
SHIGUSA_API shigusa_status shigusa_result_describe(const shigusa_result* result,
                                                   shigusa_bytes** json);

/** Editable parameters of a candidate, in order: [{"name", "group" ("posture", "path", "trunk",
 * "right_arm", "legs", …), "kind" ("weight", "angle" or "share"), "value", "low", "high", "scale"
 * ("linear" or "log"), "unit" ("" or "deg"), "locked"}]. "NAME=VALUE" is an assignment; a weight
 * such as "right_knee.flexion.weight" can also be locked by "right_knee.flexion.locked=true". */
SHIGUSA_API shigusa_status shigusa_result_parameters(const shigusa_result* result,
                                                     int32_t candidate, shigusa_bytes** json);

/** Editable parameters of the motion of one action, from 1, in the same form: those that
 * shigusa_replay_work sets. An empty list of an action without a motion, such as a wait. */
SHIGUSA_API shigusa_status shigusa_result_action_parameters(const shigusa_result* result,
                                                            int32_t candidate, int32_t action,
                                                            shigusa_bytes** json);

/** Exports a candidate to a written format (shigusa_facts), such as "bvh", or to "html": a page
 * with the moving figure, its verdict and score, that loads no other file. Fails if this build or
 * the character does not support it. Candidate 0: all of them in one GLB or page. */
SHIGUSA_API shigusa_status shigusa_result_export(const shigusa_result* result, int32_t candidate,
                                                 const char* format, shigusa_bytes** file);

/** Exports with `options`: {"fps": 24, "clip": "Reach", "joint_names": "mixamo", "in_place": true}.
 * fps: frame rate (Hz) of rated formats, 1 to 240 (default 60, of NPZ 50); clip: name of the
 * animation in GLB and VRMA, for all candidates followed by their numbers; joint_names
 * (shigusa_facts): for a built-in body in BVH; in_place: leaves out the horizontal travel of the
 * hips. The last frame is the first one not before the motion's end, and holds exactly the motion's
 * last posture. The file is read back before it is returned: if its nodes deviate from the motion,
 * the call fails (SHIGUSA_UNSUPPORTED). Unrated formats have the frames of the series, but a
 * robot's CSV has `fps` if that is given. `options` may be null. */
SHIGUSA_API shigusa_status shigusa_result_export_with(const shigusa_result* result,
                                                      int32_t candidate, const char* format,
                                                      const char* options, shigusa_bytes** file);

/** Series of numbers per frame of a candidate. */
typedef int32_t shigusa_series;
/** Values of shigusa_series. */
enum {
  SHIGUSA_TIME = 0,    /**< 1 column: s */
  SHIGUSA_ANGLES = 1,  /**< a column per dof, in the order of the description's joints: rad */
  SHIGUSA_TORQUES = 2, /**< a column per dof: N·m */
  SHIGUSA_CENTRE_OF_MASS = 3, /**< x, y, z: m, world */
  /** distance of the projected centre of mass, and of the centre of pressure, inside the support
   * polygon, negative outside: m; no columns for a body without feet */
  SHIGUSA_SUPPORT = 4,
  SHIGUSA_EFFECTORS = 5,         /**< x, y, z of each goal's effector: m, world */
  SHIGUSA_NODE_TRANSLATIONS = 6, /**< x, y, z of each node in its parent: units of node_unit_m */
  SHIGUSA_NODE_ROTATIONS = 7,    /**< x, y, z, w of each node in its parent */
  /** upper limit of each degree of freedom in the frame: rad; hips flex further with bent knees */
  SHIGUSA_UPPER_LIMITS = 8,
  /** pose of each thing of the task, in its order: x, y, z of its middle (m, world) and x, y, z, w
   * of its rotation from the world's axes; no columns without things */
  SHIGUSA_THINGS = 9
};

/** Table of frames × columns, row by row; `values` is valid until the result is freed. */
SHIGUSA_API shigusa_status shigusa_result_series(const shigusa_result* result, int32_t candidate,
                                                 shigusa_series series, const double** values,
                                                 size_t* frames, size_t* columns);

/** A series at a rate of `fps` (Hz, 1 to 240), as in exported files: `table` holds frames ×
 * columns doubles, row by row. Torques, centre of mass and support lie on lines between the
 * motion's own frames; all others are those of the posture there. */
SHIGUSA_API shigusa_status shigusa_result_series_at(const shigusa_result* result, int32_t candidate,
                                                    shigusa_series series, double fps,
                                                    shigusa_bytes** table, size_t* frames,
                                                    size_t* columns);

/** A series with the meaning of its columns. `options`: null, or {"fps": 24, "place": "file"}. fps:
 * as above; absent: the motion's own frames. place: where nodes move: "world" (y up, as goals are
 * given), or "file": where the character stands in its file, in the file's axes. `table`: doubles,
 * row by row. `about`: JSON {"name" ("node_rotations"), "unit" ("s", "rad", "N m", "m" or ""),
 * "fps", "shape" ([frames, names, components], where columns have these), "names" (of joints,
 * nodes, effectors, things, or the two of support), "components" (["x", "y", "z", "w"])}. */
SHIGUSA_API shigusa_status shigusa_result_table(const shigusa_result* result, int32_t candidate,
                                                shigusa_series series, const char* options,
                                                shigusa_bytes** table, shigusa_bytes** about);

/* ---- Recorded motion ------------------------------------------------------------------------- */

/** Scores a clip's motion (BVH, or an animation of glTF, VRM or VRMA): the object that `shigusa
 * score --json` prints. `options` may be null, or {"criteria": "default", "first": 0, "last": 80,
 * "smoothed_hz": 6, "animation": "Take 1", "cost": true, "ergonomics": {"coupling": "poor"},
 * "character": "human"}; without a character the motion is scored on its own person. cost: tells
 * what it costs the body, with what `ergonomics` adds, as for tasks. */
SHIGUSA_API shigusa_status shigusa_score_clip(const char* name, const void* file, size_t file_size,
                                              const char* options, shigusa_bytes** json);

#ifdef __cplusplus
}
#endif

#endif
