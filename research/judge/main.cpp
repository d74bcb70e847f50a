// SPDX-License-Identifier: MIT
// shigusa_judge writes a page that shows recorded reaches beside generated ones of the same task,
// to be told apart by eye.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <shigusa/generate.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "../people/record.hpp"
#include "character/character_rig.hpp"
#include "core/index.hpp"
#include "files/file.hpp"

namespace {

using namespace shigusa;
using namespace shigusa::bench;
using Json = nlohmann::json;
using Bone = HumanoidBone;

constexpr const char* kUsage = "usage: shigusa_judge REACH_FOLDER SOURCE_FOLDER PAGE\n";
constexpr const char* kClip = "cmu_02_06_60hz.bvh";
constexpr int kCandidates = 8;  // as in docs/people.md
constexpr std::size_t kSourceMaxBytes = 1 << 20;
// Limit of the distance between the two figures of a reach in their first frame (m).
constexpr double kStartApart = 0.001;

// A point of a drawn figure; it moves with a node of the man's skeleton.
struct Point {
  std::string_view name;
  Bone bone;
  bool grip = false;  // of the hand's grip and not of the bone's joint
  Vec3d beyond{};     // m, (left, up, ahead) of the joint where the first reach starts, standing
};
// Wrists are left out: the record's only turn about the forearm, so a bent one would tell.
constexpr std::array kPoints{
    Point{"spine", Bone::spine},
    Point{"chest", Bone::chest},
    Point{"neck", Bone::neck},
    Point{"head", Bone::head, false, {0.0, 0.05, 0.02}},
    Point{"nose", Bone::head, false, {0.0, 0.03, 0.13}},
    Point{"left_shoulder", Bone::left_upper_arm},
    Point{"left_elbow", Bone::left_lower_arm},
    Point{"left_grip", Bone::left_hand, true},
    Point{"left_hip", Bone::left_upper_leg},
    Point{"left_knee", Bone::left_lower_leg},
    Point{"left_ankle", Bone::left_foot},
    Point{"left_heel", Bone::left_foot, false, {0.0, -0.03, -0.05}},
    Point{"left_ball", Bone::left_toes},
    Point{"left_toes", Bone::left_toes, false, {0.0, 0.0, 0.06}},
    Point{"right_shoulder", Bone::right_upper_arm},
    Point{"right_elbow", Bone::right_lower_arm},
    Point{"right_grip", Bone::right_hand, true},
    Point{"right_hip", Bone::right_upper_leg},
    Point{"right_knee", Bone::right_lower_leg},
    Point{"right_ankle", Bone::right_foot},
    Point{"right_heel", Bone::right_foot, false, {0.0, -0.03, -0.05}},
    Point{"right_ball", Bone::right_toes},
    Point{"right_toes", Bone::right_toes, false, {0.0, 0.0, 0.06}},
};

// (kPoints) one frame: m, world of the reach; or in the axes and units of the points' nodes.
using Places = std::array<Vec3d, kPoints.size()>;
using Figure = std::vector<Places>;  // (frames)

const Rig& rig_of(const Recorded& reach) { return reach.person.rig->rig; }

const Transformd& node_of(const Point& point, const Rig& rig,
                          const std::vector<Transformd>& nodes) {
  const int grip = rig.grips[point.bone == Bone::left_hand ? 0 : 1];
  return nodes[index(point.grip ? grip : rig.bones[point.bone])];
}

// The points in their nodes, from the first frame of a reach that starts upright.
Places points_in_nodes(const Recorded& standing) {
  const Rig& rig = rig_of(standing);
  const Placement& file = rig.placement;
  const auto nodes =
      world_transforms(standing.motion.skeleton, standing.motion.clip, standing.segment.first);
  Places within;
  std::transform(kPoints.begin(), kPoints.end(), within.begin(), [&](const Point& point) {
    const Vec3d beyond =
        point.beyond.x * file.left + point.beyond.y * file.up + point.beyond.z * file.ahead;
    return transpose_times(node_of(point, rig, nodes).rotation, (1.0 / file.unit) * beyond);
  });
  return within;
}

Places places_of(const Places& within, const Rig& rig, const std::vector<Transformd>& nodes) {
  Places places;
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    places[i] = node_of(kPoints[i], rig, nodes) * within[i];
  }
  return places;
}

Figure recorded_figure(const Recorded& reach, const Places& within) {
  const Rig& rig = rig_of(reach);
  Figure figure;
  for (int f = reach.segment.first; f <= reach.segment.last; ++f) {
    Places places =
        places_of(within, rig, world_transforms(reach.motion.skeleton, reach.motion.clip, f));
    for (Vec3d& place : places) place = rig.placement.to_world(place);
    figure.push_back(places);
  }
  return figure;
}

