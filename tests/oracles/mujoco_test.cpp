// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <shigusa/kinematics.hpp>

#include "dynamics/centre_of_mass.hpp"
#include "dynamics/contact_forces.hpp"
#include "formats/urdf.hpp"
#include "support/bodies.hpp"
#include "support/mujoco_body.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// Both sides compute in double precision over at most 45 joints: they differ by some 1e-13.
constexpr double kTolerance = 1e-9;

PosedBody character(BodyExtent extent = BodyExtent::full) {
  return build_human(asymmetric_person(), {"character", extent, 1.6, 55.0, Sex::female});
}

PosedBody one_leg_up() {
  Landmarks person = asymmetric_person();
  lift_leg(person.right_leg, 1.2);
  return build_human(person, {"one_leg_up", BodyExtent::full, 1.6, 80.0, Sex::male});
}

// Every other dof about an axis that is no coordinate axis, as in robots.
PosedBody slanting() {
  BodyDefinition body = character().body.definition();
  Random random(5);
  for (std::size_t d = 0; d < body.dofs.size(); d += 2) {
    body.dofs[d].turn = rotation(Axis::x, random.uniform(-2.0, 2.0)) *
                        rotation(Axis::y, random.uniform(-2.0, 2.0)) *
                        rotation(Axis::z, random.uniform(-2.0, 2.0));
  }
  body.name = "slanting";
  return {BodyModel(std::move(body)), character().home};
}

PosedBody robot() {
  const Robot robot = parse_urdf(RobotFile().text(), "small.urdf").value();
  return build_robot(robot, find_humanoid(robot).value()).value();
}

// (dofs) each; angles go well beyond the limits
struct State {
  std::vector<double> q;
  std::vector<double> qd;
  std::vector<double> qdd;

  State(const BodyModel& body, Random& random)
      : q(random_vector(body, -3.0, 3.0, random)),
        qd(random_vector(body, -6.0, 6.0, random)),
        qdd(random_vector(body, -40.0, 40.0, random)) {}
};

struct Torques {
  std::vector<double> tau;
  Wrench<double> ground;

  Torques(const BodyModel& body, const Kinematics<double>& kinematics, const State& state)
      : tau(state.q.size()) {
    DynamicsWorkspace<double> work(body);
    ground = inverse_dynamics<double>(body, kinematics, {state.qd, state.qdd}, work, tau);
  }
};

// The largest difference of two vectors, as a share of the larger one's largest entry.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::fmax(largest, std::fabs(a[i] - b[i]));
    size = std::fmax(size, std::fmax(std::fabs(a[i]), std::fabs(b[i])));
  }
  return size == 0.0 ? 0.0 : largest / size;
}

double difference(const Vec3d& a, const Vec3d& b) {
  return difference(std::vector<double>{a.x, a.y, a.z}, std::vector<double>{b.x, b.y, b.z});
}

double difference(const Mat3d& a, const Mat3d& b) { return distance(a, b); }

struct NamedBody {
  const char* name;
  PosedBody (*make)();
};
void PrintTo(const NamedBody& body, std::ostream* out) { *out << body.name; }

class MujocoOracle : public testing::TestWithParam<NamedBody> {
 protected:
  // calls check(kinematics, state) at random states that MuJoCo has taken too
  template <class Check>
  void at_random_states(Check check) {
    Random random(11);
    for (int trial = 0; trial < 200; ++trial) {
      const State state(body, random);
      mujoco.set_state(state.q, state.qd, state.qdd);
      check(placed(body, state.q), state);
      if (HasFailure()) return;
    }
  }

  const BodyModel body = GetParam().make();
  MujocoBody mujoco{body};
};

TEST_P(MujocoOracle, PlacesLinksAlike) {
  at_random_states([&](const Kinematics<double>& kinematics, const State&) {
    for (int d = kBaseLink; d < body.dof_count(); ++d) {
      if (d != kBaseLink) {
        const auto k = static_cast<std::size_t>(d);
        ASSERT_LT(norm(kinematics.origin[k] - mujoco.joint_centre(d)), kTolerance);
        ASSERT_LT(norm(kinematics.axis[k] - mujoco.joint_axis(d)), kTolerance);
      }
      if (body.link_mass(d).mass == 0.0) continue;
      const Transformd frame = mujoco.frame(d);
      ASSERT_LT(difference(kinematics.link_rotation(d), frame.rotation), kTolerance);
      ASSERT_LT(norm(kinematics.link_origin(d) - frame.translation), kTolerance);
    }
  });
}

