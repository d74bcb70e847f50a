// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <mutex>
#include <shigusa/cost.hpp>
#include <shigusa/explore.hpp>
#include <shigusa/kinematics.hpp>
#include <thread>
#include <tuple>
#include <utility>

#include "core/index.hpp"
#include "core/say.hpp"
#include "problem/task_goals.hpp"
#include "problem/task_search.hpp"

namespace shigusa {
namespace {

constexpr double kBoxLimbs = 1.6;       // lengths of the limb to each side
constexpr double kGrain = 1e6;          // positions are whole micrometres
constexpr int kCoarsest = 8;            // spacings between the places that are searched first
constexpr std::size_t kMostStarts = 4;  // motions of neighbours that a search starts from
// A motion played at a neighbour is good up to this share of its score there, and that more.
constexpr double kGoodShare = 1.2;
constexpr double kGoodScore = 0.05;
constexpr int kPlayedStride = 2;  // grids up to this one are played before they are searched
// Motions of a search: of the coarsest grid, and of finer ones.
constexpr int kCoarseMotions = 432;
constexpr int kFineMotions = 128;
// A motion that strains is searched anew, this much slower.
constexpr double kSlower = 1.15;

double in_grains(double x) { return nearest_integer(kGrain * x) / kGrain; }

// A place of the grid, by its numbers along the axes.
using Cell = std::array<int, 3>;

using Places = std::vector<std::size_t>;

// Order of motions: possible ones first, then by ascending score.
std::pair<int, double> rank_of(const MapPlace& place) {
  return {place.verdict ? static_cast<int>(*place.verdict) : 3, place.score};
}

std::optional<int> reba_of(const Task& task, const Motion& motion) {
  const HeldSpan held{0, motion.clip.frames - 1, loads_in_hands(task)};
  return worst_reba({.posed = task, .motion = motion, .held = {&held, 1}}, task.ergonomics);
}

class Mapping {
 public:
  Mapping(const Task& task, ReachMap& map, const Progress& progress)
      : map_(map), progress_(progress), threads_(threads_for({&task, 1}, task.batch.threads)) {
    workers_.assign(index(thread_count(threads_)), task);
    for (Task& worker : workers_) {
      worker.batch.threads = 1;
      worker.candidates = 1;
    }
    values_.resize(map.places.size());
    reachable_.resize(map.places.size());
  }

  Result<void> run() {
    SHG_TRY(find_reachable());
    for (int stride = kCoarsest; stride >= 1; stride /= 2) SHG_TRY(search_grid(stride));
    SHG_TRY(play_beyond());
    map_.evaluations = evaluations_;
    return {};
  }

 private:
  [[nodiscard]] Cell cell_of(std::size_t place) const {
    const auto y = index(map_.count[1]);
    const auto z = index(map_.count[2]);
    return {static_cast<int>(place / z / y), static_cast<int>(place / z % y),
            static_cast<int>(place % z)};
  }

  // Calls work(place, task) for each of the places, in parallel, with a task that is at the place;
  // returns the first place's error.
  template <class Work>
  Result<void> for_each(const std::vector<std::size_t>& places, const Work& work) {
    std::mutex mutex;
    std::optional<std::pair<std::size_t, Error>> worst;
    const auto caller = std::this_thread::get_id();
    parallel_for(static_cast<int>(places.size()), threads_, [&](int k, int worker) {
      if (progress_.cancelled()) return;
      const std::size_t place = places[index(k)];
      Task& task = workers_[index(worker)];
      task.goals.front().position = map_.position(place);
      const Result<void> done = work(place, task);
      ++done_;
      if (!done) {
        const std::lock_guard lock(mutex);
        if (!worst || place < worst->first) worst.emplace(place, done.error());
      }
      if (progress_.report && std::this_thread::get_id() == caller) report();
    });
    if (progress_.cancelled()) return fail(ErrorCode::cancelled, say("stopped_before"));
    return worst ? tl::unexpected(worst->second) : Result<void>{};
  }

  void report() const {
    const double share = static_cast<double>(done_) / static_cast<double>(map_.places.size());
    progress_.report(
        {.stage = "map", .fraction = 0.5 * share, .evaluations = static_cast<int>(evaluations_)});
  }

