// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/spec/detail/share.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

NumberTolerance read_tolerance(TomlReader& table, Drive& drive) {
  NumberTolerance tolerance;
  tolerance.key = table.text("key", "KEY");
  const std::vector<DriveNumber> known = numbers(drive);
  const auto number = std::find_if(known.begin(), known.end(),
                                   [&](const DriveNumber& n) { return n.key == tolerance.key; });
  if (number == known.end()) {
    std::vector<std::string> keys;
    for (const DriveNumber& n : known) keys.push_back(n.key);
    const std::string meant = nearest(tolerance.key, keys);
    table.fail(
        "key", tolerance.key,
        "names no number of this drive" + (meant.empty() ? "" : ": did you mean " + meant + "?"));
  }
  if (!table.has("share") && !table.has("absolute"))
    table.fail("share", "", "is missing: give share = \"10 %\", or absolute");
  tolerance.share = optional_share(table, "share").value_or(0);
  tolerance.absolute = table.optional_number("absolute", number->unit).value_or(0);
  const std::vector<std::string> shapes{"uniform", "normal"};
  tolerance.normal = table.optional_choice("distribution", shapes).value_or(0) == 1;
  table.finish();
  return tolerance;
}

}  // namespace

std::optional<ToleranceSpec> read_tolerances(TomlReader& drive_table, const Drive& drive) {
  auto table = drive_table.optional_table("tolerances");
  if (!table) return std::nullopt;
  ToleranceSpec spec;
  Drive copy = drive;
  for (TomlReader& number : table->tables("number"))
    spec.numbers.push_back(read_tolerance(number, copy));
  const std::vector<std::string> methods{"corners", "monte_carlo"};
  if (table->optional_choice("method", methods).value_or(0) == 1)
    spec.method = ToleranceSpec::Method::monte_carlo;
  spec.cases = table->optional_count("cases").value_or(spec.cases);
  spec.seed = table->optional_count("seed").value_or(spec.seed);
  table->finish();
  if (spec.numbers.empty())
    drive_table.fail("tolerances", "", "needs at least one [[drive.tolerances.number]]");
  return spec;
}

}  // namespace jounce::spec_detail
