// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <shigusa/error.hpp>
#include <shigusa/motion.hpp>
#include <utility>
#include <vector>

#include "core/index.hpp"
#include "core/say.hpp"
#include "human/landmark_points.hpp"
#include "humanoid_names.hpp"
#include "humanoid_shape.hpp"
#include "likeness.hpp"
#include "skeleton_tree.hpp"

namespace shigusa {

// Finder of the humanoid bones of one skeleton: limbs first, then the bones between them.
class BoneFinder {
 public:
  BoneFinder(const SkeletonTree& tree, const HumanoidMap& given, const HumanoidMap& asked);

  // See find_humanoid. Call once.
  Result<HumanoidMap> find();

 private:
  using Bone = HumanoidBone;

  // Limbs: even indices are left, the first two are legs.
  static constexpr const auto& kLimbs = kLimbBones;
  static constexpr std::array<std::string_view, 4> kLimbNames{"left leg", "right leg", "left arm",
                                                              "right arm"};

  template <class... Args>
  void doubt(Sentence<std::type_identity_t<Args>...> sentence, const Args&... args) {
    map_.doubts.push_back(say(sentence, args...));
  }

  [[nodiscard]] const BoneName& name(int i) const { return names_[index(i)]; }
  [[nodiscard]] const Vec3d& at(Bone bone) const { return tree_.at(map_[bone]); }
  [[nodiscard]] Vec3d mid(Bone a, Bone b) const { return (at(a) + at(b)) * 0.5; }
  // Whether a node is an ancestor of any limb.
  [[nodiscard]] bool bears_limb(int i) const;

  void leave_to_deforming_bones();
  [[nodiscard]] bool deforms(int i) const;
  [[nodiscard]] std::vector<int> named(NameSide side, const std::vector<BonePart>& parts) const;
  [[nodiscard]] int first_below(const std::vector<int>& nodes, int ancestor) const;
  [[nodiscard]] int first_apart_below(std::vector<int> nodes, int ancestor) const;
  [[nodiscard]] bool is_beside_limbs(int i) const;
  [[nodiscard]] bool at_parent(int i) const;
  [[nodiscard]] bool strictly_below(int i, int ancestor) const;
  [[nodiscard]] Result<void> check_asked() const;
  [[nodiscard]] Result<void> check_build() const;

  // limbs
  Result<void> find_limbs();
  bool take_given(std::size_t limb);
  bool find_by_name(std::size_t limb);
  [[nodiscard]] std::vector<int> called(std::size_t limb, std::size_t k,
                                        const std::vector<BonePart>& parts) const;
  void give_lengths(std::size_t limb, const std::vector<int>& lowers, const std::vector<int>& ends,
                    LimbNodes& nodes) const;
  void find_in_row(std::size_t limb, const std::vector<int>& ends, LimbNodes& nodes) const;
  void read_arm_as_forearm(const std::vector<int>& uppers, const std::vector<int>& ends,
                           LimbNodes& nodes) const;
  int end_beside(const std::vector<int>& ends, const LimbNodes& nodes, std::size_t limb);
  int end_below(const LimbNodes& nodes, std::size_t limb);
  [[nodiscard]] int nearest_to_mean(const std::vector<int>& nodes) const;
  void pass_collar(LimbNodes& nodes) const;
  bool find_by_shape(const std::array<bool, 4>& found);
  [[nodiscard]] std::optional<BodyShape> shape_beside(const std::array<bool, 4>& found) const;
  [[nodiscard]] BranchPair branches_of(std::size_t left_limb) const;
  [[nodiscard]] bool may_be_limbs(const BranchPair& pair, bool legs,
                                  const std::array<bool, 4>& found) const;
  Vec3d left_of_feet(const BodyShape& shape, const std::array<LimbNodes, 2>& legs);
  [[nodiscard]] std::size_t left_of(const BranchPair& pair, const std::array<LimbNodes, 2>& limbs,
                                    const Vec3d& left) const;
  [[nodiscard]] int side_by_names(int branch) const;
  [[nodiscard]] Message missing(std::size_t limb) const;
  [[nodiscard]] int hub(std::size_t missing_limb) const;

  // bones between and beyond the limbs
  bool find_hips();
  [[nodiscard]] int deforming_trunk() const;
  void find_trunk_branch();
  void find_neck_and_head();
  [[nodiscard]] int head_by_shape() const;
  [[nodiscard]] bool in_row(int i, int next) const;
  [[nodiscard]] int way_up(int i) const;
  [[nodiscard]] int neck_by_shape(int head) const;
  [[nodiscard]] std::vector<int> joints_between(int top, int end) const;
  void find_spine();
  bool take_given_spine(const std::vector<int>& joints);
  void find_shoulder(Bone shoulder, Bone upper_arm);
  void find_collar_beside(Bone shoulder, int arm);
  void find_toes(Side of, Bone toes);

  const SkeletonTree& tree_;
  HumanoidMap given_;            // by the file, overridden by the user
  const HumanoidMap& asked_;     // by the user
  bool any_given_ = false;       // by the file
  std::vector<BoneName> names_;  // (nodes)
  HumanoidMap map_;
  int chest_ = -1;               // junction of the arms, or end of the trunk
  bool deforming_only_ = false;  // only names of bones prefixed DEF- count
  bool flat_ = false;            // the arms have no trunk as ancestor
};

}  // namespace shigusa
