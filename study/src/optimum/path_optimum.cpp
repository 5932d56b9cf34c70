// SPDX-License-Identifier: Apache-2.0
// The corners of a path, then its timing law.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/design/make.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/study/tune.hpp"

#include "study/src/optimum/optimum.hpp"

namespace jounce::study_detail {
namespace {

/// Share of the duration that is worth the additional knots of the tables.
constexpr double least_gain = 1e-3;

double duration_of(const Spec& spec) {
  return make_axes(spec).front().plan->duration();
}

/// The text of a spec with refine = true after the line [path]; nullopt if it has no such line.
std::optional<std::string> with_refinement(const std::string& text) {
  const std::string header = "[path]";
  for (std::size_t at = text.find(header); at != std::string::npos;
       at = text.find(header, at + 1)) {
    if (at > 0 && text[at - 1] != '\n') continue;
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) return text + "\nrefine = true\n";
    return text.substr(0, end + 1) + "refine = true\n" + text.substr(end + 1);
  }
  return std::nullopt;
}

bool can_be_refined(const Spec& spec) {
  const auto& path = std::get<PathSpec>(spec.subject);
  return !path.overlap && path.override_steps.empty() &&
         !spec.document.places.contains("path.refine");
}

/// Removes the corners on which neither the duration nor a limit depends, such as a corner that each line of the
/// program replaces. Returns a line about each.
std::string drop_idle(Spec& spec) {
  std::vector<SpecParameter>& all = spec.parameters->parameters;
  if (all.empty()) return "";
  std::string text;
  const std::vector<std::size_t> idle = idle_parameters(spec);
  for (auto i = idle.rbegin(); i != idle.rend(); ++i) {
    text = all[*i].key + " has no effect on the duration: it is not searched\n" + text;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  return text;
}

}  // namespace

ParametersSpec path_parameters(const Spec& spec) {
  const bool refines = can_be_refined(spec);
  ParametersSpec chosen;
  chosen.figure = "duration";
  if (!refines || has_corner_parameters(spec)) chosen = corner_parameters(spec);
  chosen.refine = refines;
  return chosen;
}

SpecOptimum optimum_of_path(const Spec& spec, const OptimumProgress& keep_going) {
  SpecOptimum best{.text = "", .json = "{}", .spec = spec.document.text};
  Spec effective = spec;
  const std::string idle = drop_idle(effective);
  if (!effective.parameters->parameters.empty()) best = optimum_of_numbers(effective, keep_going);
  best.text = idle + best.text;
  if (!best.spec) return best;
  const auto text = with_refinement(*best.spec);
  if (!text) {
    best.text += "the timing law is not refined, because the spec has no line [path]\n";
    return best;
  }
  const double before = duration_of(parse_spec(*best.spec, spec.document.name));
  const double after = duration_of(parse_spec(*text, spec.document.name));
  const bool faster = after < before * (1 - least_gain);
  best.text += faster ? fmt::format("refined timing law: {} {} instead of {} {} (refine = true)\n",
                                    rounded(after), spec.time_unit, rounded(before), spec.time_unit)
                      : std::string("a refined timing law is not faster\n");
  auto document = nlohmann::ordered_json::parse(best.json);
  document["refinement"] = {{"unit", spec.time_unit}, {"given", before}, {"reached", after}};
  best.json = document.dump();
  if (faster) best.spec = *text;
  return best;
}

}  // namespace jounce::study_detail
