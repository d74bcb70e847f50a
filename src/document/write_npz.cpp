// SPDX-License-Identifier: MIT
// Arrays for controllers of robots: joints and bodies over time, in a world with z up and x ahead.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/index.hpp"
#include "core/say.hpp"
#include "export_file.hpp"
#include "formats/npz.hpp"
#include "formats/urdf.hpp"
#include "kinematics/forward_kinematics.hpp"
#include "math/turn_about.hpp"
#include "sampled.hpp"

namespace shigusa {
namespace {

// A joint over time.
struct JointWay {
  std::string name;
  std::vector<double> values;   // (frames) rad, or m if it slides
  std::vector<double> torques;  // (frames) N·m
};

// Joints and bodies over time, the root first.
struct RobotWay {
  std::vector<JointWay> joints;
  std::vector<std::string> bodies;
  std::vector<std::vector<Transformd>> places;  // [body][frame]
};

// A person's degrees of freedom, and nodes with axes that are the world's in the posture of zero
// angles.
RobotWay way_of_person(const BodyModel& body, const Motion& motion) {
  const Clip& clip = motion.clip;
  RobotWay way;
  for (int d = 0; d < body.dof_count(); ++d) {
    const RobotJoint joint{.name = body.dof(d).name, .dof = d};
    way.joints.push_back({joint.name, of_joint(joint, clip.angles, clip.dofs),
                          of_joint(joint, motion.torques, clip.dofs)});
  }
  Kinematics<double> kinematics(body);
  const auto frames = index(clip.frames);
  for (std::size_t f = 0; f < frames; ++f) {
    forward_kinematics<double>(body, clip.frame(static_cast<int>(f)), kinematics);
    std::size_t b = 0;
    for (const BodyNode& node : body.nodes()) {
      if (node.end_site) continue;
      if (f == 0) {
        way.bodies.push_back(node.name);
        way.places.emplace_back(frames);
      }
      const Mat3d& r = kinematics.link_rotation(node.link);
      way.places[b++][f] = {{in_robot_world(r.cz), in_robot_world(r.cx), in_robot_world(r.cy)},
                            in_robot_world(kinematics.point(node.link, node.point))};
    }
  }
  return way;
}

// A robot's joints and links as its file has them, from the root link on.
Result<RobotWay> way_of_robot(const WriteRequest& request, const RobotFrame& frame,
                              const Motion& motion) {
  const CharacterSpec& character = request.character;
  if (!character.urdf) {
    return fail(ErrorCode::invalid_argument, say("file_needed", character.source),
                "the format npz");
  }
  SHG_TRY_ASSIGN(const Robot robot, parse_urdf(*character.urdf, character.source));
  const Clip& clip = motion.clip;
  const auto frames = index(clip.frames);
  RobotWay way;
  std::map<std::string, std::size_t> known;  // joints by name
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    const RobotJoint& joint = frame.joints[j];
    const auto carries = [j](const RootJoint& carrier) { return carrier.joint == j; };
    if (std::any_of(frame.carriers.begin(), frame.carriers.end(), carries)) continue;
    known[joint.name] = way.joints.size();
    const bool moves = joint.dof >= 0;
    way.joints.push_back(
        {joint.name,
         moves ? of_joint(joint, clip.angles, clip.dofs) : std::vector(frames, joint.angle),
         moves ? of_joint(joint, motion.torques, clip.dofs) : std::vector(frames, 0.0)});
  }
  std::vector<int> number(robot.links.size(), -1);  // of each link among the bodies
  const auto add = [&](std::size_t link, std::vector<Transformd> places) {
    number[link] = static_cast<int>(way.bodies.size());
    way.bodies.push_back(robot.links[link].name);
    way.places.push_back(std::move(places));
  };
  std::vector<const Robot::Joint*> carrier(robot.links.size(), nullptr);
  for (const Robot::Joint& joint : robot.joints) carrier[index(joint.child)] = &joint;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (robot.links[link].name == frame.root) {
      add(link, root_places(request.task.body, frame, clip));
      continue;
    }
    const Robot::Joint* const joint = carrier[link];
    if (joint == nullptr || number[index(joint->parent)] < 0) continue;  // above the root
    const auto named = known.find(joint->name);
    std::vector<Transformd> places = way.places[index(number[index(joint->parent)])];
    for (std::size_t f = 0; f < frames; ++f) {
      places[f] = places[f] * joint->origin;
      if (named == known.end()) continue;
      const double value = way.joints[named->second].values[f];
      places[f] = places[f] * (joint->slides ? Transformd{{}, joint->axis * value}
                                             : Transformd{turn_about(joint->axis, value), {}});
    }
    add(link, std::move(places));
  }
  return way;
}

// Derivatives in all frames as numpy.gradient has them: half the difference of the neighbours, and
// at both ends the difference of two. `difference(a, b)` is the way from frame a to frame b.
template <class Difference>
auto rates(std::size_t frames, double frame_time, const Difference& difference) {
  std::vector<decltype(difference(0, 0))> all(frames);
  for (std::size_t f = 0; frames > 1 && f < frames; ++f) {
    const std::size_t before = f == 0 ? 0 : f - 1;
    const std::size_t after = std::min(f + 1, frames - 1);
    all[f] = difference(before, after) * (1.0 / (static_cast<double>(after - before) * frame_time));
  }
  return all;
}

