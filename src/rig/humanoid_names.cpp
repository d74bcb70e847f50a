// SPDX-License-Identifier: MIT
#include "humanoid_names.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/text.hpp"

namespace shigusa {
namespace {

struct PartWords {
  BonePart part;
  std::array<std::string_view, 15> words;  // the rest are empty
};

// Words of the conventions for the bones, in lower case and without separators.
constexpr PartWords kWords[] = {
    {BonePart::hips, {"hips", "pelvis"}},
    {BonePart::hip, {"hip", "hipjoint"}},
    {BonePart::upper_leg,
     {"upleg", "upperleg", "thigh", "femur", "uleg", "legupper", "legup", "legtop", "足", "大腿"}},
    {BonePart::leg, {"leg"}},
    {BonePart::lower_leg,
     {"lowerleg", "lowleg", "loleg", "leglower", "leglow", "legbottom", "lleg", "shin", "shank",
      "calf", "tibia", "knee", "ひざ", "小腿"}},
    {BonePart::ankle, {"ankle", "talus", "talocrural"}},
    {BonePart::foot, {"foot", "feet", "足首", "脚", "脚踝"}},
    {BonePart::toes,
     {"toe", "toes", "toebase", "ball", "foottoe", "toefoot", "football", "つま先", "脚趾"}},
    {BonePart::heel,
     {"heel", "heelbone", "calcaneus", "footheel", "footback", "backfoot", "footrear", "rearfoot",
      "toeback", "backtoe", "かかと", "脚跟"}},
    {BonePart::collar,
     {"collar", "clavicle", "clav", "collarbone", "scapula", "sternoclavicular",
      "acromioclavicular", "肩", "锁骨"}},
    {BonePart::shoulder, {"shoulder", "肩膀"}},
    {BonePart::upper_arm,
     {"upperarm", "uparm", "uarm", "armupper", "armup", "armtop", "bicep", "biceps", "humerus",
      "shldr", "腕", "上臂"}},
    {BonePart::lower_arm,
     {"armlower", "armlow", "armbottom", "forarm", "forearm", "lowerarm", "lowarm", "loarm", "larm",
      "farm", "elbow", "radius", "ulna", "ひじ", "前臂"}},
    {BonePart::arm, {"arm"}},
    {BonePart::hand, {"wrist", "radiocarpal", "hand", "手首", "手", "手腕"}},
    {BonePart::palm, {"palm", "fist"}},
    {BonePart::spine, {"spine", "torso", "chest"}},
    {BonePart::neck, {"neck", "lowerneck", "upperneck", "首", "颈", "脖子"}},
    {BonePart::head, {"head", "skullbase", "頭", "头"}},
};

// Words of joints that assist or control a bone, but are not the bone itself.
constexpr std::string_view kOthers[] = {
    "twist",   "roll",    "ik",     "fk",     "mch",   "pole",   "target",     "ctrl",
    "control", "goal",    "tweak",  "helper", "site",  "slot",   "effector",   "helmet",
    "muscle",  "index",   "middle", "ring",   "pinky", "little", "hint",       "metacarpal",
    "carpal",  "fingers", "mesh",   "geo",    "prop",  "finger", "corrective", "share",
    "bck",     "fwd",     "inner",  "outer",  "sec",   "adj",
};
// Words of attachments that belong to neither spine nor limbs.
constexpr std::string_view kOrnaments[] = {
    "face",     "facial", "jaw",      "chin",     "eye",       "eyes",       "eyeball", "eyelid",
    "lid",      "brow",   "brows",    "eyebrow",  "ear",       "ears",       "nose",    "nostril",
    "lip",      "lips",   "mouth",    "teeth",    "tooth",     "tongue",     "cheek",   "temple",
    "forehead", "hair",   "beard",    "ponytail", "pigtail",   "braid",      "hat",     "hood",
    "horn",     "horns",  "antenna",  "crown",    "tail",      "wing",       "wings",   "skirt",
    "cape",     "cloak",  "dress",    "ribbon",   "scarf",     "belt",       "breast",  "breasts",
    "bust",     "boob",   "pectoral", "sleeve",   "cloth",     "mane",       "weapon",  "sword",
    "shield",   "gun",    "bag",      "backpack", "imu",       "camera",     "cam",     "lidar",
    "sensor",   "laser",  "radar",    "gyro",     "realsense", "microphone", "mic",     "speaker",
    "led",      "logo",
};
constexpr std::string_view kThumbs[] = {"thumb", "lthumb", "rthumb", "左親指", "右親指"};
constexpr std::string_view kTips[] = {"end", "nub", "tip", "top"};

constexpr std::string_view kLeftWords[] = {"left", "l", "lft", "lt"};
constexpr std::string_view kRightWords[] = {"right", "r", "rgt", "rt"};

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
// bytes of UTF-8 beyond ASCII count as letters
bool is_letter(char c) { return is_upper(c) || is_lower(c) || (c & 0x80) != 0; }

BonePart part_of(std::string_view word) {
  for (const PartWords& part : kWords) {
    if (!word.empty() && contains(part.words, word)) return part.part;
  }
  return BonePart::none;
}

// Part named by the longest run of adjacent words.
BonePart longest_part(const std::vector<std::string>& words) {
  BonePart best = BonePart::none;
  std::size_t best_length = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string run;
    for (std::size_t k = i; k < words.size() && run.size() < 16; ++k) {
      run += words[k];
      const BonePart part = part_of(run);
      // of equally long runs the last one: "foot ball" is a ball and "arm hand" is a hand
      if (part == BonePart::none || run.size() < best_length) continue;
      best = part;
      best_length = run.size();
    }
  }
  return best;
}

// Parses a name without separators: "lfemur", "leftupleg", "handleft", "左足".
BoneName read_glued(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += word;
  for (const std::string_view prefix : {"left", "right", "左", "右", "l", "r"}) {
    if (!std::string_view(all).starts_with(prefix)) continue;
    const BonePart part = part_of(std::string_view(all).substr(prefix.size()));
    const bool left = prefix.starts_with('l') || prefix == "左";
    if (part != BonePart::none) return {part, left ? NameSide::left : NameSide::right};
  }
  for (const std::string_view suffix : {"left", "right", "l", "r"}) {
    if (!std::string_view(all).ends_with(suffix)) continue;
    const BonePart part = part_of(std::string_view(all).substr(0, all.size() - suffix.size()));
    const NameSide side = suffix.starts_with('l') ? NameSide::left : NameSide::right;
    if (part != BonePart::none) return {part, side};
  }
  return {};
}

// Whether a limb is named: "Arm top" is an upper arm; "head top" is the end of the head.
bool has_limb(const std::vector<std::string>& words) {
  return contains(words, "arm") || contains(words, "leg");
}

// Words of control and decoration bones, which override the rest of their names.
constexpr std::string_view kNoTwist[] = {"ik", "fk", "mch", "pole", "target", "ctrl", "control"};

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  const std::size_t prefix = name.find_last_of(":|");
  if (prefix != name.npos) name.remove_prefix(prefix + 1);
  std::vector<std::string> words;
  bool open = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c)) {
      open = false;
      continue;
    }
    const bool after_lower = i > 0 && is_lower(name[i - 1]);
    const bool before_lower = i + 1 < name.size() && is_lower(name[i + 1]);
    if (!open || (is_upper(c) && (after_lower || before_lower))) words.emplace_back();
    words.back() += lower(c);
    open = true;
  }
  return words;
}

