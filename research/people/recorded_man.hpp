// SPDX-License-Identifier: MIT
#pragma once

#include "page.hpp"

namespace shigusa::bench {

// The recorded man's reaches in that folder, beside all that is made for them. Fails where he is
// not there.
[[nodiscard]] Result<std::vector<Compared>> recorded_man(const std::filesystem::path& folder);

}  // namespace shigusa::bench
