// SPDX-License-Identifier: MIT
#include "humanoid_names.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace shigusa {
namespace {

struct Word {
  std::string_view word;
  BonePart part;
};

// What conventions call the bones, in lower case and without separators.
constexpr Word kWords[] = {
    {"hips", BonePart::hips},
    {"pelvis", BonePart::hips},
    {"hip", BonePart::hip},
    {"hipjoint", BonePart::hip},
    {"upleg", BonePart::upper_leg},
    {"upperleg", BonePart::upper_leg},
    {"thigh", BonePart::upper_leg},
    {"femur", BonePart::upper_leg},
    {"leg", BonePart::leg},
    {"lowerleg", BonePart::lower_leg},
    {"lowleg", BonePart::lower_leg},
    {"loleg", BonePart::lower_leg},
    {"uleg", BonePart::upper_leg},
    {"legupper", BonePart::upper_leg},
    {"leglower", BonePart::lower_leg},
    {"legup", BonePart::upper_leg},
    {"leglow", BonePart::lower_leg},
    {"legtop", BonePart::upper_leg},
    {"legbottom", BonePart::lower_leg},
    {"lleg", BonePart::lower_leg},
    {"shin", BonePart::lower_leg},
    {"shank", BonePart::lower_leg},
    {"calf", BonePart::lower_leg},
    {"tibia", BonePart::lower_leg},
    {"knee", BonePart::lower_leg},
    {"ankle", BonePart::ankle},
    {"talus", BonePart::ankle},
    {"talocrural", BonePart::ankle},
    {"foot", BonePart::foot},
    {"feet", BonePart::foot},
    {"toe", BonePart::toes},
    {"toes", BonePart::toes},
    {"toebase", BonePart::toes},
    {"ball", BonePart::toes},
    {"collar", BonePart::collar},
    {"clavicle", BonePart::collar},
    {"clav", BonePart::collar},
    {"collarbone", BonePart::collar},
    {"scapula", BonePart::collar},
    {"sternoclavicular", BonePart::collar},
    {"acromioclavicular", BonePart::collar},
    {"shoulder", BonePart::shoulder},
    {"upperarm", BonePart::upper_arm},
    {"uparm", BonePart::upper_arm},
    {"uarm", BonePart::upper_arm},
    {"armupper", BonePart::upper_arm},
    {"armlower", BonePart::lower_arm},
    {"armup", BonePart::upper_arm},
    {"armlow", BonePart::lower_arm},
    {"armtop", BonePart::upper_arm},
    {"armbottom", BonePart::lower_arm},
    {"bicep", BonePart::upper_arm},
    {"biceps", BonePart::upper_arm},
    {"forarm", BonePart::lower_arm},
    {"humerus", BonePart::upper_arm},
    {"shldr", BonePart::upper_arm},
    {"arm", BonePart::arm},
    {"forearm", BonePart::lower_arm},
    {"lowerarm", BonePart::lower_arm},
    {"lowarm", BonePart::lower_arm},
    {"loarm", BonePart::lower_arm},
    {"larm", BonePart::lower_arm},
    {"farm", BonePart::lower_arm},
    {"elbow", BonePart::lower_arm},
    {"radius", BonePart::lower_arm},
    {"ulna", BonePart::lower_arm},
    {"wrist", BonePart::hand},
    {"radiocarpal", BonePart::hand},
    {"hand", BonePart::hand},
    {"palm", BonePart::palm},
    {"fist", BonePart::palm},
    {"spine", BonePart::spine},
    {"torso", BonePart::spine},
    {"chest", BonePart::spine},
    {"neck", BonePart::neck},
    {"lowerneck", BonePart::neck},
    {"upperneck", BonePart::neck},
    {"head", BonePart::head},
    {"skullbase", BonePart::head},
    {"足", BonePart::upper_leg},
    {"ひざ", BonePart::lower_leg},
    {"足首", BonePart::foot},
    {"つま先", BonePart::toes},
    {"肩", BonePart::collar},
    {"腕", BonePart::upper_arm},
    {"ひじ", BonePart::lower_arm},
    {"手首", BonePart::hand},
    {"首", BonePart::neck},
    {"頭", BonePart::head},
    {"大腿", BonePart::upper_leg},
    {"小腿", BonePart::lower_leg},
    {"脚", BonePart::foot},
    {"脚踝", BonePart::foot},
    {"脚趾", BonePart::toes},
    {"锁骨", BonePart::collar},
    {"肩膀", BonePart::shoulder},
    {"上臂", BonePart::upper_arm},
    {"前臂", BonePart::lower_arm},
    {"手", BonePart::hand},
    {"手腕", BonePart::hand},
    {"颈", BonePart::neck},
    {"脖子", BonePart::neck},
    {"头", BonePart::head},
};

// Words of joints that belong to a bone, or control it, but are not it.
constexpr std::string_view kOthers[] = {
    "twist",      "roll",   "ik",      "fk",     "mch",   "pole",  "target", "ctrl",
    "control",    "goal",   "tweak",   "helper", "site",  "heel",  "slot",   "effector",
    "helmet",     "muscle", "index",   "middle", "ring",  "pinky", "little", "hint",
    "metacarpal", "carpal", "fingers", "mesh",   "geo",   "prop",  "finger", "corrective",
    "share",      "bck",    "fwd",     "inner",  "outer", "sec",   "adj",
};
// Words of what hangs on a body and is no part of the spine or a limb.
constexpr std::string_view kOrnaments[] = {
    "face",     "facial",  "jaw",     "chin",   "eye",   "eyes",     "eyeball",  "eyelid",  "lid",
    "brow",     "brows",   "eyebrow", "ear",    "ears",  "nose",     "nostril",  "lip",     "lips",
    "mouth",    "teeth",   "tooth",   "tongue", "cheek", "temple",   "forehead", "hair",    "beard",
    "ponytail", "pigtail", "braid",   "hat",    "hood",  "horn",     "horns",    "antenna", "crown",
    "tail",     "wing",    "wings",   "skirt",  "cape",  "cloak",    "dress",    "ribbon",  "scarf",
    "belt",     "breast",  "breasts", "bust",   "boob",  "pectoral", "sleeve",   "cloth",   "mane",
    "weapon",   "sword",   "shield",  "gun",    "bag",   "backpack",
};
constexpr std::string_view kThumbs[] = {"thumb", "lthumb", "rthumb", "左親指", "右親指"};
constexpr std::string_view kTips[] = {"end", "nub", "tip", "top"};

constexpr std::string_view kLeftWords[] = {"left", "l", "lft", "lt"};
constexpr std::string_view kRightWords[] = {"right", "r", "rgt", "rt"};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
// bytes of UTF-8 beyond ASCII count as letters
bool is_letter(char c) { return is_upper(c) || is_lower(c) || (c & 0x80) != 0; }

template <class Words>
bool contains(const Words& words, std::string_view word) {
  for (const std::string_view w : words) {
    if (w == word) return true;
  }
  return false;
}

BonePart part_of(std::string_view word) {
  for (const Word& w : kWords) {
    if (w.word == word) return w.part;
  }
  return BonePart::none;
}

// The words of a name in lower case: split at separators, digits and capitals ("LHipJoint" is
// l, hip, joint). What stands before a colon or bar names the character.
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
    words.back() += is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
    open = true;
  }
  return words;
}

// The part named by the longest run of neighbouring words.
BonePart longest_part(const std::vector<std::string>& words) {
  BonePart best = BonePart::none;
  std::size_t best_length = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string run;
    for (std::size_t k = i; k < words.size() && run.size() < 16; ++k) {
      run += words[k];
      const BonePart part = part_of(run);
      // of equals the last one: "foot ball" is a ball and "arm hand" is a hand
      if (part == BonePart::none || run.size() < best_length) continue;
      best = part;
      best_length = run.size();
    }
  }
  return best;
}

// A name in one piece: "lfemur", "leftupleg", "handleft", "左足".
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

// "Arm top" is an upper arm; "head top" is the end of the head.
bool has_limb(const std::vector<std::string>& words) {
  return contains(words, "arm") || contains(words, "leg");
}

// Words of bones that control or decorate, whatever else their names say.
constexpr std::string_view kNoTwist[] = {"ik", "fk", "mch", "pole", "target", "ctrl", "control"};

}  // namespace

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
    } else {
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