bool is_next_in_row(std::string_view name, std::string_view next) {
  const auto digits = [](std::string_view text) {
    std::size_t count = 0;
    while (count < text.size() && is_digit(text[text.size() - 1 - count])) ++count;
    return count;
  };
  const auto number = [&](std::string_view text) {
    constexpr std::size_t kLongest = 6;
    int value = 0;
    for (const char c : text.substr(text.size() - std::min(digits(text), kLongest))) {
      value = 10 * value + (c - '0');
    }
    return value;
  };
  const auto stem = [&](std::string_view text) {
    text.remove_suffix(digits(text));
    // Blender's first one has no number: "spine", "spine.001"
    while (!text.empty() && (text.back() == '.' || text.back() == '_' || text.back() == ' ')) {
      text.remove_suffix(1);
    }
    return text;
  };
  return digits(next) > 0 && stem(name) == stem(next) && number(next) == number(name) + 1;
}

bool is_twist_name(std::string_view name) {
  bool twist = false;
  for (const std::string& word : words_of(name)) {
    if (contains(kNoTwist, word)) return false;
    twist = twist || word.ends_with("twist") || word.ends_with("roll") || word == "ulna" ||
            word.find("捩") != word.npos;
  }
  return twist;
}

BoneName read_bone_name(std::string_view name) {
  std::vector<std::string> words = words_of(name);
  for (const std::string& word : words) {
    if (contains(kThumbs, word)) return {BonePart::thumb};
    if (contains(kOrnaments, word)) return {BonePart::ornament};
  }
  for (const std::string& word : words) {
    if (contains(kTips, word) && !(word == "top" && has_limb(words))) return {BonePart::tip};
  }
  // a robot's roll is an axis, not a twist bone
  const bool robot = contains(words, "link");
  for (const std::string& word : words) {
    if (contains(kOthers, word) && !(robot && word == "roll")) return {};
  }
  BoneName result;
  std::vector<std::string> rest;
  for (std::string& word : words) {
    const bool left = contains(kLeftWords, word);
    if (left || contains(kRightWords, word)) {
      // the first one: L_HIP_R is a left hip's roll
      if (result.side != NameSide::none) continue;
      result.side = left ? NameSide::left : NameSide::right;
    } else if (word != "link") {
      rest.push_back(std::move(word));
    }
  }
  if (result.side == NameSide::none) {
    const BoneName glued = read_glued(rest);
    if (glued.part != BonePart::none) return glued;
  }
  result.part = longest_part(rest);
  return result;
}

}  // namespace shigusa
