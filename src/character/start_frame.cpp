// SPDX-License-Identifier: MIT
#include "start_frame.hpp"

#include <algorithm>
#include <shigusa/criteria.hpp>

#include "core/say.hpp"
#include "dynamics/clip_dynamics.hpp"
#include "human/at_ease.hpp"
#include "human/stance.hpp"
#include "recording.hpp"

namespace shigusa {
namespace {

// Limits on the effort of holding a start posture.
struct Hold {
  double share = 1.0;    // of a joint's strength
  double outside = 0.0;  // m, of the centre of mass beside the feet
};
constexpr Hold kSurely{1.0, 0.0};
constexpr Hold kBarely{1.5, 0.05};  // no motion is possible beyond it

bool could_hold(CharacterSpec spec, const Landmarks& start, double stature, const Hold& hold) {
  spec.stature = stature;
  spec.landmarks = start;
  spec.seat = std::nullopt;
  spec.heels = false;
  const Result<PosedBody> body = build_character(spec);
  if (!body) return true;  // reported where the body is built
  const Motion held = held_still(body->body, body->home);
  for (const JointLoad& load : joint_loads(*body, held)) {
    if (load.share > hold.share) return false;
  }
  const std::optional<SupportMargins> support = support_margins(*body, held);
  return !support || support->centre_of_mass.distance >= -hold.outside;
}

class StartChooser {
 public:
  StartChooser(const CharacterFile& file, const CharacterSpec& spec, const PersonStart& known,
               const FilePoses& poses)
      : spec_(spec),
        known_(known),
        poses_(poses),
        world_(world_transforms(file.skeleton, known.measured.clip(), 0)),
        recording_(file, known.map, known.person, world_) {}

  [[nodiscard]] Result<PersonStart> asked(int frame) const {
    SHG_TRY_ASSIGN(PersonStart found, poses_.in_frame(frame));
    SHG_TRY(check_up(frame));
    const Landmarks seen = recording_.at(frame);
    const std::optional<double> seat = seat_below(seen, stature());
    std::vector<Message>& doubts = found.start.doubts;
    found.sits = spec_.seat && seat;
    if (found.sits && abs(*seat - *spec_.seat) > kSameSeat) {
      doubts.push_back(say("frame_seat", frame, Metres{*seat}, Metres{*spec_.seat}));
    } else if (spec_.seat && !seat) {
      doubts.push_back(say("frame_no_seat", frame));
    } else if (!spec_.seat && seat) {
      tell_seat(frame, *seat, doubts);
    } else if (!spec_.seat && !could_hold(spec_, found.start.landmarks, stature(), kBarely)) {
      doubts.push_back(say("frame_no_stance", frame));
    }
    return found;
  }

  // Start if none was requested; `first` is the first available frame.
  [[nodiscard]] Result<PersonStart> found(int first) const {
    const std::optional<double> seat = seat_below(recording_.at(first), stature());
    const std::optional<int> stand = spec_.seat && seat ? first : first_stand(true);
    if (stand == 0) return poses_.in_frame(0);
    Result<PersonStart> start = stand ? poses_.in_frame(*stand) : poses_.at_rest();
    const bool stands = stand || (start && stands_at_rest(start->person.landmarks, stature()));
    const int otherwise = stands ? first : first_stand(false).value_or(first);
    if (!stands) {
      SHG_TRY(check_up(otherwise));
      start = poses_.in_frame(otherwise);
    }
    if (!start) return start;
    std::vector<Message>& doubts = start->start.doubts;
    if (!spec_.seat) {
      if (seat) tell_seat(first, *seat, doubts);
      doubts.push_back(stand    ? say("later_frame", *stand)
                       : stands ? say("no_stance")
                                : say("nothing_stands", otherwise));
    }
    start->frame = stand ? *stand : stands ? kRestPose : otherwise;
    return start;
  }

  [[nodiscard]] bool begins_standing() const { return first_stand(true) == 0; }

 private:
  // Difference (m) beyond which a frame's seat is not the requested one.
  static constexpr double kSameSeat = 0.08;

  [[nodiscard]] double stature() const { return known_.person.stature; }

  // Fails if the person lies.
  [[nodiscard]] Result<void> check_up(int frame) const {
    if (!lies(recording_.at(frame), stature())) return {};
    return fail(ErrorCode::invalid_argument, say("frame_lies", frame), spec_.source);
  }

  [[nodiscard]] std::optional<int> first_stand(bool still) const {
    return recording_.first_stand(still, [&](const Landmarks& person) {
      return could_hold(spec_, person, stature(), kSurely);
    });
  }

  static void tell_seat(int frame, double seat, std::vector<Message>& doubts) {
    if (seat >= kSeatMin && seat <= kSeatMax)
      doubts.push_back(say("frame_sits", frame, Metres{seat}));
  }

  const CharacterSpec& spec_;
  const PersonStart& known_;
  const FilePoses& poses_;
  std::vector<Transformd> world_;
  Recording recording_;
};

}  // namespace

Result<std::optional<int>> frame_of(const CharacterFile& file, const CharacterSpec& spec) {
  const int frames = file.motion.frames;
  const auto unread = [&](int frame) {
    return std::binary_search(file.unread_frames.begin(), file.unread_frames.end(), frame);
  };
  if (!spec.frame) {
    int first = 0;
    while (unread(first)) ++first;
    return first < frames ? std::optional(first) : std::nullopt;
  }
  const int frame = *spec.frame;
  if (frames == 0) {
    return fail(ErrorCode::invalid_argument, say("no_animation_frame", frame), spec.source);
  }
  if (frame < 0 || frame >= frames) {
    const std::string has = frames == 1 ? say("one_frame") : say("frames", frames - 1);
    return fail(ErrorCode::invalid_argument, say("no_frame", frame, has), spec.source);
  }
  if (unread(frame)) {
    return fail(ErrorCode::invalid_argument, say("frame_unread", frame), spec.source);
  }
  return frame;
}

Result<PersonStart> choose_start(const CharacterFile& file, const CharacterSpec& spec,
                                 const PersonStart& known, int frame, const FilePoses& poses) {
  const StartChooser chooser(file, spec, known, poses);
  return spec.frame ? chooser.asked(frame) : chooser.found(frame);
}

bool begins_standing(const CharacterFile& file, const CharacterSpec& spec,
                     const PersonStart& known) {
  const FilePoses none;
  return StartChooser(file, spec, known, none).begins_standing();
}

}  // namespace shigusa
