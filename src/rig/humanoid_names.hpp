// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shigusa {

// Part named by a joint's name. Some words mean different bones in different conventions; the chain
// around the joint decides.
enum class BonePart {
  none,
  hips,
  hip,        // upper leg with a side ("LeftHip"), hips without one
  upper_leg,  // thigh, femur, UpLeg
  leg,        // lower leg below an upper leg ("LeftUpLeg", "LeftLeg"), else upper leg
  lower_leg,  // shin, knee, tibia
  ankle,
  foot,  // toes below an ankle ("AnkleLeft", "FootLeft"), else foot
  toes,
  heel,  // "Heel.L", "FootBack.L": behind the ankle, and no foot
  collar,
  shoulder,  // collar above an upper arm ("LeftShoulder", "LeftArm"), else upper arm
  upper_arm,
  arm,  // upper arm, if no name states it more clearly
  lower_arm,
  hand,
  palm,  // the hand, if no name states it more clearly
  spine,
  neck,
  head,
  thumb,
  ornament,  // face, hair, clothes, tail, wings, carried things: neither limb nor spine
  tip,       // "HeadTop_End", "Toe.nub": the end of the parent bone
};

enum class NameSide { none, left, right };

struct BoneName {
  BonePart part = BonePart::none;
  NameSide side = NameSide::none;
};

// Parses names such as "LeftUpLeg", "mixamorig:LeftArm", "upper_arm.L", "DEF-thigh.L",
// "upperarm_l", "lfemur", "J_Bip_L_UpperLeg", "Bip01 L Calf", "leftUpperLeg" and "左ひじ". Fingers,
// twist bones, control joints and similar have no part.
[[nodiscard]] BoneName read_bone_name(std::string_view name);

// Words of a name in lower case, split at separators, digits and capitals ("LHipJoint" is l, hip,
// joint). A prefix before a colon or bar names the character and is dropped.
[[nodiscard]] std::vector<std::string> words_of(std::string_view name);

// Whether `next` follows `name` in a numbered row: "spine.004" after "spine.003".
[[nodiscard]] bool is_next_in_row(std::string_view name, std::string_view next);

// Whether a name is that of a twist bone, which takes a share of a limb's twist:
// "lowerarm_twist_01_l", "LeftForeArmRoll", "左手捩", Source's "Bip01_L_Ulna".
[[nodiscard]] bool is_twist_name(std::string_view name);

}  // namespace shigusa
