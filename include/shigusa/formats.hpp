// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// The file formats that are read or written.
enum class FileFormat {
  bvh,   ///< Biovision hierarchy: persons, clips and motions
  csv,   ///< table with one row per frame
  svg,   ///< strip figure
  png,   ///< strip figure
  pdf,   ///< strip figure
  glb,   ///< binary glTF
  vrma,  ///< VRM animation
  vrm,   ///< VRM character
  fbx,   ///< character, converted to glTF when read
  urdf,  ///< robot
  mjcf,  ///< MuJoCo model of a robot
  npz,   ///< NumPy arrays for controllers of robots
};

/// The kind of character file that writing a format requires.
enum class NeededFile {
  none,  ///< none: any character
  gltf,  ///< glTF, VRM included
  vrm,   ///< VRM only
};

/// The facts of a file format; all readers, writers and lists of formats use this table.
struct FormatInfo {
  /// The format of the row.
  FileFormat format;
  std::string_view word;                    ///< name in options, and ending of written files
  std::array<std::string_view, 2> endings;  ///< endings of files that are read: ".glb"; "" for none
  /// Media type of the files.
  std::string_view media_type;
  std::string_view about;     ///< description, one sentence
  bool person = false;        ///< persons can be read from it
  bool robot = false;         ///< robots can be read from it
  bool clip = false;          ///< recorded motions can be read from it
  bool written = false;       ///< motions can be written in it
  bool usual = false;         ///< written by default if the character allows it
  bool rated = false;         ///< written at the requested frame rate
  double rate = kUsualRate;   ///< Hz, of a rated format if none is requested
  std::size_t max_bytes = 0;  ///< size limit of a file that is read
  /// Kind of character file that writing requires.
  NeededFile needs = NeededFile::none;
  bool from_svg = false;  ///< converted from SVG by FileSettings::from_svg
  /// Built-in bodies are written as the mannequin on request (see has_mannequin).
  bool mannequin = false;
};

/// Bytes of one mebibyte.
inline constexpr std::size_t kMebibyte = std::size_t{1} << 20;

/// All formats, in the order of FileFormat.
inline constexpr std::array kFileFormats{
    FormatInfo{.format = FileFormat::bvh,
               .word = "bvh",
               .endings = {".bvh"},
               .media_type = "text/plain",
               .about = "The skeleton and its motion, as motion capture has them.",
               .person = true,
               .clip = true,
               .written = true,
               .usual = true,
               .rated = true,
               .max_bytes = 64 * kMebibyte},
    FormatInfo{.format = FileFormat::csv,
               .word = "csv",
               .endings = {".csv"},
               .media_type = "text/csv",
               .about = "Joint angles, torques, the centre of mass and the effectors over time.",
               .written = true,
               .usual = true},
    FormatInfo{.format = FileFormat::svg,
               .word = "svg",
               .endings = {".svg"},
               .media_type = "image/svg+xml",
               .about = "The strip figure: poses from left to right, as curves.",
               .written = true,
               .usual = true},
    FormatInfo{.format = FileFormat::png,
               .word = "png",
               .endings = {".png"},
               .media_type = "image/png",
               .about = "The strip figure as a picture of pixels, which takes the longest to make.",
               .written = true,
               .from_svg = true},
    FormatInfo{.format = FileFormat::pdf,
               .word = "pdf",
               .endings = {".pdf"},
               .media_type = "application/pdf",
               .about = "The strip figure as a page.",
               .written = true,
               .from_svg = true},
    FormatInfo{.format = FileFormat::glb,
               .word = "glb",
               .endings = {".glb", ".gltf"},
               .media_type = "model/gltf-binary",
               .about = "The character's own glTF file with the motion added; of a built-in body a "
                        "mannequin.",
               .person = true,
               .clip = true,
               .written = true,
               .usual = true,
               .rated = true,
               .max_bytes = 128 * kMebibyte,
               .needs = NeededFile::gltf,
               .mannequin = true},
    FormatInfo{.format = FileFormat::vrma,
               .word = "vrma",
               .endings = {".vrma"},
               .media_type = "model/gltf-binary",
               .about = "The motion alone, for any VRM character.",
               .clip = true,
               .written = true,
               .usual = true,
               .rated = true,
               .max_bytes = 128 * kMebibyte,
               .needs = NeededFile::vrm},
    FormatInfo{.format = FileFormat::vrm,
               .word = "vrm",
               .endings = {".vrm"},
               .media_type = "model/gltf-binary",
               .about = "A glTF character whose bones are told.",
               .person = true,
               .clip = true,
               .max_bytes = 128 * kMebibyte},
    FormatInfo{.format = FileFormat::fbx,
               .word = "fbx",
               .endings = {".fbx"},
               .media_type = "application/octet-stream",
               .about = "A character's skeleton, taken as the glTF file of it.",
               .person = true,
               .max_bytes = 128 * kMebibyte},
    FormatInfo{.format = FileFormat::urdf,
               .word = "urdf",
               .endings = {".urdf"},
               .media_type = "application/xml",
               .about = "A robot's links and joints.",
               .robot = true,
               .max_bytes = 16 * kMebibyte},
    FormatInfo{.format = FileFormat::mjcf,
               .word = "mjcf",
               .endings = {".xml", ".mjcf"},
               .media_type = "application/xml",
               .about = "A robot as MuJoCo has it.",
               .robot = true,
               .max_bytes = 4 * kMebibyte},
    FormatInfo{.format = FileFormat::npz,
               .word = "npz",
               .endings = {".npz"},
               .media_type = "application/zip",
               .about =
                   "Joints, bodies, velocities and torques as NumPy arrays, for controllers of "
                   "robots.",
               .written = true,
               .rated = true,
               .rate = 50.0},
};
/// The words of FileFormat.
template <>
inline constexpr auto kEnumWords<FileFormat> = words_of_table(kFileFormats, &FormatInfo::format);

