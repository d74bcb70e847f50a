// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "c/handles.hpp"
#include "support/gltf_file.hpp"

namespace shigusa_c_test {
namespace {

using testing::HasSubstr;

TEST(CInterface, TellsItsVersion) {
  EXPECT_EQ(shigusa_abi_version(), static_cast<uint32_t>(SHIGUSA_ABI_VERSION));
  EXPECT_THAT(std::string(shigusa_version()), testing::Contains('.').Times(2));
}

TEST(CInterface, AHostOfAnotherVersionIsTold) {
  EXPECT_STREQ(SHIGUSA_HEADER_VERSION, shigusa_version());
  EXPECT_EQ(shigusa_check_version(SHIGUSA_ABI_VERSION, SHIGUSA_HEADER_VERSION), SHIGUSA_OK);
  EXPECT_EQ(shigusa_check_version(SHIGUSA_ABI_VERSION, "0.0.9"), SHIGUSA_OK);
  for (const auto& [abi, version] : {std::pair(SHIGUSA_ABI_VERSION + 1, SHIGUSA_HEADER_VERSION),
                                     {SHIGUSA_ABI_VERSION, "0.99.0"},
                                     {SHIGUSA_ABI_VERSION, "17.0.0"}}) {
    EXPECT_EQ(shigusa_check_version(static_cast<uint32_t>(abi), version), SHIGUSA_UNSUPPORTED);
    EXPECT_THAT(shigusa_message(), HasSubstr(version));
    EXPECT_THAT(shigusa_message(), HasSubstr(shigusa_version()));
  }
  for (const char* version : {"", "1", "0.1", "0.1.0.0", "0.1.x", "-1.0.0", "latest"}) {
    EXPECT_EQ(shigusa_check_version(SHIGUSA_ABI_VERSION, version), SHIGUSA_INVALID_ARGUMENT);
  }
  EXPECT_EQ(shigusa_check_version(SHIGUSA_ABI_VERSION, nullptr), SHIGUSA_INVALID_ARGUMENT);
}

TEST(CInterface, TellsTheFactsOfTheEngine) {
  const Json facts = Json::parse(text_of(shigusa_facts));
  EXPECT_EQ(facts.at("mixtures").at("paper").at("joint_range"), 0.5);
  EXPECT_EQ(facts.at("ranges").at("load_kg"), Json({0.0, 500.0}));
  EXPECT_EQ(shigusa_facts(nullptr), SHIGUSA_INVALID_ARGUMENT);
}

TEST(CInterface, DescribesWhatItUnderstood) {
  const Character human = character_of(R"({"source": "human", "stature_m": 1.6})");
  const Json told = Json::parse(text_of(shigusa_character_describe, human.get()));
  EXPECT_EQ(told.at("stature_m"), 1.6);
  EXPECT_EQ(told.at("joints").size(), told.at("dof"));
  EXPECT_EQ(told.at("node_unit_m"), 1.0);
  EXPECT_GE(told.at("support_polygon").size(), 4U);
  int roots = 0;
  for (size_t i = 0; i < told.at("nodes").size(); ++i) {
    const int parent = told.at("nodes").at(i).at("parent");
    EXPECT_LT(parent, static_cast<int>(i));
    roots += parent < 0 ? 1 : 0;
  }
  EXPECT_EQ(roots, 1);
}

TEST(CInterface, ABodyFromBytesMovesTheNodesOfItsFile) {
  const std::string file = shigusa::testing_support::person_gltf().dump();
  const Character person = character_of(R"({"source": "person.gltf"})", file);
  const Json told = Json::parse(text_of(shigusa_character_describe, person.get()));
  EXPECT_TRUE(told.at("nodes").at(0).contains("file_node"));
  const Outcome result = outcome_of(
      person.get(), R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 1.1, 0.35]}]})");
  const Table turns = table_of(result.get(), 1, SHIGUSA_NODE_ROTATIONS);
  EXPECT_EQ(turns.columns, 4 * told.at("nodes").size());
  EXPECT_THAT(text_of(shigusa_result_export, result.get(), 1, "glb"), testing::StartsWith("glTF"));
  EXPECT_THAT(text_of(shigusa_result_export, result.get(), 0, "glb"),
              HasSubstr("shigusa candidate 2"));
}

