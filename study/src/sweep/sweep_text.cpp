// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/listed.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/study/detail/sweep_summary.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_designs = 12;

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

std::string text_of(const SweepSpec& spec, std::size_t number, bool with_random) {
  std::string text;
  const auto numbers = spec.numbers(number);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (with_random || !spec.parameters[i].random())
      text += (text.empty() ? "" : ", ") + numbers[i].key + " = " +
              with_unit(rounded(numbers[i].value), spec.parameters[i].unit);
  return text;
}

/// A share that is only rounding beside 1 is 0.
std::string percent(double share) {
  return fmt::format("{:.4g} %",
                     std::abs(share) <= profiles_detail::rounded_input ? 0 : 100 * share);
}

std::string heading(const SweepSpec& spec, const SweepSummary& s) {
  std::string text = (spec.name.empty() ? spec.document.name : spec.name) + ": ";
  text += counted(s.cases, "case");
  if (spec.samples > 1 && s.cases > spec.samples)
    text += fmt::format(", {} combinations of {} samples", s.cases / spec.samples, spec.samples);
  text += fmt::format("; {} within all limits", s.within);
  if (s.yield && spec.independent())
    text += fmt::format(" ({}; with 95 % confidence {} to {})", percent(s.yield->value),
                        percent(s.yield->low), percent(s.yield->high));
  else if (s.yield)
    text += fmt::format(" ({})", percent(s.yield->value));
  if (s.broken > 0) text += fmt::format(", {} beyond a limit", s.broken);
  if (s.impossible > 0) text += fmt::format(", {} impossible", s.impossible);
  if (s.impossible == s.cases) text += ": no case has a motion. Change the values of the sweep";
  return text + "\n";
}

/// The yield of each combination of listed values, one line each.
std::string yield_lines(const SweepSpec& spec, const SweepResult& result, const SweepSummary& s) {
  const std::size_t combinations = s.cases / spec.samples;
  if (!s.yield || combinations < 2 || combinations > most_designs) return "";
  std::string text;
  for (std::size_t i = 0; i < combinations; ++i) {
    std::size_t within = 0;
    for (std::size_t k = 0; k < spec.samples; ++k)
      within += result.rows[i * spec.samples + k].verdict == Verdict::within ? 1U : 0U;
    const Share share = share_of(within, spec.samples);
    const std::string interval =
        spec.independent() ? fmt::format(" ({} to {})", percent(share.low), percent(share.high))
                           : "";
    text += fmt::format("  {}{} at {}\n", percent(share.value), interval,
                        listed_text(spec, i * spec.samples));
  }
  return text;
}

std::string spread_lines(const SweepSummary& s) {
  std::size_t width = 6;
  for (const FigureSpread& f : s.figures)
    width = std::max(width, with_unit(f.given.name, f.given.unit).size() + 2);
  std::string text = fmt::format("\n  {:<{}} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", "figure",
                                 width, "given", "min", "median", "max", "deviation", "limit");
  for (const FigureSpread& f : s.figures) {
    const bool no_limits =
        f.given.name == "margin" && std::isinf(f.least) && std::isinf(f.greatest);
    if (no_limits) continue;
    double scale = f.given.name == "margin" ? 1 : 0;  // a share
    for (const double value : {f.given.value, f.least, f.median, f.greatest})
      if (std::isfinite(value)) scale = std::max(scale, std::abs(value));
    const std::string name =
        f.given.unit.empty() ? f.given.name : f.given.name + " [" + f.given.unit + "]";
    text += fmt::format("  {:<{}} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", name, width,
                        rounded(f.given.value, scale), rounded(f.least, scale),
                        rounded(f.median, scale), rounded(f.greatest, scale),
                        rounded(f.deviation, scale), f.limit ? rounded(*f.limit) : "");
  }
  return text;
}

std::string front_lines(const SweepSpec& spec, const SweepResult& result, const SweepSummary& s) {
  if (spec.objectives.empty()) return "";
  const std::string wanted = listed(spec.objectives, [](const SweepObjective& o) {
    return std::string(o.greatest ? "most " : "least ") + o.figure;
  });
  if (s.front.empty()) return "\n  no case is within all limits: " + wanted + "\n";
  std::string text = fmt::format(
      "\n  {} that no other case dominates ({}):\n",
      s.front.size() == 1 ? "the one case" : fmt::format("{} cases", s.front.size()), wanted);
  const std::size_t shown = std::min(most_designs, s.front.size());
  for (std::size_t i = 0; i < shown; ++i) {
    // Spread over the whole front.
    const std::size_t k = shown > 1 ? i * (s.front.size() - 1) / (shown - 1) : 0;
    const SweepRow& row = result.rows[s.front[k]];
    const std::string values = listed(spec.objectives, [&](const SweepObjective& o) {
      const std::size_t c = column_of(spec, o.figure);
      return with_unit(rounded(row.figures[c]), spec.given[c].unit);
    });
    text += fmt::format("    case {}: {}  at {}\n", row.number + 1, values,
                        numbers_text(spec, row.number));
  }
  if (shown < s.front.size()) text += fmt::format("    ... {} more\n", s.front.size() - shown);
  return text;
}

