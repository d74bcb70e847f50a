// SPDX-License-Identifier: MIT
#include "mjcf_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <shigusa/math.hpp>

#include "core/text.hpp"

namespace shigusa {
namespace {

constexpr std::size_t kMostKeys = 100;  // that are read

// A joint with the index of its first number in a key frame.
struct Placed {
  const XmlElement* joint;
  std::size_t begin;
  std::size_t numbers;  // 7 of a free joint, 4 of a ball, else 1
};

// Joints of all bodies in MuJoCo's order: those of a body before those of its children.
class Layout {
 public:
  Layout(MjcfFiles& files, const MjcfValues& values) : files_(files), values_(values) {
    files.each(*files.root(), [&](const XmlElement& e) {
      if (e.name == "worldbody") bodies(e, {}, 0);
    });
  }

  std::vector<Placed> joints;
  std::size_t numbers = 0;

 private:
  static std::string_view class_in(const XmlElement& element, std::string_view childclass) {
    const char* named = element.attribute("childclass");
    return named != nullptr ? named : childclass;
  }

  void bodies(const XmlElement& parent, std::string_view childclass, int depth) {
    if (depth > kMjcfMaxDepth) return;
    files_.each(parent, [&](const XmlElement& e) {
      if (e.name != "body" && e.name != "frame") return;
      const std::string_view inner = class_in(e, childclass);
      if (e.name == "body") joints_of(e, inner, 0);
      bodies(e, inner, depth + 1);
    });
  }

  void joints_of(const XmlElement& body, std::string_view childclass, int depth) {
    if (depth > kMjcfMaxDepth) return;
    files_.each(body, [&](const XmlElement& e) {
      if (e.name == "frame") joints_of(e, class_in(e, childclass), depth + 1);
      if (e.name != "joint" && e.name != "freejoint") return;
      const std::string_view type = values_.word({e, childclass}, "type");
      const bool free = e.name == "freejoint" || type == "free";
      joints.push_back({&e, numbers, free ? 7u : type == "ball" ? 4u : 1u});
      numbers += joints.back().numbers;
    });
  }

  MjcfFiles& files_;
  const MjcfValues& values_;
};

// Rotation of a ball from its quaternion, w first; empty if that is zero.
std::optional<Mat3d> turn_of_ball(const double* q) {
  const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 1e-9)) return std::nullopt;
  return to_matrix(Quatd{q[1] / length, q[2] / length, q[3] / length, q[0] / length});
}

// Intrinsic rotation angles (rad) about x, y and z, in sequence, of a rotation.
std::array<double, 3> about_each(const Mat3d& turn) {
  return {atan2(-turn.cz.y, turn.cz.z), asin(clamp(turn.cz.x, -1.0, 1.0)),
          atan2(-turn.cy.x, turn.cx.x)};
}

// Adds the angles of a ball, whose three axes are the columns of its frame.
void add_ball(const Robot& robot, std::size_t first, const double* numbers,
              Robot::Keyframe& frame) {
  const std::optional<Mat3d> turn = turn_of_ball(numbers);
  if (!turn) return;
  const Mat3d axes{robot.joints[first].axis, robot.joints[first + 1].axis,
                   robot.joints[first + 2].axis};
  const std::array<double, 3> angles = about_each(transpose(axes) * *turn * axes);
  for (std::size_t k = 0; k < 3; ++k) {
    frame.angles.emplace_back(robot.joints[first + k].name, angles[k]);
  }
}

}  // namespace

std::vector<Robot::Keyframe> read_keyframes(
    MjcfFiles& files, const MjcfValues& values,
    const std::map<const XmlElement*, std::size_t>& joint_of, const Robot& robot) {
  std::vector<Robot::Keyframe> frames;
  if (files.root() == nullptr || files.error()) return frames;
  const Layout layout(files, values);
  std::size_t number = 0;
  const auto read = [&](const XmlElement& key, const std::vector<double>& numbers) {
    const char* name = key.attribute("name");
    Robot::Keyframe& frame = frames.emplace_back();
    frame.name = name == nullptr || *name == '\0' ? fmt::format("{}", number) : name;
    for (const Placed& joint : layout.joints) {
      const auto found = joint_of.find(joint.joint);
      if (found == joint_of.end()) continue;
      const double* own = numbers.data() + joint.begin;
      if (joint.numbers == 4) add_ball(robot, found->second, own, frame);
      if (joint.numbers == 1) frame.angles.emplace_back(robot.joints[found->second].name, own[0]);
    }
  };
  files.each(*files.root(), [&](const XmlElement& section) {
    if (section.name != "keyframe") return;
    files.each(section, [&](const XmlElement& e) {
      if (e.name != "key" || frames.size() >= kMostKeys) return;
      const char* text = e.attribute("qpos");
      const auto numbers = xml_numbers(text == nullptr ? "" : text, layout.numbers);
      const auto is_tame = [](double x) { return abs(x) <= kMjcfMaxValue; };
      if (numbers && numbers->size() == layout.numbers && layout.numbers > 0 &&
          std::all_of(numbers->begin(), numbers->end(), is_tame)) {
        read(e, *numbers);
      }
      ++number;
    });
  });
  return frames;
}

}  // namespace shigusa
