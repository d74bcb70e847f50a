// SPDX-License-Identifier: MIT
#pragma once

// Everything that a program needs to generate motions and to write them to files.
#include <shigusa/character/character.hpp>
#include <shigusa/document/clip_score.hpp>
#include <shigusa/document/export.hpp>
#include <shigusa/document/facts.hpp>
#include <shigusa/document/result_file.hpp>
#include <shigusa/document/task_file.hpp>
#include <shigusa/generate/generator.hpp>