TEST(CInterface, APageShowsOneCandidateOrAll) {
  const Outcome result = outcome_of(nullptr, kLowReach);
  const auto figures = [&result](int32_t candidate) {
    const std::string page = text_of(shigusa_result_export, result.get(), candidate, "html");
    EXPECT_THAT(page, testing::StartsWith("<!DOCTYPE html>"));
    int32_t count = 0;
    for (size_t at = 0; (at = page.find("<canvas", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_GT(shigusa_result_candidates(result.get()), 1);
  EXPECT_EQ(figures(0), shigusa_result_candidates(result.get()));
  EXPECT_EQ(figures(2), 1);
  EXPECT_NE(text_of(shigusa_result_export, result.get(), 1, "html"),
            text_of(shigusa_result_export, result.get(), 2, "html"));
  for (const int32_t missing : {-1, 99}) {
    shigusa_bytes* file = nullptr;
    EXPECT_EQ(shigusa_result_export(result.get(), missing, "html", &file),
              SHIGUSA_INVALID_ARGUMENT);
    EXPECT_EQ(file, nullptr);
  }
}

TEST(CInterface, TellsTheNodesOfAFileAtRest) {
  auto file = shigusa::testing_support::person_gltf();
  const Character person = character_of(R"({"source": "person.gltf"})", file.dump());
  const Json described = Json::parse(text_of(shigusa_character_describe, person.get()));
  for (const Json& node : described.at("nodes")) {
    const auto& there = file["nodes"][node.at("file_node").get<std::size_t>()];
    const Json& rest = node.contains("rest") ? node.at("rest") : node;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(rest.at("offset").at(k), there["translation"][k].get<double>(), 1e-12);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(rest.at("rotation").at(k), there["rotation"][k].get<double>(), 1e-12);
    }
  }
}

TEST(CInterface, AFailureTellsItsSentenceAndValues) {
  const Character human = character_of(R"("human")");
  shigusa_result* none = nullptr;
  ASSERT_NE(
      shigusa_generate(human.get(), R"({"goals": [{"effector": "tail", "position_m": [0, 1, 0]}]})",
                       1, nullptr, &none),
      SHIGUSA_OK);
  shigusa_bytes* bytes = nullptr;
  ASSERT_EQ(shigusa_failure(&bytes), SHIGUSA_OK);
  const Json told = Json::parse(shigusa_bytes_data(bytes));
  shigusa_bytes_free(bytes);
  const Json& message = told.at("message");
  EXPECT_EQ(told.at("place").get<std::string>() + ": " + message.at("text").get<std::string>(),
            shigusa_message());
  EXPECT_THAT(message.at("key"), testing::AnyOf("unknown_name", "unknown_name_near"));
  EXPECT_EQ(message.at("values").at(0), "effector");
  EXPECT_EQ(message.at("values").at(1), "tail");
  EXPECT_EQ(shigusa_failure(nullptr), SHIGUSA_INVALID_ARGUMENT);
}

// Forward kinematics of the nodes, from the table alone.
TEST(CInterface, NodesBringTheHandToItsGoal) {
  const Character human = character_of(R"("human")");
  const Json nodes = Json::parse(text_of(shigusa_character_describe, human.get())).at("nodes");
  const Outcome result = outcome_of(human.get(), kLowReach);
  const Json summary = json_of(result.get());
  for (int32_t k = 1; k <= shigusa_result_candidates(result.get()); ++k) {
    const Table moves = table_of(result.get(), k, SHIGUSA_NODE_TRANSLATIONS);
    const Table turns = table_of(result.get(), k, SHIGUSA_NODE_ROTATIONS);
    const size_t last = moves.frames - 1;
    const Json& reached = summary.at("candidates").at(static_cast<size_t>(k - 1)).at("reached");
    // from the hand up to the root, p = translation + rotation · p
    double p[3] = {0, 0, 0};
    int node = -1;
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (nodes.at(i).at("name") == reached.at(0).at("joint")) node = static_cast<int>(i);
    }
    ASSERT_GE(node, 0);
    for (; node >= 0; node = nodes.at(static_cast<size_t>(node)).at("parent")) {
      const auto n = static_cast<size_t>(node);
      const double x = turns.at(last, 4 * n), y = turns.at(last, 4 * n + 1);
      const double z = turns.at(last, 4 * n + 2), w = turns.at(last, 4 * n + 3);
      const double c[3] = {y * p[2] - z * p[1] + w * p[0], z * p[0] - x * p[2] + w * p[1],
                           x * p[1] - y * p[0] + w * p[2]};
      const double r[3] = {p[0] + 2 * (y * c[2] - z * c[1]), p[1] + 2 * (z * c[0] - x * c[2]),
                           p[2] + 2 * (x * c[1] - y * c[0])};
      for (size_t a = 0; a < 3; ++a) p[a] = r[a] + moves.at(last, 3 * n + a);
    }
    const double goal[3] = {-0.2, 0.9, 0.5};
    for (size_t a = 0; a < 3; ++a) EXPECT_NEAR(p[a], goal[a], 1e-3) << k;
  }
}

TEST(CInterface, SeriesAreOfOneLength) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(human.get(), kLowReach);
  const Table time = table_of(result.get(), 1, SHIGUSA_TIME);
  const Json candidate = json_of(result.get()).at("candidates").at(0);
  EXPECT_EQ(time.frames, candidate.at("frames"));
  EXPECT_NEAR(time.values.back(), candidate.at("duration_s"), 1e-9);
  for (const shigusa_series series : {SHIGUSA_ANGLES, SHIGUSA_TORQUES}) {
    EXPECT_EQ(table_of(result.get(), 1, series).columns, 45U);
  }
  EXPECT_EQ(table_of(result.get(), 1, SHIGUSA_CENTRE_OF_MASS).columns, 3U);
  EXPECT_EQ(table_of(result.get(), 1, SHIGUSA_EFFECTORS).columns, 3U);
  const Table support = table_of(result.get(), 1, SHIGUSA_SUPPORT);
  double least = 1e9;
  for (size_t f = 0; f < support.frames; ++f) least = std::fmin(least, support.at(f, 0));
  EXPECT_NEAR(1e3 * least, candidate.at("support").at("centre_of_mass").at("least_mm"), 1e-6);
}

TEST(CInterface, TheFloorBearsTheLoadInTheHand) {
  const Outcome result = outcome_of(nullptr, R"({"seed": 3, "evaluations": 200, "goals": [
      {"effector": "right_hand", "position_m": [-0.2, 1.1, 0.5], "load_kg": 6}]})");
  const Table support = table_of(result.get(), 1, SHIGUSA_SUPPORT);
  const Json told = json_of(result.get()).at("candidates").at(0).at("support");
  for (const size_t column : {size_t{0}, size_t{1}}) {
    double least = 1e9;
    for (size_t f = 0; f < support.frames; ++f) least = std::fmin(least, support.at(f, column));
    const Json& margin = told.at(column == 0 ? "centre_of_mass" : "pressure");
    EXPECT_NEAR(1e3 * least, margin.at("least_mm").get<double>(), 1e-6);
  }
}

