// SPDX-License-Identifier: MIT
#include "dataset/plans.hpp"
#include "document/schema_check.hpp"

namespace shigusa {
namespace {

using namespace testing_support;

const SchemaCheck& plan_judge() {
  static const SchemaCheck schema = SchemaCheck::in_docs("plan.schema.json");
  return schema;
}

TEST(PlanSchema, IsWrittenFromTheTables) {
  EXPECT_TRUE(plan_schema() ==
              read_text_file(SHIGUSA_SOURCE_DIR "/docs/plan.schema.json", 1 << 20).value())
      << "scripts/make_schema writes it";
}

TEST(PlanSchema, TakesPlansAndNoOthers) {
  Json plan = small_plan(10, 5);
  EXPECT_EQ(plan_judge().judge(plan), "");
  plan["task"]["goals"] = {{"choice", Json::array({plan["task"]["goals"]})}, {"shares", {1}}};
  EXPECT_EQ(plan_judge().judge(plan), "");
  plan["task"]["goals"]["choice"][0][0]["load_kg"] = {{"uniform", {0, 10}}};
  EXPECT_EQ(plan_judge().judge(plan), "");
  Json wrong = small_plan(10, 5);
  wrong["task"]["gaols"] = 1;
  EXPECT_NE(plan_judge().judge(wrong), "");
  wrong = small_plan(10, 5);
  wrong["sead"] = 1;
  EXPECT_NE(plan_judge().judge(wrong), "");
}

}  // namespace
}  // namespace shigusa
