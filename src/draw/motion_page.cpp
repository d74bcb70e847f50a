// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <shigusa/draw.hpp>
#include <shigusa/math.hpp>

#include "candidate_strip.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "page_figures.hpp"
#include "page_text.hpp"
#include "rollout/reach_problem.hpp"

namespace shigusa {
namespace {

std::string title_of(const ShownResult& shown) {
  if (!shown.title.empty()) return shown.title;
  if (!shown.task.actions.empty()) return actions_title(shown.task.actions);
  return goals_title(shown.task.goals, shown.task.body.stature());
}

std::string_view body_words(std::string_view name) {
  if (name == "human") return "A whole human";
  if (name == "full_body") return "A body with a stiff trunk (full_body)";
  if (name == "half_body") return "Half a body, one arm and one leg (half_body)";
  return name;
}

std::string asked_html(const ShownResult& shown) {
  const Task& task = shown.task;
  std::string around;
  for (const Obstacle& obstacle : task.obstacles) {
    around += fmt::format("{}{}", around.empty() ? " In the way: " : ", ", obstacle.name);
  }
  if (!around.empty()) around += ".";
  return fmt::format(
      "<p class=\"asked\">{} of {:.2f} m, {:.0f} kg and {} freedoms. Asked for: {}.{} <span "
      "class=\"quiet\">Preset <b>{}</b>: {}.</span></p>\n",
      markup_text(body_words(task.body.name())), task.body.stature(), task.body.mass(),
      task.body.dof_count(), markup_text(asked_words(task)), markup_text(around),
      word_of(task.preset), traits_of(task.preset).about);
}

// Largest goal error (m).
double worst_error(const Candidate& candidate) {
  double error = 0.0;
  for (const GoalResult& goal : candidate.goals) error = max(error, goal.error);
  return error;
}

// Text on the goals that a candidate misses; empty if it meets them.
std::string miss_words(const Candidate& candidate) {
  const double error = worst_error(candidate);
  double turn = 0.0;
  for (const GoalResult& goal : candidate.goals) turn = max(turn, goal.turn.error.value_or(0.0));
  if (error > kReachTolerance) {
    return fmt::format("Out of reach: it ends {} from the goal.", length_words(error));
  }
  if (turn > kTurnTolerance) {
    return fmt::format("Out of reach: it ends turned by {:.0f}° from what is asked.",
                       degrees(turn));
  }
  return {};
}

std::string verdict_html(const Candidate& candidate) {
  const Judgement& judgement = candidate.judgement;
  std::string html;
  const std::string miss = miss_words(candidate);
  if (!miss.empty()) html += fmt::format("<p class=\"verdict impossible\">{}</p>\n", miss);
  html += fmt::format("<p class=\"verdict {}\">{}</p>\n", word_of(judgement.verdict),
                      verdict_sentence(judgement));
  constexpr std::size_t kTold = 3;
  std::string reasons;
  for (std::size_t i = 0; i < std::min(kTold, judgement.reasons.size()); ++i) {
    reasons += fmt::format("<li>{}</li>", markup_text(reason_sentence(judgement.reasons[i])));
  }
  if (judgement.reasons.size() > kTold) {
    reasons += fmt::format("<li>And {} more.</li>", judgement.reasons.size() - kTold);
  }
  if (!reasons.empty()) html += fmt::format("<ul class=\"reasons\">{}</ul>\n", reasons);
  return html;
}

double cost_of(const ScoreTerm& term) { return term.weight * term.penalty; }

// Largest cost of one criterion in any of the motions; scale of the bars.
double largest_cost(const GenerateResult& generation) {
  double largest = 0.0;
  for (const Candidate& candidate : generation.candidates) {
    for (const ScoreTerm& term : candidate.score.terms) largest = max(largest, cost_of(term));
  }
  return largest;
}

// The costliest criteria, as text with a bar each.
std::string costs_html(const Score& score, double largest) {
  constexpr std::size_t kTold = 3;
  constexpr double kLeast = 0.04;  // share of the score; smaller costs are left out
  std::vector<ScoreTerm> terms = score.terms;
  std::stable_sort(terms.begin(), terms.end(),
                   [](const ScoreTerm& a, const ScoreTerm& b) { return cost_of(a) > cost_of(b); });
  std::string html;
  for (std::size_t i = 0; i < std::min(kTold, terms.size()); ++i) {
    const double cost = cost_of(terms[i]);
    if (!(cost > kLeast * score.total)) break;
    html += fmt::format("<li>{}<span><i style=\"width:{:.0f}%\"></i></span></li>",
                        markup_text(capitalised(criterion_words(terms[i].name))),
                        100.0 * cost / largest);
  }
  if (html.empty()) return "<p class=\"label\">It costs nothing by these criteria.</p>\n";
  return fmt::format("<p class=\"label\">Costs the most</p><ul class=\"costs\">{}</ul>\n", html);
}

std::string number_row(std::string_view name, std::string_view value) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>", markup_text(name),
                     markup_text(value));
}

