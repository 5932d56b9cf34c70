#include <utility>
#include <vector>

#include "jounce/io/detail/spec_parts.hpp"
#include "jounce/io/units.hpp"

namespace jounce::detail {
namespace {

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

}  // namespace

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
  if (!(spec.cycle >= 1e-5 && spec.cycle <= 1))
    axis.fail("cycle", number(spec.cycle), "must be between 10 us and 1 s");
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

}  // namespace jounce::detail
