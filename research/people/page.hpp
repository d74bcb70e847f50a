// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/generate.hpp>

#include "fitted.hpp"
#include "measures.hpp"

namespace shigusa::bench {

// A method to choose a motion for a reach, with its name: "uniform weights", "best-scored of 8".
struct Chosen {
  std::string way;
  Track track;
  Apart apart;
  std::vector<ScoreTerm> criteria{};  // of generated ones
};

// A reach with all motions generated for it.
struct Compared {
  Recorded reach;
  std::vector<Chosen> chosen{};       // the same methods in the same order for each reach
  std::vector<FittedReach> fitted{};  // of fit_kinds()
  std::vector<Apart> fitted_apart{};
  std::optional<Apart> nearest_other{};  // his own, of the reaches with the same kind of start
  double own_duration = 0.0;             // s, default duration of shigusa
  Score recorded_score{};                // of his own motion, as from `shigusa score`
  int candidates = 0;
};

// The page's first part: the recorded man.
[[nodiscard]] std::string people_page(const std::vector<Compared>& compared);
// Each of his reaches.
[[nodiscard]] std::string reaches_section(const std::vector<Compared>& compared);

struct NamedPicture {
  std::string name;  // "02_06_00_start-low"
  std::string svg;
};
[[nodiscard]] Result<std::vector<NamedPicture>> people_pictures(
    const std::vector<Compared>& compared);

// A part of the page with its pictures.
struct Drawn {
  std::string text;
  std::vector<NamedPicture> pictures{};
};

// A motion of the reach's body as a strip, seen exactly from the right.
[[nodiscard]] Result<std::string> side_strip(const Recorded& reach, const Track& track);

}  // namespace shigusa::bench
