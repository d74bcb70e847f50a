// SPDX-License-Identifier: MIT
// The guarantees of shigusa.h for programs with threads: different objects may be used
// concurrently, one object by one thread at a time. The thread sanitizer checks these tests in
// scripts/check.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <functional>
#include <mutex>
#include <numeric>
#include <thread>

#include "c/handles.hpp"
#include "support/gltf_file.hpp"
#include "support/robot_file.hpp"

namespace shigusa_c_test {
namespace {

using testing::HasSubstr;

constexpr std::size_t kThreads = 4;

// Runs work(0) … work(kThreads - 1), each on its own thread, concurrently.
void at_once(const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> waiting{kThreads};
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      --waiting;
      while (waiting > 0) std::this_thread::yield();
      work(i);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// A low reach that is quick to search, even under a sanitizer.
std::string quick_reach(const std::string& preset, int evaluations = 100) {
  Json task = Json::parse(kLowReach);
  task["preset"] = preset;
  task["evaluations"] = evaluations;
  task["candidates"] = 2;
  return task.dump();
}

struct Subject {
  std::string spec;
  std::string file;
  std::string task;
};

// One of each kind of character and of each family of presets.
const std::array<Subject, kThreads>& subjects() {
  using namespace shigusa::testing_support;
  static const std::array<Subject, kThreads> all{
      Subject{R"("full_body")", "", quick_reach("human")},
      Subject{R"({"source": "person.bvh"})", person_bvh(), quick_reach("flat")},
      Subject{R"({"source": "person.gltf"})", person_gltf().dump(), quick_reach("flat")},
      Subject{R"({"source": "robot.urdf"})", RobotFile().text(), quick_reach("paper")}};
  return all;
}

// Everything that a host program reads of a result, except its search time.
std::string all_of(const shigusa_result* result, bool own_skeleton) {
  std::string all;
  for (int32_t k = 1; k <= shigusa_result_candidates(result); ++k) {
    for (const char* format : {"bvh", "csv", "svg"}) {
      all += text_of(shigusa_result_export, result, k, format);
    }
    all += text_of(shigusa_result_parameters, result, k);
    for (shigusa_series series = SHIGUSA_TIME; series <= SHIGUSA_NODE_ROTATIONS; ++series) {
      const Table table = table_of(result, k, series);
      all.append(reinterpret_cast<const char*>(table.values.data()),
                 table.values.size() * sizeof(double));
    }
  }
  if (own_skeleton) all += text_of(shigusa_result_export, result, 0, "glb");
  return all;
}

// The result that `function` returns in its last argument.
template <class Function, class... Arguments>
Outcome made_by(Function function, Arguments... arguments) {
  shigusa_result* made = nullptr;
  EXPECT_EQ(function(arguments..., &made), SHIGUSA_OK) << shigusa_message();
  return Outcome(made);
}

// A host program's whole use of the library, on its own objects.
std::string visit(const Subject& subject) {
  const bool own_skeleton = subject.spec.find(".gltf") != std::string::npos;
  const Character character = character_of(subject.spec, subject.file);
  std::string all = text_of(shigusa_character_describe, character.get());
  // two threads of the search to each of these
  const Outcome result =
      made_by(shigusa_generate, character.get(), subject.task.c_str(), 2, nullptr);
  all += all_of(result.get(), own_skeleton);
  const std::string summary = text_of(shigusa_result_describe, result.get());
  all += all_of(made_by(shigusa_restore, character.get(), summary.c_str()).get(), own_skeleton);
  all += all_of(made_by(shigusa_replay, result.get(), 1, nullptr).get(), own_skeleton);
  const std::string bvh = text_of(shigusa_result_export, result.get(), 1, "bvh");
  if (subject.spec.find(".urdf") == std::string::npos) {
    all += all_of(made_by(shigusa_mirror, result.get()).get(), own_skeleton);
    all += text_of(shigusa_score_clip, "reach.bvh", bvh.data(), bvh.size(), nullptr);
  }
  return all;
}

TEST(CInterfaceThreads, VisitsAtOnceGiveTheBytesOfVisitsAlone) {
  std::array<std::string, kThreads> alone;
  for (std::size_t i = 0; i < kThreads; ++i) alone[i] = visit(subjects()[i]);
  std::array<std::string, kThreads> together;
  at_once([&](std::size_t i) { together[i] = visit(subjects()[i]); });
  for (std::size_t i = 0; i < kThreads; ++i) {
    EXPECT_TRUE(together[i] == alone[i]) << subjects()[i].spec;
  }
}

// Results share their character's data behind their handles.
TEST(CInterfaceThreads, ResultsOfOneCharacterAreReadAtOnceWhileItIsFreed) {
  const Subject& subject = subjects()[2];
  Character character = character_of(subject.spec, subject.file);
  std::array<Outcome, kThreads> results;
  for (Outcome& result : results) {
    result = made_by(shigusa_generate, character.get(), subject.task.c_str(), 1, nullptr);
  }
  const std::string alone = all_of(results[0].get(), true);
  std::array<std::string, kThreads> read;
  at_once([&](std::size_t i) {
    if (i == 0) character.reset();
    read[i] = all_of(results[i].get(), true);
    results[i].reset();
  });
  for (const std::string& each : read) EXPECT_TRUE(each == alone);
}

TEST(CInterfaceThreads, OneObjectIsUsedByAThreadAtATime) {
  std::mutex turn;
  const Character character = character_of(R"("human")");
  const Outcome result = outcome_of(character.get(), quick_reach("flat"));
  const std::string summary = text_of(shigusa_result_describe, result.get());
  std::array<std::string, kThreads> exported;
  at_once([&](std::size_t i) {
    for (int round = 0; round < 3; ++round) {
      Outcome own;
      {
        const std::lock_guard lock(turn);
        own = i % 2 == 0 ? made_by(shigusa_restore, character.get(), summary.c_str())
                         : made_by(shigusa_replay, result.get(), 1, nullptr);
        (void)text_of(shigusa_character_describe, character.get());
      }
      exported[i] = text_of(shigusa_result_export, own.get(), 1, "csv");
    }
  });
  for (const std::string& each : exported) {
    EXPECT_TRUE(each == text_of(shigusa_result_export, result.get(), 1, "csv"));
  }
}

TEST(CInterfaceThreads, ATableIsReadWhileOthersAskForMore) {
  std::mutex turn;
  const Character character = character_of(R"("human")");
  const Outcome result = outcome_of(character.get(), quick_reach("flat"));
  std::array<double, SHIGUSA_NODE_ROTATIONS + 1> sums{};
  const auto sum = [&](shigusa_series series) {
    const double* values = nullptr;
    std::size_t frames = 0, columns = 0;
    {
      const std::lock_guard lock(turn);
      EXPECT_EQ(shigusa_result_series(result.get(), 1, series, &values, &frames, &columns),
                SHIGUSA_OK);
    }
    return std::accumulate(values, values + frames * columns, 0.0);
  };
  at_once([&](std::size_t i) {
    for (std::size_t s = i; s < sums.size(); s += kThreads) {
      sums[s] = sum(static_cast<shigusa_series>(s));
    }
  });
  for (std::size_t s = 0; s < sums.size(); ++s) {
    EXPECT_EQ(sums[s], sum(static_cast<shigusa_series>(s)));
  }
}

// As by a button of a host program: the flag is set on one thread, and read where the search
// reports, on the calling thread.
TEST(CInterfaceThreads, ASearchIsStoppedFromAnotherThreadAndOthersGoOn) {
  struct Watched {
    std::thread::id caller;
    std::atomic<bool> began{false};
    std::atomic<bool> stop{false};
  };
  std::array<Watched, kThreads> watched;
  const auto report = [](void* user, double, int32_t, double) -> int32_t {
    auto& seen = *static_cast<Watched*>(user);
    EXPECT_EQ(std::this_thread::get_id(), seen.caller);
    seen.began = true;
    return seen.stop ? 1 : 0;
  };
  std::thread button([&] {
    for (std::size_t i = 0; i < kThreads; i += 2) {
      while (!watched[i].began) std::this_thread::yield();
      watched[i].stop = true;
    }
  });
  std::array<std::string, kThreads> ends;
  at_once([&](std::size_t i) {
    watched[i].caller = std::this_thread::get_id();
    const shigusa_watch watch{report, &watched[i]};
    const Character character = character_of(R"("full_body")");
    // far more than there is time for, to be cancelled
    const std::string task = quick_reach("flat", i % 2 == 0 ? 1'000'000 : 200);
    const Outcome result = made_by(shigusa_generate, character.get(), task.c_str(), 2, &watch);
    ends[i] = json_of(result.get()).at("search_detail").at("end");
  });
  button.join();
  for (std::size_t i = 0; i < kThreads; ++i) EXPECT_EQ(ends[i] == "cancelled", i % 2 == 0) << i;
}

TEST(CInterfaceThreads, AMessageIsOfItsThread) {
  at_once([](std::size_t i) {
    const std::string name = "nobody_" + std::to_string(i);
    const std::string spec = R"({"source": ")" + name + R"(.bvh"})";
    EXPECT_STREQ(shigusa_message(), "");
    for (int round = 0; round < 100; ++round) {
      shigusa_character* none = nullptr;
      EXPECT_EQ(shigusa_character_create(spec.c_str(), "x", 1, &none), SHIGUSA_PARSE);
      EXPECT_THAT(shigusa_message(), HasSubstr(name));
    }
  });
}

}  // namespace
}  // namespace shigusa_c_test
