// SPDX-License-Identifier: MIT
#include <memory>
#include <shigusa/files.hpp>
#include <shigusa/request.hpp>

#include "commands.hpp"
#include "usage.hpp"

#ifdef SHIGUSA_HAS_DATASETS
#include <shigusa/dataset.hpp>
#endif

namespace shigusa::app {

void add_schema(CLI::App& app) {
  CLI::App* c = app.add_subcommand("schema", "Print the JSON schema of task files");
#ifdef SHIGUSA_HAS_DATASETS
  const auto of_plans = std::make_shared<bool>(false);
  c->group(kMore)->footer("shigusa schema\nshigusa schema --plan");
  describe(c->add_flag("--plan", *of_plans),
           {.group = heading(OptionGroup::output), .brief = "That of plans for data sets"});
  c->callback([of_plans] { write_out(*of_plans ? plan_schema() : task_schema()); });
#else
  c->group(kMore)->footer("shigusa schema");
  c->callback([] { write_out(task_schema()); });
#endif
}

}  // namespace shigusa::app
