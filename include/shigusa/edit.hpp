// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The kinds of editable parameters.
enum class EditableKind {
  weight,  ///< weight of a dof in the weighted IK
  angle,   ///< angle of the posture, in degrees
  share,   ///< dimensionless number
};

/// A parameter of a motion that a person can edit. "name=value" is an assignment (see
/// Request::fixed_assignments); for a weight so is "joint.locked=true", where `joint` is the name
/// without ".weight".
struct EditableParameter {
  std::string name;  ///< "right_knee.flexion.weight", "squat_deg", "bow"
  /// Group of the parameter: "right_leg", "left_arm", "trunk", "posture", "path".
  std::string group;
  EditableKind kind = EditableKind::weight;  ///< kind of the parameter
  double value = 0.0;                        ///< current value; angles in degrees
  double low = 0.0;             ///< smallest sensible value; posture parameters may be smaller
  double high = 0.0;            ///< largest sensible value; posture parameters may be larger
  bool locked = false;          ///< for weights: the dof keeps its start angle
  std::string_view sentence{};  ///< effect of the parameter, one sentence
};

/// The editable parameters of a candidate, those of the posture first. `list` is
/// GenerateResult::parameters, `values` Candidate::parameters.
[[nodiscard]] std::vector<EditableParameter> editable_parameters(const ParameterList& list,
                                                                 const Parameters& values);

/// The editable parameters of a candidate's action, from 1: those that replay_work changes by
/// WorkEdit::assignments; none of an action without a motion, such as a wait. `list` is
/// GenerateResult::parameters.
[[nodiscard]] std::vector<EditableParameter> action_parameters(const ParameterList& list,
                                                               const Candidate& candidate,
                                                               int action);

/// Formats parameters as JSON: a list of {"name", "group", "kind", "value", "low", "high", "scale"
/// ("linear" or "log"), "unit" ("" or "deg"), "locked", "sentence"}.
[[nodiscard]] std::string format_parameters(const std::vector<EditableParameter>& parameters);

/// The name of the opposite side: "left_hand" for "right_hand" and the reverse; a name without a
/// side stays.
[[nodiscard]] std::string mirrored_name(std::string_view name);

/// Mirrors a task at the plane x = 0: goals, contacts, obstacles and fixed parameters change sides.
/// The person and their start posture stay, so that the motion is the exact mirror image only for a
/// symmetric person in a symmetric posture. Fails on a body of one side.
[[nodiscard]] Result<TaskFile> mirrored(TaskFile task);

/// Mirrors parameter values: each goes to the parameter of the other side, and turns of the trunk
/// change sign. `from` and `to` are the parameter lists of the original and the mirrored task,
/// whose bodies may have different base feet.
[[nodiscard]] Parameters mirrored(const ParameterList& from, const ParameterList& to,
                                  const Parameters& values);

/// Parses a JSON list of assignments: ["squat_deg=60", "right_knee.weight=3"].
[[nodiscard]] Result<std::vector<std::string>> parse_assignments(std::string_view text,
                                                                 std::string_view name);

/// Replaying stored parameters: `player` must be made for the result's task (make_task). Candidates
/// are numbered from 1; an unknown number is an error that states how many there are.

/// Generates one candidate's motion again, after the assignments (see Request::fixed_assignments)
/// have changed its parameters in `stored`.
[[nodiscard]] Result<GenerateResult> replay(MotionPlayer& player, StoredResult& stored,
                                            int candidate,
                                            std::span<const std::string> assignments = {});
/// Generates the motions of all candidates again, in the result's order. Fails with
/// ErrorCode::cancelled if cancelled between two candidates; progress reports the score of the
/// first.
[[nodiscard]] Result<GenerateResult> replay_all(MotionPlayer& player, StoredResult& stored,
                                                const Progress& progress = {});

/// Generates the motions of all candidates again, in the result's order, of a task (make_task) with
/// or without actions. Otherwise as above.
[[nodiscard]] Result<GenerateResult> replay_all(const Task& task, StoredResult& stored,
                                                const Progress& progress = {});

/// A change of one candidate of a result whose task has actions.
struct WorkEdit {
  int action = 1;                          ///< the action whose motion is edited, from 1
  std::vector<std::string> assignments{};  ///< see Request::fixed_assignments
  std::vector<int> again{};                ///< actions that are searched anew, from 1
  std::vector<int> keep{};  ///< actions that stay; if given without `again`, others are searched
  std::optional<std::uint64_t> seed{};  ///< seed of the search; empty: the task's
};
/// Parses an edit from JSON: {"action": 2, "set": ["squat_deg=60"], "again": [3], "keep": [1, 2],
/// "seed": 5}, of which each may be absent.
[[nodiscard]] Result<WorkEdit> parse_work_edit(std::string_view text, std::string_view name);
/// Generates a candidate's actions again after the edit: the actions behind it go on from where it
/// now ends, by the motions that they had. Where an action is searched anew, several candidates
/// are found for it. `task` is that of the result (make_task); `stored` gets the edit's seed. Fails
/// on an unknown action, and on assignments for one without a motion, such as a wait.
[[nodiscard]] Result<GenerateResult> replay_work(const Task& task, StoredResult& stored,
                                                 int candidate, const WorkEdit& edit = {},
                                                 const Progress& progress = {});

/// Mirrors the task and parameters of a result (see mirrored). Its facts about files are unchanged
/// and still describe the original motions.
[[nodiscard]] Result<void> mirror_result(StoredResult& stored);

/// A new folder for the result of an edit, "edit-1", "edit-2", … No other program takes it while
/// this object lives. If nothing was written into it, it is removed at the end.
class EditFolder {
 public:
  /// Creates the first unused folder within `within`, or takes over one that a killed program left
  /// without a result.
  [[nodiscard]] static Result<EditFolder> make(const std::filesystem::path& within,
                                               std::string_view name);
  EditFolder(EditFolder&&) noexcept;             ///< takes over the folder
  EditFolder& operator=(EditFolder&&) noexcept;  ///< takes over the folder
  ~EditFolder();

  [[nodiscard]] const std::filesystem::path& path() const;  ///< full path of the folder

 private:
  struct Held;
  explicit EditFolder(std::unique_ptr<Held> held);
  std::unique_ptr<Held> held_;
};

/// Converts a generated result to the form that read_result gives.
[[nodiscard]] StoredResult stored_result(const TaskFile& file, const GenerateResult& generation);

}  // namespace shigusa
