// SPDX-License-Identifier: MIT
// Characters with meshes: soles stand on the floor in written files, and results keep the mesh's
// measurements.
#include <gmock/gmock.h>

#include <functional>
#include <shigusa/character.hpp>
#include <shigusa/files.hpp>

#include "character/character_rig.hpp"
#include "character/landmarks_json.hpp"
#include "document/character_export.hpp"
#include "formats/gltf_animation.hpp"
#include "formats/gltf_skin.hpp"
#include "formats/gltf_write.hpp"
#include "support/mesh_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double kNear = 0.003;  // m
const std::string kMotion = "motion";

// Shoes and shanks about the joints of a standing person: soles at `sole`, m in the person's own
// world, independent of the file's.
std::vector<MeshPoint> body_mesh(const json& gltf, double sole) {
  std::vector<MeshPoint> points;
  const ExportedGlb rest(glb(gltf.dump(), ""));
  const auto at = [&](const std::string& name) {
    return rest.place(index_of(gltf, name)).translation;
  };
  for (const std::string side : {"left_", "right_"}) {
    const Vec3d ankle = at(side + "foot");
    const Vec3d knee = at(side + "lower_leg");
    Vec3d ahead = at(side + "toes") - ankle;
    ahead.y = 0.0;
    ahead = normalized(ahead);
    const Vec3d across{ahead.z, 0.0, -ahead.x};
    for (const double y : {sole, 0.5 * (sole + ankle.y), ankle.y}) {
      for (int i = 0; i <= 4; ++i) {
        for (const double x : {-0.045, 0.045}) {
          Vec3d p = ankle + ahead * (-0.07 + 0.07 * i) + across * x;
          p.y = y;
          points.push_back({p, index_of(gltf, side + "foot")});
        }
      }
    }
    for (int i = 0; i < 200; ++i) {
      const double turn = 2.4 * i;
      const Vec3d out{std::cos(turn), 0.0, std::sin(turn)};
      points.push_back(
          {ankle + (knee - ankle) * (i / 200.0) + out * 0.052, index_of(gltf, side + "lower_leg")});
    }
  }
  return points;
}

// A person's file whose shoes are 35 mm thicker than by stature; `make` makes it unusual, with its
// mesh, which is bound to the nodes.
std::string odd_file(const std::function<void(json&)>& make, double sole = -0.035) {
  json gltf = person_gltf();
  MeshFile file(gltf);
  file.add_skinned(body_mesh(gltf, sole));
  make(file.json);
  return file.bytes();
}

// Moves the person below such a node.
std::function<void(json&)> below(json above) {
  above["name"] = "Armature";
  above["children"] = {0};
  return [above](json& file) { file["nodes"].push_back(above); };
}

struct Odd {
  const char* name;
  std::function<void(json&)> make;
};

void PrintTo(const Odd& odd, std::ostream* out) { *out << odd.name; }

CharacterSpec loaded(const std::string& bytes, const std::string& name = "odd.glb") {
  CharacterSpec spec{.source = name};
  const auto done = load_character(bytes, spec);
  EXPECT_TRUE(done) << done.error().to_string();
  return spec;
}

class MeshCharacters : public testing::TestWithParam<Odd> {};

TEST_P(MeshCharacters, StandOnTheirSolesInWhatLeaves) {
  TaskFile file;
  file.character = loaded(odd_file(GetParam().make));
  const double s = file.character.stature.value();
  file.goals = {{"right_hand", Vec3d{-0.1, 0.4, 0.3} * s}};
  const Task task = make_task(file, {}).value();
  const GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
  const Clip& clip = generation.candidates[0].motion.clip;
  const CharacterExporter exporter(*file.character.rig);
  const GltfAnimation animation = exporter.animation(task, clip, kMotion, {});
  const ExportedGlb out(exporter.glb(std::span(&animation, 1)).value());
  const double unit = file.character.rig->rig.placement.unit;
  for (const char* foot : {"left_foot", "right_foot"}) {
    const int node =
        file.character.rig->file_node[static_cast<std::size_t>(rig_node(file.character, foot))];
    for (const int frame : {0, clip.frames - 1}) {
      EXPECT_NEAR(lowest_vertex(out, {node}, kMotion, frame) * unit, 0.0, kNear)
          << foot << ' ' << frame;
    }
  }
  EXPECT_NEAR(task.body.stature(), 1.741 + 0.035, 0.01);
  EXPECT_THAT(file.character.doubts, Not(Contains(HasSubstr("the mesh was not read"))));
}

TEST(MeshCharacter, AFrameThatItsAnimationLacksIsTold) {
  const std::string bytes = odd_file([](json& file) {
    file["animations"] = {
        {{"name", "still"}, {"samplers", json::array()}, {"channels", json::array()}}};
  });
  CharacterSpec spec{.source = "odd.glb", .frame = 3};
  const auto refused = load_character(bytes, spec);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("frame 3 does not exist"));
}

