// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <shigusa/character.hpp>
#include <shigusa/error.hpp>
#include <shigusa/generate.hpp>
#include <shigusa/motion.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

/// People's own motion is slower than this (Hz): what is faster in recorded angles is noise, which
/// second differences blow up (D. A. Winter, Biomechanics and Motor Control of Human Movement).
inline constexpr double kMotionCutoff = 6.0;
/// A foot that is recorded to move by more than this (m) is no foot that stands.
inline constexpr double kFootSteps = 0.03;
/// Joints that are this far (m) from the recorded ones on average make another motion.
inline constexpr double kFollowsBadly = 0.03;

/// How a recorded motion is scored.
struct ScoreSettings {
  CriteriaSettings criteria = default_criteria();  ///< the mixture
  int first = 0;                                   ///< the first frame of the file that is scored
  std::optional<int> last{};  ///< the last one, included; the file's last when not given
  /// Hz, faster motion is smoothed away; 0 takes the angles as they are
  double cutoff = kMotionCutoff;
};

/// A clip's scoring as JSON asks for it: {"criteria": "default", "first": 0, "last": 80,
/// "smoothed_hz": 6, "animation": "Take 1", "character": …}, all of which may be left out.
struct ClipRequest {
  ScoreSettings settings{};  ///< how it is scored
  std::string animation{};   ///< name or index of it in the file; the first when empty
  std::optional<CharacterSpec> character{};  ///< the clip's own person when not given
};
/// Parses such a text; `name` stands for it in errors.
[[nodiscard]] Result<ClipRequest> parse_clip_request(std::string_view text, std::string_view name);

/// The score of a clip's motion on a body.
struct ClipScore {
  Score score;                  ///< by the settings' criteria
  Motion motion;                ///< smoothed; of the frames that are scored, without effectors
  ClipFit fit;                  ///< as recorded, with the frames around
  MotionMeasures measures;      ///< what the motion asks of the body
  FinalPosture final_posture;   ///< how it ends
  std::vector<Message> doubts;  ///< that make the figures worth less
};

/// Ties a skeleton to a body.
struct Rig;

/// A motion file, and the body that it drives.
struct RecordedMotion {
  SkeletonMotion motion;           ///< as the file has it
  std::shared_ptr<const Rig> rig;  ///< of its nodes; there where it was read
  BodyModel body;                  ///< that follows it
};

/// Reads a clip: .bvh, or an animation of a .glb, .gltf, .vrm or .vrma file, sampled at 60 Hz, by
/// its name or its index, the first where none is given. The body is the clip's person, as measured
/// in the frame character.frame, where character.source is the clip's own path; and else the one
/// that it names, to whose stature the clip is scaled by its person in the frame `first`. A robot
/// is refused: its joints are no person's.
[[nodiscard]] Result<RecordedMotion> read_recorded(const std::filesystem::path& clip,
                                                   CharacterSpec character, int first,
                                                   const std::string& animation = {});

/// Reads a clip in memory, whose file's name tells its kind; character.source is that name where
/// the clip's person is meant.
[[nodiscard]] Result<RecordedMotion> parse_recorded(std::string_view bytes, const std::string& name,
                                                    CharacterSpec character, int first,
                                                    const std::string& animation = {});

/// Scores the frames by the criteria that generated motions are scored by. Speeds and accelerations
/// see the frames around them; where the file begins or ends it goes on as it came. Fails where
/// frames do not exist, or criteria are out of range.
[[nodiscard]] Result<ClipScore> score_clip(const RecordedMotion& recorded,
                                           const ScoreSettings& settings = {});

/// The score as JSON text: the object that `shigusa score --json` prints, in whose `criteria` the
/// names are those of summary.json.
[[nodiscard]] std::string format_clip_score(const std::string& clip, const RecordedMotion& recorded,
                                            const ScoreSettings& settings, const ClipScore& score);

}  // namespace shigusa
