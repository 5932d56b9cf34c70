// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/io/points_text.hpp"
#include "jounce/io/samples_csv.hpp"
#include "jounce/pvt/fill.hpp"

#include "cli/common/input.hpp"
#include "cli/common/target_options.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output = "-";
  std::string axis;
  std::string to;
  std::string rule;
  TargetOptions target;
  std::size_t intervals = 0;
  std::string every;
  std::string master_unit;
  std::string position_unit;
  bool periodic = false;
  bool decimal_comma = false;
  bool json = false;
};

/// The table as it will be written, and how far it is from what was given.
struct Converted {
  TableFile file;
  std::optional<SampleError> error;  ///< none: bit for bit the table that was given
};

std::optional<Format> format_of(const ConvertArguments& options) {
  if (!options.to.empty()) return format_named(options.to);
  return format_of_path(options.output);
}

Interpolation rule_for(const ConvertArguments& options, const Table& table) {
  if (const auto format = format_of(options)) return rule_of(*format);
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite})
    if (options.rule == name(rule)) return rule;
  return rule_of(options.target).value_or(table.rule());
}

/// What the file does not say, or what is wanted instead of what it says.
TableFile in_units(TableFile file, const ConvertArguments& options) {
  const auto change = [](const char* option, std::string& unit, const std::string& wanted) {
    if (!wanted.empty() && !is_unit(wanted))
      throw InputError(option, wanted, "is not a known unit");
    double factor = 1;
    try {
      if (!unit.empty() && !wanted.empty()) factor = conversion(unit, wanted);
    } catch (const InputError&) {
      throw InputError(option, wanted, "does not measure what the table's unit does, " + unit);
    }
    if (!wanted.empty()) unit = wanted;
    return factor;
  };
  if (const double factor = change("--master-unit", file.units.x, options.master_unit); factor != 1)
    file.table = stretched(file.table, factor);
  const double factor = change("--position-unit", file.units.position, options.position_unit);
  Columns columns = file.table.columns();
  if (factor != 1)
    for (auto* column : {&columns.p, &columns.v, &columns.a})
      for (double& value : *column) value *= factor;
  const auto [least, most] = std::minmax_element(columns.p.begin(), columns.p.end());
  const bool closes = std::abs(columns.p.back() - columns.p.front()) <= 1e-9 * (*most - *least);
  const Extrapolation repeated = closes ? Extrapolation::wrap : Extrapolation::advance;
  file.table = Table(file.table.axis(), file.table.rule(),
                     options.periodic ? repeated : file.table.outside(), std::move(columns));
  return file;
}

Sampled sampled(const Input& input, Interpolation rule, const ConvertArguments& options) {
  return std::visit(
      [&](const auto& curve) {
        if (options.target.any())
          return cli::reduced(
              curve, target_of(options.target, input.table.table.axis(), rule, input.labels.units));
        return options.intervals > 0 ? sample(curve, rule, options.intervals)
                                     : sample(curve, rule, input.table.table.columns().x);
      },
      *input.curve);
}

/// Through the knots a cubic spline, periodic where the cam repeats, otherwise with natural ends: KAS
/// joins points of the type SPLINE by curves, and does not document their ends.
SampleError spline_error(const Input& input, const Table& made) {
  Columns columns{made.columns().x, made.columns().p, std::vector<double>(made.size()), {}};
  spline_velocities(columns.x, columns.p,
                    repeats(made.outside()) ? Filling::periodic : Filling::natural, columns.v);
  return std::visit(
      [&](const auto& curve) {
        return certified(curve, Interpolation::cubic_hermite, std::move(columns)).error;
      },
      *input.curve);
}

Converted convert(const Input& input, const ConvertArguments& options) {
  const Interpolation rule = rule_for(options, input.table.table);
  Converted result{input.table, input.error};
  if (rule != input.table.table.rule() || options.target.any() || options.intervals > 0) {
    Sampled made = sampled(input, rule, options);
    result = {{std::move(made.table), input.table.units, input.table.provenance}, made.error};
  }
  if (format_of(options) == Format::kollmorgen)
    result.error = spline_error(input, result.file.table);
  result.file = in_units(std::move(result.file), options);
  return result;
}

/// The values at every step of a controller's cycle, for other programs to read.
std::string samples_of(const TableFile& file, const ConvertArguments& options) {
  if (format_of(options) || options.to == "json" || options.to == "points" ||
      options.output.ends_with(".json"))
    throw InputError("--every", options.every, "writes samples, as CSV only");
  try {
    return samples_csv(file, quantity(options.every, file.units.x));
  } catch (const InputError& error) {
    throw InputError("--every", options.every, error.rule());
  }
}

std::string text_of(const TableFile& file, const ConvertArguments& options) {
  const auto format = format_of(options);
  if (format && options.every.empty()) return exchange_text(*format, file);
  for (const auto& [unit, option] :
       {std::pair{&file.units.x, "--master-unit"}, {&file.units.position, "--position-unit"}})
    if (unit->empty()) throw InputError(option, "", "is missing: the file does not name this unit");
  if (!options.every.empty()) return samples_of(file, options);
  return options.to == "json"     ? to_json(file)
         : options.to == "csv"    ? to_csv(file)
         : options.to == "points" ? points_text(file)
                                  : table_text(options.output, file);
}

/// "laws, limits, coupling and 2 cam switches stay in the spec"
std::string left_in(const Spec& spec) {
  std::vector<std::string> parts{"laws", "limits"};
  if (spec.coupling) parts.emplace_back("the coupling");
  if (const std::size_t n = spec.switches.table.switches.size(); n > 0)
    parts.push_back(fmt::format("{} cam switch{}", n, n == 1 ? "" : "es"));
  const std::string last = parts.back();
  parts.pop_back();
  return fmt::format("{} and {} stay in the spec", fmt::join(parts, ", "), last);
}

