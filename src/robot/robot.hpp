// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/human.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/say.hpp"

namespace shigusa {

// A robot as files describe it: links that joints hold together. Metres, kilograms, radians, in the
// file's own axes.
struct Robot {
  // A simple shape of a link, as large as a box: that box, the cylinder along its z or the ball in
  // it.
  struct Shape {
    enum class Kind { box, cylinder, ball };
    Kind kind = Kind::box;
    Vec3d half{};        // m, half the sizes of the box, own frame
    Transformd place{};  // of the own frame, link frame

    // The corners of the box (m, link frame), as box_corners numbers them.
    [[nodiscard]] std::array<Vec3d, 8> corners() const;
  };
  struct Link {
    std::string name;                                // unique
    double mass = 0.0;                               // kg; 0 where the file has none
    Vec3d com{};                                     // m, link frame
    Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // kg·m², about the com, link axes
    std::vector<Shape> collides;  // what it collides with, as far as shapes are simple
    std::vector<Shape> shown;     // what it looks like, the same

    // Corners of boxes around what it collides with (m, link frame).
    [[nodiscard]] std::vector<Vec3d> corners() const;
  };
  struct Joint {
    std::string name;      // unique
    int parent = 0;        // link
    int child = 0;         // link
    Transformd origin;     // the child's frame in the parent's, at the angle 0
    Vec3d axis{1, 0, 0};   // unit vector, child's frame
    bool turns = false;    // revolute or continuous; what slides or follows another stays fixed
    bool moves = false;    // as the file has it, by one number
    bool slides = false;   // that number is a length (m)
    double lower = -kPi;   // rad, or m
    double upper = kPi;    // rad, or m
    bool limited = false;  // by the file, to less than a whole turn
    double effort = 0.0;   // N·m; 0 where the file has none
    double rest = 0.0;     // rad, or m: the place that the start posture asks for
    bool floats = false;   // floating or planar: by more than one number
    // rad, as the file has them, of one that turns
    std::optional<std::array<double, 2>> ends{};
  };
  // A posture that the file has a name for: a key frame of MJCF, a group state of URDF.
  struct Keyframe {
    std::string name;
    std::vector<std::pair<std::string, double>> angles;  // by joint, rad or m; others stay at 0
  };
  std::string name;
  std::vector<Link> links;    // parents before children; the first is the root
  std::vector<Joint> joints;  // in the file's order, one for each link but the root
  std::vector<Keyframe> keyframes;
  std::vector<Message> doubts;
};

// Whether a link is part of a gripper or a finger, by its name.
[[nodiscard]] bool is_digit(const std::string& link);

// The eight corners of a box about the origin: bit k of a corner's number tells which end of axis k
// it stands at.
[[nodiscard]] std::array<Vec3d, 8> box_corners(const Vec3d& half);

// Sentences about one thing, by its name, and about many, by their number and the first name.
using OfOne = Sentence<std::string>;
using OfMany = Sentence<std::size_t, std::string>;

// Adds a doubt about things of these names: `one` with the name, or `many` with the number and the
// first name, as they are shown.
void doubt_about(const std::vector<std::string>& names, const OfOne& one, const OfMany& many,
                 std::vector<Message>& doubts);

// Reads the limits of a robot's turning joints in degrees where most of them are more than a whole
// turn, and in radians where most are next to nothing, with a doubt.
void mend_limits(Robot& robot);

// A name in a message: in quotes, short, and without bytes that a terminal may take amiss.
[[nodiscard]] std::string shown(std::string_view text);

// Places of the links (links) where all angles are 0, in the root's frame.
[[nodiscard]] std::vector<Transformd> robot_places(const Robot& robot);

// The robot with a link for the hand, fixed at the end of the forearm, where an arm ends at its
// elbow, with a doubt: where the forearm's shapes end, never nearer than its centre of mass, else
// twice as far as that, else where a person's would.
[[nodiscard]] Robot with_hands(Robot robot);

// Links that a joint turns and that nothing follows.
[[nodiscard]] std::vector<int> open_ends(const Robot& robot);
// Those that were taken for hands and are too long for that, beside the way from their shoulders:
// forearms, of both arms or of none.
[[nodiscard]] std::vector<int> forearms_for_hands(const Robot& robot, const HumanoidMap& map);
// The robot with a link fixed at the end of each of these, with doubts: for robots of which no name
// tells where limbs end.
[[nodiscard]] Robot with_ends(Robot robot, const std::vector<int>& links);

// The robot with ankles, where no joint turns between shank and foot, with a doubt: each turns
// about the knee's axis, as high above the sole as a person's. Links keep their indices; the frame
// of such a foot moves into its ankle.
[[nodiscard]] Robot with_ankles(Robot robot, const HumanoidMap& map);

// The joints of a robot's limbs where all angles are 0, in the root's frame; other landmarks are 0.
[[nodiscard]] Landmarks limbs_of(const Robot& robot, const HumanoidMap& map);

// The humanoid bones among a robot's links (see find_humanoid). Where neither names nor feet tell
// left from right, +y of a robot with z up is left. Toes are only what is called so, or asked for.
[[nodiscard]] Result<HumanoidMap> find_humanoid(const Robot& robot, const HumanoidMap& asked = {});

// The robot as a body that stands on its right foot, the left one planted beside it. Its start
// posture has every angle at 0, or as near to that as limits allow, and may leave the left foot in
// the air: see settled_posture.
//
// - The kernel's tree grows from the right foot, so joints on the way to the pelvis are turned
//   round. Links between fixed joints are one. Joints of toes, fingers and what the head carries
//   keep their angle, with a doubt.
// - Freedoms are named as a person's, where the map and the axis tell: "right_knee.flexion"; the
//   sign is the anatomical one. In `robot()` stands which joint of the file each is.
// - Limits and strengths are the file's. A joint that may turn all the way round has a person's
//   limits where it is a person's joint; one without effort gets a person's strength, by the
//   robot's weight.
// - The sole is where what the foot collides with ends, else the lowest frame that is fixed to it,
//   else a person's.
// - Hands end at the frame of a gripper, palm or hand that is fixed beyond the wrist, else at the
//   wrist's link.
// - Stature is that of a person with such legs and trunk.
// - Links without mass weigh nothing, with a doubt.
//
// - A link that stands for the world, above a floating joint or a joint of none, is not the root.
//
// `mass`: kg, spread over the links as a person's where none has a mass. Fails where the map's
// bones are no chain of turning joints, or no link has a mass and none is given.
[[nodiscard]] Result<BodyModel> build_robot(const Robot& robot, const HumanoidMap& map,
                                            std::optional<double> mass = std::nullopt);

}  // namespace shigusa
