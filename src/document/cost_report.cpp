// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <shigusa/draw.hpp>
#include <shigusa/report.hpp>

#include "core/index.hpp"
#include "core/say.hpp"
#include "core/text.hpp"
#include "draw/candidate_strip.hpp"
#include "draw/cost_plots.hpp"

namespace shigusa {
namespace {

// Where the methods ask for a change at once, of which CostPeaks::worst is a share.
constexpr double kRebaAtOnce = 11.0;
constexpr double kRulaAtOnce = 7.0;
constexpr double kLiftAtOnce = 3.0;
constexpr double kNoLoad = 2.0;

constexpr double kPerKilo = 1e-3;
constexpr std::size_t kJoints = 6;     // joints listed, the most loaded first
constexpr std::size_t kReasons = 3;    // of the verdict
constexpr double kStripWidth = 180.0;  // mm
constexpr double kLeastStrip = 100.0;  // mm, that may be drawn
constexpr int kStripPoses = 8;
constexpr double kPoseWidth = 27.0;  // mm, of a worst moment
constexpr double kSamePose = 0.1;    // s, worst moments that near are one pose

constexpr std::array<std::string_view, kRebaLevels> kRebaWords{"negligible", "low", "medium",
                                                               "high", "very high"};
constexpr std::array<std::string_view, kRulaLevels> kRulaWords{"acceptable", "investigate",
                                                               "change soon", "change at once"};

constexpr std::string_view kReportStyle =
    "@page{size:A4;margin:11mm}"
    "body{font:10.5px/1.35 \"DejaVu Sans\",system-ui,sans-serif;color:#111;background:#fff;"
    "max-width:188mm;margin:0 auto;padding:4mm 0}"
    "h1{font-size:17px;margin:0 0 2px}h2{font-size:12px;margin:9px 0 3px;border-bottom:1px solid "
    "#bbb}p{margin:2px 0}.quiet{color:#555}table{border-collapse:collapse;width:100%}"
    "th,td{text-align:left;padding:1px 6px;vertical-align:top;font-weight:normal}"
    "thead th{color:#555;border-bottom:1px solid #ccc}td.n{text-align:right}"
    "img{display:block;max-width:100%}td.bar{width:210px}td.bar svg{width:204px;height:16px}"
    "td.value{white-space:nowrap;padding:1px 6px}td.value+td{padding-left:6px}"
    ".g1{fill:#3a9d4a;background:#bfe3c4}.g2{fill:#9ccc65;background:#dcedc8}"
    ".y{fill:#f2c230;background:#fbe9a8}.o{fill:#ee8a2b;background:#fbd3ab}"
    ".r{fill:#d23a32;background:#f4b9b5}.pale{opacity:.3}"
    ".mark{stroke:#000;stroke-width:2.4;fill:none}.line{stroke:#111;stroke-width:1.1;fill:none}"
    ".begin{stroke:#555;stroke-width:.6;stroke-dasharray:1.5 2;fill:none}"
    ".plots{display:grid;grid-template-columns:1fr 1fr;gap:3px 8px}"
    ".plot{width:100%}.plot text{font-size:7px;fill:#333}.plot .name{font-size:8px;fill:#000}"
    ".page{break-before:page}ul{margin:2px 0;padding-left:15px}"
    "tr,li,.plot{break-inside:avoid}";

std::string_view word_of_side(Side side) { return side == Side::left ? "left" : "right"; }

double kilo(double value) { return kPerKilo * value; }

std::string head_row(std::initializer_list<std::string_view> names) {
  std::string row = "<thead><tr>";
  for (const std::string_view name : names) row += fmt::format("<th>{}</th>", name);
  return row + "</tr></thead>";
}

// A cell with a value in its scale's colour; a dash where there is none.
std::string cell(const CostScale& scale, const std::optional<double>& value) {
  if (!value) return "<td>–</td>";
  return fmt::format("<td class=\"value {}\">{:.3g}</td>", colour_of(scale, *value), *value);
}

// An SVG as a picture in the page, of a width (mm), apart from its names.
std::string picture(std::string_view svg, std::string_view about, double width) {
  std::string data;
  for (const char c : svg) {
    switch (c) {
      case '"':
        data += "%22";
        break;
      case '#':
        data += "%23";
        break;
      case '%':
        data += "%25";
        break;
      case '&':
        data += "%26";
        break;
      case '\n':
        data += "%0A";
        break;
      default:
        data += c;
    }
  }
  return fmt::format(
      "<img alt=\"{}\" style=\"width:{:g}mm\" src=\"data:image/svg+xml;charset=utf-8,{}\"/>\n",
      markup_text(about), width, data);
}

// The page of one report.
class ReportPage {
 public:
  explicit ReportPage(const CostReport& report) : report_(report), cost_(report.cost) {}

