// SPDX-License-Identifier: MIT
#include "layered_ways.hpp"

#include <algorithm>
#include <array>
#include <shigusa/hierarchy/generator.hpp>
#include <utility>

#include "ways.hpp"

namespace shigusa {
namespace {

// Shares of the way that are tried one after the other from its end, and how often the step
// between the last two is halved.
constexpr int kShares = 16;
constexpr int kHalvings = 6;

// Lengths of legs and arms (0..kLayerGeneMax) that are tried to get as far as possible, and the
// joints of the upper layer that are given a weight of kHeavy: those whose own way to the goal may
// lead the hand into a singularity that the others keep it from.
constexpr std::array<double, 6> kLengths{0.0, 1.0, 2.0, 4.0, 8.0, 12.0};
constexpr std::array<const char*, 5> kHeavyJoints{nullptr, "shoulder.abduction", "ankle.", "hip.",
                                                  "spine."};
constexpr double kHeavy = 15.0;

// the same paths, to be left at a share of their length
void shorten(const LayeredProblem& problem, double share, LayeredProblem& shorter) {
  for (std::size_t g = 0; g < problem.reach.goals.size(); ++g) {
    const EffectorPath& path = problem.reach.goals[g].path;
    shorter.reach.goals[g].path.goal = path.start + (path.goal - path.start) * share;
    shorter.reach.goals[g].path.detour = path.detour * share;
  }
}

LayeredProblem shortened(const LayeredProblem& problem, double share) {
  LayeredProblem shorter = problem;
  shorten(problem, share, shorter);
  return shorter;
}

double longest_path(const LayeredProblem& problem) {
  double longest = 0.0;
  for (const ReachGoal& goal : problem.reach.goals) {
    longest = max(longest, norm(goal.path.goal - goal.path.start));
  }
  return longest;
}

RolledOut play(const LayeredProblem& problem, const LayeredParameters& parameters) {
  LayeredPlayer player(problem);
  ReducedClip clip;
  player.run_upper(parameters.upper, clip);
  return player.expand(clip, parameters);
}

bool arrives_smoothly(const LayeredProblem& problem, const RolledOut& rolled) {
  return rolled.outcome.met(problem.reach.tolerance) && !jolts(rolled.motion.clip);
}

// Plays parts of a problem's way; one player for all of them.
class PartPlayer {
 public:
  explicit PartPlayer(const LayeredProblem& problem)
      : whole_(&problem), part_(problem), player_(part_) {}
  PartPlayer(const PartPlayer&) = delete;
  PartPlayer& operator=(const PartPlayer&) = delete;

  // Whether the parameters arrive, smoothly, after that share of the way.
  bool leads_to(double share, const LayeredParameters& parameters) {
    shorten(*whole_, share, part_);
    player_.run_upper(parameters.upper, clip_);
    // what the trunk misses no limb makes up for
    const bool missed = clip_.path_error > 2.0 * part_.reach.tolerance.path;
    if (missed || !player_.check_pelvis(clip_).in_reach) return false;
    return arrives_smoothly(part_, player_.expand(clip_, parameters));
  }

  // The share of the way that the parameters lead along; nothing where that is not above `least`.
  std::optional<double> farthest(const LayeredParameters& parameters, double least) {
    constexpr double kStep = 1.0 / kShares;
    for (int k = kShares; k >= 0; --k) {
      double low = k * kStep;
      // what is left of this step is no farther than what is known
      if (low + kStep <= least || least >= 1.0) return std::nullopt;
      if (!leads_to(low, parameters)) continue;
      if (k == kShares) return 1.0;
      double high = low + kStep;
      for (int halving = 0; halving < kHalvings; ++halving) {
        const double middle = 0.5 * (low + high);
        (leads_to(middle, parameters) ? low : high) = middle;
      }
      return low > least ? std::optional(low) : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  const LayeredProblem* whole_;
  LayeredProblem part_;
  LayeredPlayer player_;
  ReducedClip clip_;
};

// all that is tried to get as far as possible
std::vector<LayeredParameters> probes(std::span<const Layer> layers) {
  std::vector<LayeredParameters> all;
  for (const char* heavy : kHeavyJoints) {
    const auto has_it = [heavy](const LayerGene& gene) {
      return gene.name.find(heavy) != gene.name.npos;
    };
    const std::vector<LayerGene>& genes = layers[0].genes;
    if (heavy != nullptr && std::none_of(genes.begin(), genes.end(), has_it)) continue;
    for (const double legs : kLengths) {
      for (const double arms : kLengths) {
        LayeredParameters probe;
        for (const LayeredMember& member : layered_members(layers, probe)) {
          const bool of_legs = member.name.find("leg") != member.name.npos;
          for (double* contraction : member.contraction) *contraction = of_legs ? legs : arms;
          if (member.joint == nullptr || !member.layer.empty() || heavy == nullptr) continue;
          if (member.name.find(heavy) != member.name.npos) member.joint->weight = kHeavy;
        }
        all.push_back(std::move(probe));
      }
    }
  }
  return all;
}

LayeredEdge find_edge(const LayeredProblem& problem) {
  const std::vector<LayeredParameters> tried = probes(problem.layers);
  // standing still is nearer than nothing
  LayeredParameters best = tried.front();
  double share = -1.0;
  PartPlayer player(problem);
  for (const LayeredParameters& probe : tried) {
    if (const auto farther = player.farthest(probe, share)) {
      share = *farther;
      best = probe;
    }
  }
  if (share >= 1.0) return {problem, problem.in_reach, std::move(best)};
  share = max(share, 0.0);
  // a little before the edge others arrive too
  const double before = share - kEdgeTolerance / longest_path(problem);
  if (before > 0.0 && player.leads_to(before, best)) share = before;
  return {shortened(problem, share), false, std::move(best)};
}

}  // namespace

const LayeredEdge& LayeredWays::edge() {
  if (!edge_) edge_ = find_edge(*problem_);
  return *edge_;
}

std::optional<LayeredArrival> LayeredWays::arrival(const LayeredParameters& parameters,
                                                   LayeredWay last) {
  if (problem_->in_reach) {
    RolledOut rolled = play(*problem_, parameters);
    if (rolled.outcome.met(problem_->reach.tolerance)) {
      return LayeredArrival{problem_->reach, std::move(rolled)};
    }
  }
  if (last == LayeredWay::whole) return std::nullopt;
  if (!edge().whole) {
    RolledOut rolled = play(edge_->problem, parameters);
    if (arrives_smoothly(edge_->problem, rolled)) {
      return LayeredArrival{edge_->problem.reach, std::move(rolled)};
    }
  }
  if (last == LayeredWay::edge) return std::nullopt;
  if (const auto share = PartPlayer(*problem_).farthest(parameters, -1.0)) {
    const LayeredProblem shorter = shortened(*problem_, *share);
    return LayeredArrival{shorter.reach, play(shorter, parameters)};
  }
  return std::nullopt;
}

LayeredArrival LayeredWays::any_arrival(const LayeredParameters& parameters) {
  if (auto arrived = arrival(parameters, LayeredWay::own)) return std::move(*arrived);
  return {problem_->reach, play(*problem_, parameters)};
}

}  // namespace shigusa
