// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "jounce/plot/path_picture.hpp"
#include "jounce/proof/any_figure.hpp"
#include "jounce/proof/drive_figures.hpp"

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct PlotArguments {
  FigureRequest figure{.file = {}, .output = "-"};
  std::string plane;
};

int run_plot(const PlotArguments& options) {
  const FigureRequest& request = options.figure;
  require_other_file(request.file, request.output);
  if (!options.plane.empty()) {
    const std::vector<Input> axes = load_program(request.file, request.machine, "");
    const std::string picture =
        svg(with_option_names({"plane"}, [&] { return path_figure(axes, options.plane); }));
    under_option("--output", [&] {
      require_no_input(files_of(axes), request.output);
      write_svg_file(request.output, picture);
    });
    return fine;
  }
  const Figure figure =
      with_option_names({"axis", "over", "before", "drive"}, [&] { return any_figure(request); });
  write_picture(request.output, figure, {}, drive_look(request.drive));
  return fine;
}

}  // namespace

void add_plot(CommandLine& line) {
  const auto options = std::make_shared<PlotArguments>();
  const Verb verb = line.verb("plot", "Draw position, velocity, acceleration and jerk",
                              "jounce plot better.toml --before cam.toml -o cam.png");
  verb.option("FILE", options->figure.file, "Spec or table; - is standard input").required();
  const Option axis = verb.axis(options->figure.axis);
  verb.machine(options->figure.machine);
  const Option over = verb.over(options->figure.over);
  const Option before =
      verb.option("--before", options->figure.before, "Spec or table to draw paler underneath");
  const Option drive =
      verb.option("--drive", options->figure.drive,
                  "For a spec with a [drive]: response over time, torque over speed within the "
                  "envelope of the motor, spectrum of the residual vibration, or frequency "
                  "response of the loop with the margins (bode, nyquist)")
          .check(one_of({"response", "torque-speed", "spectrum", "bode", "nyquist"}))
          .excludes({over, before});
  const Option follower = verb.flag("--follower", options->figure.follower,
                                    "For a cam with a [follower]: lift and contact force over time")
                              .excludes({over, before, drive});
  verb.option("--plane", options->plane,
              "For a path: draw it in the plane of two axes, such as x,y, colored by its speed")
      .excludes({axis, over, before, drive, follower});
  verb.option("-o,--output", options->figure.output,
              "Picture to write, .svg or .png; - is SVG on standard output")
      .check(output_file({".svg", ".png"}));
  verb.work([options] { return run_plot(*options); });
}

}  // namespace jounce::cli