INSTANTIATE_TEST_SUITE_P(
    Of, MeshCharacters,
    testing::Values(Odd{"Plain", [](json&) {}},
                    Odd{"InCentimetres", below({{"scale", {100.0, 100.0, 100.0}}})},
                    Odd{"BelowScaledNodes",
                        [](json& f) {
                          below({{"scale", {0.01, 0.01, 0.01}}})(f);
                          f["nodes"].push_back({{"name", "Root"},
                                                {"scale", {100.0, 100.0, 100.0}},
                                                {"children", {f["nodes"].size() - 1}}});
                        }},
                    Odd{"FacingAway", below({{"rotation", {0, 1, 0, 0}}})},
                    Odd{"FacingAside",
                        below({{"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}})},
                    Odd{"ZUp", below({{"rotation", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}})},
                    Odd{"Elsewhere", below({{"translation", {3.0, 1.5, -2.0}}})}),
    [](const auto& of) { return std::string(of.param.name); });

// No rotation undoes a mirroring, so the file keeps its own axes, but its soles stand on its own
// floor.
TEST(MeshCharacter, AMirroredOneIsMeasuredAlike) {
  const CharacterSpec plain = loaded(odd_file([](json&) {}));
  const CharacterSpec mirror = loaded(odd_file(below({{"scale", {-1.0, 1.0, 1.0}}})));
  ASSERT_TRUE(plain.landmarks && mirror.landmarks);
  EXPECT_NEAR(*plain.stature, *mirror.stature, 1e-6);
  // the sides of a mirrored skeleton keep their names; seen from within it is the same person
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LE(norm((*plain.landmarks->left_leg.sole)[i] - (*mirror.landmarks->left_leg.sole)[i]),
              1e-5)
        << i;
  }
  EXPECT_NEAR(plain.landmarks->parts[BodyPart::left_shank]->radius,
              mirror.landmarks->parts[BodyPart::left_shank]->radius, 1e-5);
}

// The person's file with two fingers and a thumb on the left hand, three straight bones of 3 cm
// each, and a mesh around them.
std::string with_fingers() {
  json gltf = person_gltf();
  const ExportedGlb rest(glb(gltf.dump(), ""));
  const int hand = index_of(gltf, "left_hand");
  const Transformd at = rest.place(hand);
  const Vec3d along =
      normalized(at.translation - rest.place(index_of(gltf, "left_lower_arm")).translation);
  const Vec3d ahead = normalized(Vec3d{0, 0, 1} - along * along.z);
  const Vec3d across = cross(along, ahead);
  std::vector<MeshPoint> points = body_mesh(gltf, 0.0);
  const auto add_around = [&](const Vec3d& from, const Vec3d& way, double radius, int node) {
    for (int i = 0; i < 60; ++i) {
      const Vec3d out = ahead * std::cos(2.4 * i) + across * std::sin(2.4 * i);
      points.push_back({from + way * (i / 60.0) + out * radius, node});
    }
  };
  add_around(at.translation, along * 0.09, 0.03, hand);
  const std::pair<std::string, Vec3d> roots[] = {{"Thumb", along * 0.02 + ahead * 0.04},
                                                 {"Index", along * 0.09 + ahead * 0.02},
                                                 {"Ring", along * 0.09 - ahead * 0.02}};
  for (const auto& [finger, root] : roots) {
    auto parent = static_cast<std::size_t>(hand);
    for (int k = 0; k < 3; ++k) {
      const Vec3d local = transpose(at.rotation) * (k == 0 ? root : along * 0.03);
      const std::size_t node = gltf["nodes"].size();
      gltf["nodes"].push_back({{"name", "LeftHand" + finger + std::to_string(k + 1)},
                               {"translation", {local.x, local.y, local.z}}});
      gltf["nodes"][parent]["children"].push_back(node);
      const Vec3d from = at.translation + root + along * (0.03 * k);
      add_around(from, along * 0.03, 0.008, static_cast<int>(node));
      parent = node;
    }
  }
  MeshFile file(gltf);
  file.add_skinned(points);
  return file.bytes();
}

TEST(MeshCharacter, HandsAreAsLongAsWithRelaxedFingers) {
  const CharacterSpec spec = loaded(with_fingers());
  ASSERT_FALSE(spec.rig->rig.fingers.empty());
  const PartShape hand = spec.landmarks->parts[BodyPart::left_hand].value();
  const double length = norm(hand.to) + hand.to_radius;
  EXPECT_LT(length, 0.15);  // straight fingers end at 0.18 m
  EXPECT_GT(length, 0.09);
}

TEST(MeshCharacter, AMeshThatIsNotReadIsADoubtAndThePersonAsBefore) {
  const CharacterSpec plain = loaded(glb(person_gltf().dump()));
  const CharacterSpec packed = loaded(odd_file([](json& f) {
    f["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = json::object();
  }));
  EXPECT_THAT(packed.doubts, Contains(HasSubstr("the mesh was not read")));
  EXPECT_EQ(landmarks_to_json(*packed.landmarks), landmarks_to_json(*plain.landmarks));
}

TEST(MeshCharacter, ResultsKeepSolesAndParts) {
  const CharacterSpec spec = loaded(odd_file([](json&) {}));
  TaskFile file;
  file.character = spec;
  file.goals = {{"right_hand", {-0.2, 0.8, 0.4}}};
  const TaskFile again = parse_task(format_task(file), "task.json").value();
  ASSERT_TRUE(again.character.landmarks);
  EXPECT_TRUE(spec.landmarks->left_leg.sole);
  EXPECT_TRUE(spec.landmarks->parts[BodyPart::left_shank]);
  EXPECT_EQ(landmarks_to_json(*again.character.landmarks), landmarks_to_json(*spec.landmarks));
  const BodyModel with_file = build_character(spec).value();
  const BodyModel without = build_character(again.character).value();
  ASSERT_EQ(with_file.capsules().size(), without.capsules().size());
  for (std::size_t c = 0; c < without.capsules().size(); ++c) {
    EXPECT_EQ(with_file.capsules()[c].radius, without.capsules()[c].radius);
    EXPECT_EQ(with_file.capsules()[c].from, without.capsules()[c].from);
  }
}

std::string refused(const std::function<void(json&)>& make) {
  TaskFile file;
  file.character = loaded(odd_file([](json&) {}));
  file.goals = {{"right_hand", {-0.2, 0.8, 0.4}}};
  json task = json::parse(format_task(file));
  make(task["character"]["landmarks_m"]);
  const auto read = parse_task(task.dump(), "task.json");
  return read ? "" : read.error().to_string();
}

TEST(MeshCharacter, SolesAndPartsThatAreNoneAreRefused) {
  EXPECT_EQ(refused([](json&) {}), "");
  EXPECT_THAT(refused([](json& l) { l["left_sole"].erase(3); }),
              HasSubstr("left_sole: must be four corners"));
  EXPECT_THAT(refused([](json& l) { std::swap(l["left_sole"][0], l["left_sole"][1]); }),
              HasSubstr("counter-clockwise from above"));
  EXPECT_THAT(refused([](json& l) { l["parts"]["left_shank"]["radius_m"] = 0; }),
              HasSubstr("radius_m"));
  EXPECT_THAT(refused([](json& l) { l["parts"]["left_shank"].erase("to_m"); }),
              HasSubstr("to_m: is missing"));
  EXPECT_THAT(refused([](json& l) { l["parts"]["tail"] = json::object(); }), HasSubstr("tail"));
}

TEST(MeshCharacter, BodyTellsTheCapsulesOfAllParts) {
  const CharacterSpec spec = loaded(odd_file([](json&) {}));
  const json told = json::parse(format_character(spec, build_character(spec).value()));
  double shank = 0.0;
  for (const json& capsule : told["capsules"]) {
    if (capsule["name"] == "left_shank") shank = capsule["radius_m"];
  }
  EXPECT_NEAR(shank, 0.052, 0.002);
}

// Characters of other authors; see ../shared/characters/manifest.tsv.
struct Real {
  const char* file;
  double stature;  // m, of the mesh without helmets and hair, by hand
};

class RealMeshes : public testing::TestWithParam<Real> {};

TEST_P(RealMeshes, StandOnTheirSoles) {
  const auto path = std::filesystem::path(SHIGUSA_SHARED_DIR) / "characters" / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  TaskFile file;
  file.character.source = path.string();
  file.goals = {{"right_hand", {-0.2, 0.8, 0.4}}};
  ASSERT_TRUE(measure_character(file.character, {}));
  EXPECT_NEAR(*file.character.stature, GetParam().stature, 0.03);
  const Task task = make_task(file, {}).value();
  const GenerateResult generation = regenerate(task, uniform_parameters(task.body)).value();
  const CharacterExporter exporter(*file.character.rig);
  const GltfAnimation animation =
      exporter.animation(task, generation.candidates[0].motion.clip, kMotion, {});
  const std::string bytes = exporter.glb(std::span(&animation, 1)).value();
  // the reader is tested against its own definition elsewhere; here it reads written files
  const auto moved = parse_gltf_animation(bytes, "out.glb", {.animation = kMotion});
  ASSERT_TRUE(moved) << moved.error().to_string();
  const Skin skin = read_gltf_skin(bytes, "out.glb", moved->character, moved->posed);
  double lowest = 1e9;
  for (const SkinVertex& vertex : skin.vertices) {
    for (int node = vertex.node; node >= 0;
         node = moved->character.rest.skeleton.nodes[static_cast<std::size_t>(node)].parent) {
      if (node == rig_node(file.character, "left_foot") ||
          node == rig_node(file.character, "right_foot")) {
        lowest = std::min(lowest, vertex.position.y);
      }
    }
  }
  EXPECT_NEAR(lowest, 0.0, kNear);
}

INSTANTIATE_TEST_SUITE_P(Of, RealMeshes,
                         testing::Values(Real{"KayKit_Knight.glb", 2.315},
                                         Real{"lab0_CesiumMan.glb", 1.507}));

}  // namespace
}  // namespace shigusa
