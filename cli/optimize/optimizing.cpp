// SPDX-License-Identifier: Apache-2.0
#include "cli/optimize/optimizing.hpp"

#include <vector>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/design/cam_check.hpp"
#include "jounce/design/make.hpp"
#include "jounce/design/path_text.hpp"
#include "jounce/io/table_file.hpp"

#include "cli/common/input.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"
#include "cli/optimize/before_after.hpp"
#include "cli/optimize/peaks.hpp"

namespace jounce::cli {
namespace {

/// True if `jounce check` finds no fault with any axis of a spec. Prints the faults.
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

/// For a path: what was gained, and the proven bound.
void print_bound(std::FILE* out, const Spec& given, const Spec& optimized) {
  if (!std::holds_alternative<PathSpec>(optimized.subject)) return;
  const std::shared_ptr<const Plan> before = make_axes(given).front().plan;
  const std::shared_ptr<const Plan> after = make_axes(optimized).front().plan;
  if (!before || !after) return;  // lines that overlap
  const double bound = lower_bound(*after);
  fmt::print(out, "{}at least {} {} on this path (proven; jerk not limited): {} times the bound\n",
             path_difference(optimized, *before, *after), rounded(bound), optimized.units.x,
             rounded(after->duration() / bound));
}

void write(const OptimizeArguments& options, const Spec& given, const Spec& optimized,
           const std::string& text) {
  std::vector<Output> files;
  if (!options.table.empty()) {
    const std::vector<Input> inputs = inputs_of(optimized, optimized.document.name);
    for (const Input& input : inputs) {
      const std::string file = file_of_axis("--table", options.table, input.axis, inputs.size());
      files.push_back({file, table_text(file, input.table)});
    }
  }
  if (!options.output.empty()) files.push_back({options.output, text});
  if (!options.plot.empty()) write_picture(options.plot, before_after(given, optimized));
  write_files(files);
}

}  // namespace

std::FILE* text_stream(const OptimizeArguments& options) {
  const bool taken = options.output == "-" || options.table == "-" || options.plot == "-";
  return taken ? stderr : stdout;
}

int finish(const OptimizeArguments& options, const Spec& given, nlohmann::ordered_json document,
           const std::optional<std::string>& optimized) {
  std::FILE* out = text_stream(options);
  std::optional<Spec> spec;
  if (optimized)
    spec = parse_spec(*optimized, options.output.empty() ? given.document.name : options.output);
  if (spec && options.json) document["peaks"] = peaks_json(given, *spec);
  if (options.json) fmt::print(out, "{}\n", document.dump(1));
  if (!spec) return finding;
  if (!options.json) {
    print_peaks(out, given, *spec);
    print_bound(out, given, *spec);
  }
  if (!passes_check(options.json ? stderr : out, *spec)) return finding;
  write(options, given, *spec, *optimized);
  return fine;
}

}  // namespace jounce::cli
