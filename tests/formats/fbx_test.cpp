// SPDX-License-Identifier: MIT
#include "formats/fbx.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <shigusa/run.hpp>

#include "formats/gltf.hpp"
#include "support/fbx_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;

// The text form has 15 digits after the decimal point, for up to some 100 units.
constexpr double kRounding = 1e-12;

GltfCharacter read(const std::string& bytes) {
  const Result<std::string> glb = glb_of_fbx(bytes, "f.fbx");
  if (!glb) throw std::runtime_error(glb.error().to_string());
  return parse_gltf(*glb, "f.fbx").value();
}

std::string error_of(const std::string& bytes) {
  const Result<std::string> glb = glb_of_fbx(bytes, "f.fbx");
  return glb ? "no error" : glb.error().to_string();
}

// Joints are at the figure's points.
void expect_figure(const GltfCharacter& character, const StickFigure& figure) {
  const Skeleton& skeleton = character.rest.skeleton;
  const std::vector<Vec3d> at = rest_origins(skeleton);
  for (const StickFigure::Point& point : figure.points) {
    if (point.name.empty()) continue;
    const int node = skeleton.find(point.name);
    ASSERT_GE(node, 0) << point.name;
    EXPECT_LE(norm(at[static_cast<std::size_t>(node)] - point.at), kRounding) << point.name;
  }
}

TEST(Fbx, BothFormsGiveTheSameSkeleton) {
  const FbxFile file(standing_figure());
  for (const std::string& bytes : {file.text(), file.bytes(7400), file.bytes(7700)}) {
    const GltfCharacter character = read(bytes);
    expect_figure(character, standing_figure());
    EXPECT_EQ(character.rest.skeleton.nodes[0].name, "Armature");
  }
}

// As written by MotionBuilder, Maya and Blender before 2011, in decimetres with z up.
TEST(Fbx, VersionSixGivesTheSameSkeleton) {
  FbxFile file(standing_figure().transformed({{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}));
  file.axes = {2, 1, 1, -1, 0, 1};
  file.unit = 0.1;
  file.pre_rotation = {30, -40, 50};
  file.joint_scale = {2, 2, 2};
  file.meshes = true;
  for (const std::string& bytes : {file.text(6100), file.bytes(6100), file.bytes(6000)}) {
    const GltfCharacter character = read(bytes);
    expect_figure(character, standing_figure());
    EXPECT_EQ(character.rest.skeleton.find("Body_mesh"), -1);
  }
}

TEST(Fbx, UnitIsTheFiles) {
  for (const double unit : {0.01, 1.0, 0.0254, 0.001}) {
    FbxFile file(standing_figure());
    file.unit = unit;
    expect_figure(read(file.text()), standing_figure());
  }
}

TEST(Fbx, AxesAreTurnedToGltfs) {
  // z up, facing -y, as Blender and 3ds Max write; then z up, facing y
  struct Axes {
    std::array<int, 6> told;
    Mat3d of_file;
  };
  for (const Axes& axes : {Axes{{2, 1, 1, -1, 0, 1}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},
                           Axes{{2, 1, 1, 1, 0, -1}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}}) {
    FbxFile file(standing_figure().transformed(axes.of_file));
    file.axes = axes.told;
    expect_figure(read(file.text()), standing_figure());
  }
}

TEST(Fbx, PlacesAreTheProductOfTheFilesParts) {
  FbxFile file(standing_figure());
  file.pre_rotation = {30, -40, 50};
  file.rotation = {10, 70, -20};
  file.post_rotation = {-60, 20, 40};
  file.root_scale = 100.0;
  for (const std::string& bytes : {file.text(), file.bytes()}) {
    expect_figure(read(bytes), standing_figure());
  }
}

// Maya's segment scale compensation: a joint's children are farther away, but not larger.
TEST(Fbx, ScaleThatAModelDoesNotInheritMovesItAlone) {
  for (const Vec3d& scale : {Vec3d{0.01, 0.01, 0.01}, Vec3d{1.3, 1.3, 1.3}, Vec3d{0.5, 2, 1}}) {
    FbxFile file(standing_figure());
    file.rotation = {10, 70, -20};
    file.root_scale = 100.0;
    file.joint_scale = scale;
    for (const std::string& bytes : {file.text(), file.bytes()}) {
      expect_figure(read(bytes), standing_figure());
    }
  }
}

struct ScaledModel {
  int parent;
  int inherits;  // as the file numbers it
  Vec3d at;
  Vec3d turned_deg;
  Vec3d scale;
};

std::string text_of(const std::vector<ScaledModel>& models) {
  std::string objects;
  std::string links;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const auto& [parent, inherits, at, turned, scale] = models[i];
    const auto vector = [](const char* name, const Vec3d& v) {
      return fmt::format("P: \"{}\", \"\", \"\", \"\",{},{},{}\n", name, v.x, v.y, v.z);
    };
    objects +=
        fmt::format("Model: {}, \"Model::j{}\", \"LimbNode\" {{\nProperties70: {{\n", i + 1, i) +
        fmt::format("P: \"InheritType\", \"enum\", \"\", \"\",{}\n", inherits) +
        vector("Lcl Translation", at) + vector("Lcl Rotation", turned) +
        vector("Lcl Scaling", scale) + "}\n}\n";
    links += fmt::format("C: \"OO\",{},{}\n", i + 1, parent + 1);
  }
  return "FBXHeaderExtension: {\nFBXVersion: 7400\n}\nObjects: {\n" + objects +
         "}\nConnections: {\n" + links + "}\n";
}

