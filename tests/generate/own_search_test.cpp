// SPDX-License-Identifier: MIT
// A user's own search, and failures in users' functions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <stdexcept>

#include "core/check.hpp"

namespace shigusa {
namespace {

Task asked(Preset preset) {
  Task task = with_preset(Task(full_body(), {.goals = {{"right_hand", {-0.2, 0.6, 0.5}}}}), preset);
  task.evaluations = 200;
  return task;
}

SearchResult differential_evolution(const SearchProblem& problem, int evaluations,
                                    std::uint64_t seed, const Progress& progress) {
  return search(SearchMethod::differential_evolution, problem, evaluations, seed, progress);
}

class OwnSearch : public testing::TestWithParam<Preset> {};

TEST_P(OwnSearch, TakesThePlaceOfTheLibrarys) {
  Task library = asked(GetParam());
  library.search = SearchMethod::differential_evolution;
  Task own = asked(GetParam());
  own.own_search = differential_evolution;
  const GenerateResult expected = generate(library).value();
  const GenerateResult found = generate(own).value();
  EXPECT_EQ(found.log.evaluations, expected.log.evaluations);
  ASSERT_EQ(found.candidates.size(), expected.candidates.size());
  for (std::size_t i = 0; i < found.candidates.size(); ++i) {
    EXPECT_EQ(found.candidates[i].parameters, expected.candidates[i].parameters);
  }
}

TEST_P(OwnSearch, PointsOutsideOfTheProblemAreRefused) {
  for (const std::size_t genes : {std::size_t{3}, std::size_t{0}}) {
    Task task = asked(GetParam());
    task.own_search = [genes](const SearchProblem& problem, int, std::uint64_t, const Progress&) {
      SearchResult result;
      result.best_seen.point.assign(genes == 0 ? static_cast<std::size_t>(problem.genes) : genes,
                                    1.5);
      return result;
    };
    EXPECT_THROW((void)generate(task), PreconditionError);
  }
}

INSTANTIATE_TEST_SUITE_P(Preset, OwnSearch, testing::Values(Preset::flat, Preset::paper),
                         [](const auto& of) { return std::string(word_of(of.param)); });

TEST(OwnSearch, LayersTakeNone) {
  Task task = asked(Preset::layers);
  task.own_search = differential_evolution;
  EXPECT_THAT(generate(task).error().message, testing::HasSubstr("no search of one's own"));
}

TEST(UsersFunctions, WhatTheyThrowPassesThrough) {
  Task searched = asked(Preset::flat);
  searched.own_search = [](const SearchProblem&, int, std::uint64_t,
                           const Progress&) -> SearchResult { throw std::runtime_error("ours"); };
  EXPECT_THROW((void)generate(searched), std::runtime_error);
  Task scored = asked(Preset::flat);
  scored.criteria.user.push_back({.name = "broken",
                                  .weight = 1.0,
                                  .scale = 1.0,
                                  .value = [](const BodyModel&, const Motion&) -> double {
                                    throw std::runtime_error("ours");
                                  }});
  EXPECT_THROW((void)generate(scored), std::runtime_error);
}

}  // namespace
}  // namespace shigusa
