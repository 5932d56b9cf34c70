// SPDX-License-Identifier: Apache-2.0
// Any numbers of a spec.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/study/tune.hpp"

#include "study/src/optimum/optimum.hpp"

namespace jounce::study_detail {
namespace {

using Json = nlohmann::ordered_json;

std::string shown_unit(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

std::string figures_text(const TuneOutcome& outcome, bool maximize) {
  std::string text;
  for (std::size_t i = 0; i < outcome.figures.size(); ++i) {
    const TunedFigure& f = outcome.figures[i];
    std::string wanted = i > 0 ? "" : maximize ? "maximized" : "minimized";
    if (f.at_least) wanted += "at least " + number(*f.at_least);
    if (f.at_most) wanted += (f.at_least ? ", at most " : "at most ") + number(*f.at_most);
    text += fmt::format("  {:<28} {:>12} {:>12} {:<10} {}\n", f.name,
                        f.given ? rounded(*f.given) : "-", rounded(f.reached), f.unit, wanted);
  }
  return text;
}

std::string tune_text(const TuneOutcome& outcome, const Spec& spec) {
  const SearchOutcome& search = outcome.search;
  const std::string count = counted(search.evaluations, "evaluation");
  const bool counts = search.reason.find(count) != std::string::npos;
  std::string text = fmt::format("{}: {}{}\n", name(search.status), search.reason,
                                 counts ? "" : " (" + count + ")");
  text += fmt::format("  {:<28} {:>12} {:>12}\n", "", "given",
                      outcome.usable() ? "reached" : "nearest");
  text += figures_text(outcome, spec.parameters->maximize);
  for (const TunedNumber& n : outcome.numbers)
    text += fmt::format("  {:<28} {:>12} {:>12} {:<10} from {} to {}\n", n.key, number(n.given),
                        outcome.usable() ? number(n.reached) : rounded(n.reached),
                        shown_unit(n.unit), number(n.lower), number(n.upper));
  for (const std::string& sentence : outcome.active) text += fmt::format("  - {}\n", sentence);
  if (!outcome.usable()) {
    const Labels labels{spec.units, spec.over_master(), {}};
    if (search.answer.possible)
      text += fmt::format("{}:\n{}",
                          outcome.report.ok() ? "a requirement above is broken; the limits there"
                                              : "the least violation found",
                          full_text(outcome.report, labels));
    return text;
  }
  if (outcome.active.empty())
    text += fmt::format("  - no limit and no end of a range is reached\n");
  return text;
}

Json figure_json(const TunedFigure& f) {
  Json all{{"name", f.name}, {"unit", f.unit}};
  if (f.given) all["given"] = *f.given;
  all["reached"] = f.reached;
  if (f.at_least) all["at_least"] = *f.at_least;
  if (f.at_most) all["at_most"] = *f.at_most;
  return all;
}

Json tune_json(const TuneOutcome& outcome, const Spec& spec) {
  Json numbers = Json::array();
  for (const TunedNumber& n : outcome.numbers)
    numbers.push_back({{"key", n.key},
                       {"unit", n.unit},
                       {"given", n.given},
                       {"reached", n.reached},
                       {"range", {n.lower, n.upper}},
                       {"at_bound", n.at_bound}});
  Json figures = Json::array();
  for (const TunedFigure& f : outcome.figures) figures.push_back(figure_json(f));
  const Labels labels{spec.units, spec.over_master(), {}};
  const SearchOutcome& search = outcome.search;
  return {{"status", name(search.status)},
          {"usable", outcome.usable()},
          {"reason", search.reason},
          {spec.parameters->maximize ? "maximize" : "minimize", spec.parameters->figure},
          {"figures", figures},
          {"parameters", numbers},
          {"active", outcome.active},
          {"limits", Json::parse(to_json(outcome.report, labels))},
          {"evaluations", search.evaluations},
          {"searches", search.starts}};
}

}  // namespace

SpecOptimum optimum_of_numbers(const Spec& spec, const OptimumProgress& keep_going) {
  const double sign = spec.parameters->maximize ? -1 : 1;
  const TuneOutcome outcome = tune(
      spec, reported_to(keep_going, [&](const OptimizeProgress& p) {
        return p.reached ? fmt::format("{} {}", spec.parameters->figure, rounded(sign * *p.reached))
                         : std::string("nothing feasible yet");
      }));
  return {.text = tune_text(outcome, spec),
          .json = tune_json(outcome, spec).dump(),
          .spec = outcome.usable() ? std::optional(outcome.text) : std::nullopt};
}

}  // namespace jounce::study_detail
