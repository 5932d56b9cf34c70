// SPDX-License-Identifier: Apache-2.0
#include "cli/optimize/optimizing.hpp"

#include <vector>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/design/cam_check.hpp"
#include "jounce/design/make.hpp"
#include "jounce/io/table_file.hpp"

#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"
#include "cli/optimize/before_after.hpp"
#include "cli/optimize/peaks.hpp"

namespace jounce::cli {
namespace {

/// Whether `jounce check` finds no fault with any axis of a spec. Prints the faults.
bool passes_check(std::FILE* out, const Spec& spec) {
  bool passes = true;
  for (const Input& input : inputs_of(spec, spec.document.name)) {
    const Report report = checked(input);
    if (report.ok()) continue;
    passes = false;
    fmt::print(out, "no file is written: the result breaks these checks:\n{}",
               full_text(report, input.labels));
  }
  return passes;
}

void write(const OptimizeOptions& options, const Spec& given, const Spec& optimised,
           const std::string& text) {
  const Made made = make(optimised);
  const TableFile table{made.sampled.table,
                        optimised.units,
                        {optimised.document.name, hex(optimised.document.hash), made_by()}};
  std::vector<Output> files;
  if (!options.table.empty()) files.push_back({options.table, table_text(options.table, table)});
  if (!options.output.empty()) files.push_back({options.output, text});
  if (!options.plot.empty()) write_picture(options.plot, before_after(given, optimised));
  write_files(files);
}

}  // namespace

std::FILE* told_on(const OptimizeOptions& options) {
  const bool taken = options.output == "-" || options.table == "-" || options.plot == "-";
  return taken ? stderr : stdout;
}

int finish(const OptimizeOptions& options, const Spec& given, nlohmann::ordered_json document,
           const std::optional<std::string>& optimised) {
  std::FILE* out = told_on(options);
  std::optional<Spec> spec;
  if (optimised)
    spec = parse_spec(*optimised, options.output.empty() ? given.document.name : options.output);
  if (spec && options.json) document["peaks"] = peaks_json(given, *spec);
  if (options.json) fmt::print(out, "{}\n", document.dump(1));
  if (!spec) return finding;
  if (!options.json) print_peaks(out, given, *spec);
  if (!passes_check(options.json ? stderr : out, *spec)) return finding;
  write(options, given, *spec, *optimised);
  return fine;
}

}  // namespace jounce::cli
