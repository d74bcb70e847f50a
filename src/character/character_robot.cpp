// SPDX-License-Identifier: MIT
#include "character_robot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "character_file.hpp"
#include "core/say.hpp"
#include "files/path.hpp"
#include "formats/mjcf.hpp"
#include "formats/urdf.hpp"
#include "humanoid_request.hpp"
#include "robot/robot_size.hpp"
#include "robot/settled_posture.hpp"

namespace shigusa {
namespace {

struct ReadRobot {
  Robot robot;
  HumanoidMap map;
};

std::string file_name(const CharacterSpec& spec) {
  return to_path(spec.source).filename().string();
}

Result<ReadRobot> read_robot(Robot robot, const CharacterSpec& spec) {
  const std::string name = file_name(spec);
  robot = with_hands(std::move(robot));
  robot.name = name;
  std::vector<std::string> links;
  for (const Robot::Link& link : robot.links) links.push_back(link.name);
  SHG_TRY_ASSIGN(const HumanoidMap asked, requested_bones(spec.map, links, name));
  Result<HumanoidMap> map = find_humanoid(robot, asked);
  const bool named = asked[HumanoidBone::left_hand] >= 0 || asked[HumanoidBone::right_hand] >= 0;
  std::vector<int> lacking = map ? forearms_for_hands(robot, *map) : open_ends(robot);
  if (map && named) lacking.clear();
  if (!lacking.empty()) {
    Robot ended = with_ends(robot, lacking);
    if (Result<HumanoidMap> longer = find_humanoid(ended, asked)) {
      robot = std::move(ended);
      map = std::move(longer);
    }
  }
  if (!map) {
    return fail(map.error().code, say("no_humanoid", map.error().to_message()), name);
  }
  SHG_TRY(check_likeness(limbs_of(robot, *map), spec.map, name));
  return ReadRobot{with_ankles(std::move(robot), *map), std::move(*map)};
}

// A robot read from a file, and the URDF that results keep of it.
struct RobotFile {
  Robot robot;
  std::string urdf;
};

// The key frame that a spec requests, by name or index; null if it requests none.
Result<const Robot::Keyframe*> keyframe_of(const Robot& robot, const CharacterSpec& spec) {
  if (!spec.animation) return nullptr;
  std::vector<std::string> names;
  for (const Robot::Keyframe& frame : robot.keyframes) {
    if (frame.name == *spec.animation) return &frame;
    names.push_back(shown(frame.name));
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (fmt::format("{}", k) == *spec.animation) return &robot.keyframes[k];
  }
  const std::string name = file_name(spec);
  if (names.empty()) {
    return fail(ErrorCode::invalid_argument, say("no_keyframes", shown(*spec.animation)), name);
  }
  constexpr std::size_t kMost = 10;
  names.resize(std::min(names.size(), kMost));
  return fail(ErrorCode::invalid_argument,
              say("no_keyframe", shown(*spec.animation), fmt::format("{}", fmt::join(names, ", "))),
              name);
}

// Sets a robot's joints to the requested key frame.
Result<void> take_keyframe(Robot& robot, const CharacterSpec& spec) {
  SHG_TRY_ASSIGN(const Robot::Keyframe* frame, keyframe_of(robot, spec));
  if (frame == nullptr) return {};
  for (const auto& [name, angle] : frame->angles) {
    for (Robot::Joint& joint : robot.joints) {
      if (joint.name == name) joint.rest = angle;
    }
  }
  return {};
}

// Reads a URDF file. Errors refer to the lines of the original, not of the reduced URDF.
Result<RobotFile> read_urdf_file(std::string_view bytes, const std::string& name) {
  SHG_TRY_ASSIGN(const XmlElement reduced, reduced_urdf(bytes, name));
  SHG_TRY_ASSIGN(Robot robot, robot_of_urdf(reduced, name));
  return RobotFile{std::move(robot), write_xml(reduced)};
}

Result<RobotFile> read_mjcf_file(std::string_view bytes, CharacterSpec& spec,
                                 const std::optional<std::filesystem::path>& folder) {
  SHG_TRY_ASSIGN(Robot robot,
                 parse_mjcf(bytes, spec.source, folder ? included_from(*folder) : MjcfInclude{}));
  spec.doubts = std::move(robot.doubts);
  // results keep only the requested key frame
  SHG_TRY_ASSIGN(const Robot::Keyframe* asked, keyframe_of(robot, spec));
  std::vector<Robot::Keyframe> kept_frame;
  if (asked != nullptr) {
    spec.animation = asked->name;
    kept_frame.push_back(*asked);
  }
  robot.keyframes = std::move(kept_frame);
  std::string urdf = write_urdf(robot);
  SHG_TRY_ASSIGN(Robot kept, parse_urdf(urdf, file_name(spec)));
  return RobotFile{std::move(kept), std::move(urdf)};
}

// Reports absent files of a model before the errors that follow from them.
auto told_absent(const CharacterSpec& spec) {
  return [&spec](Error error) { return after_absent(spec.doubts, std::move(error)); };
}

}  // namespace

Result<void> check_robot_options(const CharacterSpec& spec) {
  const auto refuse = [&](Message message) {
    return fail(ErrorCode::invalid_argument, std::move(message), "character");
  };
  if (spec.stature) return refuse(say("option_of_person", "stature", spec.source));
  if (spec.extent) return refuse(say("robot_extent", spec.source));
  if (spec.seat) return refuse(say("robot_seat", spec.source));
  if (spec.heels) return refuse(say("robot_heels", spec.source));
  if (spec.frame) return refuse(say("robot_frame", spec.source));
  if (spec.sex != Sex::male) return refuse(say("robot_sex", spec.source));
  return {};
}

// Checks that masses come from one source: the robot's links, or the spec.
static Result<void> check_masses(const Robot& robot, const CharacterSpec& spec) {
  const auto weighs = [](const Robot::Link& link) { return link.mass > 0.0; };
  const bool own = std::any_of(robot.links.begin(), robot.links.end(), weighs);
  if (spec.mass && own) {
    return fail(ErrorCode::invalid_argument, say("option_of_person", "mass", spec.source),
                "character");
  }
  if (spec.mass && !(*spec.mass >= kMassMin && *spec.mass <= kMassMax)) {
    return fail(ErrorCode::invalid_argument,
                say("out_of_range", "mass", *spec.mass, "kg", kMassMin, kMassMax, "kg"),
                "character");
  }
  return {};
}

Result<void> load_robot(std::string_view bytes, CharacterSpec& spec,
                        const std::optional<std::filesystem::path>& folder) {
  const bool mjcf = format_of_file(spec.source) == FileFormat::mjcf;
  SHG_TRY_ASSIGN(RobotFile file, mjcf ? read_mjcf_file(bytes, spec, folder)
                                      : read_urdf_file(bytes, file_name(spec)));
  SHG_TRY(check_masses(file.robot, spec));
  SHG_TRY(take_keyframe(file.robot, spec));
  SHG_TRY_ASSIGN(const ReadRobot read,
                 read_robot(std::move(file.robot), spec).map_error(told_absent(spec)));
  list_bones(
      read.map, [&](std::size_t link) { return read.robot.links[link].name; }, spec);
  spec.urdf = std::move(file.urdf);
  return {};
}

Result<PosedBody> build_robot_character(const CharacterSpec& spec) {
  SHG_TRY_ASSIGN(Robot robot, parse_urdf(*spec.urdf, file_name(spec)));
  SHG_TRY(check_masses(robot, spec));
  SHG_TRY(take_keyframe(robot, spec));
  SHG_TRY_ASSIGN(const ReadRobot read,
                 read_robot(std::move(robot), spec).map_error(told_absent(spec)));
  SHG_TRY_ASSIGN(PosedBody standing, build_robot(read.robot, read.map, spec.mass)
                                         .map_error(within(spec.source))
                                         .map_error(told_absent(spec)));
  standing.doubts.insert(standing.doubts.end(), spec.doubts.begin(), spec.doubts.end());
  if (std::optional<Message> size = doubt_of_size(standing.body.stature())) {
    standing.doubts.push_back(std::move(*size));
  }
  if (spec.animation) {
    SHG_TRY(
        settle_at_keyframe(standing, read.robot, *spec.animation).map_error(within(spec.source)));
  } else {
    settle(standing);
  }
  return standing;
}

}  // namespace shigusa
