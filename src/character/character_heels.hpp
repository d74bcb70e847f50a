// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>

#include "measure/measure_person.hpp"

namespace shigusa {

// Fails where heels are asked of a body that cannot lift them: seated, or of this extent.
[[nodiscard]] Result<void> check_heels(const CharacterSpec& spec, BodyExtent extent);

// Where the toes of a file's person bend: at rest at the file's nodes (`world`, of nodes), at the
// start where the feet have taken them. Toes of which the file has no more than the joint get a tip
// by average proportions, with a doubt. Fails where the file has no toes, or not ahead of the
// ankle.
[[nodiscard]] Result<void> find_toes(const std::vector<Transformd>& world, const HumanoidMap& map,
                                     const MeasuredPerson& person, const std::string& file,
                                     MeasuredPerson& start);

}  // namespace shigusa
