// SPDX-License-Identifier: MIT
// When memory runs out within a function of the C interface, it fails with a message or continues
// without: nothing ends the program, nothing leaks, and existing objects still work. Each
// allocation in turn fails, by day one in fifty.
#include <gtest/gtest.h>
#include <shigusa.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <functional>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "memory/failing_malloc.hpp"
#include "support/gltf_file.hpp"
#include "support/night.hpp"
#include "support/person_file.hpp"
#include "support/robot_file.hpp"

namespace {

using namespace shigusa::testing_support;

constexpr const char* kTask = R"({"character": "half_body", "evaluations": 20, "candidates": 2,
    "goals": [{"effector": "right_hand", "position_m": [-0.2, 0.9, 0.4]}]})";
constexpr const char* kReach = R"({"evaluations": 20, "candidates": 1,
    "goals": [{"effector": "right_hand", "position_m": [-0.2, 0.9, 0.4]}]})";

constexpr const char* kWork = R"({"version": 2, "evaluations": 20, "candidates": 1, "actions": [
    {"goals": [{"effector": "right_hand", "position_m": [-0.2, 0.9, 0.4]}]}]})";

// Arguments of the functions, made while there is memory.
struct Hands {
  std::string bvh = person_bvh();
  std::string gltf = person_gltf().dump();
  std::string urdf = RobotFile().text();
  std::string summary;
  shigusa_character* human = nullptr;
  shigusa_character* file = nullptr;
  shigusa_result* result = nullptr;
  shigusa_result* own = nullptr;  // of the character from a file
  shigusa_result* work = nullptr;
};

struct Step {
  const char* name;
  std::function<shigusa_status(const Hands&)> call;
};

template <class Function, class... Arguments>
shigusa_status text(Function function, Arguments... arguments) {
  shigusa_bytes* bytes = nullptr;
  const shigusa_status status = function(arguments..., &bytes);
  shigusa_bytes_free(bytes);
  return status;
}

shigusa_status created(const char* spec, const std::string& file) {
  shigusa_character* made = nullptr;
  const shigusa_status status =
      shigusa_character_create(spec, file.empty() ? nullptr : file.data(), file.size(), &made);
  shigusa_character_free(made);
  return status;
}

template <class Function, class... Arguments>
shigusa_status result_of(Function function, Arguments... arguments) {
  shigusa_result* made = nullptr;
  const shigusa_status status = function(arguments..., &made);
  shigusa_result_free(made);
  return status;
}

shigusa_status exported(const shigusa_result* result, const char* format) {
  return text(shigusa_result_export, result, 1, format);
}

shigusa_status all_series(const Hands& hands) {
  // made anew: a result keeps its tables
  shigusa_result* made = nullptr;
  shigusa_status status = shigusa_replay(hands.result, 1, nullptr, &made);
  for (shigusa_series one = SHIGUSA_TIME; status == SHIGUSA_OK && one <= SHIGUSA_THINGS; ++one) {
    const double* values = nullptr;
    size_t frames = 0;
    size_t columns = 0;
    status = shigusa_result_series(made, 1, one, &values, &frames, &columns);
  }
  shigusa_result_free(made);
  return status;
}

shigusa_status series_at(const Hands& hands) {
  shigusa_bytes* table = nullptr;
  size_t frames = 0;
  size_t columns = 0;
  const shigusa_status status = shigusa_result_series_at(hands.result, 1, SHIGUSA_NODE_ROTATIONS,
                                                         30.0, &table, &frames, &columns);
  shigusa_bytes_free(table);
  return status;
}

shigusa_status table(const Hands& hands) {
  shigusa_bytes* values = nullptr;
  shigusa_bytes* about = nullptr;
  const shigusa_status status = shigusa_result_table(
      hands.result, 1, SHIGUSA_TORQUES, R"({"fps": 30, "place": "file"})", &values, &about);
  shigusa_bytes_free(values);
  shigusa_bytes_free(about);
  return status;
}

shigusa_status many(const Hands& hands) {
  const char* const tasks[] = {kTask, "{}"};
  shigusa_result* made[2] = {};
  shigusa_bytes* failures = nullptr;
  const shigusa_status status =
      shigusa_generate_all(hands.human, tasks, 2, 1, nullptr, made, &failures);
  for (shigusa_result* result : made) shigusa_result_free(result);
  shigusa_bytes_free(failures);
  return status;
}

