// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <shigusa/dataset_show.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <utility>
#include <vector>

#include "data_rows.hpp"

namespace shigusa {

// Random sample of a stream: the items with the lowest tickets, in any order of arrival.
template <class T>
class Lottery {
 public:
  explicit Lottery(std::size_t most = 0) : most_(most) {}

  void add(std::uint64_t ticket, T value) {
    ++seen_;
    if (most_ == 0 || (kept_.size() == most_ && ticket >= kept_.front().first)) return;
    if (kept_.size() == most_) {
      std::pop_heap(kept_.begin(), kept_.end(), earlier);
      kept_.pop_back();
    }
    kept_.emplace_back(ticket, std::move(value));
    std::push_heap(kept_.begin(), kept_.end(), earlier);
  }
  [[nodiscard]] std::uint64_t seen() const { return seen_; }
  // The kept items, by ticket.
  [[nodiscard]] std::vector<T> drawn() const {
    std::vector<std::pair<std::uint64_t, T>> sorted = kept_;
    std::sort(sorted.begin(), sorted.end(), earlier);
    std::vector<T> values;
    for (auto& [ticket, value] : sorted) values.push_back(std::move(value));
    return values;
  }

 private:
  static bool earlier(const std::pair<std::uint64_t, T>& a, const std::pair<std::uint64_t, T>& b) {
    return a.first < b.first;
  }
  std::size_t most_;
  std::uint64_t seen_ = 0;
  std::vector<std::pair<std::uint64_t, T>> kept_;  // a heap, the highest ticket first
};

// Outcome of a task, in the order of the column `status`.
enum class Outcome { reached, unsteady, unreachable, refused };
inline constexpr std::size_t kOutcomes = 4;
inline constexpr std::size_t kVerdicts = 3;

struct GoalMark {
  Vec3d place;
  Outcome outcome = Outcome::reached;
};
struct PersonMark {
  double stature = 0.0;  // m
  double mass = 0.0;     // kg
  bool female = false;
};
// A motion of the contact sheet.
struct ChosenMotion {
  std::uint64_t shard = 0;
  std::uint64_t task = 0;
  std::uint64_t rank = 0;
};

// Numbers of motions by score and verdict.
struct ScoreCounts {
  static constexpr double kStep = 0.01;
  static constexpr std::size_t kBins = 2000;  // the last one has all that is more
  std::array<std::vector<std::uint64_t>, kVerdicts> bins;

  ScoreCounts() { bins.fill(std::vector<std::uint64_t>(kBins, 0)); }
  void add(double score, std::size_t verdict);
};

// Styles of the best motions to goals in one cell of height and distance.
inline constexpr double kCellHeight = 0.25;  // m
inline constexpr double kCellAway = 0.1;     // m
using StyleCells = std::map<std::pair<int, int>, std::map<PostureWord, std::uint64_t>>;

// Limit up to which distinct bodies are counted.
inline constexpr std::size_t kDifferentMost = 100'000;

// Data of the page, except for the drawn motions.
struct ShowFacts {
  std::array<std::uint64_t, kOutcomes> tasks{};    // by outcome
  std::array<std::uint64_t, kVerdicts> motions{};  // by verdict
  double seconds = 0.0;                            // of all motions
  std::uint64_t bytes = 0;                         // of the shards
  std::map<std::string, std::uint64_t> characters{};
  // hashes of distinct bodies, at most kDifferentMost
  std::set<std::uint64_t> bodies{};
  Lottery<GoalMark> goals;
  Lottery<PersonMark> people;
  ScoreCounts scores{};
  StyleCells styles{};
  // by the words of their ends
  std::map<std::string, Lottery<ChosenMotion>> ends{};

  [[nodiscard]] std::uint64_t task_count() const;
  [[nodiscard]] std::uint64_t motion_count() const;
};

// Reads all shards, one after the other.
[[nodiscard]] Result<ShowFacts> gather_facts(const DataFolder& data, const ShowSettings& settings);

// A number of motions, spread over the ends: by style, then by task.
[[nodiscard]] std::vector<ChosenMotion> spread(const ShowFacts& facts, std::size_t most);

}  // namespace shigusa
