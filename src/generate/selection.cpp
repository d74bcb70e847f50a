// SPDX-License-Identifier: MIT
#include "selection.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/say.hpp"
#include "distinct.hpp"

namespace shigusa {

Selection distinct_postures(const Archive& archive, int most) {
  const std::vector<Archived> ranked = archive.ranked();
  std::vector<const Archived*> picked;
  Selection selection;
  // people do not squat for goals they reach standing
  const bool bends = !ranked.empty() && ranked.front().style != Style::upright;
  const auto squats = [](const Archived& archived) { return archived.style == Style::squat; };
  const auto between = std::find_if(ranked.begin(), ranked.end(), [&](const Archived& archived) {
    return squats(archived) && abs(archived.look.swivel) <= kElbowBetween;
  });
  const auto waits = [&](const Archived& archived) {
    return squats(archived) && between != ranked.end() && &archived < &*between &&
           between->score <= archived.score + kElbowSpread && &archived != &ranked.front();
  };
  for (const bool new_style_only : {true, false}) {
    selection.worse = 0;
    for (const Archived& archived : ranked) {
      if (static_cast<int>(picked.size()) >= most) break;
      const double spread = new_style_only && bends ? kStyleSpread : kCandidateSpread;
      if (archived.score > ranked.front().score + spread) {
        ++selection.worse;
        continue;
      }
      if (new_style_only && waits(archived)) continue;
      const bool is_hidden = std::any_of(picked.begin(), picked.end(), [&](const Archived* better) {
        return look_alike(better->look, archived.look, kLookSlack) ||
               (new_style_only && better->style == archived.style);
      });
      if (!is_hidden) picked.push_back(&archived);
    }
  }
  for (const Archived* archived : picked) {
    selection.picked.push_back({archived->point, archived->score});
  }
  for (const Archived& archived : ranked) {
    const bool is_picked = std::find(picked.begin(), picked.end(), &archived) != picked.end();
    if (!is_picked) selection.spare.push_back(archived);
  }
  return selection;
}

int count_similar(const Selection& selection, std::span<const Look> candidates, int taken) {
  if (selection.picked.empty()) return 0;
  const double most = selection.picked.front().score + kCandidateSpread;
  const auto alike = std::count_if(
      selection.spare.begin(), selection.spare.end(), [&candidates, most](const Archived& spare) {
        return spare.score <= most &&
               std::any_of(candidates.begin(), candidates.end(),
                           [&spare](const Look& look) { return look_alike(look, spare.look); });
      });
  return std::max(static_cast<int>(alike) - taken, 0);
}

Message why_fewer(const Task& task, const GenerateResult& generation, const Selection& selection) {
  if (static_cast<int>(generation.candidates.size()) >= task.candidates) return {};
  const bool by_end = traits_of(task.preset).natural;
  std::optional<Message> reasons;
  const auto add = [&](int count, Message reason) {
    if (count > 0) reasons = reasons ? say("and_more", *reasons, reason) : std::move(reason);
  };
  const int similar = by_end ? selection.similar : generation.log.near_copies;
  add(similar, by_end ? say("fewer_alike", similar) : say("fewer_near_copies", similar));
  add(selection.worse, say("fewer_worse", selection.worse, kCandidateSpread));
  add(generation.log.jolting, say("fewer_jolting", generation.log.jolting));
  add(generation.log.strange, say("fewer_strange", generation.log.strange));
  add(generation.log.over_limit, say("fewer_over_limit", generation.log.over_limit));
  add(generation.log.collided, say("fewer_collided", generation.log.collided));
  add(generation.log.missed, say("fewer_missed", generation.log.missed));
  return say("fewer_kept", generation.candidates.size(), task.candidates,
             reasons ? *reasons : say("fewer_none"));
}

}  // namespace shigusa
