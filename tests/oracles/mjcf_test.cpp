// SPDX-License-Identifier: MIT
// MJCF files as read by MuJoCo itself: positions of bodies at any angles, masses, and positions in
// an exported motion.
#include "formats/mjcf.hpp"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <memory>
#include <shigusa/files.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/math.hpp>
#include <shigusa/run.hpp>

#include "core/check.hpp"
#include "support/mjcf_file.hpp"
#include "support/robot_reader.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

// All features of the reader: each shape, by size and between points, each orientation, inertias of
// both forms, off-centre hinges, a ball, a reference angle, nested classes.
const char* const kEverything = R"(<mujoco model="all">
<compiler angle="degree" eulerseq="zXy"/>
<default><geom density="700"/><default class="c"><geom type="capsule" size="0.05 0.2"/>
<default class="d"><geom pos="0.1 0.2 0.3" euler="10 20 30"/></default></default></default>
<worldbody><body name="root" pos="1 2 3" quat="0.5 0.1 0.7 0.3"><freejoint/>
<geom type="box" size="0.1 0.2 0.3" pos="0.3 0.2 0.1" euler="30 40 50"/>
<geom type="ellipsoid" size="0.1 0.15 0.2" axisangle="1 2 3 70"/>
<body name="one" pos="0.1 0.2 0.3" axisangle="0 1 1 40" childclass="d">
<joint name="j1" axis="1 1 0" pos="0.1 0 0.05"/><joint name="j2" axis="0 1 0.3" pos="0 0.2 0"/>
<geom/><geom class="c" fromto="0 0 0.1 0.3 0.2 0.1"/>
<geom class="c" type="cylinder" fromto="0.1 0 0 0.1 0.4 0" size="0.03" mass="0.7"/>
<geom class="c" type="box" fromto="0 0 0 0.2 0.1 0.3" size="0.02"/>
<geom class="c" type="ellipsoid" fromto="0 0.5 0 0.2 0.1 0.3" size="0.04"/>
<body name="two" pos="0.2 0 0.4" xyaxes="1 2 0 0 1 1"><joint name="ball" type="ball"/>
<inertial pos="0.1 0.2 0.3" quat="0.9 0.2 0.1 0.3" mass="2.5" diaginertia="0.03 0.04 0.05"/>
<geom class="main" type="sphere" size="0.2"/>
<body name="three" zaxis="1 1 -0.5" pos="0 0 0.3">
<joint name="j3" axis="0 0 1" ref="25" pos="0.02 0.01 0"/>
<inertial pos="0.1 0 0" mass="1.5" fullinertia="0.03 0.04 0.05 0.001 0.002 0.003"/>
<body name="four" pos="0.3 0 0" zaxis="0 0 -1"><geom class="main" size="0.1" zaxis="0 1 0"/></body>
</body></body></body></body></worldbody></mujoco>)";

