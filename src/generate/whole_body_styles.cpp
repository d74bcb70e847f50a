// SPDX-License-Identifier: MIT
#include "whole_body_styles.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "core/index.hpp"

namespace shigusa {

struct StyleRange {
  std::string_view mode;
  double low;  // deg
  double high;
  bool early = false;  // needs no good motion to start from
  int parts = 1;       // two: far from the other styles, with a start of its own
};

namespace {

constexpr StyleRange kBentStyles[] = {
    {"squat", 115, 138, true, 2}, {"squat", 0, 30}, {"squat", 50, 90}};
constexpr StyleRange kUprightStyles[] = {{"lean", 12, 40, true}, {"squat", 20, 45, true}};
// One of each pair: the side opposite to the best motion's.
constexpr StyleRange kOtherSides[][2] = {
    {{"twist", 20, 65}, {"twist", -65, -20}},
    {{"right_swivel", 20, 60}, {"right_swivel", -60, -20}},
    {{"left_swivel", 20, 60}, {"left_swivel", -60, -20}},
};
// Lower bound of the logarithm of a stiff knee's weight.
constexpr double kStiffKnee = 1.0;
// Initial step of late styles: the usual step would lose their start point.
constexpr double kNearStep = 0.1;

std::span<const StyleRange> bends_of(const Archived* best) {
  if (best != nullptr && best->style == Style::upright) return kUprightStyles;
  return kBentStyles;
}

}  // namespace

Niche stiff_knees(const ParameterSpace& space) {
  Niche niche;
  for (const int gene : space.weights_of(JointKind::knee, FreedomKind::flexion)) {
    niche.push_back({gene, space.coordinate(gene, kStiffKnee), 1.0});
  }
  return niche;
}

std::vector<IslandPlan> StylePlans::early(const Archived* best) {
  std::vector<IslandPlan> plans;
  for (const StyleRange& style : bends_of(best)) {
    if (style.early) add(style, best, plans);
  }
  return plans;
}

std::vector<IslandPlan> StylePlans::late(const Archived* best) {
  std::vector<IslandPlan> plans;
  for (const StyleRange& style : bends_of(best)) add(style, best, plans);
  for (const auto& [positive, negative] : kOtherSides) {
    const int gene = space_->find(positive.mode);
    if (gene < 0) continue;
    const bool turns = best != nullptr && best->point[index(gene)] > space_->coordinate(gene, 0.0);
    add(turns ? negative : positive, best, plans);
  }
  if (left_ > 0) {  // budget of the styles that do not apply to the task
    plans.push_back({.niche = space_->find("squat") < 0 ? stiff_knees(*space_) : Niche{},
                     .from = best != nullptr ? best->point : std::vector<double>{},
                     .budget = left_ * part_});
  }
  std::uint64_t stream = 0;
  for (IslandPlan& plan : plans) {
    plan.stream = ++stream;
    if (!plan.from.empty()) plan.step = kNearStep;
  }
  return plans;
}

// Adds the plan of an unplanned style, if the task has its mode and enough motions are left.
void StylePlans::add(const StyleRange& style, const Archived* best,
                     std::vector<IslandPlan>& plans) {
  const bool planned = std::find(planned_.begin(), planned_.end(), &style) != planned_.end();
  if (planned || style.parts > left_ || space_->find(style.mode) < 0) return;
  const bool far = style.parts > 1;
  plans.push_back({.niche = niche_of(style),
                   .from = best == nullptr || far ? std::vector<double>{} : best->point,
                   .bent = far,
                   .style = true,
                   .budget = style.parts * part_});
  planned_.push_back(&style);
  left_ -= style.parts;
}

// The bounds that keep the mode within the range.
Niche StylePlans::niche_of(const StyleRange& style) const {
  const bool bends_knees = style.mode == "squat" || space_->find("squat") < 0;
  Niche niche = bends_knees ? stiff_knees(*space_) : Niche{};
  if (const int gene = space_->find(style.mode); gene >= 0) {
    niche.push_back({gene, space_->coordinate(gene, radians(style.low)),
                     space_->coordinate(gene, radians(style.high))});
  }
  return niche;
}

}  // namespace shigusa
