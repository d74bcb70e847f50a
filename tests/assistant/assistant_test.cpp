// SPDX-License-Identifier: MIT
// A scripted client of the tools: a message a line, and what is answered.
#include "assistant/assistant.hpp"

#include <gmock/gmock.h>

#include <map>

#include "formats/base64.hpp"
#include "support/assistant_calls.hpp"
#include "support/gltf_file.hpp"
#include "support/person_file.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

class Assistants : public testing::Test {
 protected:
  // The answers to lines.
  std::vector<Json> lines_after(const Words& lines, AssistantSettings settings = {}) {
    Assistant assistant(std::move(settings), {.version = "1.2.3"});
    std::vector<Json> all;
    for (const std::string& line : lines) {
      const auto answer = assistant.answer(line);
      if (!answer) continue;
      EXPECT_EQ(answer->find('\n'), answer->npos);
      all.push_back(Json::parse(*answer));
    }
    return all;
  }

  // The answers to messages, by their numbers.
  std::map<int, Json> answers(const std::vector<Json>& messages, AssistantSettings settings = {}) {
    Words lines;
    for (const Json& message : messages) lines.push_back(message.dump());
    std::map<int, Json> all;
    for (const Json& line : lines_after(lines, std::move(settings))) {
      EXPECT_EQ(line.at("jsonrpc"), "2.0");
      all[line.at("id").get<int>()] = line;
    }
    return all;
  }

  static std::string text_of(const Json& answer) {
    return answer.at("result").at("content").at(0).at("text");
  }
  static bool is_refusal(const Json& answer) { return answer.at("result").at("isError"); }
};

TEST_F(Assistants, TellsItsToolsWithTheSchemaOfTasks) {
  const auto all = answers({request(1, "initialize", {{"protocolVersion", "2025-06-18"}}),
                            {{"jsonrpc", "2.0"}, {"method", "notifications/initialized"}},
                            request(2, "tools/list"),
                            request(3, "ping"),
                            request(4, "initialize", {{"protocolVersion", "1999-01-01"}})});
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all.at(1).at("result").at("protocolVersion"), "2025-06-18");
  EXPECT_EQ(all.at(4).at("result").at("protocolVersion"), "2025-11-25");
  EXPECT_EQ(all.at(1).at("result").at("serverInfo").at("version"), "1.2.3");
  EXPECT_EQ(all.at(3).at("result"), Json::object());
  Words names;
  for (const Json& tool : all.at(2).at("result").at("tools")) {
    names.push_back(tool.at("name"));
    EXPECT_EQ(tool.at("inputSchema").at("type"), "object");
  }
  EXPECT_EQ(names, (Words{"reach", "edit", "score", "limit", "body"}));
  const Json& schema = all.at(2).at("result").at("tools").at(0).at("inputSchema");
  const Json& goals = schema.at("properties").at("task").at("properties").at("goals");
  EXPECT_EQ(goals.at("items").at("$ref"), "#/$defs/goal");
  EXPECT_TRUE(schema.at("$defs").contains("goal"));
}

TEST_F(Assistants, ReachesAndEditsWithPictures) {
  const auto all =
      answers({call(1, "reach", {{"task", kLowTask}, {"picture", "svg"}}),
               call(2, "edit", {{"result", "r1"}}),
               call(3, "edit", {{"result", "r1"}, {"candidate", 2}, {"set", {"squat_deg=50"}}}),
               call(4, "edit", {{"result", "r1"}, {"picture", "png"}})},
              {.from_svg = [](const std::string& svg, FileFormat) -> Result<std::string> {
                EXPECT_THAT(svg, HasSubstr("<svg"));
                return "a picture";
              }});
  EXPECT_THAT(text_of(all.at(1)),
              AllOf(StartsWith("r1: reached; human, right hand to"),
                    HasSubstr("candidate 1: possible, score 0."), HasSubstr("ends as")));
  const Json& picture = all.at(1).at("result").at("content").at(1);
  EXPECT_EQ(picture.at("resource").at("mimeType"), "image/svg+xml");
  EXPECT_THAT(picture.at("resource").at("text").get<std::string>(), HasSubstr("<svg"));
  EXPECT_THAT(text_of(all.at(2)), AllOf(StartsWith("r2: "), HasSubstr("squat_deg=")));
  EXPECT_THAT(text_of(all.at(3)), StartsWith("r3: reached"));
  EXPECT_NE(text_of(all.at(3)).substr(3), text_of(all.at(2)).substr(3));
  const Json& image = all.at(4).at("result").at("content").at(1);
  EXPECT_EQ(image.at("mimeType"), "image/png");
  EXPECT_EQ(from_base64(image.at("data").get<std::string>()), "a picture");
}