  Result<std::string> html() const {
    const std::string name = title();
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
        "<meta name=\"viewport\" content=\"width=device-width\"/><title>{0}</title>"
        "<style>{1}</style></head><body>\n<h1>{0}</h1>\n",
        markup_text(name), kReportStyle);
    text += who();
    SHG_TRY_ASSIGN(const std::string pictures, strips());
    text += pictures + bars() + actions() + helps();
    text += "<div class=\"page\"></div>\n";
    text += plots() + lifts() + zones() + joints() + unknown();
    return text + "</body></html>\n";
  }

 private:
  [[nodiscard]] std::string title() const {
    if (!report_.title.empty()) return report_.title;
    const Task& task = report_.task;
    return task.actions.empty() ? goals_title(task.goals, task.body.stature())
                                : actions_title(task.actions);
  }

  [[nodiscard]] std::string who() const {
    const BodyModel& body = report_.task.body;
    const Judgement& judgement = report_.candidate.judgement;
    std::string text =
        fmt::format("<p>{} of {:.2f} m and {:.0f} kg. {}, in {:.1f} s.</p>\n<p><b>{}</b>",
                    markup_text(body.name() == "human" ? "A person" : body.name()), body.stature(),
                    body.mass(), markup_text(capitalised(asked_words(report_.task))),
                    report_.candidate.motion.clip.duration(), verdict_sentence(judgement));
    for (std::size_t k = 0; k < std::min(kReasons, judgement.reasons.size()); ++k) {
      text += " " + markup_text(reason_sentence(judgement.reasons[k]));
    }
    return text + "</p>\n";
  }

  // Frames in which something is at its worst, with what it is.
  [[nodiscard]] std::vector<std::pair<int, std::string>> worst_frames() const {
    std::vector<std::pair<int, std::string>> worst;
    const Clip& clip = report_.candidate.motion.clip;
    const auto add = [&](double time, std::string what) {
      const int frame =
          std::clamp(static_cast<int>(std::lround(time / clip.frame_time)), 0, clip.frames - 1);
      for (auto& [other, says] : worst) {
        if (std::abs(other - frame) * clip.frame_time > kSamePose) continue;
        says += ", " + what;
        return;
      }
      worst.emplace_back(frame, std::move(what));
    };
    if (cost_.reba) add(cost_.reba->time, fmt::format("REBA {}", cost_.reba->score.worst));
    if (cost_.rula) add(cost_.rula->time, fmt::format("RULA {}", cost_.rula->score.worst));
    if (cost_.back && cost_.back->forces) {
      const Peak& peak = cost_.back->forces->compression;
      add(peak.time, fmt::format("L5/S1 {:.1f} kN", kilo(peak.value)));
    } else if (cost_.back) {
      add(cost_.back->moment.time, fmt::format("L5/S1 {:.0f} N·m", cost_.back->moment.value));
    }
    std::sort(worst.begin(), worst.end());
    return worst;
  }

