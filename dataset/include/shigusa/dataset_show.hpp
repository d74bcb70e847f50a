// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>

namespace shigusa {

/// Largest number of motions drawn on a page.
inline constexpr std::size_t kShownMax = 1000;

/// Settings of a page.
struct ShowSettings {
  std::size_t motions = 48;                   ///< motions on the contact sheet, at most kShownMax
  const std::atomic<bool>* cancel = nullptr;  ///< ends the work once true
};

/// Self-contained HTML page of a data set: numbers, a contact sheet of motions sampled by the
/// plan's seed and spread over their outcomes, and plots of goals, scores, styles and people. It
/// has no script and needs no other file. Missing shards are left out, which the page states. The
/// same data gives the same page. Fails on a folder without a plan or shards, and on a damaged
/// shard.
[[nodiscard]] Result<std::string> show_dataset(const std::filesystem::path& folder,
                                               const ShowSettings& settings = {});

}  // namespace shigusa
