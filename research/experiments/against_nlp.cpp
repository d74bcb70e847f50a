// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <shigusa/run.hpp>

#include "goal_search.hpp"
#include "nlp/nlp_rollout.hpp"
#include "report.hpp"
#include "search/cma_es.hpp"
#include "sections.hpp"

namespace shigusa::bench {
namespace {

constexpr int kSearched = 300;
constexpr int kTuned = 1000;

// A method to make a motion from parameters, in double precision.
struct Generator {
  const char* name;
  RolledOut (*roll_out)(const ReachProblem&, const Parameters&);
};
constexpr std::array<Generator, 2> kGenerators{Generator{"weighted IK", roll_out},
                                               Generator{"NLP-IK", roll_out_nlp}};

struct Played {
  bool met = false;
  double score = 0.0;
  double milliseconds = 0.0;
  double roughness = 0.0;  // rad/frame², largest second difference of a joint angle
};

double roughness_of(const Clip& clip) {
  double most = 0.0;
  for (int f = 2; f < clip.frames; ++f) {
    for (int d = 0; d < clip.dofs; ++d) {
      const auto k = static_cast<std::size_t>(d);
      most = max(most, abs(clip.frame(f)[k] - 2.0 * clip.frame(f - 1)[k] + clip.frame(f - 2)[k]));
    }
  }
  return most;
}

Played play(const GoalSearch& searched, std::span<const double> point, const Generator& by) {
  const ReachProblem& problem = searched.reach();
  const Parameters parameters = searched.space().decode(point);
  const Stopwatch watch;
  const RolledOut rolled = by.roll_out(problem, parameters);
  Played played{.score = worst_score(searched.criteria()), .milliseconds = watch.milliseconds()};
  played.met = rolled.outcome.met(problem.tolerance) != 0;
  played.roughness = roughness_of(rolled.motion.clip);
  if (played.met) {
    played.score = score_motion(*problem.body, rolled.motion, searched.criteria()).total;
  }
  return played;
}

// Best result of a search whose motions are made sequentially by one of the generators.
std::vector<double> best_by(const GoalSearch& searched, SearchProblem problem, const Generator& by,
                            std::uint64_t seed) {
  const auto genes = static_cast<std::size_t>(problem.genes);
  problem.evaluate = [&](std::span<const double> points, std::span<double> scores) {
    for (std::size_t i = 0; i < scores.size(); ++i) {
      scores[i] = play(searched, points.subspan(i * genes, genes), by).score;
    }
  };
  return cma_es_search(problem, {.evaluations = kSearched, .seed = seed}).best_seen.point;
}

// Three sets of parameters: the plain pseudo-inverse; those found by a search with weighted IK,
// played by both; and those found by a search with each.
struct OfPlace {
  std::array<Played, 2> plain;
  std::array<Played, 2> tuned;
  std::array<Played, 2> own;
};

OfPlace of_place(const Subject& subject, const Place& place) {
  GoalSearch searched(subject.posed, place.position);
  const SearchProblem problem = searched.problem();
  const std::vector<double> tuned =
      cma_es_search(problem, {.evaluations = kTuned, .seed = 1}).best_seen.point;
  OfPlace of;
  for (std::size_t g = 0; g < kGenerators.size(); ++g) {
    of.plain[g] = play(searched, problem.start, kGenerators[g]);
    of.tuned[g] = play(searched, tuned, kGenerators[g]);
    const std::vector<double> own = best_by(searched, problem, kGenerators[g], 1);
    of.own[g] = play(searched, own, kGenerators[g]);
  }
  return of;
}

}  // namespace

std::string against_nlp(const Plan& plan, std::span<const Subject> subjects) {
  Table table({"body", "parameters", "motions by", "met", "score", "ms a motion",
               "largest second difference, °", "score beside weighted IK"});
  for (const Subject& subject : subjects) {
    std::vector<OfPlace> all(subject.drawn);
    parallel_for(static_cast<int>(all.size()), 0, [&](int i, int) {
      const auto p = static_cast<std::size_t>(i);
      all[p] = of_place(subject, subject.places[p]);
    });
    const auto add = [&](const std::string& name, std::array<Played, 2> OfPlace::*kind) {
      for (std::size_t g = 0; g < kGenerators.size(); ++g) {
        std::vector<double> scores, times, rough, ratios;
        int met = 0;
        for (const OfPlace& of : all) {
          const Played& played = (of.*kind)[g];
          met += played.met ? 1 : 0;
          scores.push_back(played.score);
          times.push_back(played.milliseconds);
          rough.push_back(degrees(played.roughness));
          ratios.push_back(played.score / (of.*kind)[0].score);
        }
        table.add({subject.posed.body.name(), name, kGenerators[g].name, percent(met, plan.goals),
                   spread(scores), fmt::format("{:.3f}", median(times)), spread(rough),
                   g == 0 ? "" : spread(ratios)});
      }
    };
    add("all alike", &OfPlace::plain);
    add(fmt::format("best of {} by weighted IK", kTuned), &OfPlace::tuned);
    add(fmt::format("best of {} of its own", kSearched), &OfPlace::own);
  }
  return "The same parameters, played by `roll_out()` (weighted IK, limits kept) and by "
         "`roll_out_nlp()` (a nonlinear program for each frame), in double on one thread, scored "
         "by the default criteria; a motion that does not meet its goal, path or feet has the "
         "worst score. Smoothness is the largest second difference of a joint angle from frame to "
         "frame. The last kind is searched anew for each of the two, by CMA-ES with one seed.\n\n" +
         table.text();
}

}  // namespace shigusa::bench
