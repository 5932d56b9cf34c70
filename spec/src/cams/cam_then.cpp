// SPDX-License-Identifier: Apache-2.0
// The operators of [[then]] on a cam.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/cam/algebra/algebra.hpp"
#include "jounce/cam/algebra/inverse.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "spec/src/cams/cam_source.hpp"
#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

using profiles_detail::rounded_input;

constexpr double fit = 1e-9;  ///< default tolerance of a fit, as a share of the stroke

double peak(const Cam& cam, int order) {
  return std::abs(extrema(cam, order).peak().value);
}

const std::string& name_at(const NamedCam& f, double master) {
  return f.names[segment_at(f.cam, master)];
}

/// The result of an operator. `name_of(x)` returns the name of the segment at x, a place inside it.
template <class NameOf>
NamedCam renamed(Cam cam, const NamedCam& errors, const NameOf& name_of) {
  std::vector<std::string> names;
  const auto breaks = cam.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    names.push_back(name_of((breaks[i] + breaks[i + 1]) / 2));
  return {std::move(cam), std::move(names), errors.error, errors.velocity_error};
}

NamedCam scale(TomlReader& then, const NamedCam& f, Units&) {
  const auto slave = then.optional_number("slave", "1");
  const auto master = then.optional_number("master", "1");
  if (!slave && !master)
    then.fail("slave", "", "is missing: give slave, master, or both, as factors");
  if (slave == 0.) then.fail("slave", "0", "must not be 0: the slave would not move");
  if (master && !(*master > 0))
    then.fail("master", number(*master),
              "must be greater than 0: for a master that turns the other way, use operator = "
              "\"mirror\"");
  const double k = slave.value_or(1);
  const double c = master.value_or(1);
  NamedCam made{scaled(f.cam, k, c), f.names, f.error, f.velocity_error};
  made.error *= std::abs(k);
  made.velocity_error *= std::abs(k) / c;
  return made;
}

NamedCam shift(TomlReader& then, const NamedCam& f, Units& units) {
  const auto master = then.optional_number("master", units.x);
  const auto slave = then.optional_number("slave", units.position);
  if (!slave && !master) then.fail("slave", "", "is missing: give slave, master, or both");
  return {shifted(f.cam, master.value_or(0), slave.value_or(0)), f.names, f.error,
          f.velocity_error};
}

NamedCam reverse(TomlReader&, const NamedCam& f, Units&) {
  const double both = f.cam.start() + f.cam.end();
  return renamed(reversed(f.cam), f, [&](double x) { return name_at(f, both - x); });
}

NamedCam mirror(TomlReader& then, const NamedCam& f, Units& units) {
  const auto master = then.optional_number("master", units.x);
  const auto slave = then.optional_number("slave", units.position);
  if (master.has_value() == slave.has_value())
    then.fail("slave", slave ? number(*slave) : "",
              slave ? "cannot be combined with master: mirror about one, then about the other"
                    : "is missing: give the position of the slave or of the master that stays");
  if (slave) {
    Cam cam = mirrored_about_slave(f.cam, *slave);
    return {std::move(cam), f.names, f.error, f.velocity_error};
  }
  return renamed(mirrored_about_master(f.cam, *master), f,
                 [&](double x) { return name_at(f, 2 * *master - x); });
}

NamedCam phase(TomlReader& then, const NamedCam& f, Units& units) {
  const double by = then.number("master", units.x);
  if (!repeats(f.cam.outside()))
    then.fail("operator", "\"phase\"",
              "needs a cam that repeats: give periodic = true, or use operator = \"shift\"");
  return renamed(phased(f.cam, by), f, [&](double x) { return name_at(f, x - by); });
}

NamedCam cut(TomlReader& then, const NamedCam& f, Units& units) {
  const double from = then.number("from", units.x);
  const double to = then.number("to", units.x);
  return renamed(with(part(f.cam, from, to), Extrapolation::hold), f,
                 [&](double x) { return name_at(f, x); });
}

/// The other cam of an operator, in the units of the first.
NamedCam read_other(TomlReader& then, const Units& units) {
  return in_units(read_cam_source(then, "with"), units, then, "with");
}

NamedCam worse_of(const NamedCam& f, const NamedCam& g) {
  return {f.cam, {}, std::max(f.error, g.error), std::max(f.velocity_error, g.velocity_error)};
}

NamedCam replace(TomlReader& then, const NamedCam& f, Units& units) {
  const NamedCam g = read_other(then, units);
  return renamed(replaced(f.cam, g.cam), worse_of(f, g), [&](double x) {
    return name_at(x > g.cam.start() && x < g.cam.end() ? g : f, x);
  });
}

