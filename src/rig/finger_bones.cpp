// SPDX-License-Identifier: MIT
#include "finger_bones.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/index.hpp"
#include "core/text.hpp"
#include "humanoid_names.hpp"
#include "math/turn_about.hpp"
#include "skeleton_tree.hpp"

namespace shigusa {
namespace {

struct FingerWords {
  Finger finger;
  std::array<std::string_view, 7> words;  // the rest are empty
};
constexpr FingerWords kFingerWords[] = {
    {Finger::thumb, {"thumb", "親指", "拇指"}},
    {Finger::index, {"index", "pointer", "forefinger", "人指", "人差指", "食指"}},
    {Finger::middle, {"middle", "mid", "中指"}},
    {Finger::ring, {"ring", "薬指", "无名指"}},
    {Finger::little, {"little", "pinky", "pinkie", "small", "小指"}},
};
// Words of control or end nodes of a finger.
constexpr std::string_view kNoFinger[] = {"ik",      "fk",    "mch",   "pole", "target", "ctrl",
                                          "control", "tweak", "twist", "end",  "nub",    "tip"};
constexpr std::string_view kMetacarpal[] = {"metacarpal", "carpal", "palm", "inhand"};

// Sines: least for knuckles and wrist to span a palm's plane, and largest for a bone to have a
// direction in that plane.
constexpr double kFlat = 0.1;
constexpr double kStandsOut = 0.7;
// Share of its length from the wrist within which the first of four joints is a metacarpal's, if
// its bone is the longest.
constexpr double kAtWrist = 0.6;
// Distance of the thumb's target before the knuckles, in lengths of the palm.
constexpr double kOpposed = 0.5;

// Flexion in degrees by joint, of the mean finger and of the thumb.
constexpr std::array<double, kFingerJoints> kRelaxed{45.0, 30.0, 20.0};
constexpr std::array<double, kFingerJoints> kRelaxedThumb{20.0, 15.0, 15.0};
// Factors of the fingers, which increase towards the little one; their mean is 1.
constexpr std::array<double, kFingerCount> kShare{1.0, 0.8, 0.93, 1.07, 1.2};

// Finger of a node's name, or its number ("Finger2", "finger3-1.L").
struct FingerName {
  std::optional<Finger> finger;
  int number = -1;
  bool metacarpal = false;
};

bool is_word_of(const FingerWords& finger, std::string_view word) {
  const auto is = [&](std::string_view text) {
    return std::any_of(finger.words.begin(), finger.words.end(), [&](std::string_view w) {
      // full-width digits may follow a word directly: "人指１"
      const bool wide = !w.empty() && (w.front() & 0x80) != 0;
      return wide ? text.starts_with(w) : !w.empty() && text == w;
    });
  };
  if (is(word)) return true;
  // "lthumb", "rpinky", "左親指"
  for (const std::string_view side : {"l", "r", "左", "右"}) {
    if (word.starts_with(side) && is(word.substr(side.size()))) return true;
  }
  return false;
}

int finger_number(std::string_view name) {
  constexpr std::string_view kWord = "finger";
  std::string text(name);
  for (char& c : text) c = lower(c);
  std::size_t at = text.find(kWord);
  if (at == text.npos) return -1;
  for (at += kWord.size(); at < text.size(); ++at) {
    if (text[at] >= '0' && text[at] <= '9') return text[at] - '0';
    if (text[at] != '_' && text[at] != '-' && text[at] != '.' && text[at] != ' ') break;
  }
  return -1;
}

FingerName read_finger_name(std::string_view name) {
  FingerName result;
  const std::vector<std::string> words = words_of(name);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (contains(kNoFinger, word)) return {};
    result.metacarpal = result.metacarpal || contains(kMetacarpal, word) ||
                        (word == "in" && i + 1 < words.size() && words[i + 1] == "hand");
    for (const FingerWords& finger : kFingerWords) {
      if (!result.finger && is_word_of(finger, word)) result.finger = finger.finger;
    }
  }
  if (!result.finger) result.number = finger_number(name);
  return result;
}

constexpr std::array<std::string_view, kFingerCount> kVrmFingers{"Thumb", "Index", "Middle", "Ring",
                                                                 "Little"};

// Finger of a VRM name such as "leftIndexProximal".
std::optional<Finger> finger_of_vrm(std::string_view name) {
  for (std::size_t f = 0; f < kVrmFingers.size(); ++f) {
    if (name.find(kVrmFingers[f]) != name.npos) return static_cast<Finger>(f);
  }
  return std::nullopt;
}

// One hand's fingers.
class HandReader {
 public:
  HandReader(const SkeletonTree& tree, Side side, int hand, bool mirrored)
      : tree_(tree), side_(side), hand_(hand), mirrored_(mirrored), name_(index(tree.size())) {}