/// The row of a format.
[[nodiscard]] constexpr const FormatInfo& info_of(FileFormat format) {
  return kFileFormats[static_cast<std::size_t>(format)];
}

/// Whether a character from a file of one format satisfies a NeededFile. FBX counts as glTF, as its
/// skeleton is converted to glTF.
[[nodiscard]] constexpr bool is_file(FileFormat character, NeededFile needed) {
  const bool vrm = character == FileFormat::vrm;
  const bool gltf = vrm || character == FileFormat::glb || character == FileFormat::fbx;
  return needed == NeededFile::none || (needed == NeededFile::vrm ? vrm : gltf);
}

/// Whether this build contains the mannequin, which needs zlib.
[[nodiscard]] bool has_mannequin();

/// The ending of a file's name, in lower case: ".bvh".
[[nodiscard]] std::string file_ending(const std::string& name);

/// The format of a file by the ending of its name, in any case; nothing if no readable format has
/// it.
[[nodiscard]] std::optional<FileFormat> format_of_file(const std::string& name);

/// The words of the formats that satisfy a predicate, as a list for messages: "bvh, glb and vrma".
[[nodiscard]] std::string format_words(bool (*is_so)(const FormatInfo&),
                                       std::string_view last = "and");
/// The endings of the formats that satisfy a predicate, as a list for messages.
[[nodiscard]] std::string format_endings(bool (*is_so)(const FormatInfo&),
                                         std::string_view last = "or");

/// Size limit of a BVH file (bytes). This and the next three limits are checked before memory is
/// allocated.
inline constexpr std::size_t kBvhMaxBytes = info_of(FileFormat::bvh).max_bytes;
/// Largest number of joints and end sites in a BVH file.
inline constexpr int kBvhMaxNodes = 4096;
/// Largest number of frames in a BVH file.
inline constexpr int kBvhMaxFrames = 200'000;
inline constexpr std::size_t kBvhMaxTransforms = 8'000'000;  ///< largest frames × nodes: 450 MB
/// Largest magnitude of a number in a BVH file; infinities and NaN are refused too.
inline constexpr double kBvhMaxValue = 1e9;

