// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "../experiments/report.hpp"

namespace shigusa::bench {
namespace {

using Of = std::function<double(const Compared&)>;

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double middle(const std::vector<Compared>& compared, const Of& value) {
  std::vector<double> values;
  for (const Compared& c : compared) values.push_back(value(c));
  return middle(std::move(values));
}

std::string cm(double metres) { return fmt::format("{:.1f}", 100.0 * metres); }
std::string deg(double angle) { return fmt::format("{:.1f}", degrees(angle)); }

constexpr std::array kApart{"final place, cm", "nine angles, °", "with a rigid trunk, °",
                            "all angles, °"};

std::vector<std::string> cells_of(const Apart& off) {
  return {cm(off.final_place), deg(off.nine), deg(off.paper_angles), deg(off.all)};
}

// A row of medians.
std::vector<std::string> apart_row(std::vector<std::string> row,
                                   const std::vector<const Compared*>& of,
                                   const std::function<const Apart&(const Compared&)>& apart) {
  const auto middle_of = [&](double Apart::*member) {
    std::vector<double> values;
    for (const Compared* c : of) values.push_back(apart(*c).*member);
    return middle(std::move(values));
  };
  for (const std::string& cell :
       cells_of({middle_of(&Apart::final_place), middle_of(&Apart::nine),
                 middle_of(&Apart::paper_angles), middle_of(&Apart::all)})) {
    row.push_back(cell);
  }
  return row;
}

std::vector<const Compared*> those(const std::vector<Compared>& compared,
                                   const std::function<bool(const Compared&)>& wanted) {
  std::vector<const Compared*> result;
  for (const Compared& c : compared) {
    if (wanted(c)) result.push_back(&c);
  }
  return result;
}

std::string distances(const std::vector<Compared>& compared) {
  std::vector<std::string> head{"motion"};
  head.insert(head.end(), kApart.begin(), kApart.end());
  Table table(head);
  const auto all = those(compared, [](const Compared&) { return true; });
  for (std::size_t w = 0; w < compared.front().chosen.size(); ++w) {
    table.add(apart_row({compared.front().chosen[w].way}, all,
                        [w](const Compared& c) -> const Apart& { return c.chosen[w].apart; }));
  }
  const auto others =
      those(compared, [](const Compared& c) { return c.nearest_other.has_value(); });
  if (!others.empty()) {
    table.add(apart_row({"his own nearest other reach"}, others,
                        [](const Compared& c) -> const Apart& { return *c.nearest_other; }));
  }
  table.add({"*prototype, criteria-chosen*", "12.8", "–", "18.8", "–"});
  table.add({"*prototype, uniform weights*", "36", "–", "37", "–"});
  table.add({"*prototype, his own nearest other*", "9.2", "–", "11.7", "–"});
  return table.text();
}

std::string fits(const std::vector<Compared>& compared) {
  std::vector<std::string> head{"fitted to the record", "parameters"};
  head.insert(head.end(), kApart.begin(), kApart.end());
  Table table(head);
  const std::vector<FitKind> kinds = fit_kinds();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto met =
        those(compared, [k](const Compared& c) { return !c.fitted[k].clip.angles.empty(); });
    if (met.empty()) {
      table.add({kinds[k].name, "–", "none arrives", "–", "–", "–"});
      continue;
    }
    std::string name = kinds[k].name;
    if (met.size() < compared.size()) {
      name += fmt::format(" ({} of {} arrive)", met.size(), compared.size());
    }
    table.add(apart_row({name, std::to_string(met.front()->fitted[k].parameters)}, met,
                        [k](const Compared& c) -> const Apart& { return c.fitted_apart[k]; }));
  }
  table.add({"*prototype: weights, straight path*", "9", "15.1", "–", "15.9", "–"});
  table.add({"*prototype: with references and a delay*", "13", "9.1", "–", "8.1", "–"});
  table.add({"*prototype: in two phases*", "21", "5.9", "–", "7.1", "–"});
  return table.text();
}

std::string looks(const std::vector<Compared>& compared) {
  Table table({"motion", "trunk, °", "knee, °", "pelvis drop, cm", "pelvis back, cm",
               "path / distance", "bow forwards, cm", "peak speed, m/s", "at"});
  const auto row = [&](const std::string& name,
                       const std::function<const Track&(const Compared&)>& track) {
    const auto of = [&](double Looks::*member) {
      return middle(compared, [&](const Compared& c) { return looks_of(track(c)).*member; });
    };
    table.add({name, fmt::format("{:.0f}", degrees(of(&Looks::trunk))),
               fmt::format("{:.0f}", degrees(of(&Looks::knee))), cm(of(&Looks::drop)),
               cm(of(&Looks::back)), fmt::format("{:.2f}", of(&Looks::path_ratio)),
               cm(of(&Looks::bow)), fmt::format("{:.2f}", of(&Looks::peak_speed)),
               fmt::format("{:.2f}", of(&Looks::peak_time))});
  };
  row("**recorded**", [](const Compared& c) -> const Track& { return c.reach.track; });
  for (std::size_t w = 0; w < compared.front().chosen.size(); ++w) {
    row(compared.front().chosen[w].way,
        [w](const Compared& c) -> const Track& { return c.chosen[w].track; });
  }
  return table.text();
}

// The criteria's scores of his motion and of the motion that they chose.
std::string criteria(const std::vector<Compared>& compared) {
  std::vector<std::string> head{"motion", "score"};
  std::vector<std::string> his{"recorded"};
  std::vector<std::string> chosen{"best-scored"};
  const auto total = [](const std::vector<ScoreTerm>& terms) {
    double sum = 0.0;
    for (const ScoreTerm& term : terms) sum += term.weight * term.penalty;
    return sum;
  };
  const auto best = [](const Compared& c) -> const std::vector<ScoreTerm>& {
    for (const Chosen& each : c.chosen) {
      if (each.way.starts_with("best-scored")) return each.criteria;
    }
    return c.recorded_score.terms;
  };
  his.push_back(fmt::format("{:.3f}", middle(compared, [&](const Compared& c) {
                              return total(c.recorded_score.terms);
                            })));
  chosen.push_back(
      fmt::format("{:.3f}", middle(compared, [&](const Compared& c) { return total(best(c)); })));
  for (std::size_t t = 0; t < compared.front().recorded_score.terms.size(); ++t) {
    head.push_back(compared.front().recorded_score.terms[t].name);
    his.push_back(fmt::format("{:.3f}", middle(compared, [&](const Compared& c) {
                                return c.recorded_score.terms[t].penalty;
                              })));
    chosen.push_back(fmt::format(
        "{:.3f}", middle(compared, [&](const Compared& c) { return best(c)[t].penalty; })));
  }
  Table table(head);
  table.add(his);
  table.add(chosen);
  return table.text();
}

std::string each_reach(const std::vector<Compared>& compared) {
  std::string text;
  for (const Compared& c : compared) {
    const std::string& name = c.reach.segment.name;
    text += fmt::format(
        "\n### {}\n\nFrames {} to {}, {:.2f} s; shigusa would take {:.2f} s by itself. {} "
        "candidates. His body of {} freedoms follows him within {:.1f} cm on average, that of {} "
        "within {:.1f} cm.\n\n",
        name, c.reach.segment.first, c.reach.segment.last, c.reach.track.duration(), c.own_duration,
        c.candidates, c.reach.posed.body.dof_count(), 100.0 * c.reach.fit_mean,
        c.reach.paper.body.dof_count(), 100.0 * c.reach.paper_fit_mean);
    std::vector<std::string> head{"motion"};
    head.insert(head.end(), kApart.begin(), kApart.end());
    head.insert(head.end(), {"trunk, °", "knee, °", "path / distance", "bow forwards, cm"});
    Table table(head);
    const auto row = [&](const std::string& way, const Track& track, const Apart* off) {
      std::vector<std::string> cells{way};
      const auto distance =
          off != nullptr ? cells_of(*off) : std::vector<std::string>(kApart.size(), "–");
      cells.insert(cells.end(), distance.begin(), distance.end());
      const Looks l = looks_of(track);
      for (const double angle : {l.trunk, l.knee}) {
        cells.push_back(fmt::format("{:.0f}", degrees(angle)));
      }
      cells.push_back(fmt::format("{:.2f}", l.path_ratio));
      cells.push_back(cm(l.bow));
      table.add(cells);
    };
    row("recorded", c.reach.track, nullptr);
    for (const Chosen& each : c.chosen) row(each.way, each.track, &each.apart);
    text += table.text();
    text += fmt::format(
        "\n![{}: recorded, best-scored, nearest, and fitted](images/people/{}.svg)\n", name, name);
  }
  return text;
}

}  // namespace

