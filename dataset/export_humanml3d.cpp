// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "export_caption.hpp"
#include "export_index.hpp"
#include "export_npy.hpp"
#include "export_poses.hpp"
#include "export_writer.hpp"

namespace shigusa {
namespace {

// A joint of HumanML3D: one of our nodes, or, if that is missing, the point at this share of the
// line between two others.
struct Joint {
  std::string_view name;
  std::string_view node;
  std::string_view says;
  std::string_view from = {};
  std::string_view to = {};
  double share = 0.0;
};
// The joints in HumanML3D's order, that of SMPL's first 22. The shares are those of shigusa's own
// body, human.
constexpr std::array<Joint, 22> kJoints{{
    {"pelvis", "hips", "approximate: ours lies between the hip joints, SMPL's some 9 cm higher"},
    {"left_hip", "left_upper_leg", ""},
    {"right_hip", "right_upper_leg", ""},
    {"spine1", "spine", "approximate: another place of the spine", "hips", "neck", 0.17},
    {"left_knee", "left_lower_leg", ""},
    {"right_knee", "right_lower_leg", ""},
    {"spine2", "chest", "approximate: another place of the spine", "hips", "neck", 0.47},
    {"left_ankle", "left_foot", ""},
    {"right_ankle", "right_foot", ""},
    {"spine3", "upper_chest", "approximate: another place of the spine", "hips", "neck", 0.72},
    {"left_foot", "left_toes", "where the toes bend"},
    {"right_foot", "right_toes", "where the toes bend"},
    {"neck", "neck", "the neck's base"},
    {"left_collar", "left_shoulder", "the clavicle's joint at the breastbone", "neck",
     "left_upper_arm", 0.11},
    {"right_collar", "right_shoulder", "the clavicle's joint at the breastbone", "neck",
     "right_upper_arm", 0.11},
    {"head", "head", "the joint of neck and skull"},
    {"left_shoulder", "left_upper_arm", ""},
    {"right_shoulder", "right_upper_arm", ""},
    {"left_elbow", "left_lower_arm", ""},
    {"right_elbow", "right_lower_arm", ""},
    {"left_wrist", "left_hand", ""},
    {"right_wrist", "right_hand", ""},
}};

// Source of a joint: one node, or two with the share of the line between them.
struct Source {
  int from = -1;
  int to = -1;
  double share = 0.0;
};

Result<std::array<Source, kJoints.size()>> sources_of(const NodePlaces& places) {
  std::array<Source, kJoints.size()> sources;
  for (std::size_t j = 0; j < kJoints.size(); ++j) {
    const Joint& joint = kJoints[j];
    sources[j] = {places.find(joint.node), places.find(joint.node), 0.0};
    if (sources[j].from >= 0) continue;
    sources[j] = {places.find(joint.from), places.find(joint.to), joint.share};
    if (sources[j].from < 0 || sources[j].to < 0) {
      return fail(ErrorCode::unsupported,
                  fmt::format("the body has no node '{}', which is HumanML3D's {}: bodies with two "
                              "arms and two legs can leave so",
                              joint.node, joint.name));
    }
  }
  return sources;
}

constexpr const char* kAboutHumanMl3d = R"(
As in HumanML3D: `new_joints/` has a file a motion, frames × 22 × 3 (m, 32-bit floats) at 20 frames a
second; `texts/` its sentence as `caption#tokens#0.0#0.0`, the whole motion; `train.txt`, `val.txt` and
`test.txt` the names of each part, which no two parts share a person of. y is up, the floor is at 0, and
people face z at the start, their left is x. The last frame is the first that is not before the motion's
end, and shows that end.

Sentences are made from goals, loads and measured postures by a few dozen words, not by people. A motion
lasts about a second, much less than those of HumanML3D, and nobody walks. Features and their mean and
deviation (`new_joint_vecs`, `Mean.npy`, `Std.npy`) come by HumanML3D's own `motion_representation`.

| joint | shigusa's node (VRM's name) | |
|---|---|---|
)";

