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

/// The formats of files that are read or written.
enum class FileFormat {
  bvh,   ///< Biovision hierarchy: people, clips and motions
  csv,   ///< a table with one row a frame
  svg,   ///< a strip figure
  png,   ///< a strip figure
  pdf,   ///< a strip figure
  glb,   ///< binary glTF
  vrma,  ///< VRM animation
  vrm,   ///< VRM character
  fbx,   ///< a character, read as the glTF file of it
  urdf,  ///< robot
  mjcf,  ///< robot of MuJoCo
};

/// The file that a character must have come from for its motions to leave in a format.
enum class NeededFile {
  none,  ///< any character
  gltf,  ///< glTF, and VRM as one of its kind
  vrm,   ///< VRM alone
};

/// The facts of a format. All code that reads, writes, lists or describes files goes by this table;
/// a format that is written has a function write_as (src/document/export_file.hpp), one of people a
/// function read_person (src/character/character_file.hpp).
struct FormatInfo {
  /// The format that the row is of.
  FileFormat format;
  std::string_view word;                    ///< it is asked for by, and written files end in
  std::array<std::string_view, 2> endings;  ///< of files that are read: ".glb"; "" where there is
                                            ///< no other
  /// The media type of its files.
  std::string_view media_type;
  std::string_view about;     ///< one sentence
  bool person = false;        ///< people are read from it,
  bool robot = false;         ///< robots,
  bool clip = false;          ///< and recorded motion
  bool written = false;       ///< a motion can leave in it
  bool usual = false;         ///< it does where nothing is said and the character can
  bool rated = false;         ///< it has the motion at the rate that is asked for
  std::size_t max_bytes = 0;  ///< of a file that is read
  /// The character's file that writing needs.
  NeededFile needs = NeededFile::none;
  bool from_svg = false;   ///< made of the SVG by a program that can (FileSettings::from_svg)
  bool mannequin = false;  ///< built-in bodies leave in it as the mannequin (has_mannequin), where
                           ///< it is asked for
};

/// Bytes.
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
};
/// The words of FileFormat.
template <>
inline constexpr auto kEnumWords<FileFormat> = words_of_table(kFileFormats, &FormatInfo::format);

/// The row of a format.
[[nodiscard]] constexpr const FormatInfo& info_of(FileFormat format) {
  return kFileFormats[static_cast<std::size_t>(format)];
}

/// Whether a character's file of a format is what another format needs. An FBX file is taken as the
/// glTF file of its skeleton.
[[nodiscard]] constexpr bool is_file(FileFormat character, NeededFile needed) {
  const bool vrm = character == FileFormat::vrm;
  const bool gltf = vrm || character == FileFormat::glb || character == FileFormat::fbx;
  return needed == NeededFile::none || (needed == NeededFile::vrm ? vrm : gltf);
}

/// Whether this build has the mannequin, which zlib unpacks.
[[nodiscard]] bool has_mannequin();

/// The ending of a file's name in lower case: ".bvh".
[[nodiscard]] std::string file_ending(const std::string& name);

/// The format of a file by its name's ending, in any case; nothing where that is none that is read.
[[nodiscard]] std::optional<FileFormat> format_of_file(const std::string& name);

/// The words or the endings of the formats that are so, for messages: "bvh, glb and vrma".
[[nodiscard]] std::string format_words(bool (*is_so)(const FormatInfo&),
                                       std::string_view last = "and");
/// The endings of such formats.
[[nodiscard]] std::string format_endings(bool (*is_so)(const FormatInfo&),
                                         std::string_view last = "or");

/// The most bytes of a file; more is refused before memory is taken, as is what is beyond the next
/// three.
inline constexpr std::size_t kBvhMaxBytes = info_of(FileFormat::bvh).max_bytes;
/// The most joints and end sites of a file.
inline constexpr int kBvhMaxNodes = 4096;
/// The most frames of a file.
inline constexpr int kBvhMaxFrames = 200'000;
inline constexpr std::size_t kBvhMaxTransforms = 8'000'000;  ///< frames × nodes: 450 MB
/// Numbers beyond this are refused, infinities and NaN among them.
inline constexpr double kBvhMaxValue = 1e9;

