// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <shigusa/dataset_show.hpp>

#include "formats/xml.hpp"
#include "show_page.hpp"
#include "show_plot.hpp"

namespace shigusa {
namespace {

constexpr const char* kStyle = R"css(
:root{color-scheme:light dark;--page:#f3f4f5;--panel:#fff;--text:#1c2226;--quiet:#56626b;--line:#dde1e4;
--strong:#b9c1c7;--accent:#1f6f6a;--goal:#b84f10;--good:#1d7a4f;--hard:#855500;--bad:#b3233a;
--c1:#2a7fb8;--c2:#d9631a;--c3:#8a4fb0;--s1:#2a7fb8;--s2:#8a6d1f;--s3:#d9631a;--s4:#8a4fb0;--s5:#56626b}
@media (prefers-color-scheme:dark){:root{--page:#14181b;--panel:#1c2125;--text:#e8ecee;--quiet:#a3afb7;
--line:#30383e;--strong:#4b565e;--accent:#6fc9c0;--goal:#ff9f5e;--good:#66cf9b;--hard:#f0bb5c;--bad:#ff8a99;
--c1:#6cb2ea;--c2:#ff9146;--c3:#c18fe6;--s1:#6cb2ea;--s2:#d6bb62;--s3:#ff9146;--s4:#c18fe6;--s5:#a3afb7}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--text);font:15px/1.5 system-ui,sans-serif}
main{max-width:1240px;margin:0 auto;padding:20px 16px 48px}
h1{font-size:1.6rem;line-height:1.25;margin:0;overflow-wrap:anywhere}
h2{font-size:1.15rem;margin:36px 0 4px}
h3{font-size:1rem;margin:0 0 6px}
p{margin:2px 0 10px}
.quiet,figure p,.facts dt{color:var(--quiet)}
code{font-size:.86em;overflow-wrap:anywhere}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(130px,1fr));gap:10px;margin:18px 0 8px}
.facts div,figure,.sheet li{background:var(--panel);border:1px solid var(--line);border-radius:10px}
.facts div{padding:10px 14px}
.facts dt{font-size:.86rem}
.facts dd{margin:0;font-size:1.35rem;font-weight:600;font-variant-numeric:tabular-nums;line-height:1.3}
.facts small{display:block;font-size:.82rem;font-weight:400;color:var(--quiet)}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,330px),1fr));gap:12px;align-items:start}
figure{margin:0;padding:14px 12px 6px}
figure svg{display:block;width:100%;height:auto;max-width:520px;margin:0 auto}
figure p{font-size:.9rem;margin:6px 4px}
svg text{font-size:11px;fill:var(--quiet)}
svg .name{fill:var(--text)}
svg .row{font-size:12px;fill:var(--text)}
.mid{text-anchor:middle}.end{text-anchor:end}
.grid{stroke:var(--line);stroke-width:1;fill:none}
.legend span{margin-right:14px;white-space:nowrap}
.dots{fill:none;stroke:currentColor;stroke-width:4.6;stroke-linecap:round;opacity:.8}
.triangles{fill:currentColor;stroke:none;opacity:.9}
.crosses{fill:none;stroke:currentColor;stroke-width:1.7;opacity:.95}
.c1{color:var(--c1)}.c2{color:var(--c2)}.c3{color:var(--c3)}
.c4,.verdict.possible{color:var(--good)}.c5,.verdict.strains{color:var(--hard)}.c6,.verdict.impossible{color:var(--bad)}
tspan.c4{fill:var(--good)}tspan.c5{fill:var(--hard)}tspan.c6{fill:var(--bad)}
.bars{fill:currentColor;opacity:.75}
.median{stroke:var(--text);stroke-width:1.5}
.s1{color:var(--s1);fill:var(--s1)}.s2{color:var(--s2);fill:var(--s2)}.s3{color:var(--s3);fill:var(--s3)}
.s4{color:var(--s4);fill:var(--s4)}.s5{color:var(--s5);fill:var(--s5)}
.cell{fill-opacity:.2}
svg .style{font-size:10px;fill:var(--text)}
svg .halo{paint-order:stroke;stroke:var(--panel);stroke-width:3px}
svg .count{font-size:10px}
.sheet{list-style:none;margin:12px 0 0;padding:0;display:grid;grid-template-columns:repeat(auto-fill,minmax(174px,1fr));gap:10px}
.sheet li{padding:8px 10px;font-size:.82rem;line-height:1.4}
.sheet svg{display:block;width:100%;height:auto;margin-bottom:4px}
.sheet p{margin:0;color:var(--quiet);overflow-wrap:anywhere}
.sheet .words{color:var(--text);font-weight:600}
.sheet .id{font-variant-numeric:tabular-nums}
.judged{display:flex;flex-wrap:wrap;justify-content:space-between;column-gap:4px}
.verdict{white-space:nowrap}
.body{fill:none;stroke:currentColor;stroke-linecap:round;stroke-linejoin:round}
.body .head{fill:currentColor;stroke:none}
.trunk{stroke-width:7}.leg{stroke-width:5.5}.arm{stroke-width:4.5}
.start{color:var(--strong);opacity:.55}.middle{color:var(--quiet);opacity:.5}.ending{color:var(--text)}
.scale{color:var(--quiet);opacity:.28}
.moving{fill:none;stroke:var(--accent);stroke-linecap:round;stroke-linejoin:round;stroke-width:5.5}
.way{fill:none;stroke:var(--goal);stroke-width:2;stroke-dasharray:1 4.5;stroke-linecap:round}
.goal{fill:none;stroke:var(--goal);stroke-width:2.2}
.floor{stroke:var(--strong);stroke-width:1.5}
.obstacle{fill:none;stroke:var(--quiet);stroke-width:1.3;opacity:.8}
.seat{fill:none;stroke:var(--strong);stroke-width:5;stroke-linecap:round}
@media (max-width:480px){.sheet{grid-template-columns:repeat(2,1fr)}.sheet li{padding:8px}main{padding:14px 10px 32px}}
)css";

