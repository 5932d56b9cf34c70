// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/inverse.hpp"

#include <memory>

#include <fmt/format.h>

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct InverseArguments {
  std::string file, axis, slave, output;
  InverseTexts texts;
  bool json = false;
};

int run_inverse(const InverseArguments& options) {
  std::FILE* out = text_stream(options.json, {options.output});
  const Input cam = load(options.file, options.axis);
  const InverseAnswer answer = with_option_names({"slave", "at", "from", "to", "tolerance"}, [&] {
    return inverse_answer(cam, options.slave, options.output, options.texts);
  });
  require_other_file(options.file, options.output);
  if (answer.table)
    write_file(options.output, table_text(options.output, *answer.table), cam.files);
  fmt::print(out, "{}", options.json ? answer.json + "\n" : answer.text);
  return answer.found ? fine : finding;
}

}  // namespace

void add_inverse(CommandLine& line) {
  const auto options = std::make_shared<InverseArguments>();
  const Verb verb =
      line.verb("inverse", "Find the master positions that belong to a position of the slave",
                "jounce inverse cam.toml --slave 25mm\n"
                "jounce inverse cam.toml --at 30deg --from 1mm --to 39mm -o inverse.csv");
  verb.option("FILE", options->file, "Spec or table of a cam; - is standard input").required();
  verb.axis(options->axis);
  const Option slave = verb.option("--slave", options->slave,
                                   "List all master positions at which the slave is here");
  const Option output =
      verb.option("-o,--output", options->output,
                  "Table of the inverse to write, CSV or .json: the master over the slave")
          .check(output_file({".csv", ".json"}))
          .excludes({slave});
  const auto text = [&](const char* name, std::string& target, const char* help) {
    verb.option(name, target, help).needs(output);
  };
  text("--at", options->texts.at,
       "Master position inside the rise or fall to invert, if there are several");
  text("--from", options->texts.from,
       "First slave position of the table; default: where it begins");
  text("--to", options->texts.to, "Last slave position of the table; default: where it ends");
  text("--tolerance", options->texts.tolerance,
       "Greatest error of the master position; default: 1e-9 of the length of the cam");
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_inverse(*options); });
}

}  // namespace jounce::cli
