// SPDX-License-Identifier: MIT
#include "candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <shigusa/generate.hpp>
#include <shigusa/human.hpp>
#include <shigusa/run.hpp>

#include "../experiments/report.hpp"
#include "generate/posture_meter.hpp"
#include "measures.hpp"

namespace shigusa::bench {
namespace {

constexpr double kUsualStature = 1.741;  // m, of the goals below
constexpr std::array kCandidates{5, 8};

// Height (m, scaled to the usual stature) from which goals are reached upright, with straight
// knees.
constexpr double kTable = 0.90;
constexpr double kAboveTheChest = 1.30;
// Height above which people neither stoop nor squat fully.
constexpr double kLow = 0.50;
constexpr double kStraightKnee = radians(25.0);
constexpr double kFolded = radians(110.0);
constexpr double kUpright = radians(30.0);
constexpr double kElbowIn = radians(-60.0);
constexpr double kPureSquat = 30.0;  // stoop-squat index
constexpr double kPureStoop = 90.0;

// A goal, on the body's right, with the load of the hands there.
struct Place {
  const char* name;
  Vec3d at;
  bool both = false;  // hands
  double load = 0.0;  // kg, of each hand
};
constexpr std::array kPlaces{
    Place{"floor", {-0.15, 0.05, 0.35}},
    Place{"floor, beside", {-0.50, 0.06, 0.15}},
    Place{"floor, both hands", {-0.165, 0.10, 0.35}, true},
    Place{"20 cm", {-0.15, 0.20, 0.40}},
    Place{"20 cm, both hands, 10 kg", {-0.165, 0.20, 0.40}, true, 5.0},
    Place{"40 cm", {-0.15, 0.40, 0.45}},
    Place{"40 cm, both hands", {-0.165, 0.40, 0.40}, true},
    Place{"76 cm, both hands", {-0.165, 0.76, 0.40}, true},
    Place{"table", {-0.20, 0.95, 0.45}},
    Place{"chest", {-0.20, 1.25, 0.55}},
    Place{"to the side", {-0.75, 1.15, 0.05}},
    Place{"shelf of 1.50 m", {-0.20, 1.50, 0.55}},
    Place{"shelf of 1.50 m, 3 kg", {-0.20, 1.50, 0.45}, false, 3.0},
    Place{"shelf of 1.55 m, both hands", {-0.165, 1.55, 0.45}, true},
    Place{"shelf of 1.80 m", {-0.20, 1.80, 0.45}},
};

struct Build {
  const char* name;
  double stature;
  Sex sex = Sex::male;
};
constexpr std::array kBuilds{Build{"`human`", kUsualStature}, Build{"female", 1.62, Sex::female},
                             Build{"1.55 m", 1.55, Sex::female}, Build{"1.88 m", 1.88}};

PosedBody body_of(const Build& build) {
  return human_body(
      {.stature = build.stature, .mass = default_mass(build.stature, build.sex), .sex = build.sex});
}

// One query with its results.
struct Asked {
  const Place* place;
  bool met = false;
  std::vector<Candidate> candidates{};
  std::vector<double> trunks{};  // rad, of them at the end
};

Asked asked(const Place& place, const PosedBody& posed, int candidates) {
  const double scale = posed.body.stature() / kUsualStature;
  Task task(posed);
  const Vec3d at = scale * place.at;
  task.goals = {{"right_hand", at}};
  if (place.both) task.goals.push_back({"left_hand", {-at.x, at.y, at.z}});
  for (Goal& goal : task.goals) goal.load = place.load;
  task.candidates = candidates;
  task.batch.threads = 1;
  GenerateResult generation = generate(task).value();
  Asked result{.place = &place, .met = generation.meets_goals()};
  for (Candidate& candidate : generation.candidates) {
    const Track track = joints_track(posed, candidate.motion.clip);
    result.trunks.push_back(trunk_lean(track.joints.back()));
    result.candidates.push_back(std::move(candidate));
  }
  return result;
}

// Violation of a rule on people's behaviour; for a candidate of a query, by its index.
struct Rule {
  const char* name;
  bool (*concerns)(const Asked&, std::size_t);
  bool (*broken)(const Asked&, std::size_t);
};

bool always(const Asked&, std::size_t) { return true; }
double knee(const Asked& of, std::size_t c) { return of.candidates[c].final_posture.knee_flexion; }
bool impossible(const Candidate& candidate) {
  return candidate.judgement.verdict == Verdict::impossible;
}
std::string words(const Asked& of, std::size_t c) {
  return posture_words(of.candidates[c].final_posture);
}

constexpr std::array kRules{
    Rule{"first not as people",
         [](const Asked& of, std::size_t c) {
           return c == 0 && (of.place->at.y < kLow || of.place->at.y >= kTable);
         },
         [](const Asked& of, std::size_t c) {
           if (of.place->at.y >= kTable) {
             return knee(of, c) > kStraightKnee || of.trunks[c] > kUpright;
           }
           const auto index = of.candidates[c].final_posture.stoop_squat_index;
           return !index || *index < kPureSquat || *index > kPureStoop;
         }},
    Rule{"bent knees for a shelf",
         [](const Asked& of, std::size_t) { return of.place->at.y >= kAboveTheChest; },
         [](const Asked& of, std::size_t c) { return knee(of, c) > kStraightKnee; }},
    Rule{"folded on straight knees", always,
         [](const Asked& of, std::size_t c) {
           return of.trunks[c] >= kFolded && knee(of, c) < kStraightKnee;
         }},
    Rule{"elbow inwards", always,
         [](const Asked& of, std::size_t c) {
           return of.candidates[c].final_posture.elbow_swivel < kElbowIn;
         }},
    Rule{"impossible beside possible", always,
         [](const Asked& of, std::size_t c) {
           return impossible(of.candidates[c]) && !impossible(of.candidates[0]);
         }},
    Rule{"words of a better one", always,
         [](const Asked& of, std::size_t c) {
           for (std::size_t before = 0; before < c; ++before) {
             if (words(of, before) == words(of, c)) return true;
           }
           return false;
         }},
};

// Numbers of candidates that each rule applies to, and that break it.
struct Counts {
  int candidates = 0;
  std::array<int, kRules.size()> about{};
  std::array<int, kRules.size()> broken{};