  void read_names(const std::vector<std::pair<std::string, int>>& named) {
    for (int i = 0; i < tree_.size(); ++i) {
      const bool below = i != hand_ && tree_.below(i, hand_);
      if (below && !tree_.node(i).end_site) name_[index(i)] = read_finger_name(tree_.node(i).name);
    }
    for (const auto& [name, node] : named) {
      if (node == hand_ || !tree_.below(node, hand_)) continue;
      if (const auto finger = finger_of_vrm(name)) name_[index(node)] = {finger, -1, false};
    }
    number_fingers();
  }

  std::vector<FingerBone> find() {
    for (int f = 0; f < kFingerCount; ++f) rows_[index(f)] = joints_of(static_cast<Finger>(f));
    if (!find_palm()) return {};
    std::vector<FingerBone> bones;
    for (int f = 0; f < kFingerCount; ++f) {
      if (!rows_[index(f)].empty()) add(static_cast<Finger>(f), bones);
    }
    return bones;
  }

 private:
  // Numbers fingers without names, from the thumb at 0 or 1.
  void number_fingers() {
    int first = 10;
    for (int i = 0; i < tree_.size(); ++i) {
      const int number = name_[index(i)].number;
      if (number < 0) continue;
      const int parent = tree_.node(i).parent;
      const int above = name_[index(parent)].number;
      if (above >= 0 && above != number) return;  // a row of one finger's bones
      first = std::min(first, number);
    }
    for (FingerName& name : name_) {
      const int finger = name.number - std::min(first, 1);
      if (name.number >= 0 && finger < kFingerCount) name.finger = static_cast<Finger>(finger);
    }
  }

  [[nodiscard]] const Vec3d& at(int i) const { return tree_.at(i); }

  // Nodes of a finger in a chain, from the palm on.
  [[nodiscard]] std::vector<int> row_from(int first) const {
    std::vector<int> row{first};
    const auto goes_on = [&](int i) {
      return name_[index(i)].finger == name_[index(first)].finger && tree_.apart(i, row.back());
    };
    while (true) {
      const std::vector<int>& children = tree_.children(row.back());
      const auto next = std::find_if(children.begin(), children.end(), goes_on);
      if (next == children.end()) return row;
      row.push_back(*next);
    }
  }

  // Nodes of a finger's joints, at most kFingerJoints.
  [[nodiscard]] std::vector<int> joints_of(Finger finger) const {
    std::vector<int> row;
    for (int i = 0; i < tree_.size(); ++i) {
      if (name_[index(i)].finger != finger) continue;
      std::vector<int> other = row_from(i);
      if (other.size() > row.size()) row = std::move(other);
    }
    if (finger != Finger::thumb && !row.empty() && begins_at_metacarpal(row))
      row.erase(row.begin());
    // further nodes are tips
    if (row.size() > index(kFingerJoints)) row.resize(index(kFingerJoints));
    return row;
  }