TEST(CInterface, AnEditedParameterKeepsTheHandOnItsGoal) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(human.get(), kLowReach);
  const Json list = Json::parse(text_of(shigusa_result_parameters, result.get(), 1));
  EXPECT_EQ(list.at(0).at("name"), "squat_deg");
  for (const Json& each : list) {
    EXPECT_LE(each.at("low"), each.at("value")) << each;
    EXPECT_LE(each.at("value"), each.at("high")) << each;
  }
  shigusa_result* edited = nullptr;
  ASSERT_EQ(
      shigusa_replay(result.get(), 1, R"(["squat_deg=80", "right_elbow.locked=true"])", &edited),
      SHIGUSA_OK)
      << shigusa_message();
  const Outcome held(edited);
  const Json told = json_of(edited).at("candidates").at(0);
  EXPECT_LT(told.at("reached").at(0).at("error_mm"), 1.0);
  const Json after = Json::parse(text_of(shigusa_result_parameters, edited, 1));
  EXPECT_NEAR(after.at(0).at("value"), 80.0, 1e-9);
  EXPECT_NE(text_of(shigusa_result_export, result.get(), 1, "bvh"),
            text_of(shigusa_result_export, edited, 1, "bvh"));
}

TEST(CInterface, AResultComesBackFromItsJson) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(human.get(), kLowReach);
  const std::string summary = text_of(shigusa_result_describe, result.get());
  shigusa_result* restored = nullptr;
  ASSERT_EQ(shigusa_restore(nullptr, summary.c_str(), &restored), SHIGUSA_OK) << shigusa_message();
  const Outcome held(restored);
  ASSERT_EQ(shigusa_result_candidates(restored), shigusa_result_candidates(result.get()));
  for (int32_t k = 1; k <= shigusa_result_candidates(restored); ++k) {
    EXPECT_EQ(text_of(shigusa_result_export, result.get(), k, "bvh"),
              text_of(shigusa_result_export, restored, k, "bvh"));
  }
  shigusa_result* image = nullptr;
  ASSERT_EQ(shigusa_mirror(restored, &image), SHIGUSA_OK) << shigusa_message();
  const Outcome mirrored(image);
  EXPECT_EQ(json_of(image).at("goals").at(0).at("effector"), "left_hand");
}

