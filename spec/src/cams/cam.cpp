// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/cam/detail/law_names.hpp"

#include "spec/src/cams/cam_points.hpp"
#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

/// Units of the knots of a cam, and the speed of its master for rates over time.
struct CamUnits {
  const Units& of;
  const std::string& time;
  std::optional<double> speed;

  [[nodiscard]] std::string by_master(int order) const {
    return rate_unit(of.position, of.x, order);
  }
  [[nodiscard]] std::string over_time(int order) const {
    return rate_unit(of.position, time, order);
  }
};

/// The rate over time of a slave whose derivative by the master is 1. `key` is given instead of `geo`.
double rate_over_time(TomlReader& table, const char* geo, const char* key, int order,
                      const CamUnits& units) {
  if (table.has(geo))
    table.fail(key, "", std::string("cannot be combined with ") + geo + ": give one of the two");
  if (!units.speed)
    table.fail(key, "",
               std::string("is over time and needs the speed of the master: add [master] with "
                           "velocity, or give ") +
                   geo);
  return std::pow(*units.speed, order);
}

/// A derivative of the slave: under `geo` by the master, or under `key` over time.
std::optional<double> read_rate(TomlReader& table, const char* geo, const char* key, int order,
                                const CamUnits& units) {
  const auto by_master = table.optional_number(geo, units.by_master(order));
  const auto timed = table.optional_number(key, units.over_time(order));
  if (!timed) return by_master;
  const double rate = rate_over_time(table, geo, key, order, units);
  table.convert(geo, key, rate);
  return *timed / rate;
}

std::optional<Bound> read_bound(TomlReader& free, const char* key, const std::string& unit) {
  const auto pair = free.optional_pair(key, unit);
  if (!pair) return std::nullopt;
  return Bound{pair->first, pair->second};
}

std::optional<Bound> read_rate_bound(TomlReader& free, const char* geo, const char* key, int order,
                                     const CamUnits& units) {
  const auto by_master = read_bound(free, geo, units.by_master(order));
  const auto timed = read_bound(free, key, units.over_time(order));
  if (!timed) return by_master;
  const double rate = rate_over_time(free, geo, key, order, units);
  return Bound{timed->lower / rate, timed->upper / rate};
}

void read_free(TomlReader& owner, std::size_t knot, const CamUnits& units, OptimizeSpec& optimize) {
  auto free = owner.optional_table("free");
  if (!free) return;
  FreeKnot f;
  f.knot = knot;
  f.master = read_bound(*free, "master", units.of.x);
  f.slave = read_bound(*free, "slave", units.of.position);
  f.geo_velocity = read_rate_bound(*free, "geo_velocity", "velocity", 1, units);
  f.geo_acceleration = read_rate_bound(*free, "geo_acceleration", "acceleration", 2, units);
  if (knot > 0) read_free_shape(*free, knot - 1, optimize.shape);
  free->finish();
  const bool nothing = !f.master && !f.slave && !f.geo_velocity && !f.geo_acceleration;
  const bool shape =
      !optimize.shape.shapes.empty() && optimize.shape.shapes.back().segment + 1 == knot;
  if (!(nothing && shape)) optimize.free.push_back(f);
}

/// True for a line whose end gives its speed instead of its slave position.
bool follows_speed(TomlReader& segment, Law law) {
  if (law != Law::line) return false;
  const auto end = segment.optional_table("end");
  return end && !end->has("slave") && (end->has("geo_velocity") || end->has("velocity"));
}

/// A knot. `line_from`: the knot before a line that keeps its speed wherever it begins and ends.
CamKnot read_knot(TomlReader& knot, const CamUnits& units, const CamKnot* line_from = nullptr) {
  CamKnot k;
  k.master = knot.number("master", units.of.x);
  if (line_from == nullptr) k.slave = knot.number("slave", units.of.position);
  k.geo_velocity = read_rate(knot, "geo_velocity", "velocity", 1, units);
  k.geo_acceleration = read_rate(knot, "geo_acceleration", "acceleration", 2, units);
  k.geo_jerk = read_rate(knot, "geo_jerk", "jerk", 3, units);
  if (line_from != nullptr)
    k.slave = line_from->slave + *k.geo_velocity * (k.master - line_from->master);
  return k;
}

