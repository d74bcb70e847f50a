// SPDX-License-Identifier: MIT
#include "rules.hpp"

#include <array>
#include <initializer_list>
#include <utility>

namespace shigusa::bench {
namespace {

using MaybeBand = std::optional<Band>;

// Linear interpolation at x between points of ascending x, constant outside.
double on_line(double x, std::initializer_list<std::pair<double, double>> points) {
  const auto* before = points.begin();
  if (x <= before->first) return before->second;
  for (const auto* p = before + 1; p != points.end(); before = p++) {
    if (x > p->first) continue;
    const double share = (x - before->first) / (p->first - before->first);
    return before->second + share * (p->second - before->second);
  }
  return before->second;
}

bool in_front(const Case& c) { return c.aside > -0.1 && c.aside < 0.4 && c.ahead > 0.15; }
bool is_low(const Case& c) { return in_front(c) && c.height < 0.45 && !c.straight; }
bool is_bend(const Case& c) { return in_front(c) && c.height < 0.95 && !c.straight; }
bool is_shelf(const Case& c) {
  return in_front(c) && c.height > 1.2 && c.height < 1.85 && c.ahead > 0.45 && c.ahead < 0.78;
}

// Range from people who pick up from the floor to people who stand before a table.
MaybeBand trunk(const Case& c) {
  if (is_shelf(c)) return Band{0.0, 18.0};
  if (!is_bend(c)) return {};
  return Band{on_line(c.height, {{0.15, 55.0}, {0.40, 25.0}, {0.95, 0.0}}),
              on_line(c.height, {{0.15, 92.0}, {0.40, 75.0}, {0.95, 25.0}})};
}
MaybeBand knee(const Case& c) {
  if (!is_bend(c)) return {};
  return Band{on_line(c.height, {{0.15, 45.0}, {0.40, 22.0}, {0.80, 0.0}}),
              on_line(c.height, {{0.15, 125.0}, {0.40, 90.0}, {0.95, 25.0}})};
}
MaybeBand knees_stay(const Case& c) { return is_shelf(c) ? MaybeBand({-8.0, 8.0}) : MaybeBand(); }
MaybeBand shank(const Case& c) { return is_low(c) ? MaybeBand({-3.0, 33.0}) : MaybeBand(); }
MaybeBand drop(const Case& c) {
  if (!is_bend(c)) return {};
  return Band{on_line(c.height, {{0.15, 0.08}, {0.40, 0.02}, {0.95, 0.0}}),
              on_line(c.height, {{0.15, 0.45}, {0.40, 0.35}, {0.95, 0.06}})};
}
MaybeBand back(const Case& c) { return is_low(c) ? MaybeBand({0.02, 0.22}) : MaybeBand(); }
MaybeBand hips_stay(const Case& c) { return is_shelf(c) ? MaybeBand({0.0, 0.04}) : MaybeBand(); }
MaybeBand mass(const Case& c) {
  if (!is_low(c)) return {};
  return Band{on_line(c.ahead, {{0.25, 0.10}, {0.35, 0.17}, {0.62, 0.40}}),
              on_line(c.ahead, {{0.25, 0.45}, {0.62, 0.80}})};
}
MaybeBand bow(const Case& c) {
  if (!in_front(c) || c.straight || c.height > 1.87) return {};
  return Band{on_line(c.rise, {{-0.5, 0.05}, {0.5, -0.12}}),
              on_line(c.rise, {{-0.5, 0.17}, {0.5, 0.0}})};
}
MaybeBand peak(const Case& c) {
  return Band{on_line(c.rise, {{-0.5, 0.41}, {0.5, 0.30}}),
              on_line(c.rise, {{-0.5, 0.61}, {0.5, 0.48}})};
}
MaybeBand shoulder(const Case& c) {
  if (c.arm <= 0.0) return {};
  return Band{on_line(c.arm, {{0.85, -0.13}, {1.0, 0.02}, {1.15, 0.06}}),
              on_line(c.arm, {{0.70, 0.08}, {0.85, 0.12}, {1.0, 0.25}, {1.15, 0.40}})};
}
MaybeBand style(const Case& c) {
  return is_low(c) && c.height < 0.33 ? MaybeBand({18.0, 92.0}) : MaybeBand();
}
MaybeBand first(const Case& c) {
  return is_low(c) && c.ahead > 0.3 ? MaybeBand({0.85, 0.98}) : MaybeBand();
}
MaybeBand lumbar_share(const Case& c) {
  if (c.straight) return Band{0.30, 0.45};
  return is_low(c) ? MaybeBand({0.15, 0.50}) : MaybeBand();
}
MaybeBand lumbar_lead(const Case& c) { return c.straight ? MaybeBand({0.1, 9.0}) : MaybeBand(); }
MaybeBand head(const Case& c) {
  return is_low(c) && c.height > 0.08 ? MaybeBand({0.0, 1.0}) : MaybeBand();
}
MaybeBand free_elbow(const Case& c) {
  return is_low(c) && !c.both && c.height < 0.33 ? MaybeBand({20.0, 100.0}) : MaybeBand();
}
MaybeBand clavicle(const Case& c) {
  return c.height > 1.87 && in_front(c) ? MaybeBand({0.15, 0.40}) : MaybeBand();
}
MaybeBand jolt(const Case&) { return Band{0.0, 1.0}; }
MaybeBand hard(const Case&) { return Band{0.0, 1.0}; }

// A figure with people's band, and its spread between people.
struct BandRule {
  const char* name;
  const char* source;
  double Figures::*figure;
  double unit;
  MaybeBand (*band)(const Case&);
};
constexpr std::array kBands{
    BandRule{"trunk", "A1 A2 B11", &Figures::trunk, 7.0, trunk},
    BandRule{"knee", "A1 B11", &Figures::knee, 8.0, knee},
    BandRule{"knees stay, shelf", "A2", &Figures::knee_change, 8.0, knees_stay},
    BandRule{"shank", "A1 box", &Figures::shank, 4.0, shank},
    BandRule{"hips lower", "A1 box", &Figures::drop, 0.06, drop},
    BandRule{"hips back", "A1 B2", &Figures::back, 0.03, back},
    BandRule{"hips stay, shelf", "A2", &Figures::travel, 0.03, hips_stay},
    BandRule{"mass ahead", "B1 B3", &Figures::mass, 0.10, mass},
    BandRule{"bow", "B38 A2", &Figures::bow, 0.04, bow},
    BandRule{"peak", "B13 B38", &Figures::peak, 0.05, peak},
    BandRule{"shoulder's share", "B21 B22", &Figures::shoulder, 0.05, shoulder},
    BandRule{"style", "B11 B17", &Figures::style, 6.0, style},
    BandRule{"first component", "B4 B5", &Figures::first, 0.02, first},
    BandRule{"lumbar share", "B7", &Figures::lumbar_share, 0.05, lumbar_share},
    BandRule{"lumbar leads", "B8", &Figures::lumbar_lead, 0.3, lumbar_lead},
    BandRule{"head", "A1", &Figures::head, 0.05, head},
    BandRule{"free elbow", "A1", &Figures::free_elbow, 14.0, free_elbow},
    BandRule{"clavicle", "B28 B29", &Figures::clavicle, 0.08, clavicle},
    BandRule{"jolts", "smooth", &Figures::jolt, 0.5, jolt},
    BandRule{"possible", "possible", &Figures::hard, 0.5, hard},
};

using Line = std::span<const Figures>;

// Greatest shortfall of a figure's decrease, which should be at least `least` from each case to the
// next.
double fails_to_fall(Line line, double Figures::*figure, double least) {
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    worst = max(worst, line[i + 1].*figure - line[i].*figure + least);
  }
  return worst;
}
double fails_to_rise(Line line, double Figures::*figure, double least) {
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    worst = max(worst, line[i].*figure - line[i + 1].*figure + least);
  }
  return worst;
}
double index_spread(Line line) {
  const Line low = line.first(line.size() - 1);
  double mean = 0.0;
  double square = 0.0;
  for (const Figures& f : low) mean += f.index / double(low.size());
  for (const Figures& f : low) square += (f.index - mean) * (f.index - mean) / double(low.size());
  return max(sqrt(square) / max(mean, 0.05) - 0.12, 0.0);
}
double nearest_leans(Line line) {
  const double more = line[0].trunk - line[1].trunk;
  return max(max(3.0 - more, more - 17.0), max(abs(line[1].trunk - line[2].trunk) - 4.0, 0.0));
}
double men_round_more(Line line) {
  const auto ratio = [](const Figures& f) { return f.lumbar / max(f.hip, 1.0); };
  return max(0.1 - (ratio(line[0]) - ratio(line[1])), 0.0);
}

