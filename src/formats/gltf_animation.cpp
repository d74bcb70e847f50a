// SPDX-License-Identifier: MIT
#include "formats/gltf_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "core/index.hpp"
#include "core/say.hpp"
#include "files/file.hpp"
#include "formats/gltf_json.hpp"
#include "gltf_accessor.hpp"
#include "gltf_pose.hpp"
#include "gltf_tracks.hpp"
#include "gltf_vrm.hpp"
#include "human/landmark_points.hpp"

namespace shigusa {
namespace {

// VRM animations name their bones in the same form as VRM characters.
void take_animation_bones(const JsonSplice& json, const std::vector<int>& place, int nodes,
                          GltfMotion& result) {
  const auto extensions = json.member(json.root(), "extensions");
  const auto humanoid = json.member(json.member(extensions, "VRMC_vrm_animation"), "humanoid");
  if (!humanoid) return;
  const Result<GltfJson> parsed = parse_small_json(json.text_of(humanoid), "humanoid");
  if (!parsed) return;
  const GltfJson as_vrm{{"extensions", {{"VRMC_vrm", {{"humanoid", *parsed}}}}}};
  VrmBones bones = read_vrm_bones(as_vrm, nodes);
  for (const HumanoidBone bone : kHumanoidBones) {
    if (bones.map[bone] < 0) continue;
    result.character.humanoid[bone] = place[index(bones.map[bone])];
  }
}

std::vector<std::string> names_of(const JsonSplice& json, const std::string& file) {
  std::vector<std::string> names;
  for (const auto& each : json.elements(json.member(json.root(), "animations"))) {
    const Result<GltfJson> name = parse_small_json(json.text_of(json.member(each, "name")), file);
    names.push_back(name && name->is_string() && !name->empty() ? name->get<std::string>()
                                                                : std::to_string(names.size()));
  }
  return names;
}

class AnimationReader {
 public:
  AnimationReader(const GlbParts& parts, std::string_view name, GltfMotion& result)
      : json_(parts.json), accessors_(parts, name), name_(name), result_(result) {
    int most = -1;
    for (const int node : result.character.file_node) most = std::max(most, node);
    place_.assign(static_cast<std::size_t>(most + 1), -1);
    for (std::size_t i = 0; i < result.character.file_node.size(); ++i) {
      place_[index(result.character.file_node[i])] = static_cast<int>(i);
    }
    take_animation_bones(json_, place_, most + 1, result);
  }

  Result<void> read(const AnimationChoice& choice) {
    told_ = choice.gaps;
    SHG_TRY_ASSIGN(const GltfJson animation, choose(choice.animation));
    SHG_TRY(tracks(animation));
    read_actions(animation);
    return sample(choice);
  }

 private:
  tl::unexpected<Error> wrong(const Message& why) const {
    return fail(ErrorCode::parse, why,
                fmt::format("animation '{}' of {}", result_.animation, name_));
  }

  Result<GltfJson> choose(const std::string& wanted) {
    const auto list = json_.elements(json_.member(json_.root(), "animations"));
    if (list.empty()) {
      return fail(ErrorCode::parse, say("no_animation"), name_);
    }
    const std::vector<std::string> names = names_of(json_, name_);
    std::size_t chosen = 0;
    if (!wanted.empty()) {
      const auto same = std::find(names.begin(), names.end(), wanted);
      chosen = static_cast<std::size_t>(same - names.begin());
      const auto read = std::from_chars(wanted.data(), wanted.data() + wanted.size(), chosen);
      const bool number = read.ec == std::errc{} && read.ptr == wanted.data() + wanted.size();
      if (same != names.end()) chosen = static_cast<std::size_t>(same - names.begin());
      if ((same == names.end() && !number) || chosen >= names.size()) return none(wanted, names);
    } else if (names.size() > 1) {
      result_.doubts.push_back(say("first_animation", names.size(), names.front()));
    }
    result_.animation = names[chosen];
    return parse_small_json(json_.text_of(list[chosen]),
                            fmt::format("animations[{}] of {}", chosen, name_));
  }

  tl::unexpected<Error> none(const std::string& wanted,
                             const std::vector<std::string>& names) const {
    constexpr std::size_t kTold = 12;
    std::string all;
    for (std::size_t i = 0; i < std::min(names.size(), kTold); ++i) {
      all += (i > 0 ? ", '" : "'") + names[i].substr(0, 60) + "'";
    }
    if (names.size() > kTold) all += fmt::format(" and {} more", names.size() - kTold);
    return fail(ErrorCode::invalid_argument, say("no_such_animation", wanted.substr(0, 80), all),
                name_);
  }