  void add(const Asked& of) {
    for (std::size_t c = 0; c < of.candidates.size(); ++c) {
      ++candidates;
      for (std::size_t r = 0; r < kRules.size(); ++r) {
        if (!kRules[r].concerns(of, c)) continue;
        ++about[r];
        if (kRules[r].broken(of, c)) ++broken[r];
      }
    }
  }
  [[nodiscard]] std::vector<std::string> cells() const {
    std::vector<std::string> cells{std::to_string(candidates)};
    for (std::size_t r = 0; r < kRules.size(); ++r) {
      cells.push_back(about[r] == 0 ? "–" : fmt::format("{} of {}", broken[r], about[r]));
    }
    return cells;
  }
};

// Whether a squat (0), a half squat or a stoop (2) is among them.
bool offers_style(const Asked& of, std::size_t style) {
  return std::any_of(of.candidates.begin(), of.candidates.end(), [style](const Candidate& c) {
    const auto index = c.final_posture.stoop_squat_index;
    return index && (*index < kSquatIndex ? 0U : *index > kStoopIndex ? 2U : 1U) == style;
  });
}

// Styles with knee and trunk angles, "half squat (63, 78); stoop (10, 95)".
std::string listed(const Asked& of) {
  std::string text;
  for (std::size_t c = 0; c < of.candidates.size(); ++c) {
    text += fmt::format("{}{} ({:.0f}, {:.0f})", c == 0 ? "" : "; ", words(of, c),
                        degrees(knee(of, c)), degrees(of.trunks[c]));
  }
  return of.met ? text : text + " (missed)";
}

// Drawn goals of `human` (m): low ones ahead, and others to both sides.
constexpr int kDrawnGoals = 40;
constexpr int kDrawnLow = 15;
Place drawn_place(int number) {
  Random random(45, static_cast<std::uint64_t>(number));
  const auto between = [&random](double low, double high) {
    return low + (high - low) * random.uniform();
  };
  const bool low = number < kDrawnLow;
  const double bearing = radians(low ? between(-60.0, 45.0) : between(-75.0, 75.0));
  const double distance = between(0.25, 0.7);
  const double height = low ? between(0.05, kLow) : between(0.75, 1.9);
  const SinCos<double> way = sin_cos(bearing);
  return {"drawn", {distance * way.sin, height, max(distance * way.cos, low ? 0.2 : -1.0)}};
}

// Counts of what a person sees among the candidates for drawn goals.
std::string drawn_text(const PosedBody& posed) {
  std::vector<Place> goals(kDrawnGoals);
  std::vector<Asked> all(goals.size());
  parallel_for(kDrawnGoals, 0, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    goals[i] = drawn_place(index);
    all[i] = asked(goals[i], posed, kCandidates[0]);
  });
  int three = 0;
  int styles = 0;
  int shown = 0;
  int same = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    PostureMeter meter(posed.body, posed.home, 0);
    std::vector<Look> looks;
    for (std::size_t c = 0; c < all[i].candidates.size(); ++c) {
      const Look look = meter.look(all[i].candidates[c].motion.clip);
      const auto like = [&look](const Look& other) { return look_alike(other, look); };
      if (std::none_of(looks.begin(), looks.end(), like)) looks.push_back(look);
      same += kRules.back().broken(all[i], c) ? 1 : 0;
    }
    three += looks.size() >= 3 ? 1 : 0;
    shown += static_cast<int>(all[i].candidates.size());
    const bool low = i < static_cast<std::size_t>(kDrawnLow);
    styles += low && offers_style(all[i], 0) && offers_style(all[i], 2) ? 1 : 0;
  }
  return fmt::format(
      "\nOf {} drawn goals for `human`, {} have three candidates or more that a person can tell "
      "apart (joints 5 cm apart on average, and the trunk's lean 12°, knees or turn 20°, hips 7 cm "
      "or an elbow 12 cm elsewhere); {} of {} candidates have the words of a better one. Of {} "
      "low ones {} offer a squat and a stoop.\n",
      kDrawnGoals, three, same, shown, kDrawnLow, styles);
}

}  // namespace

