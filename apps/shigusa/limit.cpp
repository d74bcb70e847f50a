// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <shigusa/explore.hpp>
#include <shigusa/files.hpp>
#include <span>

#include "commands.hpp"
#include "next_step.hpp"
#include "task_input.hpp"
#include "text_table.hpp"
#include "usage.hpp"

namespace shigusa::app {
namespace {

struct LimitOptions {
  TaskInput input;
  std::string of;
  std::vector<std::string> people;  // SEX:STATURE
  std::optional<double> score;
  std::optional<double> bound;
  std::string thing;  // of a piece of work
  int seeds = LimitSettings{}.seeds;
  bool json = false;
};

// Words of --of, with the limits that they ask for.
struct LimitWord {
  std::string_view word;
  std::array<LimitKind, 2> kinds;
  std::size_t count;
};
constexpr std::array kLimitWords{
    LimitWord{"load", {LimitKind::load}, 1},
    LimitWord{"height", {LimitKind::lowest, LimitKind::highest}, 2},
    LimitWord{"distance", {LimitKind::farthest}, 1},
};
std::vector<std::string> limit_words() {
  std::vector<std::string> words;
  for (const LimitWord& each : kLimitWords) words.emplace_back(each.word);
  return words;
}

// People of whom the limits of a built-in body are shown.
const std::vector<std::string> kUsualPeople{"female:p5", "female:p50", "male:p50", "male:p95"};

// A person, as typed.
Result<CharacterSpec> person_of(const std::string& text, CharacterSpec spec) {
  const std::size_t colon = text.find(':');
  CharacterOptions options;
  options.sex = text.substr(0, colon);
  if (colon == text.npos || !value_of<Sex>(*options.sex, "sex")) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("'{}' is not SEX:STATURE, such as {}", text.substr(0, 80),
                            kUsualPeople.front()),
                "--people");
  }
  options.stature = text.substr(colon + 1);
  SHG_TRY(placed("--people", apply_character_options(options, spec)));
  return spec;
}

struct Person {
  std::string name;
  double stature = 0.0;  // m
  double mass = 0.0;     // kg
};

// Cause of the end of a limit, in a few words.
std::string end_words(const Limit& limit) {
  if (limit.end == LimitEnd::beyond) return "possible up to there, the last that is tried";
  if (limit.out_of_reach) return "out of reach";
  if (!limit.reason) return "score";
  if (limit.reason->verdict == Verdict::possible) return "score";
  const bool names = !limit.reason->subject.empty();
  return fmt::format("{}{}{}", word_of(limit.reason->kind), names ? " of " : "",
                     printable(limit.reason->subject));
}

void print_limits(std::span<const Person> people, std::span<const PersonLimit> limits) {
  TextTable table;
  std::vector<std::string> names;
  std::vector<std::string> statures;
  std::vector<std::string> masses;
  std::vector<std::string> kinds;
  std::vector<std::string> values;
  std::vector<std::string> ends;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const Limit& limit = limits[k].limit;
    const bool none = limit.end == LimitEnd::nowhere;
    names.push_back(people[k].name);
    statures.push_back(fmt::format("{:.3f}", people[k].stature));
    masses.push_back(fmt::format("{:.0f}", people[k].mass));
    kinds.emplace_back(word_of(limit.kind));
    values.push_back(none ? "none"
                          : fmt::format("{}{:.{}f} {}", limit.sharp ? "" : "~", limit.value,
                                        limit.kind == LimitKind::load ? 1 : 2,
                                        limit_unit(limit.kind)));
    ends.push_back(end_words(limit));
  }
  table.add("person", TextTable::Align::left, std::move(names));
  table.add("m", TextTable::Align::right, std::move(statures));
  table.add("kg", TextTable::Align::right, std::move(masses));
  table.add("limit", TextTable::Align::left, std::move(kinds));
  table.add("possible", TextTable::Align::right, std::move(values));
  table.add("ended by", TextTable::Align::left, std::move(ends));
  print_out("{}", table.text());
}

// Notes on limits that one number does not tell.
void note_odd(std::span<const PersonLimit> limits, int seeds) {
  for (const auto& [person, limit] : limits) {
    const std::string_view unit = limit_unit(limit.kind);
    if (limit.end == LimitEnd::nowhere) {
      note(person, fmt::format("the {} has no value that is possible, from {:g} {} on",
                               word_of(limit.kind), limit.value, unit));
    } else if (!limit.sharp) {
      note(person, fmt::format("the {} is not sharp: beyond {:.3g} {} some of {} are possible",
                               word_of(limit.kind), limit.value, unit,
                               number_of(static_cast<std::uint64_t>(seeds), "seed")));
    }
    if (limit.again) {
      note(person, fmt::format("beyond the {} it is possible again at {:.3g} {}",
                               word_of(limit.kind), *limit.again, unit));
    }
  }
}