void put(const Vec3d& v, std::vector<double>& values) {
  values.insert(values.end(), {v.x, v.y, v.z});
}
void put(const Quatd& q, std::vector<double>& values) {
  values.insert(values.end(), {q.w, q.x, q.y, q.z});
}

// The motions of bodies, frame by frame.
struct BodyTables {
  std::vector<double> positions, turns, velocities, spins;  // (frames × bodies × 3 or 4)
};

BodyTables body_tables(const RobotWay& way, std::size_t frames, double frame_time) {
  std::vector<std::vector<Vec3d>> velocities;
  std::vector<std::vector<Vec3d>> spins;
  std::vector<Quatd> before(way.places.size());
  for (const std::vector<Transformd>& places : way.places) {
    velocities.push_back(rates(frames, frame_time, [&](std::size_t a, std::size_t b) {
      return places[b].translation - places[a].translation;
    }));
    spins.push_back(rates(frames, frame_time, [&](std::size_t a, std::size_t b) {
      return rotation_vector(places[b].rotation * transpose(places[a].rotation));
    }));
  }
  BodyTables tables;
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t b = 0; b < way.places.size(); ++b) {
      const Transformd& place = way.places[b][f];
      before[b] = nearer(to_quat(place.rotation), before[b]);
      put(place.translation, tables.positions);
      put(before[b], tables.turns);
      put(velocities[b][f], tables.velocities);
      put(spins[b][f], tables.spins);
    }
  }
  return tables;
}

// Feet that stand, then those that go to goals, and whether each stands: (frames × feet).
void add_contacts(const BodyModel& body, const Candidate& candidate, std::size_t frames,
                  std::vector<NpzArray>& arrays) {
  std::vector<std::string> names;
  for (const ContactResult& contact : candidate.contacts) names.push_back(contact.effector);
  const std::size_t standing = names.size();
  for (const GoalResult& goal : candidate.goals) {
    const auto effector = body.find_effector(goal.asked.effector);
    const bool is_foot = effector && body.effector(*effector).part.joint_kind == JointKind::foot;
    if (is_foot) names.push_back(goal.asked.effector);
  }
  std::vector<std::uint8_t> stands;
  for (std::size_t k = 0; k < frames * names.size(); ++k) {
    stands.push_back(k % names.size() < standing ? 1 : 0);
  }
  arrays.push_back({"contacts", {frames, names.size()}, std::move(stands)});
  arrays.push_back({"contact_names", {names.size()}, std::move(names)});
}

Result<std::string> motion_npz(const WriteRequest& request) {
  const double rate = request.settings.rate.value_or(info_of(FileFormat::npz).rate);
  SHG_TRY_ASSIGN(const Candidate candidate,
                 sampled(request.character, request.task, request.candidate, rate));
  const Motion& motion = candidate.motion;
  RobotWay way;
  if (request.task.robot) {
    SHG_TRY_ASSIGN(way, way_of_robot(request, *request.task.robot, motion));
  } else {
    way = way_of_person(request.task.body, motion);
  }
  const auto frames = index(motion.clip.frames);
  const double frame_time = motion.clip.frame_time;
  const std::size_t bodies = way.bodies.size();
  const std::size_t joints = way.joints.size();
  BodyTables tables = body_tables(way, frames, frame_time);
  std::vector<std::string> names;
  std::vector<std::vector<double>> speeds;
  for (const JointWay& joint : way.joints) {
    names.push_back(joint.name);
    speeds.push_back(rates(frames, frame_time, [&](std::size_t a, std::size_t b) {
      return joint.values[b] - joint.values[a];
    }));
  }
  std::vector<double> positions;
  std::vector<double> velocities;
  std::vector<double> torques;
  const auto copy = [&](const std::vector<double>& from, std::size_t frame, std::size_t width,
                        std::vector<double>& to) {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(frame * bodies * width);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
  };
  for (std::size_t f = 0; f < frames; ++f) {
    copy(tables.positions, f, 3, positions);
    copy(tables.turns, f, 4, positions);
    copy(tables.velocities, f, 3, velocities);
    copy(tables.spins, f, 3, velocities);
    for (std::size_t j = 0; j < joints; ++j) {
      positions.push_back(way.joints[j].values[f]);
      velocities.push_back(speeds[j][f]);
      torques.push_back(way.joints[j].torques[f]);
    }
  }
  std::vector<NpzArray> arrays{
      {"fps", {}, std::vector{rate}},
      {"joint_pos", {frames, 7 + joints}, std::move(positions)},
      {"joint_vel", {frames, 6 + joints}, std::move(velocities)},
      {"body_pos_w", {frames, bodies, 3}, std::move(tables.positions)},
      {"body_quat_w", {frames, bodies, 4}, std::move(tables.turns)},
      {"body_lin_vel_w", {frames, bodies, 3}, std::move(tables.velocities)},
      {"body_ang_vel_w", {frames, bodies, 3}, std::move(tables.spins)},
      {"torques", {frames, joints}, std::move(torques)},
      {"joint_names", {joints}, std::move(names)},
      {"body_names", {bodies}, std::move(way.bodies)}};
  add_contacts(request.task.body, candidate, frames, arrays);
  return format_npz(arrays);
}

}  // namespace

template <>
Result<MadeFile> write_as<FileFormat::npz>(const WriteRequest& request) {
  return unread(motion_npz(request));
}

}  // namespace shigusa
