// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/report_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/pvt/check.hpp"

#include "report/src/sync_text.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? rounded(value) : rounded(value) + " " + unit;
}

std::string place(const Finding& finding, const Labels& labels) {
  const std::string segment = labels.segment_of(finding);
  return with_unit(finding.where,
                   finding.where_unit.empty() ? labels.units.x : finding.where_unit) +
         (segment.empty() ? "" : " (segment " + segment + ")");
}

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * std::abs(share));
}

/// True if the limit is a lower one: a radius that a disc cam must have.
bool is_least(const Finding& finding) {
  return finding.rule == "disc/profile_radius" || finding.rule == "disc/cutter_radius";
}

/// Verdict of a curve against a limit, with its margin.
std::string verdict(const Finding& finding) {
  const std::string limit = rounded(finding.limit);
  if (finding.broken && finding.rule.starts_with("limit/position"))
    return fmt::format("is outside the limit {} by {}", limit,
                       rounded(std::abs(finding.value - finding.limit)));
  if (finding.rule == "follower/contact")  // its margin is no share of the limit
    return finding.broken && finding.limit == 0
               ? "shows that the follower lifts off"
               : fmt::format("is {} the minimum {}", finding.broken ? "below" : "above", limit);
  if (is_least(finding))
    return fmt::format("is {} {} the minimum {}", percent(finding.margin),
                       finding.broken ? "below" : "above", limit);
  if (finding.margin < -10)
    return fmt::format("is {:.3g} times the limit {}", 1 - finding.margin, limit);
  if (finding.broken)
    return fmt::format("exceeds the limit {} by {}", limit, percent(finding.margin));
  if (std::abs(finding.margin) < 1e-9) return fmt::format("just meets the limit {}", limit);
  if (finding.rule.starts_with("limit/position"))
    return fmt::format("stays within the limit {} by {} of the travel", limit,
                       percent(finding.margin));
  return fmt::format("is {} below the limit {}", percent(finding.margin), limit);
}

/// Distance above the proven bound.
std::string of_bound(const Finding& f, const std::string& where) {
  if (f.rule == "bound/duration")
    return fmt::format("{} = {}: {} {} the whole rise, the greatest possible value", f.quantity,
                       rounded(f.value), percent(f.margin), f.broken ? "above" : "below");
  if (f.rule.starts_with("identity/"))
    return fmt::format("{} of the rise from {} is {}, of any motion {}", f.quantity, where,
                       rounded(f.value), rounded(f.limit));
  const char* whose = f.rule == "bound/acceleration_for_jerk" ? "for its jerk" : "of any motion";
  return fmt::format("{} {} at {} is {} {} {}, the minimum {}", f.quantity, rounded(f.value), where,
                     percent(f.margin), f.broken ? "below" : "above", rounded(f.limit), whose);
}

/// Findings that are allowed but perhaps not intended.
std::string of_warning(const Finding& f, const std::string& value, const std::string& where) {
  if (f.rule == "warning/overshoot")
    return fmt::format("position {} at {} is beyond the segment's end {} by {} of the travel",
                       value, where, rounded(f.limit), percent(f.margin));
  if (f.rule == "warning/velocity_overshoot")
    return fmt::format("{} {} at {} is beyond {}, at which the segment ends", f.quantity, value,
                       where, rounded(f.limit));
  return fmt::format("{} {} at {} is against the segment's ends", f.quantity, value, where);
}

/// Warnings of a time table.
std::string of_table(const Finding& f, const std::string& value, const std::string& where) {
  if (f.rule == "pt/oscillation")
    return fmt::format("{} changes by {} up to {} and back after it", f.quantity, value, where);
  if (f.rule == "pt/end_velocity")
    return fmt::format("{} is {} at the end, {}", f.quantity, value, where);
  return fmt::format("{} is {} at {}", f.quantity, value, where);
}

