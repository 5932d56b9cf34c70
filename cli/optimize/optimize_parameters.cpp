// SPDX-License-Identifier: Apache-2.0
// Any numbers of a spec.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/report/report_text.hpp"
#include "jounce/study/tune.hpp"

#include "cli/common/json.hpp"
#include "cli/optimize/optimizing.hpp"
#include "cli/optimize/watched.hpp"

namespace jounce::cli {
namespace {

std::string unit_of(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

void print_figures(std::FILE* out, const TuneOutcome& outcome, bool maximize) {
  for (std::size_t i = 0; i < outcome.figures.size(); ++i) {
    const TunedFigure& f = outcome.figures[i];
    std::string wanted = i > 0 ? "" : maximize ? "as large as can be" : "as small as can be";
    if (f.at_least) wanted += "at least " + number(*f.at_least);
    if (f.at_most) wanted += (f.at_least ? ", at most " : "at most ") + number(*f.at_most);
    fmt::print(out, "  {:<28} {:>12} {:>12} {:<10} {}\n", f.name, f.given ? rounded(*f.given) : "-",
               rounded(f.reached), f.unit, wanted);
  }
}

void print_text(std::FILE* out, const TuneOutcome& outcome, const Spec& spec) {
  const SearchOutcome& search = outcome.search;
  fmt::print(out, "{}: {} ({} evaluations)\n", name(search.status), search.reason,
             search.evaluations);
  fmt::print(out, "  {:<28} {:>12} {:>12}\n", "", "given",
             outcome.usable() ? "reached" : "nearest");
  print_figures(out, outcome, spec.parameters->maximize);
  for (const TunedNumber& n : outcome.numbers)
    fmt::print(out, "  {:<28} {:>12} {:>12} {:<10} from {} to {}\n", n.key, number(n.given),
               outcome.usable() ? number(n.reached) : rounded(n.reached), unit_of(n.unit),
               number(n.lower), number(n.upper));
  for (const std::string& sentence : outcome.active) fmt::print(out, "  - {}\n", sentence);
  if (!outcome.usable()) {
    const Labels labels{spec.units, spec.over_master(), {}};
    if (search.answer.possible)
      fmt::print(out, "least violated:\n{}", full_text(outcome.report, labels));
    return;
  }
  if (outcome.active.empty()) fmt::print(out, "  - no limit and no bound is reached\n");
}

Json json_of(const TunedFigure& f) {
  Json all{{"name", f.name}, {"unit", f.unit}};
  if (f.given) all["given"] = *f.given;
  all["reached"] = f.reached;
  if (f.at_least) all["at_least"] = *f.at_least;
  if (f.at_most) all["at_most"] = *f.at_most;
  return all;
}

Json json_of(const TuneOutcome& outcome, const Spec& spec) {
  Json numbers = Json::array();
  for (const TunedNumber& n : outcome.numbers)
    numbers.push_back({{"key", n.key},
                       {"unit", n.unit},
                       {"given", n.given},
                       {"reached", n.reached},
                       {"range", {n.lower, n.upper}},
                       {"at_bound", n.at_bound}});
  Json figures = Json::array();
  for (const TunedFigure& f : outcome.figures) figures.push_back(json_of(f));
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

TuneOutcome searched(const Spec& spec) {
  const double sign = spec.parameters->maximize ? -1 : 1;
  return watched(
      "searching",
      [&](const OptimizeProgress& p) {
        return p.reached ? fmt::format("{} {}", spec.parameters->figure, rounded(sign * *p.reached))
                         : std::string("nothing feasible yet");
      },
      [&](const KeepGoing& keep_going) { return tune(spec, keep_going); });
}

}  // namespace

int optimize_parameters(const OptimizeArguments& options, const Spec& spec) {
  const TuneOutcome outcome = searched(spec);
  if (!options.json) print_text(text_stream(options), outcome, spec);
  return finish(options, spec, json_of(outcome, spec),
                outcome.usable() ? std::optional(outcome.text) : std::nullopt);
}

}  // namespace jounce::cli