  Result<void> find_reachable() {
    std::vector<std::size_t> all(map_.places.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    return for_each(all, [this](std::size_t place, const Task& task) -> Result<void> {
      SHG_TRY_ASSIGN(const bool reached, seems_in_reach(task));
      reachable_[place] = reached ? 1 : 0;
      return {};
    });
  }

  // Keeps a motion found for a place if it is better than what is known.
  void keep(std::size_t place, const Task& task, GenerateResult& found) {
    if (!found.meets_goals()) return;
    Candidate& best = found.candidates.front();
    MapPlace made{best.judgement.verdict, best.score.total, 0.0, -1, found.duration};
    for (const JointLoad& load : best.measures.loads) {
      if (load.share <= made.strength && made.dof >= 0) continue;
      made.strength = load.share;
      made.dof = load.dof;
    }
    if (rank_of(map_.places[place]) <= rank_of(made)) return;
    made.reba = reba_of(task, best.motion);
    map_.places[place] = made;
    values_[place] = std::move(best.parameters);
  }

  // One search of a place from the motions of others.
  Result<void> search_once(std::size_t place, Task& task, const Places& others,
                           std::optional<int> motions) {
    task.starts.clear();
    for (const std::size_t other : others) task.starts.push_back(values_[other]);
    task.evaluations = motions;
    SHG_TRY_ASSIGN(GenerateResult found, generate(task));
    evaluations_ += found.log.evaluations;
    keep(place, task, found);
    return {};
  }

  // Searches a place from the motions of others; one that no motion arrives at is searched anew
  // without them, as by generate(), and one that strains is searched anew more slowly.
  Result<void> search(std::size_t place, Task& task, const Places& others,
                      std::optional<int> motions) {
    SHG_TRY(search_once(place, task, others, motions));
    const MapPlace& made = map_.places[place];
    if (!made.verdict) return search_once(place, task, {}, std::nullopt);
    if (made.verdict != Verdict::strains || task.duration) return {};
    task.duration = std::min(kSlower * made.duration, kTaskDurationMax);
    const Result<void> slower = search_once(place, task, {place}, usual_evaluations(task));
    task.duration.reset();
    return slower;
  }

  // Plays the motions of others, the best first, for a place, until one is good there or, if none
  // of them is possible, as good as the best.
  Result<void> play(std::size_t place, Task& task, const Places& others) {
    task.starts.clear();
    task.evaluations.reset();
    SHG_TRY_ASSIGN(MotionPlayer player, MotionPlayer::of(task));
    const std::optional<Verdict> best = map_.places[others.front()].verdict;
    for (const std::size_t other : others) {
      SHG_TRY_ASSIGN(GenerateResult found, player.play(values_[other]));
      ++evaluations_;
      keep(place, task, found);
      const MapPlace& made = map_.places[place];
      const double good = kGoodShare * map_.places[other].score + kGoodScore;
      const bool enough =
          made.verdict == Verdict::possible ? made.score <= good : made.verdict == best;
      if (enough) break;
    }
    return {};
  }

  // The best of others first, and no more than a search takes.
  [[nodiscard]] Places best_of(Places others) const {
    std::sort(others.begin(), others.end(), [this](std::size_t a, std::size_t b) {
      return std::pair{rank_of(map_.places[a]), a} < std::pair{rank_of(map_.places[b]), b};
    });
    others.resize(std::min(others.size(), kMostStarts));
    return others;
  }

  // Finds motions for the places of one grid that are not in the next coarser one, from the motions
  // of the places around them: these are played there, and the place is searched if none of them
  // is as good.
  Result<void> search_grid(int stride) {
    const auto on = [](const Cell& cell, int step) {
      return std::all_of(cell.begin(), cell.end(), [step](int k) { return k % step == 0; });
    };
    Places places;
    for (std::size_t k = 0; k < map_.places.size(); ++k) {
      const Cell cell = cell_of(k);
      const bool before = stride < kCoarsest && on(cell, 2 * stride);
      if (reachable_[k] != 0 && on(cell, stride) && !before) places.push_back(k);
    }
    return for_each(places, [&](std::size_t place, Task& task) -> Result<void> {
      if (stride == kCoarsest) return search(place, task, {}, kCoarseMotions);
      const Places others = best_of(corners(place, 2 * stride));
      if (stride <= kPlayedStride && !others.empty()) {
        SHG_TRY(play(place, task, others));
        const MapPlace& best = map_.places[others.front()];
        if (rank_of(map_.places[place]).first <= rank_of(best).first) return {};
      }
      return search(place, task, others, kFineMotions);
    });
  }

  // Plays the motions of the places around those that seemed out of reach: what they meet is told
  // as impossible rather than as out of reach.
  Result<void> play_beyond() {
    Places beyond;
    for (std::size_t k = 0; k < map_.places.size(); ++k) {
      if (reachable_[k] == 0 && !around(k).empty()) beyond.push_back(k);
    }
    return for_each(beyond, [&](std::size_t place, Task& task) {
      return play(place, task, best_of(around(place)));
    });
  }

  // The places in reach, with motions, beside a place.
  [[nodiscard]] Places around(std::size_t place) const {
    Places found;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        Cell cell = cell_of(place);
        cell[axis] += step;
        add_found(cell, found);
      }
    }
    std::erase_if(found, [this](std::size_t k) { return reachable_[k] == 0; });
    return found;
  }