std::string candidates_section() {
  std::vector<PosedBody> bodies;
  for (const Build& build : kBuilds) bodies.push_back(body_of(build));
  constexpr std::size_t kPerBuild = kPlaces.size() * kCandidates.size();
  std::vector<Asked> all(kBuilds.size() * kPerBuild);
  parallel_for(static_cast<int>(all.size()), 0, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    all[i] = asked(kPlaces[i % kPlaces.size()], bodies[i / kPerBuild],
                   kCandidates[i / kPlaces.size() % kCandidates.size()]);
  });
  std::vector<std::string> head{"", "candidates"};
  for (const Rule& rule : kRules) head.emplace_back(rule.name);
  Table sums(head);
  Table places(head);
  const auto row = [&all](Table& table, const std::string& name, const auto& counted) {
    Counts counts;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (counted(i)) counts.add(all[i]);
    }
    std::vector<std::string> cells{name};
    const auto more = counts.cells();
    cells.insert(cells.end(), more.begin(), more.end());
    table.add(cells);
  };
  const auto number_of = [](std::size_t i) { return i / kPlaces.size() % kCandidates.size(); };
  for (std::size_t n = 0; n < kCandidates.size(); ++n) {
    row(sums, fmt::format("{} asked for", kCandidates[n]),
        [&](std::size_t i) { return number_of(i) == n; });
  }
  for (std::size_t b = 0; b < kBuilds.size(); ++b) {
    row(sums, kBuilds[b].name, [&](std::size_t i) { return i / kPerBuild == b; });
  }
  for (std::size_t p = 0; p < kPlaces.size(); ++p) {
    row(places, kPlaces[p].name, [&](std::size_t i) { return i % kPlaces.size() == p; });
  }
  Table offers({"of goals below 0.50 m", "squat", "half squat", "stoop"});
  for (std::size_t n = 0; n < kCandidates.size(); ++n) {
    int queries = 0;
    std::array<int, 3> with{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (number_of(i) != n || all[i].place->at.y >= kLow) continue;
      ++queries;
      for (std::size_t s = 0; s < with.size(); ++s) with[s] += offers_style(all[i], s) ? 1 : 0;
    }
    std::vector<std::string> cells{fmt::format("{} asked for", kCandidates[n])};
    for (const int count : with) cells.push_back(fmt::format("{} of {}", count, queries));
    offers.add(cells);
  }
  Table styles({"goal", "of the 5 for `human`: words (knee, trunk, °)"});
  for (std::size_t p = 0; p < kPlaces.size(); ++p) {
    styles.add({kPlaces[p].name, listed(all[p])});
  }
  return fmt::format(
             "## Candidates\n\nWhether what is offered are styles that people use: {} goals for "
             "`human`, a woman of 1.62 m and people of 1.55 and 1.88 m, places by their stature; "
             "{} and {} candidates of the default preset. *First not as people*: the first for a "
             "goal below {:.2f} m is a full squat or a full stoop (an index below {:.0f} or above "
             "{:.0f}), or for one from {:.2f} m on bends a knee by more than {:.0f}° or the trunk "
             "by more than {:.0f}°. *Bent knees for a shelf*: by more than {:.0f}°, above {:.2f} "
             "m. *Folded on straight knees*: a trunk at {:.0f}° or more above knees below {:.0f}°. "
             "*Elbow inwards*: it points more to the other side than down. *Impossible beside "
             "possible*: nobody could, where the first can be done. *Words of a "
             "better one*: named as a better candidate is.\n\n",
             kPlaces.size(), kCandidates[0], kCandidates[1], kLow, kPureSquat, kPureStoop, kTable,
             degrees(kStraightKnee), degrees(kUpright), degrees(kStraightKnee), kAboveTheChest,
             degrees(kFolded), degrees(kStraightKnee)) +
         sums.text() + drawn_text(bodies.front()) + "\n" + offers.text() + "\n" + places.text() +
         "\n" + styles.text();
}

}  // namespace shigusa::bench
