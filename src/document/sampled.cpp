// SPDX-License-Identifier: MIT
#include "sampled.hpp"

#include <shigusa/series.hpp>

#include "core/index.hpp"
#include "export_file.hpp"
#include "kinematics/forward_kinematics.hpp"

namespace shigusa {

Result<Candidate> sampled(const CharacterSpec& character, const Task& task,
                          const Candidate& candidate, double rate) {
  SHG_TRY_ASSIGN(Clip clip, clip_at_rate(character, task, candidate, rate));
  const auto at_rate = [&](MotionSeries series) {
    return motion_series(character, task, candidate, series, {.rate = rate});
  };
  SHG_TRY_ASSIGN(SeriesTable torques, at_rate(MotionSeries::torques));
  SHG_TRY_ASSIGN(const SeriesTable centre, at_rate(MotionSeries::centre_of_mass));
  SHG_TRY_ASSIGN(const SeriesTable effectors, at_rate(MotionSeries::effectors));
  const auto point = [](const SeriesTable& table, std::size_t k) {
    return Vec3d{table.values[3 * k], table.values[3 * k + 1], table.values[3 * k + 2]};
  };
  Candidate result = candidate;
  Motion& motion = result.motion;
  motion.torques = std::move(torques.values);
  motion.centre_of_mass.clear();
  for (auto& way : motion.effectors) way.clear();
  for (std::size_t f = 0; f < index(clip.frames); ++f) {
    motion.centre_of_mass.push_back(point(centre, f));
    for (std::size_t e = 0; e < motion.effectors.size(); ++e) {
      motion.effectors[e].push_back(point(effectors, f * motion.effectors.size() + e));
    }
  }
  motion.clip = std::move(clip);
  result.things = things_at(candidate, rate);
  return result;
}

std::vector<Transformd> root_places(const BodyModel& body, const RobotFrame& robot,
                                    const Clip& clip) {
  Kinematics<double> kinematics(body);
  std::vector<Transformd> places;
  for (int f = 0; f < clip.frames; ++f) {
    forward_kinematics<double>(body, clip.frame(f), kinematics);
    const Mat3d r = kinematics.link_rotation(robot.link) * robot.root_in_link.rotation;
    places.push_back(
        {Mat3d{in_robot_world(r.cx), in_robot_world(r.cy), in_robot_world(r.cz)},
         in_robot_world(kinematics.point(robot.link, robot.root_in_link.translation))});
  }
  return places;
}

std::vector<double> of_joint(const RobotJoint& joint, const std::vector<double>& all, int dofs) {
  std::vector<double> values;
  for (std::size_t i = index(joint.dof); i < all.size(); i += index(dofs)) {
    values.push_back(0.0 + joint.sign * all[i]);  // 0.0 + avoids -0
  }
  return values;
}

}  // namespace shigusa