TEST(CInterface, FilesLeaveAtTheRateThatIsAskedFor) {
  const std::string file = shigusa::testing_support::person_gltf().dump();
  const Character person = character_of(R"({"source": "person.gltf"})", file);
  const Outcome result = outcome_of(
      person.get(), R"({"goals": [{"effector": "right_hand", "position_m": [-0.2, 1.1, 0.35]}]})");
  const auto written = [&](const char* format, const char* options) {
    return text_of(shigusa_result_export_with, result.get(), 1, format, options);
  };
  EXPECT_THAT(written("bvh", R"({"fps": 24})"), HasSubstr("Frame Time: 0.041666666666666664"));
  EXPECT_THAT(written("bvh", R"({"fps": 29.97})"), HasSubstr("Frame Time: 0.033366700033366704"));
  EXPECT_EQ(written("bvh", nullptr), text_of(shigusa_result_export, result.get(), 1, "bvh"));
  EXPECT_EQ(written("glb", "{}"), written("glb", R"({"fps": 60})"));
  EXPECT_LT(written("glb", R"({"fps": 24})").size(), written("glb", R"({"fps": 120})").size());
  EXPECT_LT(text_of(shigusa_result_export_with, result.get(), 0, "glb", R"({"fps": 24})").size(),
            text_of(shigusa_result_export, result.get(), 0, "glb").size());
  shigusa_bytes* bytes = nullptr;
  for (const char* options :
       {R"({"fps": 0})", R"({"fps": 241})", R"({"fps": "24"})", R"({"rate": 24})", "24", "{"}) {
    EXPECT_EQ(shigusa_result_export_with(result.get(), 1, "bvh", options, &bytes), SHIGUSA_PARSE)
        << options;
  }
  EXPECT_EQ(bytes, nullptr);
}

TEST(CInterface, NodesMoveAtTheRateThatIsAskedFor) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(human.get(), kLowReach);
  shigusa_bytes* bytes = nullptr;
  size_t frames = 0;
  size_t columns = 0;
  const auto at = [&](shigusa_series series, double fps) {
    EXPECT_EQ(shigusa_result_series_at(result.get(), 1, series, fps, &bytes, &frames, &columns),
              SHIGUSA_OK)
        << shigusa_message();
    std::vector<double> values(frames * columns);
    EXPECT_EQ(shigusa_bytes_size(bytes), values.size() * sizeof(double));
    std::memcpy(values.data(), shigusa_bytes_data(bytes), shigusa_bytes_size(bytes));
    shigusa_bytes_free(bytes);
    return values;
  };
  const std::vector<double> times = at(SHIGUSA_TIME, 25.0);
  EXPECT_EQ(times.at(10), 10 / 25.0);
  EXPECT_GE(times.back(), json_of(result.get()).at("candidates").at(0).at("duration_s"));
  const std::vector<double> turns = at(SHIGUSA_NODE_ROTATIONS, 25.0);
  const Table own = table_of(result.get(), 1, SHIGUSA_NODE_ROTATIONS);
  ASSERT_EQ(columns, own.columns);
  EXPECT_EQ(frames, times.size());
  for (size_t c = 0; c < columns; ++c) {
    EXPECT_EQ(turns[c], own.at(0, c));
    EXPECT_EQ(turns[(frames - 1) * columns + c], own.at(own.frames - 1, c));
  }
  EXPECT_EQ(shigusa_result_series_at(result.get(), 1, SHIGUSA_TIME, 0.0, &bytes, &frames, &columns),
            SHIGUSA_INVALID_ARGUMENT);
}

