// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/report_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <utility>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/detail/load_figures.hpp"
#include "jounce/plot/chart_data.hpp"
#include "jounce/plot/findings.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/plot/load_figure.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/proof/drive_figures.hpp"

#include "proof/src/figure/follower_figure.hpp"
#include "proof/src/figure/loop_figures.hpp"
#include "proof/src/page_sections.hpp"
#include "proof/src/text/loop_text.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

/// A position for people. Rounding, below 1e-12 of the range, is 0.
std::string tidy_number(double value, const Range& range) {
  return short_number(std::abs(value) < rounded_sum * std::abs(range.peak().value) ? 0 : value);
}

/// One row for each segment of the spec: range of the position, and peak of each derivative with its place.
DataTable extrema_table(const Input& input) {
  return std::visit(
      [&]<class Over>(const Curve<Over>& curve) {
        DataTable table{.caption = "Exact extrema of each segment",
                        .columns = {"segment", "least", "greatest"}};
        table.caption +=
            "; position in " + input.labels.unit_of("position") + ", @ in " + input.labels.units.x;
        for (std::size_t k = 1; k < Over::names.size(); ++k)
          table.columns.push_back(std::string("|") + Over::names[k] + "|");
        for (const auto& [label, first, last] :
             groups(curve.segments().size(), input.labels, rows_for_people)) {
          const Ranges r = segment_extrema(curve, first, last);
          DataTable::Row row{
              {label, tidy_number(r[0].min.value, r[0]), tidy_number(r[0].max.value, r[0])},
              false,
              DataTable::Place{curve.breaks()[first], curve.breaks()[last + 1]}};
          for (std::size_t k = 1; k < r.size(); ++k)
            row.cells.push_back(short_number(std::abs(r[k].peak().value)) + " @ " +
                                short_number(r[k].peak().where, 4));
          table.rows.push_back(std::move(row));
        }
        return table;
      },
      *input.curve);
}

Facts facts(const Input& input) {
  const Table& table = input.table.table;
  Facts f;
  f.rows = {{"table", fmt::format("{} knots, {}", table.size(), name(table.rule()))},
            {"range", fmt::format("{} to {} {}", short_number(table.start()),
                                  short_number(table.end()), input.labels.units.x)},
            {"sha256", hex(content_hash(table, input.labels.units))}};
  if (input.error)
    f.rows.emplace_back(
        "error against the exact curve",
        fmt::format("at most {} {} (certified)", short_number(input.error->position),
                    input.labels.units.position));
  if (!input.table.provenance.spec.empty())
    f.rows.emplace_back("spec", input.table.provenance.spec + ", sha256 " +
                                    input.table.provenance.spec_sha256.substr(0, 16) + "...");
  return f;
}

/// The findings; of very many, the first ones: a table of 200 000 knots can have a step at each knot.
DataTable first_findings(const Report& report, const Labels& labels) {
  constexpr std::size_t most = 300;
  if (report.findings.size() <= most) return findings_table(report, labels);
  Report first = report;
  std::stable_partition(first.findings.begin(), first.findings.end(),
                        [](const Finding& finding) { return finding.broken; });
  first.findings.resize(most);
  return findings_table(first, labels,
                        fmt::format("The first {} of {} findings, the broken ones first; `jounce "
                                    "check` shows all of them",
                                    most, report.findings.size()));
}

Section proof_section(const Proof& proof, const Input& input) {
  Section section{"Proof", {}};
  section.blocks.emplace_back(
      Prose{"The witness integrates only the jerk, three times, with SUNDIALS CVODES, and compares "
            "the result with the position, velocity and acceleration of the curve and its table. "
            "It reads the table as the executor does."});
  DataTable table = first_findings(proof.report, input.labels);
  section.blocks.emplace_back(std::move(table));
  if (proof.drive) {
    section.blocks.emplace_back(
        Chart{response_figure(*proof.drive, *input.drive, input.labels.units.position),
              "The response of the [drive] to the table, with a P-PI cascade and feed-forward. The "
              "drive holds the last position after the end."});
    section.blocks.emplace_back(Chart{torque_speed_figure(*proof.drive, input.drive->drive),
                                      "The same run within the envelope of the motor."});
    if (loop_of(input.drive->drive))
      section.blocks.emplace_back(
          Chart{bode_figure(input.drive->drive),
                "The open loop of both controllers, cut at the torque input of the motor: at 0 dB, "
                "the phase must be above −180 deg."});
  }
  if (proof.follower)
    section.blocks.emplace_back(
        Chart{follower_figure(*proof.follower, *input.spec->follower, input.labels.units.position),
              "The [follower] with the table as its cam."});
  return section;
}

