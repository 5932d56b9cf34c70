#include "jounce/io/spec.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/io/detail/toml_reader.hpp"
#include "jounce/io/file.hpp"
#include "jounce/io/units.hpp"

namespace jounce {
namespace {

using detail::TomlReader;

const std::vector<std::string> kinds{"cam", "move", "pvt", "axis"};
const std::vector<std::string> rules{"linear", "cubic_hermite", "quintic_hermite"};

std::string read_unit(TomlReader& reader, const char* key, const char* fallback) {
  const auto unit =
      fallback == nullptr ? reader.text(key) : reader.optional_text(key).value_or(fallback);
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

std::optional<Bound> read_bound(TomlReader& free, const char* key, const std::string& unit) {
  const auto pair = free.optional_pair(key, unit);
  if (!pair) return std::nullopt;
  return Bound{pair->first, pair->second};
}

void read_free(TomlReader& owner, std::size_t knot, const Units& units, OptimizeSpec& optimize) {
  auto free = owner.optional_table("free");
  if (!free) return;
  FreeKnot f;
  f.knot = knot;
  f.master = read_bound(*free, "master", units.x);
  f.slave = read_bound(*free, "slave", units.position);
  f.geo_velocity = read_bound(*free, "geo_velocity", rate_unit(units.position, units.x, 1));
  f.geo_acceleration = read_bound(*free, "geo_acceleration", rate_unit(units.position, units.x, 2));
  free->finish();
  optimize.free.push_back(f);
}

CamKnot read_knot(TomlReader& knot, const Units& units) {
  CamKnot k;
  k.master = knot.number("master", units.x);
  k.slave = knot.number("slave", units.position);
  k.geo_velocity = knot.optional_number("geo_velocity", rate_unit(units.position, units.x, 1));
  k.geo_acceleration =
      knot.optional_number("geo_acceleration", rate_unit(units.position, units.x, 2));
  return k;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const Law law : all_laws()) names.emplace_back(name(law));
  return names;
}

CamSpec read_cam(TomlReader& top, const Units& units, OptimizeSpec& optimize) {
  CamSpec cam;
  cam.periodic = top.optional_flag("periodic").value_or(false);
  TomlReader start = top.table("start");
  cam.start = read_knot(start, units);
  read_free(start, 0, units, optimize);
  start.finish();
  for (TomlReader& segment : top.tables("segment")) {
    CamSegment s;
    s.name = segment.optional_text("name").value_or("");
    s.law = all_laws()[segment.choice("law", law_names())];
    TomlReader end = segment.table("end");
    s.end = read_knot(end, units);
    end.finish();
    cam.segments.push_back(std::move(s));
    read_free(segment, cam.segments.size(), units, optimize);
    segment.finish();
  }
  return cam;
}

void read_optimize(TomlReader& top, OptimizeSpec& optimize) {
  auto table = top.optional_table("optimize");
  if (!table) return;
  std::vector<Objective> minimize;
  for (const auto& text : table->texts("minimize")) {
    const auto objective = objective_named(text);
    if (!objective)
      table->fail(
          "minimize", '"' + text + '"',
          "must be among \"peak geo_acceleration\", \"peak geo_jerk\", \"rms geo_acceleration\"");
    minimize.push_back(*objective);
  }
  if (!minimize.empty()) optimize.minimize = std::move(minimize);
  optimize.seed = table->optional_count("seed");
  optimize.starts = table->optional_count("starts");
  optimize.tolerance = table->optional_number("tolerance", "1");
  table->finish();
}

/// Jerk, or what controllers ask for instead: the time in which the acceleration builds up, so that
/// jerk = acceleration / smoothing in each half (Googol smoothTime, HMPL SetSmoothTime).
void read_jerk(TomlReader& move, SCurveSpec& s, const std::string& jerk_unit,
               const std::string& time_unit) {
  const auto jerk = move.optional_number("jerk", jerk_unit);
  const auto smoothing = move.optional_number("smoothing", time_unit);
  const auto deceleration_jerk = move.optional_number("deceleration_jerk", jerk_unit);
  if (jerk.has_value() == smoothing.has_value())
    move.fail(
        "jerk", "",
        "an s_curve needs either jerk or smoothing (the time in which the acceleration builds up)");
  if (smoothing) {
    if (!(*smoothing > 0)) move.fail("smoothing", number(*smoothing), "must be greater than 0");
    if (deceleration_jerk)
      move.fail("deceleration_jerk", number(*deceleration_jerk),
                "goes with jerk, not with smoothing");
    s.jerk = s.acceleration / *smoothing;
    s.deceleration_jerk = (s.deceleration == 0 ? s.acceleration : s.deceleration) / *smoothing;
  } else {
    s.jerk = *jerk;
    s.deceleration_jerk = deceleration_jerk.value_or(0);
  }
}

MoveSpec read_move(TomlReader move, const Units& units) {
  const std::vector<std::string> profiles{"trapezoid", "s_curve"};
  const bool is_s_curve = move.choice("profile", profiles) == 1;
  const auto rate = [&](int order) { return rate_unit(units.position, units.x, order); };
  TrapezoidSpec t;
  t.from = move.optional_number("from", units.position).value_or(0);
  t.to = move.number("to", units.position);
  t.velocity = move.number("velocity", rate(1));
  t.acceleration = move.number("acceleration", rate(2));
  t.deceleration = move.optional_number("deceleration", rate(2)).value_or(0);
  SCurveSpec s{t.from, t.to, t.velocity, t.acceleration, t.deceleration, 0, 0};
  if (is_s_curve) read_jerk(move, s, rate(3), units.x);
  move.finish();
  if (is_s_curve) return s;
  return t;
}

AxisSpec read_axis(TomlReader axis, const Units& units) {
  AxisSpec spec;
  spec.cycle = axis.optional_number("cycle", "s").value_or(spec.cycle);
  if (!(spec.cycle > 0)) axis.fail("cycle", number(spec.cycle), "must be greater than 0");
  spec.position = axis.optional_number("position", units.position).value_or(0);
  axis.finish();
  return spec;
}

Table read_knots(TomlReader& top, const Units& units, Rule rule) {
  Columns columns;
  for (TomlReader& knot : top.tables("knot")) {
    columns.x.push_back(knot.number("time", units.x));
    columns.p.push_back(knot.number("position", units.position));
    if (rule != Rule::linear)
      columns.v.push_back(knot.number("velocity", rate_unit(units.position, units.x, 1)));
    if (rule == Rule::quintic_hermite)
      columns.a.push_back(knot.number("acceleration", rate_unit(units.position, units.x, 2)));
    knot.finish();
  }
  return Table(Axis::time, rule, Outside::hold, std::move(columns));
}

TableOptions read_table_options(TomlReader& top, const Units& units) {
  TableOptions options;
  auto table = top.optional_table("table");
  if (!table) return options;
  if (table->has("rule")) options.rule = static_cast<Rule>(table->choice("rule", rules));
  options.tolerance = table->optional_number("tolerance", units.position);
  options.intervals = table->optional_count("intervals");
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

void read_drive_numbers(TomlReader& table, Drive& drive, const Units& units) {
  const std::string damping = "N m s/rad";
  const auto read = [&](const char* key, const std::string& unit, double& value) {
    value = table.optional_number(key, unit).value_or(value);
  };
  read("motor_inertia", "kg m^2", drive.motor_inertia);
  read("load_inertia", "kg m^2", drive.load_inertia);
  read("shaft_stiffness", "N m/rad", drive.shaft_stiffness);
  read("shaft_damping", damping, drive.shaft_damping);
  read("motor_friction", damping, drive.motor_friction);
  read("load_friction", damping, drive.load_friction);
  read("position_gain", "1/s", drive.position_gain);
  read("velocity_gain", damping, drive.velocity_gain);
  read("integral_time", "s", drive.integral_time);
  read("velocity_feed_forward", "1", drive.velocity_feed_forward);
  read("torque_feed_forward", "1", drive.torque_feed_forward);
  read("torque_limit", "N m", drive.torque_limit);
  drive.position_per_rev = table.number("position_per_rev", units.position + "/rev");
}

std::optional<DriveSpec> read_drive(TomlReader& top, const Units& units) {
  auto table = top.optional_table("drive");
  if (!table) return std::nullopt;
  DriveSpec spec;
  const std::vector<std::string> models{"servo_400w"};
  if (table->has("model") && table->choice("model", models) == 0) spec.drive = servo_400w();
  read_drive_numbers(*table, spec.drive, units);
  spec.settle = table->optional_number("settle", "s").value_or(spec.settle);
  if (auto limits = table->optional_table("limits")) {
    spec.limits.torque = limits->optional_number("torque", "N m");
    spec.limits.rms_torque = limits->optional_number("rms_torque", "N m");
    spec.limits.following_error = limits->optional_number("following_error", units.position);
    spec.limits.residual = limits->optional_number("residual", units.position);
    limits->finish();
  }
  table->finish();
  try {
    require_valid(spec.drive);
  } catch (const InputError& error) {  // the model names its own fields
    throw InputError("drive." + error.key(), error.value(), error.rule());
  }
  return spec;
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
  const std::string kind = kinds[top.choice("kind", kinds)];
  spec.name = top.optional_text("name").value_or("");
  read_units(top, spec, kind);
  spec.table = read_table_options(top, spec.units);
  spec.limits = read_limits(top, spec.units, kind == "cam");
  spec.drive = read_drive(top, spec.units);
  if (kind == "cam") {
    spec.subject = read_cam(top, spec.units, spec.optimize);
    read_optimize(top, spec.optimize);
    spec.master = read_master(top, spec);
  } else if (kind == "move") {
    spec.subject = read_move(top.table("move"), spec.units);
  } else if (kind == "pvt") {
    spec.subject = read_knots(top, spec.units, spec.table.rule);
  } else {
    spec.subject = read_axis(top.table("axis"), spec.units);
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