// Table of all numbers of a candidate.
std::string numbers_html(const BodyModel& body, const Candidate& candidate) {
  std::string rows =
      number_row("score, lower is better", fmt::format("{:.4f}", candidate.score.total));
  for (const ScoreTerm& term : candidate.score.terms) {
    rows += number_row(term.name, fmt::format("{:.3g} × {:.4f}", term.weight, term.penalty));
  }
  double slide = 0.0;
  for (const ContactResult& foot : candidate.contacts) slide = max(slide, foot.max_slide);
  rows += number_row("from the goal, mm", fmt::format("{:.3f}", 1e3 * worst_error(candidate)));
  rows += number_row("feet slide by, mm", fmt::format("{:.3f}", 1e3 * slide));
  if (const auto& support = candidate.measures.support) {
    rows += number_row("weight inside the feet by, mm",
                       fmt::format("{:.0f}", 1e3 * support->centre_of_mass.distance));
  }
  if (const JointLoad* load = most_loaded(candidate.measures)) {
    rows += number_row("most loaded, of its strength",
                       fmt::format("{} {:.0f} %", body.dof(load->dof).name, 100.0 * load->share));
  }
  return fmt::format("<details><summary>Numbers</summary><table>{}</table></details>\n", rows);
}

std::string candidate_html(const ShownResult& shown, std::size_t k, double largest) {
  const Candidate& candidate = shown.generation.candidates[k];
  const std::string words = capitalised(posture_words(candidate.final_posture));
  std::string action;  // the present one, as page_work.js tells
  if (!candidate.actions.empty()) {
    action = fmt::format("<p class=\"label\">{}</p>", action_name(candidate.actions[0].kind));
  }
  return fmt::format(
             "<li><canvas role=\"img\" aria-label=\"Candidate {0}, a moving figure: {1}. "
             "{2}\"></canvas>{3}\n"
             "<h3><span class=\"rank\">{0}</span>{1}</h3>\n",
             k + 1, words, verdict_sentence(candidate.judgement), action) +
         verdict_html(candidate) + costs_html(candidate.score, largest) +
         numbers_html(shown.task.body, candidate) + "</li>\n";
}

constexpr std::string_view kControls =
    "<div class=\"controls\" hidden=\"\"><button type=\"button\" class=\"play\">Pause</button>"
    "<input type=\"range\" min=\"0\" max=\"1000\" step=\"1\" value=\"0\" aria-label=\"Time\"/>"
    "<span class=\"time\">0.00 s</span>"
    "<button type=\"button\" class=\"turn\" data-turn=\"-0.35\" aria-label=\"Turn the figures to "
    "the "
    "left\">↶</button>"
    "<button type=\"button\" class=\"turn\" data-turn=\"0.35\" aria-label=\"Turn the figures to "
    "the "
    "right\">↷</button>"
    "</div>\n";

