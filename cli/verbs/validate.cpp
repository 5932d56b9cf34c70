// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "jounce/base/detail/progress_line.hpp"
#include "jounce/proof/drive_signals.hpp"
#include "jounce/proof/proof.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"
#include "cli/verbs/check_run.hpp"

namespace jounce::cli {
namespace {

struct ValidateArguments {
  CheckRun run;
  std::string axis, machine;
  std::string log;
  std::string signals;
  std::size_t samples = 2001;
};

/// Throws InputError if --signals cannot be written: a wrong path, several axes, or no [drive].
void require_signals_of(const ValidateArguments& options, const std::vector<Input>& inputs) {
  if (options.signals.empty()) return;
  require_signals("--signals", options.signals);
  require_other_file(options.run.file(), options.signals);
  require_no_input({options.log}, options.signals);
  if (inputs.size() > 1)
    throw InputError("--signals", options.signals, "is for one axis: name it with --axis");
  if (!inputs.front().drive)
    throw InputError("drive", "", "is missing: --signals needs a [drive]").at(options.run.file());
}

/// Calls prove() with a progress line.
Proof proven(const Input& input, const ValidateArguments& options) {
  std::optional<ProgressLine> line;
  const auto progress = [&](double share) {
    if (!line) line.emplace("tolerances");
    line->show(share);
  };
  return prove(input, {.log = options.log,
                       .drive_samples = options.signals.empty() ? 0 : options.samples,
                       .progress = progress});
}

/// The whole answer for one file.
int print_answer(const ValidateArguments& options) {
  const bool json = options.run.json;
  const std::vector<Input> inputs = load_program(options.run.file(), options.machine, options.axis);
  if (inputs.size() > 1 && !options.log.empty())
    throw InputError("--log", options.log, "is for one axis: name it with --axis");
  require_signals_of(options, inputs);
  std::FILE* out = options.signals == "-" ? stderr : stdout;
  bool ok = true;
  std::vector<std::pair<std::string, std::string>> documents;
  for (const Input& input : inputs) {
    const Proof proof = proven(input, options);
    ok = ok && proof.report.ok() && (!options.run.strict || proof.report.warnings() == 0);
    if (!options.signals.empty())
      write_file(options.signals, signals_file(*proof.drive, input, options.signals), input.files);
    if (json)
      documents.emplace_back(input.axis, proof_json(proof, input));
    else
      fmt::print(out, "{}", proof_answer(proof, input));
  }
  if (json) print_json(out, axes_json(documents));
  return ok ? fine : finding;
}

int run_validate(const ValidateArguments& options) {
  for (const auto& [option, value] : {std::pair{"--axis", &options.axis},
                                      {"--log", &options.log},
                                      {"--signals", &options.signals}})
    require_one_file(options.run, option, *value);
  if (options.run.is_one_answer())
    return answer(options.run, [&] { return print_answer(options); });
  const auto examine = [](std::vector<Input>& axes) {
    std::vector<Report> reports;
    for (const Input& axis : axes) reports.push_back(prove(axis).report);
    return reports;
  };
  return check_files("validate", options.run, examine, options.machine);
}

}  // namespace

void add_validate(CommandLine& line) {
  const auto options = std::make_shared<ValidateArguments>();
  const Verb verb = line.verb(
      "validate",
      "Prove motions by integration, in a servo model, and against the log of an executor",
      "jounce validate cam.toml --log run.csv\n"
      "jounce validate . --format junit");
  add_run_options(verb, options->run);
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--log", options->log,
              "Tick log of an executor: compare every tick with the table (to rounding) and with "
              "the exact curve (within the tolerance of the table)");
  const Option signals = verb.option(
      "--signals", options->signals,
      "Signals of the [drive] over time to write, .csv or .npy: reference, motor, load, "
      "velocity, torque, current; - is CSV on standard output. `jounce identify` reads these "
      "columns");
  signals.check(output_file({".csv", ".npy"}));
  verb.option("--samples", options->samples,
              "Number of rows of --signals, equally spaced over the run")
      .needs(signals)
      .shown()
      .check(whole(2, 10'000'000));
  verb.work([options] { return run_validate(*options); });
}

}  // namespace jounce::cli
