#include "jounce/io/spec.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"
#include "jounce/io/file.hpp"
#include "jounce/io/units.hpp"

namespace jounce {
namespace {

using detail::TomlReader;

const std::vector<std::string> kinds{"cam", "move", "pvt", "axis"};
const std::vector<std::string> rules{"linear", "cubic_hermite", "quintic_hermite"};

std::string read_unit(TomlReader& reader, const char* key, const char* fallback) {
  auto unit = fallback == nullptr ? reader.text(key) : reader.optional_text(key).value_or(fallback);
  if (!is_unit(unit))
    reader.fail(key, '"' + unit + '"',
                "is not a unit that Jounce knows, such as mm, deg, rev, pulse, s, ms");
  return unit;
}

void read_units(TomlReader& top, Spec& spec, const std::string& kind) {
  TomlReader units = top.table("units");
  spec.units.position = read_unit(units, "position", nullptr);
  spec.time_unit = read_unit(units, "time", "s");
  try {
    (void)conversion(spec.time_unit, "s");
  } catch (const InputError&) {
    units.fail("time", '"' + spec.time_unit + '"', "must be a unit of time: s, ms, us, min or h");
  }
  spec.units.x = kind == "cam" ? read_unit(units, "master", nullptr) : spec.time_unit;
  if (kind == "axis" && units.has("master")) spec.master_unit = read_unit(units, "master", nullptr);
  units.finish();
}

TableOptions read_table_options(TomlReader& top, const Units& units, const std::string& kind) {
  TableOptions options;
  if (kind == "pvt") options.rule = Rule::cubic_hermite;
  auto table = top.optional_table("table");
  if (!table) return options;
  if (table->has("rule")) options.rule = static_cast<Rule>(table->choice("rule", rules));
  if (kind == "pvt") {  // the knots are the table
    table->finish();
    return options;
  }
  options.tolerance = table->optional_number("tolerance", units.position);
  options.intervals = table->optional_count("intervals");
  if (options.intervals.value_or(1) > 10'000'000)
    table->fail("intervals", std::to_string(*options.intervals), "must be at most 10000000");
  if (options.tolerance && !(*options.tolerance > 0))
    table->fail("tolerance", number(*options.tolerance), "must be greater than 0");
  if (options.tolerance && options.intervals)
    table->fail("intervals", "", "either a tolerance or a number of intervals, not both");
  table->finish();
  return options;
}

Limits read_limits(TomlReader& top, const Units& units, bool over_master) {
  Limits limits;
  auto table = top.optional_table("limits");
  if (!table) return limits;
  const auto& names = over_master ? OverMaster::names : OverTime::names;
  limits.position_min = table->optional_number("position_min", units.position);
  limits.position_max = table->optional_number("position_max", units.position);
  const std::array rates{&limits.velocity, &limits.acceleration, &limits.jerk};
  for (std::size_t k = 0; k < rates.size(); ++k) {
    *rates[k] = table->optional_number(names[k + 1],
                                       rate_unit(units.position, units.x, static_cast<int>(k) + 1));
    if (*rates[k] && !(**rates[k] > 0))
      table->fail(names[k + 1], number(**rates[k]), "a limit must be greater than 0");
  }
  if (limits.position_min && limits.position_max && *limits.position_min > *limits.position_max)
    table->fail("position_min", number(*limits.position_min), "must not be above position_max");
  table->finish();
  return limits;
}

std::optional<MasterSpec> read_master(TomlReader& top, const Spec& spec) {
  auto table = top.optional_table("master");
  if (!table) return std::nullopt;
  MasterSpec master;
  master.velocity = table->number("velocity", rate_unit(spec.units.x, spec.time_unit, 1));
  master.distance = table->number("distance", spec.units.x);
  master.acceleration =
      table->optional_number("acceleration", rate_unit(spec.units.x, spec.time_unit, 2));
  for (const auto& [key, value] : {std::pair{"velocity", master.velocity},
                                   {"distance", master.distance},
                                   {"acceleration", master.acceleration.value_or(1)}})
    if (!(value > 0)) table->fail(key, number(value), "must be greater than 0");
  table->finish();
  return master;
}

void require_version(TomlReader& top) {
  if (!top.has("jounce"))
    top.fail("jounce", "",
             "is missing: a spec begins with `jounce = 1`, the version of its format");
  const auto version = top.optional_count("jounce");
  if (*version != Spec::version)
    top.fail("jounce", std::to_string(*version),
             "this program reads format version " + std::to_string(Spec::version));
}

void read_body(TomlReader& top, Spec& spec) {
  require_version(top);
  const std::string& kind = kinds[top.choice("kind", kinds)];
  spec.name = top.optional_text("name").value_or("");
  read_units(top, spec, kind);
  spec.table = read_table_options(top, spec.units, kind);
  spec.limits = read_limits(top, spec.units, kind == "cam");
  spec.drive = detail::read_drive(top, spec.units);
  if (kind == "cam") {
    spec.subject = detail::read_cam(top, spec.units, spec.optimize);
    detail::read_optimize(top, spec.optimize);
    spec.master = read_master(top, spec);
  } else if (kind == "move") {
    spec.subject = detail::read_move(top.table("move"), spec.units);
  } else if (kind == "pvt") {
    spec.subject = detail::read_knots(top, spec.units, spec.table.rule);
  } else {
    spec.subject = detail::read_axis(top.table("axis"), spec.units);
  }
  top.finish();
}

toml::table parse_toml(const Document& document) {
  if (document.text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("", "", "the file is empty").at(document.name, 1);
  try {
    return toml::parse(std::string_view(document.text), std::string_view(document.name));
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    throw InputError("", "", "is not TOML: " + std::string(error.description()))
        .at(document.name, static_cast<int>(at.line), static_cast<int>(at.column));
  }
}

}  // namespace

Spec parse_spec(std::string text, std::string name) {
  Document document{std::move(name), std::move(text), {}, {}};
  document.hash = sha256(document.text);
  const toml::table root = parse_toml(document);
  Spec spec;
  spec.document = std::move(document);
  TomlReader top(root, "", spec.document);
  try {
    read_body(top, spec);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
  return spec;
}

Spec read_spec(const std::string& path) {
  return parse_spec(read_file(path), path);
}

}  // namespace jounce
