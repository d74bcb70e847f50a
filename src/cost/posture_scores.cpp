// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/ergonomics.hpp>

#include "core/check.hpp"
#include "cost/posture_parts.hpp"

namespace shigusa {
namespace {

using Part = PosturePart;
using By = PostureMethod;

// Score of a part whose angle is greater than `over`, or than a threshold, in one direction. Of
// several bands the last one counts.
struct Band {
  PostureMethod method;
  PosturePart part;
  bool back;    // extension
  double over;  // rad
  double PostureThresholds::*threshold;
  int score;
};
constexpr double kAny = -1.0;
constexpr auto kUpright = &PostureThresholds::upright;
constexpr auto kExtends = &PostureThresholds::neck_extends;
constexpr auto kStraight = &PostureThresholds::straight_wrist;
// Sources: the papers named at PostureMethod, by their worksheets.
constexpr std::array kBands{
    Band{By::reba, Part::neck, false, radians(20), nullptr, 2},
    Band{By::reba, Part::neck, true, kAny, kExtends, 2},
    Band{By::reba, Part::trunk, false, kAny, kUpright, 2},
    Band{By::reba, Part::trunk, false, radians(20), nullptr, 3},
    Band{By::reba, Part::trunk, false, radians(60), nullptr, 4},
    Band{By::reba, Part::trunk, true, kAny, kUpright, 2},
    Band{By::reba, Part::trunk, true, radians(20), nullptr, 3},
    Band{By::reba, Part::upper_arm, false, radians(20), nullptr, 2},
    Band{By::reba, Part::upper_arm, false, radians(45), nullptr, 3},
    Band{By::reba, Part::upper_arm, false, radians(90), nullptr, 4},
    Band{By::reba, Part::upper_arm, true, radians(20), nullptr, 2},
    Band{By::reba, Part::wrist, false, radians(15), nullptr, 2},
    Band{By::reba, Part::wrist, true, radians(15), nullptr, 2},
    Band{By::rula, Part::neck, false, radians(10), nullptr, 2},
    Band{By::rula, Part::neck, false, radians(20), nullptr, 3},
    Band{By::rula, Part::neck, true, kAny, kExtends, 4},
    Band{By::rula, Part::trunk, false, kAny, kUpright, 2},
    Band{By::rula, Part::trunk, false, radians(20), nullptr, 3},
    Band{By::rula, Part::trunk, false, radians(60), nullptr, 4},
    Band{By::rula, Part::trunk, true, kAny, kUpright, 2},
    Band{By::rula, Part::upper_arm, false, radians(20), nullptr, 2},
    Band{By::rula, Part::upper_arm, false, radians(45), nullptr, 3},
    Band{By::rula, Part::upper_arm, false, radians(90), nullptr, 4},
    Band{By::rula, Part::upper_arm, true, radians(20), nullptr, 2},
    Band{By::rula, Part::wrist, false, kAny, kStraight, 2},
    Band{By::rula, Part::wrist, false, radians(15), nullptr, 3},
    Band{By::rula, Part::wrist, true, kAny, kStraight, 2},
    Band{By::rula, Part::wrist, true, radians(15), nullptr, 3},
};

// A table of one-digit scores, rows of the last key first, indexed from 1.
template <std::size_t keys>
struct Table {
  std::array<int, keys> sizes;
  std::string_view digits;  // hexadecimal, blanks count for nothing

