// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/report_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/check.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

using Json = nlohmann::ordered_json;

/// A position for people. A value below the rounding of the range is 0.
std::string tidy(double value, const Range& range) {
  return rounded(std::abs(value) < rounded_sum * std::abs(range.peak().value) ? 0 : value);
}

Json to_object(const Finding& finding, const Labels& labels) {
  Json object{{"rule", finding.rule.text()},
              {"quantity", finding.quantity},
              {"unit", labels.unit_of(finding)},
              {"where", finding.where},
              {"value", finding.value},
              {"limit", nullptr},
              {"margin", nullptr},
              {"broken", finding.broken}};
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
  return f.rule.family() == RuleFamily::witness || f.rule.family() == RuleFamily::played ||
         f.rule.name() == "integration" || f.rule == "drive/exact";
}

/// True for a limit of the machine, not for a joint, the table's own error, a proof, or a fact.
bool is_limit(const Finding& f) {
  return f.has_limit && f.severity == Severity::required &&
         f.rule.family() != RuleFamily::continuity && f.rule.family() != RuleFamily::table &&
         !is_proof(f);
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
  return six_digits(value);
}

std::string rounded(double value, double scale) {
  return rounded(std::abs(value) <= profiles_detail::rounded_input * scale ? 0 : value);
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? rounded(value) : rounded(value) + " " + unit;
}

std::string Labels::unit_of(const std::string& quantity) const {
  if (quantity == "time") return units.x;
  if (quantity == "slave") return units.position;
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

std::string one_line(const Report& report, const Labels& labels) {
  const std::size_t w = report.warnings();
  const std::string more = w == 0 ? "" : " (" + counted(w, "warning") + ")";
  if (const std::size_t n = report.broken(); n > 0)  // sort() puts the worst of them first
    return fmt::format("{}; the worst: {}{}", counted(n, "finding"),
                       sentence(report.findings.front(), labels), more);
  const auto closest = std::find_if(report.findings.begin(), report.findings.end(), is_limit);
  if (closest != report.findings.end()) {
    const std::string rest = not_limited_text(report, labels);
    return "all limits hold; the closest: " + sentence(*closest, labels) +
           (rest.empty() ? "" : "; " + rest) + more;
  }
  const bool continuous =
      std::any_of(report.findings.begin(), report.findings.end(),
                  [](const Finding& f) { return f.rule.family() == RuleFamily::continuity; });
  const auto none = std::find_if(
      report.findings.begin(), report.findings.end(),
      [](const Finding& f) { return f.rule == "warning/no_limits" && f.quantity != "limits"; });
  return (none == report.findings.end() ? "no limits are given"
                                        : none->quantity + " is not checked") +
         (continuous ? "; the curve is continuous" : "") + more;
}

bool is_unlimited(const Finding& finding) {
  return finding.rule.family() == RuleFamily::unlimited;
}

bool has_limits(const Report& report) {
  return std::any_of(report.findings.begin(), report.findings.end(), is_limit);
}

std::string not_limited_text(const Report& report, const Labels& labels) {
  std::string text;
  for (const Finding& f : report.findings)
    if (is_unlimited(f))
      text += fmt::format("{}{} (up to {})", text.empty() ? "not limited: " : ", ", f.quantity,
                          with_unit(std::abs(f.value), labels.unit_of(f)));
  return text;
}

namespace {

/// "  ... and 6 more findings, all of them ok: --json prints them"; "" if there are none.
std::string left_out_text(const std::vector<const Finding*>& left) {
  if (left.empty()) return "";
  const auto count = [&](const auto& is) {
    return static_cast<std::size_t>(std::count_if(left.begin(), left.end(), is));
  };
  const std::size_t broken = count([](const Finding* f) { return f->broken; });
  const std::size_t warnings =
      count([](const Finding* f) { return !f->broken && f->severity == Severity::warning; });
  std::string kinds;
  for (const auto& [number, word] :
       {std::pair{broken, "BROKEN"}, {warnings, "warn"}, {left.size() - broken - warnings, "ok"}})
    if (number > 0) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", number, word);
  return fmt::format("  ... and {} ({}): --json prints all of them\n",
                     jounce::counted(left.size(), "more finding"), kinds);
}

}  // namespace

std::string full_text(const Report& report, const Labels& labels, std::size_t most) {
  const auto is_note = [](const Finding& f) { return !f.broken && f.severity == Severity::note; };
  std::string text;
  std::size_t shown = 0;
  std::vector<const Finding*> left;
  for (const Finding& finding : report.findings) {
    if (is_note(finding)) continue;
    if (shown >= most) {
      left.push_back(&finding);
      continue;
    }
    ++shown;
    const bool warns = finding.severity == Severity::warning;
    text += fmt::format("  {:<6} {:<26} {}\n", finding.broken ? "BROKEN" : (warns ? "warn" : "ok"),
                        finding.rule.text(), sentence(finding, labels));
    if (!finding.advice.empty())
      text += fmt::format("  {:<6} {:<26} -> {}\n", "", "", finding.advice);
  }
  return text + left_out_text(left);
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

std::string axes_json(const std::vector<std::pair<std::string, std::string>>& axes) {
  if (axes.size() == 1) return axes.front().second;
  auto all = nlohmann::ordered_json::object();
  for (const auto& [name, text] : axes) {
    auto document = nlohmann::ordered_json::parse(text);
    if (document.contains("ok")) all["ok"] = all.value("ok", true) && document["ok"].get<bool>();
    all["axes"][name] = std::move(document);
  }
  return all.dump();
}

}  // namespace jounce
