#include "optimizing.hpp"

#include <vector>

#include <fmt/format.h>

#include "jounce/io/file.hpp"
#include "jounce/io/make.hpp"
#include "jounce/io/table_file.hpp"

#include "before_after.hpp"
#include "cam_check.hpp"
#include "picture.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

/// Whether `jounce check` finds no fault with any axis of a spec. Prints the faults.
bool passes_check(std::FILE* out, const Spec& spec) {
  bool passes = true;
  for (const Input& input : inputs_of(spec, spec.document.name)) {
    const Report report = checked(input);
    if (report.ok()) continue;
    passes = false;
    fmt::print(out, "nothing is written: `jounce check` finds fault with the result:\n{}",
               full_text(report, input.labels));
  }
  return passes;
}

}  // namespace

std::FILE* told_on(const OptimizeOptions& options) {
  const bool taken = options.output == "-" || options.table == "-" || options.plot == "-";
  return taken ? stderr : stdout;
}

int write_optimized(const OptimizeOptions& options, const Spec& before, const std::string& text) {
  const std::string path = options.output.empty() ? before.document.name : options.output;
  const Spec better = parse_spec(text, path);
  if (!passes_check(options.json ? stderr : told_on(options), better)) return finding;
  const Made made = make(better);
  const TableFile table{
      made.sampled.table, better.units, {path, hex(better.document.hash), made_by()}};
  std::vector<Output> files;
  if (!options.table.empty()) files.push_back({options.table, table_text(options.table, table)});
  if (!options.output.empty()) files.push_back({options.output, text});
  if (!options.plot.empty()) write_picture(options.plot, before_after(before, better));
  write_files(files);
  return fine;
}

}  // namespace jounce::cli