TEST_F(Assistants, ScoresLimitsAndDescribes) {
  Json heavy = kLowTask;
  heavy["goals"][0]["load_kg"] = 5;
  const auto all =
      answers({call(1, "body", {{"character", {{"source", "human"}, {"stature_m", 1.6}}}}),
               call(2, "score", {{"text", person_bvh()}, {"options", {{"criteria", "paper"}}}}),
               call(3, "score", {{"base64", to_base64(person_bvh())}}),
               call(4, "limit", {{"task", heavy}, {"of", "load"}, {"seeds", 1}, {"bound", 30}})});
  EXPECT_THAT(text_of(all.at(1)), AllOf(StartsWith("human: 1.600 m"), HasSubstr("right_hand -0."),
                                        HasSubstr("right_knee.flexion 0 to")));
  EXPECT_THAT(text_of(all.at(2)), AllOf(HasSubstr("score "), HasSubstr("joint_range: ")));
  EXPECT_FALSE(is_refusal(all.at(3)));
  EXPECT_THAT(text_of(all.at(4)), AllOf(StartsWith("heaviest load: "), HasSubstr(" kg")));
}

TEST_F(Assistants, AWrongCallIsAnsweredInWords) {
  const struct {
    const char* tool;
    Json arguments;
    const char* words;
  } calls[]{
      {"reach", Json::object(), "task"},
      {"reach", {{"task", {{"gaols", 1}}}}, "did you mean 'goals'"},
      {"reach", {{"task", Json::object()}}, "no goal"},
      {"reach", {{"task", kLowTask}, {"picture", "gif"}}, "svg"},
      {"reach", {{"task", {{"character", "hero.glb"}}}}, "--folder"},
      {"reach", {{"task", {{"character", "human"}, {"scene", "/etc/passwd"}}}}, "--folder"},
      {"edit", {{"result", "r9"}}, "'r9'"},
      {"edit", {{"result", "r9"}, {"set", "squat_deg=3"}}, "set"},
      {"score", Json::object(), "text, base64 and file"},
      {"score", {{"text", "no clip"}}, "HIERARCHY"},
      {"score", {{"base64", "!"}}, "base64"},
      {"score", {{"file", "lift.bvh"}}, "--folder"},
      {"limit", {{"task", kLowTask}, {"of", "speed"}}, "'speed'"},
      {"body", {{"character", "hero.glb"}}, "--folder"},
  };
  std::vector<Json> messages;
  for (const auto& each : calls) {
    messages.push_back(call(static_cast<int>(messages.size()), each.tool, each.arguments));
  }
  const auto all = answers(messages);
  for (std::size_t k = 0; k < std::size(calls); ++k) {
    const Json& answer = all.at(static_cast<int>(k));
    ASSERT_TRUE(answer.contains("result")) << answer;
    EXPECT_TRUE(is_refusal(answer)) << answer;
    EXPECT_THAT(text_of(answer), HasSubstr(calls[k].words));
  }
}

TEST_F(Assistants, FaultsOfTheProtocolHaveTheirNumbers) {
  const std::pair<std::string, int> lines[]{
      {"{\"jsonrpc\": ", -32700},
      {std::string(100, '[') + std::string(100, ']'), -32700},
      {"\xff\xfe", -32700},
      {"17", -32600},
      {"[]", -32600},
      {R"({"id": 1, "method": "ping"})", -32600},
      {R"({"jsonrpc": "2.0", "id": null, "method": "ping"})", -32600},
      {R"({"jsonrpc": "2.0", "id": 1})", -32600},
      {R"({"jsonrpc": "2.0", "id": 1, "method": "resources/list"})", -32601},
      {R"({"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": [1]})", -32602},
      {R"({"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": "raech"}})",
       -32602},
  };
  Words sent;
  for (const auto& [line, number] : lines) sent.push_back(line);
  const std::vector<Json> answered = lines_after(sent);
  ASSERT_EQ(answered.size(), std::size(lines));
  for (std::size_t k = 0; k < answered.size(); ++k) {
    EXPECT_EQ(answered[k].at("error").at("code"), lines[k].second) << lines[k].first;
    EXPECT_NE(answered[k].at("error").at("message"), "");
  }
  EXPECT_THAT(answered.back().dump(), HasSubstr("did you mean 'reach'"));
}

