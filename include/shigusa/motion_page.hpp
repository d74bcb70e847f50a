// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <shigusa/generate.hpp>
#include <shigusa/result.hpp>
#include <shigusa/strip_figure.hpp>
#include <shigusa/task.hpp>
#include <span>
#include <string>
#include <string_view>

namespace shigusa {

/// The most candidates that a page shows, of all its results together.
inline constexpr std::size_t kPageMostCandidates = 2000;
/// The most poses of a motion that a page holds; between them it draws on a straight way.
inline constexpr int kPagePoses = 61;

/// A result that a page shows. Borrows task and motions.
struct ShownResult {
  const Task& task;                  ///< that the motions were found for
  const GenerateResult& generation;  ///< the motions, as generate or replay_all gives them
  std::string title{};               ///< UTF-8; empty: the goals in words (goals_title)
};

/// HTML that shows results on one page, complete in itself: a section for each, with the sentence
/// of what was asked and its candidates as moving figures, each with its verdict and its score in
/// words, and the numbers to unfold. The page asks for no other file, works from a disk, follows
/// the reader's choice of light or dark and of less motion, and is operable by keyboard. It is
/// drawn by a small script from the figure's points in whole millimetres. Texts from files and
/// titles stand in it escaped; what is not UTF-8 is replaced. Same results, same bytes. Fails where
/// there are more candidates than kPageMostCandidates.
[[nodiscard]] Result<std::string> motion_page(std::span<const ShownResult> results,
                                              std::string_view heading = {});

/// The strip figure of the first candidate of each result under each other as SVG, with the titles
/// as captions. Fails as draw_strips does.
[[nodiscard]] Result<std::string> result_strips(std::span<const ShownResult> results);

}  // namespace shigusa
