// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <shigusa/body.hpp>
#include <shigusa/error.hpp>
#include <shigusa/formats.hpp>
#include <shigusa/human.hpp>
#include <shigusa/math.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shigusa {

/// Size limit of a character's file (bytes); a larger file is refused before memory is allocated.
inline constexpr std::size_t kCharacterMaxBytes = std::size_t{128} << 20;

/// The skeleton of a character's file, on which motions are exported; opaque.
struct CharacterRig;

/// Assignments of a file's nodes to humanoid bones: (bone "right_hand", node), where the node is a
/// name or, as "#17", its index in the file.
using BoneRequest = std::vector<std::pair<std::string, std::string>>;

/// Reads a BoneRequest from a file: {"right_hand": "Bone_17", …}, or the output of `shigusa body`
/// for a character, as text or as JSON.
[[nodiscard]] Result<BoneRequest> read_bone_request(const std::filesystem::path& path);

/// The value of CharacterSpec::frame for the file's rest pose, from which the person is posed
/// standing at ease. For BVH it is the pose of the OFFSETs; for glTF the pose of the nodes, or the
/// bind pose of the mesh if the nodes rest in the middle of a motion.
inline constexpr int kRestPose = -1;

inline constexpr double kSeatMin = 0.1;  ///< lowest seat, m
/// The highest seat, m.
inline constexpr double kSeatMax = 1.2;
/// The largest index of a frame.
inline constexpr int kFrameMax = 1'000'000;

/// Names of the built-in bodies, the default first.
inline constexpr std::array<std::string_view, 3> kBuiltInCharacters{"human", "full_body",
                                                                    "half_body"};

/// A description of the moving character: a built-in body, or a person or robot measured from a
/// file.
struct CharacterSpec {
  /// "human", "full_body", "half_body" or the path of a BVH, glTF, GLB, VRM, FBX, URDF or MJCF
  /// file; for a person or a robot read before (landmarks, urdf below), only a name
  std::string source = "human";
  std::optional<double> stature{};  ///< m, kStatureMin..kStatureMax
  std::optional<double> mass{};     ///< kg, kMassMin..kMassMax; from stature and sex when not given
  Sex sex = Sex::male;              ///< selects the tables of masses and strengths
  std::optional<BodyExtent> extent{};  ///< of a person from a file; empty: human
  /// Frame of the file's motion that is the start posture, from 0, or kRestPose; glTF
  /// animations count frames at 60 Hz. Empty: for BVH and for an animation, the first frame in
  /// which the person stands still on both feet, which measuring stores here unless it is 0; if
  /// there is none, and for glTF without an animation, the rest pose; for BVH that begins with
  /// a T- or A-pose, that pose. From a rest pose, a T- or an A-pose the person is posed
  /// standing at ease.
  std::optional<int> frame{};
  /// glTF: the animation's name or index, by default the first if a frame is given; MJCF: the
  /// name or index of the keyframe that is the start posture.
  std::optional<std::string> animation{};
  /// m, kSeatMin..kSeatMax: height of the seat; empty: the person stands.
  std::optional<double> seat{};
  bool heels = false;  ///< heels may lift; only for a standing person of BodyExtent::human whose
                       ///< file has toes
  BoneRequest map{};   ///< overrides the bones found by the file's metadata and names
  /// Measured landmarks of the person; with them the file is not needed.
  std::optional<Landmarks> landmarks{};
  /// URDF text of a robot that was read; with it the file is not needed.
  std::optional<std::string> urdf{};
  /// Nodes of a person's file whose positions (m, world, start posture) differ from the body's
  /// nodes of the same name, mostly hips and chest. Goals refer to the file's positions.
  std::vector<std::pair<std::string, Vec3d>> places{};
  /// Warnings for the user: guesses of the measurement, omissions from MJCF.
  std::vector<Message> doubts{};
  /// Pairs of humanoid bone and the file's node, as found by measuring; not stored in files.
  std::vector<std::pair<std::string, std::string>> humanoid{};
  /// The file's skeleton, shared by copies of the spec; not stored in files.
  std::shared_ptr<const CharacterRig> rig{};
};

/// Whether the source is one of kBuiltInCharacters.
[[nodiscard]] bool is_built_in(const CharacterSpec& spec);

/// Whether no file needs to be read: the character is built in or already measured.
[[nodiscard]] bool is_complete(const CharacterSpec& spec);

/// Whether the character is a robot, by the ending of its file's name or by its URDF text.
[[nodiscard]] bool is_robot(const CharacterSpec& spec);

/// Fails unless `source` is built in, has a file ending of a character format, or was already
/// measured.
[[nodiscard]] Result<void> check_source(const CharacterSpec& spec);

/// Measures the person or robot in a file's bytes. The file's name in spec.source gives the format
/// and appears in errors. Fills stature, landmarks, doubts, rig and the chosen frame; for a robot
/// urdf. From a rest pose, mostly a T-pose, the person is posed standing at ease. A robot has its
/// own stature and mass. Files included by an MJCF file are looked up in `folder`, if given.
[[nodiscard]] Result<void> load_character(
    std::string bytes, CharacterSpec& spec,
    const std::optional<std::filesystem::path>& folder = std::nullopt);

