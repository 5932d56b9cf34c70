// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/spec.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/base/units.hpp"
#include "jounce/controllers/exchange/exchange_format.hpp"
#include "jounce/io/points.hpp"
#include "jounce/io/table_file.hpp"

#include "spec/src/axis_drive.hpp"
#include "spec/src/cams/cam_source.hpp"
#include "spec/src/toml/parts.hpp"
#include "spec/src/toml/toml_syntax.hpp"

namespace jounce {
namespace {

using spec_detail::TomlReader;

using spec_detail::read_unit;

/// A kind of spec: its independent axis, and the function that reads its own part after units,
/// table and limits.
struct Kind {
  const char* name;
  enum { over_time, over_master, no_curve } runs;
  void (*read)(TomlReader& top, Spec& spec);
};

/// Reads the cam of `from`, which gives the default of [units].
std::optional<spec_detail::CamSource> read_source(TomlReader& top, const Kind& kind) {
  if (kind.name != std::string_view("cam") || !top.has("from")) return std::nullopt;
  try {
    return spec_detail::read_cam_source(top, "from");
  } catch (const InputError& error) {
    top.end_all(error);  // the units and the motion are those of the other file
  }
}

void read_own_units(TomlReader& top, Spec& spec, const Kind& kind) {
  const bool over_master = kind.runs == Kind::over_master;
  TomlReader units =
      top.table("units", over_master ? "units = { position = \"mm\", master = \"deg\" }"
                                     : "units = { position = \"mm\" }");
  spec.units.position = spec_detail::read_position_unit(units, "position", nullptr);
  spec.time_unit = spec_detail::read_time_unit(units, "time");
  spec.units.x = over_master ? spec_detail::read_master_unit(units, "master") : spec.time_unit;
  if (kind.runs == Kind::no_curve && units.has("master"))
    spec.master_unit = spec_detail::read_master_unit(units, "master");
  units.finish();
}

void read_units(TomlReader& top, Spec& spec, const Kind& kind) {
  const auto source = read_source(top, kind);
  if (source && !top.has("units")) {
    spec.units = spec_detail::units_before_then(top, source->units);
    spec.time_unit = source->time_unit;
  } else {
    read_own_units(top, spec, kind);
  }
  if (source)
    spec.subject = spec_detail::in_units(*source, spec_detail::units_before_then(top, spec.units),
                                         top, "from");
}

/// Gives the quantities that rules name by a word their units.
void name_quantities(TomlReader& top, const Spec& spec, const Kind& kind) {
  const Units& units = spec.units;
  top.name_quantity("of the length", kind.runs == Kind::over_master ? units.x : spec.time_unit);
  top.name_quantity("the time", spec.time_unit);
  if (kind.name == std::string_view("axes")) return;  // each axis has units of its own
  if (kind.runs == Kind::over_master) {
    for (const char* noun : {"master", "length from", "the master travels"})
      top.name_quantity(noun, units.x);
    for (const char* noun : {"slave", "the slave travels", "travel at least", "stroke from"})
      top.name_quantity(noun, units.position);
    for (const char* noun : {"slope", "ratio", "ratio steps from"})
      top.name_quantity(noun, rate_unit(units.position, units.x, 1));
    return;
  }
  top.name_quantity("position", units.position);
  int order = 1;
  for (const char* noun : {"velocity", "acceleration", "jerk"})
    top.name_quantity(noun, rate_unit(units.position, spec.time_unit, order++));
}

/// The travel of the master through the motion of the slave once.
struct MasterRun {
  std::optional<double> length;
  bool repeats = false;
};

/// True for a motion that begins with the travel of its master, and not at a position of the master.
bool is_passed_once(const SyncSpec& sync) {
  const auto* const follow = std::get_if<FollowPart>(&sync);
  return follow == nullptr || follow->start.event != FollowEvent::pass;
}

/// A cam is read after its master: its knots may have rates over time.
MasterRun master_run(TomlReader& top, const Spec& spec) {
  if (std::holds_alternative<CamSpec>(spec.subject))
    return {spec_detail::cam_length(top, spec.units),
            top.optional_flag("periodic").value_or(false)};
  if (const auto* made = std::get_if<NamedCam>(&spec.subject))
    return {made->cam.length(), repeats(made->cam.outside())};
  const auto period = spec.master_period();
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  if (!period && sync != nullptr && is_passed_once(*sync))
    return {sync_cam_of(*sync).cam.length(), false};
  return {period, period.has_value()};
}

/// The speed of the master, in its unit or in cycles per time.
double read_master_velocity(TomlReader& table, const Spec& spec, const MasterRun& run) {
  const std::string unit = rate_unit(spec.units.x, spec.time_unit, 1);
  const std::string cycles = rate_unit("", spec.time_unit, 1);
  const auto text = table.is_text("velocity") ? table.optional_text("velocity") : std::nullopt;
  const auto positive = [&](double value) {
    if (!(value > 0))
      table.fail("velocity", text ? '"' + *text + '"' : number(value), "must be greater than 0");
    return value;
  };
  if (!text || !is_convertible(quantity_unit(*text), cycles))
    return positive(table.number("velocity", unit));
  if (!run.repeats || !run.length)
    table.fail("velocity", '"' + *text + '"',
               "counts cycles, but this motion does not repeat: give the velocity in " + unit);
  return positive(table.number("velocity", cycles)) * *run.length;
}

constexpr double cycle_rounding = 1e-9;  ///< cycles that the ramps may exceed a whole number

/// The travel of a master that the spec leaves out: one cycle at full speed, and its ramps, in whole cycles. A motion
/// that does not repeat is passed once.
double default_distance(const MasterSpec& master, const MasterRun& run) {
  if (!run.repeats) return *run.length;
  const double ramps =
      master.acceleration ? master.velocity * master.velocity / *master.acceleration : 0;
  return *run.length * (1 + std::ceil(ramps / *run.length - cycle_rounding));
}

/// A shear that makes a list of cuts reserves acceleration for a line that changes its speed. Returns true if
/// this may change the length of its cam.
bool reserve_for(const MasterSpec& master, Spec& spec) {
  auto* const sync = std::get_if<SyncSpec>(&spec.subject);
  auto* const cuts = sync == nullptr ? nullptr : std::get_if<CutListSpec>(sync);
  if (cuts == nullptr || !(master.acceleration.value_or(0) > 0)) return false;
  cuts->line = {master.velocity, {.acceleration = *master.acceleration}, spec.slave};
  (void)sync_cam_of(*sync);  // throws for a piece that is now too short
  return true;
}

std::optional<MasterSpec> read_master(TomlReader& top, Spec& spec) {
  auto table = top.optional_table("master");
  if (!table) return std::nullopt;
  const MasterRun run = master_run(top, spec);
  MasterSpec master;
  master.velocity = read_master_velocity(*table, spec, run);
  master.acceleration =
      table->optional_number("acceleration", rate_unit(spec.units.x, spec.time_unit, 2));
  const auto distance = run.length ? table->optional_number("distance", spec.units.x)
                                   : table->number("distance", spec.units.x);
  const MasterRun travel = reserve_for(master, spec) ? master_run(top, spec) : run;
  master.distance = distance ? *distance : default_distance(master, travel);
  for (const auto& [key, value] :
       {std::pair{"acceleration", master.acceleration.value_or(1)}, {"distance", master.distance}})
    if (!(value > 0)) table->fail(key, number(value), "must be greater than 0");
  table->finish();
  return master;
}

/// Reads the parts of a spec of one axis.
void read_one_axis(TomlReader& top, Spec& spec, const Kind& kind) {
  const bool knots_are_the_table = kind.name == std::string_view("pvt") && !top.has("then");
  top.attempt([&] {
    spec.table = spec_detail::read_table_options(
        top, spec.units, knots_are_the_table,
        kind.runs == Kind::over_master ? Domain::master : Domain::time);
  });
  Limits* slave = kind.runs == Kind::over_master ? &spec.slave : nullptr;
  top.attempt(
      [&] { spec.limits = spec_detail::read_limits(top, spec.units, slave, spec.time_unit); });
  if (kind.name != std::string_view("axis"))
    top.attempt([&] { spec.drive = spec_detail::read_drive(top, spec.units); });
}

/// Reads the parts that any cam may have: a master, a coupling, switches.
void read_beside_cam(TomlReader& top, Spec& spec) {
  top.attempt([&] {
    if (auto master = read_master(top, spec)) spec.master = master;
  });
  top.attempt([&] { spec.follower = spec_detail::read_follower(top, spec); });
  top.attempt([&] { spec.coupling = spec_detail::read_coupling(top, spec.units, spec.time_unit); });
  top.attempt([&] {
    spec.switches = spec_detail::read_switches(top, spec, SwitchesOf::master, spec.master_period());
  });
}

/// Reads the knots of a cam, with their changes by [[then]].
void read_own_cam(TomlReader& top, Spec& spec) {
  if (top.has("master")) spec_detail::require_last_knot(top, spec.units);
  top.attempt([&] { spec.master = read_master(top, spec); });
  CamSpec knots = spec_detail::read_cam(top, spec.units, spec);
  if (!top.has("then")) {
    spec.subject = std::move(knots);
    return;
  }
  if (!spec.optimize.free.empty() || !spec.optimize.shape.shapes.empty())
    top.fail("then", "",
             "cannot be combined with `free`: optimize the cam in a file of its own, and name it "
             "here with from = \"FILE\"");
  spec.subject = spec_detail::read_cam_then(top, named(knots, spec.boundaries), spec.units);
}

void read_cam(TomlReader& top, Spec& spec) {
  if (const auto* source = std::get_if<NamedCam>(&spec.subject)) {
    spec.subject = spec_detail::read_cam_from(top, *source, spec.units);
    top.attempt([&] { spec.master = read_master(top, spec); });
  } else {
    read_own_cam(top, spec);
  }
  top.attempt([&] { spec_detail::read_optimize(top, spec); });
  top.attempt([&] { spec.disc = spec_detail::read_disc(top, spec.units); });
  top.attempt([&] { spec.polydyne = spec_detail::read_polydyne(top); });
}

void read_pvt(TomlReader& top, Spec& spec) {
  if (!spec.table.rule) spec.table.rule = Interpolation::cubic_hermite;
  spec.subject = spec_detail::read_knots(top, spec, *spec.table.rule);
}

void read_axis(TomlReader& top, Spec& spec) {
  AxisSpec axis;
  bool whole = true;
  const auto part = [&](const auto& read) { whole = top.attempt(read) && whole; };
  part([&] { axis = spec_detail::read_axis(top.table("axis"), spec.units); });
  part([&] { axis.homing = spec_detail::read_homing(top, spec.units); });
  part([&] { axis.follow = spec_detail::read_whom(top); });
  part([&] {
    axis.registration = spec_detail::read_registration(top, spec.units, spec.master_unit);
    if (axis.registration && !axis.cutter.empty())
      top.fail(
          "registration", "",
          "cannot be combined with axis.cutter: a correction would move the cutter against the "
          "web in its cuts, so leave out one of the two. Without the cutter, send its cam with "
          "`jounce stream --live`, and the axis corrects it between the cuts. Without the "
          "registration, a program sends the distance of two marks with `jounce order NAME cut "
          "--length LENGTH`");
  });
  part(
      [&] { axis.compensation = spec_detail::read_axis_compensation(top, spec.units, spec.name); });
  // axis_drive() reads it again
  part([&] { (void)spec_detail::read_axis_drive(top, spec.units, spec.master_unit); });
  spec.subject = axis;
  part([&] { spec.switches = spec_detail::read_switches(top, spec, SwitchesOf::position); });
  part([&] { spec.compare = spec_detail::read_compare(top, spec); });
  if (!whole) throw spec_detail::PartEnded{};
}

void read_drive_alone(TomlReader& top, Spec& spec) {
  if (!top.has("drive"))
    top.fail("drive", "",
             "is missing: add the section [drive]; `jounce new drive` writes an example");
  spec.subject = DriveAlone{};
}

constexpr std::array kinds{
    Kind{"cam", Kind::over_master, read_cam},
    Kind{"gear", Kind::over_master,
         [](auto& top, auto& spec) {
           spec.subject = SyncSpec(spec_detail::read_gear(top.table("gear"), spec.units));
         }},
    Kind{"follow", Kind::over_master,
         [](auto& top, auto& spec) {
           spec.subject = SyncSpec(spec_detail::read_follow(top, spec.units));
         }},
    Kind{"knife", Kind::over_master,
         [](auto& top, auto& spec) {
           spec.subject = SyncSpec(spec_detail::read_knife(top.table("knife"), spec.units));
         }},
    Kind{"shear", Kind::over_master,
         [](auto& top, auto& spec) {
           spec.subject = SyncSpec(spec_detail::read_shear(top.table("shear"), spec));
         }},
    Kind{"indexer", Kind::over_master,
         [](auto& top, auto& spec) {
           spec.subject = SyncSpec(spec_detail::read_indexer(top.table("indexer"), spec.units));
         }},
    Kind{"move", Kind::over_time,
         [](auto& top, auto& spec) {
           spec.subject = spec_detail::read_move(top.table("move"), spec.units);
         }},
    Kind{"queue", Kind::over_time,
         [](auto& top, auto& spec) { spec.subject = spec_detail::read_queue(top, spec.units); }},
    Kind{"axes", Kind::over_time,
         [](auto& top, auto& spec) { spec.subject = spec_detail::read_axes(top, spec); }},
    Kind{"path", Kind::over_time,
         [](auto& top, auto& spec) { spec.subject = spec_detail::read_path(top, spec); }},
    Kind{"pvt", Kind::over_time, read_pvt},
    Kind{"pt", Kind::over_time,
         [](auto& top, auto& spec) {
           spec.subject = spec_detail::read_time_table(top, spec.units);
         }},
    Kind{"axis", Kind::no_curve, read_axis},
    Kind{"drive", Kind::no_curve, read_drive_alone},
};

/// Rejects kinds of files that belong to other commands.
void refuse_other_kinds(TomlReader& top) {
  const auto kind = top.optional_text("kind");
  if (kind == "machine")
    top.fail("kind", "\"machine\"",
             "is a machine, which has no motion of its own: use it with `jounce check` and `jounce "
             "run`");
  if (kind == "sweep")
    top.fail("kind", "\"sweep\"",
             "is a sweep: start it with `jounce sweep`, or give the spec that it varies" +
                 (top.is_text("spec") ? ", " + top.text("spec") : ""));
}

void read_body(TomlReader& top, Spec& spec) {
  spec_detail::require_version(top);
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Kind& kind : kinds) all.emplace_back(kind.name);
    all.emplace_back("machine");  // refuse_other_kinds() rejects it
    return all;
  }();
  refuse_other_kinds(top);
  const std::size_t chosen = top.variant("kind", names);
  if (chosen == kinds.size()) throw spec_detail::PartEnded{};  // a misspelled machine
  const Kind& kind = kinds[chosen];
  spec.name = top.optional_text("name").value_or("");
  read_units(top, spec, kind);
  name_quantities(top, spec, kind);
  const bool several =
      kind.name == std::string_view("axes") || kind.name == std::string_view("path");
  if (!several) read_one_axis(top, spec, kind);
  if (!top.attempt([&] { kind.read(top, spec); })) throw spec_detail::PartEnded{};
  if (kind.runs == Kind::over_master) top.attempt([&] { read_beside_cam(top, spec); });
  if (kind.runs == Kind::over_time) {
    top.attempt([&] { spec.then = spec_detail::read_then(top, spec); });
    top.attempt([&] { spec.compare = spec_detail::read_compare(top, spec); });
  }
  if (kind.runs != Kind::no_curve)
    top.attempt([&] { spec.parameters = spec_detail::read_parameters(top, spec); });
  top.finish();
}

}  // namespace