std::string fact(std::string_view name, std::string_view value, std::string_view more) {
  return fmt::format("<div><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n", xml_escaped(name),
                     xml_escaped(value), xml_escaped(more));
}

std::string share(std::uint64_t part, std::uint64_t all) {
  const double percent =
      all == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
  return fmt::format("{:.{}f} %", percent, percent > 99.0 && part < all ? 1 : 0);
}

// Words for a duration, "12 min", "3.2 h".
std::string time_words(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string size_words(std::uint64_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 1e6) return fmt::format("{:.0f} kB", size / 1e3);
  return size < 1e9 ? fmt::format("{:.1f} MB", size / 1e6) : fmt::format("{:.2f} GB", size / 1e9);
}

std::string facts_html(const DataFolder& data, const ShowFacts& facts) {
  const auto of = [&facts](Outcome outcome) {
    return facts.tasks[static_cast<std::size_t>(outcome)];
  };
  const auto verdict = [&facts](Verdict one) {
    return facts.motions[static_cast<std::size_t>(one)];
  };
  const DatasetPlan& plan = data.plan;
  const std::uint64_t tasks = facts.task_count();
  const std::uint64_t motions = facts.motion_count();
  std::string text = "<dl class=\"facts\">\n";
  text += fact("tasks", grouped(tasks), "of " + grouped(plan.tasks()) + " in the plan");
  text += fact("reached", share(of(Outcome::reached), tasks),
               fmt::format("{} tasks; {} missed, {} refused", grouped(of(Outcome::reached)),
                           grouped(of(Outcome::unreachable)), grouped(of(Outcome::refused))));
  text += fact(
      "motions", grouped(motions),
      fmt::format("{} a task", tasks == 0 ? "0"
                                          : fmt::format("{:.1f}", static_cast<double>(motions) /
                                                                      static_cast<double>(tasks))));
  text += fact("possible", share(verdict(Verdict::possible), motions),
               fmt::format("{} strain, {} impossible", grouped(verdict(Verdict::strains)),
                           grouped(verdict(Verdict::impossible))));
  const bool many = facts.bodies.size() >= kDifferentMost;
  text += fact("bodies", (many ? "over " : "") + grouped(facts.bodies.size()),
               plan.people() > 0 ? fmt::format("of {} people in the plan", grouped(plan.people()))
                                 : "that differ");
  text += fact("in motion", time_words(facts.seconds), "all motions together");
  text += fact("on disk", size_words(facts.bytes),
               fmt::format("{} of {} shards", grouped(data.shards.size()), grouped(plan.shards())));
  return text + "</dl>\n";
}

