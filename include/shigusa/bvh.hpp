// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <shigusa/file_format.hpp>
#include <shigusa/result.hpp>
#include <shigusa/skeleton.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

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
