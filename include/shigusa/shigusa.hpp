// SPDX-License-Identifier: MIT
#pragma once

// Everything that a program needs to generate motions and to write them to files.
#include <shigusa/hierarchy/generator.hpp>
#include <shigusa/project/character.hpp>
#include <shigusa/project/clip_score.hpp>
#include <shigusa/project/export.hpp>
#include <shigusa/project/result_file.hpp>
#include <shigusa/project/task_file.hpp>
