// SPDX-License-Identifier: MIT
// The schemas in docs/ against what the program reads and writes, by a checker of the few keywords
// that they use.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <shigusa/shigusa.hpp>
#include <string>

namespace shigusa {
namespace {

using Json = nlohmann::json;

Json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return Json::parse(file);
}

std::filesystem::path source(const char* path) {
  return std::filesystem::path(SHIGUSA_SOURCE_DIR) / path;
}

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

// What is wrong with the value, or nothing.
class SchemaChecker {
 public:
  explicit SchemaChecker(const Json& root) : root_(root) {}

  [[nodiscard]] std::string check(const Json& value) const { return check(value, root_, "$"); }

 private:
  [[nodiscard]] std::string check(const Json& value, const Json& schema,
                                  const std::string& at) const {
    if (schema.contains("$ref")) return check(value, root_["$defs"]["parameters"], at);
    if (schema.contains("anyOf")) {
      std::string all;
      for (const Json& one : schema["anyOf"]) {
        const std::string wrong = check(value, one, at);
        if (wrong.empty()) return {};
        all += wrong + "; ";
      }
      return all;
    }
    if (schema.contains("enum")) {
      for (const Json& allowed : schema["enum"]) {
        if (allowed == value) return {};
      }
      return at + " is not one of the enum";
    }
    if (!has_type(value, schema["type"])) return at + " has the wrong type";
    if (value.is_number()) return check_number(value, schema, at);
    if (value.is_array()) return check_array(value, schema, at);
    return value.is_object() ? check_object(value, schema, at) : std::string{};
  }

  static std::string check_number(const Json& value, const Json& schema, const std::string& at) {
    const double x = value;
    if (x < schema.value("minimum", -1e300) || x > schema.value("maximum", 1e300)) {
      return at + " is out of range";
    }
    return {};
  }

  [[nodiscard]] std::string check_array(const Json& value, const Json& schema,
                                        const std::string& at) const {
    if (value.size() < schema.value("minItems", std::size_t{0}) ||
        value.size() > schema.value("maxItems", std::size_t{1'000'000})) {
      return at + " has the wrong length";
    }
    for (const Json& item : value) {
      if (auto wrong = check(item, schema["items"], at + "[]"); !wrong.empty()) return wrong;
    }
    return {};
  }

  [[nodiscard]] std::string check_object(const Json& value, const Json& schema,
                                         const std::string& at) const {
    for (const Json& name : schema.value("required", Json::array())) {
      if (!value.contains(name)) return at + " lacks " + name.get<std::string>();
    }
    const Json properties = schema.value("properties", Json::object());
    const Json others = schema.value("additionalProperties", Json(true));
    for (const auto& [name, member] : value.items()) {
      const std::string place = at + "." + name;
      if (properties.contains(name)) {
        if (auto wrong = check(member, properties[name], place); !wrong.empty()) return wrong;
      } else if (others.is_object()) {
        if (auto wrong = check(member, others, place); !wrong.empty()) return wrong;
      } else if (others == false) {
        return place + " is not allowed";
      }
    }
    return {};
  }

  const Json& root_;
};

Json produced_result() {
  TaskFile file;
  file.goals = {{"right_hand", {-0.3, 1.2, 0.4}}};
  const Task task = make_task(file, {}).value();
  const Generation generation = generate(task).value();
  return Json::parse(format_result(file, task, generation, {}, {}));
}

TEST(TaskSchema, HoldsTheExampleTasks) {
  const Json schema = read_json(source("docs/task.schema.json"));
  int tasks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source("examples/tasks"))) {
    EXPECT_EQ(SchemaChecker(schema).check(read_json(entry.path())), "") << entry.path();
    ++tasks;
  }
  EXPECT_GE(tasks, 2);
}

TEST(TaskSchema, HoldsWhatIsWritten) {
  const Json schema = read_json(source("docs/task.schema.json"));
  TaskFile file;
  file.character.source = "somebody.bvh";
  file.character.stature = 1.7;
  file.character.landmarks = standing_landmarks(1.7, 0.1);
  file.goals = {{"left_hand", {0.3, 1.2, 0.4}}};
  file.duration = 1.5;
  file.evaluations = 100;
  EXPECT_EQ(SchemaChecker(schema).check(Json::parse(format_task(file))), "");
}

TEST(TaskSchema, RefusesWhatTheReaderRefuses) {
  const Json schema = read_json(source("docs/task.schema.json"));
  for (const char* text :
       {R"({"goal": []})", R"({"goals": [{"effector": "right_hand"}]})",
        R"({"goals": [{"effector": "right_hand", "position_m": [1, 2]}]})",
        R"({"goals": [{"effector": "right_hand", "position_m": [1, 2, 1e9]}]})",
        R"({"duration_s": 0})", R"({"seed": "a"})", R"({"version": 2})", R"({"preset": "human"})",
        R"({"character": {"stature_m": 1.7}})", R"({"criteria": {"torque": {"lean": 1}}})"}) {
    EXPECT_NE(SchemaChecker(schema).check(Json::parse(text)), "") << text;
    EXPECT_FALSE(parse_task(text, "t")) << text;
  }
}

TEST(ResultSchema, HoldsAResult) {
  const Json schema = read_json(source("docs/result.schema.json"));
  EXPECT_EQ(SchemaChecker(schema).check(produced_result()), "");
}

TEST(ResultSchema, TaskInAResultIsATask) {
  const Json schema = read_json(source("docs/task.schema.json"));
  EXPECT_EQ(SchemaChecker(schema).check(produced_result()["task"]), "");
}

TEST(ResultSchema, RefusesAResultWithoutItsParts) {
  const Json schema = read_json(source("docs/result.schema.json"));
  const Json whole = produced_result();
  for (const auto& [name, member] : whole.items()) {
    Json part = whole;
    part.erase(name);
    EXPECT_NE(SchemaChecker(schema).check(part), "") << name;
  }
}

}  // namespace
}  // namespace shigusa