/// Findings that prevent an output from firing as intended.
std::string of_compare(const Finding& f, const std::string& value, const std::string& where) {
  if (f.rule == "compare/missed")
    return fmt::format("{} of {} points fire", rounded(f.value), rounded(f.limit));
  if (f.rule == "compare/merged")
    return fmt::format("points come {} apart at {}, and the pulse lasts longer", value, where);
  return fmt::format("the output is up to {} late, at {}", value, where);
}

/// Findings of a coupling without a limit: a step, a figure, or a start that it refuses.
std::string of_coupling(const Finding& f, const std::string& value, const std::string& where) {
  const bool steps = f.value != 0;
  if (f.rule == "coupling/start")
    return steps ? fmt::format("{} steps by {} where the slave engages, at {}", f.quantity, value,
                               where)
                 : fmt::format("{} is continuous where the slave engages", f.quantity);
  if (f.rule == "coupling/period")
    return steps ? fmt::format("{} steps by {} at the end of each period", f.quantity, value)
                 : fmt::format("{} is continuous from period to period", f.quantity);
  if (f.rule == "coupling/enter")
    return fmt::format("the cam moves at {} where the master enters it, at {}", value, where);
  if (f.rule == "coupling/end" || f.rule == "coupling/begin")
    return fmt::format("the cam {} moving, with {} {} at {}",
                       f.rule == "coupling/end" ? "ends" : "begins", f.quantity, value, where);
  if (f.rule == "coupling/ramp")
    return fmt::format("the correction reaches {} {} {} {}", f.quantity, value,
                       f.where_unit.empty() ? "at" : "after", where);
  return fmt::format("the slave cannot engage with its master at {}", where);
}

/// A position for people: what is rounding beside the range is 0.
std::string tidy(double value, const Range& range) {
  return rounded(std::abs(value) < 1e-12 * std::abs(range.peak().value) ? 0 : value);
}

Json to_object(const Finding& finding, const Labels& labels) {
  Json object{
      {"rule", finding.rule},   {"quantity", finding.quantity}, {"unit", labels.unit_of(finding)},
      {"where", finding.where}, {"value", finding.value},       {"limit", nullptr},
      {"margin", nullptr},      {"broken", finding.broken}};
  if (finding.has_limit) {
    object["limit"] = finding.limit;
    object["margin"] = finding.margin;
  }
  if (!finding.where_unit.empty()) object["where_unit"] = finding.where_unit;
  if (!finding.axis.empty()) object["axis"] = finding.axis;
  if (finding.segment) {
    object["segment"] = labels.number_of_segment(*finding.segment);
    object["segment_name"] = labels.segment_of(finding);
    object["piece"] = *finding.segment + 1;
  }
  if (!finding.advice.empty()) object["advice"] = finding.advice;
  if (finding.severity != Severity::required)
    object["severity"] = finding.severity == Severity::warning ? "warning" : "note";
  return object;
}

/// True if one computation is compared with another: its limit is not one of the machine.
bool is_proof(const Finding& f) {
  return f.rule.starts_with("witness/") || f.rule.starts_with("played/") ||
         f.rule.ends_with("/integration") || f.rule == "drive/exact";
}

/// True for a limit of the machine, not for a joint, the table's own error, a proof, or a fact.
bool is_limit(const Finding& f) {
  return f.has_limit && f.severity == Severity::required && !f.rule.starts_with("continuity/") &&
         !f.rule.starts_with("table/") && !is_proof(f);
}

std::vector<SegmentGroup> taken_together(const std::vector<SegmentGroup>& all, std::size_t most) {
  std::vector<SegmentGroup> few;
  for (std::size_t i = 0; i < most; ++i) {
    const SegmentGroup& a = all[i * all.size() / most];
    const SegmentGroup& b = all[(i + 1) * all.size() / most - 1];
    few.push_back({a.first == b.first ? a.label : a.label + " to " + b.label, a.first, b.last});
  }
  return few;
}

}  // namespace