class MujocoModel {
 public:
  explicit MujocoModel(const std::string& path) {
    char error[500] = "";
    model_.reset(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
    SHG_CHECK(model_ != nullptr, error);
    data_.reset(mj_makeData(model_.get()));
  }

  [[nodiscard]] const mjModel& model() const { return *model_; }
  [[nodiscard]] mjData& data() { return *data_; }
  void place() {
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
  }
  [[nodiscard]] int find(mjtObj kind, const std::string& name) const {
    return mj_name2id(model_.get(), kind, name.c_str());
  }
  // The first coordinate of a joint in qpos.
  [[nodiscard]] double* qpos(const std::string& joint) {
    const int id = find(mjOBJ_JOINT, joint);
    SHG_CHECK(id >= 0, joint.c_str());
    return data_->qpos + model_->jnt_qposadr[id];
  }
  void place_root(const Vec3d& at, const Quatd& q) {
    double* root = data_->qpos;
    for (int k = 0; k < 3; ++k) root[k] = at[k];
    root[3] = q.w;
    root[4] = q.x;
    root[5] = q.y;
    root[6] = q.z;
  }
  static Vec3d vector(const double* v) { return {v[0], v[1], v[2]}; }
  static Mat3d matrix(const double* rows) {
    return {{rows[0], rows[3], rows[6]}, {rows[1], rows[4], rows[7]}, {rows[2], rows[5], rows[8]}};
  }
  [[nodiscard]] Vec3d at(const std::string& body) const {
    return vector(data_->xpos + 3 * find(mjOBJ_BODY, body));
  }

 private:
  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
};

Quatd about(const Vec3d& axis, double angle) {
  const SinCos<double> half = sin_cos(0.5 * angle);
  return {axis.x * half.sin, axis.y * half.sin, axis.z * half.sin, half.cos};
}

// Sets each joint of the robot and of MuJoCo's model to the same angle; the links' positions.
std::vector<Transformd> turned(const Robot& robot, MujocoModel& mujoco, Random& random) {
  std::vector<Transformd> places(robot.links.size());
  std::map<std::string, Quatd> balls;
  for (const Robot::Joint& joint : robot.joints) {
    const double angle = joint.turns ? random.uniform(-2.0, 2.0) : 0.0;
    const Transformd turn{to_matrix(about(joint.axis, angle)), {}};
    places[static_cast<std::size_t>(joint.child)] =
        places[static_cast<std::size_t>(joint.parent)] * joint.origin * turn;
    if (!joint.turns) continue;
    if (mujoco.find(mjOBJ_JOINT, joint.name) >= 0) {
      *mujoco.qpos(joint.name) = angle;
    } else {
      const std::string ball = joint.name.substr(0, joint.name.size() - 2);
      const Quatd q = balls[ball] = balls[ball] * about(joint.axis, angle);
      const double values[] = {q.w, q.x, q.y, q.z};
      std::copy(std::begin(values), std::end(values), mujoco.qpos(ball));
    }
  }
  return places;
}

void expect_near(const Vec3d& ours, const Vec3d& theirs, const std::string& of) {
  // both add up some ten bodies within metres in doubles
  EXPECT_LE(norm(ours - theirs), 1e-12) << of;
}

void expect_near(const Mat3d& ours, const Mat3d& theirs, const std::string& of) {
  expect_near(ours.cx, theirs.cx, of);
  expect_near(ours.cy, theirs.cy, of);
  expect_near(ours.cz, theirs.cz, of);
}

void expect_same_bodies(const std::string& path) {
  const Robot robot =
      parse_mjcf(text_of(path), "r.xml", included_from(std::filesystem::path(path).parent_path()))
          .value();
  MujocoModel mujoco(path);
  const mjModel& m = mujoco.model();
  mjData& d = mujoco.data();
  Random random(3);
  for (int trial = 0; trial < 3; ++trial) {
    const std::vector<Transformd> places = turned(robot, mujoco, random);
    mujoco.place_root({}, {});
    mujoco.place();
    int bodies = 0;
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      const Robot::Link& link = robot.links[i];
      const int body = mujoco.find(mjOBJ_BODY, link.name);
      if (body < 0) continue;  // between the hinges of a body
      ++bodies;
      const int hinges = i == 0 ? 0 : m.body_jntnum[body];
      const double* origin =
          hinges == 0 ? d.xpos + 3 * body : d.xanchor + 3 * (m.body_jntadr[body] + hinges - 1);
      expect_near(places[i].translation, MujocoModel::vector(origin), link.name);
      expect_near(places[i].rotation, MujocoModel::matrix(d.xmat + 9 * body), link.name);
      EXPECT_NEAR(link.mass, m.body_mass[body], 1e-12 * link.mass) << link.name;
      if (link.mass == 0.0) continue;
      expect_near(places[i] * link.com, MujocoModel::vector(d.xipos + 3 * body), link.name);
      const Mat3d axes = MujocoModel::matrix(d.ximat + 9 * body);
      const double* i3 = m.body_inertia + 3 * body;
      const Mat3d theirs =
          axes * Mat3d{{i3[0], 0, 0}, {0, i3[1], 0}, {0, 0, i3[2]}} * transpose(axes);
      const Mat3d ours = places[i].rotation * link.inertia * transpose(places[i].rotation);
      // MuJoCo keeps principal axes, which it finds to some 1e-8
      const double size = 1e-7 * (i3[0] + i3[1] + i3[2]);
      for (int k = 0; k < 3; ++k) {
        EXPECT_LE(norm(ours.column(k) - theirs.column(k)), size) << "inertia of " << link.name;
      }
    }
    EXPECT_EQ(bodies, m.nbody - 1);
  }
}

TEST(MujocoReadsMjcf, AsWeDoWithEveryForm) {
  const WorkFolder work;
  expect_same_bodies(work.put("all.xml", kEverything));
}

TEST(MujocoReadsMjcf, AsWeDoTheResearchLayout) {
  const WorkFolder work;
  expect_same_bodies(work.put("research.xml", research_mjcf()));
}