  template <class... Key>
  [[nodiscard]] constexpr int at(Key... key) const {
    const std::array<int, keys> given{key...};
    int cell = 0;
    for (std::size_t k = 0; k < keys; ++k) cell = cell * sizes[k] + given[k] - 1;
    for (const char digit : digits) {
      if (digit == ' ' || cell-- > 0) continue;
      return digit <= '9' ? digit - '0' : digit - 'a' + 10;
    }
    return 0;
  }
  // Whether it has a digit for each cell.
  [[nodiscard]] constexpr bool whole() const {
    int cells = 1;
    for (const int size : sizes) cells *= size;
    for (const char digit : digits) cells -= digit != ' ' ? 1 : 0;
    return cells == 0;
  }
};

// neck, trunk, legs
constexpr Table<3> kRebaA{{3, 5, 4},
                          "1234 2345 2456 3567 4678  1234 3456 4567 5678 6789 "
                          "3356 4567 5678 6789 7899"};
// upper arm, lower arm, wrist
constexpr Table<3> kRebaB{{6, 2, 3}, "122 123  123 234  345 455  455 567  678 788  788 899"};
// score A, score B
constexpr Table<2> kRebaC{{12, 12},
                          "111233456777 122344566778 233345677888 344456788999 "
                          "444567889999 66678899aaaa 7778999aabbb 8889aaaaabbb "
                          "999aaabbbccc aaabbbbccccc bbbbcccccccc cccccccccccc"};
// upper arm, lower arm, wrist, twist of the wrist
constexpr Table<4> kRulaA{{6, 3, 4, 2},
                          "12222333 22223333 23333344  23333444 33333444 34444455 "
                          "33444455 34444455 44444555  44444555 44444555 44455566 "
                          "55555667 56666777 66677778  77777889 88888999 99999999"};
constexpr Table<4> kRulaOlderA{{6, 3, 4, 2},
                               "12222333 22223333 23233344  22233344 22233344 23333445 "
                               "23334455 23334455 23344455  34444455 34444455 34455566 "
                               "55555667 56666777 66677778  77777889 78888999 99999999"};
// neck, trunk, legs
constexpr Table<3> kRulaB{{6, 6, 2},
                          "132334556677 232345556777 333445566777 "
                          "555667777788 777778888888 888888899999"};
// score C, score D
constexpr Table<2> kRulaC{{8, 7},
                          "1233455 2234455 3334456 3334566 4445677 4456677 5566777 5567777"};
static_assert(kRebaA.whole() && kRebaB.whole() && kRebaC.whole() && kRulaA.whole() &&
              kRulaOlderA.whole() && kRulaB.whole() && kRulaC.whole());

// Greatest score of each level.
constexpr std::array kRebaEnds{1, 3, 7, 10};
constexpr std::array kRulaEnds{2, 4, 6};

template <std::size_t size>
int level_of(int score, const std::array<int, size>& ends) {
  int level = 0;
  for (const int end : ends) level += score > end ? 1 : 0;
  return level;
}

template <class Parts, std::size_t size>
void check(const Parts& parts, const std::array<SubScore<Parts>, size>& ranges) {
  for (const auto& [name, part, least, most] : ranges) {
    const int given = parts.*part;
    SHG_CHECK(
        given >= least && given <= most,
        fmt::format("the sub-score of {} is {} to {}; {} is given", name, least, most, given));
  }
}

}  // namespace

int base_score(PostureMethod method, PosturePart part, double angle,
               const PostureThresholds& thresholds) {
  if (part == Part::lower_arm) return angle >= radians(60) && angle <= radians(100) ? 1 : 2;
  int score = 1;
  for (const Band& band : kBands) {
    if (band.method != method || band.part != part || band.back != (angle < 0.0)) continue;
    const double over = band.threshold == nullptr ? band.over : thresholds.*band.threshold;
    if (abs(angle) > over) score = std::max(score, band.score);
  }
  return score;
}

RebaScore reba_score(const RebaParts& parts) {
  check(parts, kRebaParts);
  RebaScore score{parts};
  score.table_a = kRebaA.at(std::min(parts.neck, 3), parts.trunk, parts.legs);
  score.score_a = score.table_a + parts.load;
  score.table_b = kRebaB.at(parts.upper_arm, parts.lower_arm, parts.wrist);
  score.score_b = score.table_b + parts.coupling;
  score.table_c = kRebaC.at(score.score_a, score.score_b);
  score.score = score.table_c + parts.activity;
  score.level = level_of(score.score, kRebaEnds);
  return score;
}

RulaScore rula_score(const RulaParts& parts, RulaEdition edition) {
  check(parts, kRulaParts);
  const Table<4>& table = edition == RulaEdition::present ? kRulaA : kRulaOlderA;
  const int added = parts.muscle + parts.force;
  RulaScore score{parts};
  score.table_a = table.at(parts.upper_arm, parts.lower_arm, parts.wrist, parts.wrist_twist);
  score.score_c = score.table_a + added;
  score.table_b = kRulaB.at(parts.neck, parts.trunk, parts.legs);
  score.score_d = score.table_b + added;
  score.score = kRulaC.at(std::min(score.score_c, 8), std::min(score.score_d, 7));
  score.level = 1 + level_of(score.score, kRulaEnds);
  return score;
}

}  // namespace shigusa
