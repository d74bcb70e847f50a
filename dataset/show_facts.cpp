// SPDX-License-Identifier: MIT
#include "show_facts.hpp"

#include <cmath>
#include <numeric>

#include "core/hash.hpp"

namespace shigusa {
namespace {

// Largest number of marks in a plot: more would only overlap.
constexpr std::size_t kMarks = 1200;
// Random streams of the tickets.
constexpr std::uint64_t kGoalTickets = 0x676F616C;
constexpr std::uint64_t kMotionTickets = 0x6D6F7665;

std::uint64_t ticket(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  return Random(seed ^ stream, number).next();
}

// Data of a shard's tasks.
void add_tasks(const DataFolder& data, const ShardRows& rows, ShowFacts& facts) {
  const Table& goals = *std::next(rows.tables.begin());
  std::map<std::uint64_t, Outcome> outcomes;
  for (std::size_t at = 0; at < rows.tasks->rows(); ++at) {
    const Row task{rows.tasks, at};
    const std::uint64_t status = std::min<std::uint64_t>(task.whole("status"), kOutcomes - 1);
    const auto outcome = static_cast<Outcome>(status);
    ++facts.tasks[status];
    outcomes[task.whole("task")] = outcome;
    if (outcome == Outcome::refused) continue;
    const std::string who = task.text("character");
    ++facts.characters[who];
    Fnv1a body;
    body.add(who);
    body.add(task.whole("sex"));
    body.add(task.number("stature_m"));
    body.add(task.number("mass_kg"));
    if (facts.bodies.size() < kDifferentMost) facts.bodies.insert(body.value());
    const std::uint64_t own = data.plan.people() > 0 ? task.whole("person") : task.whole("task");
    facts.people.add(
        ticket(data.plan.seed(), kGoalTickets, own),
        {task.number("stature_m"), task.number("mass_kg"), task.text("sex") == "female"});
  }
  for (std::size_t at = 0; at < goals.rows(); ++at) {
    const Row goal{&goals, at};
    const std::uint64_t number = goal.whole("task");
    const Vec3d place = goal.point("position_m");
    if (!is_finite(place.x + place.y + place.z)) continue;
    facts.goals.add(ticket(data.plan.seed(), kGoalTickets, 64 * number + at % 64),
                    {place, outcomes[number]});
  }
}

// Counts the style of a task's best motion in the cell of its first goal.
void add_style(const DataMotion& motion, ShowFacts& facts) {
  const auto outcome = static_cast<Outcome>(motion.task.whole("status"));
  if (motion.goals.empty() || outcome > Outcome::unsteady) return;
  const Vec3d place = motion.goals.front().point("position_m");
  const double away = sqrt(place.x * place.x + place.z * place.z);
  const std::pair cell{static_cast<int>(std::floor(place.y / kCellHeight)),
                       static_cast<int>(std::floor(away / kCellAway))};
  ++facts.styles[cell][words_for(motion.ends()).front()];
}

void add_motions(const DataFolder& data, const ShardRows& rows, std::size_t most,
                 ShowFacts& facts) {
  const DataMotion* before = nullptr;
  for (const DataMotion& motion : rows.motions) {
    const std::uint64_t verdict =
        std::min<std::uint64_t>(motion.motion.whole("verdict"), kVerdicts - 1);
    ++facts.motions[verdict];
    facts.seconds += motion.motion.number("duration_s");
    facts.scores.add(motion.motion.number("score"), verdict);
    if (before == nullptr || before->number() != motion.number()) add_style(motion, facts);
    before = &motion;
    const std::uint64_t number = 256 * motion.number() + motion.rank();
    const auto end =
        facts.ends.try_emplace(motion.motion.text("words"), Lottery<ChosenMotion>(most)).first;
    end->second.add(ticket(data.plan.seed(), kMotionTickets, number),
                    {rows.head.shard, motion.number(), motion.rank()});
  }
}

}  // namespace

void ScoreCounts::add(double score, std::size_t verdict) {
  if (!is_finite(score)) return;
  const double bin = clamp(std::floor(score / kStep), 0.0, static_cast<double>(kBins - 1));
  ++bins[verdict][static_cast<std::size_t>(bin)];
}

std::uint64_t ShowFacts::task_count() const {
  return std::accumulate(tasks.begin(), tasks.end(), std::uint64_t{0});
}
std::uint64_t ShowFacts::motion_count() const {
  return std::accumulate(motions.begin(), motions.end(), std::uint64_t{0});
}

Result<ShowFacts> gather_facts(const DataFolder& data, const ShowSettings& settings) {
  ShowFacts facts{.goals = Lottery<GoalMark>(kMarks), .people = Lottery<PersonMark>(kMarks)};
  for (const std::uint64_t shard : data.shards) {
    if (settings.cancel != nullptr && settings.cancel->load()) {
      return fail(ErrorCode::cancelled, "was stopped before all shards were read",
                  data.folder.string());
    }
    std::error_code unknown;
    const std::uintmax_t size =
        std::filesystem::file_size(data.folder / shard_name(shard), unknown);
    facts.bytes += unknown ? 0 : size;
    SHG_TRY_ASSIGN(const ShardRows rows, read_rows(data, shard, {}));
    add_tasks(data, rows, facts);
    add_motions(data, rows, settings.motions, facts);
  }
  return facts;
}

std::vector<ChosenMotion> spread(const ShowFacts& facts, std::size_t most) {
  std::vector<std::vector<ChosenMotion>> ends;
  for (const auto& [words, lottery] : facts.ends) ends.push_back(lottery.drawn());
  // one of each outcome, then a second of each, until there are enough
  std::vector<std::size_t> taken(ends.size(), 0);
  std::size_t count = 0;
  for (bool more = true; more && count < most;) {
    more = false;
    for (std::size_t e = 0; e < ends.size() && count < most; ++e) {
      if (taken[e] >= ends[e].size()) continue;
      ++taken[e];
      ++count;
      more = true;
    }
  }
  std::vector<ChosenMotion> chosen;
  for (std::size_t e = 0; e < ends.size(); ++e) {
    chosen.insert(chosen.end(), ends[e].begin(),
                  ends[e].begin() + static_cast<std::ptrdiff_t>(taken[e]));
  }
  return chosen;
}

}  // namespace shigusa
