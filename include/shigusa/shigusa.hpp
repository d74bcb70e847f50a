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

/// Natural whole-body motion from the goals of hands and feet. A BodyModel with Goals makes a Task;
/// generate() finds Candidates for it, and write_result() keeps them as files. Metres, kilograms,
/// seconds and radians everywhere; the world has +Y up, and a person faces +Z with the left towards
/// +X.
namespace shigusa {}