std::vector<SegmentGroup> groups(std::size_t segments, const Labels& labels, std::size_t most) {
  std::vector<SegmentGroup> all;
  if (labels.segments.empty() && segments > most) {  // one a segment, of which few are shown
    for (std::size_t i = 0; i < most; ++i) {
      const std::size_t first = i * segments / most;
      const std::size_t last = (i + 1) * segments / most - 1;
      const std::string label = std::to_string(first + 1);
      all.push_back(
          {first == last ? label : label + " to " + std::to_string(last + 1), first, last});
    }
    return all;
  }
  for (std::size_t i = 0; i < segments; ++i) {
    const std::string label =
        i < labels.segments.size() ? labels.segments[i] : std::to_string(i + 1);
    if (!all.empty() && all.back().label == label)
      all.back().last = i;
    else
      all.push_back({label, i, i});
  }
  return all.size() > most ? taken_together(all, most) : all;
}

std::string rounded(double value) {
  return fmt::format("{:.6g}", value);
}

std::string Labels::unit_of(const std::string& quantity) const {
  if (quantity == "time") return units.x;
  const auto& names = over_master ? OverMaster::names : OverTime::names;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (quantity == names[k] || quantity == std::string("step of ") + names[k] ||
        quantity.starts_with(std::string(names[k]) + " while "))
      return rate_unit(units.position, units.x, static_cast<int>(k));
  return "";
}

std::string Labels::unit_of(const Finding& finding) const {
  return finding.unit.empty() ? unit_of(finding.quantity) : finding.unit;
}

std::string Labels::segment_of(const Finding& finding) const {
  if (!finding.segment) return "";
  return *finding.segment < segments.size() ? segments[*finding.segment]
                                            : std::to_string(*finding.segment + 1);
}

std::size_t Labels::number_of_segment(std::size_t piece) const {
  std::size_t number = 1;
  for (std::size_t i = 1; i <= piece; ++i)
    if (i >= segments.size() || segments[i] != segments[i - 1]) ++number;
  return number;
}