Mat3d diagonal(const Vec3d& v) { return {{v.x, 0, 0}, {0, v.y, 0}, {0, 0, v.z}}; }

// The origins by the product of matrices given by Autodesk's SDK, in metres.
std::vector<Vec3d> origins_of(const std::vector<ScaledModel>& models) {
  struct World {
    Vec3d at{};
    Mat3d turned{};
    Mat3d scaled{};  // the SDK's global shear and scaling
  };
  std::vector<World> world;
  std::vector<Vec3d> origins;
  for (const auto& [parent, inherits, at, turned_deg, scale] : models) {
    const World above = parent < 0 ? World{} : world[static_cast<std::size_t>(parent)];
    const Mat3d own = rotation(Axis::z, radians(turned_deg.z)) *
                      rotation(Axis::y, radians(turned_deg.y)) *
                      rotation(Axis::x, radians(turned_deg.x));
    const Vec3d& s = parent < 0 ? Vec3d{1, 1, 1} : models[static_cast<std::size_t>(parent)].scale;
    const Mat3d without = above.scaled * diagonal({1 / s.x, 1 / s.y, 1 / s.z});
    const Mat3d whole = inherits == 0   ? above.turned * own * above.scaled * diagonal(scale)
                        : inherits == 1 ? above.turned * above.scaled * own * diagonal(scale)
                                        : above.turned * own * without * diagonal(scale);
    World here{above.at + above.turned * (above.scaled * at), above.turned * own, {}};
    here.scaled = transpose(here.turned) * whole;
    world.push_back(here);
    origins.push_back(here.at * 0.01);
  }
  return origins;
}

TEST(Fbx, ScaleIsInheritedByAutodesksFormula) {
  Random random(5);
  const auto within = [&](double low, double high) {
    return Vec3d{random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
  };
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<ScaledModel> models;
    for (int i = 0; i < 7; ++i) {
      const int parent =
          i == 0 ? -1 : static_cast<int>(random.below(static_cast<std::uint32_t>(i)));
      models.push_back({parent, 2 * static_cast<int>(random.below(2)), within(-50, 50),
                        within(-180, 180), within(0.5, 2)});
      // a scale that differs between axes, and is inherited before the turn, shears
      const bool even = trial % 2 == 0;
      if (even) models.back().scale = Vec3d{1, 1, 1} * models.back().scale.x;
      if (even && random.below(2) == 0) models.back().inherits = 1;
    }
    const GltfCharacter character = read(text_of(models));
    const std::vector<Vec3d> at = rest_origins(character.rest.skeleton);
    const std::vector<Vec3d> expected = origins_of(models);
    for (std::size_t i = 0; i < models.size(); ++i) {
      const int node = character.rest.skeleton.find(fmt::format("j{}", i));
      EXPECT_LE(norm(at[static_cast<std::size_t>(node)] - expected[i]), 1e-9) << trial << ' ' << i;
    }
  }
}

