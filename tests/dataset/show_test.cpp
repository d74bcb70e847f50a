// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <shigusa/dataset_show.hpp>

#include "dataset/plans.hpp"
#include "dataset/show_facts.hpp"
#include "dataset/show_plot.hpp"
#include "formats/xml.hpp"

namespace shigusa {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// The page of a plan of five tasks, with `shards` of its three shards made.
std::string shown(const WorkFolder& work, Json json, std::uint64_t shards,
                  std::size_t motions = 6) {
  const DatasetPlan plan = plan_of_json(json);
  EXPECT_TRUE(keep_plan(plan, work.path()));
  made(plan, {.folder = work.path(), .last_shard = shards});
  const auto page = show_dataset(work.path(), {.motions = motions});
  EXPECT_TRUE(page) << page.error().to_string();
  return page.value_or("");
}

Json five_tasks() {
  Json json = small_plan(5, 2);
  json["motions"] = "all";
  return json;
}

// Number of occurrences of a word in a text.
std::size_t count_of(const std::string& text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Show, PageIsWellFormedAndNeedsNothingElse) {
  const WorkFolder work;
  Json json = five_tasks();
  json["name"] = "Shelves & <seats>";
  const std::string page = shown(work, json, 3);
  ASSERT_TRUE(page.starts_with("<!DOCTYPE html>\n"));
  const auto tree = parse_xml(page.substr(page.find('\n') + 1),
                              {.bytes = 10'000'000, .tags = 100'000, .depth = 50}, "show.html");
  ASSERT_TRUE(tree) << tree.error().to_string();
  EXPECT_THAT(page, HasSubstr("<h1>Shelves &amp; &lt;seats></h1>"));
  for (const char* outside : {"<script", "http:", "https:", "url(", "@import", "<link", "<img"}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
}

TEST(Show, PageHasTheCounts) {
  const WorkFolder work;
  const std::string page = shown(work, five_tasks(), 3);
  std::uint64_t motions = 0;
  for (std::uint64_t shard = 0; shard < 3; ++shard) {
    motions += ShardTables(work.path(), shard).motions.rows();
  }
  EXPECT_THAT(page, HasSubstr("<dt>tasks</dt><dd>5<small>of 5 in the plan"));
  EXPECT_THAT(page, HasSubstr("<dt>motions</dt><dd>" + std::to_string(motions) + "<small>"));
  EXPECT_THAT(page, HasSubstr("3 of 3 shards"));
  EXPECT_THAT(page, Not(HasSubstr("not here")));
  const std::size_t drawn = std::min<std::size_t>(6, motions);
  EXPECT_EQ(count_of(page, "<p class=\"id\">motion "), drawn);
  EXPECT_THAT(page, HasSubstr("<h2>" + std::to_string(drawn) + " motions</h2>"));
}

TEST(Show, SaysThatShardsAreMissing) {
  const WorkFolder work;
  const std::string page = shown(work, five_tasks(), 1);
  EXPECT_THAT(page, HasSubstr("<b>2 of 3 shards are not here</b>"));
  EXPECT_THAT(page, HasSubstr("<dt>tasks</dt><dd>2<small>of 5 in the plan"));
}

TEST(Show, SameDataSamePageWhateverSeriesAreKept) {
  const WorkFolder one;
  const WorkFolder bare;
  Json without = five_tasks();
  without["series"] = Json::array();
  Json with = five_tasks();
  with["series"] = {"positions"};
  // of the contact sheet: above it stand the plan's digest and the size
  const auto sheet = [](const std::string& page) { return page.substr(page.find("<ul class")); };
  const std::string page = shown(one, with, 3);
  EXPECT_TRUE(sheet(page) == sheet(shown(bare, without, 3)));
  EXPECT_TRUE(page == show_dataset(one.path(), {.motions = 6}).value());
}

TEST(Show, FailsWhereThereIsNoDataSet) {
  const WorkFolder work;
  EXPECT_THAT(show_dataset(work.path()).error().to_string(), HasSubstr("plan.json"));
  ASSERT_TRUE(keep_plan(plan_of_json(five_tasks()), work.path()));
  EXPECT_THAT(show_dataset(work.path()).error().to_string(), HasSubstr("has no shards"));
  EXPECT_THAT(show_dataset(work.path(), {.motions = kShownMax + 1}).error().to_string(),
              HasSubstr("allowed are 0 to 1000"));
}

TEST(Lottery, KeepsTheSameFewInAnyOrder) {
  Lottery<int> up(3);
  Lottery<int> down(3);
  for (int k = 0; k < 50; ++k) {
    up.add(static_cast<std::uint64_t>(k * 37 % 101), k);
    down.add(static_cast<std::uint64_t>((49 - k) * 37 % 101), 49 - k);
  }
  EXPECT_EQ(up.seen(), 50u);
  EXPECT_EQ(up.drawn(), down.drawn());
  // 37 · 41 = 15 · 101 + 2, 37 · 11 = 4 · 101 + 3
  EXPECT_THAT(up.drawn(), ElementsAre(0, 41, 11));
}

TEST(Ticks, AreRoundAndWithinTheRange) {
  EXPECT_THAT(ticks(0.0, 2.1, 7).at, ElementsAre(0.0, 0.5, 1.0, 1.5, 2.0));
  EXPECT_EQ(ticks(-0.7, 0.7, 7).at.size(), 5u);
  EXPECT_EQ(tick_label(0.5, 0.25), "0.50");
  EXPECT_EQ(tick_label(-2.0, 1.0), "\u22122");
  EXPECT_TRUE(ticks(1.0, 1.0, 5).at.empty());
}

}  // namespace
}  // namespace shigusa