// Order of people's figures between the cases of a series.
struct OrderRule {
  const char* name;
  const char* source;
  Series series;
  double unit;
  double (*broken)(Line);
};
constexpr std::array kOrders{
    OrderRule{"trunk falls with height", "B11", Series::heights, 7.0,
              [](Line l) { return fails_to_fall(l, &Figures::trunk, -2.0); }},
    OrderRule{"knee falls with height", "B11", Series::heights, 8.0,
              [](Line l) { return fails_to_fall(l, &Figures::knee, -3.0); }},
    OrderRule{"index is constant", "B15", Series::heights, 0.05, index_spread},
    OrderRule{"style rises with height", "B11", Series::heights, 6.0,
              [](Line l) { return fails_to_rise(l.first(4), &Figures::style, -5.0); }},
    OrderRule{"knee rises with distance", "B12", Series::near_and_far, 8.0,
              [](Line l) {
                return max(fails_to_rise(l.first(2), &Figures::knee, 4.0),
                           fails_to_rise(l.last(2), &Figures::knee, -3.0));
              }},
    OrderRule{"shank rises with distance", "B12", Series::near_and_far, 4.0,
              [](Line l) {
                return max(fails_to_rise(l.first(2), &Figures::shank, 2.0),
                           fails_to_rise(l.last(2), &Figures::shank, -2.0));
              }},
    OrderRule{"trunk leans most when near", "B12", Series::near_and_far, 7.0, nearest_leans},
    OrderRule{"mass rises with distance", "B1 B3", Series::distances, 0.10,
              [](Line l) { return fails_to_rise(l, &Figures::mass, 0.03); }},
    OrderRule{"hips back falls with distance", "B2", Series::distances, 0.03,
              [](Line l) { return fails_to_fall(l, &Figures::back, 0.01); }},
    OrderRule{"shoulder joins beyond the arm", "B21", Series::arms, 0.05,
              [](Line l) { return fails_to_rise(l.last(2), &Figures::shoulder, 0.02); }},
    OrderRule{"men round more", "B6", Series::sexes, 0.3, men_round_more},
};

