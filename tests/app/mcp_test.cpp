// SPDX-License-Identifier: MIT
// The streams of `shigusa mcp`: lines of any length, calls that are cancelled, and the end.
#include <gmock/gmock.h>

#include "support/assistant_calls.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::StartsWith;
using Words = std::vector<std::string>;

class AssistantsDoor : public testing::Test {
 protected:
  // The program's lines after these; the last of them may lack its end.
  std::vector<Json> lines_after(const std::string& input, const Words& options = {}) {
    Words words{"mcp"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramRun run =
        run_shigusa(words, {.folder = work_.path(), .input = work_.put("input", input)});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    std::vector<Json> lines;
    for (std::size_t at = 0; at < run.out.size();) {
      const std::size_t end = run.out.find('\n', at);
      lines.push_back(Json::parse(run.out.substr(at, end - at)));
      at = end + 1;
    }
    return lines;
  }

  WorkFolder work_;
};

TEST_F(AssistantsDoor, AnswersUntilTheInputEnds) {
  const std::vector<Json> lines =
      lines_after(request(1, "initialize").dump() + "\n\n" +
                  call(2, "reach", {{"task", kLowTask}, {"picture", "png"}}).dump());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].at("result").at("serverInfo").at("version"), "");
  const Json& content = lines[1].at("result").at("content");
  // a build or a machine without librsvg says so
  if (lines[1].at("result").at("isError")) {
    EXPECT_THAT(content.at(0).at("text").get<std::string>(), HasSubstr("librsvg"));
  } else {
    EXPECT_THAT(content.at(0).at("text").get<std::string>(), StartsWith("r1: reached"));
    EXPECT_THAT(content.at(1).at("data").get<std::string>(), StartsWith("iVBORw0KGgo"));
  }
}

TEST_F(AssistantsDoor, WithoutInputItEnds) {
  const ProgramRun run = run_shigusa({"mcp"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(AssistantsDoor, AFolderThatIsNoneIsRefused) {
  const ProgramRun run = run_shigusa({"mcp", "--folder", "nowhere"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("--folder nowhere: is no folder"));
}

TEST_F(AssistantsDoor, AHugeLineIsRefusedAndTheNextAnswered) {
  const std::vector<Json> lines =
      lines_after(std::string(40 << 20, '[') + "\n" + request(1, "ping").dump());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].at("error").at("code"), -32600);
  EXPECT_EQ(lines[1].at("id"), 1);
}

TEST_F(AssistantsDoor, ASearchTellsItsProgressAndCanBeCancelled) {
  Json endless = kLowTask;
  endless["evaluations"] = 100'000'000;
  Json told = call(1, "reach", {{"task", kLowTask}});
  told["params"]["_meta"] = {{"progressToken", "p"}};
  const Json cancel{
      {"jsonrpc", "2.0"}, {"method", "notifications/cancelled"}, {"params", {{"requestId", 2}}}};
  std::string input;
  for (const Json& message :
       {told, call(2, "reach", {{"task", endless}}), cancel, request(3, "ping")}) {
    input += message.dump() + "\n";
  }
  double before = 0.0;
  Words ids;
  for (const Json& line : lines_after(input)) {
    if (line.contains("id")) {
      ids.push_back(line["id"].dump());
      continue;
    }
    EXPECT_EQ(line.at("method"), "notifications/progress");
    EXPECT_EQ(line.at("params").at("progressToken"), "p");
    EXPECT_GT(line.at("params").at("progress").get<double>(), before);
    before = line.at("params").at("progress");
  }
  EXPECT_GT(before, 0.0);
  EXPECT_EQ(ids, (Words{"1", "3"}));
}

}  // namespace
}  // namespace shigusa
