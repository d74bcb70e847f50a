// SPDX-License-Identifier: MIT
#include <shigusa/series.hpp>

#include "door.hpp"

using namespace shigusa;
using namespace shigusa::door;

namespace {

constexpr size_t kSeries = kEnumWords<MotionSeries>.size();
static_assert(kSeries == SHIGUSA_THINGS + 1);

// Fails if the result has no such candidate or series.
Result<void> check_series(const shigusa_result& result, int32_t candidate, shigusa_series series) {
  if (candidate < 1 || static_cast<size_t>(candidate) > result.generation.candidates.size()) {
    return fail(ErrorCode::invalid_argument,
                "candidate " + std::to_string(candidate) + " does not exist");
  }
  if (series < 0 || static_cast<size_t>(series) >= kSeries) {
    return fail(ErrorCode::invalid_argument,
                "series " + std::to_string(series) + " is none that this build knows");
  }
  return {};
}

Result<SeriesTable> table_of(const shigusa_result& result, int32_t candidate, shigusa_series series,
                             const SeriesSettings& settings = {}) {
  SHG_TRY(check_series(result, candidate, series));
  const auto& of = result.generation.candidates[static_cast<size_t>(candidate - 1)];
  return motion_series(result.file.character, result.task, of, static_cast<MotionSeries>(series),
                       settings);
}

Result<void> give_values(const SeriesTable& table, shigusa_bytes** bytes) {
  return give(
      {reinterpret_cast<const char*>(table.values.data()), table.values.size() * sizeof(double)},
      bytes);
}

size_t columns_of(size_t values, size_t frames) { return frames == 0 ? 0 : values / frames; }

}  // namespace

extern "C" shigusa_status shigusa_result_series(const shigusa_result* result, int32_t candidate,
                                                shigusa_series series, const double** values,
                                                size_t* frames, size_t* columns) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "values", values, "frames", frames, "columns", columns));
    SHG_TRY(check_series(*result, candidate, series));
    const auto& all = result->generation.candidates;
    const auto index = static_cast<size_t>(candidate - 1);
    auto& kept = result->series;
    if (kept.empty()) kept.assign(all.size(), std::vector<std::vector<double>>(kSeries));
    std::vector<double>& table = kept[index][static_cast<size_t>(series)];
    if (table.empty()) {
      SHG_TRY_ASSIGN(SeriesTable made, table_of(*result, candidate, series));
      table = std::move(made.values);
    }
    *values = table.data();
    *frames = static_cast<size_t>(all[index].motion.clip.frames);
    *columns = columns_of(table.size(), *frames);
    return {};
  });
}

extern "C" shigusa_status shigusa_result_series_at(const shigusa_result* result, int32_t candidate,
                                                   shigusa_series series, double fps,
                                                   shigusa_bytes** table, size_t* frames,
                                                   size_t* columns) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "table", table, "frames", frames, "columns", columns));
    SHG_TRY_ASSIGN(const SeriesTable made, table_of(*result, candidate, series, {.rate = fps}));
    SHG_TRY(give_values(made, table));
    *frames = made.frames;
    *columns = columns_of(made.values.size(), made.frames);
    return {};
  });
}

extern "C" shigusa_status shigusa_result_table(const shigusa_result* result, int32_t candidate,
                                               shigusa_series series, const char* options,
                                               shigusa_bytes** table, shigusa_bytes** about) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "table", table, "about", about));
    SHG_TRY_ASSIGN(const SeriesSettings settings,
                   parse_series_settings(options == nullptr ? "{}" : options, "options"));
    SHG_TRY_ASSIGN(const SeriesTable made, table_of(*result, candidate, series, settings));
    auto told = std::make_unique<shigusa_bytes>(
        shigusa_bytes{format_series(static_cast<MotionSeries>(series), made)});
    SHG_TRY(give_values(made, table));
    *about = told.release();
    return {};
  });
}
