// SPDX-License-Identifier: MIT
// shigusa_people generates a recorded man's reaches and writes docs/people.md.
#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <shigusa/parallel.hpp>
#include <shigusa/score_clip.hpp>

#include "page.hpp"
#include "task/make_problem.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;

constexpr int kCandidates = 8;
constexpr int kFitEvaluations = 20000;
constexpr const char* kClip = "cmu_02_06_60hz.bvh";

Chosen chosen(const Recorded& reach, std::string way, const Candidate& candidate) {
  Track track = track_of(reach, candidate.motion.clip);
  const Apart off = apart(reach, track);
  return {std::move(way), std::move(track), off, candidate.score.terms};
}

// The best-scored candidate and the one that ends nearest to the record; `what` stands before the
// words for them.
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

// "start-low" of "02_06_00_start-low"
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

int fault(const Error& error) {
  std::cerr << "shigusa_people: " << error.to_string() << "\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: shigusa_people DOCS_FOLDER REACH_FOLDER\n";
    return 2;
  }
  const std::filesystem::path docs = argv[1];
  const std::filesystem::path folder = argv[2];
  const auto segments = downward_segments(folder / "manifest.tsv");
  if (!segments) return fault(segments.error());
  std::vector<Compared> all;
  for (const Segment& segment : *segments) {
    Result<Compared> each = compared(folder / kClip, segment);
    if (!each) return fault(each.error());
    all.push_back(std::move(*each));
  }

  fit_all(all);
  find_others(all);
  const auto pictures = people_pictures(all);
  if (!pictures) return fault(pictures.error());
  const std::filesystem::path images = docs / "images" / "people";
  std::filesystem::create_directories(images);
  for (const NamedPicture& picture : *pictures) {
    std::ofstream(images / (picture.name + ".svg"), std::ios::binary) << picture.svg;
  }
  std::ifstream remarks(docs / "people_remarks.md", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(remarks), {}};
  const std::filesystem::path page = docs / "people.md";
  std::ofstream(page, std::ios::binary) << people_page(all) << "\n" << text;
  std::cout << page.string() << "\n";
  return 0;
}
