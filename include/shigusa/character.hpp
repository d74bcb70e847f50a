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

/// No file of a character may be larger; more is refused before memory is taken.
inline constexpr std::size_t kCharacterMaxBytes = std::size_t{128} << 20;

/// A character's own skeleton, for motions to leave on it.
struct CharacterRig;

/// Humanoid bones ("right_hand") and the nodes of a file that they are, as a person tells them: by
/// name, or by "#17" the node of that place in the file.
using BoneRequest = std::vector<std::pair<std::string, std::string>>;

/// Reads such a list from a file: {"right_hand": "Bone_17", …}, or what `shigusa body` printed of a
/// character, as text or as JSON.
[[nodiscard]] Result<BoneRequest> read_bone_request(const std::filesystem::path& path);

/// In a frame's place: the file's rest pose, from which the person stands at ease. Of BVH that of
/// the OFFSETs; of glTF that of the nodes, or where they rest in the middle of a motion that in
/// which the mesh was bound.
inline constexpr int kRestPose = -1;

inline constexpr double kStatureMin = 0.5;  ///< m
/// The greatest stature, m.
inline constexpr double kStatureMax = 2.5;
inline constexpr double kMassMin = 2.0;  ///< kg
/// The greatest mass, kg.
inline constexpr double kMassMax = 300.0;
inline constexpr double kSeatMin = 0.1;  ///< m
/// The highest seat, m.
inline constexpr double kSeatMax = 1.2;
/// The last frame that a file may be asked for.
inline constexpr int kFrameMax = 1'000'000;

/// The bodies that need no file, the usual one first.
inline constexpr std::array<std::string_view, 3> kBuiltInCharacters{"human", "full_body",
                                                                    "half_body"};

/// The one who moves: a built-in body, or a person measured from a file.
struct CharacterSpec {
  /// "human", "full_body", "half_body" or the path of a BVH, glTF, GLB, VRM, FBX, URDF or MJCF
  /// file; for a person or a robot read before (landmarks, urdf below), only a name
  std::string source = "human";
  std::optional<double> stature{};  ///< m, kStatureMin..kStatureMax
  std::optional<double> mass{};     ///< kg, kMassMin..kMassMax; from stature and sex when not given
  Sex sex = Sex::male;              ///< of the tables of masses and strengths
  std::optional<BodyExtent> extent{};  ///< of a person from a file; human when not given
  /// of the file's motion: the start posture, exactly as that frame has it, or kRestPose. Of glTF
  /// it is one of an animation, at 60 frames a second. None: of BVH and of an animation the first
  /// in which the person stands still on both feet, which measuring tells here unless it is frame
  /// 0; else, and of glTF without an animation, the rest pose. Of BVH that begins with a T- or an
  /// A-pose its first. In the last three people stand at ease
  std::optional<int> frame{};
  std::optional<std::string>
      animation{};  ///< of glTF: its name or index; the first for a frame alone; of MJCF a keyframe
  std::optional<double>
      seat{};          ///< m, kSeatMin..kSeatMax: height of the seat that the person sits on
  bool heels = false;  ///< they may lift; of the body human, standing, of a file with toes
  BoneRequest map{};   ///< of the file's bones; goes before what the file and its names tell
  /// the person as measured: with these the file is not needed any more
  std::optional<Landmarks> landmarks{};
  /// the robot as read, as URDF text, in landmarks' place
  std::optional<std::string> urdf{};
  /// of a person: nodes of the file that are not where the body has those of their names, hips and
  /// chest mostly (m, world, in the start posture): goals are for the file's
  std::vector<std::pair<std::string, Vec3d>> places{};
  std::vector<Message> doubts{};  ///< what was guessed in measuring, or left out of MJCF
  /// what measuring found: humanoid bone and the file's node for it; not kept in files
  std::vector<std::pair<std::string, std::string>> humanoid{};
  /// the file's skeleton, shared by the copies of a spec; not kept in files either
  std::shared_ptr<const CharacterRig> rig{};
};

/// True for those of kBuiltInCharacters, which need no file.
[[nodiscard]] bool is_built_in(const CharacterSpec& spec);

/// True where the file that `source` names, if it does, is not needed: built in, or read before.
[[nodiscard]] bool is_complete(const CharacterSpec& spec);

/// True for a robot, by its file's name or read before.
[[nodiscard]] bool is_robot(const CharacterSpec& spec);

/// Fails where `source` can be no character at all: neither built in, nor a file of one of these
/// kinds by its ending, nor measured before.
[[nodiscard]] Result<void> check_source(const CharacterSpec& spec);