std::string joints_table() {
  std::string text;
  for (const Joint& joint : kJoints) {
    text += fmt::format("| {} | {} | {}", joint.name, joint.node, joint.says);
    if (joint.share > 0.0) {
      text +=
          fmt::format("{}of bodies without it: {:.0f} % of the way from {} to {}",
                      joint.says.empty() ? "" : "; ", 100.0 * joint.share, joint.from, joint.to);
    }
    text += " |\n";
  }
  return text;
}

// Least number of frames that HumanML3D's readers accept.
constexpr std::size_t kReadFrames = 40;

class HumanMl3dWriter : public DataWriter {
 public:
  explicit HumanMl3dWriter(const ExportJob& job) : job_(job), poses_(job.data.plan) {}

  [[nodiscard]] std::vector<DatasetSeries> series() const override {
    return poses_.series_for_places();
  }

  Result<void> add(const DataMotion& motion) override {
    SHG_TRY_ASSIGN(const NodePlaces kept, poses_.places(motion));
    SHG_TRY_ASSIGN(const auto sources, sources_of(kept));
    if (motions_ == 0) SHG_TRY(begin());
    const NodePlaces places = at_rate(kept, job_.rate);
    std::vector<float> numbers;
    for (std::size_t f = 0; f < places.frames(); ++f) {
      for (const Source& source : sources) {
        const Vec3d from = places.at(f, source.from);
        const Vec3d place = from + source.share * (places.at(f, source.to) - from);
        for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<float>(place[k]));
      }
    }
    constexpr std::size_t kFrame = 3 * kJoints.size();
    const std::size_t frames = std::max(places.frames(), job_.settings.least_frames);
    while (!numbers.empty() && numbers.size() < frames * kFrame) {
      numbers.push_back(numbers[numbers.size() - kFrame]);
    }
    const std::string id = motion.id();
    SHG_TRY(job_.folder.put("new_joints/" + id + ".npy",
                            npy::floats(numbers, {frames, kJoints.size(), 3})));
    const std::string caption = caption_of(motion);
    SHG_TRY(job_.folder.put("texts/" + id + ".txt",
                            fmt::format("{}#{}#0.0#0.0\n", caption, tokens_of(caption))));
    ++motions_;
    if (frames < kReadFrames) ++short_;
    return parts_[static_cast<std::size_t>(split_of(motion, job_.data.plan))].add(id + "\n");
  }

  Result<void> finish() override {
    for (LongFile& part : parts_) SHG_TRY(part.finish());
    return job_.folder.put("README.md", about_export(job_, motions_) + about_lengths() +
                                            kAboutHumanMl3d + joints_table());
  }

 private:
  // Number of motions that these readers leave out.
  [[nodiscard]] std::string about_lengths() const {
    std::string text = fmt::format(
        "\nHumanML3D's usual readers leave out motions of fewer than {} frames, which is {} of "
        "these "
        "{}. ",
        kReadFrames, short_, motions_);
    text += job_.settings.least_frames > 0
                ? fmt::format("Shorter motions hold their last pose up to {} frames.\n",
                              job_.settings.least_frames)
                : fmt::format("With `--least-frames {}` they hold their last pose up to that.\n",
                              kReadFrames);
    return text;
  }

  Result<void> begin() {
    constexpr std::array kParts{"train.txt", "val.txt", "test.txt"};
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      SHG_TRY(parts_[k].begin(job_.settings.to / kParts[k]));
    }
    return {};
  }

  const ExportJob& job_;
  Poses poses_;
  std::array<LongFile, 3> parts_;  // by Split
  std::uint64_t motions_ = 0;
  std::uint64_t short_ = 0;  // of fewer frames than readers take
};

}  // namespace

template <>
Result<std::unique_ptr<DataWriter>> make_writer<DataFormat::humanml3d>(const ExportJob& job) {
  return std::make_unique<HumanMl3dWriter>(job);
}

}  // namespace shigusa
