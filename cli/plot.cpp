#include <memory>

#include "drive_figures.hpp"
#include "follower_figure.hpp"
#include "over_time.hpp"
#include "picture.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string file;
  std::string axis;
  std::string over = "master";
  std::string before;
  std::string drive;
  bool follower = false;
  std::string output = "-";
};

Figure figure(const Options& options) {
  std::vector<Input> inputs = load_axes(options.file, options.axis);
  if (!options.drive.empty()) {
    if (inputs.size() > 1)
      throw InputError("--drive", options.drive, "is of one axis: say which with --axis");
    return drive_figure(inputs.front(), options.drive);
  }
  if (options.follower) {  // of a cam: one axis
    const Input& input = inputs.front();
    const FollowerResult run = followed(input, 2001);
    Figure figure = follower_figure(run, *input.spec->follower, input.labels.units.position);
    figure.title = input.name + ": " + figure.title;
    return figure;
  }
  const bool over = options.over == "time";
  if (over)
    for (Input& input : inputs) input = over_time(input);
  if (options.before.empty()) return figure_of(inputs);
  if (inputs.size() > 1)
    throw InputError("--before", options.before, "compares one axis: say which with --axis");
  const Input before = load_beside(options.before, inputs.front());
  return figure_of(inputs.front(), over ? over_time(before) : before);
}

int run(const Options& options) {
  require_other_file(options.file, options.output);
  SvgOptions look;
  if (options.drive == "torque-speed" || options.drive == "spectrum") look.panel_height = 320;
  write_picture(options.output, figure(options), look);
  return fine;
}

}  // namespace

void add_plot(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, "plot", "Draw position, velocity, acceleration and jerk",
                            "jounce plot better.toml --before cam.toml -o cam.png");
  verb->add_option("FILE", options->file, "Spec or table; - is standard input")->required();
  add_axis_option(verb, options->axis);
  CLI::Option* over =
      verb->add_option(
              "--over", options->over,
              "A cam over its master, or its slave over time behind the [master] of the spec")
          ->check(CLI::IsMember({"master", "time"}));
  CLI::Option* before =
      verb->add_option("--before", options->before, "Another one, drawn paler underneath");
  verb->add_option("--drive", options->drive,
                   "Of a spec with a [drive]: its response over time, its torque over speed within "
                   "the motor's envelope, or the spectrum of the vibration left")
      ->check(CLI::IsMember({"response", "torque-speed", "spectrum"}))
      ->excludes(over, before);
  verb->add_flag("--follower", options->follower,
                 "Of a cam with a [follower]: its lift and its contact force over time")
      ->excludes(over, before, "--drive");
  verb->add_option("-o,--output", options->output,
                   "Picture to write, .svg or .png; - is SVG on standard output");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