shigusa_status of_angles(const Hands& hands) {
  static const std::vector<double> still(std::size_t{2} * 45, 0.0);
  return result_of(shigusa_result_of_angles, hands.human, nullptr, still.data(), std::size_t{2},
                   std::size_t{45}, 60.0);
}

// A refused call, whose reason is read: a failure needs memory too.
shigusa_status refused(const Hands&) {
  const shigusa_status status = created(R"({"source": "human", "stature_m": 99})", "");
  const shigusa_status told = text(shigusa_failure);
  return told == SHIGUSA_OK ? status : told;
}

const std::vector<Step>& steps() {
  static const std::vector<Step> all{
      {"shigusa_facts", [](const Hands&) { return text(shigusa_facts); }},
      {"shigusa_failure", refused},
      {"shigusa_character_create",
       [](const Hands&) { return created(R"({"source": "human", "stature_m": 1.6})", ""); }},
      {"shigusa_character_create bvh",
       [](const Hands& h) { return created(R"({"source": "a.bvh"})", h.bvh); }},
      {"shigusa_character_create gltf",
       [](const Hands& h) { return created(R"({"source": "a.gltf"})", h.gltf); }},
      {"shigusa_character_create urdf",
       [](const Hands& h) { return created(R"({"source": "a.urdf"})", h.urdf); }},
      {"shigusa_character_describe",
       [](const Hands& h) { return text(shigusa_character_describe, h.file); }},
      {"shigusa_generate",
       [](const Hands&) { return result_of(shigusa_generate, nullptr, kTask, 1, nullptr); }},
      {"shigusa_generate_all", many},
      {"shigusa_result_of_angles", of_angles},
      {"shigusa_restore",
       [](const Hands& h) { return result_of(shigusa_restore, h.human, h.summary.c_str()); }},
      {"shigusa_replay",
       [](const Hands& h) {
         return result_of(shigusa_replay, h.result, 1, R"(["right_elbow.weight=2.5"])");
       }},
      {"shigusa_replay_work",
       [](const Hands& h) {
         return result_of(shigusa_replay_work, h.work, 1, R"({"set": ["squat_deg=20"]})", nullptr);
       }},
      {"shigusa_mirror", [](const Hands& h) { return result_of(shigusa_mirror, h.result); }},
      {"shigusa_result_describe",
       [](const Hands& h) { return text(shigusa_result_describe, h.result); }},
      {"shigusa_result_parameters",
       [](const Hands& h) { return text(shigusa_result_parameters, h.result, 1); }},
      {"shigusa_result_action_parameters",
       [](const Hands& h) { return text(shigusa_result_action_parameters, h.work, 1, 1); }},
      {"shigusa_result_export bvh", [](const Hands& h) { return exported(h.result, "bvh"); }},
      {"shigusa_result_export csv", [](const Hands& h) { return exported(h.result, "csv"); }},
      {"shigusa_result_export svg", [](const Hands& h) { return exported(h.result, "svg"); }},
      {"shigusa_result_export html", [](const Hands& h) { return exported(h.result, "html"); }},
      {"shigusa_result_export glb", [](const Hands& h) { return exported(h.own, "glb"); }},
      {"shigusa_result_export_with",
       [](const Hands& h) {
         return text(shigusa_result_export_with, h.result, 1, "bvh", R"({"fps": 24})");
       }},
      {"shigusa_result_series", all_series},
      {"shigusa_result_series_at", series_at},
      {"shigusa_result_table", table},
      {"shigusa_score_clip",
       [](const Hands& h) {
         return text(shigusa_score_clip, "a.bvh", static_cast<const void*>(h.bvh.data()),
                     h.bvh.size(), nullptr);
       }},
  };
  return all;
}

// The state of a process that tries a step, shared with the waiting one.
struct Progress {
  long allocation = 0;  // that is being refused
  long tried = 0;
  int lack = 0;
  char wrong[200] = "";
};

