// SPDX-License-Identifier: MIT
#include <shigusa/edit.hpp>

#include "core/say.hpp"
#include "problem/mirror_request.hpp"

namespace shigusa {

std::string mirrored_name(std::string_view name) { return with_other_side(name); }

Result<TaskFile> mirrored(TaskFile task) {
  if (is_robot(task.character)) {
    return fail(ErrorCode::unsupported, say("robot_mirror", task.character.source));
  }
  SHG_TRY_ASSIGN(const PosedBody built, build_character(task.character));
  const BodyModel& body = built.body;
  for (const Dof& dof : body.dofs()) {
    if (body.find_dof(mirrored_name(dof.name))) continue;
    return fail(ErrorCode::unsupported,
                say("one_side", body.name(), dof.name, mirrored_name(dof.name)));
  }
  mirror_request(task);
  return task;
}

Parameters mirrored(const ParameterList& from, const ParameterList& to, const Parameters& values) {
  return mirrored_values(from, to, values);
}

}  // namespace shigusa
