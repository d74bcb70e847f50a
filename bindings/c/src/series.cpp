// SPDX-License-Identifier: MIT
#include <shigusa/character.hpp>

#include "door.hpp"

using namespace shigusa;
using namespace shigusa::door;

namespace {

constexpr size_t kSeries = SHIGUSA_THINGS + 1;

void add(const Vec3d& v, std::vector<double>& table) { table.insert(table.end(), {v.x, v.y, v.z}); }

void add_times(const Clip& clip, std::vector<double>& table) {
  for (int f = 0; f < clip.frames; ++f) table.push_back(f * clip.frame_time);
}

void add_poses(const std::vector<ThingMotion>& things, size_t frames, std::vector<double>& table) {
  for (size_t f = 0; f < frames; ++f) {
    for (const ThingMotion& thing : things) {
      if (thing.poses.size() != frames) continue;
      add(thing.poses[f].translation, table);
      const Quatd q = to_quat(thing.poses[f].rotation);
      table.insert(table.end(), {q.x, q.y, q.z, q.w});
    }
  }
}

struct NodeTables {
  std::vector<double> translations;
  std::vector<double> rotations;
};

NodeTables node_tables(const shigusa_result& result, const Candidate& candidate, const Clip& clip) {
  NodeTables tables;
  for (const LocalTransform& local :
       node_motion(result.file.character, result.task, candidate, clip)) {
    add(local.translation, tables.translations);
    const Quatd& q = local.rotation;
    tables.rotations.insert(tables.rotations.end(), {q.x, q.y, q.z, q.w});
  }
  return tables;
}

bool is_of_nodes(shigusa_series series) {
  return series == SHIGUSA_NODE_TRANSLATIONS || series == SHIGUSA_NODE_ROTATIONS;
}

// Table of one series that is not of nodes, frame by frame.
std::vector<double> table_of(const shigusa_result& result, const Candidate& candidate,
                             shigusa_series series) {
  const Motion& motion = candidate.motion;
  const auto frames = static_cast<size_t>(motion.clip.frames);
  std::vector<double> table;
  switch (series) {
    case SHIGUSA_TIME:
      add_times(motion.clip, table);
      break;
    case SHIGUSA_ANGLES:
      return motion.clip.angles;
    case SHIGUSA_TORQUES:
      return motion.torques;
    case SHIGUSA_CENTRE_OF_MASS:
      for (const Vec3d& at : motion.centre_of_mass) add(at, table);
      break;
    case SHIGUSA_SUPPORT:
      for (const SupportFrame& frame : support_frames(result.task, candidate)) {
        table.insert(table.end(), {frame.centre_of_mass, frame.pressure});
      }
      break;
    case SHIGUSA_EFFECTORS:
      for (size_t f = 0; f < frames; ++f) {
        for (const std::vector<Vec3d>& effector : motion.effectors) add(effector[f], table);
      }
      break;
    case SHIGUSA_UPPER_LIMITS:
      for (int f = 0; f < motion.clip.frames; ++f) {
        for (int d = 0; d < motion.clip.dofs; ++d) {
          table.push_back(upper_limit(result.task.body, d, motion.clip.frame(f)));
        }
      }
      break;
    case SHIGUSA_THINGS:
      add_poses(candidate.things, frames, table);
      break;
    default:
      break;
  }
  return table;
}

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
    std::vector<std::vector<double>>& tables = kept[index];
    std::vector<double>& table = tables[static_cast<size_t>(series)];
    if (table.empty() && is_of_nodes(series)) {
      NodeTables made = node_tables(*result, all[index], all[index].motion.clip);
      tables[SHIGUSA_NODE_TRANSLATIONS] = std::move(made.translations);
      tables[SHIGUSA_NODE_ROTATIONS] = std::move(made.rotations);
    } else if (table.empty()) {
      table = table_of(*result, all[index], series);
    }
    *values = table.data();
    *frames = static_cast<size_t>(all[index].motion.clip.frames);
    *columns = *frames == 0 ? 0 : table.size() / *frames;
    return {};
  });
}

extern "C" shigusa_status shigusa_result_series_at(const shigusa_result* result, int32_t candidate,
                                                   shigusa_series series, double fps,
                                                   shigusa_bytes** table, size_t* frames,
                                                   size_t* columns) {
  return guarded([&]() -> Result<void> {
    SHG_TRY(need("result", result, "table", table, "frames", frames, "columns", columns));
    SHG_TRY(check_series(*result, candidate, series));
    SHG_TRY(check_rate(fps, "fps"));
    if (series != SHIGUSA_TIME && series != SHIGUSA_ANGLES && series != SHIGUSA_THINGS &&
        !is_of_nodes(series)) {
      return fail(ErrorCode::unsupported,
                  "series " + std::to_string(series) + " is of the motion's own frames alone");
    }
    const auto index = static_cast<size_t>(candidate - 1);
    const Candidate& of = result->generation.candidates[index];
    const Clip clip = motion_at(result->task.body, of, fps);
    std::vector<double> values;
    if (series == SHIGUSA_TIME) add_times(clip, values);
    if (series == SHIGUSA_ANGLES) values = clip.angles;
    if (series == SHIGUSA_THINGS) {
      add_poses(things_at(of, fps), static_cast<size_t>(clip.frames), values);
    }
    if (is_of_nodes(series)) {
      NodeTables tables = node_tables(*result, of, clip);
      values = std::move(series == SHIGUSA_NODE_ROTATIONS ? tables.rotations : tables.translations);
    }
    *frames = static_cast<size_t>(clip.frames);
    *columns = values.size() / *frames;
    return give({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)},
                table);
  });
}
