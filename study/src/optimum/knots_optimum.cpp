// SPDX-License-Identifier: Apache-2.0
// Knots of a cam that are free within bounds.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/design/make.hpp"
#include "jounce/optimize/optimize.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/spec/detail/edit.hpp"

#include "study/src/optimum/optimum.hpp"

namespace jounce::study_detail {
namespace {

using Json = nlohmann::ordered_json;

std::string objective_unit(Objective objective, const Units& units) {
  return rate_unit(units.position, units.x, objective == Objective::peak_jerk ? 3 : 2);
}

Labels cam_labels(const Spec& spec) {
  Labels labels{spec.units, true, {}};
  for (const auto& segment : std::get<CamSpec>(spec.subject).segments)
    labels.segments.push_back(std::to_string(labels.segments.size() + 1) +
                              (segment.name.empty() ? "" : " " + segment.name));
  return labels;
}

std::string active_sentence(const Finding& finding, const Labels& labels) {
  if (finding.rule.family() == RuleFamily::bound)
    return fmt::format("{} is at the end of its range, {}", finding.quantity,
                       rounded(finding.limit));
  const std::string where =
      fmt::format("{} {} (segment {})", rounded(finding.where), labels.units.x,
                  labels.segments[finding.segment.value_or(0)]);
  if (finding.rule.family() == RuleFamily::objective)
    return fmt::format("{} is attained at {}", finding.rule.name(), where);
  return fmt::format("{} reaches its limit {} at {}", finding.quantity, rounded(finding.limit),
                     where);
}

std::string knots_text(const CamProblem& problem, const Outcome<CamSpec>& outcome,
                       const Labels& labels) {
  std::string text = fmt::format("{}: {}\n", name(outcome.status), outcome.reason);
  text += fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>10}   ({}, {})\n", "", "given", "reached",
                      "bound", "could save", counted(outcome.evaluations, "evaluation"),
                      counted(outcome.starts, "start"));
  for (std::size_t k = 0; k < outcome.figures.size(); ++k) {
    const FigureResult& r = outcome.figures[k];
    const bool known = *r.bound > 0 || r.reached == 0;
    text += fmt::format("  {:<24} {:>12} {:>12} {:>12} {:>11}   {}\n", r.name, rounded(r.given),
                        rounded(r.reached), known ? rounded(*r.bound) : "-",
                        known ? fmt::format("{:.2f} %", 100 * *r.gap()) : "-",
                        objective_unit(problem.minimize[k], labels.units));
  }
  if (outcome.usable())
    for (const auto& finding : outcome.active)
      text += fmt::format("  - {}\n", active_sentence(finding, labels));
  else
    text += fmt::format("the least violation found:\n{}", full_text(outcome.limits, labels));
  return text;
}

Json knots_json(const CamProblem& problem, const Outcome<CamSpec>& outcome, const Labels& labels) {
  Json objectives = Json::array();
  for (std::size_t k = 0; k < outcome.figures.size(); ++k) {
    const FigureResult& r = outcome.figures[k];
    objectives.push_back({{"objective", r.name},
                          {"unit", objective_unit(problem.minimize[k], labels.units)},
                          {"given", r.given},
                          {"reached", r.reached},
                          {"bound", *r.bound},
                          {"gap", *r.gap()}});
  }
  Json active = Json::array();
  for (const auto& finding : outcome.active)
    active.push_back({{"rule", finding.rule.text()},
                      {"quantity", finding.quantity},
                      {"where", finding.where},
                      {"value", finding.value},
                      {"limit", finding.limit}});
  return {{"status", name(outcome.status)},
          {"usable", outcome.usable()},
          {"reason", outcome.reason},
          {"objectives", objectives},
          {"active", active},
          {"limits", Json::parse(to_json(outcome.limits, labels))},
          {"evaluations", outcome.evaluations},
          {"starts", outcome.starts}};
}

}  // namespace

SpecOptimum optimum_of_knots(const Spec& spec, const OptimumProgress& keep_going) {
  const CamProblem problem = make_problem(spec);
  const Labels labels = cam_labels(spec);
  const auto outcome = optimize(problem, reported_to(keep_going, [&](const OptimizeProgress& p) {
                                  return std::string(name(problem.minimize[p.stage]));
                                }));
  return {.text = knots_text(problem, outcome, labels),
          .json = knots_json(problem, outcome, labels).dump(),
          .spec = outcome.usable() ? std::optional(with_knots(spec, outcome.best)) : std::nullopt};
}

}  // namespace jounce::study_detail