Result<int> limit(const LimitOptions& options) {
  SHG_TRY_ASSIGN(const BatchSettings batch, batch_settings(options.input));
  SHG_TRY_ASSIGN(const TaskFile file, task_file_of(options.input));
  const CharacterSpec& own = file.character;
  std::vector<std::string> people = options.people;
  const bool any_person = is_built_in(own) && !own.stature && !own.mass;
  if (people.empty() && any_person && file.actions.empty()) people = kUsualPeople;
  std::vector<TaskFile> files;
  for (const std::string& text : people) {
    files.push_back(file);
    SHG_TRY_ASSIGN(files.back().character, person_of(text, own));
  }
  if (people.empty()) files.push_back(file);
  const auto word = std::find_if(kLimitWords.begin(), kLimitWords.end(),
                                 [&](const LimitWord& each) { return each.word == options.of; });
  std::vector<Person> persons;
  std::vector<PersonLimit> limits;
  for (std::size_t k = 0; k < files.size(); ++k) {
    SHG_TRY_ASSIGN(Task task, make_task(files[k], folder_of(options.input)));
    task.batch = batch;
    if (k == 0) note_other_axes(task);
    const std::string name = people.empty() ? task.body.name() : people[k];
    for (const LimitKind kind : std::span(word->kinds).first(word->count)) {
      const LimitSettings settings{kind, options.score, options.bound, options.seeds,
                                   options.thing};
      const Result<Limit> found = find_limit(task, settings, terminal_progress());
      end_progress_line();
      if (!found) return tl::unexpected(in_task(found.error(), options.input, "limit"));
      persons.push_back({printable(name), task.body.stature(), task.body.mass()});
      limits.push_back({name, *found});
    }
  }
  if (options.json) {
    print_out("{}", format_limits(limits));
  } else {
    print_limits(persons, limits);
  }
  note_odd(limits, options.seeds);
  const bool all = std::all_of(limits.begin(), limits.end(), [](const PersonLimit& each) {
    return each.limit.end != LimitEnd::nowhere;
  });
  return all ? kDone : kUnreachable;
}

}  // namespace

void add_limit(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<LimitOptions>();
  LimitOptions& o = *options;
  CLI::App* c = app.add_subcommand(
      "limit", "Find the heaviest load, the lowest, highest or farthest place that is possible");
  c->group(kLook)->footer(
      "shigusa limit --of load --goal right_hand=-0.2,0.8,0.4 --people male:p50\n"
      "shigusa limit --of height --goal right_hand=-0.2,1.1,0.4 --stature p5\n"
      "shigusa limit task.json --of distance --people female:p5 --score 1");
  add_task_input(*c, o.input);
  const std::string group = "The limit";
  describe(c->add_option("--of", o.of)->required()->check(one_of("limit", limit_words())),
           {.group = group,
            .brief = "What grows until the task is no longer possible",
            .full = "What grows until the task is no longer possible: the load in the hands with "
                    "goals, in all, or in a task with actions the mass of a thing; the height of "
                    "the goals, up and down; or their distance from the feet. All goals move "
                    "together.",
            .form = fmt::format("{}", fmt::join(limit_words(), "|"))});
  describe(c->add_option("--people", o.people)->delimiter(',')->allow_extra_args(false),
           {.group = group,
            .brief = "Whose limits, with commas between (default: four people)",
            .full = fmt::format("Whose limits, with commas between: a sex and a stature, in metres "
                                "or p5, p50, p95. When not given, {} for goals of a built-in "
                                "body without --stature and --mass, else the task's own.",
                                fmt::join(kUsualPeople, ", ")),
            .form = "SEX:STATURE,…"});
  describe(c->add_option("--score", o.score)->check(number(1e-6, 1e6)),
           {.group = group,
            .brief = "Highest score that counts as possible (default: any)",
            .form = "SCORE"});
  describe(c->add_option("--bound", o.bound)->check(number(0.0, kLoadMax)),
           {.group = group,
            .brief = "Last value tried, in kg or m",
            .full = "Last value tried, in kilograms or metres; when not given, 100 kg, the floor, "
                    "1.5 statures of height and 1 of distance.",
            .form = "VALUE"});
  describe(c->add_option("--load-of", o.thing),
           {.group = group,
            .brief = "Thing of a piece of work that gets heavier (default: the first)",
            .full = "In a task with actions: the thing whose mass grows; when not given, the first "
                    "that an action grasps.",
            .form = "THING",
            .rare = true});
  describe(c->add_option("--seeds", o.seeds)->check(whole_number(1, kLimitSeedsMax)),
           {.group = group,
            .brief = "Searches that must agree at a value (default 5)",
            .full = "Searches, each with other random numbers, that must agree on both sides of a "
                    "limit; 5 when not given.",
            .form = "N",
            .rare = true});
  add_batch_options(*c, o.input);
  describe(c->add_flag("--json", o.json),
           {.group = heading(OptionGroup::output), .brief = "Print JSON"});
  c->callback([options, &exit_code] { exit_code = exit_code_of(limit(*options)); });
}

}  // namespace shigusa::app
