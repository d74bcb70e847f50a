// SPDX-License-Identifier: MIT
// Characters of a host's nodes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "c/handles.hpp"

namespace shigusa_c_test {
namespace {

Json description_of(const shigusa_character* character) {
  return Json::parse(text_of(shigusa_character_describe, character));
}

// A person of a file, as a host has one.
std::string file_of_human() {
  const Outcome found = outcome_of(nullptr, kLowReach);
  return text_of(shigusa_result_export, found.get(), 1, "glb");
}

// The nodes of a described character as a host tells them.
Json nodes_of(const Json& description) {
  Json nodes = Json::array();
  for (const Json& node : description.at("nodes")) {
    const Json& rest = node.contains("rest") ? node.at("rest") : node;
    Json told{{"name", node.at("name")},
              {"parent", node.at("parent")},
              {"translation", rest.at("offset")},
              {"rotation", rest.at("rotation")}};
    if (rest.contains("scale")) told["scale"] = rest.at("scale");
    nodes.push_back(std::move(told));
  }
  return {{"nodes", nodes}};
}

Character of_nodes(const Json& nodes, const char* spec = R"({"source": "rig.glb"})") {
  shigusa_character* made = nullptr;
  EXPECT_EQ(shigusa_character_of_nodes(spec, nodes.dump().c_str(), &made), SHIGUSA_OK)
      << shigusa_message();
  return Character(made);
}

// The first goal's effector in a frame (m, world).
std::array<double, 3> place_of(const shigusa_result* result, size_t frame) {
  const Table places = table_of(result, 1, SHIGUSA_EFFECTORS);
  return {places.at(frame, 0), places.at(frame, 1), places.at(frame, 2)};
}

// A place of the world in the axes and units of the host.
std::array<double, 3> in_file(const Json& description, const std::array<double, 3>& place) {
  const Json& placement = description.at("placement");
  std::array<double, 3> at{};
  for (size_t k = 0; k < 3; ++k) {
    at[k] = placement.at("origin").at(k).get<double>();
    size_t axis = 0;
    for (const char* of : {"left", "up", "ahead"}) {
      at[k] += placement.at(of).at(k).get<double>() * place[axis++] /
               placement.at("unit_m").get<double>();
    }
  }
  return at;
}

TEST(CInterfaceOfNodes, IsThePersonOfTheFile) {
  const Character file = character_of(R"({"source": "rig.glb"})", file_of_human());
  const Json described = description_of(file.get());
  const Character nodes = of_nodes(nodes_of(described));
  ASSERT_NE(nodes, nullptr);
  const Json own = description_of(nodes.get());
  EXPECT_NEAR(own.at("stature_m").get<double>(), described.at("stature_m").get<double>(), 0.02);
  EXPECT_EQ(own.at("joints").size(), described.at("joints").size());
  const Outcome found = outcome_of(nodes.get(), kLowReach);
  ASSERT_NE(found, nullptr);
  const auto end = place_of(found.get(), table_of(found.get(), 1, SHIGUSA_TIME).frames - 1);
  EXPECT_NEAR(end[0], -0.2, 1e-5);
  EXPECT_NEAR(end[1], 0.9, 1e-5);
  EXPECT_NEAR(end[2], 0.5, 1e-5);
}

// Nodes below one that moves, turns and scales them, in the host's own axes.
TEST(CInterfaceOfNodes, MayStandElsewhere) {
  const Character file = character_of(R"({"source": "rig.glb"})", file_of_human());
  const Json plain = nodes_of(description_of(file.get()));
  Json moved{{"nodes",
              {{{"name", "Armature"},
                {"translation", {1.5, 0.3, -0.7}},
                {"rotation", {0.0, std::sin(0.35), 0.0, std::cos(0.35)}},
                {"scale", {0.9, 0.9, 0.9}}}}}};
  for (Json node : plain.at("nodes")) {
    node["parent"] = node.at("parent").get<int>() + 1;
    moved["nodes"].push_back(node);
  }
  const Character there = of_nodes(moved);
  const Character here = of_nodes(plain);
  ASSERT_NE(there, nullptr);
  EXPECT_NEAR(description_of(there.get()).at("stature_m").get<double>(),
              0.9 * description_of(here.get()).at("stature_m").get<double>(), 1e-4);
  const Json placement = description_of(there.get()).at("placement");
  EXPECT_NEAR(placement.at("ahead").at(0).get<double>(), std::sin(0.7), 1e-3);
  EXPECT_NEAR(placement.at("origin").at(1).get<double>(), 0.3, 1e-3);
}

// The last posture of one motion, told as the pose of the nodes, is the first of the next.
TEST(CInterfaceOfNodes, StartsFromThePresentPose) {
  const Character file = character_of(R"({"source": "rig.glb"})", file_of_human());
  Json nodes = nodes_of(description_of(file.get()));
  const Character before = of_nodes(nodes);
  const Outcome first = outcome_of(before.get(), kLowReach);
  const Json described = description_of(before.get());
  const auto last = [&](shigusa_series series) {
    shigusa_bytes* rows = nullptr;
    const std::string about = [&] {
      shigusa_bytes* told = nullptr;
      EXPECT_EQ(shigusa_result_table(first.get(), 1, series, R"({"place": "file"})", &rows, &told),
                SHIGUSA_OK);
      std::string text = shigusa_bytes_data(told);
      shigusa_bytes_free(told);
      return text;
    }();
    const Json shape = Json::parse(about).at("shape");
    const auto* values = reinterpret_cast<const double*>(shigusa_bytes_data(rows));
    const size_t row = shape.at(1).get<size_t>() * shape.at(2).get<size_t>();
    std::vector<double> end(values + (shape.at(0).get<size_t>() - 1) * row,
                            values + shape.at(0).get<size_t>() * row);
    shigusa_bytes_free(rows);
    return end;
  };
  const std::vector<double> at = last(SHIGUSA_NODE_TRANSLATIONS);
  const std::vector<double> turned = last(SHIGUSA_NODE_ROTATIONS);
  const Json& listed = described.at("nodes");
  for (size_t i = 0; i < listed.size(); ++i) {
    const auto own = listed.at(i).at("file_node").get<size_t>();
    if (own >= nodes.at("nodes").size()) continue;  // hands and feet that the skeleton lacks
    nodes["nodes"][own]["pose"] = {
        {"translation", {at[3 * i], at[3 * i + 1], at[3 * i + 2]}},
        {"rotation", {turned[4 * i], turned[4 * i + 1], turned[4 * i + 2], turned[4 * i + 3]}}};
  }
  const Character posed = of_nodes(nodes);
  ASSERT_NE(posed, nullptr);
  const Outcome next = outcome_of(
      posed.get(), R"({"goals": [{"effector": "right_hand", "position_m": [-0.3, 1.3, 0.4]}],
                       "seed": 3, "evaluations": 600})");
  ASSERT_NE(next, nullptr);
  const auto end =
      in_file(described, place_of(first.get(), table_of(first.get(), 1, SHIGUSA_TIME).frames - 1));
  const auto begin = in_file(description_of(posed.get()), place_of(next.get(), 0));
  for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(begin[k], end[k], 1e-5) << k;
}

TEST(CInterfaceOfNodes, WrongOnesAreRefused) {
  shigusa_character* none = nullptr;
  for (const auto& [nodes, said] :
       {std::pair("", "is empty"),
        {"[", "JSON"},
        {"{}", "nodes: is missing"},
        {R"({"nodes": []})", "1 to 2048"},
        {R"({"nodes": [{"parent": -1}]})", "nodes[0].name: is missing"},
        {R"({"nodes": [{"name": "a", "parent": 3}]})", "nodes[0].parent"},
        {R"({"nodes": [{"name": "a", "rotation": [0, 0, 0, 0]}]})", "nodes[0].rotation"},
        {R"({"nodes": [{"name": "a", "translation": [1e99, 0, 0]}]})", "nodes[0].translation"},
        {R"({"nodes": [{"name": "a", "pose": {"turn": 3}}]})", "nodes[0].pose"},
        {R"({"nodes": [{"name": "a", "parent": 1}, {"name": "b", "parent": 0}]})", "ring"},
        {R"({"nodes": [{"name": "a", "scale": [0, 0, 0]}]})", "rig.glb"}}) {
    EXPECT_NE(shigusa_character_of_nodes(R"({"source": "rig.glb"})", nodes, &none), SHIGUSA_OK);
    EXPECT_THAT(shigusa_message(), testing::HasSubstr(said)) << nodes;
  }
  EXPECT_EQ(shigusa_character_of_nodes(R"("human")", R"({"nodes": [{"name": "a"}]})", &none),
            SHIGUSA_INVALID_ARGUMENT);
  EXPECT_EQ(none, nullptr);
}

}  // namespace
}  // namespace shigusa_c_test
