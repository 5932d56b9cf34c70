#include "jounce/io/spec.hpp"

#include <utility>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"
#include "jounce/io/file.hpp"
#include "jounce/io/units.hpp"

namespace jounce {
namespace {

using detail::TomlReader;

using detail::read_unit;

const std::vector<std::string> kinds{"cam", "move", "queue", "axes", "pvt", "axis"};

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

/// What belongs to the one axis of a spec.
void read_one_axis(TomlReader& top, Spec& spec, const std::string& kind) {
  const bool knots_are_the_table = kind == "pvt" && !top.has("then");
  spec.table = detail::read_table_options(top, spec.units, knots_are_the_table);
  if (kind == "pvt" && !spec.table.rule) spec.table.rule = Rule::cubic_hermite;
  spec.limits =
      detail::read_limits(top, spec.units, kind == "cam" ? &spec.slave : nullptr, spec.time_unit);
  spec.drive = detail::read_drive(top, spec.units);
}

void read_cam_parts(TomlReader& top, Spec& spec) {
  spec.subject = detail::read_cam(top, spec.units, spec);
  detail::read_optimize(top, spec.optimize);
  spec.master = read_master(top, spec);
  spec.disc = detail::read_disc(top, spec.units);
  spec.coupling = detail::read_coupling(top, spec.units, spec.time_unit);
  const auto& cam = std::get<CamSpec>(spec.subject);
  std::optional<double> period;
  if (cam.periodic && !cam.segments.empty() &&
      cam.segments.back().end.master > cam.start.master)  // otherwise design() says what is wrong
    period = cam.segments.back().end.master - cam.start.master;
  spec.switches = detail::read_switches(top, spec, SwitchesOf::master, period);
}

void read_axis_parts(TomlReader& top, Spec& spec) {
  spec.subject = detail::read_axis(top.table("axis"), spec.units);
  spec.switches = detail::read_switches(top, spec, SwitchesOf::position);
}

void read_body(TomlReader& top, Spec& spec) {
  require_version(top);
  const std::string& kind = kinds[top.choice("kind", kinds)];
  spec.name = top.optional_text("name").value_or("");
  read_units(top, spec, kind);
  if (kind != "axes") read_one_axis(top, spec, kind);
  if (kind == "cam")
    read_cam_parts(top, spec);
  else if (kind == "move")
    spec.subject = detail::read_move(top.table("move"), spec.units);
  else if (kind == "queue")
    spec.subject = detail::read_queue(top, spec.units);
  else if (kind == "axes")
    spec.subject = detail::read_axes(top, spec);
  else if (kind == "pvt")
    spec.subject = detail::read_knots(top, spec.units, *spec.table.rule);
  else
    read_axis_parts(top, spec);
  if (kind != "cam" && kind != "axis") spec.then = detail::read_then(top, spec.units);
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

std::vector<AxisPart> Spec::parts() const {
  if (!axes.empty()) return axes;
  return {{"", units, table, limits, drive}};
}

Spec read_spec(const std::string& path) {
  return parse_spec(read_file(path), path);
}

}  // namespace jounce
