// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <shigusa/body.hpp>
#include <shigusa/math.hpp>

namespace shigusa {

// Mass and mass distribution of one body segment. Source: P. de Leva, Adjustments to
// Zatsiorsky-Seluyanov's segment inertia parameters, J. Biomechanics 29 (1996) 1223-1230, table 4.
struct SegmentParameters {
  double mass;          // fraction of the body's mass
  double com;           // fraction of the segment's length, from its first-named end
  double r_sagittal;    // radius of gyration about the fore-aft axis, fraction of length
  double r_transverse;  // the same about the left-right axis
  double r_long;        // the same about the segment's own axis
};

// One of three parts of the trunk, cut transversely. Same source.
struct TrunkPart {
  double mass;          // fraction of the body's mass
  double length;        // fraction of mid-hips – C7
  double r_sagittal;    // radius of gyration about the fore-aft axis, fraction of the part's length
  double r_transverse;  // the same about the left-right axis
  double r_long;
};

struct SegmentTable {
  SegmentParameters head;       // vertex – C7
  SegmentParameters trunk;      // mid-shoulders – mid-hips
  SegmentParameters upper_arm;  // shoulder – elbow
  SegmentParameters forearm;    // elbow – wrist
  SegmentParameters hand;       // wrist – third fingertip
  SegmentParameters thigh;      // hip – knee
  SegmentParameters shank;      // knee – ankle
  SegmentParameters foot;       // heel – toe tip
  // the trunk's three parts from below: mid-hips – navel – xiphoid – C7
  std::array<TrunkPart, 3> trunk_parts;
  double mean_stature;  // m, of the measured group
  double mean_mass;     // kg
};

[[nodiscard]] const SegmentTable& segment_table(Sex sex);

// Lengths as fractions of stature. Source: Drillis and Contini 1966, as in D. Winter, Biomechanics
// and Motor Control of Human Movement; the hips' joint centres: half of the 0.17 m between the hip
// joint centres of a mean person.
struct StatureFractions {
  static constexpr double kAnkleHeight = 0.039;
  static constexpr double kShank = 0.246;
  static constexpr double kThigh = 0.245;
  static constexpr double kShoulderHeight = 0.818;
  static constexpr double kUpperArm = 0.186;
  static constexpr double kForearm = 0.146;
  static constexpr double kHand = 0.108;
  static constexpr double kFootLength = 0.152;
  static constexpr double kFootBreadth = 0.055;
  static constexpr double kShoulderHalfBreadth = 0.129;
  static constexpr double kHipHalfBreadth = 0.050;
  static constexpr double kHeadLength = 0.1395;  // vertex – C7: 0.2429 m of 1.741 m, de Leva
  // sternoclavicular joint: distance from the middle, and height above the shoulder joints
  static constexpr double kClavicleHalfBreadth = 0.014;
  static constexpr double kClavicleRise = 0.010;
};

// Positions of three spine joints in place of its 17, as shares of the line from mid-hip to C7.
// L5/S1 is some 0.10 m above the hips of a man of 1.74 m (criteria/low_back.hpp), T12/L1 0.18 m
// higher, and the third in the middle of the chest.
inline constexpr std::size_t kSpineJoints = 3;
inline constexpr std::array<double, kSpineJoints> kSpineShares{0.17, 0.47, 0.72};
// The joint of neck and skull, as a share of the line from C7 to the vertex.
inline constexpr double kHeadJointShare = 0.35;

// Radii of capsules around the bones, as fractions of stature: rough, from a trunk about 0.23 m
// deep and a thigh, a forearm 0.16 m and 0.08 m thick in a man of 1.74 m.
inline constexpr double kTrunkRadius = 0.066;
inline constexpr double kThighRadius = 0.043;
inline constexpr double kForearmRadius = 0.020;
inline constexpr double kHandRadius = 0.012;
inline constexpr double kUpperArmRadius = 0.026;
// The head and its neck, and the shank at the calf, as fractions of stature: men of the 1988
// Anthropometric Survey of U.S. Army Personnel (C. Gordon et al., Natick TR-89/044), whose mean
// stature is 1.756 m, to the nearest 5 mm. Head breadth 0.150 m and length 0.195 m, bigonial
// breadth 0.120 m, circumferences of neck and calf 0.380 m. The chin is at 0.870 of the stature
// (Drillis and Contini).
inline constexpr double kHeadBreadth = 0.150 / 1.756;
inline constexpr double kHeadDepth = 0.195 / 1.756;
inline constexpr double kJawRadius = 0.5 * 0.120 / 1.756;
inline constexpr double kNeckRadius = 0.380 / kTwoPi / 1.756;
inline constexpr double kCalfRadius = 0.380 / kTwoPi / 1.756;
inline constexpr double kChinBelowVertex = 1.0 - 0.870;
// Capsules by stature have a constant thickness; a shank is as thick as the calf only in its upper
// half.
inline constexpr double kShankRadius = 0.93 * kCalfRadius;

// Compression (m) of the flesh of trunk and thighs by a hand or forearm without strain, an
// estimate.
inline constexpr double kFleshGives = 0.008;

// Share of the foot's length behind the ankle joint.
inline constexpr double kHeelShare = 0.25;
// Grip position: the third knuckle, 86.2 mm of the hand's 189.9 mm from the wrist to the fingertip
// (de Leva 1996, hand WJC–MET3 and WJC–DAC3).
inline constexpr double kGripFraction = 0.454;

// Joint limits in radians and strengths in N·m; positive angles are flexion (dorsiflexion),
// abduction and lateral rotation. Sources: limits after the AAOS and CDC tables, with the lumped
// hip of a rigid trunk; strengths of an adult man of 73 kg.
struct JointLimits {
  double lower;
  double upper;
  double torque_positive;
  double torque_negative;
};
// Dorsiflexion with a bent knee under the body's weight: up to +40° in a recorded man's reaches to
// the floor. The 30° of the tables, with a straight knee, would prevent a squat on flat feet.
inline constexpr JointLimits kAnkleFlexion{radians(-50), radians(40), 45, 150};
inline constexpr JointLimits kKneeFlexion{0, radians(145), 100, 230};
inline constexpr JointLimits kHipFlexion{radians(-20), radians(115), 120, 220};
inline constexpr JointLimits kHipAbduction{radians(-25), radians(45), 110, 110};
inline constexpr JointLimits kHipRotation{radians(-45), radians(45), 50, 50};
inline constexpr JointLimits kShoulderFlexion{radians(-60), radians(170), 80, 80};
inline constexpr JointLimits kShoulderAbduction{radians(-40), radians(170), 65, 70};
inline constexpr JointLimits kShoulderRotation{radians(-70), radians(90), 32, 50};
inline constexpr JointLimits kElbowFlexion{0, radians(150), 70, 55};
// Hip flexion with a bent knee: 115° + 50° · min(1, knee / 60°).
inline constexpr double kHipFlexionGain = radians(50);
inline constexpr double kHipFlexionKneeFull = radians(60);

// Hip flexion of the body `human`, whose spine moves separately: hamstrings stop a straight leg at
// about 85°, a bent one goes to 125° (AAOS 120°, CDC 130°).
inline constexpr JointLimits kFreeHipFlexion{radians(-20), radians(85), 120, 220};
inline constexpr double kFreeHipFlexionGain = radians(40);
// Strengths of a weight-bearing leg: 2.7 % and 1.6 % of weight times stature (R. Ottaviani, J.
// Ashton-Miller and E. Wojtys, American J. Sports Medicine 29 (2001) 219-225).
inline constexpr JointLimits kAnkleInversion{radians(-15), radians(35), 34, 20};
// Toes of a heel that lifts: 58° in a rise onto both forefeet, 42° in gait (D. Nawoczenski, J.
// Baumhauer and B. Umberger, J. Bone and Joint Surgery 81-A (1999) 370-376). Their flexors'
// strength by J.-P. Goldmann and G.-P. Brüggemann, J. Anatomy 221 (2012) 187-194, a third for the
// extensors.
inline constexpr JointLimits kToesFlexion{0, radians(58), 4.7, 14.2};
// Share of the toes in the foot's mass: 0.217 of 1.467 kg in the lower limb model of S. Delp et
// al., IEEE Trans. Biomedical Engineering 37 (1990) 757-767, from OpenSim.
inline constexpr double kToesMass = 0.15;
// Weight of the toes relative to other degrees of freedom: feet stay flat if anything else brings
// the hand to its goal.
inline constexpr double kToesGive = 1e-3;
// Whole spine between pelvis and neck: AAOS' thoracolumbar range of motion, and strengths about
// L5/S1. Positive: forwards, to the left, turned to the left.
inline constexpr JointLimits kSpineFlexion{radians(-25), radians(80), 150, 240};
inline constexpr JointLimits kSpineLateral{radians(-35), radians(35), 140, 140};
inline constexpr JointLimits kSpineRotation{radians(-45), radians(45), 75, 75};
// Shares of each of three joints in that range: the lumbar spine bends, the thoracic one turns (A.
// White and M. Panjabi, Clinical Biomechanics of the Spine).
struct SpineShares {
  double flexion;
  double lateral;
  double rotation;
};
inline constexpr std::array<SpineShares, kSpineJoints> kSpineRanges{
    {{0.40, 0.35, 0.10}, {0.35, 0.35, 0.30}, {0.25, 0.30, 0.60}}};
// Shares of one of the spine's joints; if they are fewer than three, they share all.
[[nodiscard]] constexpr SpineShares spine_shares(std::size_t joint, std::size_t joints) {
  SpineShares shares{};
  for (std::size_t k = joint; k < kSpineJoints; k += joints) {
    shares.flexion += kSpineRanges[k].flexion;
    shares.lateral += kSpineRanges[k].lateral;
    shares.rotation += kSpineRanges[k].rotation;
  }
  return shares;
}
// Half of the neck's range of motion (AAOS), of each of its two joints; strengths by A. Vasavada et
// al., Spine 26 (2001) 1904-1909. A positive angle bends the head forwards, to the left, or turns
// it to the left.
inline constexpr JointLimits kNeckFlexion{radians(-22.5), radians(22.5), 30, 52};
inline constexpr JointLimits kNeckLateral{radians(-22.5), radians(22.5), 36, 36};
inline constexpr JointLimits kNeckRotation{radians(-35), radians(35), 15, 15};
// Clavicle: it elevates and protracts the shoulder; its range is subtracted from the shoulder's
// own.
inline constexpr JointLimits kClavicleElevation{radians(-8), radians(35), 60, 60};
inline constexpr JointLimits kClavicleProtraction{radians(-20), radians(25), 60, 60};
inline constexpr JointLimits kFreeShoulderFlexion{radians(-60), radians(160), 80, 80};
inline constexpr JointLimits kFreeShoulderAbduction{radians(-40), radians(145), 65, 70};
// Lateral rotation of an arm: 60° at the side, 90° when abducted (AAOS), as swing and twist are
// coupled.
inline constexpr JointLimits kFreeShoulderRotation{radians(-70), radians(60), 32, 50};
inline constexpr double kFreeShoulderRotationGain = radians(30);
inline constexpr double kFreeShoulderRotationFull = radians(90);  // of abduction
// Supination of the forearm from thumb-ahead (AAOS 80° either way), palmar flexion and radial
// deviation of the hand (AAOS 80°/70°, 20°/30°); strengths by S. Delp, A. Grierson and T. Buchanan,
// J. Biomechanics 29 (1996) 1371-1375, and of the forearm some 9 N·m.
inline constexpr JointLimits kForearmRotation{radians(-80), radians(80), 9, 8};
inline constexpr JointLimits kWristFlexion{radians(-70), radians(80), 12.2, 7.1};
inline constexpr JointLimits kWristDeviation{radians(-30), radians(20), 11, 9.5};
// Share by which strength grows with a mass above the usual one of a stature, and falls below it:
// a quarter of what people gain or lose is lean (G. Forbes, Nutrition Reviews 45 (1987) 225).
inline constexpr double kStrengthOfMass = 0.25;
// Women's joint strength as a share of men's, each at the mean mass of their group.
inline constexpr double kFemaleStrength = 0.6;

}  // namespace shigusa
