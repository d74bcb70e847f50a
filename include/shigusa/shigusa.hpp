// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/body.hpp>
#include <shigusa/character.hpp>
#include <shigusa/criteria.hpp>
#include <shigusa/draw.hpp>
#include <shigusa/edit.hpp>
#include <shigusa/error.hpp>
#include <shigusa/files.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/goal.hpp>
#include <shigusa/human.hpp>
#include <shigusa/kinematics.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>
#include <shigusa/search.hpp>

/// First number of the library's version. CMake reads all three here.
#define SHIGUSA_VERSION_MAJOR 0
/// The second: below 1.0 another one may have another interface.
#define SHIGUSA_VERSION_MINOR 1
/// The third: another one has the same interface.
#define SHIGUSA_VERSION_PATCH 0

/// Numbers as the text of a version.
#define SHIGUSA_QUOTE_VERSION(major, minor, patch) #major "." #minor "." #patch
/// The same of macros.
#define SHIGUSA_SPELL_VERSION(major, minor, patch) SHIGUSA_QUOTE_VERSION(major, minor, patch)
/// The version as text: "0.1.0".
#define SHIGUSA_VERSION \
  SHIGUSA_SPELL_VERSION(SHIGUSA_VERSION_MAJOR, SHIGUSA_VERSION_MINOR, SHIGUSA_VERSION_PATCH)

/// Natural whole-body motion from the goals of hands and feet. A BodyModel with Goals makes a Task;
/// generate() finds Candidates for it, and write_result() keeps them as files. Metres, kilograms,
/// seconds and radians everywhere; the world has +Y up, and a person faces +Z with the left towards
/// +X.
namespace shigusa {}