TEST(CInterface, ARestoredResultCanBeStopped) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(human.get(), kLowReach);
  const std::string summary = text_of(shigusa_result_describe, result.get());
  ASSERT_GT(shigusa_result_candidates(result.get()), 2);
  int32_t done = 0;
  const auto stop_at_two = [](void* user, double, int32_t evaluations, double) -> int32_t {
    *static_cast<int32_t*>(user) = evaluations;
    return evaluations == 2 ? 1 : 0;
  };
  const shigusa_watch watch{stop_at_two, &done};
  shigusa_result* restored = nullptr;
  EXPECT_EQ(shigusa_restore_watched(human.get(), summary.c_str(), &watch, &restored),
            SHIGUSA_CANCELLED);
  EXPECT_THAT(shigusa_message(), HasSubstr("stopped after 2 of "));
  EXPECT_EQ(done, 2);
  EXPECT_EQ(restored, nullptr);
}

// The layered presets have parameters of their own, each assigned by its listed name.
TEST(CInterface, EveryParameterOfEveryPresetCanBeSetByItsName) {
  const Character human = character_of(R"("human")");
  for (const char* preset : {"flat", "paper", "human"}) {
    Json task = Json::parse(kLowReach);
    task["preset"] = preset;
    task["candidates"] = 1;
    const Outcome result = outcome_of(human.get(), task.dump());
    ASSERT_EQ(shigusa_result_candidates(result.get()), 1);
    const Json list = Json::parse(text_of(shigusa_result_parameters, result.get(), 1));
    Json assignments = Json::array();
    for (const Json& each : list) {
      const std::string name = each.at("name");
      assignments.push_back(name + "=" + each.at("value").dump());
      if (each.at("locked") == true) {
        assignments.push_back(name.substr(0, name.rfind('.')) + ".locked=true");
      }
    }
    shigusa_result* again = nullptr;
    ASSERT_EQ(shigusa_replay(result.get(), 1, assignments.dump().c_str(), &again), SHIGUSA_OK)
        << preset << ": " << shigusa_message();
    const Outcome held(again);
    const Json after = Json::parse(text_of(shigusa_result_parameters, again, 1));
    ASSERT_EQ(after.size(), list.size());
    for (size_t i = 0; i < list.size(); ++i) {
      EXPECT_EQ(after[i].at("name"), list[i].at("name"));
      EXPECT_NEAR(after[i].at("value"), list[i].at("value"), 1e-9) << list[i];
      EXPECT_EQ(after[i].at("locked"), list[i].at("locked")) << list[i];
    }
  }
}

TEST(CInterface, ReportsProgressAndStopsWhenTold) {
  const Character human = character_of(R"("human")");
  struct Seen {
    int calls = 0;
    int stop_at = 0;
    int32_t evaluations = 0;
  };
  const auto report = [](void* user, double fraction, int32_t evaluations, double) -> int32_t {
    auto& seen = *static_cast<Seen*>(user);
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    seen.evaluations = evaluations;
    return ++seen.calls == seen.stop_at ? 1 : 0;
  };
  const auto run = [&](Seen& seen) {
    const shigusa_watch watch{report, &seen};
    shigusa_result* made = nullptr;
    EXPECT_EQ(shigusa_generate(human.get(), kLowReach, 1, &watch, &made), SHIGUSA_OK);
    return Outcome(made);
  };
  Seen all;
  (void)run(all);
  Seen stopped{.stop_at = 3};
  const Outcome early = run(stopped);
  EXPECT_GT(all.calls, 6);
  EXPECT_LT(stopped.evaluations, all.evaluations);
  EXPECT_EQ(json_of(early.get()).at("search_detail").at("end"), "cancelled");
}

