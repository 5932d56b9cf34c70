// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "jounce/base/file.hpp"
#include "jounce/base/printable.hpp"
#include "jounce/design/disc.hpp"

#include "cli/common/input.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ContourArguments {
  std::string spec;
  std::string output;
};

std::string drawn(const ContourArguments& options, const Spec& spec, const Disc& disc) {
  if (options.output.ends_with(".dxf")) return contour_dxf(drawing_of(spec, disc));
  if (options.output.ends_with(".svg")) return contour_svg(drawing_of(spec, disc));
  if (options.output.ends_with(".csv")) return contour_csv(spec, disc);
  throw InputError("--output", options.output, "must end in .dxf, .svg or .csv");
}

void print_extremes(const Disc& disc, const Spec& spec) {
  const DiscExtremes e = extremes(disc);
  const std::string& length = spec.disc->length;
  const auto at = [&](const Extremum& x) { return rounded(x.where) + " " + spec.units.x; };
  const auto deg = [](const Extremum& x) { return rounded(x.value * 180 / std::numbers::pi); };
  const double roller = spec.disc->geometry.roller_radius;
  fmt::print("pressure angle: {} deg at {} .. {} deg at {}\n", deg(e.pressure_angle.min),
             at(e.pressure_angle.min), deg(e.pressure_angle.max), at(e.pressure_angle.max));
  fmt::print("profile, most convex: radius {} {} at {}\n",
             rounded(1 / e.pitch_curvature.max.value - roller), length, at(e.pitch_curvature.max));
  if (e.pitch_curvature.min.value < 0)
    fmt::print("profile, most hollow: radius {} {} at {}\n",
               rounded(roller - 1 / e.pitch_curvature.min.value), length,
               at(e.pitch_curvature.min));
  else
    fmt::print("profile: nowhere hollow\n");
}

/// Whether the contour crosses itself or the cutter does not get into it.
bool cannot_be_cut(const Report& report) {
  return std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& f) {
    return f.broken && (f.rule == "disc/interference" || f.rule == "disc/cutter_radius" ||
                        (f.rule == "disc/profile_radius" && f.value <= 0));
  });
}

int run_contour(const ContourArguments& options) {
  const Input input = load(options.spec);
  if (!input.spec || !std::holds_alternative<CamSpec>(input.spec->subject))
    throw InputError("SPEC", input.name, "must be a spec of kind \"cam\" with [disc]");
  const Spec& spec = *input.spec;
  const Disc disc = make_disc(spec, std::get<Cam>(*input.curve));
  const Report report = check_disc(spec, std::get<Cam>(*input.curve));
  if (cannot_be_cut(report) && !options.output.ends_with(".svg")) {
    fmt::print(
        "{}: {} is not written: this plate cannot be cut; draw it as .svg to see the cause\n{}",
        input.name, printable(options.output), full_text(report, input.labels));
    return finding;
  }
  require_other_file(options.spec, options.output);
  write_file(options.output, drawn(options, spec, disc));
  fmt::print("{}: {} within {} {} of the exact contour (certified)\n", input.name,
             printable(options.output), rounded(spec.disc->tolerance), spec.disc->length);
  print_extremes(disc, spec);
  fmt::print("\n{}", full_text(report, input.labels));
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
      .required();
  verb.work([options] { return run_contour(*options); });
}

}  // namespace jounce::cli