/// Measures a person from the nodes of a host's skeleton, as from a GLB file of the name
/// spec.source that has them: JSON {"nodes": [{"name", "parent" (index; -1 or absent: none),
/// "translation" [x, y, z], "rotation" [x, y, z, w] and "scale" [x, y, z] (in the parent, at rest;
/// absent: none), "pose": {"translation", "rotation", "scale"} (as the node is now; what is absent
/// is as at rest)}, …]}, up to 2048. If any node has a pose, motions start from that pose unless
/// the spec has a frame.
[[nodiscard]] Result<void> load_nodes(std::string_view nodes, CharacterSpec& spec);

/// Measures the character from the file named by `source`, unless it is built in or already
/// measured, and reduces the source to the bare file name. A relative path starts at `folder`.
[[nodiscard]] Result<void> measure_character(CharacterSpec& spec,
                                             const std::filesystem::path& folder);

/// Sets the rig of an already measured person to that of `measured`. Fails if the two are different
/// persons: joints more than 1 µm apart.
[[nodiscard]] Result<void> attach_rig(CharacterSpec& spec, const CharacterSpec& measured);

/// Reads the rig of an already measured person from their file. Fails if the file cannot be read or
/// holds a different person: joints more than 1 µm apart.
[[nodiscard]] Result<void> attach_file(CharacterSpec& spec, const std::filesystem::path& path);

/// Builds the body of a measured or built-in character. `base`: the foot that is fixed, if both
/// feet stand; `on_both`: both feet stand even if their height difference would make one of them
/// count as lifted. Fails on a stature or mass out of range.
[[nodiscard]] Result<PosedBody> build_character(const CharacterSpec& spec, Side base = Side::right,
                                                bool on_both = false);

/// A measured character: build_character of its description.
struct Character : PosedBody {
  CharacterSpec spec;  ///< the measured description, with its file's rig
};

/// Measures a character and builds its body: measure_character, then build_character.
[[nodiscard]] Result<Character> open_character(CharacterSpec spec,
                                               const std::filesystem::path& folder = ".");

/// Positions of all effectors in the home state: (effectors) m, world.
[[nodiscard]] std::vector<Vec3d> start_places(const PosedBody& body);

/// A point of the body that goals can be given for.
struct GoalPlace {
  std::string effector;  ///< "right_hand"
  std::string node;      ///< node of the body at the point
  Vec3d start{};         ///< m, world, in the start posture
};
/// All points of a body that goals can be given for: its effectors, and the base foot; a goal for
/// the base foot makes the other foot the base.
[[nodiscard]] std::vector<GoalPlace> goal_places(const PosedBody& body);

/// Name of the robot file's joint behind a dof; empty for a person.
[[nodiscard]] std::string file_joint(const PosedBody& body, int dof);

/// The lowest and highest limits (rad) of a dof, the upper one with the full growth of its
/// LimitCoupling.
[[nodiscard]] std::pair<double, double> widest_limits(const BodyModel& body, int dof);

/// A twist bone of the character's file.
struct TwistShare {
  std::string node;    ///< name of the twist bone's node in the file
  std::string bone;    ///< humanoid bone that it takes a share of twist from
  double share = 0.0;  ///< position along that bone, 0..1
};
/// The twist bones of the character's file; empty without a rig.
[[nodiscard]] std::vector<TwistShare> twist_shares(const CharacterSpec& spec);

/// The measured character as JSON text, as printed by `shigusa body --json`; its `nodes` are those
/// of node_motion.
[[nodiscard]] std::string format_character(const CharacterSpec& spec, const PosedBody& body);

/// A node moved by node_motion: of the character's file if its rig is loaded, else of the body's
/// skeleton.
struct CharacterNode {
  std::string name;  ///< name in the file
  int parent = -1;   ///< index of an earlier node; -1 for a root
  Vec3d offset{};    ///< position in the parent's frame, in units of node_unit, in the posture that
                     ///< was measured
  Vec3d scale{1, 1, 1};       ///< scale along its own axes, constant during a motion
  int file_node = -1;         ///< glTF node index; -1 for other formats
  Quatd rotation{};           ///< rotation in its parent in that posture
  LocalTransform rest{};      ///< the same at rest, as the file has it
  Vec3d rest_scale{1, 1, 1};  ///< scale at rest
};

/// The nodes moved by node_motion, parents before children.
[[nodiscard]] std::vector<CharacterNode> character_nodes(const CharacterSpec& character,
                                                         const PosedBody& body);
/// Metres per unit of the nodes' translations.
[[nodiscard]] double node_unit(const CharacterSpec& character);

/// Where the nodes of a character move.
enum class MotionPlace {
  world,  ///< in the world of goals, y up, whatever the axes of a file; but see node_motion
  file,   ///< where the character stands in its file, in the file's axes
};
/// The words of MotionPlace.
template <>
inline constexpr std::array kEnumWords<MotionPlace>{EnumWord{MotionPlace::world, "world"},
                                                    EnumWord{MotionPlace::file, "file"}};

/// Transforms of all nodes of a motion on the character's own skeleton, relative to the parent:
/// (frames × nodes), translations in units of node_unit. Fingers stay as in the file. A mirrored
/// file's nodes always move in the file's place.
[[nodiscard]] std::vector<LocalTransform> node_motion(const CharacterSpec& character,
                                                      const PosedBody& body, const Clip& clip,
                                                      MotionPlace place = MotionPlace::world);

}  // namespace shigusa
