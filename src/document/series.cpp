// SPDX-License-Identifier: MIT
#include <algorithm>
#include <shigusa/files.hpp>
#include <shigusa/score.hpp>
#include <shigusa/series.hpp>

#include "core/index.hpp"
#include "formats/json_reader.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {
namespace {

void add(const Vec3d& v, std::vector<double>& values) {
  values.insert(values.end(), {v.x, v.y, v.z});
}
void add(const Quatd& q, std::vector<double>& values) {
  values.insert(values.end(), {q.x, q.y, q.z, q.w});
}

const std::vector<std::string>& point_components() {
  static const std::vector<std::string> names{"x", "y", "z"};
  return names;
}

// The tables of a candidate at given frames.
class SeriesMaker {
 public:
  SeriesMaker(const CharacterSpec& character, const Task& task, const Candidate& candidate,
              const SeriesSettings& settings)
      : character_(character),
        task_(task),
        candidate_(candidate),
        settings_(settings),
        clip_(settings.rate ? motion_at(task.body, candidate, *settings.rate)
                            : candidate.motion.clip) {}

  SeriesTable table(MotionSeries series) {
    table_.frames = index(clip_.frames);
    table_.frame_time = clip_.frame_time;
    fill(series);
    return std::move(table_);
  }

 private:
  void fill(MotionSeries series) {
    const Motion& motion = candidate_.motion;
    std::vector<double>& values = table_.values;
    switch (series) {
      case MotionSeries::time:
        for (int f = 0; f < clip_.frames; ++f) values.push_back(f * clip_.frame_time);
        return;
      case MotionSeries::angles:
        name_joints();
        values = clip_.angles;
        return;
      case MotionSeries::torques:
        name_joints();
        values = in_frames(motion.torques);
        return;
      case MotionSeries::centre_of_mass:
        table_.components = point_components();
        for (const Vec3d& at : motion.centre_of_mass) add(at, values);
        values = in_frames(std::move(values));
        return;
      case MotionSeries::support:
        for (const SupportFrame& frame : support_frames(task_, candidate_)) {
          values.insert(values.end(), {frame.centre_of_mass, frame.pressure});
        }
        if (!values.empty()) table_.names = {"centre_of_mass", "pressure"};
        values = in_frames(std::move(values));
        return;
      case MotionSeries::effectors:
        return add_effectors();
      case MotionSeries::node_translations:
      case MotionSeries::node_rotations:
        return add_nodes(series == MotionSeries::node_rotations);
      case MotionSeries::upper_limits:
        name_joints();
        for (int f = 0; f < clip_.frames; ++f) {
          for (int d = 0; d < clip_.dofs; ++d) {
            values.push_back(upper_limit(task_.body, d, clip_.frame(f)));
          }
        }
        return;
      case MotionSeries::things:
        return add_things();
    }
  }

  void name_joints() {
    for (const Dof& dof : task_.body.dofs()) table_.names.push_back(dof.name);
  }

  // A table of the motion's own frames, in these.
  [[nodiscard]] std::vector<double> in_frames(std::vector<double> own) const {
    if (!settings_.rate || own.empty()) return own;
    const Clip& from = candidate_.motion.clip;
    const std::size_t last = index(from.frames - 1);
    const std::size_t width = own.size() / index(from.frames);
    std::vector<double> values;
    for (int f = 0; f < clip_.frames; ++f) {
      const double at = from.frame_time > 0.0 ? f * clip_.frame_time / from.frame_time : 0.0;
      const std::size_t before = std::min(static_cast<std::size_t>(at), last);
      const std::size_t after = std::min(before + 1, last);
      const double share = min(at - static_cast<double>(before), 1.0);
      for (std::size_t k = 0; k < width; ++k) {
        const double first = own[before * width + k];
        values.push_back(first + (own[after * width + k] - first) * share);
      }
    }
    return values;
  }

