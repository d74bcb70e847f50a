// SPDX-License-Identifier: MIT
#pragma once

#include <urdf_parser/urdf_parser.h>

#include <cstdlib>
#include <fstream>
#include <kdl/frames.hpp>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/check.hpp"

// An independent reader of an exported robot trajectory: the table's own columns, and the links'
// positions by urdfdom's model of the file and KDL's frames. It knows nothing of BodyModel.
namespace shigusa::testing_support {

class Table {
 public:
  // No name may hold a comma or a quote.
  explicit Table(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream fields(line); std::getline(fields, line, ',');) names.push_back(line);
    while (std::getline(lines, line)) {
      std::istringstream fields(line);
      for (const std::string& name : names) {
        std::string field;
        std::getline(fields, field, ',');
        columns_[name].push_back(std::strtod(field.c_str(), nullptr));
      }
      ++rows_;
    }
  }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool has(const std::string& name) const { return columns_.count(name) != 0; }
  [[nodiscard]] double at(const std::string& name, std::size_t row) const {
    return columns_.at(name).at(row);
  }

 private:
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

class RobotReader {
 public:
  // `urdf`: the text of the file
  explicit RobotReader(const std::string& urdf) : model_(urdf::parseURDF(urdf)) {
    SHG_CHECK(model_ != nullptr, "a robot's file");
  }

  [[nodiscard]] const urdf::ModelInterface& model() const { return *model_; }

  // A link's frame in the robot's world at one row of the table.
  [[nodiscard]] KDL::Frame place(const std::string& link, const Table& table,
                                 std::size_t row) const {
    const auto& joint = model_->getLink(link)->parent_joint;
    if (!joint) {
      const auto root = [&](const char* name) {
        return table.at(std::string("root.") + name, row);
      };
      return {KDL::Rotation::Quaternion(root("qx"), root("qy"), root("qz"), root("qw")),
              {root("x [m]"), root("y [m]"), root("z [m]")}};
    }
    const urdf::Pose& origin = joint->parent_to_joint_origin_transform;
    const KDL::Frame fixed(KDL::Rotation::Quaternion(origin.rotation.x, origin.rotation.y,
                                                     origin.rotation.z, origin.rotation.w),
                           {origin.position.x, origin.position.y, origin.position.z});
    KDL::Frame turned;
    if (joint->type == urdf::Joint::REVOLUTE || joint->type == urdf::Joint::CONTINUOUS) {
      turned = KDL::Frame(KDL::Rotation::Rot({joint->axis.x, joint->axis.y, joint->axis.z},
                                             table.at(joint->name + " [rad]", row)));
    }
    if (joint->type == urdf::Joint::PRISMATIC) {
      turned.p = KDL::Vector(joint->axis.x, joint->axis.y, joint->axis.z) *
                 table.at(joint->name + " [m]", row);
    }
    return place(joint->parent_link_name, table, row) * fixed * turned;
  }

 private:
  urdf::ModelInterfaceSharedPtr model_;
};

inline std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace shigusa::testing_support
