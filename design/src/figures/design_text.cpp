// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/design_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

/// For a table of fewest knots: the error of its velocity, and the reason for the number of knots.
std::string fewest_text(const Input& input) {
  const std::string rate = input.labels.over_master ? std::string(OverMaster::names[1])
                                                    : std::string(OverTime::names[1]);
  const char* why = *input.binding == Binding::none ? "two knots are enough"
                    : *input.binding == Binding::most
                        ? "the smallest error for this number of knots, or close to it"
                    : *input.binding == Binding::tolerance
                        ? "the fewest knots for the tolerance of the position, or close to it"
                        : "the fewest knots for the tolerance of the velocity, or close to it";
  return fmt::format("{}: at most {} {} (certified); {}", rate, rounded(input.error->velocity),
                     input.labels.unit_of(rate), why);
}

}  // namespace

std::string design_text(const Input& input, const Report& report, const std::string& file) {
  const Table& table = input.table.table;
  const Units& units = input.labels.units;
  std::string text =
      fmt::format("{}: {} knots, {}, from {} to {} {}\n", input.name, table.size(),
                  name(table.rule()), rounded(table.start()), rounded(table.end()), units.x);
  if (input.error)
    text += fmt::format("error against the exact curve: at most {} {} (certified), at {} {}\n",
                        rounded(input.error->position), units.position, rounded(input.error->where),
                        units.x);
  if (input.error && input.binding) text += fewest_text(input) + "\n";
  for (const Residual& r : input.residuals)
    text += fmt::format("residual vibration at {} Hz, damping {}: {} {}; without {} {} {}\n",
                        rounded(r.mode.frequency), rounded(r.mode.damping), rounded(r.after),
                        units.position,
                        input.spec && input.spec->polydyne ? "[polydyne]" : "the operators",
                        rounded(r.before), units.position);
  if (!report.ok()) text += fmt::format("jounce check: {}\n", one_line(report, input.labels));
  if (const std::string rest = not_limited_text(report, input.labels); !rest.empty())
    text += rest + "\n";
  text += fmt::format("sha256 {}\n", hex(content_hash(table, units)));
  if (!report.ok() && file != "-")
    text += fmt::format("wrote {}, although the motion breaks {}\n", file,
                        counted(report.broken(), "rule"));
  return text;
}

std::string design_json(const Input& input, const Report& report, const std::string& file) {
  const Table& table = input.table.table;
  Json summary{{"table", file},
               {"knots", table.size()},
               {"rule", name(table.rule())},
               {"sha256", hex(content_hash(table, input.labels.units))}};
  if (input.error) {
    summary["error"] = input.error->position;
    summary["error_where"] = input.error->where;
    if (input.binding) {
      summary["error_velocity"] = input.error->velocity;
      summary["binding"] = name(*input.binding);
    }
  }
  summary["broken"] = report.broken();
  for (const Finding& f : report.findings)
    if (is_unlimited(f))
      summary["not_limited"].push_back({{"quantity", f.quantity},
                                        {"unit", input.labels.unit_of(f)},
                                        {"peak", f.value},
                                        {"where", f.where}});
  for (const Residual& r : input.residuals)
    summary["residuals"].push_back({{"frequency", r.mode.frequency},
                                    {"damping", r.mode.damping},
                                    {"before", r.before},
                                    {"after", r.after}});
  return summary.dump();
}

}  // namespace jounce