  [[nodiscard]] bool begins_at_metacarpal(const std::vector<int>& row) const {
    if (name_[index(row[0])].metacarpal) return true;
    if (row.size() <= index(kFingerJoints)) return false;
    const double first = norm(at(row[1]) - at(row[0]));
    for (std::size_t k = 2; k < row.size(); ++k) {
      if (norm(at(row[k]) - at(row[k - 1])) > first) return false;
    }
    return norm(at(row[0]) - at(hand_)) < kAtWrist * first;
  }

  bool find_palm() {
    Vec3d sum{};
    std::vector<int> knuckles;
    for (int f = 1; f < kFingerCount; ++f) {
      if (rows_[index(f)].empty()) continue;
      knuckles.push_back(rows_[index(f)][0]);
      sum += at(knuckles.back());
    }
    if (knuckles.size() < 2) return false;
    const auto count = static_cast<double>(knuckles.size());
    const Vec3d along = sum * (1.0 / count) - at(hand_);
    const Vec3d to_thumb = at(knuckles.front()) - at(knuckles.back());
    const Vec3d square = cross(to_thumb, along);
    length_ = norm(along);
    if (!(norm(square) > kFlat * norm(to_thumb) * length_)) return false;
    along_ = along * (1.0 / length_);
    const bool right = (side_ == Side::right) != mirrored_;
    normal_ = normalized(right ? square : -square);
    opposed_ = (at(knuckles[0]) + at(knuckles[1])) * 0.5 + normal_ * (kOpposed * length_);
    return true;
  }

  // Direction of a bone to the next joint or the tip; empty if the file has none.
  [[nodiscard]] std::optional<Vec3d> direction(const std::vector<int>& row, std::size_t k) const {
    if (k + 1 < row.size()) return at(row[k + 1]) - at(row[k]);
    for (const int child : tree_.children(row[k])) {
      if (tree_.apart(child, row[k])) return at(child) - at(row[k]);
    }
    return std::nullopt;
  }

  // Adds a finger's bones with its axis and the flexion of each relative to the palm.
  void add(Finger finger, std::vector<FingerBone>& bones) const {
    const std::vector<int>& row = rows_[index(static_cast<int>(finger))];
    const bool thumb = finger == Finger::thumb;
    const auto first = direction(row, 0);
    const auto last = direction(row, row.size() - 1);
    const Vec3d end = at(row.back()) + last.value_or(Vec3d{});
    Vec3d straight = along_;
    Vec3d palmar = normal_;
    if (thumb) {
      straight = normalized(end - at(row[0]), along_);
      palmar = opposed_ - at(row[0]);
    } else if (first) {
      const Vec3d flat = *first - normal_ * dot(*first, normal_);
      if (norm(flat) > kStandsOut * norm(*first)) straight = normalized(flat);
    }
    const Vec3d axis = normalized(cross(straight, palmar));
    if (!(norm(axis) > 0.5)) return;
    const Vec3d up = cross(axis, straight);
    double before = 0.0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const auto bone = direction(row, k);
      const double angle = bone ? atan2(dot(*bone, up), dot(*bone, straight)) : before;
      // the flexion of a thumb at the wrist is not determined by its bones
      const bool free = thumb && k == 0;
      const int joint = static_cast<int>(k) + 1 + (thumb ? missing(row) : 0);
      bones.push_back({row[k], side_, finger, joint, axis, free ? 0.0 : wrapped(angle - before)});
      before = angle;
    }
  }

  // Number of missing joints: a thumb of two bones has none at the wrist.
  [[nodiscard]] static int missing(const std::vector<int>& row) {
    return kFingerJoints - static_cast<int>(row.size());
  }

  [[nodiscard]] static double wrapped(double angle) {
    if (angle > kPi) return angle - 2.0 * kPi;
    return angle < -kPi ? angle + 2.0 * kPi : angle;
  }

  const SkeletonTree& tree_;
  Side side_;
  int hand_;
  bool mirrored_;
  std::vector<FingerName> name_;  // (nodes)
  std::array<std::vector<int>, kFingerCount> rows_;
  double length_ = 0.0;  // from the wrist to the knuckles' middle
  Vec3d along_{};        // unit, that way
  Vec3d normal_{};       // unit, out of the palm
  Vec3d opposed_{};      // target direction of the thumb
};

}  // namespace

