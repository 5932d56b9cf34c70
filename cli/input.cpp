#include "input.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/io/file.hpp"
#include "jounce/io/printable.hpp"

namespace jounce::cli {
namespace {

Input from_table(TableFile file, const std::string& path) {
  std::variant<Cam, Trajectory> curve =
      file.table.axis() == Axis::master
          ? std::variant<Cam, Trajectory>(file.table.curve<OverMaster>())
          : file.table.curve<OverTime>();
  Labels labels{file.units, file.table.axis() == Axis::master, {}};
  return {std::nullopt, std::move(curve),  std::move(file), std::nullopt,
          {},           std::move(labels), printable(path)};
}

Input from_spec(Spec spec, const std::string& path) {
  Made made = make(spec);
  TableFile table{std::move(made.sampled.table),
                  spec.units,
                  {path == "-" ? "" : printable(path), hex(spec.document.hash), made_by()}};
  Labels labels{spec.units, spec.is_cam(), std::move(made.segments)};
  Input input{std::nullopt,
              std::move(made.curve),
              std::move(table),
              std::holds_alternative<Table>(spec.subject) ? std::nullopt
                                                          : std::optional(made.sampled.error),
              spec.limits,
              std::move(labels),
              spec.name.empty() ? printable(path) : spec.name};
  input.spec = std::move(spec);
  return input;
}

/// What the table was allowed to differ: the tolerance asked for, or a millionth of the stroke where
/// only a number of intervals was.
double allowed_error(const Input& input, const Range& travel) {
  const double stroke = travel.max.value - travel.min.value;
  if (input.spec->table.tolerance) return *input.spec->table.tolerance;
  return (input.spec->table.intervals ? 1e-6 : 1e-9) * (stroke > 0 ? stroke : 1);
}

template <class Over>
Report check_curve(const Curve<Over>& curve, const Input& input, int continuity) {
  Report report = check(curve, input.limits);
  const auto add = [&](const Report& part) {
    report.findings.insert(report.findings.end(), part.findings.begin(), part.findings.end());
  };
  add(check_continuity(curve, continuity));
  if (!input.error) return report;
  const double allowed = std::max(allowed_error(input, extrema(curve, 0)),
                                  1e-14 * std::abs(extrema(curve, 0).peak().value));
  const bool broken = input.error->position > allowed;
  report.findings.push_back({"table/position",
                             "table",
                             "position",
                             input.error->where,
                             input.error->position,
                             allowed,
                             (allowed - input.error->position) / allowed,
                             broken,
                             std::nullopt,
                             broken ? "give [table] a tolerance, or more intervals" : "",
                             {},
                             {}});
  // Where the curve keeps a limit, its table may still break it between the knots.
  Report table = check(input.table.table.curve<Over>(), input.limits);
  std::erase_if(table.findings, [&](const Finding& f) {
    return !f.broken || std::any_of(report.findings.begin(), report.findings.end(),
                                    [&](const Finding& g) { return g.broken && g.rule == f.rule; });
  });
  for (Finding& finding : table.findings) {
    finding.axis = "table";
    finding.segment = std::nullopt;
  }
  add(table);
  return report;
}

}  // namespace

Report check_all(const Input& input, int continuity) {
  Report report = std::visit(
      [&](const auto& curve) { return check_curve(curve, input, continuity); }, input.curve);
  sort(report);
  return report;
}

Input load(const std::string& path) {
  std::string text = read_file(path);
  const std::string name = path == "-" ? "standard input" : path;
  if (is_table(text)) return from_table(parse_table(text, name), name);
  return from_spec(parse_spec(std::move(text), name), path);
}

}  // namespace jounce::cli
