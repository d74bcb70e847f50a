// SPDX-License-Identifier: MIT
#pragma once

#include <shigusa/character.hpp>
#include <tuple>

#include "core/field.hpp"

namespace shigusa {

// Whether the character can be a person: it is not a robot that was read.
[[nodiscard]] inline bool may_be_a_person(const CharacterSpec& spec) { return !spec.urdf; }
// Whether the character can be a person from a file: neither built in nor a robot that was read.
[[nodiscard]] inline bool may_be_a_persons_file(const CharacterSpec& spec) {
  return !spec.urdf && !is_built_in(spec);
}

// The fields of a character.
template <>
inline constexpr FieldTable kFields<CharacterSpec>{
    "character_spec", "A built-in body, or a person or a robot from a file.",
    std::tuple{
        Field{
            "source",
            &CharacterSpec::source,
            "human, full_body, half_body or a BVH, GLB, glTF, VRM, FBX, URDF or MJCF (.xml) file; "
            "of a person with landmarks or a robot with urdf, only a name.",
            {.required = true, .written = always}},
        Field{"stature_m",
              &CharacterSpec::stature,
              "Standing height. Of a person from a file: scales the file.",
              {.low = kStatureMin, .high = kStatureMax}},
        Field{"mass_kg",
              &CharacterSpec::mass,
              "That of an average person of the stature when not given. Of a robot whose file has "
              "no masses: spread over its links as a person's.",
              {.low = kMassMin, .high = kMassMax}},
        Field{"map", &CharacterSpec::map,
              "The nodes of the file that some humanoid bones are: {\"right_hand\": \"Bone_17\"}. "
              "Goes before what the file and its names tell."},
        Field{"urdf", &CharacterSpec::urdf,
              "A robot as read: the text of its URDF file without meshes; one of an MJCF file as "
              "URDF. With it the file is not needed."},
        Field{"sex",
              &CharacterSpec::sex,
              "For mass distribution and strength.",
              {.written = always, .of = may_be_a_person}},
        Field{"seat_m",
              &CharacterSpec::seat,
              "Height of the seat that the person sits on; they stand when it is not given.",
              {.low = kSeatMin, .high = kSeatMax, .of = may_be_a_person}},
        Field{"heels",
              &CharacterSpec::heels,
              "Heels may lift, where people's do; of the body human, standing.",
              {.of = may_be_a_person}},
        Field{"extent",
              &CharacterSpec::extent,
              "Of a person from a file: all freedoms that the file has joints for (human), 18 "
              "(full) or 9 (half). human when not given, by the presets paper and layers full.",
              {.of = may_be_a_persons_file}},
        Field{
            "frame",
            &CharacterSpec::frame,
            "Of a person from a file: the frame that is the start posture, from 0, of glTF of an "
            "animation; or rest, the file's rest pose, from which the person stands at ease. When "
            "not given, of BVH and of an animation the first in which the person stands still on "
            "both feet, else the rest pose; of glTF without an animation the rest pose; of BVH "
            "that begins with a T- or an A-pose that one, at ease.",
            {.high = kFrameMax, .word = {kRestPose, "rest"}, .of = may_be_a_persons_file}},
        Field{"animation",
              &CharacterSpec::animation,
              "Of a glTF file: the name or the index of the animation that the frame is of, at 60 "
              "frames a second; the first when not given. Of an MJCF file: the name or the index "
              "of the keyframe that the robot starts from.",
              {.of = [](const CharacterSpec& spec) { return !is_built_in(spec); }}},
        Field{"doubts",
              &CharacterSpec::doubts,
              "Of a person with landmarks: guesses of the measuring; of a robot from an MJCF file: "
              "what was left out.",
              {.of = [](const CharacterSpec& spec) { return !is_built_in(spec); }}},
        Field{"places_m",
              &CharacterSpec::places,
              "Of a person with landmarks: nodes of the file that are not where the body has those "
              "of their names, in the start posture. Goals are for the file's.",
              {.of = may_be_a_persons_file}},
        Field{"landmarks_m",
              &CharacterSpec::landmarks,
              "The person as measured, in the start posture; stature_m stands beside it.",
              {.of = may_be_a_persons_file}},
    }};

}  // namespace shigusa