std::string vrm_finger_name(const FingerBone& bone) {
  constexpr std::array<std::string_view, kFingerJoints> kJoints{"Proximal", "Intermediate",
                                                                "Distal"};
  constexpr std::array<std::string_view, kFingerJoints> kThumbJoints{"Metacarpal", "Proximal",
                                                                     "Distal"};
  std::string name = bone.side == Side::left ? "left" : "right";
  name += kVrmFingers[static_cast<std::size_t>(bone.finger)];
  name += (bone.finger == Finger::thumb ? kThumbJoints : kJoints)[index(bone.joint - 1)];
  return name;
}

std::vector<FingerBone> find_finger_bones(const Skeleton& skeleton,
                                          const std::vector<Transformd>& world,
                                          const HumanoidMap& map,
                                          const std::vector<std::pair<std::string, int>>& named,
                                          bool mirrored) {
  const SkeletonTree tree(skeleton, world);
  std::vector<FingerBone> bones;
  for (const Side side : {Side::left, Side::right}) {
    const int hand = map[side == Side::left ? HumanoidBone::left_hand : HumanoidBone::right_hand];
    if (hand < 0) continue;
    HandReader reader(tree, side, hand, mirrored);
    reader.read_names(named);
    const std::vector<FingerBone> found = reader.find();
    bones.insert(bones.end(), found.begin(), found.end());
  }
  std::stable_sort(bones.begin(), bones.end(),
                   [](const FingerBone& a, const FingerBone& b) { return a.node < b.node; });
  return bones;
}

double flexion(HandPosture posture, Finger finger, int joint) {
  const auto& mean = finger == Finger::thumb ? kRelaxedThumb : kRelaxed;
  const double relaxed = mean[index(joint - 1)] * kShare[static_cast<std::size_t>(finger)];
  return radians(posture == HandPosture::open ? kOpenShare * relaxed : relaxed);
}

double mean_flexion(HandPosture posture) {
  double sum = 0.0;
  for (int finger = 0; finger < kFingerCount; ++finger) {
    for (int joint = 1; joint <= kFingerJoints; ++joint) {
      sum += flexion(posture, static_cast<Finger>(finger), joint);
    }
  }
  return sum / (kFingerCount * kFingerJoints);
}

std::vector<SkinVertex> relaxed_hands(const Skeleton& skeleton,
                                      const std::vector<Transformd>& world, const HumanoidMap& map,
                                      const std::vector<FingerBone>& fingers,
                                      std::span<const SkinVertex> skin) {
  // transform of each node for its descendants, and whether it belongs to a hand
  std::vector<Transformd> moves(world.size());
  std::vector<bool> of_hand(world.size(), false);
  auto next = fingers.begin();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const int parent = skeleton.nodes[i].parent;
    if (parent >= 0) {
      moves[i] = moves[index(parent)];
      of_hand[i] = of_hand[index(parent)];
    }
    for (const HumanoidBone hand : {HumanoidBone::left_hand, HumanoidBone::right_hand}) {
      of_hand[i] = of_hand[i] || map[hand] == static_cast<int>(i);
    }
    for (; next != fingers.end() && index(next->node) == i; ++next) {
      const double angle = flexion(HandPosture::relaxed, next->finger, next->joint) - next->bent;
      const Mat3d turn = turn_about(next->axis, angle);
      const Vec3d& joint = world[i].translation;
      moves[i] = moves[i] * Transformd{turn, joint - turn * joint};
    }
  }
  std::vector<SkinVertex> hands;
  for (const SkinVertex& vertex : skin) {
    if (vertex.node < 0 || !of_hand[index(vertex.node)]) continue;
    hands.push_back(vertex);
    hands.back().position = moves[index(vertex.node)] * vertex.position;
  }
  return hands;
}

}  // namespace shigusa
