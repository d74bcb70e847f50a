// SPDX-License-Identifier: MIT
#include "recorded_man.hpp"

#include <fmt/format.h>

#include <shigusa/run.hpp>
#include <shigusa/score.hpp>

#include "problem/make_problem.hpp"

namespace shigusa::bench {
namespace {

constexpr int kCandidates = 8;
constexpr int kFitEvaluations = 100000;
constexpr const char* kClip = "cmu_02_06_60hz.bvh";

Chosen chosen(const Recorded& reach, std::string way, const Candidate& candidate) {
  Track track = track_of(reach, candidate.motion.clip);
  const Apart off = apart(reach, track);
  return {std::move(way), std::move(track), off, candidate.score.terms};
}

// The best-scored candidate and the one that ends nearest to the record; `what`: introduction of
// their words.
void add_two(const Recorded& reach, const std::string& what, const GenerateResult& generation,
             std::vector<Chosen>& into) {
  const std::string of = fmt::format(" of {}", kCandidates);
  into.push_back(chosen(reach, what + "best-scored" + of, generation.candidates.front()));
  std::optional<Chosen> nearest;
  for (const Candidate& candidate : generation.candidates) {
    Chosen each = chosen(reach, what + "nearest" + of, candidate);
    if (!nearest || each.apart.final_place < nearest->apart.final_place) nearest = std::move(each);
  }
  into.push_back(std::move(*nearest));
}

Result<GenerateResult> motions_of(const Recorded& record, Preset preset) {
  Task task = with_preset(record.task(), preset);
  task.candidates = kCandidates;
  return generate(task);
}

Result<Compared> compared(const std::filesystem::path& clip, const Segment& segment) {
  SHG_TRY_ASSIGN(Recorded reach, read_reach(clip, segment));
  Compared result{std::move(reach)};
  const Recorded& record = result.reach;
  SHG_TRY_ASSIGN(const GenerateResult flat, motions_of(record, Preset::flat));
  result.candidates = static_cast<int>(flat.candidates.size());
  add_two(record, "", flat, result.chosen);
  SHG_TRY_ASSIGN(const GenerateResult layered, motions_of(record, Preset::human));
  add_two(record, "preset `human`, ", layered, result.chosen);
  const Task paper = with_preset(record.task(), Preset::paper);
  SHG_TRY_ASSIGN(const GenerateResult uniform,
                 regenerate(paper, uniform_parameters(record.task().body)));
  result.chosen.push_back(chosen(record, "uniform weights", uniform.candidates.front()));
  SHG_TRY_ASSIGN(const GenerateResult searched, motions_of(record, Preset::paper));
  add_two(record, "preset `paper`, ", searched, result.chosen);
  SHG_TRY_ASSIGN(const Recorded on_toes, read_reach(clip, segment, true));
  SHG_TRY_ASSIGN(const GenerateResult lifted, motions_of(on_toes, Preset::flat));
  add_two(on_toes, "heels may lift, ", lifted, result.chosen);
  Task task = record.task();
  task.duration.reset();
  result.own_duration = make_problem(task).value().duration;
  SHG_TRY_ASSIGN(
      const RecordedMotion recorded,
      read_recorded(clip,
                    {.source = clip.string(), .extent = BodyExtent::human, .frame = segment.first},
                    segment.first));
  SHG_TRY_ASSIGN(const ClipScore score,
                 score_clip(recorded, {.first = segment.first, .last = segment.last}));
  result.recorded_score = score.score;
  return result;
}

void fit_all(std::vector<Compared>& all) {
  const std::vector<FitKind> kinds = fit_kinds();
  const int count = static_cast<int>(all.size() * kinds.size());
  for (Compared& c : all) {
    c.fitted.resize(kinds.size());
    c.fitted_apart.resize(kinds.size());
  }
  parallel_for(count, 0, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    Compared& c = all[i / kinds.size()];
    const std::size_t k = i % kinds.size();
    c.fitted[k] = fitted_reach(c.reach, kinds[k], kFitEvaluations);
    if (c.fitted[k].clip.angles.empty()) return;
    c.fitted_apart[k] = apart(c.reach, track_of(c.reach, c.fitted[k].clip));
  });
}

// Name of a reach, "start-low" for "02_06_00_start-low"
std::string kind_of(const Segment& segment) {
  return segment.name.substr(segment.name.rfind('_') + 1);
}

void find_others(std::vector<Compared>& all) {
  for (Compared& c : all) {
    for (const Compared& other : all) {
      if (&other == &c || kind_of(other.reach.segment) != kind_of(c.reach.segment)) continue;
      const Apart off = apart(c.reach, other.reach);
      if (!c.nearest_other || off.final_place < c.nearest_other->final_place) {
        c.nearest_other = off;
      }
    }
  }
}

}  // namespace

Result<std::vector<Compared>> recorded_man(const std::filesystem::path& folder) {
  SHG_TRY_ASSIGN(const auto segments, downward_segments(folder / "manifest.tsv"));
  std::vector<Compared> all;
  for (const Segment& segment : segments) {
    SHG_TRY_ASSIGN(Compared each, compared(folder / kClip, segment));
    all.push_back(std::move(each));
  }
  fit_all(all);
  find_others(all);
  return all;
}

}  // namespace shigusa::bench
