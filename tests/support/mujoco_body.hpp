// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Eigenvalues>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/check.hpp"
#include "dynamics/inverse_dynamics.hpp"

// A BodyModel as a MuJoCo model: an oracle for kinematics and dynamics in tests, and a rival in the
// benchmark.
namespace shigusa::testing_support {

inline constexpr double kMujocoStep = 1e-3;  // s, of forward simulation

// Mass for a clavicle, which moves and has none of its own: far below the oracle's resolution.
inline const MassProperties kNextToNothing{
    1e-12, {}, {{1e-13, 0, 0}, {0, 1e-13, 0}, {0, 0, 1e-13}}};

// Whether the body's base is fixed to the world, or the body stands on its feet on a floor at y =
// 0.
enum class MujocoBase { fixed, on_the_floor };

// Writes the body as MJCF. MuJoCo requires mass on each moving body, so the dofs of one joint,
// which share a point and of which only the last has mass, become the hinges of one MuJoCo body.
class MjcfWriter {
 public:
  // `beside`: further bodies of the world. `constraints`: elements after the world.
  explicit MjcfWriter(const BodyModel& body, MujocoBase base = MujocoBase::fixed,
                      const std::string& beside = {}, const std::string& constraints = {})
      : body_(body), free_(base == MujocoBase::on_the_floor) {
    text_ = "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>";
    text_ += fmt::format("<option gravity=\"0 {:.17g} 0\" timestep=\"{}\"/><worldbody>", -kGravity,
                         kMujocoStep);
    if (free_) text_ += "<geom type=\"plane\" zaxis=\"0 1 0\" size=\"5 5 0.1\"/>";
    const Mat3d& r = body.base().rotation;
    text_ += fmt::format("<body name=\"base\" pos=\"{}\" xyaxes=\"{} {}\">",
                         numbers(body.base().translation), numbers(r.cx), numbers(r.cy));
    if (free_) text_ += "<freejoint/>";
    add_inertial(body.link_mass(kBaseLink));
    add_soles(kBaseLink);
    add_children(kBaseLink);
    text_ += "</body>" + beside + "</worldbody>" + constraints + "</mujoco>";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string numbers(const Vec3d& v) {
    return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z);
  }

  [[nodiscard]] std::vector<int> children(int link) const {
    std::vector<int> result;
    for (int d = 0; d < body_.dof_count(); ++d) {
      if (body_.dof(d).parent == link) result.push_back(d);
    }
    return result;
  }

  void add_inertial(const MassProperties& m) {
    if (m.mass == 0.0) return;
    // MuJoCo would find the principal axes too, but only to 1e-7 where two moments are alike
    Eigen::Matrix3d inertia;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        inertia(row, column) = m.inertia.column(column)[row];
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
    const Eigen::Vector3d& i = principal.eigenvalues();
    const Eigen::Matrix3d& axes = principal.eigenvectors();
    text_ += fmt::format(
        "<inertial pos=\"{}\" mass=\"{:.17g}\" diaginertia=\"{:.17g} {:.17g} {:.17g}\" "
        "xyaxes=\"{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\"/>",
        numbers(m.com), m.mass, i(0), i(1), i(2), axes(0, 0), axes(1, 0), axes(2, 0), axes(0, 1),
        axes(1, 1), axes(2, 1));
  }

  // A foot touches the floor with a ball at each corner of its sole.
  void add_soles(int link) {
    constexpr double kBall = 0.01;  // m
    if (!free_) return;
    for (const Foot& foot : body_.feet()) {
      if (foot.link != link) continue;
      for (const Vec3d& corner : foot.outline) {
        // inwards: up, from the sole's middle towards the ankle
        text_ += fmt::format("<geom type=\"sphere\" size=\"{}\" pos=\"{}\"/>", kBall,
                             numbers(corner + Vec3d{0, kBall, 0}));
      }
    }
  }

  void add_joint(int d) {
    const Dof& dof = body_.dof(d);
    const double s = dof.sign;
    const Vec3d axis = dof.turn.value_or(Mat3d{}).column(static_cast<int>(dof.axis)) * s;
    text_ +=
        fmt::format("<joint name=\"{}\" type=\"hinge\" axis=\"{}\"/>", dof.name, numbers(axis));
  }

  void add_children(int link) {
    for (int d : children(link)) {
      text_ += fmt::format("<body pos=\"{}\">", numbers(body_.dof(d).offset));
      add_joint(d);
      for (std::vector<int> next = children(d);
           body_.link_mass(d).mass == 0.0 && next.size() == 1 &&
           body_.dof(next[0]).offset == Vec3d{};
           next = children(d)) {
        d = next[0];
        add_joint(d);
      }
      add_inertial(body_.link_mass(d).mass > 0.0 ? body_.link_mass(d) : kNextToNothing);
      add_soles(d);
      add_children(d);
      text_ += "</body>";
    }
  }