void spec_detail::require_version(TomlReader& top) {
  try {
    if (!top.has("jounce")) top.refuse_misspelt("jounce");
    if (!top.has("jounce")) top.refuse_below_header("jounce");
  } catch (const InputError& error) {
    top.end_all(error);
  }
  if (!top.has("jounce"))
    top.fail_all("jounce", "",
                 "is missing: a spec begins with `jounce = 1`, the version of its format");
  const auto version = top.optional_whole("jounce");
  if (*version != Spec::version)
    top.fail_all("jounce", std::to_string(*version),
                 "must be " + std::to_string(Spec::version) +
                     ", the format version that this program reads");
}

namespace {

/// Throws InputError for a dotted key of too many parts. The parser nests a table for each part and
/// destroys them recursively: 50 000 parts overrun the stack. It limits nested values itself.
void require_shallow_keys(const Document& document) {
  constexpr std::size_t most = 256;
  int line = 1;
  std::size_t dots = 0;
  for (const char c : document.text) {
    if (c == '\n') ++line;
    const bool word = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' ||
                      c == ' ' || c == '\t' || c == '"' || c == '\'';
    if (c == '.')
      ++dots;
    else if (!word && std::exchange(dots, 0) >= most && (c == '=' || c == ']'))
      throw InputError("key", "",
                       "must have at most " + std::to_string(most) + " parts between dots")
          .at(document.name, line);
  }
}

/// True for a file that is named like a spec, or begins with its first key.
bool is_meant_as_spec(const Document& document) {
  std::string_view text = document.text;
  while (!text.empty() &&
         (text.front() == '#' || text.find_first_not_of(" \t\r") == text.find('\n')))
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.starts_with("jounce") || document.name.ends_with(".toml");
}

int line_number(const std::string& text, std::size_t at) {
  return 1 + static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Throws InputError for a file that is no text, and for a table, which is made from a spec.
void require_spec_text(const Document& document) {
  const std::string& text = document.text;
  if (const auto at = text.find('\0'); at != std::string::npos)
    throw InputError(
        "", "",
        text.starts_with("\x93NUMPY")
            ? "is an array of NumPy, which Jounce writes but does not read: save it as CSV"
            : "is not a text file: it has a zero byte here")
        .at(document.name, line_number(text, at));
  if (document.name.ends_with(".dxf") || document.name.ends_with(".svg"))
    throw InputError("", "", "is a drawing, not a spec: give a spec").at(document.name, 1);
  if (is_table(text) || exchange_format_of_text(text) != nullptr)
    throw InputError("", "", "is a table, not a spec: give a spec").at(document.name, 1);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("", "", "the file is empty: `jounce new` writes a spec to start with")
        .at(document.name, 1);
}

}  // namespace

namespace {

bool is_piped(const Document& document) {
  return document.name == "standard input";
}

/// The error of a file of points in place of a spec or a table.
InputError points_alone(const Document& document) {
  const Points points = parse_points(document.text, document.name);  // throws: a column is twice
  const bool over_time = std::ranges::any_of(points.columns, [](const PointColumn& column) {
    return column.name == "time" || column.name.starts_with("time ");
  });
  return InputError("", "",
                    "has points only, without the header of a Jounce table: write " +
                        std::string(is_piped(document) ? "the points to a file, and " : "") +
                        "a spec of kind \"" + (over_time ? "pvt" : "cam") + "\" with points = \"" +
                        (is_piped(document) ? "FILE" : document.name) + '"' +
                        (over_time ? "" : ", or fit a cam to the points with `jounce fit`"))
      .at(document.name, 1);
}

}  // namespace

toml::table spec_detail::parse_toml(const Document& document) {
  require_shallow_keys(document);
  require_spec_text(document);
  try {
    return toml::parse(std::string_view(document.text), std::string_view(document.name));
  } catch (const toml::parse_error& error) {
    if (begins_as_points(document.text)) throw points_alone(document);
    if (begins_as_gcode(document.text))
      throw InputError("", "",
                       "is a G-code program: name " +
                           std::string(is_piped(document) ? "the file" : "it") +
                           " in the spec of its machine, a spec of kind \"path\", with gcode = "
                           "{ file = \"" +
                           (is_piped(document) ? "FILE" : document.name) +
                           "\" }; or give that spec with --machine to check, design, diff, plot, "
                           "report, stream or validate")
          .at(document.name, 1);
    if (!is_meant_as_spec(document))
      throw InputError("", "",
                       "is not a spec, a table, a G-code program or a controller file that Jounce "
                       "reads; a spec begins with jounce = 1")
          .at(document.name, 1);
    const auto at = error.source().begin;
    throw syntax_error(document, static_cast<int>(at.line), static_cast<int>(at.column),
                       std::string(error.description()));
  }
}

std::string spec_kind(const std::string& text) {
  try {
    const toml::table root = spec_detail::parse_toml({"", text, {}, {}});
    return root["kind"].value<std::string>().value_or("");
  } catch (const InputError&) {
    return "";  // the reader reports the error
  }
}

Spec spec_detail::parse_source(std::string text, std::string name) {
  Spec spec;
  spec.document = {std::move(name), std::move(text), {}, {}};
  spec.document.hash = sha256(spec.document.text);
  const toml::table root = parse_toml(spec.document);
  TomlReader top(root, "", spec.document);
  try {
    read_body(top, spec);
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
  return spec;
}

Spec parse_spec(std::string text, std::string name, const std::function<void(const Spec&)>& use) {
  Document document{std::move(name), std::move(text), {}, {}};
  document.hash = sha256(document.text);
  const toml::table root = spec_detail::parse_toml(document);
  return spec_detail::read_document(root, [&](spec_detail::ErrorList& errors) {
    Spec spec;
    spec.document = document;
    TomlReader top(root, "", spec.document, &errors);
    if (!top.attempt([&] { read_body(top, spec); }) || !use || top.placeholders() > 0) return spec;
    try {
      use(spec);
    } catch (const InputError& error) {
      for (const InputError& one : all_errors(error)) errors.add(spec.document.located(one));
    }
    return spec;
  });
}

Spec::Spec() = default;
Spec::Spec(const Spec& other) = default;
Spec::Spec(Spec&& other) noexcept = default;
Spec& Spec::operator=(const Spec& other) = default;
Spec& Spec::operator=(Spec&& other) noexcept = default;
Spec::~Spec() = default;

std::optional<double> Spec::master_period() const {
  if (const auto* sync = std::get_if<SyncSpec>(&subject)) return jounce::master_period(*sync);
  if (const auto* made = std::get_if<NamedCam>(&subject)) {
    if (!repeats(made->cam.outside())) return std::nullopt;
    return made->cam.length();
  }
  const auto* cam = std::get_if<CamSpec>(&subject);
  if (cam == nullptr || !cam->periodic || cam->segments.empty()) return std::nullopt;
  const double period = cam->segments.back().end.master - cam->start.master;
  if (!(period > 0)) return std::nullopt;  // design() reports the error
  return period;
}

std::vector<AxisPart> Spec::parts() const {
  if (!axes.empty()) return axes;
  return {{"", units, table, limits, drive}};
}

Spec read_spec(const std::string& path) {
  return parse_spec(read_file(path), path);
}

}  // namespace jounce