  [[nodiscard]] Result<std::string> strips() const {
    MotionStrip strip = candidate_strip(report_.task, report_.candidate);
    strip.settings.width_mm = kStripWidth;
    if (strip.settings.frames.empty()) strip.settings.poses = kStripPoses;
    SHG_TRY_ASSIGN(const std::string whole,
                   draw_strip(strip.motion, strip.overlay, strip.settings));
    std::string text = picture(whole, "The motion as poses from left to right", kStripWidth);
    const auto worst = worst_frames();
    if (worst.empty()) return text;
    // times count from the first pose
    strip.settings.frames = {0};
    std::string caption;
    for (const auto& [frame, says] : worst) {
      if (frame > 0) strip.settings.frames.push_back(frame);
      caption += fmt::format("{}{:.2f} s: {}", caption.empty() ? "" : "; ",
                             frame * report_.candidate.motion.clip.frame_time, says);
    }
    strip.overlay.caption = "Worst moments. " + caption;
    strip.overlay.actions.clear();
    const auto poses = static_cast<double>(strip.settings.frames.size());
    const double width = std::min(kStripWidth, kPoseWidth * poses);
    strip.settings.width_mm = std::max(width, kLeastStrip);
    SHG_TRY_ASSIGN(const std::string moments,
                   draw_strip(strip.motion, strip.overlay, strip.settings));
    return text + picture(moments, strip.overlay.caption, width);
  }

  // `words`: of the levels; `soon`: the one at which something should be changed soon.
  static std::string posture_row(const CostScale& scale, const PostureCourse& course,
                                 std::span<const std::string_view> words, std::size_t soon) {
    std::size_t level = 0;
    for (std::size_t k = 0; k < course.above.size(); ++k) {
      if (course.above[k] > 0.0) level = k;
    }
    return bar_row(scale, course.score.worst,
                   fmt::format("{}; {} side at {:.2f} s; mean {:.1f}; {:.0f} % of the time "
                               "{} or more",
                               words[level], word_of_side(course.side), course.time,
                               course.score.mean, 100.0 * course.above[soon], words[soon]));
  }

  [[nodiscard]] std::string bars() const {
    std::string rows;
    if (cost_.reba) rows += posture_row(kRebaScale, *cost_.reba, kRebaWords, 3);
    if (cost_.rula) rows += posture_row(kRulaScale, *cost_.rula, kRulaWords, 2);
    if (cost_.back && cost_.back->forces) {
      const BackForcesCourse& forces = *cost_.back->forces;
      std::string about = fmt::format(
          "at {:.2f} s; limits {:.1f} and {:.1f} kN; {:.0f} % of the time above the first",
          forces.compression.time, kilo(kBackActionLimit), kilo(kBackPermissible),
          100.0 * forces.above_action);
      if (forces.limit) about += fmt::format("; by age and sex {:.1f} kN", kilo(*forces.limit));
      about += fmt::format("; shear {:.0f} N", forces.shear.value);
      rows += bar_row(kCompressionScale, kilo(forces.compression.value), about);
    }
    if (cost_.back) {
      rows += bar_row(kMomentScale, cost_.back->moment.value,
                      fmt::format("at {:.2f} s", cost_.back->moment.time));
    }
    for (const LiftCost& lift : cost_.lifts) {
      if (lift.index) {
        rows += bar_row(kLiftScale, *lift.index,
                        fmt::format("{}, {:g} kg", markup_text(lift.span.thing), lift.span.mass));
      } else {
        rows += fmt::format(
            "<tr><th>Lifting index</th><td></td><td class=\"value r\">none</td>"
            "<td>{}, {:g} kg: no load is allowed</td></tr>\n",
            markup_text(lift.span.thing), lift.span.mass);
      }
    }
    return "<h2>What it costs, at its worst</h2>\n<table>" + rows + "</table>\n";
  }

