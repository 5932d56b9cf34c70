// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/plot/findings.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/plot/page.hpp"

#include "cli/common/folders.hpp"
#include "cli/common/path_section.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"
#include "cli/proof/cam_check.hpp"
#include "cli/proof/drive_figures.hpp"
#include "cli/proof/follower_figure.hpp"
#include "cli/proof/loop_figures.hpp"
#include "cli/proof/loop_text.hpp"
#include "cli/proof/proof.hpp"

namespace jounce::cli {
namespace {

struct ReportArguments {
  std::string file;
  std::string axis, machine;
  std::string before;
  std::string log;
  std::string output = "-";
};

/// A position for people: what is rounding beside the range is 0.
std::string tidy(double value, const Range& range) {
  return short_number(std::abs(value) < 1e-12 * std::abs(range.peak().value) ? 0 : value);
}

/// A row a segment of the spec: range of the position, peak of each derivative and where it is.
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
          DataTable::Row row{{label, tidy(r[0].min.value, r[0]), tidy(r[0].max.value, r[0])},
                             false};
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

Section proof_section(const Proof& proof, const Input& input) {
  Section section{"Proof", {}};
  section.blocks.emplace_back(
      Prose{"The witness integrates only the jerk, three times, with SUNDIALS CVODES, and compares "
            "the result with the position, velocity and acceleration of the curve and its table. "
            "It reads the table as the executor does."});
  DataTable table = findings_table(proof.report, input.labels);
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

/// Refuses a name that ends like that of another kind of file.
void require_page(const char* option, const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  if (path != "-" && !ending.empty() && ending != ".html" && ending != ".htm")
    throw InputError(option, path, "must end in .html: a report is a page of HTML");
}

int run_report(const ReportArguments& options) {
  require_other_file(options.file, options.output);
  require_folders({{"--output", options.output}});
  require_page("--output", options.output);
  const Input input = load_program_axis(options.file, options.machine, options.axis);
  const auto before =
      options.before.empty() ? std::nullopt : std::optional(load_beside(options.before, input));
  Report report = checked(input);
  std::erase_if(report.findings, [](const Finding& f) { return f.severity == Severity::note; });
  add_not_limited(report, input);
  const Proof proof = prove(input, options.log, 2000);
  std::erase_if(report.findings, [](const Finding& f) {  // they are in the proof
    return f.rule == "table/position" || f.rule == "drive/stability";
  });
  Report all = report;
  all.findings.insert(all.findings.end(), proof.report.findings.begin(),
                      proof.report.findings.end());

  Page page{.title = input.name,
            .subtitle = "Motion table report",
            .verdict = verdict(all),
            .footer = "Made by " + made_by()};
  Figure figure = figure_of(input, before);
  figure.title.clear();
  page.sections.push_back(
      {"Curve",
       {Chart{std::move(figure), before ? "The pale line is " + before->name +
                                              " as it was before. Marked are the exact extrema."
                                        : "Marked are the exact extrema."},
        extrema_table(input)}});
  if (input.plan) page.sections.push_back(path_section(input));
  page.sections.push_back({"Limits and joints", {findings_table(report, input.labels)}});
  page.sections.push_back(proof_section(proof, input));
  page.sections.push_back({"Table", {facts(input)}});
  write_file(options.output, html(page));
  if (options.output != "-") fmt::print("{}: {}\n", input.name, one_line(all, input.labels));
  return all.ok() ? fine : finding;
}

}  // namespace

void add_report(CommandLine& line) {
  const auto options = std::make_shared<ReportArguments>();
  const Verb verb =
      line.verb("report", "Write one self-contained HTML page with curve, limits and proof",
                "jounce report better.toml --before cam.toml --log run.csv -o cam.html");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--before", options->before, "Spec or table to draw paler underneath");
  verb.option("--log", options->log, "Tick log of an executor to compare with the exact curve");
  verb.option("-o,--output", options->output, "Page to write; - is standard output");
  verb.work([options] { return run_report(*options); });
}

}  // namespace jounce::cli
