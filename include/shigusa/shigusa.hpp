// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/action.hpp>
#include <shigusa/body.hpp>
#include <shigusa/character.hpp>
#include <shigusa/cost.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/draw.hpp>
#include <shigusa/edit.hpp>
#include <shigusa/ergonomics.hpp>
#include <shigusa/error.hpp>
#include <shigusa/explore.hpp>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/habit.hpp>
#include <shigusa/human.hpp>
#include <shigusa/kinematics.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/report.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <shigusa/scene.hpp>
#include <shigusa/score.hpp>
#include <shigusa/search.hpp>
#include <shigusa/series.hpp>

/// Major version of the library. CMake reads all three numbers here.
#define SHIGUSA_VERSION_MAJOR 0
/// Minor version: below 1.0 another one may have another interface.
#define SHIGUSA_VERSION_MINOR 2
/// Patch version: another one has the same interface.
#define SHIGUSA_VERSION_PATCH 0

/// Joins three numbers to the text of a version.
#define SHIGUSA_QUOTE_VERSION(major, minor, patch) #major "." #minor "." #patch
/// Expands three macros and joins them.
#define SHIGUSA_SPELL_VERSION(major, minor, patch) SHIGUSA_QUOTE_VERSION(major, minor, patch)
/// The version as text: "0.2.0".
#define SHIGUSA_VERSION \
  SHIGUSA_SPELL_VERSION(SHIGUSA_VERSION_MAJOR, SHIGUSA_VERSION_MINOR, SHIGUSA_VERSION_PATCH)

/// Natural whole-body motion from goals for hands, feet and other joints. A BodyModel and Goals
/// make a Task; generate() searches Candidates for it, and write_result() writes them to files.
/// Units are metres, kilograms, seconds and radians; the world has +Y up, and a person faces +Z
/// with the left towards +X.
/// open_character, Task, generate and save are the way from a file to a file.
///
/// The method is that of T. Mukai, S. Kuriyama and T. Kaneko ("the paper"; docs/paper_map.md leads
/// from its sections and rules to the code).
namespace shigusa {}
