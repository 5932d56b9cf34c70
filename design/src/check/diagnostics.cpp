// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/diagnostics.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace jounce {
namespace {

/// The file of the findings; a table has no spec.
struct Subject {
  const Spec* spec;
  const Labels& labels;
  const std::string& axis;
};

/// A key in the document of a spec, and its place.
struct KeyPlace {
  std::string key;
  FilePlace place;
};

/// The place of the first of these keys that exists in the document; without a file if there is
/// none.
KeyPlace first_of(const Document& document, const std::vector<std::string>& keys) {
  for (const std::string& key : keys)
    if (const auto at = document.places.find(key); at != document.places.end())
      return {key, {document.name, at->second.line, at->second.column}};
  return {};
}

/// The number in a label such as "3 return" or "line 40"; 0 if there is none.
int number_in(const std::string& label) {
  const auto at = label.find_first_of("0123456789");
  int number = 0;
  if (at != std::string::npos)
    std::from_chars(label.data() + at, label.data() + label.size(), number);
  return number;
}

/// The prefix "axis[2]." for the second of several axes.
std::string prefix_of(const Subject& subject) {
  const auto& axes = subject.spec->axes;
  const auto own = std::find_if(axes.begin(), axes.end(),
                                [&](const AxisPart& part) { return part.name == subject.axis; });
  return own == axes.end() ? "" : "axis[" + std::to_string(own - axes.begin() + 1) + "].";
}

/// True if the segments of the curve are those of the file. Operators make other segments.
bool keeps_segments(const Spec& spec) {
  return std::all_of(spec.then.begin(), spec.then.end(),
                     [](const Operator& each) { return std::holds_alternative<RetimeSpec>(each); });
}

/// The place of the finding's segment: its line in a path; otherwise [[segment]] or [[command]], or
/// the [[point]] or [[knot]] at its end.
KeyPlace place_of_segment(const Finding& finding, const Subject& subject) {
  if (!finding.segment || !keeps_segments(*subject.spec)) return {};
  const Document& document = subject.spec->document;
  const int number = number_in(subject.labels.segment_of(finding));
  if (number == 0) return {};
  if (const auto* path = std::get_if<PathSpec>(&subject.spec->subject))
    return {"line " + std::to_string(number),
            {path->source.empty() ? document.name : path->source, number, 0}};
  const auto numbered = [](const char* key, int n) {
    return std::string(key) + "[" + std::to_string(n) + "]";
  };
  return first_of(document, {numbered("segment", number), numbered("command", number),
                             numbered("point", number), numbered("knot", number)});
}

/// The key of the limit that a finding is compared with.
KeyPlace place_of_limit(const Finding& finding, const Subject& subject) {
  const std::string own = prefix_of(subject);
  std::string name(finding.rule.name());
  switch (finding.rule.family()) {
    case RuleFamily::limit:
      if (name == "master_velocity" || name == "master_acceleration")
        return first_of(subject.spec->document, {"limits.slave", "master"});
      if (name == "acceleration_step" || name == "velocity_step")
        name = name == "velocity_step" ? "acceleration" : "jerk";
      if (name.starts_with("load_"))
        return first_of(subject.spec->document, {"load.limits." + name.substr(5), "load"});
      return first_of(subject.spec->document, {own + "limits." + name, "path.limits." + name,
                                               "limits." + name, "limits.slave." + name});
    case RuleFamily::drive:
      return first_of(subject.spec->document, {own + "drive.limits." + name});
    case RuleFamily::disc:
      return first_of(subject.spec->document, {"disc.limits." + name});
    case RuleFamily::table:
      return first_of(subject.spec->document, {own + "table.tolerance", own + "table"});
    default:
      return {};
  }
}

/// The section for a finding without a segment and without a limit.
KeyPlace place_of_section(const Finding& finding, const Subject& subject) {
  const std::string own = prefix_of(subject);
  std::string section = name(finding.rule.family());
  if (finding.rule.family() == RuleFamily::tolerance) section = "drive.tolerances";
  if (finding.rule.family() == RuleFamily::limit ||
      finding.rule.family() == RuleFamily::unlimited || finding.rule == "warning/no_limits")
    section = "limits";
  if (finding.rule == "warning/not_played") section = finding.quantity;
  std::vector<std::string> keys{own + section, section};
  if (!own.empty()) keys.push_back(own.substr(0, own.size() - 1));
  keys.emplace_back("kind");
  return first_of(subject.spec->document, keys);
}

Level level_of(const Finding& finding) {
  if (finding.broken) return Level::broken;
  switch (finding.severity) {
    case Severity::warning:
      return Level::warning;
    case Severity::note:
      return Level::note;
    case Severity::required:
      break;
  }
  return Level::good;
}

void set_place(Diagnostic& d, const Finding& finding, const Subject& subject) {
  KeyPlace limit = place_of_limit(finding, subject);
  KeyPlace place = place_of_segment(finding, subject);
  if (place.place.file.empty()) place = limit;
  if (place.place.file.empty()) place = place_of_section(finding, subject);
  if (place.place.file.empty()) return;
  d.key = std::move(place.key);
  d.place = std::move(place.place);
  d.limit_place = std::move(limit.place);
}

Diagnostic diagnostic_of(const Finding& finding, const Subject& subject, const std::string& file) {
  Diagnostic d;
  d.rule = finding.rule.text();
  d.level = level_of(finding);
  d.place.file = file;
  if (subject.spec != nullptr) set_place(d, finding, subject);
  d.axis = subject.axis;
  if (!finding.axis.empty()) d.axis += (d.axis.empty() ? "" : " ") + finding.axis;
  d.segment = subject.labels.segment_of(finding);
  d.message = sentence(finding, subject.labels);
  d.advice = finding.advice;
  d.quantity = finding.quantity;
  constexpr std::array without_number{"warning/no_limits", "warning/not_played",
                                      "warning/older_table"};
  if (std::find(without_number.begin(), without_number.end(), d.rule) != without_number.end())
    return d;
  d.unit = subject.labels.unit_of(finding);
  d.value = finding.value;
  if (finding.has_limit) d.limit = finding.limit;
  if (finding.has_limit) d.margin = finding.margin;
  d.where = finding.where;
  d.where_unit = finding.where_unit.empty() ? subject.labels.units.x : finding.where_unit;
  return d;
}

std::vector<Diagnostic> all_of(const Report& report, const Subject& subject,
                               const std::string& file) {
  std::vector<Diagnostic> all;
  for (const Finding& finding : report.findings)
    all.push_back(diagnostic_of(finding, subject, file));
  return all;
}

}  // namespace

std::vector<Diagnostic> diagnostics_of(const Report& report, const Input& input,
                                       const std::string& file) {
  const Spec* const spec = input.spec && !input.against ? &*input.spec : nullptr;
  return all_of(report, {spec, input.labels, input.axis}, file);
}

std::vector<Diagnostic> diagnostics_of(const Report& report, const Spec& spec,
                                       const std::string& file) {
  return all_of(report, {&spec, {spec.units, spec.over_master(), {}}, ""}, file);
}

}  // namespace jounce