  const BodyModel& body_;
  bool free_;
  std::string text_;
};

class MujocoBody {
 public:
  explicit MujocoBody(const BodyModel& body, MujocoBase base = MujocoBase::fixed,
                      const std::string& beside = {}, const std::string& constraints = {}) {
    const std::string xml = MjcfWriter(body, base, beside, constraints).text();
    const auto files = std::make_unique<mjVFS>();  // too large for the stack
    mj_defaultVFS(files.get());
    const int size = static_cast<int>(xml.size());
    SHG_CHECK(mj_makeEmptyFileVFS(files.get(), "body.xml", size) == 0, "MuJoCo's file");
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), "body.xml")], xml.data(), xml.size());
    char error[1000] = "";
    model_.reset(mj_loadXML("body.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    SHG_CHECK(model_ != nullptr, error);
    data_.reset(mj_makeData(model_.get()));
    for (const Dof& dof : body.dofs()) {
      joints_.push_back(mj_name2id(model_.get(), mjOBJ_JOINT, dof.name.c_str()));
    }
  }

  // MuJoCo's own.
  [[nodiscard]] const mjModel* model() const { return model_.get(); }
  [[nodiscard]] mjModel* model() { return model_.get(); }
  [[nodiscard]] mjData* data() const { return data_.get(); }
  // Where a dof stands in MuJoCo's vectors of speeds and forces, and of positions.
  [[nodiscard]] int address(std::size_t dof) const { return model_->jnt_dofadr[joints_[dof]]; }
  [[nodiscard]] int place(std::size_t dof) const { return model_->jnt_qposadr[joints_[dof]]; }
  // The MuJoCo body of a link that has mass, or of the base.
  [[nodiscard]] int body_of(int link) const {
    return link == kBaseLink ? mj_name2id(model_.get(), mjOBJ_BODY, "base")
                             : model_->jnt_bodyid[joints_[static_cast<std::size_t>(link)]];
  }

  // Places the body and computes all that follows from its state (each (dofs), the body's order).
  void set_state(std::span<const double> q, std::span<const double> qd,
                 std::span<const double> qdd) {
    for (std::size_t d = 0; d < joints_.size(); ++d) {
      data_->qpos[place(d)] = q[d];
      data_->qvel[address(d)] = qd[d];
      data_->qacc[address(d)] = qdd[d];
    }
    mj_inverse(model_.get(), data_.get());
    mj_rnePostConstraint(model_.get(), data_.get());
  }

  [[nodiscard]] Vec3d joint_centre(int dof) const {
    return vector(data_->xanchor + 3 * joints_[static_cast<std::size_t>(dof)]);
  }
  [[nodiscard]] Vec3d joint_axis(int dof) const {
    return vector(data_->xaxis + 3 * joints_[static_cast<std::size_t>(dof)]);
  }
  // Frame of a link that has mass, or of the base.
  [[nodiscard]] Transformd frame(int link) const {
    const int b = body_of(link);
    const double* r = data_->xmat + 9 * b;  // by rows
    return {{{r[0], r[3], r[6]}, {r[1], r[4], r[7]}, {r[2], r[5], r[8]}},
            vector(data_->xpos + 3 * b)};
  }

  struct PointJacobian {
    std::vector<Vec3d> position;  // (dofs) m/rad
    std::vector<Vec3d> rotation;  // (dofs)
  };
  // Jacobian of a world point that is carried by a link with mass.
  [[nodiscard]] PointJacobian jacobian(int link, const Vec3d& at) const {
    const auto n = static_cast<std::size_t>(model_->nv);
    std::vector<double> position(3 * n);
    std::vector<double> rotation(3 * n);
    const double point[3] = {at.x, at.y, at.z};
    mj_jac(model_.get(), data_.get(), position.data(), rotation.data(), point, body_of(link));
    PointJacobian result;
    for (std::size_t d = 0; d < joints_.size(); ++d) {
      const auto i = static_cast<std::size_t>(address(d));
      result.position.push_back({position[i], position[n + i], position[2 * n + i]});
      result.rotation.push_back({rotation[i], rotation[n + i], rotation[2 * n + i]});
    }
    return result;
  }

  // Of the body alone.
  [[nodiscard]] Vec3d centre_of_mass() const {
    return vector(data_->subtree_com + 3 * body_of(kBaseLink));
  }

  // (dofs) N·m
  [[nodiscard]] std::vector<double> inverse_torques() const {
    std::vector<double> torques;
    for (std::size_t d = 0; d < joints_.size(); ++d) {
      torques.push_back(data_->qfrc_inverse[address(d)]);
    }
    return torques;
  }

  // The wrench of the world on the base, moment about the world's origin.
  [[nodiscard]] Wrench<double> ground_wrench() const {
    const int base = body_of(kBaseLink);
    const double* w = data_->cfrc_int + 6 * base;
    const Vec3d force = vector(w + 3);
    const Vec3d about = vector(data_->subtree_com + 3 * model_->body_rootid[base]);
    return {force, vector(w) + cross(about, force)};
  }

 private:
  static Vec3d vector(const double* v) { return {v[0], v[1], v[2]}; }

  struct Deleter {
    void operator()(mjModel* m) const { mj_deleteModel(m); }
    void operator()(mjData* d) const { mj_deleteData(d); }
  };
  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
  std::vector<int> joints_;  // (dofs) MuJoCo's joint
};

}  // namespace shigusa::testing_support
