// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include <fmt/format.h>

#include "jounce/design/detail/law_guide.hpp"
#include "jounce/plot/input_figure.hpp"

#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct LawsArguments {
  std::string law;
  std::string output;
  bool markdown = false;
  bool json = false;
};

/// A law by its name; errors name LAW.
Law named(const std::string& word) {
  return under_option("LAW", [&] { return law_of(word); });
}

void draw(const LawsArguments& options) {
  if (options.law.empty())
    throw InputError("--output", options.output, "needs a LAW: name the law to draw");
  const Law law = named(options.law);
  write_picture(options.output, under_option("LAW", [&] { return law_figure(law); }), {});
}

int run_laws(const LawsArguments& options) {
  if (options.markdown)
    fmt::print("{}", laws_markdown());
  else if (!options.output.empty())
    draw(options);
  else if (options.json)
    print_json(options.law.empty() ? laws_json() : "[" + law_json(named(options.law)) + "]");
  else
    fmt::print("{}", options.law.empty() ? law_table() : law_text(named(options.law)));
  return fine;
}

}  // namespace

void add_laws(CommandLine& line) {
  const auto options = std::make_shared<LawsArguments>();
  const Verb verb = line.verb("laws", "List the motion laws of cams, or describe one",
                              "jounce laws modified_sine -o modified_sine.svg");
  const Option law =
      verb.option("LAW", options->law, "Name of a law, as in a spec").completed_by(law_names);
  const Option picture =
      verb.option("-o,--output", options->output, "Picture of the law to write, .svg or .png")
          .check(output_file({".svg", ".png"}));
  verb.flag("--markdown", options->markdown, "Print the whole guide (docs/laws.md)")
      .excludes({law, picture,
                 verb.flag("--json", options->json, "All results as JSON, numbers with all digits")
                     .excludes({picture})});
  verb.work([options] { return run_laws(*options); });
}

}  // namespace jounce::cli
