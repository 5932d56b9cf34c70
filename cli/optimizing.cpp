#include "optimizing.hpp"

#include <vector>

#include "jounce/io/file.hpp"
#include "jounce/io/make.hpp"
#include "jounce/io/table_file.hpp"

#include "before_after.hpp"
#include "picture.hpp"

namespace jounce::cli {

std::FILE* told_on(const OptimizeOptions& options) {
  const bool taken = options.output == "-" || options.table == "-" || options.plot == "-";
  return taken ? stderr : stdout;
}

void write_optimized(const OptimizeOptions& options, const Spec& before, const std::string& text) {
  const std::string path = options.output.empty() ? before.document.name : options.output;
  const Spec better = parse_spec(text, path);
  const Made made = make(better);
  const TableFile table{
      made.sampled.table, better.units, {path, hex(better.document.hash), made_by()}};
  std::vector<Output> files;
  if (!options.table.empty()) files.push_back({options.table, table_text(options.table, table)});
  if (!options.output.empty()) files.push_back({options.output, text});
  if (!options.plot.empty()) write_picture(options.plot, before_after(before, better));
  write_files(files);
}

}  // namespace jounce::cli
