// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/convert.hpp"

#include <array>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/controllers/table_target.hpp"
#include "jounce/design/detail/count_sizes.hpp"

#include "cli/common/input.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/outputs.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output = "-";
  std::string axis, over;
  std::string to, rule;
  TargetTexts target;
  std::size_t intervals = 0;
  std::string every;
  std::string master_unit, position_unit;
  bool periodic = false, decimal_comma = false, allow_loss = false, json = false;
};

int run_convert(ConvertArguments options) {
  std::FILE* out = text_stream(options.json, {options.output});
  const TableForm form = table_form(options.to, options.output);
  if (options.to.empty())
    under_option("OUT", [&] { require_known_ending(options.output, options.input); });
  require_other_file(options.input, options.output, "OUT");
  Input read =
      only_one(over(options.over, load_axes(options.input, options.axis, options.decimal_comma)),
               options.input);
  const CountedInput given = with_option_names({"x_step", "p_step"}, [&] {
    return in_units_of_counts(std::move(read), options.target,
                              {options.master_unit, options.position_unit}, form.format);
  });
  const Input& input = given.input;
  Conversion wanted{.intervals = options.intervals,
                    .units = {options.master_unit, options.position_unit},
                    .periodic = options.periodic};
  const Converted made = with_option_names(
      {"tolerance", "velocity_tolerance", "most", "spacing", "x_step", "p_step", "v_step",
       "intervals", options.to.empty() ? "" : "format", "master_unit", "position_unit", "rule",
       "controller"},
      [&] {
        complete(wanted, form, interpolation_named(options.rule), options.target, given, option_of);
        return converted(input, wanted);
      });
  const bool writes = made.keeps() || options.allow_loss;
  const std::string text = with_option_names({"every", "master_unit", "position_unit"}, [&] {
    return form_text(form, made.file, options.every);
  });
  if (writes) write_file(options.output, text, input.files);
  const auto lost = all_losses(input, form, made.file.table, !options.every.empty());
  if (options.json)
    fmt::print(out, "{}\n", conversion_json(made, form, writes ? options.output : "", lost));
  else
    fmt::print(out, "{}{}", conversion_text(input, made, form, lost),
               writes ? "" : not_written_text(wanted, made));
  return writes ? fine : finding;
}

/// The options for a table of fewest knots: the keys of [table].
std::array<Option, 8> add_target_options(const Verb& verb, TargetTexts& texts) {
  return {
      verb.option("--controller", texts.controller,
                  "New knots: the best table that this controller can use")
          .check(one_of(controller_names())),
      verb.option(
          "--tolerance", texts.tolerance,
          "New knots: the fewest that keep the position within this tolerance; default: unchanged"),
      verb.option("--velocity-tolerance", texts.velocity_tolerance,
                  "The same for the velocity (of a cam: geo_velocity)"),
      verb.option("--most", texts.most,
                  "Maximum number of new knots; without a tolerance, the table with the smallest "
                  "error, or close to it")
          .check(whole(1, 10'000'000)),
      verb.option("--spacing", texts.spacing, "Least distance between new knots"),
      verb.option("--resolution", texts.x_step,
                  "New knots at multiples of this, such as 1ms; for IN in counts: the size of a "
                  "count of the first column, such as 0.01deg"),
      verb.option("--position-resolution", texts.p_step,
                  "Round the positions of the new knots to multiples of this, such as 1pulse; "
                  "for IN in counts: the size of a count, such as 1um"),
      verb.option("--velocity-resolution", texts.v_step,
                  "Round the velocities of the new knots to multiples of this")};
}

}  // namespace

void add_convert(CommandLine& line) {
  const auto options = std::make_shared<ConvertArguments>();
  const Verb verb = line.verb(
      "convert", "Convert between formats of tables and controllers, and report the error",
      "jounce convert cam.csv cam.st\njounce convert old.xyva cam.csv --master-unit deg "
      "--position-unit mm");
  verb.option("IN", options->input, "Table or spec, in any known format; - is standard input")
      .required();
  verb.option("OUT", options->output,
              "File to write: " + known_endings(true) + "; - is standard output")
      .check(output_file());
  verb.option("--to", options->to,
              "Format, if the extension of OUT does not determine it: " +
                  fmt::format("{}", fmt::join(form_names(), ", ")) +
                  "; points: CSV of segments with types, for the PT and follow modes of Googol")
      .check(one_of(form_names()));
  verb.axis(options->axis);
  verb.over(options->over);
  verb.option("--rule", options->rule,
              "For csv, json, lcm-log and mcap: linear, cubic_hermite, quintic_hermite; default: "
              "unchanged")
      .check(one_of({"linear", "cubic_hermite", "quintic_hermite"}));
  const auto [controller, tolerance, velocity_tolerance, most, spacing, x_step, p_step, v_step] =
      add_target_options(verb, options->target);
  verb.option("--intervals", options->intervals, "New knots at this number of equal intervals")
      .check(whole(1, 10'000'000))
      .excludes({controller, tolerance, velocity_tolerance, most, spacing});
  verb.option("--every", options->every,
              "Write samples (CSV) instead of a table: the position and its first two derivatives, "
              "at this interval of the first column, such as \"1 ms\"");
  verb.option("--master-unit", options->master_unit,
              "Unit of the first column. For a file without units: the unit that it is in; "
              "otherwise the unit to convert to");
  verb.option("--position-unit", options->position_unit, "The same for the position");
  verb.flag("--periodic", options->periodic,
            "For files that do not state it: the cam repeats. If the slave ends at another "
            "position, it advances in each period");
  verb.flag("--decimal-comma", options->decimal_comma,
            "Read numbers with a decimal comma: 0,5 is 0.5");
  verb.flag("--allow-loss", options->allow_loss,
            "Write the file although its error exceeds the tolerance, or the table a limit");
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_convert(*options); });
}

}  // namespace jounce::cli
