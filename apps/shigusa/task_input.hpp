// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <shigusa/files.hpp>
#include <shigusa/run.hpp>
#include <string>

#include "commands.hpp"

namespace shigusa::app {

// A task from a file and options, and how it is computed, as typed.
struct TaskInput {
  std::string task;  // file, or empty
  std::optional<std::string> character;
  CharacterOptions person;
  TaskOptions asked;
  int threads = 0;  // 0: one for each core
  std::optional<std::string> simd;
  // effector of a goal that the task has if neither file nor options give one; empty: none
  std::string goal_of;
};

// Adds the options of a task to a command.
void add_task_input(CLI::App& command, TaskInput& input);
// Adds the options of its computation, which do not change results.
void add_batch_options(CLI::App& command, TaskInput& input);

// Options for the computation that do not change results.
[[nodiscard]] Result<BatchSettings> batch_settings(const TaskInput& input);

// The task file with the options applied; notes on it are printed.
[[nodiscard]] Result<TaskFile> task_file_of(const TaskInput& input);

// Folder in which relative paths of the task start.
[[nodiscard]] std::filesystem::path folder_of(const TaskInput& input);

// An error of the task, with its place in the task's file, or what the command is to be given.
[[nodiscard]] Error in_task(const Error& error, const TaskInput& input, const char* command);

// Prints a hint for each goal that is plausible in the axes of robots: x ahead, y to the left, z
// up.
void note_other_axes(const Task& task);

}  // namespace shigusa::app
