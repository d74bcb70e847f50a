// SPDX-License-Identifier: MIT
#include "draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <shigusa/run.hpp>

#include "core/hash.hpp"
#include "formats/json_reader.hpp"

namespace shigusa {
namespace {

constexpr double kFar = kGoalRange;

std::string shown(const Json& value) {
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

Result<void> wrong(const std::string& place, std::string_view word, const Json& argument,
                   std::string_view allowed) {
  return fail(ErrorCode::parse, fmt::format("is {}; allowed is {}", shown(argument), allowed),
              fmt::format("{}.{}", place, word));
}

bool is_number_in(const Json& value, double low, double high) {
  return value.is_number() && value.get<double>() >= low && value.get<double>() <= high;
}

bool is_range(const Json& value, double low, double high) {
  return value.is_array() && value.size() == 2 && is_number_in(value[0], low, high) &&
         is_number_in(value[1], low, high) && value[0].get<double>() <= value[1].get<double>();
}

bool is_point(const Json& value) {
  return value.is_array() && value.size() == 3 &&
         std::all_of(value.begin(), value.end(),
                     [](const Json& x) { return is_number_in(x, -kFar, kFar); });
}

Vec3d point_of(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

bool is_box(const Json& value) {
  if (!value.is_array() || value.size() != 2 || !is_point(value[0]) || !is_point(value[1])) {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (value[0][k].get<double>() > value[1][k].get<double>()) return false;
  }
  return true;
}

// Word of a draw; the first of several.
std::string word_in(const Json& draw) {
  for (const DrawInfo& known : kDraws) {
    if (draw.contains(known.word)) return std::string(known.word);
  }
  return {};
}

const DrawInfo& info_of(std::string_view word) {
  return *std::find_if(kDraws.begin(), kDraws.end(),
                       [word](const DrawInfo& known) { return known.word == word; });
}

Result<void> check_choice(const Json& draw, const std::string& place) {
  const Json& values = draw["choice"];
  if (!values.is_array() || values.empty()) {
    return wrong(place, "choice", values, "a list with a value");
  }
  if (draw.contains("shares")) {
    const Json& shares = draw["shares"];
    double sum = 0.0;
    bool numbers = shares.is_array() && shares.size() == values.size();
    for (std::size_t k = 0; numbers && k < shares.size(); ++k) {
      numbers = is_number_in(shares[k], 0.0, 1e9);
      if (numbers) sum += shares[k].get<double>();
    }
    if (!numbers || !(sum > 0.0)) {
      return wrong(place, "shares", shares, "a number of at least 0 for each value, not all 0");
    }
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    SHG_TRY(check_draws(values[k], fmt::format("{}.choice[{}]", place, k)));
  }
  return {};
}

Result<void> check_argument(const Json& draw, const std::string& word, const std::string& place) {
  const Json& argument = draw[word];
  const auto allow = [&](bool good, std::string_view form) {
    return good ? Result<void>{} : wrong(place, word, argument, form);
  };
  if (word == "choice") return check_choice(draw, place);
  if (word == "uniform") {
    return allow(is_range(argument, -1e9, 1e9), "[low, high] with low ≤ high");
  }
  if (word == "integer") {
    constexpr double kMost = 4294967294.0;  // the count of the numbers has 32 bits
    const bool whole = is_range(argument, 0.0, kMost) && argument[0].is_number_integer() &&
                       argument[1].is_number_integer();
    return allow(whole, "[low, high], whole numbers from 0 with low ≤ high");
  }
  if (word == "percentile") {
    return allow(is_range(argument, 0.1, 99.9), "[low, high] with 0.1 ≤ low ≤ high ≤ 99.9");
  }
  if (word == "bmi") {
    return allow(is_range(argument, 5.0, 100.0), "[low, high] with 5 ≤ low ≤ high ≤ 100");
  }
  if (word == "box_m" || word == "statures" || word == "reach") {
    return allow(is_box(argument), "[[x, y, z], [x, y, z]], the low corner and the high one");
  }
  if (word == "rotation") return allow(argument == "any", "\"any\"");
  JsonReader reader(argument, fmt::format("{}.{}", place, word));
  if (word == "surface_m") {
    Vec3d corner{};
    std::vector<Vec3d> along;
    for (const char* key : {"corner", "along"}) reader.require(key);
    reader.vector("corner", corner, kFar);
    reader.vectors("along", along, 2, kFar);
    if (const auto& error = reader.finish()) return tl::unexpected(*error);
    return allow(along.size() == 2, info_of(word).form);
  }
  int goal = 0;
  for (const char* key : {"goal", "offset_m"}) reader.require(key);
  reader.integer("goal", goal, 0, kGoalsMax);
  if (reader.has("offset_m") && is_draw(argument["offset_m"])) {
    SHG_TRY(check_draws(argument["offset_m"], fmt::format("{}.beside.offset_m", place)));
  } else {
    Vec3d offset{};
    reader.vector("offset_m", offset, kFar);
  }
  if (const auto& error = reader.finish()) return tl::unexpected(*error);
  return {};
}

// Normal quantile of p in (0, 1): P. J. Acklam's rational approximation (relative error below
// 1.15e-9).
double normal_quantile(double p) {
  constexpr std::array a{-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                         1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
  constexpr std::array b{-5.447609879822406e+01, 1.615858368580409e+02, -1.556989798598866e+02,
                         6.680131188771972e+01, -1.328068155288572e+01};
  constexpr std::array c{-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                         -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
  constexpr std::array d{7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00,
                         3.754408661907416e+00};
  constexpr double kTail = 0.02425;
  const auto tail = [&](double q) {
    const double above = ((((c[0] * q + c[1]) * q + c[2]) * q + c[3]) * q + c[4]) * q + c[5];
    return above / ((((d[0] * q + d[1]) * q + d[2]) * q + d[3]) * q + 1.0);
  };
  if (p < kTail) return tail(sqrt(-2.0 * natural_log(p)));
  if (p > 1.0 - kTail) return -tail(sqrt(-2.0 * natural_log(1.0 - p)));
  const double q = p - 0.5;
  const double r = q * q;
  const double above = (((((a[0] * r + a[1]) * r + a[2]) * r + a[3]) * r + a[4]) * r + a[5]) * q;
  return above / (((((b[0] * r + b[1]) * r + b[2]) * r + b[3]) * r + b[4]) * r + 1.0);
}

// Evaluator of a template.
class Drawer {
 public:
  Drawer(const DrawSource& source, const TaskOfDraws& task_of)
      : source_(source), task_of_(task_of) {}

  Result<Json> task(const Json& whole) { return object(whole, ""); }

 private:
  // Draws a value; `beside`: the object that it belongs to, as far as drawn.
  Result<Json> value(const Json& form, const std::string& place, const Json& beside) {
    if (is_draw(form)) return draw(form, place, beside);
    if (form.is_object()) return object(form, place);
    if (!form.is_array()) return form;
    Json list = Json::array();
    const bool goals = are_goals(place);
    if (goals) goals_.clear();
    for (std::size_t k = 0; k < form.size(); ++k) {
      SHG_TRY_ASSIGN(Json item, value(form[k], fmt::format("{}[{}]", place, k), Json::object()));
      if (goals) goals_.push_back(item);
      list.push_back(std::move(item));
    }
    return list;
  }

  // Whether a place is that of a list of goals: the task's, or an action's.
  static bool are_goals(const std::string& place) {
    return place == "goals" || place.ends_with(".goals");
  }

  // Members that others depend on are drawn first.
  static int order_of(const std::string& key) {
    constexpr std::array<std::string_view, 4> kFirst{"character", "sex", "stature_m", "effector"};
    const auto* const found = std::find(kFirst.begin(), kFirst.end(), key);
    return static_cast<int>(found - kFirst.begin());
  }

  Result<Json> object(const Json& form, const std::string& place) {
    std::vector<std::string> keys;
    for (const auto& item : form.items()) keys.push_back(item.key());
    std::stable_sort(keys.begin(), keys.end(), [](const std::string& a, const std::string& b) {
      return order_of(a) < order_of(b);
    });
    Json result = Json::object();
    for (const std::string& key : keys) {
      SHG_TRY_ASSIGN(Json item, value(form[key], place.empty() ? key : place + "." + key, result));
      if (place.empty() && key == "character") character_ = item;
      result[key] = std::move(item);
    }
    return result;
  }

  // Random numbers of one place.
  [[nodiscard]] Random random_at(const std::string& place) const {
    Fnv1a hash;
    hash.add(place);
    hash.add(place.starts_with("character") ? source_.person : source_.task);
    return Random(source_.seed, hash.value());
  }
  // Fraction of a range, 0..1.
  double share(Random& random) const {
    if (source_.mode == DrawMode::lowest) return 0.0;
    return source_.mode == DrawMode::highest ? 1.0 : random.uniform();
  }
  double between(const Json& range, Random& random) const {
    const double low = range[0].get<double>();
    const double high = range[1].get<double>();
    return low + (high - low) * share(random);
  }
  Vec3d in_box(const Json& box, Random& random) const {
    Vec3d point{};
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double low = box[0][i].get<double>();
      point[k] = low + (box[1][i].get<double>() - low) * share(random);
    }
    return point;
  }

  Result<Json> draw(const Json& form, const std::string& place, const Json& beside) {
    const std::string word = word_in(form);
    const Json& argument = form[word];
    Random random = random_at(place);
    if (word == "uniform") return Json(between(argument, random));
    if (word == "integer") return integer(argument, random);
    if (word == "choice") return choice(form, place, beside, random);
    if (word == "percentile") return Json(stature_at(between(argument, random), sex_of(beside)));
    if (word == "bmi") return Json(mass_of(between(argument, random), beside));
    if (word == "box_m") return to_json(in_box(argument, random));
    if (word == "statures") return in_statures(argument, random);
    if (word == "surface_m") return on_surface(argument, random);
    if (word == "reach") return in_reach(argument, place, beside, random);
    if (word == "rotation") return to_json(any_rotation(random));
    return beside_goal(argument, place);
  }

  [[nodiscard]] Json integer(const Json& range, Random& random) const {
    const auto low = range[0].get<std::uint64_t>();
    const auto high = range[1].get<std::uint64_t>();
    if (source_.mode == DrawMode::lowest) return low;
    if (source_.mode == DrawMode::highest) return high;
    return low + random.below(static_cast<std::uint32_t>(high - low + 1));
  }

  Result<Json> choice(const Json& form, const std::string& place, const Json& beside,
                      Random& random) {
    const Json& values = form["choice"];
    std::size_t chosen = source_.alternative % values.size();
    if (source_.mode == DrawMode::random) {
      chosen = form.contains("shares") ? by_shares(form["shares"], random.uniform())
                                       : random.below(static_cast<std::uint32_t>(values.size()));
    }
    // draws of an alternative have a place of their own, but one under "goals" is still a goal's
    const bool goals = are_goals(place);
    return value(values[chosen], goals ? place : fmt::format("{}={}", place, chosen), beside);
  }

  static std::size_t by_shares(const Json& shares, double at) {
    double sum = 0.0;
    for (const Json& share : shares) sum += share.get<double>();
    double before = 0.0;
    std::size_t last = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const double own = shares[k].get<double>();
      if (own > 0.0) last = k;
      before += own;
      if (at * sum < before && own > 0.0) return k;
    }
    return last;
  }

  static Sex sex_of(const Json& character) {
    const auto sex = character.find("sex");
    return sex != character.end() && *sex == "female" ? Sex::female : Sex::male;
  }
  static double mass_of(double bmi, const Json& character) {
    const auto stature = character.find("stature_m");
    const double height = stature != character.end() && stature->is_number()
                              ? stature->get<double>()
                              : mean_stature(sex_of(character));
    return bmi * height * height;
  }

  Result<Json> in_statures(const Json& box, Random& random) {
    SHG_TRY_ASSIGN(const Task task, task_of_(character_, Json()));
    return to_json(in_box(box, random) * task.body.stature());
  }

  [[nodiscard]] Json on_surface(const Json& surface, Random& random) const {
    const double a = share(random);
    const double b = share(random);
    return to_json(point_of(surface["corner"]) + point_of(surface["along"][0]) * a +
                   point_of(surface["along"][1]) * b);
  }

  // Draws points until the body reaches one.
  Result<Json> in_reach(const Json& box, const std::string& place, const Json& goal,
                        Random& random) {
    if (source_.mode != DrawMode::random) return to_json(in_box(box, random));
    constexpr int kTries = 1000;
    SHG_TRY_ASSIGN(Task task, task_of_(character_, Json{{"effector", goal.value("effector", "")},
                                                        {"position_m", {0.0, 1.0, 0.3}}}));
    for (int i = 0; i < kTries; ++i) {
      const Vec3d point = in_box(box, random);
      task.goals.front().position = point;
      SHG_TRY_ASSIGN(const bool reached, seems_in_reach(task));
      if (reached) return to_json(point);
    }
    return fail(
        ErrorCode::invalid_argument,
        fmt::format("{} of {} points of the box were tried, and none is in reach", kTries, kTries),
        place);
  }

  // Shoemake, Uniform random rotations, Graphics Gems III (1992) 124-132.
  [[nodiscard]] Quatd any_rotation(Random& random) const {
    const double u = share(random);
    const SinCos<double> first = sin_cos(kTwoPi * share(random));
    const SinCos<double> second = sin_cos(kTwoPi * share(random));
    const double a = sqrt(1.0 - u);
    const double b = sqrt(u);
    return {a * first.sin, a * first.cos, b * second.sin, b * second.cos};
  }

  Result<Json> beside_goal(const Json& argument, const std::string& place) {
    const auto index = argument["goal"].get<std::size_t>();
    const auto is_there = [&] {
      return index < goals_.size() && goals_[index].contains("position_m") &&
             is_point(goals_[index]["position_m"]);
    };
    if (!is_there()) {
      return fail(ErrorCode::parse,
                  fmt::format("is goal {}, which is no earlier goal with a position", index),
                  place + ".beside.goal");
    }
    SHG_TRY_ASSIGN(const Json offset,
                   value(argument["offset_m"], place + ".offset_m", Json::object()));
    return to_json(point_of(goals_[index]["position_m"]) + point_of(offset));
  }

  const DrawSource& source_;
  const TaskOfDraws& task_of_;
  Json character_;           // as drawn
  std::vector<Json> goals_;  // of a list, as drawn so far
};

}  // namespace

bool is_draw(const Json& value) { return value.is_object() && !word_in(value).empty(); }

Result<void> check_draws(const Json& value, const std::string& place) {
  if (is_draw(value)) {
    const std::string word = word_in(value);
    for (const auto& item : value.items()) {
      if (item.key() == word || (word == "choice" && item.key() == "shares")) continue;
      return fail(ErrorCode::parse,
                  fmt::format("'{}' stands beside '{}', which stands alone", item.key(), word),
                  place);
    }
    return check_argument(value, word, place);
  }
  if (value.is_object()) {
    for (const auto& item : value.items()) {
      SHG_TRY(check_draws(item.value(), place + "." + item.key()));
    }
  } else if (value.is_array()) {
    for (std::size_t k = 0; k < value.size(); ++k) {
      SHG_TRY(check_draws(value[k], fmt::format("{}[{}]", place, k)));
    }
  }
  return {};
}

std::size_t most_alternatives(const Json& value) {
  std::size_t most = 1;
  if (is_draw(value) && value.contains("choice")) most = value["choice"].size();
  if (value.is_structured()) {
    for (const Json& inner : value) most = std::max(most, most_alternatives(inner));
  }
  return most;
}

Result<Json> drawn(const Json& task, const DrawSource& source, const TaskOfDraws& task_of) {
  return Drawer(source, task_of).task(task);
}

double stature_at(double percent, Sex sex) {
  constexpr double kQuantile95 = 1.6448536269514722;
  const double median = *stature_percentile("p50", sex);
  const double other = *stature_percentile(percent < 50.0 ? "p5" : "p95", sex);
  return median + abs(other - median) / kQuantile95 * normal_quantile(percent / 100.0);
}

}  // namespace shigusa