/// Throws InputError if something free would move the ends of a line that keeps its speed. `number`: of its segment.
void refuse_free_ends(TomlReader& top, const OptimizeSpec& optimize, std::size_t number) {
  const auto& knots = optimize.free;
  const auto& shapes = optimize.shape.shapes;
  const bool moves = std::any_of(knots.begin(), knots.end(), [&](const FreeKnot& free) {
    return free.knot == number || free.knot + 1 == number;
  });
  const bool changes = std::any_of(shapes.begin(), shapes.end(), [&](const FreeShape& free) {
    return free.segment + 1 == number;
  });
  if (moves || changes)
    top.fail(("segment[" + std::to_string(number) + "].end.slave").c_str(), "",
             "is missing: it follows from the velocity of the line only if neither the line nor "
             "its knots are free. Add slave = NUMBER, or replace free with [[optimize.parameter]]");
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawInfo& law : all_laws()) names.emplace_back(law.name);
  return names;
}

/// Throws InputError with the name of the law here, if the spec has its name in another tool.
void refuse_alias(TomlReader& owner, const char* key) {
  if (!owner.is_text(key)) return;
  const auto text = owner.optional_text(key);
  if (const LawAlias* alias = law_alias(*text)) owner.fail(key, '"' + *text + '"', rule_of(*alias));
}

constexpr const char* no_law =
    "is not a law: `jounce laws` lists all, such as modified_sine or 345";

CamPoint read_point(TomlReader& point, const CamUnits& units) {
  CamPoint p;
  p.master = point.number("master", units.of.x);
  p.slave = point.optional_number("slave", units.of.position);
  p.geo_velocity = read_rate(point, "geo_velocity", "velocity", 1, units);
  p.geo_acceleration = read_rate(point, "geo_acceleration", "acceleration", 2, units);
  p.geo_jerk = read_rate(point, "geo_jerk", "jerk", 3, units);
  p.tolerance = point.optional_number("tolerance", units.of.position).value_or(0);
  if (!p.slave && !p.geo_velocity && !p.geo_acceleration && !p.geo_jerk)
    point.fail("slave", "", "is missing: a point needs a position, or a derivative");
  point.finish();
  return p;
}

const std::array<std::string, 3> boundaries{"rest", "minimum_jerk", "minimum_peak_acceleration"};

}  // namespace

std::optional<Law> read_law(TomlReader& owner, const char* key) {
  refuse_alias(owner, key);
  const auto chosen = owner.optional_choice(key, law_names(), no_law);
  if (!chosen) return std::nullopt;
  return all_laws()[*chosen].law;
}

namespace {

/// The master position of a knot; without the table of the knot, that of the point of a file that
/// replaces it.
std::optional<double> master_of(std::optional<TomlReader> knot, const Units& units,
                                TomlReader& segment, double MasterSpan::*point) {
  if (knot) return knot->optional_number("master", units.x);
  if (const auto span = span_of_points(segment, units)) return (*span).*point;
  return std::nullopt;
}

}  // namespace

void require_last_knot(TomlReader& top, const Units& units) {
  auto segments = top.tables("segment");
  if (segments.empty()) return;
  auto end = segments.back().optional_table("end");
  auto before = segments.size() > 1 ? segments[segments.size() - 2].optional_table("end")
                                    : top.optional_table("start");
  if (!end || !before) return;
  std::optional<double> to;
  std::optional<double> from;
  try {
    to = end->optional_number("master", units.x);
    from = before->optional_number("master", units.x);
  } catch (const InputError&) {
    return;
  }
  if (!to || !from || *to > *from) return;
  const bool turn = *to < *from && top.optional_flag("periodic").value_or(false);
  end->fail("master", number(*to),
            "must be greater than " + number(*from) + ", the previous knot" +
                (turn ? ": the last knot of a periodic cam is the end of its turn" : ""));
}

