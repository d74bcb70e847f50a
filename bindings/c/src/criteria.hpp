// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa.h>

#include <cstddef>
#include <shigusa/criteria.hpp>

#include "watch.hpp"

namespace shigusa::door {

// Adds the host's criteria to those of a task. They are called through `watched`, which outlives
// the settings.
Result<void> add_criteria(const shigusa_criterion* criteria, std::size_t count, Watched& watched,
                          CriteriaSettings& settings);

}  // namespace shigusa::door