  void add_found(const Cell& cell, Places& places) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= map_.count[axis]) return;
    }
    const std::size_t place = map_.at(cell[0], cell[1], cell[2]);
    if (map_.places[place].verdict) places.push_back(place);
  }

  // The places with motions at the corners of a place's cell of a coarser grid.
  [[nodiscard]] Places corners(std::size_t place, int stride) const {
    const Cell cell = cell_of(place);
    Places found;
    for (int corner = 0; corner < 8; ++corner) {
      Cell other{};
      bool once = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool far = (corner >> axis & 1) != 0;
        once = once && !(far && cell[axis] % stride == 0);
        other[axis] = (cell[axis] / stride + (far ? 1 : 0)) * stride;
      }
      if (once) add_found(other, found);
    }
    return found;
  }

  ReachMap& map_;
  const Progress& progress_;
  int threads_;
  std::vector<Task> workers_;
  std::vector<Parameters> values_;  // (places) of the motions found
  std::vector<char> reachable_;     // (places)
  std::atomic<long long> evaluations_{0};
  std::atomic<long long> done_{0};
};

// The corners of the default box.
std::pair<Vec3d, Vec3d> usual_box(const Task& task, const Effector& effector, double spacing) {
  const Posture home(task.body, task.home.angles);
  const double limb = task.body.limb_length(effector);
  const Dof& root = task.body.dof(effector.limb_root);
  const Vec3d at = home.place(root.parent) * root.offset;
  const double side = kBoxLimbs * limb;
  const auto whole = [spacing](double x) { return nearest_integer(x / spacing) * spacing; };
  return {{whole(at.x - side), 0.0, whole(at.z - side)},
          {whole(at.x + side), whole(at.y + limb), whole(at.z + side)}};
}

Result<ReachMap> empty_map(const Task& task, const MapSettings& settings) {
  const auto wrong = [](const Message& what) { return fail(ErrorCode::invalid_argument, what); };
  const double spacing = settings.spacing;
  if (!(spacing >= kSpacingMin && spacing <= kSpacingMax)) {
    return wrong(say("spacing_range", spacing, kSpacingMin, kSpacingMax));
  }
  const std::string& name = task.goals.front().effector;
  const auto effector = task.body.find_effector(name);
  const auto box = usual_box(task, task.body.effector(*effector), spacing);
  const Vec3d low = settings.low.value_or(box.first);
  const Vec3d high = settings.high.value_or(box.second);
  ReachMap map{.effector = name, .low = low, .spacing = spacing};
  double places = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool finite = abs(low[axis]) <= kGoalRange && abs(high[axis]) <= kGoalRange;
    if (!finite || !(low[axis] <= high[axis])) {
      return wrong(say("box_range", "xyz"[axis], low[axis], high[axis], kGoalRange));
    }
    const double steps = (high[axis] - low[axis]) / spacing + 1e-6;
    map.count[index(axis)] = static_cast<int>(steps) + 1;
    places *= static_cast<double>(map.count[index(axis)]);
  }
  if (places > static_cast<double>(kPlacesMax)) {
    return wrong(say("places_most", places, kPlacesMax));
  }
  map.places.resize(static_cast<std::size_t>(places));
  return map;
}

}  // namespace

Vec3d ReachMap::position(std::size_t place) const {
  const auto y = index(count[1]);
  const auto z = index(count[2]);
  return {coordinate(Axis::x, static_cast<int>(place / z / y)),
          coordinate(Axis::y, static_cast<int>(place / z % y)),
          coordinate(Axis::z, static_cast<int>(place % z))};
}

std::size_t ReachMap::at(int x, int y, int z) const {
  return (index(x) * index(count[1]) + index(y)) * index(count[2]) + index(z);
}

double ReachMap::coordinate(Axis axis, int k) const {
  return in_grains(low[static_cast<int>(axis)] + k * spacing);
}

std::optional<int> ReachMap::plane(Axis axis, double coordinate) const {
  const double steps = (coordinate - low[static_cast<int>(axis)]) / spacing;
  const int last = count[static_cast<std::size_t>(axis)] - 1;
  if (!(steps >= -0.5 && steps <= last + 0.5)) return std::nullopt;
  return std::clamp(static_cast<int>(nearest_integer(steps)), 0, last);
}

Result<ReachMap> reach_map(const Task& task, const MapSettings& settings,
                           const Progress& progress) {
  const auto wrong = [](const Message& what) { return fail(ErrorCode::invalid_argument, what); };
  if (!task.actions.empty()) return wrong(say("map_of_goals"));
  if (task.goals.empty()) return wrong(say("no_goal"));
  if (task.preset != Preset::flat || task.pareto) return wrong(say("map_by_flat"));
  Task home = task;
  if (const auto effector = task.body.find_effector(task.goals.front().effector)) {
    // the position is ignored, whatever it is
    const Posture posture(task.body, task.home.angles);
    home.goals.front().position = posture.place(task.body.effector(*effector)).translation;
  }
  SHG_TRY(PreparedTask::of(home));
  SHG_TRY_ASSIGN(ReachMap map, empty_map(home, settings));
  SHG_TRY(Mapping(home, map, progress).run());
  return map;
}

}  // namespace shigusa
