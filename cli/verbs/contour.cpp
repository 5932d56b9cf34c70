// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/base/detail/printable.hpp"
#include "jounce/design/disc.hpp"

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ContourArguments {
  std::string spec;
  std::string output;
};

int run_contour(const ContourArguments& options) {
  const Input input = load(options.spec);
  const Spec& spec = cam_with_disc(input, options.spec);
  const Disc disc = make_disc(spec, std::get<Cam>(*input.curve));
  const Report report = check_disc(spec, std::get<Cam>(*input.curve));
  if (cannot_be_cut(report) && !options.output.ends_with(".svg")) {
    fmt::print(
        "{}: {} is not written: this plate cannot be cut; draw it as .svg to see the cause\n{}",
        input.name, printable(options.output), full_text(report, input.labels));
    return finding;
  }
  require_other_file(options.spec, options.output);
  const std::string drawing =
      with_option_names({"output"}, [&] { return contour_file(options.output, spec, disc); });
  write_file(options.output, drawing, input.files);
  fmt::print("{}: {} within {} {} of the exact contour (certified)\n", input.name,
             printable(options.output), rounded(spec.disc->tolerance), spec.disc->length);
  fmt::print("{}\n{}", extremes_text(spec, disc), full_text(report, input.labels));
  return report.ok() ? fine : finding;
}

}  // namespace

void add_contour(CommandLine& line) {
  const auto options = std::make_shared<ContourArguments>();
  const Verb verb = line.verb("contour", "Draw the contour of a cam plate with [disc]",
                              "jounce contour valve.toml -o valve.dxf");
  verb.option("SPEC", options->spec, "Spec of a cam with [disc]; - is standard input").required();
  verb.option("-o,--output", options->output,
              "Drawing to write, in mm: .dxf (R12), .svg (prints 1:1) or .csv (points)")
      .check(output_file())
      .required();
  verb.work([options] { return run_contour(*options); });
}

}  // namespace jounce::cli
