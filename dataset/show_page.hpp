// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "export_poses.hpp"
#include "show_facts.hpp"

namespace shigusa {

// An obstacle box: its centre (m, world), its sides along its own axes (m) and its rotation.
struct ShownBox {
  Vec3d middle;
  Vec3d size;
  Quatd turn;
};

// A motion of the contact sheet with the facts beside it.
struct SheetMotion {
  std::string id;
  std::string words;
  std::string verdict;
  std::string person;  // "female, 1.63 m, 58 kg"
  std::string goal;    // "right hand, 4.2 kg, 1.21 m up"
  double score = 0.0;
  NodePlaces places;
  std::vector<Vec3d> goals;            // m, world
  std::vector<std::string> effectors;  // of the goals
  std::vector<ShownBox> obstacles;
  std::optional<double> seat{};  // m
};

// Reads the chosen motions, in their order.
[[nodiscard]] Result<std::vector<SheetMotion>> read_sheet(const DataFolder& data,
                                                          const std::vector<ChosenMotion>& chosen);

// The contact sheet as a part of a page.
[[nodiscard]] std::string sheet_html(const std::vector<SheetMotion>& motions);

// The plots. `person`: a motion whose first frame represents the body, if there is one.
[[nodiscard]] std::string reach_html(const ShowFacts& facts, const SheetMotion* person);
[[nodiscard]] std::string scores_html(const ShowFacts& facts);
[[nodiscard]] std::string styles_html(const ShowFacts& facts);
[[nodiscard]] std::string people_html(const ShowFacts& facts);

// Lines of a body in a frame, projected so that `right` (unit, horizontal) points to the right; in
// centimetres, y down.
struct FigureView {
  Vec3d right{1, 0, 0};
  Vec3d up{0, 1, 0};

  [[nodiscard]] double x(const Vec3d& p) const { return 100.0 * dot(p, right); }
  [[nodiscard]] double y(const Vec3d& p) const { return -100.0 * dot(p, up); }
};
// `style`: class of the whole figure.
[[nodiscard]] std::string figure_svg(const NodePlaces& places, std::size_t frame,
                                     const FigureView& view, std::string_view style);

}  // namespace shigusa
