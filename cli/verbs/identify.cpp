// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "jounce/base/detail/progress_line.hpp"
#include "jounce/io/recording.hpp"
#include "jounce/proof/identification.hpp"

#include "cli/common/json.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct IdentifyArguments {
  std::string drive;
  std::string log;
  std::vector<std::string> fit;
  std::string output;
  std::string plot;
  int iterations = 50;
  bool json = false;
};

Identification fitted(const Recording& run, const Drive& drive, const IdentifyArguments& options) {
  WatchedWork work("identifying");
  return identify(run, {drive, options.fit, options.iterations}, [&](int done, double share) {
    return work.goes_on(std::min(1.0, done / 20.0),
                        fmt::format("residual {:.3g} of the start's", share));
  });
}

int run_identify(const IdentifyArguments& options) {
  std::FILE* out = text_stream(options.json, {options.output, options.plot});
  for (const std::string& output : {options.output, options.plot}) {
    require_other_file(options.drive, output);
    require_other_file(options.log, output);
  }
  const Spec spec = read_spec(options.drive);
  if (!spec.drive)
    throw spec.document.located(InputError("drive", "", "is missing: the fit needs a [drive]"));
  const std::string& u = spec.units.position;
  const Recording recording = read_recording(options.log, spec.drive->drive, u);
  const Identification found = fitted(recording, spec.drive->drive, options);
  if (options.json)
    print_json(out, identification_json(found));
  else
    fmt::print(out, "{}", identification_text(found, u));
  if (!found.usable()) return finding;
  if (!options.output.empty())
    write_file(options.output, fitted_spec_text(found, spec, options.log), spec.document.files);
  if (!options.output.empty() && found.status != Identification::Status::converged)
    fmt::print(stderr, "jounce: wrote {}, although the fit is not accepted\n", options.output);
  if (!options.plot.empty())
    write_picture(options.plot,
                  identification_figure(found, recording, "identification from " + options.log, u),
                  spec.document.files);
  return found.status == Identification::Status::converged ? fine : finding;
}

}  // namespace

void add_identify(CommandLine& line) {
  const auto options = std::make_shared<IdentifyArguments>();
  const Verb verb =
      line.verb("identify", "Fit numbers of a drive to a recorded run, with confidence intervals",
                "jounce identify drive.toml --log run.csv --fit "
                "motor.inertia,mass[1].stiffness -o fitted.toml");
  verb.option("DRIVE", options->drive,
              "Spec with a [drive], such as the output of `jounce new drive`")
      .required();
  verb.option("--log", options->log,
              "Recording: CSV with time, command, and feedback, velocity, torque, current or load; "
              "or the ticks of a run, from `jounce replay --csv`")
      .required();
  verb.option("--fit", options->fit, "Numbers to fit: motor.inertia,mass[1].stiffness,...")
      .required()
      .separated();
  verb.option("-o,--output", options->output, "Spec to write: DRIVE with the fitted numbers")
      .check(output_file({".toml"}));
  verb.option("--plot", options->plot, "Picture to write, .svg or .png: recorded, model, residual")
      .check(output_file({".svg", ".png"}));
  verb.option("--iterations", options->iterations, "Maximum number of iterations")
      .shown()
      .check(whole(1, 10'000));
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_identify(*options); });
}

}  // namespace jounce::cli
