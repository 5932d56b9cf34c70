// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/design/over_time.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/path_picture.hpp"
#include "jounce/proof/drive_figures.hpp"
#include "jounce/proof/follower_figure.hpp"
#include "jounce/proof/loop_figures.hpp"

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct PlotArguments {
  std::string file;
  std::string axis, machine, plane;
  std::string over;
  std::string before;
  std::string drive;
  bool follower = false;
  std::string output = "-";
};

bool of_loop(const PlotArguments& options) {
  return options.drive == "bode" || options.drive == "nyquist";
}

/// Calls loop_figure(); errors name --drive.
Figure loop_of(const PlotArguments& options) {
  try {
    return loop_figure(options.file, options.axis, options.drive);
  } catch (const InputError& error) {
    if (error.key() != "axis") throw;
    throw InputError("--drive", error.value(), error.rule());
  }
}

/// Calls over_time(); errors name --over.
Input slave_of(const Input& input) {
  const bool is_cam = std::holds_alternative<Cam>(*input.curve);
  if (!is_cam || !input.spec)
    throw InputError("--over", "time",
                     input.name + (is_cam ? " is a table, which has no master: give its spec"
                                          : " is over time already: leave out --over"));
  return over_time(input);
}

Figure figure(const PlotArguments& options) {
  if (of_loop(options)) return loop_of(options);
  std::vector<Input> inputs = load_program(options.file, options.machine, options.axis);
  if (!options.drive.empty()) {
    if (inputs.size() > 1)
      throw InputError("--drive", options.drive, "shows one axis: name it with --axis");
    return drive_figure(inputs.front(), options.drive);
  }
  if (options.follower)
    return follower_figure(inputs.front());  // a spec with [follower] has one axis
  const bool over = options.over == "time";
  if (options.over == "master" && !inputs.front().labels.over_master)
    throw InputError("--over", "master",
                     inputs.front().name + " is over time, without a master: leave out --over");
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
    const std::string picture =
        svg(with_option_names({"plane"}, [&] { return path_figure(axes, options.plane); }));
    under_option("--output", [&] { write_svg_file(options.output, picture); });
    return fine;
  }
  write_picture(options.output, figure(options), drive_look(options.drive));
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
              "Picture to write, .svg or .png; - is SVG on standard output")
      .check(ends_in({".svg", ".png"}));
  verb.work([options] { return run_plot(*options); });
}

}  // namespace jounce::cli