std::string people_page(const std::vector<Compared>& compared) {
  std::string page =
      "# Beside a real person\n\nThis page is written by `scripts/make_people`; change "
      "`research/people`, not the page.\n\nA recorded man (`../shared/reach`, from the CMU motion "
      "capture database) bends to the floor. For each of these reaches shigusa is told his "
      "skeleton, the posture that he starts from, where his right hand ends and how long he takes, "
      "and nothing else: the preset `flat` with 8 candidates on his body of the extent `human`. No "
      "weight was tuned on these numbers: they are one man on one day, and say where criteria and "
      "parameters are wrong. After him come published regularities, other recorded persons, and "
      "how evenly and smoothly random tasks are met.\n\n";
  page += fmt::format(
      "*Final place* is the mean distance of right shoulder, elbow, hip and knee at the end, from "
      "his joints as recorded. *Nine angles* are the right side's nine freedoms of the paper's "
      "table 1: the root mean square over time of what each is off by, averaged over the nine; "
      "*all angles* that of all freedoms of his body. *With a rigid trunk*: both motions are "
      "fitted, frame by frame, by a body whose trunk has no joints, as the prototype's had none, "
      "and its nine compared. "
      "Medians over {} reaches. *Nearest of 8* is the candidate whose final place is nearest, "
      "which "
      "nobody knows beforehand. Rows in italics are the throw-away prototype's, for ten reaches of "
      "which these are six.\n\n",
      compared.size());
  page += distances(compared);
  page +=
      "\n## What he does and what is made\n\nMedians. The trunk is the line from hips to "
      "shoulders at the end, against the vertical; the bow is how far in front of its straight "
      "way the hand is where it is farthest from that; \"at\" is the share of the duration at "
      "which "
      "the hand is fastest.\n\n";
  page += looks(compared);
  page += fmt::format("\nHe takes {:.2f} s, shigusa would take {:.2f} s by itself.\n",
                      middle(compared, [](const Compared& c) { return c.reach.track.duration(); }),
                      middle(compared, [](const Compared& c) { return c.own_duration; }));
  page +=
      "\n## What the criteria say of him\n\nPenalties of the recorded motion (`shigusa score`, "
      "smoothed at 6 Hz) beside those of the best-scored candidates; medians.\n\n";
  page += criteria(compared);
  page +=
      "\n## What the parameters can express\n\nThe preset's parameters searched for the record "
      "itself: the difference of angles is the score. They have seen what they are compared "
      "with, so this is no forecast, but the least that these parameters leave.\n\n";
  page += fits(compared);
  return page;
}

std::string reaches_section(const std::vector<Compared>& compared) {
  return "## Reach by reach\n\nThe recorded man's.\n" + each_reach(compared);
}

}  // namespace shigusa::bench
