// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <thread>

#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

Task task_for(const Vec3d& goal, const LimbStore& store) {
  Task task = with_preset(Task(half_body(), {.goals = {{"right_hand", goal}}}), Preset::layers);
  task.layers.store = store;
  task.seed = 3;
  return task;
}

constexpr Vec3d kGoal{-0.3, 1.0, 0.45};

std::vector<double> numbers(const GenerateResult& generation) {
  std::vector<double> all{generation.best_seen_score, double(generation.log.evaluations)};
  for (const Candidate& candidate : generation.candidates) {
    all.push_back(candidate.score.total);
    const std::vector<double>& angles = candidate.motion.clip.angles;
    all.insert(all.end(), angles.begin(), angles.end());
  }
  return all;
}

GenerateResult generated(const LimbStore& store) {
  return generate(task_for(kGoal, store)).value();
}

TEST(LimbCache, ColdWarmAndWithoutGiveTheSameNumbers) {
  const WorkFolder folder;
  const GenerateResult without = generated({});
  const GenerateResult cold = generated(limb_store(folder / "new" / "cache"));
  const GenerateResult warm = generated(limb_store(folder / "new" / "cache"));
  EXPECT_GT(cold.log.cells_searched, 0);
  EXPECT_EQ(warm.log.cells_searched, 0);
  EXPECT_EQ(numbers(cold), numbers(without));
  EXPECT_EQ(numbers(warm), numbers(without));
}

TEST(LimbCache, GrowsWithTheGoalsAsked) {
  const WorkFolder folder;
  const LimbStore store = limb_store(folder.path());
  (void)generated(store);
  const Task other = task_for({-0.5, 1.5, 0.2}, store);
  EXPECT_GT(generate(other).value().log.cells_searched, 0);
  EXPECT_EQ(generate(other).value().log.cells_searched, 0);
  EXPECT_EQ(generated(store).log.cells_searched, 0);
  EXPECT_EQ(folder.contents().size(), 1u) << "one arm, one file";
}

TEST(LimbCache, ReplacesDamagedFiles) {
  const WorkFolder folder;
  const LimbStore store = limb_store(folder.path());
  const GenerateResult cold = generated(store);
  const auto good = folder.contents();
  const std::string name = good.begin()->first;
  for (const std::string& bad : {std::string(), std::string("not a library"),
                                 good.begin()->second.substr(0, 100), std::string(70000, 'x')}) {
    folder.put(name, bad);
    const GenerateResult again = generated(store);
    EXPECT_EQ(again.log.cells_searched, cold.log.cells_searched);
    EXPECT_EQ(numbers(again), numbers(cold));
    EXPECT_EQ(folder.contents(), good);
  }
}

TEST(LimbCache, FolderThatCannotBeWrittenIsAsGoodAsNone) {
  const WorkFolder folder;
  folder.put("file", "x");
  const GenerateResult nowhere = generated(limb_store(folder / "file" / "below"));
  EXPECT_EQ(numbers(nowhere), numbers(generated({})));
}

TEST(LimbCache, TwoAtOnceLeaveAWholeFile) {
  const WorkFolder folder;
  const LimbStore store = limb_store(folder.path());
  const auto work = [&] {
    for (int i = 0; i < 10; ++i) (void)generated(store);
  };
  std::thread one(work);
  std::thread other(work);
  one.join();
  other.join();
  EXPECT_EQ(folder.contents().size(), 1u) << "nothing is left beside the file";
  EXPECT_EQ(generated(store).log.cells_searched, 0);
}

class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    if (value != nullptr) {
      setenv(name, value, 1);
    } else {
      unsetenv(name);
    }
  }
  ~Environment() {
    if (old_) {
      setenv(name_, old_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST(CacheFolder, IsTheOwnOneThenTheUsersThenHomes) {
  const Environment own("SHIGUSA_CACHE", "/a/own");
  EXPECT_EQ(cache_folder(), "/a/own");
  const Environment none("SHIGUSA_CACHE", nullptr);
  const Environment user("XDG_CACHE_HOME", "/a/cache");
  EXPECT_EQ(cache_folder(), "/a/cache/shigusa");
  const Environment relative("XDG_CACHE_HOME", "cache");
  const Environment home("HOME", "/a/home");
  EXPECT_EQ(cache_folder(), "/a/home/.cache/shigusa");
  const Environment homeless("HOME", nullptr);
  EXPECT_EQ(cache_folder(), std::nullopt);
}

}  // namespace
}  // namespace shigusa