  // Times that are no numbers or out of order are as good as none.
  void read_actions(const GltfJson& animation) {
    const auto extras = animation.find("extras");
    if (extras == animation.end() || !extras->is_object()) return;
    const auto list = extras->find("shigusa_actions");
    if (list == extras->end() || !list->is_array()) return;
    std::vector<GltfActionTime> actions;
    double before = 0.0;
    for (const GltfJson& one : *list) {
      const auto number = [&one](const char* key) {
        return one.is_object() && one.contains(key) && one[key].is_number() ? one[key].get<double>()
                                                                            : -1.0;
      };
      const GltfActionTime time{number("start_s"), number("end_s")};
      if (!(time.start >= before && time.end >= time.start) || !is_finite(time.end)) return;
      before = time.start;
      actions.push_back(time);
    }
    result_.actions = std::move(actions);
  }

  Result<void> tracks(const GltfJson& animation) {
    tracks_.resize(result_.character.file_node.size());
    for (const char* key : {"channels", "samplers"}) {
      if (!animation.is_object() || !animation.contains(key) || !animation[key].is_array()) {
        return wrong(say("no_list_of", key));
      }
    }
    for (const GltfJson& channel : animation["channels"]) {
      if (Result<void> taken = take(channel, animation["samplers"]); !taken) {
        if (!told_) return taken;
        left_out_.push_back(taken.error().message);
      }
    }
    if (!left_out_.empty()) {
      result_.doubts.push_back(say("tracks_left_out", left_out_.size(), left_out_[0]));
    }
    return {};
  }

  Result<void> take(const GltfJson& channel, const GltfJson& samplers) {
    if (!channel.is_object() || !channel.contains("target") || !channel["target"].is_object()) {
      return wrong(say("channel_no_target"));
    }
    const GltfJson& target = channel["target"];
    if (!target.contains("node") || !target["node"].is_number_unsigned()) return {};
    const auto node = target["node"].get<std::uint64_t>();
    const int at = node < place_.size() ? place_[static_cast<std::size_t>(node)] : -1;
    constexpr std::array kPaths{"translation", "rotation", "scale"};
    const auto path = std::find(kPaths.begin(), kPaths.end(),
                                target.contains("path") && target["path"].is_string()
                                    ? target["path"].get<std::string>()
                                    : "");
    if (at < 0 || path == kPaths.end()) return {};
    const bool known = channel.contains("sampler") && channel["sampler"].is_number_unsigned() &&
                       channel["sampler"] < static_cast<std::uint64_t>(samplers.size()) &&
                       samplers[channel["sampler"].get<std::size_t>()].is_object();
    if (!known) return lost(at, say("channel_sampler"));
    const GltfJson& sampler = samplers[channel["sampler"].get<std::size_t>()];
    std::vector<KeyGap> gaps;
    Result<GltfTrackKeys> keys = read_track_keys(sampler, path - kPaths.begin() == 1 ? 4 : 3,
                                                 accessors_, told_ ? &gaps : nullptr);
    if (!keys) return lost(at, keys.error().to_message());
    for (const KeyGap& gap : gaps) gaps_.emplace_back(at, gap);
    duration_ = max(duration_, keys->end);
    tracks_[index(at)][static_cast<std::size_t>(path - kPaths.begin())] = std::move(*keys);
    return {};
  }

  // An unreadable track of a node.
  Result<void> lost(int node, const Message& why) {
    constexpr double kEver = std::numeric_limits<double>::infinity();
    gaps_.emplace_back(node, KeyGap{-1.0, kEver});
    return wrong(why);
  }

  // Frames within the gaps between keys.
  void tell_gaps(double frame_time, int frames) {
    for (const auto& [node, gap] : gaps_) {
      const auto within = [&, &gap = gap](int f) {
        const double time = f * frame_time;
        return time > gap.after && time < gap.before;
      };
      int first = 0;
      while (first < frames && !within(first)) ++first;
      int last = first;
      while (last + 1 < frames && within(last + 1)) ++last;
      if (first < frames) result_.gaps.push_back({node, first, last});
    }
    if (result_.gaps.empty()) return;
    const GltfGap& gap = result_.gaps[0];
    result_.doubts.push_back(say("keys_left_out", result_.gaps.size(),
                                 result_.character.rest.skeleton.nodes[index(gap.node)].name,
                                 gap.first, gap.last));
  }

