// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/document/result_file.hpp>
#include <span>
#include <string>
#include <string_view>

namespace shigusa {

// One layer of a plan.
struct Layer;

// "left_hand" of "right_hand" and the other way round; what has no side is as it was.
[[nodiscard]] std::string mirrored_name(std::string_view name);

// The task on the other side of the body's middle, x = 0: goals, contacts, obstacles and what is
// fixed change sides. The person is the same, with their own left and right, and stands at the
// start as before: of somebody who is alike on both sides, and stands so, the motion is the mirror
// image; anybody else reaches the mirrored goal from their own posture. Fails on a body of one
// side.
[[nodiscard]] Result<TaskFile> mirrored(TaskFile task);

// The values of a motion's mirror image: each goes to the parameter of the other side, and a turn
// of the trunk changes its sign. `from` and `to` are the plans of both tasks, whose bodies may
// stand on either foot.
[[nodiscard]] Parameters mirrored(std::span<const Layer> from, std::span<const Layer> to,
                                  const Parameters& values);

}  // namespace shigusa