/// Measures the person or robot of a file in memory: the file's name in spec.source tells its kind,
/// and errors name it. Fills stature, landmarks, doubts, rig and the frame that was found, of a
/// robot urdf. A rest pose is mostly a T: from that the person stands at ease. A robot has its own
/// stature and mass. Files that an MJCF file includes are looked for in `folder`, where there is
/// one.
[[nodiscard]] Result<void> load_character(
    std::string bytes, CharacterSpec& spec,
    const std::optional<std::filesystem::path>& folder = std::nullopt);

/// The same by the file that `source` names, if it does and has not been measured yet; leaves the
/// file's bare name as the source. A relative path starts at `folder`.
[[nodiscard]] Result<void> measure_character(CharacterSpec& spec,
                                             const std::filesystem::path& folder);

/// Gives a person who was measured before the rig of the same one, measured with it. Fails where it
/// is another person's: joints that stand elsewhere by more than 1 µm.
[[nodiscard]] Result<void> attach_rig(CharacterSpec& spec, const CharacterSpec& measured);

/// Finds the rig of a person who was measured before in their file. Fails where the file cannot be
/// read or holds another person: joints that stand elsewhere by more than 1 µm.
[[nodiscard]] Result<void> attach_file(CharacterSpec& spec, const std::filesystem::path& path);

/// Makes the body. The spec must have been measured. Fails on a stature or mass out of range.
/// `base`: the foot that bears the body, of people who stand on both; `on_both`: they do, even
/// where one foot is so high above the other that it would be taken for lifted.
[[nodiscard]] Result<BodyModel> build_character(const CharacterSpec& spec, Side base = Side::right,
                                                bool on_both = false);

/// A character that can move.
struct Character {
  CharacterSpec spec;  ///< measured, with the rig of its file
  BodyModel body;      ///< as build_character makes it of the spec
};

/// Opens a character by its built-in name or its file: measure_character, then build_character.
[[nodiscard]] Result<Character> open_character(CharacterSpec spec,
                                               const std::filesystem::path& folder = ".");

/// (effectors) m, world: where goals can be given for, in the start posture.
[[nodiscard]] std::vector<Vec3d> start_places(const BodyModel& body);

/// Where a goal can be given for.
struct GoalPlace {
  std::string effector;  ///< "right_hand"
  std::string node;      ///< of the body
  Vec3d start{};         ///< m, world, in the start posture
};
/// All of a body's: its effectors, and the foot that bears it, which a goal makes the other one.
[[nodiscard]] std::vector<GoalPlace> goal_places(const BodyModel& body);

/// The file's joint that a freedom of a robot is; empty of a person's.
[[nodiscard]] std::string file_joint(const BodyModel& body, int dof);

/// The angles (rad) that a freedom never passes: its upper limit is that of the most that another
/// angle lets it grow to (LimitCoupling).
[[nodiscard]] std::pair<double, double> widest_limits(const BodyModel& body, int dof);

/// A twist bone of the file, and whose twist it shares.
struct TwistShare {
  std::string node;    ///< of the file
  std::string bone;    ///< humanoid bone whose twist it shares
  double share = 0.0;  ///< of the way along that bone, 0..1
};
/// The twist bones of the character's file; none without its rig.
[[nodiscard]] std::vector<TwistShare> twist_shares(const CharacterSpec& spec);

/// The character as it was understood, as JSON text: the object that `shigusa body --json` prints,
/// whose `nodes` are those of node_motion.
[[nodiscard]] std::string format_character(const CharacterSpec& spec, const BodyModel& body);

/// A node that a motion moves: of the character's own file where its rig is at hand, else of the
/// body's skeleton.
struct CharacterNode {
  std::string name;      ///< in the file
  int parent = -1;       ///< index of an earlier node; -1 for a root
  Vec3d offset{};        ///< in the parent where the start was measured, in units of node_unit
  Vec3d scale{1, 1, 1};  ///< along its own axes, in all of a motion
  int file_node = -1;    ///< of glTF: index in the file
};

/// All nodes that node_motion moves, parents before children.
[[nodiscard]] std::vector<CharacterNode> character_nodes(const CharacterSpec& character,
                                                         const BodyModel& body);
/// m per unit of the nodes' translations.
[[nodiscard]] double node_unit(const CharacterSpec& character);

/// (frames × nodes) each node in its parent, as a character leaves in its own file, whose fingers
/// stay as the file has them.
[[nodiscard]] std::vector<LocalTransform> node_motion(const CharacterSpec& character,
                                                      const BodyModel& body, const Clip& clip);

}  // namespace shigusa
