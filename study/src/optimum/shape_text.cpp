// SPDX-License-Identifier: Apache-2.0
#include "study/src/optimum/shape_text.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "jounce/design/detail/limit_advice.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce::study_detail {
namespace {

using Json = nlohmann::ordered_json;

/// "geo_jerk is kept at 0 at 0 deg (segment 1 push): free.ends = { jerk = "free" } lets it step there".
std::string kept_sentence(std::span<const Finding> findings, const CamRunOutcome& run,
                          const ShapeWords& words) {
  std::string text = "geo_jerk is kept";
  for (std::size_t i = 0; i < findings.size(); ++i)
    text += fmt::format("{} at {} at {}", i == 0 ? "" : " and", rounded(findings[i].value),
                        words.at(findings[i].where, run));
  return text + ": free.ends = { jerk = \"free\" } lets it step there";
}

/// "limited by geo_velocity at 12 deg (segment 1 push), 212 deg (segment 2 back) and 7 more places".
std::string active_sentence(std::span<const Finding> findings, const CamRunOutcome& run,
                            const ShapeWords& words) {
  constexpr std::size_t most = 3;
  const Finding& first = findings.front();
  if (first.rule.family() == RuleFamily::kept) return kept_sentence(findings, run, words);
  const bool objective = first.rule.family() == RuleFamily::objective;
  const bool of_position = first.quantity == "slave";
  std::string text = objective     ? first.quantity + " is attained"
                     : of_position ? "limited by the range of the slave position"
                                   : "limited by " + first.quantity;
  if (first.quantity == "residual" || first.quantity.starts_with("rms "))
    return text;  // these have no place
  for (std::size_t i = 0; i < std::min(most, findings.size()); ++i)
    text += (i == 0 ? " at " : ", ") + words.at(findings[i].where, run);
  if (findings.size() > most) text += " and " + counted(findings.size() - most, "more place");
  return text;
}

/// Places of one rule in one line; an rms has no place.
std::string active_text(const CamRunOutcome& run, const ShapeWords& words) {
  const auto& active = run.shape.active;
  std::string text;
  for (auto first = active.begin(); first != active.end();) {
    const auto last =
        std::find_if(first, active.end(), [&](const Finding& f) { return f.rule != first->rule; });
    if (first->rule.family() != RuleFamily::objective || first->quantity.starts_with("peak"))
      text += fmt::format("  - {}\n", active_sentence({first, last}, run, words));
    first = last;
  }
  return text;
}

std::string run_text(const CamRunOutcome& run, const ShapeWords& words) {
  std::string text = fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>12}   segments {}\n", "",
                                 "given", "reached", "bound", "could save", words.segments(run));
  for (const PrintedFigure& t : printed_figures(run, words)) {
    const auto [unit, size] = words.unit_in_spec(t.spec.unit);
    text += fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>12}   {}\n", t.spec.name,
                        rounded(t.given * size), rounded(t.reached * size),
                        t.bound ? rounded(*t.bound * size) : "-",
                        t.could_save ? fmt::format("{:.2f} %", 100 * *t.could_save) : "-", unit);
  }
  text += active_text(run, words);
  if (const Finding* next = next_limit(run))
    text += fmt::format("  - {} is {:.0f} % below its limit, closest at {}\n", next->quantity,
                        100 * next->margin, words.at(next->where, run));
  return text;
}

Json json_of(const Finding& finding, const ShapeWords& words) {
  return {{"rule", finding.rule.text()},
          {"quantity", finding.quantity},
          {"where", words.place(finding.where)},
          {"value", finding.value},
          {"limit", finding.limit},
          {"margin", finding.margin}};
}

Json json_of(const CamRunOutcome& run, const ShapeWords& words) {
  Json figures = Json::array();
  for (const PrintedFigure& t : printed_figures(run, words)) {
    Json figure{
        {"figure", t.spec.name}, {"unit", t.spec.unit}, {"given", t.given}, {"reached", t.reached}};
    if (t.bound) figure["bound"] = *t.bound;
    if (t.could_save) figure["could_save"] = *t.could_save;
    figures.push_back(std::move(figure));
  }
  Json active = Json::array();
  for (const Finding& finding : run.shape.active) active.push_back(json_of(finding, words));
  Json segments = Json::array();
  for (const std::size_t i : run.segments) segments.push_back(i + 1);
  Json object{{"segments", segments},
              {"status", name(run.shape.status)},
              {"reason", run.shape.reason},
              {"figures", figures},
              {"active", active},
              {"limits", Json::parse(to_json(run.shape.limits, {words.labels().units, true, {}}))},
              {"rounds", run.shape.rounds},
              {"evaluations", run.shape.evaluations}};
  if (const Finding* next = next_limit(run)) object["next"] = json_of(*next, words);
  return object;
}

/// The reason of the outcome: the limit that no shape of a free segment can keep, if there is one.
std::string reason_of(const CamShapeOutcome& outcome, const ShapeWords& words) {
  if (outcome.status != OptimizeStatus::infeasible) return outcome.reason;
  Report free = outcome.limits;
  std::erase_if(free.findings, [&](const Finding& f) {
    return std::none_of(outcome.runs.begin(), outcome.runs.end(), [&](const CamRunOutcome& run) {
      return f.segment && std::count(run.segments.begin(), run.segments.end(), *f.segment) > 0;
    });
  });
  const std::string why = impossible_limit(words.cam(), outcome.best, words.labels(), free);
  return why.empty() ? outcome.reason : why;
}

}  // namespace

std::string text_of(const CamShapeOutcome& outcome, const ShapeWords& words) {
  std::string text = fmt::format("{}: {}\n", name(outcome.status), reason_of(outcome, words));
  for (const CamRunOutcome& run : outcome.runs) {
    text += run_text(run, words);
    if (!run.shape.usable())
      text += fmt::format("{}:\n{}",
                          run.shape.status == OptimizeStatus::infeasible
                              ? "the shape that exceeds the limits least"
                              : "a shape that exceeds the limits; others may exceed them less",
                          full_text(words.in_cam(run.shape.limits, run), words.labels()));
  }
  if (outcome.limits.ok()) return text;
  Report limits = outcome.limits;
  advise_on_limits(words.cam(), outcome.best, words.labels(), limits);
  return text + "limits of the whole cam:\n" + full_text(limits, words.labels());
}

nlohmann::ordered_json json_of(const CamShapeOutcome& outcome, const ShapeWords& words) {
  Json runs = Json::array();
  for (const CamRunOutcome& run : outcome.runs) runs.push_back(json_of(run, words));
  return {{"status", name(outcome.status)},
          {"usable", outcome.usable()},
          {"reason", reason_of(outcome, words)},
          {"runs", runs},
          {"limits", Json::parse(to_json(outcome.limits, words.labels()))}};
}

}  // namespace jounce::study_detail