/// Torque, power and heating of the motor.
Section load_section(Figure figure, const Input& input) {
  figure.title.clear();
  Facts values;
  for (const LoadFigure& f : load_figures(*input.spec, std::get<Cam>(*input.curve)))
    values.rows.emplace_back(
        f.name, rounded(f.value) + " " + f.unit +
                    (f.where ? " at " + rounded(*f.where) + " " + input.labels.units.x : ""));
  return {
      "Load",
      {Chart{std::move(figure), "Torque and power of the motor, at the velocity of [master].", ""},
       std::move(values)}};
}

/// Findings of the exact check, without the notes and without those that are in the proof.
Report check_of(const Input& input) {
  Report report = checked(input);
  std::erase_if(report.findings, [](const Finding& f) {
    return f.severity == Severity::note || f.rule == "table/position" ||
           f.rule == "drive/stability";
  });
  add_not_limited(report, input);
  return report;
}

/// The day in UTC, such as 2026-11-26. The environment variable SOURCE_DATE_EPOCH (s) replaces the
/// clock, so that a page can be reproduced: reproducible-builds.org.
std::string report_day() {
  const char* const given = std::getenv("SOURCE_DATE_EPOCH");
  const auto now = given == nullptr ? std::time(nullptr)
                                    : static_cast<std::time_t>(std::strtoll(given, nullptr, 10));
  std::tm day{};
  if (gmtime_r(&now, &day) == nullptr) return "";
  return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

Page empty_page(const std::string& title, const Report& all) {
  return {.title = title,
          .subtitle = "Motion table report",
          .verdict = verdict(all),
          .footer = "Made by " + made_by() + " on " + report_day()};
}

/// The sections of an axis, except its path and its spec, and all its findings.
struct ReportedAxis {
  std::vector<Section> sections;
  Report findings;
};

/// Adds the remarks of an axis to the text of the spec. They have no places: the text is common to the
/// charts of all axes.
void add_remarks(Listing& spec, Section section) {
  Listing own = std::get<Listing>(std::move(section.blocks.front()));
  for (Listing::Remark& remark : own.remarks) remark.place.reset();
  own.remarks.insert(own.remarks.begin(), spec.remarks.begin(), spec.remarks.end());
  std::stable_sort(own.remarks.begin(), own.remarks.end(),
                   [](const auto& a, const auto& b) { return a.line < b.line; });
  spec = std::move(own);
}

ReportedAxis reported_axis(const Input& input, const std::optional<Input>& before,
                           const ReportOptions& options) {
  const Report report = check_of(input);
  const Proof proof = prove(input, options.proof);
  ReportedAxis part{{}, report};
  std::vector<Finding>& all = part.findings.findings;
  all.insert(all.end(), proof.report.findings.begin(), proof.report.findings.end());
  sort(part.findings);

  Figure figure = figure_of(input, before);
  figure.title.clear();
  std::vector<Section>& sections = part.sections;
  sections.push_back({"Curve",
                      {Chart{std::move(figure),
                             before ? "The pale line is " + before->name +
                                          " as it was before. Marked are the exact extrema."
                                    : "Marked are the exact extrema.",
                             chart_data(input, before)},
                       extrema_table(input)}});
  if (!options.optimum.empty())
    sections.push_back(optimum_section(read_file(options.optimum), options.optimum, input.labels));
  if (auto load = load_figure(input)) sections.push_back(load_section(std::move(*load), input));
  if (input.spec && input.spec->disc) sections.push_back(disc_section(input));
  sections.push_back({"Limits and joints", {first_findings(report, input.labels)}});
  sections.push_back(proof_section(proof, input));
  sections.push_back({"Table", {facts(input)}});
  return part;
}

}  // namespace

ReportPage report_page(const Input& input, const std::optional<Input>& before,
                       const ReportOptions& options) {
  ReportedAxis part = reported_axis(input, before, options);
  Page page = empty_page(input.name, part.findings);
  page.sections = std::move(part.sections);
  if (input.plan)
    page.sections.insert(page.sections.begin() + (options.optimum.empty() ? 1 : 2),
                         path_section(input));
  if (input.spec) page.sections.push_back(spec_section(input, part.findings));
  return {std::move(page), std::move(part.findings)};
}

ReportPage report_page(const std::vector<Input>& axes, const ReportOptions& options) {
  const Input& first = axes.front();
  Report all;
  Listing spec;
  std::vector<Section> sections;
  if (first.plan) sections.push_back(path_section(first));
  for (const Input& input : axes) {
    ReportedAxis part = reported_axis(input, std::nullopt, options);
    for (Section& section : part.sections) {
      section.heading = input.axis + ": " + section.heading;
      sections.push_back(std::move(section));
    }
    all.findings.insert(all.findings.end(), part.findings.findings.begin(),
                        part.findings.findings.end());
    if (input.spec) add_remarks(spec, spec_section(input, part.findings));
  }
  sort(all);
  if (first.spec) sections.push_back({"Spec", {std::move(spec)}});
  Page page = empty_page(first.name.substr(0, first.name.size() - first.axis.size() - 1), all);
  page.sections = std::move(sections);
  return {std::move(page), std::move(all)};
}

}  // namespace jounce