/// Throws InputError if the slave moves where a dwell begins.
void require_rest(TomlReader& then, const Cam& cam, double at, const Units& units) {
  const double greatest = peak(cam, 1);
  for (const Side side : {Side::left, Side::right}) {
    const double speed = cam.jet(at, side)[1];
    const bool outside = side == Side::left ? !(at > cam.start()) : !(at < cam.end());
    if (outside || std::abs(speed) <= rounded_input * greatest) continue;
    then.fail(
        "at", number(at),
        "must be a place where the slave rests, because a dwell begins at rest; here the slave "
        "moves with " +
            six_digits(speed) + " " + rate_unit(units.position, units.x, 1) +
            ". Choose a place outside the rises and falls, which are " +
            inverted(cam).ranges_text() + " " + units.x);
  }
}

NamedCam insert(TomlReader& then, const NamedCam& f, Units& units) {
  const double at = then.number("at", units.x);
  const auto dwell = then.optional_number("dwell", units.x);
  if (dwell && then.has("with"))
    then.fail("dwell", number(*dwell), "cannot be combined with `with`: give one of the two");
  if (dwell && !(*dwell > 0)) then.fail("dwell", number(*dwell), "must be greater than 0");
  if (!(at >= f.cam.start() && at <= f.cam.end()))
    then.fail("at", number(at),
              "must lie within the cam, " + number(f.cam.start()) + " to " + number(f.cam.end()));
  if (!dwell && !then.has("with"))
    then.fail("with", "", "is missing: add with = \"other.toml\", or dwell = NUMBER");
  if (dwell) require_rest(then, f.cam, at, units);
  const double rest = f.cam.jet(at, at == f.cam.end() ? Side::left : Side::right)[0];
  const NamedCam g =
      dwell ? NamedCam{Cam({line(*dwell, rest, rest)}), {"dwell"}} : read_other(then, units);
  const double length = g.cam.length();
  return renamed(inserted(f.cam, at, g.cam), worse_of(f, g), [&](double x) {
    if (x < at) return name_at(f, x);
    return x < at + length ? name_at(g, x - at + g.cam.start()) : name_at(f, x - length);
  });
}

/// The tolerance of a fit, in the unit of the values of `f`.
double read_tolerance(TomlReader& then, const Cam& f, const std::string& unit) {
  const Range travel = extrema(f, 0);
  const double stroke = travel.max.value - travel.min.value;
  return then.optional_positive("tolerance", unit).value_or(fit * (stroke > 0 ? stroke : 1));
}

NamedCam superpose(TomlReader& then, const NamedCam& f, Units& units) {
  const NamedCam g = read_other(then, units);
  const double tolerance = read_tolerance(then, f.cam, units.position);
  const Fitted<OverMaster> sum = superimposed(f.cam, g.cam, tolerance);
  const NamedCam errors{f.cam,
                        {},
                        f.error + g.error + sum.error[0],
                        f.velocity_error + g.velocity_error + sum.error[1]};
  return renamed(sum.curve, errors, [&](double x) { return name_at(f, x); });
}

/// f(g(x)), with the errors of f and g by the chain rule.
NamedCam compose(TomlReader& then, const NamedCam& f, Units& units) {
  const NamedCam g = in_units(read_cam_source(then, "with"), {units.x, units.x}, then, "with");
  const double tolerance = read_tolerance(then, f.cam, units.position);
  const Fitted<OverMaster> chain = composed_within(f.cam, g.cam, tolerance);
  const double slope = peak(f.cam, 1);
  const double ratio = peak(g.cam, 1);
  const NamedCam errors{f.cam,
                        {},
                        f.error + slope * g.error + chain.error[0],
                        f.velocity_error * ratio + peak(f.cam, 2) * g.error * ratio +
                            slope * g.velocity_error + chain.error[1]};
  return renamed(chain.curve, errors, [&](double x) { return name_at(f, g.cam.jet(x)[0]); });
}

/// The branch of the inverse that contains the master position `at`, or the only one.
const Inverse& branch_of(TomlReader& then, const Inversion& all, const std::optional<double>& at) {
  if (at) {
    if (const Inverse* branch = all.branch_at(*at)) return *branch;
    then.fail("at", number(*at), "must lie in a rise or fall of the slave, " + all.ranges_text());
  }
  if (all.branches.size() == 1) return all.branches.front();
  if (all.branches.empty()) then.fail("operator", "\"inverse\"", "needs a slave that moves");
  then.fail("at", "",
            "is missing: the slave passes its positions " + std::to_string(all.branches.size()) +
                " times. Give a master position inside the rise or fall that you need, such as " +
                number((all.branches[0].master_from() + all.branches[0].master_to()) / 2));
}

/// Share of the branch that the default of `from` or `to` leaves out at an end where the slave rests:
/// the inverse is infinitely steep there.
constexpr double left_out_at_rest = 0.01;