std::string result_html(const ShownResult& shown, std::size_t number) {
  const GenerateResult& generation = shown.generation;
  const double largest = largest_cost(generation);
  std::string html = fmt::format(
      "<section class=\"result\" id=\"result-{0}\" aria-labelledby=\"title-{0}\">\n"
      "<h2 id=\"title-{0}\">{1}</h2>\n",
      number, markup_text(title_of(shown)));
  html += asked_html(shown);
  html += fmt::format("<p class=\"quiet\">{} {} of {}{:.2f} s, the best first.</p>\n",
                      generation.candidates.size(),
                      generation.candidates.size() == 1 ? "motion" : "motions",
                      shown.task.actions.empty() ? "" : "up to ", page_seconds(generation));
  html += kControls;
  html += "<ol class=\"candidates\">\n";
  for (std::size_t k = 0; k < generation.candidates.size(); ++k) {
    html += candidate_html(shown, k, largest);
  }
  html += fmt::format("</ol>\n<script type=\"application/json\">{}</script>\n</section>\n",
                      page_figures(shown.task, generation));
  return html;
}

std::string contents_html(std::span<const ShownResult> results) {
  if (results.size() < 2) return {};
  std::string html = "<nav aria-label=\"Results\"><ul>";
  for (std::size_t k = 0; k < results.size(); ++k) {
    const Task& task = results[k].task;
    html += fmt::format(
        "<li><a href=\"#result-{}\">{}</a> <span class=\"quiet\">{}, {}</span></li>", k + 1,
        markup_text(title_of(results[k])), markup_text(task.body.name()), word_of(task.preset));
  }
  return html + "</ul></nav>\n";
}

constexpr std::string_view kPageFoot =
    "<footer><p>The ring is the goal, the line the way of what goes there; green outlines are the "
    "feet that stay. Circles on the floor are 25 cm apart. Places are told as the body at its "
    "start "
    "sees them, from the floor between its feet. A bar is a criterion's part of the score, of the "
    "same length in all motions of a result; lower scores are better.</p></footer>\n";

// The page's script, with the part for pieces of work if one is shown.
std::string script_of(std::span<const ShownResult> results) {
  constexpr std::string_view kScenes = "const scenes = ";
  std::string script(kPageScript);
  if (std::any_of(results.begin(), results.end(),
                  [](const ShownResult& shown) { return is_work(shown.generation); })) {
    script.insert(script.find(kScenes), kPageWork);
  }
  return script;
}

}  // namespace

Result<std::string> motion_page(std::span<const ShownResult> results, std::string_view heading) {
  std::size_t candidates = 0;
  for (const ShownResult& shown : results) candidates += shown.generation.candidates.size();
  if (candidates > kPageMostCandidates) {
    return fail(ErrorCode::invalid_argument,
                say("candidates_most", candidates, kPageMostCandidates), "the page");
  }
  const std::string title = markup_text(heading.empty() ? "Motions by shigusa" : heading);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; script-src 'unsafe-inline'\"/>\n"
      "<title>{0}</title>\n<style>{1}</style></head>\n<body><header><h1>{0}</h1>\n"
      "<p class=\"quiet\">Drag a figure to turn it.</p>\n"
      "<noscript><p>The figures are drawn by the page's own script, which this browser does not "
      "run.</p></noscript>\n{2}</header>\n<main>\n",
      title, kPageStyle, contents_html(results));
  for (std::size_t k = 0; k < results.size(); ++k) page += result_html(results[k], k + 1);
  page += "</main>\n";
  page += kPageFoot;
  return fmt::format("{}<script>{}</script>\n</body></html>\n", page, script_of(results));
}

Result<std::string> result_strips(std::span<const ShownResult> results) {
  std::vector<MotionStrip> strips;
  for (const ShownResult& shown : results) {
    const Candidate& first = shown.generation.candidates.front();
    strips.push_back(candidate_strip(shown.task, first));
    strips.back().overlay.caption =
        fmt::format("{}: {}, {}", title_of(shown), posture_words(first.final_posture),
                    word_of(first.judgement.verdict));
  }
  return draw_strips(strips);
}

}  // namespace shigusa
