// SPDX-License-Identifier: MIT
// Series as tables with their meaning, at any rate and in a file's own place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <shigusa/math.hpp>

#include "c/handles.hpp"
#include "support/gltf_file.hpp"

namespace shigusa_c_test {
namespace {

using shigusa::Quatd;
using shigusa::Vec3d;

struct NamedTable {
  Json about;
  Table table;
};

std::string taken(shigusa_bytes* bytes) {
  std::string text(shigusa_bytes_data(bytes), shigusa_bytes_size(bytes));
  shigusa_bytes_free(bytes);
  return text;
}

NamedTable named_table(const shigusa_result* result, shigusa_series series, const char* options) {
  shigusa_bytes* values = nullptr;
  shigusa_bytes* about = nullptr;
  EXPECT_EQ(shigusa_result_table(result, 1, series, options, &values, &about), SHIGUSA_OK)
      << shigusa_message();
  NamedTable made{Json::parse(taken(about)), {}};
  const std::string bytes = taken(values);
  made.table.values.resize(bytes.size() / sizeof(double));
  if (!bytes.empty()) std::memcpy(made.table.values.data(), bytes.data(), bytes.size());
  const Json& shape = made.about.at("shape");
  made.table.frames = shape.at(0);
  made.table.columns = 1;
  for (std::size_t k = 1; k < shape.size(); ++k) {
    made.table.columns *= shape.at(k).get<std::size_t>();
  }
  EXPECT_EQ(made.table.values.size(), made.table.frames * made.table.columns);
  return made;
}

const shigusa_result* low_reach() {
  static const Outcome made = outcome_of(nullptr, kLowReach);
  return made.get();
}

TEST(CInterfaceTables, HaveTheNamesOfTheirColumns) {
  const Json names = {"time",         "angles",    "torques",           "centre_of_mass",
                      "support",      "effectors", "node_translations", "node_rotations",
                      "upper_limits", "things"};
  const Character human = character_of(R"("human")");
  const Json described = Json::parse(text_of(shigusa_character_describe, human.get()));
  Json joints = Json::array();
  for (const Json& joint : described.at("joints")) joints.push_back(joint.at("name"));
  Json nodes = Json::array();
  for (const Json& node : described.at("nodes")) nodes.push_back(node.at("name"));
  for (shigusa_series series = SHIGUSA_TIME; series <= SHIGUSA_THINGS; ++series) {
    const auto [about, table] = named_table(low_reach(), series, nullptr);
    EXPECT_EQ(about.at("name"), names.at(static_cast<std::size_t>(series)));
    EXPECT_NEAR(about.at("fps"),
                (static_cast<double>(table.frames) - 1) /
                    table_of(low_reach(), 1, SHIGUSA_TIME).values.back(),
                1e-9);
    const Table own = table_of(low_reach(), 1, series);
    EXPECT_EQ(table.values, own.values) << series;
    EXPECT_EQ(table.columns, own.columns) << series;
  }
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_TORQUES, nullptr).about.at("names"), joints);
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_NODE_ROTATIONS, nullptr).about.at("names"), nodes);
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_NODE_ROTATIONS, nullptr).about.at("components"),
            Json({"x", "y", "z", "w"}));
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_EFFECTORS, nullptr).about.at("names"),
            Json({"right_hand"}));
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_TIME, nullptr).about.at("shape").size(), 1U);
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_SUPPORT, nullptr).about.at("names"),
            Json({"centre_of_mass", "pressure"}));
  EXPECT_EQ(named_table(low_reach(), SHIGUSA_CENTRE_OF_MASS, nullptr).about.count("names"), 0U);
}

TEST(CInterfaceTables, AreAllAtAnyRate) {
  const double end = table_of(low_reach(), 1, SHIGUSA_TIME).values.back();
  const auto frames = static_cast<std::size_t>(std::ceil(end * 24.0 - 1e-9)) + 1;
  for (shigusa_series series = SHIGUSA_ANGLES; series < SHIGUSA_THINGS; ++series) {
    const auto [about, table] = named_table(low_reach(), series, R"({"fps": 24})");
    EXPECT_NEAR(about.at("fps"), 24.0, 1e-9);
    EXPECT_EQ(table.frames, frames);
    const Table own = table_of(low_reach(), 1, series);
    ASSERT_EQ(table.columns, own.columns);
    for (std::size_t c = 0; c < own.columns; ++c) {
      EXPECT_NEAR(table.at(0, c), own.at(0, c), 1e-9) << series;
      EXPECT_NEAR(table.at(frames - 1, c), own.at(own.frames - 1, c), 1e-9) << series;
    }
  }
  // between two frames of its own
  const Table times = table_of(low_reach(), 1, SHIGUSA_TIME);
  const Table own = table_of(low_reach(), 1, SHIGUSA_TORQUES);
  const Table torques = named_table(low_reach(), SHIGUSA_TORQUES, R"({"fps": 24})").table;
  for (std::size_t f = 0; f + 1 < frames; ++f) {
    const double at = static_cast<double>(f) / 24.0 / times.at(1, 0);
    const auto before = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(before);
    EXPECT_NEAR(torques.at(f, 20),
                own.at(before, 20) * (1 - share) + own.at(before + 1, 20) * share, 1e-9);
  }
}