  Result<void> sample(const AnimationChoice& choice) {
    const double rate = choice.frame_rate;
    const Skeleton& rest = result_.character.rest.skeleton;
    const double most = min(kGltfMaxFrames, static_cast<double>(kGltfMaxTransforms) /
                                                static_cast<double>(rest.nodes.size()));
    constexpr double kRounding = 1e-4;  // of a frame: times are single precision
    const double frames = duration_ * rate + kRounding + 1.0;
    if (!(frames <= most)) {
      return wrong(say("lasts", duration_, frames, rate, most));
    }
    result_.motion.skeleton = rest;
    SkeletonClip& clip = result_.motion.clip;
    clip.frame_time = 1.0 / rate;
    clip.frames = static_cast<int>(frames);
    clip.local.reserve(static_cast<std::size_t>(clip.frames) * rest.nodes.size());
    resting_ = placed_nodes(rest, result_.character.places);
    for (int f = 0; f < clip.frames; ++f) {
      SHG_TRY(add_frame(rest, f * clip.frame_time));
      if (f == choice.posed) result_.posed = places(f * clip.frame_time);
    }
    tell_gaps(clip.frame_time, clip.frames);
    return {};
  }

  // Local transforms of the nodes at a time.
  [[nodiscard]] std::vector<GltfPlace> places(double time) const {
    std::vector<GltfPlace> all = result_.character.places;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      const auto& [moves, turns, scales] = tracks_[i];
      if (!moves.times.empty()) all[i].translation = moves.vector_at(time);
      if (!turns.times.empty()) all[i].rotation = turns.rotation_at(time);
      if (!scales.times.empty()) all[i].scale = scales.vector_at(time);
    }
    return all;
  }

  Result<void> add_frame(const Skeleton& rest, double time) {
    const std::vector<Transformd> world = placed_nodes(rest, places(time));
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Vec3d& at = world[i].translation;
      if (abs(at.x) + abs(at.y) + abs(at.z) <= kGltfMaxValue) continue;
      return wrong(say("stands_beyond_at", time, rest.nodes[i].name, kGltfMaxValue));
    }
    const std::vector<LocalTransform> local = turned_from_rest(rest, resting_, world);
    std::vector<LocalTransform>& all = result_.motion.clip.local;
    all.insert(all.end(), local.begin(), local.end());
    return {};
  }

  JsonSplice json_;
  GltfAccessors accessors_;
  std::string name_;
  GltfMotion& result_;
  std::vector<int> place_;  // (nodes of the file) index in the skeleton, or -1
  std::vector<std::array<GltfTrackKeys, 3>> tracks_;  // (nodes) translation, rotation, scale
  std::vector<Transformd> resting_;
  double duration_ = 0.0;                     // s
  bool told_ = false;                         // damaged tracks are left out
  std::vector<std::pair<int, KeyGap>> gaps_;  // by node
  std::vector<Message> left_out_;             // why tracks are
};

}  // namespace

Result<std::vector<std::string>> gltf_animation_names(std::string_view bytes,
                                                      std::string_view name) {
  SHG_TRY_ASSIGN(const GlbParts parts, glb_parts(bytes, name));
  return names_of(JsonSplice(parts.json), std::string(name));
}

Result<GltfMotion> parse_gltf_animation(std::string_view bytes, std::string_view name,
                                        const AnimationChoice& choice) {
  if (!(choice.frame_rate > 0.0) || !is_finite(choice.frame_rate)) {
    return fail(ErrorCode::invalid_argument, say("frame_rate", choice.frame_rate));
  }
  SHG_TRY_ASSIGN(GltfCharacter character, parse_gltf(bytes, name));
  SHG_TRY_ASSIGN(const GlbParts parts, glb_parts(bytes, name));
  GltfMotion result{std::move(character), {}, {}, {}, {}, {}};
  result.doubts = result.character.doubts;
  SHG_TRY(AnimationReader(parts, name, result).read(choice));
  return result;
}

Result<GltfMotion> read_gltf_animation(const std::filesystem::path& path,
                                       const AnimationChoice& choice) {
  SHG_TRY_ASSIGN(const std::string bytes, read_text_file(path, kGltfMaxBytes));
  return parse_gltf_animation(bytes, path.filename().string(), choice);
}

}  // namespace shigusa
