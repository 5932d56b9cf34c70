#include <memory>

#include "drive_figures.hpp"
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
  std::string output = "-";
};

Figure figure(const Options& options) {
  std::vector<Input> inputs = load_axes(options.file, options.axis);
  if (!options.drive.empty()) {
    if (inputs.size() > 1)
      throw InputError("--drive", options.drive, "is of one axis: say which with --axis");
    return drive_figure(inputs.front(), options.drive);
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
  write_picture(options.output, figure(options));
  return fine;
}

}  // namespace

void add_plot(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, "plot", "Draw position, velocity, acceleration and jerk",
                            "jounce plot better.toml --before cam.toml -o cam.png");
  verb->add_option("FILE", options->file, "Spec or table; - is standard input")->required();
  add_axis_option(verb, options->axis);
  verb->add_option("--over", options->over,
                   "A cam over its master, or its slave over time behind the [master] of the spec")
      ->check(CLI::IsMember({"master", "time"}));
  verb->add_option("--drive", options->drive,
                   "Of a spec with a [drive]: its response over time, its torque over speed within "
                   "the motor's envelope, or the spectrum of the vibration left")
      ->check(CLI::IsMember({"response", "torque-speed", "spectrum"}));
  verb->add_option("--before", options->before, "Another one, drawn paler underneath");
  verb->add_option("-o,--output", options->output,
                   "Picture to write, .svg or .png; - is SVG on standard output");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
