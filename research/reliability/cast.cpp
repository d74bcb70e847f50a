// SPDX-License-Identifier: MIT
#include "cast.hpp"

#include <algorithm>

#include "files/file.hpp"
#include "support/fbx_file.hpp"
#include "support/gltf_file.hpp"
#include "support/mjcf_file.hpp"
#include "support/robot_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa::bench {
namespace {

using namespace testing_support;

// Skeleton of person_bvh as an FBX file, in centimetres.
std::string person_fbx() {
  const SkeletonMotion person = parse_bvh(person_bvh(), "person.bvh").value();
  const std::vector<Transformd> places = world_transforms(person.skeleton, person.clip, 0);
  StickFigure figure;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SkeletonNode& node = person.skeleton.nodes[i];
    figure.points.push_back({node.name, node.parent, places[i].translation * 0.01});
  }
  return FbxFile(figure).bytes();
}

std::string person_vrm() {
  nlohmann::json file = person_gltf();
  nlohmann::json bones;
  for (std::size_t i = 0; i < file["nodes"].size(); ++i) {
    const std::string name = file["nodes"][i].value("name", "");
    if (name.empty() || name.ends_with("grip")) continue;
    bones[camel_case(name)] = {{"node", i}};
  }
  file["extensionsUsed"] = {"VRMC_vrm"};
  file["extensions"]["VRMC_vrm"] = {{"specVersion", "1.0"}, {"humanoid", {{"humanBones", bones}}}};
  return glb(file.dump());
}

struct OwnFile {
  const char* name;
  std::string bytes;
};
std::vector<OwnFile> own_files() {
  return {{"our.bvh", person_bvh()},
          {"our.glb", glb(person_gltf().dump())},
          {"our.vrm", person_vrm()},
          {"our.fbx", person_fbx()},
          {"our.urdf", RobotFile().text()},
          {"our_without_hands.urdf", RobotFile(false).text()},
          {"our_research.xml", research_mjcf()},
          {"our_research_without_hands.xml", research_mjcf(false)},
          {"our_research_without_ankles.xml", research_mjcf(true, false)},
          {"our_maker.xml", makers_mjcf()}};
}

// Whether the person supports the request, tested by the request alone.
bool heels_lift(CharacterSpec character) {
  character.heels = true;
  return !is_robot(character) && build_character(character).has_value();
}

// MuJoCo reads files: built-in models are written to one for it.
std::shared_ptr<const MujocoFile> by_mujoco(const CastMember& member,
                                            const std::filesystem::path& path) {
  std::error_code none;
  if (std::filesystem::exists(path, none)) return MujocoFile::read(path);
  const testing_support::WorkFolder folder;
  return MujocoFile::read(folder.put(path.filename().string(), *member.bytes));
}

void add(std::string bytes, const std::filesystem::path& path, Cast& cast) {
  CastMember member;
  member.character.source = path.filename().string();
  const bool urdf = path.extension() == ".urdf";
  member.bytes = std::make_shared<std::string>(std::move(bytes));
  member.folder = path.parent_path();
  const auto refuse = [&](const Error& error) {
    cast.absent.push_back(member.character.source + ": " + error.to_string());
  };
  const Result<void> loaded = load_character(*member.bytes, member.character, member.folder);
  if (!loaded) return refuse(loaded.error());
  const Result<PosedBody> body = build_character(member.character);
  if (!body) return refuse(body.error());
  member.stature = body->body.stature();
  member.toes = heels_lift(member.character);
  if (is_robot(member.character)) {
    member.robot.emplace(urdf ? *member.bytes : member.character.urdf.value());
    if (!urdf) member.mujoco = by_mujoco(member, path);
    cast.robots.push_back(std::move(member));
  } else {
    cast.people.push_back(std::move(member));
  }
}

}  // namespace

CharacterSpec seated_member(const CastMember& member, double seat) {
  CharacterSpec character;
  character.source = member.character.source;
  character.seat = seat;
  return load_character(*member.bytes, character, member.folder) ? character : member.character;
}

Cast load_cast(const std::filesystem::path& folder) {
  Cast cast;
  for (OwnFile& file : own_files()) add(std::move(file.bytes), file.name, cast);
  std::error_code none;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (format_of_file(entry.path().string())) paths.push_back(entry.path());
  }
  if (paths.empty()) {
    cast.absent.push_back("no characters in '" + folder.string() + "': our own files alone");
  }
  std::sort(paths.begin(), paths.end());
  for (const std::filesystem::path& path : paths) {
    const Result<std::string> bytes = read_text_file(path, kCharacterMaxBytes);
    if (bytes) add(*bytes, path, cast);
  }
  return cast;
}

}  // namespace shigusa::bench