TEST(CInterface, GivesTheSameBytesFromSeveralThreads) {
  std::vector<std::string> files(3);
  std::vector<std::thread> threads;
  for (std::string& file : files) {
    threads.emplace_back([&file] {
      const Character human = character_of(R"("human")");
      file = text_of(shigusa_result_export, outcome_of(human.get(), kLowReach).get(), 1, "csv");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(files[0], files[1]);
  EXPECT_EQ(files[0], files[2]);
}

TEST(CInterface, ScoresAClip) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(human.get(), kLowReach);
  const std::string bvh = text_of(shigusa_result_export, result.get(), 1, "bvh");
  const std::string json = text_of(shigusa_score_clip, "reach.bvh", bvh.data(), bvh.size(),
                                   R"({"criteria": "paper", "smoothed_hz": 0})");
  EXPECT_TRUE(Json::parse(json).at("criteria").contains("torque"));
}

TEST(CInterface, RefusesWithACodeAndASentence) {
  const Character human = character_of(R"("human")");
  shigusa_character* character = nullptr;
  shigusa_result* result = nullptr;
  shigusa_bytes* bytes = nullptr;
  const auto refused = [](shigusa_status status, shigusa_status expected, const char* words) {
    EXPECT_EQ(status, expected) << shigusa_message();
    EXPECT_THAT(shigusa_message(), HasSubstr(words));
  };
  refused(shigusa_character_create(nullptr, nullptr, 0, &character), SHIGUSA_INVALID_ARGUMENT,
          "spec is null");
  refused(shigusa_character_create("{", nullptr, 0, &character), SHIGUSA_PARSE, "character");
  refused(shigusa_character_create(R"({"source": "hman"})", nullptr, 0, &character), SHIGUSA_PARSE,
          "human");
  refused(shigusa_character_create(R"({"source": "hero.glb"})", nullptr, 0, &character),
          SHIGUSA_INVALID_ARGUMENT, "bytes");
  refused(shigusa_character_create(R"({"source": "hero.glb"})", "no glTF", 7, &character),
          SHIGUSA_PARSE, "hero.glb");
  refused(shigusa_character_create(R"("human")", "x", 1, &character), SHIGUSA_INVALID_ARGUMENT,
          "needs no file");
  refused(shigusa_generate(nullptr, "{}", 0, nullptr, &result), SHIGUSA_INVALID_ARGUMENT, "goal");
  refused(shigusa_generate(nullptr, R"({"character": "/etc/person.bvh"})", 0, nullptr, &result),
          SHIGUSA_INVALID_ARGUMENT, "by its bytes");
  refused(shigusa_generate(human.get(), kLowReach, -1, nullptr, &result), SHIGUSA_INVALID_ARGUMENT,
          "threads");
  refused(shigusa_restore(nullptr, "{}", &result), SHIGUSA_PARSE, "not a result");
  EXPECT_EQ(character, nullptr);
  EXPECT_EQ(result, nullptr);

  const Outcome made = outcome_of(human.get(), kLowReach);
  refused(shigusa_replay(made.get(), 9, nullptr, &result), SHIGUSA_INVALID_ARGUMENT,
          "candidate 9 does not exist");
  refused(shigusa_replay(made.get(), 1, R"(["squatt_deg=3"])", &result), SHIGUSA_NOT_FOUND,
          "squat");
  refused(shigusa_replay(made.get(), 1, R"("squat_deg=3")", &result), SHIGUSA_PARSE, "list");
  refused(shigusa_result_export(made.get(), 1, "fbx", &bytes), SHIGUSA_INVALID_ARGUMENT, "fbx");
  refused(shigusa_result_export(made.get(), 1, "vrma", &bytes), SHIGUSA_INVALID_ARGUMENT, "vrma");
  refused(shigusa_score_clip("x.bvh", "x", 1, nullptr, &bytes), SHIGUSA_PARSE, "x.bvh");
  const double* values = nullptr;
  size_t size = 0;
  refused(shigusa_result_series(made.get(), 1, 99, &values, &size, &size), SHIGUSA_INVALID_ARGUMENT,
          "series 99");
  EXPECT_EQ(bytes, nullptr);
}

TEST(CInterface, AGoalOutOfReachIsNoFailure) {
  const Character human = character_of(R"("human")");
  const Outcome result = outcome_of(
      human.get(), R"({"goals": [{"effector": "right_hand", "position_m": [0, 3, 0]}]})");
  EXPECT_EQ(json_of(result.get()).at("status"), "unreachable");
  EXPECT_GT(json_of(result.get()).at("remaining_mm"), 100.0);
}

TEST(CInterface, FreesNothing) {
  shigusa_character_free(nullptr);
  shigusa_result_free(nullptr);
  shigusa_bytes_free(nullptr);
  EXPECT_EQ(shigusa_result_candidates(nullptr), 0);
  EXPECT_EQ(shigusa_bytes_size(nullptr), 0U);
}

}  // namespace
}  // namespace shigusa_c_test