// The best-scored motion of the reach's task on the man's skeleton, at the record's frames.
Result<Figure> generated_figure(const Recorded& reach, const Places& within) {
  Task task = reach.task();
  task.candidates = kCandidates;
  SHG_TRY_ASSIGN(const GenerateResult generation, generate(task));
  const double frame_time = reach.motion.clip.frame_time;
  const Clip clip = resampled(generation.candidates.front().motion.clip, 1.0 / frame_time);
  const SkeletonClip moved{frame_time, clip.frames, node_motion(reach.person, reach.posed, clip)};
  const Rig& rig = rig_of(reach);
  Figure figure;
  // a duration that is rounded up has a frame more than the record
  const int frames = std::min(clip.frames, reach.segment.last - reach.segment.first + 1);
  for (int f = 0; f < frames; ++f) {
    Places places = places_of(within, rig, world_transforms(reach.motion.skeleton, moved, f));
    for (Vec3d& place : places) place = rig.placement.unit * place;
    figure.push_back(places);
  }
  return figure;
}

Result<void> check_alike(const Recorded& reach, const Figure& recorded, const Figure& generated) {
  if (generated.size() != recorded.size()) {
    return fail(ErrorCode::parse, "the generated motion has other frames", reach.segment.name);
  }
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    if (norm(generated.front()[i] - recorded.front()[i]) < kStartApart) continue;
    return fail(ErrorCode::parse, "the two figures start apart at " + std::string(kPoints[i].name),
                reach.segment.name);
  }
  return {};
}

Json in_millimetres(const Vec3d& place) {
  return {std::lround(1e3 * place.x), std::lround(1e3 * place.y), std::lround(1e3 * place.z)};
}

// (frames × points) whole millimetres.
Json in_millimetres(const Figure& figure) {
  Json frames = Json::array();
  for (const Places& places : figure) {
    Json frame = Json::array();
    for (const Vec3d& place : places) frame.push_back(in_millimetres(place));
    frames.push_back(std::move(frame));
  }
  return frames;
}

// All reaches as both figures' points; read by judge_page.js.
Result<Json> motions(const std::filesystem::path& folder) {
  Json points = Json::array();
  for (const Point& point : kPoints) points.push_back(point.name);
  Json reaches = Json::array();
  SHG_TRY_ASSIGN(const auto segments, all_segments(folder / "manifest.tsv"));
  SHG_TRY_ASSIGN(const Recorded standing, read_reach(folder / kClip, segments.front()));
  const Places within = points_in_nodes(standing);
  for (const Segment& segment : segments) {
    SHG_TRY_ASSIGN(const Recorded reach, read_reach(folder / kClip, segment));
    const Figure recorded = recorded_figure(reach, within);
    SHG_TRY_ASSIGN(const Figure generated, generated_figure(reach, within));
    SHG_TRY(check_alike(reach, recorded, generated));
    reaches.push_back({{"name", segment.name},
                       {"frame_time", reach.motion.clip.frame_time},
                       {"goal", in_millimetres(reach.track.joints.back()[right_grip])},
                       {"recorded", in_millimetres(recorded)},
                       {"generated", in_millimetres(generated)}});
  }
  return Json{{"points", std::move(points)}, {"reaches", std::move(reaches)}};
}

// Replaces a line of the page by an element with the text.
Result<void> insert(std::string& page, std::string_view line, std::string_view opening,
                    std::string_view text) {
  const std::size_t at = page.find(line);
  if (at == std::string::npos) {
    return fail(ErrorCode::parse, "has no line " + std::string(line), "judge_page.html");
  }
  page.replace(at, line.size(), std::string(opening) + std::string(text) + "</script>");
  return {};
}

Result<void> write_page(const std::filesystem::path& folder, const std::filesystem::path& source,
                        const std::filesystem::path& file) {
  SHG_TRY_ASSIGN(std::string page, read_text_file(source / "judge_page.html", kSourceMaxBytes));
  SHG_TRY_ASSIGN(const std::string script,
                 read_text_file(source / "judge_page.js", kSourceMaxBytes));
  SHG_TRY_ASSIGN(const Json shown, motions(folder));
  SHG_TRY(insert(page, "<!-- motions -->", R"(<script type="application/json" id="motions">)",
                 shown.dump()));
  SHG_TRY(insert(page, "<!-- script -->", "<script>\n", script));
  return write_file(file, page);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  if (words.size() != 3) {
    std::cerr << kUsage;
    return 2;
  }
  const Result<void> done = write_page(words[0], words[1], words[2]);
  if (!done) std::cerr << "shigusa_judge: " << done.error().to_string() << "\n";
  return done ? 0 : 2;
}