  // Peaks of the frames within a time.
  [[nodiscard]] std::string span_row(std::string_view name, double from, double to) const {
    std::optional<double> reba;
    std::optional<double> rula;
    std::optional<double> compression;
    std::optional<double> moment;
    const auto raise = [](std::optional<double>& most, double value) {
      most = most ? std::max(*most, value) : value;
    };
    const double half = 0.5 * report_.candidate.motion.clip.frame_time;
    for (const FrameCost& frame : cost_.frames) {
      if (frame.time < from - half || frame.time > to + half) continue;
      for (const auto& side : frame.reba) {
        if (side) raise(reba, side->score);
      }
      for (const auto& side : frame.rula) {
        if (side) raise(rula, side->score);
      }
      if (frame.back) raise(compression, kilo(frame.back->compression));
      if (frame.back_moment) raise(moment, std::fabs(*frame.back_moment));
    }
    return fmt::format("<tr><td>{}</td><td class=\"n\">{:.2f}–{:.2f} s</td>{}{}{}{}</tr>\n",
                       markup_text(name), from, to, cell(kRebaScale, reba), cell(kRulaScale, rula),
                       cell(kCompressionScale, compression), cell(kMomentScale, moment));
  }

  [[nodiscard]] std::string actions() const {
    std::string rows;
    const auto& done = report_.candidate.actions;
    for (std::size_t a = 0; a < done.size() && a < report_.task.actions.size(); ++a) {
      rows += span_row(fmt::format("{}. {}", a + 1, action_words(report_.task.actions[a])),
                       done[a].start, done[a].end);
    }
    if (rows.empty()) {
      rows = span_row("the whole motion", 0.0, report_.candidate.motion.clip.duration());
    }
    return "<h2>By action</h2>\n<table>" +
           head_row({"action", "time", "REBA", "RULA", "compression, kN", "moment, N·m"}) + rows +
           "</table>\n";
  }

  [[nodiscard]] static std::string peaks_cells(const CostPeaks& peaks) {
    const auto number = [](const auto& value) {
      return value ? std::optional<double>(*value) : std::nullopt;
    };
    std::string cells = cell(kRebaScale, number(peaks.reba)) + cell(kRulaScale, number(peaks.rula));
    cells += cell(kCompressionScale,
                  peaks.compression ? std::optional(kilo(*peaks.compression)) : std::nullopt);
    cells += cell(kMomentScale, peaks.moment);
    cells +=
        peaks.no_load ? "<td class=\"value r\">none allowed</td>" : cell(kLiftScale, peaks.lifting);
    return cells;
  }

  [[nodiscard]] std::string helps() const {
    if (report_.changes.empty()) return {};
    std::string rows =
        fmt::format("<tr><td>as it is</td>{}<td>{}</td></tr>\n", peaks_cells(cost_peaks(cost_)),
                    word_of(report_.candidate.judgement.verdict));
    for (const TriedChange& tried : report_.changes) {
      rows += fmt::format("<tr><td>{}</td>{}<td>{}</td></tr>\n", markup_text(tried.change),
                          peaks_cells(tried.peaks), word_of(tried.verdict));
    }
    return "<h2>What would help most</h2>\n<p class=\"quiet\">Each change was searched anew; the "
           "worst moments of its best motion.</p>\n<table>" +
           head_row({"change", "REBA", "RULA", "compression, kN", "moment, N·m", "lifting index",
                     "verdict"}) +
           rows + "</table>\n";
  }

  template <class Value>
  [[nodiscard]] PlotLine line(std::string_view name, Value&& value) const {
    PlotLine made{name, {}};
    made.values.reserve(cost_.frames.size());
    for (const FrameCost& frame : cost_.frames) made.values.push_back(value(frame));
    return made;
  }

