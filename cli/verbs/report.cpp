// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/proof/report_page.hpp"

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ReportArguments {
  std::string file, axis, machine, before;
  ReportOptions page;
  std::string output = "-";
};

int run_report(const ReportArguments& options) {
  const std::string& out = options.output;
  require_other_file(options.file, out);
  const std::vector<Input> axes = load_program(options.file, options.machine, options.axis);
  std::vector<std::string> read = files_of(axes);
  read.insert(read.end(), {options.page.proof.log, options.page.optimum});
  if (axes.size() > 1) {
    for (const auto& [option, value] : {std::pair{"--before", &options.before},
                                        {"--log", &options.page.proof.log},
                                        {"--optimum", &options.page.optimum}})
      if (!value->empty()) throw InputError(option, *value, "is for one axis: name it with --axis");
    const auto [page, all] = report_page(axes, options.page);
    write_file(out, html(page), read);
    if (out != "-") fmt::print("{}: {}\nwrote {}\n", page.title, page.verdict->text, out);
    return all.ok() ? fine : finding;
  }
  const Input& input = axes.front();
  std::optional<Input> before;
  if (!options.before.empty()) before = load_beside(options.before, input, options.machine);
  if (before) read.insert(read.end(), before->files.begin(), before->files.end());
  const auto [page, all] =
      with_option_names({"before"}, [&] { return report_page(input, before, options.page); });
  write_file(out, html(page), read);
  if (out != "-") fmt::print("{}: {}\nwrote {}\n", input.name, one_line(all, input.labels), out);
  return all.ok() ? fine : finding;
}

}  // namespace

void add_report(CommandLine& line) {
  const auto options = std::make_shared<ReportArguments>();
  const Verb verb =
      line.verb("report", "Write one self-contained HTML page with curve, limits and proof",
                "jounce report better.toml --before cam.toml --log run.csv -o cam.html");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--before", options->before, "Spec or table to draw paler underneath");
  verb.option("--log", options->page.proof.log,
              "Tick log of an executor to compare with the exact curve");
  verb.option("--optimum", options->page.optimum,
              "Output of `jounce optimize --json` to show: gain, bound and active limits");
  verb.option("-o,--output", options->output, "Page to write; - is standard output")
      .check(output_file({".html", ".htm"}));
  verb.work([options] { return run_report(*options); });
}

}  // namespace jounce::cli