std::string sentence(const Finding& finding, const Labels& labels) {
  if (finding.rule == "table/position")
    return fmt::format("the table is {} from the exact curve at {}; {} is allowed",
                       with_unit(finding.value, labels.unit_of(finding)), place(finding, labels),
                       rounded(finding.limit));
  if (finding.rule.starts_with("continuity/") || finding.rule == "disc/corner") {
    const std::string step = with_unit(finding.value, labels.unit_of(finding));
    const std::string where = place(finding, labels);
    return finding.broken ? fmt::format("{} is {} at {}", finding.quantity, step, where)
                          : fmt::format("{} is continuous (largest step {})",
                                        finding.quantity.substr(8), step);
  }
  if (finding.rule == "disc/interference")
    return fmt::format("{} is {} at {}", finding.quantity,
                       with_unit(finding.value, labels.unit_of(finding)), place(finding, labels));
  if (finding.rule == "disc/profile_radius" && finding.limit == 0)
    return fmt::format("{} is {} at {}; it must be greater than 0", finding.quantity,
                       with_unit(finding.value, labels.unit_of(finding)), place(finding, labels));
  if (finding.rule.starts_with("bound/") || finding.rule.starts_with("identity/"))
    return of_bound(finding, place(finding, labels));
  if (finding.rule.starts_with("warning/"))
    return of_warning(finding, with_unit(finding.value, labels.unit_of(finding)),
                      place(finding, labels));
  if (finding.rule == "fill/limits")
    return fmt::format("no velocities keep the limits from {} to the next knot, {} later",
                       place(finding, labels), with_unit(finding.value, labels.units.x));
  if (finding.rule.starts_with("fill/"))
    return fmt::format(
        "{} {} at the knots of {} rules out {}", finding.quantity,
        with_unit(finding.value, labels.unit_of(finding)), place(finding, labels),
        finding.rule == "fill/convex" ? "the bend of the data" : "a way without turning back");
  if (finding.rule.starts_with("compare/") && finding.rule != "compare/speed")
    return of_compare(finding, with_unit(finding.value, labels.unit_of(finding)),
                      place(finding, labels));
  if (finding.rule.starts_with("pt/"))
    return of_table(finding, with_unit(finding.value, labels.unit_of(finding)),
                    place(finding, labels));
  if (finding.rule == "tolerance/stability")
    return fmt::format("the loop is unstable in {} cases", rounded(finding.value));
  if (finding.rule == "drive/stability")
    return fmt::format(
        "the loop is unstable{}: what is left of an error grows by the factor e in {} ms",
        finding.where > 0 ? " at " + place(finding, labels) : "", rounded(1e3 / finding.value));
  if (finding.rule.ends_with("/integration"))
    return fmt::format("the integration ended at {}", place(finding, labels));
  if (is_sync_rule(finding.rule)) return sync_sentence(finding, place(finding, labels));
  if (finding.rule.starts_with("joint/") || finding.rule.starts_with("follow/"))
    return fmt::format("{} is {} at {}", finding.quantity,
                       with_unit(finding.value, labels.unit_of(finding)), place(finding, labels));
  if (finding.rule.starts_with("coupling/"))
    return of_coupling(finding, with_unit(finding.value, labels.unit_of(finding)),
                       place(finding, labels));
  if (is_unlimited(finding))
    return fmt::format("{} has no limit; its peak is {} at {}", finding.quantity,
                       with_unit(finding.value, labels.unit_of(finding)), place(finding, labels));
  if (!finding.has_limit)
    return fmt::format("{} is {} at {}", finding.quantity,
                       with_unit(finding.value, labels.unit_of(finding)), place(finding, labels));
  const bool met = !finding.broken && std::abs(finding.margin) < 1e-9;
  return fmt::format("{} {} at {} {}", finding.quantity,
                     with_unit(met ? finding.limit : finding.value, labels.unit_of(finding)),
                     place(finding, labels), verdict(finding));
}

std::string one_line(const Report& report, const Labels& labels) {
  const std::size_t w = report.warnings();
  const std::string more =
      w == 0 ? "" : fmt::format(" ({} {})", w, w == 1 ? "warning" : "warnings");
  if (const std::size_t n = report.broken(); n > 0)  // sort() puts the worst of them first
    return fmt::format("{} {}; the worst: {}{}", n, n == 1 ? "finding" : "findings",
                       sentence(report.findings.front(), labels), more);
  const auto closest = std::find_if(report.findings.begin(), report.findings.end(), is_limit);
  if (closest != report.findings.end()) {
    const std::string rest = not_limited_text(report, labels);
    return "all limits hold; the closest: " + sentence(*closest, labels) +
           (rest.empty() ? "" : "; " + rest) + more;
  }
  const bool continuous =
      std::any_of(report.findings.begin(), report.findings.end(),
                  [](const Finding& f) { return f.rule.starts_with("continuity/"); });
  return (continuous ? "no limits are given; the curve is continuous" : "no limits are given") +
         more;
}

bool is_unlimited(const Finding& finding) {
  return finding.rule.starts_with("unlimited/");
}

std::string not_limited_text(const Report& report, const Labels& labels) {
  std::string text;
  for (const Finding& f : report.findings)
    if (is_unlimited(f))
      text += fmt::format("{}{} (up to {})", text.empty() ? "not limited: " : ", ", f.quantity,
                          with_unit(std::abs(f.value), labels.unit_of(f)));
  return text;
}