// Models from other projects, with stand-ins for their included files.
std::string shared_model(const std::string& file, const WorkFolder& work) {
  const std::string path = std::string(SHIGUSA_SHARED_DIR) + "/characters/" + file;
  if (!std::filesystem::exists(path)) return "";
  work.put("common/skybox.xml", "<mujocoinclude><asset/></mujocoinclude>");
  work.put("common/visual.xml", "<mujocoinclude><visual/></mujocoinclude>");
  work.put("common/materials.xml",
           "<mujocoinclude><asset><material name=\"self\"/><material name=\"grid\"/></asset>"
           "</mujocoinclude>");
  return work.put(file, text_of(path));
}

class MujocoReadsShared : public testing::TestWithParam<const char*> {
 protected:
  const WorkFolder work_;
  const std::string path_ = shared_model(GetParam(), work_);
};

TEST_P(MujocoReadsShared, AsWeDo) {
  if (path_.empty()) GTEST_SKIP() << "no " << GetParam();
  expect_same_bodies(path_);
}

// A motion's table drives MuJoCo's model: the hand ends on its goal, and the feet stay.
void expect_replayed(const std::string& path) {
  for (const char* hand : {"right_hand", "left_hand"}) {
    TaskFile file;
    file.character.source = path;
    Task task = make_task(file, {}).value();
    const double aside = hand[0] == 'l' ? 0.15 : -0.15;
    task.goals = {{hand, Vec3d{aside, 0.5, 0.25} * task.body.stature()}};
    const GenerateResult generation = generate(task).value();
    ASSERT_TRUE(generation.meets_goals()) << hand;
    const Candidate& candidate = generation.candidates[0];
    const Table table(export_candidate(task, candidate, FileFormat::csv).value());
    MujocoModel mujoco(path);
    const mjModel& m = mujoco.model();
    std::map<std::string, Vec3d> first;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const auto cell = [&](const char* name) { return table.at(name, row); };
      mujoco.place_root({cell("root.x [m]"), cell("root.y [m]"), cell("root.z [m]")},
                        {cell("root.qx"), cell("root.qy"), cell("root.qz"), cell("root.qw")});
      for (int j = 0; j < m.njnt; ++j) {
        if (m.jnt_type[j] != mjJNT_HINGE) continue;
        const std::string name = mj_id2name(&m, mjOBJ_JOINT, j);
        const double angle = *mujoco.qpos(name) = table.at(name + " [rad]", row);
        if (m.jnt_limited[j] == 0) continue;
        ASSERT_GE(angle, m.jnt_range[2 * j] - 1e-12) << name;
        ASSERT_LE(angle, m.jnt_range[2 * j + 1] + 1e-12) << name;
      }
      mujoco.place();
      for (const ContactResult& contact : candidate.contacts) {
        const auto [found, fresh] = first.emplace(contact.node, mujoco.at(contact.node));
        ASSERT_LE(norm(mujoco.at(contact.node) - found->second), 1e-3) << contact.node << row;
      }
    }
    const Vec3d& goal = task.goals[0].position;
    // the effector stands in the last hinge of the hand's body, if it has one
    const int body = mujoco.find(mjOBJ_BODY, candidate.goals[0].node);
    ASSERT_GE(body, 0) << candidate.goals[0].node;
    const int hinges = m.body_jntnum[body];
    const double* end = hinges == 0
                            ? mujoco.data().xpos + 3 * body
                            : mujoco.data().xanchor + 3 * (m.body_jntadr[body] + hinges - 1);
    EXPECT_LE(norm(MujocoModel::vector(end) - Vec3d{goal.z, goal.x, goal.y}), 1e-3) << hand;
  }
}

TEST_P(MujocoReadsShared, AndPlaysMotionsToTheirGoal) {
  if (path_.empty()) GTEST_SKIP() << "no " << GetParam();
  expect_replayed(path_);
}

TEST(MujocoPlaysMjcf, MotionsEndOnTheirGoal) {
  const WorkFolder work;
  expect_replayed(work.put("research.xml", research_mjcf()));
}

INSTANTIATE_TEST_SUITE_P(Files, MujocoReadsShared,
                         testing::Values("mujoco__humanoid.xml", "dm_control__humanoid_CMU.xml"),
                         [](const auto& test) { return std::string(test.param).substr(0, 6); });

}  // namespace
}  // namespace shigusa