std::string worst_lines(const SweepSpec& spec, const SweepResult& result, const SweepSummary& s) {
  std::string text;
  const std::size_t margin = column_of(spec, "margin");
  if (s.worst && std::isfinite(result.rows[*s.worst].figures[margin])) {
    const SweepRow& row = result.rows[*s.worst];
    text += fmt::format("\n  worst: case {}, margin {}{}, at {}\n", row.number + 1,
                        percent(row.figures[margin]), row.why.empty() ? "" : " (" + row.why + ")",
                        numbers_text(spec, row.number));
  }
  for (const SweepRow& row : result.rows) {
    if (row.verdict != Verdict::impossible) continue;
    return text + fmt::format("  first impossible: case {}, at {}: {}\n", row.number + 1,
                              numbers_text(spec, row.number), row.why);
  }
  return text;
}

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json json_of(const FigureSpread& f, const SweepResult& result) {
  return {{"name", f.given.name},
          {"unit", f.given.unit},
          {"given", finite(f.given.value)},
          {"limit", f.limit ? Json(*f.limit) : Json()},
          {"min", finite(f.least)},
          {"median", finite(f.median)},
          {"max", finite(f.greatest)},
          {"mean", finite(f.mean)},
          {"deviation", finite(f.deviation)},
          {"min_case", result.rows[f.least_case].number + 1},
          {"max_case", result.rows[f.greatest_case].number + 1}};
}

Json json_of(const SweepSpec& spec, const SweepRow& row) {
  Json numbers = Json::object();
  for (const auto& change : spec.numbers(row.number)) numbers[change.key] = change.value;
  Json figures = Json::object();
  for (std::size_t c = 0; c < spec.given.size(); ++c)
    figures[spec.given[c].name] = finite(row.figures[c]);
  Json object{{"case", row.number + 1}, {"parameters", numbers}, {"figures", figures}};
  if (!row.why.empty()) object["why"] = row.why;
  return object;
}

}  // namespace

std::string numbers_text(const SweepSpec& spec, std::size_t number) {
  return text_of(spec, number, true);
}

std::string listed_text(const SweepSpec& spec, std::size_t number) {
  return text_of(spec, number, false);
}

std::string summary_text(const SweepSpec& spec, const SweepResult& result,
                         const SweepSummary& summary) {
  std::string text = heading(spec, summary) + yield_lines(spec, result, summary);
  if (!summary.figures.empty()) text += spread_lines(summary);
  text += worst_lines(spec, result, summary);
  return text + front_lines(spec, result, summary);
}

std::string summary_json(const SweepSpec& spec, const SweepResult& result,
                         const SweepSummary& summary) {
  Json all{{"ok", summary.within > 0},         {"cases", summary.cases},
           {"within", summary.within},         {"broken", summary.broken},
           {"impossible", summary.impossible}, {"evaluated", result.evaluated},
           {"resumed", result.resumed}};
  if (summary.yield) all["yield"]["share"] = summary.yield->value;
  if (summary.yield && spec.independent())
    all["yield"].update(
        {{"low", summary.yield->low}, {"high", summary.yield->high}, {"confidence", 0.95}});
  all["figures"] = Json::array();
  for (const FigureSpread& f : summary.figures) all["figures"].push_back(json_of(f, result));
  if (summary.worst) all["worst"] = json_of(spec, result.rows[*summary.worst]);
  if (!spec.objectives.empty()) all["front"] = Json::array();
  for (const std::size_t i : summary.front) all["front"].push_back(json_of(spec, result.rows[i]));
  return all.dump(1);
}

std::string SweepClock::text(std::size_t done, std::size_t cases) {
  if (first_ == 0) first_ = done - 1;
  const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - begun_;
  const double left =
      so_far.count() / static_cast<double>(done - first_) * static_cast<double>(cases - done);
  return fmt::format(
      "{} of {}, {} left", done, cases,
      left < 100 ? fmt::format("{:.0f} s", left) : fmt::format("{:.0f} min", left / 60));
}

}  // namespace jounce
