// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string_view>

namespace shigusa {

// Names of one bone in files, in the order of JointNames.
using JointNameRow = std::array<std::string_view, 4>;

// Bones whose names differ between conventions.
[[nodiscard]] std::span<const JointNameRow> joint_name_rows();

// Name of a built-in body's node in a convention; `own` if the convention has none.
[[nodiscard]] std::string_view joint_name(JointNames names, std::string_view own);

// Skeleton with its nodes renamed to a convention.
[[nodiscard]] Skeleton named(Skeleton skeleton, JointNames names);

}  // namespace shigusa
