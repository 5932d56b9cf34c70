// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/identify.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/io/recording.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/spec/drive_file.hpp"

#include "cli/common/folders.hpp"
#include "cli/common/interrupt.hpp"
#include "cli/common/json.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/progress.hpp"
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

/// The recorded values of a quantity, with its unit and its label in the picture.
struct Quantity {
  const std::vector<double>& recorded;
  std::string unit;
  bool deviation;  ///< drawn and reported as its distance from the command
};

Quantity quantity_named(const Recording& run, const std::string& name, const std::string& u) {
  if (name == "position") return {run.position, u, true};
  if (name == "load") return {run.load, u, true};
  if (name == "velocity") return {run.velocity, u + "/s", false};
  return {run.torque, "N m", false};
}

std::string interval(const FittedNumber& n) {
  return fmt::format("{} to {}", rounded(n.low), rounded(n.high));
}

/// "1.2 %", half the interval over the value.
std::string share(const FittedNumber& n) {
  const double half = 50 * std::abs((n.high - n.low) / n.value);
  return half < 1000 ? fmt::format("+-{:.2g} %", half) : "unknown";
}

void print_text(std::FILE* out, const Identification& found, const Recording& run,
                const std::string& u) {
  fmt::print(out, "{}: {}\n", name(found.status), found.reason);
  if (found.numbers.empty()) return;
  fmt::print(out, "  {:<28} {:>12} {:>12} {:>12}   95 % interval\n", "", "start", "fitted", "");
  for (const FittedNumber& n : found.numbers)
    fmt::print(out, "  {:<28} {:>12} {:>12} {:>12}   {} {}\n", n.key, rounded(n.start),
               rounded(n.value), share(n), interval(n), n.unit);
  for (const Explained& e : found.explained)
    fmt::print(out, "  residual of {:<16} {:>12} {:>12} {:>12}   {} rms\n", e.quantity,
               rounded(e.before), rounded(e.after), "", quantity_named(run, e.quantity, u).unit);
  for (const Entangled& e : found.entangled)
    fmt::print(out, "  - {} and {} are hardly distinguishable (correlation {:.4f})\n", e.first,
               e.second, e.correlation);
  for (const std::string& note : found.notes) fmt::print(out, "  - {}\n", note);
}

void print_json(std::FILE* out, const Identification& found) {
  Json numbers = Json::array(), entangled = Json::array(), explained = Json::array();
  for (const FittedNumber& n : found.numbers)
    numbers.push_back({{"key", n.key},
                       {"unit", n.unit},
                       {"start", n.start},
                       {"value", n.value},
                       {"low", n.low},
                       {"high", n.high}});
  for (const Entangled& e : found.entangled)
    entangled.push_back({{"first", e.first}, {"second", e.second}, {"correlation", e.correlation}});
  for (const Explained& e : found.explained)
    explained.push_back({{"quantity", e.quantity},
                         {"rms_before", e.before},
                         {"rms_after", e.after},
                         {"autocorrelation", e.autocorrelation}});
  const Json document{{"status", name(found.status)}, {"usable", found.usable()},
                      {"reason", found.reason},       {"numbers", numbers},
                      {"entangled", entangled},       {"explained", explained},
                      {"notes", found.notes},         {"iterations", found.iterations}};
  fmt::print(out, "{}\n", document.dump(1));
}

/// Recorded and model above each other, what is left below.
Figure picture(const Identification& found, const Recording& run, const IdentifyArguments& options,
               const std::string& u) {
  Figure figure{.title = "identification from " + options.log, .x_label = "time [s]"};
  for (const Explained& e : found.explained) {
    const Quantity q = quantity_named(run, e.quantity, u);
    std::vector<double> recorded = q.recorded, model = e.model, left = e.model;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
      left[i] = recorded[i] - model[i];
      if (q.deviation) recorded[i] -= run.command[i], model[i] -= run.command[i];
    }
    const std::string what = e.quantity + (q.deviation ? " - command" : "");
    figure.panels.push_back({.y_label = fmt::format("{} [{}]", what, q.unit),
                             .series = {{"recorded", run.time, recorded, Style::under},
                                        {"fitted model", run.time, model}}});
    figure.panels.push_back({.y_label = fmt::format("residual [{}]", q.unit),
                             .series = {{"recorded - model", run.time, left, Style::dots}}});
  }
  return figure;
}

std::string fitted_file(const Identification& found, DriveSpec drive, const Units& units,
                        const IdentifyArguments& options) {
  drive.drive = found.drive;
  std::map<std::string, std::string> beside;
  for (const FittedNumber& n : found.numbers)
    beside[n.key] = "95 %: " + interval(n) + ", was " + rounded(n.start);
  return drive_text(
      drive, units,
      fmt::format("{} with numbers fitted to {} by jounce identify", options.drive, options.log),
      beside);
}

Identification fitted(const Recording& run, const Drive& drive, const IdentifyArguments& options) {
  Progress progress("identifying");
  const Interrupt interrupt;
  const Trajectory command = commanded_motion(run);
  return identify(run, command, {drive, options.fit, options.iterations},
                  [&](int done, double share) {
                    progress.show(std::min(1.0, done / 20.0),
                                  fmt::format("residual {:.3g} of the start's", share));
                    return !interrupt.asked();
                  });
}

int run_identify(const IdentifyArguments& options) {
  for (const std::string& output : {options.output, options.plot}) {
    require_other_file(options.drive, output);
    require_other_file(options.log, output);
  }
  require_folders({{"--output", options.output}, {"--plot", options.plot}});
  if (!options.plot.empty()) require_picture("--plot", options.plot);
  const Spec spec = read_spec(options.drive);
  if (!spec.drive)
    throw spec.document.located(InputError("drive", "", "is missing: the fit needs a [drive]"));
  const std::string& u = spec.units.position;
  const Recording recording = read_recording(options.log, spec.drive->drive, u);
  const Identification found = fitted(recording, spec.drive->drive, options);
  std::FILE* out = options.output == "-" || options.plot == "-" ? stderr : stdout;
  options.json ? print_json(out, found) : print_text(out, found, recording, u);
  if (!found.usable()) return finding;
  if (!options.output.empty())
    write_file(options.output, fitted_file(found, *spec.drive, spec.units, options));
  if (!options.plot.empty()) write_picture(options.plot, picture(found, recording, options, u));
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
              "Recording: CSV with time, command, and feedback, torque, current, ...")
      .required();
  verb.option("--fit", options->fit, "Numbers to fit: motor.inertia,mass[1].stiffness,...")
      .required()
      .separated();
  verb.option("-o,--output", options->output, "Drive with the fitted numbers to write");
  verb.option("--plot", options->plot, "Picture to write, .svg or .png: recorded, model, residual");
  verb.option("--iterations", options->iterations, "Maximum number of iterations")
      .shown()
      .check(whole(1, 10'000));
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_identify(*options); });
}

}  // namespace jounce::cli
