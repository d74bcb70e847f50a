// SPDX-License-Identifier: MIT
// One page and one picture of results, on the command line.
#include <cstdlib>

#include "app/result_checks.hpp"
#include "formats/xml.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

// The text between two others, first occurrence after `from`.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    std::size_t from = 0) {
  const std::size_t at = text.find(begin, from);
  SHG_CHECK(at != text.npos, "a text " + begin);
  const std::size_t start = at + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

// The page without the text of its styles and scripts, which is no markup.
std::string markup_of(std::string page) {
  for (const std::string tag : {"style", "script"}) {
    for (std::size_t at = page.find("<" + tag); at != page.npos; at = page.find("<" + tag, at)) {
      const std::size_t begin = page.find('>', at) + 1;
      page.erase(begin, page.find("</" + tag, begin) - begin);
      at = begin;
    }
  }
  return page;
}

class Show : public testing::Test {
 protected:
  ProgramRun run(const Words& call) { return run_shigusa(call, {.folder = work_.path()}); }
  void reach(const std::string& out, const Words& more = {}) {
    Words call{"reach", "--goal", "right_hand=-0.2,1.1,0.4", "--formats", "",
               "--out", out,      "--evaluations",           "160"};
    call.insert(call.end(), more.begin(), more.end());
    const ProgramRun done = run(call);
    ASSERT_THAT(done.exit_code, delivered()) << done.err;
  }
  std::string show(Words arguments) {
    arguments.insert(arguments.begin(), "show");
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done.out;
  }

  WorkFolder work_;
};

TEST_F(Show, ResultsHaveASectionEachAndTheirCandidatesAFigure) {
  reach("one");
  reach("two", {"--character", "half_body", "--preset", "paper"});
  EXPECT_EQ(show({"one", "two/summary.json"}), "index.html\n");
  const std::string page = work_.get("index.html");
  std::size_t figures = 0;
  for (std::size_t at = page.find("<canvas"); at != page.npos; at = page.find("<canvas", at + 1)) {
    ++figures;
  }
  std::size_t candidates = 0;
  for (const char* folder : {"one", "two"}) {
    candidates += StoredRun(work_, folder).summary().at("candidates").size();
  }
  EXPECT_EQ(figures, candidates);
  EXPECT_THAT(page, AllOf(HasSubstr("id=\"result-2\""), Not(HasSubstr("id=\"result-3\""))));
  const std::string words = StoredRun(work_, "one").candidate(1).at("final_posture").at("words");
  EXPECT_THAT(page, HasSubstr(words.substr(1)));
}

TEST_F(Show, PageAsksForNothingElse) {
  reach("one");
  show({"one"});
  const std::string page = work_.get("index.html");
  for (const char* outside : {"http:", "https:", "src=", "url(", "@import", "import(", "fetch("}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST_F(Show, MarkupIsWellFormedAndTheDataIsJson) {
  reach("one");
  show({"one", "--title", "<b>\"1\" & 2</b>"});
  const std::string page = work_.get("index.html");
  const std::string markup = markup_of(page).substr(page.find('\n') + 1);
  const auto parsed = parse_xml(markup, {.bytes = 1 << 20, .tags = 10'000, .depth = 30}, "page");
  EXPECT_TRUE(parsed) << parsed.error().to_string();
  const Json data = Json::parse(between(page, "<script type=\"application/json\">", "</script>"));
  EXPECT_EQ(data.at("motions").size(), StoredRun(work_, "one").summary().at("candidates").size());
  if (std::system("command -v node > /dev/null") != 0) GTEST_SKIP() << "no Node.js here";
  const std::size_t last = page.rfind("<script>");
  const std::string script = work_.put("page.js", between(page, "<script>", "</script>", last));
  EXPECT_EQ(std::system(("node --check '" + script + "'").c_str()), 0);
}

TEST_F(Show, TextsAreEscaped) {
  reach("one", {"--obstacle", "<i>box</i>=0,0.2,0.8,0.1,0.1,0.1"});
  show({"one", "--title", "</h2><script>alert(1)</script>", "--heading", "a\x01&\xff\"b"});
  const std::string page = work_.get("index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("&lt;/h2&gt;&lt;script&gt;alert(1)"),
                          HasSubstr("a&amp;\xEF\xBF\xBD&quot;b"),
                          HasSubstr("&lt;i&gt;box&lt;/i&gt;"), Not(HasSubstr("<i>box"))));
}

TEST_F(Show, SameResultsGiveTheSameBytes) {
  reach("one");
  reach("two");
  show({"one", "--out", "a.html"});
  show({"two", "--out", "b.html"});
  EXPECT_EQ(work_.get("a.html"), work_.get("b.html"));
}

TEST_F(Show, APageIsSmall) {
  reach("one");
  show({"one"});
  const std::string page = work_.get("index.html");
  const std::string section = between(page, "<section", "</section>");
  const std::size_t candidates = StoredRun(work_, "one").summary().at("candidates").size();
  EXPECT_LE(section.size(), candidates * 12'000);
  EXPECT_LE(page.size() - section.size(), 24'000u);
}

TEST_F(Show, DrawsTheFirstCandidatesUnderEachOther) {
  reach("one");
  reach("two");
  EXPECT_EQ(show({"one", "two", "--picture", "both.svg", "--title", "First title"}),
            "index.html\nboth.svg\n");
  EXPECT_THAT(work_.get("both.svg"), HasSubstr("<svg"));
}

}  // namespace
}  // namespace shigusa
