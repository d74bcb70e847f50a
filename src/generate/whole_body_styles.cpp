// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include "whole_body_search.hpp"

namespace shigusa {
namespace {

constexpr double kRounding = 1e-6;
constexpr double kStiffKnee =
    1.0;  // logarithm of the least weight of a knee that goes by the target

// A range (deg) of a posture mode that is a style of its own.
struct StyleRange {
  const char* mode;
  double low;
  double high;
  bool far = false;  // from what is found otherwise
};
constexpr StyleRange kBentStyles[] = {
    {"squat", 115, 138, true}, {"squat", 0, 30}, {"squat", 50, 90}};
constexpr StyleRange kUprightStyles[] = {{"lean", 25, 60}, {"squat", 30, 60}};
constexpr double kOtherTurn[] = {20, 65};    // deg, to the side that the best does not turn to
constexpr double kOtherSwivel[] = {20, 60};  // deg, of the elbow, likewise

}  // namespace

// The parts that search for the styles that the guess has not.
std::vector<WholeBodySearch::Part> WholeBodySearch::styles(const PointScorer::Guess& guess,
                                                           int budget) const {
  std::vector<Part> parts;
  const Niche knees = stiff_knees();
  const bool given = space_.find("squat") < 0;
  double left = 1.0 - kFreeShare;
  const auto add_style = [&](std::string_view mode, double low, double high, bool far = false) {
    const double share = far ? kFarShare : kStyleShare;
    if (space_.find(mode) < 0 || share > left + kRounding) return;
    Niche niche = given || mode == "squat" ? knees : Niche{};
    bind(niche, mode, low, high);
    parts.push_back({std::move(niche), far ? std::vector<double>{} : guess.point,
                     static_cast<int>(share * budget)});
    left -= share;
  };
  for (const StyleRange& style : guess.bends ? std::span<const StyleRange>(kBentStyles)
                                             : std::span<const StyleRange>(kUprightStyles)) {
    add_style(style.mode, style.low, style.high, style.far);
  }
  const auto add_other = [&](std::string_view mode, const double(&range)[2]) {
    const int gene = space_.find(mode);
    if (gene < 0) return;
    const bool positive = !guess.point.empty() && guess.point[static_cast<std::size_t>(gene)] >
                                                      space_.coordinate(gene, 0.0);
    positive ? add_style(mode, -range[1], -range[0]) : add_style(mode, range[0], range[1]);
  };
  add_other("twist", kOtherTurn);
  add_other("right_swivel", kOtherSwivel);
  add_other("left_swivel", kOtherSwivel);
  // of the styles that the task has not
  const int rest = static_cast<int>((left + kRounding) * budget);
  if (rest > 0) parts.push_back({given ? knees : Niche{}, guess.point, rest});
  return parts;
}

// Keeps a mode of both phases within a range (deg).
void WholeBodySearch::bind(Niche& niche, std::string_view mode, double low, double high) const {
  for (const int gene :
       {space_.find(mode), space_.find(std::string(kLaterPrefix) + std::string(mode))}) {
    if (gene < 0) continue;
    niche.push_back(
        {gene, space_.coordinate(gene, radians(low)), space_.coordinate(gene, radians(high))});
  }
}

// Where the knees' flexion is given they go by it: light ones would bend as the hand has it.
WholeBodySearch::Niche WholeBodySearch::stiff_knees() const {
  Niche niche;
  for (const char* name : {"knee.flexion", "left_knee.flexion", "right_knee.flexion"}) {
    for (const int gene : {space_.find(name), space_.find(std::string(kLaterPrefix) + name)}) {
      if (gene >= 0) niche.push_back({gene, space_.coordinate(gene, kStiffKnee), 1.0});
    }
  }
  return niche;
}

}  // namespace shigusa