std::optional<double> cam_length(TomlReader& top, const Units& units) {
  try {
    auto segments = top.tables("segment");
    if (segments.empty()) return std::nullopt;
    TomlReader& last = segments.back();
    const auto from =
        master_of(top.optional_table("start"), units, segments.front(), &MasterSpan::from);
    const auto to = master_of(last.optional_table("end"), units, last, &MasterSpan::to);
    if (!from || !to || !(*to > *from)) return std::nullopt;
    return *to - *from;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

namespace {

/// True if the spec leaves out the start of the cam, which is then the first point of the file of
/// its first segment.
bool starts_with_file(TomlReader& top) {
  if (top.has("start")) return false;
  auto segments = top.tables("segment");
  return !segments.empty() && segments.front().is_text("points");
}

/// Reads the end of a segment; without its table, it is the last point of the file. `line_from`: see read_knot().
CamKnot read_end(TomlReader& segment, const CamUnits& units, const CamKnot* line_from,
                 const std::optional<CamPointFile>& file) {
  if (file && !segment.has("end")) {
    if (segment.optional_table("free"))
      segment.fail("free", "", "moves the last point of the file: give the segment its own end");
    return CamPointFile::knot_of(file->points.back());
  }
  if (!segment.has("end") && segment.is_faulty("points")) throw PartEnded{};  // its last point
  TomlReader end = segment.table("end", "end = { master = NUMBER, slave = NUMBER }");
  CamKnot knot = read_knot(end, units, line_from);
  end.refuse_here("free", "belongs to the segment: write free beside end, not inside end");
  end.finish();
  return knot;
}

}  // namespace

LawForm read_form(TomlReader& segment) {
  LawForm form;
  form.inflection = segment.optional_number("inflection", "1");
  form.straight = segment.optional_number("straight", "1");
  const std::array<std::string, 3> shares{"1", "1", "1"};
  if (const auto given = segment.numbers("shares", shares); !given.empty())
    form.shares = {given[0], given[1], given[2]};
  const std::array<std::string, 2> amplitudes{"1", "1"};
  if (const auto given = segment.numbers("harmonics", amplitudes); !given.empty())
    form.harmonics = {given[0], given[1]};
  return form;
}

namespace {

/// Reads the control values and the knots of the law b_spline.
ControlShape read_control(TomlReader& segment, Law law, const Units& units) {
  if (law != Law::b_spline) {
    for (const char* key : {"control", "knots"})
      segment.refuse_here(
          key, "applies to the law b_spline only: leave it out, or give law = \"b_spline\"");
    return {};
  }
  ControlShape shape{segment.number_list("control", units.position)};
  if (segment.has("knots")) shape.knots = segment.number_list("knots", units.x);
  return shape;
}

}  // namespace

CamSpec read_cam(TomlReader& top, const Units& of, Spec& spec) {
  // [master] with an error of its own: any speed avoids an error that only follows from it
  const auto speed = spec.master         ? std::optional(spec.master->velocity)
                     : top.has("master") ? std::optional(1.0)
                                         : std::nullopt;
  const CamUnits units{of, spec.time_unit, speed};
  OptimizeSpec& optimize = spec.optimize;
  CamSpec cam;
  cam.periodic = top.optional_flag("periodic").value_or(false);
  cam.slave_period = top.optional_number("slave_period", of.position);
  cam.velocity_steps = spec.table.rule == Interpolation::linear;
  if (const auto chosen = top.optional_choice("boundaries", boundaries))
    spec.boundaries = static_cast<Boundaries>(*chosen);
  const bool from_file = starts_with_file(top);
  if (!from_file) {
    TomlReader start = top.table("start", "start = { master = 0, slave = 0 }");
    cam.start = read_knot(start, units);
    read_free(start, 0, units, optimize);
    start.finish();
  }
  std::vector<std::size_t> lines;  // that keep their speed, by number
  top.for_each("segment", [&](TomlReader& segment) {
    CamSegment s;
    s.name = segment.optional_text("name").value_or("");
    s.form = read_form(segment);
    refuse_alias(segment, "law");
    if (!segment.has("law"))
      segment.fail("law", "",
                   "is missing: add law = \"quintic\" (between any two knots), \"modified_sine\" "
                   "(from rest to rest), \"dwell\", or another law of `jounce laws`");
    s.law = all_laws()[segment.choice("law", law_names(), no_law)].law;
    s.control = read_control(segment, s.law, of);
    const auto file = read_cam_points(segment, s.law, of);
    if (!file)
      for (TomlReader& point : segment.tables("points"))
        s.points.push_back(read_point(point, units));
    if (from_file && cam.segments.empty() && file)
      cam.start = CamPointFile::knot_of(file->points.front());
    const CamKnot& begin = cam.segments.empty() ? cam.start : cam.segments.back().end;
    const bool keeps_speed = follows_speed(segment, s.law);
    s.end = read_end(segment, units, keeps_speed ? &begin : nullptr, file);
    if (file) s.points = file->within(s.law, begin, s.end);
    cam.segments.push_back(std::move(s));
    read_free(segment, cam.segments.size(), units, optimize);
    if (keeps_speed) lines.push_back(cam.segments.size());
    segment.finish();
  });
  for (const std::size_t line : lines) refuse_free_ends(top, optimize, line);
  return cam;
}

namespace {

/// Without a parameter and a free shape, only the knots are free.
[[noreturn]] void refuse_other_figure(TomlReader& table, const std::string& figure) {
  const std::vector<std::string> known{"peak geo_acceleration", "peak geo_jerk",
                                       "rms geo_acceleration"};
  const std::string meant = nearest(figure, known);
  if (!meant.empty())
    table.fail("minimize", '"' + figure + '"', "is unknown: did you mean \"" + meant + "\"?");
  table.fail(
      "minimize", '"' + figure + '"',
      "must be a list of \"peak geo_acceleration\", \"peak geo_jerk\" or \"rms "
      "geo_acceleration\"; any other figure needs [[optimize.parameter]] with key and range, "
      "or a segment with a free shape: free = { shape = 100 }");
}

void read_knot_optimize(TomlReader& table, OptimizeSpec& optimize) {
  std::vector<Objective> minimize;
  if (table.is_text("minimize")) refuse_other_figure(table, *table.optional_text("minimize"));
  for (const auto& text : table.texts("minimize")) {
    const auto objective = objective_named(text);
    if (!objective) refuse_other_figure(table, text);
    minimize.push_back(*objective);
  }
  if (!minimize.empty()) optimize.minimize = std::move(minimize);
  optimize.seed = table.optional_count("seed");
  optimize.starts = table.optional_count("starts");
  if (optimize.starts.value_or(1) > 10'000)
    table.fail("starts", std::to_string(*optimize.starts), "must be at most 10000");
  optimize.tolerance = table.optional_number("tolerance", "1");
  optimize.seconds = read_budget(table);
}

}  // namespace

std::optional<double> read_budget(TomlReader& table) {
  const auto seconds = table.optional_number("budget", "s");
  if (seconds && !(*seconds > 0)) table.fail("budget", number(*seconds), "must be greater than 0");
  return seconds;
}

void read_optimize(TomlReader& top, Spec& spec) {
  const auto& load = spec.optimize.shape.load = read_load(top, spec.units);
  if (load && (load->peak_torque || load->rms_torque) && !spec.master)
    top.fail(
        "load", "",
        "limits a torque, which depends on the speed of the master: add [master] with velocity");
  if (!std::holds_alternative<CamSpec>(spec.subject)) return;  // read_parameters() reads the rest
  auto table = top.optional_table("optimize");
  const bool shapes = !spec.optimize.shape.shapes.empty();
  if (shapes && !table)
    top.fail("optimize", "",
             "is missing: a free shape needs an objective. Add [optimize] with minimize = "
             "[\"peak geo_jerk\"]");
  if (!table || table->has("parameter")) return;  // read_parameters() reads [[optimize.parameter]]
  if (shapes)
    read_shape_optimize(*table, spec);
  else
    read_knot_optimize(*table, spec.optimize);
  table->finish();
}

}  // namespace jounce::spec_detail