std::string full_text(const Report& report, const Labels& labels, std::size_t most) {
  const auto is_note = [](const Finding& f) { return !f.broken && f.severity == Severity::note; };
  std::string text;
  std::size_t shown = 0;
  std::size_t left = 0;
  for (const Finding& finding : report.findings) {
    if (is_note(finding) || shown >= most) {
      left += is_note(finding) ? 0 : 1;
      continue;
    }
    ++shown;
    const bool warns = finding.severity == Severity::warning;
    text += fmt::format("  {:<6} {:<26} {}\n", finding.broken ? "BROKEN" : (warns ? "warn" : "ok"),
                        finding.rule, sentence(finding, labels));
    if (!finding.advice.empty())
      text += fmt::format("  {:<6} {:<26} -> {}\n", "", "", finding.advice);
  }
  if (left > 0) text += fmt::format("  ... and {} more findings\n", left);
  return text;
}

std::string to_json(const Report& report, const Labels& labels) {
  Json findings = Json::array();
  for (const auto& finding : report.findings) findings.push_back(to_object(finding, labels));
  return Json{{"ok", report.ok()}, {"findings", findings}}.dump();
}

namespace {

/// Names of a curve or of a table for the two lists below.
template <class Over>
const auto& names_of(const Curve<Over>&) {
  return Over::names;
}
const auto& names_of(const Table& table) {
  return table.axis() == Domain::time ? OverTime::names : OverMaster::names;
}

template <class Motion>
std::string text_of_extrema(const Motion& motion, const Labels& labels) {
  const auto& names = names_of(motion);
  std::string text =
      fmt::format("  {:<20} {:>22} {:>22} {:>22} {:>22}\n", "segment", "position",
                  "max |" + std::string(names[1]) + "|", "max |" + std::string(names[2]) + "|",
                  "max |" + std::string(names[3]) + "|");
  for (const auto& [label, first, last] :
       groups(motion.breaks().size() - 1, labels, rows_for_people)) {
    const Ranges ranges = segment_extrema(motion, first, last);
    text += fmt::format(
        "  {:<20} {:>22}", label,
        tidy(ranges[0].min.value, ranges[0]) + " .. " + tidy(ranges[0].max.value, ranges[0]));
    for (std::size_t k = 1; k < ranges.size(); ++k) {
      const Extremum& peak = ranges[k].peak();
      text += fmt::format(
          " {:>22}", fmt::format("{} @ {}", rounded(std::abs(peak.value)), rounded(peak.where)));
    }
    text += '\n';
  }
  return text;
}

template <class Motion>
std::string json_of_extrema(const Motion& motion, const Labels& labels) {
  const auto& names = names_of(motion);
  Json list = Json::array();
  for (const auto& [label, first, last] : groups(motion.breaks().size() - 1, labels)) {
    const Ranges ranges = segment_extrema(motion, first, last);
    Json object{
        {"segment", label}, {"from", motion.breaks()[first]}, {"to", motion.breaks()[last + 1]}};
    for (std::size_t k = 0; k < ranges.size(); ++k)
      for (const auto& [bound, extremum] :
           {std::pair{"min", ranges[k].min}, {"max", ranges[k].max}})
        object[names[k]][bound] = {{"value", extremum.value}, {"where", extremum.where}};
    list.push_back(std::move(object));
  }
  return list.dump();
}

}  // namespace

template <class Over>
std::string extrema_text(const Curve<Over>& curve, const Labels& labels) {
  return text_of_extrema(curve, labels);
}
template <class Over>
std::string extrema_json(const Curve<Over>& curve, const Labels& labels) {
  return json_of_extrema(curve, labels);
}
std::string extrema_text(const Table& table, const Labels& labels) {
  return text_of_extrema(table, labels);
}
std::string extrema_json(const Table& table, const Labels& labels) {
  return json_of_extrema(table, labels);
}

template std::string extrema_text(const Curve<OverTime>&, const Labels&);
template std::string extrema_text(const Curve<OverMaster>&, const Labels&);
template std::string extrema_json(const Curve<OverTime>&, const Labels&);
template std::string extrema_json(const Curve<OverMaster>&, const Labels&);

}  // namespace jounce