/// The default of `from` (side: right) or `to` (side: left).
double end_of_inverse(const Inverse& branch, Side side) {
  const double end = side == Side::right ? branch.start() : branch.end();
  if (std::isfinite(branch.at(end, side).geo_velocity)) return end;
  const double leave = left_out_at_rest * (branch.end() - branch.start());
  return side == Side::right ? end + leave : end - leave;
}

NamedCam inverse(TomlReader& then, const NamedCam& f, Units& units) {
  if (!is_position_unit(units.x))
    then.fail("operator", "\"inverse\"",
              "needs a master in a length, an angle or pulses, because it exchanges master and "
              "slave; this master is in " +
                  units.x);
  const Inversion all = inverted(f.cam);
  const Inverse& branch = branch_of(then, all, then.optional_number("at", units.x));
  const double from =
      then.optional_number("from", units.position).value_or(end_of_inverse(branch, Side::right));
  const double to =
      then.optional_number("to", units.position).value_or(end_of_inverse(branch, Side::left));
  const double tolerance =
      then.optional_positive("tolerance", units.x).value_or(fit * f.cam.length());
  const Fitted<OverMaster> made = inverse_within(branch, from, to, tolerance);
  const double slope = peak(made.curve, 1);
  const NamedCam errors{
      f.cam,
      {},
      f.error * slope + made.error[0],
      f.velocity_error * slope * slope + f.error * peak(made.curve, 2) + made.error[1]};
  std::swap(units.x, units.position);
  return renamed(made.curve, errors, [&](double x) { return name_at(f, made.curve.jet(x)[0]); });
}

struct CamOperator {
  const char* name;
  NamedCam (*apply)(TomlReader& then, const NamedCam& f, Units& units);
};
constexpr std::array cam_operators{
    CamOperator{"scale", scale},         CamOperator{"shift", shift},
    CamOperator{"mirror", mirror},       CamOperator{"reverse", reverse},
    CamOperator{"phase", phase},         CamOperator{"part", cut},
    CamOperator{"replace", replace},     CamOperator{"insert", insert},
    CamOperator{"superpose", superpose}, CamOperator{"compose", compose},
    CamOperator{"inverse", inverse}};

/// Applies one operator. An error of the algebra gets its place in the document.
NamedCam applied(TomlReader& then, const NamedCam& f, Units& units) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const CamOperator& each : cam_operators) all.emplace_back(each.name);
    return all;
  }();
  const CamOperator& chosen = cam_operators[then.variant("operator", names)];
  try {
    NamedCam made = chosen.apply(then, f, units);
    then.finish();
    return made;
  } catch (const InputError& error) {
    if (!error.document().empty()) throw;
    const char* const own = error.key().c_str();
    const std::string key = then.has(own) || then.is_faulty(own) ? error.key() : "operator";
    then.fail(key.c_str(),
              key == "operator" ? std::string("\"") + chosen.name + '"' : error.value(),
              (key == "operator" ? error.key() + " = " + error.value() + " " : "") + error.rule());
  }
}

/// True if an odd number of operators exchanges master and slave.
bool exchanges_units(TomlReader& top) {
  bool exchanges = false;
  for (TomlReader& then : top.tables("then"))
    if (then.is_text("operator") && then.text("operator") == "inverse") exchanges = !exchanges;
  return exchanges;
}

/// The cam repeats or holds, as the spec states it.
void set_periodic(Cam& cam, bool periodic) {
  const Range travel = extrema(cam, 0);
  const double step = value(cam.segments().back(), 1) - value(cam.segments().front(), 0);
  const bool closes = std::abs(step) <= rounded_input * (travel.max.value - travel.min.value);
  cam = with(cam, !periodic ? Extrapolation::hold
                  : closes  ? Extrapolation::wrap
                            : Extrapolation::advance);
}

}  // namespace

Units units_before_then(TomlReader& top, const Units& units) {
  if (!exchanges_units(top)) return units;
  return {units.position, units.x};
}

NamedCam read_cam_then(TomlReader& top, NamedCam cam, const Units& units) {
  if (!top.has("from") && exchanges_units(top))
    top.fail("then", "",
             "has the operator inverse, which exchanges the units of master and slave: write the "
             "knots in another file, and name it here with from = \"FILE\"");
  Units now = units_before_then(top, units);
  for (TomlReader& then : top.tables("then")) cam = applied(then, cam, now);
  return cam;
}

NamedCam read_cam_from(TomlReader& top, const NamedCam& source, const Units& units) {
  for (const char* key : {"start", "segment", "boundaries", "slave_period"})
    top.refuse_here(key,
                    "cannot be combined with from, which names the cam that this file changes: "
                    "leave one of the "
                    "two out");
  NamedCam cam = read_cam_then(top, source, units);
  if (const auto periodic = top.optional_flag("periodic")) set_periodic(cam.cam, *periodic);
  return cam;
}

}  // namespace jounce::spec_detail