TEST_P(MujocoOracle, PlacesEffectorsAlike) {
  at_random_states([&](const Kinematics<double>& kinematics, const State&) {
    for (const Effector& effector : body.effectors()) {
      const Vec3d expected = mujoco.frame(effector.link) * effector.point;
      ASSERT_LT(norm(kinematics.point(effector.link, effector.point) - expected), kTolerance);
    }
  });
}

TEST_P(MujocoOracle, HasTheSameJacobians) {
  const auto check = [&](const Posture& posture, int link, const Vec3d& point) {
    const PointJacobian ours = posture.jacobian(link, point);
    const MujocoBody::PointJacobian expected = mujoco.jacobian(link, posture.place(link) * point);
    for (std::size_t d = 0; d < body.dofs().size(); ++d) {
      ASSERT_LT(norm(ours.linear[d] - expected.position[d]), kTolerance);
      ASSERT_LT(norm(ours.angular[d] - expected.rotation[d]), kTolerance);
    }
  };
  at_random_states([&](const Kinematics<double>&, const State& state) {
    const Posture posture(body, state.q);
    for (const Effector& effector : body.effectors()) {
      check(posture, effector.link, effector.point);
    }
    for (const Foot& foot : body.feet()) check(posture, foot.link, foot.centre);
  });
}

TEST_P(MujocoOracle, HasTheSameCentreOfMass) {
  at_random_states([&](const Kinematics<double>& kinematics, const State&) {
    ASSERT_LT(norm(centre_of_mass(body, kinematics) - mujoco.centre_of_mass()), kTolerance);
  });
}

TEST_P(MujocoOracle, NeedsTheSameTorques) {
  at_random_states([&](const Kinematics<double>& kinematics, const State& state) {
    const Torques torques(body, kinematics, state);
    ASSERT_LT(difference(torques.tau, mujoco.inverse_torques()), kTolerance);
  });
}

TEST_P(MujocoOracle, PushesTheFloorAlike) {
  at_random_states([&](const Kinematics<double>& kinematics, const State& state) {
    const Torques torques(body, kinematics, state);
    const Wrench<double> expected = mujoco.ground_wrench();
    ASSERT_LT(difference(torques.ground.force, expected.force), kTolerance);
    ASSERT_LT(difference(torques.ground.moment, expected.moment), kTolerance);
  });
}

class MujocoOracleOnTwoFeet : public MujocoOracle {};

TEST_P(MujocoOracleOnTwoFeet, SecondFootRelievesTheJointsByItsJacobian) {
  const Foot& second = body.feet()[1];
  at_random_states([&](const Kinematics<double>& kinematics, const State& state) {
    Torques torques(body, kinematics, state);
    const Wrench<double> part =
        share_ground_wrench<double>(body, kinematics, state.q, torques.ground, torques.tau);
    const Vec3d at = kinematics.point(second.link, second.centre);
    const Vec3d moment = part.moment - cross(at, part.force);
    const MujocoBody::PointJacobian jacobian = mujoco.jacobian(second.link, at);
    std::vector<double> expected = mujoco.inverse_torques();
    for (std::size_t d = 0; d < expected.size(); ++d) {
      expected[d] -= dot(jacobian.position[d], part.force) + dot(jacobian.rotation[d], moment);
    }
    ASSERT_LT(difference(torques.tau, expected), kTolerance);
  });
}

std::string name_of(const testing::TestParamInfo<NamedBody>& test) { return test.param.name; }

const NamedBody kFullBody{"full_body", [] { return full_body(); }};
const NamedBody kSmallWoman{"small_woman", [] { return full_body({1.48, 44.0, Sex::female}); }};
const NamedBody kCharacter{"character", [] { return character(); }};
const NamedBody kHuman{"human", [] { return human_body(); }};
const NamedBody kHeels{"heels", [] { return human_body({.heels = true}); }};
const NamedBody kWholeCharacter{"whole_character", [] { return character(BodyExtent::human); }};
const NamedBody kSlanting{"slanting", slanting};
const NamedBody kRobot{"robot", robot};

INSTANTIATE_TEST_SUITE_P(Bodies, MujocoOracle,
                         testing::Values(NamedBody{"half_body", [] { return half_body(); }},
                                         NamedBody{"one_leg_up", one_leg_up}, kFullBody,
                                         kSmallWoman, kCharacter, kHuman, kHeels, kWholeCharacter,
                                         kSlanting, kRobot),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Bodies, MujocoOracleOnTwoFeet,
                         testing::Values(kFullBody, kSmallWoman, kCharacter, kHuman, kHeels,
                                         kWholeCharacter, kSlanting, kRobot),
                         name_of);

}  // namespace
}  // namespace shigusa
