// SPDX-License-Identifier: Apache-2.0
// Findings for the limits that an input does not have.
#include <algorithm>
#include <array>
#include <utility>

#include "jounce/design/input.hpp"
#include "jounce/pvt/check.hpp"

namespace jounce {

void add_not_limited(Report& report, const Input& input) {
  const Limits slave = input.spec ? input.spec->slave : Limits{};
  const Limits& own = input.limits;
  const std::array limited{true, own.velocity || slave.velocity,
                           own.acceleration || slave.acceleration, own.jerk || slave.jerk};
  const auto& names = input.labels.over_master ? OverMaster::names : OverTime::names;
  const Ranges ranges = of_motion(input, [](const auto& motion) { return extrema(motion); });
  for (std::size_t k = 1; k < limited.size(); ++k) {
    const Extremum& peak = ranges[k].peak();
    if (limited[k] || peak.value == 0) continue;
    Finding f;
    f.rule = Rule(RuleFamily::unlimited, names[k]);
    f.quantity = names[k];
    f.where = peak.where;
    f.value = peak.value;
    f.severity = Severity::note;
    f.has_limit = false;
    report.findings.push_back(std::move(f));
  }
}

void add_no_limits(Report& report, const Spec* spec) {
  if (has_limits(report)) return;
  const auto gives = [&](const std::string& section) {
    return spec != nullptr &&
           std::any_of(spec->document.places.begin(), spec->document.places.end(),
                       [&](const auto& place) { return place.first.starts_with(section); });
  };
  const bool slave = gives("limits.slave.");
  const bool drive = gives("drive.limits.");
  Finding f;
  f.rule = "warning/no_limits";
  f.quantity = "limits";
  f.severity = Severity::warning;
  f.has_limit = false;
  f.advice = spec != nullptr ? "give [limits] in the spec, or --limit"
                             : "give the spec of the table with --against, or --limit";
  if (slave) {
    f.quantity = "limits.slave";
    f.advice = "add [master] with velocity: these limits are over time";
  } else if (drive) {
    f.quantity = "drive.limits";
    f.advice = "`jounce validate` compares the motion with these limits";
  }
  report.findings.push_back(std::move(f));
  sort(report);
}

}  // namespace jounce
