// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/base/file.hpp"
#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/design/over_time.hpp"
#include "jounce/plot/path_picture.hpp"
#include "jounce/proof/drive_figures.hpp"
#include "jounce/proof/follower_figure.hpp"
#include "jounce/proof/loop_figures.hpp"

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/picture.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct PlotArguments {
  std::string file;
  std::string axis, machine, plane;
  std::string over = "master";
  std::string before;
  std::string drive;
  bool follower = false;
  std::string output = "-";
};

/// The drive of a spec or of its axis, without the curve: a spec of kind "drive" has none.
Drive drive_of(const PlotArguments& options) {
  const std::string text = read_file(options.file);
  const std::string name = options.file == "-" ? "standard input" : options.file;
  const InputError missing("drive", "", "is missing: this picture needs a spec with a [drive]");
  if (is_table(text) || cam_format_of_text(text) != nullptr) throw InputError(missing).at(name);
  const Spec spec = parse_spec(text, name);
  const std::vector<AxisPart> parts = spec.parts();
  if (parts.size() > 1 && options.axis.empty())
    throw InputError("--drive", options.drive, "shows one axis: name it with --axis");
  for (const AxisPart& part : parts)
    if (part.drive && (options.axis.empty() || part.name == options.axis)) return part.drive->drive;
  throw spec.document.located(missing);
}

Figure loop_figure(const PlotArguments& options) {
  const Drive drive = drive_of(options);
  Figure figure = options.drive == "bode" ? bode_figure(drive) : nyquist_figure(drive);
  figure.title = options.file + ": " + figure.title;
  return figure;
}

bool of_loop(const PlotArguments& options) {
  return options.drive == "bode" || options.drive == "nyquist";
}

/// Calls over_time(); errors name --over.
Input slave_of(const Input& input) {
  const bool is_cam = std::holds_alternative<Cam>(*input.curve);
  if (!is_cam || !input.spec)
    throw InputError("--over", "time",
                     input.name + (is_cam ? " is a table without a master: give its spec"
                                          : " is over time already: leave out --over"));
  return over_time(input);
}

Figure figure(const PlotArguments& options) {
  if (of_loop(options)) return loop_figure(options);
  std::vector<Input> inputs = load_program(options.file, options.machine, options.axis);
  if (!options.drive.empty()) {
    if (inputs.size() > 1)
      throw InputError("--drive", options.drive, "shows one axis: name it with --axis");
    return drive_figure(inputs.front(), options.drive);
  }
  if (options.follower) {  // a spec with a [follower] has one axis
    const Input& input = inputs.front();
    const FollowerResult run = followed(input, 2001);
    Figure figure = follower_figure(run, *input.spec->follower, input.labels.units.position);
    figure.title = input.name + ": " + figure.title;
    return figure;
  }
  const bool over = options.over == "time";
  if (over)
    for (Input& input : inputs) input = slave_of(input);
  if (options.before.empty()) return with_option_names({"axis"}, [&] { return figure_of(inputs); });
  if (inputs.size() > 1)
    throw InputError("--before", options.before, "compares one axis: name it with --axis");
  const Input before = load_beside(options.before, inputs.front());
  return with_option_names(
      {"before"}, [&] { return figure_of(inputs.front(), over ? slave_of(before) : before); });
}

int run_plot(const PlotArguments& options) {
  require_other_file(options.file, options.output);
  if (!options.plane.empty()) {
    const std::vector<Input> axes = load_program(options.file, options.machine, "");
    write_svg(options.output, svg(with_option_names(
                                  {"plane"}, [&] { return path_figure(axes, options.plane); })));
    return fine;
  }
  SvgOptions look;
  if (options.drive == "torque-speed" || options.drive == "spectrum") look.panel_height = 320;
  if (options.drive == "bode") look.panel_height = 220;
  if (options.drive == "nyquist") look.panel_height = nyquist_height;
  write_picture(options.output, figure(options), look);
  return fine;
}

}  // namespace

void add_plot(CommandLine& line) {
  const auto options = std::make_shared<PlotArguments>();
  const Verb verb = line.verb("plot", "Draw position, velocity, acceleration and jerk",
                              "jounce plot better.toml --before cam.toml -o cam.png");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  const Option axis = verb.axis(options->axis);
  verb.machine(options->machine);
  const Option over =
      verb.option(
              "--over", options->over,
              "Draw a cam over its master, or the slave over time with the [master] of the spec")
          .check(one_of({"master", "time"}));
  const Option before =
      verb.option("--before", options->before, "Spec or table to draw paler underneath");
  const Option drive =
      verb.option("--drive", options->drive,
                  "For a spec with a [drive]: response over time, torque over speed within the "
                  "envelope of the motor, spectrum of the residual vibration, or frequency "
                  "response of the loop with the margins (bode, nyquist)")
          .check(one_of({"response", "torque-speed", "spectrum", "bode", "nyquist"}))
          .excludes({over, before});
  const Option follower = verb.flag("--follower", options->follower,
                                    "For a cam with a [follower]: lift and contact force over time")
                              .excludes({over, before, drive});
  verb.option("--plane", options->plane,
              "For a path: draw it in the plane of two axes, such as x,y, colored by its speed")
      .excludes({axis, over, before, drive, follower});
  verb.option("-o,--output", options->output,
              "Picture to write, .svg or .png; - is SVG on standard output");
  verb.work([options] { return run_plot(*options); });
}

}  // namespace jounce::cli
