// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <shigusa/math.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "moving_body.hpp"
#include "table.hpp"

namespace shigusa::bench {

// Root placement of a robot in a row of a table (shigusa's world, m).
[[nodiscard]] Transformd root_place(const Table& table, std::size_t row);

// Tree of a URDF file: links, joints, masses, limits, following the format's specification. It is
// independent of the library's bodies.
class RobotTree {
 public:
  struct Joint {
    std::string name;
    std::string child;
    std::string parent;
    Transformd origin;  // of the child in the parent at 0
    Vec3d axis{1, 0, 0};
    bool turns = false;
    bool slides = false;
    std::string follows;  // the joint that it copies
    double times = 1.0;
    double plus = 0.0;
    std::optional<double> lower;
    std::optional<double> upper;
  };
  struct Link {
    std::string name;
    double mass = 0.0;
    Transformd inertial;  // centre of mass, and the axes of the inertia
    Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  };

  // Throws std::runtime_error on malformed URDF.
  explicit RobotTree(std::string_view urdf);

  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] const std::vector<Link>& links() const { return links_; }
  [[nodiscard]] bool has_link(const std::string& name) const { return link_of_.count(name) != 0; }

  // [row] frames of the links (shigusa's world, m) from the table's root and joints.
  using Places = std::map<std::string, Transformd>;
  [[nodiscard]] std::vector<Places> places(const std::string& root, const Table& table) const;

  // Pieces, and hinges whose torques the table has; `feet`: planted links.
  [[nodiscard]] MovingBody pieces(const std::string& root, const std::vector<Places>& places,
                                  const std::vector<std::string>& feet, double frame_time) const;

 private:
  [[nodiscard]] double value_of(const Joint& joint, const Table& table, std::size_t row) const;
  [[nodiscard]] const Joint* joint_above(const std::string& link) const;
  [[nodiscard]] bool hangs_on(const std::string& link, const std::string& above) const;

  std::vector<Joint> joints_;
  std::vector<Link> links_;
  std::map<std::string, std::size_t> link_of_;
  std::map<std::string, std::size_t> above_;     // link: the joint that carries it
  std::map<std::string, std::size_t> joint_of_;  // by its name
};

}  // namespace shigusa::bench
