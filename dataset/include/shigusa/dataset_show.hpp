// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <shigusa/error.hpp>
#include <string>

namespace shigusa {

/// The most motions that a page draws.
inline constexpr std::size_t kShownMax = 1000;

/// How a data set is shown.
struct ShowSettings {
  std::size_t motions = 48;                   ///< of the contact sheet, at most kShownMax
  const std::atomic<bool>* cancel = nullptr;  ///< ends the work once it is true
};

/// HTML that shows a data set on one page, complete in itself: numbers, a contact sheet of
/// motions that the plan's seed draws, spread over the ways in which motions end, and plots of
/// goals, scores, styles and people. It has no script and asks for no other file. Shards that are
/// not made yet are left out, and the page says so. Same data, same page. Fails on a folder without
/// a plan or shards, and on a damaged shard.
[[nodiscard]] Result<std::string> show_dataset(const std::filesystem::path& folder,
                                               const ShowSettings& settings = {});

}  // namespace shigusa
