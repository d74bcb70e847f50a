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
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <shigusa/parameters.hpp>
#include <shigusa/request.hpp>
#include <shigusa/run.hpp>
#include <shigusa/score.hpp>
#include <shigusa/search.hpp>

/// Natural whole-body motion from goals for hands, feet and other joints. A BodyModel and Goals
/// make a Task; generate() searches Candidates for it, and write_result() writes them to files.
/// Units are metres, kilograms, seconds and radians; the world has +Y up, and a person faces +Z
/// with the left towards +X.
namespace shigusa {}
