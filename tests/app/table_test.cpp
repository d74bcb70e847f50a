// SPDX-License-Identifier: MIT
// The tables of reach, edit and score in a terminal.
#include <algorithm>

#include "app/result_checks.hpp"
#include "support/person_file.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

constexpr std::size_t kWidth = 100;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Number of characters, each of which may have several bytes in UTF-8.
std::size_t width_of(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

void expect_fits(const std::string& text) {
  for (const std::string& line : lines_of(text)) EXPECT_LE(width_of(line), kWidth) << line;
}

// The line with that beginning, or an empty one.
std::string line_with(const std::string& text, const std::string& beginning) {
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with(beginning)) return line;
  }
  return {};
}

class Table : public testing::Test {
 protected:
  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }
  ProgramRun reach(const Words& more) {
    Words call{"reach", "--formats", "", "--out", "out", "--evaluations", "160"};
    call.insert(call.end(), more.begin(), more.end());
    return run(call);
  }

  WorkFolder work_;
};

TEST_F(Table, FitsAHundredCharacters) {
  const Words low{"--goal", "right_hand=0.25,0.55,0.5"};
  const Words calls[] = {
      {"--preset", "paper", "--character", "half_body"},
      {"--preset", "flat"},
      {"--preset", "layers", "--character", "full_body"},
      {"--preset", "human"},
      {"--goal", "left_hand=0.2,0.9,0.45", "--load", "right_hand=5"},
      {"--pareto", "--candidates", "20"},
      {"--preset", "paper", "--character", "full_body", "--candidates", "30"},
      {"--obstacle", "table=0,0.2,0.6,1,0.4,0.4"},
  };
  for (const Words& more : calls) {
    Words call = low;
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun done = reach(call);
    EXPECT_THAT(done.exit_code, delivered()) << done.err;
    expect_fits(done.out);
  }
  for (const Words& goals :
       {Words{"--goal", "left_foot=0.2,0.3,0.4"}, Words{"--goal", "right_hand=60,40,-90"},
        Words{"--contacts", "right_foot"}, Words{"--heels", "--goal", "head=0,1.75,0.1"}}) {
    expect_fits(reach(goals).out);
  }
}

TEST_F(Table, TellsGoalsInWords) {
  EXPECT_THAT(reach({"--goal", "right_hand=-0.2,1.1,0.4"}).out,
              testing::StartsWith("reached: human, right hand to 0.2 m right, 1.1 m up, 0.4 m "
                                  "ahead\n"));
  EXPECT_THAT(reach({"--contacts", "right_foot"}).out,
              HasSubstr(": human, standing on the right foot\n"));
}

// Each criterion has a row, or is listed among those that are 0 for all.
TEST_F(Table, LeavesOutNoCriterion) {
  const ProgramRun done = reach({"--goal", "right_hand=-0.2,1.1,0.4"});
  const std::string zeros = done.out.substr(done.out.find("0 for all: "));
  const StoredRun stored(work_, "out");
  for (const auto& [name, unused] : stored.candidate(1).at("criteria").items()) {
    double largest = 0.0;
    for (const Json& candidate : stored.summary().at("candidates")) {
      largest = std::max(largest, candidate.at("criteria").at(name).get<double>());
    }
    const std::string row = line_with(done.out, name + " ");
    // as printed, with four digits
    EXPECT_EQ(row.empty(), largest < 5e-5) << name;
    EXPECT_EQ(zeros.find(name) != zeros.npos, row.empty()) << name;
  }
}

TEST_F(Table, HasNoColumnThatIsZeroForAll) {
  const ProgramRun done = reach({"--goal", "right_hand=-0.2,1.1,0.4"});
  const std::string zeros = done.out.substr(done.out.find("0 for all: "));
  EXPECT_THAT(zeros, HasSubstr("over its limit"));
  EXPECT_THAT(line_with(done.out, "rank"), AllOf(HasSubstr("verdict"), Not(HasSubstr("limit"))));
  EXPECT_THAT(done.out, Not(testing::ContainsRegex("\njoint_range +0.25 +0.0000")));
}

TEST_F(Table, OfAnEditHasOneColumn) {
  ASSERT_EQ(reach({"--goal", "right_hand=-0.2,1.1,0.4"}).exit_code, 0);
  const ProgramRun edited = run({"edit", "out", "--set", "right_elbow.weight=3"});
  ASSERT_THAT(edited.exit_code, delivered()) << edited.err;
  expect_fits(edited.out);
  EXPECT_THAT(line_with(edited.out, "penalty"), testing::EndsWith(" 1"));
}

TEST_F(Table, OfAScoreFitsToo) {
  work_.put("person.bvh", person_bvh());
  const ProgramRun scored = run({"score", "person.bvh"});
  ASSERT_EQ(scored.exit_code, 0) << scored.err;
  expect_fits(scored.out);
  EXPECT_THAT(scored.out, HasSubstr("\npenalty, 0 to 1 "));
}

}  // namespace
}  // namespace shigusa