  void add_effectors() {
    const auto& own = candidate_.motion.effectors;
    table_.components = point_components();
    for (std::size_t e = 0; e < own.size(); ++e) {
      const bool named = e < candidate_.goals.size();
      table_.names.push_back(named ? candidate_.goals[e].asked.effector : std::string());
    }
    Kinematics<double> placed(task_.body);
    for (int f = 0; f < clip_.frames; ++f) {
      if (settings_.rate) forward_kinematics<double>(task_.body, clip_.frame(f), placed);
      for (std::size_t e = 0; e < own.size(); ++e) {
        const auto effector = task_.body.find_effector(table_.names[e]);
        if (!settings_.rate || !effector) {
          add(own[e][std::min(index(f), own[e].size() - 1)], table_.values);
          continue;
        }
        const Effector& of = task_.body.effector(*effector);
        add(placed.point(of.link, of.point), table_.values);
      }
    }
  }

  void add_nodes(bool rotations) {
    for (const CharacterNode& node : character_nodes(character_, task_)) {
      table_.names.push_back(node.name);
    }
    table_.components = point_components();
    if (rotations) table_.components.emplace_back("w");
    for (const LocalTransform& local :
         node_motion(character_, task_, candidate_, clip_, settings_.place)) {
      if (rotations) {
        add(local.rotation, table_.values);
      } else {
        add(local.translation, table_.values);
      }
    }
  }

  void add_things() {
    std::vector<ThingMotion> things =
        settings_.rate ? things_at(candidate_, *settings_.rate) : candidate_.things;
    std::erase_if(things, [this](const ThingMotion& thing) {
      return thing.poses.size() != index(clip_.frames);
    });
    table_.components = {"x", "y", "z", "qx", "qy", "qz", "qw"};
    for (const ThingMotion& thing : things) table_.names.push_back(thing.thing.name);
    for (std::size_t f = 0; f < index(clip_.frames); ++f) {
      for (const ThingMotion& thing : things) {
        add(thing.poses[f].translation, table_.values);
        add(to_quat(thing.poses[f].rotation), table_.values);
      }
    }
  }

  const CharacterSpec& character_;
  const Task& task_;
  const Candidate& candidate_;
  const SeriesSettings& settings_;
  Clip clip_;
  SeriesTable table_{};
};

const char* unit_of(MotionSeries series) {
  switch (series) {
    case MotionSeries::time:
      return "s";
    case MotionSeries::angles:
    case MotionSeries::upper_limits:
      return "rad";
    case MotionSeries::torques:
      return "N m";
    case MotionSeries::centre_of_mass:
    case MotionSeries::support:
    case MotionSeries::effectors:
    case MotionSeries::things:
      return "m";
    case MotionSeries::node_translations:
    case MotionSeries::node_rotations:
      return "";
  }
  return "";
}

}  // namespace

Result<SeriesSettings> parse_series_settings(std::string_view text, std::string_view name) {
  SHG_TRY_ASSIGN(const Json json, parse_json(text, name));
  JsonReader reader(json, std::string(name) + ": ");
  SeriesSettings settings;
  if (reader.has("fps")) reader.number("fps", settings.rate.emplace(), kRateMin, kRateMax);
  reader.word("place", settings.place);
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return settings;
}

Result<SeriesTable> motion_series(const CharacterSpec& character, const Task& task,
                                  const Candidate& candidate, MotionSeries series,
                                  const SeriesSettings& settings) {
  if (settings.rate) SHG_TRY(check_rate(*settings.rate, "fps"));
  return SeriesMaker(character, task, candidate, settings).table(series);
}

std::string format_series(MotionSeries series, const SeriesTable& table) {
  Json json{{"name", word_of(series)},
            {"unit", unit_of(series)},
            {"fps", table.frame_time > 0.0 ? 1.0 / table.frame_time : 0.0},
            {"shape", {table.frames}}};
  const auto add_dimension = [&json](const char* key, const std::vector<std::string>& names) {
    json["shape"].push_back(names.size());
    json[key] = names;
  };
  if (!table.names.empty() || table.values.empty()) add_dimension("names", table.names);
  if (!table.components.empty()) add_dimension("components", table.components);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace shigusa
