// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>

#include "measure/measure_person.hpp"

namespace shigusa {

// Fails if lifting heels is requested for a body that cannot: a seated one, or one of this extent.
[[nodiscard]] Result<void> check_heels(const CharacterSpec& spec, BodyExtent extent);

// Finds the toes' joints of a file's person: at rest from the file's nodes (`world`, nodes), at the
// start moved along with the feet. Toes with only a joint in the file get a tip by average
// proportions, with a doubt. Fails if the file has no toes, or toes that are not ahead of the
// ankle.
[[nodiscard]] Result<void> find_toes(const std::vector<Transformd>& world, const HumanoidMap& map,
                                     const MeasuredPerson& person, const std::string& file,
                                     MeasuredPerson& start);

}  // namespace shigusa
