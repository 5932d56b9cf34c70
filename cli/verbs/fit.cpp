// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/fit.hpp"

#include <memory>

#include <fmt/format.h>

#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct FitArguments {
  std::string file, output = "-";
  FitOptions fit;
  bool json = false;
};

int run_fit(const FitArguments& options) {
  std::FILE* out = text_stream(options.json, {options.output});
  require_other_file(options.file, options.output);
  const FittedCam made =
      with_option_names({"tolerance", "period", "drawing", "master_unit", "position_unit"},
                        [&] { return fitted_cam(options.file, options.fit); });
  write_file(options.output, made.text);
  fmt::print(out, "{}", options.json ? fit_json(made, options.output) + "\n" : fit_text(made));
  return made.ok() ? fine : finding;
}

}  // namespace

void add_fit(CommandLine& line) {
  const auto options = std::make_shared<FitArguments>();
  const Verb verb = line.verb("fit", "Make the spec of a cam from measured points or a table",
                              "jounce fit measured.csv --tolerance 20um -o cam.toml");
  verb.option(
          "FILE", options->file,
          "Columns master and slave (CSV, .xlsx), a drawing (.dxf, .svg), or a cam table in any "
          "known format; - is standard input")
      .required();
  verb.option("--tolerance", options->fit.tolerance,
              "Greatest distance of the cam from a point, with the error of the measurement; "
              "default: the column tolerance of the file");
  verb.option("--period", options->fit.period,
              "The cam repeats after this travel of the master, such as 360deg");
  verb.option("--drawing", options->fit.drawing,
              "Keys of the table drawing, such as \"roller_radius = 8, offset = 3\"");
  verb.option("--master-unit", options->fit.master_unit,
              "Unit of the master, for a file without units");
  verb.option("--position-unit", options->fit.position_unit, "The same for the slave");
  verb.option("-o,--output", options->output, "Spec to write; - is standard output")
      .check(output_file({".toml"}));
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_fit(*options); });
}

}  // namespace jounce::cli