TEST(CInterfaceTables, RefuseOtherOptions) {
  const std::pair<const char*, const char*> wrong[] = {
      {R"({"fps": 0})", "fps"}, {R"({"place": "moon"})", "place"}, {R"({"rate": 24})", "rate"}};
  for (const auto& [options, says] : wrong) {
    shigusa_bytes* table = nullptr;
    shigusa_bytes* about = nullptr;
    EXPECT_EQ(shigusa_result_table(low_reach(), 1, SHIGUSA_TIME, options, &table, &about),
              SHIGUSA_PARSE);
    EXPECT_THAT(shigusa_message(), testing::HasSubstr(says));
    EXPECT_EQ(table, nullptr);
    EXPECT_EQ(about, nullptr);
  }
}

Vec3d point(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

// Origins of all nodes in a frame, in the units of node tracks.
std::vector<Vec3d> origins(const Json& nodes, const Table& moves, const Table& turns,
                           std::size_t frame) {
  std::vector<shigusa::Transformd> placed;
  std::vector<Vec3d> all;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto at = [&](const Table& table, std::size_t width, std::size_t k) {
      return table.at(frame, width * n + k);
    };
    const Vec3d move{at(moves, 3, 0), at(moves, 3, 1), at(moves, 3, 2)};
    const Quatd turn{at(turns, 4, 0), at(turns, 4, 1), at(turns, 4, 2), at(turns, 4, 3)};
    const Vec3d scale =
        nodes.at(n).contains("scale") ? point(nodes.at(n).at("scale")) : Vec3d{1, 1, 1};
    const auto r = to_matrix(turn);
    const shigusa::Transformd local{{r.cx * scale.x, r.cy * scale.y, r.cz * scale.z}, move};
    const int parent = nodes.at(n).at("parent");
    placed.push_back(parent < 0 ? local : placed[static_cast<std::size_t>(parent)] * local);
    all.push_back(placed.back().translation);
  }
  return all;
}

// A scaled armature that stands elsewhere and looks aside, as in a host's scene.
TEST(CInterfaceTables, NodesMoveWhereTheCharacterStandsInItsFile) {
  auto file = shigusa::testing_support::person_gltf();
  std::vector<int> roots;
  std::vector<bool> below(file["nodes"].size());
  for (const auto& node : file["nodes"]) {
    if (!node.contains("children")) continue;
    for (const int child : node["children"]) below[static_cast<std::size_t>(child)] = true;
  }
  for (std::size_t n = 0; n < below.size(); ++n) {
    if (!below[n]) roots.push_back(static_cast<int>(n));
  }
  file["nodes"].push_back({{"name", "Armature"},
                           {"children", roots},
                           {"translation", {1.5, 0.2, -0.7}},
                           {"rotation", {0.0, std::sin(0.35), 0.0, std::cos(0.35)}},
                           {"scale", {0.9, 0.9, 0.9}}});
  const Character person = character_of(R"({"source": "person.gltf"})", file.dump());
  const Json described = Json::parse(text_of(shigusa_character_describe, person.get()));
  const Outcome result = outcome_of(person.get(), kLowReach);
  ASSERT_NE(result, nullptr);
  const auto origins_in = [&](const char* options, std::size_t frame) {
    return origins(described.at("nodes"),
                   named_table(result.get(), SHIGUSA_NODE_TRANSLATIONS, options).table,
                   named_table(result.get(), SHIGUSA_NODE_ROTATIONS, options).table, frame);
  };
  const Json& placement = described.at("placement");
  const double unit = placement.at("unit_m");
  double moved = 0.0;
  for (const std::size_t frame : {std::size_t{0}, std::size_t{12}}) {
    const std::vector<Vec3d> world = origins_in(R"({"fps": 24})", frame);
    const std::vector<Vec3d> in_file = origins_in(R"({"fps": 24, "place": "file"})", frame);
    for (std::size_t n = 0; n < world.size(); ++n) {
      // what stays in the file, such as the armature, stays in both
      const Vec3d from = in_file[n] - point(placement.at("origin"));
      const Vec3d there{unit * dot(from, point(placement.at("left"))),
                        unit * dot(from, point(placement.at("up"))),
                        unit * dot(from, point(placement.at("ahead")))};
      const bool stays = norm(world[n] - in_file[n]) == 0.0;
      if (!stays) {
        EXPECT_LT(norm(there - world[n] * unit), 1e-6) << n;
      }
      moved += stays ? 0.0 : 1.0;
    }
  }
  EXPECT_GT(moved, 40.0);
}

}  // namespace
}  // namespace shigusa_c_test