/// One column of a BVH's motion.
struct BvhChannel {
  bool rotates = false;  ///< about the axis; else it moves along it
  Axis axis = Axis::x;   ///< of the parent's frame
};
/// (nodes) the channels of each in their order; of end sites none.
using BvhChannels = std::vector<std::vector<BvhChannel>>;

/// A BVH file: its motion, and how it writes it.
struct BvhFile {
  SkeletonMotion motion;             ///< in the file's own unit and axes
  BvhChannels channels;              ///< of its nodes
  std::vector<Message> doubts{};     ///< faults that were told
  std::vector<int> unread_frames{};  ///< frames, rising, with values that are no numbers
};

/// The way that a file with a damaged motion is taken.
enum class BvhFaults {
  refused,  ///< an error
  told,     ///< what it still has is taken, with doubts; its skeleton without frames at the least
};

/// Parses BVH text. Lengths stay in the file's own unit (BVH does not tell it) and axes in the
/// file's own directions; angles become rotations. Channels in any order and number per joint, LF
/// or CRLF, several roots. Errors name the line, the value seen and what is allowed; `name` stands
/// for the file in them.
///
/// - A joint's rotation is the product of its axis rotations in the order of its channels,
///   R = R1 R2 R3; one axis may come twice.
/// - Position channels replace the OFFSET along their axis, for the root as for any other joint:
///   animation tools write the whole place of the joint in its parent there. MakeHuman writes what
///   is to be added to the OFFSET: a file whose joints below the roots have position channels, 0
///   nearly all in its first frame while the OFFSETs are not, is read so.
/// - A name is the rest of its line, spaces included. Bytes that are no UTF-8 and control
///   characters become '_', a joint without name is called "joint", and a name that comes again
///   gets "_2", "_3", … so that names are unique. End sites have no name.
/// - Keywords and channels may be in lower case. Values may be spread over lines in any way, but
///   there must be exactly frames × channels of them; one whole frame more is left out, since some
///   writers count frames from 0.
[[nodiscard]] Result<SkeletonMotion> parse_bvh(std::string_view text, std::string_view name);

/// The same with the channels. Faults that may be told: no motion, or one without frames; a frame
/// time that is none; rows that are missing or more than promised; values that are no numbers.
[[nodiscard]] Result<BvhFile> parse_bvh_file(std::string_view text, std::string_view name,
                                             BvhFaults faults = BvhFaults::refused);

/// Reads and parses a BVH file.
[[nodiscard]] Result<SkeletonMotion> read_bvh(const std::filesystem::path& path);

/// How format_bvh writes a motion.
struct BvhFormat {
  double unit = 0.01;  ///< m per unit written: centimetres, what animation tools expect of BVH
  /// Channels of the nodes as another file has them; empty: as described below. A node keeps its
  /// own where they can tell its motion: three different rotations, and three positions if it
  /// moves; one that does not loses them. One that lacks positions keeps the order of its
  /// rotations.
  BvhChannels channels{};
};

/// The motion as BVH text: roots with 6 channels, other nodes with Zrotation Xrotation Yrotation; a
/// node that also moves within its parent has 6 channels as a root has. Angles go on from frame to
/// frame without jumps of 360°, through gimbal lock too. Numbers are written so that reading them
/// back moves no origin of a human body by more than 1e-6 m.
///
/// The OFFSET of a root and of a node that moves is written as 0, since tools differ in whether
/// position channels count from there (three.js) or from the parent (Blender).
/// Nodes come depth first, children in their order. Blanks within names, braces and control
/// characters become '_', and names are made unique as parse_bvh does. Needs at least one frame.
[[nodiscard]] std::string format_bvh(const SkeletonMotion& motion, const BvhFormat& format = {});

/// (nodes) indices in the order that format_bvh writes them.
[[nodiscard]] std::vector<int> bvh_order(const Skeleton& skeleton);

}  // namespace shigusa
