// SPDX-License-Identifier: MIT
// Pieces of work of built-in bodies as GLB, by the files' own numbers.
#include <gmock/gmock.h>

#include <algorithm>
#include <shigusa/files.hpp>

#include "formats/gltf_animation.hpp"
#include "support/exported_glb.hpp"
#include "support/work.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using Json = nlohmann::ordered_json;

constexpr double kMillimetre = 1e-3;
constexpr double kTenthDegree = radians(0.1);
constexpr const char* kAnimation = "shigusa";

int node_of(const ExportedGlb& glb, const std::string& name) {
  const Json& nodes = glb.json().at("nodes");
  const auto found = std::find_if(nodes.begin(), nodes.end(),
                                  [&](const Json& node) { return node.value("name", "") == name; });
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

double turn_between(const Mat3d& a, const Mat3d& b) {
  return norm(rotation_vector(a * transpose(b)));
}

// Places and turns of things in a file against those of the candidate.
void expect_there(const ExportedGlb& glb, const std::string& animation, const Candidate& candidate,
                  const std::vector<std::string>& names, double rate) {
  const int frames = glb.frames(animation);
  const Clip& clip = candidate.motion.clip;
  for (std::size_t t = 0; t < names.size(); ++t) {
    const int node = node_of(glb, names[t]);
    ASSERT_GE(node, 0) << names[t];
    EXPECT_EQ(glb.parent(node), -1);
    for (int f = 0; f < frames; ++f) {
      const Transformd place = glb.place(node, animation, f);
      // between two frames of the candidate
      const std::vector<Transformd>& poses = candidate.things[t].poses;
      const double at = min(f / rate, clip.duration()) / clip.frame_time;
      const auto before = static_cast<std::size_t>(at + 1e-6);
      const double share = at - static_cast<double>(before);
      const Transformd& own = poses.at(before);
      const Transformd& next = poses.at(std::min(before + 1, poses.size() - 1));
      const Vec3d expected = own.translation * (1.0 - share) + next.translation * share;
      EXPECT_LE(norm(place.translation - expected), kMillimetre) << names[t] << " " << f;
      EXPECT_LE(turn_between(place.rotation, own.rotation),
                turn_between(next.rotation, own.rotation) + kTenthDegree);
    }
    const Transformd last = glb.place(node, animation, frames - 1);
    EXPECT_LE(norm(last.translation - candidate.things[t].poses.back().translation), kMillimetre);
    EXPECT_LE(turn_between(last.rotation, candidate.things[t].poses.back().rotation), kTenthDegree);
  }
}

TEST(ThingExport, ThingsAreWhereTheCandidateHasThemAtAnyRate) {
  for (const double rate : {60.0, 24.0}) {
    const Candidate& first = box_work().generation.candidates.front();
    const std::string bytes = export_candidate(box_work().file.character, box_work().task, first,
                                               FileFormat::glb, {.rate = rate})
                                  .value();
    EXPECT_TRUE(parse_gltf_animation(bytes, "work.glb"));
    expect_there(ExportedGlb(bytes), kAnimation, first, {"box", "hips_2"}, rate);
  }
}

TEST(ThingExport, ActionsAreMarkersOfTheirAnimation) {
  const Candidate& first = box_work().generation.candidates.front();
  const ExportedGlb glb(
      export_candidate(box_work().file.character, box_work().task, first, FileFormat::glb).value());
  const Json& list = glb.json().at("animations").at(0).at("extras").at("shigusa_actions");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list.at(0).at("name"), "grasp");
  EXPECT_EQ(list.at(1).at("name"), "place");
  EXPECT_EQ(list.at(0).at("start_s"), 0.0);
  EXPECT_EQ(list.at(0).at("end_s"), list.at(1).at("start_s"));
  EXPECT_NEAR(list.at(1).at("end_s").get<double>(), first.motion.clip.duration(), 1e-9);
}

TEST(ThingExport, ThingsOfAllCandidatesAreInAFileOnce) {
  const auto& candidates = box_work().generation.candidates;
  ASSERT_EQ(candidates.size(), 2u);
  const ExportedGlb glb(export_all(box_work().file.character, box_work().task, candidates).value());
  EXPECT_EQ(glb.json().at("meshes").size(), 3u);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    expect_there(glb, candidate_animation({}, k + 1), candidates[k], {"box", "hips_2"}, 60.0);
  }
  const Json& roots = glb.json().at("scenes").at(0).at("nodes");
  for (const char* name : {"box", "hips_2"}) {
    EXPECT_EQ(std::count(roots.begin(), roots.end(), Json(node_of(glb, name))), 1) << name;
  }
}

}  // namespace
}  // namespace shigusa
