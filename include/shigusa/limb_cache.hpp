// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <shigusa/layered_settings.hpp>

namespace shigusa {

/// No library is larger: a full one has 13.9 kB.
inline constexpr std::size_t kMaxLimbFile = 1 << 16;

/// The folder for what can be made again: $SHIGUSA_CACHE, or shigusa in $XDG_CACHE_HOME or in
/// ~/.cache. Nothing where none of these is an absolute path.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder();

/// Keeps limb libraries as files of a folder, which is made when there is something to keep. Files
/// are written beside their place and renamed, so that programs at the same time see whole ones. A
/// folder that cannot be read or written is as good as none.
[[nodiscard]] LimbStore limb_store(const std::filesystem::path& folder);

/// A store in cache_folder(); an empty one without it.
[[nodiscard]] LimbStore limb_store();

}  // namespace shigusa
