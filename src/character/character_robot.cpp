// SPDX-License-Identifier: MIT
#include "character_robot.hpp"

#include <fmt/format.h>

#include "character_file.hpp"
#include "core/say.hpp"
#include "humanoid_request.hpp"
#include "robot/mjcf.hpp"
#include "robot/settled_posture.hpp"
#include "robot/urdf.hpp"

namespace shigusa {
namespace {

struct ReadRobot {
  Robot robot;
  HumanoidMap map;
};

std::string file_name(const CharacterSpec& spec) {
  return std::filesystem::path(spec.source).filename().string();
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

// A robot's file, as it was read and as the URDF in which results keep it.
struct RobotFile {
  Robot robot;
  std::string urdf;
};

// Errors name the lines of the file, and not of what is kept of it.
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
  std::string urdf = write_urdf(robot);
  SHG_TRY_ASSIGN(Robot kept, parse_urdf(urdf, file_name(spec)));
  return RobotFile{std::move(kept), std::move(urdf)};
}

}  // namespace

Result<void> check_robot_options(const CharacterSpec& spec) {
  const struct {
    const char* what;
    bool given;
  } persons[] = {{"stature", spec.stature.has_value()},
                 {"mass", spec.mass.has_value()},
                 {"extent", spec.extent.has_value()},
                 {"seat", spec.seat.has_value()},
                 {"heels", spec.heels},
                 {"frame", spec.frame.has_value()}};
  for (const auto& option : persons) {
    if (!option.given) continue;
    return fail(ErrorCode::invalid_argument, say("option_of_person", option.what, spec.source),
                "character");
  }
  return {};
}

Result<void> load_robot(std::string_view bytes, CharacterSpec& spec,
                        const std::optional<std::filesystem::path>& folder) {
  const bool mjcf = format_of_file(spec.source) == FileFormat::mjcf;
  SHG_TRY_ASSIGN(RobotFile file, mjcf ? read_mjcf_file(bytes, spec, folder)
                                      : read_urdf_file(bytes, file_name(spec)));
  SHG_TRY_ASSIGN(const ReadRobot read, read_robot(std::move(file.robot), spec));
  list_bones(
      read.map, [&](std::size_t link) { return read.robot.links[link].name; }, spec);
  spec.urdf = std::move(file.urdf);
  return {};
}

Result<BodyModel> build_robot_character(const CharacterSpec& spec) {
  SHG_TRY_ASSIGN(Robot robot, parse_urdf(*spec.urdf, file_name(spec)));
  SHG_TRY_ASSIGN(const ReadRobot read, read_robot(std::move(robot), spec));
  SHG_TRY_ASSIGN(const BodyModel body,
                 build_robot(read.robot, read.map).map_error(within(spec.source)));
  BodyDefinition standing = body.definition();
  standing.doubts.insert(standing.doubts.end(), spec.doubts.begin(), spec.doubts.end());
  standing.start = settled_posture(body, standing.doubts);
  return BodyModel(std::move(standing));
}

}  // namespace shigusa