// Calls a step on a new thread, with that allocation failing; returns its status.
shigusa_status called(const Step& step, const Hands& hands, Lack lack, long allocation,
                      long& made) {
  shigusa_status status = SHIGUSA_OK;
  std::thread([&] {
    run_out(lack, allocation);
    status = step.call(hands);
    made = allocations();
    run_out(Lack::none, 0);
  }).join();
  return status;
}

// Blocks leaked by nlohmann's constructor of an object if it throws: the object's members so far.
constexpr long kLost = 64;

// Tries a step in a process of its own, which a fault may end.
void try_step(const Step& step, const Hands& hands, Progress& progress) {
  const auto wrong = [&](const char* what, long number) {
    std::snprintf(progress.wrong, sizeof progress.wrong, "%s %ld", what, number);
  };
  long all = 0;
  // the second time the library's permanent data exist
  for (int k = 0; k < 2; ++k) (void)called(step, hands, Lack::none, 0, all);
  const shigusa_status usual = called(step, hands, Lack::none, 0, all);
  const long every = cases(1, 50);
  for (const Lack lack : {Lack::from_then, Lack::once}) {
    progress.lack = static_cast<int>(lack);
    for (long n = 1 + all % every; n <= all && progress.wrong[0] == '\0'; n += every) {
      progress.allocation = n;
      ++progress.tried;
      long kept = 0;
      long made = 0;
      for (int again = 0; again < 2; ++again) {
        const long before = blocks();
        const shigusa_status status = called(step, hands, lack, n, made);
        kept = std::max(0L, blocks() - before - kLost);
        if (status == SHIGUSA_FAULT || status == SHIGUSA_HOST) wrong("status", status);
        if (kept == 0) break;
      }
      if (kept != 0) wrong("blocks lost", kept);
    }
    if (called(step, hands, Lack::none, 0, all) != usual) wrong("afterwards another status", usual);
  }
}

Hands made_hands() {
  Hands hands;
  EXPECT_EQ(shigusa_character_create(R"("human")", nullptr, 0, &hands.human), SHIGUSA_OK);
  EXPECT_EQ(shigusa_character_create(R"({"source": "a.gltf"})", hands.gltf.data(),
                                     hands.gltf.size(), &hands.file),
            SHIGUSA_OK)
      << shigusa_message();
  EXPECT_EQ(shigusa_generate(hands.human, kReach, 1, nullptr, &hands.result), SHIGUSA_OK)
      << shigusa_message();
  EXPECT_EQ(shigusa_generate(hands.file, kReach, 1, nullptr, &hands.own), SHIGUSA_OK)
      << shigusa_message();
  EXPECT_EQ(shigusa_generate(hands.human, kWork, 1, nullptr, &hands.work), SHIGUSA_OK)
      << shigusa_message();
  shigusa_bytes* bytes = nullptr;
  EXPECT_EQ(shigusa_result_describe(hands.result, &bytes), SHIGUSA_OK);
  hands.summary.assign(shigusa_bytes_data(bytes), shigusa_bytes_size(bytes));
  shigusa_bytes_free(bytes);
  return hands;
}

class DoorMemory : public testing::TestWithParam<std::size_t> {};

TEST_P(DoorMemory, RunsOut) {
  const Step& step = steps()[GetParam()];
  void* const room =
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(room, MAP_FAILED);
  Progress& progress = *new (room) Progress;
  const pid_t child = fork();
  if (child == 0) {
    const Hands hands = made_hands();
    alarm(3000);
    try_step(step, hands, progress);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << "ended at allocation " << progress.allocation << ", lack "
                       << progress.lack;
  EXPECT_STREQ(progress.wrong, "")
      << "at allocation " << progress.allocation << ", lack " << progress.lack;
  EXPECT_GT(progress.tried, 0);
  munmap(room, sizeof(Progress));
}

std::string test_name(const testing::TestParamInfo<std::size_t>& step) {
  std::string name;
  for (const char* c = steps()[step.param].name; *c != '\0'; ++c) {
    if (std::isalnum(static_cast<unsigned char>(*c)) != 0) name += *c;
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(CInterface, DoorMemory, testing::Range(std::size_t{0}, steps().size()),
                         test_name);

}  // namespace