/// One channel of a BVH joint: a column of the motion data.
struct BvhChannel {
  bool rotates = false;  ///< rotation about the axis; else translation along it
  Axis axis = Axis::x;   ///< axis of the parent's frame
};
/// (nodes) channels of each node, in file order; empty for end sites.
using BvhChannels = std::vector<std::vector<BvhChannel>>;

/// The content of a BVH file: motion, channels and faults.
struct BvhFile {
  SkeletonMotion motion;             ///< in the file's own unit and axes
  BvhChannels channels;              ///< channels of the nodes
  std::vector<Message> doubts{};     ///< tolerated faults, as warnings for the user
  std::vector<int> unread_frames{};  ///< indices of frames with invalid numbers, ascending
};

/// The treatment of a file with damaged motion data.
enum class BvhFaults {
  refused,  ///< damage is an error
  told,     ///< the readable part is used, with doubts; at least the skeleton without frames
};

/// Parses BVH text. Lengths stay in the file's unit, which BVH does not state, and axes in the
/// file's directions; angles become rotations. Accepted are channels in any order and number per
/// joint, LF or CRLF, and several roots. Errors state the line, the value seen and the values
/// allowed; `name` stands for the file in them.
///
/// - A joint's rotation is the product of its axis rotations in channel order, R = R1 R2 R3; an
///   axis may occur twice.
/// - Position channels replace the OFFSET along their axis, for every joint, as animation tools
///   write the full position of a joint in its parent there. MakeHuman writes a difference to the
///   OFFSET instead; this is assumed if joints below the roots have position channels that are
///   nearly all 0 in the first frame while the OFFSETs are not.
/// - A name is the rest of its line, spaces included. Bytes that are not UTF-8 and control
///   characters become '_', a joint without a name is called "joint", and repeated names get "_2",
///   "_3", … so that names are unique. End sites have no name.
/// - Keywords and channels may be in lower case. Values may be spread over lines in any way, but
///   there must be exactly frames × channels of them; one extra frame is ignored, since some
///   writers count frames from 0.
[[nodiscard]] Result<SkeletonMotion> parse_bvh(std::string_view text, std::string_view name);

/// Parses BVH text with its channels. Faults that BvhFaults::told tolerates: missing motion or
/// frames, an invalid frame time, missing or surplus rows, and invalid numbers.
[[nodiscard]] Result<BvhFile> parse_bvh_file(std::string_view text, std::string_view name,
                                             BvhFaults faults = BvhFaults::refused);

/// Reads a BVH file (see parse_bvh).
[[nodiscard]] Result<SkeletonMotion> read_bvh(const std::filesystem::path& path);

/// Settings of format_bvh.
struct BvhFormat {
  double unit = 0.01;  ///< m per written unit; the default, centimetres, is usual for BVH
  /// Channels of the nodes, as in another file; empty: see format_bvh. A node uses its own channels
  /// only if they can express its motion: three different rotations, and three positions if it
  /// moves. A node that does not move loses position channels; a moving node without them keeps the
  /// order of its rotations.
  BvhChannels channels{};
};

/// Formats a motion as BVH text. Roots have 6 channels, other nodes Zrotation Xrotation Yrotation;
/// a node that also moves within its parent has 6 channels like a root. Angles are continuous from
/// frame to frame, without jumps of 360°, also through gimbal lock. Numbers have enough digits that
/// reading them back moves no origin of a human body by more than 1e-6 m.
///
/// The OFFSET of a root and of a moving node is written as 0, since tools differ in whether
/// position channels are relative to it (three.js) or to the parent (Blender). Nodes are written
/// depth first, children in order. Blanks within names, braces and control characters become '_',
/// and names are made unique as in parse_bvh. At least one frame is needed.
[[nodiscard]] std::string format_bvh(const SkeletonMotion& motion, const BvhFormat& format = {});

/// Node indices in the order of format_bvh: (nodes).
[[nodiscard]] std::vector<int> bvh_order(const Skeleton& skeleton);

}  // namespace shigusa