  [[nodiscard]] std::string plots() const {
    const double duration = report_.candidate.motion.clip.duration();
    std::vector<double> begins;
    for (const ActionResult& action : report_.candidate.actions) begins.push_back(action.start);
    std::string text;
    const auto of_sides = [&](const CostScale& scale, auto member) {
      std::vector<PlotLine> lines;
      for (const std::size_t side : {0U, 1U}) {
        lines.push_back(line(side == 0 ? "left" : "right", [&](const FrameCost& frame) {
          const auto& score = (frame.*member)[side];
          return score ? std::optional<double>(score->score) : std::nullopt;
        }));
      }
      text += plot_over_time(scale, lines, duration, begins);
    };
    if (cost_.reba) of_sides(kRebaScale, &FrameCost::reba);
    if (cost_.rula) of_sides(kRulaScale, &FrameCost::rula);
    const auto alone = [&](const CostScale& scale, auto value) {
      text += plot_over_time(scale, std::array{line("", value)}, duration, begins);
    };
    if (cost_.back && cost_.back->forces) {
      alone(kCompressionScale, [](const FrameCost& frame) {
        return frame.back ? std::optional(kilo(frame.back->compression)) : std::nullopt;
      });
    }
    if (cost_.back) {
      alone(kMomentScale, [](const FrameCost& frame) {
        return frame.back_moment ? std::optional(std::fabs(*frame.back_moment)) : std::nullopt;
      });
    }
    return "<h2>Over time</h2>\n<div class=\"plots\">" + text + "</div>\n";
  }

  [[nodiscard]] std::string lifts() const {
    if (cost_.lifts.empty()) return {};
    std::string rows;
    const auto row = [&](std::string_view name, const Lift& lift, const LiftIndex& index) {
      rows += fmt::format(
          "<tr><td>{}</td><td>{:.0f}</td><td>{:.0f}</td><td>{:.0f}</td><td>{:.0f}</td>"
          "<td>{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f}</td><td>{:.1f}</td>",
          markup_text(name), 100.0 * lift.horizontal, 100.0 * lift.vertical, 100.0 * lift.travel,
          degrees(lift.asymmetry), index.horizontal, index.vertical, index.travel, index.asymmetry,
          index.frequency, index.coupling, index.limit);
      rows += cell(kLiftScale, index.index) + "</tr>\n";
    };
    std::string notes;
    for (const LiftCost& lift : cost_.lifts) {
      row(fmt::format("{} taken", lift.span.thing), lift.origin, lift.at_origin);
      row(fmt::format("{} put", lift.span.thing), lift.destination, lift.at_destination);
      for (const Message& note : lift.notes) {
        notes += fmt::format("<p class=\"quiet\">{}</p>\n", markup_text(note.text));
      }
    }
    if (cost_.repeated && cost_.repeated->index) {
      notes += fmt::format("<p>Composite index of all lifts: {:.2f}</p>\n", *cost_.repeated->index);
    }
    return "<h2>Lifts by the revised NIOSH equation</h2>\n<table>" +
           head_row(
               {"lift", "H, cm", "V, cm", "D, cm", "A, °", "HM VM DM AM FM CM", "RWL, kg", "LI"}) +
           rows + "</table>\n" + notes;
  }

  [[nodiscard]] std::string zones() const {
    if (cost_.zones.empty()) return {};
    std::string rows;
    for (const ZoneCourse& zone : cost_.zones) {
      const std::string name =
          fmt::format("{}{}{}", zone.side ? word_of_side(*zone.side) : std::string_view(),
                      zone.side ? " " : "", part_words(word_of(zone.part)));
      rows += fmt::format("<tr><td>{}</td><td class=\"n\">{:.0f}°</td>", markup_text(name),
                          degrees(zone.greatest));
      for (const double share : zone.shares) {
        rows += fmt::format("<td class=\"n\">{:.0f} %</td>", 100.0 * share);
      }
      rows += fmt::format("<td>{}</td></tr>\n",
                          zone.verdict ? part_words(word_of(*zone.verdict)) : "–");
    }
    return "<h2>Zones of EN 1005-4</h2>\n<table>" +
           head_row({"part", "greatest", "below 0°", "zone 0", "zone 1", "zone 2", "verdict"}) +
           rows + "</table>\n";
  }

