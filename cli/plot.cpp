#include <memory>

#include "jounce/io/file.hpp"

#include "picture.hpp"
#include "verb.hpp"

namespace jounce::cli {
namespace {

struct Options {
  std::string file;
  std::string before;
  std::string output = "-";
};

int run(const Options& options) {
  const bool png = options.output.ends_with(".png");
  if (!png && !options.output.ends_with(".svg") && options.output != "-")
    throw InputError("--output", options.output,
                     "must end in .svg or .png, or be - for SVG on standard output");
  const Input input = load(options.file);
  const auto before = options.before.empty() ? std::nullopt : std::optional(load(options.before));
  const std::string picture = svg(figure_of(input, before));
  if (png)
    write_png(options.output, picture);
  else
    write_file(options.output, picture);
  return fine;
}

}  // namespace

void add_plot(CLI::App& app, Work& work) {
  const auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, "plot", "Draw position, velocity, acceleration and jerk",
                            "jounce plot better.toml --before cam.toml -o cam.png");
  verb->add_option("FILE", options->file, "Spec or table; - is standard input")->required();
  verb->add_option("--before", options->before, "Another one, drawn paler underneath");
  verb->add_option("-o,--output", options->output,
                   "Picture to write, .svg or .png; - is SVG on standard output");
  verb->callback([options, &work] { work = [options] { return run(*options); }; });
}

}  // namespace jounce::cli