TEST(Fbx, JointsAreLimbNodesAndWhatTheyHangOn) {
  FbxFile file(standing_figure());
  file.meshes = true;
  EXPECT_EQ(read(file.text()).rest.skeleton.find("Body_mesh"), -1);
}

TEST(Fbx, DamagedSceneryIsLeftOut) {
  const std::string whole = FbxFile(standing_figure()).text();
  for (const char* numbers :
       {"\"Lcl Translation\", \"\", \"A\",1e300,0,0", "\"Lcl Rotation\", \"\", \"A\",0,1e12,0"}) {
    std::string text = whole;
    const std::size_t begin = text.find('{', text.find("Objects:")) + 1;
    text.insert(begin,
                std::string("\nModel: 77, \"Model::Rock\", \"Null\" {\nProperties70: {\nP: ") +
                    std::string(numbers).insert(std::string(numbers).find(',') + 1, " \"Lcl\",") +
                    "\n}\n}\nModel: 78, \"Model::Moss\", \"Null\" {\n}\n");
    text.insert(text.find('{', text.find("Connections:")) + 1, "\nC: \"OO\",78,77\n");
    const GltfCharacter character = read(text);
    expect_figure(character, standing_figure());
    EXPECT_EQ(character.rest.skeleton.find("Rock"), -1);
    EXPECT_EQ(character.rest.skeleton.find("Moss"), -1);
  }
}

TEST(Fbx, FileWithoutLimbNodesGivesItsOtherModels) {
  FbxFile file(standing_figure());
  file.kind = "Null";
  file.meshes = true;
  const GltfCharacter character = read(file.text());
  expect_figure(character, standing_figure());
  EXPECT_EQ(character.rest.skeleton.find("Body_mesh"), -1);
}

TEST(Fbx, CommentsCommasAndEmptyRecordsOfTheTextFormAreTaken) {
  std::string text = FbxFile(standing_figure()).text();
  const std::size_t at = text.find("Objects: ");
  text.insert(at,
              "; a comment with { and \"\nTakes:  {\n}\nReferences: \n"
              "Video: 12, \"Video::\", \"Clip\" {\n Content: ,\n\"abc==\"\n Key: *3 {\n"
              "a: 1,2\n,3\n}\n}\n");
  expect_figure(read(text), standing_figure());
}

TEST(Fbx, NamesMayBeInAnyEncoding) {
  StickFigure figure = standing_figure();
  figure["Hips"].name =
      "mixamorig:H\xFC"
      "rste";
  EXPECT_GE(read(FbxFile(figure).bytes())
                .rest.skeleton.find("mixamorig:H\xEF\xBF\xBD"
                                    "rste"),
            0);
}

TEST(Fbx, WhatIsNoFbxIsRefused) {
  EXPECT_EQ(error_of(""), "f.fbx: no FBXVersion: this is no FBX file");
  EXPECT_EQ(error_of("{}"), "line 1 of f.fbx: no record: it begins with a name and a colon");
  EXPECT_EQ(error_of("Kaydara FBX Binary  "),
            "line 1 of f.fbx: no record: it begins with a name and a colon");
  EXPECT_EQ(error_of("FBXHeaderExtension: {\nFBXVersion: 5800\n}\n"),
            "f.fbx: FBX of version 5.8; versions from 6 on are read: save it as FBX 7.4 (2014), or "
            "as GLB");
  EXPECT_EQ(error_of("FBXHeaderExtension: {\nFBXVersion: 7400\n}\n"),
            "f.fbx: no model: there is no skeleton in this file");
}