constexpr std::size_t kRecorded = kBands.size() + kOrders.size();

}  // namespace

const std::vector<RuleName>& rule_names() {
  static const std::vector<RuleName> kNames = [] {
    std::vector<RuleName> names;
    for (const BandRule& rule : kBands) names.push_back({rule.name, rule.source});
    for (const OrderRule& rule : kOrders) names.push_back({rule.name, rule.source});
    names.push_back({"recorded reaches", "reaches.tsv, CMU 02_06"});
    return names;
  }();
  return kNames;
}

std::vector<Term> terms_of(const Unit& unit, std::span<const Figures> figures) {
  std::vector<Term> terms;
  for (std::size_t i = 0; i < unit.cases.size(); ++i) {
    const Case& c = unit.cases[i];
    const Figures& f = figures[i];
    for (std::size_t r = 0; r < kBands.size(); ++r) {
      const BandRule& rule = kBands[r];
      const bool always = rule.figure == &Figures::hard || rule.figure == &Figures::jolt;
      const MaybeBand band = rule.band(c);
      if (!band || (!c.recorded.empty() && !always)) continue;
      const double value = f.*rule.figure;
      terms.push_back(
          {r, value, max(max(band->low - value, value - band->high), 0.0) / rule.unit, i});
    }
    for (const Known& known : c.recorded) {
      const double apart = abs(f.*known.figure - known.value) / known.unit;
      terms.push_back({kRecorded, apart, max(apart - 1.0, 0.0), i});
    }
  }
  for (std::size_t r = 0; r < kOrders.size(); ++r) {
    if (kOrders[r].series != unit.series) continue;
    const double broken = max(kOrders[r].broken(figures), 0.0);
    terms.push_back({kBands.size() + r, broken, broken / kOrders[r].unit});
  }
  return terms;
}

double loss_of(const Term& term) {
  const double square = term.off * term.off;
  return square / (1.0 + square);
}

}  // namespace shigusa::bench
