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

// Description of a robot from a file: links connected by joints. Metres, kilograms, radians, in the
// file's own axes.
struct Robot {
  // A simple shape of a link, inscribed in a box: the box itself, the cylinder along its z axis or
  // the ball.
  struct Shape {
    enum class Kind { box, cylinder, ball };
    Kind kind = Kind::box;
    Vec3d half{};        // m, half the sizes of the box, own frame
    Transformd place{};  // of the own frame, link frame

    // Corners of the box (m, link frame), numbered as in box_corners.
    [[nodiscard]] std::array<Vec3d, 8> corners() const;
  };
  struct Link {
    std::string name;                                // unique
    double mass = 0.0;                               // kg; 0 if the file has none
    Vec3d com{};                                     // m, link frame
    Mat3d inertia{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};  // kg·m², about the com, link axes
    std::vector<Shape> collides;                     // simple collision shapes
    std::vector<Shape> shown;                        // simple visual shapes

    // Corners of boxes around the collision shapes (m, link frame).
    [[nodiscard]] std::vector<Vec3d> corners() const;
  };
  struct Joint {
    std::string name;      // unique
    int parent = 0;        // link
    int child = 0;         // link
    Transformd origin;     // the child's frame in the parent's, at the angle 0
    Vec3d axis{1, 0, 0};   // unit vector, child's frame
    bool turns = false;    // revolute or continuous; sliding and mimicking joints are fixed
    bool moves = false;    // has one degree of freedom in the file
    bool slides = false;   // its position is a length (m)
    double lower = -kPi;   // rad, or m
    double upper = kPi;    // rad, or m
    bool limited = false;  // limited by the file to less than a full turn
    double effort = 0.0;   // N·m; 0 if the file has none
    double rest = 0.0;     // rad, or m: position in the start posture
    bool floats = false;   // floating or planar: several degrees of freedom
    // rad, limits of the file, for a turning joint
    std::optional<std::array<double, 2>> ends{};
  };
  // A named posture of the file: a key frame of MJCF, a group state of URDF.
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

// The eight corners of a box about the origin: bit k of a corner's number selects the end of axis
// k.
[[nodiscard]] std::array<Vec3d, 8> box_corners(const Vec3d& half);

// Messages about one thing, by its name, and about several, by their number and the first name.
using OfOne = Sentence<std::string>;
using OfMany = Sentence<std::size_t, std::string>;

// Adds a doubt about the named things: `one` with the name, or `many` with the number and the
// first name, formatted for display.
void doubt_about(const std::vector<std::string>& names, const OfOne& one, const OfMany& many,
                 std::vector<Message>& doubts);

// Converts the limits of a robot's turning joints, with a doubt: degrees if most ranges exceed
// two full turns in radians, and radians read as degrees if most ranges are tiny.
void mend_limits(Robot& robot);

// A name for a message: quoted, shortened, and without control bytes.
[[nodiscard]] std::string shown(std::string_view text);

// (links) placements of the links at zero angles, in the root's frame.
[[nodiscard]] std::vector<Transformd> robot_places(const Robot& robot);

// Robot with a hand link fixed at the end of the forearm if an arm ends at its elbow, with a
// doubt. The hand is where the forearm's shapes end, but not nearer than its centre of mass; else
// at twice the distance of that; else by human proportions.
[[nodiscard]] Robot with_hands(Robot robot);

// Links that a joint turns and that have no children.
[[nodiscard]] std::vector<int> open_ends(const Robot& robot);
// Links mapped as hands that are too long for that, relative to the distance from their shoulders:
// forearms, of both arms or of none.
[[nodiscard]] std::vector<int> forearms_for_hands(const Robot& robot, const HumanoidMap& map);
// Robot with a link fixed at the end of each of these links, with doubts; for robots whose names
// do not mark the ends of limbs.
[[nodiscard]] Robot with_ends(Robot robot, const std::vector<int>& links);

// Robot with ankles added if no joint turns between shank and foot, with a doubt. Each turns
// about the knee's axis, at a person's height above the sole. Links keep their indices; the frame
// of such a foot moves to its ankle.
[[nodiscard]] Robot with_ankles(Robot robot, const HumanoidMap& map);

// Limb joints of a robot at zero angles, in the root's frame; other landmarks are 0.
[[nodiscard]] Landmarks limbs_of(const Robot& robot, const HumanoidMap& map);

// Humanoid bones among a robot's links (see find_humanoid). If neither names nor feet determine
// left and right, +y of a robot with z up is left. Toes require their name, or the user's
// assignment.
[[nodiscard]] Result<HumanoidMap> find_humanoid(const Robot& robot, const HumanoidMap& asked = {});

// Builds the body of a robot that stands on its right foot, with the left one planted beside it.
// Its start posture has every angle at 0, or as near to that as limits allow, and may leave the
// left foot in the air: see settle.
//
// - The kernel's tree grows from the right foot, so joints between it and the pelvis are reversed.
//   Rigidly connected links are one. Joints of toes, fingers and attachments of the head are fixed
//   at their angles, with a doubt.
// - Degrees of freedom have a person's names where the map and the axis determine them:
//   "right_knee.flexion"; the sign is the anatomical one. The RobotFrame maps them to the joints of
//   the file.
// - Limits and strengths are the file's. A continuous joint has a person's limits if it is a
//   person's joint; one without effort gets a person's strength, scaled by the robot's weight.
// - The sole is at the lower end of the foot's collision shapes, else at a frame named as a sole,
//   at the bottom of a box with the foot's mass and inertia, or at the lowest frame fixed to it,
//   else by human proportions.
// - Hands end at the frame of a gripper, palm or hand that is fixed beyond the wrist, else at the
//   wrist's link.
// - Stature is that of a person with these legs and trunk.
// - Links without mass are massless, with a doubt.
// - A link that represents the world, above a floating joint or a joint without degrees of freedom,
//   is not the root.
//
// `mass`: kg, distributed over the links as a person's if none has a mass. Fails if the map's bones
// are no chain of turning joints, or if no link has a mass and none is given.
[[nodiscard]] Result<PosedBody> build_robot(const Robot& robot, const HumanoidMap& map,
                                            std::optional<double> mass = std::nullopt);

}  // namespace shigusa