std::string about_html(const DataFolder& data, const ShowFacts& facts) {
  const DatasetPlan& plan = data.plan;
  std::string who;
  for (const auto& [name, count] : facts.characters) {
    who += fmt::format("{}{} ({} tasks)", who.empty() ? "" : ", ", name, grouped(count));
  }
  std::string series;
  for (const DatasetSeries one : plan.series()) {
    series += fmt::format("{}{}", series.empty() ? "" : ", ", word_of(one));
  }
  std::string text = fmt::format("Characters: {}. Series kept: {}. Motions kept: {}. Seed {}.",
                                 who.empty() ? "none" : who, series.empty() ? "none" : series,
                                 word_of(plan.motions()), plan.seed());
  if (!plan.licence().empty()) text += " Licence: " + plan.licence() + ".";
  text = fmt::format("<p class=\"quiet\">{} Plan <code>{}</code></p>\n", xml_escaped(text),
                     plan.digest());
  if (data.shards.size() < plan.shards()) {
    text += fmt::format(
        "<p><b>{} of {} shards are not here</b>; all that follows is of those that "
        "are.</p>\n",
        grouped(plan.shards() - data.shards.size()), grouped(plan.shards()));
  }
  return text;
}

std::string title_of(const DataFolder& data) {
  if (!data.plan.name().empty()) return data.plan.name();
  std::error_code failed;
  const auto whole = std::filesystem::weakly_canonical(data.folder, failed);
  return "Data set " + (failed ? data.folder : whole).filename().string();
}

std::string page(const DataFolder& data, const ShowFacts& facts,
                 const std::vector<SheetMotion>& motions) {
  const std::string title = xml_escaped(title_of(data));
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n<title>{0}</title>\n<style>{1}</style>\n"
      "</head><body><main>\n<h1>{0}</h1>\n",
      title, kStyle);
  text += facts_html(data, facts) + about_html(data, facts);
  text += "<section><h2>Where the goals are</h2>\n" +
          reach_html(facts, motions.empty() ? nullptr : &motions.front()) + "</section>\n";
  text += "<section><h2>How the motions are</h2>\n<div class=\"plots\">\n" + styles_html(facts) +
          scores_html(facts) + people_html(facts) + "</div></section>\n";
  text += fmt::format(
      "<section><h2>{} motions</h2>\n<p class=\"quiet\">Drawn by the plan's seed, spread over the "
      "ways "
      "in which motions end. Light is the start, dark the end; dots are the way to the goal, a "
      "ringed "
      "cross. The viewer stands on the side of what moves.</p>\n{}</section>\n",
      motions.size(), sheet_html(motions));
  return text + "</main></body></html>\n";
}

}  // namespace

Result<std::string> show_dataset(const std::filesystem::path& folder,
                                 const ShowSettings& settings) {
  if (settings.motions > kShownMax) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("are {}; allowed are 0 to {}", settings.motions, kShownMax), "motions");
  }
  SHG_TRY_ASSIGN(const DataFolder data, DataFolder::open(folder));
  SHG_TRY_ASSIGN(const ShowFacts facts, gather_facts(data, settings));
  SHG_TRY_ASSIGN(const std::vector<SheetMotion> motions,
                 read_sheet(data, spread(facts, settings.motions)));
  return page(data, facts, motions);
}

}  // namespace shigusa
