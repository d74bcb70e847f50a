// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/run.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The kinds of editable numbers.
enum class EditableKind {
  weight,  ///< of a freedom in the weighted IK
  angle,   ///< degrees, of the posture
  share,   ///< a number without a unit
};

/// One of the numbers that a person edits of a motion. "name=value" is an assignment (see
/// assign_parameter); so is, of a weight, "joint.locked=true", with `joint` the name without
/// ".weight".
struct EditableParameter {
  std::string name;  ///< "right_knee.flexion.weight", "squat_deg", "bow"
  /// "right_leg", "left_arm", "trunk", "posture", "path"
  std::string group;
  EditableKind kind = EditableKind::weight;  ///< of the number
  double value = 0.0;                        ///< angles in degrees
  double low = 0.0;                          ///< sensible; of a posture less is allowed
  double high = 0.0;                         ///< sensible; of a posture more is allowed
  bool locked = false;                       ///< of a weight: the freedom keeps its start angle
  std::string_view sentence{};               ///< its effect
};

/// All of a candidate's, the posture's first; the list is the result's.
[[nodiscard]] std::vector<EditableParameter> editable_parameters(const ParameterList& list,
                                                                 const Parameters& values);

/// The parameters as JSON text: a list of {"name", "group", "kind", "value", "low", "high", "scale"
/// ("linear" or "log"), "unit" ("" or "deg"), "locked", "sentence"}.
[[nodiscard]] std::string format_parameters(const std::vector<EditableParameter>& parameters);

/// "left_hand" of "right_hand" and the reverse; a name without a side stays.
[[nodiscard]] std::string mirrored_name(std::string_view name);

/// The task on the other side of the body's middle, x = 0: goals, contacts, obstacles and
/// fixed parameters change sides. The person is the same, with their own left and right, and stands
/// at the start as before: of somebody who is alike on both sides, and stands so, the motion is the
/// mirror image; anybody else reaches the mirrored goal from their own posture. Fails on a body of
/// one side.
[[nodiscard]] Result<TaskFile> mirrored(TaskFile task);

/// The values of a motion's mirror image: each goes to the parameter of the other side, and a turn
/// of the trunk changes its sign. `from` and `to` are the lists of both tasks, whose bodies may
/// stand on either foot.
[[nodiscard]] Parameters mirrored(const ParameterList& from, const ParameterList& to,
                                  const Parameters& values);

/// Parses a JSON list of assignments: ["squat_deg=60", "right_knee.weight=3"].
[[nodiscard]] Result<std::vector<std::string>> parse_assignments(std::string_view text,
                                                                 std::string_view name);

/// Motions of stored parameters; the player is of the result's task (make_task). Candidates count
/// from 1; these fail where there is none of that number, naming how many there are.

/// One candidate's motion with the assignments (see assign_parameter) to its parameters, which stay
/// changed.
[[nodiscard]] Result<GenerateResult> replay(MotionPlayer& player, StoredResult& stored,
                                            int candidate,
                                            std::span<const std::string> assignments = {});
/// All of them, in the result's order. Fails with ErrorCode::cancelled where it is stopped between
/// two of them; scores that it reports are of the first.
[[nodiscard]] Result<GenerateResult> replay_all(MotionPlayer& player, StoredResult& stored,
                                                const Progress& progress = {});

/// Takes task and parameters to the other side (see mirrored). The facts about files stay, and
/// are of the motions before.
[[nodiscard]] Result<void> mirror_result(StoredResult& stored);

/// A new folder for what an edit gives, "edit-1", "edit-2", … While this lives no other program
/// takes it. Goes again where nothing was written into it.
class EditFolder {
 public:
  /// Makes the first that is not there yet within a folder, or takes one that a killed program left
  /// without a result.
  [[nodiscard]] static Result<EditFolder> make(const std::filesystem::path& within,
                                               std::string_view name);
  EditFolder(EditFolder&&) noexcept;             ///< takes over the folder
  EditFolder& operator=(EditFolder&&) noexcept;  ///< takes over the folder
  ~EditFolder();

  [[nodiscard]] const std::filesystem::path& path() const;  ///< its whole path

 private:
  struct Held;
  explicit EditFolder(std::unique_ptr<Held> held);
  std::unique_ptr<Held> held_;
};

/// A result as it would be read back from its file.
[[nodiscard]] StoredResult stored_result(const TaskFile& file, const GenerateResult& generation);

}  // namespace shigusa
