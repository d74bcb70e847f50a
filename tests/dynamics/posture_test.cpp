// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/criteria.hpp>
#include <shigusa/kinematics.hpp>

#include "dynamics/clip_dynamics.hpp"
#include "formats/urdf.hpp"
#include "support/bodies.hpp"
#include "support/robot_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

constexpr double kStep = 1e-5;  // rad, of central differences: an error of step² for lengths of 1 m

struct NamedBody {
  const char* name;
  PosedBody (*make)();
};
void PrintTo(const NamedBody& body, std::ostream* out) { *out << body.name; }

class PostureOf : public testing::TestWithParam<NamedBody> {
 protected:
  // (f at the angles with one of them larger - f with it smaller) / (twice the step)
  template <class F>
  auto slope(std::size_t dof, F f) const {
    std::vector<double> q = angles;
    q[dof] += kStep;
    const auto after = f(Posture(posed, q));
    q[dof] -= 2 * kStep;
    return (after - f(Posture(posed, q))) * (0.5 / kStep);
  }
  // J, of the weight
  static double energy(const Posture& posture) {
    return posture.body().mass() * kGravity * posture.centre_of_mass().y;
  }

  const PosedBody posed = GetParam().make();
  Random random{3};
  const std::vector<double> angles = random_posture(posed, random);
  const Posture posture{posed, angles};
};

TEST_P(PostureOf, HasJacobiansThatAreDerivatives) {
  for (int link = kBaseLink; link < posed.body.dof_count(); ++link) {
    const Vec3d point{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 0.2};
    const PointJacobian jacobian = posture.jacobian(link, point);
    const Mat3d back = transpose(posture.place(link).rotation);
    for (std::size_t d = 0; d < angles.size(); ++d) {
      const Vec3d linear = slope(d, [&](const Posture& at) { return at.place(link) * point; });
      const Vec3d angular = slope(
          d, [&](const Posture& at) { return rotation_vector(at.place(link).rotation * back); });
      ASSERT_LT(norm(jacobian.linear[d] - linear), 1e-8)
          << link << ' ' << posed.body.dofs()[d].name;
      ASSERT_LT(norm(jacobian.angular[d] - angular), 1e-8)
          << link << ' ' << posed.body.dofs()[d].name;
    }
  }
}

TEST_P(PostureOf, HasTheCentreOfMassOfItsLinks) {
  Vec3d moment{};
  double mass = 0.0;
  for (int link = kBaseLink; link < posed.body.dof_count(); ++link) {
    const MassProperties& m = posed.body.link_mass(link);
    moment += posture.place(link) * m.com * m.mass;
    mass += m.mass;
  }
  EXPECT_LT(norm(posture.centre_of_mass() - moment * (1.0 / mass)), 1e-12);
}

TEST_P(PostureOf, PlacesWhatHasAName) {
  for (int k = 0; k < posed.body.effector_count(); ++k) {
    const Effector& effector = posed.body.effector(k);
    const Transformd place = posture.effector_place(effector.name).value();
    EXPECT_EQ(place.translation, posture.place(effector.link) * effector.point);
    EXPECT_EQ(place.rotation, posture.place(effector.link).rotation);
  }
  const std::vector<Transformd> nodes = node_places(posed, angles);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const BodyNode& node = posed.body.nodes()[k];
    EXPECT_EQ(nodes[k].translation, posture.place(node.link) * node.point);
    if (node.end_site) continue;
    EXPECT_EQ(posture.node_place(node.name).value().translation, nodes[k].translation);
  }
}

TEST_P(PostureOf, HoldsItselfAsAMotionAtRestDoes) {
  Clip still;
  still.dofs = posed.body.dof_count();
  still.frames = 3;
  for (int k = 0; k < still.frames; ++k) {
    still.angles.insert(still.angles.end(), angles.begin(), angles.end());
  }
  const Motion motion = ClipDynamics(posed).completed(still);
  const std::vector<double> held = posture.holding_torques();
  const auto second = motion.torques.begin() + posed.body.dof_count();
  EXPECT_EQ(held, std::vector<double>(second, second + posed.body.dof_count()));
}

// Only the joints between the second foot and the base carry the floor's force on that foot.
TEST_P(PostureOf, HoldsItselfAgainstTheSlopeOfItsEnergy) {
  const std::vector<double> held = posture.holding_torques();
  int compared = 0;
  for (int d = 0; d < posed.body.dof_count(); ++d) {
    bool bears = false;
    for (const Foot& foot : posed.body.feet()) bears = bears || posed.body.moves(d, foot.link);
    if (bears) continue;
    const auto k = static_cast<std::size_t>(d);
    // J: rounding of an energy of 1 kJ by the step
    EXPECT_NEAR(held[k], slope(k, energy), 1e-6) << posed.body.dofs()[k].name;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

std::string name_of(const testing::TestParamInfo<NamedBody>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Bodies, PostureOf,
    testing::Values(NamedBody{"chain",
                              [] {
                                return chain({{Axis::x, 1.0}, {Axis::z, 0.5}, {Axis::y, 0.3}});
                              }},
                    NamedBody{"full_body", [] { return full_body(); }},
                    NamedBody{"human", [] { return human_body(); }},
                    NamedBody{"heels", [] { return human_body({.heels = true}); }},
                    NamedBody{"robot",
                              [] {
                                const Robot robot = parse_urdf(RobotFile().text(), "small").value();
                                return build_robot(robot, find_humanoid(robot).value()).value();
                              }}),
    name_of);

TEST(Posture, OutlivesItsAngles) {
  const PosedBody posed = full_body();
  std::vector<double> angles(posed.home.angles.begin(), posed.home.angles.end());
  const Posture posture(posed, angles);
  angles.assign(angles.size(), 1.0);
  EXPECT_EQ(posture.effector_place("right_hand").value().translation,
            effector_position(posed, posed.home.angles, "right_hand"));
}

// The message of the PreconditionError that a call throws.
template <class Call>
std::string refusal_of(Call call) {
  try {
    call();
  } catch (const PreconditionError& error) {
    return error.what();
  }
  return "none";
}

TEST(Posture, RefusesWhatItsBodyHasNot) {
  const PosedBody posed = full_body();
  std::vector<double> angles(17);
  EXPECT_THAT(refusal_of([&] { Posture(posed, angles); }),
              HasSubstr("has 18 angles; 17 are given"));
  angles.resize(18);
  for (const double wrong : {__builtin_nan(""), 1e300, -2e6}) {
    angles[4] = wrong;
    EXPECT_THAT(refusal_of([&] { Posture(posed, angles); }), HasSubstr("of at most 1000000 rad"));
  }
  const Posture posture(posed, posed.home.angles);
  EXPECT_THAT(refusal_of([&] { (void)posture.place(18); }), HasSubstr("are -1 to 17; 18 is given"));
  EXPECT_THAT(refusal_of([&] { (void)posture.jacobian(-2, {}); }), HasSubstr("-2 is given"));
  for (const auto& unknown :
       {posture.effector_place("right_hnad"), posture.node_place("right_hnad")}) {
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::not_found);
    EXPECT_THAT(unknown.error().to_string(), HasSubstr("did you mean 'right_hand'"));
  }
}

}  // namespace
}  // namespace shigusa