/// What a table of straight lines or splines loses of what Jounce's own tables say.
void add_losses(std::vector<std::string>& all, Format format, const Table& table) {
  if (format == Format::xyva || format == Format::codesys) return;
  all.emplace_back(format == Format::kollmorgen
                       ? "positions only: the error is that of a cubic spline through them; "
                         "Kollmorgen does not document how KAS ends its splines"
                       : "positions only: the error is that of straight lines between them");
  all.emplace_back("units and hash are not in the file");
  if (repeats(table.outside()) && format != Format::kollmorgen)
    all.emplace_back("the file does not state that the cam repeats: read it with --periodic");
}

/// Reports the parts of the input that the output does not contain.
std::vector<std::string> losses(const ConvertArguments& options, const Input& input,
                                const Table& made) {
  std::vector<std::string> all = input.unread;
  if (!options.every.empty()) all.emplace_back("samples: the file contains no values between them");
  if (options.to == "points")
    all.emplace_back("points count from the first knot; their types define the rates");
  if (input.spec) all.push_back(left_in(*input.spec));
  if (const auto format = format_of(options)) add_losses(all, *format, made);
  return all;
}

std::string word_for(const ConvertArguments& options) {
  if (const auto format = format_of(options)) return name(*format);
  if (options.to == "points") return options.to;
  return options.to == "json" || (options.to.empty() && options.output.ends_with(".json")) ? "json"
                                                                                           : "csv";
}

nlohmann::ordered_json json_of(const Converted& made, const ConvertArguments& options,
                               const Input& input) {
  nlohmann::ordered_json document{{"table", options.output},
                                  {"format", word_for(options)},
                                  {"knots", made.file.table.size()},
                                  {"rule", name(made.file.table.rule())},
                                  {"lossless", !made.error.has_value()}};
  if (made.error) {
    document["error"] = made.error->position;
    document["error_where"] = made.error->where;
    document["error_velocity"] = made.error->velocity;
  }
  document["losses"] = losses(options, input, made.file.table);
  return document;
}

void print_text(std::FILE* out, const Converted& made, const ConvertArguments& options,
                const Input& input) {
  fmt::print(out, "{} -> {}: {} knots, {}\n", input.name, word_for(options), made.file.table.size(),
             name(made.file.table.rule()));
  const Labels& labels = input.labels;
  if (!made.error)
    fmt::print(out, "the numbers are unchanged\n");
  else
    fmt::print(
        out, "error: at most {} {} (certified), at {} {}; {} {} in the {}\n",
        rounded(made.error->position), labels.units.position, rounded(made.error->where),
        labels.units.x, rounded(made.error->velocity),
        labels.unit_of(std::string(labels.over_master ? OverMaster::names[1] : OverTime::names[1])),
        labels.over_master ? OverMaster::names[1] : OverTime::names[1]);
  for (const auto& loss : losses(options, input, made.file.table)) fmt::print(out, "{}\n", loss);
}

/// What the file is to be must be said: by its ending, or by --to.
void require_known_ending(const ConvertArguments& options) {
  const std::string& path = options.output;
  if (format_of(options) || !options.to.empty() || path == "-" || path.ends_with(".csv") ||
      path.ends_with(".json"))
    return;
  throw InputError("OUT", path, "has no extension of a known format: name the format with --to");
}

int run_convert(const ConvertArguments& options) {
  require_known_ending(options);
  require_other_file(options.input, options.output, "OUT");
  const Input input = load(options.input, options.axis, options.decimal_comma);
  const Converted made = convert(input, options);
  write_file(options.output, text_of(made.file, options));
  std::FILE* out = options.output == "-" ? stderr : stdout;  // the table itself has standard output
  if (options.json)
    fmt::print(out, "{}\n", json_of(made, options, input).dump());
  else
    print_text(out, made, options, input);
  return fine;
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
              "File to write: .csv, .json, .xyva, .st (CODESYS declaration), .txt (pairs); - "
              "is standard output");
  std::vector<std::string> formats = format_names();
  formats.insert(formats.begin(), {"csv", "json", "points"});
  verb.option("--to", options->to,
              "Format, if the extension of OUT does not determine it: csv, json, xyva, codesys, "
              "pairs, sew, kollmorgen; points: CSV of segments with types, for the PT and follow "
              "modes of Googol")
      .check(one_of(formats));
  verb.axis(options->axis);
  verb.option("--rule", options->rule,
              "For csv and json: linear, cubic_hermite, quintic_hermite; default: unchanged")
      .check(one_of({"linear", "cubic_hermite", "quintic_hermite"}));
  const auto target = add_target_options(verb, options->target);
  verb.option("--intervals", options->intervals,
              "New knots at equal intervals, this number of them")
      .check(whole(1, 10'000'000))
      .excludes(target);
  verb.option("--every", options->every,
              "Write samples instead of a table: position and two derivatives at every step of the "
              "first column, such as \"1 ms\", as CSV");
  verb.option("--master-unit", options->master_unit,
              "Unit of the first column: that of a file without units, or the unit to convert to");
  verb.option("--position-unit", options->position_unit, "The same for the position");
  verb.flag("--periodic", options->periodic,
            "The cam repeats, and the slave advances if it ends at another position; for files "
            "without this information");
  verb.flag("--decimal-comma", options->decimal_comma, "Read 0,5 as 0.5");
  verb.flag("--json", options->json, "Summary as JSON");
  verb.work([options] { return run_convert(*options); });
}

}  // namespace jounce::cli