TEST_F(Assistants, ABatchIsAnsweredInOneLine) {
  const Json batch = Json::array({request(1, "ping"), request(2, "ping")});
  const std::vector<Json> lines = lines_after({batch.dump()});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 2u);
}

TEST_F(Assistants, FilesAreReadBelowTheFolderAlone) {
  const WorkFolder work;
  work.put("files/person.gltf", person_gltf().dump());
  work.put("files/lift.bvh", person_bvh());
  work.put("secret.bvh", person_bvh());
  std::filesystem::create_symlink("../secret.bvh", work / "files/link.bvh");
  Json task = kLowTask;
  task["character"] = "person.gltf";
  const auto all =
      answers({call(1, "reach", {{"task", task}}), call(2, "score", {{"file", "lift.bvh"}}),
               call(3, "score", {{"file", "../secret.bvh"}}),
               call(4, "score", {{"file", (work / "secret.bvh").string()}}),
               call(5, "score", {{"file", "link.bvh"}}), call(6, "edit", {{"result", "r1"}})},
              {.folder = work / "files"});
  EXPECT_THAT(text_of(all.at(1)), StartsWith("r1: "));
  EXPECT_FALSE(is_refusal(all.at(2))) << text_of(all.at(2));
  for (const int id : {3, 4, 5}) {
    EXPECT_TRUE(is_refusal(all.at(id)));
    EXPECT_THAT(text_of(all.at(id)), HasSubstr("not below the server's folder"));
  }
  EXPECT_FALSE(is_refusal(all.at(6))) << text_of(all.at(6));
}

TEST_F(Assistants, TheOldestResultIsForgotten) {
  std::vector<Json> messages{call(1, "reach", {{"task", kLowTask}})};
  for (int id = 2; id <= 17; ++id) messages.push_back(call(id, "edit", {{"result", "r1"}}));
  messages.push_back(call(18, "edit", {{"result", "r1"}}));
  messages.push_back(call(19, "edit", {{"result", "r2"}}));
  const auto all = answers(messages);
  EXPECT_FALSE(is_refusal(all.at(17)));
  EXPECT_TRUE(is_refusal(all.at(18)));
  EXPECT_FALSE(is_refusal(all.at(19)));
}

TEST_F(Assistants, ATooLongLineOrBatchIsRefused) {
  Json batch = Json::array();
  for (int id = 0; id < 33; ++id) batch.push_back(request(id, "ping"));
  for (const Json& answer :
       lines_after({std::string(kAssistantLineMost + 1, ' ') + "x", batch.dump()})) {
    EXPECT_EQ(answer.at("error").at("code"), -32600);
  }
}

// A line that cancels comes while answer() is at the call.
TEST_F(Assistants, ACancelledCallHasNoAnswer) {
  Assistant* session = nullptr;
  const auto cancel = [](int id) {
    return Json{
        {"jsonrpc", "2.0"}, {"method", "notifications/cancelled"}, {"params", {{"requestId", id}}}}
        .dump();
  };
  bool cancels = true;
  Assistant assistant({}, {.stops = [&] {
                        EXPECT_FALSE(session->cancel_by(cancel(2)));
                        EXPECT_FALSE(session->cancel_by("{\"method\": \"ping\"}"));
                        EXPECT_EQ(cancels && session->cancel_by(cancel(1)), cancels);
                        return !cancels;
                      }});
  session = &assistant;
  Json endless = kLowTask;
  endless["evaluations"] = 100'000'000;
  EXPECT_EQ(assistant.answer(call(1, "reach", {{"task", endless}}).dump()), std::nullopt);
  EXPECT_FALSE(assistant.cancel_by(cancel(1)));
  cancels = false;
  const auto stopped = assistant.answer(call(1, "reach", {{"task", endless}}).dump());
  ASSERT_TRUE(stopped);
  EXPECT_THAT(text_of(Json::parse(*stopped)), HasSubstr("stopped early"));
}

}  // namespace
}  // namespace shigusa