TEST(Fbx, FaultsAreToldWithTheirPlace) {
  const std::string head = "FBXHeaderExtension: {\nFBXVersion: 7400\n}\n";
  EXPECT_EQ(error_of(head + "Objects: {\n"), "line 5 of f.fbx: the file ends within a record");
  EXPECT_EQ(error_of(head + "}"), "line 4 of f.fbx: a '}' closes nothing");
  EXPECT_EQ(error_of(head + "a: \"b"), "line 4 of f.fbx: a text is never closed");
  EXPECT_EQ(error_of(head + "Objects: {\nModel: 1,\"Model::a\",\"LimbNode\"\n"
                            "Model: 1,\"Model::b\",\"LimbNode\"\n}\n"),
            "f.fbx: two models have the id 1");
  FbxFile circle(standing_figure());
  circle.more_links = {{900, 1003}};
  circle.root_link = false;
  EXPECT_THAT(error_of(circle.text()), HasSubstr("hangs in a circle"));
  FbxFile far(standing_figure());
  far.unit = 1e-12;
  EXPECT_THAT(error_of(far.text()), HasSubstr("beyond 1e+09"));
  FbxFile spinning(standing_figure());
  spinning.rotation = {0, 1e12, 0};
  EXPECT_EQ(error_of(spinning.text()), "f.fbx: model 'Hips' is turned by more than 1e+09 degrees");
  FbxFile axes(standing_figure());
  axes.axes = {1, 1, 1, 1, 0, 1};
  EXPECT_THAT(error_of(axes.text()), HasSubstr("are not 0, 1 and 2 in some order"));
  std::string unit = FbxFile(standing_figure()).text();
  const std::string told = "1.000000000000000";
  unit.replace(unit.find(told), told.size(), "-1");
  EXPECT_EQ(error_of(unit), "f.fbx: UnitScaleFactor is -1; it is above 0");
}

TEST(Fbx, LimitsAreHeld) {
  std::string deep = "a: ";
  for (int i = 0; i < 100'000; ++i) deep += "{a: ";
  EXPECT_EQ(error_of(deep), "line 1 of f.fbx: records are nested deeper than 64");
  std::string models = "FBXHeaderExtension: {\nFBXVersion: 7400\n}\nObjects: {\n";
  for (int i = 0; i <= kFbxMaxNodes; ++i) models += fmt::format("Model: {},\"a\",\"b\"\n", i);
  EXPECT_EQ(error_of(models + "}"), "f.fbx: more than 4096 models");
  std::string links = "Connections: {\n";
  for (std::size_t i = 0; i <= kFbxMaxRecords; ++i) links += "C: \"OO\",1,2\n";
  EXPECT_THAT(error_of(links + "}"), HasSubstr("more than 300000 records"));
}

TEST(Fbx, RecordsThatLieAboutTheirLengthAreRefused) {
  const std::string whole = FbxFile(standing_figure()).bytes();
  for (const std::uint32_t length : {1u, 28u, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
    std::string lie = whole;
    std::memcpy(lie.data() + 27, &length, 4);
    EXPECT_THAT(error_of(lie), HasSubstr("f.fbx")) << length;
  }
}

// A file truncated anywhere is an error or a smaller skeleton, never a crash.
TEST(Fbx, TruncatedFilesGiveClearErrors) {
  for (const std::string& whole :
       {FbxFile(standing_figure()).text(), FbxFile(standing_figure()).bytes()}) {
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += 7) {
      const Result<std::string> glb = glb_of_fbx(whole.substr(0, size), "f.fbx");
      if (glb) continue;
      ++refused;
      EXPECT_THAT(glb.error().to_string(), HasSubstr("f.fbx: "));
    }
    // except where it is cut behind the last model's connections
    EXPECT_GT(refused, static_cast<int>(whole.size() / 7 - whole.size() / 70));
  }
}

TEST(Fbx, MutatedFilesAreReadOrRefused) {
  Random random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    const FbxFile file(standing_figure());
    const std::uint32_t version = trial % 3 == 0 ? 6100 : 7400;
    std::string bytes = trial % 2 == 0 ? file.text(version) : file.bytes(version);
    for (int k = 0; k < 4; ++k) {
      const auto at = random.below(static_cast<std::uint32_t>(bytes.size()));
      bytes[at] = static_cast<char>(random.below(256));
    }
    const Result<std::string> glb = glb_of_fbx(bytes, "f.fbx");
    if (!glb) continue;
    const Result<GltfCharacter> character = parse_gltf(*glb, "f.fbx");
    EXPECT_TRUE(character || !character.error().message.empty());
  }
}

}  // namespace
}  // namespace shigusa