  [[nodiscard]] std::string joints() const {
    std::vector<StrengthCost> most(cost_.strengths);
    std::erase_if(most, [](const StrengthCost& one) { return !(one.strength > 0.0); });
    std::stable_sort(most.begin(), most.end(), [](const StrengthCost& a, const StrengthCost& b) {
      return a.torque * b.strength > b.torque * a.strength;
    });
    if (most.size() > kJoints) most.resize(kJoints);
    std::string rows;
    for (const StrengthCost& one : most) {
      rows += fmt::format(
          "<tr><td>{}</td><td class=\"n\">{:.0f}</td><td class=\"n\">{:.0f}</td><td "
          "class=\"n\">{:.0f} %</td><td class=\"n\">{:.0f} %</td><td class=\"n\">{:.2f} s</td>"
          "</tr>\n",
          markup_text(part_words(one.dof)), one.torque, one.strength,
          100.0 * one.torque / one.strength, 100.0 * one.able, one.time);
    }
    return "<h2>Strength</h2>\n<table>" +
           head_row({"joint", "needs, N·m", "mean, N·m", "share", "people who could", "at"}) +
           rows + "</table>\n";
  }

  [[nodiscard]] std::string unknown() const {
    const Ergonomics& told = report_.ergonomics;
    std::string text = "<h2>What a motion does not tell</h2>\n<ul>";
    for (const Message& note : cost_.notes) {
      text += fmt::format("<li>{}</li>", markup_text(note.text));
    }
    const std::string recurs = told.moves_per_min
                                   ? fmt::format("{:g} times a minute", *told.moves_per_min)
                                   : std::string("not known");
    text += fmt::format(
        "<li>As told, or by default: coupling {}, {:g} lifts a minute, lifting time {}, postures "
        "held above a minute: {}, repeated: {}, rapid: {}, shock: {}; recurrence {}; age {}.</li>",
        word_of(told.coupling), told.lifts_per_min, word_of(told.lifting_time),
        told.held ? "yes" : "no", told.repeated ? "yes" : "no", told.rapid ? "yes" : "no",
        told.shock ? "yes" : "no", recurs,
        told.age ? fmt::format("{:g}", *told.age) : std::string("not known"));
    text +=
        "<li>Angles are those of the body's model, against its own upright posture. Two "
        "people who rate one posture by REBA differ by 1 or less in three of four "
        "cases.</li><li>L5/S1: one muscle balances the moment; abdominal pressure and opposing "
        "muscles do not count.</li><li>This is no diagnosis, and no proof that a workplace is "
        "safe.</li></ul>\n";
    return text;
  }

  const CostReport& report_;
  const MotionCost& cost_;
};

}  // namespace

namespace {

// Shares of where each method asks for a change at once.
std::vector<double> shares_of(const CostPeaks& peaks) {
  std::vector<double> shares;
  if (peaks.no_load) shares.push_back(kNoLoad);
  if (peaks.reba) shares.push_back(*peaks.reba / kRebaAtOnce);
  if (peaks.rula) shares.push_back(*peaks.rula / kRulaAtOnce);
  if (peaks.compression) shares.push_back(*peaks.compression / kBackPermissible);
  if (peaks.lifting) shares.push_back(*peaks.lifting / kLiftAtOnce);
  return shares;
}

}  // namespace

double CostPeaks::worst() const {
  double most = 0.0;
  for (const double share : shares_of(*this)) most = std::max(most, share);
  return most;
}

double CostPeaks::mean() const {
  const std::vector<double> shares = shares_of(*this);
  double sum = 0.0;
  for (const double share : shares) sum += share;
  return shares.empty() ? 0.0 : sum / static_cast<double>(shares.size());
}

CostPeaks cost_peaks(const MotionCost& cost) {
  CostPeaks peaks;
  if (cost.reba) peaks.reba = cost.reba->score.worst;
  if (cost.rula) peaks.rula = cost.rula->score.worst;
  if (cost.back) peaks.moment = cost.back->moment.value;
  if (cost.back && cost.back->forces) peaks.compression = cost.back->forces->compression.value;
  for (const LiftCost& lift : cost.lifts) {
    peaks.no_load = peaks.no_load || !lift.index;
    if (lift.index) peaks.lifting = std::max(peaks.lifting.value_or(0.0), *lift.index);
  }
  return peaks;
}

Result<std::string> cost_report(const CostReport& report) { return ReportPage(report).html(); }

}  // namespace shigusa
