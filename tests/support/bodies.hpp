// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/human.hpp>
#include <shigusa/run.hpp>
#include <string>
#include <vector>

#include "kinematics/forward_kinematics.hpp"
#include "math/rotation_samples.hpp"

// Bodies and postures for tests: the smallest bodies that show a claim, and random people.
namespace shigusa::testing_support {

// A hinge at the world's origin with a point mass at the end of a massless rod. At angle 0 the rod
// stands upright; positive angles turn it about `axis`.
struct Pendulum {
  Axis axis = Axis::x;
  double length = 1.0;  // m
  double mass = 1.0;    // kg
};

inline Dof hinge(std::string name, int parent, const Vec3d& offset, Axis axis = Axis::x) {
  Dof dof;
  dof.joint = name;
  dof.name = name + ".flexion";
  dof.parent = parent;
  dof.offset = offset;
  dof.axis = axis;
  dof.lower = -2.0;
  dof.upper = 2.0;
  return dof;
}

// A chain of upright rods with a hinge at the foot of each, and an effector "tip" at the end.
inline BodyDefinition chain_definition(const std::vector<Pendulum>& rods) {
  BodyDefinition body;
  body.name = "chain";
  Vec3d offset{};
  for (const Pendulum& rod : rods) {
    const int parent = static_cast<int>(body.dofs.size()) - 1;
    body.dofs.push_back(hinge("hinge_" + std::to_string(parent + 1), parent, offset, rod.axis));
    MassProperties mass;
    mass.mass = rod.mass;
    mass.com = {0, rod.length, 0};
    body.masses.push_back(mass);
    body.mass += rod.mass;
    body.stature += rod.length;
    offset = {0, rod.length, 0};
  }
  const int last = static_cast<int>(rods.size()) - 1;
  body.effectors.push_back({"tip", "tip", last, offset, 0});
  return body;
}

// A body whose home has every angle at 0.
inline PosedBody at_zero(BodyDefinition definition) {
  const std::size_t dofs = definition.dofs.size();
  return {BodyModel(std::move(definition)), {.angles = std::vector<double>(dofs)}};
}

inline PosedBody chain(const std::vector<Pendulum>& rods) {
  return at_zero(chain_definition(rods));
}

// (dofs) uniform in [low, high]
inline std::vector<double> random_vector(const BodyModel& body, double low, double high,
                                         Random& random) {
  std::vector<double> values;
  for (int d = 0; d < body.dof_count(); ++d) values.push_back(random.uniform(low, high));
  return values;
}

// (dofs, rad) uniform within each joint's limits
inline std::vector<double> random_posture(const BodyModel& body, Random& random) {
  std::vector<double> angles;
  for (const Dof& dof : body.dofs()) angles.push_back(random.uniform(dof.lower, dof.upper));
  return angles;
}

inline Kinematics<double> placed(const BodyModel& body, std::span<const double> angles) {
  Kinematics<double> kinematics(body);
  forward_kinematics<double>(body, angles, kinematics);
  return kinematics;
}

// World position (m) of an effector by its name.
inline Vec3d effector_position(const BodyModel& body, std::span<const double> angles,
                               const char* name) {
  const Effector& effector = body.effector(body.find_effector(name).value());
  return placed(body, angles).point(effector.link, effector.point);
}

// All landmarks of a person, for loops.
inline std::vector<Vec3d*> all_points(Landmarks& person) {
  std::vector<Vec3d*> points{&person.neck, &person.head_top};
  for (Landmarks::Leg* leg : {&person.left_leg, &person.right_leg}) {
    points.insert(points.end(), {&leg->hip, &leg->knee, &leg->ankle, &leg->toe});
  }
  for (Landmarks::Arm* arm : {&person.left_arm, &person.right_arm}) {
    points.insert(points.end(), {&arm->shoulder, &arm->elbow, &arm->wrist, &arm->fingertip});
  }
  return points;
}

// Moves each landmark by up to `by` (m) along each axis: the two sides of real people and drawn
// characters differ.
inline Landmarks perturbed(Landmarks person, double by, Random& random) {
  for (Vec3d* point : all_points(person)) {
    *point += Vec3d{random.uniform(-by, by), random.uniform(-by, by), random.uniform(-by, by)};
  }
  return person;
}

// Points an arm along two directions (world) and keeps its segments' lengths; the hand continues
// the forearm.
inline void point_arm(Landmarks::Arm& arm, const Vec3d& upper, const Vec3d& fore) {
  const double upper_length = norm(arm.elbow - arm.shoulder);
  const double fore_length = norm(arm.wrist - arm.elbow);
  const double hand_length = norm(arm.fingertip - arm.wrist);
  arm.elbow = arm.shoulder + normalized(upper) * upper_length;
  arm.wrist = arm.elbow + normalized(fore) * fore_length;
  arm.fingertip = arm.wrist + normalized(fore) * hand_length;
}

// Lifts a foot by bending the knee (rad): thigh forwards, shank back.
inline void lift_leg(Landmarks::Leg& leg, double bend) {
  const double thigh = norm(leg.knee - leg.hip);
  const double shank = norm(leg.ankle - leg.knee);
  const Vec3d foot = leg.toe - leg.ankle;
  const SinCos<double> half = sin_cos(0.5 * bend);
  leg.knee = leg.hip + Vec3d{0, -half.cos, half.sin} * thigh;
  leg.ankle = leg.knee + Vec3d{0, -half.cos, -half.sin} * shank;
  leg.toe = leg.ankle + foot;
}

// A character with different sides, turned feet and half raised arms.
inline Landmarks asymmetric_person() {
  Random random(7);
  Landmarks person = perturbed(standing_landmarks(1.6, radians(15.0)), 0.02, random);
  point_arm(person.left_arm, {0.8, -0.5, 0.3}, {0.3, 0.2, 0.9});
  point_arm(person.right_arm, {-0.3, -0.9, 0.2}, {-0.1, -0.3, 0.9});
  return person;
}

}  // namespace shigusa::testing_support
