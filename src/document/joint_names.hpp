// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/files.hpp>
#include <shigusa/motion.hpp>
#include <span>
#include <string_view>

namespace shigusa {

// A bone by the names that it has in files: in the order of JointNames.
using JointNameRow = std::array<std::string_view, 4>;

// The bones that have other names somewhere.
[[nodiscard]] std::span<const JointNameRow> joint_name_rows();

// The name that a node of a built-in body has there; its own where there is none for it.
[[nodiscard]] std::string_view joint_name(JointNames names, std::string_view own);

// The skeleton with its nodes renamed.
[[nodiscard]] Skeleton named(Skeleton skeleton, JointNames names);

}  // namespace shigusa
